//! The heat shield in depth as a table of its history and as one JSON object.

use super::Table;
use crate::problem::in_depth::InDepth;
use crate::units::number::shortest;
use ::ablation::history::Sample;
use ::ablation::settings::Outcome;
use serde_json::{Value, json};

/// Name of an outcome.
pub fn outcome_name(outcome: Outcome) -> &'static str {
    match outcome {
        Outcome::Finished => "finished",
        Outcome::Cooled => "cooled",
        Outcome::BurntThrough => "burnt-through",
        Outcome::OutOfWork => "out-of-work",
        Outcome::NotSettled => "not-settled",
        Outcome::Stopped => "stopped",
    }
}

/// Heading of a depth, such as `T_1mm_K`.
fn depth_heading(depth_m: f64) -> String {
    // A depth of 12 mm is 0.012 m, which times 1000 is 12 but for rounding.
    let mm = (depth_m * 1e9).round() / 1e6;
    format!("T_{}mm_K", shortest(mm))
}

fn headings(answer: &InDepth) -> Vec<String> {
    let mut headings = vec!["t_s".to_string(), "Tw_K".to_string()];
    headings.extend(answer.depths_m.iter().map(|depth| depth_heading(*depth)));
    let rest = [
        "mdot_g_kg_m2s",
        "mdot_c_kg_m2s",
        "recession_m",
        "T_bond_K",
        "T_back_K",
    ];
    headings.extend(rest.map(String::from));
    headings
}

fn numbers(answer: &InDepth, row: &Sample) -> Vec<f64> {
    let mut numbers = vec![row.time_s, row.wall_k];
    numbers.extend(&row.depths_k);
    let behind = |layer: usize| row.behind_k.get(layer).copied().unwrap_or_default();
    let back = row.behind_k.last().copied().unwrap_or_default();
    numbers.extend([
        row.gas_kg_m2s,
        row.char_kg_m2s,
        row.recession_m,
        behind(answer.limit.layer),
        back,
    ]);
    numbers
}

/// Value of a column of the history at a time, s; `None` where there is no such column or row.
pub fn value_at(answer: &InDepth, column: &str, time_s: f64) -> Option<f64> {
    let place = headings(answer)
        .iter()
        .position(|heading| heading == column)?;
    let row = answer
        .response
        .history
        .rows
        .iter()
        .find(|row| (row.time_s - time_s).abs() < 1e-6)?;
    numbers(answer, row).get(place).copied()
}

/// Rows of the history, one for each output time: time, wall, depths, gas, char, recession, bond, back.
pub fn in_depth(answer: &InDepth) -> Table {
    let rows = answer.response.history.rows.iter();
    let cells = |row: &Sample| numbers(answer, row).into_iter().map(shortest).collect();
    Table {
        headers: headings(answer),
        rows: rows.map(cells).collect(),
    }
}

/// The answer as one object: outcome, layers, limits, peaks, balances, work, history by columns, findings.
pub fn in_depth_json(answer: &InDepth) -> Value {
    let response = &answer.response;
    let history = &response.history;
    let account = &response.account;
    let peak = |peak: &::ablation::history::Peak| json!({ "temperature_k": peak.temperature_k, "time_s": peak.time_s });
    let layers = answer.stack.layers.iter().zip(&history.behind);
    let layers: Vec<Value> = layers
        .map(|(layer, behind)| json!({ "material": layer.material.name, "thickness_m": layer.thickness_m, "behind": peak(behind) }))
        .collect();
    let last = history.rows.last();
    let columns = headings(answer)
        .into_iter()
        .enumerate()
        .map(|(i, heading)| {
            let of_row = |row: &Sample| numbers(answer, row).get(i).copied();
            (
                heading,
                json!(history.rows.iter().map(of_row).collect::<Vec<_>>()),
            )
        });
    let sized = answer.sized.map(|sized| {
        json!({ "thickness_m": sized.thickness_m, "with_recession_margin_m": sized.with_margin_m, "runs": sized.runs })
    });
    json!({
        "name": answer.name,
        "outcome": outcome_name(response.outcome),
        "end_s": response.end_s,
        "layers": layers,
        "bond_layer": answer.limit.layer + 1,
        "bond_limit_k": answer.limit.temperature_k,
        "sized": sized,
        "wall": peak(&history.wall),
        "recession_m": last.map(|row| row.recession_m),
        "pyrolysis_depth_m": history.pyrolysis_depth_m,
        "gas_pressure_pa": history.pressure_pa,
        "energy": {
            "wall_j_m2": account.wall_j_m2,
            "back_j_m2": account.back_j_m2,
            "stored_j_m2": account.stored_j_m2,
            "imbalance": account.energy_imbalance(),
        },
        "mass": {
            "gas_kg_m2": account.gas_kg_m2,
            "char_kg_m2": account.char_kg_m2,
            "stored_kg_m2": account.stored_kg_m2,
            "imbalance": account.mass_imbalance(),
        },
        "work": { "steps": account.steps, "taken_back": account.taken_back, "corrections": account.corrections },
        "history": Value::Object(columns.collect()),
        "findings": answer.findings,
    })
}
