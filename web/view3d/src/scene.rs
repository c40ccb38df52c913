//! Parts of a vehicle as vertex data.

use super::camera::Ball;
use super::lathe::{Edge, edges};
use msape::answer::surface::SurfaceHeating;
use msape::vehicle::Vehicle;
use msape::vehicle::profile::Profile;
use msape::vehicle::segment::{Point, Segment};

/// Chord error as a fraction of the radius: a tenth of a pixel where the vehicle is as wide as a screen.
const CHORD_ERROR: f64 = 1e-4;
/// Numbers per vertex: x, r, axial normal, radial normal, value, side.
const NUMBERS: usize = 6;
/// Bytes per vertex.
pub const STRIDE: usize = 4 * NUMBERS;

/// Range of vertices.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Run {
    /// Index of the first.
    pub first: i32,
    /// Count.
    pub count: i32,
}

/// Vertex ranges of a part.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Part {
    /// Triangles of one slice.
    pub wall: Run,
    /// Closed curves, each as a fan.
    pub faces: Vec<Run>,
    /// Edges of the cut faces.
    pub lines: Run,
    /// Curves, for finding the part under the pointer.
    pub curves: Vec<Vec<Edge>>,
}

/// Complete scene; its buffers are reused.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Vertices, little-endian.
    pub bytes: Vec<u8>,
    /// Parts, in the order of the mass tree.
    pub parts: Vec<Part>,
    /// Bounding sphere.
    pub ball: Ball,
}

impl Scene {
    /// Fills the scene with a vehicle; the outer surface gets its heat flux divided by the largest.
    pub fn fill(&mut self, vehicle: &Vehicle, heating: Option<&SurfaceHeating>) {
        self.clear(&vehicle.outline);
        let outside = &vehicle.outline.segments;
        let value = |segment: &Segment, at: Point| {
            let heating = heating.filter(|_| outside.contains(segment));
            heating.map_or(-1.0, |heating| {
                let flux = heating.heat_flux_w_m2(heating.region(segment), at.r_m);
                (flux / heating.largest_w_m2()) as f32
            })
        };
        let error_m = CHORD_ERROR * 0.5 * vehicle.dimensions.diameter_m;
        for component in vehicle.components.iter().filter(|c| c.volume_m3 > 0.0) {
            self.add(&component.profiles, error_m, value);
        }
    }

    /// Fills the scene with a body of revolution.
    pub fn fill_body(&mut self, outline: &Profile) {
        self.clear(outline);
        let error_m = CHORD_ERROR * f64::from(self.ball.radius_m);
        self.add(std::slice::from_ref(outline), error_m, |_, _| -1.0);
    }

    fn clear(&mut self, outline: &Profile) {
        self.bytes.clear();
        self.parts.clear();
        self.ball = ball(outline);
    }

    fn add(
        &mut self,
        profiles: &[Profile],
        error_m: f64,
        value: impl Fn(&Segment, Point) -> f32 + Copy,
    ) {
        let curves: Vec<Vec<Edge>> = profiles
            .iter()
            .map(|profile| edges(profile, error_m, value))
            .collect();
        let walls: Vec<Edge> = curves
            .iter()
            .flatten()
            .filter(|edge| !edge.is_on_axis())
            .copied()
            .collect();
        let first = self.count();
        for Edge { start, end } in &walls {
            for (corner, side) in [
                (start, 0.0),
                (end, 0.0),
                (end, 1.0),
                (start, 0.0),
                (end, 1.0),
                (start, 1.0),
            ] {
                let numbers = [
                    corner.at.x_m as f32,
                    corner.at.r_m as f32,
                    corner.normal_x as f32,
                    corner.normal_r as f32,
                    corner.value,
                    side,
                ];
                self.push(numbers);
            }
        }
        let wall = self.since(first);
        let faces = curves
            .iter()
            .map(|curve| {
                let first = self.count();
                curve.iter().for_each(|edge| self.point(edge.start.at));
                self.since(first)
            })
            .collect();
        let first = self.count();
        for edge in &walls {
            self.point(edge.start.at);
            self.point(edge.end.at);
        }
        let lines = self.since(first);
        self.parts.push(Part {
            wall,
            faces,
            lines,
            curves,
        });
    }

    fn point(&mut self, at: Point) {
        self.push([at.x_m as f32, at.r_m as f32, 0.0, 0.0, -1.0, 0.0]);
    }

    fn push(&mut self, numbers: [f32; NUMBERS]) {
        for number in numbers {
            self.bytes.extend_from_slice(&number.to_le_bytes());
        }
    }

    fn count(&self) -> i32 {
        (self.bytes.len() / STRIDE) as i32
    }

    fn since(&self, first: i32) -> Run {
        let count = self.count() - first;
        Run { first, count }
    }
}

/// Smallest sphere, centered on the axis, around the ends of the segments and the midpoints of the arcs.
fn ball(outline: &Profile) -> Ball {
    let mut points = Vec::new();
    for segment in &outline.segments {
        points.push(segment.start());
        if let Segment::Arc {
            center,
            radius_m,
            start_angle_rad,
            sweep_rad,
            ..
        } = *segment
        {
            for part in [0.25, 0.5, 0.75] {
                let angle = start_angle_rad + part * sweep_rad;
                points.push(Point {
                    x_m: center.x_m + radius_m * angle.cos(),
                    r_m: center.r_m + radius_m * angle.sin(),
                });
            }
        }
    }
    let radius = |center: f64| {
        let distances = points.iter().map(|p| (p.x_m - center).hypot(p.r_m));
        distances.fold(0.0, f64::max)
    };
    let ends = points.iter().map(|p| p.x_m);
    let (mut low, mut high) = ends.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x), high.max(x))
    });
    // the radius is a convex function of the center
    for _ in 0..40 {
        let third = (high - low) / 3.0;
        if radius(low + third) < radius(high - third) {
            high -= third;
        } else {
            low += third;
        }
    }
    let center = 0.5 * (low + high);
    Ball {
        center_m: center as f32,
        radius_m: radius(center) as f32,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::{Case, Library, Request, design};
    use std::f64::consts::PI;

    #[test]
    fn the_ball_about_a_ball_is_that_ball() {
        let half = Segment::arc(Point { x_m: 3.0, r_m: 0.0 }, 2.0, PI, -PI);
        let profile = Profile {
            segments: vec![half],
        };
        let ball = ball(&profile.closed());
        assert!((ball.center_m - 3.0).abs() < 1e-3, "{ball:?}");
        assert!((ball.radius_m - 2.0).abs() < 1e-3, "{ball:?}");
    }

    #[test]
    fn a_scene_has_the_vehicles_components_and_paints_only_the_outside() {
        let library = Library::builtin().unwrap();
        let answer = design(&Case::run_page(), &library, Request::Nothing).unwrap();
        let vehicle = &answer.design.as_ref().unwrap().vehicle;
        let heating = SurfaceHeating::of(&answer);
        let mut scene = Scene::default();
        scene.fill(vehicle, heating.as_ref());
        let solid = |c: &&msape::vehicle::Component| c.volume_m3 > 0.0;
        assert_eq!(
            scene.parts.len(),
            vehicle.components.iter().filter(solid).count()
        );
        let value = |vertex: i32| {
            let at = vertex as usize * STRIDE + 16;
            f32::from_le_bytes(scene.bytes[at..at + 4].try_into().unwrap())
        };
        let painted = |part: &Part| {
            (part.wall.first..part.wall.first + part.wall.count).any(|v| value(v) >= 0.0)
        };
        let which: Vec<bool> = scene.parts.iter().map(painted).collect();
        let wetted: Vec<bool> = vehicle
            .components
            .iter()
            .filter(solid)
            .map(|c| c.wetted_area_m2 > 0.0)
            .collect();
        assert_eq!(which, wetted);
        // filling again gives the same scene
        let before = scene.clone();
        scene.fill(vehicle, heating.as_ref());
        assert_eq!(
            (before.bytes, before.parts),
            (scene.bytes, scene.parts.clone())
        );
    }
}
