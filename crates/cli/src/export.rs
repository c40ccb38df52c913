//! Command `export`.

use crate::args::{Export, formats};
use crate::failure::Failure;
use crate::read::Data;
use crate::{Done, output, read, signal};
use cad::export::{Format, Info, Model};
use msape::progress::Progress;
use msape::quantity::input;
use msape::{Case, InputError, Library, Request, problem};
use std::path::Path;
use std::process::ExitCode;

/// Designs a case, or takes its outline, and writes it in a CAD, mesh or drawing format.
pub fn export(arguments: &Export, data: &Data) -> Done {
    let path = arguments.output.as_deref().filter(|p| *p != Path::new("-"));
    let format = format(arguments, path)?;
    if path.is_none() && !format.is_text() {
        return Err(Failure::input(format!(
            "--output: {} is not text; give the name of a file",
            format.name()
        )));
    }
    let mut loaded = read::asked(&arguments.source, path, data)?;
    let model = signal::stoppable(|progress| model(&loaded.case, &data.library, progress));
    let model = loaded.unless_at_fault(model)??;
    if signal::is_stopped() {
        return Err(Failure::Stopped);
    }
    loaded.tell();
    output::write(format.write(&model, &Info::default()), path)?;
    Ok(ExitCode::SUCCESS)
}

/// The requested format, or that of the file name extension.
fn format(arguments: &Export, path: Option<&Path>) -> Result<Format, Failure> {
    if let Some(format) = arguments.format {
        return Ok(match (format, path.and_then(ending)) {
            // an extension .glb selects the binary form
            (Format::Gltf, Some(Format::Glb)) => Format::Glb,
            (format, _) => format,
        });
    }
    path.and_then(ending).ok_or_else(|| {
        Failure::input(format!(
            "--format: give one of {}, or a file name that ends so",
            formats()
        ))
    })
}

fn ending(path: &Path) -> Option<Format> {
    Format::named(path.extension()?.to_str()?)
}

/// The model to export; inner error if there is no vehicle, outer error for faults of the case.
fn model(
    case: &Case,
    library: &Library,
    progress: &mut dyn Progress,
) -> Result<Result<Model, Failure>, Vec<InputError>> {
    let designed = case.gives_any(input::design::INPUTS);
    if !designed && let Some(body) = problem::rigid_body(case, library)? {
        return Ok(Ok(Model::of_body(&case.name, &body)));
    }
    let answer = problem::design_watched(case, library, Request::Nothing, progress)?;
    Ok(match &answer.design {
        Some(design) => Ok(Model::of_vehicle(&answer.name, &design.vehicle)),
        None => Err(Failure::input(format!(
            "there is no vehicle to export: the design is {}. {}",
            answer.outcome.name(),
            answer.reason.unwrap_or_default()
        ))),
    })
}
