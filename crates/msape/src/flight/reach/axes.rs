//! The tables that a flight of a vehicle looks up, axis by axis.
//!
//! ```text
//! low ≤ argument ≤ high        beyond: the rule of the table, hold, extend or refuse
//! ```
//!
//! with the argument in the unit of its column: m, Mach, rad, s, m/s or kg/m³.
//!
//! # Valid
//! Tables given by a case, and the altitudes of any atmosphere.
//!
//! # References
//! - Own convention.

use super::{ATMOSPHERE, Argument, Axis, NEAR_M};
use crate::aero::damping::Damping;
use crate::aero::database::Database;
use crate::aero::table::{Extrapolation, Grid};
use crate::aero::{Drag, DragTable};
use crate::flight::freedom::Freedom;
use crate::flight::lift::{Bank, Source};
use crate::flight::mission::{Body, Mission};
use crate::flight::six_dof::aerodynamics::Aerodynamics;
use crate::heating::given::GivenHeating;
use crate::planet::atmosphere::Atmosphere;
use crate::planet::wind::Wind;
use crate::quantity::input;

/// The tables of the case that a flight of this vehicle looks up, one entry an axis.
pub fn axes(mission: &Mission, body: &Body) -> Vec<Axis> {
    let mut axes = Vec::new();
    if let Wind::Table(table) = &mission.wind {
        axes.push(Axis {
            rule: mission.beyond.wind,
            ..Axis::held(input::wind::TABLE.key, Argument::Altitude, table.ends_m())
        });
    }
    if mission.beyond.atmosphere == Extrapolation::Refuse {
        axes.extend(of_atmosphere(mission));
    }
    axes.extend(mission.heating.given().into_iter().flat_map(of_heating));
    match &body.freedom {
        Freedom::Ballistic => of_drag(&body.drag, &mut axes),
        Freedom::Lifting(lift) => {
            match &lift.source {
                Source::OfDrag(_) | Source::Coefficient(_) => of_drag(&body.drag, &mut axes),
                Source::Table(table, rule) => {
                    of_drag(&body.drag, &mut axes);
                    axes.push(Axis {
                        rule: *rule,
                        ..Axis::held(input::vehicle::LIFT_TABLE.key, Argument::Mach, table.ends())
                    });
                }
                Source::Trim(trim) => axes.extend(&trim.axes),
            }
            let of_bank = |key, argument, ends| Axis {
                rule: lift.beyond_bank,
                ..Axis::held(key, argument, ends)
            };
            match &lift.bank {
                Bank::Constant(_) => {}
                Bank::OfTime(table) => {
                    let key = input::vehicle::BANK_TABLE_DEG.key;
                    axes.push(of_bank(key, Argument::Time, table.ends()));
                }
                Bank::OfSpeed(table) => {
                    let key = input::vehicle::BANK_SPEED_TABLE_DEG.key;
                    axes.push(of_bank(key, Argument::AirSpeed, table.ends()));
                }
            }
        }
        Freedom::Rigid(rigid) => match &rigid.aerodynamics {
            Aerodynamics::Drag => of_drag(&body.drag, &mut axes),
            Aerodynamics::Constants(_) => {}
            Aerodynamics::Database(of) => {
                axes.extend(of_database(&of.database));
                if of.database.table().is_none() {
                    of_drag_table(of.axial_force.as_ref(), &mut axes);
                }
            }
        },
    }
    axes
}

/// Axes of the tables that the closed form looks up. It flies on beyond their ends whatever the rule, with the
/// atmosphere extrapolated and the heating held.
pub fn axes_of_closed_form(mission: &Mission) -> Vec<Axis> {
    let on = |axis: Axis, instead: Extrapolation| Axis {
        rule: match axis.rule {
            Extrapolation::Refuse => instead,
            rule => rule,
        },
        ..axis
    };
    let air = of_atmosphere(mission).map(|axis| on(axis, Extrapolation::Extend));
    let heating = mission.heating.given().into_iter().flat_map(of_heating);
    let heating = heating.map(|axis| on(axis, Extrapolation::Hold));
    air.into_iter().chain(heating).collect()
}

/// The altitudes of the atmosphere; none where it has no ends.
pub fn of_atmosphere(mission: &Mission) -> Option<Axis> {
    let (bottom_m, top_m) = mission.atmosphere.valid_m();
    let level = match &mission.atmosphere {
        Atmosphere::Table(table) => table.is_held(),
        _ => [false; 2],
    };
    // an end of the atmosphere counts whether it is held or not; level rows continue as the rule says
    (bottom_m.is_finite() && top_m.is_finite()).then_some(Axis {
        key: ATMOSPHERE,
        argument: Argument::Altitude,
        ends: [bottom_m, top_m],
        rule: mission.beyond.atmosphere,
        level: match mission.beyond.atmosphere {
            Extrapolation::Refuse => [false; 2],
            _ => level,
        },
        slack: NEAR_M,
    })
}

/// Speed and density of heat fluxes that the case gives.
fn of_heating(table: &GivenHeating) -> impl Iterator<Item = Axis> {
    let (key, rule) = (table.key, table.extrapolation);
    let arguments = [Argument::AirSpeed, Argument::Density];
    let axes = arguments.into_iter().zip(table.ends()).zip(table.level());
    axes.map(move |((argument, ends), level)| Axis {
        rule,
        level,
        ..Axis::held(key, argument, ends)
    })
}

fn of_drag(drag: &Drag, axes: &mut Vec<Axis>) {
    if let Drag::Table(table) = drag {
        of_drag_table(Some(table), axes);
    }
}

fn of_drag_table(table: Option<&DragTable>, axes: &mut Vec<Axis>) {
    let own = table.and_then(|table| Some((table.own()?, table)));
    axes.extend(own.map(|(own, table)| Axis {
        rule: own.extrapolation,
        level: table.level(),
        ..Axis::held(own.key, Argument::Mach, table.ends())
    }));
}

/// Axes of the tables in a database.
pub fn of_database(database: &Database) -> Vec<Axis> {
    let grid = |key: &'static str, grid: &Grid| {
        let rule = grid.extrapolation;
        let arguments = [Argument::Mach, Argument::TotalAlpha, Argument::Knudsen];
        let level = grid.level();
        let ends = arguments.into_iter().zip(grid.ends()).zip(level);
        let axis = move |((argument, ends), level): ((Argument, Option<[f64; 2]>), [bool; 2])| {
            let held = Axis::held(key, argument, ends?);
            Some(Axis {
                rule,
                level,
                ..held
            })
        };
        ends.filter_map(axis).collect::<Vec<Axis>>()
    };
    let mut axes = Vec::new();
    if let Some(table) = database.table() {
        axes.extend(grid(input::vehicle::AERODYNAMICS_TABLE.key, table));
    }
    match database.damping() {
        Damping::Table(table) if Some(table) != database.table() => {
            axes.extend(grid(input::vehicle::AERODYNAMICS_DAMPING_TABLE.key, table));
        }
        _ => {}
    }
    axes
}
