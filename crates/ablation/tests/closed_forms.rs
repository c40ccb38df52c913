//! Conduction and recession beside closed forms: slab, cylinder, sphere, contact, a half space that recedes.

use ablation::contact::Joint;
use ablation::environment::{Environment, Heating, Held};
use ablation::geometry::Geometry;
use ablation::grid::Resolution;
use ablation::history::Sample;
use ablation::march::{Response, Run};
use ablation::settings::{Outcome, Settings, Until};
use ablation::solid::{Solid, State};
use ablation::stack::{Back, Layer, Material, Stack};
use ablation::surface::Surface;
use ablation::wall::WallSettings;
use core::ops::ControlFlow;
use numerics::{math, root};

/// Heat capacity of the gas at the wall, J/(kg K): a film of h W/(m² K) is a transfer of h / 1000.
const GAS_J_KGK: f64 = 1000.0;

/// A solid of constant properties, black to the shock layer and without emission.
fn material(density_kg_m3: f64, specific_heat: f64, conductivity: f64) -> Material {
    let state = State {
        density_kg_m3,
        formation_j_kg: 0.0,
        specific_heat: vec![[300.0, specific_heat]],
        conductivity: vec![[300.0, conductivity]],
        emissivity: 0.0,
        absorptivity: 1.0,
    };
    let gas = vec![[0.0, 0.0], [1000.0, 1000.0 * GAS_J_KGK]];
    let solid = Solid::inert(state).unwrap();
    Material::try_new("constant".to_string(), solid, None, Surface::Inert(gas)).unwrap()
}

fn layer(material: Material, thickness_m: f64, joint: Joint) -> Layer {
    Layer {
        material,
        thickness_m,
        joint,
    }
}

fn settings(until_s: f64, depths_m: &[f64], cells: usize) -> Settings {
    Settings {
        initial_temperature_k: 300.0,
        wall: WallSettings {
            blowing: 0.0,
            recession: false,
            sink_temperature_k: 300.0,
        },
        until: Until::Time(until_s),
        output_step_s: None,
        depths_m: depths_m.to_vec(),
        resolution: Resolution {
            cells,
            stretch: 4.0,
            cells_behind: cells,
        },
        tolerance_k: 2e-6,
        most_steps: 1_000_000,
    }
}

fn respond(stack: &Stack, environment: &Environment, settings: &Settings) -> Response {
    let run = Run::try_new(stack, environment, settings).unwrap();
    let response = run.response(|_| ControlFlow::Continue(()));
    assert_eq!(response.outcome, Outcome::Finished);
    assert!(
        response.account.energy_imbalance().abs() < 1e-8,
        "{:?}",
        response.account
    );
    response
}

fn last(response: &Response) -> &Sample {
    response.history.rows.last().unwrap()
}

/// Film of a gas at 1300 K, W/(m² K), from the start.
fn film(h: f64, until_s: f64) -> Environment {
    let heating = Heating {
        pressure_pa: 1e5,
        transfer_kg_m2s: h / GAS_J_KGK,
        recovery_j_kg: 1300.0 * GAS_J_KGK,
        radiative_w_m2: 0.0,
        chemistry: true,
    };
    Environment::heated(&[(0.0, heating), (until_s, heating)]).unwrap()
}

/// Errors on three grids, each twice as fine: the order is two, and what is left after extrapolation is small.
fn second_order(exact: f64, scale: f64, at: impl Fn(usize) -> f64) {
    let [coarse, middle, fine] = [24, 48, 96].map(&at);
    let ratio = (coarse - exact) / (middle - exact);
    let extrapolated = fine + (fine - middle) / 3.0;
    let before = middle + (middle - coarse) / 3.0;
    // Once more, by the fourth order of what the first leaves.
    let left = extrapolated + (extrapolated - before) / 15.0 - exact;
    let said = format!("{ratio}: {coarse} {middle} {fine} {exact}, {left} of {scale}");
    assert!((3.6..4.5).contains(&ratio), "{said}");
    assert!(left.abs() < 1e-6 * scale, "{said}");
}

const RHO: f64 = 1000.0;
const C: f64 = 1000.0;
const K: f64 = 1.0;
/// Radius or thickness, m.
const L: f64 = 0.02;
/// Film, W/(m² K): a Biot number of 2.
const H: f64 = 100.0;
/// Time, s: a Fourier number of 0.25.
const T: f64 = 100.0;

/// First roots of f, each between two places.
fn roots(f: impl Fn(f64) -> f64, between: impl Fn(usize) -> [f64; 2]) -> Vec<f64> {
    (0..12)
        .map(|n| root::brent(&f, between(n)[0], between(n)[1], 1e-14).unwrap())
        .collect()
}

/// Temperature at the insulated back or center and at the surface of a body in a film, from ζ, C and the surface's factor.
fn of_series(terms: impl Iterator<Item = (f64, f64, f64)>) -> [f64; 2] {
    let fourier = K / (RHO * C) * T / (L * L);
    let sums = terms.fold([0.0; 2], |sum, (zeta, c, surface)| {
        let term = c * math::exp(-zeta * zeta * fourier);
        [sum[0] + term, sum[1] + term * surface]
    });
    sums.map(|theta| 1300.0 - 1000.0 * theta)
}

fn body(geometry: Geometry, cells: usize) -> [f64; 2] {
    let layers = vec![layer(material(RHO, C, K), L, Joint::Perfect)];
    let stack = Stack::try_new(layers, geometry, Back::Adiabatic).unwrap();
    let response = respond(&stack, &film(H, T), &settings(T, &[], cells));
    [last(&response).behind_k[0], last(&response).wall_k]
}

fn body_is_second_order(geometry: Geometry, exact: [f64; 2]) {
    for (side, exact) in exact.into_iter().enumerate() {
        second_order(exact, 1000.0, |cells| body(geometry, cells)[side]);
    }
}

#[test]
fn slab_in_a_film() {
    // ζ tan ζ = Bi; C = 4 sin ζ / (2 ζ + sin 2ζ)
    let biot = H * L / K;
    let zetas = roots(
        |z| z * math::sin(z) - biot * math::cos(z),
        |n| [n as f64 * math::PI, (n as f64 + 0.5) * math::PI],
    );
    let terms = zetas.iter().map(|z| {
        let c = 4.0 * math::sin(*z) / (2.0 * z + math::sin(2.0 * z));
        (*z, c, math::cos(*z))
    });
    body_is_second_order(Geometry::Planar, of_series(terms));
}

#[test]
fn cylinder_in_a_film() {
    // ζ J₁ = Bi J₀; C = 2 J₁ / (ζ (J₀² + J₁²)); Bi = h R / k
    let biot = H * L / K;
    let zero = |n: usize| {
        let pi = n as f64 * math::PI;
        root::brent(libm::j1, pi, pi + math::FRAC_PI_2, 1e-14).unwrap()
    };
    let zeros: Vec<f64> = (0..13)
        .map(|n| if n == 0 { 1e-9 } else { zero(n) })
        .collect();
    let zetas = roots(
        |z| z * libm::j1(z) - biot * libm::j0(z),
        |n| [zeros[n], zeros[n + 1]],
    );
    let terms = zetas.iter().map(|z| {
        let (j0, j1) = (libm::j0(*z), libm::j1(*z));
        (*z, 2.0 * j1 / (z * (j0 * j0 + j1 * j1)), j0)
    });
    body_is_second_order(Geometry::Cylindrical { radius_m: L }, of_series(terms));
}

#[test]
fn sphere_in_a_film() {
    // 1 − ζ cot ζ = Bi; C = 4 (sin ζ − ζ cos ζ) / (2 ζ − sin 2ζ)
    let biot = H * L / K;
    let zetas = roots(
        |z| (1.0 - biot) * math::sin(z) - z * math::cos(z),
        |n| [n as f64 * math::PI + 1e-3, (n as f64 + 1.0) * math::PI],
    );
    let terms = zetas.iter().map(|z| {
        let (sin, cos) = math::sin_cos(*z);
        let c = 4.0 * (sin - z * cos) / (2.0 * z - math::sin(2.0 * z));
        (*z, c, sin / z)
    });
    body_is_second_order(Geometry::Spherical { radius_m: L }, of_series(terms));
}

#[test]
fn flux_into_a_slab_settles_on_its_parabola() {
    // T = T₀ + q t/(ρ c L) + q L/(3 k) at the heated side
    let heating = Heating {
        pressure_pa: 0.0,
        transfer_kg_m2s: 0.0,
        recovery_j_kg: 0.0,
        radiative_w_m2: 5000.0,
        chemistry: false,
    };
    let until_s = 4000.0;
    let environment = Environment::heated(&[(0.0, heating), (until_s, heating)]).unwrap();
    let exact = 300.0 + 5000.0 * until_s / (RHO * C * L) + 5000.0 * L / K / 3.0;
    second_order(exact, 1000.0, |cells| {
        let layers = vec![layer(material(RHO, C, K), L, Joint::Perfect)];
        let stack = Stack::try_new(layers, Geometry::Planar, Back::Adiabatic).unwrap();
        last(&respond(
            &stack,
            &environment,
            &settings(until_s, &[], cells),
        ))
        .wall_k
    });
}

/// A wall held at a temperature, and moved inwards.
fn held(temperature_k: f64, recession_m_s: f64) -> Environment {
    let held = Held {
        temperature_k,
        pressure_pa: 0.0,
        recession_m_s,
    };
    Environment::held(&[(0.0, held)]).unwrap()
}

#[test]
fn contact_and_layers_in_series_carry_one_flux() {
    // q = ΔT / (L₁/k₁ + R + L₂/k₂) = 700 / (0.02/1 + 0.01 + 0.03/0.5) = 7777.8 W/m² at the end
    let joint = Joint::Contact {
        resistance_m2k_w: 0.01,
    };
    let layers = vec![
        layer(material(RHO, C, K), 0.02, Joint::Perfect),
        layer(material(500.0, C, 0.5), 0.03, joint),
    ];
    let back = Back::Held {
        temperature_k: 300.0,
    };
    let stack = Stack::try_new(layers, Geometry::Planar, back).unwrap();
    let wanted = settings(60_000.0, &[0.01, 0.02, 0.035], 12);
    let response = respond(&stack, &held(1000.0, 0.0), &wanted);
    let q = 700.0 / 0.09;
    let sample = last(&response);
    for (got, exact) in [
        (sample.depths_k[0], 1000.0 - 0.01 * q),
        (sample.behind_k[0], 1000.0 - 0.02 * q),
        (sample.depths_k[2], 300.0 + q * 0.015 / 0.5),
        (sample.behind_k[1], 300.0),
    ] {
        assert!((got - exact).abs() < 1e-6 * 700.0, "{got} {exact}");
    }
}

#[test]
fn gap_and_back_radiate_one_flux() {
    // The wall at 1000 K, a gap of emissivity 0.8, a back of emissivity 0.5 and a film of 10 W/(m² K) to 250 K.
    let joint = Joint::Gap {
        conductance_w_m2k: 0.0,
        emissivity: 0.8,
    };
    let layers = vec![
        layer(material(RHO, C, K), 0.01, Joint::Perfect),
        layer(material(500.0, C, 0.5), 0.01, joint),
    ];
    let back = Back::Exposed {
        temperature_k: 250.0,
        emissivity: 0.5,
        film_w_m2k: 10.0,
    };
    let stack = Stack::try_new(layers, Geometry::Planar, back).unwrap();
    let response = respond(&stack, &held(1000.0, 0.0), &settings(20_000.0, &[], 12));
    let [front, end] = [last(&response).behind_k[0], last(&response).behind_k[1]];
    let black = |t: f64| 5.670_374_419e-8 * math::powi(t, 4);
    let q = (1000.0 - front) / 0.01;
    let out = 0.5 * (black(end) - black(250.0)) + 10.0 * (end - 250.0);
    assert!((q - out).abs() < 1e-5 * q, "{q} {out}");
    let behind = end + q * 0.01 / 0.5;
    let across = 0.8 * (black(front) - black(behind));
    assert!((q - across).abs() < 1e-5 * q, "{q} {across}");
}

#[test]
fn half_space_that_recedes_at_constant_speed() {
    // θ = ½ [erfc((ξ + v t)/(2 √(α t))) + exp(−v ξ/α) erfc((ξ − v t)/(2 √(α t)))], ξ = x − v t
    let (v, until_s, xi) = (1e-4, 60.0, 0.004);
    let alpha = K / (RHO * C);
    let passed = v * until_s;
    let root = 2.0 * (alpha * until_s).sqrt();
    let erfc = |x: f64| 1.0 - math::erf(x);
    let moved = math::exp(-v * xi / alpha) * erfc((xi - passed) / root);
    let exact = 300.0 + 500.0 * (erfc((xi + passed) / root) + moved);
    second_order(exact, 1000.0, |cells| {
        // Deep enough that nothing arrives at its back.
        let layers = vec![layer(material(RHO, C, K), 0.08, Joint::Perfect)];
        let stack = Stack::try_new(layers, Geometry::Planar, Back::Adiabatic).unwrap();
        let wanted = settings(until_s, &[passed + xi], 4 * cells);
        let response = respond(&stack, &held(1300.0, v), &wanted);
        let sample = last(&response);
        assert!((sample.recession_m - passed).abs() < 1e-12);
        assert!(response.account.mass_imbalance().abs() < 1e-8);
        sample.depths_k[0]
    });
}
