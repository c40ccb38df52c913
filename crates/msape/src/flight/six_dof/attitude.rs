//! Attitude at the start from angles, and angles of an attitude.
//!
//! ```text
//! R = H R₃₂₁(yaw, pitch, roll)                     against the local horizon
//! R = H R₃₂₁(ψ, γ, bank) W(α, β)                   against the velocity
//! W = | cα cβ    sβ   sα cβ |
//!     | −cα sβ   cβ  −sα sβ |
//!     | −sα      0    cα    |
//! ```
//!
//! with R from axes of the body (x forward along the axis, y right, z down) to planet-fixed axes, H from local north, east
//! and down, ψ and γ azimuth and angle of the velocity relative to the air; all angles in rad.
//!
//! # Valid
//! Everywhere; where the air is at rest against the body, α and β are counted against the direction that the case gives
//! the velocity, and where the velocity is vertical, against the azimuth that the case gives it.
//!
//! # References
//! - \[stevens-lewis-2016\] sections 1.4 and 2.3.

use super::quaternion::{of_yaw_pitch_roll, yaw_pitch_roll_rad};
use crate::flight::mission::{Mission, Start};
use crate::planet::horizon::Horizon;
use crate::planet::wind::Wind;
use nalgebra::{Matrix3, Rotation3, UnitQuaternion, Vector3};
use numerics::math;

/// Attitude at the start, as given by a case.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Given {
    /// Yaw, pitch and roll against local north, east and down, rad.
    YawPitchRoll([f64; 3]),
    /// Angle of attack, of sideslip and of bank against the velocity relative to the air, rad.
    AlphaBetaBank([f64; 3]),
    /// Rotation from body axes to local north, east and down, unit length.
    Quaternion(UnitQuaternion<f64>),
}

/// Rotation from body axes to planet-fixed axes at the start of a mission.
pub fn at_start(given: &Given, start: &Start, mission: &Mission) -> UnitQuaternion<f64> {
    let local = mission.planet.local(start.position_m);
    let horizon = Horizon::new(local.up);
    let to_planet = of_horizon(&horizon);
    let level = match given {
        Given::YawPitchRoll(angles) => of_yaw_pitch_roll(*angles),
        Given::Quaternion(quaternion) => *quaternion,
        Given::AlphaBetaBank([alpha, beta, bank]) => {
            let row = mission.wind.row(local.altitude_m);
            let [east_m_s, north_m_s] = Wind::east_north_m_s(row, local.altitude_m);
            let [north, east, up] = horizon.parts(start.velocity_m_s);
            let (north, east) = (north - north_m_s, east - east_m_s);
            let along = math::hypot(north, east);
            let given = start.relative;
            let (psi, gamma) = if along == 0.0 && up == 0.0 {
                (given.azimuth_rad, given.flight_path_angle_rad)
            } else if along < UPRIGHT * up.abs() {
                (given.azimuth_rad, math::atan2(up, along))
            } else {
                (math::atan2(east, north), math::atan2(up, along))
            };
            let stream = of_yaw_pitch_roll([psi, gamma, *bank]);
            stream * of_stream(*alpha, *beta)
        }
    };
    UnitQuaternion::from_rotation_matrix(&to_planet) * level
}

/// Tangent of the angle to the vertical within which a velocity has no azimuth of its own.
const UPRIGHT: f64 = 1e-9;

/// Rotation from local north, east and down to planet-fixed axes.
fn of_horizon(horizon: &Horizon<f64>) -> Rotation3<f64> {
    let [north, east, up] = [horizon.north, horizon.east, horizon.up].map(Vector3::from);
    Rotation3::from_matrix_unchecked(Matrix3::from_columns(&[north, east, -up]))
}

/// Rotation from body axes to wind axes.
fn of_stream(alpha: f64, beta: f64) -> UnitQuaternion<f64> {
    UnitQuaternion::from_axis_angle(&Vector3::z_axis(), -beta)
        * UnitQuaternion::from_axis_angle(&Vector3::y_axis(), alpha)
}

/// Yaw, pitch and roll against local north, east and down of an attitude against planet-fixed axes, rad.
pub fn angles_rad(attitude: &Rotation3<f64>, up: [f64; 3]) -> [f64; 3] {
    let to_planet = of_horizon(&Horizon::new(up));
    yaw_pitch_roll_rad(&(to_planet.inverse() * attitude))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_velocity_of_the_stream_has_its_alpha_and_beta() {
        // u = V cα cβ, v = V sβ, w = V sα cβ
        let (alpha, beta) = (0.3, -0.2);
        let [u, v, w] = (of_stream(alpha, beta).inverse() * Vector3::x()).into();
        assert!((u - math::cos(alpha) * math::cos(beta)).abs() < 1e-15);
        assert!((v - math::sin(beta)).abs() < 1e-15);
        assert!((w - math::sin(alpha) * math::cos(beta)).abs() < 1e-15);
    }

    #[test]
    fn angles_come_back_over_any_place() {
        let up = [0.48, 0.6, 0.64];
        let to_planet = of_horizon(&Horizon::new(up));
        let angles = [1.0, -0.5, 2.0];
        let attitude = to_planet * of_yaw_pitch_roll(angles).to_rotation_matrix();
        for (given, back) in angles.iter().zip(angles_rad(&attitude, up)) {
            assert!((given - back).abs() < 1e-14);
        }
        // The third axis of the level body points down.
        let down = to_planet * Vector3::z();
        assert!((down.z + 0.64).abs() < 1e-15);
    }
}
