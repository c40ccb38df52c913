use super::*;

#[test]
fn keys_stand_once_and_every_input_explains_itself() {
    let all: Vec<_> = inputs().collect();
    for (i, input) in all.iter().enumerate() {
        assert!(
            all[..i].iter().all(|other| other.key != input.key),
            "{}",
            input.key
        );
        assert!(
            !input.label.is_empty() && input.help.ends_with('.'),
            "{}",
            input.key
        );
        assert!(!input.source.is_empty(), "{}", input.key);
    }
}

#[test]
fn presets_and_usual_ranges_are_allowed() {
    for input in inputs() {
        let Kind::Number {
            allowed,
            usual,
            dimension,
            ..
        } = input.kind
        else {
            continue;
        };
        if let Preset::Number(value) = input.preset {
            assert!(allowed.contains(value), "{}", input.key);
        }
        if let Some((min, max)) = usual {
            assert!(
                allowed.contains(min) && allowed.contains(max) && min < max,
                "{}",
                input.key
            );
        }
        assert!(
            Unit::find(input.unit).is_some_and(|u| u.dimension == dimension),
            "{}",
            input.key
        );
    }
}

#[test]
fn a_key_ends_in_its_canonical_unit() {
    let suffix = |d: Dimension| match d {
        Dimension::Length => "_m",
        Dimension::Mass => "_kg",
        Dimension::Speed => "_m_s",
        Dimension::Angle => "_deg",
        Dimension::Density => "_kg_m3",
        Dimension::Time => "_s",
        Dimension::Load => "_earth_g",
        Dimension::Temperature => "_k",
        _ => "",
    };
    for input in inputs() {
        if let Kind::Number { dimension, .. } = input.kind {
            let sections = ["design.density_kg_m3.", "design.component_mass_kg."];
            let of_components = sections
                .iter()
                .any(|section| input.key.starts_with(section));
            assert!(
                of_components || input.key.ends_with(suffix(dimension)),
                "{}",
                input.key
            );
        }
    }
}
