//! Findings where a run leaves the tables of its materials.
//!
//! ```text
//! T_first ≤ T ≤ T_last
//! ```
//!
//! with T in K, of heat capacity, conductivity, gas and wall.
//!
//! # Valid
//! Any run.
//!
//! # References
//! - \[assumed\]: beyond a table its end holds.

use crate::finding::{Finding, Severity};
use ::ablation::march::Response;
use ::ablation::stack::Stack;
use ::ablation::surface::Surface;

fn beyond(name: &str, of: &str, unit: &str, value: f64, [low, high]: [f64; 2]) -> Option<Finding> {
    if value >= low && value <= high {
        return None;
    }
    Some(Finding {
        severity: Severity::Extrapolated,
        model: "in-depth".to_string(),
        key: name.to_string(),
        value: Some(value),
        valid: (Some(low), Some(high)),
        message: format!(
            "{name}: {of} reached {}{unit}; its table ends at {} and {}{unit}, beyond which the end holds.",
            crate::units::number::rounded(value, 4),
            crate::units::number::rounded(low, 4),
            crate::units::number::rounded(high, 4),
        ),
        source: "assumed".to_string(),
        field: None,
    })
}

/// Remarks on all layers of a stack.
pub fn findings(stack: &Stack, response: &Response) -> Vec<Finding> {
    let history = &response.history;
    let mut found = Vec::new();
    let mut hottest = history.wall.temperature_k;
    for (i, layer) in stack.layers.iter().enumerate() {
        let material = &layer.material;
        let ends = material.solid.covered_k();
        found.extend(beyond(
            &material.name,
            "the solid",
            " K",
            hottest,
            [0.0, ends[1]],
        ));
        if i == 0 {
            if let Some(pyrolysis) = &material.pyrolysis {
                found.extend(beyond(
                    &material.name,
                    "the gas",
                    " K",
                    hottest,
                    [0.0, pyrolysis.gas.covered_k()[1]],
                ));
            }
            if let Surface::Reacting(table) = &material.surface {
                let [pressure, gas, temperature] = table.covered();
                found.extend(beyond(
                    &material.name,
                    "the wall",
                    " K",
                    hottest,
                    temperature,
                ));
                let [least, most] = history.exposed_pa;
                for pressure_pa in [least, most] {
                    if pressure_pa.is_finite() && pressure_pa > 0.0 {
                        found.extend(beyond(
                            &material.name,
                            "the pressure at the wall",
                            " Pa",
                            pressure_pa,
                            pressure,
                        ));
                    }
                }
                found.extend(beyond(
                    &material.name,
                    "pyrolysis gas over the transfer coefficient",
                    "",
                    history.gas_ratio,
                    gas,
                ));
            }
        }
        hottest = history.behind.get(i).map_or(0.0, |peak| peak.temperature_k);
    }
    found
}
