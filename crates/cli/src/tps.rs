//! Command `tps`: the heat shield in depth.

use crate::args::Tps;
use crate::read::Data;
use crate::show::columns::{Align, Columns};
use crate::{Done, output, read, signal};
use msape::problem::in_depth::{Ask, InDepth, in_depth};
use msape::table::in_depth as table;
use msape::units::number::rounded;
use std::process::ExitCode;

/// Answers a case with `[tps]`.
pub fn tps(arguments: &Tps, data: &Data) -> Done {
    let mut loaded = read::asked(&arguments.source, arguments.output.as_deref(), data)?;
    let ask = match arguments.size {
        true => Ask::Thickness,
        false => Ask::Response,
    };
    let found = signal::stoppable(|progress| in_depth(&loaded.case, &data.library, ask, progress));
    let mut answer = loaded.unless_at_fault(found)?;
    answer.findings.extend(loaded.findings());
    let text = match (arguments.json, arguments.csv) {
        (true, _) => format!("{:#}\n", table::in_depth_json(&answer)),
        (_, true) => table::in_depth(&answer).to_csv(),
        _ => shown(&answer),
    };
    output::write(text, arguments.output.as_deref())?;
    Ok(signal::code(ExitCode::SUCCESS))
}

/// The answer as tables to read.
fn shown(answer: &InDepth) -> String {
    let response = &answer.response;
    let history = &response.history;
    let number = |value: f64| rounded(value, 6);
    let mut text = format!(
        "{}: {} at {} s\n\n",
        answer.name,
        table::outcome_name(response.outcome),
        number(response.end_s)
    );
    let mut lines = Columns::new(&[Align::Left, Align::Right, Align::Left]);
    let mut line = |name: &str, value: f64, unit: &str| {
        lines.push(vec![name.to_string(), number(value), unit.to_string()])
    };
    line(
        "Peak temperature of the wall",
        history.wall.temperature_k,
        "K",
    );
    line("  at", history.wall.time_s, "s");
    for (i, peak) in history.behind.iter().enumerate() {
        let name = answer
            .stack
            .layers
            .get(i)
            .map_or("", |layer| layer.material.name.as_str());
        line(
            &format!("Peak temperature behind {name}"),
            peak.temperature_k,
            "K",
        );
        line("  at", peak.time_s, "s");
    }
    line("Bond limit", answer.limit.temperature_k, "K");
    let last = history.rows.last();
    line(
        "Recession",
        last.map_or(0.0, |row| 1e3 * row.recession_m),
        "mm",
    );
    line(
        "Depth to which 2 % is pyrolyzed",
        1e3 * history.pyrolysis_depth_m,
        "mm",
    );
    line(
        "Gas and char that left",
        response.account.gas_kg_m2 + response.account.char_kg_m2,
        "kg/m^2",
    );
    line(
        "Energy missing from the balance",
        response.account.energy_imbalance(),
        "",
    );
    line(
        "Mass missing from the balance",
        response.account.mass_imbalance(),
        "",
    );
    if let Some(sized) = answer.sized {
        match (sized.thickness_m, sized.with_margin_m) {
            (Some(thickness), Some(with_margin)) => {
                line("Thickness for the bond limit", 1e3 * thickness, "mm");
                line("  with the margin on recession", 1e3 * with_margin, "mm");
            }
            _ => line(
                "Thickness for the bond limit: none up to",
                1e3 * msape::ablation::sizing::THICKNESS_M[1],
                "mm",
            ),
        }
    }
    text.extend(lines.lines().map(|line| format!("{line}\n")));
    for finding in &answer.findings {
        text.push_str(&format!("\n{}: {}\n", finding.model, finding.message));
    }
    text
}
