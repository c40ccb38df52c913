//! Shape, back face, limit and settings of a run in depth, from a case.

use crate::ablation::sizing::Limit;
use crate::case::Reader;
use crate::quantity::choice::{BackFace, NormalGeometry};
use crate::quantity::input::tps;
use ::ablation::geometry::Geometry;
use ::ablation::grid::Resolution;
use ::ablation::settings::{Settings, Until};
use ::ablation::stack::Back;
use ::ablation::wall::WallSettings;

/// Longest time of a run without `tps.until_s` after the last row of its environment, s. Assumed: longer than any soak.
const LONGEST_S: f64 = 20_000.0;
/// Most steps of a run, those that are taken back included.
const MOST_STEPS: usize = 200_000;

pub(super) fn geometry(reader: &mut Reader) -> Option<Geometry> {
    let shape: NormalGeometry = reader.choice(&tps::GEOMETRY)?;
    let radius = |reader: &mut Reader| reader.required_number(&tps::RADIUS_M);
    Some(match shape {
        NormalGeometry::Planar => Geometry::Planar,
        NormalGeometry::Cylindrical => Geometry::Cylindrical {
            radius_m: radius(reader)?,
        },
        NormalGeometry::Spherical => Geometry::Spherical {
            radius_m: radius(reader)?,
        },
    })
}

pub(super) fn back(reader: &mut Reader) -> Option<Back> {
    let back: BackFace = reader.choice(&tps::BACK)?;
    let initial = reader.number(&tps::INITIAL_TEMPERATURE_K)?;
    let temperature_k = match reader.given(&tps::BACK_TEMPERATURE_K) {
        true => reader.number(&tps::BACK_TEMPERATURE_K)?,
        false => initial,
    };
    Some(match back {
        BackFace::Adiabatic => Back::Adiabatic,
        BackFace::Held => Back::Held { temperature_k },
        BackFace::Radiating => {
            let [emissivity, film_w_m2k] =
                [&tps::BACK_EMISSIVITY, &tps::BACK_FILM_W_M2K].map(|input| reader.number(input));
            Back::Exposed {
                temperature_k,
                emissivity: emissivity?,
                film_w_m2k: film_w_m2k?,
            }
        }
    })
}

pub(super) fn limit(reader: &mut Reader) -> Option<Limit> {
    let [layer, limit_k, margin_k, recession_margin] = [
        &tps::BOND_LAYER,
        &tps::BOND_LIMIT_K,
        &tps::TEMPERATURE_MARGIN_K,
        &tps::RECESSION_MARGIN,
    ]
    .map(|input| reader.number(input));
    Some(Limit {
        layer: layer? as usize - 1,
        temperature_k: limit_k? - margin_k?,
        recession_margin: recession_margin?,
    })
}

/// Settings of a run whose environment ends at `last_s`. Every number is read before the first fault is looked at.
pub(super) fn settings(reader: &mut Reader, last_s: f64) -> Option<Settings> {
    let numbers = [
        &tps::BOND_LAYER,
        &tps::BLOWING,
        &tps::SINK_TEMPERATURE_K,
        &tps::INITIAL_TEMPERATURE_K,
        &tps::OUTPUT_STEP_S,
        &tps::CELLS,
        &tps::TOLERANCE_K,
    ]
    .map(|input| reader.number(input));
    let recession = reader.flag(&tps::RECESSION);
    let given = reader.given(&tps::UNTIL_S);
    let until = given.then(|| reader.number(&tps::UNTIL_S));
    let given = reader.given(&tps::DEPTHS_M);
    let depths = given.then(|| reader.rows(&tps::DEPTHS_M));
    let [
        Some(bond_layer),
        Some(blowing),
        Some(sink_temperature_k),
        Some(initial_temperature_k),
        Some(output_step_s),
        Some(cells),
        Some(tolerance_k),
    ] = numbers
    else {
        return None;
    };
    Some(Settings {
        initial_temperature_k,
        wall: WallSettings {
            blowing,
            recession: recession?,
            sink_temperature_k,
        },
        until: match until {
            Some(time_s) => Until::Time(time_s?),
            None => Until::Cooled {
                layer: bond_layer as usize - 1,
                at_most_s: last_s + LONGEST_S,
            },
        },
        output_step_s: Some(output_step_s),
        depths_m: match depths {
            Some(rows) => rows?.concat(),
            None => Vec::new(),
        },
        resolution: Resolution {
            cells: cells as usize,
            ..Resolution::default()
        },
        tolerance_k,
        most_steps: MOST_STEPS,
    })
}
