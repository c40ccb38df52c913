//! Grounds, and the load of a rigid vehicle that goes into them.
//!
//! ```text
//! rigid            no penetration: the foam does all
//! equation 1       G = α Dₙ V² / M
//! Young            G = F(z) / (M g), ½ M V² = ∫₀ᶻ F dz, F = M V² / (2 D) with the cross-section A(z) at the depth z
//! ```
//!
//! with G in Earth g, α the empirical constant, Dₙ twice the nose radius in m, V the speed in m/s, M the mass in kg, F in N, z
//! in m, D the depth of Young's equation in m.
//!
//! # Valid
//! Vertical fall. Equation 1 was measured with spherical penetrometers: a vehicle that goes deeper than its spherical nose
//! shows the ground more than its nose diameter. Young's equation is for slender bodies; that the resistance at a depth is
//! the mean of a body with the cross-section at that depth is an assumption of this project, which keeps his depth for a cylinder.
//!
//! # References
//! - \[samareh-2014\] equation 1; \[young-1997\].

use crate::data::Data;
use crate::vehicle::impact::soil::Soil;
use crate::vehicle::impact::striker::Striker;
use crate::vehicle::impact::young::{self, Penetrator};
use numerics::scalar::Single;
use serde::{Deserialize, Serialize};

/// A ground and the law of its resistance; with neither of the two laws it is rigid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ground {
    /// Key of the source in the list of references.
    pub source: String,
    /// Place in the source.
    pub place: String,
    /// Note for the reader.
    pub note: String,
    /// Name.
    pub name: String,
    /// Empirical constant of equation 1.
    pub penetration: Option<Penetration>,
    /// Penetrability in Young's equation.
    pub young: Option<Penetrability>,
}

/// The empirical constant α of equation 1 and the range in which it was measured.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Penetration {
    /// Value used.
    pub alpha: f64,
    /// Least value measured.
    pub alpha_min: f64,
    /// Largest value measured.
    pub alpha_max: f64,
}

/// The penetrability S of Young's equation and its range.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Penetrability {
    /// Value used.
    pub s_number: f64,
    /// Least value, of the hardest soil.
    pub s_number_min: f64,
    /// Largest value, of the softest soil.
    pub s_number_max: f64,
}

/// Load of a rigid vehicle in the ground, Earth g.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct RigidBodyLoad<S = f64> {
    /// Load with the value used, Earth g.
    pub load_earth_g: S,
    /// Least load of the range, Earth g.
    pub least_earth_g: S,
    /// Largest load of the range, Earth g.
    pub largest_earth_g: S,
}

/// Law of the resistance of a ground.
enum Law {
    Rigid,
    Equation1(Penetration),
    Young(Penetrability),
}

impl Ground {
    /// Reads a file of `data/grounds`.
    pub fn parse(data: Data) -> Result<Self, String> {
        let ground: Self = data.read()?;
        let [least, middle, largest] = match (ground.penetration, ground.young) {
            (Some(_), Some(_)) => {
                return Err("penetration and young: one of them, or neither".to_string());
            }
            (Some(p), None) => [p.alpha_min, p.alpha, p.alpha_max],
            (None, Some(y)) => [y.s_number_min, y.s_number, y.s_number_max],
            (None, None) => return Ok(ground),
        };
        if 0.0 < least && least <= middle && middle <= largest && largest.is_finite() {
            Ok(ground)
        } else {
            Err(format!(
                "{least}, {middle}, {largest}: must be above 0 and rise"
            ))
        }
    }

    /// Source of the law, for a reader.
    pub fn law_source(&self) -> &'static str {
        match self.law() {
            Law::Rigid => "NASA/TM-2014-218507, section 3.1.5",
            Law::Equation1(_) => "NASA/TM-2014-218507, equation 1",
            Law::Young(_) => "Young, SAND97-2426",
        }
    }

    /// Resistance of the ground to a vehicle.
    pub fn soil<S: Single>(&self, striker: &Striker<S>) -> Soil<S> {
        match self.law() {
            Law::Rigid => Soil::Rigid,
            Law::Equation1(p) => Soil::equation_1(p.alpha, striker),
            Law::Young(y) => young_soil(y.s_number, striker),
        }
    }

    /// Load of a rigid vehicle; `None` on rigid ground.
    pub fn rigid_body_load<S: Single>(&self, striker: &Striker<S>) -> Option<RigidBodyLoad<S>> {
        let [load_earth_g, least_earth_g, largest_earth_g] = match self.law() {
            Law::Rigid => return None,
            Law::Equation1(p) => {
                let load = |alpha| {
                    super::penetration_load_earth_g(
                        alpha,
                        striker.nose_diameter_m,
                        striker.speed_m_s,
                        striker.mass_kg,
                    )
                };
                [load(p.alpha), load(p.alpha_min), load(p.alpha_max)]
            }
            Law::Young(y) => {
                let load = |s| young_soil(s, striker).rigid_body_load_earth_g(striker);
                // the softest ground gives the least load
                [load(y.s_number), load(y.s_number_max), load(y.s_number_min)]
            }
        };
        Some(RigidBodyLoad {
            load_earth_g,
            least_earth_g,
            largest_earth_g,
        })
    }

    fn law(&self) -> Law {
        match (self.penetration, self.young) {
            (Some(penetration), _) => Law::Equation1(penetration),
            (None, Some(young)) => Law::Young(young),
            (None, None) => Law::Rigid,
        }
    }
}

fn young_soil<S: Single>(penetrability: f64, striker: &Striker<S>) -> Soil<S> {
    let footprint = striker.footprint;
    let area_m2 = footprint.largest_area_m2();
    let full_n = young::mean_resistance_n(
        penetrability,
        &Penetrator {
            mass_kg: striker.mass_kg,
            area_m2,
            nose_coefficient: footprint.nose_coefficient(),
            speed_m_s: striker.speed_m_s,
        },
    );
    Soil::growing(full_n, footprint)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::forebody::Forebody;
    use numerics::math::RADIANS_PER_DEGREE;

    const CLAY: &str = include_str!("../../../data/grounds/uttr-clay.toml");

    /// The MSR vehicle of Table 15: 0.9 m, nose ratio 0.25, 60 deg, 45.7 kg.
    fn striker(speed_m_s: f64) -> Striker {
        let forebody = Forebody {
            diameter_m: 0.9,
            nose_radius_m: 0.1125,
            shoulder_radius_m: 0.0315,
            cone_half_angle_rad: 60.0 * RADIANS_PER_DEGREE,
        };
        Striker::new(&forebody, 45.7, speed_m_s)
    }

    fn ground(name: &str) -> Ground {
        let path = format!("grounds/{name}.toml");
        Ground::parse(crate::library::data_file(&path).unwrap().into()).unwrap()
    }

    #[test]
    fn the_clay_of_utah_is_28_within_27_and_29() {
        let ground = Ground::parse(CLAY.into()).unwrap();
        let penetration = ground.penetration.unwrap();
        assert_eq!(
            [
                penetration.alpha,
                penetration.alpha_min,
                penetration.alpha_max
            ],
            [28.0, 27.0, 29.0]
        );
        // 28 · 0.225 · 900 / 45.7
        let load = ground.rigid_body_load(&striker(30.0)).unwrap();
        assert!((load.load_earth_g - 124.070).abs() < 1e-3);
        assert!(load.least_earth_g < load.load_earth_g && load.load_earth_g < load.largest_earth_g);
    }

    #[test]
    fn bad_grounds_are_refused() {
        assert!(Ground::parse("name = 'x'\nalpha = 1".into()).is_err());
        assert!(
            Ground::parse(
                CLAY.replace("alpha_min = 27.0", "alpha_min = 30.0")
                    .as_str()
                    .into()
            )
            .is_err()
        );
        let both =
            format!("{CLAY}\n[young]\ns_number = 1.0\ns_number_min = 1.0\ns_number_max = 1.0\n");
        assert!(
            Ground::parse(both.as_str().into())
                .unwrap_err()
                .contains("one of them")
        );
    }

    #[test]
    fn harder_grounds_give_more_and_a_rigid_one_nothing() {
        let load = |name: &str| ground(name).rigid_body_load(&striker(30.0)).unwrap();
        let names = ["wendover-mud", "wet-clay", "stiff-clay", "cemented-sand"];
        for pair in names.windows(2) {
            let (soft, hard) = (load(pair[0]), load(pair[1]));
            assert!(soft.load_earth_g < hard.load_earth_g, "{pair:?}");
            assert!(soft.least_earth_g < soft.load_earth_g);
            assert!(soft.load_earth_g < soft.largest_earth_g);
        }
        assert_eq!(ground("rigid").rigid_body_load(&striker(30.0)), None);
    }

    /// Two flight-like vehicles fell on the sandy clay of Utah at about 30 m/s: less than 600 g at the center of gravity
    /// (abstract of \[kellas-2017\]; sizes and masses are not in it, those of Table 15 stand in for them).
    #[test]
    fn drops_of_2017_stay_below_600_g() {
        let mud = ground("wendover-mud")
            .rigid_body_load(&striker(30.0))
            .unwrap();
        // 427 to 571 g over the range of S
        assert!(mud.least_earth_g > 400.0 && mud.largest_earth_g < 600.0);
        let clay = Ground::parse(CLAY.into()).unwrap();
        let load = |nose_diameter_m| {
            let striker = Striker {
                nose_diameter_m,
                ..striker(30.0)
            };
            clay.rigid_body_load(&striker).unwrap().load_earth_g
        };
        // equation 1: 28 · 900 / 45.7 = 551.42 g for each meter; with the nose a quarter of that of the whole vehicle
        assert!((load(0.225) - 124.07).abs() < 0.01 && (load(0.9) - 496.28).abs() < 0.01);
    }

    #[test]
    fn every_ground_of_the_library_reads() {
        for (path, text) in crate::library::data_folder("grounds") {
            let ground =
                Ground::parse(text.into()).unwrap_or_else(|fault| panic!("{path}: {fault}"));
            assert!(
                !ground.note.is_empty() && !ground.place.is_empty(),
                "{path}"
            );
        }
    }
}
