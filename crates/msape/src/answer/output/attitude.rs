//! Outputs of the attitude, in six degrees of freedom.

use super::Output;
use crate::answer::Answer;
use crate::flight::AttitudeEvents;
use crate::quantity::Module;
use crate::units::Dimension;
use numerics::math::RADIANS_PER_DEGREE;

const SECTION: &str = "NASA/TM-2014-218507, section 3.3.2";

fn attitude<T>(answer: &Answer, get: impl Fn(&AttitudeEvents) -> Option<T>) -> Option<T> {
    get(answer.flight.as_ref()?.attitude.as_ref()?)
}

fn angle(answer: &Answer, get: impl Fn(&AttitudeEvents) -> f64) -> Option<f64> {
    attitude(answer, |a| Some(get(a) / RADIANS_PER_DEGREE))
}

const fn angle_output(
    key: &'static str,
    label: &'static str,
    get: fn(&Answer) -> Option<f64>,
) -> Output {
    Output::new(key, label, Module::Flight, get).unit(Dimension::Angle, "deg")
}

const fn time_output(
    key: &'static str,
    label: &'static str,
    get: fn(&Answer) -> Option<f64>,
) -> Output {
    Output::new(key, label, Module::Flight, get).unit(Dimension::Time, "s")
}

pub(super) static OUTPUTS: &[Output] = &[
    angle_output(
        "initial_total_alpha_deg",
        "Total Angle of Attack at Entry",
        |a| angle(a, |e| e.initial_total_alpha_rad),
    )
    .help(
        "Angle between axis and velocity relative to the air at the start.",
        SECTION,
    ),
    angle_output(
        "maximum_total_alpha_deg",
        "Max Total Angle of Attack",
        |a| angle(a, |e| e.maximum_total_alpha.angle_rad),
    )
    .help(
        "Largest angle between axis and velocity relative to the air.",
        SECTION,
    ),
    time_output(
        "maximum_total_alpha_time_s",
        "Max Total Angle of Attack at Time",
        |a| attitude(a, |e| Some(e.maximum_total_alpha.time_s)),
    )
    .help("Time of it after the start.", SECTION),
    angle_output(
        "total_alpha_at_peak_heating_deg",
        "Total Angle of Attack at Max Heat Rate",
        |a| angle(a, |e| e.total_alpha_at_peak_heating_rad),
    )
    .help(
        "Total angle of attack at the largest total heat rate.",
        SECTION,
    ),
    angle_output(
        "maximum_total_alpha_after_peak_heating_deg",
        "Max Total Angle of Attack after Max Heat Rate",
        |a| angle(a, |e| e.maximum_total_alpha_after_peak_heating.angle_rad),
    )
    .help(
        "Largest total angle of attack from the largest total heat rate on.",
        SECTION,
    ),
    time_output(
        "maximum_total_alpha_after_peak_heating_time_s",
        "Max Total Angle of Attack after Max Heat Rate at Time",
        |a| attitude(a, |e| Some(e.maximum_total_alpha_after_peak_heating.time_s)),
    )
    .help("Time of it after the start.", SECTION),
    angle_output(
        "total_alpha_at_peak_deceleration_deg",
        "Total Angle of Attack at Max Entry Load",
        |a| angle(a, |e| e.total_alpha_at_peak_deceleration_rad),
    )
    .help(
        "Total angle of attack at the largest deceleration.",
        SECTION,
    ),
    time_output(
        "first_below_10_deg_time_s",
        "First below 10 deg at Time",
        |a| attitude(a, |e| e.first_below_10_deg_time_s),
    )
    .help(
        "First time after the start at which the total angle of attack is below 10 deg.",
        SECTION,
    ),
    Output::new(
        "first_below_10_deg_knudsen",
        "First below 10 deg at Knudsen Number",
        Module::Flight,
        |a| attitude(a, |e| e.first_below_10_deg_knudsen),
    )
    .help(
        "Knudsen number at that time.",
        "NASA/TM-2014-218507, Figure 27",
    ),
    Output::new(
        "hemisphere_changes",
        "Turns through 90 deg",
        Module::Flight,
        |a| attitude(a, |e| Some(e.hemisphere_change_times_s.len() as f64)),
    )
    .help(
        "Number of times at which the total angle of attack goes through 90 deg, either way.",
        SECTION,
    ),
    time_output(
        "first_hemisphere_change_time_s",
        "First Turn through 90 deg at Time",
        |a| attitude(a, |e| e.hemisphere_change_times_s.first().copied()),
    )
    .help("Time of the first of them.", SECTION),
    time_output(
        "last_hemisphere_change_time_s",
        "Last Turn through 90 deg at Time",
        |a| attitude(a, |e| e.hemisphere_change_times_s.last().copied()),
    )
    .help("Time of the last of them.", SECTION),
    Output::new(
        "last_hemisphere_change_knudsen",
        "Last Turn through 90 deg at Knudsen Number",
        Module::Flight,
        |a| attitude(a, |e| e.last_hemisphere_change_knudsen),
    )
    .help(
        "Knudsen number at the last of them.",
        "NASA/TM-2014-218507, Figure 27",
    ),
    angle_output(
        "final_total_alpha_deg",
        "Final Total Angle of Attack",
        |a| angle(a, |e| e.final_total_alpha_rad),
    )
    .help("Total angle of attack at the end of the flight.", SECTION),
    angle_output(
        "final_total_alpha_amplitude_deg",
        "Final Amplitude of Total Angle of Attack",
        |a| angle(a, |e| e.final_amplitude_rad),
    )
    .help(
        "Largest total angle of attack in the last 10 s of the flight.",
        "NASA/TM-2014-218507, section 3.3.7",
    ),
    Output::new(
        "maximum_transverse_rate_deg_s",
        "Max Transverse Rate",
        Module::Flight,
        |a| angle(a, |e| e.maximum_transverse_rate_rad_s),
    )
    .unit(Dimension::BodyRate, "deg/s")
    .help(
        "Largest rate of turn across the axis, of the points looked at.",
        SECTION,
    ),
];
