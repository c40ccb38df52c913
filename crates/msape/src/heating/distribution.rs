//! Laminar heating along a sphere-cone after Lees, over that at the stagnation point.
//!
//! ```text
//! sphere  q̇/q̇₀ = 2 θ sin θ P(θ) / √D(θ)
//!         P = (1−e) cos² θ + e
//!         D = (1−e)(θ² − θ sin 4θ/2 + (1 − cos 4θ)/8) + 4e (θ² − θ sin 2θ + (1 − cos 2θ)/2)
//! cone    q̇/q̇₀ = A S / √(B + S³),   S = r / (Rₙ sin θc),   φ = π/2 − θc
//!         A = (√3/2) √(P(φ) φ),     B = (3/16) D(φ) / (φ P(φ) sin² θc) − cot³ θc
//! ```
//!
//! with θ the angle from the stagnation point, rad, θc the cone half-angle, r the distance from the axis and Rₙ the nose
//! radius, m, e = 1/(γ M²).
//!
//! # Valid
//! Zero angle of attack, no shoulder. On cones steeper than about 55 degrees the flow is subsonic or transonic and the
//! flank is under-predicted: a lower bound there.
//!
//! # References
//! - \[lees-1956\], re-derived for this project: dD/dθ = 16 θ sin² θ P, D(0) = 0.

use crate::data::Data;
use crate::finding::range::{Check, Range};
use crate::finding::{Finding, Severity};
use crate::quantity::input;
use numerics::math;
use serde::Deserialize;

/// Range of the distribution, from `heating/lees.toml`.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lees {
    /// Key of the reference.
    pub source: String,
    /// Place in it.
    pub place: String,
    /// Note on its limits.
    pub note: String,
    valid: Valid,
}

#[derive(Clone, Copy, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
struct Valid {
    cone_half_angle_deg: Range,
}

/// A blunted cone without shoulder.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SphereCone {
    /// Cone half-angle, rad.
    pub half_angle_rad: f64,
    /// Nose radius, m.
    pub nose_radius_m: f64,
}

impl Lees {
    /// Reads the range from the text of `heating/lees.toml`.
    pub fn parse(data: Data) -> Result<Self, String> {
        data.read()
    }

    /// The caution, where the cone is too steep.
    pub fn findings(&self, body: &SphereCone) -> Vec<Finding> {
        let check = Check {
            severity: Severity::Extrapolated,
            model: "lees distribution",
            key: "cone_half_angle_deg",
            quantity: "Cone half-angle",
            value: body.half_angle_rad / math::RADIANS_PER_DEGREE,
            range: self.valid.cone_half_angle_deg,
            unit: "deg",
            si_per_unit: 1.0,
            meaning: "the flow over the cone is not supersonic, flank heating is a lower bound",
            source: "Lees 1956, Newtonian pressure; limit assumed",
            field: Some(input::design::CONE_HALF_ANGLE_DEG.key),
        };
        check.finding().into_iter().collect()
    }
}

impl SphereCone {
    /// Distance of the tangent point of sphere and cone from the axis, m.
    pub fn tangent_radius_m(&self) -> f64 {
        self.nose_radius_m * math::cos(self.half_angle_rad)
    }

    /// Heat flux at `radius_m` from the axis over that at the stagnation point; `e` = 1/(γ M²), 0 in the hypersonic limit.
    pub fn heat_flux_ratio(&self, radius_m: f64, e: f64) -> f64 {
        let Self {
            half_angle_rad: theta_c,
            nose_radius_m: r_n,
        } = *self;
        if radius_m <= self.tangent_radius_m() {
            return on_sphere(math::asin((radius_m / r_n).clamp(0.0, 1.0)), e);
        }
        let (sine, cosine) = math::sin_cos(theta_c);
        let (phi, cot) = (math::FRAC_PI_2 - theta_c, cosine / sine);
        let p = pressure_ratio(phi, e);
        let s = radius_m / (r_n * sine);
        // A = (√3/2) √(P φ),  B = (3/16) D / (φ P sin² θc) − cot³ θc
        let a = 0.5 * (3.0 * p * phi).sqrt();
        let b = 3.0 / 16.0 * length_integral(phi, e) / (phi * p * sine * sine) - cot * cot * cot;
        a * s / (b + s * s * s).sqrt()
    }
}

fn on_sphere(theta: f64, e: f64) -> f64 {
    if theta < 1e-6 {
        return 1.0;
    }
    // q̇/q̇₀ = 2 θ sin θ P / √D
    2.0 * theta * math::sin(theta) * pressure_ratio(theta, e) / length_integral(theta, e).sqrt()
}

/// Newtonian pressure over that at the stagnation point.
fn pressure_ratio(theta: f64, e: f64) -> f64 {
    let cosine = math::cos(theta);
    (1.0 - e) * cosine * cosine + e
}

fn length_integral(theta: f64, e: f64) -> f64 {
    let t2 = theta * theta;
    if theta < 0.1 {
        // near 0 the closed form cancels: its series, 1e-10 at the switch
        let t4 = t2 * t2;
        let cold = 4.0 * t4 * (1.0 - t2 * (8.0 / 9.0 - t2 * (16.0 / 45.0 - t2 * (128.0 / 1575.0))));
        let warm = 4.0 * t4 * (1.0 - t2 * (2.0 / 9.0 - t2 * (1.0 / 45.0 - t2 * (2.0 / 1575.0))));
        return (1.0 - e) * cold + e * warm;
    }
    let (sin4, cos4) = math::sin_cos(4.0 * theta);
    let (sin2, cos2) = math::sin_cos(2.0 * theta);
    (1.0 - e) * (t2 - 0.5 * theta * sin4 + 0.125 * (1.0 - cos4))
        + 4.0 * e * (t2 - theta * sin2 + 0.5 * (1.0 - cos2))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cone(deg: f64) -> SphereCone {
        SphereCone {
            half_angle_rad: deg * math::RADIANS_PER_DEGREE,
            nose_radius_m: 1.0,
        }
    }

    #[test]
    fn one_at_the_nose_and_the_same_on_both_sides_of_the_tangent_point() {
        for deg in [45.0, 60.0, 70.0] {
            for e in [0.0, 0.01] {
                assert!((cone(deg).heat_flux_ratio(1e-9, e) - 1.0).abs() < 1e-12);
                let r = cone(deg).tangent_radius_m();
                let step = cone(deg).heat_flux_ratio(r * (1.0 + 1e-13), e)
                    - cone(deg).heat_flux_ratio(r, e);
                assert!(step.abs() < 1e-11, "{deg} deg, e {e}: {step}");
            }
        }
    }

    #[test]
    fn series_meets_the_closed_form() {
        for e in [0.0, 0.02, 1.0] {
            let (series, closed) = (length_integral(0.1 - 1e-12, e), length_integral(0.1, e));
            assert!(
                (series / closed - 1.0).abs() < 1e-9,
                "e {e}: {series} against {closed}"
            );
        }
    }

    #[test]
    fn independent_table_is_met_to_its_last_digit() {
        let text = include_str!("../../../../tests/data/heating_lees_spherecone.csv");
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(text.as_bytes());
        let mut rows = 0;
        for row in reader.deserialize::<(f64, f64, String, f64, f64)>() {
            let (deg, bluntness, zone, r, ratio) = row.unwrap();
            let body = SphereCone {
                nose_radius_m: bluntness,
                ..cone(deg)
            };
            let ours = body.heat_flux_ratio(r, 0.0);
            // both columns carry four digits: half a digit of the ratio, and of r times the slope (below 2)
            assert!(
                (ours - ratio).abs() < 1.6e-4,
                "{deg} {bluntness} {zone} {r}: {ours} against {ratio}"
            );
            rows += 1;
        }
        assert_eq!(rows, 108);
    }

    #[test]
    fn steep_cone_is_cautioned() {
        let lees = Lees::parse(include_str!("../../data/heating/lees.toml").into()).unwrap();
        assert!(lees.findings(&cone(45.0)).is_empty());
        assert_eq!(lees.findings(&cone(60.0)).len(), 1);
    }
}
