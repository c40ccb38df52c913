//! Remarks on a vehicle: inputs that the closing rules changed, and findings.

use crate::finding::{Adjustment, Finding, Severity};
use crate::quantity::input;
use crate::vehicle::figures::Figures;
use crate::vehicle::impact::foam_rule::FoamRule;
use crate::vehicle::impact::remarks::strength;
use crate::vehicle::input::VehicleInput;
use crate::vehicle::kinds::Concept;
use crate::vehicle::layout::Layout;

/// Changes smaller than this are rounding, m.
const ROUNDING_M: f64 = 1e-9;

/// Adjustments of diameter, shoulder radius and impact foam, where they differ from the request.
pub fn adjustments(
    input: &VehicleInput,
    diameter_m: f64,
    foam: &FoamRule,
    layout: &Layout,
) -> Vec<Adjustment> {
    let mut list = Vec::new();
    let source = "NASA/TM-2014-218507, section 3.1.2".to_owned();
    if diameter_m > input.diameter_m + ROUNDING_M {
        list.push(Adjustment {
            key: input::design::DIAMETER_M.key.to_owned(),
            from: input.diameter_m,
            to: diameter_m,
            reason: "The vehicle was grown to the smallest diameter that holds payload, impact foam and lid.".to_owned(),
            source: source.clone(),
        });
    }
    let shoulder_m = layout.outline.forebody.shoulder_radius_m;
    let asked_m = input.shoulder_radius_ratio * diameter_m / 2.0;
    if (shoulder_m - asked_m).abs() > ROUNDING_M {
        let reason = if shoulder_m < asked_m {
            "The shoulder radius was reduced, as the wing's aft side would be steeper than the forebody and thicker at its tip than at its root."
        } else {
            "The shoulder radius was increased to the smallest that has room for the layers of forebody and aftbody."
        };
        list.push(Adjustment {
            key: input::design::SHOULDER_RADIUS_RATIO.key.to_owned(),
            from: input.shoulder_radius_ratio,
            to: 2.0 * shoulder_m / diameter_m,
            reason: reason.to_owned(),
            source,
        });
    }
    if let Some(asked) = input.impact.stroke_efficiency
        && foam.stroke_efficiency < asked
    {
        list.push(Adjustment {
            key: input::design::STROKE_EFFICIENCY.key.to_owned(),
            from: asked,
            to: foam.stroke_efficiency,
            reason: "The stroke efficiency was reduced to what the plateau of the foam in use has: beyond it the foam stiffens and the payload feels more than its limit.".to_owned(),
            source: "Gibson and Ashby, Cellular Solids; strain where densification begins".to_owned(),
        });
    }
    if layout.foam_thickness_m > foam.least_thickness_m + ROUNDING_M {
        list.push(Adjustment {
            key: "foam_thickness_m".to_owned(),
            from: foam.least_thickness_m,
            to: layout.foam_thickness_m,
            reason: "The impact foam was thickened beyond the required stroke, as the lid, tied to the impact sphere, would stand too low for its wing."
                .to_owned(),
            source: "assumed: the report leaves open what is done when no shoulder radius closes".to_owned(),
        });
    }
    let gap_m = input.rules.payload_lid_gap_m;
    if input.concept == Concept::NonMsr && layout.lid_insulation_thickness_m > gap_m + ROUNDING_M {
        list.push(Adjustment {
            key: "lid_gap_m".to_owned(),
            from: gap_m,
            to: layout.lid_insulation_thickness_m,
            reason: "The lid was raised over the payload and the primary structure lengthened, as the lid about the center of gravity would not let the payload pass or would stand too low for its wing."
                .to_owned(),
            source: "assumed: the report leaves open what is done when no shoulder radius closes".to_owned(),
        });
    }
    list
}

/// Remarks on foam and balance.
pub fn findings(input: &VehicleInput, figures: &Figures) -> Vec<Finding> {
    let mut list = Vec::new();
    list.extend(strength(input, &figures.impact));
    list.extend(narrow_gap(input, &figures.layout));
    let payload_x_m = figures.layout.payload_x_m;
    if figures.mass.cg_x_m > payload_x_m {
        list.push(Finding {
            severity: Severity::Note,
            model: "mass properties".to_owned(),
            key: "vertical_cg_location_m".to_owned(),
            value: Some(figures.mass.cg_x_m),
            valid: (None, Some(payload_x_m)),
            message: "The center of gravity stands behind the payload: the heaviest part should be the foremost.".to_owned(),
            source: "general knowledge".to_owned(),
            field: None,
        });
    }
    list
}

/// Finding on a lid that is nearer to the impact sphere than the rules provide where there is room.
fn narrow_gap(input: &VehicleInput, layout: &Layout) -> Option<Finding> {
    let rules = &input.rules;
    let wanted_m = rules.body_foam_gap_m + rules.lid_insulation_gap_m;
    let gap_m = layout.body_foam_thickness_m + layout.lid_insulation_thickness_m;
    let narrowed = input.concept == Concept::Msr && gap_m < wanted_m - ROUNDING_M;
    narrowed.then(|| Finding {
        severity: Severity::Note,
        model: "vehicle geometry".to_owned(),
        key: "lid_gap_m".to_owned(),
        value: Some(gap_m),
        valid: (Some(wanted_m), None),
        message: format!(
            "Body foam and lid insulation over the impact sphere are {:.1} mm together and not the {:.1} mm of Table 9: a wider lid would make the wing's aft side steeper than allowed.",
            gap_m * 1000.0,
            wanted_m * 1000.0
        ),
        source: "NASA/TM-2014-218507, section 3.1.2 and Table 9".to_owned(),
        field: None,
    })
}
