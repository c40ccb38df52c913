//! Flights drawn at random by a fixed seed.

use msape::flight::mission::Start;
use msape::flight::numbers::Numbers;
use msape::planet::geodetic::Geodetic;
use msape::planet::horizon::Velocity;
use msape::problem::FlightProblem;
use msape::{Case, Library};
use numerics::scalar::Scalar;
use std::sync::LazyLock;

static LIBRARY: LazyLock<Library> = LazyLock::new(|| Library::builtin().unwrap());

/// Drag by Mach number, radiation, wind: everything that may affect lanes individually.
pub const EVERYTHING: &str = r#"
schema = "msape/1"
name = "everything"
[entry]
planet = "earth-msape"
atmosphere = "us-1976"
altitude_m = 125000.0
latitude_deg = 33.0
longitude_deg = 246.0
speed_m_s = 12000.0
flight_path_angle_deg = -8.0
azimuth_deg = 90.0
[wind]
table = [[0.0, 5.0, 1.0], [12000.0, 40.0, -3.0], [30000.0, 0.0, 0.0]]
[vehicle]
mass_kg = 46.0
reference_area_m2 = 0.51887
nose_radius_m = 0.2286
aerodynamics = "mmeev-60"
[heating]
radiative = "tauber-sutton"
"#;

pub fn problem(text: &str) -> FlightProblem {
    FlightProblem::check(&Case::from_text(text).unwrap(), &LIBRARY).unwrap()
}

/// Numbers between 0 and 1 by a fixed seed, after Steele, Lea and Flood.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Number of parameters from which a random flight is drawn: entry state and vehicle.
pub const PARAMETERS: usize = 14;

pub fn drawn(random: &mut Random) -> [f64; PARAMETERS] {
    [
        random.within(100e3, 130e3),
        random.within(-1.0, 1.0),
        random.within(-3.0, 3.0),
        random.within(10e3, 14e3),
        random.within(-0.4, -0.12),
        random.within(0.1, 6.0),
        random.within(30.0, 120.0),
        random.within(0.3, 1.5),
        random.within(0.15, 0.6),
        random.within(0.9, 1.1),
        random.within(0.8, 1.2),
        random.within(0.5, 1.5),
        random.within(0.9, 1.4),
        random.within(0.9, 1.4),
    ]
}

pub fn numbers<S: Scalar>(problem: &FlightProblem, parameters: [S; PARAMETERS]) -> Numbers<S> {
    let [
        h,
        lat,
        lon,
        v,
        gamma,
        psi,
        mass,
        area,
        nose,
        drag,
        density,
        wind,
        convective,
        radiative,
    ] = parameters;
    let position = Geodetic {
        altitude_m: h,
        latitude_rad: lat,
        longitude_rad: lon,
    };
    let velocity = Velocity {
        speed_m_s: v,
        flight_path_angle_rad: gamma,
        azimuth_rad: psi,
    };
    Numbers {
        start: Start::relative(&problem.mission.planet, &position, velocity),
        mass_kg: mass,
        reference_area_m2: area,
        nose_radius_m: nose,
        drag_factor: drag,
        density_factor: density,
        wind_factor: wind,
        convective_factor: convective,
        radiative_factor: radiative,
        ..Numbers::constant(&Numbers::of(&problem.mission, &problem.body))
    }
}
