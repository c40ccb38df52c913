//! The documented cases that ship with the program, solved and compared with their published or computed figures.
//!
//! Expectations are data: `data/validation/<name>.toml` names a case of the folder `cases` and lists quantities with
//! their reference values, tolerances and the reasons of these. Command and page
//! compute the comparison anew. Predictions of flown capsules, [`prediction`], are listed with the comparisons but are not a test.

mod file;
#[cfg(feature = "ablation")]
mod in_depth;
mod points;
pub mod prediction;

pub use file::{Command, Expectation, File, Histories, Points, Tolerance};

use crate::answer::Answer;
use crate::answer::output;
use crate::case::Case;
use crate::flight::Request;
use crate::flight::columns;
use crate::library::{DataError, Library, data_file, data_folder};
use crate::problem::{design, fly};
use crate::progress::{Part, Progress};
use crate::units::Unit;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::ops::ControlFlow;

/// Verdict on a comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Verdict {
    /// Within the tolerance.
    Within,
    /// Beyond the tolerance.
    Beyond,
    /// The quantity did not occur, or the case was refused.
    Absent,
    /// Shown for information, not judged.
    Shown,
}

impl Verdict {
    /// Name as in files and tables.
    pub fn name(self) -> &'static str {
        match self {
            Verdict::Within => "within",
            Verdict::Beyond => "beyond",
            Verdict::Absent => "absent",
            Verdict::Shown => "shown",
        }
    }

    /// Whether the verdict counts against the program.
    pub fn is_miss(self) -> bool {
        matches!(self, Verdict::Beyond | Verdict::Absent)
    }
}

/// A compared quantity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Name of the validation file, such as `msape-ref-m1`.
    pub case: String,
    /// Key of the quantity, as in answer or trajectory.
    pub quantity: String,
    /// Label of the quantity, with the inputs that this row changes in the case.
    pub label: String,
    /// Symbol of the unit of the numbers below.
    pub unit: String,
    /// Value to compare with.
    pub reference: f64,
    /// Value computed now.
    pub ours: Option<f64>,
    /// Computed value minus the reference.
    pub difference: Option<f64>,
    /// Largest difference allowed, in the same unit.
    pub tolerance: Option<f64>,
    /// Tolerance as text, such as `0.1 %`.
    pub tolerance_text: String,
    /// Reason for the tolerance; for a row without a verdict, the reason for that.
    pub reason: String,
    /// Source of the reference value: key of the bibliography and place.
    pub source: String,
    /// Whether an assumption of the program was fitted to this value.
    pub calibrated: bool,
    /// Verdict.
    pub verdict: Verdict,
    /// Faults for which the case was refused, if it was.
    pub fault: Option<String>,
}

/// The validation files that ship with the program, by name.
///
/// # Errors
/// A file that cannot be read, which a test excludes.
pub fn files() -> Result<Vec<(String, File)>, DataError> {
    data_folder("validation")
        .filter_map(|(path, text)| Some((path, text, path.strip_prefix("validation/")?)))
        .filter_map(|(path, text, name)| Some((path, text, name.strip_suffix(".toml")?)))
        .map(|(path, text, name)| match File::parse(text) {
            Ok(file) => Ok((name.to_string(), file)),
            Err(message) => Err(DataError {
                file: path.to_string(),
                message,
            }),
        })
        .collect()
}

/// Rows of each file; the observer may stop it after a row, and the rows up to there are returned.
///
/// # Errors
/// A case file of the program that cannot be read, which a test excludes.
pub fn run(
    library: &Library,
    files: &[(String, File)],
    progress: &mut dyn Progress,
) -> Result<Vec<Vec<Row>>, DataError> {
    let mut rows = Vec::new();
    let part = |number: usize| number as f64 / files.len() as f64;
    for (number, (name, file)) in files.iter().enumerate() {
        let mut part = Part {
            whole: progress,
            from: part(number),
            to: part(number + 1),
        };
        let (of_file, told) = run_file(library, name, file, &mut part)?;
        rows.push(of_file);
        if told.is_break() {
            break;
        }
    }
    Ok(rows)
}

/// The rows of one file, and whether the observer has stopped the computation after one of them.
fn run_file(
    library: &Library,
    name: &str,
    file: &File,
    progress: &mut dyn Progress,
) -> Result<(Vec<Row>, ControlFlow<()>), DataError> {
    let runner = Runner::new(library, name, file)?;
    #[cfg(feature = "ablation")]
    if file.command == Command::Tps {
        return in_depth::rows(&runner, progress);
    }
    let count = file.count();
    let mut rows = Vec::with_capacity(count);
    let mut told = |done: usize| progress.advance(done as f64 / count.max(1) as f64);
    // Rows with the same changes are adjacent and share one solution.
    let mut solved: Option<(&Settings, Result<Answer, String>)> = None;
    for expected in &file.rows {
        let answer = match solved.take() {
            Some((set, answer)) if *set == expected.set => answer,
            _ => runner.solve(&expected.set),
        };
        rows.push(runner.row(expected, &answer));
        solved = Some((&expected.set, answer));
        if told(rows.len()).is_break() {
            return Ok((rows, ControlFlow::Break(())));
        }
    }
    for points in &file.points {
        rows.push(points::row(&runner, points)?);
        if told(rows.len()).is_break() {
            return Ok((rows, ControlFlow::Break(())));
        }
    }
    Ok((rows, ControlFlow::Continue(())))
}

/// Keys of the case that a row sets, as text.
type Settings = BTreeMap<String, String>;

/// Data for solving the case of a file in its variants.
struct Runner<'a> {
    library: &'a Library,
    name: &'a str,
    file: &'a File,
    case: Case,
}

impl<'a> Runner<'a> {
    fn new(library: &'a Library, name: &'a str, file: &'a File) -> Result<Self, DataError> {
        let path = format!("cases/{}", file.case);
        let error = |message: String| DataError {
            file: path.clone(),
            message,
        };
        let text = data_file(&path).ok_or_else(|| error("is not there".to_string()))?;
        let case = Case::from_text(text).map_err(|faults| error(joined(&faults)))?;
        Ok(Runner {
            library,
            name,
            file,
            case,
        })
    }

    /// The case with some keys set.
    fn case_with(&self, set: &Settings) -> Case {
        let mut case = self.case.clone();
        for (key, text) in set {
            case.set(key, text);
        }
        case
    }

    /// Solves the case with some keys set; an error states why the case was refused.
    fn solve(&self, set: &Settings) -> Result<Answer, String> {
        let case = self.case_with(set);
        let request = self.file.step_s.map_or(Request::Nothing, Request::Uniform);
        let answer = match self.file.command {
            Command::Fly => fly(&case, self.library, request),
            Command::Design => design(&case, self.library, request),
            Command::Tps => return Err("is no flight".to_string()),
        };
        answer.map_err(|faults| joined(&faults))
    }

    fn row(&self, expected: &Expectation, answer: &Result<Answer, String>) -> Row {
        let unit = Unit::find(&expected.unit);
        let ours = answer
            .as_ref()
            .ok()
            .and_then(|answer| value(answer, &expected.quantity, expected.time_s))
            .map(|x| unit.map_or(x, |unit| unit.from_canonical(x)));
        Comparison {
            expected,
            label: label_of_row(expected),
            ours,
            fault: answer.as_ref().err().cloned(),
        }
        .row(self)
    }
}

/// A computed value and its reference.
struct Comparison<'a> {
    expected: &'a Expectation,
    label: String,
    ours: Option<f64>,
    fault: Option<String>,
}

impl Comparison<'_> {
    fn row(self, runner: &Runner) -> Row {
        let Expectation {
            quantity,
            value,
            unit,
            tolerance,
            calibrated,
            note,
            source,
            place,
            ..
        } = self.expected;
        let file = runner.file;
        let tolerance = tolerance
            .as_ref()
            .and_then(|name| file.tolerances.get(name));
        let allowed = tolerance.map(|tolerance| tolerance.allowed(*value));
        let difference = self.ours.map(|ours| ours - value);
        let verdict = match (difference, allowed) {
            (_, None) => Verdict::Shown,
            (None, Some(_)) => Verdict::Absent,
            (Some(difference), Some(allowed)) if difference.abs() <= allowed => Verdict::Within,
            _ => Verdict::Beyond,
        };
        let reasons = [tolerance.map(|t| t.reason.as_str()), note.as_deref()];
        Row {
            case: runner.name.to_string(),
            quantity: quantity.clone(),
            label: self.label,
            unit: unit.clone(),
            reference: *value,
            ours: self.ours,
            difference,
            tolerance: allowed,
            tolerance_text: tolerance.map_or_else(String::new, |t| t.text(unit)),
            reason: reasons.into_iter().flatten().collect::<Vec<_>>().join(" "),
            source: format!(
                "{}, {}",
                source.as_ref().unwrap_or(&file.source),
                place.as_ref().unwrap_or(&file.place)
            ),
            calibrated: *calibrated,
            verdict,
            fault: self.fault,
        }
    }
}

/// A quantity of the answer, or of its trajectory at a time.
fn value(answer: &Answer, key: &str, time_s: Option<f64>) -> Option<f64> {
    let value = match time_s {
        None => (output::find(key)?.get)(answer)?,
        Some(time_s) => {
            let trajectory = answer.flight.as_ref()?.trajectory.as_ref()?;
            let row = trajectory
                .column("time_s")?
                .iter()
                .position(|t| (t - time_s).abs() < 1e-6)?;
            *trajectory.column(key)?.get(row)?
        }
    };
    value.is_finite().then_some(value)
}

fn label_of_row(expected: &Expectation) -> String {
    let mut label = label_of(&expected.quantity);
    if let Some(time_s) = expected.time_s {
        label.push_str(&format!(" at {time_s} s"));
    }
    for (key, text) in &expected.set {
        label.push_str(&format!(", {key} = {text}"));
    }
    label
}

fn label_of(key: &str) -> String {
    output::find(key)
        .map(|output| output.label)
        .or_else(|| columns::find(key).map(|column| column.label))
        .unwrap_or(key)
        .to_string()
}

fn joined(faults: &[crate::case::InputError]) -> String {
    let all: Vec<String> = faults.iter().map(ToString::to_string).collect();
    all.join("; ")
}

#[cfg(test)]
mod tests;
