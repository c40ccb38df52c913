//! The modules of the report, by which quantities are grouped, the jobs that give them and the tasks that ask for them.

/// Module of the report to which an output belongs; results are grouped by it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Module {
    /// Passes and convergence.
    Coupling,
    /// Dimensions.
    Geometry,
    /// Masses, center of gravity, inertias.
    Mass,
    /// Landing.
    Impact,
    /// Carrier and primary structure.
    Structure,
    /// Trajectory.
    Flight,
    /// Coefficients.
    Aerodynamics,
    /// Heating environment.
    Heating,
    /// Heat shield.
    HeatShield,
    /// Payload temperature.
    ThermalSoak,
}

impl Module {
    /// Heading of the module.
    pub fn label(self) -> &'static str {
        match self {
            Module::Coupling => "Coupling",
            Module::Geometry => "Geometry",
            Module::Mass => "Mass properties",
            Module::Impact => "Impact analysis",
            Module::Structure => "Structural analysis",
            Module::Flight => "Flight mechanics",
            Module::Aerodynamics => "Aerodynamics",
            Module::Heating => "Aerothermal",
            Module::HeatShield => "TPS sizing",
            Module::ThermalSoak => "Thermal soak",
        }
    }
}

/// Kind of job whose answers have an output.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Job {
    /// `fly`: flight only.
    Fly,
    /// `design`: everything.
    Design,
}

/// Task that asks for an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Task {
    /// The flight of a point mass.
    PointMass,
    /// The flight of a rigid body.
    RigidBody,
    /// A design.
    Design,
    /// The flight of a designed vehicle as a rigid body.
    DesignedBody,
    /// The heat shield in depth.
    InDepth,
}

impl Task {
    /// All that fly or design.
    pub const ALL: &'static [Task] = &[
        Task::PointMass,
        Task::RigidBody,
        Task::Design,
        Task::DesignedBody,
    ];
    /// The flights.
    pub const FLOWN: &'static [Task] = &[Task::PointMass, Task::RigidBody, Task::DesignedBody];
}
