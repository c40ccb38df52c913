//! Attitude of a vehicle in flight, in the frame of the view.
//!
//! ```text
//! view: X downrange at the start, Y up, Z to the right of the track
//! model: Y aft along the axis;  X = −z_b, Y = −x_b, Z = y_b        R = H(χ₀) R₃₂₁(yaw, pitch, roll) M
//! ```
//!
//! with x_b forward, y_b right, z_b down, χ₀ the azimuth at the start of the flight.

use super::camera::{Ball, Camera};
use msape::flight::Trajectory;
use nalgebra::{Matrix3, Matrix4, Rotation3, UnitQuaternion, Vector3};

/// Attitude of a vehicle: rotation from the model to the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude(pub UnitQuaternion<f64>);

impl Attitude {
    /// As the model stands.
    pub fn upright() -> Attitude {
        Attitude(UnitQuaternion::identity())
    }

    /// A view of the model that is turned about the center of its ball.
    pub fn seen(&self, view: Matrix4<f32>, ball: Ball) -> Matrix4<f32> {
        let center_m = Vector3::y() * ball.center_m;
        let turn: Matrix4<f32> = self.0.to_homogeneous().map(|part| part as f32);
        view * Matrix4::new_translation(&center_m) * turn * Matrix4::new_translation(&-center_m)
    }
}

/// Where a direction of the view points on the screen: to the right, up, and towards the viewer.
pub fn on_screen(camera: &Camera, direction: [f64; 3]) -> [f64; 3] {
    let turn: Matrix3<f32> = camera
        .view(Ball::default(), 1.0)
        .fixed_view::<3, 3>(0, 0)
        .into();
    (turn.map(f64::from) * Vector3::from(direction)).into()
}

/// Attitude and velocity along a flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    time_s: Vec<f64>,
    turns: Vec<UnitQuaternion<f64>>,
    velocity_m_s: Vec<Vector3<f64>>,
}

impl Course {
    /// Course of a flight with attitude; `None` if it has none.
    pub fn of(trajectory: &Trajectory) -> Option<Course> {
        let column = |key: &str| trajectory.column(key).filter(|values| !values.is_empty());
        let [yaw, pitch, roll] = ["yaw_deg", "pitch_deg", "roll_deg"].map(column);
        let (yaw, pitch, roll) = (yaw?, pitch?, roll?);
        let [north, east, down] = [
            "northward_speed_m_s",
            "eastward_speed_m_s",
            "downward_speed_m_s",
        ]
        .map(column);
        let (north, east, down) = (north?, east?, down?);
        let heading = column("azimuth_deg")?.first()?.to_radians();
        let horizon = horizon(heading);
        let model = model();
        let mut course = Course {
            time_s: column("time_s")?.to_vec(),
            ..Course::default()
        };
        let angles = yaw.iter().zip(pitch).zip(roll);
        for ((yaw, pitch), roll) in angles {
            let [roll, pitch, yaw] = [roll, pitch, yaw].map(|angle| angle.to_radians());
            let body = Rotation3::from_euler_angles(roll, pitch, yaw);
            let turn = UnitQuaternion::from_rotation_matrix(&(horizon * body * model));
            course.turns.push(turn);
        }
        for ((north, east), down) in north.iter().zip(east).zip(down) {
            let velocity_m_s = horizon * Vector3::new(*north, *east, *down);
            course.velocity_m_s.push(velocity_m_s);
        }
        Some(course)
    }

    /// First and last time, s.
    pub fn ends_s(&self) -> (f64, f64) {
        let ends = (self.time_s.first(), self.time_s.last());
        (
            ends.0.copied().unwrap_or_default(),
            ends.1.copied().unwrap_or_default(),
        )
    }

    /// Row nearest to a time.
    pub fn row(&self, time_s: f64) -> usize {
        let (i, j, part) = self.place(time_s);
        if part < 0.5 { i } else { j }
    }

    /// Time of a row, s.
    pub fn time_s(&self, row: usize) -> Option<f64> {
        self.time_s.get(row).copied()
    }

    /// Attitude at a time.
    pub fn attitude(&self, time_s: f64) -> Attitude {
        let (i, j, part) = self.place(time_s);
        let (Some(a), Some(b)) = (self.turns.get(i), self.turns.get(j)) else {
            return Attitude::upright();
        };
        // The shorter of the two ways to the next attitude.
        Attitude(a.try_slerp(b, part, 1e-9).unwrap_or(*a))
    }

    /// Direction of the velocity at a time.
    pub fn direction(&self, time_s: f64) -> [f64; 3] {
        let (i, j, part) = self.place(time_s);
        let (Some(a), Some(b)) = (self.velocity_m_s.get(i), self.velocity_m_s.get(j)) else {
            return [0.0; 3];
        };
        let direction = a.lerp(b, part).try_normalize(0.0);
        direction.unwrap_or_default().into()
    }

    /// Rows before and after a time, and the fraction of the interval between them.
    fn place(&self, time_s: f64) -> (usize, usize, f64) {
        let last = self.time_s.len().saturating_sub(1);
        let after = self.time_s.partition_point(|t| *t < time_s).min(last);
        let before = after.saturating_sub(1);
        let (Some(t0), Some(t1)) = (self.time_s.get(before), self.time_s.get(after)) else {
            return (0, 0, 0.0);
        };
        let part = if t1 > t0 {
            ((time_s - t0) / (t1 - t0)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        (before, after, part)
    }
}

/// From the model to the axes of the body.
fn model() -> Rotation3<f64> {
    turn([[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]])
}

/// From north, east, down to the view that looks along a heading from its right, rad.
fn horizon(heading_rad: f64) -> Rotation3<f64> {
    let (s, c) = heading_rad.sin_cos();
    turn([[c, s, 0.0], [0.0, 0.0, -1.0], [-s, c, 0.0]])
}

/// The turn of three rows.
fn turn(rows: [[f64; 3]; 3]) -> Rotation3<f64> {
    Rotation3::from_matrix_unchecked(Matrix3::from(rows).transpose())
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::flight::columns::columns;

    /// A history with these columns and all others zero.
    fn history(rows: usize, given: &[(&str, &[f64])]) -> Trajectory {
        let values = columns().map(|column| {
            let own = given.iter().find(|(key, _)| *key == column.key);
            own.map_or(vec![0.0; rows], |(_, values)| values.to_vec())
        });
        Trajectory {
            values: values.collect(),
            phases: Vec::new(),
            coarsened_s: None,
        }
    }

    fn near(got: [f64; 3], want: [f64; 3]) {
        for (got, want) in got.iter().zip(want) {
            assert!((got - want).abs() < 1e-12, "{got} against {want}");
        }
    }

    /// Direction of the nose.
    fn nose(Attitude(turn): Attitude) -> [f64; 3] {
        (turn * -Vector3::y()).into()
    }

    #[test]
    fn eastwards_and_level_the_nose_is_on_the_right_and_its_right_side_faces_the_viewer() {
        let east = [90.0, 90.0];
        let course = history(
            2,
            &[
                ("time_s", &[0.0, 1.0]),
                ("yaw_deg", &east),
                ("azimuth_deg", &east),
                ("eastward_speed_m_s", &[7.0, 7.0]),
            ],
        );
        let course = Course::of(&course).unwrap();
        near(nose(course.attitude(0.5)), [1.0, 0.0, 0.0]);
        near(course.direction(0.5), [1.0, 0.0, 0.0]);
        let Attitude(turn) = course.attitude(0.0);
        near((turn * Vector3::z()).into(), [0.0, 0.0, 1.0]);
    }

    #[test]
    fn straight_down_the_model_stands_as_it_is_drawn() {
        let course = history(
            1,
            &[
                ("time_s", &[0.0]),
                ("pitch_deg", &[-90.0]),
                ("downward_speed_m_s", &[40.0]),
            ],
        );
        let course = Course::of(&course).unwrap();
        near(nose(course.attitude(0.0)), [0.0, -1.0, 0.0]);
        near(course.direction(0.0), [0.0, -1.0, 0.0]);
    }

    #[test]
    fn between_rows_it_turns_by_the_shorter_way() {
        // roll from 170 to −170 deg is a rotation of 20 deg through 180 deg
        let course = history(
            2,
            &[("time_s", &[0.0, 2.0]), ("roll_deg", &[170.0, -170.0])],
        );
        let course = Course::of(&course).unwrap();
        let Attitude(turn) = course.attitude(1.0);
        near((turn * Vector3::z()).into(), [0.0, 0.0, -1.0]);
        assert_eq!((course.row(0.9), course.row(1.1)), (0, 1));
        assert_eq!(course.ends_s(), (0.0, 2.0));
    }

    #[test]
    fn a_model_turns_about_the_center_of_its_ball() {
        let ball = Ball {
            center_m: 0.2,
            radius_m: 0.5,
        };
        let still = Camera::SIDE.view(ball, 1.0);
        let over = Attitude(UnitQuaternion::from_axis_angle(
            &Vector3::z_axis(),
            std::f64::consts::PI,
        ));
        let seen = over.seen(still, ball);
        let y = |m: &Matrix4<f32>, y: f32| m.m22 * y + m.m24;
        // The center stays, the end half a meter behind it comes to half a meter below.
        assert!((y(&seen, 0.2) - y(&still, 0.2)).abs() < 1e-6);
        assert!((y(&seen, 0.7) - y(&still, -0.3)).abs() < 1e-6);
        near(on_screen(&Camera::SIDE, [1.0, 0.0, 0.0]), [1.0, 0.0, 0.0]);
    }
}
