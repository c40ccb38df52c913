//! A charring solid that is made up: balances, order, outcomes and bounds of work in benign and in bad conditions.

use ablation::contact::Joint;
use ablation::environment::{Environment, Heating};
use ablation::fault::Fault;
use ablation::gas::{Gas, GasRow};
use ablation::geometry::Geometry;
use ablation::grid::Resolution;
use ablation::march::{Response, Run};
use ablation::reaction::Reaction;
use ablation::settings::{Outcome, Settings, Until};
use ablation::solid::{Solid, State};
use ablation::stack::{Back, Layer, Material, Pyrolysis, Stack};
use ablation::surface::{Surface, WallRow, WallTable};
use ablation::wall::WallSettings;
use core::ops::ControlFlow;

fn state(density_kg_m3: f64, formation_j_kg: f64) -> State {
    State {
        density_kg_m3,
        formation_j_kg,
        specific_heat: vec![[300.0, 1000.0], [2000.0, 2000.0]],
        conductivity: vec![[300.0, 0.4], [2000.0, 0.8]],
        emissivity: 0.85,
        absorptivity: 0.85,
    }
}

fn wall_table() -> WallTable {
    let rows = [1e3, 1e5].into_iter().flat_map(|pressure_pa| {
        [0.0, 1.0].into_iter().flat_map(move |gas_rate| {
            [300.0, 1000.0, 3000.0].map(|temperature_k| WallRow {
                pressure_pa,
                gas_rate,
                char_rate: 0.17 * (1.0 - 0.5 * gas_rate) * temperature_k / 3000.0,
                temperature_k,
                enthalpy_j_kg: 1200.0 * temperature_k - 1e6,
            })
        })
    });
    WallTable::try_new(rows.collect()).unwrap()
}

fn charring() -> Material {
    let gas = [300.0, 4000.0].map(|temperature_k| GasRow {
        pressure_pa: 1e5,
        temperature_k,
        molar_mass_kg_mol: 0.02,
        enthalpy_j_kg: 3000.0 * temperature_k - 6e6,
        viscosity_pa_s: 4e-5,
    });
    let reaction =
        |rate, activation| Reaction::of_component([40.0, 0.0], rate, activation, 3.0, 350.0);
    let pyrolysis = Pyrolysis {
        reactions: vec![reaction(1e4, 8500.0), reaction(4e8, 20_000.0)],
        gas: Gas::try_new(gas.to_vec()).unwrap(),
        permeability_m2: [1e-11, 2e-11],
    };
    let solid = Solid::try_new(state(300.0, -1e6), state(220.0, 0.0)).unwrap();
    let surface = Surface::Reacting(wall_table());
    Material::try_new("made up".to_string(), solid, Some(pyrolysis), surface).unwrap()
}

fn stack(thickness_m: f64, geometry: Geometry) -> Stack {
    let metal = Solid::inert(State {
        specific_heat: vec![[300.0, 900.0]],
        conductivity: vec![[300.0, 150.0]],
        ..state(2700.0, 0.0)
    });
    let metal = Material::try_new(
        "metal".to_string(),
        metal.unwrap(),
        None,
        Surface::Inert(vec![[0.0, 0.0], [1000.0, 1e6]]),
    );
    let layers = vec![
        Layer {
            material: charring(),
            thickness_m,
            joint: Joint::Perfect,
        },
        Layer {
            material: metal.unwrap(),
            thickness_m: 0.002,
            joint: Joint::Contact {
                resistance_m2k_w: 1e-4,
            },
        },
    ];
    Stack::try_new(layers, geometry, Back::Adiabatic).unwrap()
}

fn heating(transfer_kg_m2s: f64, recovery_j_kg: f64, chemistry: bool) -> Heating {
    Heating {
        pressure_pa: 2e4,
        transfer_kg_m2s,
        recovery_j_kg,
        radiative_w_m2: 1e5,
        chemistry,
    }
}

/// A pulse of 20 s, and rest.
fn pulse() -> Environment {
    Environment::heated(&[
        (0.0, heating(0.0, 0.0, true)),
        (5.0, heating(0.1, 1.5e7, true)),
        (
            20.0,
            Heating {
                radiative_w_m2: 0.0,
                ..heating(0.0, 0.0, false)
            },
        ),
    ])
    .unwrap()
}

fn settings(until: Until) -> Settings {
    Settings {
        initial_temperature_k: 290.0,
        wall: WallSettings {
            blowing: 0.5,
            recession: true,
            sink_temperature_k: 250.0,
        },
        until,
        output_step_s: None,
        depths_m: vec![0.004],
        resolution: Resolution::default(),
        tolerance_k: 0.1,
        most_steps: 20_000,
    }
}

fn respond(stack: &Stack, environment: &Environment, settings: &Settings) -> Response {
    let run = Run::try_new(stack, environment, settings).unwrap();
    run.response(|_| ControlFlow::Continue(()))
}

#[test]
fn mass_and_energy_are_closed_in_every_geometry() {
    for geometry in [
        Geometry::Planar,
        Geometry::Cylindrical { radius_m: 0.1 },
        Geometry::Spherical { radius_m: 0.1 },
    ] {
        let until = Until::Cooled {
            layer: 0,
            at_most_s: 5000.0,
        };
        let response = respond(&stack(0.03, geometry), &pulse(), &settings(until));
        let account = response.account;
        assert_eq!(response.outcome, Outcome::Cooled, "{geometry:?}");
        assert!(account.energy_imbalance().abs() < 1e-8, "{account:?}");
        assert!(account.mass_imbalance().abs() < 1e-8, "{account:?}");
        assert!(account.gas_kg_m2 > 0.1 && account.char_kg_m2 > 0.05);
        assert!(account.steps < 600, "{account:?}");
    }
}

#[test]
fn finer_cells_and_steps_lead_to_one_answer() {
    let at = |cells: usize, tolerance_k: f64| {
        let mut settings = settings(Until::Time(20.0));
        settings.resolution.cells = cells;
        settings.tolerance_k = tolerance_k;
        let response = respond(&stack(0.03, Geometry::Planar), &pulse(), &settings);
        response.history.rows.last().unwrap().depths_k[0]
    };
    let [coarse, middle, fine] = [48, 96, 192].map(|cells| at(cells, 1e-3));
    let ratio = (coarse - middle) / (middle - fine);
    assert!((3.0..5.5).contains(&ratio), "{coarse} {middle} {fine}");
    // The default settings are within a kelvin of all that.
    assert!((at(64, 0.1) - fine).abs() < 1.0);
}

#[test]
fn layer_that_burns_through_says_when() {
    let until = Until::Time(20.0);
    let thin = respond(&stack(2e-4, Geometry::Planar), &pulse(), &settings(until));
    assert_eq!(thin.outcome, Outcome::BurntThrough);
    assert!((1.0..15.0).contains(&thin.end_s), "{}", thin.end_s);
    let film = respond(&stack(1e-6, Geometry::Planar), &pulse(), &settings(until));
    assert_eq!(film.outcome, Outcome::BurntThrough);
    assert!(film.end_s < thin.end_s);
}

#[test]
fn bad_conditions_are_answered_in_bounded_work() {
    let rows = |rows: &[(f64, Heating)]| Environment::heated(rows).unwrap();
    for environment in [
        // No transfer with chemistry on, and none at all.
        rows(&[
            (0.0, heating(0.0, 1e7, true)),
            (50.0, heating(0.0, 0.0, true)),
        ]),
        // A boundary layer that cools, and one far hotter than the table of the wall.
        rows(&[
            (0.0, heating(0.1, -4e5, true)),
            (50.0, heating(0.1, -4e5, true)),
        ]),
        rows(&[
            (0.0, heating(0.3, 6e7, true)),
            (9.0, heating(0.3, 6e7, true)),
        ]),
        // A jump within a microsecond.
        rows(&[
            (0.0, heating(0.0, 0.0, true)),
            (1.0, heating(0.0, 0.0, true)),
            (1.000_001, heating(0.2, 2e7, true)),
            (9.0, heating(0.2, 2e7, false)),
        ]),
    ] {
        let response = respond(
            &stack(0.05, Geometry::Planar),
            &environment,
            &settings(Until::Time(60.0)),
        );
        let account = response.account;
        assert_eq!(response.outcome, Outcome::Finished, "{environment:?}");
        assert!(account.steps + account.taken_back < 3000, "{account:?}");
        assert!(account.energy_imbalance().abs() < 1e-8, "{account:?}");
    }
}

#[test]
fn gas_that_would_cool_the_wall_below_nothing_ends_the_run() {
    // The wall's gas of the table has −1e6 J/kg at 0 K.
    let cold = heating(0.1, -3e6, true);
    let environment = Environment::heated(&[(0.0, cold), (50.0, cold)]).unwrap();
    let until = settings(Until::Time(60.0));
    let response = respond(&stack(0.05, Geometry::Planar), &environment, &until);
    assert_eq!(response.outcome, Outcome::NotSettled);
    assert!(response.account.taken_back < 100);
}

#[test]
fn two_days_take_few_steps_more_than_an_hour() {
    let long = respond(
        &stack(0.03, Geometry::Planar),
        &pulse(),
        &settings(Until::Time(162_000.0)),
    );
    assert_eq!(long.outcome, Outcome::Finished);
    assert!(long.account.steps < 700, "{:?}", long.account);
    // The metal ends at the sink's temperature.
    let last = long.history.rows.last().unwrap();
    assert!(
        (last.behind_k[1] - 250.0).abs() < 0.1,
        "{}",
        last.behind_k[1]
    );
}

#[test]
fn watcher_and_limit_of_work_end_a_run() {
    let (stack, environment) = (stack(0.03, Geometry::Planar), pulse());
    let mut wanted = settings(Until::Time(20.0));
    let run = Run::try_new(&stack, &environment, &wanted).unwrap();
    let stopped = run.response(|time| match time < 2.0 {
        true => ControlFlow::Continue(()),
        false => ControlFlow::Break(()),
    });
    assert_eq!(stopped.outcome, Outcome::Stopped);
    assert!((2.0..5.0).contains(&stopped.end_s));
    wanted.most_steps = 10;
    let ended = respond(&stack, &environment, &wanted);
    assert_eq!(
        (ended.outcome, ended.account.steps <= 10),
        (Outcome::OutOfWork, true)
    );
}

#[test]
fn numbers_beyond_their_ranges_are_refused_by_name() {
    let said = |fault: Fault| fault.to_string();
    let negative = Environment::heated(&[(0.0, heating(-0.1, 0.0, true))]).unwrap_err();
    assert!(said(negative).starts_with("environment: CH_kg_m2s: got -0.1, must be 0 to"));
    let late = [
        (1.0, heating(0.1, 0.0, true)),
        (0.5, heating(0.1, 0.0, true)),
    ];
    let unsorted = said(Environment::heated(&late).unwrap_err());
    assert_eq!(
        unsorted,
        "environment: t_s: row 2 is not above the one before"
    );
    let none = said(Environment::heated(&[(0.0, heating(f64::NAN, 0.0, true))]).unwrap_err());
    assert_eq!(none, "environment: CH_kg_m2s: row 1 holds no finite number");
    let missing = WallTable::try_new(vec![
        WallRow {
            pressure_pa: 1e5,
            gas_rate: 0.0,
            char_rate: 0.1,
            temperature_k: 300.0,
            enthalpy_j_kg: 0.0,
        },
        WallRow {
            pressure_pa: 1e5,
            gas_rate: 0.0,
            char_rate: 0.1,
            temperature_k: 400.0,
            enthalpy_j_kg: 0.0,
        },
        WallRow {
            pressure_pa: 1e5,
            gas_rate: 1.0,
            char_rate: 0.1,
            temperature_k: 300.0,
            enthalpy_j_kg: 0.0,
        },
    ]);
    assert!(said(missing.unwrap_err()).starts_with("wall: T_K: not every combination"));
    let stack = stack(0.03, Geometry::Planar);
    let mut wanted = settings(Until::Time(20.0));
    wanted.initial_temperature_k = 0.0;
    let environment = pulse();
    let refused = Run::try_new(&stack, &environment, &wanted).err().unwrap();
    assert!(said(refused).starts_with("settings: initial_temperature_k: got 0, must be 1 to"));
    assert!(Stack::try_new(vec![], Geometry::Planar, Back::Adiabatic).is_err());
    let thick = Stack::try_new(
        stack.layers,
        Geometry::Spherical { radius_m: 0.01 },
        Back::Adiabatic,
    );
    assert!(said(thick.unwrap_err()).starts_with("stack: radius_m: got 0.01, must be 0.032"));
}
