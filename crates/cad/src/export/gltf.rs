//! glTF 2.0: one node, mesh and material per part, in meters, as text with embedded data or as one binary file.
//!
//! glTF is Y up: the vehicle stands upright, nose down, as it lands. The data keep the vehicle frame (x aft); a root
//! node rotates x to Y.
//!
//! # References
//! - \[gltf-2.0\].

use crate::export::Info;
use crate::export::mesh::{self, Mesh, MeshOptions};
use crate::export::model::{Model, Part};
use crate::export::stl::chord_error_m;
use numerics::math::pow;
use serde_json::{Map, Value, json};

/// Quaternion that rotates x to y, y to z and z to x: a third of a turn about (1, 1, 1).
const X_TO_Y: [f64; 4] = [0.5, 0.5, 0.5, 0.5];

/// Ratio of the chord error to that of STL: display needs less accuracy than printing.
const COARSER: f64 = 4.0;

/// Constants of the format.
const UNSIGNED_INT: u32 = 5125;
const FLOAT: u32 = 5126;
const ARRAY_BUFFER: u32 = 34962;
const ELEMENT_ARRAY_BUFFER: u32 = 34963;

/// The model as text, with the buffer in base 64.
pub fn gltf(model: &Model, info: &Info) -> String {
    let (mut document, data) = document(model, info);
    let uri = format!("data:application/octet-stream;base64,{}", base_64(&data));
    let buffer = json!([{ "byteLength": data.len(), "uri": uri }]);
    document.insert("buffers".to_owned(), buffer);
    let mut text = Value::Object(document).to_string();
    text.push('\n');
    text
}

/// The model as one binary file.
pub fn glb(model: &Model, info: &Info) -> Vec<u8> {
    let (mut document, data) = document(model, info);
    let buffer = json!([{ "byteLength": data.len() }]);
    document.insert("buffers".to_owned(), buffer);
    let mut text = Value::Object(document).to_string().into_bytes();
    while !text.len().is_multiple_of(4) {
        text.push(b' ');
    }
    let length = 12 + 8 + text.len() + 8 + data.len();
    let mut bytes = Vec::with_capacity(length);
    bytes.extend(b"glTF");
    bytes.extend(2_u32.to_le_bytes());
    bytes.extend((length as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", text), (b"BIN\0", data)] {
        bytes.extend((chunk.len() as u32).to_le_bytes());
        bytes.extend(kind);
        bytes.extend(chunk);
    }
    bytes
}

/// The JSON document without its buffer, and the buffer's bytes.
fn document(model: &Model, info: &Info) -> (Map<String, Value>, Vec<u8>) {
    let options = MeshOptions::whole(COARSER * chord_error_m(model));
    let mut store = Store::default();
    let (mut nodes, mut meshes, mut materials) = (Vec::new(), Vec::new(), Vec::new());
    for part in model.parts.iter().filter(|p| !p.profiles.is_empty()) {
        let mesh = mesh::mesh(&part.profiles, &options);
        let [positions, normals] =
            [&mesh.positions_m, &mesh.normals].map(|list| store.vectors(list));
        let indices = store.indices(&mesh);
        let index = meshes.len();
        meshes.push(json!({
            "name": part.name,
            "primitives": [{
                "attributes": { "POSITION": positions, "NORMAL": normals },
                "indices": indices,
                "material": index,
            }],
        }));
        materials.push(material(part));
        nodes.push(json!({ "name": part.name, "mesh": index }));
    }
    let children: Vec<usize> = (0..nodes.len()).collect();
    let root = nodes.len();
    nodes.push(json!({ "name": model.name, "rotation": X_TO_Y, "children": children }));
    let mut document = Map::new();
    let members = [
        (
            "asset",
            json!({
                "version": "2.0",
                "generator": info.program,
                "extras": { "frame": "meters; x aft, turned to Y up: the nose is down" },
            }),
        ),
        ("scene", json!(0)),
        ("scenes", json!([{ "name": model.name, "nodes": [root] }])),
        ("nodes", Value::Array(nodes)),
        ("meshes", Value::Array(meshes)),
        ("materials", Value::Array(materials)),
        ("accessors", Value::Array(store.accessors)),
        ("bufferViews", Value::Array(store.views)),
    ];
    for (name, member) in members {
        document.insert(name.to_owned(), member);
    }
    (document, store.data)
}

fn material(part: &Part) -> Value {
    let [red, green, blue] = part.color.map(linear);
    let name = part.substance.as_ref().map_or(&part.name, |s| &s.material);
    let look = json!({
        "baseColorFactor": [red, green, blue, 1.0],
        "metallicFactor": 0.0,
        "roughnessFactor": 0.8,
    });
    match &part.substance {
        None => json!({ "name": name, "pbrMetallicRoughness": look }),
        Some(substance) => json!({
            "name": name,
            "pbrMetallicRoughness": look,
            "extras": {
                "density_kg_m3": substance.density_kg_m3,
                "density_basis": substance.basis.name(),
            },
        }),
    }
}

/// Linear intensity of an sRGB value, to four digits.
fn linear(screen: u8) -> f64 {
    let c = f64::from(screen) / 255.0;
    let light = if c <= 0.04045 {
        c / 12.92
    } else {
        pow((c + 0.055) / 1.055, 2.4)
    };
    (light * 1e4).round() / 1e4
}

/// Buffer with its views and accessors.
#[derive(Default)]
struct Store {
    data: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Store {
    fn view(&mut self, from: usize, target: u32) -> usize {
        let length = self.data.len() - from;
        self.views.push(json!({
            "buffer": 0, "byteOffset": from, "byteLength": length, "target": target,
        }));
        self.views.len() - 1
    }

    fn vectors(&mut self, list: &[[f32; 3]]) -> usize {
        let from = self.data.len();
        let (mut least, mut most) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for vector in list {
            for ((v, least), most) in vector.iter().zip(&mut least).zip(&mut most) {
                (*least, *most) = (least.min(*v), most.max(*v));
                self.data.extend(v.to_le_bytes());
            }
        }
        let view = self.view(from, ARRAY_BUFFER);
        self.accessors.push(json!({
            "bufferView": view, "componentType": FLOAT, "count": list.len(), "type": "VEC3",
            "min": least, "max": most,
        }));
        self.accessors.len() - 1
    }

    fn indices(&mut self, mesh: &Mesh) -> usize {
        let from = self.data.len();
        for i in mesh.triangles.iter().flatten() {
            self.data.extend(i.to_le_bytes());
        }
        let view = self.view(from, ELEMENT_ARRAY_BUFFER);
        self.accessors.push(json!({
            "bufferView": view, "componentType": UNSIGNED_INT, "count": 3 * mesh.triangles.len(),
            "type": "SCALAR",
        }));
        self.accessors.len() - 1
    }
}

/// Base-64 encoding of bytes.
fn base_64(bytes: &[u8]) -> String {
    const LETTERS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for chunk in bytes.chunks(3) {
        let byte = |i: usize| u32::from(chunk.get(i).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for place in 0..4 {
            let letter = LETTERS.get((bits >> (18 - 6 * place) & 63) as usize);
            let padding = place > chunk.len();
            text.push(if padding {
                '='
            } else {
                letter.copied().map_or('=', char::from)
            });
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn base_64_of_the_words_of_rfc_4648() {
        let rows = [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foobar", "Zm9vYmFy"),
        ];
        for (plain, coded) in rows {
            assert_eq!(base_64(plain.as_bytes()), coded);
        }
    }

    #[test]
    fn middle_grey_of_the_screen_is_a_fifth_of_the_light() {
        // ((188/255 + 0.055) / 1.055)^2.4 = 0.5029
        assert_eq!((linear(0), linear(188), linear(255)), (0.0, 0.5029, 1.0));
    }
}
