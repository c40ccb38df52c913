//! Properties of an input: kind of value, commands that require it, and place in a form.

use super::Column;
use crate::units::Dimension;

/// Part of the form in which an input stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Entry state and where the flight ends.
    Mission,
    /// Size and shape.
    Vehicle,
    /// Payload.
    Payload,
    /// Heat shield and its models.
    HeatShield,
    /// Landing without a parachute.
    Impact,
    /// Margins on mass and heating.
    Margins,
    /// Planet, atmosphere, wind, heating models.
    Models,
    /// Densities of the components, and masses that are given.
    Densities,
    /// Convergence and integration.
    Solver,
}

impl Group {
    /// Heading of the group.
    pub fn label(self) -> &'static str {
        match self {
            Group::Mission => "Mission",
            Group::Vehicle => "Vehicle",
            Group::Payload => "Payload",
            Group::HeatShield => "Heat shield",
            Group::Impact => "Impact",
            Group::Margins => "Margins",
            Group::Models => "Planet and models",
            Group::Densities => "Component densities and masses",
            Group::Solver => "Solver",
        }
    }
}

/// Level of user to whom an input is shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// All users: inputs of the report's run page.
    Basic,
    /// Users who change models, assumptions and tolerances.
    Expert,
}

/// Commands that ask for an input, and commands that require it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// Has a default, or is one of several alternatives.
    Optional,
    /// Required by `fly` and by `design`.
    Always,
    /// `fly` cannot do without it.
    Fly,
    /// `design` cannot do without it.
    Design,
}

/// Range of a number in the canonical unit; an end that is not `included` is excluded.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Range {
    /// Lower end.
    pub min: f64,
    /// Upper end.
    pub max: f64,
    /// Whether the lower end itself is allowed.
    pub min_included: bool,
}

impl Range {
    /// Both ends allowed.
    pub const fn closed(min: f64, max: f64) -> Range {
        Range {
            min,
            max,
            min_included: true,
        }
    }

    /// Above `min`, up to `max`.
    pub const fn above(min: f64, max: f64) -> Range {
        Range {
            min,
            max,
            min_included: false,
        }
    }

    /// Whether a value is inside; NaN never is.
    pub fn contains(&self, value: f64) -> bool {
        value <= self.max && (value > self.min || (self.min_included && value == self.min))
    }
}

/// Name, in a case, of the drag of the outline itself.
pub const OWN_OUTLINE: &str = "outline";

/// Name, in a case, of the planet's own atmosphere.
pub const OWN_ATMOSPHERE: &str = "planet";

/// Source of the choices of a nominal input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Choices {
    /// Fixed choices: value and label.
    Fixed(&'static [(&'static str, &'static str)]),
    /// Planets of the library.
    Planets,
    /// The planet's own atmosphere, then those of the library by name.
    Atmospheres,
    /// Forebody concepts of the library.
    ForebodyConcepts,
    /// Aftbody heat-shield materials of the library.
    AftbodyMaterials,
    /// Grounds of the library.
    Grounds,
    /// Aerodynamic databases of the library.
    Aerodynamics,
    /// The outline of the design itself, then the aerodynamic databases of the library.
    DesignAerodynamics,
    /// Outlines of the library.
    Outlines,
}

/// Kind of value that an input accepts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Number {
        /// Physical dimension.
        dimension: Dimension,
        /// Allowed range; a value outside is a fault.
        allowed: Range,
        /// Usual range, that of the report's run page and of the slider; a value outside gives a finding.
        usual: Option<(f64, f64)>,
        /// Whether the number must be an integer.
        whole: bool,
    },
    /// A choice among names.
    Choice(Choices),
    /// Yes or no.
    Flag,
    /// Free text.
    Text,
    /// Rows of numbers.
    Rows(&'static [Column]),
}

/// Default of an input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Preset {
    /// No default.
    Absent,
    /// A number in the canonical unit.
    Number(f64),
    /// A name.
    Name(&'static str),
    /// Yes or no.
    Flag(bool),
}
