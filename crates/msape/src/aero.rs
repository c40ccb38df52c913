//! Aerodynamic coefficients: drag against Mach number, and force and moment at any attitude.
//!
//! ```text
//! C_D(M) linear between rows, ends held
//! ```
//!
//! with M the Mach number relative to the air and C_D referred to the area of the largest diameter; both without unit.
//! At zero angle of attack drag and axial force are the same.
//!
//! - [`surface`], [`shadow`], [`integral`]: pressure and shear of [`newtonian`] or [`free_molecular`] flow over an outline.
//! - [`database`]: both limits on a [`curve`] over the angle of attack, [`bridging`] in Knudsen number, [`euler`] correction and tables
//!   in Mach number, [`damping`]; [`table`] is a table in its place; [`standard`] the recipe of this program.
//! - [`polar`]: coefficients, trim and stability of a body; [`stored`]: a database as rows.
//!
//! # Valid
//! [`DragTable`]: ballistic flight at zero angle of attack; free-molecular effects are not in the table.
//!
//! # References
//! - \[samareh-2014\] section 3.3 and equation 7; \[mitcheltree-1997\] Table 4.

pub mod bridging;
pub mod coefficient;
pub mod curve;
pub mod damping;
pub mod database;
pub mod euler;
pub mod free_molecular;
pub mod integral;
pub mod newtonian;
pub mod polar;
pub mod shadow;
pub mod stability;
pub mod standard;
pub mod stored;
pub mod surface;
pub mod table;
pub mod trim;

use crate::data::Data;
use crate::finding::range::short;
use crate::finding::{Finding, Severity};
use numerics::math::RADIANS_PER_DEGREE;
use numerics::scalar::Scalar;
use serde::Deserialize;
use serde::de::IgnoredAny;
use table::Extrapolation;

/// Mach number below which the case's terminal drag coefficient holds; the validity of equation 7.
pub const SUBSONIC_MACH_MAX: f64 = 0.5;

/// Drag of a vehicle.
#[derive(Clone, Debug, PartialEq)]
pub enum Drag {
    /// Constant at every Mach number.
    Constant(f64),
    /// Against Mach number.
    Table(DragTable),
}

/// Drag coefficient against Mach number, ascending.
#[derive(Clone, Debug, PartialEq)]
pub struct DragTable {
    mach: Vec<f64>,
    coefficient: Vec<f64>,
    /// Coefficient, slope and Mach number of the row below the first knot, between two and above the last.
    lines: Vec<[f64; 3]>,
    own: Option<Own>,
}

/// Origin of a drag table given by a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Own {
    /// Key of the case.
    pub key: &'static str,
    /// Rule beyond its ends.
    pub extrapolation: Extrapolation,
}

impl DragTable {
    /// The table with another coefficient below Mach 0.5.
    pub fn with_subsonic(&self, coefficient: f64) -> DragTable {
        let replaced = |(mach, c)| {
            (
                mach,
                if mach <= SUBSONIC_MACH_MAX {
                    coefficient
                } else {
                    c
                },
            )
        };
        let rows: Vec<(f64, f64)> = self.rows().map(replaced).collect();
        DragTable::from_ascending(&rows)
    }

    /// A table from rows of Mach number and drag coefficient.
    ///
    /// # Errors
    /// Every faulty row, with its number and value.
    pub fn try_new(rows: &[(f64, f64)]) -> Result<DragTable, Vec<String>> {
        let mut faults = Vec::new();
        if rows.is_empty() {
            faults.push("got no rows, must be one or more".to_string());
        }
        for (i, &(mach, coefficient)) in rows.iter().enumerate() {
            if !(0.0..=1e3).contains(&mach) {
                faults.push(format!(
                    "row {}: Mach number {mach}, must be 0 to 1000",
                    i + 1
                ));
            }
            if !(0.0..=100.0).contains(&coefficient) {
                faults.push(format!(
                    "row {}: drag coefficient {coefficient}, must be 0 to 100",
                    i + 1
                ));
            }
            if i > 0 && mach <= rows[i - 1].0 {
                faults.push(format!(
                    "row {}: Mach number {mach} is not above {} of the row before",
                    i + 1,
                    rows[i - 1].0
                ));
            }
        }
        if faults.is_empty() {
            Ok(DragTable::from_ascending(rows))
        } else {
            Err(faults)
        }
    }

    /// A table from rows that ascend in Mach number.
    pub(crate) fn from_ascending(rows: &[(f64, f64)]) -> DragTable {
        let (mach, coefficient) = rows.iter().copied().unzip();
        let level = |row: Option<&(f64, f64)>| row.map(|(_, c)| [*c, 0.0, 0.0]);
        let between = rows.windows(2).filter_map(|pair| {
            let [(m0, c0), (m1, c1)] = *pair else {
                return None;
            };
            Some([c0, (c1 - c0) / (m1 - m0), m0])
        });
        let lines = level(rows.first())
            .into_iter()
            .chain(between)
            .chain(level(rows.last()));
        DragTable {
            mach,
            coefficient,
            lines: lines.collect(),
            own: None,
        }
    }

    /// The table marked as given by a case, with its rule beyond the ends.
    pub fn of_case(mut self, own: Own) -> DragTable {
        let last = self.lines.len().saturating_sub(1);
        if own.extrapolation == Extrapolation::Extend && last >= 2 {
            self.lines.copy_within(1..2, 0);
            self.lines.copy_within(last - 1..last, last);
        }
        self.own = Some(own);
        self
    }

    /// Origin of the table, where a case gives it.
    pub fn own(&self) -> Option<Own> {
        self.own
    }

    /// Whether its first two and its last two rows are alike.
    pub fn level(&self) -> [bool; 2] {
        let alike = |pair: Option<&[f64]>| matches!(pair, Some([a, b]) if a == b);
        [
            self.coefficient.first_chunk::<2>(),
            self.coefficient.last_chunk::<2>(),
        ]
        .map(|pair| alike(pair.map(<[f64; 2]>::as_slice)))
    }

    /// First and last Mach number.
    pub fn ends(&self) -> [f64; 2] {
        let [first, last] = [self.mach.first(), self.mach.last()];
        [first, last].map(|mach| mach.copied().unwrap_or_default())
    }

    /// Drag coefficient at a Mach number.
    #[inline]
    pub fn at<S: Scalar>(&self, mach: S) -> S {
        Self::by_line(mach.lookup(|mach| self.line(mach)), mach)
    }

    /// Drag coefficient at a Mach number by a line of a table, wherever it ends.
    #[inline]
    pub fn by_line<S: Scalar>([base, slope, start]: [S; 3], mach: S) -> S {
        base + (mach - start) * slope
    }

    /// Line between two rows at a Mach number: coefficient, slope and Mach number of its first row.
    #[inline]
    pub fn line(&self, mach: f64) -> [f64; 3] {
        let below = self.mach.partition_point(|&m| m <= mach);
        self.lines.get(below).copied().unwrap_or_default()
    }

    /// Mach numbers of the rows, ascending.
    pub fn machs(&self) -> &[f64] {
        &self.mach
    }

    /// Rows of Mach number and drag coefficient.
    pub fn rows(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        self.mach
            .iter()
            .copied()
            .zip(self.coefficient.iter().copied())
    }
}

/// A table serves cones within this of its own, deg: by 2 sin² θ the axial force of a 60 deg cone moves by 1 %.
const CONE_WITHIN_DEG: f64 = 0.5;

/// A named database of axial force, from `data/aerodynamics`.
#[derive(Clone, Debug, PartialEq)]
pub struct AxialForce {
    /// Vehicle that it describes.
    pub title: String,
    /// Half-angle of the cone to which it belongs, deg.
    pub cone_half_angle_deg: f64,
    /// Axial force coefficient against Mach number.
    pub table: DragTable,
}

/// A file, of whose headings two count.
#[derive(Deserialize)]
struct File {
    title: String,
    #[serde(rename = "source")]
    _source: Option<IgnoredAny>,
    #[serde(rename = "place")]
    _place: Option<IgnoredAny>,
    #[serde(rename = "note")]
    _note: Option<IgnoredAny>,
    cone_half_angle_deg: f64,
    rows: Vec<Row>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Row {
    mach: f64,
    axial_force_coefficient: f64,
    #[serde(rename = "provenance")]
    _provenance: String,
}

impl AxialForce {
    /// A finding where the cone of a vehicle is another than that of the table; a vehicle may have none.
    pub fn other_cone(
        &self,
        name: &str,
        half_angle_rad: Option<f64>,
        field: &str,
    ) -> Option<Finding> {
        let own = self.cone_half_angle_deg;
        let valid = (Some(own - CONE_WITHIN_DEG), Some(own + CONE_WITHIN_DEG));
        let half_angle_deg = half_angle_rad.map(|angle| angle / RADIANS_PER_DEGREE);
        let vehicle = match half_angle_deg {
            Some(deg) if (deg - own).abs() <= CONE_WITHIN_DEG => return None,
            Some(deg) => format!("has one of {} deg", short(deg)),
            None => "has none".to_string(),
        };
        Some(Finding {
            severity: Severity::Extrapolated,
            model: format!("axial force {name}"),
            key: "forebody_cone_angle_deg".into(),
            value: half_angle_deg,
            valid,
            message: format!(
                "The table is of a cone of {} deg, this vehicle {vehicle}: by impact theory the axial force goes with the \
                 squared sine of the angle.",
                short(own)
            ),
            source: self.title.clone(),
            field: Some(field.into()),
        })
    }

    /// Reads a CSV file of `data/aerodynamics`.
    ///
    /// # Errors
    /// The fault of the file.
    pub fn parse(data: Data) -> Result<AxialForce, String> {
        let file: File = match data {
            #[cfg(feature = "own-data")]
            Data::Own(text) => File::of_csv(text)?,
            shipped => shipped.read()?,
        };
        let rows: Vec<_> = file
            .rows
            .iter()
            .map(|row| (row.mach, row.axial_force_coefficient))
            .collect();
        Ok(AxialForce {
            title: file.title,
            cone_half_angle_deg: file.cone_half_angle_deg,
            table: DragTable::try_new(&rows).map_err(|faults| faults.join("; "))?,
        })
    }
}

#[cfg(feature = "own-data")]
impl File {
    fn of_csv(text: &str) -> Result<File, String> {
        let header = |name: &str| {
            text.lines()
                .filter_map(|line| line.strip_prefix('#'))
                .find_map(|line| line.trim().strip_prefix(name)?.strip_prefix(':'))
                .map(|value| value.trim().to_string())
                .ok_or_else(|| format!("no header line \"# {name}:\""))
        };
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let rows: Result<_, _> = reader.deserialize().collect();
        Ok(File {
            title: header("title")?,
            _source: None,
            _place: None,
            _note: None,
            cone_half_angle_deg: header("cone_half_angle_deg")?
                .parse()
                .map_err(|e| format!("cone_half_angle_deg: {e}"))?,
            rows: rows.map_err(|e| e.to_string())?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn linear_between_rows_and_held_outside() {
        let table = DragTable::try_new(&[(0.5, 1.0), (1.5, 2.0)]).unwrap();
        assert_eq!(
            [table.at(0.0), table.at(1.0), table.at(1.5), table.at(9.0)],
            [1.0, 1.5, 2.0, 2.0]
        );
    }

    #[test]
    fn a_table_of_a_case_may_go_on_with_its_last_slopes() {
        let own = Own {
            key: "vehicle.drag_table",
            extrapolation: Extrapolation::Extend,
        };
        // slopes 1 and 2
        let table = DragTable::try_new(&[(0.5, 1.0), (1.5, 2.0), (2.5, 4.0)])
            .unwrap()
            .of_case(own);
        assert_eq!(
            [table.at(0.0), table.at(2.0), table.at(3.0)],
            [0.5, 3.0, 5.0]
        );
        assert_eq!(table.ends(), [0.5, 2.5]);
    }

    #[test]
    fn every_fault_is_reported() {
        let faults = DragTable::try_new(&[(1.0, 1.0), (0.5, -1.0), (2.0, f64::NAN)]).unwrap_err();
        assert_eq!(faults.len(), 3, "{faults:?}");
    }

    #[test]
    fn the_built_in_database_reads() {
        let database =
            AxialForce::parse(include_str!("../data/aerodynamics/mmeev-60.csv").into()).unwrap();
        assert_eq!(database.cone_half_angle_deg, 60.0);
        assert_eq!(database.table.at(24.7), 1.4816);
        let table = database.table.with_subsonic(0.73);
        assert_eq!((table.at(0.3), table.at(0.6)), (0.73, 0.965));
    }

    #[test]
    fn a_60_deg_table_on_another_cone_or_none_is_said() {
        let table =
            AxialForce::parse(include_str!("../data/aerodynamics/mmeev-60.csv").into()).unwrap();
        let at = |deg: f64| table.other_cone("mmeev-60", Some(deg * RADIANS_PER_DEGREE), "x");
        assert_eq!((at(60.0), at(59.6)), (None, None));
        let said = at(50.0).unwrap();
        assert!(said.message.contains("50 deg"), "{}", said.message);
        assert_eq!(said.valid, (Some(59.5), Some(60.5)));
        let none = table.other_cone("mmeev-60", None, "x").unwrap();
        assert!(none.message.contains("has none") && none.value.is_none());
    }
}
