//! Closed form of a steep ballistic entry: the low-fidelity counterpart of the integrated flight.
//!
//! ```text
//! V(h)  = V_E exp(−ρ(h) H / (2 β sin γ)),   ρ(h) = ρ₀ exp(−h/H)
//! a_max = V_E² sin γ / (2 e H)   at   h = H ln(ρ₀ H / (β sin γ))
//! ```
//!
//! with V_E the entry speed in m/s, γ the constant angle below the horizon, β = m/(C_D A) in kg/m², H the scale height in
//! m, ρ₀ in kg/m³. Heat loads and times are summed over the closed form; below the terminal speed the vehicle falls at
//! that speed.
//!
//! # Valid
//! Steep entry: gravity, lift, rotation and the curvature of the planet are left out; β is that of Mach 25. A shallow
//! entry decelerates less than computed here (a third less at −8 deg). An atmosphere that is not exponential is
//! replaced by the exponential through its densities at two altitudes of the planet's file: on Earth 45 and 65 km.
//!
//! # References
//! - \[allen-eggers-1958\] equations 13, 15 and 17.

use super::equations::{CONVECTIVE, RADIATIVE, STATES};
use super::mission::{Body, Mission, Model};
use super::motion::Motion;
use super::reach::{Argument, Axis, Span, axes_of_closed_form, passed};
use super::sample::{self, EARTH_G_M_S2, Sample};
use super::trajectory::{Request, Trajectory};
use super::{Flight, Peak, PointHeat, points, three_dof};
use crate::aero::Drag;
use crate::heating::pressure::Stream;
use crate::heating::{Flow, HeatFlux};
use crate::planet::atmosphere::Atmosphere;
use crate::planet::geodetic::Geodetic;
use crate::planet::horizon::Velocity;
use numerics::{math, root};

mod ending;
mod entry;

pub use ending::ending;
pub use entry::Entry;

/// Intervals of the sum over altitude.
const INTERVALS: usize = 400;
/// Flies the closed form.
pub fn fly(mission: &Mission, body: &Body, request: Request) -> Flight {
    let entry = Entry::of(mission, body);
    let mut sum = Sum::new(mission, body, entry);
    let start_m = mission.planet.local(mission.start.position_m).altitude_m;
    let end_m = mission.stop.altitude_m.unwrap_or(0.0).min(start_m);
    let step_m = (start_m - end_m) / INTERVALS as f64;
    sum.visit(start_m);
    let end_s = mission.stop.time_s.unwrap_or(f64::INFINITY);
    for i in 1..=INTERVALS {
        let (above_m, altitude_m) = (
            start_m - (i - 1) as f64 * step_m,
            start_m - i as f64 * step_m,
        );
        if step_m <= 0.0 {
            break;
        }
        let left_s = end_s - sum.time_s;
        if sum.leg(altitude_m).time_s > left_s {
            let gap = |altitude_m: f64| sum.leg(altitude_m).time_s - left_s;
            let last_m = root::brent(gap, above_m, altitude_m, 1e-9 * step_m);
            sum.visit(last_m.unwrap_or(altitude_m));
            break;
        }
        sum.visit(altitude_m);
    }
    sum.flight(request)
}

/// Part of the descent between two altitudes.
struct LegDown {
    speed_m_s: f64,
    entering_m_s: f64,
    sine: f64,
    time_s: f64,
}

/// The sum over altitude as it goes down.
struct Sum<'a> {
    mission: &'a Mission,
    body: &'a Body,
    entry: Entry,
    place: Geodetic<f64>,
    time_s: f64,
    downrange_m: f64,
    load: HeatFlux<f64>,
    before: Option<(f64, f64, HeatFlux<f64>)>,
    /// Heating at the points of the body for which the case gives it, and the present heat flux of each, W/m².
    points: Vec<(PointHeat, f64)>,
    /// Axes of the tables that the closed form looks up, and the values looked up in each.
    spans: Vec<(Axis, Span)>,
    /// Largest values: deceleration, dynamic pressure, rise of the stagnation pressure over that of the air, heat fluxes.
    peaks: [Peak; 7],
    /// Pressure of the air where the stagnation pressure rises most above it, Pa.
    ambient_pa: f64,
    rows: Vec<(f64, [f64; STATES])>,
}

const NO_PEAK: Peak = Peak {
    value: 0.0,
    time_s: 0.0,
    altitude_m: 0.0,
    speed_m_s: 0.0,
    density_kg_m3: 0.0,
};

impl<'a> Sum<'a> {
    fn new(mission: &'a Mission, body: &'a Body, entry: Entry) -> Sum<'a> {
        Sum {
            mission,
            body,
            entry,
            place: mission.planet.geodetic(mission.start.position_m),
            time_s: 0.0,
            downrange_m: 0.0,
            load: HeatFlux::default(),
            before: None,
            points: points::none_yet(mission),
            spans: axes_of_closed_form(mission)
                .into_iter()
                .map(|axis| (axis, Span::EMPTY))
                .collect(),
            peaks: [NO_PEAK; 7],
            ambient_pa: 0.0,
            rows: Vec::with_capacity(INTERVALS + 1),
        }
    }

    /// The part of the descent from the last altitude to another one below it.
    fn leg(&self, altitude_m: f64) -> LegDown {
        let entering_m_s = self.entry.speed_at_m_s(altitude_m);
        let terminal_m_s = terminal_speed_m_s(self.mission, self.body, altitude_m);
        let speed_m_s = entering_m_s.max(terminal_m_s);
        let sine = if entering_m_s < speed_m_s {
            1.0
        } else {
            self.entry.sine
        };
        let time_s = self.before.map_or(0.0, |(above_m, above_m_s, _)| {
            (above_m - altitude_m) / (0.5 * (speed_m_s + above_m_s) * sine)
        });
        LegDown {
            speed_m_s,
            entering_m_s,
            sine,
            time_s,
        }
    }

    fn visit(&mut self, altitude_m: f64) {
        let Sum {
            mission,
            body,
            entry,
            ..
        } = *self;
        let air = mission.atmosphere.air(altitude_m);
        let LegDown {
            speed_m_s,
            entering_m_s,
            sine,
            time_s: dt,
        } = self.leg(altitude_m);
        let density_kg_m3 = match mission.atmosphere {
            Atmosphere::Exponential(_) => air.density_kg_m3,
            _ => entry.density_kg_m3(altitude_m),
        };
        let flow = Flow::new(density_kg_m3, entering_m_s, body.nose_radius_m);
        let flux = mission.heating.heat_flux(&flow);
        if let Some((above_m, _, flux_above)) = self.before {
            self.time_s += dt;
            self.downrange_m += (above_m - altitude_m) * (1.0 - sine * sine).max(0.0).sqrt() / sine;
            self.load.convective_w_m2 +=
                0.5 * (flux.convective_w_m2 + flux_above.convective_w_m2) * dt;
            self.load.radiative_w_m2 +=
                0.5 * (flux.radiative_w_m2 + flux_above.radiative_w_m2) * dt;
        }
        points::add(&mut self.points, mission, &flow, dt);
        for (axis, span) in &mut self.spans {
            let value = match axis.argument {
                Argument::AirSpeed => entering_m_s,
                Argument::Density => density_kg_m3,
                _ => altitude_m,
            };
            span.take(value, self.time_s);
        }
        self.before = Some((altitude_m, speed_m_s, flux));
        let dynamic_pressure_pa = 0.5 * density_kg_m3 * entering_m_s * entering_m_s;
        let stream = Stream {
            pressure_pa: air.pressure_pa,
            density_kg_m3,
            speed_m_s: entering_m_s,
            mach: entering_m_s / air.speed_of_sound_m_s,
            heat_capacity_ratio: air.heat_capacity_ratio,
        };
        let values = [
            dynamic_pressure_pa / entry.ballistic_coefficient_kg_m2 / EARTH_G_M_S2,
            dynamic_pressure_pa,
            mission.heating.pressure.pressure_pa(&stream) - air.pressure_pa,
            flux.convective_w_m2,
            flux.radiative_w_m2,
            flux.total_w_m2(),
            mission.heating.margined(&flux).total_w_m2(),
        ];
        if values[2] > self.peaks[2].value {
            self.ambient_pa = air.pressure_pa;
        }
        for (peak, value) in self.peaks.iter_mut().zip(values) {
            if value > peak.value {
                *peak = Peak {
                    value,
                    time_s: self.time_s,
                    altitude_m,
                    speed_m_s,
                    density_kg_m3,
                };
            }
        }
        self.rows
            .push((self.time_s, self.state(altitude_m, speed_m_s)));
    }

    /// The state in planet-fixed axes: along the great circle of the entry azimuth, at the entry angle.
    fn state(&self, altitude_m: f64, speed_m_s: f64) -> [f64; STATES] {
        let arc = self.downrange_m / self.mission.planet.sphere_radius_m();
        let ((sin_a, cos_a), azimuth) =
            (math::sin_cos(arc), self.mission.start.relative.azimuth_rad);
        let ((sin_l, cos_l), (sin_z, cos_z)) = (
            math::sin_cos(self.place.latitude_rad),
            math::sin_cos(azimuth),
        );
        let latitude_rad = math::asin((sin_l * cos_a + cos_l * sin_a * cos_z).clamp(-1.0, 1.0));
        let east = math::atan2(
            sin_z * sin_a * cos_l,
            cos_a - sin_l * math::sin(latitude_rad),
        );
        let place = Geodetic {
            altitude_m,
            latitude_rad,
            longitude_rad: self.place.longitude_rad + east,
        };
        let position = self.mission.planet.cartesian_m(&place);
        let velocity = self
            .mission
            .planet
            .horizon(position)
            .cartesian_m_s(&Velocity {
                speed_m_s,
                flight_path_angle_rad: -math::asin(self.entry.sine),
                azimuth_rad: azimuth,
            });
        let [x, y, z] = position;
        let [vx, vy, vz] = velocity;
        let mut state = [x, y, z, vx, vy, vz, 0.0, 0.0];
        state[CONVECTIVE] = self.load.convective_w_m2;
        state[RADIATIVE] = self.load.radiative_w_m2;
        state
    }

    fn flight(self, request: Request) -> Flight {
        let [
            deceleration,
            dynamic,
            stagnation,
            convective,
            radiative,
            total,
            margined,
        ] = self.peaks;
        let mission = self.mission;
        let end = self.rows.last().map_or([0.0; STATES], |(_, state)| *state);
        let place = sample::position(mission, &end);
        let margins = mission.heating.margined(&HeatFlux {
            convective_w_m2: 1.0,
            radiative_w_m2: 1.0,
        });
        let final_speed_m_s = (end[3] * end[3] + end[4] * end[4] + end[5] * end[5]).sqrt();
        Flight {
            model: Model::AllenEggers,
            entry_relative: mission.start.relative,
            entry_inertial: mission.start.inertial,
            peak_deceleration_earth_g: self.exact_deceleration(deceleration),
            peak_dynamic_pressure_pa: dynamic,
            peak_stagnation_pressure_pa: Peak {
                value: stagnation.value + self.ambient_pa,
                ..stagnation
            },
            peak_convective_heat_flux_w_m2: convective,
            peak_radiative_heat_flux_w_m2: (radiative.value > 0.0).then_some(radiative),
            peak_total_heat_flux_w_m2: total,
            peak_total_margined_heat_flux_w_m2: margined,
            convective_heat_load_j_m2: self.load.convective_w_m2,
            radiative_heat_load_j_m2: self.load.radiative_w_m2,
            convective_margin: margins.convective_w_m2,
            radiative_margin: margins.radiative_w_m2,
            peak_wall_temperature_k: sample::wall_temperature_k(
                mission,
                &HeatFlux {
                    convective_w_m2: margined.value,
                    radiative_w_m2: 0.0,
                },
                margined.speed_m_s,
            ),
            ballistic_coefficient_kg_m2: self.entry.ballistic_coefficient_kg_m2,
            time_of_flight_s: self.time_s,
            final_altitude_m: place.altitude_m,
            final_speed_m_s,
            final_flight_path_angle_rad: sample::flight_path_angle_rad(mission, &end),
            final_latitude_rad: place.latitude_rad,
            final_longitude_rad: place.longitude_rad,
            final_density_kg_m3: mission.atmosphere.density_kg_m3(place.altitude_m),
            downrange_m: self.downrange_m,
            mach_times_s: [None; 4],
            trajectory: self.trajectory(request),
            passed: self
                .spans
                .iter()
                .flat_map(|(axis, span)| passed(&[*axis], &[*span], None))
                .collect(),
            pushed: None,
            altitudes_m: [place.altitude_m, self.place.altitude_m],
            phases: Vec::new(),
            points: self.points.iter().map(|(point, _)| *point).collect(),
            exits: 0,
            attitude: None,
            evaluations: 0,
        }
    }

    /// The largest deceleration by its closed form, where it is within the descent; its time is that of the nearest
    /// altitude.
    fn exact_deceleration(&self, sampled: Peak) -> Peak {
        let altitude_m = self.entry.peak_deceleration_altitude_m();
        let start_m = self.place.altitude_m;
        let end_m = self.before.map_or(start_m, |(altitude_m, ..)| altitude_m);
        if !(end_m..=start_m).contains(&altitude_m) {
            return sampled;
        }
        Peak {
            value: self.entry.peak_deceleration_m_s2() / EARTH_G_M_S2,
            altitude_m,
            speed_m_s: self.entry.speed_at_m_s(altitude_m),
            density_kg_m3: self.entry.density_kg_m3(altitude_m),
            ..sampled
        }
    }

    /// The time history at the altitudes of the sum, whatever step was requested.
    fn trajectory(&self, request: Request) -> Option<Trajectory> {
        if request == Request::Nothing {
            return None;
        }
        let mut history = Trajectory::new();
        for (t, state) in &self.rows {
            let motion = three_dof::motion(self.mission, self.body);
            let motion = motion.within(&motion.place(state));
            history.push(&Sample::new(&motion, *t, state, &self.place));
        }
        Some(history)
    }
}

/// Speed at which drag carries the weight on the rotating planet, m/s: equation 2 of the report; without limit where there
/// is no drag.
pub fn terminal_speed_m_s(mission: &Mission, body: &Body, altitude_m: f64) -> f64 {
    let drag_coefficient = match &body.drag {
        Drag::Constant(coefficient) => *coefficient,
        Drag::Table(table) => table.at(0.0),
    };
    let below = Geodetic {
        altitude_m,
        ..mission.planet.geodetic(mission.start.position_m)
    };
    let [x, y, z] = mission
        .planet
        .effective_gravity(mission.planet.cartesian_m(&below));
    let gravity_m_s2 = (x * x + y * y + z * z).sqrt();
    let density = mission.atmosphere.density_kg_m3(altitude_m);
    let weight_n = body.mass_kg * gravity_m_s2;
    // ½ ρ C_D A V_t² = M g
    let speed = (2.0 * weight_n / (density * drag_coefficient * body.reference_area_m2)).sqrt();
    speed.min(mission.start.relative.speed_m_s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn naca_1381_sphere_peaks_at_233_9_g() {
        // 30000 ft/s vertical, H 22000 ft: 9144² / (2 e 6705.6) = 2293.6 m/s² = 233.878 g
        let entry = Entry {
            speed_m_s: 9144.0,
            sine: 1.0,
            ballistic_coefficient_kg_m2: 1000.0,
            surface_density_kg_m3: 1.225,
            scale_height_m: 6705.6,
        };
        assert!((entry.peak_deceleration_m_s2() / EARTH_G_M_S2 - 233.878).abs() < 5e-4);
        // V/V_E at peak deceleration is exp(-1/2).
        let ratio = entry.speed_at_m_s(entry.peak_deceleration_altitude_m()) / entry.speed_m_s;
        assert!((ratio - 0.606_530_659_712_633).abs() < 1e-12);
    }

    #[test]
    fn kshana_corridor_case_of_6_km_s_and_3_deg() {
        // The fixture carries the angle to nine digits, which is worth 3e-9 of the deceleration.
        // Published fixture: 6000 m/s, 3 deg, 50 kg/m2, 1.225 kg/m3, 7200 m: 48.13330597965842 m/s2 at 58484.3456517217 m.
        let entry = Entry {
            speed_m_s: 6000.0,
            sine: math::sin(3.0 * math::RADIANS_PER_DEGREE),
            ballistic_coefficient_kg_m2: 50.0,
            surface_density_kg_m3: 1.225,
            scale_height_m: 7200.0,
        };
        assert!((entry.peak_deceleration_m_s2() - 48.133_305_979_658_42).abs() < 1e-6);
        assert!((entry.peak_deceleration_altitude_m() - 58_484.345_651_721_7).abs() < 1e-4);
    }
}
