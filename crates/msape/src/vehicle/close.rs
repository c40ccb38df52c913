//! Closing at one diameter: the center of gravity about which the vehicle is laid out, with converged walls.
//!
//! ```text
//! g(x, walls) = x   bracketed among the x that leave room for a wing; the foremost root, x(walls)
//! walls             least fixed point of  walls → geometry(x(walls), walls) → masses → loads → walls,  from the least gauges up
//! ```
//!
//! with x in m and g the center of gravity of the vehicle laid out about x with these walls. Too far forward the lid is so flat,
//! too far aft its foot is so high that the wing is too shallow: in between is the admissible interval; g outside it is not
//! needed. In the MSR concept nothing is laid out about x, and g is its center of gravity at once. There is no initial guess:
//! the vehicle that closes at a diameter depends on the input and the diameter alone.
//!
//! # Valid
//! As [`crate::vehicle::outline`] and [`crate::vehicle::structure`]. Thicker walls make heavier vehicles and these thicker walls:
//! from the least gauges the walls rise to the lightest that carry their vehicle, or without end when there are none.
//! g changes little with x, as lid and filling are a small part of the mass: more than one root has not been met; a
//! root ahead of the one found is looked for at a few places only.
//!
//! # References
//! - \[samareh-2014\] section 3.1.2 and Figure 12 (as the text describes it). Its loop, geometry about the last center of gravity
//!   over and over, is replaced by the bracketed root: it need not settle where a vehicle closes.

use crate::vehicle::draft::Memory;
use crate::vehicle::forebody::Forebody;
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::{Concept, Foam};
use crate::vehicle::layout::{Depths, Frame, Layout, Misfit, Trial};
use crate::vehicle::mass::{Component, Densities, Masses, components, masses, total};
use crate::vehicle::structure::{Structure, size};
use crate::vehicle::{msr, non_msr};
use numerics::root;
use numerics::scalar::Single;

/// A vehicle that closes at a diameter.
#[derive(Clone, Debug)]
pub struct Closed {
    /// Layout of all components.
    pub layout: Layout,
    /// Components.
    pub components: Vec<Component>,
    /// Walls.
    pub structure: Structure,
    /// Geometries laid out.
    pub iterations: u32,
}

/// Turns after which walls count as rising without end.
const MOST_TURNS: u32 = 500;

/// Iterations after which a vehicle that does not fit is taken as it is: thicker walls give it no room.
const MOST_UNFIT_TURNS: u32 = 12;

/// Precision of center of gravity and walls, as a fraction of that of the rules.
const PRECISION: f64 = 1e-4;

/// Least room with walls of minimum gauge for a search to continue, m: thicker walls never gain as much.
const HOPELESS_M: f64 = -0.02;

/// Lack of room, or error of the center of gravity, above which approximate walls suffice, m.
const UNFIT_M: f64 = 1e-4;

/// Step for finding the side with more room, and room that is zero within rounding, m.
const NEAR_M: f64 = 1e-9;

/// Room that counts for each meter by which a center of gravity lies beyond the places that leave room: it moves faster with
/// the diameter than the annulus does.
const CG_SHARE: f64 = 0.2;

/// Interval searched first for the center of gravity when walls have changed, m.
const NEIGHBORHOOD_M: f64 = 1e-3;

/// Room that is missing at the edge of the places that leave room: the length that a wing must have, m.
const EDGE_M: f64 = 1e-6;

/// Number of places between nose and aft end at which the foremost root is searched for.
const PLACES: u32 = 6;

/// A vehicle at a diameter, whether it closes or not.
#[derive(Clone, Debug)]
pub struct Attempt {
    /// Layout, which may not fit.
    trial: Trial,
    structure: Structure,
    iterations: u32,
}

impl Attempt {
    /// Why it does not close.
    pub fn misfit(&self) -> Option<Misfit> {
        self.trial.misfit
    }

    /// Room, continuous in the diameter, m: negative where the vehicle is too small.
    pub fn room_m(&self) -> f64 {
        self.trial.room_m
    }

    /// The whole vehicle, when it closes.
    pub fn closed(&self, input: &VehicleInput, foam: &FoamRule) -> Result<Closed, Misfit> {
        if let Some(misfit) = self.trial.misfit {
            return Err(misfit);
        }
        let (layout, structure) = (self.trial.layout, self.structure);
        let foam = foam.at(layout.foam_thickness_m);
        let components = components(
            input,
            &layout,
            &Densities {
                structure: &structure,
                foam,
            },
        );
        let mass = total(components.iter().map(Component::part));
        let sized = size::walls(input, &size::loads(input, &layout, &components, &mass));
        Ok(Closed {
            layout,
            components,
            structure: structure.with_reasons(sized),
            iterations: self.iterations,
        })
    }
}

/// Layout of a vehicle at successive diameters, with the impact foam that the landing requires or more of it.
pub struct Search<'a> {
    input: &'a VehicleInput,
    foam: &'a FoamRule<'a>,
    /// Foam of the least thickness.
    least_foam: Foam,
    payload_radius_m: f64,
    memory: Memory,
}

impl<'a> Search<'a> {
    /// Search for the vehicle of an input, whose landing requires `foam`.
    pub fn new(input: &'a VehicleInput, foam: &'a FoamRule<'a>) -> Self {
        Self {
            input,
            foam,
            least_foam: foam.at(foam.least_thickness_m),
            payload_radius_m: input.payload_diameter_m() / 2.0,
            memory: Memory::default(),
        }
    }

    /// The vehicle at a diameter, when it closes there.
    pub fn close(&mut self, diameter_m: f64) -> Result<Closed, Misfit> {
        self.attempt(diameter_m)?.closed(self.input, self.foam)
    }

    /// The vehicle at a diameter, whether it closes or not.
    pub fn attempt(&mut self, diameter_m: f64) -> Result<Attempt, Misfit> {
        let (input, radius_m, payload_radius_m) =
            (self.input, diameter_m / 2.0, self.payload_radius_m);
        if payload_radius_m >= radius_m {
            return Err(Misfit::PayloadWiderThanVehicle {
                payload_radius_m,
                vehicle_radius_m: radius_m,
            });
        }
        let mut candidate = Candidate {
            input,
            foam: self.foam,
            least_foam: self.least_foam,
            memory: &mut self.memory,
            forebody: forebody(input, diameter_m),
            payload_radius_m,
            structure: least_walls(input),
            layouts: 0,
        };
        let trial = candidate.trial()?;
        Ok(Attempt {
            trial,
            structure: candidate.structure,
            iterations: candidate.layouts,
        })
    }
}

fn least_walls(input: &VehicleInput) -> Structure {
    Structure {
        forebody: match input.forebody.carrier_thickness_m {
            Some(thickness_m) => input.forebody.carrier.at_thickness(thickness_m),
            None => input.forebody.carrier.at_minimum_gauge(),
        },
        aftbody: input.aftbody_carrier.at_minimum_gauge(),
        primary: input.primary_carrier.at_minimum_gauge(),
    }
}

/// Forebody of an input at a diameter, m.
pub fn forebody<S: Single>(input: &VehicleInput<S>, diameter_m: S) -> Forebody<S> {
    let radius_m = diameter_m / 2.0;
    Forebody {
        diameter_m,
        nose_radius_m: input.nose_radius_ratio * radius_m,
        shoulder_radius_m: input.shoulder_radius_ratio * radius_m,
        cone_half_angle_rad: input.cone_half_angle_rad,
    }
}

/// Layers of an input with its walls.
pub fn depths<S: Single>(input: &VehicleInput<S>, structure: &Structure<S>) -> Depths<S> {
    Depths {
        forebody_tps_m: input.forebody.tps_thickness_m,
        bond_m: input.forebody.bond_thickness_m,
        forebody_carrier_m: structure.forebody.thickness_m,
        aftbody_tps_m: input.aftbody_tps_thickness_m,
        aftbody_carrier_m: structure.aftbody.thickness_m,
        primary_m: structure.primary.thickness_m,
    }
}

/// Lays a vehicle out.
pub fn lay_out<S: Single>(concept: Concept, frame: &Frame<S>) -> Trial<S> {
    match concept {
        Concept::Msr => msr::layout(frame),
        Concept::NonMsr => non_msr::layout(frame),
    }
}

/// A diameter being tried.
struct Candidate<'a> {
    input: &'a VehicleInput,
    foam: &'a FoamRule<'a>,
    /// Foam of the least thickness.
    least_foam: Foam,
    memory: &'a mut Memory,
    forebody: Forebody,
    payload_radius_m: f64,
    /// Walls of the last iteration.
    structure: Structure,
    layouts: u32,
}

impl Candidate<'_> {
    fn lay_out(&self, cg_x_m: f64) -> Trial {
        let frame = Frame {
            forebody: self.forebody,
            depths: depths(self.input, &self.structure),
            payload_radius_m: self.payload_radius_m,
            foam_thickness_m: self.foam.least_thickness_m,
            cg_x_m,
            rules: &self.input.rules,
        };
        lay_out(self.input.concept, &frame)
    }

    /// Width within which center of gravity and walls are found, m.
    fn precision_m(&self) -> f64 {
        PRECISION * self.input.rules.convergence_m
    }

    fn masses(&mut self, trial: &Trial) -> Masses {
        let thickness_m = trial.layout.foam_thickness_m;
        let foam = if thickness_m == self.least_foam.thickness_m {
            self.least_foam
        } else {
            self.foam.at(thickness_m)
        };
        let structure = &self.structure;
        let densities = Densities { structure, foam };
        masses(self.input, &trial.layout, &densities, self.memory)
    }

    /// Layout with walls that carry it, and the distance of its center of gravity from the place about which it is laid out, m.
    fn settle(&mut self) -> Result<(Trial, f64), Misfit> {
        let mut x_m = None;
        let mut move_m = f64::INFINITY;
        for turn in 0..MOST_TURNS {
            x_m = match self.input.concept {
                // nothing is laid out about it
                Concept::Msr => None,
                Concept::NonMsr => Some(self.own_cg_x_m(x_m)?),
            };
            let trial = self.lay_out(x_m.unwrap_or_default());
            let masses = self.masses(&trial);
            let off_m = masses.cg_x_m - x_m.unwrap_or(masses.cg_x_m);
            if trial.room_m < HOPELESS_M {
                return Ok((trial, off_m));
            }
            let loads = size::loads_of(self.input, &trial.layout, &masses);
            let sized = size::walls(self.input, &loads);
            move_m = largest_move_m(&self.structure, &sized);
            let unfit = trial.room_m < -UNFIT_M || off_m.abs() > UNFIT_M;
            let enough_m = if unfit {
                0.1 * UNFIT_M
            } else {
                self.precision_m()
            };
            if move_m <= enough_m || (unfit && turn >= MOST_UNFIT_TURNS) {
                return Ok((trial, off_m));
            }
            if move_m.is_nan() || move_m > self.forebody.diameter_m {
                break;
            }
            self.structure = sized;
        }
        Err(Misfit::NotConverged { move_m })
    }

    /// Distance of the center of gravity behind the place about which the vehicle is laid out, m; where the wing is too
    /// shallow by how much, positive when a place further aft has it less so.
    fn lead_m(&mut self, x_m: f64) -> f64 {
        self.layouts += 1;
        let trial = self.lay_out(x_m);
        if trial.room_m >= 0.0 {
            return self.masses(&trial).cg_x_m - x_m;
        }
        if self.lay_out(x_m + NEAR_M).room_m > trial.room_m {
            -trial.room_m
        } else {
            trial.room_m
        }
    }

    /// The place about which the vehicle with these walls has its center of gravity, or the last one that leaves room for a
    /// wing, m: near the place `before_m` of walls before, or the foremost.
    fn own_cg_x_m(&mut self, before_m: Option<f64>) -> Result<f64, Misfit> {
        if let Some(x_m) = before_m {
            let (fore, aft) = (x_m - NEIGHBORHOOD_M, x_m + NEIGHBORHOOD_M);
            if self.lead_m(fore) > 0.0 && self.lead_m(aft) <= 0.0 {
                return self.cg_between(fore, aft);
            }
        }
        let nose_x_m = self.forebody.nose_tip_x_m();
        let payload_x_m = self.forebody.resting_ball_x_m(0.0, self.payload_radius_m);
        let aft_x_m = self.forebody.shoulder_center().x_m.max(payload_x_m) + self.payload_radius_m;
        let step_m = (aft_x_m - nose_x_m) / f64::from(PLACES);
        let place = |k: u32| nose_x_m + step_m * f64::from(k);
        // from the nose on; beyond the vehicle no center of gravity lies behind
        match (1..=4 * PLACES).find(|&k| self.lead_m(place(k)) <= 0.0) {
            Some(k) => self.cg_between(place(k - 1), place(k)),
            None => Err(Misfit::NotConverged { move_m: step_m }),
        }
    }

    /// The place between two at which the lead changes its sign, m: no closer than need be where the center of gravity is far off.
    fn cg_between(&mut self, fore_m: f64, aft_m: f64) -> Result<f64, Misfit> {
        let none = || Misfit::NotConverged {
            move_m: aft_m - fore_m,
        };
        let near = root::bracket(|x_m| self.lead_m(x_m), fore_m, aft_m, 0.1 * UNFIT_M);
        let [one, other] = near.ok_or_else(none)?;
        if self.lead_m(one).abs().max(self.lead_m(other).abs()) > UNFIT_M {
            return Ok(one);
        }
        let tolerance = self.precision_m();
        root::brent(|x_m| self.lead_m(x_m), one, other, tolerance).ok_or_else(none)
    }

    /// Converged layout, with the room that its center of gravity leaves.
    fn trial(&mut self) -> Result<Trial, Misfit> {
        let (trial, off_m) = self.settle()?;
        if trial.room_m < -EDGE_M || off_m.abs() < self.input.rules.convergence_m {
            return Ok(trial);
        }
        // the last place that leaves room for a wing, and the center of gravity lies beyond it
        let about_cg = self.lay_out(trial.layout.outline.lid_center_x_m + off_m);
        let slope_rad = about_cg.layout.outline.wing_slope_rad;
        Ok(Trial {
            room_m: -off_m.abs() * CG_SHARE,
            misfit: about_cg.misfit.or(Some(Misfit::WingTooShallow {
                slope_rad,
                least_rad: self.input.rules.wing_slope_min_rad,
            })),
            ..trial
        })
    }
}

/// Largest change of a wall's thickness, or of its faces', m.
fn largest_move_m(old: &Structure, new: &Structure) -> f64 {
    let pairs = [
        (old.forebody, new.forebody),
        (old.aftbody, new.aftbody),
        (old.primary, new.primary),
    ];
    let moves = pairs.map(|(old, new)| {
        let height = (new.thickness_m - old.thickness_m).abs();
        height + (new.face_thickness_m - old.face_thickness_m).abs()
    });
    moves.iter().sum()
}
