//! The closing loop at one diameter: geometry, masses and walls until nothing moves any more.
//!
//! ```text
//! geometry(x_cg, walls) → masses → x_cg → loads → walls → geometry
//! ```
//!
//! with x_cg the centre of gravity in m. It stops when x_cg, the attached structure and every wall move less than the rules say.
//!
//! # Valid
//! As [`crate::vehicle::outline`] and [`crate::vehicle::structure`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.2 and Figure 12 (as the text describes it).

use crate::vehicle::forebody::Forebody;
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::Concept;
use crate::vehicle::layout::{Depths, Frame, Layout, Misfit};
use crate::vehicle::mass::found_foam;
use crate::vehicle::mass::{Component, Densities, MassProperties, components, total};
use crate::vehicle::structure::{Structure, Wall, size};
use crate::vehicle::{msr, non_msr};

/// A vehicle that closes at a diameter.
#[derive(Clone, Debug)]
pub struct Closed {
    /// Where everything stands.
    pub layout: Layout,
    /// Components.
    pub components: Vec<Component>,
    /// Their sum.
    pub mass: MassProperties,
    /// Walls.
    pub structure: Structure,
    /// Turns of the loop.
    pub iterations: u32,
}

impl Closed {
    /// Start for a neighbouring diameter.
    pub fn start(&self) -> Start {
        Start {
            cg_over_diameter: self.mass.cg_x_m / self.layout.outline.forebody.diameter_m,
            structure: self.structure,
        }
    }
}

/// Turns after which the loop gives up.
const MOST_TURNS: u32 = 200;

/// Where the loop starts: a centre of gravity and walls.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Centre of gravity over diameter.
    pub cg_over_diameter: f64,
    /// Walls.
    pub structure: Structure,
}

/// The vehicle at the diameter `diameter_m`, with the impact foam that `foam` asks for or more of it.
pub fn close(input: &VehicleInput, diameter_m: f64, foam: &FoamRule) -> Result<Closed, Misfit> {
    let structure = Structure {
        forebody: match input.forebody.carrier_thickness_m {
            Some(thickness_m) => input.forebody.carrier.at_thickness(thickness_m),
            None => input.forebody.carrier.at_minimum_gauge(),
        },
        aftbody: input.aftbody_carrier.at_minimum_gauge(),
        primary: input.primary_carrier.at_minimum_gauge(),
    };
    let forebody = forebody(input, diameter_m);
    let cg_x_m = first_cg_x_m(&forebody, input.payload_diameter_m() / 2.0);
    let start = Start {
        cg_over_diameter: cg_x_m / diameter_m,
        structure,
    };
    close_from(input, diameter_m, foam, start)
}

fn forebody(input: &VehicleInput, diameter_m: f64) -> Forebody {
    let radius_m = diameter_m / 2.0;
    Forebody {
        diameter_m,
        nose_radius_m: input.nose_radius_ratio * radius_m,
        shoulder_radius_m: input.shoulder_radius_ratio * radius_m,
        cone_half_angle_rad: input.cone_half_angle_rad,
    }
}

/// The same from a neighbour's centre of gravity and walls, which takes fewer turns.
pub fn close_from(
    input: &VehicleInput,
    diameter_m: f64,
    foam: &FoamRule,
    start: Start,
) -> Result<Closed, Misfit> {
    let forebody = forebody(input, diameter_m);
    let rules = &input.rules;
    let payload_radius_m = input.payload_diameter_m() / 2.0;
    if payload_radius_m >= forebody.diameter_m / 2.0 {
        return Err(Misfit::PayloadWiderThanVehicle {
            payload_radius_m,
            vehicle_radius_m: forebody.diameter_m / 2.0,
        });
    }
    let mut structure = start.structure;
    let mut cg_x_m = start.cg_over_diameter * diameter_m;
    let mut last_foot_x_m = f64::INFINITY;
    let mut moved = f64::INFINITY;
    let mut last = None;
    for iterations in 1..=MOST_TURNS {
        let depths = Depths {
            forebody_tps_m: input.forebody.tps_thickness_m,
            bond_m: input.forebody.bond_thickness_m,
            forebody_carrier_m: structure.forebody.thickness_m,
            aftbody_tps_m: input.aftbody_tps_thickness_m,
            aftbody_carrier_m: structure.aftbody.thickness_m,
            primary_m: structure.primary.thickness_m,
        };
        let frame = Frame {
            forebody,
            depths,
            payload_radius_m,
            foam_thickness_m: foam.least_thickness_m,
            cg_x_m,
            rules,
        };
        let layout = match input.concept {
            Concept::Msr => msr::layout(&frame)?,
            Concept::NonMsr => non_msr::layout(&frame)?,
        };
        let foam = foam.at(layout.foam_thickness_m);
        let foam_material = found_foam(input, foam);
        let components = components(
            input,
            &layout,
            &Densities {
                structure: &structure,
                foam,
                foam_material: &foam_material,
            },
        );
        let mass = total(&components);
        let sized = size::walls(input, &size::loads(input, &layout, &components, &mass));
        let foot_x_m = layout.outline.attached_structure_x_m;
        moved = (mass.cg_x_m - cg_x_m).abs();
        let settled = moved < rules.convergence_m
            && (foot_x_m - last_foot_x_m).abs() < rules.convergence_m
            && [
                (sized.forebody, structure.forebody),
                (sized.aftbody, structure.aftbody),
                (sized.primary, structure.primary),
            ]
            .iter()
            .all(|(new, old)| (new.thickness_m - old.thickness_m).abs() < rules.convergence_m);
        if settled {
            let slope_rad = layout.outline.wing_slope_rad;
            if slope_rad < rules.wing_slope_min_rad.min(frame.steepest_rad()) {
                return Err(Misfit::WingTooShallow {
                    slope_rad,
                    least_rad: rules.wing_slope_min_rad,
                });
            }
            return Ok(Closed {
                layout,
                components,
                mass,
                structure: sized_labels(structure, sized),
                iterations,
            });
        }
        let next = secant_step(last, (cg_x_m, mass.cg_x_m));
        last = Some((cg_x_m, mass.cg_x_m));
        cg_x_m = next;
        last_foot_x_m = foot_x_m;
        structure = sized;
    }
    Err(Misfit::NotConverged { move_m: moved })
}

/// Next guess of x = g(x) from two pairs (x, g(x)) by the secant, from one by g(x) itself; never further than twice the way to g(x).
fn secant_step(last: Option<(f64, f64)>, now: (f64, f64)) -> f64 {
    let residual = now.1 - now.0;
    let Some(last) = last else { return now.1 };
    let change = residual - (last.1 - last.0);
    let step = -residual * (now.0 - last.0) / change;
    if step * residual > 0.0 && step.abs() <= 2.0 * residual.abs() {
        now.0 + step
    } else {
        now.1
    }
}

/// A first centre of gravity, ahead of where it will be: then the lid is wide and its foot is lifted, never too low.
fn first_cg_x_m(forebody: &Forebody, payload_radius_m: f64) -> f64 {
    0.8 * forebody
        .resting_ball_x_m(0.0, payload_radius_m)
        .max(0.5 * forebody.shoulder_center().x_m)
}

/// The walls that the masses were computed with, with the reasons found in the last turn (they differ by less than the convergence).
fn sized_labels(used: Structure, sized: Structure) -> Structure {
    let label = |used: Wall, sized: Wall| Wall {
        thickness_m: used.thickness_m,
        face_thickness_m: used.face_thickness_m,
        density_kg_m3: used.density_kg_m3,
        ..sized
    };
    Structure {
        forebody: label(used.forebody, sized.forebody),
        aftbody: label(used.aftbody, sized.aftbody),
        primary: label(used.primary, sized.primary),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_secant_finds_the_fixed_point_of_a_line_at_once() {
        // g(x) = 3 − x/2 has its fixed point at 2
        let pair = |x: f64| (x, 3.0 - x / 2.0);
        assert_eq!(secant_step(None, pair(0.0)), 3.0);
        assert!((secant_step(Some(pair(0.0)), pair(3.0)) - 2.0).abs() < 1e-15);
        // no slope to go by: g(x)
        assert_eq!(secant_step(Some(pair(1.0)), pair(1.0)), 2.5);
    }
}
