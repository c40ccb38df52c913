//! CSV of the half-section: one row per segment of the outer mold line and of every part, in millimeters.
//!
//! Angles describe arcs, positive from the x axis towards the r axis. Component `outline` comes first; on its own it is
//! an outline that `outline.file` of a case can read.

use crate::export::chain::chains;
use crate::export::model::Model;
use msape::units::number::shortest;
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::RADIANS_PER_DEGREE;

/// Lengths in the file are in millimeters.
const MM_PER_M: f64 = 1000.0;

/// Column names.
pub const HEADER: &str = "component,body,segment,kind,x_start_mm,r_start_mm,x_end_mm,r_end_mm,\
                          x_center_mm,r_center_mm,radius_mm,sweep_deg";

/// The half-section as CSV.
pub fn csv(model: &Model) -> String {
    let mut text = format!("{HEADER}\n");
    rows(&mut text, "outline", std::slice::from_ref(&model.outline));
    for part in &model.parts {
        rows(&mut text, &part.key, &part.profiles);
    }
    text
}

fn rows(text: &mut String, component: &str, profiles: &[Profile]) {
    for (profile, body) in profiles.iter().zip(1..) {
        let segments = chains(profile).into_iter().flat_map(|c| c.segments);
        for (segment, number) in segments.zip(1..) {
            let (kind, numbers) = row(&segment);
            text.push_str(&format!("{component},{body},{number},{kind},{numbers}\n"));
        }
    }
}

fn row(segment: &Segment) -> (&'static str, String) {
    let mm = |p: Point| [p.x_m * MM_PER_M, p.r_m * MM_PER_M];
    let joined = |numbers: Vec<f64>| {
        let numbers: Vec<String> = numbers.into_iter().map(shortest).collect();
        numbers.join(",")
    };
    match *segment {
        Segment::Line { start, end } => ("line", joined([mm(start), mm(end)].concat()) + ",,,,"),
        Segment::Arc {
            start,
            end,
            center,
            radius_m,
            sweep_rad,
            ..
        } => {
            let mut numbers = [mm(start), mm(end), mm(center)].concat();
            numbers.extend([radius_m * MM_PER_M, sweep_rad / RADIANS_PER_DEGREE]);
            ("arc", joined(numbers))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::model::Measures;
    use numerics::math::PI;

    #[test]
    fn a_ball_of_half_a_meter() {
        let half = Segment::arc(Point::on_axis(1.0), 0.5, PI, -PI);
        let profile = Profile {
            segments: vec![half],
        }
        .closed();
        let text = csv(&Model::of_outline("Ball", &profile, Measures::default()));
        let arc = "1,1,arc,500,0,1500,0,1000,0,500,-180";
        assert_eq!(text, format!("{HEADER}\noutline,{arc}\nbody,{arc}\n"));
    }
}
