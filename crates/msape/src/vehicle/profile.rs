//! Closed curves of straight lines and circular arcs in the half-plane (x, r), and the solids that they enclose when revolved.
//!
//! ```text
//! A = ∮ −r dx    ∬ r dA = ∮ −r²/2 dx    ∬ x r dA = ∮ −x r²/2 dx    ∬ x² r dA = ∮ −x² r²/2 dx    ∬ r³ dA = ∮ −r⁴/4 dx
//! V = 2π ∬ r dA    x̄ = ∬ x r dA / ∬ r dA    I_xx = 2π ρ ∬ r³ dA    I_yy = π ρ ∬ r³ dA + 2π ρ ∬ x² r dA
//! ```
//!
//! with lengths in m, A in m², V in m³, ρ in kg/m³, I in kg m²; x along the axis from the virtual apex, aft positive, r ≥ 0.
//! Every integral is a closed form over lines and arcs (Green's theorem): nothing is sampled.
//!
//! # Valid
//! Curves that do not cross themselves and do not cross the axis.
//!
//! # References
//! - \[samareh-2014\] section 3.1.4 (components as revolved closed profiles).

use crate::vehicle::segment::{Integrals, Point, Segment};
use numerics::math::PI;
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// An open or closed chain of segments, each starting where the one before it ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Profile<S = f64> {
    /// The segments, in order.
    pub segments: Vec<Segment<S>>,
}

impl<S> Default for Profile<S> {
    fn default() -> Self {
        Self {
            segments: Vec::new(),
        }
    }
}

/// Properties of the solid that a closed profile encloses when revolved about the axis.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct SolidProperties<S = f64> {
    /// Area of the half-section, m².
    pub section_area_m2: S,
    /// Volume, m³.
    pub volume_m3: S,
    /// Volume times the axial position of its centroid, m⁴.
    pub volume_moment_m4: S,
    /// Second moment about the axis, ∫ (y² + z²) dV, m⁵.
    pub axial_second_moment_m5: S,
    /// Second moment about a transverse axis through x = 0, ∫ (x² + z²) dV, m⁵.
    pub transverse_second_moment_m5: S,
}

impl<S: Single> SolidProperties<S> {
    /// An empty body.
    pub fn empty() -> Self {
        let zero = S::constant(0.0);
        Self {
            section_area_m2: zero,
            volume_m3: zero,
            volume_moment_m4: zero,
            axial_second_moment_m5: zero,
            transverse_second_moment_m5: zero,
        }
    }

    /// Axial position of the centroid, m; zero for an empty body.
    pub fn centroid_x_m(&self) -> S {
        if self.volume_m3.value() > 0.0 {
            self.volume_moment_m4 / self.volume_m3
        } else {
            S::constant(0.0)
        }
    }

    /// The two bodies as one.
    pub fn plus(self, other: Self) -> Self {
        Self {
            section_area_m2: self.section_area_m2 + other.section_area_m2,
            volume_m3: self.volume_m3 + other.volume_m3,
            volume_moment_m4: self.volume_moment_m4 + other.volume_moment_m4,
            axial_second_moment_m5: self.axial_second_moment_m5 + other.axial_second_moment_m5,
            transverse_second_moment_m5: self.transverse_second_moment_m5
                + other.transverse_second_moment_m5,
        }
    }
}

impl<S: Single> Profile<S> {
    /// The end of the last segment.
    pub fn end(&self) -> Option<Point<S>> {
        self.segments.last().map(Segment::end)
    }

    /// The start of the first segment.
    pub fn start(&self) -> Option<Point<S>> {
        self.segments.first().map(Segment::start)
    }

    /// The curve in the opposite direction.
    pub fn reversed(&self) -> Self {
        Self {
            segments: self.segments.iter().rev().map(Segment::reversed).collect(),
        }
    }

    /// Whether it lies where another does and in its direction, however both move.
    pub fn is_along(&self, other: &Self) -> bool {
        let mut pairs = self.segments.iter().zip(&other.segments);
        self.segments.len() == other.segments.len() && pairs.all(|(one, other)| one.is_along(other))
    }

    /// An empty curve that reuses the memory of this one.
    pub fn cleared(mut self) -> Self {
        self.segments.clear();
        self
    }

    /// This curve followed by a segment, joined by a line where there is a gap.
    pub fn and(self, segment: Segment<S>) -> Self {
        let mut path = self.line_to(segment.start());
        path.segments.push(segment);
        path
    }

    /// This curve followed by `other`, joined by a line where there is a gap.
    pub fn then(self, other: &Self) -> Self {
        other.segments.iter().copied().fold(self, Self::and)
    }

    /// This curve followed by `other` in the opposite direction, joined by a line where there is a gap.
    pub fn back_along(self, other: &Self) -> Self {
        let backwards = other.segments.iter().rev().map(Segment::reversed);
        backwards.fold(self, Self::and)
    }

    /// This curve with a line to `point` (nothing when it is already there).
    pub fn line_to(mut self, point: Point<S>) -> Self {
        match self.end() {
            Some(end) if !end.is_at(&point) => self.segments.push(Segment::Line {
                start: end,
                end: point,
            }),
            _ => {}
        }
        self
    }

    /// This curve closed by a line to its start.
    pub fn closed(self) -> Self {
        match self.start() {
            Some(start) => self.line_to(start),
            None => self,
        }
    }

    /// Area, volume and moments enclosed by the closed curve, whichever way it is run.
    pub fn solid(&self) -> SolidProperties<S> {
        let sum = self
            .segments
            .iter()
            .fold(Integrals::zero(), |sum, s| sum.plus(&s.integrals()));
        let sign = if sum.r_dx.value() > 0.0 { 1.0 } else { -1.0 };
        let r3 = sum.r4_dx * sign / 4.0;
        SolidProperties {
            section_area_m2: sum.r_dx * sign,
            volume_m3: sum.r2_dx * (sign * PI),
            volume_moment_m4: sum.x_r2_dx * (sign * PI),
            axial_second_moment_m5: r3 * (2.0 * PI),
            transverse_second_moment_m5: r3 * PI + sum.x2_r2_dx * (sign * PI),
        }
    }

    /// Volume and its moment about x = 0 as in [`Profile::solid`], with the same bits, m³ and m⁴.
    pub fn volume_and_moment(&self) -> (S, S) {
        let zero = S::constant(0.0);
        let (mut r_dx, mut r2_dx, mut x_r2_dx) = (zero, zero, zero);
        for segment in &self.segments {
            let i = segment.integrals();
            r_dx += i.r_dx;
            r2_dx += i.r2_dx;
            x_r2_dx += i.x_r2_dx;
        }
        let sign = if r_dx.value() > 0.0 { 1.0 } else { -1.0 };
        (r2_dx * (sign * PI), x_r2_dx * (sign * PI))
    }

    /// Area swept by the curve when it is revolved about the axis, m².
    pub fn wetted_area_m2(&self) -> S {
        let areas = self.segments.iter().map(Segment::swept_area_m2);
        areas.fold(S::constant(0.0), |sum, area| sum + area)
    }
}

impl Profile {
    /// Least and largest axial position, least and largest distance from the axis, of every point of it and not of its ends alone, m.
    pub fn bounds_m(&self) -> [f64; 4] {
        let (least, most) = (f64::INFINITY, f64::NEG_INFINITY);
        let bounds = self.segments.iter().map(Segment::bounds_m);
        bounds.fold(
            [least, most, least, most],
            |[a, b, c, d], [x0, x1, r0, r1]| [a.min(x0), b.max(x1), c.min(r0), d.max(r1)],
        )
    }

    /// Centroid of the section (not of the body of revolution); `None` when it has no area.
    pub fn section_centroid(&self) -> Option<Point> {
        let (mut area, mut x, mut r) = (0.0, 0.0, 0.0);
        for segment in &self.segments {
            let i = segment.integrals();
            area += i.r_dx;
            x += i.x_r_dx;
            r += i.r2_dx / 2.0;
        }
        (area != 0.0).then(|| Point {
            x_m: x / area,
            r_m: r / area,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use numerics::math::FRAC_PI_2;

    fn point(x_m: f64, r_m: f64) -> Point {
        Point { x_m, r_m }
    }

    fn close(got: f64, want: f64) {
        assert!(
            (got - want).abs() <= 1e-12 * want.abs().max(1.0),
            "{got} against {want}"
        );
    }

    /// A line of no length would have the derivative of a square root at zero.
    #[test]
    fn curves_are_joined_by_place_and_not_by_derivatives() {
        use numerics::scalar::{Dual, Scalar};
        let at = |x: f64, r: f64, index: usize| Point {
            x_m: Dual::<2>::variable(x, index),
            r_m: Dual::constant(r),
        };
        let line = |index| Segment::Line {
            start: at(0.0, 1.0, index),
            end: at(2.0, 1.0, index),
        };
        let [one, other] = [0, 1].map(|index| Profile::default().and(line(index)));
        let joined = one.clone().line_to(at(2.0, 1.0, 1));
        assert_eq!(joined, one);
        assert!(one != other && one.is_along(&other));
        assert!(!one.is_along(&one.reversed()) && !one.is_along(&Profile::default()));
        let arcs = [PI, -PI].map(|sweep| Segment::arc(point(0.0, 0.0), 1.0, 0.0, sweep));
        assert!(arcs[0].is_along(&arcs[0]) && !arcs[0].is_along(&arcs[1]));
    }

    #[test]
    fn sphere_of_radius_2_at_x_3() {
        let half = Segment::arc(point(3.0, 0.0), 2.0, PI, -PI);
        let ball = Profile {
            segments: vec![half],
        }
        .closed()
        .solid();
        let volume = 4.0 / 3.0 * PI * 8.0;
        close(ball.volume_m3, volume);
        close(ball.centroid_x_m(), 3.0);
        // 2/5 V R² about any diameter; V x̄² more about the origin
        close(ball.axial_second_moment_m5, 0.4 * volume * 4.0);
        close(
            ball.transverse_second_moment_m5,
            0.4 * volume * 4.0 + volume * 9.0,
        );
        close(half.swept_area_m2(), 4.0 * PI * 4.0);
    }

    #[test]
    fn cone_of_height_3_and_base_radius_2() {
        let side = Segment::Line {
            start: point(0.0, 0.0),
            end: point(3.0, 2.0),
        };
        let cone = Profile {
            segments: vec![side],
        }
        .line_to(point(3.0, 0.0))
        .closed()
        .solid();
        let volume = PI * 4.0 * 3.0 / 3.0;
        close(cone.volume_m3, volume);
        close(cone.centroid_x_m(), 2.25); // 3/4 of the height from the apex
        close(cone.axial_second_moment_m5, 0.3 * volume * 4.0); // 3/10 V R²
        close(
            cone.transverse_second_moment_m5,
            volume * (0.15 * 4.0 + 0.6 * 9.0),
        ); // V (3/20 R² + 3/5 H²), about the apex
        close(side.swept_area_m2(), PI * 2.0 * 13.0_f64.sqrt());
    }

    #[test]
    fn torus_ring_of_radius_half_at_2() {
        let ring = Profile {
            segments: vec![Segment::arc(point(1.0, 2.0), 0.5, 0.3, 2.0 * PI)],
        };
        let solid = ring.solid();
        let volume = 2.0 * PI * PI * 2.0 * 0.25;
        close(solid.volume_m3, volume); // 2 π² R a²
        close(solid.centroid_x_m(), 1.0);
        close(solid.axial_second_moment_m5, volume * (4.0 + 0.75 * 0.25)); // V (R² + 3/4 a²)
        close(
            solid.transverse_second_moment_m5,
            volume * (2.0 + 0.625 * 0.25 + 1.0),
        ); // V (R²/2 + 5/8 a² + x̄²)
        close(ring.wetted_area_m2(), 4.0 * PI * PI * 2.0 * 0.5);
    }

    #[test]
    fn hollow_cylinder_from_1_to_2_of_length_4() {
        let wall = Profile {
            segments: vec![Segment::Line {
                start: point(0.0, 1.0),
                end: point(4.0, 1.0),
            }],
        }
        .line_to(point(4.0, 2.0))
        .line_to(point(0.0, 2.0))
        .closed();
        let solid = wall.solid();
        let volume = PI * 3.0 * 4.0;
        close(solid.volume_m3, volume);
        close(solid.axial_second_moment_m5, volume * 2.5); // V (R² + r²) / 2
        close(
            solid.transverse_second_moment_m5,
            volume * (1.25 + 16.0 / 3.0),
        ); // V ((R² + r²)/4 + L²/3), about the end
        assert_eq!(wall.section_centroid().unwrap(), point(2.0, 1.5));
        assert_eq!(wall.reversed().solid(), solid);
    }

    #[test]
    fn quarter_circle_has_its_centroid_at_4_over_3_pi() {
        let quarter = Profile {
            segments: vec![Segment::arc(point(0.0, 0.0), 1.0, 0.0, FRAC_PI_2)],
        }
        .line_to(point(0.0, 0.0))
        .closed();
        let centroid = quarter.section_centroid().unwrap();
        close(centroid.x_m, 4.0 / (3.0 * PI));
        close(centroid.r_m, 4.0 / (3.0 * PI));
        close(quarter.solid().section_area_m2, PI / 4.0);
    }
}
