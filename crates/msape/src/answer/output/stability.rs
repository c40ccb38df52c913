//! Outputs of static stability: margin and trims of the designed outline about its own center of gravity.

use super::Output;
use crate::aero::stability::{RegimeStability, Stability};
use crate::answer::Answer;
use crate::quantity::Module;
use crate::units::Dimension;

const SECTION: &str = "NASA/TM-2014-218507, section 3.3.2";

fn regime<T>(
    answer: &Answer,
    which: fn(&Stability) -> &RegimeStability,
    get: impl Fn(&RegimeStability) -> Option<T>,
) -> Option<T> {
    get(which(answer.design.as_ref()?.stability.as_ref()?))
}

/// The outputs of one regime: field, start of the keys, words of the labels, flow in the help.
macro_rules! outputs {
    ($field:ident, $key:literal, $label:literal, $flow:literal) => {
        [
            Output::new(concat!($key, "_static_margin"), concat!("Static Margin (X/D), ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| r.static_margin)
            })
            .help(concat!("Distance of the center of gravity ahead of the center of pressure nose first in diameters, in ", $flow, "; positive is stable."), SECTION),
            Output::new(concat!($key, "_cm_alpha_per_rad"), concat!("Moment Slope Nose First (1/rad), ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.end(0.0)?.cm_alpha_per_rad))
            })
            .help(concat!("Slope of the moment about the center of gravity at 0 deg, in ", $flow, "; negative is stable."), SECTION),
            Output::new(concat!($key, "_aft_first_cm_alpha_per_rad"), concat!("Moment Slope Aft First (1/rad), ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.end(180.0)?.cm_alpha_per_rad))
            })
            .help(concat!("Slope of the moment about the center of gravity at 180 deg, in ", $flow, "; negative is stable."), SECTION),
            Output::new(concat!($key, "_trims"), concat!("Number of Trims, ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.trims.len() as f64))
            })
            .help(concat!("Angles of attack from 0 to 180 deg, both included, at which the moment about the center of gravity vanishes in ", $flow, ", stable or not; the notes list them."), SECTION),
            Output::new(concat!($key, "_stable_trim_deg"), concat!("Stable Trim not Nose First, ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.other_trim()?.alpha_deg))
            })
            .unit(Dimension::Angle, "deg")
            .help(concat!("Least angle of attack but 0 deg at which the vehicle is stable in ", $flow, "."), SECTION),
            Output::new(concat!($key, "_stable_trim_cm_alpha_per_rad"), concat!("Moment Slope at that Trim (1/rad), ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.other_trim()?.cm_alpha_per_rad))
            })
            .help(concat!("Slope of the moment about the center of gravity there, in ", $flow, "."), SECTION),
            Output::new(concat!($key, "_unstable_trim_deg"), concat!("Unstable Trim, ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.turning_point()?.alpha_deg))
            })
            .unit(Dimension::Angle, "deg")
            .help(concat!("Least angle of attack between 0 and 180 deg at which the moment vanishes and the vehicle is unstable in ", $flow, ": up to it the moment turns the nose forward."), SECTION),
            Output::new(concat!($key, "_unstable_trim_cm_alpha_per_rad"), concat!("Moment Slope at the Unstable Trim (1/rad), ", $label), Module::Aerodynamics, |a| {
                regime(a, |s| &s.$field, |r| Some(r.turning_point()?.cm_alpha_per_rad))
            })
            .help(concat!("Slope of the moment about the center of gravity there, in ", $flow, "."), SECTION),
        ]
    };
}

pub(super) static FREE_MOLECULAR: &[Output] = &outputs!(
    free_molecular,
    "free_molecular",
    "Free-Molecular",
    "free-molecular flow at the limit of high speed"
);

pub(super) static HYPERSONIC: &[Output] =
    &outputs!(hypersonic, "hypersonic", "Hypersonic", "hypersonic flow");
