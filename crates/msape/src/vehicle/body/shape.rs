//! Outlines from a few dimensions: sphere-cones and spherical segments with a torus shoulder and an aftbody.
//!
//! ```text
//! x_n = Rₙ / sin θ,  x_s = (r_s + R_s cos θ) / tan θ + R_s sin θ,  r_s = D/2 − R_s        sphere-cone, x from the virtual apex
//! x_n = Rₙ,          x_s = Rₙ − √((Rₙ − R_s)² − r_s²)                                     spherical segment, x from the tip
//! r_t = R_c cos φ                                                                         end of an aft cone at a cap
//! ```
//!
//! with x_n and (x_s, r_s) the centers of nose and shoulder in m, θ the half-angle of the forebody's cone, φ that of an aft cone
//! against the axis in rad, R_c the radius of a cap that the last aft cone touches in m.
//!
//! # Valid
//! 0 < θ < π/2. Radii of nose and shoulder may be zero. An aft cone narrows: 0 < φ ≤ π/2.
//!
//! # References
//! - \[samareh-2014\] section 3.1.4 for the virtual apex. The aftbody called `mmeev` is a convention: a half-torus shoulder, a face
//!   15 deg from the plane normal to the axis, and a lid of 0.6 of the radius about x = 0.4 √3 (D/2) / tan θ.

use crate::vehicle::body::RigidBody;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::{FRAC_PI_2, PI, RADIANS_PER_DEGREE, atan2, cos, sin_cos};
use serde::{Deserialize, Serialize};

/// A cone of the aftbody, from where the outline has come to `end_radius_m`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct AftCone {
    /// Angle against the axis, rad.
    pub half_angle_rad: f64,
    /// Distance from the axis at which it ends, m; zero is the axis.
    pub end_radius_m: f64,
}

/// Shape behind the shoulder.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Aft {
    /// A half-torus shoulder, then a disc.
    Flat,
    /// A half-torus shoulder, a face 15 deg from the plane normal to the axis, a spherical lid.
    Mmeev,
    /// Cones, then a disc.
    Cones(Vec<AftCone>),
    /// Cones, the last of which touches a spherical cap on the axis.
    Capped {
        /// The cones; where the last one ends follows from the cap.
        cones: Vec<AftCone>,
        /// Radius of the cap, m.
        cap_radius_m: f64,
    },
}

/// Dimensions of an outline.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shape {
    /// Largest diameter, m.
    pub diameter_m: f64,
    /// Radius of nose or segment, m.
    pub nose_radius_m: f64,
    /// Radius of the shoulder, m.
    pub shoulder_radius_m: f64,
    /// Half-angle of the forebody's cone, rad; `None` for a spherical segment.
    pub cone_half_angle_rad: Option<f64>,
    /// Aftbody.
    pub aft: Aft,
}

/// Fault of a dimension: its name without the section, and the message.
pub type ShapeFault = (&'static str, String);

/// Slope of the aft face of [`Aft::Mmeev`] against the plane normal to the axis, rad.
const MMEEV_SLOPE_RAD: f64 = 15.0 * RADIANS_PER_DEGREE;
/// Radius of its lid over the vehicle's.
const MMEEV_LID: f64 = 0.6;

/// Adds a segment unless it has no length.
fn add(segments: &mut Vec<Segment>, segment: Segment) {
    let gone = match segment {
        Segment::Line { start, end } => start == end,
        Segment::Arc {
            radius_m,
            sweep_rad,
            ..
        } => radius_m == 0.0 || sweep_rad == 0.0,
    };
    if !gone {
        segments.push(segment);
    }
}

impl Shape {
    /// All faults that keep these dimensions from defining an outline.
    pub fn faults(&self) -> Vec<ShapeFault> {
        let radius = self.diameter_m / 2.0;
        let (nose, shoulder) = (self.nose_radius_m, self.shoulder_radius_m);
        let mut faults: Vec<ShapeFault> = Vec::new();
        if shoulder > radius {
            let message = format!(
                "got {shoulder} m, must be at most {radius} m, the radius of the vehicle: the shoulder arc would cross the axis"
            );
            faults.push(("shoulder_radius_m", message));
            return faults;
        }
        match self.cone_half_angle_rad {
            Some(theta) => {
                let (_, cos) = sin_cos(theta);
                let begins = radius - shoulder + shoulder * cos;
                if nose * cos > begins {
                    let message = format!(
                        "got {nose} m, must be at most {:.6} m: the nose sphere crosses the shoulder, as it would touch the cone {:.6} m off the axis, beyond {begins:.6} m where the shoulder begins",
                        begins / cos,
                        nose * cos
                    );
                    faults.push(("nose_radius_m", message));
                }
            }
            None if nose < radius => {
                let message = format!(
                    "got {nose} m, must be at least {radius} m: a spherical segment of a smaller sphere does not reach the shoulder"
                );
                faults.push(("nose_radius_m", message));
            }
            None => {}
        }
        faults.extend(self.aft_faults());
        faults
    }

    fn aft_faults(&self) -> Vec<ShapeFault> {
        let (cones, cap) = match &self.aft {
            Aft::Flat | Aft::Mmeev => return Vec::new(),
            Aft::Cones(cones) => (cones, None),
            Aft::Capped {
                cones,
                cap_radius_m,
            } => (cones, Some(*cap_radius_m)),
        };
        let mut faults = Vec::new();
        let Some(first) = cones.first() else {
            return vec![("aft", "an aftbody of cones has none".to_owned())];
        };
        let radius = self.diameter_m / 2.0 - self.shoulder_radius_m;
        let mut from = radius + self.shoulder_radius_m * cos(first.half_angle_rad);
        for (i, cone) in cones.iter().enumerate() {
            let end = match cap {
                Some(cap) if i + 1 == cones.len() => cap * cos(cone.half_angle_rad),
                _ => cone.end_radius_m,
            };
            if end > from {
                let message = format!(
                    "aft cone {} ends {end:.6} m off the axis, outside {from:.6} m where it begins: it must narrow",
                    i + 1
                );
                faults.push(("aft", message));
            }
            from = end;
        }
        faults
    }

    /// The body, or all faults of its dimensions.
    pub fn body(&self, name: &str) -> Result<RigidBody, Vec<ShapeFault>> {
        let faults = self.faults();
        if !faults.is_empty() {
            return Err(faults);
        }
        Ok(RigidBody {
            name: name.to_owned(),
            outline: self.outline().closed(),
            diameter_m: self.diameter_m,
            nose_radius_m: Some(self.nose_radius_m).filter(|radius| *radius > 0.0),
            cone_half_angle_rad: self.cone_half_angle_rad,
            virtual_apex_x_m: self.cone_half_angle_rad.map(|_| 0.0),
            notes: Vec::new(),
        })
    }

    /// The shape scaled by a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let cones = |cones: &[AftCone]| {
            let scaled = |cone: &AftCone| AftCone {
                end_radius_m: factor * cone.end_radius_m,
                ..*cone
            };
            cones.iter().map(scaled).collect()
        };
        Self {
            diameter_m: factor * self.diameter_m,
            nose_radius_m: factor * self.nose_radius_m,
            shoulder_radius_m: factor * self.shoulder_radius_m,
            cone_half_angle_rad: self.cone_half_angle_rad,
            aft: match &self.aft {
                Aft::Flat => Aft::Flat,
                Aft::Mmeev => Aft::Mmeev,
                Aft::Cones(list) => Aft::Cones(cones(list)),
                Aft::Capped {
                    cones: list,
                    cap_radius_m,
                } => Aft::Capped {
                    cones: cones(list),
                    cap_radius_m: factor * cap_radius_m,
                },
            },
        }
    }

    /// Center of the shoulder, and the angle from its center to where the forebody meets it, from the x axis.
    fn shoulder(&self) -> (Point, f64) {
        let (nose, radius) = (self.nose_radius_m, self.shoulder_radius_m);
        let r_m = self.diameter_m / 2.0 - radius;
        match self.cone_half_angle_rad {
            Some(theta) => {
                let (sin, cos) = sin_cos(theta);
                let x_m = (r_m + radius * cos) * cos / sin + radius * sin;
                (Point { x_m, r_m }, FRAC_PI_2 + theta)
            }
            None => {
                let between = nose - radius;
                let along = (between * between - r_m * r_m).max(0.0).sqrt();
                let x_m = nose - along;
                (Point { x_m, r_m }, PI - atan2(r_m, along))
            }
        }
    }

    /// The open outline from the nose to the aft end of the axis.
    pub fn outline(&self) -> Profile {
        let mut segments = Vec::with_capacity(8);
        let (center, meets) = self.shoulder();
        let nose = self.nose_radius_m;
        let shoulder = |to: f64| Segment::arc(center, self.shoulder_radius_m, meets, to - meets);
        match self.cone_half_angle_rad {
            Some(theta) => {
                let (sin, cos) = sin_cos(theta);
                let nose_center = Point::on_axis(nose / sin);
                let arc = Segment::arc(nose_center, nose, PI, theta - FRAC_PI_2);
                add(&mut segments, arc);
                let start = match nose > 0.0 {
                    true => arc.end(),
                    false => Point::on_axis(0.0),
                };
                let end = match self.shoulder_radius_m > 0.0 {
                    true => shoulder(0.0).start(),
                    false => center,
                };
                if end.r_m > start.r_m && nose * cos < end.r_m {
                    add(&mut segments, Segment::Line { start, end });
                }
            }
            None => add(
                &mut segments,
                Segment::arc(Point::on_axis(nose), nose, PI, meets - PI),
            ),
        }
        let half_turn = Point {
            x_m: center.x_m + self.shoulder_radius_m,
            r_m: center.r_m,
        };
        match &self.aft {
            Aft::Flat => {
                add(&mut segments, shoulder(0.0));
                let end = Point::on_axis(half_turn.x_m);
                add(
                    &mut segments,
                    Segment::Line {
                        start: half_turn,
                        end,
                    },
                );
            }
            Aft::Mmeev => {
                add(&mut segments, shoulder(0.0));
                self.mmeev_aft(&mut segments, half_turn);
            }
            Aft::Cones(cones) => {
                let end = self.cones(&mut segments, cones, None);
                let start = end;
                add(
                    &mut segments,
                    Segment::Line {
                        start,
                        end: Point::on_axis(end.x_m),
                    },
                );
            }
            Aft::Capped {
                cones,
                cap_radius_m,
            } => {
                let end = self.cones(&mut segments, cones, Some(*cap_radius_m));
                let angle = cones
                    .last()
                    .map_or(FRAC_PI_2, |c| FRAC_PI_2 - c.half_angle_rad);
                let (_, c) = sin_cos(angle);
                let cap_center = Point::on_axis(end.x_m - cap_radius_m * c);
                add(
                    &mut segments,
                    Segment::arc(cap_center, *cap_radius_m, angle, -angle),
                );
            }
        }
        joined(segments)
    }

    /// Shoulder and aft cones; where they end.
    fn cones(&self, segments: &mut Vec<Segment>, cones: &[AftCone], cap: Option<f64>) -> Point {
        let (center, meets) = self.shoulder();
        let leaves = cones.first().map_or(0.0, |c| FRAC_PI_2 - c.half_angle_rad);
        let arc = Segment::arc(center, self.shoulder_radius_m, meets, leaves - meets);
        add(segments, arc);
        let mut at = match self.shoulder_radius_m > 0.0 {
            true => arc.end(),
            false => center,
        };
        for (i, cone) in cones.iter().enumerate() {
            let (sin, cos) = sin_cos(cone.half_angle_rad);
            let r_m = match cap {
                Some(cap) if i + 1 == cones.len() => cap * cos,
                _ => cone.end_radius_m,
            };
            let end = Point {
                x_m: at.x_m + (at.r_m - r_m) * cos / sin,
                r_m,
            };
            add(segments, Segment::Line { start: at, end });
            at = end;
        }
        at
    }

    fn mmeev_aft(&self, segments: &mut Vec<Segment>, start: Point) {
        let radius = self.diameter_m / 2.0;
        let (sin, cos) = sin_cos(
            self.cone_half_angle_rad
                .unwrap_or(60.0 * RADIANS_PER_DEGREE),
        );
        let center = Point::on_axis(0.4 * 3.0_f64.sqrt() * radius * cos / sin);
        let lid = MMEEV_LID * radius;
        // along the face, run from the shoulder inwards: distance at which it meets the lid
        let (s, c) = sin_cos(MMEEV_SLOPE_RAD);
        let (dx, dr) = (start.x_m - center.x_m, start.r_m);
        // |(dx + t s, dr − t c)| = R
        let half = dr * c - dx * s;
        let rest = half * half - (dx * dx + dr * dr - lid * lid);
        let to_axis = start.r_m / c;
        let meets = half - rest.max(0.0).sqrt();
        let apex_x_m = start.x_m + to_axis * s;
        if rest <= 0.0 || !(0.0..to_axis).contains(&meets) || center.x_m + lid <= apex_x_m {
            let end = Point::on_axis(apex_x_m);
            add(segments, Segment::Line { start, end });
            return;
        }
        let end = Point {
            x_m: start.x_m + meets * s,
            r_m: start.r_m - meets * c,
        };
        add(segments, Segment::Line { start, end });
        let angle = atan2(end.r_m, end.x_m - center.x_m);
        add(segments, Segment::arc(center, lid, angle, -angle));
    }
}

/// Segments whose ends differ by rounding, made to meet: each begins exactly where the one before it ends.
fn joined(mut segments: Vec<Segment>) -> Profile {
    let mut last: Option<Point> = None;
    for segment in &mut segments {
        if let Some(point) = last {
            match segment {
                Segment::Line { start, .. } | Segment::Arc { start, .. } => *start = point,
            }
        }
        last = Some(segment.end());
    }
    Profile { segments }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sphere_cone(theta_deg: f64, aft: Aft) -> Shape {
        Shape {
            diameter_m: 1.0,
            nose_radius_m: 0.375,
            shoulder_radius_m: 0.025,
            cone_half_angle_rad: Some(theta_deg * RADIANS_PER_DEGREE),
            aft,
        }
    }

    /// Gaps, crossings and the like of a shape's outline.
    fn sound(shape: &Shape) -> RigidBody {
        let body = shape.body("x").unwrap();
        let open = shape.outline();
        let faults = crate::vehicle::body::check::faults(&open);
        assert!(faults.is_empty(), "{shape:?}: {faults:?}");
        for pair in open.segments.windows(2) {
            assert_eq!(pair[0].end(), pair[1].start(), "{shape:?}");
        }
        body
    }

    #[test]
    fn sphere_cone_torus_of_1_m_with_a_flat_back() {
        // forebody computed independently: 0.08566168 m³ and 0.93450031 m² to the largest diameter;
        // behind it half a torus: π r_s² R_s + 2π (r_s π R_s²/4 + R_s³/3), and 2π R_s (r_s π/2 + R_s) + π r_s²
        let body = sound(&sphere_cone(60.0, Aft::Flat));
        let (r_s, rs) = (0.475, 0.025);
        let behind =
            PI * r_s * r_s * rs + 2.0 * PI * (r_s * PI * rs * rs / 4.0 + rs * rs * rs / 3.0);
        let area = 2.0 * PI * rs * (r_s * FRAC_PI_2 + rs) + PI * r_s * r_s;
        let volume = body.outline.solid().volume_m3;
        assert!((volume - 0.085_661_68 - behind).abs() < 5.1e-9, "{volume}");
        let wetted = body.outline.wetted_area_m2();
        assert!((wetted - 0.934_500_31 - area).abs() < 5.1e-9, "{wetted}");
    }

    #[test]
    fn sharp_cone_without_shoulder_is_a_cone() {
        let mut cone = sphere_cone(45.0, Aft::Flat);
        (cone.nose_radius_m, cone.shoulder_radius_m) = (0.0, 0.0);
        let body = sound(&cone);
        assert!((body.outline.solid().volume_m3 - PI * 0.125 / 3.0).abs() < 1e-15);
        assert_eq!((body.nose_radius_m, body.outline.segments.len()), (None, 3));
    }

    #[test]
    fn the_lid_of_the_mmeev_stands_at_60_deg_and_not_at_45() {
        let lid = |theta| {
            let body = sound(&sphere_cone(theta, Aft::Mmeev));
            let arcs = body
                .outline
                .segments
                .iter()
                .filter(|s| matches!(s, Segment::Arc { radius_m, .. } if *radius_m == 0.3));
            arcs.count()
        };
        assert_eq!((lid(45.0), lid(60.0), lid(70.0)), (0, 1, 1));
        let body = sound(&sphere_cone(60.0, Aft::Mmeev));
        // center at 0.2 D, top a radius of 0.3 D behind
        assert!((body.nose_tip_x_m() + body.length_m() - 0.5).abs() < 1e-12);
    }

    #[test]
    fn a_hemisphere_is_a_spherical_segment() {
        let shape = Shape {
            diameter_m: 2.0,
            nose_radius_m: 1.0,
            shoulder_radius_m: 0.0,
            cone_half_angle_rad: None,
            aft: Aft::Flat,
        };
        let body = sound(&shape);
        assert!((body.outline.solid().volume_m3 - 2.0 * PI / 3.0).abs() < 1e-15);
    }

    #[test]
    fn capped_cones_touch_their_cap() {
        let shape = Shape {
            diameter_m: 3.9116,
            nose_radius_m: 4.694,
            shoulder_radius_m: 0.196,
            cone_half_angle_rad: None,
            aft: Aft::Capped {
                cones: vec![AftCone {
                    half_angle_rad: 33.0 * RADIANS_PER_DEGREE,
                    end_radius_m: 0.0,
                }],
                cap_radius_m: 0.231,
            },
        };
        let body = sound(&shape);
        let cap = body.outline.segments.iter().rev().nth(1).unwrap();
        let Segment::Arc { center, start, .. } = *cap else {
            panic!("{cap:?}")
        };
        assert!(
            ((start.r_m / (start.x_m - center.x_m))
                - 1.0 / numerics::math::tan(33.0 * RADIANS_PER_DEGREE))
            .abs()
                < 1e-12
        );
    }

    #[test]
    fn impossible_dimensions_say_what_crosses_what() {
        let mut shape = sphere_cone(60.0, Aft::Flat);
        shape.nose_radius_m = 1.2;
        let (key, message) = shape.body("x").unwrap_err().remove(0);
        assert_eq!(key, "nose_radius_m");
        assert!(
            message.contains("at most 0.975000 m") && message.contains("crosses the shoulder"),
            "{message}"
        );
        shape.shoulder_radius_m = 0.6;
        assert_eq!(shape.body("x").unwrap_err()[0].0, "shoulder_radius_m");
    }
}
