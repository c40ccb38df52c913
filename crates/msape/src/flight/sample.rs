//! What a state means: the numbers of one instant of a flight.

use super::equations::{Equations, STATES, Surroundings};
use super::mission::Mission;
use super::motion::{Motion, head};
use super::trajectory::Trajectory;
use crate::heating::HeatFlux;
use crate::heating::pressure::Stream;
use crate::heating::wall::{ColdWall, Wall, radiating_temperature_k};
use crate::planet::geodetic::{Geodetic, great_circle_m};
use crate::planet::horizon::Horizon;
use numerics::math::RADIANS_PER_DEGREE;
use numerics::scalar::{Scalar, Single};

/// Standard acceleration of gravity, m/s²: the Earth g of loads.
pub const EARTH_G_M_S2: f64 = 9.80665;

/// What changes fast and is looked for at every step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Loads<S = f64> {
    /// Aerodynamic force over mass, Earth g.
    pub deceleration_earth_g: S,
    /// Dynamic pressure, Pa.
    pub dynamic_pressure_pa: S,
    /// Heat fluxes without margins.
    pub heat_flux: HeatFlux<S>,
}

impl<S: Scalar> Loads<S> {
    /// The loads under an aerodynamic force over mass, m/s².
    #[inline]
    pub fn new(point: &Equations<S>, around: &Surroundings<S>, deceleration_m_s2: S) -> Self {
        Loads {
            deceleration_earth_g: deceleration_m_s2 / EARTH_G_M_S2,
            dynamic_pressure_pa: around.density_kg_m3
                * 0.5
                * around.air_speed_m_s
                * around.air_speed_m_s,
            heat_flux: point.heat_flux(around),
        }
    }

    /// The loads of one lane.
    pub fn lane(&self, lane: usize) -> Loads<S::Lane> {
        Loads {
            deceleration_earth_g: self.deceleration_earth_g.lane(lane),
            dynamic_pressure_pa: self.dynamic_pressure_pa.lane(lane),
            heat_flux: HeatFlux {
                convective_w_m2: self.heat_flux.convective_w_m2.lane(lane),
                radiative_w_m2: self.heat_flux.radiative_w_m2.lane(lane),
            },
        }
    }
}

/// Angle of the relative velocity against the geodetic horizon at one state, rad.
pub fn flight_path_angle_rad<S: Scalar>(mission: &Mission, y: &[S; STATES]) -> S {
    let [x, y, z, v_x, v_y, v_z, ..] = *y;
    let horizon = mission.planet.horizon([x, y, z]);
    horizon.velocity([v_x, v_y, v_z]).flight_path_angle_rad
}

/// Pressure at the stagnation point at one state, Pa.
pub fn stagnation_pressure<S: Scalar>(equations: &Equations<S>, y: &[S; STATES]) -> S {
    let around = equations.surroundings(y);
    let air = equations.air(around.altitude_m);
    let stream = Stream {
        pressure_pa: air.pressure_pa,
        density_kg_m3: around.density_kg_m3,
        speed_m_s: around.air_speed_m_s,
        mach: around.air_speed_m_s / air.speed_of_sound_m_s,
    };
    equations.mission.heating.pressure.pressure_pa(&stream)
}

/// Mach number relative to the air at one state.
pub fn mach<S: Scalar>(equations: &Equations<S>, y: &[S; STATES]) -> S {
    let around = equations.surroundings(y);
    around.air_speed_m_s / equations.sound_m_s(around.altitude_m)
}

/// Temperature at which the stagnation point radiates away heat fluxes that carry their margins, K.
pub fn wall_temperature_k<S: Scalar>(
    mission: &Mission,
    margined: &HeatFlux<S>,
    air_speed_m_s: S,
) -> S {
    match mission.heating.options.wall {
        Wall::Cold => radiating_temperature_k(margined.total_w_m2(), mission.wall_emissivity),
        _ => mission.heating.gas.radiative_equilibrium_temperature_k(
            &ColdWall {
                convective_w_m2: margined.convective_w_m2,
                radiative_w_m2: margined.radiative_w_m2,
                speed_m_s: air_speed_m_s,
            },
            mission.wall_emissivity,
        ),
    }
}

/// Geodetic position of a state.
pub fn position<S: Scalar>(mission: &Mission, y: &[S; STATES]) -> Geodetic<S> {
    mission.planet.geodetic([y[0], y[1], y[2]])
}

/// Appends the row of one instant to a time history.
pub fn record<'a, const N: usize, S: Single>(
    trajectory: &mut Trajectory,
    motion: &impl Motion<'a, N, S>,
    t: S,
    state: &[S; N],
    start: &Geodetic<S>,
) {
    let equations = motion.point();
    let mission = equations.mission;
    let y = &head(state);
    let around = equations.surroundings(y);
    let air = equations.air(around.altitude_m);
    let Loads {
        deceleration_earth_g,
        dynamic_pressure_pa,
        heat_flux,
    } = motion.loads(t, state);
    let margined = mission.heating.margined(&heat_flux);
    let place = position(mission, y);
    let velocity = [y[3], y[4], y[5]];
    let horizon = Horizon::new(around.up);
    let [north_m_s, east_m_s, up_m_s] = horizon.parts(velocity);
    let relative = horizon.velocity(velocity);
    let [vx, vy, vz] = mission.planet.inertial_m_s([y[0], y[1], y[2]], velocity);
    let row = [
        t,
        around.altitude_m,
        place.latitude_rad / RADIANS_PER_DEGREE,
        place.longitude_rad / RADIANS_PER_DEGREE,
        relative.speed_m_s,
        relative.flight_path_angle_rad / RADIANS_PER_DEGREE,
        relative.azimuth_rad / RADIANS_PER_DEGREE,
        (vx * vx + vy * vy + vz * vz).sqrt(),
        east_m_s,
        north_m_s,
        -up_m_s,
        great_circle_m(start, &place),
        around.air_speed_m_s / air.speed_of_sound_m_s,
        around.density_kg_m3,
        air.temperature_k,
        air.pressure_pa,
        motion.drag_coefficient(t, state),
        dynamic_pressure_pa,
        stagnation_pressure(equations, y),
        deceleration_earth_g,
        heat_flux.convective_w_m2,
        heat_flux.radiative_w_m2,
        heat_flux.total_w_m2(),
        margined.total_w_m2(),
        y[super::equations::CONVECTIVE],
        y[super::equations::RADIATIVE],
        wall_temperature_k(mission, &margined, around.air_speed_m_s),
        equations.knudsen(&around),
    ];
    let attitude = motion.attitude(state).map(|attitude| {
        let [yaw, pitch, roll] = attitude.yaw_pitch_roll_rad;
        let [p, q, r] = attitude.rates_rad_s;
        let angles = [attitude.total_alpha_rad, yaw, pitch, roll, p, q, r];
        angles.map(|angle| angle / RADIANS_PER_DEGREE)
    });
    let attitude: [Option<f64>; 7] = match attitude {
        Some(angles) => angles.map(Some),
        None => [None; 7],
    };
    let phase = equations.is_phased().then(|| equations.phase() as f64);
    let row = row.map(|value| Some(value.value()));
    let values = row.into_iter().chain(attitude).chain([phase]);
    for (column, value) in trajectory.values.iter_mut().zip(values) {
        column.extend(value);
    }
}
