//! Facts of an outline: where its pieces meet, what it encloses, up to the largest diameter and in all.
//!
//! ```text
//! A = Σ 2π ∫ r ds      V = π ∮ r² dx      x̄ = π ∮ x r² dx / V
//! ```
//!
//! with lengths in m, from the tip of the nose where the name says so; exact for lines and arcs.
//!
//! # Valid
//! Same as [`crate::vehicle::body`].
//!
//! # References
//! - \[samareh-2014\] section 3.1.4; the integrals are those of [`crate::vehicle::profile`].

use crate::vehicle::body::RigidBody;
use crate::vehicle::profile::Profile;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::FRAC_PI_2;
use serde::{Deserialize, Serialize};

/// Facts of an outline.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Facts {
    /// Largest diameter, m.
    pub diameter_m: f64,
    /// Area that coefficients refer to, m².
    pub reference_area_m2: f64,
    /// Extent along the axis, m.
    pub length_m: f64,
    /// Radius of the nose, m.
    pub nose_radius_m: Option<f64>,
    /// Half-angle of the forebody's cone, deg.
    pub cone_half_angle_deg: Option<f64>,
    /// Virtual apex ahead of the nose, m.
    pub virtual_apex_ahead_of_nose_m: Option<f64>,
    /// End of the nose's arc behind the tip, m.
    pub nose_tangent_from_nose_m: Option<f64>,
    /// Distance of this end from the axis, m.
    pub nose_tangent_r_m: Option<f64>,
    /// Beginning of the shoulder's arc behind the tip, m.
    pub shoulder_tangent_from_nose_m: Option<f64>,
    /// Distance of this beginning from the axis, m.
    pub shoulder_tangent_r_m: Option<f64>,
    /// Radius of the shoulder, m.
    pub shoulder_radius_m: Option<f64>,
    /// Largest diameter behind the tip, m.
    pub largest_diameter_from_nose_m: f64,
    /// Area up to the largest diameter, m².
    pub forebody_area_m2: f64,
    /// Volume up to the largest diameter, m³.
    pub forebody_volume_m3: f64,
    /// Centroid of this volume behind the tip, m.
    pub forebody_centroid_from_nose_m: f64,
    /// Area of the whole outline, m².
    pub wetted_area_m2: f64,
    /// Volume of the whole, m³.
    pub volume_m3: f64,
    /// Centroid of the whole behind the tip, m.
    pub centroid_from_nose_m: f64,
}

impl RigidBody {
    /// Facts of the body.
    pub fn facts(&self) -> Facts {
        let tip_m = self.nose_tip_x_m();
        let first = self.outline.segments.first();
        let nose_end = first.and_then(|segment| match segment {
            Segment::Arc { .. } => Some(segment.end()),
            Segment::Line { .. } => None,
        });
        let (fore, shoulder) = forebody(&self.outline);
        let widest = fore.end().unwrap_or_default();
        let solid = fore
            .clone()
            .line_to(Point::on_axis(widest.x_m))
            .closed()
            .solid();
        let whole = self.outline.solid();
        // the nose itself is no shoulder, as on a ball
        let shoulder = shoulder.filter(|arc| Some(arc.start()) != self.outline.start());
        let shoulder_radius_m = shoulder.and_then(|arc| match arc {
            Segment::Arc { radius_m, .. } => Some(radius_m),
            Segment::Line { .. } => None,
        });
        Facts {
            diameter_m: self.diameter_m,
            reference_area_m2: self.reference_area_m2(),
            length_m: self.length_m(),
            nose_radius_m: self.nose_radius_m,
            cone_half_angle_deg: self
                .cone_half_angle_rad
                .map(|angle| angle / numerics::math::RADIANS_PER_DEGREE),
            virtual_apex_ahead_of_nose_m: self.virtual_apex_x_m.map(|x| tip_m - x),
            nose_tangent_from_nose_m: nose_end.map(|p| p.x_m - tip_m),
            nose_tangent_r_m: nose_end.map(|p| p.r_m),
            shoulder_tangent_from_nose_m: shoulder.map(|arc| arc.start().x_m - tip_m),
            shoulder_tangent_r_m: shoulder.map(|arc| arc.start().r_m),
            shoulder_radius_m,
            largest_diameter_from_nose_m: widest.x_m - tip_m,
            forebody_area_m2: fore.wetted_area_m2(),
            forebody_volume_m3: solid.volume_m3,
            forebody_centroid_from_nose_m: solid.centroid_x_m() - tip_m,
            wetted_area_m2: self.outline.wetted_area_m2(),
            volume_m3: whole.volume_m3,
            centroid_from_nose_m: whole.centroid_x_m() - tip_m,
        }
    }
}

/// The outline up to its largest diameter, and the arc on which that lies.
fn forebody(outline: &Profile) -> (Profile, Option<Segment>) {
    let largest = |segment: &Segment| segment.bounds_m()[3];
    let [.., most] = outline.bounds_m();
    let mut fore = Profile::default();
    for segment in &outline.segments {
        if largest(segment) < most * (1.0 - 1e-12) {
            fore.segments.push(*segment);
            continue;
        }
        return match *segment {
            Segment::Arc {
                center,
                radius_m,
                start_angle_rad,
                ..
            } if segment.sweeps(FRAC_PI_2) => {
                let arc = Segment::arc(
                    center,
                    radius_m,
                    start_angle_rad,
                    FRAC_PI_2 - start_angle_rad,
                );
                if FRAC_PI_2 != start_angle_rad {
                    fore.segments.push(arc);
                }
                (fore, Some(*segment))
            }
            _ if segment.start().r_m < most * (1.0 - 1e-12) => {
                fore.segments.push(*segment);
                (fore, None)
            }
            _ => (fore, None),
        };
    }
    (fore, None)
}

#[cfg(test)]
mod tests {
    use crate::vehicle::body::shape::{Aft, Shape};
    use numerics::math::PI;

    #[test]
    fn sphere_cone_of_1_m_as_computed_independently() {
        let shape = Shape {
            diameter_m: 1.0,
            nose_radius_m: 0.375,
            shoulder_radius_m: 0.025,
            cone_half_angle_rad: Some(PI / 3.0),
            aft: Aft::Flat,
        };
        let facts = shape.body("x").unwrap().facts();
        // printed to eight decimals, hence half a unit of the last
        let rows = [
            (facts.nose_tangent_from_nose_m.unwrap(), 0.050_240_47),
            (facts.nose_tangent_r_m.unwrap(), 0.187_5),
            (facts.shoulder_tangent_from_nose_m.unwrap(), 0.223_445_55),
            (facts.shoulder_tangent_r_m.unwrap(), 0.487_5),
            (facts.largest_diameter_from_nose_m, 0.245_096_19),
            (facts.virtual_apex_ahead_of_nose_m.unwrap(), 0.058_012_7),
            (facts.forebody_area_m2, 0.934_500_31),
            (facts.forebody_volume_m3, 0.085_661_68),
            (facts.forebody_centroid_from_nose_m, 0.171_052_67),
            (4.0 * facts.reference_area_m2, PI),
        ];
        for (got, want) in rows {
            assert!((got - want).abs() <= 5.001e-9, "{got} against {want}");
        }
        assert_eq!(facts.shoulder_radius_m, Some(0.025));
    }

    #[test]
    fn a_ball_is_half_forebody_and_a_cone_is_all() {
        let ball =
            crate::vehicle::body::from_rows("ball", &[vec![0.0, 0.0, -1.0], vec![2.0, 0.0, 0.0]]);
        let facts = ball.unwrap().facts();
        assert!((facts.forebody_volume_m3 - 2.0 * PI / 3.0).abs() < 1e-14);
        assert!((facts.centroid_from_nose_m - 1.0).abs() < 1e-14);
        assert_eq!(facts.shoulder_radius_m, None);
        let cone = crate::vehicle::body::from_rows(
            "cone",
            &[vec![5.0, 0.0], vec![6.0, 1.0], vec![6.0, 0.0]],
        );
        let facts = cone.unwrap().facts();
        assert!((facts.forebody_volume_m3 - facts.volume_m3).abs() < 1e-15);
        assert!((facts.forebody_centroid_from_nose_m - 0.75).abs() < 1e-14);
        assert!((facts.largest_diameter_from_nose_m - 1.0).abs() < 1e-15);
        assert!((facts.cone_half_angle_deg.unwrap() - 45.0).abs() < 1e-12);
    }

    #[test]
    fn lengths_are_between_extremes_and_not_between_ends() {
        let length = |rows: &[Vec<f64>]| {
            let body = crate::vehicle::body::from_rows("x", rows).unwrap();
            (body.facts().length_m, body.extent_m())
        };
        // a ball as one arc
        let (ball, _) = length(&[vec![0.0, 0.0, -1.0], vec![1.0, 0.0, 0.0]]);
        assert!((ball - 1.0).abs() < 1e-15);
        // a base that is hollow, and a nose that is
        let (dish, _) = length(&[vec![0.0, 0.0], vec![0.4, 0.5], vec![0.2, 0.0]]);
        assert!((dish - 0.4).abs() < 1e-15);
        let hollow = [
            vec![0.2, 0.0],
            vec![0.0, 0.3],
            vec![0.4, 0.5],
            vec![0.4, 0.0],
        ];
        assert_eq!(length(&hollow), (0.4, [0.0, 0.4]));
        // a bulging base: an arc of 0.5 about (1, 0), half a ball
        let (bulging, _) = length(&[
            vec![0.0, 0.0],
            vec![1.0, 0.5, -numerics::math::tan(PI / 8.0)],
            vec![1.5, 0.0],
        ]);
        assert!((bulging - 1.5).abs() < 1e-12);
    }
}
