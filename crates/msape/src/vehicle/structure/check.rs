//! Results of every rule for the walls as built: demand, capacity, margin, and the thickness that this rule alone requires.
//!
//! ```text
//! margin = capacity / demand − 1
//! ```
//!
//! with demand and capacity in the unit that the check names; the safety factor is in the demand.
//!
//! # Valid
//! Same as [`super::capacity`].
//!
//! # References
//! - Those of [`super::capacity`] and [`super::size`].

use super::size::{AxialLoads, PressureShell, WallLoads};
use super::{Carrier, Construction, LaunchLoad, Structure, Wall};
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::WallPlace;
use numerics::math::PI;
use serde::{Deserialize, Serialize};

/// A structural rule.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Rule {
    /// Least thickness.
    MinimumGauge,
    /// Stress in laminate or faces.
    Strength,
    /// A cone under external pressure.
    ConePressureBuckling,
    /// A cone under axial load.
    ConeAxialBuckling,
    /// A spherical cap under external pressure.
    CapBuckling,
    /// A cylinder under axial load.
    CylinderBuckling,
    /// Faces on a thick core.
    FaceWrinkling,
    /// Faces on honeycomb.
    HoneycombWrinkling,
    /// Faces into the cells of honeycomb.
    Dimpling,
    /// A sandwich whose core gives way in shear.
    ShearCrimping,
    /// Shear in the core at a ring.
    CoreShear,
}

impl Rule {
    /// Name in plain words.
    pub fn label(self) -> &'static str {
        match self {
            Self::MinimumGauge => "minimum gauge",
            Self::Strength => "strength",
            Self::ConePressureBuckling => "buckling of the cone under pressure",
            Self::ConeAxialBuckling => "buckling of the cone under axial load",
            Self::CapBuckling => "buckling of the spherical part",
            Self::CylinderBuckling => "buckling of the cylinder",
            Self::FaceWrinkling => "wrinkling of the faces",
            Self::HoneycombWrinkling => "wrinkling of the faces on honeycomb",
            Self::Dimpling => "dimpling of the faces",
            Self::ShearCrimping => "shear crimping",
            Self::CoreShear => "shear of the core",
        }
    }

    /// Source of the rule.
    pub fn source(self) -> &'static str {
        match self {
            Self::MinimumGauge => "data of the wall's material",
            Self::Strength => "membrane stress",
            Self::ConePressureBuckling => "NASA SP-8019, hydrostatic pressure, knock-down 0.75",
            Self::ConeAxialBuckling => "NASA SP-8019, axial compression, knock-down 0.33",
            Self::CapBuckling => "NASA SP-8032, section 4.2.1.1, knock-down 0.14 + 3.2/lambda^2",
            Self::CylinderBuckling => "NASA SP-8007, axial compression",
            Self::FaceWrinkling => "NASA/CR-1999-208994, factor 0.5",
            Self::HoneycombWrinkling => "NASA/CR-1999-208994, factor 0.33",
            Self::Dimpling | Self::ShearCrimping => "Hexcel AGU 075b",
            Self::CoreShear => "edge of a shell under pressure, Timoshenko and Woinowsky-Krieger",
        }
    }
}

/// Load case.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum LoadCase {
    /// Making of the wall.
    Making,
    /// Stagnation pressure at entry.
    EntryPressure,
    /// Deceleration at entry.
    EntryDeceleration,
    /// A corner of the launch loads.
    Launch(LaunchLoad),
}

impl LoadCase {
    /// Name in plain words, with the load factors of a corner.
    pub fn label(self) -> String {
        match self {
            Self::Making => "making".to_owned(),
            Self::EntryPressure => "entry, pressure".to_owned(),
            Self::EntryDeceleration => "entry, deceleration".to_owned(),
            Self::Launch(LaunchLoad {
                axial_earth_g,
                lateral_earth_g,
            }) => format!("launch, {axial_earth_g} g along, {lateral_earth_g} g across"),
        }
    }
}

/// Result of a rule in a load case.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Check {
    /// Wall.
    pub wall: WallPlace,
    /// Rule.
    pub rule: Rule,
    /// Load case.
    pub load_case: LoadCase,
    /// Unit of demand and capacity.
    pub unit: String,
    /// Demand, safety factor included.
    pub demand: f64,
    /// Capacity of the wall as built.
    pub capacity: f64,
    /// Capacity over demand less one.
    pub margin: f64,
    /// Thickness that this rule alone requires, m, of a rule for faces that of both together; absent where a thicker wall
    /// does not help.
    pub required_thickness_m: Option<f64>,
    /// Source of the rule.
    pub source: String,
}

/// A wall and its material.
struct Built<'a> {
    place: WallPlace,
    carrier: &'a Carrier,
    wall: &'a Wall,
    list: Vec<Check>,
}

/// Numbers of a rule: unit, demand, capacity, required thickness.
type Figures = (&'static str, f64, f64, Option<f64>);

impl Built<'_> {
    fn add(
        &mut self,
        rule: Rule,
        load_case: LoadCase,
        (unit, demand, capacity, thickness): Figures,
    ) {
        // a rule without a requirement gives no check
        if demand > 0.0 && capacity.is_finite() {
            self.list.push(Check {
                wall: self.place,
                rule,
                load_case,
                unit: unit.to_owned(),
                demand,
                capacity,
                margin: capacity / demand - 1.0,
                required_thickness_m: thickness,
                source: rule.source().to_owned(),
            });
        }
    }

    /// Checks of the force N in the wall: strength, and the faces of a sandwich.
    fn membrane(&mut self, load_case: LoadCase, n_m: f64) {
        let (carrier, h, t_f) = (
            self.carrier,
            self.wall.thickness_m,
            self.wall.face_thickness_m,
        );
        let sandwich = matches!(carrier.construction, Construction::Sandwich { .. });
        let area = if sandwich { 2.0 * t_f } else { h };
        let (stress, strength) = (n_m / area, carrier.strength_pa);
        let faces = |allowed: f64| Some(n_m / allowed);
        self.add(
            Rule::Strength,
            load_case,
            ("Pa", stress, strength, faces(strength)),
        );
        let wrinkling = carrier.wrinkling_stress_pa();
        self.add(
            Rule::FaceWrinkling,
            load_case,
            ("Pa", stress, wrinkling, faces(wrinkling)),
        );
        let honeycomb = carrier.honeycomb_wrinkling_stress_pa(h, t_f);
        self.add(
            Rule::HoneycombWrinkling,
            load_case,
            ("Pa", stress, honeycomb, None),
        );
        self.add(
            Rule::Dimpling,
            load_case,
            ("Pa", stress, carrier.dimpling_stress_pa(t_f), None),
        );
        self.add(
            Rule::ShearCrimping,
            load_case,
            ("N/m", n_m, carrier.crimping_n_m(h, t_f), None),
        );
    }

    fn gauge(&mut self) {
        let least = self.carrier.minimum_gauge_m;
        let figures = ("m", least, self.wall.thickness_m, Some(least));
        self.add(Rule::MinimumGauge, LoadCase::Making, figures);
    }

    fn equivalent(&self) -> (f64, f64) {
        let Wall {
            thickness_m,
            face_thickness_m,
            ..
        } = *self.wall;
        self.carrier.equivalent(thickness_m, face_thickness_m)
    }

    /// A shell under external pressure.
    fn pressure(mut self, shell: &PressureShell, launch: LaunchLoad) -> Vec<Check> {
        let (carrier, wall) = (self.carrier, self.equivalent());
        let p = shell.pressure_pa;
        let entry = if shell.from_deceleration {
            LoadCase::EntryDeceleration
        } else {
            LoadCase::EntryPressure
        };
        let n_m = p * shell.membrane_radius_m();
        let face_m = carrier.face_thickness_m(n_m);
        self.gauge();
        self.membrane(entry, n_m);
        if let Some(cone) = shell.cone {
            let needed = Some(carrier.cone_thickness_m(&cone, p, face_m));
            let figures = ("Pa", p, Carrier::cone_pressure_pa(&cone, wall), needed);
            self.add(Rule::ConePressureBuckling, entry, figures);
            let load = shell.launch_axial_n;
            let needed = Some(carrier.cone_axial_thickness_m(cone.half_angle_rad, load, face_m));
            let capacity = carrier.cone_axial_load_n(cone.half_angle_rad, wall);
            let figures = ("N", load, capacity, needed);
            self.add(Rule::ConeAxialBuckling, LoadCase::Launch(launch), figures);
        }
        let needed = Some(carrier.cap_thickness_m(&shell.cap, p, face_m));
        let figures = ("Pa", p, carrier.cap_pressure_pa(&shell.cap, wall), needed);
        self.add(Rule::CapBuckling, entry, figures);
        if let Construction::Sandwich {
            core_shear_strength_pa,
            ..
        } = carrier.construction
        {
            let rho = shell.ring_curvature_radius_m;
            let d = self.wall.thickness_m - self.wall.face_thickness_m;
            let needed = Some(carrier.ring_shear_thickness_m(p, rho, face_m));
            let figures = (
                "Pa",
                carrier.ring_shear_pa(p, rho, d),
                core_shear_strength_pa,
                needed,
            );
            self.add(Rule::CoreShear, entry, figures);
        }
        self.membrane(
            LoadCase::Launch(launch),
            shell.launch_pressure_pa * shell.membrane_radius_m(),
        );
        self.list
    }

    /// A cylinder under axial loads.
    fn axial(mut self, loads: &AxialLoads) -> Vec<Check> {
        self.gauge();
        let (carrier, wall, radius_m) = (self.carrier, self.equivalent(), loads.radius_m);
        let launch = loads
            .launch
            .map(|(corner, n)| (LoadCase::Launch(corner), n));
        for (load_case, load_n) in [(LoadCase::EntryDeceleration, loads.entry_n)]
            .into_iter()
            .chain(launch)
        {
            let n_m = load_n / (2.0 * PI * radius_m);
            self.membrane(load_case, n_m);
            let face_m = carrier.face_thickness_m(n_m);
            let needed = Some(carrier.cylinder_thickness_m(radius_m, load_n, face_m));
            let figures = ("N", load_n, carrier.cylinder_load_n(radius_m, wall), needed);
            self.add(Rule::CylinderBuckling, load_case, figures);
        }
        self.list
    }
}

/// Every rule for every wall.
pub fn checks(input: &VehicleInput, loads: &WallLoads, structure: &Structure) -> Vec<Check> {
    let built = |place, carrier, wall| Built {
        place,
        carrier,
        wall,
        list: Vec::new(),
    };
    let strongest = |a: LaunchLoad, b: &LaunchLoad| {
        if b.axial_earth_g.abs() > a.axial_earth_g.abs() {
            *b
        } else {
            a
        }
    };
    let launch = input
        .structure_loads
        .launch
        .iter()
        .fold(LaunchLoad::default(), strongest);
    let mut all = built(
        WallPlace::Forebody,
        &input.forebody.carrier,
        &structure.forebody,
    )
    .pressure(&loads.forebody, launch);
    all.extend(
        built(
            WallPlace::Aftbody,
            &input.aftbody_carrier,
            &structure.aftbody,
        )
        .pressure(&loads.aftbody, launch),
    );
    all.extend(
        built(
            WallPlace::Primary,
            &input.primary_carrier,
            &structure.primary,
        )
        .axial(&loads.primary),
    );
    all
}
