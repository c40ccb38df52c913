//! Outputs of volume, areas and mass properties beyond those of the report.

use super::Output;
use crate::answer::Answer;
use crate::quantity::Module;
use crate::units::Dimension;
use crate::vehicle::{ComponentKind, Vehicle};

fn vehicle(answer: &Answer, get: impl Fn(&Vehicle) -> f64) -> Option<f64> {
    answer.design.as_ref().map(|design| get(&design.vehicle))
}

fn wetted(answer: &Answer, kinds: &[ComponentKind]) -> Option<f64> {
    vehicle(answer, |v| {
        let parts = v.components.iter().filter(|c| kinds.contains(&c.kind));
        parts.map(|c| c.wetted_area_m2).sum()
    })
}

const SECTION: &str = "NASA/TM-2014-218507, section 3.1.4";
const CRUSHED: &str =
    "NASA/TM-2014-218507, section 3.1.5 for the stroke; how the foam is compressed is assumed";

pub(super) static OUTPUTS: &[Output] = &[
    Output::new("vehicle_volume_m3", "Vehicle Volume (m^3)", Module::Geometry, |a| vehicle(a, |v| v.mass.volume_m3))
        .help("Volume inside the outer surface, in m^3.", SECTION),
    Output::new("forebody_tps_wetted_area_m2", "Forebody TPS Wetted Area", Module::Geometry, |a| {
        wetted(a, &[ComponentKind::ForebodyTps, ComponentKind::Bond, ComponentKind::ForebodyCarrier])
    })
        .unit(Dimension::Area, "m^2")
        .help("Outer area of the forebody's layers, round the shoulder to where the wing begins.", SECTION),
    Output::new("aftbody_tps_wetted_area_m2", "Aftbody TPS Wetted Area", Module::Geometry, |a| {
        wetted(a, &[ComponentKind::AftbodyTps, ComponentKind::AftbodyCarrier])
    })
        .unit(Dimension::Area, "m^2")
        .help("Outer area of the aftbody's layers: wing, annulus and lid.", SECTION),
    Output::new("lid_gap_m", "Foam and Insulation Over the Payload or Impact Sphere", Module::Geometry, |a| {
        vehicle(a, |v| v.dimensions.body_foam_thickness_m + v.dimensions.lid_insulation_thickness_m)
    })
        .unit(Dimension::Length, "m")
        .help("Body foam and lid insulation together on the axis, between impact sphere, or payload, and the lid's structure.", SECTION),
    Output::new("mass_margin_kg", "Mass of the Margin", Module::Mass, |a| vehicle(a, |v| v.mass.mass_kg - v.mass.mass_without_margin_kg))
        .unit(Dimension::Mass, "kg")
        .help("Margin on every component but the payload, in all.", SECTION),
    Output::new("crushed_cg_location_from_nose_m", "Vehicle CG Location from Nose After Landing", Module::Mass, |a| {
        vehicle(a, |v| v.crushed.cg_x_m - v.dimensions.virtual_apex_ahead_m)
    })
        .unit(Dimension::Length, "m")
        .help("Center of gravity behind the nose with the payload moved forward by the required stroke.", CRUSHED),
    Output::new("crushed_ixx_kg_m2", "Ixx After Landing", Module::Mass, |a| vehicle(a, |v| v.crushed.ixx_kg_m2))
        .unit(Dimension::Inertia, "kg-m2")
        .help("Moment of inertia about the axis with the payload moved forward by the required stroke.", CRUSHED),
    Output::new("crushed_iyy_kg_m2", "Iyy After Landing", Module::Mass, |a| vehicle(a, |v| v.crushed.iyy_kg_m2))
        .unit(Dimension::Inertia, "kg-m2")
        .help("Moment of inertia about a transverse axis with the payload moved forward by the required stroke.", CRUSHED),
    Output::new("crushed_izz_kg_m2", "Izz After Landing", Module::Mass, |a| vehicle(a, |v| v.crushed.izz_kg_m2))
        .unit(Dimension::Inertia, "kg-m2")
        .help("Moment of inertia about the other transverse axis with the payload moved forward by the required stroke.", CRUSHED),
];
