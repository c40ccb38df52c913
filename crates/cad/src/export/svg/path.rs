//! Transformation from the half-section to the sheet.

use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};
use numerics::math::PI;

/// Scale and position of the section on the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Millimeters of the body per millimeter of the sheet.
    pub scale: f64,
    /// Axial position of the nose, m.
    pub nose_x_m: f64,
    /// Position of the nose on the sheet, mm.
    pub left_mm: f64,
    /// Position of the axis on the sheet, mm.
    pub axis_mm: f64,
}

impl View {
    /// Position on the sheet, mm; `half` is 1 above the axis, −1 below.
    pub fn at(&self, point: Point, half: f64) -> [f64; 2] {
        let per_m = 1000.0 / self.scale;
        [
            self.left_mm + (point.x_m - self.nose_x_m) * per_m,
            self.axis_mm - half * point.r_m * per_m,
        ]
    }

    /// Path of a closed profile.
    pub fn path(&self, profile: &Profile, half: f64) -> String {
        format!("{}Z", self.run(profile.segments.iter(), half))
    }

    /// Path without the segments on the axis.
    pub fn open_path(&self, profile: &Profile, half: f64) -> String {
        let off_axis = |s: &&Segment| s.start().r_m != 0.0 || s.end().r_m != 0.0 || is_arc(s);
        self.run(profile.segments.iter().filter(off_axis), half)
    }

    fn run<'a>(&self, segments: impl Iterator<Item = &'a Segment>, half: f64) -> String {
        let mut text = String::new();
        let mut last: Option<Point> = None;
        for segment in segments {
            if last != Some(segment.start()) {
                let letter = if last.is_none() { 'M' } else { 'L' };
                text.push_str(&self.to(letter, segment.start(), half));
            }
            match *segment {
                Segment::Line { end, .. } => text.push_str(&self.to('L', end, half)),
                Segment::Arc {
                    center,
                    radius_m,
                    start_angle_rad,
                    sweep_rad,
                    end,
                    ..
                } => {
                    // two pieces of at most a half-turn each, so that the large-arc flag is always 0
                    let piece = sweep_rad / 2.0;
                    let middle = Segment::arc(center, radius_m, start_angle_rad, piece).end();
                    let radius = radius_m * 1000.0 / self.scale;
                    let large = u8::from(piece.abs() > PI);
                    // y of the sheet points down
                    let turn = u8::from((sweep_rad < 0.0) == (half > 0.0));
                    for point in [middle, end] {
                        let [x, y] = self.at(point, half);
                        text.push_str(&format!(
                            "A{radius:.4} {radius:.4} 0 {large} {turn} {x:.4} {y:.4}"
                        ));
                    }
                }
            }
            last = Some(segment.end());
        }
        text
    }

    fn to(&self, letter: char, point: Point, half: f64) -> String {
        let [x, y] = self.at(point, half);
        format!("{letter}{x:.4} {y:.4}")
    }
}

fn is_arc(segment: &Segment) -> bool {
    matches!(segment, Segment::Arc { .. })
}

/// A point at the largest distance from the axis.
pub fn widest(profile: &Profile) -> Point {
    let points = profile.segments.iter().flat_map(|segment| {
        let top = match *segment {
            Segment::Arc {
                center, radius_m, ..
            } if segment.bounds_m()[3] > segment.start().r_m.max(segment.end().r_m) => Point {
                x_m: center.x_m,
                r_m: center.r_m + radius_m,
            },
            segment => segment.start(),
        };
        [top, segment.end()]
    });
    points.fold(
        Point::default(),
        |best, p| if p.r_m > best.r_m { p } else { best },
    )
}
