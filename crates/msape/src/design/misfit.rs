//! Reasons why a vehicle does not close, reported at the inputs that mend it.

use crate::finding::{Finding, Severity};
use crate::quantity::input;
use crate::vehicle::NotClosed;
use crate::vehicle::input::{PayloadSize, VehicleInput};
use crate::vehicle::layout::Misfit;

/// Key of the input that gives the payload's size.
fn payload_key(size: PayloadSize) -> &'static str {
    match size {
        PayloadSize::DensityKgM3(_) => input::design::PAYLOAD_DENSITY_KG_M3.key,
        PayloadSize::DiameterM(_) => input::design::PAYLOAD_DIAMETER_M.key,
        PayloadSize::DiameterRatio(_) => input::design::PAYLOAD_DIAMETER_RATIO.key,
    }
}

/// Keys of the inputs that cause a misfit.
fn fields(misfit: &Misfit, input: &VehicleInput) -> Vec<&'static str> {
    let payload = payload_key(input.payload_size);
    match misfit {
        Misfit::NoseWiderThanShoulder { .. } => {
            vec![
                input::design::NOSE_RADIUS_RATIO.key,
                input::design::SHOULDER_RADIUS_RATIO.key,
            ]
        }
        Misfit::PayloadWiderThanVehicle { .. }
        | Misfit::LidWiderThanShoulder { .. }
        | Misfit::WingTooShallow { .. } => vec![input::design::DIAMETER_M.key, payload],
        Misfit::WingTooSteep => vec![input::design::CONE_HALF_ANGLE_DEG.key, payload],
        Misfit::NoRoomForLayers { .. } => {
            vec![
                input::design::DIAMETER_M.key,
                input::design::SHOULDER_RADIUS_RATIO.key,
            ]
        }
        Misfit::NotConverged { .. } => vec![input::design::DIAMETER_M.key],
    }
}

/// Findings on the misfit at the requested diameter, one for each input that causes it.
pub fn findings(not_closed: &NotClosed, input: &VehicleInput) -> Vec<Finding> {
    let Some(misfit) = &not_closed.at_input else {
        return Vec::new();
    };
    let of_field = |field: &str| Finding {
        severity: Severity::Exceeded,
        model: "closing rules".to_owned(),
        key: field.to_owned(),
        value: None,
        valid: (None, None),
        message: format!("At {:.3} m {}.", input.diameter_m, misfit.reason()),
        source: "NASA/TM-2014-218507, section 3.1.2".to_owned(),
        field: Some(field.to_owned()),
    };
    fields(misfit, input).into_iter().map(of_field).collect()
}

#[cfg(test)]
mod tests {
    use crate::quantity::input;
    use crate::{Case, Library, Outcome, Request, design};

    #[test]
    fn a_payload_too_wide_is_told_at_its_own_field_and_at_the_diameter() {
        let library = Library::builtin().unwrap();
        let mut case = Case::run_page();
        case.set("design.payload_diameter_ratio", "0.95");
        let answer = design(&case, &library, Request::Nothing).unwrap();
        assert_eq!(answer.outcome, Outcome::NotClosed, "{:?}", answer.reason);
        let told: Vec<_> = answer
            .findings
            .iter()
            .filter(|finding| finding.model == "closing rules")
            .collect();
        let fields: Vec<&str> = told.iter().filter_map(|f| f.field.as_deref()).collect();
        assert_eq!(fields.len(), 2, "{fields:?}");
        assert!(
            fields.contains(&"design.payload_diameter_ratio"),
            "{fields:?}"
        );
        assert!(fields.iter().all(|key| input::find(key).is_some()));
        let said = &told[0].message;
        assert!(said.contains("payload, foam and lid"), "{said}");
    }
}
