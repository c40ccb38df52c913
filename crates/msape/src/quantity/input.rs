//! The inputs: one entry for each key that a case file may hold.

mod aerodynamics;
mod attitude;
mod design;
mod heating;
mod kind;
mod mission;
mod outline;
pub mod phase;
mod vehicle;

use crate::units::{Dimension, Unit, canonical};

use kind::HELD;
pub use kind::{
    Choices, Column, Group, Kind, Level, Need, OWN_ATMOSPHERE, OWN_OUTLINE, Preset, Range,
    range_of_column,
};

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
mod tests;
