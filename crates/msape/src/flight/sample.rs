//! Numbers of one instant of a flight, computed from its state.

use super::equations::{CONVECTIVE, Equations, RADIATIVE, STATES, Surroundings};
use super::mission::Mission;
use super::motion::{AttitudeSample, Motion, head};
use crate::heating::HeatFlux;
use crate::heating::pressure::Stream;
use crate::heating::wall::{ColdWall, Wall, radiating_temperature_k};
use crate::planet::geodetic::Geodetic;
use crate::planet::horizon::Horizon;
use numerics::math::RADIANS_PER_DEGREE;
use numerics::scalar::{Scalar, Single};

/// Standard acceleration of gravity, m/s²: the Earth g of loads.
pub const EARTH_G_M_S2: f64 = 9.80665;

/// Quantities that change fast and whose peaks are looked for at every step.
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
        heat_capacity_ratio: air.heat_capacity_ratio,
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

/// The numbers of one instant, of which a time history takes its columns: SI, angles in rad.
pub struct Sample {
    /// Time after the start, s.
    pub time_s: f64,
    /// Geodetic altitude, m.
    pub altitude_m: f64,
    /// Geodetic latitude, rad.
    pub latitude_rad: f64,
    /// Longitude, rad.
    pub longitude_rad: f64,
    /// Speed relative to the planet, m/s.
    pub speed_m_s: f64,
    /// Angle of that velocity against the horizon, rad.
    pub flight_path_angle_rad: f64,
    /// Azimuth of that velocity, rad.
    pub azimuth_rad: f64,
    /// Speed in the frame that does not rotate, m/s.
    pub inertial_speed_m_s: f64,
    /// Velocity relative to the planet toward north, east and up, m/s.
    pub velocity_m_s: [f64; 3],
    /// Distance from the start over the planet, m.
    pub downrange_m: f64,
    /// Mach number.
    pub mach: f64,
    /// Density of the air, kg/m³.
    pub density_kg_m3: f64,
    /// Temperature of the air, K.
    pub temperature_k: f64,
    /// Pressure of the air, Pa.
    pub pressure_pa: f64,
    /// Drag coefficient in use.
    pub drag_coefficient: f64,
    /// Dynamic pressure, Pa.
    pub dynamic_pressure_pa: f64,
    /// Pressure at the stagnation point, Pa.
    pub stagnation_pressure_pa: f64,
    /// Aerodynamic force over mass, Earth g.
    pub deceleration_earth_g: f64,
    /// Convective heat flux without margin, W/m².
    pub convective_heat_flux_w_m2: f64,
    /// Radiative heat flux without margin, W/m².
    pub radiative_heat_flux_w_m2: f64,
    /// Heat flux without margins, W/m².
    pub total_heat_flux_w_m2: f64,
    /// Heat flux with margins, W/m².
    pub total_margined_heat_flux_w_m2: f64,
    /// Convective heat flux integrated over time, J/m².
    pub convective_heat_load_j_m2: f64,
    /// Radiative heat flux integrated over time, J/m².
    pub radiative_heat_load_j_m2: f64,
    /// Temperature of the wall at the stagnation point, K.
    pub wall_temperature_k: f64,
    /// Knudsen number.
    pub knudsen: f64,
    /// Attitude of a rigid body.
    pub attitude: Option<AttitudeSample>,
    /// Number of the phase, where the flight has phases.
    pub phase: Option<f64>,
}

impl Sample {
    /// The sample of a state; `start` is where the flight began.
    pub fn new<'a, const N: usize, S: Single>(
        motion: &impl Motion<'a, N, S>,
        t: S,
        state: &[S; N],
        start: &Geodetic<S>,
    ) -> Sample {
        let equations = motion.point();
        let mission = equations.mission;
        let y = &head(state);
        let around = equations.surroundings(y);
        let air = equations.air(around.altitude_m);
        let loads = motion.loads(t, state);
        let heat_flux = loads.heat_flux;
        let margined = mission.heating.margined(&heat_flux);
        let place = position(mission, y);
        let velocity = [y[3], y[4], y[5]];
        let horizon = Horizon::new(around.up);
        let relative = horizon.velocity(velocity);
        let [vx, vy, vz] = mission.planet.inertial_m_s([y[0], y[1], y[2]], velocity);
        let wall_k = wall_temperature_k(mission, &margined, around.air_speed_m_s);
        Sample {
            time_s: t.value(),
            altitude_m: around.altitude_m.value(),
            latitude_rad: place.latitude_rad.value(),
            longitude_rad: place.longitude_rad.value(),
            speed_m_s: relative.speed_m_s.value(),
            flight_path_angle_rad: relative.flight_path_angle_rad.value(),
            azimuth_rad: relative.azimuth_rad.value(),
            inertial_speed_m_s: (vx * vx + vy * vy + vz * vz).sqrt().value(),
            velocity_m_s: horizon.parts(velocity).map(|part| part.value()),
            downrange_m: mission.planet.distance_m(start, &place).value(),
            mach: (around.air_speed_m_s / air.speed_of_sound_m_s).value(),
            density_kg_m3: around.density_kg_m3.value(),
            temperature_k: air.temperature_k.value(),
            pressure_pa: air.pressure_pa.value(),
            drag_coefficient: motion.drag_coefficient(t, state).value(),
            dynamic_pressure_pa: loads.dynamic_pressure_pa.value(),
            stagnation_pressure_pa: stagnation_pressure(equations, y).value(),
            deceleration_earth_g: loads.deceleration_earth_g.value(),
            convective_heat_flux_w_m2: heat_flux.convective_w_m2.value(),
            radiative_heat_flux_w_m2: heat_flux.radiative_w_m2.value(),
            total_heat_flux_w_m2: heat_flux.total_w_m2().value(),
            total_margined_heat_flux_w_m2: margined.total_w_m2().value(),
            convective_heat_load_j_m2: y[CONVECTIVE].value(),
            radiative_heat_load_j_m2: y[RADIATIVE].value(),
            wall_temperature_k: wall_k.value(),
            knudsen: equations.knudsen(&around).value(),
            attitude: motion.attitude(state),
            phase: equations.is_phased().then(|| equations.phase() as f64),
        }
    }

    /// An angle or rate of the attitude, deg or deg/s.
    pub fn angle(&self, of: fn(&AttitudeSample) -> f64) -> Option<f64> {
        let attitude = self.attitude.as_ref()?;
        Some(of(attitude) / RADIANS_PER_DEGREE)
    }
}
