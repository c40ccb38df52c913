//! Origins of coefficients: marks below each figure, and a description of each regime.

use super::AeroView;
use super::figures::{Over, sources};
use leptos::prelude::*;
use msape::aero::coefficient::{Coefficient, Origin};
use msape::aero::database::Regime;

/// Style class of a mark.
fn class(origin: Origin) -> &'static str {
    match origin {
        Origin::Published | Origin::Given => "mark mark-good",
        Origin::Computed => "mark",
        Origin::Assumed => "mark mark-extrapolated",
    }
}

/// Origins of the numbers of a figure, by part.
#[component]
pub fn OriginMarks(coefficient: Coefficient, over: Over) -> impl IntoView {
    let view = AeroView::expect();
    let list = Memo::new(move |_| {
        view.curves.with(|curves| {
            let curves = curves.as_ref();
            curves
                .map(|curves| sources(curves, coefficient, over))
                .unwrap_or_default()
        })
    });
    view! {
        <ul class="origins" aria-label="Where the numbers come from">
            {move || list.get().into_iter().map(|source| view! {
                <li>{source.part} " " {source.origins.into_iter().map(|(origin, words)| view! { <span class=class(origin)>{words}</span> " " }).collect_view()}</li>
            }).collect_view()}
        </ul>
    }
}

/// Regimes in order.
const REGIMES: [Regime; 6] = [
    Regime::FreeMolecular,
    Regime::Transitional,
    Regime::Hypersonic,
    Regime::Supersonic,
    Regime::Transonic,
    Regime::Subsonic,
];

fn reach(regime: Regime) -> &'static str {
    match regime {
        Regime::FreeMolecular => "Knudsen number from 10",
        Regime::Transitional => "Knudsen number 0.001 to 10",
        Regime::Hypersonic => "Mach number from 5",
        Regime::Supersonic => "Mach number 1.5 to 5",
        Regime::Transonic => "Mach number 0.5 to 1.5",
        Regime::Subsonic => "Mach number to 0.5",
        Regime::Table => "everywhere",
    }
}

/// Description of each regime.
#[component]
pub fn Sources() -> impl IntoView {
    let view = AeroView::expect();
    let is_table = move || {
        view.curves
            .with(|curves| curves.as_ref().is_some_and(|curves| curves.is_table))
    };
    let regimes = move || {
        if is_table() {
            vec![Regime::Table]
        } else {
            REGIMES.to_vec()
        }
    };
    let remarks = move || {
        let curves = view.curves.get();
        curves.map_or_else(Vec::new, |curves| curves.remarks.clone())
    };
    view! {
        {move || remarks().into_iter().map(|remark| view! {
            <p class="quiet"><span class="mark mark-extrapolated">"note"</span> " " {remark.message}</p>
        }).collect_view()}
        <table class="facts regimes">
            <caption>"Where static coefficients come from"</caption>
            <tbody>
                {move || regimes().into_iter().map(|regime| view! {
                    <tr>
                        <th scope="row">{regime.name()}<br /><span class="quiet">{reach(regime)}</span></th>
                        <td class="words">{regime.provenance()}</td>
                    </tr>
                }).collect_view()}
            </tbody>
        </table>
    }
}
