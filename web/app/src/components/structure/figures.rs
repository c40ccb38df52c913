//! Stress and displacement along a wall.

use msape::shell::analysis::CarrierAnalysis;
use msape::shell::wall::Place;
use msape::vehicle::WallPlace;
use msape_kit::display::{UnitSystem, symbol};
use msape_plot::{Axis, EventLine, Figure, LimitLine, Series};

/// Quantity plotted along a wall.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Equivalent stress.
    Stress,
    /// Displacement relative to the foot of the lid.
    Displacement,
}

/// Ratio of allowable stress to peak stress above which the allowable is omitted, as it would flatten the figure.
const FAR: f64 = 3.0;

impl Along {
    /// Label for headings and axes.
    pub fn label(self) -> &'static str {
        match self {
            Along::Stress => "Stress",
            Along::Displacement => "Displacement",
        }
    }

    fn unit(self) -> &'static str {
        match self {
            Along::Stress => "MPa",
            Along::Displacement => "mm",
        }
    }

    /// Value at entry and at launch.
    fn of(self, place: &Place) -> [f64; 2] {
        match self {
            Along::Stress => [place.entry_stress_pa, place.launch_stress_pa],
            Along::Displacement => [place.entry_displacement_m, place.launch_displacement_m],
        }
    }
}

/// Quantity along a wall at entry and at launch, broken at the joints of its parts.
pub fn figure(
    shell: &CarrierAnalysis,
    wall: WallPlace,
    what: Along,
    nose_x_m: f64,
    units: UnitSystem,
) -> Figure {
    let (x_unit, y_unit) = (units.named("mm"), units.named(what.unit()));
    let (x_label, from_m) = match wall {
        WallPlace::Primary => ("Distance from the nose", nose_x_m),
        WallPlace::Forebody | WallPlace::Aftbody => ("Distance from the axis", 0.0),
    };
    let places = shell.distributions.of_wall(wall);
    let mut points = [Vec::new(), Vec::new()];
    let mut events = Vec::new();
    let mut before: Option<&Place> = None;
    for place in &places {
        let x = x_unit.from_canonical(place.along_m() - from_m);
        if before.is_some_and(|before| before.part != place.part) {
            let label = match wall {
                WallPlace::Aftbody => "foot of the lid",
                WallPlace::Forebody | WallPlace::Primary => "primary structure",
            };
            events.push(EventLine {
                x,
                label: label.to_string(),
            });
            for points in &mut points {
                points.push((x, f64::NAN));
            }
        }
        for (points, value) in points.iter_mut().zip(what.of(place)) {
            points.push((x, y_unit.from_canonical(value)));
        }
        before = Some(place);
    }
    let peak = places.iter().flat_map(|p| what.of(p)).fold(0.0, f64::max);
    let allowed = shell.entry.of_wall(wall).next();
    let allowed = allowed.map(|part| part.allowed_stress_pa());
    let [entry, launch] = points;
    Figure {
        x: Axis::new(x_label, symbol(x_unit)),
        y: Axis::new(what.label(), symbol(y_unit)),
        series: vec![
            Series::line("entry", entry, 0),
            Series::line("launch", launch, 1),
        ],
        events,
        limits: allowed
            .filter(|allowed| what == Along::Stress && *allowed < FAR * peak)
            .map(|allowed| LimitLine {
                y: y_unit.from_canonical(allowed),
                label: "allowed".to_string(),
            })
            .into_iter()
            .collect(),
        ..Figure::default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use benchmark::Bench;
    use msape::design::structural::Structural;

    #[test]
    fn both_carriers_are_broken_where_their_parts_meet_and_peaks_are_those_of_the_table() {
        let bench = Bench::new().unwrap();
        let (design, flight) = &bench.msr_design;
        let structural = Structural::new(&bench.msr.input, design, flight);
        let shell = structural.shell.unwrap();
        for wall in WallPlace::ALL {
            let figure = figure(&shell, wall, Along::Stress, 0.0, UnitSystem::Si);
            let breaks = usize::from(wall != WallPlace::Primary);
            assert_eq!(figure.events.len(), breaks, "{wall:?}");
            for (series, case) in figure.series.iter().zip([&shell.entry, &shell.launch]) {
                let finite = series.points.iter().map(|p| p.1).filter(|y| y.is_finite());
                let drawn = finite.fold(0.0, f64::max);
                let told = case.of_wall(wall).map(|p| p.stress_pa).fold(0.0, f64::max);
                // curves are at the Gauss points, the table also evaluates the ends of elements
                assert!(drawn > 0.5 * told && drawn <= told, "{drawn} {told}");
                let rising = series.points.windows(2).all(|pair| pair[0].0 <= pair[1].0);
                assert!(rising || wall == WallPlace::Aftbody);
            }
        }
    }
}
