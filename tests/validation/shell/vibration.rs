//! Natural frequencies.

use super::*;

#[test]
fn clamped_circular_plate_vibrates_as_in_leissa() {
    let t = 1e-3;
    // λ² of Leissa, NASA SP-160, Table 2.1; shear and rotary inertia reduce it by 1e-5 at this thickness
    for (harmonic, parameter) in [(0, 10.2158), (1, 21.26), (2, 34.88), (3, 51.04)] {
        let shell = plate(t, 1);
        let exact = parameter * (shell.bending() / (DENSITY * shell.thickness)).sqrt() / (2.0 * PI);
        let name = format!("plate, clamped: frequency, {harmonic} nodal diameters");
        let (error, _) = row(&name, MESHES, exact, |elements| {
            plate(t, elements).frequency_hz(harmonic, [None, CLAMPED])
        });
        // half a unit of the last printed digit is 2e-4 of 34.88; 51.04 is 51.03 to four digits
        assert!(error < 4e-4, "{error:.1e}");
    }
    let thin = 2e-4;
    // the roots of J_n(λ) I_n'(λ) = J_n'(λ) I_n(λ), more accurate than the printed digits
    for (harmonic, root) in [(0, 3.196_220_617), (1, 4.610_899_879), (2, 5.905_678_236)] {
        let parameter: f64 = root * root;
        let shell = plate(thin, 1);
        let exact = parameter * (shell.bending() / (DENSITY * shell.thickness)).sqrt() / (2.0 * PI);
        let name = format!("plate, clamped: the same, exact root, n = {harmonic}");
        let (error, order) = row(&name, [2, 4, 8, 16], exact, |elements| {
            plate(thin, elements).frequency_hz(harmonic, [None, CLAMPED])
        });
        // conditions on the axis keep n ≥ 1 below the full fourth order on coarse meshes
        assert!(error < 1e-4 && order > 3.0, "{error:.1e}, {order:.2}");
    }
}

/// Lowest frequency of a cylinder between shear diaphragms in the theory of the model, exactly: the five amplitudes
/// give a 5 by 5 matrix; its lowest eigenvalue by inverse iteration.
fn cylinder_exact_hz(length: f64, t: f64, m: u32, n: u32) -> f64 {
    let shell = cylinder(length, t, 1);
    let wall = shell.model.walls[0];
    let c = wall.section.stiffness();
    let (a, d, s) = (c.membrane_n_m, c.bending_nm, c.shear_n_m);
    let (k, n) = (f64::from(m) * PI / length, f64::from(n));
    let half = (1.0 - NU) / 2.0;
    // u cos kx, v sin kx, w sin kx, β cos kx, φ sin kx; R = 1
    let e_s = [-k, 0.0, 0.0, 0.0, 0.0];
    let e_t = [0.0, n, 1.0, 0.0, 0.0];
    let g = [-n, k, 0.0, 0.0, 0.0];
    let k_s = [0.0, 0.0, 0.0, -k, 0.0];
    let k_t = [0.0, 0.0, 0.0, 0.0, n];
    let k_st = [n / 2.0, k / 2.0, 0.0, -n, k];
    let g_s = [0.0, 0.0, k, 1.0, 0.0];
    let g_t = [0.0, -1.0, -n, 0.0, 1.0];
    let mut stiffness = [[0.0; 5]; 5];
    let mut add = |p: &[f64; 5], q: &[f64; 5], c: f64| {
        for i in 0..5 {
            for j in 0..5 {
                stiffness[i][j] += 0.5 * c * (p[i] * q[j] + q[i] * p[j]);
            }
        }
    };
    for (p, q, c) in [
        (&e_s, &e_s, a),
        (&e_t, &e_t, a),
        (&e_s, &e_t, 2.0 * a * NU),
        (&g, &g, a * half),
        (&k_s, &k_s, d),
        (&k_t, &k_t, d),
        (&k_s, &k_t, 2.0 * d * NU),
        (&k_st, &k_st, d * half),
        (&g_s, &g_s, s),
        (&g_t, &g_t, s),
    ] {
        add(p, q, c);
    }
    let ArealMass {
        mass_kg_m2,
        rotary_kg,
    } = wall.areal;
    let mass = [mass_kg_m2, mass_kg_m2, mass_kg_m2, rotary_kg, rotary_kg];
    let mut x = [1.0, 1.1, 0.9, 1.2, 0.8];
    let mut value = 0.0;
    for _ in 0..200 {
        let mut y = [0.0; 5];
        for i in 0..5 {
            y[i] = mass[i] * x[i];
        }
        gauss(stiffness, &mut y);
        let norm = (0..5).map(|i| mass[i] * y[i] * y[i]).sum::<f64>().sqrt();
        value = 1.0 / norm;
        x = y.map(|v| v / norm);
    }
    value.sqrt() / (2.0 * PI)
}

fn gauss(mut a: [[f64; 5]; 5], b: &mut [f64; 5]) {
    for i in 0..5 {
        let pivot = (i..5)
            .max_by(|&p, &q| a[p][i].abs().total_cmp(&a[q][i].abs()))
            .unwrap();
        a.swap(i, pivot);
        b.swap(i, pivot);
        for j in i + 1..5 {
            let f = a[j][i] / a[i][i];
            let upper = a[i];
            for (x, y) in a[j].iter_mut().zip(upper).skip(i) {
                *x -= f * y;
            }
            b[j] -= f * b[i];
        }
    }
    for i in (0..5).rev() {
        let sum: f64 = (i + 1..5).map(|k| a[i][k] * b[k]).sum();
        b[i] = (b[i] - sum) / a[i][i];
    }
}

const DIAPHRAGMS: [Option<Held>; 2] = [Some(Held::ByDiaphragm); 2];

#[test]
fn cylinder_between_diaphragms_vibrates_as_its_exact_solution() {
    let t = 0.01;
    for (length, harmonic) in [(2.0, 2), (2.0, 4), (2.0, 6), (1.0, 3), (4.0, 1)] {
        // the lowest frequency of a harmonic has one half-wave along the axis
        let exact = cylinder_exact_hz(length, t, 1, harmonic);
        let name = format!("cylinder, L/R {length}, R/t 100: frequency, n = {harmonic}");
        let found = row(&name, MESHES, exact, |elements| {
            cylinder(length, t, elements).frequency_hz(harmonic, DIAPHRAGMS)
        });
        fourth_order(found, 1e-5);
    }
}

/// Lowest ω² R² ρ (1 − ν²) / E of a cylinder between shear diaphragms after Flügge, in the form of Leissa, NASA SP-288:
/// Ω⁶ − K₂ Ω⁴ + K₁ Ω² − K₀ = 0, with λ = m π R / L and k = t² / 12 R².
fn fluegge(length: f64, t: f64, n: u32) -> f64 {
    let (l2, n2, k) = ((PI / length).powi(2), f64::from(n * n), t * t / 12.0);
    let sum = n2 + l2;
    let half = 0.5 * (1.0 - NU);
    let k2 = 1.0 + 0.5 * (3.0 - NU) * sum + k * sum * sum;
    let k1 =
        half * ((3.0 + 2.0 * NU) * l2 + n2 + sum * sum + (3.0 - NU) / (1.0 - NU) * k * sum.powi(3));
    let of_fluegge = 2.0 * (2.0 - NU) * l2 * n2 + n2 * n2
        - 2.0 * NU * l2.powi(3)
        - 6.0 * l2 * l2 * n2
        - 2.0 * (4.0 - NU) * l2 * n2 * n2
        - 2.0 * n2.powi(3);
    let k0 = half * ((1.0 - NU * NU) * l2 * l2 + k * sum.powi(4) + k * of_fluegge);
    // the lowest root lies far below the two others: Newton's method from zero increases monotonically to it
    let mut y = 0.0;
    for _ in 0..50 {
        let value = ((y - k2) * y + k1) * y - k0;
        let slope = (3.0 * y - 2.0 * k2) * y + k1;
        y -= value / slope;
    }
    y
}

#[test]
fn cylinders_vibrate_as_after_fluegge() {
    for (length, harmonic) in [
        (20.0, 1),
        (20.0, 2),
        (20.0, 3),
        (20.0, 4),
        (20.0, 5),
        (2.0, 4),
        (2.0, 6),
    ] {
        let hz = cylinder(length, 0.01, 40).frequency_hz(harmonic, DIAPHRAGMS);
        let ours = hz * 2.0 * PI * (DENSITY * (1.0 - NU * NU) / E).sqrt();
        let exact = fluegge(length, 0.01, harmonic).sqrt();
        let off = ours / exact - 1.0;
        println!(
            "cylinder, L/R {length}, R/t 100, n = {harmonic}: {ours:.6}, Fluegge {exact:.6}, {off:+.1e}"
        );
        // shear deformation and rotary inertia reduce it by about (n t / R)²: 4e-3 at n = 6, of which a part
        assert!(off.abs() < 1e-3);
    }
}
