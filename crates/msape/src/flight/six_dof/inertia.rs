//! Inertia of a rigid body about its center of gravity, and Euler's equations.
//!
//! ```text
//! I ω̇ = M − ω × (I ω)
//! ```
//!
//! with I in kg·m² (off-diagonal elements are minus the products of inertia), ω in rad/s, M in N·m, all in axes of the
//! body.
//!
//! # Valid
//! Positive definite tensors whose principal moments fit a body: none exceeds the sum of the others.
//!
//! # References
//! - \[goldstein-2002\] sections 5.3 and 5.5.

use nalgebra::{Matrix3, SymmetricEigen, Vector3};

/// Part of the largest element by which a tensor may be unsymmetric, or its moments may break the triangle inequality:
/// what rounding to four figures does.
const ROUNDING: f64 = 1e-4;

/// A tensor of inertia that a body can have, with its inverse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// The tensor, kg·m².
    pub tensor_kg_m2: Matrix3<f64>,
    /// Inverse of the inertia, 1/(kg·m²).
    inverse: Matrix3<f64>,
}

impl Inertia {
    /// The inertia of a body.
    ///
    /// # Errors
    /// Everything that no body can have, each with values and what they must be.
    pub fn try_new(rows: [[f64; 3]; 3]) -> Result<Inertia, Vec<String>> {
        let mut faults = Vec::new();
        let largest = rows.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
        let axes = ["x", "y", "z"];
        if largest == 0.0 {
            return Err(vec![
                "got no inertia at all, 0 kg-m^2; must be positive definite".to_string(),
            ]);
        }
        for (i, axis) in axes.iter().enumerate() {
            let moment = rows[i][i];
            if moment <= 0.0 || !moment.is_finite() {
                let message = format!("got {moment} kg-m^2 about {axis}, must be above 0 kg-m^2");
                faults.push(message);
            }
            for j in 0..i {
                let (a, b) = (rows[i][j], rows[j][i]);
                // an infinite or missing number is not within the bound either
                let same = (a - b).abs() <= ROUNDING * largest;
                if !same {
                    let other = axes[j];
                    faults.push(format!("got {a} kg-m^2 in row {axis}, column {other} and {b} kg-m^2 in row {other}, column {axis}; both must be the same"));
                }
            }
        }
        if !faults.is_empty() {
            return Err(faults);
        }
        let tensor = Matrix3::from(rows);
        let tensor = (tensor + tensor.transpose()) * 0.5;
        let Some([low, middle, high]) = principal_moments(&tensor) else {
            return Err(vec![UNKNOWN.to_string()]);
        };
        let moments = format!("principal moments {low:.6}, {middle:.6} and {high:.6} kg-m^2");
        if low <= 0.0 || low.is_nan() {
            return Err(vec![format!(
                "has the {moments}; all must be above 0 kg-m^2"
            )]);
        }
        if high > (low + middle) * (1.0 + ROUNDING) {
            return Err(vec![format!(
                "has the {moments}; the largest must be at most {:.6} kg-m^2, the sum of the others, or no mass has them",
                low + middle
            )]);
        }
        let inverse = tensor.try_inverse();
        let inverse = inverse.filter(|inverse| inverse.iter().all(|part| part.is_finite()));
        inverse.map_or_else(
            || Err(vec![UNKNOWN.to_string()]),
            |inverse| {
                Ok(Inertia {
                    inverse,
                    tensor_kg_m2: tensor,
                })
            },
        )
    }

    /// ω̇ under a moment, N·m, in rad/s².
    #[inline]
    pub fn acceleration_rad_s2(
        &self,
        rates_rad_s: &Vector3<f64>,
        moment_n_m: Vector3<f64>,
    ) -> Vector3<f64> {
        let momentum = self.tensor_kg_m2 * rates_rad_s;
        self.inverse * (moment_n_m - rates_rad_s.cross(&momentum))
    }
}

/// Fault of a tensor so large or small that its moments or its inverse are not numbers.
const UNKNOWN: &str = "is too small or too large to be computed with; give the moments in kg-m^2";
/// Iterations of the search for eigenvalues; three by three take fewer than ten.
const ITERATIONS: usize = 100;

/// Eigenvalues of a symmetric matrix, ascending; `None` where they are not found.
fn principal_moments(tensor: &Matrix3<f64>) -> Option<[f64; 3]> {
    let found = SymmetricEigen::try_new(*tensor, f64::EPSILON, ITERATIONS)?;
    let mut moments: [f64; 3] = found.eigenvalues.into();
    moments.sort_unstable_by(f64::total_cmp);
    Some(moments)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_body_about_its_axes_spins_steadily() {
        let inertia =
            Inertia::try_new([[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.5]]).unwrap();
        assert_eq!(
            inertia.acceleration_rad_s2(&Vector3::new(3.0, 0.0, 0.0), Vector3::zeros()),
            Vector3::zeros()
        );
        // ṗ = (I_y − I_z) q r / I_x = −0.5 · 2 · 3, q̇ = (I_z − I_x) r p / I_y, with p = 0; plus a moment of 1 about x
        let [p, q, r] = inertia
            .acceleration_rad_s2(&Vector3::new(0.0, 2.0, 3.0), Vector3::x())
            .into();
        assert!((p + 2.0).abs() < 1e-15 && q.abs() < 1e-15 && r.abs() < 1e-15);
    }

    #[test]
    fn the_inverse_is_the_inverse_with_products_of_inertia() {
        let m = [[3.0, -0.2, 0.1], [-0.2, 4.0, 0.3], [0.1, 0.3, 5.0]];
        let inertia = Inertia::try_new(m).unwrap();
        let product = inertia.tensor_kg_m2 * inertia.inverse;
        assert!((product - Matrix3::identity()).amax() < 1e-15);
    }

    #[test]
    fn principal_moments_of_a_turned_body() {
        // In the plane x, y: 4 ± 1 with equal diagonal and off-diagonal 1.
        let [low, middle, high] =
            principal_moments(&[[4.0, 1.0, 0.0], [1.0, 4.0, 0.0], [0.0, 0.0, 4.5]].into()).unwrap();
        assert!(
            (low - 3.0).abs() < 1e-14 && (middle - 4.5).abs() < 1e-14 && (high - 5.0).abs() < 1e-14
        );
    }

    #[test]
    fn what_no_body_can_have_is_refused() {
        let said = |m: [[f64; 3]; 3]| Inertia::try_new(m).unwrap_err().join("\n");
        assert!(said([[0.0; 3]; 3]).contains("no inertia at all"));
        let diagonal = |x: f64, y: f64, z: f64| [[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]];
        assert!(said(diagonal(1.0, 1.0, 2.5)).contains("at most 2.000000 kg-m^2"));
        assert!(said(diagonal(1.0, -1.0, 1.0)).contains("got -1 kg-m^2 about y"));
        let mut skewed = diagonal(1.0, 1.0, 1.0);
        skewed[0][1] = 0.2;
        assert!(said(skewed).contains("both must be the same"));
        let mut too_large = diagonal(1.0, 1.0, 1.0);
        (too_large[0][1], too_large[1][0]) = (1.5, 1.5);
        assert!(said(too_large).contains("must be above 0"));
        for wild in [f64::NAN, f64::INFINITY] {
            assert!(said(diagonal(1.0, 1.0, wild)).contains("about z"));
            let mut beside = diagonal(1.0, 1.0, 1.0);
            (beside[0][1], beside[1][0]) = (wild, wild);
            assert!(said(beside).contains("both must be the same"));
        }
        // determinants of 1e-600 and 1e600 are not numbers
        for size in [1e-200, 1e200] {
            assert!(said(diagonal(size, size, size)).contains("too small or too large"));
        }
        // A flat disc is at the limit.
        assert!(Inertia::try_new(diagonal(2.0, 1.0, 1.0)).is_ok());
    }
}
