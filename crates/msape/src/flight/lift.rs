//! Lift of a point mass, rotated about its velocity by a bank schedule.
//!
//! ```text
//! a = q A/m (−C_D û + C_L (cos σ n̂ + sin σ b̂))
//! b̂ = û × ẑ / |û × ẑ|,  n̂ = b̂ × û
//! ```
//!
//! with a in m/s², q the dynamic pressure in Pa, A in m², m in kg, û the direction of flight relative to the air, ẑ the
//! geodetic vertical and σ the angle of bank in rad, positive when the lift leans to the right.
//!
//! Where û is vertical, b̂ has no direction. In a fall lift that points down, at a bank beyond 90 deg, drives û into the vertical and
//! holds it there, in a climb lift that points up: near it the lift fades, a = q A/m C_L f(s/ε) …, with s = |û × ẑ|,
//! f(x) = x (3 − x²)/2 below 1, ε = E (1 ∓ cos σ)/2, so that û stays. The other way lift drives û away and does not fade; exactly at
//! the vertical b̂ is that of the azimuth at the start.
//!
//! # Valid
//! E is assumed: a flight held vertical leans by a small part of it.
//!
//! # References
//! - \[vinh-1980\] chapter 2.

use super::equations::{Equations, Surroundings};
use super::trim::Trim;
use crate::aero::table::Extrapolation;
use crate::planet::horizon::Horizon;
use nalgebra::Vector3;
use numerics::interp::Table1;
use numerics::scalar::{Mask, Scalar};

/// Sine of the angle to the vertical within which lift has the direction of the start.
const UPRIGHT: f64 = 1e-9;
/// Sine of the angle to the vertical within which lift fades that points straight down; assumed.
const FADING: f64 = 0.03;

/// Lift of a point mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Lift {
    /// Origin of its magnitude.
    pub source: Source,
    /// Direction of the lift.
    pub bank: Bank,
    /// Rule beyond the ends of a table of the bank angle.
    pub beyond_bank: Extrapolation,
}

/// Size of the lift.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// A part of the drag.
    OfDrag(f64),
    /// A coefficient, the same at every Mach number.
    Coefficient(f64),
    /// A coefficient against Mach number, and the rule beyond its ends.
    Table(Table1, Extrapolation),
    /// Lift and drag at the angle of attack where the moment about the center of gravity vanishes.
    Trim(Trim),
}

/// Angle of bank, rad.
#[derive(Clone, Debug, PartialEq)]
pub enum Bank {
    /// Always the same.
    Constant(f64),
    /// Against the time after the start, s.
    OfTime(Table1),
    /// Against the speed relative to the air, m/s.
    OfSpeed(Table1),
}

/// Coefficients along and across the velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DragAndLift<S> {
    /// Drag coefficient.
    pub drag: S,
    /// Lift coefficient.
    pub lift: S,
}

impl Lift {
    /// The coefficients at one state.
    #[inline]
    pub fn coefficients<S: Scalar>(
        &self,
        equations: &Equations<S>,
        around: &Surroundings<S>,
    ) -> DragAndLift<S> {
        let drag = around.drag_coefficient;
        let lift = match &self.source {
            Source::OfDrag(ratio) => drag * *ratio,
            Source::Coefficient(coefficient) => S::constant(*coefficient),
            Source::Table(table, _) => {
                table.at(around.air_speed_m_s / equations.sound_m_s(around.altitude_m))
            }
            Source::Trim(trim) => return trim.at(equations, around),
        };
        DragAndLift { drag, lift }
    }

    /// Angle of bank, rad.
    #[inline]
    pub fn bank_rad<S: Scalar>(&self, t: S, air_speed_m_s: S) -> S {
        match &self.bank {
            Bank::Constant(angle) => S::constant(*angle),
            Bank::OfTime(table) => table.at(t),
            Bank::OfSpeed(table) => table.at(air_speed_m_s),
        }
    }

    /// Drag and lift over mass, planet-fixed axes, m/s².
    #[inline]
    pub fn force_over_mass_m_s2<S: Scalar>(
        &self,
        equations: &Equations<S>,
        around: &Surroundings<S>,
        t: S,
    ) -> [S; 3] {
        let DragAndLift { drag, lift } = self.coefficients(equations, around);
        let v = around.air_speed_m_s;
        let rate = around.density_kg_m3 * v * equations.half_area_over_mass_m2_kg();
        let [ux, uy, uz] = around.air_velocity_m_s;
        let held = || {
            let azimuth_rad = equations.numbers().start.relative.azimuth_rad;
            let (sin, cos) = (azimuth_rad.sin(), azimuth_rad.cos());
            Horizon::new(around.up).vector([-sin, cos, S::constant(0.0)])
        };
        let bank_rad = self.bank_rad(t, v);
        let [nx, ny, nz] = direction(&around.air_velocity_m_s, &around.up, [bank_rad, lift], held);
        let (along, across) = (-rate * drag, rate * v * lift);
        [
            along * ux + across * nx,
            along * uy + across * ny,
            along * uz + across * nz,
        ]
    }
}

/// Direction of lift of a bank, rad, and a sign: a unit vector across the velocity, shorter where it fades; to the right is
/// `held` at the vertical.
fn direction<S: Scalar>(
    velocity_m_s: &[S; 3],
    up: &[S; 3],
    [bank_rad, lift]: [S; 2],
    held: impl Fn() -> [S; 3],
) -> [S; 3] {
    let [velocity_m_s, up] = [velocity_m_s, up].map(|vector| Vector3::from(*vector));
    let length = |vector: &Vector3<S>| vector.dot(vector).sqrt();
    let speed = length(&velocity_m_s).max(S::constant(f64::MIN_POSITIVE));
    let u = velocity_m_s.map(|v| v / speed);
    let right = u.cross(&up);
    let one = S::constant(1.0);
    let upright = length(&right);
    let scale = one / upright.max(S::constant(UPRIGHT));
    let mut right = right.map(|r| r * scale);
    let vertical = upright.less(S::constant(UPRIGHT));
    if vertical.any() {
        let held: Vector3<S> = held().into();
        right = right.zip_map(&held, |right, held| S::select(vertical, held, right));
    }
    let (sin, cos) = (bank_rad.sin(), bank_rad.cos());
    let near = upright.less(S::constant(FADING));
    if near.any() {
        let zero = S::constant(0.0);
        let climbs = zero.less(u.dot(&up));
        let away = S::select(climbs, -cos, cos);
        let away = S::select(lift.less(zero), -away, away);
        let width = ((one - away) * (0.5 * FADING)).max(S::constant(f64::MIN_POSITIVE));
        let part = (upright.max(S::constant(UPRIGHT)) / width).min(one);
        let fading = part * (S::constant(3.0) - part * part) * 0.5;
        let fading = S::select(near, fading, one);
        right = right.map(|r| r * fading);
    }
    let above = right.cross(&u);
    above
        .zip_map(&right, |above, right| cos * above + sin * right)
        .into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::FRAC_PI_2;

    #[test]
    fn eastward_over_the_equator_lift_is_up_and_banked_right_it_is_south() {
        // x up, y east, z north
        let level = direction(&[0.0_f64, 5.0, 0.0], &[1.0, 0.0, 0.0], [0.0, 1.0], NORTH);
        assert_eq!(level, [1.0, 0.0, 0.0]);
        let banked = direction(
            &[0.0_f64, 5.0, 0.0],
            &[1.0, 0.0, 0.0],
            [FRAC_PI_2, 1.0],
            NORTH,
        );
        assert!((banked[2] + 1.0).abs() < 1e-15 && banked[0].abs() < 1e-15);
    }

    #[test]
    fn at_3_4_5_lift_is_across_the_velocity() {
        // climbing 4 of 5, going 3 of 5 eastward: lift leans back, (up, east) = (0.6, -0.8)
        let [up, east, north] =
            direction(&[4.0_f64, 3.0, 0.0], &[1.0, 0.0, 0.0], [0.0, 1.0], NORTH);
        assert!((up - 0.6).abs() < 1e-15 && (east + 0.8).abs() < 1e-15 && north == 0.0);
    }

    const NORTH: fn() -> [f64; 3] = || [0.0, 0.0, 1.0];

    #[test]
    fn straight_down_lift_has_the_direction_of_the_start_and_none_where_it_points_down() {
        // right is north, so that ahead is west: x up, y east, z north
        let of = |bank: f64| direction(&[-5.0_f64, 0.0, 0.0], &[1.0, 0.0, 0.0], [bank, 1.0], NORTH);
        assert_eq!(of(0.0), [0.0, -1.0, 0.0]);
        let down = of(core::f64::consts::PI);
        assert!(down.iter().all(|part| part.abs() < 1e-7), "{down:?}");
    }

    #[test]
    fn lift_down_fades_evenly_into_the_vertical() {
        let pi = core::f64::consts::PI;
        let of = |down: f64, sine: f64, bank: f64, lift: f64| {
            let u = [-down * (1.0 - sine * sine).sqrt(), sine, 0.0];
            let [x, y, z] = direction(&u, &[1.0, 0.0, 0.0], [bank, lift], NORTH);
            (x * x + y * y + z * z).sqrt()
        };
        let size = |sine: f64, bank: f64| of(1.0, sine, bank, 1.0);
        assert!((size(FADING, pi) - 1.0).abs() < 1e-15);
        // x = 1/2: ½ (3 − ¼)/2 = 0.6875
        assert!((size(0.5 * FADING, pi) - 0.6875).abs() < 1e-12);
        // at 90 deg over half the width
        assert!((size(0.25 * FADING, FRAC_PI_2) - 0.6875).abs() < 1e-12);
        assert!((size(1e-6, 0.0) - 1.0).abs() < 1e-12);
        // The signs are reversed for lift below zero, and in a climb.
        assert!((of(1.0, 0.5 * FADING, 0.0, -1.0) - 0.6875).abs() < 1e-12);
        assert!((of(-1.0, 0.5 * FADING, 0.0, 1.0) - 0.6875).abs() < 1e-12);
        assert!((of(-1.0, 1e-6, pi, 1.0) - 1.0).abs() < 1e-12);
    }
}
