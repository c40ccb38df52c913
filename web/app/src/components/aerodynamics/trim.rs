//! Trim angles of a body and its stability there.

use super::AeroView;
use super::figures::family_names;
use leptos::prelude::*;
use msape_kit::display::number;

/// Trim points, center of pressure and static margin of each curve.
#[component]
pub fn TrimTable() -> impl IntoView {
    let view = AeroView::expect();
    let rows = move || {
        view.curves.with(|curves| {
            let Some(curves) = curves.as_ref() else {
                return Vec::new();
            };
            let row = |(curve, name): (&msape_worker::questions::curves::OverAlpha, String)| {
                let shown = |value: Option<f64>| value.map_or("–".to_string(), |value| number(value, 4));
                let trims = curve.polar.trim.iter().map(|trim| {
                    let words = trim.word();
                    let class = if trim.is_stable() { "mark mark-good" } else { "mark mark-extrapolated" };
                    view! { <span class="trim-point">{format!("{} deg ", number(trim.alpha_deg, 4))}<span class=class>{words}</span></span> " " }
                });
                view! {
                    <tr>
                        <th scope="row">{name}</th>
                        <td class="value">{shown(curve.polar.pressure_center)}</td>
                        <td class="value">{shown(curve.polar.static_margin)}</td>
                        <td class="words">{trims.collect_view()}</td>
                    </tr>
                }
            };
            curves.over_alpha.iter().zip(family_names(curves)).map(row).collect()
        })
    };
    view! {
        <div class="wide-table" tabindex="0" role="region" aria-label="Trim and stability">
            <table class="facts">
                <caption>"Trim and stability about the center of gravity"</caption>
                <thead>
                    <tr>
                        <th scope="col">"Curve"</th>
                        <th scope="col">"Center of pressure (D)"</th>
                        <th scope="col">"Static margin (D)"</th>
                        <th scope="col">"Trim angles"</th>
                    </tr>
                </thead>
                <tbody>{rows}</tbody>
            </table>
        </div>
    }
}
