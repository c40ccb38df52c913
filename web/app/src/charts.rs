//! Figures of a flight: columns, units and events.

use msape::flight::columns::find;
use msape::flight::{Flight, Trajectory};
use msape::quantity::Column;
use msape_kit::display::{UnitSystem, symbol};
use msape_plot::{Axis, EventLine, Figure, Scale, Series};

/// One column plotted over another.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChartSpec {
    /// Key of the horizontal column.
    pub x: String,
    /// Key of the vertical column.
    pub y: String,
}

/// Part of a flight shown in plots over time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Span {
    /// From the start until the vehicle is well below the speed of sound.
    Entry,
    /// Whole flight.
    Whole,
}

impl Span {
    /// End of the time shown, s; `None` for the whole flight.
    fn end_s(self, flight: &Flight) -> Option<f64> {
        let [.., subsonic_s] = flight.mach_times_s;
        let end_s = 1.15 * subsonic_s?;
        (self == Span::Entry && end_s < 0.8 * flight.time_of_flight_s).then_some(end_s)
    }
}

/// Plots of the report: vertical and horizontal column.
pub const REPORT_PLOTS: [(&str, &str); 4] = [
    ("altitude_m", "time_s"),
    ("total_heat_flux_w_m2", "time_s"),
    ("deceleration_earth_g", "time_s"),
    ("altitude_m", "speed_m_s"),
];

/// Plots of attitude: vertical and horizontal column.
pub const ATTITUDE_PLOTS: [(&str, &str); 4] = [
    ("total_alpha_deg", "time_s"),
    ("total_alpha_deg", "knudsen"),
    ("q_deg_s", "time_s"),
    ("dynamic_pressure_pa", "time_s"),
];

impl ChartSpec {
    /// Heading: "Altitude over Time".
    pub fn title(&self) -> String {
        let label = |key| find(key).map_or("", |column| column.label);
        let over = label(&self.x).to_lowercase();
        let over = over.replace("knudsen", "Knudsen").replace("mach", "Mach");
        format!("{} over {over}", label(&self.y))
    }

    /// Points in the displayed units, one for each row of the time history.
    pub fn points(&self, trajectory: &Trajectory, units: UnitSystem) -> Vec<(f64, f64)> {
        let values = |key: &str| {
            let column = find(key)?;
            Some((trajectory.column(key)?, units.of_column(column)))
        };
        match (values(&self.x), values(&self.y)) {
            (Some((x, x_unit)), Some((y, y_unit))) => x
                .iter()
                .zip(y)
                .map(|(x, y)| (x_unit.from_canonical(*x), y_unit.from_canonical(*y)))
                .collect(),
            _ => Vec::new(),
        }
    }

    /// The figure.
    pub fn figure(&self, flight: &Flight, units: UnitSystem, span: Span) -> Figure {
        let points = flight
            .trajectory
            .as_ref()
            .map(|trajectory| self.points(trajectory, units))
            .unwrap_or_default();
        let label = find(&self.y).map_or("", |column| column.label);
        let mut x = axis(&self.x, units);
        if self.x == "time_s"
            && let Some(column) = find(&self.x)
            && let Some(end_s) = span.end_s(flight)
        {
            x = x.with_range(0.0, units.of_column(column).from_canonical(end_s));
        }
        Figure {
            x,
            y: axis(&self.y, units),
            events: self.events(flight, &points),
            series: vec![Series::line(label, points, 0)],
            ..Figure::default()
        }
    }

    fn events(&self, flight: &Flight, points: &[(f64, f64)]) -> Vec<EventLine> {
        let Some(time_s) = flight
            .trajectory
            .as_ref()
            .and_then(|trajectory| trajectory.column("time_s"))
        else {
            return Vec::new();
        };
        events(flight)
            .into_iter()
            .filter_map(|(at_s, label)| {
                let x = interpolated(time_s, points, at_s)?;
                Some(EventLine { x, label })
            })
            .collect()
    }
}

fn axis(key: &str, units: UnitSystem) -> Axis {
    find(key).map_or_else(Axis::default, |column: &'static Column| {
        let axis = Axis::new(column.label, symbol(units.of_column(column)));
        // the Knudsen number falls by ten orders of magnitude during a descent
        axis.with_scale(if key == "knudsen" {
            Scale::Log
        } else {
            Scale::Linear
        })
    })
}

/// Times, s, and short names of the events of a flight.
pub fn events(flight: &Flight) -> Vec<(f64, String)> {
    let mach = ["Mach 5", "Mach 2", "Mach 1.4", "Mach 0.8"];
    let mut events = vec![
        (
            flight.peak_total_heat_flux_w_m2.time_s,
            "peak heating".to_string(),
        ),
        (
            flight.peak_deceleration_earth_g.time_s,
            "peak deceleration".to_string(),
        ),
        (flight.time_of_flight_s, "end".to_string()),
    ];
    for (time_s, name) in flight.mach_times_s.iter().zip(mach) {
        if let Some(time_s) = time_s {
            events.push((*time_s, name.to_string()));
        }
    }
    events
}

/// Horizontal value at a time, interpolated linearly between rows.
fn interpolated(time_s: &[f64], points: &[(f64, f64)], at_s: f64) -> Option<f64> {
    let after = time_s.partition_point(|t| *t < at_s);
    let last = time_s.len().checked_sub(1)?;
    let (i, j) = (after.saturating_sub(1).min(last), after.min(last));
    let (t0, t1) = (*time_s.get(i)?, *time_s.get(j)?);
    let (x0, x1) = (points.get(i)?.0, points.get(j)?.0);
    let part = if t1 > t0 {
        (at_s - t0) / (t1 - t0)
    } else {
        0.0
    };
    Some(x0 + (x1 - x0) * part.clamp(0.0, 1.0))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_way_in_time_is_half_way_in_between() {
        let points = [(0.0, 1.0), (10.0, 1.0), (40.0, 1.0)];
        assert_eq!(interpolated(&[0.0, 2.0, 4.0], &points, 3.0), Some(25.0));
        assert_eq!(interpolated(&[0.0, 2.0, 4.0], &points, 9.0), Some(40.0));
        assert_eq!(interpolated(&[], &[], 1.0), None);
    }

    #[test]
    fn the_plots_of_the_report_have_their_columns() {
        for (y, x) in REPORT_PLOTS.into_iter().chain(ATTITUDE_PLOTS) {
            assert!(find(y).is_some() && find(x).is_some(), "{y} {x}");
        }
    }
}
