//! SVG: the section through the axis on an A4 sheet, to scale, with dimensions, legend and title block; light and dark.
//!
//! One unit is a millimeter on the sheet. The nose is on the left; the lower half mirrors the upper.

mod callout;
mod path;

use crate::export::Info;
use crate::export::model::Model;
use callout::{Callout, Side};
use msape::vehicle::segment::Point;
use path::View;

/// Sheet size, mm.
const SHEET: [f64; 2] = [297.0, 210.0];
/// Box that the section must fit into: left, top, width, height, mm.
const BOX: [f64; 4] = [66.0, 18.0, 90.0, 150.0];
/// Left edge of legend and title block, mm.
const COLUMN: f64 = 212.0;
/// Scales within a decade.
const SCALES: [f64; 9] = [1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0];
/// Characters that fit into the column, for the two font sizes.
const LETTERS: [usize; 2] = [44, 54];

const STYLE: &str = "\
:root{--paper:#fff;--ink:#1a1a1a;--soft:#5c5c5c;--line:#444}\
@media (prefers-color-scheme:dark){:root{--paper:#15181c;--ink:#ececec;--soft:#a9b0b8;--line:#b8bec6}}\
.paper{fill:var(--paper)}\
text{font:3.2px system-ui,sans-serif;fill:var(--ink)}\
.small{font-size:2.6px;fill:var(--soft)}\
.title{font-size:4.4px;font-weight:600}\
.part path{fill-rule:evenodd}\
.part .edge{fill:none;stroke:var(--paper);stroke-width:.08}\
.outline{fill:none;stroke:var(--ink);stroke-width:.35}\
.thin{fill:none;stroke:var(--line);stroke-width:.18}\
.axis{stroke-dasharray:6 1.2 .8 1.2}\
.arrow{fill:var(--line)}\
.solid{fill:var(--ink)}\
.hollow{fill:var(--paper);stroke:var(--ink);stroke-width:.2}";

/// The model as the text of an SVG file.
pub fn svg(model: &Model, info: &Info) -> String {
    let view = view(model);
    let [width, height] = SHEET;
    let title = escaped(&model.name);
    let description = format!(
        "Section through the axis of {title}, scale 1:{}, dimensions in millimeters.",
        view.scale
    );
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}mm\" height=\"{height}mm\" \
         viewBox=\"0 0 {width} {height}\" role=\"img\" aria-labelledby=\"title description\">\n\
         <title id=\"title\">{title}</title>\n<desc id=\"description\">{description}</desc>\n\
         <style>{STYLE}</style>\n<rect class=\"paper\" width=\"{width}\" height=\"{height}\"/>\n"
    );
    for part in &model.parts {
        let [red, green, blue] = part.color;
        text.push_str(&format!(
            "<g class=\"part\" id=\"{}\" fill=\"#{red:02x}{green:02x}{blue:02x}\"><title>{}</title>\n",
            part.key,
            escaped(&about(part).join(", "))
        ));
        for profile in &part.profiles {
            for half in [1.0, -1.0] {
                // outline of this half without the axis
                let (body, edge) = (view.path(profile, half), view.open_path(profile, half));
                text.push_str(&format!(
                    "<path d=\"{body}\"/>\n<path class=\"edge\" d=\"{edge}\"/>\n"
                ));
            }
        }
        text.push_str("</g>\n");
    }
    for half in [1.0, -1.0] {
        let path = view.open_path(&model.outline, half);
        text.push_str(&format!("<path class=\"outline\" d=\"{path}\"/>\n"));
    }
    text.push_str(&dimensions(model, &view));
    text.push_str(&legend(model));
    text.push_str(&title_block(model, &view, info));
    text.push_str("</svg>\n");
    text
}

/// Placement of the section: the largest scale of the list that fits, centered in the box.
fn view(model: &Model) -> View {
    let [nose, aft, widest] = model.extent_m();
    let [left, top, width, height] = BOX;
    let needed = (1000.0 * (aft - nose) / width).max(2000.0 * widest / height);
    let decades = [0.01, 0.1, 1.0, 10.0, 100.0, 1000.0];
    let scale = decades
        .iter()
        .flat_map(|decade| SCALES.map(|s| (s * decade * 1000.0).round() / 1000.0))
        .find(|&scale| scale >= needed)
        .unwrap_or(needed);
    let shift = (width - 1000.0 * (aft - nose) / scale) / 2.0;
    View {
        scale,
        nose_x_m: nose,
        left_mm: left + shift,
        axis_mm: top + height / 2.0,
    }
}

/// Dimension lines, callouts, axis and center of gravity.
fn dimensions(model: &Model, view: &View) -> String {
    let [nose, aft, widest] = model.extent_m();
    let at = |x_m, r_m| view.at(Point { x_m, r_m }, 1.0);
    let ([left, axis], [right, _]) = (at(nose, 0.0), at(aft, 0.0));
    let [wide_x, top] = view.at(path::widest(&model.outline), 1.0);
    let bottom = 2.0 * axis - top;
    let mm = |length_m: f64| format!("{:.1}", length_m * 1000.0);
    let mut text = line("thin axis", [left - 8.0, axis], [right + 8.0, axis]);
    // diameter, ahead of the nose
    let x = left - 10.0;
    for y in [top, bottom] {
        text.push_str(&line("thin", [x - 1.5, y], [wide_x, y]));
    }
    text.push_str(&line("thin", [x, top], [x, bottom]));
    text.push_str(&arrow([x, top], [0.0, -1.0]));
    text.push_str(&arrow([x, bottom], [0.0, 1.0]));
    text.push_str(&format!(
        "<text transform=\"translate({:.3} {:.3}) rotate(-90)\" text-anchor=\"middle\">⌀ {}</text>\n",
        x - 1.2,
        axis + (bottom - axis) / 2.0,
        mm(2.0 * widest)
    ));
    // length, below
    let y = bottom + 9.0;
    for x in [left, right] {
        text.push_str(&line("thin", [x, axis], [x, y + 1.5]));
    }
    text.push_str(&line("thin", [left, y], [right, y]));
    text.push_str(&arrow([left, y], [-1.0, 0.0]));
    text.push_str(&arrow([right, y], [1.0, 0.0]));
    text.push_str(&label(
        "middle",
        [(left + right) / 2.0, y - 1.2],
        &mm(aft - nose),
    ));
    let (mut fore, mut behind) = (Vec::new(), Vec::new());
    for callout in callout::callouts(model) {
        match callout.side {
            Side::Fore => fore.push(callout),
            Side::Aft => behind.push(callout),
        }
    }
    text.push_str(&column(&fore, view, x - 8.0, "end"));
    text.push_str(&column(&behind, view, right + 16.0, "start"));
    if let Some(cg) = model.measures.cg_x_m {
        let [x, y] = at(cg, 0.0);
        text.push_str(&format!(
            "<circle class=\"hollow\" cx=\"{x:.3}\" cy=\"{y:.3}\" r=\"1.8\"/>\n\
             <path class=\"solid\" d=\"M{x:.3} {y:.3}v-1.8a1.8 1.8 0 0 1 1.8 1.8zm0 0v1.8a1.8 1.8 0 0 1 -1.8 -1.8z\"/>\n"
        ));
        let to = [right + 14.0, axis + 12.0];
        text.push_str(&line("thin", [x + 1.3, y + 1.3], to));
        let words = format!("CG {} from the nose", mm(cg - nose));
        text.push_str(&label("start", [to[0] + 1.0, to[1] + 1.0], &words));
    }
    text
}

/// Callouts stacked in the order of their points, with leaders.
fn column(callouts: &[Callout], view: &View, x: f64, anchor: &str) -> String {
    let mut rows: Vec<([f64; 2], &str)> = callouts
        .iter()
        .map(|c| (view.at(c.at, 1.0), c.words.as_str()))
        .collect();
    rows.sort_by(|(a, _), (b, _)| a[1].total_cmp(&b[1]));
    let gap = if anchor == "end" { 1.0 } else { -1.0 };
    let mut last = f64::NEG_INFINITY;
    let mut text = String::new();
    for (point, words) in rows {
        let y = (point[1] - 4.0).max(last + 6.0);
        last = y;
        text.push_str(&line("thin", point, [x + gap, y - 1.0]));
        text.push_str(&format!(
            "<circle class=\"arrow\" cx=\"{:.3}\" cy=\"{:.3}\" r=\".5\"/>\n",
            point[0], point[1]
        ));
        text.push_str(&label(anchor, [x, y], words));
    }
    text
}

fn about(part: &crate::export::model::Part) -> Vec<String> {
    let mut words = vec![part.name.clone()];
    if let Some(substance) = &part.substance {
        words.push(substance.material.clone());
        words.push(format!("{:.0} kg/m³", substance.density_kg_m3));
    }
    words
}

fn legend(model: &Model) -> String {
    let mut text = String::new();
    let mut y = 20.0;
    for part in &model.parts {
        let [red, green, blue] = part.color;
        text.push_str(&format!(
            "<rect x=\"{COLUMN}\" y=\"{:.3}\" width=\"5\" height=\"5\" fill=\"#{red:02x}{green:02x}{blue:02x}\"/>\n",
            y - 3.6
        ));
        let words = about(part);
        text.push_str(&label("start", [COLUMN + 7.0, y], &part.name));
        if let Some(rest) = words.get(1..).filter(|rest| !rest.is_empty()) {
            text.push_str(&small([COLUMN + 7.0, y + 3.6], &rest.join(", ")));
        }
        y += 10.5;
    }
    text
}

/// Title block: name, scale with scale bar, mass.
fn title_block(model: &Model, view: &View, info: &Info) -> String {
    let top = 170.0;
    let mut text = line("thin", [COLUMN, top], [SHEET[0] - 10.0, top]);
    text.push_str(&format!(
        "<text class=\"title\" x=\"{COLUMN}\" y=\"{:.3}\">{}</text>\n",
        top + 6.5,
        escaped(&cut(&model.name, LETTERS[0] * 7 / 10))
    ));
    let mut words = format!("Section through the axis, 1:{}, mm", view.scale);
    if let Some(mass) = model.measures.mass_kg {
        words.push_str(&format!(", {mass:.2} kg"));
    }
    text.push_str(&label("start", [COLUMN, top + 12.5], &words));
    text.push_str(&small([COLUMN, top + 17.0], info.program));
    // the longest round length that takes at most 60 mm on the sheet
    let most = 60.0 * view.scale;
    let length = [0.1, 1.0, 10.0, 100.0, 1000.0, 10_000.0]
        .iter()
        .flat_map(|decade| [1.0, 2.0, 5.0].map(|s| s * decade))
        .filter(|&length| length <= most)
        .fold(0.1, f64::max);
    let (y, end) = (top + 25.0, COLUMN + length / view.scale);
    text.push_str(&line("thin", [COLUMN, y], [end, y]));
    for share in [0.0, 0.5, 1.0] {
        let x = COLUMN + share * (end - COLUMN);
        text.push_str(&line("thin", [x, y - 1.2], [x, y + 1.2]));
        let words = format!("{}", share * length);
        text.push_str(&format!(
            "<text class=\"small\" x=\"{x:.3}\" y=\"{:.3}\" text-anchor=\"middle\">{words}</text>\n",
            y + 4.2
        ));
    }
    text
}

fn line(class: &str, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) -> String {
    format!("<path class=\"{class}\" d=\"M{x0:.3} {y0:.3}L{x1:.3} {y1:.3}\"/>\n")
}

/// Arrowhead with its tip at a point.
fn arrow([x, y]: [f64; 2], [ux, uy]: [f64; 2]) -> String {
    let (back, wide) = (2.6, 0.45);
    let side = |s: f64| [x - back * ux - s * wide * uy, y - back * uy + s * wide * ux];
    let ([ax, ay], [bx, by]) = (side(1.0), side(-1.0));
    format!("<path class=\"arrow\" d=\"M{x:.3} {y:.3}L{ax:.3} {ay:.3}L{bx:.3} {by:.3}Z\"/>\n")
}

fn label(anchor: &str, [x, y]: [f64; 2], words: &str) -> String {
    let words = escaped(&cut(words, LETTERS[0]));
    format!("<text x=\"{x:.3}\" y=\"{y:.3}\" text-anchor=\"{anchor}\">{words}</text>\n")
}

fn small([x, y]: [f64; 2], words: &str) -> String {
    let words = escaped(&cut(words, LETTERS[1]));
    format!("<text class=\"small\" x=\"{x:.3}\" y=\"{y:.3}\">{words}</text>\n")
}

/// Text shortened to a number of characters.
fn cut(words: &str, most: usize) -> String {
    if words.chars().count() <= most {
        return words.to_owned();
    }
    let kept: String = words.chars().take(most.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}

/// Text with markup escaped and characters that XML does not allow removed.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            // noncharacters, not allowed in XML
            '\u{fffe}' | '\u{ffff}' => {}
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

#[cfg(test)]
mod tests;
