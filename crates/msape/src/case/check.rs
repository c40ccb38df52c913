//! Checks keys and values against the list of inputs and reports every fault at once.

use super::fault::InputError;
use super::words::{column_names, must_be, nearest, shown, squeezed, unknown_key, with_unit};
use super::{Case, Value};
use crate::finding::{Finding, Severity};
use crate::quantity::choice::Choice;
use crate::quantity::input::repeated::Section;
use crate::quantity::input::{self, Alternatives, Choices, Input, Key, Kind, Preset};
use crate::units::{canonical, cut, parse_number, told};
use std::fmt;

/// Largest number of reported unknown keys; a file with more of them is not a case.
const UNKNOWN_MAX: usize = 50;
/// Largest number of reported faults of one table.
const ROW_FAULTS_MAX: usize = 100;

/// Message where a case is refused though no fault was noted, which would be a fault of the program.
const NO_REASON: &str =
    "refused without a reason, which is a fault of the program; please report it with the case";

/// Reads checked values out of a case and collects the faults on the way.
pub struct Reader<'a> {
    case: &'a Case,
    /// Faults so far.
    pub faults: Vec<InputError>,
    /// Numbers outside their usual range, and defaults that changed since the case was written.
    pub findings: Vec<Finding>,
}

impl<'a> Reader<'a> {
    /// A reader that has noted every unknown key.
    pub fn new(case: &'a Case) -> Reader<'a> {
        let mut reader = Reader {
            case,
            faults: Vec::new(),
            findings: case.version_note().into_iter().collect(),
        };
        let known = |key: &str| input::find(key).is_some() && !input::repeated::is_repeated(key);
        let mut unknown = case.values.keys().filter(|key| !known(key));
        for key in unknown.by_ref().take(UNKNOWN_MAX) {
            reader.fault(key, unknown_key(key));
        }
        let more = unknown.count();
        if more > 0 {
            reader.fault(&"", format!("and {more} more unknown keys"));
        }
        // a caller that reads the files replaces their names by the rows
        for file in input::inputs() {
            if let ([table, ..], true) = (file.tables, reader.given(file)) {
                reader.fault(file, format!("was not read; give its rows as {table}"));
            }
        }
        reader
    }

    /// Notes a fault, at an input or at a section.
    pub fn fault(&mut self, key: &dyn fmt::Display, message: impl Into<String>) {
        self.faults.push(InputError {
            key: cut(&key.to_string()),
            message: message.into(),
        });
    }

    /// Notes a remark at an input.
    pub fn remark(&mut self, key: &dyn fmt::Display, message: impl Into<String>) {
        self.findings.push(Finding::note("input", key, message));
    }

    /// All faults, each once: a key may be read more than once. A refusal has one at least.
    pub fn into_faults(mut self) -> Vec<InputError> {
        if self.faults.is_empty() {
            self.fault(&"", NO_REASON);
        }
        once(&mut self.faults);
        self.faults
    }

    /// All remarks, each once.
    pub fn into_findings(mut self) -> Vec<Finding> {
        once(&mut self.findings);
        self.findings
    }

    fn value(&self, key: Key) -> Option<&'a Value> {
        self.case.values.get(&*key.text())
    }

    /// Whether the case gives this input.
    pub fn given(&self, key: impl Into<Key>) -> bool {
        self.value(key.into()).is_some()
    }

    /// Whether the case gives one of these inputs.
    pub fn any_given(&self, inputs: &[&'static Input]) -> bool {
        self.case.gives_any(inputs)
    }

    /// Ways that the case uses to give a quantity, each by the first of its inputs that is given.
    pub fn ways(&self, alternatives: &Alternatives) -> Vec<&'static Input> {
        let first = |way: &&[&'static Input]| way.iter().find(|input| self.given(**input)).copied();
        alternatives.ways.iter().filter_map(first).collect()
    }

    /// A value as the case writes it.
    pub fn text(&self, input: &'static Input) -> Option<String> {
        self.case.text(input.key)
    }

    /// The largest number of a repeated section in the case.
    pub fn count(&self, of: &Section) -> usize {
        let mut numbers = (1..=of.most).rev();
        let given = |number: &usize| {
            let section = format!("{}.{number}.", of.name);
            let mut after = self.case.values.range(section.clone()..);
            after
                .next()
                .is_some_and(|(key, _)| key.starts_with(&section))
        };
        numbers.find(given).unwrap_or(0)
    }

    /// A number in the canonical unit, or its default; `None` when absent without default, or at fault.
    pub fn number(&mut self, key: impl Into<Key>) -> Option<f64> {
        let key = key.into();
        let input = key.input;
        let Kind::Number {
            dimension,
            allowed,
            usual,
            whole,
        } = input.kind
        else {
            debug_assert!(false, "{key} is no number");
            return None;
        };
        let unit = canonical(dimension);
        let value = match self.value(key) {
            None => match input.preset {
                Preset::Number(value) => return Some(value),
                _ => return None,
            },
            Some(Value::Number(value)) => *value,
            Some(Value::Text(text)) => match parse_number(text, dimension, unit) {
                Ok(value) => value,
                Err(error) => {
                    self.fault(&key, format!("{error}; {}", must_be(&allowed, unit.symbol)));
                    return None;
                }
            },
            Some(other) => {
                self.fault(
                    &key,
                    format!(
                        "got {}, {}",
                        shown(other, false),
                        must_be(&allowed, unit.symbol)
                    ),
                );
                return None;
            }
        };
        if !allowed.contains(value) {
            self.fault(
                &key,
                format!(
                    "got {}, {}",
                    with_unit(value, unit.symbol),
                    must_be(&allowed, unit.symbol)
                ),
            );
            return None;
        }
        if whole && value % 1.0 != 0.0 {
            self.fault(&key, format!("got {}, must be a whole number", told(value)));
            return None;
        }
        if let Some((min, max)) = usual
            && !(min..=max).contains(&value)
        {
            self.findings.push(Finding {
                severity: Severity::Note,
                model: "input".to_string(),
                key: key.to_string(),
                value: Some(value),
                valid: (Some(min), Some(max)),
                message: format!(
                    "{} is {}, outside the usual range {} to {}.",
                    input.label,
                    with_unit(value, unit.symbol),
                    min,
                    with_unit(max, unit.symbol)
                ),
                source: input.source.to_string(),
                field: Some(key.to_string()),
            });
        }
        Some(value)
    }

    /// A number that cannot be absent; its absence is a fault.
    pub fn required_number(&mut self, input: &'static Input) -> Option<f64> {
        if self.given(input) {
            return self.number(input);
        }
        self.missing(input);
        None
    }

    /// Records that an input is missing, with the values allowed.
    pub fn missing(&mut self, input: &'static Input) {
        let message = match input.kind {
            Kind::Number {
                dimension, allowed, ..
            } => {
                format!(
                    "missing; {} {}",
                    input.label,
                    must_be(&allowed, canonical(dimension).symbol)
                )
            }
            _ => format!("missing; {}", input.help),
        };
        self.fault(input, message);
    }

    /// A yes or no, or its default.
    pub fn flag(&mut self, input: &'static Input) -> Option<bool> {
        match (self.value(input.into()), input.preset) {
            (Some(Value::Flag(flag)), _) => Some(*flag),
            (None, Preset::Flag(flag)) => Some(flag),
            (None, _) => None,
            (Some(other), _) => {
                self.fault(
                    input,
                    format!("got {}, must be true or false", shown(other, false)),
                );
                None
            }
        }
    }

    /// Free text.
    pub fn words(&mut self, key: impl Into<Key>) -> Option<String> {
        let key = key.into();
        match self.value(key)? {
            Value::Text(text) => Some(text.clone()),
            other => {
                self.fault(&key, format!("got {}, must be text", shown(other, false)));
                None
            }
        }
    }

    /// Value of an input with fixed choices, or its default.
    pub fn choice<C: Choice>(&mut self, key: impl Into<Key>) -> Option<C> {
        let key = key.into();
        let fixed = match key.input.kind {
            Kind::Choice(Choices::Fixed(fixed)) => fixed,
            _ => &[],
        };
        let names: Vec<&'static str> = fixed.iter().map(|(name, _)| *name).collect();
        let name = self.name(key, &names)?;
        let choice = C::named(name);
        debug_assert!(choice.is_some(), "{key}: {name} is of another choice");
        choice
    }

    /// One of `names`, or the default; `SuttonGraves` is taken for `sutton-graves`.
    pub fn name<'n>(&mut self, key: impl Into<Key>, names: &[&'n str]) -> Option<&'n str> {
        let key = key.into();
        let input = key.input;
        let wanted = match (self.value(key), input.preset) {
            (Some(Value::Text(text)), _) => text.clone(),
            (None, Preset::Name(name)) => name.to_string(),
            (None, _) => return None,
            (Some(other), _) => {
                self.fault(
                    &key,
                    format!(
                        "got {}, must be one of {}",
                        shown(other, false),
                        names.join(", ")
                    ),
                );
                return None;
            }
        };
        let found = names
            .iter()
            .find(|name| squeezed(name) == squeezed(&wanted));
        if found.is_none() {
            let near = nearest(&wanted, names.iter().copied());
            let hint = near
                .map(|n| format!("; did you mean \"{n}\"?"))
                .unwrap_or_default();
            self.fault(
                &key,
                format!(
                    "got \"{}\", must be one of {}{hint}",
                    cut(&wanted),
                    names.join(", ")
                ),
            );
        }
        found.copied()
    }

    /// Rows of numbers with the columns of the input; ragged or empty tables are faults.
    pub fn rows(&mut self, key: impl Into<Key>) -> Option<Vec<Vec<f64>>> {
        let key = key.into();
        let input = key.input;
        let Kind::Rows(columns) = input.kind else {
            return None;
        };
        let rows = match self.value(key)? {
            Value::Rows(rows) => rows.clone(),
            other => {
                self.fault(
                    &key,
                    format!(
                        "got {}, must be rows of {}",
                        shown(other, true),
                        column_names(input)
                    ),
                );
                return None;
            }
        };
        let fewest = columns.iter().filter(|column| column.required).count();
        let before = self.faults.len();
        if rows.is_empty() {
            self.fault(
                &key,
                format!("got no rows, must be rows of {}", column_names(input)),
            );
        }
        for (i, row) in rows.iter().enumerate() {
            if self.faults.len() - before >= ROW_FAULTS_MAX {
                break;
            }
            if row.len() < fewest || row.len() > columns.len() || row.len() != rows[0].len() {
                let message = format!(
                    "row {} has {} numbers, must be {}",
                    i + 1,
                    row.len(),
                    column_names(input)
                );
                self.fault(&key, message);
            }
            for (cell, column) in row.iter().zip(columns) {
                let allowed = column.allowed;
                let wrong = if !cell.is_finite() {
                    "must be a finite number".to_string()
                } else if !allowed.contains(*cell) {
                    must_be(&allowed, "")
                } else {
                    continue;
                };
                if self.faults.len() >= before + ROW_FAULTS_MAX {
                    return None;
                }
                let (row, name, cell) = (i + 1, column.name, told(*cell));
                let message = format!("row {row}, {name}: got {cell}, {wrong}");
                self.fault(&key, message);
            }
        }
        (self.faults.len() == before).then_some(rows)
    }
}

/// Removes repeated items from a list.
fn once<T: PartialEq>(list: &mut Vec<T>) {
    let mut kept: Vec<T> = Vec::with_capacity(list.len());
    for item in list.drain(..) {
        if !kept.contains(&item) {
            kept.push(item);
        }
    }
    *list = kept;
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quantity::choice::{ConvectiveModel, RadiativeModel};

    fn read(text: &str) -> Case {
        Case::from_toml(&format!("schema='msape/1'\n{text}")).unwrap()
    }

    #[test]
    fn every_fault_names_key_value_range_and_unit() {
        let case = read(
            "[vehicle]\nmass_kg=-46.0\nnose_radius_m=nan\ndiameter_m='90 kg'\n[entry]\nspeed_km_s=12.0\nlatitude_deg=91",
        );
        let mut reader = Reader::new(&case);
        for input in [
            &input::vehicle::MASS_KG,
            &input::vehicle::NOSE_RADIUS_M,
            &input::vehicle::DIAMETER_M,
            &input::entry::LATITUDE_DEG,
        ] {
            assert_eq!(reader.number(input), None, "{input}");
        }
        assert_eq!(reader.required_number(&input::entry::AZIMUTH_DEG), None);
        let said: Vec<String> = reader.faults.iter().map(ToString::to_string).collect();
        assert_eq!(
            said,
            [
                "entry.speed_km_s: unknown key; the nearest known key is entry.speed_m_s, in m/s",
                "vehicle.mass_kg: got -46 kg, must be above 0 kg and at most 1000000 kg",
                "vehicle.nose_radius_m: got NaN m, must be above 0 m and at most 1000 m",
                "vehicle.diameter_m: unit \"kg\" does not fit here: use one of m, mm, cm, km, in, ft, mi, nmi; must be above 0 m and at most 300 m",
                "entry.latitude_deg: got 91 deg, must be -90 to 90 deg",
                "entry.azimuth_deg: missing; Entry Azimuth must be -360 to 360 deg",
            ]
        );
    }

    #[test]
    fn names_are_read_as_the_report_spells_them() {
        let case = read("[heating]\nconvective='SuttonGraves'\nradiative='TauberSuton'");
        let mut reader = Reader::new(&case);
        let convective: Option<ConvectiveModel> = reader.choice(&input::heating::CONVECTIVE);
        assert_eq!(convective, Some(ConvectiveModel::SuttonGraves));
        let radiative: Option<RadiativeModel> = reader.choice(&input::heating::RADIATIVE);
        assert_eq!(radiative, None);
        assert!(
            reader.faults[0]
                .message
                .contains("did you mean \"tauber-sutton\"")
        );
    }

    #[test]
    fn outside_the_usual_range_is_a_finding() {
        let case = read("[entry]\nspeed_m_s=9000.0");
        let mut reader = Reader::new(&case);
        assert_eq!(reader.number(&input::entry::SPEED_M_S), Some(9000.0));
        let about = |finding: &&Finding| finding.key == "entry.speed_m_s";
        let finding = reader.findings.iter().find(about).unwrap();
        assert_eq!(finding.valid, (Some(10_000.0), Some(16_000.0)));
    }

    #[test]
    fn ragged_rows_are_faults() {
        let case = read("[atmosphere]\ntable=[[0.0,1.2],[1.0],[2.0,nan]]");
        let mut reader = Reader::new(&case);
        assert_eq!(reader.rows(&input::atmosphere::TABLE), None);
        assert_eq!(reader.faults.len(), 2);
    }
}
