//! Two levels of fidelity side by side: equations 1 to 6, and the dynamics of the crush.

use crate::components::vehicle::VehicleView;
use leptos::prelude::*;
use msape::Answer;
use msape::answer::output::{self, Output};
use msape_kit::display::{UnitSystem, number, symbol};

/// Landing surface.
#[derive(Clone, Copy, PartialEq, Eq)]
enum On {
    Rigid,
    Ground,
}

/// One quantity from both levels: keys of outputs.
struct Pair {
    on: On,
    name: &'static str,
    equation: Option<&'static str>,
    dynamics: Option<&'static str>,
}

const fn pair(
    on: On,
    name: &'static str,
    equation: Option<&'static str>,
    dynamics: Option<&'static str>,
) -> Pair {
    Pair {
        on,
        name,
        equation,
        dynamics,
    }
}

const PAIRS: &[Pair] = &[
    pair(
        On::Rigid,
        "Load of the payload",
        Some("crush_load_limit_earth_g"),
        Some("rigid_surface_peak_load_earth_g"),
    ),
    pair(
        On::Rigid,
        "Stroke",
        Some("required_stroke_m"),
        Some("rigid_surface_stroke_m"),
    ),
    pair(
        On::Rigid,
        "Thickness of the foam",
        Some("foam_thickness_m"),
        Some("foam_thickness_needed_m"),
    ),
    pair(
        On::Rigid,
        "Strength of the foam",
        Some("foam_strength_pa"),
        Some("foam_strength_needed_pa"),
    ),
    pair(
        On::Rigid,
        "Energy in the foam, J",
        None,
        Some("rigid_surface_foam_energy_j"),
    ),
    pair(
        On::Rigid,
        "Duration",
        None,
        Some("rigid_surface_pulse_duration_s"),
    ),
    pair(
        On::Ground,
        "Load",
        Some("estimated_impact_load_earth_g"),
        Some("peak_impact_deceleration_earth_g"),
    ),
    pair(
        On::Ground,
        "Depth in the ground",
        Some("estimated_penetration_depth_m"),
        Some("penetration_depth_m"),
    ),
    pair(On::Ground, "Stroke", None, Some("dynamic_stroke_m")),
    pair(
        On::Ground,
        "Energy in the foam, J",
        None,
        Some("impact_foam_energy_j"),
    ),
    pair(
        On::Ground,
        "Duration",
        None,
        Some("impact_pulse_duration_s"),
    ),
];

/// The table.
#[component]
pub fn Levels(ground: Memo<String>) -> impl IntoView {
    let card = VehicleView::expect();
    let body = move |on: On, title: Signal<String>| {
        let rows = move || {
            let units = card.units.get();
            card.solved.with(|solved| {
                let answer = &solved.as_ref()?.answer;
                let pairs = PAIRS.iter().filter(|pair| pair.on == on);
                Some(pairs.map(|pair| row(pair, answer, units)).collect_view())
            })
        };
        view! {
            <tbody>
                <tr class="group"><th scope="rowgroup" colspan="4">{title}</th></tr>
                {rows}
            </tbody>
        }
    };
    let speed = move || {
        let units = card.units.get();
        card.solved.with(|solved| {
            let answer = &solved.as_ref()?.answer;
            let said = [
                "impact_speed_m_s",
                "impact_off_axis_angle_deg",
                "impact_energy_j",
                "crushing_mass_kg",
                "foam_plateau_stress_pa",
            ]
            .into_iter()
            .filter_map(output::find)
            .map(|output| format!("{}: {}", output.label, with_symbol(output, answer, units)));
            Some(said.collect::<Vec<_>>().join("; "))
        })
    };
    view! {
        <div class="mass-tree" tabindex="0" role="region" aria-label="Equations and dynamics">
            <table class="tree levels">
                <thead>
                    <tr>
                        <th scope="col">"Landing"</th>
                        <th scope="col">"Equations 1 to 6"</th>
                        <th scope="col">"Dynamics"</th>
                        <th scope="col">"Dynamics over equation"</th>
                    </tr>
                </thead>
                {body(On::Rigid, Signal::stored("On a rigid surface, where the foam takes all".to_string()))}
                {body(On::Ground, Signal::derive(move || format!("On the chosen ground: {}", ground.get())))}
            </table>
        </div>
        <p class="quiet">{speed}</p>
    }
}

fn with_symbol(output: &'static Output, answer: &Answer, units: UnitSystem) -> String {
    let unit = units.of_output(output);
    match (output.get)(answer) {
        Some(value) => format!("{} {}", number(unit.from_canonical(value), 4), symbol(unit))
            .trim_end()
            .to_string(),
        None => "–".to_string(),
    }
}

fn row(pair: &Pair, answer: &Answer, units: UnitSystem) -> impl IntoView + use<> {
    let output = |key: Option<&'static str>| key.and_then(output::find);
    let (equation, dynamics) = (output(pair.equation), output(pair.dynamics));
    let value = |output: Option<&'static Output>| output.and_then(|output| (output.get)(answer));
    let ratio = match (value(equation), value(dynamics)) {
        (Some(equation), Some(dynamics)) if equation > 0.0 => {
            Some(format!("{:.2}", dynamics / equation))
        }
        _ => None,
    };
    let cell = |output: Option<&'static Output>| match output {
        Some(output) => view! {
            <td title=output.help data-level=output.key>
                <span class="value">{with_symbol(output, answer, units)}</span>
                <span class="basis">{output.label}</span>
            </td>
        }
        .into_any(),
        None => view! { <td></td> }.into_any(),
    };
    view! {
        <tr>
            <th scope="row">{pair.name}</th>
            {cell(equation)}
            {cell(dynamics)}
            <td>{ratio}</td>
        </tr>
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_levels_of_a_pair_are_of_one_dimension() {
        for pair in PAIRS {
            let dimension = |key: Option<&str>| key.map(|key| output::find(key).unwrap().dimension);
            let (a, b) = (dimension(pair.equation), dimension(pair.dynamics));
            assert!(a.is_none() || b.is_none() || a == b, "{}", pair.name);
            assert!(b.is_some());
        }
    }
}
