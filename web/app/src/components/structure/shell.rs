//! Results of the shell model for the parts of a wall, and natural frequencies of the vehicle.

use super::{StructureView, margin};
use leptos::prelude::*;
use msape::shell::analysis::PartStress;
use msape_kit::display::{UnitSystem, number, symbol};

/// Peak stress of each part of the selected wall, at entry and at launch, with its location.
#[component]
pub fn PartTable() -> impl IntoView {
    let view = StructureView::expect();
    let rows = move || {
        let (wall, units, nose_x_m) = (view.wall.get(), view.card.units.get(), view.nose_x_m());
        view.shell(|shell| {
            let cases = [("entry", &shell.entry), ("launch", &shell.launch)];
            let rows = cases.into_iter().flat_map(|(name, case)| {
                case.of_wall(wall)
                    .map(move |part| row(part, name, units, nose_x_m))
            });
            rows.collect_view()
        })
    };
    let unit = move |name: &'static str, symbol_of: &'static str| {
        move || format!("{name}, {}", symbol(view.card.units.get().named(symbol_of)))
    };
    let most = move || {
        let (wall, units) = (view.wall.get(), view.card.units.get());
        view.shell(|shell| {
            let [entry, launch] = shell.displacement_m(wall).map(|m| {
                msape_kit::display::with_unit(m, 3, units.named("mm"))
            });
            let allowed = shell.entry.of_wall(wall).next().map(|part| {
                msape_kit::display::with_unit(part.allowed_stress_pa(), 4, units.named("MPa"))
            });
            format!(
                "Stress after von Mises in laminate or faces, at the limit load; {} is allowed. Largest displacement against the foot of the lid: {entry} at entry, {launch} at launch.",
                allowed.unwrap_or_default()
            )
        })
    };
    view! {
        <div class="mass-tree" tabindex="0" role="region" aria-label="Stress by part">
            <table class="tree">
                <thead>
                    <tr>
                        <th scope="col">"Part"</th>
                        <th scope="col" class="words">"Load case"</th>
                        <th scope="col">{unit("Peak stress", "MPa")}</th>
                        <th scope="col">{unit("from the axis", "mm")}</th>
                        <th scope="col">{unit("from the nose", "mm")}</th>
                        <th scope="col">"Margin"</th>
                        <th scope="col">{unit("Core shear", "MPa")}</th>
                        <th scope="col">"Margin of the core"</th>
                    </tr>
                </thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
        <p class="quiet">{most}</p>
    }
}

fn row(
    part: &PartStress,
    case: &'static str,
    units: UnitSystem,
    nose_x_m: f64,
) -> impl IntoView + use<> {
    let shown = |value: f64, symbol: &str, digits| {
        number(units.named(symbol).from_canonical(value), digits)
    };
    let core = part.core_margin;
    let label = |value: f64| view! { <span class:short=value < -1e-6>{margin(value)}</span> };
    view! {
        <tr>
            <th scope="row">{part.part.label()}</th>
            <td class="words">{case}</td>
            <td class="value">{shown(part.stress_pa, "MPa", 4)}</td>
            <td>{shown(part.at.r_m, "mm", 4)}</td>
            <td>{shown(part.at.x_m - nose_x_m, "mm", 4)}</td>
            <td class="value">{label(part.margin)}</td>
            <td>{core.map(|_| shown(part.shear_pa, "MPa", 3))}</td>
            <td class="value">{core.map(label)}</td>
        </tr>
    }
}

/// Motion of the vehicle with a circumferential wave number.
fn motion(waves: u32) -> &'static str {
    match waves {
        0 => "along the axis",
        1 => "across the axis",
        2 => "the rim becomes an ellipse",
        _ => "the rim waves",
    }
}

/// Lowest frequency for each circumferential wave number.
#[component]
pub fn Frequencies() -> impl IntoView {
    let view = StructureView::expect();
    let rows = move || {
        view.shell(|shell| {
            let lowest = shell.first_frequency();
            let row = |found: &msape::shell::modes::Frequency| {
                let is_lowest = lowest == Some(*found);
                view! {
                    <tr class:least=is_lowest>
                        <th scope="row">{format!("{}: {}", found.harmonic, motion(found.harmonic))} {is_lowest.then(|| view! { " " <span class="mark mark-least">"lowest"</span> })}</th>
                        <td class="value">{number(found.frequency_hz, 4)}</td>
                    </tr>
                }
            };
            shell.frequencies.iter().map(row).collect_view()
        })
    };
    view! {
        <table class="tree frequencies">
            <thead><tr><th scope="col">"Waves round the axis"</th><th scope="col">"Frequency, Hz"</th></tr></thead>
            <tbody>{rows}</tbody>
        </table>
    }
}
