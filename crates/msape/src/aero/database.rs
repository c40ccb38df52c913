//! Static and dynamic coefficients of one outline at any Mach number, Knudsen number and angle of attack.
//!
//! ```text
//! C = C_c + (C_fm − C_c) w(Kn)
//! M ≥ 1.5:  C_A = k A [1 + (K − 1) cos² α] ± b cos² α     C_N = k N     C_m = k C       minus, and K = 1, for α > 90 deg
//!           K = [C_A0(M) − b]/(k A₀)     b = 1/max(M, 3)²     k = C_p,max(M)
//! M ≤ 0.5:  C_A = C_A0 − 0.5 sin² α     C_N = 0.749 sin α     C_m = −x_cp C_N            up to 60 deg, as above from 100 deg
//! ```
//!
//! with A, N, C the Newtonian coefficients of the outline for C_p,max = 1, A₀ that at α = 0, C_A0(M) the axial force nose first, w the bridging weight,
//! x_cp the Newtonian center of pressure in diameters from the virtual apex, α the total angle of attack in rad. Between Mach 0.5
//! and 1.5, and between 60 and 100 deg, both are blended by a smooth step. C_fm is cubic in 1/S
//! through S = 5, 10, 25 and ∞.
//!
//! # Valid
//! Bodies of revolution; damping and what comes from wind tunnels is of air. Backward flight in a continuum is an impact theory and no more; the base pressure b and the blends
//! beyond 60 deg are assumed.
//!
//! # References
//! - \[samareh-2014\] sections 3.3.1 to 3.3.7, equation 7; \[mitcheltree-1997\] (hypersonic axial force and center of
//!   pressure); \[schaaf-chambre-1961\]; \[wilmoth-1999\]. Base pressure and blends: \[assumed\].

use super::DragTable;
use super::bridging::Bridging;
use super::curve::{Curve, Place, STEPS};
use super::damping::Damping;
use super::free_molecular::Gas;
use super::integral::{Effort, Law, Loads, loads};
use super::newtonian::pressure_coefficient_max;
use super::surface::Surface;
use super::table::Grid;
use crate::vehicle::profile::Profile;
use numerics::math::{PI, RADIANS_PER_DEGREE, sin_cos};
use serde::{Deserialize, Serialize};

mod provenance;

pub use provenance::Regime;

/// Ratio of specific heats in pressure coefficients and speed ratios where no other gas is named: that of cold air.
pub const GAMMA: f64 = 1.4;
/// Normal force of equation 7 over the sine of the angle of attack.
const SUBSONIC_NORMAL: f64 = 0.749;
/// Decrease of the axial force in equation 7 per sin² α.
const SUBSONIC_AXIAL_LOSS: f64 = 0.5;
/// Mach numbers between which equation 7 is blended out.
const MACH_BLEND: [f64; 2] = [0.5, 1.5];
/// Angles between which equation 7 is blended out, deg.
const ALPHA_BLEND_DEG: [f64; 2] = [60.0, 100.0];
/// Below this Mach number the base pressure is held.
pub const BASE_MACH_MIN: f64 = 3.0;
/// Speed ratios at which free-molecular flow is computed, beside infinity.
const SPEED_RATIOS: [f64; 3] = [25.0, 10.0, 5.0];

/// Choices of a database that is computed from an outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Options {
    /// Axial force nose first in continuum flow against Mach number.
    pub axial_force: DragTable,
    /// Bridging between continuum and free-molecular flow.
    pub bridging: Bridging,
    /// Ratio of the wall's temperature to that of the air in free-molecular flow.
    pub wall_temperature_ratio: f64,
    /// Accommodation of normal and tangential momentum.
    pub accommodation: [f64; 2],
    /// Pitch damping.
    pub damping: Damping,
    /// Ratio of specific heats in pressure coefficients and speed ratios.
    pub heat_capacity_ratio: f64,
}

/// Coefficients at one place, about the virtual apex, with the area of the reference diameter and that diameter.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Coefficients {
    /// Axial force coefficient, positive aft.
    pub ca: f64,
    /// Normal force coefficient, positive away from the side that meets the air.
    pub cn: f64,
    /// Pitching moment coefficient about the virtual apex, positive where the angle of attack grows.
    pub cm: f64,
    /// Pitch damping coefficient per unit of q D/(2V).
    pub cmq: f64,
    /// Regime of origin.
    pub regime: Regime,
}

impl Coefficients {
    /// The moment coefficient about a point on the axis `x` diameters aft of the virtual apex.
    pub fn cm_about(&self, x: f64) -> f64 {
        self.cm + self.cn * x
    }

    /// The static coefficients alone.
    pub fn loads(&self) -> Loads {
        Loads {
            ca: self.ca,
            cn: self.cn,
            cm: self.cm,
        }
    }
}

/// A database: computed from an outline, or a table.
#[derive(Clone, Debug, PartialEq)]
pub struct Database {
    /// Reference diameter, m.
    pub diameter_m: f64,
    source: Source,
    damping: Damping,
}

#[derive(Clone, Debug, PartialEq)]
enum Source {
    Computed(Box<Computed>),
    Table(Grid),
}

#[derive(Clone, Debug, PartialEq)]
struct Computed {
    newtonian: Curve,
    /// Coefficients of C_fm = c₀ + y (c₁ + (y − y₁) (c₂ + (y − y₂) c₃)), y = 1/S.
    free_molecular: [Curve; 4],
    axial_force: DragTable,
    pressure_coefficient: Vec<f64>,
    pressure_center: f64,
    bridging: Bridging,
    heat_capacity_ratio: f64,
}

/// Nodes of C_p,max over M/(1 + M).
const PRESSURE_NODES: usize = 512;

impl Database {
    /// The database of an outline whose x starts at the virtual apex.
    pub fn of_outline(outline: &Profile, diameter_m: f64, options: Options) -> Database {
        Database::of_surface(&Surface::new(outline, diameter_m), options)
    }

    /// The database of a surface.
    pub fn of_surface(surface: &Surface, options: Options) -> Database {
        let [normal, tangential] = options.accommodation;
        let gas = |speed_ratio: f64| {
            Law::FreeMolecular(Gas {
                speed_ratio,
                wall_temperature_ratio: options.wall_temperature_ratio,
                normal_accommodation: normal,
                tangential_accommodation: tangential,
            })
        };
        let [first, second, third] = SPEED_RATIOS;
        let laws = [
            Law::Newtonian(1.0),
            gas(f64::INFINITY),
            gas(first),
            gas(second),
            gas(third),
        ];
        let mut values: [Vec<Loads>; 5] = Default::default();
        for node in 0..=STEPS {
            let found = loads(surface, &laws, Curve::angle_rad(node), Effort::TABLE);
            for (list, value) in values.iter_mut().zip(found) {
                list.push(value);
            }
        }
        let [newtonian, mut f0, mut f1, mut f2, mut f3] = values;
        let [y1, y2, y3] = SPEED_RATIOS.map(|speed_ratio| 1.0 / speed_ratio);
        divide(&mut [&mut f0, &mut f1, &mut f2, &mut f3], [0.0, y1, y2, y3]);
        let newtonian = Curve::new(&newtonian);
        let slope = newtonian.first_slope();
        let pressure_coefficient = (0..=PRESSURE_NODES)
            .map(|n| n as f64 / PRESSURE_NODES as f64)
            .map(|y| pressure_coefficient_max(y / (1.0 - y).max(1e-6), options.heat_capacity_ratio))
            .collect();
        Database {
            diameter_m: surface.diameter_m(),
            source: Source::Computed(Box::new(Computed {
                free_molecular: [f0, f1, f2, f3].map(|values| Curve::new(&values)),
                pressure_center: if slope.cn == 0.0 {
                    0.0
                } else {
                    -slope.cm / slope.cn
                },
                newtonian,
                axial_force: options.axial_force,
                pressure_coefficient,
                bridging: options.bridging,
                heat_capacity_ratio: options.heat_capacity_ratio,
            })),
            damping: options.damping,
        }
    }

    /// The database of a table.
    pub fn of_table(grid: Grid, diameter_m: f64, damping: Damping) -> Database {
        Database {
            diameter_m,
            source: Source::Table(grid),
            damping,
        }
    }

    /// Coefficients at a Mach number, a Knudsen number (mean free path over diameter) and a total angle of attack, rad.
    ///
    /// Any angle is taken: axial force and damping are even in it, normal force and moment odd.
    pub fn coefficients(&self, mach: f64, knudsen: f64, total_alpha_rad: f64) -> Coefficients {
        let turned = if total_alpha_rad.abs() <= PI {
            total_alpha_rad
        } else {
            total_alpha_rad - 2.0 * PI * (total_alpha_rad / (2.0 * PI)).round()
        };
        let (alpha, sign) = (turned.abs(), if turned < 0.0 { -1.0 } else { 1.0 });
        let (sin, cos) = sin_cos(alpha);
        let (Loads { ca, cn, cm }, regime) = match &self.source {
            Source::Table(grid) => (grid.loads(mach, knudsen, alpha), Regime::Table),
            Source::Computed(computed) => computed.at(mach, knudsen, alpha, [sin, cos]),
        };
        Coefficients {
            ca,
            cn: sign * cn,
            cm: sign * cm,
            cmq: self.damping.coefficient([mach, knudsen], alpha, [sin, cos]),
            regime,
        }
    }

    /// The table, where it is one.
    pub fn table(&self) -> Option<&Grid> {
        match &self.source {
            Source::Table(grid) => Some(grid),
            Source::Computed(_) => None,
        }
    }

    /// Ratio of the heat capacities of the gas for which it was computed; that of air where it is a table.
    pub fn heat_capacity_ratio(&self) -> f64 {
        match &self.source {
            Source::Computed(computed) => computed.heat_capacity_ratio,
            Source::Table(_) => GAMMA,
        }
    }

    /// Model of pitch damping.
    pub fn damping(&self) -> &Damping {
        &self.damping
    }
}

/// Newton's divided differences, in place.
fn divide<const K: usize>(values: &mut [&mut Vec<Loads>; K], y: [f64; K]) {
    for order in 1..K {
        for n in (order..K).rev() {
            let scale = 1.0 / (y[n] - y[n - order]);
            let (before, rest) = values.split_at_mut(n);
            if let (Some(before), Some(here)) = (before.last(), rest.first_mut()) {
                for (here, before) in here.iter_mut().zip(before.iter()) {
                    *here = here.mixed(scale, before, -scale);
                }
            }
        }
    }
}

/// 0 below the first, 1 above the second, with level ends.
fn smooth_step(x: f64, [from, to]: [f64; 2]) -> f64 {
    let t = ((x - from) / (to - from)).clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

impl Computed {
    fn at(&self, mach: f64, knudsen: f64, alpha: f64, sin_cos: [f64; 2]) -> (Loads, Regime) {
        let place = Place::new(alpha);
        let weight = self.bridging.weight(knudsen);
        let continuum = if weight < 1.0 {
            self.continuum(mach, alpha, sin_cos, &place)
        } else {
            Loads::default()
        };
        if weight == 0.0 {
            return (continuum, Regime::of_mach(mach));
        }
        let free = self.free_molecular(mach, &place);
        let regime = if weight < 1.0 {
            Regime::Transitional
        } else {
            Regime::FreeMolecular
        };
        (continuum.mixed(1.0 - weight, &free, weight), regime)
    }

    fn free_molecular(&self, mach: f64, place: &Place) -> Loads {
        let [first, second, slowest] = SPEED_RATIOS;
        let y = 1.0 / (mach * (0.5 * self.heat_capacity_ratio).sqrt()).max(slowest);
        let [c0, c1, c2, c3] = &self.free_molecular;
        let last = c2.at(place).mixed(1.0, &c3.at(place), y - 1.0 / second);
        let middle = c1.at(place).mixed(1.0, &last, y - 1.0 / first);
        c0.at(place).mixed(1.0, &middle, y)
    }

    fn continuum(&self, mach: f64, alpha: f64, [sin, cos]: [f64; 2], place: &Place) -> Loads {
        let Loads { ca, cn, cm } = self.newtonian.at(place);
        let k = self.pressure_coefficient(mach);
        let axial_force = self.axial_force.at(mach);
        let base_mach = mach.max(BASE_MACH_MIN);
        let base = 1.0 / (base_mach * base_mach);
        let square = cos * cos;
        let impact = Loads {
            ca: if cos > 0.0 {
                let correction = (axial_force - base) / (k * self.newtonian.first().ca);
                k * ca * (1.0 + (correction - 1.0) * square) + base * square
            } else {
                k * ca - base * square
            },
            cn: k * cn,
            cm: k * cm,
        };
        let subsonic = (1.0 - smooth_step(mach, MACH_BLEND))
            * (1.0 - smooth_step(alpha, ALPHA_BLEND_DEG.map(|a| a * RADIANS_PER_DEGREE)));
        if subsonic == 0.0 {
            return impact;
        }
        let normal = SUBSONIC_NORMAL * sin;
        let low = Loads {
            ca: axial_force - SUBSONIC_AXIAL_LOSS * sin * sin,
            cn: normal,
            cm: -self.pressure_center * normal,
        };
        impact.mixed(1.0 - subsonic, &low, subsonic)
    }

    fn pressure_coefficient(&self, mach: f64) -> f64 {
        let y = mach / (1.0 + mach) * PRESSURE_NODES as f64;
        let index = (y as usize).min(PRESSURE_NODES - 1);
        match self.pressure_coefficient.get(index..index + 2) {
            Some([a, b]) => a + (b - a) * (y - index as f64),
            _ => 0.0,
        }
    }
}

#[cfg(test)]
mod tests;
