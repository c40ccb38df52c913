//! Products: the assembly, its parts and their properties.

use super::part21::{Id, Instances, list, of, real, reals, string};
use super::{properties, shell};
use crate::export::chain::NOTHING_M;
use crate::export::model::Part;

const X: [f64; 3] = [1.0, 0.0, 0.0];
const Z: [f64; 3] = [0.0, 0.0, 1.0];

/// Instances shared by all parts, and the parts added so far.
pub struct Assembly {
    product_context: Id,
    definition_context: Id,
    units: Units,
    context: Id,
    origin: Id,
    root: Product,
    products: Vec<Id>,
    styled: Vec<Id>,
}

#[derive(Clone, Copy)]
struct Units {
    density: Id,
    area: Id,
    volume: Id,
}

#[derive(Clone, Copy)]
struct Product {
    definition: Id,
    shape: Id,
    representation: Id,
}

impl Assembly {
    /// The assembly without parts.
    pub fn new(i: &mut Instances, name: &str) -> Self {
        let application =
            i.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        i.add(&format!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,#{application})"
        ));
        let product_context = i.add(&format!("PRODUCT_CONTEXT('',#{application},'mechanical')"));
        let definition_context = i.add(&format!(
            "PRODUCT_DEFINITION_CONTEXT('part definition',#{application},'design')"
        ));
        let mm = i.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        let rad = i.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let sr = i.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let nothing_mm = real(NOTHING_M * 1000.0);
        let error = i.add(&format!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({nothing_mm}),#{mm},'distance_accuracy_value','')"
        ));
        let context = i.add(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT((#{error}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT((#{mm},#{rad},#{sr}))REPRESENTATION_CONTEXT('',''))"
        ));
        let kg = i.add("(MASS_UNIT()NAMED_UNIT(*)SI_UNIT(.KILO.,.GRAM.))");
        let m = i.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT($,.METRE.))");
        let mut derived = |elements: &[(Id, f64)]| {
            let elements: Vec<Id> = elements
                .iter()
                .map(|&(unit, power)| {
                    i.add(&format!("DERIVED_UNIT_ELEMENT(#{unit},{})", real(power)))
                })
                .collect();
            i.add(&format!("DERIVED_UNIT({})", list(&elements)))
        };
        let units = Units {
            density: derived(&[(kg, 1.0), (m, -3.0)]),
            area: derived(&[(mm, 2.0)]),
            volume: derived(&[(mm, 3.0)]),
        };
        let origin = shell::placement(i, [0.0; 3], [Z, X]);
        let mut assembly = Self {
            product_context,
            definition_context,
            units,
            context,
            origin,
            root: Product {
                definition: 0,
                shape: 0,
                representation: 0,
            },
            products: Vec::new(),
            styled: Vec::new(),
        };
        let representation = i.add(&format!(
            "SHAPE_REPRESENTATION({},(#{origin}),#{context})",
            string(name)
        ));
        assembly.root = assembly.product(i, name, representation);
        assembly
    }

    fn product(&mut self, i: &mut Instances, name: &str, representation: Id) -> Product {
        let (text, context) = (string(name), self.product_context);
        let product = i.add(&format!("PRODUCT({text},{text},'',(#{context}))"));
        let formation = i.add(&format!("PRODUCT_DEFINITION_FORMATION('','',#{product})"));
        let definition = i.add(&format!(
            "PRODUCT_DEFINITION('design','',#{formation},#{})",
            self.definition_context
        ));
        let shape = i.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{definition})"));
        i.add(&format!(
            "SHAPE_DEFINITION_REPRESENTATION(#{shape},#{representation})"
        ));
        self.products.push(product);
        Product {
            definition,
            shape,
            representation,
        }
    }

    /// Adds a part with its solids and places it in the assembly.
    pub fn add(&mut self, i: &mut Instances, part: &Part, solids: &[Id]) {
        let context = self.context;
        // each part needs its own axis system: a placement belongs to one representation
        let own = shell::placement(i, [0.0; 3], [Z, X]);
        let mut items = vec![own];
        items.extend_from_slice(solids);
        let name = string(&part.name);
        let representation = i.add(&format!(
            "ADVANCED_BREP_SHAPE_REPRESENTATION({name},{},#{context})",
            list(&items)
        ));
        let product = self.product(i, &part.name, representation);
        let (root, of_part) = (self.root, product.definition);
        let usage = i.add(&format!(
            "NEXT_ASSEMBLY_USAGE_OCCURRENCE({},{name},'',#{},#{of_part},$)",
            string(&part.key),
            root.definition
        ));
        let placed = i.add(&format!("PRODUCT_DEFINITION_SHAPE('','',#{usage})"));
        let transformation = i.add(&format!(
            "ITEM_DEFINED_TRANSFORMATION('','',#{own},#{})",
            self.origin
        ));
        let relation = i.add(&format!(
            "(REPRESENTATION_RELATIONSHIP('','',#{representation},#{})\
             REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION(#{transformation})SHAPE_REPRESENTATION_RELATIONSHIP())",
            root.representation
        ));
        i.add(&format!(
            "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION(#{relation},#{placed})"
        ));
        self.color(i, part, solids);
        self.material(i, part, product.definition);
        self.checks(i, part, product.shape);
    }

    fn color(&mut self, i: &mut Instances, part: &Part, solids: &[Id]) {
        let rgb = part.color.map(|c| real(f64::from(c) / 255.0)).join(",");
        let color = i.add(&format!("COLOUR_RGB('',{rgb})"));
        let fill = i.add(&format!("FILL_AREA_STYLE_COLOUR('',#{color})"));
        let area = i.add(&format!("FILL_AREA_STYLE('',(#{fill}))"));
        let style = i.add(&format!("SURFACE_STYLE_FILL_AREA(#{area})"));
        let side = i.add(&format!("SURFACE_SIDE_STYLE('',(#{style}))"));
        let usage = i.add(&format!("SURFACE_STYLE_USAGE(.BOTH.,#{side})"));
        let assigned = i.add(&format!("PRESENTATION_STYLE_ASSIGNMENT((#{usage}))"));
        for solid in solids {
            let item = i.add(&format!("STYLED_ITEM('color',(#{assigned}),#{solid})"));
            self.styled.push(item);
        }
    }

    /// A property of a product or shape: one representation with these items.
    fn property(&self, i: &mut Instances, [kind, name]: [&str; 2], about: Id, items: &[Id]) {
        let (kind, name) = (string(kind), string(name));
        let property = i.add(&format!("PROPERTY_DEFINITION({kind},{name},#{about})"));
        let representation = i.add(&format!(
            "REPRESENTATION({name},{},#{})",
            list(items),
            self.context
        ));
        i.add(&format!(
            "PROPERTY_DEFINITION_REPRESENTATION(#{property},#{representation})"
        ));
    }

    fn material(&self, i: &mut Instances, part: &Part, definition: Id) {
        let Some(substance) = &part.substance else {
            return;
        };
        let note = format!("density: {}", substance.basis.name());
        let name = i.put(
            "DESCRIPTIVE_REPRESENTATION_ITEM",
            &[string(&substance.material), string(&note)],
        );
        let kind = "material property";
        self.property(i, [kind, "material name"], definition, &[name]);
        let density = i.add(&format!(
            "MEASURE_REPRESENTATION_ITEM('density measure',POSITIVE_RATIO_MEASURE({}),#{})",
            real(substance.density_kg_m3),
            self.units.density
        ));
        self.property(i, [kind, "density"], definition, &[density]);
    }

    /// Validation properties: volume, area and centroid, for the reader to compare with.
    fn checks(&self, i: &mut Instances, part: &Part, shape: Id) {
        let solid = properties(part);
        let area_m2: f64 = part.profiles.iter().map(|p| p.wetted_area_m2()).sum();
        let volume = i.add(&format!(
            "MEASURE_REPRESENTATION_ITEM('volume measure',VOLUME_MEASURE({}),#{})",
            real(solid.volume_m3 * 1e9),
            self.units.volume
        ));
        let area = i.add(&format!(
            "MEASURE_REPRESENTATION_ITEM('surface area measure',AREA_MEASURE({}),#{})",
            real(area_m2 * 1e6),
            self.units.area
        ));
        let centroid = i.add(&format!(
            "CARTESIAN_POINT('centre point',{})",
            reals(&[solid.centroid_x_m() * 1000.0, 0.0, 0.0])
        ));
        let kind = "geometric validation property";
        self.property(i, [kind, "volume"], shape, &[volume]);
        self.property(i, [kind, "surface area"], shape, &[area]);
        self.property(i, [kind, "centroid"], shape, &[centroid]);
    }

    /// Adds the instances that refer to all parts.
    pub fn finish(self, i: &mut Instances) {
        i.add(&format!(
            "PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,{})",
            list(&self.products)
        ));
        if !self.styled.is_empty() {
            i.put(
                "MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION",
                &["''".to_owned(), list(&self.styled), of(self.context)],
            );
        }
    }
}
