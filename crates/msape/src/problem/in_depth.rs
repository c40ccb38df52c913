//! The heat shield in depth of a case: `[tps]`, with an environment of its own or that of the case's flight.

mod layers;
mod settings;
mod wall;

use crate::ablation::sizing::{Limit, Sized, size};
use crate::ablation::{Cards, coverage};
use crate::case::{Case, InputError, Reader};
use crate::finding::{Finding, Severity};
use crate::library::Library;
use crate::progress::Progress;
use crate::quantity::input::tps;
use ::ablation::environment::Environment;
use ::ablation::march::{Response, Run};
use ::ablation::settings::{Settings, Until};
use ::ablation::solid::REFERENCE_TEMPERATURE_K;
use ::ablation::stack::Stack;
use std::ops::ControlFlow;

/// Temperatures at which the enthalpy of air at the wall is tabulated, K.
const AIR_K: [usize; 2] = [100, 4000];

/// A heat shield in depth that was checked.
#[derive(Clone, Debug)]
pub struct InDepthProblem {
    /// Layers, shape, back.
    pub stack: Stack,
    /// Conditions at the wall.
    pub environment: Environment,
    /// Settings of the run.
    pub settings: Settings,
    /// Limit by which it is judged and sized.
    pub limit: Limit,
    /// Findings of the check.
    pub findings: Vec<Finding>,
}

/// Question about a heat shield in depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ask {
    /// Its response as it is.
    Response,
    /// The thickness of its first layer, and the response with it.
    Thickness,
}

/// The answer.
#[derive(Clone, Debug)]
pub struct InDepth {
    /// Name of the case.
    pub name: String,
    /// Stack of the response.
    pub stack: Stack,
    /// Depths of the history, m.
    pub depths_m: Vec<f64>,
    /// Limit.
    pub limit: Limit,
    /// Response.
    pub response: Response,
    /// Result of the sizing, where it was asked for: thickness, m, with the margin on recession, m, and number of runs.
    pub sized: Option<Thickness>,
    /// Findings.
    pub findings: Vec<Finding>,
}

/// Thickness of the first layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thickness {
    /// Thickness at which the limit is kept, m; none where it is not kept.
    pub thickness_m: Option<f64>,
    /// Thickness with the margin on recession, m.
    pub with_margin_m: Option<f64>,
    /// Runs.
    pub runs: usize,
}

/// Answers a case with `[tps]`.
///
/// # Errors
/// Every fault of the case at once.
pub fn in_depth(
    case: &Case,
    library: &Library,
    ask: Ask,
    progress: &mut dyn Progress,
) -> Result<InDepth, Vec<InputError>> {
    InDepthProblem::check(case, library)?.solve(&case.name, ask, progress)
}

impl InDepthProblem {
    /// Checks a case; one without an environment is flown or designed for it.
    ///
    /// # Errors
    /// Every fault of the case at once.
    pub fn check(case: &Case, library: &Library) -> Result<Self, Vec<InputError>> {
        let mut reader = Reader::new(case);
        let air = air(library);
        let cards = Cards {
            own: &library.ablators,
            air: &air,
        };
        let margin = reader.number(&tps::HEATING_MARGIN);
        let flown = wall::flown(&mut reader, case, library);
        let environment =
            margin.and_then(|margin| wall::environment(&mut reader, flown.as_ref(), margin));
        let layers = layers::layers(&mut reader, &cards, flown.as_ref());
        let geometry = settings::geometry(&mut reader);
        let back = settings::back(&mut reader);
        let times_s = environment.as_ref().map(Environment::times_s);
        let last_s = times_s.and_then(|times_s| times_s.last()).copied();
        let settings = settings::settings(&mut reader, last_s.unwrap_or_default());
        let limit = settings::limit(&mut reader);
        let stack = layers
            .zip(geometry)
            .zip(back)
            .and_then(
                |((layers, geometry), back)| match Stack::try_new(layers, geometry, back) {
                    Ok(stack) => Some(stack),
                    Err(fault) => {
                        reader.fault(&"tps", fault.to_string());
                        None
                    }
                },
            );
        if let (Some(stack), Some(limit)) = (&stack, &limit)
            && limit.layer >= stack.layers.len()
        {
            let most = stack.layers.len();
            reader.fault(
                &tps::BOND_LAYER,
                format!(
                    "got {}, must be 1 to {most}, the number of layers",
                    limit.layer + 1
                ),
            );
        }
        if let (Some(stack), Some(settings)) = (&stack, &settings) {
            let whole = stack.thickness_m();
            for depth in settings
                .depths_m
                .iter()
                .filter(|depth| **depth > whole * (1.0 + 1e-12))
            {
                reader.fault(
                    &tps::DEPTHS_M,
                    format!("got {depth} m, must be 0 to {whole} m, the thickness of all layers"),
                );
            }
        }
        match (stack, environment, settings, limit) {
            (Some(stack), Some(environment), Some(settings), Some(limit))
                if reader.faults.is_empty() =>
            {
                Ok(Self {
                    stack,
                    environment,
                    settings,
                    limit,
                    findings: reader.into_findings(),
                })
            }
            _ => Err(reader.into_faults()),
        }
    }

    /// Computes the answer; the observer may stop it, and what there is until then is the answer.
    ///
    /// # Errors
    /// Settings that only show beyond their range when layers and environment are known.
    pub fn solve(
        &self,
        name: &str,
        ask: Ask,
        progress: &mut dyn Progress,
    ) -> Result<InDepth, Vec<InputError>> {
        let fault = |fault: ::ablation::fault::Fault| {
            vec![InputError {
                key: "tps".to_string(),
                message: fault.to_string(),
            }]
        };
        let [start, end] = [
            self.environment.times_s().first(),
            self.environment.times_s().last(),
        ]
        .map(|time| time.copied().unwrap_or_default());
        let end = match self.settings.until {
            Until::Time(time) => time,
            Until::Cooled { .. } => end,
        };
        let mut watch = |time: f64| -> ControlFlow<()> {
            progress.advance(((time - start) / (end - start)).clamp(0.0, 1.0))
        };
        let (stack, response, sized) = match ask {
            Ask::Response => {
                let run =
                    Run::try_new(&self.stack, &self.environment, &self.settings).map_err(fault)?;
                (self.stack.clone(), run.response(&mut watch), None)
            }
            Ask::Thickness => {
                let Sized {
                    thickness_m,
                    with_margin_m,
                    response,
                    stack,
                    runs,
                } = size(
                    &self.stack,
                    &self.environment,
                    &self.settings,
                    &self.limit,
                    &mut watch,
                )
                .map_err(fault)?;
                (
                    stack,
                    response,
                    Some(Thickness {
                        thickness_m,
                        with_margin_m,
                        runs,
                    }),
                )
            }
        };
        let mut findings = self.findings.clone();
        findings.extend(coverage::findings(&stack, &response));
        findings.extend(self.end_finding(&response));
        Ok(InDepth {
            name: name.to_string(),
            depths_m: self.settings.depths_m.clone(),
            limit: self.limit,
            stack,
            response,
            sized,
            findings,
        })
    }

    /// A remark that the bond was still getting warmer when the run ended.
    fn end_finding(&self, response: &Response) -> Option<Finding> {
        let peak = response.history.behind.get(self.limit.layer)?;
        let rises = peak.time_s >= response.end_s
            && response
                .history
                .rows
                .first()?
                .behind_k
                .get(self.limit.layer)?
                + 1.0
                < peak.temperature_k;
        rises.then(|| Finding {
            severity: Severity::Note,
            model: "in-depth".to_string(),
            key: tps::UNTIL_S.to_string(),
            value: Some(response.end_s),
            valid: (None, None),
            message: format!(
                "The temperature behind layer {} was still rising at the end of the run, {} s.",
                self.limit.layer + 1,
                crate::units::number::rounded(response.end_s, 6)
            ),
            source: "assumed".to_string(),
            field: Some(tps::UNTIL_S.to_string()),
        })
    }
}

/// Enthalpy of undissociated air against 298.15 K, at a wall without chemistry.
fn air(library: &Library) -> Vec<[f64; 2]> {
    let Some((_, world)) = library
        .planets
        .iter()
        .find(|(name, _)| name == "earth")
        .or(library.planets.first())
    else {
        return Vec::new();
    };
    let h = |t: f64| world.wall_gas.enthalpy_j_kg(t);
    let [first, last] = AIR_K;
    let rows = (first..=last).step_by(first).map(|t| t as f64);
    rows.map(|t| [t, h(t) - h(REFERENCE_TEMPERATURE_K)])
        .collect()
}

#[cfg(test)]
mod tests;
