use super::*;
use crate::vehicle::body::shape::Aft;

fn stardust() -> Shape {
    Shape {
        diameter_m: 0.8128,
        nose_radius_m: 0.2286,
        shoulder_radius_m: 0.01905,
        cone_half_angle_rad: Some(math::PI / 3.0),
        aft: Aft::Flat,
    }
}

#[test]
fn layer_of_stardust_is_0_0323_m3() {
    // cap 2π (1 − 0.86603) (0.2286³ − 0.1704³)/3 = 0.84178 × 0.0069985/3 = 0.0019637;
    // cone L = 0.2921/0.86603 = 0.33729, 2π L (0.26035 × 0.0582 − 0.25 × 0.0582²) = 2.11925 × 0.0143056 = 0.0303171
    let volume = shell_volume_m3(&stardust(), math::PI / 3.0, 0.0582);
    assert!((volume - 0.0322808).abs() < 1e-6, "{volume}");
}

#[test]
fn thin_layer_is_area_times_thickness() {
    // area of cap 2π Rₙ² (1 − sin θ) = 0.043990, of cone 2π L r̄ = 0.551747 m²
    let volume = shell_volume_m3(&stardust(), math::PI / 3.0, 1e-7);
    assert!((volume / 1e-7 - 0.595737).abs() < 1e-5, "{volume}");
}

#[test]
fn a_band_that_meets_what_flew_is_a_hit_and_one_beside_it_a_miss() {
    let flown = FlownValue {
        least: 16.0,
        greatest: 17.0,
        source: "assumed".into(),
        place: "here".into(),
    };
    let verdict =
        |least, greatest| row("x", "m", "kg", [18.0, least, greatest], Some(&flown)).verdict;
    assert_eq!(verdict(16.9, 19.0), Verdict::Hit);
    assert_eq!(verdict(16.2, 16.8), Verdict::Hit);
    assert_eq!(verdict(17.1, 19.0), Verdict::Miss);
    assert_eq!(verdict(14.0, 15.9), Verdict::Miss);
    assert_eq!(
        row("x", "m", "kg", [18.0, 17.0, 19.0], None).verdict,
        Verdict::NotKnown
    );
}

#[test]
fn four_capsules_close_on_their_mass_and_their_bands_hold_what_they_predict() {
    let library = Library::builtin().unwrap();
    let capsules = capsules(&library).unwrap();
    let names: Vec<&str> = capsules.iter().map(|c| c.name.as_str()).collect();
    assert_eq!(names, ["genesis", "hayabusa", "hayabusa2", "stardust"]);
    for capsule in &capsules {
        let [thickness, heat_shield, entry] = &capsule.rows[..] else {
            panic!("three rows")
        };
        for row in &capsule.rows {
            assert!(
                row.least < row.predicted && row.predicted < row.greatest,
                "{row:?}"
            );
        }
        // the relation of each material has 6.3 or 7.3 %
        let part = (thickness.greatest - thickness.predicted) / thickness.predicted;
        assert!((0.063..0.0731).contains(&(part + 1e-9)), "{part}");
        // closed: what is given and the heat shield make the entry mass
        let (_, text) = data_folder("predictions")
            .find(|(path, _)| path.ends_with(&format!("/{}.toml", capsule.name)))
            .unwrap();
        let file: File = toml::from_str(text).unwrap();
        let sum = file.equipment.mass_kg + heat_shield.predicted;
        assert!((sum - entry.predicted).abs() < 1e-6, "{}", capsule.name);
    }
}

#[test]
fn given_mass_of_stardust_is_its_entry_mass_less_the_heat_shield_that_flew() {
    // 45.8 kg − 266 kg/m³ × 0.032281 m³ = 45.8 − 8.587 = 37.2 kg
    let library = Library::builtin().unwrap();
    let density = named(&library.materials, "pica")
        .unwrap()
        .density
        .density_kg_m3;
    let flown = density * shell_volume_m3(&stardust(), math::PI / 3.0, 0.0582);
    assert!((45.8 - flown - 37.2).abs() < 0.05, "{flown}");
}
