//! Checks the center of gravity against the outline.

use super::forms::one_row;
use super::outline::Outline;
use crate::case::Reader;
use crate::quantity::input;
use crate::vehicle::profile::Profile;

/// Pieces into which a segment is cut.
const PIECES: u32 = 256;

/// Center of gravity, m; it must be inside the outline, and given where moments depend on it.
pub(super) fn cg(reader: &mut Reader, outline: &Outline, moments: bool) -> Option<[f64; 3]> {
    let key = &input::vehicle::CG_M;
    let Some(cg) = one_row::<3>(reader, key)? else {
        if moments {
            reader.fault(
                key,
                "missing; give x aft of the virtual apex, y and z, in m",
            );
            return None;
        }
        return Some([0.0; 3]);
    };
    if let Outline::Body(body) = outline {
        let [x, y, z] = cg;
        let r = (y * y + z * z).sqrt();
        let apex = body.virtual_apex_x_m.unwrap_or_else(|| body.nose_tip_x_m());
        if !contains(&body.outline, x + apex, r) {
            let [from, to] = body.extent_m().map(|x_m| x_m - apex);
            let radius = 0.5 * body.diameter_m;
            let message = format!(
                "got x {x} m, {r} m from the axis, which is outside the outline; must be within it, x {from:.4} to {to:.4} m and at most {radius:.4} m from the axis"
            );
            reader.fault(key, message);
            return None;
        }
    }
    Some(cg)
}

/// Whether a point of the half-plane is inside a closed outline: a ray away from the axis leaves it an odd number of times.
fn contains(outline: &Profile, x_m: f64, r_m: f64) -> bool {
    let mut crossings = 0;
    for segment in &outline.segments {
        // the segment that closes the outline along the axis is not a wall
        if segment.bounds_m()[3] == 0.0 {
            continue;
        }
        let mut before = segment.start();
        for i in 1..=PIECES {
            let here = segment.at(f64::from(i) / f64::from(PIECES));
            if (before.x_m > x_m) != (here.x_m > x_m) {
                let part = (x_m - before.x_m) / (here.x_m - before.x_m);
                if before.r_m + part * (here.r_m - before.r_m) >= r_m {
                    crossings += 1;
                }
            }
            before = here;
        }
    }
    crossings % 2 == 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::segment::{Point, Segment};
    use numerics::math::FRAC_PI_2;

    #[test]
    fn inside_and_outside_of_a_half_ball_on_a_cone() {
        // A quarter circle from the axis at x = -1 to (0, 1), a line back to the axis at x = 1.
        let arc = Segment::arc(Point::on_axis(0.0), 1.0, 2.0 * FRAC_PI_2, -FRAC_PI_2);
        let outline = Profile {
            segments: vec![arc],
        }
        .line_to(Point::on_axis(1.0))
        .closed();
        for (x, r, inside) in [
            (0.0, 0.0, true),
            (-0.5, 0.8, true),
            (-0.5, 0.9, false),
            (0.5, 0.49, true),
            (0.5, 0.51, false),
            (1.1, 0.0, false),
            (-1.1, 0.0, false),
        ] {
            assert_eq!(contains(&outline, x, r), inside, "{x} {r}");
        }
    }

    #[test]
    fn a_ball_of_one_arc_has_an_inside() {
        let ball = Profile {
            segments: vec![Segment::arc(
                Point::on_axis(1.0),
                1.0,
                2.0 * FRAC_PI_2,
                -2.0 * FRAC_PI_2,
            )],
        };
        let ball = ball.closed();
        for (x, r, inside) in [(1.0, 0.0, true), (1.0, 1.01, false), (2.5, 0.0, false)] {
            assert_eq!(contains(&ball, x, r), inside, "{x} {r}");
        }
    }
}
