//! Deceleration over time and force over crush, on both surfaces.

use msape::answer::landing::{LandingColumn, Surface, columns};
use msape::vehicle::Vehicle;
use msape::vehicle::impact::history::History;
use msape::vehicle::impact::landing::Landing;
use msape_kit::display::{UnitSystem, symbol};
use msape_plot::{Axis, EventLine, Figure, LimitLine, Series};

/// Figure of the landing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Curves {
    /// Deceleration of the payload over time on a rigid surface.
    Rigid,
    /// Deceleration of the payload over time on the chosen ground; the much longer duration needs an axis of its own.
    Ground,
    /// Force of the foam over its crush.
    Force,
}

impl Curves {
    /// Heading.
    pub fn title(self, ground: &str) -> String {
        match self {
            Curves::Rigid => "Payload deceleration over time: rigid surface".to_string(),
            Curves::Ground => format!("Payload deceleration over time: {ground}"),
            Curves::Force => "Force of the foam over its crush".to_string(),
        }
    }

    /// Keys of the horizontal and the vertical column.
    fn keys(self) -> [&'static str; 2] {
        match self {
            Curves::Rigid | Curves::Ground => ["time_s", "payload_deceleration_earth_g"],
            Curves::Force => ["crush_m", "force_n"],
        }
    }
}

/// Data of the figures.
#[derive(Clone, Debug, PartialEq)]
pub struct Histories {
    rigid: History,
    ground: History,
    /// Load limit for which the foam is sized, Earth g.
    limit_earth_g: f64,
    /// Load of a rigid vehicle on the chosen ground, Earth g.
    rigid_vehicle_earth_g: Option<f64>,
    /// Force of equation 6, N, and stroke of equation 4, m.
    equation: (f64, f64),
    /// Crush at which the foam stiffens and at which it is solid, m.
    bends_m: [f64; 2],
}

impl Histories {
    /// Data of a designed vehicle.
    pub fn of(vehicle: &Vehicle, landing: &Landing) -> Histories {
        let [_, plateau_m, closed_m] = landing.absorber.bends_m();
        let impact = &vehicle.impact;
        Histories {
            rigid: Surface::Rigid.history(landing).clone(),
            ground: Surface::Ground.history(landing).clone(),
            rigid_vehicle_earth_g: impact.ground_penetration.map(|load| load.load_earth_g),
            limit_earth_g: impact.crush_load_limit_earth_g,
            equation: (vehicle.foam_force_n(), impact.required_stroke_m),
            bends_m: [plateau_m, closed_m],
        }
    }
}

/// A column of the landing histories, by key.
fn column(key: &str) -> Option<&'static LandingColumn> {
    columns().iter().find(|column| column.column.key == key)
}

/// A figure of the landing.
pub fn figure(of: &Histories, what: Curves, units: UnitSystem) -> Figure {
    let [x, y] = what.keys();
    let (Some(x), Some(y)) = (column(x), column(y)) else {
        return Figure::default();
    };
    let (x_unit, y_unit) = (units.of_column(&x.column), units.of_column(&y.column));
    let at = |x: f64, y: f64| (x_unit.from_canonical(x), y_unit.from_canonical(y));
    let line = |name: &str, history: &History, look: usize| {
        let both = (x.values)(history).iter().zip((y.values)(history));
        let points = both.map(|(x, y)| at(*x, *y)).collect();
        Series::line(name, points, look)
    };
    let limit = |load: f64, label: &str| LimitLine {
        y: y_unit.from_canonical(load),
        label: label.to_string(),
    };
    let figure = Figure {
        x: Axis::new(x.column.label, symbol(x_unit)),
        y: Axis::new(y.column.label, symbol(y_unit)),
        ..Figure::default()
    };
    match what {
        Curves::Rigid => Figure {
            series: vec![line("dynamics", &of.rigid, 0)],
            limits: vec![limit(of.limit_earth_g, "crush load limit")],
            ..figure
        },
        Curves::Ground => Figure {
            series: vec![line("dynamics", &of.ground, 0)],
            limits: of
                .rigid_vehicle_earth_g
                .map(|load| limit(load, "rigid vehicle"))
                .into_iter()
                .collect(),
            ..figure
        },
        Curves::Force => {
            let (force_n, stroke_m) = of.equation;
            let plateau = vec![at(0.0, 0.0), at(0.0, force_n), at(stroke_m, force_n)];
            let names = ["foam stiffens", "foam is solid"];
            let events = of
                .bends_m
                .into_iter()
                .zip(names)
                .map(|(m, name)| EventLine {
                    x: x_unit.from_canonical(m),
                    label: name.to_string(),
                });
            Figure {
                series: vec![
                    line("dynamics, rigid surface", &of.rigid, 0),
                    line("dynamics, chosen ground", &of.ground, 1),
                    Series::line("equations 4 and 6", plateau, 2),
                ],
                events: events.collect(),
                ..figure
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use benchmark::Bench;

    #[test]
    fn force_is_the_payload_s_mass_times_its_deceleration_and_the_equations_are_there() {
        let bench = Bench::new().unwrap();
        let (design, _) = &bench.msr_design;
        let of = Histories::of(&design.vehicle, &design.landing);
        let drawn = |what| figure(&of, what, UnitSystem::Si);
        let (load, force) = (drawn(Curves::Rigid), drawn(Curves::Force));
        assert_eq!(load.limits.len(), 1);
        assert_eq!(drawn(Curves::Ground).limits.len(), 1);
        assert_eq!(force.series.len(), 3);
        let peak = |figure: &Figure| {
            let ys = figure.series[0].points.iter().map(|p| p.1);
            ys.fold(0.0, f64::max)
        };
        // F = m G g
        let mass = peak(&force) / (peak(&load) * 9.80665);
        assert!((mass / design.landing.payload_side_kg - 1.0).abs() < 1e-9);
        // equation 6 times the stroke of equation 4 is the energy of the payload
        let [_, (_, force_n), (stroke_m, _)] = force.series[2].points[..] else {
            panic!("three corners");
        };
        let speed = design.landing.velocity.speed_m_s;
        let energy = 0.5 * design.payload_mass_kg * speed * speed;
        assert!((force_n * stroke_m / energy - 1.0).abs() < 0.02, "{energy}");
    }
}
