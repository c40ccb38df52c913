//! A row of a table of coefficients.
//!
//! ```text
//! C_A = C_D cos α − C_L sin α        C_N = C_D sin α + C_L cos α
//! ```
//!
//! with α the angle of attack in rad.
//!
//! # Valid
//! Any angle.
//!
//! # References
//! - Rotation from the axes of the wind to those of the body.

use numerics::math::{RADIANS_PER_DEGREE, cos, sin};

/// One row as it was read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Row {
    /// Line of the file, from 1, or number of the row.
    pub line: u64,
    /// Mach number.
    pub mach: f64,
    /// Angle of attack, deg.
    pub alpha_deg: f64,
    /// Knudsen number.
    pub knudsen: Option<f64>,
    /// Altitude, m, in the place of the Knudsen number.
    pub altitude_m: Option<f64>,
    /// Axial force coefficient.
    pub ca: Option<f64>,
    /// Normal force coefficient.
    pub cn: Option<f64>,
    /// Drag coefficient.
    pub cd: Option<f64>,
    /// Lift coefficient.
    pub cl: Option<f64>,
    /// Pitching moment coefficient about the virtual apex.
    pub cm: Option<f64>,
    /// Pitch damping per unit of q D/(2V).
    pub cmq: Option<f64>,
}

impl Row {
    /// The row of a case: mach, alpha_deg, ca, cn, cm, cmq, knudsen, altitude_m, the last ones optional.
    pub fn of_cells(cells: &[f64], line: u64) -> Row {
        let cell = |n: usize| cells.get(n).copied();
        Row {
            line,
            mach: cell(0).unwrap_or_default(),
            alpha_deg: cell(1).unwrap_or_default(),
            ca: cell(2),
            cn: cell(3),
            cm: cell(4),
            cmq: cell(5),
            knudsen: if cell(7).is_some() { None } else { cell(6) },
            altitude_m: cell(7),
            ..Row::default()
        }
    }

    /// The row of a damping table: mach, alpha_deg, cmq, knudsen, the last one optional.
    pub fn of_damping(cells: &[f64], line: u64) -> Row {
        let cell = |n: usize| cells.get(n).copied();
        Row {
            line,
            mach: cell(0).unwrap_or_default(),
            alpha_deg: cell(1).unwrap_or_default(),
            cmq: cell(2),
            knudsen: cell(3),
            ..Row::default()
        }
    }

    /// The cells of [`Row::of_cells`], as far as there are any.
    pub fn cells(&self) -> Vec<f64> {
        let [ca, cn, ..] = body_axes(self);
        let mut cells = vec![self.mach, self.alpha_deg, ca, cn];
        let rest = [self.cm, self.cmq, self.knudsen, self.altitude_m];
        let count = rest.iter().rposition(Option::is_some).map_or(0, |n| n + 1);
        cells.extend(rest.iter().take(count).map(|value| value.unwrap_or(0.0)));
        cells
    }

    /// Quantity that orders rows besides Mach number and angle: Knudsen number, or altitude above the lowest.
    pub(super) fn height(&self) -> Option<f64> {
        self.knudsen
            .or(self.altitude_m.map(|altitude_m| altitude_m + 1e4))
    }
}

/// Coefficients C_A, C_N, C_m, C_mq of a row.
pub(super) fn body_axes(row: &Row) -> [f64; 4] {
    let alpha = row.alpha_deg * RADIANS_PER_DEGREE;
    let (ca, cn) = match (row.cd, row.ca) {
        (Some(cd), None) => {
            let (s, c, cl) = (sin(alpha), cos(alpha), row.cl.unwrap_or_default());
            (cd * c - cl * s, cd * s + cl * c)
        }
        (_, ca) => (ca.unwrap_or_default(), row.cn.unwrap_or_default()),
    };
    [
        ca,
        cn,
        row.cm.unwrap_or_default(),
        row.cmq.unwrap_or_default(),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lift_and_drag_at_90_deg_are_axial_force_and_normal_force_turned() {
        let row = Row {
            alpha_deg: 90.0,
            cd: Some(0.5),
            cl: Some(-0.2),
            altitude_m: Some(8e4),
            ..Row::default()
        };
        let [ca, cn, ..] = body_axes(&row);
        assert!((ca - 0.2).abs() < 1e-15 && (cn - 0.5).abs() < 1e-15);
        let again = Row::of_cells(&row.cells(), 1);
        assert!(again.altitude_m == Some(8e4) && again.knudsen.is_none());
        assert!((again.cn.unwrap() - 0.5).abs() < 1e-15);
    }
}
