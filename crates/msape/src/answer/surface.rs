//! Largest heat flux along the outer surface of a design, as its heat shields are sized: for a map of the surface.
//!
//! ```text
//! nose and cone   q̇ = q̇₀ f(r)     f of Lees along a sphere-cone, e = 0
//! shoulder        q̇ = q̇ₛ          its largest value on all of the arc
//! forebody        q̇ linear in r   where the case gives the heating of its points, instead of both
//! aftbody         q̇ = q̇ₐ
//! ```
//!
//! with the heat flux of the stagnation point q̇₀, of the shoulder q̇ₛ and of the aftbody q̇ₐ with their margins in W/m², r the
//! distance from the axis in m. The heat flux jumps where two models meet; these steps are not in the flow.
//!
//! # Valid
//! Zero angle of attack. Same as [`crate::heating::distribution`]: on cones steeper than about 55 degrees a lower bound. Radiative
//! heating is distributed like convective heating.
//!
//! # References
//! - \[lees-1956\]; \[samareh-2014\] sections 3.4.3 and 3.5.2.

use crate::answer::Answer;
use crate::flight::points::PointHeat;
use crate::heating::distribution::SphereCone;
use crate::heating::given::body::Along;
use crate::vehicle::forebody::Forebody;
use crate::vehicle::segment::{Point, Segment};
use numerics::math::hypot;

/// Largest distance of a point of the shoulder from its circle, as a fraction of the radius.
const ON_SHOULDER: f64 = 1e-6;

/// Heat flux along the outer surface of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct SurfaceHeating {
    /// Heated forebody.
    pub forebody: Forebody,
    /// Largest heat flux at the stagnation point, W/m².
    pub stagnation_w_m2: f64,
    /// Largest heat flux on the shoulder, W/m².
    pub shoulder_w_m2: f64,
    /// Largest heat flux on the aftbody, W/m².
    pub aftbody_w_m2: f64,
    /// Distance from the axis, m, and largest heat flux, W/m², of the points for which the case gives the heating, from the axis
    /// outwards; none where it gives none.
    pub points: Vec<[f64; 2]>,
}

/// A part of the outer surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Region {
    /// Nose and cone.
    Forebody,
    /// Shoulder arc.
    Shoulder,
    /// Wing, annulus, lid.
    Aftbody,
}

impl SurfaceHeating {
    /// Heating of a design; `None` without a flight or a closed vehicle.
    pub fn of(answer: &Answer) -> Option<Self> {
        let (design, flight) = (answer.design.as_ref()?, answer.flight.as_ref()?);
        let forebody = design.vehicle.layout.outline.forebody;
        let point = |point: &PointHeat| {
            let r_m = match point.along {
                Along::Radius => 0.5 * forebody.diameter_m * point.fraction,
                Along::Arc => forebody.radius_along_m(point.fraction),
            };
            [r_m, point.peak_heat_flux_w_m2]
        };
        Some(Self {
            points: flight.points.iter().map(point).collect(),
            forebody,
            stagnation_w_m2: flight.peak_total_margined_heat_flux_w_m2.value,
            shoulder_w_m2: design.shoulder_heat_flux_w_m2,
            aftbody_w_m2: design.aftbody_heat_flux_w_m2,
        })
    }

    /// Largest heat flux on the surface, W/m².
    pub fn largest_w_m2(&self) -> f64 {
        self.stagnation_w_m2
            .max(self.shoulder_w_m2)
            .max(self.aftbody_w_m2)
    }

    /// The part of the surface on which a segment of the outer mold line lies.
    pub fn region(&self, segment: &Segment) -> Region {
        let center = self.forebody.shoulder_center();
        let radius = self.forebody.shoulder_radius_m;
        let (start, end) = (segment.start(), segment.end());
        let on_shoulder = |p: Point| {
            let off = hypot(p.x_m - center.x_m, p.r_m - center.r_m) - radius;
            off.abs() <= ON_SHOULDER * radius
        };
        let is_arc = matches!(segment, Segment::Arc { .. });
        if is_arc && on_shoulder(start) && on_shoulder(end) {
            Region::Shoulder
        } else if 0.5 * (start.x_m + end.x_m) < center.x_m {
            Region::Forebody
        } else {
            Region::Aftbody
        }
    }

    /// Heat flux at the distance `r_m` from the axis on a part of the surface, W/m².
    pub fn heat_flux_w_m2(&self, region: Region, r_m: f64) -> f64 {
        let body = SphereCone {
            half_angle_rad: self.forebody.cone_half_angle_rad,
            nose_radius_m: self.forebody.nose_radius_m,
        };
        match region {
            Region::Forebody | Region::Shoulder if !self.points.is_empty() => self.of_points(r_m),
            Region::Forebody => self.stagnation_w_m2 * body.heat_flux_ratio(r_m, 0.0),
            Region::Shoulder => self.shoulder_w_m2,
            Region::Aftbody => self.aftbody_w_m2,
        }
    }
}

impl SurfaceHeating {
    /// Heat flux between the points of the case, held beyond the last, W/m².
    fn of_points(&self, r_m: f64) -> f64 {
        let next = self.points.partition_point(|[at_m, _]| *at_m <= r_m);
        let before = next.checked_sub(1).and_then(|i| self.points.get(i));
        match (before, self.points.get(next)) {
            (Some([r_0, q_0]), Some([r_1, q_1])) => q_0 + (q_1 - q_0) * (r_m - r_0) / (r_1 - r_0),
            (Some([_, q]), None) | (None, Some([_, q])) => *q,
            (None, None) => self.stagnation_w_m2,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Case, Library, Request, design};

    fn heated() -> (SurfaceHeating, Answer) {
        let library = Library::builtin().unwrap();
        let answer = design(&Case::run_page(), &library, Request::Nothing).unwrap();
        (SurfaceHeating::of(&answer).unwrap(), answer)
    }

    #[test]
    fn every_region_of_an_outline_is_met_from_the_nose_to_the_lid() {
        let (heating, answer) = heated();
        let outline = answer.design.unwrap().vehicle.outline;
        // joints of rounding sweep next to nothing, the closing line on the axis nothing
        let outside = outline.segments.iter().filter(|s| s.swept_area_m2() > 1e-9);
        let regions: Vec<Region> = outside.map(|s| heating.region(s)).collect();
        let count = |region| regions.iter().filter(|r| **r == region).count();
        // nose, cone; shoulder; wing, annulus, lid
        assert_eq!(
            [Region::Forebody, Region::Shoulder, Region::Aftbody].map(count),
            [2, 1, 3],
            "{regions:?}"
        );
        assert_eq!(regions.first(), Some(&Region::Forebody));
        assert_eq!(regions.last(), Some(&Region::Aftbody));
    }

    #[test]
    fn the_stagnation_point_has_its_own_heat_flux_and_the_cone_less() {
        let (heating, answer) = heated();
        let tip = heating.heat_flux_w_m2(Region::Forebody, 0.0);
        assert_eq!(
            tip,
            answer
                .flight
                .unwrap()
                .peak_total_margined_heat_flux_w_m2
                .value
        );
        let r_m = 0.4 * heating.forebody.diameter_m;
        assert!(heating.heat_flux_w_m2(Region::Forebody, r_m) < tip);
        assert!(heating.largest_w_m2() >= tip);
    }

    #[test]
    fn points_that_the_case_gives_are_the_map_of_the_forebody() {
        let text = crate::library::data_file("cases/msr-eev-pica.toml").unwrap();
        for (key, along) in [("radius", Along::Radius), ("arc", Along::Arc)] {
            let mut rows = String::new();
            for f in [0.0, 0.5, 1.0] {
                for v in [2e3, 14e3] {
                    for rho in [1e-6_f64, 1e-2] {
                        let flux = (1.0 + f) * 3.6e-4 * rho.sqrt() * v * v * v;
                        rows.push_str(&format!("[{f}, {v}, {rho:e}, {flux:e}, 0.0],\n"));
                    }
                }
            }
            let mut case = Case::from_text(text).unwrap();
            case.set(&format!("heating.{key}_table"), &format!("[{rows}]"));
            let library = Library::builtin().unwrap();
            let answer = design(&case, &library, Request::Nothing).unwrap();
            let heating = SurfaceHeating::of(&answer).unwrap();
            let tip = heating.heat_flux_w_m2(Region::Forebody, 0.0);
            assert!((tip / heating.stagnation_w_m2 - 1.0).abs() < 1e-9);
            let radius_m = 0.5 * heating.forebody.diameter_m;
            let half_m = match along {
                Along::Radius => 0.5 * radius_m,
                Along::Arc => heating.forebody.radius_along_m(0.5),
            };
            for (region, r_m, of_tip) in [
                (Region::Forebody, half_m, 1.5),
                (Region::Forebody, 0.5 * half_m, 1.25),
                (Region::Shoulder, radius_m, 2.0),
            ] {
                let flux = heating.heat_flux_w_m2(region, r_m);
                assert!((flux / tip - of_tip).abs() < 1e-9, "{key} {r_m}: {flux}");
            }
            assert!((heating.largest_w_m2() / tip - 2.0).abs() < 1e-9);
            // the heat shield is sized at the last point, and all points are in the JSON
            let made = answer.design.as_ref().unwrap();
            assert!((made.shoulder_heat_flux_ratio - 2.0).abs() < 1e-9);
            let load = made.shoulder_heat_load_j_m2 / made.forebody_judged.heat_load_j_m2;
            assert!((load - 1.0).abs() < 1e-9, "{load}");
            let json = crate::answer::json(&answer, crate::quantity::Job::Design);
            let last = &json["heating_points"][2];
            assert_eq!(last[format!("{key}_fraction")], 1.0);
            let flux = last["peak_total_margined_heat_flux_w_m2"].as_f64();
            assert_eq!(
                flux,
                answer
                    .flight
                    .as_ref()
                    .map(|f| f.points[2].peak_heat_flux_w_m2)
            );
            // the closed form integrates the points, too
            case.set("solver.flight_model", "allen-eggers");
            let closed = design(&case, &library, Request::Nothing).unwrap();
            let points = closed.flight.unwrap().points;
            let load = points[2].heat_load_j_m2 / points[0].heat_load_j_m2;
            assert!((load - 2.0).abs() < 1e-9, "{load}");
        }
    }
}
