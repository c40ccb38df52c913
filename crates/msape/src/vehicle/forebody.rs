//! Sphere-cone forebody: nose sphere, cone, shoulder arc, and its inner offsets.
//!
//! ```text
//! x_n = Rₙ / sin θ                                  center of the nose sphere
//! x_s = (r_s + R_s cos θ) / tan θ + R_s sin θ        center of the shoulder arc, r_s = D/2 − R_s
//! r   = (x − t / sin θ) tan θ                       cone at the depth t under the surface
//! ```
//!
//! with x from the virtual apex in m, aft positive; r from the axis in m; θ the cone half-angle in rad.
//!
//! # Valid
//! 0 < θ < π/2 and a nose that ends before the shoulder: Rₙ cos θ ≤ r_s + R_s cos θ.
//!
//! # References
//! - \[samareh-2014\] section 3.1.4, Figures 14-17 (coordinate system at the virtual apex).

use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI};
use numerics::scalar::Single;
use numerics::scalar::functions::sin_cos;
use serde::{Deserialize, Serialize};

/// The forebody's outer mold line.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Forebody<S = f64> {
    /// Largest diameter, m.
    pub diameter_m: S,
    /// Radius of the nose sphere, m.
    pub nose_radius_m: S,
    /// Radius of the shoulder arc, m.
    pub shoulder_radius_m: S,
    /// Angle between the axis and the cone, rad.
    pub cone_half_angle_rad: S,
}

impl<S: Single> Forebody<S> {
    /// Sine and cosine of the cone half-angle.
    pub fn sin_cos(&self) -> (S, S) {
        sin_cos(self.cone_half_angle_rad)
    }

    /// Axial position of the center of the nose sphere, m.
    pub fn nose_center_x_m(&self) -> S {
        self.nose_radius_m / self.sin_cos().0
    }

    /// Axial position of the nose tip: distance of the virtual apex ahead of it, m.
    pub fn nose_tip_x_m(&self) -> S {
        self.nose_center_x_m() - self.nose_radius_m
    }

    /// Center of the shoulder arc; its x is that of the largest diameter.
    pub fn shoulder_center(&self) -> Point<S> {
        let (sin, cos) = self.sin_cos();
        let Self {
            shoulder_radius_m: r_s,
            ..
        } = *self;
        let r_m = self.diameter_m / 2.0 - r_s;
        Point {
            x_m: (r_m + r_s * cos) * cos / sin + r_s * sin,
            r_m,
        }
    }

    /// Point at depth `depth_m` where the nose sphere joins the cone; on the axis if no sphere is left at this depth.
    pub fn nose_tangent(&self, depth_m: S) -> Point<S> {
        let (sin, cos) = self.sin_cos();
        let radius = self.nose_radius_m - depth_m;
        if radius.value() > 0.0 {
            Point {
                x_m: self.nose_center_x_m() - radius * sin,
                r_m: radius * cos,
            }
        } else {
            Point::on_axis(depth_m / sin)
        }
    }

    /// Point at depth `depth_m`, less than the shoulder radius, where the cone joins the shoulder arc.
    pub fn shoulder_tangent(&self, depth_m: S) -> Point<S> {
        let (sin, cos) = self.sin_cos();
        let (center, radius) = (self.shoulder_center(), self.shoulder_radius_m - depth_m);
        Point {
            x_m: center.x_m - radius * sin,
            r_m: center.r_m + radius * cos,
        }
    }

    /// Distance from the axis, m, at a fraction of the length along the surface from the nose tip to the largest diameter.
    pub fn radius_along_m(&self, part: S) -> S {
        let zero = S::constant(0.0);
        let (nose, tangent) = (self.nose_tangent(zero), self.shoulder_tangent(zero));
        let (sin, _) = self.sin_cos();
        let theta = self.cone_half_angle_rad;
        let on_nose_m = self.nose_radius_m * (-theta + FRAC_PI_2);
        let on_cone_m = (tangent.r_m - nose.r_m) / sin;
        let s_m = part * (on_nose_m + on_cone_m + self.shoulder_radius_m * theta);
        let beyond_m = s_m - on_nose_m - on_cone_m;
        if s_m.less(on_nose_m) {
            self.nose_radius_m * sin_cos(s_m / self.nose_radius_m).0
        } else if beyond_m.value() < 0.0 {
            nose.r_m + (s_m - on_nose_m) * sin
        } else {
            let turned_rad = theta - beyond_m / self.shoulder_radius_m;
            self.shoulder_center().r_m + self.shoulder_radius_m * sin_cos(turned_rad).1
        }
    }

    /// Axial position of the surface at depth `depth_m` (nose or cone) at the distance `r_m` from the axis, m.
    pub fn depth_x_m(&self, depth_m: S, r_m: S) -> S {
        let (sin, cos) = self.sin_cos();
        let radius = self.nose_radius_m - depth_m;
        if r_m.less(radius * cos) {
            self.nose_center_x_m() - (radius * radius - r_m * r_m).sqrt()
        } else {
            r_m * cos / sin + depth_m / sin
        }
    }

    /// Nose arc and the start of the cone at depth `depth_m`, from the axis outwards.
    pub fn nose(&self, depth_m: S) -> Profile<S> {
        let radius = self.nose_radius_m - depth_m;
        if radius.value() > 0.0 {
            let center = Point::on_axis(self.nose_center_x_m());
            Profile {
                segments: vec![Segment::arc(
                    center,
                    radius,
                    S::constant(PI),
                    -(-self.cone_half_angle_rad + FRAC_PI_2),
                )],
            }
        } else {
            Profile::default()
        }
    }

    /// `path` with the surface at depth `depth_m` (nose and cone) between two distances from the axis, outwards.
    pub fn between(
        &self,
        path: Profile<S>,
        depth_m: S,
        [inner_r_m, outer_r_m]: [S; 2],
    ) -> Profile<S> {
        let radius = self.nose_radius_m - depth_m;
        let at = |r_m: S| Point {
            x_m: self.depth_x_m(depth_m, r_m),
            r_m,
        };
        let tangent = self.nose_tangent(depth_m);
        let mut path = path;
        let mut from = at(inner_r_m);
        if radius.value() > 0.0 && inner_r_m.less(tangent.r_m) {
            let center = Point::on_axis(self.nose_center_x_m());
            let angle = |p: Point<S>| p.r_m.atan2(p.x_m - center.x_m);
            let to = if outer_r_m.less(tangent.r_m) {
                at(outer_r_m)
            } else {
                tangent
            };
            let start_angle_rad = angle(from);
            path = path.and(Segment::Arc {
                start: from,
                end: to,
                center,
                radius_m: radius,
                start_angle_rad,
                sweep_rad: angle(to) - start_angle_rad,
            });
            from = to;
        }
        if from.r_m.less(outer_r_m) {
            path = path.and(Segment::Line {
                start: from,
                end: at(outer_r_m),
            });
        }
        path
    }

    /// Axial position of the center of a ball of radius `radius_m` that rests on the surface at depth `depth_m`, m.
    pub fn resting_ball_x_m(&self, depth_m: S, radius_m: S) -> S {
        let nose = self.nose_radius_m - depth_m;
        if radius_m.less(nose) {
            self.nose_center_x_m() - nose + radius_m
        } else {
            (radius_m + depth_m) / self.sin_cos().0
        }
    }

    /// Nose, cone and shoulder up to the largest diameter.
    pub fn profile(&self) -> Profile<S> {
        let theta = self.cone_half_angle_rad;
        let shoulder = Segment::arc(
            self.shoulder_center(),
            self.shoulder_radius_m,
            theta + FRAC_PI_2,
            -theta,
        );
        self.nose(S::constant(0.0)).and(shoulder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_of_the_length_is_a_distance_from_the_axis() {
        // 60 deg, nose 0.5 m, shoulder 0.05 m, 1.6 m across: arcs of 30 and 60 deg and a cone from 0.25 to 0.775 m
        let body = Forebody {
            diameter_m: 1.6,
            nose_radius_m: 0.5,
            shoulder_radius_m: 0.05,
            cone_half_angle_rad: PI / 3.0,
        };
        let sin = 0.75_f64.sqrt();
        let (nose_m, cone_m, shoulder_m) = (PI / 12.0, (0.775 - 0.25) / sin, 0.05 * PI / 3.0);
        let whole_m = nose_m + cone_m + shoulder_m;
        for (s_m, r_m) in [
            (0.0, 0.0),
            (0.5 * nose_m, 0.5 * sin_cos(PI / 12.0).0),
            (nose_m + 0.1, 0.25 + 0.1 * sin),
            (
                nose_m + cone_m + 0.5 * shoulder_m,
                0.75 + 0.05 * sin_cos(PI / 6.0).1,
            ),
            (whole_m, 0.8),
        ] {
            let ours = body.radius_along_m(s_m / whole_m);
            assert!((ours - r_m).abs() < 1e-12, "{s_m}: {ours}, {r_m}");
        }
    }

    #[test]
    fn sphere_cone_of_1_m_as_computed_independently() {
        let body = Forebody {
            diameter_m: 1.0,
            nose_radius_m: 0.375,
            shoulder_radius_m: 0.025,
            cone_half_angle_rad: PI / 3.0,
        };
        let tip = body.nose_tip_x_m();
        let solid = body
            .profile()
            .line_to(Point::on_axis(body.shoulder_center().x_m))
            .closed()
            .solid();
        // printed to eight decimals, hence half a unit of the last
        let rows = [
            (body.nose_tangent(0.0).x_m - tip, 0.050_240_47),
            (body.nose_tangent(0.0).r_m, 0.187_5),
            (body.shoulder_tangent(0.0).x_m - tip, 0.223_445_55),
            (body.shoulder_tangent(0.0).r_m, 0.487_5),
            (body.shoulder_center().x_m - tip, 0.245_096_19),
            (tip, 0.058_012_7),
            (body.profile().wetted_area_m2(), 0.934_500_31),
            (solid.volume_m3, 0.085_661_68),
            (solid.centroid_x_m() - tip, 0.171_052_67),
        ];
        for (got, want) in rows {
            assert!((got - want).abs() <= 5.001e-9, "{got} against {want}");
        }
    }

    #[test]
    fn ball_rests_on_the_nose_or_in_the_cone() {
        let body = Forebody {
            diameter_m: 1.0,
            nose_radius_m: 0.3,
            shoulder_radius_m: 0.05,
            cone_half_angle_rad: PI / 6.0,
        };
        // center of the nose at 0.3 / 0.5 = 0.6; a ball of 0.1 rests at 0.6 − 0.3 + 0.1, one of 0.4 at 0.4 / 0.5
        assert!((body.resting_ball_x_m(0.0, 0.1) - 0.4).abs() < 1e-15);
        assert!((body.resting_ball_x_m(0.0, 0.4) - 0.8).abs() < 1e-15);
    }
}
