//! The outputs: one entry for each number of an answer.

mod attitude;
mod design;
mod flight;
mod landing;
mod mass;
mod stability;
mod structure;
mod turning;

use crate::answer::Answer;
use crate::quantity::{Job, Module};
use crate::units::{Dimension, Unit, canonical};

/// An output of an answer.
#[derive(Clone, Copy)]
pub struct Output {
    /// Key with its SI unit, such as `total_entry_mass_kg`.
    pub key: &'static str,
    /// The report's own label where it has one, without the unit.
    pub label: &'static str,
    /// Physical dimension of the output.
    pub dimension: Dimension,
    /// Symbol of the unit shown by default and used in the report's own CSV.
    pub unit: &'static str,
    /// Whether the report's CSV has this column.
    pub in_report: bool,
    /// Module of the report.
    pub module: Module,
    /// Explanation of the output in one sentence.
    pub help: &'static str,
    /// Source of the definition: equation, table, section.
    pub source: &'static str,
    /// Function that returns the value in an answer, in the canonical unit; `None` when it did not occur.
    pub get: fn(&Answer) -> Option<f64>,
}

impl Output {
    const fn new(
        key: &'static str,
        label: &'static str,
        module: Module,
        get: fn(&Answer) -> Option<f64>,
    ) -> Output {
        Output {
            key,
            label,
            dimension: Dimension::One,
            unit: "",
            in_report: false,
            module,
            help: "",
            source: "",
            get,
        }
    }

    const fn unit(mut self, dimension: Dimension, unit: &'static str) -> Output {
        self.dimension = dimension;
        self.unit = unit;
        self
    }

    const fn help(mut self, help: &'static str, source: &'static str) -> Output {
        self.help = help;
        self.source = source;
        self
    }

    /// Marks a column of the report's Appendix D.
    const fn report(mut self) -> Output {
        self.in_report = true;
        self
    }

    /// Unit in which it is shown by default.
    pub fn shown_unit(&self) -> &'static Unit {
        Unit::find(self.unit)
            .filter(|unit| unit.dimension == self.dimension)
            .unwrap_or_else(|| canonical(self.dimension))
    }

    /// Column header in the report's manner, such as `Max Dynamic Pressure (Pa)`.
    pub fn header(&self) -> String {
        if self.unit.is_empty() {
            self.label.to_string()
        } else {
            format!("{} ({})", self.label, self.unit)
        }
    }
}

/// The outputs of a job, in the order of tables and files.
pub fn outputs(job: Job) -> impl Iterator<Item = &'static Output> {
    let of_design: [&[Output]; 7] = match job {
        Job::Fly => [&[]; 7],
        Job::Design => [
            design::OUTPUTS,
            mass::OUTPUTS,
            structure::OUTPUTS,
            landing::OUTPUTS,
            stability::FREE_MOLECULAR,
            stability::HYPERSONIC,
            turning::OUTPUTS,
        ],
    };
    of_design
        .into_iter()
        .flatten()
        .chain(flight::OUTPUTS)
        .chain(attitude::OUTPUTS)
}

/// The output with this key.
pub fn find(key: &str) -> Option<&'static Output> {
    outputs(Job::Design).find(|output| output.key == key)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_stand_once_and_every_output_explains_itself() {
        let all: Vec<_> = outputs(Job::Design).collect();
        for (i, output) in all.iter().enumerate() {
            assert!(
                all[..i].iter().all(|other| other.key != output.key),
                "{}",
                output.key
            );
            assert!(
                all[..i]
                    .iter()
                    .all(|other| other.header() != output.header()),
                "{}",
                output.header()
            );
            assert!(
                output.help.ends_with('.') && !output.source.is_empty(),
                "{}",
                output.key
            );
            let unit = Unit::find(output.unit).unwrap();
            assert_eq!(unit.dimension, output.dimension, "{}", output.key);
        }
    }
}
