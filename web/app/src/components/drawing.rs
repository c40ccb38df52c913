//! Section of the vehicle, to scale: components, dimensions, center of gravity.

use crate::components::mass_tree::{Detail, Legend};
use crate::components::vehicle::VehicleView;
use crate::drawing::{Section, class, scale_bar_mm, section};
use leptos::prelude::*;
use msape::answer::output;
use msape::units::{Dimension, Unit, canonical};
use msape::vehicle::{ComponentKind, Dimensions, Vehicle};
use msape_kit::display::{UnitSystem, number, symbol};

/// Layer that can be hidden.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layer {
    HeatShield,
    Structure,
    Foam,
    Payload,
    Dimensions,
    CenterOfGravity,
}

const LAYERS: [(Layer, &str); 6] = [
    (Layer::HeatShield, "Heat shield"),
    (Layer::Structure, "Structure"),
    (Layer::Foam, "Foam and insulation"),
    (Layer::Payload, "Payload"),
    (Layer::Dimensions, "Dimensions"),
    (Layer::CenterOfGravity, "CG"),
];

impl Layer {
    /// Components of a layer.
    fn kinds(self) -> &'static [ComponentKind] {
        match self {
            Layer::HeatShield => &[
                ComponentKind::ForebodyTps,
                ComponentKind::Bond,
                ComponentKind::AftbodyTps,
            ],
            Layer::Structure => &[
                ComponentKind::ForebodyCarrier,
                ComponentKind::AftbodyCarrier,
                ComponentKind::PrimaryStructure,
                ComponentKind::ImpactShell,
            ],
            Layer::Foam => &[
                ComponentKind::WingInsulation,
                ComponentKind::ImpactFoam,
                ComponentKind::BodyFoam,
                ComponentKind::LidInsulation,
            ],
            Layer::Payload => &[ComponentKind::Payload],
            Layer::Dimensions | Layer::CenterOfGravity => &[],
        }
    }
}

/// Drawing with its legend and the detail of the selected component.
#[component]
pub fn Drawing() -> impl IntoView {
    let view = VehicleView::expect();
    let hidden = RwSignal::new(Vec::<Layer>::new());
    let shows = move |layer: Layer| match layer.kinds() {
        [] => hidden.with(|hidden| !hidden.contains(&layer)),
        kinds => kinds.iter().any(|kind| view.shows(*kind)),
    };
    let toggle = move |layer: Layer| {
        let is_shown = untrack(|| shows(layer));
        match layer.kinds() {
            [] => hidden.update(|hidden| match is_shown {
                true => hidden.push(layer),
                false => hidden.retain(|other| *other != layer),
            }),
            kinds => view.hidden.update(|hidden| {
                hidden.retain(|kind| !kinds.contains(kind));
                if is_shown {
                    hidden.extend_from_slice(kinds);
                }
            }),
        }
    };
    let drawing = move || {
        view.vehicle.with(|vehicle| {
            let vehicle = vehicle.as_ref()?;
            let section = section(vehicle);
            Some(sheet(vehicle, &section, view, hidden).into_any())
        })
    };
    view! {
        <div class="vehicle">
            <div class="tools" role="group" aria-label="Layers of the drawing">
                {LAYERS.into_iter().map(|(layer, name)| view! {
                    <button type="button" class="small" aria-pressed=move || shows(layer).to_string()
                        on:click=move |_| toggle(layer)>{name}</button>
                }).collect_view()}
            </div>
            {drawing}
            <Legend />
            <Detail />
        </div>
    }
}

/// The SVG.
fn sheet(
    vehicle: &Vehicle,
    section: &Section,
    view: VehicleView,
    hidden: RwSignal<Vec<Layer>>,
) -> impl IntoView + use<> {
    let (lit, chosen, units) = (view.lit, view.chosen, view.units.get());
    let d = vehicle.dimensions;
    let r = section.radius_mm;
    let (left, right) = (-1.26 * r, 1.62 * r);
    let font = 0.084 * r;
    let lid_label_mm = lid_label_mm(section, font);
    let top = (section.top_mm - 0.14 * r).min(lid_label_mm - 1.3 * font);
    let bottom = section.bottom_mm + 0.54 * r;
    let shows = move |layer: Layer| hidden.with(|hidden| !hidden.contains(&layer));
    let description = describe(&d, units);
    let parts = section.parts.iter().enumerate().map(|(i, part)| {
        let kind = part.kind;
        let (fill, edges) = (part.fill.clone(), part.edges.clone());
        let (x, y) = part.label;
        let anchor = part.anchor;
        let is_lit = move || lit.get() == Some(kind) || chosen.get() == Some(kind);
        let dim = move || lit.get().is_some_and(|other| other != kind);
        view! {
            <g style:display=move || if view.shows(kind) { "" } else { "none" }>
                <path d=fill class=format!("part {}", class(kind)) class:dim=dim
                    on:pointerenter=move |_| lit.set(Some(kind))
                    on:pointerleave=move |_| lit.set(None)
                    on:click=move |_| view.choose(kind)>
                </path>
                <path d=edges class="edge" class:lit=is_lit></path>
                {anchor.map(|(ax, ay)| view! { <path class="leader" d=format!("M{ax:.2} {ay:.2}L{x:.2} {y:.2}")></path> })}
                <text class="number" x=x y=y font-size=font stroke-width=0.25 * font>{i + 1}</text>
            </g>
        }
    }).collect_view();
    let cg_mm = -d.cg_from_apex_m * 1e3;
    view! {
        <svg class="section" viewBox=format!("{left:.1} {top:.1} {:.1} {:.1}", right - left, bottom - top)
            role="img" aria-label=description>
            <path class="axis" d=format!("M0 {:.1}V{:.1}", section.top_mm - 0.1 * r, section.bottom_mm + 0.12 * r)></path>
            {parts}
            <path class="outline" d=section.outline.clone()></path>
            <g style:display=move || if shows(Layer::Dimensions) { "" } else { "none" } font-size=font>
                {dimension_lines(&d, section, units, left, font)}
                {angles(vehicle, section, left, font)}
                {lid(&d, section, units, left, font)}
                <text x=right - 0.3 * font y=bottom - 0.6 * font text-anchor="end">{cg_label(&d, units)}</text>
                {scale_bar(section, units, left, bottom, font)}
            </g>
            <g style:display=move || if shows(Layer::CenterOfGravity) { "" } else { "none" } font-size=font>
                <circle class="cg" cx="0" cy=cg_mm r=0.5 * font></circle>
                <path class="cg-quarter" d=quarters(cg_mm, 0.5 * font)></path>
                <text x=0.7 * font y=cg_mm class="number cg-label" text-anchor="start" stroke-width=0.25 * font>"CG"</text>
            </g>
        </svg>
    }
}

/// Opposite quarters of the center-of-gravity symbol.
fn quarters(y: f64, r: f64) -> String {
    format!(
        "M0 {y}V{}A{r} {r} 0 0 1 {r} {y}ZM0 {y}V{}A{r} {r} 0 0 1 {} {y}Z",
        y - r,
        y + r,
        -r
    )
}

/// A length in the displayed units.
fn length(meters: f64, units: UnitSystem) -> String {
    let unit = length_unit(units);
    format!(
        "{} {}",
        number(unit.from_canonical(meters), 3),
        symbol(unit)
    )
}

fn length_unit(units: UnitSystem) -> &'static Unit {
    let printed = output::find("diameter_m")
        .map_or(canonical(Dimension::Length), |output| output.shown_unit());
    units.unit(Dimension::Length, printed)
}

fn describe(d: &Dimensions, units: UnitSystem) -> String {
    let dimensions = dimensions(d, units);
    let mut letters = dimensions.chars();
    let first = letters.next().map(|first| first.to_lowercase().to_string());
    format!(
        "Section of the vehicle: {}{}",
        first.unwrap_or_default(),
        letters.as_str()
    )
}

/// Main dimensions in a sentence.
pub fn dimensions(d: &Dimensions, units: UnitSystem) -> String {
    format!(
        "Diameter {}, height {}, nose radius {}, shoulder radius {}, center of gravity {} behind the nose.",
        length(d.diameter_m, units),
        length(d.vehicle_height_m, units),
        length(d.nose_radius_m, units),
        length(d.shoulder_radius_m, units),
        length(d.cg_from_nose_m, units),
    )
}

fn dimension_lines(
    d: &Dimensions,
    section: &Section,
    units: UnitSystem,
    left: f64,
    font: f64,
) -> impl IntoView + use<> {
    let r = section.radius_mm;
    let y = section.bottom_mm + 0.26 * r;
    let x = 1.16 * r;
    let a = 0.35 * font;
    let (top, bottom) = (section.top_mm, section.bottom_mm);
    let middle = 0.5 * (top + bottom);
    let nose_r = d.nose_radius_m * 1e3;
    // on the nose sphere, 20 deg off the axis, to the left
    let (nx, ny) = (-nose_r * 0.342, section.bottom_mm - nose_r * (1.0 - 0.940));
    let shoulder_r = d.shoulder_radius_m * 1e3;
    let shoulder_y = section.shoulder_mm;
    view! {
        <g class="dimensions">
            <path class="dimension" d=format!("M{} {}V{}M{r} {}V{}M{} {y}H{r}", -r, shoulder_y + 0.03 * r, y + a, shoulder_y + 0.03 * r, y + a, -r)></path>
            <path class="arrow" d=format!("M{} {y}l{} {}v{}ZM{r} {y}l{} {}v{}Z", -r, 2.0 * a, -0.5 * a, a, -2.0 * a, -0.5 * a, a)></path>
            <text x="0" y=y + 1.15 * font text-anchor="middle">{format!("⌀ {}", length(d.diameter_m, units))}</text>
            <path class="dimension" d=format!("M{} {top}H{}M{} {bottom}H{}M{x} {top}V{bottom}", 0.05 * r, x + a, 0.05 * r, x + a)></path>
            <path class="arrow" d=format!("M{x} {top}l{} {}h{}ZM{x} {bottom}l{} {}h{}Z", -0.5 * a, 2.0 * a, a, -0.5 * a, -2.0 * a, a)></path>
            <text x=x + 0.4 * font y=middle text-anchor="start" dominant-baseline="central">{length(d.vehicle_height_m, units)}</text>
            <path class="leader" d=format!("M{nx} {ny}L{} {}", nx - 0.12 * r, ny + 0.1 * r)></path>
            <text x=nx - 0.14 * r y=ny + 0.14 * r text-anchor="end">{format!("nose R {}", length(d.nose_radius_m, units))}</text>
            <path class="leader" d=format!("M{} {}L{} {}", -r + 0.3 * shoulder_r, shoulder_y - 0.7 * shoulder_r, -r, shoulder_y - 0.22 * r)></path>
            <text x=left + 0.02 * r y=shoulder_y - 0.26 * r - 1.2 * font text-anchor="start">"shoulder"</text>
            <text x=left + 0.02 * r y=shoulder_y - 0.26 * r text-anchor="start">{format!("R {}", length(d.shoulder_radius_m, units))}</text>
        </g>
    }
}

/// Height of the lid's dimension: above the lid, or above the shoulder's dimension where that is higher.
fn lid_label_mm(section: &Section, font: f64) -> f64 {
    let shoulder = section.shoulder_mm - 0.26 * section.radius_mm - 2.6 * font;
    section.top_mm.min(shoulder)
}

fn cg_label(d: &Dimensions, units: UnitSystem) -> String {
    format!(
        "CG {} from nose, {} ⌀ from apex",
        length(d.cg_from_nose_m, units),
        number(d.cg_over_diameter, 3)
    )
}

/// Half-angle of the cone on the left, slope of the wing on the right.
fn angles(vehicle: &Vehicle, section: &Section, left: f64, font: f64) -> impl IntoView + use<> {
    let r = section.radius_mm;
    let outline = &vehicle.layout.outline;
    let on_screen = |x_m: f64, r_m: f64| (r_m * 1e3, -x_m * 1e3);
    let (fore, aft) = (
        outline.forebody.shoulder_tangent(0.0),
        outline.forebody.nose_tangent(0.0),
    );
    let cone = on_screen(
        0.4 * aft.x_m + 0.6 * fore.x_m,
        -(0.4 * aft.r_m + 0.6 * fore.r_m),
    );
    let cone_text = (cone.0 - 0.1 * r, cone.1 + 0.17 * r);
    let tip = outline.on_tip_line(outline.forebody.shoulder_radius_m);
    let edge_r_m = outline.annulus_outer_r_m(0.0);
    let wing = on_screen(
        0.5 * (tip.x_m + outline.attached_structure_x_m),
        0.5 * (tip.r_m + edge_r_m),
    );
    let wing_text = (1.12 * r, wing.1.min(section.shoulder_mm) - 0.24 * r);
    let deg = |angle_rad: f64| {
        let tenths = (10.0 * angle_rad.to_degrees()).round() / 10.0;
        format!("{tenths} deg")
    };
    view! {
        <path class="leader" d=format!("M{:.2} {:.2}L{:.2} {:.2}", cone.0, cone.1, cone_text.0, cone_text.1 - 0.5 * font)></path>
        <text x=(cone_text.0 + 0.1 * r).max(left + 4.5 * font) y=cone_text.1 + 0.4 * font text-anchor="end">
            {format!("cone {}", deg(outline.forebody.cone_half_angle_rad))}
        </text>
        <path class="leader" d=format!("M{:.2} {:.2}L{:.2} {:.2}", wing.0, wing.1, wing_text.0 - 2.0 * font, wing_text.1 + 0.3 * font)></path>
        <text x=wing_text.0 y=wing_text.1 text-anchor="end">{format!("wing {}", deg(outline.wing_slope_rad))}</text>
    }
}

/// Radius of the lid, on its left.
fn lid(
    d: &Dimensions,
    section: &Section,
    units: UnitSystem,
    left: f64,
    font: f64,
) -> impl IntoView + use<> {
    let lid_r = d.lid_radius_m * 1e3;
    // on the lid, 35 deg off the axis
    let (x, y) = (-0.574 * lid_r, section.top_mm + (1.0 - 0.819) * lid_r);
    let label = lid_label_mm(section, font);
    let text_x = left + 0.02 * section.radius_mm;
    view! {
        <path class="leader" d=format!("M{x:.2} {y:.2}L{:.2} {:.2}", text_x + 7.0 * font, label - 0.3 * font)></path>
        <text x=text_x y=label text-anchor="start">{format!("lid R {}", length(d.lid_radius_m, units))}</text>
    }
}

fn scale_bar(
    section: &Section,
    units: UnitSystem,
    left: f64,
    bottom: f64,
    font: f64,
) -> impl IntoView + use<> {
    let length_mm = scale_bar_mm(2.0 * section.radius_mm);
    let (x, y) = (left + 0.5 * font, bottom - 0.6 * font);
    let end = x + length_mm;
    view! {
        <path class="dimension" d=format!("M{x} {}V{y}H{end}V{}", y - 0.4 * font, y - 0.4 * font)></path>
        <text x=end + 0.4 * font y=y>{length(1e-3 * length_mm, units)}</text>
    }
}
