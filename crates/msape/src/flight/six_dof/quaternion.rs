//! Attitude as a quaternion: from the axes of the body to those of the planet.
//!
//! ```text
//! r = R(q) b
//! q̇ = ½ q ⊗ ω + k (1 − |q|²) q
//! yaw = atan2(R₂₁, R₁₁),  pitch = −asin R₃₁,  roll = atan2(R₃₂, R₃₃)
//! yaw = atan2(−R₁₂, R₂₂),  roll = 0                                        where the pitch is ±90 deg
//! ```
//!
//! with b a vector in axes of the body, ω the rates of the body against the axes of r, in rad/s. R does not depend on the
//! length of q; the term with k, 1/s, keeps the length near one without a change of attitude.
//!
//! # Valid
//! Quaternions whose length is not zero.
//!
//! # References
//! - \[stevens-lewis-2016\] section 1.8.

use nalgebra::{Quaternion, Rotation3, UnitQuaternion, Vector3};
use numerics::math;

/// Rate at which the length returns to one, 1/s.
const RETURN_1_S: f64 = 1.0;

/// The quaternion of four parts, the scalar part first.
#[inline]
pub fn of_parts([w, x, y, z]: [f64; 4]) -> Quaternion<f64> {
    Quaternion::new(w, x, y, z)
}

/// The four parts of a quaternion, the scalar part first.
#[inline]
pub fn parts(q: &Quaternion<f64>) -> [f64; 4] {
    [q.w, q.i, q.j, q.k]
}

/// The rotation scaled to unit length.
#[inline]
pub fn unit(q: Quaternion<f64>) -> UnitQuaternion<f64> {
    UnitQuaternion::new_unchecked(q / q.norm_squared().sqrt())
}

/// Derivative under rates about the axes of the body, rad/s, in 1/s.
#[inline]
pub fn derivative(q: &Quaternion<f64>, rates_rad_s: Vector3<f64>) -> Quaternion<f64> {
    let k = RETURN_1_S * (1.0 - q.norm_squared());
    q * Quaternion::from_imag(rates_rad_s) * 0.5 + q * k
}

/// The rotation by yaw, pitch and roll, rad, in this order about the axes z, y, x of the body: from the axes of the body to
/// those against which the angles are counted.
pub fn of_yaw_pitch_roll([yaw, pitch, roll]: [f64; 3]) -> UnitQuaternion<f64> {
    UnitQuaternion::from_euler_angles(roll, pitch, yaw)
}

/// Cosine of the pitch below which roll counts as zero.
const UPRIGHT: f64 = 1e-8;

/// Yaw, pitch and roll of a rotation from the axes of the body to those against which they are counted, rad.
pub fn yaw_pitch_roll_rad(rotation: &Rotation3<f64>) -> [f64; 3] {
    let m = rotation.matrix();
    let level = math::hypot(m.m11, m.m21);
    let pitch = math::atan2(-m.m31, level);
    if level < UPRIGHT {
        // Only yaw ∓ roll is known: roll is zero, and yaw is seen on the second axis.
        return [math::atan2(-m.m12, m.m22), pitch, 0.0];
    }
    [math::atan2(m.m21, m.m11), pitch, math::atan2(m.m32, m.m33)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::FRAC_PI_2;

    #[test]
    fn yawed_a_quarter_the_nose_points_east() {
        // north, east, down
        let turned = |angles, axis: Vector3<f64>| of_yaw_pitch_roll(angles) * axis;
        let nose = turned([FRAC_PI_2, 0.0, 0.0], Vector3::x());
        assert!((nose.y - 1.0).abs() < 1e-15, "{nose:?}");
        // pitched up a quarter it points up
        assert!((turned([0.0, FRAC_PI_2, 0.0], Vector3::x()).z + 1.0).abs() < 1e-15);
        // rolled a quarter the right side points down
        assert!((turned([0.0, 0.0, FRAC_PI_2], Vector3::y()).z - 1.0).abs() < 1e-15);
    }

    #[test]
    fn angles_and_rotation_and_back() {
        for angles in [[0.3, -0.2, 0.1], [3.0, 1.5, -3.1], [-2.0, -1.4, 2.0]] {
            let back = yaw_pitch_roll_rad(&of_yaw_pitch_roll(angles).to_rotation_matrix());
            for (angle, back) in angles.iter().zip(back) {
                assert!((angle - back).abs() < 1e-13, "{angles:?}");
            }
        }
    }

    #[test]
    fn straight_up_and_down_roll_is_zero_and_yaw_keeps_the_difference_or_the_sum() {
        for (yaw, pitch, roll, expected) in [
            (0.2, FRAC_PI_2, 0.0, 0.2),
            (0.2, FRAC_PI_2, 0.5, -0.3),
            (0.2, -FRAC_PI_2, 0.5, 0.7),
        ] {
            let q = of_yaw_pitch_roll([yaw, pitch, roll]);
            let back = yaw_pitch_roll_rad(&q.to_rotation_matrix());
            assert!((back[0] - expected).abs() < 1e-13, "{back:?}");
            assert!(
                (back[1] - pitch).abs() < 1e-15 && back[2] == 0.0,
                "{back:?}"
            );
        }
    }

    #[test]
    fn the_length_does_not_matter_to_the_attitude() {
        let q = of_yaw_pitch_roll([0.3, -0.2, 0.1]);
        let long = unit(q.into_inner() * 3.0);
        assert!(
            (long.to_rotation_matrix().matrix() - q.to_rotation_matrix().matrix()).amax() < 1e-15
        );
    }

    #[test]
    fn the_derivative_is_that_of_a_small_turn_after_the_attitude() {
        let q = of_yaw_pitch_roll([0.3, -0.2, 0.1]).into_inner();
        let (rates, dt) = (Vector3::new(0.5, -0.3, 0.2), 1e-4);
        let later = q * Quaternion::from_parts(1.0, rates * (0.5 * dt));
        let slope = (later - q) / dt - derivative(&q, rates);
        assert!(slope.coords.amax() < 1e-12);
    }
}
