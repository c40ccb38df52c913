//! Attitude as a quaternion: from the axes of the body to those of the planet.
//!
//! ```text
//! r = R(q) b,   R = 1 + 2/|q|² (w [v]ₓ + [v]ₓ²),   q = (w, v)
//! q̇ = ½ q ⊗ ω + k (1 − |q|²) q
//! yaw = atan2(R₂₁, R₁₁),  pitch = −asin R₃₁,  roll = atan2(R₃₂, R₃₃)
//! yaw = atan2(−R₁₂, R₂₂),  roll = 0                                        where the pitch is ±90 deg
//! ```
//!
//! with b a vector in axes of the body, ω the rates of the body against the axes of r, in rad/s. R does not depend on the
//! length of q; the term with k, 1/s, keeps the length near one without a change of attitude.
//!
//! # Valid
//! Quaternions that are not nothing.
//!
//! # References
//! - \[stevens-lewis-2016\] section 1.8.

use numerics::math;

/// Rate at which the length returns to one, 1/s.
const RETURN_1_S: f64 = 1.0;

/// A rotation from one set of axes to another, scalar part first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quaternion(pub [f64; 4]);

/// Rows of the matrix of a rotation.
pub type Matrix = [[f64; 3]; 3];

impl Quaternion {
    /// The rotation by yaw, pitch and roll, rad, in this order about the axes z, y, x of the body: from the axes of the
    /// body to those against which the angles are counted.
    pub fn of_yaw_pitch_roll([yaw, pitch, roll]: [f64; 3]) -> Quaternion {
        let half = |angle: f64| math::sin_cos(0.5 * angle);
        let ((sy, cy), (sp, cp), (sr, cr)) = (half(yaw), half(pitch), half(roll));
        Quaternion([
            cy * cp * cr + sy * sp * sr,
            cy * cp * sr - sy * sp * cr,
            cy * sp * cr + sy * cp * sr,
            sy * cp * cr - cy * sp * sr,
        ])
    }

    /// The rotation whose matrix has these rows; unit length.
    pub fn of_matrix(m: &Matrix) -> Quaternion {
        let [[xx, xy, xz], [yx, yy, yz], [zx, zy, zz]] = *m;
        let squares = [
            1.0 + xx + yy + zz,
            1.0 + xx - yy - zz,
            1.0 - xx + yy - zz,
            1.0 - xx - yy + zz,
        ];
        // The largest part is found first: it divides the others.
        let (mut largest, mut of) = (0, squares[0]);
        for (i, square) in squares.iter().enumerate() {
            if *square > of {
                (largest, of) = (i, *square);
            }
        }
        let parts = match largest {
            0 => [of, zy - yz, xz - zx, yx - xy],
            1 => [zy - yz, of, xy + yx, xz + zx],
            2 => [xz - zx, xy + yx, of, yz + zy],
            _ => [yx - xy, xz + zx, yz + zy, of],
        };
        Quaternion(parts).unit()
    }

    /// The same rotation with unit length.
    pub fn unit(self) -> Quaternion {
        let scale = 1.0 / self.length_squared().sqrt();
        Quaternion(self.0.map(|part| part * scale))
    }

    /// Square of the length.
    #[inline]
    pub fn length_squared(&self) -> f64 {
        let [w, x, y, z] = self.0;
        w * w + x * x + y * y + z * z
    }

    /// This rotation after another.
    pub fn after(&self, first: &Quaternion) -> Quaternion {
        let [w, x, y, z] = self.0;
        let [a, b, c, d] = first.0;
        Quaternion([
            w * a - x * b - y * c - z * d,
            w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b,
            w * d + x * c - y * b + z * a,
        ])
    }

    /// Matrix of the rotation.
    #[inline]
    pub fn matrix(&self) -> Matrix {
        let [w, x, y, z] = self.0;
        let s = 2.0 / self.length_squared();
        let (sx, sy, sz) = (s * x, s * y, s * z);
        let (wx, wy, wz) = (w * sx, w * sy, w * sz);
        let (xx, xy, xz) = (x * sx, x * sy, x * sz);
        let (yy, yz, zz) = (y * sy, y * sz, z * sz);
        [
            [1.0 - (yy + zz), xy - wz, xz + wy],
            [xy + wz, 1.0 - (xx + zz), yz - wx],
            [xz - wy, yz + wx, 1.0 - (xx + yy)],
        ]
    }

    /// Derivative under rates about the axes of the body, rad/s, in 1/s.
    #[inline]
    pub fn derivative(&self, [p, q, r]: [f64; 3]) -> [f64; 4] {
        let [w, x, y, z] = self.0;
        let k = RETURN_1_S * (1.0 - self.length_squared());
        [
            -0.5 * (x * p + y * q + z * r) + k * w,
            0.5 * (w * p + y * r - z * q) + k * x,
            0.5 * (w * q + z * p - x * r) + k * y,
            0.5 * (w * r + x * q - y * p) + k * z,
        ]
    }
}

/// Cosine of the pitch below which roll counts as nought.
const UPRIGHT: f64 = 1e-8;

/// Yaw, pitch and roll of a matrix from the axes of the body to those against which they are counted, rad.
pub fn yaw_pitch_roll_rad(m: &Matrix) -> [f64; 3] {
    let [[xx, ..], [yx, ..], [zx, zy, zz]] = *m;
    let level = math::hypot(xx, yx);
    if level < UPRIGHT {
        // Only yaw ∓ roll is known: roll is nought, and yaw is seen on the second axis.
        let [[_, xy, _], [_, yy, _], _] = *m;
        return [math::atan2(-xy, yy), math::atan2(-zx, level), 0.0];
    }
    [
        math::atan2(yx, xx),
        math::atan2(-zx, level),
        math::atan2(zy, zz),
    ]
}

/// M b.
#[inline]
pub fn turned(m: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    [
        m[0][0] * x + m[0][1] * y + m[0][2] * z,
        m[1][0] * x + m[1][1] * y + m[1][2] * z,
        m[2][0] * x + m[2][1] * y + m[2][2] * z,
    ]
}

/// Mᵀ r.
#[inline]
pub fn turned_back(m: &Matrix, [x, y, z]: [f64; 3]) -> [f64; 3] {
    [
        m[0][0] * x + m[1][0] * y + m[2][0] * z,
        m[0][1] * x + m[1][1] * y + m[2][1] * z,
        m[0][2] * x + m[1][2] * y + m[2][2] * z,
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::FRAC_PI_2;

    #[test]
    fn yawed_a_quarter_the_nose_points_east() {
        // north, east, down
        let m = Quaternion::of_yaw_pitch_roll([FRAC_PI_2, 0.0, 0.0]).matrix();
        let nose = turned(&m, [1.0, 0.0, 0.0]);
        assert!((nose[1] - 1.0).abs() < 1e-15, "{nose:?}");
        // pitched up a quarter it points up
        let m = Quaternion::of_yaw_pitch_roll([0.0, FRAC_PI_2, 0.0]).matrix();
        assert!((turned(&m, [1.0, 0.0, 0.0])[2] + 1.0).abs() < 1e-15);
        // rolled a quarter the right side points down
        let m = Quaternion::of_yaw_pitch_roll([0.0, 0.0, FRAC_PI_2]).matrix();
        assert!((turned(&m, [0.0, 1.0, 0.0])[2] - 1.0).abs() < 1e-15);
    }

    #[test]
    fn angles_and_matrix_and_back() {
        for angles in [[0.3, -0.2, 0.1], [3.0, 1.5, -3.1], [-2.0, -1.4, 2.0]] {
            let q = Quaternion::of_yaw_pitch_roll(angles);
            let back = yaw_pitch_roll_rad(&q.matrix());
            let of_matrix = Quaternion::of_matrix(&q.matrix());
            let same: f64 = q.0.iter().zip(of_matrix.0).map(|(a, b)| a * b).sum();
            assert!((same.abs() - 1.0).abs() < 1e-14);
            for (angle, back) in angles.iter().zip(back) {
                assert!((angle - back).abs() < 1e-13, "{angles:?}");
            }
        }
    }

    #[test]
    fn straight_up_and_down_roll_is_nought_and_yaw_keeps_the_difference_or_the_sum() {
        for (yaw, pitch, roll, expected) in [
            (0.2, FRAC_PI_2, 0.0, 0.2),
            (0.2, FRAC_PI_2, 0.5, -0.3),
            (0.2, -FRAC_PI_2, 0.5, 0.7),
        ] {
            let q = Quaternion::of_yaw_pitch_roll([yaw, pitch, roll]);
            let back = yaw_pitch_roll_rad(&q.matrix());
            assert!((back[0] - expected).abs() < 1e-13, "{back:?}");
            assert!(
                (back[1] - pitch).abs() < 1e-15 && back[2] == 0.0,
                "{back:?}"
            );
        }
    }

    #[test]
    fn the_length_does_not_matter_to_the_matrix() {
        let q = Quaternion::of_yaw_pitch_roll([0.3, -0.2, 0.1]);
        let long = Quaternion(q.0.map(|part| 3.0 * part));
        for (a, b) in q
            .matrix()
            .iter()
            .flatten()
            .zip(long.matrix().iter().flatten())
        {
            assert!((a - b).abs() < 1e-15);
        }
    }

    #[test]
    fn the_derivative_is_that_of_a_small_turn_after_the_attitude() {
        let q = Quaternion::of_yaw_pitch_roll([0.3, -0.2, 0.1]);
        let (rates, dt) = ([0.5, -0.3, 0.2], 1e-4);
        let turn = Quaternion([
            1.0,
            0.5 * rates[0] * dt,
            0.5 * rates[1] * dt,
            0.5 * rates[2] * dt,
        ]);
        let later = q.after(&turn);
        for i in 0..4 {
            let slope = (later.0[i] - q.0[i]) / dt;
            assert!((slope - q.derivative(rates)[i]).abs() < 1e-12);
        }
    }
}
