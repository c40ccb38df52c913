//! Equations of motion of a rigid body, relative to the rotating planet.
//!
//! ```text
//! dv/dt = F/m + g(r) − 2 Ω×v − Ω×(Ω×r)
//! dq/dt = ½ q ⊗ (ω − Rᵀ Ω)
//! I dω/dt = M − ω × (I ω)
//! ```
//!
//! with the point mass first (r, v, Q as in [`crate::flight::equations`]), q the attitude from axes of the body to
//! planet-fixed axes, ω the inertial rates in axes of the body in rad/s, Ω the rotation of the planet in rad/s, F in N and
//! M in N·m from [`super::aerodynamics`].
//!
//! # Valid
//! Rigid bodies; where a phase changes the mass, center of gravity and shape of the inertia stay. Gravity has no
//! moment. Heating is that of the nose forward, whatever the attitude.
//!
//! # References
//! - \[stevens-lewis-2016\] section 1.7; \[samareh-2014\] section 3.2.

use super::aerodynamics::{Aerodynamics, Load, Stream, total_alpha_rad};
use super::attitude::angles_rad;
use super::quaternion;
use super::rigid::Rigid;
use crate::aero::{Drag, DragTable};
use crate::flight::equations::{Equations, STATES, Surroundings};
use crate::flight::integration::point_tolerance;
use crate::flight::motion::{AttitudeSample, Motion, head};
use crate::flight::reach::Arguments;
use crate::flight::sample::Loads;
use crate::planet::wind::Wind;
use nalgebra::{Quaternion, Rotation3, Vector3};
use numerics::ode::{Step, Tolerance};

/// Components of the state: a point mass, quaternion, rates.
pub const RIGID_STATES: usize = RATES + 3;
/// Index of the quaternion in the state.
pub const ATTITUDE: usize = STATES;
/// Index of the rates in the state.
pub const RATES: usize = ATTITUDE + 4;
/// Rate below which the allowed error of a step no longer decreases, rad/s.
const RATE_SCALE_RAD_S: f64 = 1.0;

/// Below this speed against the air the attitude has no drag coefficient of its own, m/s.
const SLOWEST_M_S: f64 = 1e-6;

/// A rigid body in flight.
#[derive(Clone, Copy)]
pub struct RigidMotion<'a> {
    /// The part that does not depend on attitude.
    pub point: Equations<'a>,
    /// The body.
    pub rigid: &'a Rigid,
}

/// Everything at one state.
struct Instant {
    point: [f64; STATES],
    around: Surroundings<f64>,
    attitude: Quaternion<f64>,
    to_planet: Rotation3<f64>,
    stream: Stream,
}

#[inline]
fn quaternion_of(y: &[f64; RIGID_STATES]) -> Quaternion<f64> {
    quaternion::of_parts(core::array::from_fn(|i| y[ATTITUDE + i]))
}

/// Angle between the axis of an attitude and a velocity in planet-fixed axes, rad.
#[inline]
fn seen_alpha_rad(attitude: Quaternion<f64>, velocity_m_s: &Vector3<f64>) -> f64 {
    total_alpha_rad(&quaternion::unit(attitude).inverse_transform_vector(velocity_m_s))
}

impl RigidMotion<'_> {
    #[inline]
    fn instant(&self, y: &[f64; RIGID_STATES]) -> Instant {
        self.instant_in(y, &self.around(y))
    }

    #[inline]
    fn instant_in(&self, y: &[f64; RIGID_STATES], around: &Surroundings<f64>) -> Instant {
        let (point, around) = (head(y), *around);
        let attitude = quaternion_of(y);
        let to_planet = quaternion::unit(attitude).to_rotation_matrix();
        let stream = Stream {
            velocity_m_s: to_planet.inverse_transform_vector(&around.air_velocity_m_s.into()),
            speed_m_s: around.air_speed_m_s,
            density_kg_m3: around.density_kg_m3,
            drag_coefficient: around.drag_coefficient,
            rates_rad_s: Vector3::from_fn(|i, _| y[RATES + i]),
            mach_knudsen: self.mach_knudsen(&around),
        };
        Instant {
            point,
            around,
            attitude,
            to_planet,
            stream,
        }
    }

    /// Total angle of attack within a step, rad, from only those components of the dense output that it needs.
    #[inline]
    pub fn total_alpha_in_rad(&self, step: &Step<RIGID_STATES>, t: f64) -> f64 {
        match &self.point.mission.wind {
            Wind::Calm => {
                let velocity_m_s = Vector3::from_fn(|i, _| step.component(3 + i, t));
                let parts = core::array::from_fn(|i| step.component(ATTITUDE + i, t));
                seen_alpha_rad(quaternion::of_parts(parts), &velocity_m_s)
            }
            _ => self.total_alpha_rad(&step.at(t)),
        }
    }

    /// Angle between the axis and the velocity relative to the air, rad.
    #[inline]
    pub fn total_alpha_rad(&self, y: &[f64; RIGID_STATES]) -> f64 {
        let velocity_m_s = match &self.point.mission.wind {
            Wind::Calm => [y[3], y[4], y[5]],
            _ => self.point.surroundings(&head(y)).air_velocity_m_s,
        };
        seen_alpha_rad(quaternion_of(y), &velocity_m_s.into())
    }

    #[inline]
    fn load(&self, stream: &Stream) -> Load {
        self.rigid.aerodynamics.load(stream, self.rigid)
    }

    /// Force and moment, those of a parachute included.
    #[inline]
    fn whole_load(&self, t: f64, stream: &Stream) -> Load {
        let load = self.load(stream);
        if !self.point.is_phased() {
            return load;
        }
        let changed = self.point.changed();
        // coefficients stay, as do the lengths of the moments
        let numbers = self.point.numbers();
        let load = load.times(numbers.reference_area_m2 / self.point.body.reference_area_m2);
        load.with_canopy(
            stream,
            changed.canopy_m2(t),
            changed.attachment_m,
            self.rigid.cg_m,
        )
    }

    /// Mass over that at the start: the inertia is scaled with it when a phase changes the mass.
    #[inline]
    fn part_of_mass(&self) -> f64 {
        self.point.numbers().mass_kg / self.point.body.mass_kg
    }

    /// Mach and Knudsen number, where the coefficients depend on them.
    #[inline]
    fn mach_knudsen(&self, around: &Surroundings<f64>) -> [f64; 2] {
        match &self.rigid.aerodynamics {
            Aerodynamics::Drag | Aerodynamics::Constants(_) => [0.0; 2],
            Aerodynamics::Database(of_outline) => {
                let air = self
                    .point
                    .mission
                    .atmosphere
                    .air_in(&self.point.held().piece, around.altitude_m);
                [
                    around.air_speed_m_s / air.speed_of_sound_m_s,
                    air.mean_free_path_m / of_outline.database.diameter_m,
                ]
            }
        }
    }
}

impl<'a> Motion<'a, RIGID_STATES> for RigidMotion<'a> {
    type Lane = Self;

    #[inline]
    fn everywhere(of: &Self) -> Self {
        *of
    }

    #[inline]
    fn set_lane(&mut self, _lane: usize, of: &Self) {
        *self = *of;
    }

    #[inline]
    fn point(&self) -> &Equations<'a> {
        &self.point
    }

    #[inline]
    fn point_mut(&mut self) -> &mut Equations<'a> {
        &mut self.point
    }

    #[inline]
    fn drag_table(&self) -> Option<&'a DragTable> {
        match (&self.rigid.aerodynamics, &self.point.body.drag) {
            (Aerodynamics::Database(of_outline), _) => of_outline.axial_force.as_ref(),
            (Aerodynamics::Drag, Drag::Table(table)) => Some(table),
            _ => None,
        }
    }

    #[inline]
    fn holds_drag(&self) -> bool {
        matches!(self.rigid.aerodynamics, Aerodynamics::Drag)
    }

    fn tolerance(&self) -> Tolerance<RIGID_STATES> {
        let tolerance = self.point.mission.solver.tolerance;
        let of_point = point_tolerance(tolerance);
        let part = |of_point: &[f64; STATES], attitude: f64, rates: f64| {
            core::array::from_fn(|i| match of_point.get(i) {
                Some(part) => *part,
                None if i < RATES => attitude,
                None => rates,
            })
        };
        Tolerance {
            relative: part(&of_point.relative, 0.0, tolerance),
            absolute: part(&of_point.absolute, tolerance, tolerance * RATE_SCALE_RAD_S),
        }
    }

    #[inline]
    fn derivative_in(
        &self,
        t: f64,
        y: &[f64; RIGID_STATES],
        around: &Surroundings<f64>,
    ) -> [f64; RIGID_STATES] {
        let Instant {
            point,
            around,
            attitude,
            to_planet,
            stream,
        } = self.instant_in(y, around);
        let Load {
            force_n,
            moment_n_m,
        } = self.whole_load(t, &stream);
        let force = to_planet * force_n / self.point.numbers().mass_kg;
        let of_point = self.point.moved_by(&point, &around, force.into());
        let spin = self.point.mission.planet.rotation_rate_rad_s;
        let of_planet = to_planet.inverse_transform_vector(&(Vector3::z() * spin));
        let of_attitude = quaternion::derivative(&attitude, stream.rates_rad_s - of_planet);
        let of_attitude = quaternion::parts(&of_attitude);
        let moment_n_m = match self.point.is_phased() {
            true => moment_n_m / self.part_of_mass(),
            false => moment_n_m,
        };
        let inertia = &self.rigid.inertia;
        let of_rates = inertia.acceleration_rad_s2(&stream.rates_rad_s, moment_n_m);
        core::array::from_fn(|i| match i {
            0..ATTITUDE => of_point[i],
            ATTITUDE..RATES => of_attitude[i - ATTITUDE],
            _ => of_rates[i - RATES],
        })
    }

    fn loads_in(&self, t: f64, y: &[f64; RIGID_STATES], around: &Surroundings<f64>) -> Loads {
        let Instant { stream, .. } = self.instant_in(y, around);
        let force_n = self.whole_load(t, &stream).force_n.norm_squared().sqrt();
        let deceleration_m_s2 = force_n / self.point.numbers().mass_kg;
        Loads::new(&self.point, around, deceleration_m_s2)
    }

    fn drag_coefficient(&self, _t: f64, y: &[f64; RIGID_STATES]) -> f64 {
        // A stream of unit speed and density 2 has the pressure 1; rates do not change the force.
        let Instant { stream, .. } = self.instant(y);
        let v = stream.speed_m_s;
        if v < SLOWEST_M_S {
            // the line that holds may be of a larger Mach number
            let at_rest = |table: &DragTable| table.at(0.0);
            return self.drag_table().map_or(stream.drag_coefficient, at_rest);
        }
        let unit = Stream {
            speed_m_s: v,
            density_kg_m3: 2.0 / (v * v),
            ..stream
        };
        let against = -self.load(&unit).force_n.dot(&stream.velocity_m_s) / v;
        against / self.rigid.reference.area_m2
    }

    fn arguments(&self, t: f64, y: &[f64; RIGID_STATES]) -> Arguments<f64> {
        let Instant { around, stream, .. } = self.instant(y);
        let [_, knudsen] = stream.mach_knudsen;
        let alpha_rad = total_alpha_rad(&stream.velocity_m_s);
        self.point.arguments(t, &around, alpha_rad, knudsen)
    }

    fn attitude(&self, y: &[f64; RIGID_STATES]) -> Option<AttitudeSample> {
        let Instant {
            around,
            to_planet,
            stream,
            ..
        } = self.instant(y);
        Some(AttitudeSample {
            total_alpha_rad: total_alpha_rad(&stream.velocity_m_s),
            yaw_pitch_roll_rad: angles_rad(&to_planet, around.up),
            rates_rad_s: stream.rates_rad_s.into(),
        })
    }
}
