//! Axial force of an outline nose first against Mach number: computed at high speed, by published tables below.
//!
//! ```text
//! C_A0 = k(M) K A₀ + b                                            M ≥ 3
//! K = c₀ + a t + b t² + c R_n/R_b + d R_s/R_b + e/M² + f t R_n/R_b     t = (θ − 60 deg)/10 deg
//! C_A0 = T(M) {1 + [C_A0(3)/T(3) − 1] s}      s = M − 0.5 within 0…1      M < 3
//! ```
//!
//! with k = C_p,max, A₀ the Newtonian axial force for C_p,max = 1, b = 1/M² the base pressure, T the published table of the cone
//! angle, interpolated linearly in sin² θ between 45, 60 and 70 deg. An outline without a cone is given the angle whose sharp cone has the same A₀, and K = 1.
//!
//! # Valid
//! Air, or a gas of another ratio of heat capacities in k alone. Mach 3 to 27, 41 to 70 deg, R_n/R_b 0.5 to 2.7, R_s/R_b 0.04 to 0.2; kept within these ranges. Below Mach 3: 45 to 70 deg.
//!
//! # References
//! - \[aether\] (Euler solutions to which K was fitted); \[asim\] and \[samareh-2014\] (tables); b is \[assumed\].

use super::DragTable;
use super::database::BASE_MACH_MIN;
use super::newtonian::pressure_coefficient_max;
use crate::data::Data;
use numerics::math::{RADIANS_PER_DEGREE, sin};
use serde::{Deserialize, Serialize};

/// Dimensions of a sphere-cone that the correction depends on.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SphereCone {
    /// Cone half-angle, rad.
    pub cone_half_angle_rad: f64,
    /// Nose radius over that of the vehicle.
    pub nose_radius_ratio: f64,
    /// Shoulder radius over that of the vehicle.
    pub shoulder_radius_ratio: f64,
}

/// Coefficients of K, from `data/aero-models/euler-correction.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct EulerCorrection {
    #[serde(rename = "source")]
    _source: String,
    #[serde(rename = "place")]
    _place: String,
    /// Note on the correction.
    pub note: String,
    constant_factor: f64,
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    e: f64,
    f: f64,
    valid: Valid,
}

#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Valid {
    mach: Range,
    cone_half_angle_deg: Range,
    nose_radius_ratio: Range,
    shoulder_radius_ratio: Range,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Range {
    min: f64,
    max: f64,
}

impl Range {
    fn keep(&self, x: f64) -> f64 {
        x.clamp(self.min, self.max)
    }
}

impl EulerCorrection {
    /// Reads the data file.
    ///
    /// # Errors
    /// The fault of the file.
    pub fn parse(data: Data) -> Result<EulerCorrection, String> {
        data.read()
    }

    /// Factor on the modified Newtonian axial force of a forebody.
    pub fn factor(&self, body: &SphereCone, mach: f64) -> f64 {
        let EulerCorrection {
            constant_factor: c0,
            a,
            b,
            c,
            d,
            e,
            f,
            ref valid,
            ..
        } = *self;
        let degrees = body.cone_half_angle_rad / RADIANS_PER_DEGREE;
        let t = (valid.cone_half_angle_deg.keep(degrees) - 60.0) / 10.0;
        let rn = valid.nose_radius_ratio.keep(body.nose_radius_ratio);
        let rs = valid.shoulder_radius_ratio.keep(body.shoulder_radius_ratio);
        let m = valid.mach.keep(mach);
        c0 + a * t + b * t * t + c * rn + d * rs + e / (m * m) + f * t * rn
    }

    /// Whether a body is within the range to which the factor was fitted, but for the bluntness of nose and shoulder.
    pub fn covers(&self, body: &SphereCone) -> bool {
        let degrees = body.cone_half_angle_rad / RADIANS_PER_DEGREE;
        self.valid.cone_half_angle_deg.keep(degrees) == degrees
    }
}

/// Published tables by the half-angle of their cone, deg, ascending.
pub type Tables<'a> = [(f64, &'a DragTable)];

/// Mach numbers at which the computed part is tabulated.
const MACH: [f64; 16] = [
    3.0, 3.5, 4.0, 4.5, 5.0, 6.0, 7.0, 8.0, 10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 40.0, 60.0,
];

/// Axial force of an outline nose first, from its Newtonian coefficient for C_p,max = 1.
pub fn axial_force(
    newtonian: f64,
    body: Option<&SphereCone>,
    correction: &EulerCorrection,
    tables: &Tables,
    heat_capacity_ratio: f64,
) -> DragTable {
    let computed = |mach: f64| {
        let factor = body.map_or(1.0, |body| correction.factor(body, mach));
        let base = mach.max(BASE_MACH_MIN);
        pressure_coefficient_max(mach, heat_capacity_ratio) * factor * newtonian
            + 1.0 / (base * base)
    };
    let square = body.map_or(newtonian, |body| {
        let s = sin(body.cone_half_angle_rad);
        s * s
    });
    let trend = |mach: f64| interpolated(tables, square, mach);
    let excess = match trend(BASE_MACH_MIN) {
        Some(at) if at > 0.0 => computed(BASE_MACH_MIN) / at - 1.0,
        _ => 0.0,
    };
    let mut mach: Vec<f64> = tables
        .iter()
        .flat_map(|(_, table)| table.rows().map(|(mach, _)| mach))
        .filter(|mach| *mach < BASE_MACH_MIN)
        .chain([0.0, 0.5, 1.5])
        .collect();
    mach.sort_unstable_by(f64::total_cmp);
    mach.dedup();
    let low = mach.iter().map(|&mach| {
        let value = trend(mach).unwrap_or_else(|| computed(mach));
        (mach, value * (1.0 + excess * (mach - 0.5).clamp(0.0, 1.0)))
    });
    let rows: Vec<(f64, f64)> = low
        .chain(MACH.iter().map(|&mach| (mach, computed(mach))))
        .map(|(mach, c)| (mach, c.max(0.0)))
        .collect();
    DragTable::from_ascending(&rows)
}

/// The table of a cone angle at a Mach number, held beyond the smallest and largest angle.
fn interpolated(tables: &Tables, square: f64, mach: f64) -> Option<f64> {
    let of = |(degrees, table): &(f64, &DragTable)| {
        let s = sin(degrees * RADIANS_PER_DEGREE);
        (s * s, table.at(mach))
    };
    let after = tables.partition_point(|table| of(table).0 <= square);
    match (
        after.checked_sub(1).and_then(|n| tables.get(n)),
        tables.get(after),
    ) {
        (Some(a), Some(b)) => {
            let ((sa, ca), (sb, cb)) = (of(a), of(b));
            Some(ca + (square - sa) / (sb - sa) * (cb - ca))
        }
        (Some(only), None) | (None, Some(only)) => Some(of(only).1),
        (None, None) => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn correction() -> EulerCorrection {
        EulerCorrection::parse(include_str!("../../data/aero-models/euler-correction.toml").into())
            .unwrap()
    }

    #[test]
    fn at_60_deg_the_factor_is_the_constant_less_the_radii_and_mach() {
        let body = SphereCone {
            cone_half_angle_rad: 60.0 * RADIANS_PER_DEGREE,
            nose_radius_ratio: 0.5,
            shoulder_radius_ratio: 0.04,
        };
        // 1.1404 − 0.092·0.5 − 0.2125·0.04 − 0.1465/100 = 1.084435
        assert!((correction().factor(&body, 10.0) - 1.084_435).abs() < 1e-12);
        // beyond Mach 27 it is held
        assert_eq!(
            correction().factor(&body, 50.0),
            correction().factor(&body, 27.0)
        );
    }

    #[test]
    fn computed_and_published_meet_at_mach_3() {
        let table = DragTable::try_new(&[(0.4, 1.0), (2.0, 1.5), (4.0, 1.4)]).unwrap();
        let got = axial_force(0.9, None, &correction(), &[(60.0, &table)], 1.4);
        // p₀₂/p = 12.061 at Mach 3: k = 11.061/6.3 = 1.7557; 0.9 k + 1/9 = 1.6912
        assert!((got.at(3.0) - 1.6912).abs() < 1e-4);
        // table 1.45 at Mach 3, factor 1.1664 from Mach 1.5 up, none at 0.5 and below
        assert!((got.at(2.0) - 1.5 * got.at(3.0) / 1.45).abs() < 1e-12);
        assert_eq!(got.at(0.4), 1.0);
    }
}
