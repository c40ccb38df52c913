//! Import and export of bodies and tables, as text and bytes: every reader and writer is a pure function, so that the
//! page and the command line read and write the same.
//!
//! - [`export`]: the vehicle as CAD, mesh and drawing files.
//! - [`outline`]: outlines of rigid bodies from CSV and DXF.
//! - [`table`]: rows of an atmosphere, a wind, drag, bank or aerodynamic coefficients from text.
//! - [`text`]: decoding of file bytes to text.
//!
//! A case holds rows, never files: callers read a file into rows with this crate before the case is checked.

pub mod export;
pub mod outline;
pub mod table;
pub mod text;
