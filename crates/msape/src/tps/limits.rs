//! Findings on a sized heat shield: limits of the material, range of its relation.
//!
//! ```text
//! q̇ ≤ q̇max, or q̇ ≤ q̇short for no longer than the short duration;  p ≤ pmax;  tmin ≤ t ≤ tmax
//! ```
//!
//! with cold-wall heat flux q̇ in W/cm², pressure p in atm, thickness t in cm.
//!
//! # Valid
//! The limits are those of tests and flights: a material may withstand more.
//!
//! # References
//! - \[samareh-2014\] Tables 7 and 8.

use super::material::{Limits, TpsMaterial};
use super::mer::{Governed, Mer, Sizing};
use super::{Environment, PA_PER_ATM, Side};
use crate::finding::range::{Check, Range, short};
use crate::finding::{Finding, Severity};
use crate::heating::PER_CM2;
use crate::quantity::input;

/// Findings of one sized heat shield.
pub fn findings(
    material: &TpsMaterial,
    environment: &Environment,
    sizing: &Sizing,
) -> Vec<Finding> {
    let side = environment.side().name();
    let model = format!("mer {}", material.name);
    let thickness_key = format!("{side}_tps_thickness_m");
    let flux_of = format!("Peak heat flux {}", environment.point.place());
    let field = format!("design.{side}_tps");
    let limits = material.limits;
    let pressure = Check {
        severity: Severity::Exceeded,
        model: &model,
        key: environment.point.pressure_key(),
        quantity: "Peak pressure",
        value: environment.peak_pressure_pa / PA_PER_ATM,
        range: Range::up_to(limits.pressure_atm),
        unit: "atm",
        si_per_unit: PA_PER_ATM,
        meaning: "the material was not tested at it",
        source: "NASA/TM-2014-218507, Table 8",
        field: Some(&field),
    };
    let flux = Check {
        key: environment.point.heat_flux_key(),
        quantity: &flux_of,
        value: environment.peak_heat_flux_w_m2 / PER_CM2,
        unit: "W/cm²",
        si_per_unit: PER_CM2,
        ..pressure
    };
    let thickness = Check {
        key: &thickness_key,
        unit: "cm",
        si_per_unit: 0.01,
        ..pressure
    };
    let made = Check {
        severity: Severity::Note,
        quantity: "Thickness of the relation",
        value: sizing.relation_thickness_m * 100.0,
        range: Range::from(limits.minimum_thickness_cm),
        meaning: "the least thickness made is used",
        ..thickness
    };
    let thick = Check {
        quantity: "Thickness",
        value: sizing.thickness_m * 100.0,
        range: Range {
            min: None,
            max: limits.maximum_thickness_cm,
        },
        meaning: "it was not made that thick",
        ..thickness
    };
    let fitted = Check {
        severity: Severity::Extrapolated,
        quantity: "Thickness of the relation",
        value: sizing.relation_thickness_m * 100.0,
        range: Range::from(material.fit.minimum_thickness_cm),
        meaning: "the relation was fitted to thicker heat shields only",
        source: "NASA/TM-2014-218507, Table 7",
        ..thickness
    };
    let given = sizing.governed_by == Governed::Given;
    let mut findings: Vec<Finding> = heat_flux(&flux, &limits, environment.time_above_limit_s)
        .into_iter()
        .collect();
    findings.extend(pressure.finding());
    findings.extend(made.finding().filter(|_| !given));
    findings.extend([thick, fitted].iter().filter_map(Check::finding));
    findings.extend(branch(material, environment, sizing, &fitted));
    findings.extend(in_depth(material, environment, &fitted));
    findings.extend(other_side(material, environment.side(), &fitted));
    findings
}

/// The heat-flux limit, and the short pulse that may exceed it.
fn heat_flux(check: &Check, limits: &Limits, time_above_limit_s: Option<f64>) -> Option<Finding> {
    let Limits {
        heat_flux_w_cm2,
        short_heat_flux_w_cm2,
        short_duration_s,
        ..
    } = *limits;
    let sustained = Check {
        range: Range::up_to(heat_flux_w_cm2),
        ..*check
    };
    let (Some(allowed_s), true) = (short_duration_s, check.value <= short_heat_flux_w_cm2) else {
        return Check {
            meaning: "beyond the material, the design should not be used",
            ..sustained
        }
        .finding();
    };
    let (severity, duration) = match time_above_limit_s {
        Some(time) if time <= allowed_s => (Severity::Note, format!("it lasts {} s", short(time))),
        Some(time) => (Severity::Exceeded, format!("it lasts {} s", short(time))),
        None => (
            Severity::Exceeded,
            "how long it lasts was not counted".into(),
        ),
    };
    let (most, allowed) = (short(short_heat_flux_w_cm2), short(allowed_s));
    let meaning = format!("up to {most} W/cm² is allowed for {allowed} s, {duration}");
    Check {
        severity,
        meaning: &meaning,
        ..sustained
    }
    .finding()
}

/// The branch that a relation of two takes, and the range of x of the second.
fn branch(
    material: &TpsMaterial,
    environment: &Environment,
    sizing: &Sizing,
    template: &Check,
) -> Vec<Finding> {
    let Mer::TwoBranch {
        switch_heat_flux_w_cm2,
        largest_x,
        ..
    } = material.mer
    else {
        return Vec::new();
    };
    let flux_w_cm2 = environment.peak_heat_flux_w_m2 / PER_CM2;
    let second = flux_w_cm2 > switch_heat_flux_w_cm2;
    // one beyond the switch is on the second branch, the switch itself on the first
    let [lower, upper] = [switch_heat_flux_w_cm2, switch_heat_flux_w_cm2 + 1.0]
        .map(|flux| material.mer.thickness_cm(sizing.x, flux));
    let taken = if second { "second" } else { "first" };
    let named = Finding {
        severity: Severity::Note,
        model: template.model.into(),
        key: template.key.into(),
        value: Some(sizing.relation_thickness_m),
        valid: (None, None),
        message: format!(
            "The relation jumps at {} W/cm²: with this heat load from {} cm on its first branch to {} cm on its second. \
             At {} W/cm² the {taken} counts.",
            short(switch_heat_flux_w_cm2),
            short(lower),
            short(upper),
            short(flux_w_cm2),
        ),
        source: "NASA/TM-2014-218507, Table 7".into(),
        field: template.field.map(str::to_owned),
    };
    let held = Check {
        severity: Severity::Exceeded,
        quantity: "Heat load over squared entry speed",
        value: sizing.x,
        range: Range::up_to(largest_x),
        unit: "J/cm² per (km/s)²",
        si_per_unit: PER_CM2 / 1e6,
        meaning: "the relation turns down there and is held, the thickness is too small",
        ..*template
    };
    let held = second.then(|| held.finding()).flatten();
    core::iter::once(named).chain(held).collect()
}

/// The relation against an in-depth model at the angle of this entry.
fn in_depth(material: &TpsMaterial, environment: &Environment, template: &Check) -> Vec<Finding> {
    let depth = environment.entry_depth_deg();
    let at_angle = |row: &&super::material::InDepth| {
        environment.side() == Side::Forebody && row.flight_path_angle_deg.contains(depth)
    };
    let finding = |row: &super::material::InDepth| {
        let Range { min, max } = row.difference_percent;
        let (low, high) = (min.unwrap_or(0.0), max.unwrap_or(0.0));
        let (severity, message) = if low < 0.0 {
            let message = format!(
                "At {} deg below the horizon the relation gives up to {} % less thickness than an in-depth ablation \
                 model: add margin.",
                short(depth),
                short(-low)
            );
            (Severity::Extrapolated, message)
        } else {
            let message = format!(
                "At {} deg below the horizon the relation gives {} to {} % more thickness than an in-depth ablation \
                 model.",
                short(depth),
                short(low),
                short(high)
            );
            (Severity::Note, message)
        };
        let (lower, upper) = (row.flight_path_angle_deg.min, row.flight_path_angle_deg.max);
        Finding {
            severity,
            model: template.model.into(),
            key: "entry_relative_flight_path_angle_deg".into(),
            value: Some(-depth),
            // the difference applies inside the row's angles; the relation is good outside them
            valid: if low < 0.0 {
                (None, upper.map(|deg| -deg))
            } else {
                (lower.map(|deg| -deg), None)
            },
            message,
            source: format!(
                "comparison with an in-depth ablation model, {}",
                row.provenance
            ),
            field: Some(input::entry::FLIGHT_PATH_ANGLE_DEG.key.into()),
        }
    };
    material
        .in_depth
        .iter()
        .filter(at_angle)
        .map(finding)
        .collect()
}

/// A relation used on the side for which it was not made.
fn other_side(material: &TpsMaterial, side: Side, template: &Check) -> Option<Finding> {
    (!material.sides.contains(&side)).then(|| Finding {
        severity: Severity::Extrapolated,
        model: template.model.into(),
        key: template.key.into(),
        value: None,
        valid: (None, None),
        message: format!(
            "The relation of {} was not made for the {}.",
            material.name,
            side.name()
        ),
        source: "NASA/TM-2014-218507, section 3.5.1".into(),
        field: template.field.map(str::to_owned),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tps::Point;
    use crate::tps::material::tests::FILES;
    use crate::tps::mer::size;
    use numerics::math::RADIANS_PER_DEGREE;

    fn material(index: usize) -> TpsMaterial {
        TpsMaterial::parse(FILES[index].into()).unwrap()
    }

    /// 12 km/s at −9°, 12 kJ/cm², 800 W/cm², half an atmosphere: quiet for PICA.
    const FOREBODY: Environment = Environment {
        point: Point::Stagnation,
        peak_heat_flux_w_m2: 800e4,
        heat_load_j_m2: 12_000e4,
        peak_pressure_pa: 0.5 * PA_PER_ATM,
        entry_speed_m_s: 12e3,
        entry_flight_path_angle_rad: -9.0 * RADIANS_PER_DEGREE,
        time_above_limit_s: None,
    };

    const AFTBODY: Environment = Environment {
        point: Point::Aftbody,
        peak_heat_flux_w_m2: 40e4,
        heat_load_j_m2: 600e4,
        peak_pressure_pa: 0.1 * PA_PER_ATM,
        ..FOREBODY
    };

    fn found(index: usize, environment: Environment) -> Vec<Finding> {
        let material = material(index);
        findings(&material, &environment, &size(&material, &environment))
    }

    #[test]
    fn pica_inside_its_limits_is_quiet() {
        assert_eq!(found(0, FOREBODY), []);
    }

    #[test]
    fn pica_at_1302_w_cm2_is_exceeded_and_carbon_phenolic_is_not() {
        let hot = Environment {
            peak_heat_flux_w_m2: 1302e4,
            ..FOREBODY
        };
        let findings = found(0, hot);
        assert_eq!(findings.len(), 1);
        assert_eq!(findings[0].severity, Severity::Exceeded);
        assert_eq!(findings[0].valid, (None, Some(1200e4)));
        assert!(findings[0].message.contains("1302") && findings[0].message.contains("1200"));
        assert_eq!(findings[0].field.as_deref(), Some("design.forebody_tps"));
        assert_eq!(found(1, hot), []);
    }

    #[test]
    fn shallow_pica_is_warned_of_and_steep_noted() {
        let at = |deg: f64| {
            found(
                0,
                Environment {
                    entry_flight_path_angle_rad: -deg * RADIANS_PER_DEGREE,
                    ..FOREBODY
                },
            )
        };
        assert_eq!(at(5.5)[0].severity, Severity::Extrapolated);
        assert!(
            at(5.5)[0].message.contains("27 %"),
            "{}",
            at(5.5)[0].message
        );
        assert_eq!(at(20.0)[0].severity, Severity::Note);
        assert!(at(8.0).is_empty() && at(10.0).is_empty());
    }

    #[test]
    fn sirca_between_100_and_125_w_cm2_depends_on_the_30_seconds() {
        let pulse = |time| {
            found(
                2,
                Environment {
                    peak_heat_flux_w_m2: 110e4,
                    time_above_limit_s: time,
                    ..AFTBODY
                },
            )
        };
        assert_eq!(pulse(Some(20.0))[0].severity, Severity::Note);
        assert_eq!(pulse(Some(40.0))[0].severity, Severity::Exceeded);
        assert_eq!(pulse(None)[0].severity, Severity::Exceeded);
        let beyond = found(
            2,
            Environment {
                peak_heat_flux_w_m2: 130e4,
                time_above_limit_s: Some(1.0),
                ..AFTBODY
            },
        );
        assert_eq!(beyond[0].severity, Severity::Exceeded);
    }

    #[test]
    fn pressure_and_thickness_limits_speak() {
        // PICA bears 1.5 atm; SLA-561V at x = 20: 0.0064 × 400 + 0.0961 × 20 + 0.3322 = 4.81 cm, made up to 3 cm
        let pressed = found(
            0,
            Environment {
                peak_pressure_pa: 2.0 * PA_PER_ATM,
                ..FOREBODY
            },
        );
        assert_eq!(
            (pressed.len(), pressed[0].key.as_str()),
            (1, "peak_stagnation_pressure_pa")
        );
        let thick = found(
            5,
            Environment {
                heat_load_j_m2: 20.0 * 144.0 * 1e4,
                ..AFTBODY
            },
        );
        assert!(
            thick.iter().any(
                |finding| finding.message.contains("4.814 cm") && finding.valid.1 == Some(0.03)
            )
        );
    }

    #[test]
    fn li_900_beyond_x_of_9_6_is_exceeded_above_10_w_cm2_only() {
        let at = |flux: f64| {
            found(
                4,
                Environment {
                    peak_heat_flux_w_m2: flux,
                    heat_load_j_m2: 1500e4,
                    ..AFTBODY
                },
            )
        };
        assert!(
            at(50e4)
                .iter()
                .any(|finding| finding.severity == Severity::Exceeded)
        );
        assert!(
            at(9e4)
                .iter()
                .all(|finding| finding.severity == Severity::Note)
        );
    }

    #[test]
    fn li_900_names_the_branch_it_takes_and_both_thicknesses() {
        // x = 576 J/cm² / 144 = 4: first 0.6961 × 4^0.656 = 0.6961 × 2.4828 = 1.728 cm, second 2.543 cm
        for (flux, branch) in [(10.0, "first"), (10.1, "second")] {
            let findings = found(
                4,
                Environment {
                    peak_heat_flux_w_m2: flux * 1e4,
                    heat_load_j_m2: 576e4,
                    ..AFTBODY
                },
            );
            assert_eq!(findings.len(), 1, "{findings:?}");
            let said = &findings[0].message;
            let counts = format!("the {branch} counts");
            assert!(
                said.contains(&counts) && said.contains("1.728 cm") && said.contains("2.543 cm"),
                "{said}"
            );
        }
    }

    #[test]
    fn limit_of_the_shoulder_is_that_of_the_shoulder() {
        let hot = Environment {
            point: Point::Shoulder,
            peak_heat_flux_w_m2: 1302e4,
            ..FOREBODY
        };
        let findings = found(0, hot);
        assert_eq!(findings[0].key, "shoulder_peak_heat_flux_w_m2");
        assert!(findings[0].message.contains("on the shoulder"));
    }

    #[test]
    fn thin_shields_are_below_the_fit_and_a_backshell_tile_does_not_go_in_front() {
        // SIRCA, 100 J/cm²: x = 0.694, 0.4335 cm: below 0.518 (fit) and 0.5 (made)
        let thin = found(
            2,
            Environment {
                heat_load_j_m2: 100e4,
                ..AFTBODY
            },
        );
        assert_eq!(
            thin.iter()
                .map(|finding| finding.severity)
                .collect::<Vec<_>>(),
            [Severity::Note, Severity::Extrapolated]
        );
        let front = found(
            2,
            Environment {
                peak_heat_flux_w_m2: 50e4,
                ..FOREBODY
            },
        );
        assert!(
            front
                .iter()
                .any(|finding| finding.message.contains("not made for the forebody"))
        );
    }
}
