//! Figures of a database: curves, axes and marks.

use msape::aero::bridging::{CONTINUUM, FREE_MOLECULAR};
use msape::aero::coefficient::{Coefficient, Origin};
use msape::aero::database::Regime;
use msape_kit::display::input_number;
use msape_plot::{Axis, EventLine, Figure, Kind, LimitLine, Marker, Scale, Series, Style};
use msape_worker::questions::curves::{Curves, Family, Line};

/// Horizontal axis of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Angle of attack.
    Alpha,
    /// Mach number.
    Mach,
    /// Knudsen number.
    Knudsen,
}

impl Over {
    /// Heading of a coefficient over this axis.
    pub fn title(self, coefficient: Coefficient) -> String {
        let over = match self {
            Over::Alpha => "angle of attack",
            Over::Mach => "Mach number",
            Over::Knudsen => "Knudsen number",
        };
        format!("{} over {over}", coefficient.label())
    }

    fn axis(self) -> Axis {
        match self {
            Over::Alpha => Axis::new("Angle of Attack", "deg").with_range(0.0, 180.0),
            Over::Mach => Axis::new("Mach Number", "").with_scale(Scale::Log),
            Over::Knudsen => Axis::new("Knudsen Number", "").with_scale(Scale::Log),
        }
    }
}

/// Mach numbers at which the database changes its sources, with the regime that begins there.
const MACH_MARKS: [(f64, &str); 3] = [(0.5, "transonic"), (1.5, "supersonic"), (5.0, "hypersonic")];
/// Knudsen numbers at which it changes its sources.
const KNUDSEN_MARKS: [(f64, &str); 2] = [
    (CONTINUUM, "transitional"),
    (FREE_MOLECULAR, "free-molecular"),
];

/// Name of a curve at a Mach number.
pub fn mach_name(mach: f64) -> String {
    format!("Mach {}", input_number(mach))
}

/// Name of a curve at a Knudsen number.
pub fn knudsen_name(knudsen: f64) -> String {
    format!("Kn {}", input_number(knudsen))
}

fn angle_name(alpha_deg: f64) -> String {
    format!("{} deg", input_number(alpha_deg))
}

/// Names of the curves over the angle of attack.
pub fn family_names(curves: &Curves) -> Vec<String> {
    let name = |mach: f64, knudsen: f64| match curves.places.family {
        Family::Mach => mach_name(mach),
        Family::Knudsen => knudsen_name(knudsen),
    };
    curves
        .over_alpha
        .iter()
        .map(|curve| name(curve.mach, curve.knudsen))
        .collect()
}

/// Figure of a coefficient; trim is marked on the moment about the center of gravity.
pub fn figure(curves: &Curves, coefficient: Coefficient, over: Over) -> Figure {
    let lines = match over {
        Over::Alpha => {
            let names = family_names(curves);
            let line = |(index, name): (usize, String)| {
                let rows = &curves.over_alpha.get(index)?.polar.rows;
                let points = rows
                    .iter()
                    .map(|row| (row.alpha_deg, coefficient.of(row).unwrap_or(f64::NAN)));
                Some(Series::line(name, points.collect(), index))
            };
            names.into_iter().enumerate().filter_map(line).collect()
        }
        Over::Mach => of_lines(&curves.over_mach, coefficient),
        Over::Knudsen => of_lines(&curves.over_knudsen, coefficient),
    };
    let mut figure = Figure {
        x: over.axis(),
        y: Axis::new(coefficient.symbol(), ""),
        series: lines,
        events: marks(curves, over),
        ..Figure::default()
    };
    if matches!(coefficient, Coefficient::CmCg | Coefficient::Cmq) {
        figure.limits.push(LimitLine {
            y: 0.0,
            label: String::new(),
        });
    }
    if coefficient == Coefficient::CmCg && over == Over::Alpha {
        let points = |stable: bool| {
            let trims = curves.over_alpha.iter().flat_map(|curve| &curve.polar.trim);
            trims
                .filter(|trim| trim.is_stable() == stable)
                .map(|trim| (trim.alpha_deg, 0.0))
                .collect::<Vec<_>>()
        };
        for (name, stable, marker) in [
            ("stable trim", true, Marker::Circle),
            ("unstable trim", false, Marker::Cross),
        ] {
            let points = points(stable);
            if !points.is_empty() {
                figure.series.push(Series {
                    name: name.to_string(),
                    points,
                    style: Style {
                        color: if stable { 2 } else { 1 },
                        marker: Some(marker),
                        kind: Kind::Points,
                        ..Style::default()
                    },
                    ..Series::default()
                });
            }
        }
    }
    figure
}

fn of_lines(lines: &[Line], coefficient: Coefficient) -> Vec<Series> {
    let series = |(index, line): (usize, &Line)| {
        let values = line
            .rows
            .iter()
            .map(|row| coefficient.of(row).unwrap_or(f64::NAN));
        let points = line.x.iter().copied().zip(values).collect();
        Series::line(angle_name(line.alpha_deg), points, index)
    };
    lines.iter().enumerate().map(series).collect()
}

fn marks(curves: &Curves, over: Over) -> Vec<EventLine> {
    let marks: &[(f64, &str)] = match over {
        _ if curves.is_table => &[],
        Over::Alpha => &[],
        // the Mach number has no effect in free-molecular flow
        Over::Mach
            if curves
                .places
                .knudsen
                .first()
                .is_some_and(|k| *k > CONTINUUM) =>
        {
            &[]
        }
        Over::Mach => &MACH_MARKS,
        Over::Knudsen => &KNUDSEN_MARKS,
    };
    let mark = |(x, label): &(f64, &str)| EventLine {
        x: *x,
        label: label.to_string(),
    };
    marks.iter().map(mark).collect()
}

/// Part of a figure and the origin of its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Curve or part of it.
    pub part: String,
    /// Origins.
    pub origins: Vec<(Origin, String)>,
}

/// Mach numbers within each continuum regime.
const WITHIN: [f64; 4] = [0.3, 1.0, 3.0, 20.0];

/// Regime of a computed database at a Mach and a Knudsen number.
fn regime_at(mach: f64, knudsen: f64) -> Regime {
    match knudsen {
        k if k >= FREE_MOLECULAR => Regime::FreeMolecular,
        k if k > CONTINUUM => Regime::Transitional,
        _ => Regime::of_mach(mach),
    }
}

/// Origins of the numbers of a figure, by part.
pub fn sources(curves: &Curves, coefficient: Coefficient, over: Over) -> Vec<Source> {
    let of = |part: String, regime: Regime, mach: f64| Source {
        part,
        origins: origins(curves, coefficient, regime, mach),
    };
    let first = |list: &[f64], otherwise: f64| list.first().copied().unwrap_or(otherwise);
    let places: Vec<(f64, f64)> = match over {
        Over::Alpha => {
            let named = curves.over_alpha.iter().zip(family_names(curves));
            let source = named.map(|(curve, name)| of(name, curve.regime, curve.mach));
            return source.collect();
        }
        _ if curves.is_table && coefficient != Coefficient::Cmq => {
            return vec![of("All".to_string(), Regime::Table, 1.0)];
        }
        Over::Mach => {
            let knudsen = first(&curves.places.knudsen, 0.0);
            WITHIN.map(|mach| (mach, knudsen)).to_vec()
        }
        Over::Knudsen => {
            let mach = first(&curves.places.mach, 20.0);
            let middle = (CONTINUUM * FREE_MOLECULAR).sqrt();
            [0.0, middle, FREE_MOLECULAR]
                .map(|knudsen| (mach, knudsen))
                .to_vec()
        }
    };
    let mut sources: Vec<Source> = places
        .into_iter()
        .map(|(mach, knudsen)| {
            let regime = regime_at(mach, knudsen);
            of(capital(regime.name()), regime, mach)
        })
        .collect();
    sources.dedup();
    sources
}

fn origins(
    curves: &Curves,
    coefficient: Coefficient,
    regime: Regime,
    mach: f64,
) -> Vec<(Origin, String)> {
    use msape_worker::questions::curves::DampingOrigin;
    let regime = match (coefficient, curves.damping) {
        (Coefficient::Cmq, DampingOrigin::Absent) => {
            return vec![(Origin::Assumed, "none, taken as zero".to_string())];
        }
        (Coefficient::Cmq, DampingOrigin::Table) => {
            return vec![(Origin::Given, Origin::Given.name().to_string())];
        }
        // a table of static coefficients does not define damping
        (Coefficient::Cmq, DampingOrigin::Report) => Regime::of_mach(mach),
        _ => regime,
    };
    let near = coefficient.origin(regime, 1.0);
    let far = coefficient.origin(regime, 90.0);
    let mut origins = vec![(near, near.name().to_string())];
    if far != near {
        origins.push((far, format!("{} beyond 60 deg", far.name())));
    }
    if coefficient == Coefficient::Cmq && near == Origin::Assumed {
        origins = vec![(
            Origin::Assumed,
            "placeholder for Viking, assumed".to_string(),
        )];
    }
    origins
}

fn capital(text: &str) -> String {
    let mut text = text.to_string();
    if let Some(first) = text.get_mut(..1) {
        first.make_ascii_uppercase();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::{Case, Library};
    use msape_worker::questions::curves::{AskCurves, Kept, Places, curves};

    fn drawn() -> Curves {
        let mut case = Case::default();
        case.set("outline.preset", "sphere-cone-60");
        let question = AskCurves {
            case,
            places: Places {
                mach: vec![20.0, 0.3],
                knudsen: vec![0.0],
                alpha_deg: vec![0.0, 20.0],
                family: Family::Mach,
                cg_over_diameter: Some(0.2),
            },
        };
        curves(&question, &Library::builtin().unwrap(), &Kept::default()).unwrap()
    }

    #[test]
    fn trim_is_marked_by_its_stability_on_the_moment_alone() {
        let curves = drawn();
        let figure = |c| super::figure(&curves, c, Over::Alpha);
        let names = |figure: Figure| {
            figure
                .series
                .into_iter()
                .map(|s| s.name)
                .collect::<Vec<_>>()
        };
        assert_eq!(names(figure(Coefficient::Ca)), ["Mach 20", "Mach 0.3"]);
        let names = names(figure(Coefficient::CmCg));
        assert!(names.contains(&"stable trim".to_string()), "{names:?}");
        let stable = figure(Coefficient::CmCg).series;
        let stable = stable.iter().find(|s| s.name == "stable trim").unwrap();
        assert!(stable.points.contains(&(0.0, 0.0)));
    }

    #[test]
    fn the_placeholder_is_said_to_be_assumed_wherever_damping_is_drawn() {
        let curves = drawn();
        let said = |over| {
            let sources = sources(&curves, Coefficient::Cmq, over);
            sources
                .into_iter()
                .flat_map(|source| source.origins.into_iter().map(|(_, words)| words))
                .collect::<Vec<_>>()
        };
        assert_eq!(
            said(Over::Alpha),
            ["placeholder for Viking, assumed", "published"]
        );
        assert_eq!(said(Over::Mach)[0], "published");
        assert!(
            said(Over::Mach)[1..]
                .iter()
                .all(|words| words.contains("assumed"))
        );
    }

    #[test]
    fn marks_are_where_another_regime_begins() {
        for (mach, name) in MACH_MARKS {
            assert_eq!(Regime::of_mach(1.001 * mach).name(), name);
            assert_ne!(Regime::of_mach(0.999 * mach).name(), name);
        }
        assert_eq!(
            WITHIN.map(|mach| Regime::of_mach(mach).name())[1..],
            MACH_MARKS.map(|(_, name)| name)
        );
        let mut curves = drawn();
        curves.places.knudsen = vec![100.0];
        let sources = sources(&curves, Coefficient::Ca, Over::Mach);
        assert_eq!(sources.len(), 1);
        assert_eq!(sources[0].origins[0].0, Origin::Computed);
        assert!(
            figure(&curves, Coefficient::Ca, Over::Mach)
                .events
                .is_empty()
        );
    }

    #[test]
    fn regimes_are_marked_where_the_sources_change() {
        let figure = figure(&drawn(), Coefficient::Cn, Over::Mach);
        assert_eq!(figure.events.len(), 3);
        assert_eq!(figure.series[1].points.first().unwrap().0, 0.1);
    }
}
