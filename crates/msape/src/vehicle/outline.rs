//! Outer mold line and its layers: forebody, shoulder, wing, annulus and lid, each followed at any depth.
//!
//! ```text
//! (x_a − x_s) cos φ + (r_s − r_a) sin φ = R_s       wing line from the annulus (x_a, r_a) tangent to the shoulder (x_s, r_s)
//! r_L² = R_L² − (x_a − x_L)²,  r_a = r_L + 60 mm     foot of the lid, of radius R_L about x_L; outer edge of the annulus
//! t + t_a sin(θ + φ) ≤ R_s [1 + sin(θ + φ)]         layers t of the forebody and t_a of the aftbody fit into the shoulder
//! ```
//!
//! with x from the virtual apex and r from the axis in m, φ the slope of the wing's aft side against the plane normal to
//! the axis in rad (positive: the wing is thicker at its root), θ the cone half-angle in rad.
//! The forebody's layers run round the shoulder up to the tangent point of the wing line; there, on the line normal to
//! the wing through the center of the shoulder (the *tip line*), the aftbody's layers begin. A layer deeper than the
//! shoulder radius ends on the tip line.
//!
//! # Valid
//! 0 < φ ≤ π/2 − θ.
//!
//! # References
//! - \[samareh-2014\] sections 3.1.2 and 3.1.4; its Figures 14-18 being lost, the construction is deduced from the text.

use crate::vehicle::forebody::Forebody;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment, half_chord_m};
use numerics::math::FRAC_PI_2;
use numerics::scalar::Single;
use numerics::scalar::functions::{asin, hypot, sin_cos};
use serde::{Deserialize, Serialize};

/// The whole outer mold line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Outline<S = f64> {
    /// Nose, cone and shoulder.
    pub forebody: Forebody<S>,
    /// Slope of the wing's aft side against the plane normal to the axis, rad.
    pub wing_slope_rad: S,
    /// Axial position of the annulus, to whose inside the primary structure is attached, m.
    pub attached_structure_x_m: S,
    /// Width of the annulus, m.
    pub annulus_width_m: S,
    /// Outer radius of the lid, m.
    pub lid_radius_m: S,
    /// Axial position of the lid's center of curvature, m.
    pub lid_center_x_m: S,
}

/// Slope of the line from the annulus edge `edge` that touches the aft side of the shoulder, rad; `None` when there is none.
pub fn wing_slope_rad<S: Single>(forebody: &Forebody<S>, edge: Point<S>) -> Option<S> {
    let center = forebody.shoulder_center();
    let (dx, dr) = (edge.x_m - center.x_m, center.r_m - edge.r_m);
    let (distance, radius) = (hypot(dx, dr), forebody.shoulder_radius_m);
    (dr.value() > 0.0 && radius.less(distance)).then(|| asin(radius / distance) - dx.atan2(dr))
}

/// Smallest shoulder radius into which layers of `fore_m` and `aft_m` fit at the wing slope `slope_rad`, m.
pub fn smallest_shoulder_radius_m<S: Single>(
    fore_m: S,
    aft_m: S,
    cone_half_angle_rad: S,
    slope_rad: S,
) -> S {
    let cos_delta = (cone_half_angle_rad + slope_rad).sin();
    (fore_m + aft_m * cos_delta) / (cos_delta + 1.0)
}

impl<S: Single> Outline<S> {
    /// Radius of the lid's surface at depth `depth_m` where it meets the plane of the annulus, m.
    pub fn lid_foot_r_m(&self, depth_m: S) -> S {
        let height = self.attached_structure_x_m - self.lid_center_x_m;
        let radius = self.lid_radius_m - depth_m;
        half_chord_m(radius, height)
    }

    /// Point on the tip line, `aft_m` behind the center of the shoulder.
    pub fn on_tip_line(&self, aft_m: S) -> Point<S> {
        let (center, (s, c)) = (
            self.forebody.shoulder_center(),
            sin_cos(self.wing_slope_rad),
        );
        Point {
            x_m: center.x_m + aft_m * c,
            r_m: center.r_m - aft_m * s,
        }
    }

    /// `path` with the forebody's surface at depth `depth_m`, from the distance `inner_r_m` off the axis outwards and round the
    /// shoulder to the tip line.
    pub fn fore_layer(&self, path: Profile<S>, depth_m: S, inner_r_m: S) -> Profile<S> {
        let cone_end = self.cone_end(depth_m);
        let path = self
            .forebody
            .between(path, depth_m, [inner_r_m, cone_end.r_m])
            .line_to(cone_end);
        let radius = self.forebody.shoulder_radius_m - depth_m;
        if radius.value() > 0.0 {
            let start = self.forebody.cone_half_angle_rad + FRAC_PI_2;
            let arc = Segment::arc(
                self.forebody.shoulder_center(),
                radius,
                start,
                -(start + self.wing_slope_rad),
            );
            path.and(arc)
        } else {
            path
        }
    }

    /// End of the cone at depth `depth_m`: at the shoulder arc, or on the tip line if no arc is left at this depth.
    fn cone_end(&self, depth_m: S) -> Point<S> {
        let below = depth_m - self.forebody.shoulder_radius_m;
        if below.value() < 0.0 {
            self.forebody.shoulder_tangent(depth_m)
        } else {
            self.on_tip_line(
                below / (self.forebody.cone_half_angle_rad + self.wing_slope_rad).sin(),
            )
        }
    }

    /// `path` with the aftbody's surface at depth `depth_m`, from the tip line inwards to the foot of the lid and on to the axis.
    pub fn aft_layer(&self, path: Profile<S>, depth_m: S) -> Profile<S> {
        self.aft_layer_to_foot(path, depth_m).and(self.lid(depth_m))
    }

    /// `path` with the wing's and the annulus' surface at depth `depth_m`, from the tip line inwards to the foot of the lid.
    pub fn aft_layer_to_foot(&self, path: Profile<S>, depth_m: S) -> Profile<S> {
        let foot_r_m = self.lid_foot_r_m(depth_m);
        let x_m = self.attached_structure_x_m;
        let start = self.on_tip_line(self.forebody.shoulder_radius_m - depth_m);
        let corner = Point {
            x_m: x_m - depth_m,
            r_m: self.annulus_outer_r_m(depth_m),
        };
        path.and(Segment::Line { start, end: corner })
            .line_to(Point {
                x_m: x_m - depth_m,
                r_m: foot_r_m,
            })
            .line_to(Point { x_m, r_m: foot_r_m })
    }

    /// The lid's surface at depth `depth_m`, from its foot to the axis.
    pub fn lid(&self, depth_m: S) -> Segment<S> {
        let center = Point::on_axis(self.lid_center_x_m);
        let radius_m = self.lid_radius_m - depth_m;
        let start = Point {
            x_m: self.attached_structure_x_m,
            r_m: self.lid_foot_r_m(depth_m),
        };
        let start_angle_rad = start.r_m.atan2(start.x_m - center.x_m);
        let end = Point::on_axis(center.x_m + radius_m);
        Segment::Arc {
            start,
            end,
            center,
            radius_m,
            start_angle_rad,
            sweep_rad: -start_angle_rad,
        }
    }

    /// Distance from the axis of the corner between wing and annulus at depth `depth_m`, m.
    pub fn annulus_outer_r_m(&self, depth_m: S) -> S {
        // the line at depth t runs parallel to the wing, the annulus' parallel to the annulus: they meet tan(φ/2) t further out
        let (s, c) = sin_cos(self.wing_slope_rad);
        self.lid_foot_r_m(S::constant(0.0)) + self.annulus_width_m + depth_m * s / (c + 1.0)
    }

    /// The closed outer mold line, from the nose tip round the shoulder and over the lid.
    pub fn profile(&self) -> Profile<S> {
        let zero = S::constant(0.0);
        let fore = self.fore_layer(Profile::default(), zero, zero);
        self.aft_layer(fore, zero).closed()
    }

    /// Axial position of the top of the lid, m.
    pub fn lid_top_x_m(&self) -> S {
        self.lid_center_x_m + self.lid_radius_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::PI;

    fn forebody() -> Forebody {
        Forebody {
            diameter_m: 2.0,
            nose_radius_m: 0.5,
            shoulder_radius_m: 0.1,
            cone_half_angle_rad: PI / 3.0,
        }
    }

    #[test]
    fn a_wing_as_thick_as_the_shoulder_is_parallel_to_the_forebody() {
        let body = forebody();
        // the cone shifted aft by 2 R_s normal to itself: x = r / tan θ + 2 R_s / sin θ
        let edge = Point {
            x_m: body.depth_x_m(0.2, 0.5),
            r_m: 0.5,
        };
        let slope = wing_slope_rad(&body, edge).unwrap();
        assert!((slope - PI / 6.0).abs() < 1e-14);
        // parallel walls: twice the radius is the room
        assert!((smallest_shoulder_radius_m(0.04, 0.02, PI / 3.0, slope) - 0.03).abs() < 1e-16);
    }

    #[test]
    fn no_wing_where_the_annulus_is_wider_than_the_shoulder() {
        assert_eq!(
            wing_slope_rad(
                &forebody(),
                Point {
                    x_m: 0.5,
                    r_m: 0.95
                }
            ),
            None
        );
    }

    #[test]
    fn layers_meet_on_the_tip_line() {
        let body = forebody();
        let edge = Point {
            x_m: 0.55,
            r_m: 0.46,
        };
        let outline = Outline {
            forebody: body,
            wing_slope_rad: wing_slope_rad(&body, edge).unwrap(),
            attached_structure_x_m: edge.x_m,
            annulus_width_m: 0.06,
            lid_radius_m: 0.4,
            lid_center_x_m: edge.x_m,
        };
        for depth in [0.0, 0.05, 0.12] {
            let path = Profile::default;
            let end = outline.fore_layer(path(), depth, 0.0).end().unwrap();
            let start = outline.aft_layer(path(), depth).start().unwrap();
            let (s, c) = sin_cos(outline.wing_slope_rad);
            let center = body.shoulder_center();
            for p in [end, start] {
                let along = (p.x_m - center.x_m) * s + (p.r_m - center.r_m) * c;
                assert!(along.abs() < 1e-15, "{p:?} is off the tip line by {along}");
            }
        }
        assert!((outline.annulus_outer_r_m(0.0) - edge.r_m).abs() < 1e-15);
    }
}
