//! The carrier structure as a shell of revolution: stress, displacement and first frequencies by finite elements.
//!
//! The high-fidelity counterpart of [`crate::vehicle::structure`], computed once for a converged design:
//!
//! 1. [`mesh`]: meridians of lines and arcs become elements of three nodes.
//! 2. [`section`]: stiffness and faces of a solid wall or a sandwich.
//! 3. [`element`]: strains of a shear-deformable shell for the harmonic n round the axis.
//! 4. [`model`]: degrees of freedom, supports, stiffness and mass under their skyline.
//! 5. [`statics`]: displacement and stress under distributed loads. [`modes`]: first frequency of each harmonic.
//! 6. [`carrier`]: the model of a vehicle with its walls, masses and loads. [`analysis`]: its results, [`wall`] for one wall.
//!
//! Deliberately absent: nonlinear buckling, the fillings' stiffness (they are mass), torsion.

pub mod analysis;
pub mod carrier;
pub mod element;
pub mod mesh;
pub mod model;
pub mod modes;
pub mod section;
pub mod statics;
pub mod wall;
