//! Files of bodies and tables, in and out, as text and bytes: every reader and writer is a pure function, so that the page
//! and the command line read and write the same.
//!
//! - [`export`]: the vehicle as CAD, mesh and drawing files.
//! - [`outline`]: outlines of rigid bodies from CSV and DXF.
//! - [`table`]: rows of an atmosphere, a wind, drag, bank or aerodynamic coefficients from text.
//! - [`text`]: bytes of a file as text.
//!
//! A case holds rows, never files: who calls this crate reads a file into rows before the case is checked.

pub mod export;
pub mod outline;
pub mod table;
pub mod text;
