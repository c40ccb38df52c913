//! Camera of the view.
//!
//! The axis of the vehicle is vertical, nose down. Azimuth rotates about it, elevation tilts it.

use nalgebra::{Matrix4, Rotation3, Vector3, Vector4};
use std::f32::consts::{FRAC_PI_2, PI, TAU};

/// Half the field of view, rad.
const HALF_VIEW_RAD: f32 = 0.26;
/// Range of the zoom.
const ZOOM: (f32, f32) = (0.5, 8.0);

/// A place to look from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// Rotation about the axis of the vehicle, rad.
    pub azimuth_rad: f32,
    /// Elevation above the plane of the largest diameter, rad: positive shows the aft side.
    pub elevation_rad: f32,
    /// Magnification; at 1 the vehicle fills the view.
    pub zoom: f32,
}

/// Line of sight in the vehicle's frame: across, along its axis, towards the initial viewer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// Position of the eye, m.
    pub eye_m: [f64; 3],
    /// Direction.
    pub direction: [f64; 3],
}

/// Bounding sphere of the vehicle.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Ball {
    /// Axial position of its center, m.
    pub center_m: f32,
    /// Radius, m.
    pub radius_m: f32,
}

impl Camera {
    /// Initial view: from the side, slightly from above, into the cut.
    pub const START: Camera = Camera {
        azimuth_rad: 0.35,
        elevation_rad: 0.35,
        zoom: 1.0,
    };
    /// From the side, straight into the cut.
    pub const SIDE: Camera = Camera {
        azimuth_rad: 0.0,
        elevation_rad: 0.0,
        zoom: 1.0,
    };
    /// The nose from the front.
    pub const FRONT: Camera = Camera {
        azimuth_rad: 0.0,
        elevation_rad: -FRAC_PI_2,
        zoom: 1.0,
    };
    /// The lid from behind.
    pub const BACK: Camera = Camera {
        azimuth_rad: 0.0,
        elevation_rad: FRAC_PI_2,
        zoom: 1.0,
    };

    /// The camera rotated by angles, rad.
    #[must_use]
    pub fn turned(self, azimuth_rad: f32, elevation_rad: f32) -> Camera {
        let azimuth_rad = self.azimuth_rad + azimuth_rad;
        Camera {
            azimuth_rad: azimuth_rad - TAU * ((azimuth_rad + PI) / TAU).floor(),
            elevation_rad: (self.elevation_rad + elevation_rad).clamp(-FRAC_PI_2, FRAC_PI_2),
            ..self
        }
    }

    /// The camera with the zoom multiplied by a factor.
    #[must_use]
    pub fn zoomed(self, factor: f32) -> Camera {
        Camera {
            zoom: (self.zoom * factor).clamp(ZOOM.0, ZOOM.1),
            ..self
        }
    }

    /// Place of a point of the vehicle before the eye.
    pub fn view(&self, ball: Ball, aspect: f32) -> Matrix4<f32> {
        let center_m = Vector3::y() * ball.center_m;
        let away_m = Vector3::z() * -self.distance_m(ball, aspect);
        Matrix4::new_translation(&away_m)
            * self.turn().to_homogeneous()
            * Matrix4::new_translation(&-center_m)
    }

    /// Turned about y by −azimuth, then about x by elevation.
    fn turn(&self) -> Rotation3<f32> {
        Rotation3::from_axis_angle(&Vector3::x_axis(), self.elevation_rad)
            * Rotation3::from_axis_angle(&Vector3::y_axis(), -self.azimuth_rad)
    }

    /// From before the eye to the screen; everything within `reach_m` of the center has a depth.
    pub fn projection(&self, ball: Ball, aspect: f32, reach_m: f32) -> Matrix4<f32> {
        let distance = self.distance_m(ball, aspect);
        let near = (distance - 1.1 * reach_m).max(0.02 * distance);
        let far = distance + 1.1 * reach_m;
        let f = 1.0 / HALF_VIEW_RAD.tan();
        // by its elements: the constructor of the library panics where near and far are one, as in a scene without size
        let mut projection = Matrix4::from_diagonal(&Vector4::new(f / aspect, f, 0.0, 0.0));
        projection.m33 = (far + near) / (near - far);
        projection.m34 = 2.0 * far * near / (near - far);
        projection.m43 = -1.0;
        projection
    }

    /// Line of sight through a position of the view, each coordinate from −1 to 1, upward positive.
    pub fn sight(&self, ball: Ball, aspect: f32, place: [f32; 2]) -> Sight {
        let turn = self.turn();
        let tan = HALF_VIEW_RAD.tan();
        let seen = Vector3::new(place[0] * aspect * tan, place[1] * tan, -1.0);
        let away_m = Vector3::z() * self.distance_m(ball, aspect);
        let eye_m = turn.inverse_transform_vector(&away_m) + Vector3::y() * ball.center_m;
        Sight {
            eye_m: eye_m.map(f64::from).into(),
            direction: turn.inverse_transform_vector(&seen).map(f64::from).into(),
        }
    }

    fn distance_m(&self, ball: Ball, aspect: f32) -> f32 {
        let half = (HALF_VIEW_RAD.tan() * aspect.min(1.0)).atan();
        ball.radius_m / (half.sin() * self.zoom)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const BALL: Ball = Ball {
        center_m: 0.2,
        radius_m: 0.5,
    };

    fn apply(m: &Matrix4<f32>, [x, y, z]: [f32; 3]) -> [f32; 4] {
        (m * Vector4::new(x, y, z, 1.0)).into()
    }

    fn near(got: f32, want: f32) {
        assert!((got - want).abs() < 1e-5, "{got} against {want}");
    }

    #[test]
    fn from_the_side_the_axis_is_upright_and_the_cut_faces_the_eye() {
        let view = Camera::SIDE.view(BALL, 1.0);
        let top = apply(&view, [0.0, 0.7, 0.0]);
        let front = apply(&view, [0.0, 0.2, 0.5]);
        near(top[0], 0.0);
        near(top[1], 0.5);
        // half a meter nearer than the axis
        near(front[2] - top[2], 0.5);
    }

    #[test]
    fn from_behind_the_aft_end_is_nearest() {
        let view = Camera::BACK.view(BALL, 1.0);
        let aft = apply(&view, [0.0, 0.7, 0.0]);
        let nose = apply(&view, [0.0, -0.3, 0.0]);
        near(aft[2] - nose[2], 1.0);
        near(aft[1], 0.0);
    }

    #[test]
    fn a_turn_to_the_right_brings_the_left_side_forward() {
        let view = Camera::SIDE.turned(-FRAC_PI_2, 0.0).view(BALL, 1.0);
        let left = apply(&view, [-0.5, 0.2, 0.0]);
        let right = apply(&view, [0.5, 0.2, 0.0]);
        near(left[2] - right[2], 1.0);
    }

    #[test]
    fn the_line_of_sight_through_a_point_meets_it() {
        let camera = Camera::START.turned(0.4, -0.9).zoomed(1.3);
        let (point, aspect) = ([0.1_f32, 0.45, -0.2], 1.6);
        let p = apply(&camera.view(BALL, aspect), point);
        let q = apply(&camera.projection(BALL, aspect, 1.0), [p[0], p[1], p[2]]);
        let sight = camera.sight(BALL, aspect, [q[0] / q[3], q[1] / q[3]]);
        let t = f64::from(-p[2]);
        let met = sight.eye_m.iter().zip(sight.direction);
        for ((eye_m, direction), wanted) in met.zip(point) {
            let met = eye_m + t * direction;
            assert!(
                (met - f64::from(wanted)).abs() < 1e-5,
                "{met} against {wanted}"
            );
        }
    }

    #[test]
    fn a_scene_without_size_is_projected_without_a_fault() {
        for (ball, reach_m) in [(Ball::default(), 0.0), (BALL, 0.0)] {
            let projection = Camera::START.projection(ball, 1.0, reach_m);
            assert_eq!(projection.m43, -1.0);
        }
    }

    #[test]
    fn the_ball_just_fits_into_narrow_and_wide_views() {
        for aspect in [0.5, 1.0, 2.0] {
            let camera = Camera::SIDE;
            let (view, projection) = (
                camera.view(BALL, aspect),
                camera.projection(BALL, aspect, BALL.radius_m),
            );
            // the outermost visible point lies slightly before the center
            let mut widest: f32 = 0.0;
            for i in 0..1000 {
                let a = i as f32 * TAU / 1000.0;
                let p = apply(&view, [0.5 * a.cos(), 0.2, 0.5 * a.sin()]);
                let q = apply(&projection, [p[0], p[1], p[2]]);
                widest = widest.max((q[0] / q[3]).abs() * aspect.max(1.0));
            }
            assert!((0.98..=1.001).contains(&widest), "{aspect}: {widest}");
        }
    }
}
