//! Choices whose names are fixed: each is an enum that carries its name in a case and its label.
//!
//! From the one declaration come the list of an input, what [`crate::case::Reader::choice`] reads, and the enum that
//! physics matches on, so that a new model does not compile until every match knows it.

use super::input::Choices;
use serde::{Deserialize, Serialize};

/// A choice of a fixed list.
pub trait Choice: Copy + 'static {
    /// All choices, each with its name in a case and its label.
    const ALL: &'static [(Self, &'static str, &'static str)];
    /// Names and labels of all, for an input that takes each of them.
    const CHOICES: Choices;

    /// The choice with this name; `None` if there is none.
    fn named(name: &str) -> Option<Self> {
        let mut all = Self::ALL.iter();
        all.find_map(|(choice, known, _)| (*known == name).then_some(*choice))
    }
}

/// Declares a choice: for each variant its name in a case and its label.
macro_rules! choice {
    (
        $(#[$about:meta])*
        $choice:ident { $($(#[$doc:meta])* $variant:ident = $name:literal, $label:literal;)+ }
    ) => {
        $(#[$about])*
        #[derive(Clone, Copy, Debug, PartialEq, Eq)]
        pub enum $choice {
            $($(#[$doc])* $variant,)+
        }

        impl Choice for $choice {
            const ALL: &'static [(Self, &'static str, &'static str)] =
                &[$((Self::$variant, $name, $label)),+];
            const CHOICES: Choices = Choices::Fixed(&[$(($name, $label)),+]);
        }

        impl $choice {
            /// Name in a case.
            pub const fn name(self) -> &'static str {
                self.entry().0
            }

            /// Name and label, for an input that takes some of the choices.
            const fn entry(self) -> (&'static str, &'static str) {
                match self {
                    $(Self::$variant => ($name, $label),)+
                }
            }
        }
    };
}

choice! {
    /// Reference frame of speed, flight-path angle and azimuth at entry.
    Frame {
        /// Frame that rotates with the planet.
        Relative = "relative", "Relative to the planet";
        /// Inertial frame.
        Inertial = "inertial", "Inertial";
    }
}

choice! {
    /// Relation for convective heating.
    ConvectiveModel {
        /// Sutton and Graves.
        SuttonGraves = "sutton-graves", "SuttonGraves";
        /// Brandis and Johnston.
        BrandisJohnston = "brandis-johnston", "BrandisJohnston";
    }
}

choice! {
    /// Condition behind the last layer of a heat shield in depth.
    BackFace {
        /// No heat flows.
        Adiabatic = "adiabatic", "Adiabatic";
        /// Held at a temperature.
        Held = "held", "Held at a temperature";
        /// Radiates, with a film if wanted.
        Radiating = "radiating", "Radiates, with a film";
    }
}

choice! {
    /// Shape of the surfaces of equal depth of a heat shield.
    NormalGeometry {
        /// Planes.
        Planar = "planar", "Planar";
        /// Cylinders.
        Cylindrical = "cylindrical", "Cylindrical";
        /// Spheres.
        Spherical = "spherical", "Spherical";
    }
}

choice! {
    /// Relation for radiative heating.
    RadiativeModel {
        /// Tauber and Sutton.
        TauberSutton = "tauber-sutton", "TauberSutton";
        /// Brandis and Johnston.
        BrandisJohnston = "brandis-johnston", "BrandisJohnston";
        /// No radiation.
        None = "none", "None";
    }
}

choice! {
    /// Wall condition for convective heating.
    WallModel {
        /// Cold wall.
        Cold = "cold", "Cold wall";
        /// Hot wall in radiative equilibrium.
        RadiativeEquilibrium = "radiative-equilibrium", "Hot wall in radiative equilibrium";
    }
}

choice! {
    /// Model of the stagnation pressure.
    PressureModel {
        /// Cp,max = 2, which bounds every gas.
        NewtonianLimit = "newtonian-limit", "Newtonian limit, twice the dynamic pressure";
        /// The report's fit to Navier-Stokes results.
        Equation9 = "equation-9", "Equation 9, fit to Navier-Stokes results";
        /// Equations 10 to 12 with the ratio of specific heats of the undisturbed air.
        PerfectGas = "perfect-gas", "Perfect gas, equations 10 to 12";
    }
}

choice! {
    /// Point at which the heat shield of a part is sized.
    JudgedAt {
        /// The hottest point of the part, shoulder included.
        HottestPoint = "hottest-point", "Hottest point of each part, shoulder included";
        /// The stagnation point, whatever the heating of the shoulder.
        StagnationPoint = "stagnation-point", "Stagnation point";
    }
}

choice! {
    /// Method by which the equations of motion are integrated.
    MethodName {
        /// Dormand and Prince, order 5(4).
        DormandPrince54 = "dormand-prince-54", "Runge-Kutta of order 5(4), adaptive";
        /// Dormand and Prince, order 8(5,3).
        DormandPrince853 = "dormand-prince-853", "Runge-Kutta of order 8(5,3), adaptive";
        /// Classical Runge-Kutta method of order 4.
        Rk4 = "rk4", "Classical Runge-Kutta of order 4, fixed step";
    }
}

choice! {
    /// Flight model.
    #[derive(Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    FlightModel {
        /// Three degrees of freedom, integrated.
        ThreeDof = "three-dof", "Three degrees of freedom, integrated";
        /// Six degrees of freedom, integrated: point mass and attitude of a rigid body.
        SixDof = "six-dof", "Six degrees of freedom, integrated";
        /// The closed form of Allen and Eggers.
        AllenEggers = "allen-eggers", "Closed form of Allen and Eggers";
    }
}

impl FlightModel {
    /// Models of a point mass that a case can choose; the attitude comes with `vehicle.dof`.
    pub(super) const OF_POINT_MASS: Choices =
        Choices::Fixed(&[Self::ThreeDof.entry(), Self::AllenEggers.entry()]);
}

choice! {
    /// Extrapolation beyond the ends of a table.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    Extrapolation {
        /// The value at the end.
        #[default]
        Hold = "hold", "Hold the end";
        /// The straight line with the last slope.
        Extend = "extend", "Extend with the last slope";
        /// Nothing: a place beyond the table is a fault, and a flight ends there.
        Refuse = "refuse", "Refuse";
    }
}

impl Extrapolation {
    /// Choices for tables that cannot be extended.
    pub(super) const HELD: Choices = Choices::Fixed(&[Self::Hold.entry(), Self::Refuse.entry()]);
    /// Choices for heating tables, the default first.
    pub(super) const OF_HEATING: Choices = Choices::Fixed(&[
        Self::Extend.entry(),
        Self::Hold.entry(),
        Self::Refuse.entry(),
    ]);
    /// Choices for the atmosphere, whose density is never held constant.
    pub(super) const OF_AIR: Choices = Choices::Fixed(&[
        (Self::Extend.name(), "Density goes on with its last slope"),
        Self::Refuse.entry(),
    ]);
}

choice! {
    /// Model of pitch damping.
    DampingModel {
        /// Equation 7 of the report, corrected.
        Report = "report", "Equation 7 corrected, placeholder for Viking (assumed)";
        /// Equation 7 of the report, as printed.
        ReportPrinted = "report-printed", "Equation 7 with the radius of gyration as printed, placeholder for Viking (assumed)";
        /// No damping.
        None = "none", "None";
    }
}

choice! {
    /// How continuum and free-molecular flow are bridged.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "kebab-case")]
    Bridging {
        /// Sine squared.
        #[default]
        SineSquared = "sine-squared", "Sine squared, Knudsen number 0.001 to 10";
        /// Error function.
        ErrorFunction = "error-function", "Error function about Knudsen number 0.1";
    }
}

choice! {
    /// Law that determines the strength of the impact foam.
    #[derive(Default, Serialize, Deserialize)]
    FoamStrength {
        /// The law by which the landing is judged: energy over the volume that is crushed.
        #[default]
        CrushLaw = "crush-law", "Crush law";
        /// Equation 6 as printed: energy over the payload's cross-section and the stroke.
        Equation6 = "equation-6", "Equation 6";
    }
}

choice! {
    /// Mass that crushes the impact foam.
    #[derive(Default, Serialize, Deserialize)]
    CrushingMass {
        /// The payload alone, as in equations 4 and 6.
        #[default]
        Payload = "payload", "Payload";
        /// The whole impact sphere of the MSR concept, which moves with the payload.
        ImpactSphere = "impact-sphere", "Impact sphere with payload";
    }
}

choice! {
    /// Aft shape of a sphere-cone given by its dimensions.
    AftOfCone {
        /// A disc.
        Flat = "flat", "Flat disc";
        /// A face 15 deg from the plane normal to the axis and a spherical lid.
        Mmeev = "mmeev", "Face of 15 deg and spherical lid";
    }
}

choice! {
    /// A unit of length that files are drawn in.
    LengthUnit {
        /// Meter.
        Meter = "m", "m";
        /// Centimeter.
        Centimeter = "cm", "cm";
        /// Millimeter.
        Millimeter = "mm", "mm";
        /// Inch.
        Inch = "in", "in";
        /// Foot.
        Foot = "ft", "ft";
    }
}

choice! {
    /// Direction in which a quantity crosses a value.
    Direction {
        /// Downwards.
        Falling = "falling", "Falling";
        /// Upwards.
        Rising = "rising", "Rising";
    }
}

#[cfg(test)]
mod tests {
    use super::super::input::{Kind, Preset, inputs};
    use super::*;

    #[test]
    fn a_choice_is_found_by_its_name_alone() {
        assert_eq!(Frame::named("inertial"), Some(Frame::Inertial));
        assert_eq!(Frame::named("Inertial"), None);
        for (model, name, _) in PressureModel::ALL {
            assert_eq!(model.name(), *name);
        }
    }

    #[test]
    fn a_default_is_one_of_the_choices() {
        for input in inputs() {
            if let (Kind::Choice(Choices::Fixed(fixed)), Preset::Name(preset)) =
                (input.kind, input.preset)
            {
                assert!(fixed.iter().any(|(name, _)| *name == preset), "{input}");
            }
        }
    }
}
