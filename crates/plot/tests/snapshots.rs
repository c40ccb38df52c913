//! Figures as SVG, compared byte for byte with `tests/snapshots`. `UPDATE_SNAPSHOTS=1` rewrites them.

use msape_plot::{
    Aspect, Axis, Cursor, EventLine, Figure, Kind, LimitLine, Scale, Series, Side, Style, Theme,
    svg,
};
use numerics::math::{exp, ln, pow, sin};
use std::path::Path;

/// An invented entry: time s, altitude km, speed km/s, heat flux W/cm², deceleration g.
fn entry() -> Vec<[f64; 5]> {
    let (mut altitude, mut speed, mut rows) = (125.0, 12.0, Vec::new());
    for i in 0..1300_u32 {
        let t = f64::from(i) * 0.5;
        let density = 1.225 * exp(-altitude / 7.2);
        let g = density * speed * speed * 1e6 / (2.0 * 60.0) / 9.81;
        let heat = 1.74e-8 * (density / 0.3_f64).sqrt() * pow(speed * 1e3, 3.0);
        rows.push([t, altitude, speed, heat, g]);
        speed = (speed - (g - 0.3) * 9.81e-3 * 0.5).max(0.03);
        altitude = (altitude - speed * 0.14 * 0.5 - 0.03).max(0.0);
    }
    rows
}

fn column(rows: &[[f64; 5]], x: usize, y: usize) -> Vec<(f64, f64)> {
    rows.iter().map(|r| (r[x], r[y])).collect()
}

fn event(x: f64, label: &str) -> EventLine {
    EventLine {
        x,
        label: label.to_owned(),
    }
}

fn events() -> Vec<EventLine> {
    [
        (30.0, "peak deceleration"),
        (24.5, "peak heat flux"),
        (33.0, "peak dynamic pressure"),
        (46.0, "Mach 5"),
        (58.0, "Mach 2"),
        (63.0, "Mach 1.4"),
        (72.0, "Mach 0.8"),
        (649.0, "ground"),
    ]
    .into_iter()
    .map(|(x, label)| event(x, label))
    .collect()
}

fn altitude() -> Figure {
    Figure {
        title: Some("MSR Earth entry vehicle".to_owned()),
        description: "Altitude falls steeply for a minute, then slowly.".to_owned(),
        x: Axis::new("Time", "s"),
        y: Axis::new("Altitude", "km"),
        series: vec![Series::line("Altitude", column(&entry(), 0, 1), 0)],
        events: events(),
        ..Figure::default()
    }
}

fn heating() -> Figure {
    let rows = entry();
    let scaled = |name: &str, factor: f64, index| {
        let points = column(&rows, 0, 3)
            .iter()
            .map(|(x, y)| (*x, y * factor))
            .collect();
        Series::line(name, points, index)
    };
    let radiative = column(&rows, 0, 3)
        .iter()
        .map(|(x, y)| (*x, 1e-3 * y * y))
        .collect();
    Figure {
        x: Axis::new("Time", "s").with_range(0.0, 90.0),
        y: Axis::new("Heat flux", "W/cm²"),
        series: vec![
            scaled("Convective", 1.0, 0),
            Series::line("Radiative", radiative, 1),
            scaled("Total with margin", 1.3, 2),
        ],
        limits: vec![LimitLine {
            y: 1200.0,
            label: "PICA limit, 1200 W/cm²".to_owned(),
        }],
        events: events(),
        cursor: Some(Cursor::X(28.0)),
        ..Figure::default()
    }
}

fn two_axes() -> Figure {
    let rows = entry();
    let mut right = Series::line("Speed", column(&rows, 0, 2), 1);
    right.side = Side::Right;
    Figure {
        x: Axis::new("Time", "s").with_range(0.0, 120.0),
        y: Axis::new("Deceleration", "Earth g"),
        y2: Some(Axis::new("Speed relative to the planet", "km/s")),
        series: vec![Series::line("Deceleration", column(&rows, 0, 4), 0), right],
        events: vec![event(30.0, "peak deceleration")],
        ..Figure::default()
    }
}

fn atmosphere() -> Figure {
    let points = (0..=200).map(|i| {
        let h = f64::from(i);
        (1.225 * exp(-h / 7.2) + 1e-9 * exp(-h / 40.0), h)
    });
    Figure {
        x: Axis::new("Density", "kg/m³").with_scale(Scale::Log),
        y: Axis::new("Altitude", "km"),
        series: vec![Series::line("US 1976", points.collect(), 0)],
        ..Figure::default()
    }
}

fn altitude_over_speed() -> Figure {
    Figure {
        x: Axis::new("Relative velocity", "km/s"),
        y: Axis::new("Altitude", "km"),
        series: vec![Series::line("a", column(&entry(), 2, 1), 0)],
        cursor: Some(Cursor::Point(8.0, 55.0)),
        ..Figure::default()
    }
}

fn scatter() -> Figure {
    let cloud = |seed: f64| {
        (0..300)
            .map(|i| {
                let a = sin(f64::from(i) * 12.9898 + seed) * 43_758.545_3;
                let b = sin(f64::from(i) * 78.233 + seed) * 12_543.123;
                let (a, b) = (a - a.floor(), b - b.floor());
                (30.0 + 20.0 * a + seed, 900.0 + 800.0 * a * b + 50.0 * seed)
            })
            .collect()
    };
    let points = |name: &str, seed, index| Series {
        style: Style {
            kind: Kind::Points,
            marker: Some(msape_plot::Marker::nth(index)),
            ..Style::nth(index)
        },
        ..Series::line(name, cloud(seed), index)
    };
    Figure {
        title: Some("Trade space".to_owned()),
        x: Axis::new("Total entry mass", "kg"),
        y: Axis::new("Peak convective heat flux", "W/cm²"),
        series: vec![points("PICA", 0.0, 0), points("Carbon phenolic", 9.0, 1)],
        ..Figure::default()
    }
}

fn many() -> Figure {
    let line = |i: usize| {
        let k = i as f64;
        let points = (0..=60).map(|n| {
            let x = f64::from(n) / 10.0;
            (
                x,
                exp(-x / (1.0 + k)) * (1.0 + 0.2 * sin(3.0 * x + k)) + 0.1 * k,
            )
        });
        Series::line(
            format!("Entry angle −{} deg", 5 + 2 * i),
            points.collect(),
            i,
        )
    };
    Figure {
        x: Axis::new("Range", "Mm"),
        y: Axis::new("Ratio", ""),
        series: (0..8).map(line).collect(),
        ..Figure::default()
    }
}

fn to_scale() -> Figure {
    let arc = (0..=90).map(|i| {
        let a = f64::from(i) * std::f64::consts::PI / 90.0;
        (0.45 * sin(a), 0.45 * sin(a - std::f64::consts::FRAC_PI_2))
    });
    let cone = vec![
        (0.05, 0.0),
        (0.3, 0.45),
        (0.36, 0.40),
        (0.5, 0.1),
        (0.5, 0.0),
    ];
    let area = |name: &str, points, index| Series {
        style: Style {
            kind: Kind::Area,
            ..Style::nth(index)
        },
        ..Series::line(name, points, index)
    };
    Figure {
        x: Axis::new("x", "m"),
        y: Axis::new("r", "m"),
        series: vec![area("Sphere", arc.collect(), 0), area("Vehicle", cone, 1)],
        aspect: Aspect::Equal,
        ..Figure::default()
    }
}

fn gaps() -> Figure {
    let points = (0..=100).map(|i| {
        let x = f64::from(i) / 10.0;
        let y = if (40..50).contains(&i) {
            f64::NAN
        } else {
            ln(x + 0.1) * 1e6
        };
        (x, y)
    });
    Figure {
        x: Axis::new("Time", "s"),
        y: Axis::new("Stagnation pressure", "Pa"),
        series: vec![Series::line("a", points.collect(), 0)],
        ..Figure::default()
    }
}

fn empty() -> Figure {
    Figure {
        x: Axis::new("Time", "s"),
        y: Axis::new("Altitude", "km"),
        series: vec![Series::line("a", vec![(f64::NAN, 1.0)], 0)],
        ..Figure::default()
    }
}

/// Compares a figure with the committed file, or rewrites the file.
fn check(name: &str, figure: &Figure, theme: &Theme, (width, height): (u32, u32)) {
    let now = svg(figure, theme, width, height);
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/snapshots")
        .join(format!("{name}.svg"));
    if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
        std::fs::write(&path, &now).unwrap();
    }
    let before = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        now == before,
        "{name}.svg differs; UPDATE_SNAPSHOTS=1 rewrites it"
    );
}

const PAGE: (u32, u32) = (800, 500);
const PHONE: (u32, u32) = (320, 240);

#[test]
fn altitude_with_events() {
    check("altitude", &altitude(), &Theme::light(), PAGE);
    check("altitude-phone", &altitude(), &Theme::light(), PHONE);
}

#[test]
fn heating_with_limit_and_cursor() {
    check("heating-dark", &heating(), &Theme::dark(), PAGE);
    check("heating-phone", &heating(), &Theme::light(), PHONE);
}

#[test]
fn two_vertical_axes() {
    check("two-axes", &two_axes(), &Theme::light(), (600, 360));
    check("two-axes-phone", &two_axes(), &Theme::dark(), PHONE);
}

#[test]
fn logarithmic_axis() {
    check("atmosphere", &atmosphere(), &Theme::light(), (500, 400));
}

#[test]
fn cross_hair() {
    check(
        "altitude-over-speed",
        &altitude_over_speed(),
        &Theme::dark(),
        (480, 320),
    );
}

#[test]
fn point_clouds() {
    check("scatter", &scatter(), &Theme::light(), (600, 400));
}

#[test]
fn eight_series() {
    check("many", &many(), &Theme::light(), (700, 420));
    check(
        "many-contrast",
        &many(),
        &Theme::high_contrast_dark(),
        (360, 300),
    );
}

#[test]
fn drawing_to_scale() {
    check("to-scale", &to_scale(), &Theme::light(), (500, 360));
}

#[test]
fn gaps_and_powers_of_ten() {
    check("gaps", &gaps(), &Theme::light(), (400, 280));
}

#[test]
fn nothing_to_show() {
    check("empty", &empty(), &Theme::light(), PHONE);
}

#[test]
fn same_figure_gives_the_same_bytes() {
    let draw = || svg(&heating(), &Theme::light(), 640, 400);
    assert_eq!(draw(), draw());
}
