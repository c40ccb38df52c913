//! The inputs: one entry for each key that a case file may hold.

mod aerodynamics;
mod attitude;
mod design;
mod heating;
mod mission;
mod outline;
pub mod phase;
mod vehicle;

use crate::units::{Dimension, Unit, canonical};

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
const HELD: &[(&str, &str)] = &[("hold", "Hold the end"), ("refuse", "Refuse")];

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

/// One input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Input {
    /// Dotted key in the case file, such as `entry.speed_m_s`.
    pub key: &'static str,
    /// The report's own label where it has one, without the unit.
    pub label: &'static str,
    /// Symbol of the unit shown by default.
    pub unit: &'static str,
    /// One sentence: what it is.
    pub help: &'static str,
    /// Where its definition or default comes from.
    pub source: &'static str,
    /// Part of the form.
    pub group: Group,
    /// Who needs to see it.
    pub level: Level,
    /// Which command needs it.
    pub need: Need,
    /// What it takes.
    pub kind: Kind,
    /// What holds when it is absent.
    pub preset: Preset,
    /// Other names under which it is read.
    pub aliases: &'static [&'static str],
}

impl Input {
    const fn new(key: &'static str, label: &'static str, group: Group, kind: Kind) -> Input {
        Input {
            key,
            label,
            unit: "",
            help: "",
            source: "",
            group,
            level: Level::Expert,
            need: Need::Optional,
            kind,
            preset: Preset::Absent,
            aliases: &[],
        }
    }

    const fn number(
        key: &'static str,
        label: &'static str,
        group: Group,
        dimension: Dimension,
        allowed: Range,
    ) -> Input {
        let kind = Kind::Number {
            dimension,
            allowed,
            usual: None,
            whole: false,
        };
        Input::new(key, label, group, kind)
    }

    const fn unit(mut self, symbol: &'static str) -> Input {
        self.unit = symbol;
        self
    }

    const fn usual(mut self, min: f64, max: f64) -> Input {
        if let Kind::Number { usual, .. } = &mut self.kind {
            *usual = Some((min, max));
        }
        self
    }

    const fn whole(mut self) -> Input {
        if let Kind::Number { whole, .. } = &mut self.kind {
            *whole = true;
        }
        self
    }

    const fn help(mut self, help: &'static str, source: &'static str) -> Input {
        self.help = help;
        self.source = source;
        self
    }

    const fn basic(mut self) -> Input {
        self.level = Level::Basic;
        self
    }

    const fn need(mut self, need: Need) -> Input {
        self.need = need;
        self
    }

    const fn preset(mut self, preset: Preset) -> Input {
        self.preset = preset;
        self
    }

    const fn aliases(mut self, aliases: &'static [&'static str]) -> Input {
        self.aliases = aliases;
        self
    }

    /// Dimension of a number; [`Dimension::One`] for what is not a number.
    pub fn dimension(&self) -> Dimension {
        match self.kind {
            Kind::Number { dimension, .. } => dimension,
            _ => Dimension::One,
        }
    }

    /// Unit in which it is shown by default.
    pub fn shown_unit(&self) -> &'static Unit {
        Unit::find(self.unit)
            .filter(|unit| unit.dimension == self.dimension())
            .unwrap_or_else(|| canonical(self.dimension()))
    }

    /// Whether it is a table of one row, which may be given without the outer brackets: `[0.2, 0.0, 0.0]`.
    pub fn is_one_row(&self) -> bool {
        attitude::ONE_ROW.contains(&self.key)
    }

    /// The report's column header, such as `Entry Velocity (m/s)`.
    pub fn header(&self) -> String {
        if self.unit.is_empty() {
            self.label.to_string()
        } else {
            format!("{} ({})", self.label, self.unit)
        }
    }
}

/// All inputs, in the order of files and forms.
pub fn inputs() -> impl Iterator<Item = &'static Input> {
    mission::INPUTS
        .iter()
        .chain(heating::INPUTS)
        .chain(design::INPUTS)
        .chain(vehicle::INPUTS)
        .chain(outline::INPUTS)
        .chain(attitude::INPUTS)
        .chain(aerodynamics::INPUTS)
        .chain(phase::INPUTS)
}

/// The input with this key or alias; of a key of one phase, such as `phase.2.mach`, the one that stands for all.
pub fn find(key: &str) -> Option<&'static Input> {
    let numbered = phase::numbered(key);
    let key = numbered.as_ref().map_or(key, |(_, key)| key);
    inputs().find(|input| input.key == key || input.aliases.contains(&key))
}

/// The key under which a case keeps an input: aliases give way to it, a phase without number is the first.
pub fn canonical_key(key: &str) -> String {
    match (find(key), phase::numbered(key)) {
        (Some(_), Some(_)) | (None, _) => key.to_string(),
        (Some(input), None) => match input.key.strip_prefix("phase.") {
            Some(name) => format!("{}.1.{name}", phase::SECTION),
            None => input.key.to_string(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_stand_once_and_every_input_explains_itself() {
        let all: Vec<_> = inputs().collect();
        for (i, input) in all.iter().enumerate() {
            assert!(
                all[..i].iter().all(|other| other.key != input.key),
                "{}",
                input.key
            );
            assert!(
                !input.label.is_empty() && input.help.ends_with('.'),
                "{}",
                input.key
            );
            assert!(!input.source.is_empty(), "{}", input.key);
        }
    }

    #[test]
    fn presets_and_usual_ranges_are_allowed() {
        for input in inputs() {
            let Kind::Number {
                allowed,
                usual,
                dimension,
                ..
            } = input.kind
            else {
                continue;
            };
            if let Preset::Number(value) = input.preset {
                assert!(allowed.contains(value), "{}", input.key);
            }
            if let Some((min, max)) = usual {
                assert!(
                    allowed.contains(min) && allowed.contains(max) && min < max,
                    "{}",
                    input.key
                );
            }
            assert!(
                Unit::find(input.unit).is_some_and(|u| u.dimension == dimension),
                "{}",
                input.key
            );
        }
    }

    #[test]
    fn a_key_ends_in_its_canonical_unit() {
        let suffix = |d: Dimension| match d {
            Dimension::Length => "_m",
            Dimension::Mass => "_kg",
            Dimension::Speed => "_m_s",
            Dimension::Angle => "_deg",
            Dimension::Density => "_kg_m3",
            Dimension::Time => "_s",
            Dimension::Load => "_earth_g",
            Dimension::Temperature => "_k",
            _ => "",
        };
        for input in inputs() {
            if let Kind::Number { dimension, .. } = input.kind {
                let sections = ["design.density_kg_m3.", "design.component_mass_kg."];
                let of_components = sections
                    .iter()
                    .any(|section| input.key.starts_with(section));
                assert!(
                    of_components || input.key.ends_with(suffix(dimension)),
                    "{}",
                    input.key
                );
            }
        }
    }
}
