//! Loads on the walls of a vehicle, and the walls that carry them.
//!
//! ```text
//! entry     p = f max(p₀, M a / A)          forebody; a fraction of it on the lid
//!           N = p ρ_max or p R / 2          P = f m a on the primary structure, m what hangs on it
//! launch    N = f M g (|n_a| / 2πR + n_l h / πR²)    primary structure, at each corner (n_l, n_a)
//!           p = f |n_a| g m / A             carriers: their own inertia; P = f |n_a| g m at the inner end of the cone
//! ```
//!
//! with pressures in Pa, forces in N, N in N/m; f the safety factor, p₀ the peak stagnation pressure, M a the entry mass
//! times its deceleration, A the frontal area, h the distance of the center of gravity from the attached structure, R the
//! radius of the primary structure, m. On the primary structure lateral bending is treated as if its largest force acted
//! round the whole circle: it buckles at a smaller stress under axial load than in bending, so that this is conservative.
//!
//! # Valid
//! The aft side of the wing is a dish that the wing's filling backs: it follows the lid.
//!
//! # References
//! - \[samareh-2014\] section 3.1.6; \[spacex-falcon-guide\] Figure 4-1; \[nasa-std-5001\]. Which load goes where is a choice.

use super::capacity::{Cap, Cone};
use super::{Carrier, LaunchLoad, Needs, Structure, Wall};
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::ComponentKind;
use crate::vehicle::kinds::EARTH_G_M_S2;
use crate::vehicle::layout::Layout;
use crate::vehicle::mass::Component;
use crate::vehicle::mass::{MassProperties, Masses};
use numerics::math::{FRAC_PI_2, PI};
use numerics::scalar::Single;

/// A cone between two rings under external pressure with its spherical cap, or a cap alone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PressureShell<S = f64> {
    /// Design pressure, factor included, Pa.
    pub pressure_pa: S,
    /// Whether the deceleration of the whole mass is more than the stagnation pressure.
    pub from_deceleration: bool,
    /// Cone; `None` when there is none.
    pub cone: Option<Cone<S>>,
    /// Largest normal radius of curvature of the cone, m.
    pub largest_curvature_radius_m: S,
    /// Normal radius of curvature at the ring, m.
    pub ring_curvature_radius_m: S,
    /// Cap.
    pub cap: Cap<S>,
    /// Pressure by which its own inertia loads it at launch, factor included, Pa.
    pub launch_pressure_pa: S,
    /// Axial load at the inner end of the cone at launch, factor included, N.
    pub launch_axial_n: S,
}

/// Axial loads of a cylinder, factor included.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AxialLoads<S = f64> {
    /// Radius, m.
    pub radius_m: S,
    /// Axial load at entry, N.
    pub entry_n: S,
    /// Corners at launch, and the axial load that makes the same largest force, N.
    pub launch: [(LaunchLoad<S>, S); 4],
}

/// Loads of the three walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallLoads<S = f64> {
    /// Forebody carrier structure.
    pub forebody: PressureShell<S>,
    /// Aftbody carrier structure.
    pub aftbody: PressureShell<S>,
    /// Primary structure.
    pub primary: AxialLoads<S>,
}

impl<S: Single> PressureShell<S> {
    /// Radius of curvature with which pressure makes the largest force in the wall, m.
    pub fn membrane_radius_m(&self) -> S {
        self.largest_curvature_radius_m.max(self.cap.radius_m / 2.0)
    }
}

impl<S: Single> AxialLoads<S> {
    /// Largest load, N.
    pub fn largest_n(&self) -> S {
        self.launch
            .iter()
            .map(|(_, n)| *n)
            .fold(self.entry_n, S::max)
    }
}

impl<S: Single> Carrier<S> {
    /// The wall of a shell under external pressure.
    pub fn pressure_wall(&self, shell: &PressureShell<S>) -> Wall<S> {
        let p = shell.pressure_pa;
        let membrane_n_m = p.max(shell.launch_pressure_pa) * shell.membrane_radius_m();
        let face_m = self.face_thickness_m(membrane_n_m);
        let cone = shell.cone.map_or(S::constant(0.0), |cone| {
            let axial_n = shell.launch_axial_n;
            let axial = self.cone_axial_thickness_m(cone.half_angle_rad, axial_n, face_m);
            self.cone_thickness_m(&cone, p, face_m).max(axial)
        });
        self.wall(&Needs {
            membrane_n_m,
            face_m,
            buckling_m: cone,
            cap_buckling_m: self.cap_thickness_m(&shell.cap, p, face_m),
            core_shear_m: self.ring_shear_thickness_m(p, shell.ring_curvature_radius_m, face_m),
        })
    }

    /// The wall of a cylinder under axial loads.
    pub fn axial_wall(&self, loads: &AxialLoads<S>) -> Wall<S> {
        let load_n = loads.largest_n();
        let needs = Needs::of_force(self, load_n / (loads.radius_m * (2.0 * PI)));
        self.wall(&Needs {
            buckling_m: self.cylinder_thickness_m(loads.radius_m, load_n, needs.face_m),
            ..needs
        })
    }
}

/// Loads from these masses.
pub fn loads(
    input: &VehicleInput,
    layout: &Layout,
    components: &[Component],
    mass: &MassProperties,
) -> WallLoads {
    let parts = components.iter().map(Component::part);
    loads_of(input, layout, &Masses::of(parts, mass))
}

/// Loads of the three walls from the masses alone.
pub fn loads_of<S: Single>(
    input: &VehicleInput<S>,
    layout: &Layout<S>,
    mass: &Masses<S>,
) -> WallLoads<S> {
    let (none, surface) = (S::constant(0.0), S::constant(0.0));
    let outline = &layout.outline;
    let forebody = &outline.forebody;
    let load = &input.structure_loads;
    let factor = load.safety_factor;
    let entry_m_s2 = input.loads.entry_load_earth_g * EARTH_G_M_S2;
    let area_m2 = forebody.diameter_m * PI * forebody.diameter_m / 4.0;
    let inertial_pa = mass.mass_kg * entry_m_s2 / area_m2;
    let stagnation_pa = input.loads.peak_stagnation_pressure_pa;
    let pressure_pa = factor * inertial_pa.max(stagnation_pa);
    let (theta_sin, theta_cos) = forebody.sin_cos();
    let (inner_r, outer_r) = (
        layout.primary_outer_r_m(),
        forebody.shoulder_tangent(surface).r_m,
    );
    use ComponentKind::{AftbodyCarrier, AftbodyTps, Bond, ForebodyCarrier, ForebodyTps};
    let of_forebody = |kind| matches!(kind, ForebodyTps | Bond | ForebodyCarrier);
    let forebody_kg = mass.sum_kg(of_forebody);
    let aftbody_kg = mass.sum_kg(|kind| matches!(kind, AftbodyTps | AftbodyCarrier));
    let axial_g = load
        .launch
        .iter()
        .map(|c| c.axial_earth_g.abs())
        .fold(none, S::max);
    let launch_m_s2 = factor * axial_g * EARTH_G_M_S2;
    let slant_length_m = (outer_r - inner_r) / theta_sin;
    let fore_shell = PressureShell {
        pressure_pa,
        from_deceleration: stagnation_pa.less(inertial_pa),
        cone: (slant_length_m.value() > 0.0).then(|| Cone {
            slant_length_m,
            curvature_radius_m: (inner_r + outer_r) / 2.0 / theta_cos,
            half_angle_rad: forebody.cone_half_angle_rad,
        }),
        largest_curvature_radius_m: outer_r / theta_cos,
        ring_curvature_radius_m: inner_r / theta_cos,
        cap: Cap {
            radius_m: forebody.nose_radius_m,
            half_angle_rad: -forebody.cone_half_angle_rad + FRAC_PI_2,
        },
        launch_pressure_pa: launch_m_s2 * forebody_kg / area_m2,
        launch_axial_n: launch_m_s2 * forebody_kg,
    };
    let lid_foot_r = outline.lid_foot_r_m(surface);
    let aft_shell = PressureShell {
        pressure_pa: load.aftbody_pressure_fraction * pressure_pa,
        from_deceleration: fore_shell.from_deceleration,
        cone: None,
        largest_curvature_radius_m: none,
        ring_curvature_radius_m: outline.lid_radius_m,
        cap: Cap {
            radius_m: outline.lid_radius_m,
            half_angle_rad: lid_foot_r
                .atan2(outline.attached_structure_x_m - outline.lid_center_x_m),
        },
        launch_pressure_pa: launch_m_s2 * aftbody_kg / area_m2,
        launch_axial_n: none,
    };
    // in entry the forebody carries itself; the rest hangs on the primary structure
    let carried_kg = mass.sum_kg(|kind| !of_forebody(kind));
    let radius_m = layout.primary_inner_r_m();
    let arm_m = (mass.cg_x_m - outline.attached_structure_x_m).abs();
    // N = P / 2πR + M / πR²: as of the axial load P + 2 M / R
    let equivalent = |corner: LaunchLoad<S>| {
        let (axial, lateral) = (corner.axial_earth_g.abs(), corner.lateral_earth_g.abs());
        factor * EARTH_G_M_S2 * mass.mass_kg * (axial + lateral * 2.0 * arm_m / radius_m)
    };
    WallLoads {
        forebody: fore_shell,
        aftbody: aft_shell,
        primary: AxialLoads {
            radius_m,
            entry_n: factor * carried_kg * entry_m_s2,
            launch: load.launch.map(|corner| (corner, equivalent(corner))),
        },
    }
}

/// Walls for these loads.
pub fn walls<S: Single>(input: &VehicleInput<S>, loads: &WallLoads<S>) -> Structure<S> {
    Structure {
        forebody: match input.forebody.carrier_thickness_m {
            Some(thickness_m) => input.forebody.carrier.at_thickness(thickness_m),
            None => input.forebody.carrier.pressure_wall(&loads.forebody),
        },
        aftbody: input.aftbody_carrier.pressure_wall(&loads.aftbody),
        primary: input.primary_carrier.axial_wall(&loads.primary),
    }
}

#[cfg(test)]
mod tests {
    use super::super::Governs;
    use super::super::tests::solid;
    use super::*;

    fn cap_of_half_a_meter(pressure_pa: f64) -> PressureShell {
        PressureShell {
            pressure_pa,
            from_deceleration: false,
            cone: None,
            largest_curvature_radius_m: 0.8,
            ring_curvature_radius_m: 0.4,
            cap: Cap {
                radius_m: 0.5,
                half_angle_rad: 1.0,
            },
            launch_pressure_pa: 0.0,
            launch_axial_n: 0.0,
        }
    }

    #[test]
    fn strength_asks_for_p_rho_over_sigma() {
        // 2e5 · 0.8 / 1e8 = 1.6 mm
        let wall = solid().pressure_wall(&cap_of_half_a_meter(2e5));
        assert!((wall.strength_thickness_m - 0.0016).abs() < 1e-15);
        assert_eq!(wall.governs, Governs::CapBuckling);
    }

    #[test]
    fn light_load_leaves_the_minimum_gauge() {
        let corner = LaunchLoad::default();
        let loads = AxialLoads {
            radius_m: 0.2,
            entry_n: 1000.0,
            launch: [(corner, 500.0); 4],
        };
        let wall = solid().axial_wall(&loads);
        assert_eq!(
            (wall.thickness_m, wall.governs),
            (0.001, Governs::MinimumGauge)
        );
        assert_eq!(loads.largest_n(), 1000.0);
    }
}
