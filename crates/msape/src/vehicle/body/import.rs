//! Outlines from files: CSV of points, DXF of lines and arcs.
