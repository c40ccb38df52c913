//! The inputs: one item for each key that a case file may hold, such as [`entry::SPEED_M_S`] for `entry.speed_m_s`.
//!
//! The module of an item is the section of its key; the name is the rest of the key, dots as underlines.

/// Declares inputs, for the default tasks unless they name others: the item of each, and the list of all.
macro_rules! inputs {
    ($tasks:expr; $($name:ident: $key:literal = $made:expr;)+) => {
        $(
            #[doc = concat!("`", $key, "`.")]
            pub static $name: Input = $made.of($key, $tasks);
        )+

        /// The inputs of this file, in the order of the list.
        pub static INPUTS: &[&Input] = &[$(&$name),+];
    };
}

mod alternatives;
pub mod atmosphere;
pub mod attitude;
pub mod column;
pub mod design;
pub mod entry;
pub mod heating;
mod kind;
pub mod outline;
pub mod phase;
pub mod planet;
pub mod repeated;
pub mod solver;
pub mod stop;
pub mod tps;
pub mod vehicle;
pub mod wind;

use super::Task;
use crate::units::{Dimension, Unit, canonical};
use std::fmt;

pub use alternatives::Alternatives;
pub use column::Column;
pub use kind::{Choices, Group, Kind, Level, Need, OWN_ATMOSPHERE, OWN_OUTLINE, Preset, Range};
pub use repeated::Key;

const CONVENTION: &str = "convention of this program";
const RUN_PAGE: &str = "NASA/TM-2014-218507, Appendix D, run page";
const REPORT_FLIGHT: &str = "NASA/TM-2014-218507, section 3.2";
const REPORT_STATIC: &str = "NASA/TM-2014-218507, section 3.3.1";
const REPORT_DAMPING: &str = "NASA/TM-2014-218507, section 3.3.7";
/// Altitude below the lowest of every planet, m; each planet has its own limit.
const DEEPEST_M: f64 = -1e6;

/// An input of a case.
#[derive(Clone, Copy)]
pub struct Input {
    /// Dotted key in the case file, such as `entry.speed_m_s`.
    pub key: &'static str,
    /// The report's own label where it has one, without the unit.
    pub label: &'static str,
    /// Symbol of the unit shown by default.
    pub unit: &'static str,
    /// Explanation of the input in one sentence.
    pub help: &'static str,
    /// Source of the definition or of the default.
    pub source: &'static str,
    /// Part of the form.
    pub group: Group,
    /// Level of user to whom it is shown.
    pub level: Level,
    /// Commands that require it.
    pub need: Need,
    /// Kind of value that it accepts.
    pub kind: Kind,
    /// Default.
    pub preset: Preset,
    /// Other names under which it is accepted.
    pub aliases: &'static [&'static str],
    /// Tasks that ask for it.
    pub tasks: &'static [Task],
    /// Group of alternative inputs to which it belongs.
    pub alternatives: Option<&'static Alternatives>,
    /// Section that takes the place of the default if a case has it.
    pub default_gives_way_to: Option<&'static str>,
    /// Tables that the file named by this input contains.
    pub tables: &'static [&'static Input],
    /// Whether it is a table of one row, which may be given without the outer brackets: `[0.2, 0.0, 0.0]`.
    pub one_row: bool,
}

impl PartialEq for Input {
    fn eq(&self, other: &Input) -> bool {
        self.key == other.key
    }
}

impl fmt::Debug for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key)
    }
}

/// Key of the input, by which messages name it.
impl fmt::Display for Input {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.key)
    }
}

impl Input {
    const fn new(label: &'static str, group: Group, kind: Kind) -> Input {
        Input {
            key: "",
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
            tasks: &[],
            alternatives: None,
            default_gives_way_to: None,
            tables: &[],
            one_row: false,
        }
    }

    const fn number(
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
        Input::new(label, group, kind)
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

    /// This input for the given tasks instead of those of its file.
    const fn tasks(mut self, tasks: &'static [Task]) -> Input {
        self.tasks = tasks;
        self
    }

    const fn one_way_of(mut self, alternatives: &'static Alternatives) -> Input {
        self.alternatives = Some(alternatives);
        self
    }

    const fn default_gives_way_to(mut self, section: &'static str) -> Input {
        self.default_gives_way_to = Some(section);
        self
    }

    const fn file_of(mut self, tables: &'static [&'static Input]) -> Input {
        self.tables = tables;
        self
    }

    const fn one_row(mut self) -> Input {
        self.one_row = true;
        self
    }

    const fn of(mut self, key: &'static str, tasks: &'static [Task]) -> Input {
        self.key = key;
        if self.tasks.is_empty() {
            self.tasks = tasks;
        }
        self
    }

    /// Whether a task asks for it.
    pub fn is_of(&self, task: Task) -> bool {
        self.tasks.contains(&task)
    }

    /// Inputs of the other ways to give the same quantity.
    pub fn rivals(&self) -> impl Iterator<Item = &'static Input> {
        let key = self.key;
        let ways = self.alternatives.map_or(&[][..], |all| all.ways);
        let own = move |way: &&&[&Input]| way.iter().any(|input| input.key == key);
        let others = ways.iter().filter(move |way| !own(way));
        others.flat_map(|way| way.iter().copied())
    }

    /// The input that names a file of this table.
    pub fn file(&self) -> Option<&'static Input> {
        inputs().find(|file| file.tables.contains(&self))
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
    let lists = [
        entry::INPUTS,
        planet::INPUTS,
        atmosphere::INPUTS,
        wind::INPUTS,
        heating::INPUTS,
        stop::INPUTS,
        solver::INPUTS,
        heating::table::INPUTS,
        design::INPUTS,
        vehicle::INPUTS,
        outline::INPUTS,
        vehicle::freedom::INPUTS,
        attitude::INPUTS,
        vehicle::aerodynamics::INPUTS,
        phase::INPUTS,
        tps::INPUTS,
        tps::layer::INPUTS,
    ];
    lists.into_iter().flatten().copied()
}

/// The rules beyond the ends of tables.
pub static BEYOND_TABLES: [&Input; 5] = [
    &atmosphere::EXTRAPOLATION,
    &heating::EXTRAPOLATION,
    &vehicle::AERODYNAMICS_EXTRAPOLATION,
    &vehicle::BANK_EXTRAPOLATION,
    &wind::EXTRAPOLATION,
];

/// The input with this key or alias; of a key of one of a repeated section, such as `phase.2.mach`, the one that stands for all.
pub fn find(key: &str) -> Option<&'static Input> {
    let numbered = repeated::numbered(key);
    let key = numbered.as_ref().map_or(key, |(_, key)| key);
    inputs().find(|input| input.key == key || input.aliases.contains(&key))
}

/// The key under which a case keeps an input: aliases give way to it, one of a repeated section without number is the first.
pub fn canonical_key(key: &str) -> String {
    match (find(key), repeated::numbered(key)) {
        (Some(_), Some(_)) | (None, _) => key.to_string(),
        (Some(input), None) if repeated::is_repeated(input.key) => input.of_number(1).to_string(),
        (Some(input), None) => input.key.to_string(),
    }
}

#[cfg(test)]
mod tests;
