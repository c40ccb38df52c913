//! The heat shield in depth of a case: `[tps]`, with an environment of its own or that of the case's flight.

mod layers;
mod wall;

use crate::ablation::sizing::{Limit, Sized, size};
use crate::ablation::{Cards, coverage};
use crate::case::{Case, InputError, Reader};
use crate::finding::{Finding, Severity};
use crate::library::Library;
use crate::progress::Progress;
use crate::quantity::choice::{BackFace, NormalGeometry};
use crate::quantity::input::{Input, tps};
use ::ablation::environment::Environment;
use ::ablation::geometry::Geometry;
use ::ablation::grid::Resolution;
use ::ablation::march::{Response, Run};
use ::ablation::settings::{Settings, Until};
use ::ablation::solid::REFERENCE_TEMPERATURE_K;
use ::ablation::stack::{Back, Stack};
use ::ablation::wall::WallSettings;
use std::ops::ControlFlow;

/// Longest time of a run without `tps.until_s` after the last row of its environment, s. Assumed: longer than any soak.
const LONGEST_S: f64 = 20_000.0;
/// Most steps of a run, those that are taken back included.
const MOST_STEPS: usize = 200_000;
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
        let geometry = geometry(&mut reader);
        let back = back(&mut reader);
        let settings = environment
            .as_ref()
            .and_then(|environment| settings(&mut reader, environment));
        let limit = limit(&mut reader);
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

fn geometry(reader: &mut Reader) -> Option<Geometry> {
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

fn back(reader: &mut Reader) -> Option<Back> {
    let back: BackFace = reader.choice(&tps::BACK)?;
    let initial = reader.number(&tps::INITIAL_TEMPERATURE_K)?;
    let temperature_k = match reader.given(&tps::BACK_TEMPERATURE_K) {
        true => reader.number(&tps::BACK_TEMPERATURE_K)?,
        false => initial,
    };
    Some(match back {
        BackFace::Adiabatic => Back::Adiabatic,
        BackFace::Held => Back::Held { temperature_k },
        BackFace::Radiating => Back::Exposed {
            temperature_k,
            emissivity: reader.number(&tps::BACK_EMISSIVITY)?,
            film_w_m2k: reader.number(&tps::BACK_FILM_W_M2K)?,
        },
    })
}

fn limit(reader: &mut Reader) -> Option<Limit> {
    let layer = reader.number(&tps::BOND_LAYER)?;
    let limit = reader.number(&tps::BOND_LIMIT_K)?;
    let margin = reader.number(&tps::TEMPERATURE_MARGIN_K)?;
    Some(Limit {
        layer: layer as usize - 1,
        temperature_k: limit - margin,
        recession_margin: reader.number(&tps::RECESSION_MARGIN)?,
    })
}

fn settings(reader: &mut Reader, environment: &Environment) -> Option<Settings> {
    let number = |reader: &mut Reader, input: &'static Input| reader.number(input);
    let layer = number(reader, &tps::BOND_LAYER)? as usize - 1;
    let last_s = environment.times_s().last().copied().unwrap_or_default();
    let until = match reader.given(&tps::UNTIL_S) {
        true => Until::Time(number(reader, &tps::UNTIL_S)?),
        false => Until::Cooled {
            layer,
            at_most_s: last_s + LONGEST_S,
        },
    };
    let depths_m = match reader.given(&tps::DEPTHS_M) {
        true => reader.rows(&tps::DEPTHS_M)?.concat(),
        false => Vec::new(),
    };
    let wall = WallSettings {
        blowing: number(reader, &tps::BLOWING)?,
        recession: reader.flag(&tps::RECESSION)?,
        sink_temperature_k: number(reader, &tps::SINK_TEMPERATURE_K)?,
    };
    Some(Settings {
        initial_temperature_k: number(reader, &tps::INITIAL_TEMPERATURE_K)?,
        wall,
        until,
        output_step_s: Some(number(reader, &tps::OUTPUT_STEP_S)?),
        depths_m,
        resolution: Resolution {
            cells: number(reader, &tps::CELLS)? as usize,
            ..Resolution::default()
        },
        tolerance_k: number(reader, &tps::TOLERANCE_K)?,
        most_steps: MOST_STEPS,
    })
}

#[cfg(test)]
mod tests;
