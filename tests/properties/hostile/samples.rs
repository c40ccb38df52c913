//! Files to change: shipped cases, cases that once gave wrong results, and a table or drawing of each dialect.

use crate::designs::LIBRARY;
use cad::export::{Format, Info, Model};
use msape::quantity::input::find;
use msape::{Case, Request, problem};
use msape_tests::shipped;
use msape_tests::text::PLAIN;
use std::fs;
use std::path::Path;

/// Texts of the files in a folder of this crate, sorted by name.
fn folder(name: &str) -> Vec<String> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
    let mut paths: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .collect();
    paths.sort();
    paths
        .iter()
        .map(|path| fs::read_to_string(path).unwrap())
        .collect()
}

/// Cases as TOML and JSON.
pub(crate) fn cases() -> Vec<String> {
    let shipped = shipped::cases().unwrap();
    let json = shipped.iter().map(|case| case.case.to_json());
    let mut texts: Vec<String> = shipped
        .iter()
        .map(|case| case.text.to_string())
        .chain(json)
        .collect();
    texts.extend(folder("properties/robustness"));
    texts.push(PLAIN.to_string());
    texts
}

/// Tables by the key that names their file.
pub(crate) const TABLES: [(&str, &[&str]); 10] = [
    (
        "tps.environment",
        &[
            "t_s,p_Pa,CH_kg_m2s,h_r_J_kg\n0,101325,0,0\n0.1,101325,0.3,1.5e6\n60,101325,0.3,1.5e6\n",
            "# after the flight the wall only radiates\nh_r_J_kg;t_s;p_Pa;CH_kg_m2s;chemistry;q_rad_W_m2\n2e7;0;500;0.05;1;1e5\n0;60;500;0;0;0\n",
        ],
    ),
    (
        "tps.surface_temperature",
        &[
            "t_s,T_K,p_Pa\n0,300,101325\n0.1,1644,101325\n60,1644,101325\n",
            "t_s\tT_K\tp_Pa\trecession_m_s\n0\t300\t1e5\t0\n10\t2500\t1e5\t1e-5\n",
        ],
    ),
    (
        "atmosphere.file",
        &[
            "altitude_m,density_kg_m3,temperature_K,pressure_Pa\n0,1.2250,288.15,101325\n5000,0.7361,255.65,54020\n10000,0.4135,223.15,26436\n",
            "T [°C];Höhe (km);Dichte (g/m³)\n15,0;0;1225,0\n-56,5;11;364,8\n-56,5;20;88,9\n",
            "# Z, m\tT, K\tp, Pa\trho, kg/m3\n0\t288.15\t101325\t1.2250\n5000\t255.65\t54020\t0.7361\n10000\t223.15\t26436\t0.4135\n",
            "  0.0   1.2250\n 5000.0  0.7361\n10000.0  0.4135\n",
            "pressure_hPa,height_m,temperature_C\n1013.25,0,15\n540.2,5000,-17.5\n264.4,10000,-49.9\n",
            "sep=;\nh [m];rho [kg/m^3];speed of sound\n10000;0,4135;299,5\n\n5000;0,7361;320,5;\n0;1,2250;340,3\n",
            "geopotential altitude (m),rho (kg/m3)\n0,1.225000e+00\n51000,8.616060e-04\n71000,6.421100e-05\n",
            "-----\n   PRES   HGHT   TEMP   DWPT   RELH   MIXR   DRCT   SKNT\n    hPa     m      C      C      %    g/kg    deg   knot\n-----\n 1000.0    100   15.0   10.0     72   7.0    270      5\n  850.0   1500    5.0    0.0     70   4.6    280     15\n  500.0   5600  -20.0  -30.0     40   0.9    290     45\n",
        ],
    ),
    (
        "wind.file",
        &[
            "Altitude (ft);Speed (kt);Direction (deg)\n0;19,4;270\n30000;60,1;280\n",
            "altitude_m,eastward_m_s,northward_m_s\n0,5,1\n10000,20,-3\n50000,40,0\n",
        ],
    ),
    (
        "heating.file",
        &[
            "V [km/s];rho [kg/m3];q_conv [W/cm2];q_rad [W/cm2]\n8;1e-4;50,5;0\n8;1e-3;160;0\n12;1e-4;170;20\n12;1e-3;540;300\n",
            "8000,1e-4,1e5,0\n8000,1e-3,3e5,0\n9000,1e-4,2e5,1e4\n9000,1e-3,6e5,2e4\n",
            "r/R,speed_m_s,density_kg_m3,q\n0,8e3,1e-4,2e5\n0,8e3,1e-3,4e5\n0,9e3,1e-4,3e5\n0,9e3,1e-3,6e5\n1,8e3,1e-4,1e5\n1,8e3,1e-3,2e5\n1,9e3,1e-4,2e5\n1,9e3,1e-3,3e5\n",
        ],
    ),
    (
        "vehicle.drag_file",
        &[
            "0.01,0.33\n0.5,0.38\n1.0,0.63\n2.0,0.51\n",
            "Mach;CD (-);CL\n0,1;0,33;0\n0,9;0,45;0\n1,2;0,62;0\n",
        ],
    ),
    ("vehicle.lift_file", &["mach,cl\n0,0.1\n2,0.2\n"]),
    (
        "vehicle.bank_file",
        &[
            "t (s)  bank (deg)\n0  30\n10  30\n",
            "speed (km/s),bank (rad)\n0.5,0.1\n7,1.0\n",
        ],
    ),
    (
        "vehicle.aerodynamics.file",
        &[
            "mach,alpha_deg,ca,cn,cm\n0.5,0,1.4,0,0\n0.5,30,1.2,0.25,-0.1\n20,0,1.5,0,0\n20,30,1.3,0.25,-0.1\n",
            "\"mach\";\"alpha (deg)\";\"CD\";\"CL\"\n\"1\";\"0\";\"1,4\";\"0\"\n\"1\";\"30\";\"1,2\";\"-0,25\"\n",
            "0.01,0.33\n0.5,0.38\n1.0,0.63\n2.0,0.51\n",
        ],
    ),
    (
        "vehicle.aerodynamics.damping_file",
        &["mach,alpha_deg,cmq\n0.5,0,-0.1\n0.5,30,-0.2\n20,0,-0.3\n20,30,-0.4\n"],
    ),
];

const POINTS: [&str; 4] = [
    "x (mm); r (mm)\n0; 0\n500,0; 500\n500; 0\n",
    "x_m,r_m,bulge\n0,0,0.4142135623730951\n1,1,0\n1,0,0\n",
    "# nose\n0 0\n0.1 0.2\n0.5 0.4\n0.9 0\n",
    "x,r\nin,in\n0,0\n12,6\n20,0\n",
];

/// Curves and ignored entities, in one drawing.
const DRAWING: &str = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n1\n0\nLAYER\n2\nouter\n70\n0\n62\n7\n0\nENDTAB\n0\nENDSEC\n\
0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nnose\n70\n0\n10\n0\n20\n0\n0\nARC\n8\n0\n10\n100\n20\n0\n40\n100\n50\n90\n51\n180\n0\nENDBLK\n0\nENDSEC\n\
0\nSECTION\n2\nENTITIES\n0\nINSERT\n2\nnose\n10\n0\n20\n0\n41\n1\n42\n1\n50\n0\n\
0\nSPLINE\n70\n8\n71\n3\n72\n8\n73\n4\n40\n0\n40\n0\n40\n0\n40\n0\n40\n1\n40\n1\n40\n1\n40\n1\n10\n100\n20\n100\n10\n150\n20\n140\n10\n200\n20\n150\n10\n250\n20\n150\n\
0\nLWPOLYLINE\n90\n3\n70\n0\n10\n250\n20\n150\n42\n-0.2\n10\n280\n20\n120\n10\n300\n20\n60\n\
0\nELLIPSE\n10\n300\n20\n0\n11\n0\n21\n60\n40\n0.5\n41\n0\n42\n1.5707963267948966\n0\nLINE\n10\n0\n20\n0\n11\n1\n21\n0\n0\nTEXT\n1\nx\n0\nENDSEC\n0\nEOF\n";

/// Binary form of a drawing: the same pairs, each value with the type of its code.
fn binary(text: &str) -> Vec<u8> {
    let mut bytes = b"AutoCAD Binary DXF\r\n\x1a\0".to_vec();
    let lines: Vec<&str> = text.lines().map(str::trim).collect();
    for pair in lines.chunks_exact(2) {
        let code: u16 = pair[0].parse().unwrap();
        bytes.extend(code.to_le_bytes());
        match code {
            10..=59 | 110..=149 | 210..=239 => {
                bytes.extend(pair[1].parse::<f64>().unwrap().to_le_bytes())
            }
            60..=79 | 170..=179 | 270..=289 => {
                bytes.extend(pair[1].parse::<i16>().unwrap().to_le_bytes())
            }
            90..=99 => bytes.extend(pair[1].parse::<i32>().unwrap().to_le_bytes()),
            _ => {
                bytes.extend(pair[1].bytes());
                bytes.push(0);
            }
        }
    }
    bytes
}

/// A shipped vehicle and a known outline, to be exported.
pub(crate) fn models() -> Vec<Model> {
    let design = |text: &str| {
        let case = Case::from_text(text).unwrap();
        let answer = msape::design(&case, &LIBRARY, Request::Nothing).unwrap();
        Model::of_vehicle(&answer.name, &answer.design.unwrap().vehicle)
    };
    let mut apollo = Case::default();
    apollo.set("outline.preset", "apollo");
    let body = problem::rigid_body(&apollo, &LIBRARY).unwrap().unwrap();
    let shipped = msape::library::data_file("cases/msr-eev-pica.toml").unwrap();
    vec![design(shipped), Model::of_body("apollo", &body)]
}

/// Names and bytes of outlines: points, half-sections, drawings in text and binary.
pub(crate) fn outlines() -> Vec<(&'static str, Vec<u8>)> {
    let mut files: Vec<(&str, Vec<u8>)> = POINTS
        .iter()
        .map(|text| ("a.csv", text.as_bytes().to_vec()))
        .collect();
    for model in models() {
        files.push(("a.csv", Format::Csv.write(&model, &Info::default())));
        files.push(("a.dxf", Format::Dxf.write(&model, &Info::default())));
    }
    files.push(("a.dxf", DRAWING.as_bytes().to_vec()));
    files.push(("a.dxf", binary(DRAWING)));
    files
}

#[cfg(test)]
mod tests {
    use super::*;
    use cad::outline::read;

    /// The unchanged samples are valid.
    #[test]
    fn every_kind_of_table_has_samples() {
        let keys = TABLES.map(|(key, _)| key);
        for key in cad::table::files() {
            assert!(keys.contains(&key.key), "{key}");
        }
    }

    #[test]
    fn every_sample_is_read() {
        for (name, bytes) in outlines() {
            let unit = Some(cad::outline::LengthUnit::Millimeter);
            let read = read(name, &bytes, unit).unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
            assert!(read.rows.len() >= 3);
        }
        let earth = cad::table::Ground::earth(&LIBRARY);
        for (key, texts) in TABLES {
            for text in texts {
                let file = find(key).unwrap();
                let table = cad::table::read(file, text.as_bytes(), &earth);
                assert!(table.is_ok(), "{key}: {table:?}\n{text}");
            }
        }
    }

    #[test]
    fn text_and_binary_are_one_drawing() {
        let [text, binary] = [DRAWING.as_bytes().to_vec(), binary(DRAWING)]
            .map(|file| read("a.dxf", &file, None).unwrap());
        assert_eq!(text.rows, binary.rows);
    }
}
