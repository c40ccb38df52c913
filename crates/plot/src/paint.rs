//! Drawing of shapes on a plotters backend.

use crate::compose::compose;
use crate::figure::Figure;
use crate::mapping::Mapping;
use crate::scene::{Anchor, Label, Point, Scene, Shape};
use crate::text::Weight;
use crate::theme::{Rgb, Theme};
use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind};
use plotters::element::{Circle, PathElement, Polygon, Text};
use plotters::prelude::DrawingBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{Color, FontDesc, FontFamily, FontStyle, RGBColor, ShapeStyle, TextStyle};

/// Size of a figure and units of the backend. Plotters uses integer coordinates, so that lines are smooth only where a
/// CSS px has several backend units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Width, CSS px.
    pub width_px: f64,
    /// Height, CSS px.
    pub height_px: f64,
    /// Backend units per CSS px.
    pub units_per_px: f64,
    /// Divisor that the backend applies to font sizes.
    pub font_divisor: f64,
    /// Downward shift needed to center text vertically, in font sizes.
    pub text_drop_em: f64,
}

impl Frame {
    /// For a backend that keeps font sizes and centers text, with `units_per_px` units per CSS px.
    pub fn new(width_px: f64, height_px: f64, units_per_px: f64) -> Self {
        Self {
            width_px,
            height_px,
            units_per_px,
            font_divisor: 1.0,
            text_drop_em: 0.0,
        }
    }
}

/// Draws a figure on any plotters backend and returns its mapping from data to px.
///
/// # Errors
/// Errors of the backend.
pub fn draw<DB: DrawingBackend>(
    figure: &Figure,
    theme: &Theme,
    frame: &Frame,
    area: &DrawingArea<DB, Shift>,
) -> Result<Mapping, DrawingAreaErrorKind<DB::ErrorType>> {
    let (scene, mapping) = compose(figure, theme, (frame.width_px, frame.height_px));
    paint(&scene, theme, frame, area)?;
    Ok(mapping)
}

fn paint<DB: DrawingBackend>(
    scene: &Scene,
    theme: &Theme,
    frame: &Frame,
    area: &DrawingArea<DB, Shift>,
) -> Result<(), DrawingAreaErrorKind<DB::ErrorType>> {
    let unit = |px: f64| (px * frame.units_per_px).round() as i32;
    let place = |(x, y): &Point| (unit(*x), unit(*y));
    let places = |points: &[Point]| points.iter().map(place).collect::<Vec<_>>();
    for shape in &scene.shapes {
        match shape {
            Shape::Path {
                points,
                color,
                width_px,
            } => {
                let style = rgb(*color).stroke_width(unit(*width_px).max(1) as u32);
                area.draw(&PathElement::new(places(points), style))?;
            }
            Shape::Fill {
                points,
                color,
                opacity,
            } => {
                let style = ShapeStyle::from(&rgb(*color).mix(*opacity)).filled();
                area.draw(&Polygon::new(places(points), style))?;
            }
            Shape::Dot {
                at,
                radius_px,
                color,
            } => {
                area.draw(&Circle::new(
                    place(at),
                    unit(*radius_px),
                    rgb(*color).filled(),
                ))?;
            }
            Shape::Text(label) => {
                let Label {
                    text, at, size_px, ..
                } = label;
                let at = place(&(at.0, at.1 + frame.text_drop_em * size_px));
                area.draw(&Text::new(
                    text.as_str(),
                    at,
                    text_style(label, theme, frame),
                ))?;
            }
        }
    }
    Ok(())
}

fn rgb(Rgb(r, g, b): Rgb) -> RGBColor {
    RGBColor(r, g, b)
}

fn text_style<'a>(label: &Label, theme: &'a Theme, frame: &Frame) -> TextStyle<'a> {
    let style = match label.weight {
        Weight::Normal => FontStyle::Normal,
        Weight::Bold => FontStyle::Bold,
    };
    let h_pos = match label.anchor {
        Anchor::Start => HPos::Left,
        Anchor::Middle => HPos::Center,
        Anchor::End => HPos::Right,
    };
    // integers also give shorter text
    let size = (label.size_px * frame.units_per_px).round() * frame.font_divisor;
    let family = FontFamily::Name(&theme.font_family);
    TextStyle {
        font: FontDesc::new(family, size, style),
        color: rgb(label.color).to_backend_color(),
        pos: Pos::new(h_pos, VPos::Center),
    }
}
