//! The shapes of all components of a vehicle: closed curves that are revolved about the axis.
//!
//! ```text
//! layers of forebody and aftbody | primary structure | wing | filling of the concept | payload
//! ```
//!
//! with lengths in m; each layer between two surfaces of the outer mold line at a depth.
//!
//! # Valid
//! Same as [`crate::vehicle::outline`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.4 and Table 1.

use crate::vehicle::draft::{Draft, Memory};
use crate::vehicle::kinds::{ComponentKind, Concept};
use crate::vehicle::layout::Layout;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use crate::vehicle::{msr, non_msr};
use numerics::math::PI;
use numerics::scalar::Single;

/// Draws every component, in the order in which they are summed.
pub fn draw<S: Single>(concept: Concept, layout: &Layout<S>, draft: &mut Draft<S>) {
    let (d, outline) = (&layout.depths, &layout.outline);
    draft.layers(
        [
            ComponentKind::ForebodyTps,
            ComponentKind::Bond,
            ComponentKind::ForebodyCarrier,
        ],
        [d.forebody_tps_m, d.forebody_tps_m + d.bond_m, d.fore_m()],
        |path, depth_m| outline.fore_layer(path, depth_m, S::constant(0.0)),
    );
    draft.layers(
        [ComponentKind::AftbodyTps, ComponentKind::AftbodyCarrier],
        [d.aftbody_tps_m, d.aft_m()],
        |path, depth_m| outline.aft_layer(path, depth_m),
    );
    draft.part(ComponentKind::PrimaryStructure, |path| {
        if d.primary_m.value() > 0.0 {
            primary(path, layout)
        } else {
            path
        }
    });
    draft.part(ComponentKind::WingInsulation, |path| wing(path, layout));
    match concept {
        Concept::Msr => msr::filling(layout, draft),
        Concept::NonMsr => non_msr::filling(layout, draft),
    }
    draft.part(ComponentKind::Payload, |path| {
        let center = Point::on_axis(layout.payload_x_m);
        let half = S::constant(PI);
        path.and(Segment::arc(center, layout.payload_radius_m, half, -half))
    });
}

/// The profiles of every component, in the order in which they are summed.
pub fn profiles(concept: Concept, layout: &Layout) -> Vec<(ComponentKind, Vec<Profile>)> {
    let mut all: Vec<(ComponentKind, Vec<Profile>)> = Vec::with_capacity(ComponentKind::COUNT);
    let mut keep = |kind, profile: &Profile| {
        if all.last().is_none_or(|(last, _)| *last != kind) {
            all.push((kind, Vec::new()));
        }
        if let Some((_, profiles)) = all.last_mut()
            && !profile.segments.is_empty()
        {
            profiles.push(profile.clone());
        }
    };
    let mut memory = Memory::default();
    draw(concept, layout, &mut Draft::new(&mut memory, &mut keep));
    all
}

fn primary<S: Single>(path: Profile<S>, layout: &Layout<S>) -> Profile<S> {
    let (inner, outer) = (layout.primary_inner_r_m(), layout.primary_outer_r_m());
    let x_m = layout.outline.attached_structure_x_m - layout.depths.aft_m();
    let forebody = &layout.outline.forebody;
    let foot = forebody.between(path, layout.depths.fore_m(), [inner, outer]);
    foot.line_to(Point { x_m, r_m: outer })
        .line_to(Point { x_m, r_m: inner })
}

fn wing<S: Single>(path: Profile<S>, layout: &Layout<S>) -> Profile<S> {
    let (fore, aft) = (layout.depths.fore_m(), layout.depths.aft_m());
    let outline = &layout.outline;
    let wall_r = layout.primary_outer_r_m();
    let x_m = outline.attached_structure_x_m - aft;
    outline
        .fore_layer(path, fore, wall_r)
        .line_to(outline.on_tip_line(outline.forebody.shoulder_radius_m - aft))
        .line_to(Point {
            x_m,
            r_m: outline.annulus_outer_r_m(aft),
        })
        .line_to(Point { x_m, r_m: wall_r })
}
