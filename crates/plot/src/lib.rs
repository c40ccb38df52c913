//! Figures: one description, drawn on any plotters backend.
//!
//! A [`Figure`] describes the content: axes, series, event and limit lines, cursor. A [`Theme`] describes the style.
//! They are drawn by
//!
//! - [`svg`]: an SVG document, the same bytes everywhere, for tests, reports and exports;
//! - `canvas`: an HTML canvas, in the browser only;
//! - [`draw`]: any other plotters backend;
//! - [`csv`], [`table`] and [`summary`]: the data as a file, as a table and in words.
//!
//! Text is measured with a built-in table of widths: layout needs no font, file or DOM, and is the same everywhere.
//! Sizes are CSS px.
//!
//! ```
//! use msape_plot::{Axis, Figure, Series, Theme, svg};
//!
//! let figure = Figure {
//!     x: Axis::new("Time", "s"),
//!     y: Axis::new("Altitude", "km"),
//!     series: vec![Series::line("Stardust", vec![(0.0, 135.0), (50.0, 60.0), (300.0, 10.0)], 0)],
//!     ..Figure::default()
//! };
//! let text = svg(&figure, &Theme::light(), 640, 400);
//! assert!(text.contains("Altitude (km)"));
//! ```
//!
//! Deliberately absent: font rendering, animation, interaction. A page places its cursor with the [`Mapping`] that
//! drawing returns, and reads values with [`readings`].

mod annotation;
mod compose;
mod csv;
mod event;
mod figure;
mod layout;
mod legend;
mod line;
mod mapping;
mod marker;
mod number;
mod paint;
mod painter;
mod range;
mod reading;
mod scene;
mod summary;
mod svg;
mod table;
mod text;
mod theme;
mod tick;

#[cfg(feature = "canvas")]
mod canvas;
#[cfg(feature = "canvas")]
pub use canvas::{CanvasSize, canvas};

pub use csv::csv;
pub use figure::{
    Aspect, Axis, Cursor, Dash, EventLine, Figure, Kind, LimitLine, Marker, Scale, Series, Side,
    Style,
};
pub use mapping::{AxisMap, Mapping, Rect};
pub use paint::{Frame, draw};
pub use reading::{Reading, readings};
pub use summary::summary;
pub use svg::svg;
pub use table::{Table, table};
pub use theme::{Rgb, Theme};
pub use tick::{Tick, ticks};
