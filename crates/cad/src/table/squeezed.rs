//! Normalized names and units of headings.
//!
//! # References
//! - Own convention.

/// A name in lower case without blanks and signs.
pub(super) fn squeezed(name: &str) -> String {
    name.chars()
        .filter(|c| c.is_alphanumeric() || *c == '®')
        .flat_map(char::to_lowercase)
        .map(|c| match c {
            // spreadsheets replace (R) by this sign
            '®' => 'r',
            '³' => '3',
            '²' => '2',
            c => c,
        })
        .collect()
}

/// A unit without slashes and power signs: kg/m³, kg m^-3 and kg/m**3 become `kgm3`.
pub(super) fn squeezed_unit(symbol: &str) -> String {
    if symbol.trim() == "\"" {
        return "\"".to_owned();
    }
    let lower = symbol
        .to_lowercase()
        .replace("°c", "c")
        .replace("°f", "f")
        .replace("°k", "k");
    let lower = lower
        .replace("°r", "r")
        .replace('°', "deg")
        .replace('⁻', "");
    let powers = lower.replace('⁰', "0").replace('¹', "1");
    squeezed(&powers)
}
