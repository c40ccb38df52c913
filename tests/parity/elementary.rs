//! Elementary functions.

use numerics::math;

#[cfg(target_arch = "wasm32")]
use wasm_bindgen_test::wasm_bindgen_test as test;

/// Hash of the bits of many numbers (FNV-1a, 64 bit).
fn digest(numbers: impl Iterator<Item = f64>) -> u64 {
    numbers
        .flat_map(|number| number.to_bits().to_le_bytes())
        .fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
        })
}

/// 2000 arguments from −10 to 10, none of them round.
fn arguments() -> impl Iterator<Item = f64> {
    (0..2000).map(|i| (f64::from(i) - 999.7) / 99.97)
}

#[test]
fn functions_of_one_argument_give_the_recorded_bits() {
    type Row = (&'static str, fn(f64) -> f64, u64);
    let rows: [Row; 14] = [
        ("sin", math::sin, 0x6f57_5618_5580_9acb),
        ("cos", math::cos, 0x0f55_8f34_b2c4_c5ff),
        ("tan", math::tan, 0x6b4f_fed7_ddec_93c6),
        ("asin", |x| math::asin(x / 10.1), 0xe14d_ee74_d6a4_cb97),
        ("acos", |x| math::acos(x / 10.1), 0x9a30_bc27_de77_7083),
        ("atan", math::atan, 0x65ef_e118_fee7_67be),
        ("sinh", math::sinh, 0xb395_6df7_573c_7525),
        ("cosh", math::cosh, 0x6371_909a_86fc_edb5),
        ("tanh", math::tanh, 0x2ec2_4937_722f_5f4c),
        ("exp", math::exp, 0xd8e0_2f70_13b9_d980),
        ("ln", |x| math::ln(x.abs()), 0xced0_4863_69bc_8949),
        ("log10", |x| math::log10(x.abs()), 0xcf43_4a90_8fc5_3d17),
        ("cbrt", math::cbrt, 0xe3a8_a845_4ad8_e3ec),
        ("erf", math::erf, 0xae32_8149_949f_58d4),
    ];
    let found = rows.map(|(name, function, _)| (name, digest(arguments().map(function))));
    assert_eq!(found, rows.map(|(name, _, recorded)| (name, recorded)));
}

#[test]
fn functions_of_two_arguments_give_the_recorded_bits() {
    type Row = (&'static str, fn(f64, f64) -> f64, u64);
    let rows: [Row; 3] = [
        ("atan2", math::atan2, 0x0aab_e559_a9ce_bdb6),
        ("pow", |x, y| math::pow(x.abs(), y), 0xae46_a87f_b5ed_1a22),
        ("hypot", math::hypot, 0xaf55_2595_c553_738c),
    ];
    let found = rows.map(|(name, function, _)| {
        (
            name,
            digest(arguments().map(|x| function(x, 3.3 - 0.7 * x))),
        )
    });
    assert_eq!(found, rows.map(|(name, _, recorded)| (name, recorded)));
}
