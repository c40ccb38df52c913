//! Units of the quantities that a column may hold.
//!
//! ```text
//! SI = factor × number + offset
//! ```
//!
//! # Valid
//! The units listed.
//!
//! # References
//! - \[nist-sp-811\] appendix B for the factors.

use super::Quantity;
use crate::table::squeezed::squeezed_unit;
use numerics::math::PI;

/// Spellings of a unit, with factor and offset to SI.
type Unit = (&'static [&'static str], f64, f64);

const LENGTHS: &[Unit] = &[
    (
        &["m", "meter", "metre", "meters", "metres", "gpm", "mgp"],
        1.0,
        0.0,
    ),
    (
        &["km", "kilometers", "kilometres", "kmgp", "gpkm"],
        1000.0,
        0.0,
    ),
    (&["ft", "feet", "gpft"], 0.3048, 0.0),
    (&["kft"], 304.8, 0.0),
];
const SPEEDS: &[Unit] = &[
    (&["ms", "ms1", "mps"], 1.0, 0.0),
    (&["kms", "kms1"], 1000.0, 0.0),
    (&["kmh", "kmh1", "kph"], 1.0 / 3.6, 0.0),
    (&["kt", "kts", "kn", "knot", "knots"], 1852.0 / 3600.0, 0.0),
    (&["fts", "fts1", "fps"], 0.3048, 0.0),
    (&["mph"], 0.44704, 0.0),
];
const ANGLES: &[Unit] = &[
    (&["deg", "degree", "degrees"], 1.0, 0.0),
    (&["rad", "radian", "radians"], 180.0 / PI, 0.0),
];
const NUMBERS: &[Unit] = &[(&["1"], 1.0, 0.0)];

impl Quantity {
    /// Units with factor and offset; the first is assumed for a number without unit.
    pub fn units(self) -> (&'static str, &'static [Unit]) {
        match self {
            Self::Altitude | Self::CapitalH | Self::PressureAltitude => ("m, km, ft, kft", LENGTHS),
            Self::Geopotential => (
                "m, km, ft, kft, m2/s2",
                const {
                    &[
                        LENGTHS[0],
                        LENGTHS[1],
                        LENGTHS[2],
                        LENGTHS[3],
                        (&["m2s2", "jkg"], 1.0 / 9.80665, 0.0),
                    ]
                },
            ),
            Self::Density => (
                "kg/m3, g/m3, g/cm3, kg/km3, slug/ft3, lb/ft3",
                &[
                    (&["kgm3", "kgcum"], 1.0, 0.0),
                    (&["gm3"], 1e-3, 0.0),
                    (&["gcm3", "gcc", "kgl", "kgdm3"], 1e3, 0.0),
                    (&["kgkm3"], 1e-9, 0.0),
                    (
                        &["slugft3", "slugsft3", "slugcuft", "slugscuft"],
                        515.378818393195,
                        0.0,
                    ),
                    (&["lbft3", "lbmft3", "lbcuft"], 16.0184633739601, 0.0),
                ],
            ),
            Self::Temperature => (
                "K, C, F, R",
                &[
                    (&["k", "degk", "kelvin"], 1.0, 0.0),
                    (&["c", "degc", "celsius"], 1.0, 273.15),
                    (
                        &["f", "degf", "fahrenheit"],
                        5.0 / 9.0,
                        273.15 - 160.0 / 9.0,
                    ),
                    (&["r", "degr", "rankine"], 5.0 / 9.0, 0.0),
                ],
            ),
            Self::Pressure => (
                "Pa, hPa, kPa, mbar, bar, atm, torr, psi, psf",
                &[
                    (&["pa", "nm2", "pascal"], 1.0, 0.0),
                    (&["hpa", "mbar", "mb", "millibar"], 100.0, 0.0),
                    (&["kpa"], 1000.0, 0.0),
                    (&["bar"], 1e5, 0.0),
                    (&["atm"], 101325.0, 0.0),
                    (&["torr", "mmhg"], 101325.0 / 760.0, 0.0),
                    (&["psi", "lbin2", "lbfin2"], 6894.75729316836, 0.0),
                    (&["psf", "lbft2", "lbfft2"], 47.8802589803358, 0.0),
                ],
            ),
            Self::Eastward | Self::Northward | Self::WindSpeed | Self::Speed => {
                ("m/s, km/s, km/h, kt, ft/s, mph", SPEEDS)
            }
            Self::WindDirection | Self::Alpha | Self::Bank => ("deg, rad", ANGLES),
            Self::Time => (
                "s, min, h",
                &[
                    (&["s", "sec", "second", "seconds"], 1.0, 0.0),
                    (&["min", "minutes"], 60.0, 0.0),
                    (&["h", "hours"], 3600.0, 0.0),
                ],
            ),
            // the unit of an outline applies to x and r together
            Self::X | Self::R => (
                "m, cm, mm, in, ft",
                &[
                    (&["m", "meter", "metre", "meters", "metres"], 1.0, 0.0),
                    (&["cm"], 0.01, 0.0),
                    (&["mm"], 0.001, 0.0),
                    (&["in", "inch", "inches", "\""], 0.0254, 0.0),
                    (&["ft", "feet", "foot"], 0.3048, 0.0),
                ],
            ),
            Self::Convective | Self::Radiative | Self::TotalHeat => (
                "W/m2, kW/m2, MW/m2, W/cm2, BTU/ft2s",
                &[
                    (&["wm2"], 1.0, 0.0),
                    (&["kwm2"], 1e3, 0.0),
                    (&["mwm2"], 1e6, 0.0),
                    (&["wcm2"], 1e4, 0.0),
                    (
                        &["btuft2s", "btusft2", "btuft2sec"],
                        11_356.526_682_225_8,
                        0.0,
                    ),
                ],
            ),
            // fractions of the largest radius, or of the whole length
            Self::RadiusFraction | Self::ArcFraction => (
                "none",
                &[(
                    &["1", "r", "rmax", "rb", "s", "smax", "l", "lmax"],
                    1.0,
                    0.0,
                )],
            ),
            _ => ("none", NUMBERS),
        }
    }

    /// Factor and offset of a unit as written in a file; those of the first unit where the file names none.
    pub fn unit(self, symbol: &str) -> Option<(f64, f64)> {
        let plain = squeezed_unit(symbol);
        let (_, units) = self.units();
        let found = if plain.is_empty() {
            units.first()
        } else {
            units
                .iter()
                .find(|(spellings, ..)| spellings.contains(&plain.as_str()))
        };
        found.map(|(_, factor, offset)| (*factor, *offset))
    }
}
