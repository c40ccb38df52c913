//! Mass properties after landing: the payload has moved forward by the stroke and has crushed the foam ahead of it.
//!
//! ```text
//! dm = ρ (b − a) 2π r dr                       foam from x = a to the payload at b, in a column at the distance r from the axis
//! a..b → a..b − s                              each column keeps its mass and its r
//! Δ ∫ x dm = −ρ V s / 2                        V the volume of all columns, r < Rₚ
//! Δ ∫ x² dm = ∫ [(a² + a b' + b'²) − (a² + a b + b²)] / 3 dm,  b' = b − s
//! ```
//!
//! with the density ρ in kg/m³, lengths in m, Rₚ the payload's radius and s the stroke. Behind the payload a void of π Rₚ² s is left;
//! the foam around it does not change. All terms are exact but the last integral, by quadrature to nine digits.
//!
//! # Valid
//! Landing on the nose, one-dimensional crush: the payload a homogeneous ball, each column of uniform density. The stroke is cut at
//! 95 % of the foam's thickness.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5 for the stroke; how the foam is compressed is a choice of ours.

use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::kinds::Concept;
use crate::vehicle::layout::Layout;
use crate::vehicle::mass::{MassProperties, Part, total};
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI};
use numerics::quadrature::Rule;
use numerics::scalar::Single;
use numerics::scalar::functions::{asin, sin_cos};

/// Largest stroke over foam thickness.
const MOST_STROKE: f64 = 0.95;
/// Panels of the quadrature, denser where thin foam bends the most: at the payload's equator.
const PANELS: u32 = 8;

/// Mass properties with the payload moved forward by `stroke_m` into the foam.
pub fn crushed<S: Single>(
    concept: Concept,
    layout: &Layout<S>,
    parts: impl Iterator<Item = (ComponentKind, Part<S>)>,
    stroke_m: S,
) -> MassProperties<S> {
    let stroke_m = stroke_m.min(layout.foam_thickness_m * MOST_STROKE);
    total(parts.map(|(kind, part)| {
        let after = match kind {
            ComponentKind::Payload => Part {
                cg_x_m: part.cg_x_m - stroke_m,
                ..part
            },
            ComponentKind::ImpactFoam => foam(concept, layout, part, stroke_m),
            _ => part,
        };
        (kind, after)
    }))
}

/// The foam with the columns ahead of the payload compressed.
fn foam<S: Single>(concept: Concept, layout: &Layout<S>, part: Part<S>, stroke_m: S) -> Part<S> {
    let mass_kg = part.mass_with_margin_kg;
    let density = mass_kg / part.volume_m3;
    let columns_m3 = columns(concept, layout).solid().volume_m3;
    let shift = density * 0.5 * columns_m3 * stroke_m;
    let cg_x_m = part.cg_x_m - shift / mass_kg;
    let about_apex = part.iyy_kg_m2
        + mass_kg * part.cg_x_m * part.cg_x_m
        + density * second_moment_change_m5(concept, layout, stroke_m);
    let radius = layout.payload_radius_m;
    Part {
        volume_m3: part.volume_m3 - radius * PI * radius * stroke_m,
        cg_x_m,
        iyy_kg_m2: about_apex - mass_kg * cg_x_m * cg_x_m,
        ..part
    }
}

/// The foam ahead of the payload, within its radius.
fn columns<S: Single>(concept: Concept, layout: &Layout<S>) -> Profile<S> {
    let radius_m = layout.payload_radius_m;
    let center = Point::on_axis(layout.payload_x_m);
    let [axis, quarter, half] = [0.0, FRAC_PI_2, PI].map(S::constant);
    let front = match concept {
        Concept::Msr => {
            let outer_m = radius_m + layout.foam_thickness_m;
            let sweep_rad = -asin(radius_m / outer_m);
            Profile::default().and(Segment::arc(center, outer_m, half, sweep_rad))
        }
        Concept::NonMsr => {
            let forebody = &layout.outline.forebody;
            forebody.between(Profile::default(), layout.depths.fore_m(), [axis, radius_m])
        }
    };
    front
        .and(Segment::arc(center, radius_m, quarter, quarter))
        .closed()
}

/// Change of ∫ x² dV, each volume weighted by its value before the crush, m⁵.
fn second_moment_change_m5<S: Single>(concept: Concept, layout: &Layout<S>, stroke_m: S) -> S {
    let radius = layout.payload_radius_m;
    let forebody = &layout.outline.forebody;
    let fore_m = layout.depths.fore_m();
    let outer = radius + layout.foam_thickness_m;
    let floor_x_m = |r: S| match concept {
        Concept::Msr => layout.payload_x_m - (outer * outer - r * r).sqrt(),
        Concept::NonMsr => forebody.depth_x_m(fore_m, r),
    };
    // r = Rₚ sin u: the payload's surface is smooth in u
    let along = |u: S| {
        let (s, c) = sin_cos(u);
        let (a, b) = (floor_x_m(radius * s), layout.payload_x_m - radius * c);
        let b_new = b - stroke_m;
        let change = a * (b_new - b) + b_new * b_new - b * b;
        radius * (2.0 * PI) * s * radius * c * (b - a) * change / 3.0
    };
    // the curvature jumps where the nose joins the cone
    let [axis, equator] = [0.0, FRAC_PI_2].map(S::constant);
    let kink = match concept {
        Concept::Msr => equator,
        Concept::NonMsr => {
            let part = forebody.nose_tangent(fore_m).r_m / radius;
            asin(part.clamp(axis, S::constant(1.0)))
        }
    };
    Rule::Gauss8.composite(along, [axis, kink], PANELS)
        + Rule::Gauss8.composite(along, [kink, equator], PANELS)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::build;
    use crate::vehicle::mass::Component;
    use crate::vehicle::tests::{galahad, msr};

    #[test]
    fn without_stroke_nothing_moves() {
        for input in [msr(), galahad()] {
            let vehicle = build(&input).unwrap();
            let same = crushed(
                input.concept,
                &vehicle.layout,
                vehicle.components.iter().map(Component::part),
                0.0,
            );
            let close = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
            close(same.mass_kg, vehicle.mass.mass_kg);
            close(same.cg_x_m, vehicle.mass.cg_x_m);
            close(same.iyy_kg_m2, vehicle.mass.iyy_kg_m2);
            close(same.ixx_kg_m2, vehicle.mass.ixx_kg_m2);
        }
    }

    #[test]
    fn the_payload_sweeps_its_cross_section_times_the_stroke() {
        for input in [msr(), galahad()] {
            let vehicle = build(&input).unwrap();
            let (layout, mass) = (&vehicle.layout, vehicle.mass);
            let stroke = 0.4 * layout.foam_thickness_m;
            let after = crushed(
                input.concept,
                layout,
                vehicle.components.iter().map(Component::part),
                stroke,
            );
            let r = layout.payload_radius_m;
            assert!((mass.volume_m3 - after.volume_m3 - PI * r * r * stroke).abs() < 1e-12);
            assert_eq!(after.mass_without_margin_kg, mass.mass_without_margin_kg);
            // payload forward by the stroke, the column's foam by less than that
            let forward = (mass.cg_x_m - after.cg_x_m) * mass.mass_kg;
            let least = input.payload_mass_kg * stroke;
            let foam = vehicle.component(ComponentKind::ImpactFoam).unwrap();
            let most = least + foam.mass_with_margin_kg * stroke;
            assert!(
                forward > least && forward < most,
                "{least} {forward} {most}"
            );
            // no sideways motion
            assert_eq!(after.ixx_kg_m2, mass.ixx_kg_m2);
        }
    }

    #[test]
    fn the_second_moment_agrees_with_ten_thousand_rings() {
        for input in [msr(), galahad()] {
            let layout = build(&input).unwrap().layout;
            let (s, radius) = (0.5 * layout.foam_thickness_m, layout.payload_radius_m);
            let outer = radius + layout.foam_thickness_m;
            let n = 10_000;
            let mut sum = 0.0;
            for k in 0..n {
                let r = radius * (f64::from(k) + 0.5) / f64::from(n);
                let a = match input.concept {
                    Concept::Msr => layout.payload_x_m - (outer * outer - r * r).sqrt(),
                    Concept::NonMsr => layout.outline.forebody.depth_x_m(layout.depths.fore_m(), r),
                };
                let b = layout.payload_x_m - (radius * radius - r * r).sqrt();
                // (b − a) dx²/dm: a bar from a to b has (a² + ab + b²)/3
                let mean = |b: f64| (a * a + a * b + b * b) / 3.0;
                sum += 2.0 * PI * r * radius / f64::from(n) * (b - a) * (mean(b - s) - mean(b));
            }
            let exact = second_moment_change_m5(input.concept, &layout, s);
            // the midpoint rule errs by (1/n)^1.5 where the ball is upright
            assert!((sum / exact - 1.0).abs() < 1e-5, "{sum} {exact}");
        }
    }

    #[test]
    fn a_stroke_beyond_the_foam_is_cut() {
        let vehicle = build(&msr()).unwrap();
        let at = |stroke| {
            crushed(
                Concept::Msr,
                &vehicle.layout,
                vehicle.components.iter().map(Component::part),
                stroke,
            )
        };
        assert_eq!(at(10.0), at(MOST_STROKE * vehicle.layout.foam_thickness_m));
        assert!(at(10.0).iyy_kg_m2.is_finite());
    }
}
