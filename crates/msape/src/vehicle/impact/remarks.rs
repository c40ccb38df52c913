//! Findings on a landing.
//!
//! ```text
//! sin² δ > 1 %       share of the kinetic energy that is not vertical, δ between velocity and vertical
//! z > Rₙ (1 − sin θ)  equation 1: deeper than the spherical nose
//! z < 3 D            Young's equation: shallower than three diameters
//! ```
//!
//! with z the depth of a rigid vehicle, Rₙ, θ, D nose radius, cone half-angle and diameter; lengths in m.
//!
//! # Valid
//! The limit of 1 % of the energy is an assumption of this project: about 6 deg.
//!
//! # References
//! - \[samareh-2014\] section 3.1.5; \[young-1997\].

use crate::finding::{Finding, Severity};
use crate::quantity::input;
use crate::vehicle::Vehicle;
use crate::vehicle::impact::Impact;
use crate::vehicle::impact::crush::PulseEnd;
use crate::vehicle::impact::ground::Ground;
use crate::vehicle::impact::landing::Landing;
use crate::vehicle::impact::striker::Striker;
use crate::vehicle::impact::supply::foam_strength_at_pa;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::FoamStrength;
use numerics::math::{PI, RADIANS_PER_DEGREE};

/// Relative excess over the load limit that is attributed to rounding and elastic ringing.
const LOAD_TOLERANCE: f64 = 0.01;
/// Relative crush beyond the plateau that is attributed to a landing slightly faster than in the pass before.
const PLATEAU_TOLERANCE: f64 = 1e-3;
/// Largest share of the kinetic energy in horizontal motion.
const SIDEWAYS_SHARE: f64 = 0.01;
/// Depth in diameters from which Young's equation holds.
const YOUNG_DIAMETERS: f64 = 3.0;
/// Input that sets the load limit.
const LIMIT: &str = input::design::CRUSH_LOAD_LIMIT_EARTH_G.key;
const REPORT: &str = "NASA/TM-2014-218507, section 3.1.5";

/// Findings of a landing.
pub fn findings(vehicle: &Vehicle, landing: &Landing, ground: &Ground) -> Vec<Finding> {
    let mut list = Vec::new();
    list.extend(rigid_body(vehicle, ground));
    list.extend(range_of_ground(vehicle, landing, ground));
    list.extend(densified(vehicle, landing));
    list.extend(over_limit(
        vehicle,
        "rigid_surface_peak_load_earth_g",
        landing.rigid_surface.peak_load_earth_g,
        "a rigid surface",
    ));
    if ground.penetration.is_some() || ground.young.is_some() {
        list.extend(over_limit(
            vehicle,
            "peak_impact_deceleration_earth_g",
            landing.ground.peak_load_earth_g,
            "the chosen ground",
        ));
    }
    list.extend(off_axis(landing));
    list.extend(unfinished(landing));
    list
}

/// Findings on the law that gives the strength of the foam, and on a strength that no grade has.
pub fn strength(input: &VehicleInput, impact: &Impact) -> Vec<Finding> {
    let asked_pa = impact.foam_strength_pa;
    let note = |severity, valid, message, field: &str| Finding {
        severity,
        model: "impact foam".to_string(),
        key: "foam_strength_pa".to_string(),
        value: Some(asked_pa),
        valid,
        message,
        source: format!("{REPORT}; data sheets of Rohacell"),
        field: Some(field.to_string()),
    };
    let (mpa, printed_mpa) = (asked_pa / 1e6, impact.equation_6_strength_pa / 1e6);
    let by = match impact.foam_strength_by {
        FoamStrength::CrushLaw => format!(
            "The strength of the impact foam, {mpa:.2} MPa, is that with which it stops the payload on a rigid surface within its plateau; equation 6 as printed asks for {printed_mpa:.2} MPa."
        ),
        FoamStrength::Equation6 => format!(
            "The strength of the impact foam, {mpa:.2} MPa, is that of equation 6 as printed, over the payload's cross-section and not over the foam's footprint."
        ),
    };
    let mut list = vec![note(
        Severity::Note,
        (None, None),
        by,
        input::design::FOAM_STRENGTH.key,
    )];
    let grades = &input.foam_grades;
    let (weakest, strongest) = match input.densities.impact_foam_kg_m3 {
        // one foam, as strong as it is
        Some(density) => {
            let given_pa = foam_strength_at_pa(grades, density);
            (given_pa, given_pa)
        }
        None => (
            grades.first().map(|grade| grade.compressive_strength_pa),
            grades.last().map(|grade| grade.compressive_strength_pa),
        ),
    };
    if let Some(offered_pa) = strongest.filter(|offered_pa| asked_pa > *offered_pa) {
        let message = format!(
            "The landing asks for {mpa:.1} MPa of crush strength, the foam offers {:.1} MPa: webs or honeycomb have to carry the rest.",
            offered_pa / 1e6
        );
        list.push(note(
            Severity::Extrapolated,
            (None, Some(offered_pa)),
            message,
            LIMIT,
        ));
    }
    if let Some(offered_pa) = weakest.filter(|offered_pa| asked_pa < *offered_pa) {
        let message = format!(
            "The landing asks for {mpa:.2} MPa of crush strength, the weakest foam on offer has {:.2} MPa: the payload stops sooner, under a larger load.",
            offered_pa / 1e6
        );
        list.push(note(
            Severity::Extrapolated,
            (Some(offered_pa), None),
            message,
            LIMIT,
        ));
    }
    list
}

fn over_limit(vehicle: &Vehicle, key: &str, load: f64, place: &str) -> Option<Finding> {
    let limit = vehicle.impact.crush_load_limit_earth_g;
    (load > limit * (1.0 + LOAD_TOLERANCE)).then(|| Finding {
        severity: Severity::Exceeded,
        model: "crush dynamics".to_string(),
        key: key.to_string(),
        value: Some(load),
        valid: (None, Some(limit)),
        message: format!(
            "On {place} the payload feels {load:.0} g, above the crush load limit of {limit:.0} g."
        ),
        source: REPORT.to_string(),
        field: Some(
            match vehicle.impact.foam_strength_by {
                FoamStrength::CrushLaw => input::design::STROKE_EFFICIENCY.key,
                FoamStrength::Equation6 => input::design::FOAM_STRENGTH.key,
            }
            .to_string(),
        ),
    })
}

/// The load of a rigid vehicle against the limit.
fn rigid_body(vehicle: &Vehicle, ground: &Ground) -> Option<Finding> {
    let load = vehicle.impact.ground_penetration?.load_earth_g;
    let limit = vehicle.impact.crush_load_limit_earth_g;
    (load > limit).then(|| Finding {
        severity: Severity::Exceeded,
        model: "impact".to_string(),
        key: "estimated_impact_load_earth_g".to_string(),
        value: Some(load),
        valid: (None, Some(limit)),
        message: format!(
            "Ground penetration gives {load:.0} g, above the crush load limit of {limit:.0} g."
        ),
        source: ground.law_source().to_string(),
        field: Some(LIMIT.to_string()),
    })
}

/// Depth outside the range of the ground's law.
fn range_of_ground(vehicle: &Vehicle, landing: &Landing, ground: &Ground) -> Option<Finding> {
    let striker = Striker::new(
        &vehicle.layout.outline.forebody,
        vehicle.mass.mass_kg,
        landing.velocity.speed_m_s,
    );
    let depth = landing.rigid_body_depth_m;
    let nose = striker.footprint.nose_depth_m();
    let least = YOUNG_DIAMETERS * vehicle.dimensions.diameter_m;
    let finding = |valid, message| Finding {
        severity: Severity::Extrapolated,
        model: "ground penetration".to_string(),
        key: "estimated_penetration_depth_m".to_string(),
        value: Some(depth),
        valid,
        message,
        source: ground.law_source().to_string(),
        field: Some(input::design::GROUND.to_string()),
    };
    if ground.penetration.is_some() && depth > nose {
        return Some(finding(
            (None, Some(nose)),
            format!(
                "Equation 1 is of spherical penetrometers: with its mean resistance the vehicle goes in by {:.0} mm, its spherical nose ends at {:.0} mm, and behind it the ground meets more than the nose diameter.",
                depth * 1e3,
                nose * 1e3
            ),
        ));
    }
    (ground.young.is_some() && depth < least).then(|| {
        finding(
            (Some(least), None),
            format!(
                "Young's equation is for bodies that go in by three diameters or more; here it is {:.2} diameters.",
                depth / vehicle.dimensions.diameter_m
            ),
        )
    })
}

/// Foam that leaves its plateau.
fn densified(vehicle: &Vehicle, landing: &Landing) -> Option<Finding> {
    let margin = landing.densification_margin();
    let absorber = &landing.absorber;
    let plateau_m = absorber.plateau_crush_m();
    let foam = match landing.foam_needed_m {
        Some(foam_m) => format!("{:.0} mm of it", foam_m * 1e3),
        None => "no thickness of it".to_string(),
    };
    let radius_m = vehicle.dimensions.payload_diameter_m / 2.0;
    let share = absorber.area_m2(plateau_m) / (PI * radius_m * radius_m);
    let footprint = if share < 1.0 {
        format!(
            " The flattened sphere has up to {:.0} % of the payload's cross-section, all of which equation 6 counts.",
            share * 100.0
        )
    } else {
        String::new()
    };
    (margin < -PLATEAU_TOLERANCE).then(|| Finding {
        severity: Severity::Note,
        model: "crush dynamics".to_string(),
        key: "foam_densification_margin".to_string(),
        value: Some(margin),
        valid: (Some(0.0), None),
        message: format!(
            "On a rigid surface {:.0} mm of the {:.0} mm of foam are crushed, its plateau ends at {:.0} mm: {foam} or a crush strength of {:.2} MPa instead of {:.2} MPa would keep to it.{footprint}",
            landing.rigid_surface.stroke_m * 1e3,
            absorber.thickness_m * 1e3,
            plateau_m * 1e3,
            landing.strength_needed_pa / 1e6,
            absorber.law.plateau_pa / 1e6,
        ),
        source: "Gibson and Ashby, Cellular Solids; strain where densification begins".to_string(),
        field: Some(input::design::STROKE_EFFICIENCY.to_string()),
    })
}

/// A velocity that is not vertical.
fn off_axis(landing: &Landing) -> Option<Finding> {
    let velocity = &landing.velocity;
    let (h, v) = (velocity.horizontal_m_s, velocity.speed_m_s);
    let share = h * h / (v * v);
    let angle_deg = velocity.off_axis_rad() / RADIANS_PER_DEGREE;
    (share > SIDEWAYS_SHARE).then(|| Finding {
        severity: Severity::Extrapolated,
        model: "crush dynamics".to_string(),
        key: "impact_off_axis_angle_deg".to_string(),
        value: Some(angle_deg),
        valid: (Some(0.0), None),
        message: format!(
            "The vehicle touches down {angle_deg:.1} deg off the vertical, with {h:.1} m/s sideways and {:.1} m/s down; {:.1} % of its energy is sideways, and the models of the landing are vertical.",
            velocity.vertical_m_s(),
            share * 100.0
        ),
        source: REPORT.to_string(),
        field: None,
    })
}

fn unfinished(landing: &Landing) -> Option<Finding> {
    let pulses = [&landing.rigid_surface, &landing.ground];
    let given_up = pulses.iter().any(|p| p.end == PulseEnd::Unfinished);
    (given_up && landing.velocity.speed_m_s > 0.0).then(|| Finding {
        severity: Severity::Extrapolated,
        model: "crush dynamics".to_string(),
        key: "impact_pulse_duration_s".to_string(),
        value: None,
        valid: (None, None),
        message: "The landing was not followed to the stop of the payload: its numbers are those up to there.".to_string(),
        source: "convention of this program".to_string(),
        field: None,
    })
}
