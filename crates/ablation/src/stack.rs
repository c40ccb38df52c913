//! Layers from the wall inwards, and the back.

use crate::contact::Joint;
use crate::fault::Fault;
use crate::gas::Gas;
use crate::geometry::Geometry;
use crate::reaction::Reaction;
use crate::solid::Solid;
use crate::surface::Surface;

/// Pyrolysis of a material.
#[derive(Clone, Debug, PartialEq)]
pub struct Pyrolysis {
    /// Reactions; their losses are the difference of virgin and char density.
    pub reactions: Vec<Reaction>,
    /// Gas that they set free.
    pub gas: Gas,
    /// Permeability, virgin and char, m².
    pub permeability_m2: [f64; 2],
}

/// A material.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// Name.
    pub name: String,
    /// Solid.
    pub solid: Solid,
    /// Pyrolysis, if it chars.
    pub pyrolysis: Option<Pyrolysis>,
    /// Chemistry when it is the wall.
    pub surface: Surface,
}

impl Material {
    /// The material, checked.
    ///
    /// # Errors
    /// Reactions beyond their ranges, or that do not add up to the difference of the densities; impermeable solids.
    pub fn try_new(
        name: String,
        solid: Solid,
        pyrolysis: Option<Pyrolysis>,
        surface: Surface,
    ) -> Result<Self, Fault> {
        if let Some(pyrolysis) = &pyrolysis {
            let mut total = 0.0;
            for reaction in &pyrolysis.reactions {
                reaction.check()?;
                total += reaction.loss_kg_m3;
            }
            let loss = solid.virgin.density_kg_m3 - solid.char.density_kg_m3;
            if (total - loss).abs() > 1e-6 * solid.virgin.density_kg_m3 {
                return Err(Fault::Range {
                    of: "reactions",
                    key: "density_kg_m3",
                    value: total,
                    least: loss,
                    most: loss,
                });
            }
            for value in pyrolysis.permeability_m2 {
                if !(f64::MIN_POSITIVE..=1.0).contains(&value) {
                    return Err(Fault::Range {
                        of: "pyrolysis",
                        key: "permeability_m2",
                        value,
                        least: f64::MIN_POSITIVE,
                        most: 1.0,
                    });
                }
            }
        }
        Ok(Self {
            name,
            solid,
            pyrolysis,
            surface,
        })
    }
}

/// A layer.
#[derive(Clone, Debug, PartialEq)]
pub struct Layer {
    /// Material.
    pub material: Material,
    /// Thickness, m.
    pub thickness_m: f64,
    /// Joint with the layer before; unused of the first.
    pub joint: Joint,
}

/// Condition behind the last layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Back {
    /// No heat flows.
    Adiabatic,
    /// Surface at a temperature.
    Held {
        /// Temperature, K.
        temperature_k: f64,
    },
    /// Surface that radiates and has a film, either of which may be none.
    Exposed {
        /// Temperature of the surroundings, K.
        temperature_k: f64,
        /// Emissivity.
        emissivity: f64,
        /// Film coefficient, W/(m² K).
        film_w_m2k: f64,
    },
}

/// Layers, shape and back.
#[derive(Clone, Debug, PartialEq)]
pub struct Stack {
    /// Layers from the wall inwards; only the first may char or recede.
    pub layers: Vec<Layer>,
    /// Shape.
    pub geometry: Geometry,
    /// Back.
    pub back: Back,
}

impl Stack {
    /// The stack, checked.
    ///
    /// # Errors
    /// No layer, thicknesses or temperatures beyond their ranges, a radius below the thickness, pyrolysis behind the first layer.
    pub fn try_new(layers: Vec<Layer>, geometry: Geometry, back: Back) -> Result<Self, Fault> {
        const OF: &str = "stack";
        if layers.is_empty() {
            return Err(Fault::TooFew {
                of: OF,
                key: "layer",
                rows: 0,
                least: 1,
            });
        }
        let range = |key: &'static str, value: f64, least: f64, most: f64| {
            if (least..=most).contains(&value) {
                return Ok(());
            }
            Err(Fault::Range {
                of: OF,
                key,
                value,
                least,
                most,
            })
        };
        let mut total = 0.0;
        for layer in &layers {
            range("thickness_m", layer.thickness_m, 1e-7, 100.0)?;
            total += layer.thickness_m;
            match layer.joint {
                Joint::Perfect => {}
                Joint::Contact { resistance_m2k_w } => {
                    range("contact_m2k_w", resistance_m2k_w, 0.0, 1e6)?
                }
                Joint::Gap {
                    conductance_w_m2k,
                    emissivity,
                } => {
                    range("gap_conductance_w_m2k", conductance_w_m2k, 0.0, 1e9)?;
                    range("gap_emissivity", emissivity, 0.0, 1.0)?;
                }
            }
        }
        if let Some(layer) = layers
            .iter()
            .skip(1)
            .find(|layer| layer.material.pyrolysis.is_some())
        {
            let value = layer.thickness_m;
            return Err(Fault::Range {
                of: "a layer that chars behind the first",
                key: "thickness_m",
                value,
                least: 0.0,
                most: 0.0,
            });
        }
        if let Some(radius) = geometry.radius_m() {
            range("radius_m", radius, total, f64::MAX)?;
        }
        match back {
            Back::Adiabatic => {}
            Back::Held { temperature_k } => range("back_temperature_k", temperature_k, 1.0, 1e4)?,
            Back::Exposed {
                temperature_k,
                emissivity,
                film_w_m2k,
            } => {
                range("back_temperature_k", temperature_k, 0.0, 1e4)?;
                range("back_emissivity", emissivity, 0.0, 1.0)?;
                range("back_film_w_m2k", film_w_m2k, 0.0, 1e9)?;
            }
        }
        Ok(Self {
            layers,
            geometry,
            back,
        })
    }

    /// Thickness of all layers, m.
    pub fn thickness_m(&self) -> f64 {
        self.layers
            .iter()
            .fold(0.0, |sum, layer| sum + layer.thickness_m)
    }
}
