//! How a vehicle is turned in flight, in the frame of the view.
//!
//! ```text
//! view: X downrange at the start, Y up, Z to the right of the track
//! model: Y aft along the axis;  X = −z_b, Y = −x_b, Z = y_b        R = H(χ₀) R₃₂₁(yaw, pitch, roll) M
//! ```
//!
//! with x_b forward, y_b right, z_b down, χ₀ the azimuth of the flight's start.

use super::camera::{Ball, Camera, Matrix};
use msape::flight::Trajectory;

/// Three rows of a turn.
type Turn = [[f64; 3]; 3];

/// A turn as scalar and vector.
type Quaternion = [f64; 4];

/// A vehicle that is turned: where its axes point, from the model to the view.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Attitude(pub Turn);

impl Attitude {
    /// As the model stands.
    pub const UPRIGHT: Attitude = Attitude([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);

    /// A view of the model that is turned about the centre of its ball.
    pub fn seen(&self, view: Matrix, ball: Ball) -> Matrix {
        let Attitude(turn) = self;
        let c = f64::from(ball.center_m);
        let mut model = [0.0; 16];
        for (i, row) in turn.iter().enumerate() {
            for (j, part) in row.iter().enumerate() {
                model[4 * j + i] = *part as f32;
            }
            let back = if i == 1 { c } else { 0.0 };
            model[12 + i] = (back - row[1] * c) as f32;
        }
        model[15] = 1.0;
        product(&view, &model)
    }
}

/// The product of two matrices of four columns.
fn product(a: &Matrix, b: &Matrix) -> Matrix {
    let mut c = [0.0; 16];
    for column in 0..4 {
        for row in 0..4 {
            c[4 * column + row] = (0..4).map(|k| a[4 * k + row] * b[4 * column + k]).sum();
        }
    }
    c
}

/// Where a direction of the view points on the screen: to the right, up, and towards the viewer.
pub fn on_screen(camera: &Camera, direction: [f64; 3]) -> [f64; 3] {
    let view = camera.view(Ball::default(), 1.0);
    let part = |row: usize| {
        let sum = (0..3).map(|k| f64::from(view[4 * k + row]) * direction[k]);
        sum.sum()
    };
    [part(0), part(1), part(2)]
}

/// Attitude and velocity along a flight.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Course {
    time_s: Vec<f64>,
    turns: Vec<Quaternion>,
    velocity_m_s: Vec<[f64; 3]>,
}

impl Course {
    /// The course of a flight with attitude; `None` where it has none.
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
        let mut course = Course {
            time_s: column("time_s")?.to_vec(),
            ..Course::default()
        };
        let angles = yaw.iter().zip(pitch).zip(roll);
        for ((yaw, pitch), roll) in angles {
            let body = [yaw, pitch, roll].map(|angle| angle.to_radians());
            let turn = times(&times(&horizon, &of_yaw_pitch_roll(body)), &MODEL);
            let mut turn = quaternion(&turn);
            // The shorter of the two ways to the next attitude.
            if let Some(before) = course.turns.last()
                && dot(before, &turn) < 0.0
            {
                turn = turn.map(|part| -part);
            }
            course.turns.push(turn);
        }
        for ((north, east), down) in north.iter().zip(east).zip(down) {
            course
                .velocity_m_s
                .push(turned(&horizon, [*north, *east, *down]));
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

    /// The row nearest to a time.
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
            return Attitude::UPRIGHT;
        };
        let mixed: Quaternion = std::array::from_fn(|k| a[k] + part * (b[k] - a[k]));
        let length = dot(&mixed, &mixed).sqrt();
        Attitude(matrix(&mixed.map(|part| part / length)))
    }

    /// Direction of the velocity at a time.
    pub fn direction(&self, time_s: f64) -> [f64; 3] {
        let (i, j, part) = self.place(time_s);
        let (Some(a), Some(b)) = (self.velocity_m_s.get(i), self.velocity_m_s.get(j)) else {
            return [0.0; 3];
        };
        let mixed: [f64; 3] = std::array::from_fn(|k| a[k] + part * (b[k] - a[k]));
        let length = mixed.iter().map(|x| x * x).sum::<f64>().sqrt();
        if length == 0.0 {
            return [0.0; 3];
        }
        mixed.map(|x| x / length)
    }

    /// Rows before and after a time, and the part of the way between them.
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
const MODEL: Turn = [[0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [-1.0, 0.0, 0.0]];

/// From north, east, down to the view that looks along a heading from its right, rad.
fn horizon(heading_rad: f64) -> Turn {
    let (s, c) = heading_rad.sin_cos();
    [[c, s, 0.0], [0.0, 0.0, -1.0], [-s, c, 0.0]]
}

/// From axes of the body to north, east, down.
fn of_yaw_pitch_roll([yaw, pitch, roll]: [f64; 3]) -> Turn {
    let ((sy, cy), (sp, cp), (sr, cr)) = (yaw.sin_cos(), pitch.sin_cos(), roll.sin_cos());
    [
        [cp * cy, sr * sp * cy - cr * sy, cr * sp * cy + sr * sy],
        [cp * sy, sr * sp * sy + cr * cy, cr * sp * sy - sr * cy],
        [-sp, sr * cp, cr * cp],
    ]
}

fn times(a: &Turn, b: &Turn) -> Turn {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}

fn turned(turn: &Turn, v: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| (0..3).map(|k| turn[i][k] * v[k]).sum())
}

fn dot(a: &Quaternion, b: &Quaternion) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The turn of a matrix, by the largest of its four parts.
fn quaternion(m: &Turn) -> Quaternion {
    let squares = [
        1.0 + m[0][0] + m[1][1] + m[2][2],
        1.0 + m[0][0] - m[1][1] - m[2][2],
        1.0 - m[0][0] + m[1][1] - m[2][2],
        1.0 - m[0][0] - m[1][1] + m[2][2],
    ];
    let largest = (0..4).max_by(|a, b| squares[*a].total_cmp(&squares[*b]));
    let largest = largest.unwrap_or(0);
    let half = 0.5 * squares[largest].max(0.0).sqrt();
    let [x, y, z] = [m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]];
    let [xy, xz, yz] = [m[1][0] + m[0][1], m[0][2] + m[2][0], m[2][1] + m[1][2]];
    let fourfold = match largest {
        0 => [4.0 * half * half, x, y, z],
        1 => [x, 4.0 * half * half, xy, xz],
        2 => [y, xy, 4.0 * half * half, yz],
        _ => [z, xz, yz, 4.0 * half * half],
    };
    fourfold.map(|part| part / (4.0 * half))
}

fn matrix([w, x, y, z]: &Quaternion) -> Turn {
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - w * z),
            2.0 * (x * z + w * y),
        ],
        [
            2.0 * (x * y + w * z),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - w * x),
        ],
        [
            2.0 * (x * z - w * y),
            2.0 * (y * z + w * x),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::flight::columns::columns;
    use std::f64::consts::{FRAC_PI_2, PI};

    /// A history of these columns, the others nothing.
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

    /// Where the nose points.
    fn nose(Attitude(turn): Attitude) -> [f64; 3] {
        turned(&turn, [0.0, -1.0, 0.0])
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
        near(turned(&turn, [0.0, 0.0, 1.0]), [0.0, 0.0, 1.0]);
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
        // Roll from 170 to -170 deg is a turn of 20 deg over the top.
        let course = history(
            2,
            &[("time_s", &[0.0, 2.0]), ("roll_deg", &[170.0, -170.0])],
        );
        let course = Course::of(&course).unwrap();
        let Attitude(turn) = course.attitude(1.0);
        near(turned(&turn, [0.0, 0.0, 1.0]), [0.0, 0.0, -1.0]);
        assert_eq!((course.row(0.9), course.row(1.1)), (0, 1));
        assert_eq!(course.ends_s(), (0.0, 2.0));
    }

    #[test]
    fn any_turn_survives_the_way_through_its_four_parts() {
        for angles in [
            [0.3, -0.7, 2.9],
            [PI, 0.0, 0.0],
            [0.0, FRAC_PI_2, PI],
            [-3.0, 1.2, -1.5],
        ] {
            let turn = of_yaw_pitch_roll(angles);
            let back = matrix(&quaternion(&turn));
            for (a, b) in turn.iter().zip(back) {
                near(b, *a);
            }
        }
    }

    #[test]
    fn a_model_turns_about_the_centre_of_its_ball() {
        let ball = Ball {
            center_m: 0.2,
            radius_m: 0.5,
        };
        let still = Camera::SIDE.view(ball, 1.0);
        let over = Attitude([[-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]);
        let seen = over.seen(still, ball);
        let y = |m: &Matrix, y: f32| m[5] * y + m[13];
        // The centre stays, the end half a metre behind it comes to half a metre below.
        assert!((y(&seen, 0.2) - y(&still, 0.2)).abs() < 1e-6);
        assert!((y(&seen, 0.7) - y(&still, -0.3)).abs() < 1e-6);
        near(on_screen(&Camera::SIDE, [1.0, 0.0, 0.0]), [1.0, 0.0, 0.0]);
    }
}
