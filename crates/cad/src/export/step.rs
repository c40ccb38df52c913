//! STEP, application protocol 214: an assembly of solids with analytic surfaces, in millimeters.
//!
//! Each body is a product with name, color, material and density; its solids have planes, cylinders, cones, spheres and
//! tori as faces, lines and circles as edges. Volume, area and centroid are stored with each part as validation
//! properties, so that a reader can check its import.
//!
//! # References
//! - \[iso-10303-21\], \[iso-10303-42\], \[iso-10303-214\].

mod part21;
mod product;
mod shell;

use crate::export::Info;
use crate::export::chain::{Chain, Ends, chains};
use crate::export::model::{Model, Part};
use msape::vehicle::profile::{Profile, SolidProperties};
use part21::{Id, Instances, string};
use product::Assembly;

/// The model as the text of a STEP file.
pub fn step(model: &Model, info: &Info) -> String {
    let mut instances = Instances::default();
    let mut assembly = Assembly::new(&mut instances, &model.name);
    for part in &model.parts.iter().flat_map(single).collect::<Vec<Part>>() {
        let solids = solids(&mut instances, part);
        if !solids.is_empty() {
            assembly.add(&mut instances, part, &solids);
        }
    }
    assembly.finish(&mut instances);
    let name = string(&model.name);
    let (stamp, program) = (string(&info.time_stamp), string(info.program));
    format!(
        "ISO-10303-21;\nHEADER;\n\
         FILE_DESCRIPTION(({name}),'2;1');\n\
         FILE_NAME({name},{stamp},(''),(''),{program},{program},'');\n\
         FILE_SCHEMA(('AUTOMOTIVE_DESIGN {{ 1 0 10303 214 1 1 1 1 }}'));\n\
         ENDSEC;\nDATA;\n{}ENDSEC;\nEND-ISO-10303-21;\n",
        instances.into_text()
    )
}

/// One part for each body: readers attach a material to the product, and not all of them to one of several solids.
fn single(part: &Part) -> Vec<Part> {
    if part.profiles.len() < 2 {
        return vec![part.clone()];
    }
    let one = |(profile, number): (&Profile, usize)| Part {
        key: format!("{}-{number}", part.key),
        name: format!("{} {number}", part.name),
        profiles: vec![profile.clone()],
        ..part.clone()
    };
    part.profiles.iter().zip(1..).map(one).collect()
}

/// Adds the solids of a part.
fn solids(instances: &mut Instances, part: &Part) -> Vec<Id> {
    let mut list = Vec::new();
    for profile in &part.profiles {
        let chains = chains(profile);
        let (outer, voids): (Vec<_>, Vec<_>) = chains
            .iter()
            .filter(|c| c.ends != Ends::Open)
            .partition(|c| enclosed(c) > 0.0);
        for body in outer {
            let inside: Vec<&Chain> = voids
                .iter()
                .copied()
                .filter(|v| contains(body, v))
                .collect();
            list.push(solid(instances, &part.name, body, &inside));
        }
    }
    list
}

fn solid(instances: &mut Instances, name: &str, body: &Chain, voids: &[&Chain]) -> Id {
    let shell = shell::closed_shell(instances, body);
    let name = string(name);
    if voids.is_empty() {
        return instances.add(&format!("MANIFOLD_SOLID_BREP({name},#{shell})"));
    }
    let mut hollow = Vec::with_capacity(voids.len());
    for void in voids {
        // a reversed void is a separate body: its orientation is inside out
        let body = Chain {
            segments: void.segments.iter().rev().map(|s| s.reversed()).collect(),
            ends: void.ends,
        };
        let shell = shell::closed_shell(instances, &body);
        hollow.push(instances.add(&format!("ORIENTED_CLOSED_SHELL('',*,#{shell},.F.)")));
    }
    let voids = part21::list(&hollow);
    instances.add(&format!("BREP_WITH_VOIDS({name},#{shell},{voids})"))
}

/// ∮ r² dx of a chain, positive when its outside is out.
fn enclosed(chain: &Chain) -> f64 {
    chain.segments.iter().map(|s| s.integrals().r2_dx).sum()
}

/// Whether a void lies in a body: both reach the axis, and the void lies between the ends of the body.
fn contains(body: &Chain, void: &Chain) -> bool {
    let ends = |c: &Chain| {
        Some((
            c.segments.first()?.start().x_m,
            c.segments.last()?.end().x_m,
        ))
    };
    match (body.ends, ends(body), ends(void)) {
        (Ends::OnAxis, Some((fore, aft)), Some((to, from))) => fore <= to && from <= aft,
        _ => false,
    }
}

/// Volume, area and centroid of a part.
fn properties(part: &Part) -> SolidProperties {
    let solids = part.profiles.iter().map(Profile::solid);
    solids.fold(SolidProperties::empty(), SolidProperties::plus)
}
