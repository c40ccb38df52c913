//! Heat fluxes against speed and density from a file, at the stagnation point or at points along the forebody.
//!
//! ```text
//! columns by name: speed, density, convective and radiative, or total; r or s as a fraction
//! ```
//!
//! # Valid
//! A complete grid of speeds and densities, in any order. A total heat flux is stored as convective, with radiative
//! fluxes of 0.
//! # References
//! - Own convention.

use super::columns::without_unit;
use super::layout::Layout;
use super::quantity::Quantity;
use super::sheet::sheet;
use super::{Table, TableFault};
use msape::aero::table::Extrapolation;
use msape::heating::given::GivenHeating;
use msape::heating::given::body::{Along, BodyHeating};
use msape::quantity::input::{self, Input};

const HEATING: Layout = Layout {
    quantities: &[
        Quantity::Speed,
        Quantity::Density,
        Quantity::Convective,
        Quantity::Radiative,
        Quantity::TotalHeat,
        Quantity::RadiusFraction,
        Quantity::ArcFraction,
    ],
    bare: (
        &[
            Quantity::Speed,
            Quantity::Density,
            Quantity::Convective,
            Quantity::Radiative,
        ],
        4,
    ),
    whole: true,
};

const BARE_OVER_RADIUS: [Quantity; 5] = bare_along(Quantity::RadiusFraction);
const BARE_OVER_ARC: [Quantity; 5] = bare_along(Quantity::ArcFraction);
const RADIUS_TABLE: &str = input::heating::RADIUS_TABLE.key;
const ARC_TABLE: &str = input::heating::ARC_TABLE.key;

const fn bare_along(fraction: Quantity) -> [Quantity; 5] {
    [
        fraction,
        Quantity::Speed,
        Quantity::Density,
        Quantity::Convective,
        Quantity::Radiative,
    ]
}

/// Rows of speed, density and heat fluxes, preceded by the fraction where the file has one or the input asks for it.
pub fn read(text: &str, input: Option<&Input>) -> Result<Table, Vec<TableFault>> {
    let bare: (&'static [Quantity], usize) = match input.map(|input| input.key) {
        Some(key) if key == RADIUS_TABLE => (&BARE_OVER_RADIUS, 5),
        Some(key) if key == ARC_TABLE => (&BARE_OVER_ARC, 5),
        _ => HEATING.bare,
    };
    let mut sheet = sheet(text, &Layout { bare, ..HEATING })?;
    let needed = [Quantity::Speed, Quantity::Density];
    let mut faults: Vec<TableFault> = needed
        .into_iter()
        .filter(|q| !sheet.has(*q))
        .map(|q| sheet.missing(q.names().0))
        .collect();
    let [convective, radiative, total, radius, arc] = [
        Quantity::Convective,
        Quantity::Radiative,
        Quantity::TotalHeat,
        Quantity::RadiusFraction,
        Quantity::ArcFraction,
    ]
    .map(|q| sheet.has(q));
    let along = match (radius, arc) {
        (true, true) => {
            let fault = "header: give r or s as a fraction, not both";
            faults.push(TableFault::Rows(fault.to_owned()));
            None
        }
        (true, false) => Some((Quantity::RadiusFraction, Along::Radius, RADIUS_TABLE)),
        (false, true) => Some((Quantity::ArcFraction, Along::Arc, ARC_TABLE)),
        (false, false) => None,
    };
    let by_parts = convective && (radiative || along.is_none());
    if !by_parts && (convective || radiative || !total) {
        let also = match along {
            Some(_) => "convective and radiative heat flux, or total",
            None => "convective heat flux, if wanted with radiative, or total",
        };
        faults.push(TableFault::Rows(format!("header: give {also}")));
    }
    if !faults.is_empty() {
        return Err(faults);
    }
    if by_parts && total {
        let remark = "total is left out beside convective";
        sheet.remarks.push(remark.to_owned());
    }
    if !by_parts {
        let remark = "the total heat flux counts as convective, with its margin, and there is no radiative one beside it";
        sheet.remarks.push(remark.to_owned());
    } else if !radiative {
        let remark = "without a radiative heat flux the relation of the case stays for it";
        sheet.remarks.push(remark.to_owned());
    }
    sheet.remarks.extend(without_unit(&sheet));
    let row = |cells: &[f64]| {
        let value = |q: Quantity| sheet.value(cells, q);
        let mut row: Vec<f64> = along.iter().filter_map(|(q, ..)| value(*q)).collect();
        row.extend(needed.into_iter().filter_map(value));
        if by_parts {
            row.extend(value(Quantity::Convective));
            row.extend(value(Quantity::Radiative));
        } else {
            row.extend(
                value(Quantity::TotalHeat)
                    .map(|total| [total, 0.0])
                    .into_iter()
                    .flatten(),
            );
        }
        row
    };
    let rows: Vec<Vec<f64>> = sheet.rows.iter().map(|(_, cells)| row(cells)).collect();
    let hold = Extrapolation::Hold;
    let (key, checked) = match along {
        None => {
            let key = input::heating::TABLE.key;
            (key, GivenHeating::try_new(key, &rows, hold).map(drop))
        }
        Some((_, along, key)) => (key, BodyHeating::try_new(key, along, &rows, hold).map(drop)),
    };
    match checked {
        Err(faults) => Err(faults.into_iter().map(TableFault::Rows).collect()),
        Ok(()) => Ok(Table {
            key,
            rows,
            remarks: sheet.remarks,
        }),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faults(text: &str) -> String {
        let faults = read(text, None).unwrap_err();
        let said: Vec<String> = faults.iter().map(ToString::to_string).collect();
        said.join("\n")
    }

    #[test]
    fn units_columns_and_separators_are_read_as_of_other_tables() {
        let text = "V [km/s];rho [kg/m3];q_conv [W/cm2];q_rad [W/cm2]\n8;1e-4;50,5;0\n8;1e-3;160;0\n12;1e-4;170;20\n12;1e-3;540;300\n";
        let table = read(text, None).unwrap();
        assert_eq!(table.key, "heating.table");
        assert_eq!(table.rows[0], [8e3, 1e-4, 5.05e5, 0.0]);
        assert_eq!(table.rows[3], [12e3, 1e-3, 5.4e6, 3e6]);
        let bare = read(
            "8000,1e-4,1e5,2e4\n8000,1e-3,3e5,6e4\n9000,1e-4,2e5,4e4\n9000,1e-3,6e5,9e4\n",
            None,
        );
        let bare = bare.unwrap();
        assert_eq!(bare.key, "heating.table");
        assert_eq!(bare.rows[0], [8e3, 1e-4, 1e5, 2e4]);
        assert!(
            bare.remarks
                .iter()
                .any(|remark| remark.contains("radiative")),
            "{:?}",
            bare.remarks
        );
        // three columns may be a total heat flux or a convective one
        for few in [
            "8000,1e-4\n9000,1e-3\n",
            "8000,1e-4,1e5\n8000,1e-3,3e5\n9000,1e-4,2e5\n9000,1e-3,6e5\n",
        ] {
            let few = faults(few);
            assert!(few.contains("no heading names them"), "{few}");
        }
    }

    #[test]
    fn a_total_stands_as_convective_and_a_convective_one_alone_leaves_the_radiation() {
        let of = |name: &str| {
            let text = format!(
                "speed_m_s,density_kg_m3,{name}\n8e3,1e-4,1\n8e3,1e-3,2\n9e3,1e-4,3\n9e3,1e-3,4\n"
            );
            read(&text, None).unwrap()
        };
        let total = of("q_MW_m2");
        assert_eq!(total.rows[0], [8e3, 1e-4, 1e6, 0.0]);
        assert!(
            total
                .remarks
                .iter()
                .any(|r| r.contains("counts as convective"))
        );
        let convective = of("convective_w_m2");
        assert_eq!(convective.rows[0], [8e3, 1e-4, 1.0]);
        assert!(
            convective
                .remarks
                .iter()
                .any(|r| r.contains("relation of the case stays"))
        );
    }

    #[test]
    fn points_of_the_body_by_radius_or_by_length() {
        let of = |name: &str, heat: &str| {
            let mut text = format!("{name},speed_m_s,density_kg_m3,{heat}\n");
            for point in ["0", "0.5", "1"] {
                for place in ["8e3,1e-4", "8e3,1e-3", "9e3,1e-4", "9e3,1e-3"] {
                    text.push_str(&format!("{point},{place},2e5\n"));
                }
            }
            text
        };
        let by_radius = read(&of("r/R", "q"), None).unwrap();
        assert_eq!(by_radius.key, "heating.radius_table");
        assert_eq!(by_radius.rows[4], [0.5, 8e3, 1e-4, 2e5, 0.0]);
        assert_eq!(
            read(&of("s", "total"), None).unwrap().key,
            "heating.arc_table"
        );
        let half = faults(&of("s", "convective"));
        assert!(
            half.contains("give convective and radiative heat flux, or total"),
            "{half}"
        );
    }

    #[test]
    fn holes_and_missing_columns_are_faults() {
        let hole = faults("speed_m_s,density_kg_m3,q\n8e3,1e-4,1\n8e3,1e-3,2\n9e3,1e-4,3\n");
        assert!(
            hole.contains("no row for 9000 m/s and 0.001 kg/m^3"),
            "{hole}"
        );
        let none = faults("speed_m_s,q\n8e3,1\n9e3,2\n");
        assert!(none.contains("no column for density"), "{none}");
    }
}
