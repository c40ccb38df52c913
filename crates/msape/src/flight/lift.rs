//! Lift of a point mass, turned about its velocity by a schedule of bank.
//!
//! ```text
//! a = q A/m (−C_D û + C_L (cos σ n̂ + sin σ b̂))
//! b̂ = û × ẑ / |û × ẑ|,  n̂ = b̂ × û
//! ```
//!
//! with a in m/s², q the dynamic pressure in Pa, A in m², m in kg, û the direction of flight relative to the air, ẑ the
//! geodetic vertical and σ the angle of bank in rad, positive when the lift leans to the right.
//!
//! # Valid
//! Where the flight is within 1e-9 rad of the vertical, lift has no direction and fades.
//!
//! # References
//! - \[vinh-1980\] chapter 2.

use super::equations::{Equations, Surroundings};
use super::trim::Trim;
use numerics::interp::Table1;
use numerics::math;

/// Sine of the angle to the vertical within which lift fades.
const UPRIGHT: f64 = 1e-9;

/// Lift of a point mass.
#[derive(Clone, Debug, PartialEq)]
pub struct Lift {
    /// Where its size comes from.
    pub source: Source,
    /// Its direction.
    pub bank: Bank,
}

/// Size of the lift.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// A part of the drag.
    OfDrag(f64),
    /// A coefficient, the same at every Mach number.
    Coefficient(f64),
    /// A coefficient against Mach number.
    Table(Table1),
    /// Lift and drag at the angle of attack where the moment about the centre of gravity is nothing.
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
pub struct DragAndLift {
    /// Drag coefficient.
    pub drag: f64,
    /// Lift coefficient.
    pub lift: f64,
}

impl Lift {
    /// The coefficients at one state.
    #[inline]
    pub fn coefficients(&self, equations: &Equations, around: &Surroundings<f64>) -> DragAndLift {
        let drag = around.drag_coefficient;
        let lift = match &self.source {
            Source::OfDrag(ratio) => ratio * drag,
            Source::Coefficient(coefficient) => *coefficient,
            Source::Table(table) => table.at(mach(equations, around)),
            Source::Trim(trim) => return trim.at(equations, around),
        };
        DragAndLift { drag, lift }
    }

    /// Angle of bank, rad.
    #[inline]
    pub fn bank_rad(&self, t: f64, air_speed_m_s: f64) -> f64 {
        match &self.bank {
            Bank::Constant(angle) => *angle,
            Bank::OfTime(table) => table.at(t),
            Bank::OfSpeed(table) => table.at(air_speed_m_s),
        }
    }

    /// Drag and lift over mass, planet-fixed axes, m/s².
    #[inline]
    pub fn force_over_mass_m_s2(
        &self,
        equations: &Equations,
        around: &Surroundings<f64>,
        t: f64,
    ) -> [f64; 3] {
        let DragAndLift { drag, lift } = self.coefficients(equations, around);
        let v = around.air_speed_m_s;
        let rate = around.density_kg_m3
            * v
            * (0.5 * equations.body.reference_area_m2 / equations.body.mass_kg);
        let [ux, uy, uz] = around.air_velocity_m_s;
        let [nx, ny, nz] = direction(&around.air_velocity_m_s, &around.up, self.bank_rad(t, v));
        let (along, across) = (-rate * drag, rate * v * lift);
        [
            along * ux + across * nx,
            along * uy + across * ny,
            along * uz + across * nz,
        ]
    }
}

/// Direction of lift, a unit vector across the velocity; nothing where there is none.
fn direction(velocity_m_s: &[f64; 3], up: &[f64; 3], bank_rad: f64) -> [f64; 3] {
    let speed = length(velocity_m_s).max(f64::MIN_POSITIVE);
    let u = velocity_m_s.map(|v| v / speed);
    let right = cross(&u, up);
    let scale = 1.0 / length(&right).max(UPRIGHT);
    let right = right.map(|r| r * scale);
    let above = cross(&right, &u);
    let (sin, cos) = math::sin_cos(bank_rad);
    core::array::from_fn(|i| cos * above[i] + sin * right[i])
}

fn mach(equations: &Equations, around: &Surroundings<f64>) -> f64 {
    let atmosphere = &equations.mission.atmosphere;
    around.air_speed_m_s / atmosphere.speed_of_sound_in(equations.layer, around.altitude_m)
}

fn length([x, y, z]: &[f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

fn cross(a: &[f64; 3], b: &[f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::FRAC_PI_2;

    #[test]
    fn eastward_over_the_equator_lift_is_up_and_banked_right_it_is_south() {
        // x up, y east, z north
        let level = direction(&[0.0, 5.0, 0.0], &[1.0, 0.0, 0.0], 0.0);
        assert_eq!(level, [1.0, 0.0, 0.0]);
        let banked = direction(&[0.0, 5.0, 0.0], &[1.0, 0.0, 0.0], FRAC_PI_2);
        assert!((banked[2] + 1.0).abs() < 1e-15 && banked[0].abs() < 1e-15);
    }

    #[test]
    fn at_3_4_5_lift_is_across_the_velocity() {
        // climbing 4 of 5, going 3 of 5 eastward: lift leans back, (up, east) = (0.6, -0.8)
        let [up, east, north] = direction(&[4.0, 3.0, 0.0], &[1.0, 0.0, 0.0], 0.0);
        assert!((up - 0.6).abs() < 1e-15 && (east + 0.8).abs() < 1e-15 && north == 0.0);
    }

    #[test]
    fn straight_down_lift_has_no_direction() {
        assert_eq!(
            direction(&[-5.0, 0.0, 0.0], &[1.0, 0.0, 0.0], 1.0),
            [0.0; 3]
        );
    }
}
