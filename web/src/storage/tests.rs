//! Tabs that share records, and what a browser may do to them.
