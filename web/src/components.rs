//! What pages are made of. They read signals and call [`crate::state::State::edit`].

pub mod alternatives;
pub mod chart;
pub mod chart_panel;
pub mod chart_table;
pub mod choice;
pub mod coupling;
pub mod drawing;
pub mod export;
pub mod field;
pub mod form;
pub mod header;
pub mod headline;
pub mod mass_tree;
pub mod notes;
pub mod number;
pub mod open;
pub mod residuals;
pub mod results;
pub mod rows;
pub mod runs;
pub mod segments;
pub mod share;
pub mod tabs;
pub mod vehicle;
pub mod view3d;
