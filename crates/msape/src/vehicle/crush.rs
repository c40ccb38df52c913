//! Mass properties after landing: the payload has moved forward by the stroke and has crushed the foam ahead of it.
//!
//! ```text
//! ρ' V' = ρ V,  V' = V − π Rₚ² s        column of foam ahead of the payload, before and after
//! M' = M,  x_cg' = (M x_cg − m_p s + ρ' ∬ x dV' − ρ ∬ x dV) / M
//! ```
//!
//! with the density ρ in kg/m³ and the volume V in m³ of the column, Rₚ the payload's radius and s the stroke in m, m_p the payload's
//! mass in kg. Behind the payload a void is left; the foam beside the column stays as it is. Integrals are exact.
//!
//! # Valid
//! Landing on the nose, one-dimensional crush: the payload a homogeneous ball, the crushed column of uniform density. The stroke is cut at
//! 95 % of the foam's thickness.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5 for the stroke; how the foam is compressed is a choice of ours.

use crate::vehicle::input::Concept;
use crate::vehicle::layout::Layout;
use crate::vehicle::mass::{Component, ComponentKind, MassProperties, total};
use crate::vehicle::profile::{Profile, SolidProperties};
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, asin};

/// Largest stroke over foam thickness.
const MOST_STROKE: f64 = 0.95;

/// Mass properties with the payload moved forward by `stroke_m` into the foam.
pub fn crushed(
    concept: Concept,
    layout: &Layout,
    components: &[Component],
    stroke_m: f64,
) -> MassProperties {
    let stroke_m = stroke_m.min(MOST_STROKE * layout.foam_thickness_m);
    let before = column(concept, layout, 0.0).solid();
    let after = column(concept, layout, stroke_m).solid();
    let compression = before.volume_m3 / after.volume_m3;
    let parts: Vec<Component> = components
        .iter()
        .map(|part| match part.kind {
            ComponentKind::Payload => Component {
                cg_x_m: part.cg_x_m - stroke_m,
                ..part.clone()
            },
            ComponentKind::ImpactFoam => foam(part, before, after, compression),
            _ => part.clone(),
        })
        .collect();
    total(&parts)
}

/// The foam with its column compressed: the same mass in less volume.
fn foam(
    part: &Component,
    before: SolidProperties,
    after: SolidProperties,
    compression: f64,
) -> Component {
    let moved = |whole: f64, before: f64, after: f64| whole - before + compression * after;
    let (whole, mass_kg) = (part.solid, part.mass_with_margin_kg);
    // with the mean density of the foam: the compressed column counts with its own
    let density = mass_kg / whole.volume_m3;
    let moment = moved(
        whole.volume_moment_m4,
        before.volume_moment_m4,
        after.volume_moment_m4,
    );
    let axial = moved(
        whole.axial_second_moment_m5,
        before.axial_second_moment_m5,
        after.axial_second_moment_m5,
    );
    let transverse = moved(
        whole.transverse_second_moment_m5,
        before.transverse_second_moment_m5,
        after.transverse_second_moment_m5,
    );
    let cg_x_m = moment / whole.volume_m3;
    Component {
        volume_m3: whole.volume_m3 - before.volume_m3 + after.volume_m3,
        cg_x_m,
        ixx_kg_m2: density * axial,
        iyy_kg_m2: density * transverse - mass_kg * cg_x_m * cg_x_m,
        ..part.clone()
    }
}

/// The foam ahead of the payload, within its radius, when it has moved by `stroke_m`.
fn column(concept: Concept, layout: &Layout, stroke_m: f64) -> Profile {
    let radius_m = layout.payload_radius_m;
    let front = match concept {
        Concept::Msr => {
            let outer_m = radius_m + layout.foam_thickness_m;
            let center = Point::on_axis(layout.payload_x_m);
            let sweep_rad = -asin(radius_m / outer_m);
            Profile {
                segments: vec![Segment::arc(center, outer_m, PI, sweep_rad)],
            }
        }
        Concept::NonMsr => {
            let forebody = &layout.outline.forebody;
            forebody.between(layout.depths.fore_m(), 0.0, radius_m)
        }
    };
    let center = Point::on_axis(layout.payload_x_m - stroke_m);
    let payload = Segment::arc(center, radius_m, FRAC_PI_2, FRAC_PI_2);
    front
        .then(&Profile {
            segments: vec![payload],
        })
        .closed()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::build;
    use crate::vehicle::tests::{galahad, msr};

    #[test]
    fn without_stroke_nothing_moves() {
        for input in [msr(), galahad()] {
            let vehicle = build(&input).unwrap();
            let same = crushed(input.concept, &vehicle.layout, &vehicle.components, 0.0);
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
            let after = crushed(input.concept, layout, &vehicle.components, stroke);
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
            // nothing goes sideways but towards the axis' plane: the inertia about the axis stays
            assert!((after.ixx_kg_m2 / mass.ixx_kg_m2 - 1.0).abs() < 0.01);
        }
    }

    #[test]
    fn a_stroke_beyond_the_foam_is_cut() {
        let vehicle = build(&msr()).unwrap();
        let at = |stroke| crushed(Concept::Msr, &vehicle.layout, &vehicle.components, stroke);
        assert_eq!(at(10.0), at(MOST_STROKE * vehicle.layout.foam_thickness_m));
        assert!(at(10.0).iyy_kg_m2.is_finite());
    }
}
