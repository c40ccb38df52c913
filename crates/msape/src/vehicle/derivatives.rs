//! A vehicle with the derivatives of its numbers: found by value, then moved with its inputs.
//!
//! ```text
//! r(u, p) = 0  →  du/dp = −(∂r/∂u)⁻¹ ∂r/∂p
//! ```
//!
//! with u what the search finds: diameter, place about which the vehicle is laid out, thickness, faces and density of the three
//! walls; and r what holds there: the requested diameter or no room to spare, the center of gravity at that place, walls as the
//! rules require. Roots within a layout (shoulder, foam, lid) move by their own equations.
//!
//! # Valid
//! Away from changes of branch, which [`Branches`] names; there the derivative is that of the branch taken. A
//! diameter at which room jumps has no derivative: not a number.
//!
//! # References
//! - \[griewank-walther-2008\] chapter 15.

use crate::vehicle::build;
use crate::vehicle::close::{depths, forebody, lay_out};
use crate::vehicle::draft::Memory;
use crate::vehicle::figures::Figures;
use crate::vehicle::grow::{NotClosed, largest_growth};
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::Concept;
use crate::vehicle::layout::{Frame, Trial};
use crate::vehicle::mass::{Densities, Masses, masses, parts, total};
use crate::vehicle::structure::{Governs, Structure, Wall, size};
use numerics::math::FRAC_PI_2;
use numerics::scalar::{Dual, Scalar, Single};

/// Diameter, place, and three numbers of each of three walls.
const UNKNOWNS: usize = 11;

/// Room that the smallest diameter at most leaves where room limits it, m.
fn no_room_m(input: &VehicleInput) -> f64 {
    largest_growth(input) * input.rules.diameter_resolution_m + input.rules.convergence_m
}

/// Changes smaller than this are rounding, m.
const ROUNDING_M: f64 = 1e-9;

/// Condition that determines the diameter of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DiameterBy {
    /// The requested diameter.
    Asked,
    /// The room for the wing.
    Room,
    /// A part that fits from one diameter on and not below: no derivative.
    Jump,
}

/// Branches taken by the numbers of a vehicle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Branches {
    /// Condition that determines the diameter.
    pub diameter: DiameterBy,
    /// Shoulder radius compared with that requested.
    pub shoulder: core::cmp::Ordering,
    /// Whether the impact foam is thicker than the landing requires.
    pub foam_thickened: bool,
    /// Whether the gap under the lid is that of the rules.
    pub whole_gap: bool,
    /// Whether the steepest wing is limited by the rules, and not by the forebody.
    pub steepest_by_rule: bool,
    /// Whether payload and foam rest in the nose and not in the cone.
    pub in_nose: bool,
    /// Criterion that determines the thickness of each wall.
    pub walls: [Governs; 3],
}

/// The numbers of a vehicle, with derivatives, and the branches on which they are.
pub fn figures<S: Single>(input: &VehicleInput<S>) -> Result<(Figures<S>, Branches), NotClosed> {
    let plain = input.lift(S::value);
    let found = build(&plain)?;
    let diameter_m = found.dimensions.diameter_m;
    let walls = [
        found.structure.forebody,
        found.structure.aftbody,
        found.structure.primary,
    ];
    let mut system = System {
        by: if diameter_m == plain.diameter_m {
            DiameterBy::Asked
        } else {
            DiameterBy::Room
        },
        governs: walls.map(|wall| wall.governs),
    };
    let place_m = match input.concept {
        Concept::Msr => 0.0,
        Concept::NonMsr => found.layout.outline.lid_center_x_m,
    };
    let [a, b, c] = walls.map(|w| [w.thickness_m, w.face_thickness_m, w.density_kg_m3]);
    let at = [
        diameter_m, place_m, a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2],
    ];
    let rule = FoamRule::new(&plain);
    let room_m = system.trial(&plain, &rule, &at).room_m;
    if system.by == DiameterBy::Room && room_m.abs() > no_room_m(&plain) {
        system.by = DiameterBy::Jump;
    }
    let rule = FoamRule::new(input);
    let residual = || system.residual(input, &rule, at.map(S::constant));
    let unknowns = S::roots(at, residual, || {
        let lifted = plain.lift(Dual::<UNKNOWNS>::constant);
        let variables = core::array::from_fn(|k| Dual::variable(at[k], k));
        let rows = system.residual(&lifted, &FoamRule::new(&lifted), variables);
        rows.map(|row| row.slope)
    });
    let used = &system.structure(&unknowns);
    let layout = system.trial(input, &rule, &unknowns).layout;
    let foam = rule.at(layout.foam_thickness_m);
    let parts = parts(
        input,
        &layout,
        &Densities {
            structure: used,
            foam,
        },
    )
    .into_iter();
    let masses = Masses::of(parts.clone(), &total(parts.clone()));
    let sized = size::walls(input, &size::loads_of(input, &layout, &masses));
    let walls = (layout, used.with_reasons(sized));
    let figures = Figures::new(input, &rule, unknowns[0], walls, parts);
    let branches = system.branches(input, &rule, &figures);
    Ok((figures, branches))
}

/// Equations that a vehicle that closes satisfies.
struct System {
    by: DiameterBy,
    /// Criterion that determines the thickness of each wall.
    governs: [Governs; 3],
}

impl System {
    fn structure<S: Single>(&self, u: &[S; UNKNOWNS]) -> Structure<S> {
        let [forebody, aftbody, primary] = core::array::from_fn(|k| {
            // only these three are read
            let thickness_m = u[2 + 3 * k];
            Wall {
                thickness_m,
                face_thickness_m: u[3 + 3 * k],
                density_kg_m3: u[4 + 3 * k],
                governs: self.governs[k],
                strength_thickness_m: thickness_m,
                buckling_thickness_m: thickness_m,
                cap_buckling_thickness_m: thickness_m,
                core_shear_thickness_m: thickness_m,
            }
        });
        Structure {
            forebody,
            aftbody,
            primary,
        }
    }

    fn trial<S: Single>(
        &self,
        input: &VehicleInput<S>,
        rule: &FoamRule<S>,
        u: &[S; UNKNOWNS],
    ) -> Trial<S> {
        let frame = Frame {
            forebody: forebody(input, u[0]),
            depths: depths(input, &self.structure(u)),
            payload_radius_m: input.payload_diameter_m() / 2.0,
            foam_thickness_m: rule.least_thickness_m,
            cg_x_m: u[1],
            rules: &input.rules,
        };
        lay_out(input.concept, &frame)
    }

    fn residual<S: Single>(
        &self,
        input: &VehicleInput<S>,
        rule: &FoamRule<S>,
        u: [S; UNKNOWNS],
    ) -> [S; UNKNOWNS] {
        let Trial { layout, room_m, .. } = self.trial(input, rule, &u);
        let structure = &self.structure(&u);
        let foam = rule.at(layout.foam_thickness_m);
        let masses = masses(
            input,
            &layout,
            &Densities { structure, foam },
            &mut Memory::default(),
        );
        let sized = size::walls(input, &size::loads_of(input, &layout, &masses));
        let diameter = match self.by {
            DiameterBy::Asked => input.diameter_m - u[0],
            DiameterBy::Room => room_m,
            DiameterBy::Jump => S::constant(f64::NAN) * u[0],
        };
        let place = match input.concept {
            Concept::Msr => -u[1],
            Concept::NonMsr => masses.cg_x_m - u[1],
        };
        let [a, b, c] = [sized.forebody, sized.aftbody, sized.primary]
            .map(|w| [w.thickness_m, w.face_thickness_m, w.density_kg_m3]);
        let asked = [a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]];
        core::array::from_fn(|k| match k {
            0 => diameter,
            1 => place,
            _ => asked[k - 2] - u[k],
        })
    }

    fn branches<S: Single>(
        &self,
        input: &VehicleInput<S>,
        rule: &FoamRule<S>,
        figures: &Figures<S>,
    ) -> Branches {
        let (layout, d) = (&figures.layout, &figures.dimensions);
        let shoulder_m = (d.shoulder_radius_m - d.input_shoulder_radius_m).value();
        let rules = &input.rules;
        let gap_m = (layout.body_foam_thickness_m + layout.lid_insulation_thickness_m).value();
        let wanted_m = match input.concept {
            Concept::Msr => rules.body_foam_gap_m + rules.lid_insulation_gap_m,
            Concept::NonMsr => rules.payload_lid_gap_m,
        };
        let forebody = &layout.outline.forebody;
        let nose_m = forebody.nose_radius_m - layout.depths.fore_m();
        let ball_m = match input.concept {
            Concept::Msr => layout.impact_sphere_radius_m(),
            Concept::NonMsr => layout.payload_radius_m + layout.foam_thickness_m,
        };
        Branches {
            diameter: self.by,
            shoulder: if shoulder_m.abs() <= ROUNDING_M {
                core::cmp::Ordering::Equal
            } else {
                shoulder_m.total_cmp(&0.0)
            },
            foam_thickened: (layout.foam_thickness_m - rule.least_thickness_m).value() > ROUNDING_M,
            whole_gap: (gap_m - wanted_m).abs() <= ROUNDING_M,
            steepest_by_rule: (forebody.cone_half_angle_rad + rules.wing_slope_max_rad).value()
                < FRAC_PI_2,
            in_nose: ball_m.less(nose_m),
            walls: self.governs,
        }
    }
}
