//! Checks the rows of a table and puts them in order.
//!
//! ```text
//! every Mach number × every Knudsen number × every angle has one row;   C_A(−α) = C_A(α)   C_N(−α) = −C_N(α)
//! ```
//!
//! # Valid
//! Rows in the order Mach, Knudsen, angle, each ascending.
//!
//! # References
//! - Own convention.

use super::push::pushes;
use super::row::{Row, body_axes};
use super::{Content, Extrapolation, Given, Grid};
use numerics::math::{PI, RADIANS_PER_DEGREE, log10};

/// Faults are listed up to this number, assumed.
const MOST_FAULTS: usize = 100;
/// Largest difference between the two sides, in coefficients: tables are printed to three or four decimals.
const ALIKE: f64 = 2e-3;
/// Angles that are one, deg.
const SAME_DEG: f64 = 1e-9;

impl Grid {
    /// A table from its rows.
    ///
    /// # Errors
    /// Everything that is wrong with them, each fault with its line.
    pub fn try_new(rows: &[Row], extrapolation: Extrapolation) -> Result<Grid, Vec<String>> {
        let mut faults = Vec::new();
        ranges(rows, &mut faults);
        if rows.is_empty() {
            faults.push("the table holds no row".to_string());
        }
        if faults.is_empty() {
            pushes(rows, &mut faults);
            order(rows, &mut faults);
        }
        let rows = if faults.is_empty() {
            one_side(rows, &mut faults)
        } else {
            Vec::new()
        };
        let axes = Axes::new(&rows);
        if faults.is_empty() {
            axes.holes(&rows, &mut faults);
        }
        if !faults.is_empty() {
            faults.truncate(MOST_FAULTS);
            return Err(faults);
        }
        Ok(axes.grid(&rows, extrapolation))
    }
}

fn ranges(rows: &[Row], faults: &mut Vec<String>) {
    for row in rows {
        if faults.len() >= MOST_FAULTS {
            return;
        }
        let mut within = |name: &str, value: f64, low: f64, high: f64| {
            if !(low..=high).contains(&value) {
                faults.push(format!(
                    "line {}: {name} {value}, must be {low} to {high}",
                    row.line
                ));
            }
        };
        within("Mach number", row.mach, 0.0, 1000.0);
        within("angle of attack", row.alpha_deg, -180.0, 180.0);
        if let Some(knudsen) = row.knudsen {
            within("Knudsen number", knudsen, 1e-12, 1e12);
        }
        if let Some(altitude_m) = row.altitude_m {
            within("altitude", altitude_m, -5e3, 1e6);
        }
        let all = [
            ("CA", row.ca),
            ("CN", row.cn),
            ("CD", row.cd),
            ("CL", row.cl),
            ("Cm", row.cm),
            ("Cmq", row.cmq),
        ];
        for (name, value) in all {
            if let Some(value) = value {
                within(name, value, -100.0, 100.0);
            }
        }
    }
}

fn order(rows: &[Row], faults: &mut Vec<String>) {
    for pair in rows.windows(2) {
        let [before, row] = pair else { continue };
        if faults.len() >= MOST_FAULTS {
            return;
        }
        let line = row.line;
        let knudsen = |row: &Row| row.knudsen.or(row.altitude_m).unwrap_or(0.0);
        if row.mach < before.mach {
            faults.push(format!(
                "line {line}: Mach number {} after {}; rows must ascend in Mach number",
                row.mach, before.mach
            ));
        } else if row.mach == before.mach && knudsen(row) < knudsen(before) {
            faults.push(format!(
                "line {line}: Knudsen number or altitude {} after {}; rows of one Mach number must ascend in it",
                knudsen(row),
                knudsen(before)
            ));
        } else if row.mach == before.mach
            && knudsen(row) == knudsen(before)
            && row.alpha_deg <= before.alpha_deg
        {
            let what = if row.alpha_deg == before.alpha_deg {
                "twice"
            } else {
                "after a larger one"
            };
            faults.push(format!(
                "line {line}: angle of attack {} deg {what}; rows of one Mach number must ascend in angle of attack",
                row.alpha_deg
            ));
        }
    }
}

/// Rows of α ≥ 0, after the other side was compared with them; the rows are in order.
fn one_side(rows: &[Row], faults: &mut Vec<String>) -> Vec<Row> {
    let same = |a: &Row, b: &Row| a.mach == b.mach && a.height() == b.height();
    for line in rows.chunk_by(same) {
        // angles ascend within a line, so that the partner of one is found by halving
        let at = |alpha_deg: f64| {
            let before = line.partition_point(|row| row.alpha_deg < alpha_deg - SAME_DEG);
            line.get(before)
                .filter(|row| (row.alpha_deg - alpha_deg).abs() < SAME_DEG)
        };
        let two_sided = line.first().is_some_and(|row| row.alpha_deg < 0.0);
        for row in line.iter().filter(|row| two_sided && row.alpha_deg != 0.0) {
            match at(-row.alpha_deg) {
                None => faults.push(format!(
                    "line {}: angle of attack {} deg has no partner at {} deg: the table is one-sided at Mach {}; give the angles from 0 upwards, or both sides alike",
                    row.line, row.alpha_deg, -row.alpha_deg, row.mach
                )),
                Some(other) if row.alpha_deg < 0.0 => alike(row, other, faults),
                Some(_) => {}
            }
        }
        if let Some(first) = line
            .first()
            .filter(|_| line.iter().all(|row| row.alpha_deg != 0.0))
        {
            faults.push(format!(
                "line {}: no row at angle of attack 0 deg for Mach {}",
                first.line, first.mach
            ));
        }
        if faults.len() >= MOST_FAULTS {
            break;
        }
    }
    rows.iter()
        .filter(|row| row.alpha_deg >= 0.0)
        .copied()
        .collect()
}

fn alike(row: &Row, other: &Row, faults: &mut Vec<String>) {
    let pairs = [
        ("CA", row.ca, other.ca, 1.0),
        ("CD", row.cd, other.cd, 1.0),
        ("CN", row.cn, other.cn, -1.0),
        ("CL", row.cl, other.cl, -1.0),
        ("Cm", row.cm, other.cm, -1.0),
        ("Cmq", row.cmq, other.cmq, 1.0),
    ];
    for (name, a, b, sign) in pairs {
        if let (Some(a), Some(b)) = (a, b)
            && (a - sign * b).abs() > ALIKE
        {
            faults.push(format!(
                "line {}: {name} {a} at {} deg, but {b} at {} deg: a body of revolution is symmetric",
                row.line, row.alpha_deg, other.alpha_deg
            ));
        }
    }
}

struct Axes {
    mach: Vec<f64>,
    knudsen: Vec<f64>,
    alpha_deg: Vec<f64>,
}

fn axis(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut axis: Vec<f64> = values.collect();
    axis.sort_unstable_by(f64::total_cmp);
    axis.dedup();
    axis
}

impl Axes {
    fn new(rows: &[Row]) -> Axes {
        Axes {
            mach: axis(rows.iter().map(|row| row.mach)),
            knudsen: axis(rows.iter().map(|row| row.height().unwrap_or(1.0))),
            alpha_deg: axis(rows.iter().map(|row| row.alpha_deg)),
        }
    }

    /// Faults where a combination has no row; rows are in order and none comes twice.
    fn holes(&self, rows: &[Row], faults: &mut Vec<String>) {
        let mut rest = rows.iter().peekable();
        for mach in &self.mach {
            for knudsen in &self.knudsen {
                if faults.len() >= MOST_FAULTS {
                    return;
                }
                for alpha in &self.alpha_deg {
                    let here = |row: &Row| {
                        row.mach == *mach
                            && row.height().unwrap_or(1.0) == *knudsen
                            && row.alpha_deg == *alpha
                    };
                    if rest.peek().is_some_and(|row| here(row)) {
                        rest.next();
                    } else if faults.len() < MOST_FAULTS {
                        let at = if self.knudsen.len() > 1 {
                            format!(", Knudsen number {knudsen}")
                        } else {
                            String::new()
                        };
                        let before = rest.peek().map_or("at the end".to_string(), |row| {
                            format!("before line {}", row.line)
                        });
                        faults.push(format!(
                            "no row for Mach {mach}{at}, angle of attack {alpha} deg ({before}): the table has a hole"
                        ));
                    }
                }
            }
        }
    }

    fn grid(self, rows: &[Row], extrapolation: Extrapolation) -> Grid {
        let alpha_rad: Vec<f64> = self
            .alpha_deg
            .iter()
            .map(|a| a * RADIANS_PER_DEGREE)
            .collect();
        let given = |found: bool| if found { Given::Yes } else { Given::No };
        let any = |get: fn(&Row) -> Option<f64>| rows.iter().any(|row| get(row).is_some());
        let content = if any(|row| row.ca.or(row.cd)) {
            Content::Static {
                moment: given(any(|row| row.cm)),
                damping: given(any(|row| row.cmq)),
            }
        } else {
            Content::DampingOnly
        };
        let values: Vec<[f64; 4]> = rows.iter().map(body_axes).collect();
        let values = values
            .chunks(alpha_rad.len().max(1))
            .flat_map(|line| {
                let slopes = slopes(&alpha_rad, line);
                line.iter()
                    .copied()
                    .zip(slopes)
                    .map(|(f, g)| [f, g])
                    .collect::<Vec<_>>()
            })
            .collect();
        Grid {
            content,
            extrapolation,
            mach: self.mach,
            log_knudsen: self.knudsen.iter().map(|k| log10(*k)).collect(),
            alpha_rad,
            values,
        }
    }
}

/// Slopes that keep what is monotone monotone; at 0 and 180 deg those of an even C_A and C_mq and an odd C_N and C_m.
fn slopes(alpha_rad: &[f64], line: &[[f64; 4]]) -> Vec<[f64; 4]> {
    let count = line.len();
    let mut slopes = vec![[0.0; 4]; count];
    if count < 2 {
        return slopes;
    }
    let secant = |n: usize, k: usize| -> f64 {
        match (line.get(n..n + 2), alpha_rad.get(n..n + 2)) {
            (Some([a, b]), Some([x, y])) => (b[k] - a[k]) / (y - x),
            _ => 0.0,
        }
    };
    for (n, slope) in slopes.iter_mut().enumerate() {
        for (k, slope) in slope.iter_mut().enumerate() {
            let even = k == 0 || k == 3;
            *slope = if n == 0 {
                if even { 0.0 } else { secant(0, k) }
            } else if n == count - 1 {
                let turned = alpha_rad
                    .last()
                    .is_some_and(|last| (last - PI).abs() < 1e-9);
                if even && turned {
                    0.0
                } else {
                    secant(n - 1, k)
                }
            } else {
                let (a, b) = (secant(n - 1, k), secant(n, k));
                if a * b <= 0.0 {
                    0.0
                } else {
                    2.0 * a * b / (a + b)
                }
            };
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(line: u64, mach: f64, alpha_deg: f64, ca: f64, cn: f64) -> Row {
        Row {
            line,
            mach,
            alpha_deg,
            ca: Some(ca),
            cn: Some(cn),
            ..Row::default()
        }
    }

    fn good() -> Vec<Row> {
        vec![
            row(2, 1.0, 0.0, 1.0, 0.0),
            row(3, 1.0, 10.0, 0.9, 0.1),
            row(4, 1.0, 20.0, 0.7, 0.2),
            row(5, 2.0, 0.0, 2.0, 0.0),
            row(6, 2.0, 10.0, 1.8, 0.2),
            row(7, 2.0, 20.0, 1.4, 0.4),
        ]
    }

    #[test]
    fn rows_are_met_and_the_middle_is_between() {
        let grid = Grid::try_new(&good(), Extrapolation::Hold).unwrap();
        let a = 10.0 * RADIANS_PER_DEGREE;
        assert!((grid.loads(1.5, 0.0, a).ca - 1.35).abs() < 1e-15);
        assert!((grid.loads(9.0, 0.0, a).ca - 1.8).abs() < 1e-15);
        assert!((grid.loads(2.0, 0.0, PI).cn - 0.4).abs() < 1e-15);
        let mut extended = grid.clone();
        extended.extrapolation = Extrapolation::Extend;
        assert!((extended.loads(3.0, 0.0, a).ca - 2.7).abs() < 1e-14);
        // the last secant of C_N: 0.2 in 10 deg
        assert!((extended.loads(2.0, 0.0, 3.0 * a).cn - 0.6).abs() < 1e-14);
        assert_eq!(grid.beyond(3.0, 0.0, 3.0 * a).len(), 2);
        assert!(grid.beyond(2.0, 0.0, 2.0 * a).is_empty());
    }

    #[test]
    fn every_fault_has_its_line() {
        let mut hole = good();
        hole.remove(4);
        let faults = Grid::try_new(&hole, Extrapolation::Hold).unwrap_err();
        assert_eq!(
            faults,
            ["no row for Mach 2, angle of attack 10 deg (before line 7): the table has a hole"]
        );
        let mut unsorted = good();
        unsorted.swap(0, 3);
        let faults = Grid::try_new(&unsorted, Extrapolation::Hold).unwrap_err();
        assert!(
            faults[0].starts_with("line 3: Mach number 1 after 2"),
            "{faults:?}"
        );
        let mut one_sided = good();
        one_sided.insert(0, row(1, 1.0, -10.0, 0.9, -0.1));
        let faults = Grid::try_new(&one_sided, Extrapolation::Hold).unwrap_err();
        assert!(faults[0].contains("line 4: angle of attack 20 deg has no partner at -20 deg"));
        let crooked = [
            row(1, 1.0, -10.0, 0.9, 0.1),
            row(2, 1.0, 0.0, 1.0, 0.0),
            row(3, 1.0, 10.0, 0.9, 0.1),
        ];
        let faults = Grid::try_new(&crooked, Extrapolation::Hold).unwrap_err();
        assert_eq!(faults.len(), 1);
        assert!(faults[0].starts_with("line 1: CN 0.1 at -10 deg, but 0.1 at 10 deg"));
        let late = [row(1, 1.0, 5.0, 1.0, 0.0), row(2, f64::NAN, 10.0, 1.0, 0.0)];
        assert_eq!(
            Grid::try_new(&late, Extrapolation::Hold).unwrap_err().len(),
            1
        );
        assert_eq!(
            Grid::try_new(&late[..1], Extrapolation::Hold)
                .unwrap_err()
                .len(),
            1
        );
    }

    #[test]
    fn lift_and_drag_become_axial_and_normal_force() {
        let of = |alpha_deg: f64, cd: f64, cl: f64| Row {
            line: 1,
            mach: 1.0,
            alpha_deg,
            cd: Some(cd),
            cl: Some(cl),
            ..Row::default()
        };
        let rows = [of(0.0, 1.0, 0.0), of(90.0, 0.5, -0.2)];
        let grid = Grid::try_new(&rows, Extrapolation::Hold).unwrap();
        let across = grid.loads(1.0, 0.0, 0.5 * PI);
        assert!((across.ca - 0.2).abs() < 1e-15 && (across.cn - 0.5).abs() < 1e-15);
    }
}
