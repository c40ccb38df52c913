//! What an input takes, who needs it, and where it stands in a form.

use crate::units::Dimension;

/// Part of the form in which an input stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Entry state and where the flight ends.
    Mission,
    /// Size and shape.
    Vehicle,
    /// What is carried.
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

/// Who needs to see an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// Everybody: the report's run page.
    Basic,
    /// Those who change models, assumptions and tolerances.
    Expert,
}

/// Which command asks for an input, and which cannot do without it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Need {
    /// Has a default, or is one of several alternatives.
    Optional,
    /// Neither `fly` nor `design` can do without it.
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

/// Rules beyond a table that can only be held.
pub(super) const HELD: &[(&str, &str)] = &[("hold", "Hold the end"), ("refuse", "Refuse")];

/// Name, in a case, of the drag of the outline itself.
pub const OWN_OUTLINE: &str = "outline";

/// Name, in a case, of the planet's own atmosphere.
pub const OWN_ATMOSPHERE: &str = "planet";

/// Where the choices of a nominal input come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Choices {
    /// Always the same: value and label.
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

/// Range of the cells of a column of any table, by its name; the signs of attitude and the like are free.
///
/// ```
/// use msape::quantity::input::range_of_column;
/// assert!(!range_of_column("altitude_m").contains(1e12));
/// ```
pub fn range_of_column(name: &str) -> Range {
    match name {
        "altitude_m" => Range::closed(-1e6, 1e9),
        // Nought is open: the other two of density, temperature and pressure give it, or the row is refused.
        "density_kg_m3" => Range::closed(0.0, 1e4),
        "temperature_K" => Range::closed(0.0, 1e5),
        "pressure_Pa" => Range::closed(0.0, 1e12),
        "eastward_m_s" | "northward_m_s" => Range::closed(-2e3, 2e3),
        "mach" => Range::closed(0.0, 1e3),
        "speed_m_s" => Range::closed(0.0, 1e5),
        "time_s" => Range::closed(-1e7, 1e7),
        // Nought stands for none, where the altitude is given in its place.
        "knudsen" => Range::closed(0.0, 1e12),
        "alpha_deg" => Range::closed(-180.0, 180.0),
        "bank_deg" => Range::closed(-36_000.0, 36_000.0),
        "p_deg_s" | "q_deg_s" | "r_deg_s" => Range::closed(-36_000.0, 36_000.0),
        "ca" | "cn" | "cm" | "cmq" | "lift_coefficient" => Range::closed(-100.0, 100.0),
        "drag_coefficient" => Range::closed(0.0, 100.0),
        "convective_w_m2" | "radiative_w_m2" => Range::closed(0.0, 1e12),
        "radius_fraction" | "arc_fraction" => Range::closed(0.0, 1.0),
        "x_m" | "y_m" | "z_m" | "r_m" => Range::closed(-1e4, 1e4),
        // Elements of inertia, kg-m², and of a quaternion.
        _ => Range::closed(-1e9, 1e9),
    }
}

/// A column of an input table.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Column {
    /// Name with unit, such as `altitude_m`.
    pub name: &'static str,
    /// Whether every row must have it.
    pub required: bool,
}

/// What kind of value an input takes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number.
    Number {
        /// What it measures.
        dimension: Dimension,
        /// Outside of it the input is refused.
        allowed: Range,
        /// Outside of it the answer carries a finding; the range of the report's run page, and of the slider.
        usual: Option<(f64, f64)>,
        /// Whether it counts something.
        whole: bool,
    },
    /// One of several names.
    Choice(Choices),
    /// Yes or no.
    Flag,
    /// Free text.
    Text,
    /// Rows of numbers.
    Rows(&'static [Column]),
}

/// What holds when the case says nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Preset {
    /// Nothing holds.
    Absent,
    /// A number in the canonical unit.
    Number(f64),
    /// A name.
    Name(&'static str),
    /// Yes or no.
    Flag(bool),
}
