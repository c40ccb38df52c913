//! Rows of a table with negative drag, by which the air would push a body, and angles in radians.
//!
//! ```text
//! C_A cos α + C_N sin α ≥ 0
//! ```
//!
//! with α in rad: the air takes energy from a body that it flows round, and gives it none.
//!
//! # Valid
//! Bodies without engines.
//!
//! # References
//! - First law of thermodynamics; own convention for angles.

use super::row::{Row, body_axes};
use crate::finding::range::short;
use numerics::math::{PI, RADIANS_PER_DEGREE, sin_cos};

/// Drag coefficient that a row may be below zero, assumed to cover rounding: of C_A and C_N to three decimals, 0.0005 (|cos α| + |sin α|) or
/// 7.1e-4 at most, and of the angle to 0.1 deg at coefficients of about 1, 8.7e-4 (|cos α| + |sin α|) or 1.2e-3 at most; 1.9e-3 together.
const PUSH: f64 = 2e-3;
/// Fractions of π: a table whose angles end at one of them is taken to be in radians.
const OF_PI: [f64; 6] = [1.0, 2.0 / 3.0, 0.5, 1.0 / 3.0, 0.25, 1.0 / 6.0];
/// Tolerance of these parts: a part of π printed with two decimals, 3.14, 1.57 or 1.05, is off by half of the last at
/// most, and cut after three, 3.141, by less.
const OF_PI_WITHIN: f64 = 0.005;

/// Rows by which the air would push the body: C_A cos α + C_N sin α < 0.
pub(super) fn pushes(rows: &[Row], faults: &mut Vec<String>) {
    let largest_deg = rows.iter().map(|row| row.alpha_deg).fold(0.0, f64::max);
    let hint = if in_radians(largest_deg) {
        format!("; the largest angle is {largest_deg}: are the angles in rad?")
    } else {
        String::new()
    };
    for row in rows.iter().filter(|row| row.ca.or(row.cd).is_some()) {
        let [ca, cn, ..] = body_axes(row);
        let (sin, cos) = sin_cos(row.alpha_deg * RADIANS_PER_DEGREE);
        let drag = ca * cos + cn * sin;
        if drag < -PUSH {
            faults.push(format!(
                "line {}: CA {} and CN {} at {} deg make a drag coefficient of {}, must be 0 or more: the air would push the body{hint}",
                row.line,
                short(ca),
                short(cn),
                row.alpha_deg,
                short(drag)
            ));
        }
    }
}

/// Whether the largest angle of a table, read as deg, is one of these fractions of π.
pub fn in_radians(largest_deg: f64) -> bool {
    let is = |part: &f64| (largest_deg - part * PI).abs() <= OF_PI_WITHIN;
    OF_PI.iter().any(is)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(alpha_deg: f64, ca: f64, cn: f64) -> Row {
        Row {
            line: 3,
            alpha_deg,
            ca: Some(ca),
            cn: Some(cn),
            ..Row::default()
        }
    }

    #[test]
    fn axial_force_of_a_body_flying_backwards_points_forward_in_its_axes() {
        let of = |row: Row| {
            let mut faults = Vec::new();
            pushes(&[row], &mut faults);
            faults
        };
        assert!(of(row(180.0, -0.8, 0.0)).is_empty());
        assert!(of(row(100.0, -0.1, 0.5)).is_empty());
        assert!(of(row(30.0, -0.001, 0.0)).is_empty());
        assert_eq!(
            of(row(180.0, 0.8, 0.0)),
            [
                "line 3: CA 0.8 and CN 0 at 180 deg make a drag coefficient of -0.8, must be 0 or more: the air would push the body"
            ]
        );
        let printed = |text: &str| text.parse::<f64>().unwrap();
        let said = of(row(printed("3.14159"), -1.2, 0.0)).concat();
        assert!(
            said.contains("the largest angle is 3.14159: are the angles in rad?"),
            "{said}"
        );
    }

    #[test]
    fn half_a_turn_and_its_parts_are_radians_and_round_degrees_are_not() {
        assert!(
            [
                "3.1416", "1.5708", "0.5236", "0.785398", "3.14", "3.141", "3.142", "1.57",
                "1.571", "2.09", "1.05", "0.79", "0.52"
            ]
            .iter()
            .all(|text| in_radians(text.parse().unwrap()))
        );
        assert!(
            ![
                3.0, 3.1, 3.2, 1.5, 1.6, 2.0, 2.1, 0.5, 0.8, 1.0, 30.0, 180.0
            ]
            .iter()
            .any(|a| in_radians(*a))
        );
    }
}
