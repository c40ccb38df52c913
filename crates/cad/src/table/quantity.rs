//! Quantities that a column may hold: their names and units.
//!
//! ```text
//! SI = factor × number + offset
//! ```
//!
//! with the factor in SI units per unit of the file; angles come out in deg.
//!
//! # Valid
//! The names and units listed.
//!
//! # References
//! - \[nist-sp-811\] appendix B for the factors.

mod unit;

/// Quantity of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    Altitude,
    Geopotential,
    /// Column "H", which is geopotential in standard atmospheres and geometric elsewhere.
    CapitalH,
    PressureAltitude,
    Density,
    Temperature,
    Pressure,
    Eastward,
    Northward,
    WindSpeed,
    WindDirection,
    Mach,
    Alpha,
    Knudsen,
    AxialForce,
    NormalForce,
    Drag,
    Lift,
    Moment,
    PitchDamping,
    Time,
    Speed,
    Bank,
    X,
    R,
    Bulge,
    Convective,
    Radiative,
    /// Sum of convective and radiative heat flux.
    TotalHeat,
    /// Distance from the axis divided by the largest radius.
    RadiusFraction,
    /// Length along the outline divided by that to the largest radius.
    ArcFraction,
}

impl Quantity {
    /// Name, and its synonyms in lower case without blanks and signs.
    pub fn names(self) -> (&'static str, &'static [&'static str]) {
        match self {
            Self::Altitude => (
                "altitude",
                &[
                    "altitude",
                    "alt",
                    "height",
                    "h",
                    "z",
                    "elevation",
                    "geometricaltitude",
                    "geometricheight",
                    "altitudegeometric",
                    "heightgeometric",
                    "geometricalt",
                    "geomalt",
                    "hgeom",
                    "altitudemsl",
                    "heightmsl",
                    "altitudeamsl",
                    "höhe",
                    "hoehe",
                    "hauteur",
                    "quota",
                    "altura",
                    "altitud",
                ],
            ),
            Self::Geopotential => (
                "geopotential altitude",
                &[
                    "geopotentialaltitude",
                    "geopotentialheight",
                    "altitudegeopotential",
                    "heightgeopotential",
                    "geopotential",
                    "geopotentialalt",
                    "geopalt",
                    "geopheight",
                    "gph",
                    "gpheight",
                    "gpm",
                    "hght",
                    "hgeop",
                    "hgp",
                ],
            ),
            Self::CapitalH => ("altitude", &[]),
            Self::PressureAltitude => (
                "pressure altitude",
                &[
                    "pressurealtitude",
                    "pressurealt",
                    "pressureheight",
                    "altitudepressure",
                    "palt",
                    "presalt",
                ],
            ),
            Self::Density => (
                "density",
                &[
                    "density",
                    "rho",
                    "ρ",
                    "dens",
                    "airdensity",
                    "massdensity",
                    "staticdensity",
                    "dichte",
                    "densité",
                    "densità",
                    "densidad",
                ],
            ),
            Self::Temperature => (
                "temperature",
                &[
                    "temperature",
                    "temp",
                    "t",
                    "tmp",
                    "tmpc",
                    "airtemperature",
                    "statictemperature",
                    "temperatur",
                    "température",
                    "temperatura",
                ],
            ),
            Self::Pressure => (
                "pressure",
                &[
                    "pressure",
                    "press",
                    "p",
                    "pres",
                    "airpressure",
                    "staticpressure",
                    "druck",
                    "pression",
                    "pressione",
                    "presión",
                ],
            ),
            Self::Eastward => (
                "eastward wind",
                &[
                    "eastward",
                    "eastwardwind",
                    "east",
                    "u",
                    "ew",
                    "uew",
                    "zonal",
                    "zonalwind",
                    "uwind",
                    "windu",
                    "ewwind",
                ],
            ),
            Self::Northward => (
                "northward wind",
                &[
                    "northward",
                    "northwardwind",
                    "north",
                    "v",
                    "ns",
                    "vns",
                    "meridional",
                    "meridionalwind",
                    "vwind",
                    "windv",
                    "nswind",
                ],
            ),
            Self::WindSpeed => (
                "wind speed",
                &[
                    "windspeed",
                    "speed",
                    "wspd",
                    "sknt",
                    "sped",
                    "wind",
                    "windvelocity",
                    "smps",
                    "ff",
                ],
            ),
            Self::WindDirection => (
                "wind direction",
                &[
                    "winddirection",
                    "winddir",
                    "direction",
                    "wdir",
                    "drct",
                    "dir",
                    "dd",
                ],
            ),
            Self::Mach => ("mach", &["mach", "m", "ma", "machnumber", "machzahl"]),
            Self::Alpha => (
                "alpha_deg",
                &[
                    "alpha",
                    "aoa",
                    "angleofattack",
                    "totalangleofattack",
                    "totalaoa",
                    "totalalpha",
                    "alfa",
                    "α",
                ],
            ),
            Self::Knudsen => ("knudsen", &["kn", "knudsen", "knudsennumber"]),
            Self::AxialForce => (
                "ca",
                &["ca", "caxial", "axialforcecoefficient", "capoweroff"],
            ),
            Self::NormalForce => ("cn", &["cn", "cnormal", "normalforcecoefficient"]),
            Self::Drag => (
                "cd",
                &[
                    "cd",
                    "dragcoefficient",
                    "coefficientofdrag",
                    "cx",
                    "cw",
                    "drag",
                ],
            ),
            Self::Lift => (
                "cl",
                &["cl", "liftcoefficient", "coefficientoflift", "lift"],
            ),
            Self::Moment => ("cm", &["cm", "cmapex", "pitchingmomentcoefficient"]),
            Self::PitchDamping => ("cmq", &["cmq", "pitchdamping"]),
            Self::Time => ("time", &["time", "t", "seconds", "zeit", "temps"]),
            Self::Speed => ("speed", &["speed", "velocity", "v", "airspeed"]),
            Self::Bank => ("bank", &["bank", "bankangle", "sigma", "σ"]),
            Self::X => ("x", &["x", "z", "axial", "station"]),
            Self::R => ("r", &["r", "y", "radius", "radial"]),
            Self::Bulge => ("bulge", &["bulge"]),
            Self::Convective => (
                "convective",
                &[
                    "convective",
                    "qconv",
                    "qdotconv",
                    "qconvective",
                    "qc",
                    "convectiveheatflux",
                    "convectiveheatrate",
                    "convectiveheating",
                    "heatfluxconvective",
                ],
            ),
            Self::Radiative => (
                "radiative",
                &[
                    "radiative",
                    "qrad",
                    "qdotrad",
                    "qradiative",
                    "qr",
                    "radiativeheatflux",
                    "radiativeheatrate",
                    "radiativeheating",
                    "heatfluxradiative",
                ],
            ),
            Self::TotalHeat => (
                "total",
                &[
                    "total",
                    "qtot",
                    "qdottot",
                    "qtotal",
                    "q",
                    "qdot",
                    "qw",
                    "heatflux",
                    "heatrate",
                    "totalheatflux",
                    "totalheatrate",
                    "heatfluxtotal",
                    "wallheatflux",
                ],
            ),
            Self::RadiusFraction => (
                "r fraction",
                &[
                    "r",
                    "radius",
                    "rfraction",
                    "radiusfraction",
                    "fractionofradius",
                ],
            ),
            Self::ArcFraction => (
                "s fraction",
                &[
                    "s",
                    "arc",
                    "sfraction",
                    "arcfraction",
                    "arclength",
                    "fractionofarc",
                ],
            ),
        }
    }
}
