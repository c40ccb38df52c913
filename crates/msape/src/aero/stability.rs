//! Static margin and trims of an outline about its center of gravity, in free-molecular and in hypersonic flow.
//!
//! ```text
//! margin = x_cp − x_cg,  x_cp = −C_m/C_N as α → 0        in diameters
//! C_m + C_N x_cg = 0:  every trim from 0 to 180 deg, stable where dC_m,cg/dα < 0
//! ```
//!
//! with α the angle of attack in rad, x aft of the virtual apex, C_m about it. Free-molecular flow is the limit of high speed,
//! S → ∞, on a wall that takes the molecules up: the least margin of any speed. Hypersonic flow is Newton's, with
//! C_p,max of high Mach numbers; its trims are those of the [database](super::database) at Mach 1.5 and above, where
//! C_N and C_m of impact theory are only scaled.
//!
//! # Valid
//! Bodies of revolution with the center of gravity on the axis. Impact theory for a vehicle that flies backward knows no
//! wake and no separated flow.
//!
//! # References
//! - \[samareh-2014\] sections 3.1.2 and 3.3.2, Figure 25; \[anderson-2006\] sections 3.2 and 3.3; \[schaaf-chambre-1961\].

use super::free_molecular::Gas;
use super::integral::{Effort, Law, Loads, loads};
use super::newtonian::pressure_coefficient_max;
use super::standard::AeroBody;
use super::trim::{END_STEP_RAD, Search, Trim, trims};
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// Mach number of the hypersonic limit.
const HYPERSONIC_MACH: f64 = 1e4;
/// Search for trims: roots of coarse moments, corrected by those of a table.
const SEARCH: Search = Search {
    steps: 20,
    tolerance_rad: 5e-4,
    slope_step_rad: 0.01,
};
/// Effort for the signs of the search: one rule of five points per piece.
const COARSE: Effort = Effort {
    tolerance: f64::INFINITY,
    depth: 0,
    short: f64::INFINITY,
    thermal_panel: 4.6,
};
/// Normal force below which there is no center of pressure.
const NO_FORCE: f64 = 1e-12;

/// Stability in one regime.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct RegimeStability {
    /// Distance of the center of pressure, nose first, aft of the center of gravity, diameters.
    pub static_margin: Option<f64>,
    /// Every trim from 0 to 180 deg, ascending.
    pub trims: Vec<Trim>,
}

/// Stability of a body about its center of gravity.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Stability {
    /// Stability in free-molecular flow.
    pub free_molecular: RegimeStability,
    /// Stability in hypersonic continuum flow.
    pub hypersonic: RegimeStability,
}

impl RegimeStability {
    fn inner(&self, stable: bool) -> Option<&Trim> {
        let inner = |t: &&Trim| t.alpha_deg > 0.0 && t.alpha_deg < 180.0;
        self.trims
            .iter()
            .filter(inner)
            .find(|t| t.is_stable() == stable)
    }

    /// The first unstable trim between 0 and 180 deg: up to this angle the moment turns the nose forward.
    pub fn turning_point(&self) -> Option<&Trim> {
        self.inner(false)
    }

    /// The first stable trim that is not nose first.
    pub fn other_trim(&self) -> Option<&Trim> {
        self.trims
            .iter()
            .find(|t| t.alpha_deg > 0.0 && t.is_stable())
    }

    /// The trim straight at an end: 0 or 180 deg.
    pub fn end(&self, alpha_deg: f64) -> Option<&Trim> {
        self.trims.iter().find(|t| t.alpha_deg == alpha_deg)
    }

    /// All trims as text, such as `0 deg (stable), 111.2 deg (unstable)`.
    pub fn words(&self) -> String {
        let words = self.trims.iter().map(|t| {
            let alpha_deg = (10.0 * t.alpha_deg).round() / 10.0;
            format!("{alpha_deg} deg ({})", t.word())
        });
        words.collect::<Vec<_>>().join(", ")
    }
}

impl Stability {
    /// Stability of a body in a gas of a ratio of heat capacities; `None` where its center of gravity is not known.
    pub fn new(body: &AeroBody, heat_capacity_ratio: f64) -> Option<Stability> {
        let [x, _] = body.cg_over_diameter()?;
        let laws = [
            Law::FreeMolecular(Gas::diffuse(f64::INFINITY)),
            Law::Newtonian(pressure_coefficient_max(
                HYPERSONIC_MACH,
                heat_capacity_ratio,
            )),
        ];
        // Both laws see the same shadows: what both need is computed for both.
        let both = |alpha: f64, effort: Effort| (alpha, loads(&body.surface, &laws, alpha, effort));
        let step = |n: u32| PI * (f64::from(n) / f64::from(SEARCH.steps));
        let beside = [END_STEP_RAD, PI - END_STEP_RAD].map(|alpha| both(alpha, Effort::FINE));
        let steps: Vec<_> = (0..=SEARCH.steps)
            .map(|n| both(step(n), COARSE))
            .chain(beside)
            .collect();
        let [free_molecular, hypersonic] = core::array::from_fn(|i| {
            let known = |list: &[(f64, [Loads; 2])], alpha: f64| {
                list.iter()
                    .find(|(at, _)| *at == alpha)
                    .map(|(_, both)| both[i])
            };
            let at = |alpha: f64, effort: Effort| {
                let [found] = loads(&body.surface, &[laws[i]], alpha, effort);
                found
            };
            let coarse = |alpha: f64| {
                let found = known(&steps, alpha).unwrap_or_else(|| at(alpha, COARSE));
                found.cm_about(x, 0.0)
            };
            let fine = |alpha: f64| {
                // Beside the axis moments are small against the tolerance of a table.
                let effort = match alpha.min(PI - alpha) <= END_STEP_RAD {
                    true => Effort::FINE,
                    false => Effort::TABLE,
                };
                let found = known(&beside, alpha).unwrap_or_else(|| at(alpha, effort));
                found.cm_about(x, 0.0)
            };
            let [(_, near), _] = beside;
            RegimeStability {
                static_margin: (near[i].cn.abs() > NO_FORCE).then(|| -near[i].cm / near[i].cn - x),
                trims: trims(&coarse, &fine, SEARCH),
            }
        });
        Some(Stability {
            free_molecular,
            hypersonic,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::aero::database::GAMMA;
    use crate::aero::polar::{Aero, Theory};
    use crate::aero::surface::Surface;
    use crate::vehicle::profile::Profile;
    use crate::vehicle::segment::{Point, Segment};

    fn body(outline: &Profile, cg_x_m: f64) -> AeroBody {
        AeroBody {
            name: String::new(),
            surface: Surface::new(outline, 1.0),
            sphere_cone: None,
            cg_m: Some([cg_x_m, 0.0, 0.0]),
        }
    }

    fn outline(points: &[[f64; 2]]) -> Profile {
        let at = |p: &[f64; 2]| Point {
            x_m: p[0],
            r_m: p[1],
        };
        let line = |pair: &[[f64; 2]]| Segment::Line {
            start: at(&pair[0]),
            end: at(&pair[1]),
        };
        Profile {
            segments: points.windows(2).map(line).collect(),
        }
        .closed()
    }

    #[test]
    fn a_sphere_has_no_margin_about_its_center_and_that_of_its_cg_elsewhere() {
        let arc = Segment::arc(Point::on_axis(0.5), 0.5, PI, -PI);
        let sphere = Profile {
            segments: vec![arc],
        }
        .closed();
        for (cg, margin) in [(0.5, 0.0), (0.4, 0.1), (0.55, -0.05)] {
            let found = Stability::new(&body(&sphere, cg), GAMMA).unwrap();
            for regime in [&found.free_molecular, &found.hypersonic] {
                let ours = regime.static_margin.unwrap();
                assert!((ours - margin).abs() < 1e-6, "{cg}: {ours}");
                let words: Vec<_> = regime.trims.iter().map(Trim::word).collect();
                // A force through the center: forward of it the CG leads nose first only, aft of it tail first only.
                match margin {
                    0.0 => assert!(words.iter().all(|w| *w == "neutral"), "{words:?}"),
                    m if m > 0.0 => assert_eq!(words, ["stable", "unstable"]),
                    _ => assert_eq!(words, ["unstable", "stable"]),
                }
            }
        }
        // Newton: C_D = C_p,max/2, so that C_m,cg = −(C_p,max/2)(0.1) sin α about 0.1 D forward of the center.
        let hypersonic = Stability::new(&body(&sphere, 0.4), GAMMA)
            .unwrap()
            .hypersonic;
        let slope = hypersonic.end(0.0).unwrap().cm_alpha_per_rad;
        assert!((slope + 0.5 * 1.8394 * 0.1).abs() < 1e-4, "{slope}");
        // Cold molecules that stick and leave slowly: C_D = 2.
        let free = Stability::new(&body(&sphere, 0.4), GAMMA)
            .unwrap()
            .free_molecular;
        let slope = free.end(0.0).unwrap().cm_alpha_per_rad;
        assert!((slope + 0.2).abs() < 1e-4, "{slope}");
    }

    #[test]
    fn a_cone_is_stable_about_points_ahead_of_two_thirds_of_a_diameter() {
        // 45 deg: Newton's center of pressure nose first is (2/3)(0.5)/cos² 45° = 2/3
        let cone = outline(&[[0.0, 0.0], [0.5, 0.5], [0.5, 0.0]]);
        for (cg, margin) in [(0.4, 2.0 / 3.0 - 0.4), (0.49, 2.0 / 3.0 - 0.49)] {
            let found = Stability::new(&body(&cone, cg), GAMMA).unwrap().hypersonic;
            assert!((found.static_margin.unwrap() - margin).abs() < 1e-5);
            assert!(found.end(0.0).unwrap().is_stable());
        }
    }

    #[test]
    fn trims_are_those_of_the_fine_search() {
        // A blunt nose with a long cone behind it is stable both ways; a plate with a ball behind it has trims between.
        for (shape, cg) in [
            (vec![[0.0, 0.0], [0.29, 0.5], [1.2, 0.0]], 0.4),
            (vec![[0.0, 0.0], [0.29, 0.5], [0.9, 0.1], [0.9, 0.0]], 0.35),
            (
                vec![
                    [0.0, 0.0],
                    [0.29, 0.5],
                    [0.34, 0.5],
                    [0.34, 0.3],
                    [0.6, 0.3],
                    [0.6, 0.0],
                ],
                0.30,
            ),
        ] {
            let body = body(&outline(&shape), cg);
            let found = Stability::new(&body, GAMMA).unwrap();
            let theories = [
                (
                    &found.free_molecular,
                    Theory::FreeMolecular(Gas::diffuse(f64::INFINITY)),
                ),
                (
                    &found.hypersonic,
                    Theory::newtonian(Some(HYPERSONIC_MACH), GAMMA),
                ),
            ];
            for (ours, theory) in theories {
                let fine = Aero::new(&body, theory, None).trim([cg, 0.0]);
                let words = |trims: &[Trim]| trims.iter().map(Trim::word).collect::<Vec<_>>();
                assert_eq!(words(&ours.trims), words(&fine), "{ours:?} {fine:?}");
                for (a, b) in ours.trims.iter().zip(&fine) {
                    assert!((a.alpha_deg - b.alpha_deg).abs() < 0.1, "{a:?} {b:?}");
                }
            }
        }
    }
}
