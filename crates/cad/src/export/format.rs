//! Export formats, declared once: name, file name extension, media type, help, writer.

use crate::export::model::Model;
use crate::export::{Info, dxf, gltf, iges, step, stl, svg, table};
use serde::{Deserialize, Serialize};

/// File format.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Format {
    /// Solids: ISO 10303-21, application protocol 214.
    Step,
    /// Surfaces of revolution: IGES 5.3.
    Iges,
    /// Triangles of the outer surface, binary.
    Stl,
    /// Triangles of every part, as text.
    Gltf,
    /// The same content as [`Format::Gltf`], as one binary file.
    Glb,
    /// Lines and arcs of the half-section.
    Dxf,
    /// Segments of the half-section, as CSV.
    Csv,
    /// Dimensioned drawing of the section.
    Svg,
}

impl Format {
    /// All formats, in the order in which they are offered.
    pub const ALL: [Format; 8] = [
        Format::Step,
        Format::Iges,
        Format::Stl,
        Format::Gltf,
        Format::Glb,
        Format::Dxf,
        Format::Csv,
        Format::Svg,
    ];

    /// Name, as typed; also the file name extension.
    pub fn name(self) -> &'static str {
        match self {
            Format::Step => "step",
            Format::Iges => "iges",
            Format::Stl => "stl",
            Format::Gltf => "gltf",
            Format::Glb => "glb",
            Format::Dxf => "dxf",
            Format::Csv => "csv",
            Format::Svg => "svg",
        }
    }

    /// Content of the format, in one phrase.
    pub fn help(self) -> &'static str {
        match self {
            Format::Step => {
                "solids with true surfaces, names, materials and colors (STEP AP214, mm)"
            }
            Format::Iges => "surfaces of revolution (IGES 5.3, mm)",
            Format::Stl => "outer surface as triangles (binary STL, mm)",
            Format::Gltf => "triangles of every component (glTF 2.0, m, Y up)",
            Format::Glb => "the same as one binary file",
            Format::Dxf => {
                "lines and arcs of the half-section, one layer a component (AutoCAD 2000, mm)"
            }
            Format::Csv => "the same as a table (mm)",
            Format::Svg => "drawing of the section, to scale, with dimensions and legend",
        }
    }

    /// Media type.
    pub fn media_type(self) -> &'static str {
        match self {
            Format::Step => "model/step",
            Format::Iges => "model/iges",
            Format::Stl => "model/stl",
            Format::Gltf => "model/gltf+json",
            Format::Glb => "model/gltf-binary",
            Format::Dxf => "image/vnd.dxf",
            Format::Csv => "text/csv",
            Format::Svg => "image/svg+xml",
        }
    }

    /// Whether the format is text that a terminal can show.
    pub fn is_text(self) -> bool {
        !matches!(self, Format::Stl | Format::Glb)
    }

    /// The format with this name or file name extension.
    pub fn named(name: &str) -> Option<Format> {
        let name = match name.trim().to_ascii_lowercase().as_str() {
            "stp" => "step".to_owned(),
            "igs" => "iges".to_owned(),
            name => name.to_owned(),
        };
        Self::ALL.into_iter().find(|f| f.name() == name)
    }

    /// The model as a file in this format.
    pub fn write(self, model: &Model, info: &Info) -> Vec<u8> {
        match self {
            Format::Step => step::step(model, info).into_bytes(),
            Format::Iges => iges::iges(model, info).into_bytes(),
            Format::Stl => stl::stl(model),
            Format::Gltf => gltf::gltf(model, info).into_bytes(),
            Format::Glb => gltf::glb(model, info),
            Format::Dxf => dxf::dxf(model).into_bytes(),
            Format::Csv => table::csv(model).into_bytes(),
            Format::Svg => svg::svg(model, info).into_bytes(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_format_is_found_by_its_name() {
        for format in Format::ALL {
            assert_eq!(Format::named(format.name()), Some(format));
        }
        assert_eq!(Format::named("STEP"), Some(Format::Step));
        assert_eq!(Format::named("dwg"), None);
    }
}
