//! Reads data files of any kind from TOML.
//!
//! In the browser, where only shipped files are read, the reader of TOML stands in the program once and meets the struct of a file
//! through a table of functions: compiled for each struct anew it was a fifth of the page's worker. Elsewhere it is compiled for
//! each, and tells the line of each fault.

use serde::de::DeserializeOwned;

/// What is in the text of a data file, or what is wrong with it and where.
pub fn parse<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    #[cfg(target_family = "wasm")]
    return parse_once(text);
    #[cfg(not(target_family = "wasm"))]
    toml::from_str(text).map_err(|error| error.to_string())
}

/// As [`parse`], by one reader for all structs.
#[cfg(any(test, target_family = "wasm"))]
fn parse_once<T: DeserializeOwned>(text: &str) -> Result<T, String> {
    let reader = toml::Deserializer::parse(text).map_err(|error| error.to_string())?;
    let mut reader = <dyn erased_serde::Deserializer>::erase(reader);
    erased_serde::deserialize(&mut reader).map_err(|error| error.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde::Deserialize;

    #[derive(Debug, Deserialize)]
    #[serde(deny_unknown_fields)]
    struct Thing {
        #[serde(rename = "list")]
        _list: Vec<[f64; 2]>,
        #[serde(rename = "part")]
        _part: Option<Part>,
    }

    #[derive(Debug, Deserialize)]
    #[serde(tag = "kind", rename_all = "kebab-case", deny_unknown_fields)]
    enum Part {
        Solid {
            #[serde(rename = "density_kg_m3")]
            _density_kg_m3: f64,
        },
    }

    #[test]
    fn both_readers_give_the_same_and_refuse_the_same() {
        for text in [
            "list = [[1, 2]]\nother = 1\n",
            "list = [[1, 2, 3]]\n",
            "list = [[1, \"x\"]]\n",
            "\n\npart = { kind = \"sold\", density_kg_m3 = 1 }\nlist = []\n",
            "list = [",
            "part = 1",
        ] {
            assert!(parse_once::<Thing>(text).is_err(), "{text}");
            assert!(parse::<Thing>(text).unwrap_err().contains("line"), "{text}");
        }
        let good = "list = [[1, 2.5]]\n[part]\nkind = \"solid\"\ndensity_kg_m3 = 1e3\n";
        let [once, each] = [parse_once::<Thing>(good), parse(good)];
        assert_eq!(
            format!("{:?}", once.unwrap()),
            format!("{:?}", each.unwrap())
        );
    }

    #[test]
    fn a_shipped_file_is_the_same_by_both() {
        let text = include_str!("../data/planets/earth.toml");
        let once: crate::planet::Planet = parse_once(text).unwrap();
        assert_eq!(Ok(once), parse(text));
        let text = include_str!("../data/vehicles/mmeev.toml");
        let once: crate::vehicle::VehicleData = parse_once(text).unwrap();
        assert_eq!(Ok(once), parse(text));
    }
}
