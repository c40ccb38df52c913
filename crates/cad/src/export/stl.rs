//! STL, binary: the outer surface as triangles, in millimeters, watertight.
//!
//! The format has no unit; programs for 3-D printing expect millimeters, and the header names the unit.

use crate::export::mesh::{self, MeshOptions};
use crate::export::model::Model;

/// Ratio of the chord error to the diameter.
const CHORD_ERROR: f64 = 1e-4;

/// Millimeters in a meter.
const MM_PER_M: f32 = 1000.0;

/// Chord error for a model, m.
pub fn chord_error_m(model: &Model) -> f64 {
    let [_, _, widest] = model.extent_m();
    2.0 * CHORD_ERROR * widest
}

/// The model as the bytes of an STL file.
pub fn stl(model: &Model) -> Vec<u8> {
    let options = MeshOptions::whole(chord_error_m(model));
    let mesh = mesh::mesh(std::slice::from_ref(&model.outline), &options);
    let mut bytes = Vec::with_capacity(84 + 50 * mesh.triangles.len());
    // a binary file must not begin with "solid", which marks the text form
    let header = format!("Units: mm. {}", model.name);
    bytes.extend(header.bytes().chain(std::iter::repeat(b' ')).take(80));
    bytes.extend((mesh.triangles.len() as u32).to_le_bytes());
    for (t, [a, b, c]) in mesh.triangles.iter().zip(mesh.corners_m()) {
        let normal = (b - a).cross(&(c - a));
        let length = normal.norm_squared().sqrt();
        let part = |v: f64| {
            if length > 0.0 {
                (v / length) as f32
            } else {
                0.0
            }
        };
        let unit = <[f64; 3]>::from(normal).map(part);
        let corners = t.map(|i| {
            mesh.positions_m
                .get(i as usize)
                .copied()
                .unwrap_or_default()
        });
        for v in std::iter::once(unit).chain(corners.map(|p| p.map(|v| v * MM_PER_M))) {
            v.iter().for_each(|v| bytes.extend(v.to_le_bytes()));
        }
        bytes.extend([0, 0]);
    }
    bytes
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::model::Measures;
    use msape::vehicle::profile::Profile;
    use msape::vehicle::segment::{Point, Segment};
    use nalgebra::Vector3;
    use numerics::math::PI;
    use std::collections::BTreeMap;

    #[test]
    fn a_ball_of_1_m_is_closed_and_has_its_volume_in_mm() {
        let half = Segment::arc(Point::on_axis(1.0), 0.5, PI, -PI);
        let profile = Profile {
            segments: vec![half],
        }
        .closed();
        let bytes = stl(&Model::of_outline("Ball", &profile, Measures::default()));
        let count = u32::from_le_bytes(bytes[80..84].try_into().unwrap()) as usize;
        assert_eq!(bytes.len(), 84 + 50 * count);
        assert_eq!(&bytes[..16], b"Units: mm. Ball ");
        // chords of 4 asin √(1e-4) = 0.04 rad: 158 around the axis, 79 from pole to pole
        assert_eq!(count, 2 * 158 * (79 - 1));
        let (mut edges, mut volume) = (BTreeMap::new(), 0.0);
        for triangle in bytes[84..].chunks(50) {
            let number =
                |i: usize| f32::from_le_bytes(triangle[4 * i..4 * i + 4].try_into().unwrap());
            let corner = |k: usize| [number(3 * k), number(3 * k + 1), number(3 * k + 2)];
            let [a, b, c] = [1, 2, 3].map(corner);
            let [x, y, z] = [a, b, c].map(|p| Vector3::from(p).map(f64::from));
            volume += x.dot(&y.cross(&z)) / 6.0;
            for (from, to) in [(a, b), (b, c), (c, a)] {
                *edges
                    .entry([from, to].map(|p| p.map(f32::to_bits)))
                    .or_insert(0) += 1;
            }
        }
        for (&[from, to], count) in &edges {
            assert_eq!((*count, edges.get(&[to, from])), (1, Some(&1)));
        }
        // the chord error of 1e-4 of the diameter, twice, over a third of the radius
        let exact = PI / 6.0 * 1e9;
        assert!((volume / exact - 1.0).abs() < 1.2e-3, "{volume}");
    }
}
