//! Detection of the lines that name the columns of a table and their units.
//!
//! ```text
//! titles, comments     left out
//! heading              the line above the numbers, commented or not, that names the most columns
//! units                a line of units below it
//! ```
//!
//! # Valid
//! Columns that a table of this kind does not use are named in a message and left out.
//!
//! # References
//! - Own convention.

use super::cells;
use super::heading::{Heading, heading};
use super::layout::{Cells, Column, Cut, Layout, Sheet, is_rule, listed};
use super::quantity::Quantity;
use super::separator::Separator;
use super::{MOST_FAULTS, TableFault, shown};
use std::borrow::Cow;

/// Number of lines above the numbers in which the heading is searched for.
const MOST_TITLES: usize = 40;

/// Columns according to the lines above the numbers.
pub(super) fn columns(
    above: &[Cut],
    width: usize,
    separator: Separator,
    layout: &Layout,
) -> Result<Sheet, Vec<TableFault>> {
    let near = above
        .get(above.len().saturating_sub(MOST_TITLES)..)
        .unwrap_or_default();
    let mut best: Option<(usize, usize, Cells)> = None;
    for (place, cut) in near.iter().enumerate().rev() {
        for cells in ways(cut, separator)
            .into_iter()
            .filter(|cells| cells.len() == width)
        {
            let known = cells
                .iter()
                .filter(|cell| heading(cell, layout.quantities) != Heading::Unknown)
                .count();
            // a single word of a comment may match a name by chance
            let enough = if cut.line.comment { 2.min(width) } else { 1 };
            if known >= enough && best.as_ref().is_none_or(|(most, ..)| known > *most) {
                best = Some((known, place, cells));
            }
        }
    }
    let Some((_, place, cells)) = best else {
        return bare(near, width, separator, layout);
    };
    let names: Vec<&str> = cells.iter().map(AsRef::as_ref).collect();
    let line = near.get(place).map_or(0, |cut| cut.line.number);
    let after = near.get(place + 1..).unwrap_or_default();
    let units = units(after, &names, layout, separator)?;
    named(&names, units.as_deref(), line, layout)
}

/// Candidate splits of a line above the numbers into cells.
fn ways<'t>(cut: &Cut<'t>, separator: Separator) -> Vec<Cells<'t>> {
    let text = cut.line.text;
    let by = |sign: char| -> Cells<'t> {
        let cells = text
            .split(sign)
            .map(str::trim)
            .filter(|cell| !cell.is_empty());
        cells
            .map(|cell| Cow::Borrowed(cell.trim_matches('"')))
            .collect()
    };
    let wide: Cells = {
        let cells = text
            .split("  ")
            .flat_map(|cell| cell.split('\t'))
            .map(str::trim);
        cells
            .filter(|cell| !cell.is_empty())
            .map(Cow::Borrowed)
            .collect()
    };
    let mut ways = vec![cut.cells.clone(), by('\t'), wide, by(';'), by('|'), by(',')];
    if separator == Separator::Blanks || cut.line.comment {
        let words = cells::split(text, Separator::Blanks);
        // a unit in brackets belongs to the preceding word
        let mut joined: Cells = Vec::new();
        for word in &words {
            match joined.last_mut() {
                Some(last) if word.starts_with(['(', '[']) => {
                    *last = Cow::Owned(format!("{last} {word}"))
                }
                _ => joined.push(word.clone()),
            }
        }
        ways.extend([words, joined]);
    }
    // alternating names and units: name, unit, name, unit
    let commas = by(',');
    // a name with its unit after a comma: Speed of sound, [m/s]
    let mut joined: Cells = Vec::new();
    for cell in &commas {
        match joined.last_mut() {
            Some(last) if cell.starts_with(['(', '[']) => {
                *last = Cow::Owned(format!("{last} {cell}"))
            }
            _ => joined.push(cell.clone()),
        }
    }
    ways.push(joined);
    if commas.len() % 2 == 0 {
        ways.push(
            commas
                .chunks(2)
                .map(|pair| Cow::Owned(pair.join(", ")))
                .collect(),
        );
    }
    ways
}

/// Units of a line between heading and numbers; a line that is neither units nor a rule is a fault.
fn units(
    after: &[Cut],
    names: &[&str],
    layout: &Layout,
    separator: Separator,
) -> Result<Option<Vec<String>>, Vec<TableFault>> {
    let mut found = None;
    for cut in after.iter().filter(|cut| !is_rule(&cut.cells)) {
        let strip = |cell: &str| cell.trim_matches(['(', ')', '[', ']', ' ']).to_owned();
        let fits = |cells: &Cells| {
            let mut known = 0;
            let sound = cells.len() == names.len()
                && names.iter().zip(cells).all(|(name, cell)| {
                    let unit = strip(cell);
                    match heading(name, layout.quantities) {
                        Heading::Known(quantity, None)
                            if !matches!(unit.as_str(), "" | "-" | "--") =>
                        {
                            known += 1;
                            quantity.unit(&unit).is_some()
                        }
                        _ => true,
                    }
                });
            sound && known > 0
        };
        match ways(cut, separator).into_iter().find(fits) {
            Some(cells) if found.is_none() => {
                found = Some(cells.iter().map(|cell| strip(cell)).collect())
            }
            None if !cut.line.comment => {
                return Err(vec![TableFault::NeitherUnitsNorNumbers {
                    line: cut.line.number,
                }]);
            }
            _ => {}
        }
    }
    Ok(found)
}

fn named(
    names: &[&str],
    units: Option<&[String]>,
    line: u64,
    layout: &Layout,
) -> Result<Sheet, Vec<TableFault>> {
    let mut sheet = Sheet {
        columns: Vec::new(),
        rows: Vec::new(),
        headed: true,
        unknown: Vec::new(),
        twice: Vec::new(),
        remarks: Vec::new(),
    };
    let (mut faults, mut odd) = (Vec::new(), Vec::new());
    for (place, name) in names.iter().enumerate() {
        let of_row = units.and_then(|units| units.get(place)).map(String::as_str);
        match heading(name, layout.quantities) {
            Heading::Known(quantity, unit) => {
                let unit = unit
                    .or(of_row.filter(|unit| *unit != "-"))
                    .unwrap_or_default();
                if let Some((factor, offset)) = quantity.unit(unit) {
                    sheet.columns.push(Column {
                        quantity,
                        place,
                        named_unit: !unit.is_empty(),
                        spare: false,
                        factor,
                        offset,
                    });
                }
            }
            Heading::OddUnit(quantity, unit) => odd.push((quantity, place, unit)),
            Heading::Unknown => sheet.unknown.push(shown(name)),
        }
    }
    super::units::chosen(&mut sheet, names, line, &mut faults);
    for (quantity, place, unit) in odd {
        // an unknown unit is no fault if the same quantity is also given in a known one
        let other = sheet.columns.iter().find(|c| c.quantity == quantity);
        if other.is_some_and(|column| column.named_unit) {
            sheet
                .unknown
                .extend(names.get(place).map(|name| shown(name)));
            continue;
        }
        faults.push(TableFault::UnknownUnit {
            column: place + 1,
            unit: shown(unit),
            name: quantity.names().0,
            expected: quantity.units().0,
        });
    }
    faults.truncate(MOST_FAULTS);
    if !faults.is_empty() {
        return Err(faults);
    }
    if !sheet.unknown.is_empty() {
        let columns = if sheet.unknown.len() == 1 {
            "column"
        } else {
            "columns"
        };
        sheet
            .remarks
            .push(format!("{columns} left out: {}", listed(&sheet.unknown)));
    }
    Ok(sheet)
}

/// Columns of a file without heading.
fn bare(
    near: &[Cut],
    width: usize,
    separator: Separator,
    layout: &Layout,
) -> Result<Sheet, Vec<TableFault>> {
    let (quantities, fewest) = layout.bare;
    let heads = |cut: &&Cut| {
        cut.cells.len() == width
            && width > 1
            && !is_rule(&cut.cells)
            && (!cut.line.comment || separator != Separator::Blanks)
    };
    if let Some(cut) = near.iter().rev().find(heads) {
        return Err(vec![TableFault::UnknownHeading {
            line: cut.line.number,
            names: listed(&cut.cells.iter().map(|cell| shown(cell)).collect::<Vec<_>>()),
            expected: expected(layout),
        }]);
    }
    // a line that names quantities but has another number of cells is a fault
    let names_some = |cells: &Cells| {
        let known = |cell: &Cow<str>| heading(cell, layout.quantities) != Heading::Unknown;
        cells.iter().filter(|cell| known(cell)).count() > 1
    };
    let titles = near.iter().rev().filter(|cut| !cut.line.comment);
    for cut in titles {
        if let Some(cells) = ways(cut, separator).into_iter().find(names_some) {
            return Err(vec![TableFault::Fields {
                line: cut.line.number,
                found: cells.len(),
                wanted: width,
            }]);
        }
    }
    if !(fewest..=quantities.len()).contains(&width) {
        return Err(vec![TableFault::NoHeading {
            columns: width,
            expected: expected(layout),
        }]);
    }
    let columns = quantities
        .iter()
        .take(width)
        .enumerate()
        .map(|(place, quantity)| Column {
            quantity: *quantity,
            place,
            named_unit: false,
            spare: false,
            factor: 1.0,
            offset: 0.0,
        });
    let names: Vec<String> = quantities
        .iter()
        .take(width)
        .map(|q| with_unit(*q))
        .collect();
    Ok(Sheet {
        columns: columns.collect(),
        rows: Vec::new(),
        headed: false,
        unknown: Vec::new(),
        twice: Vec::new(),
        remarks: vec![format!(
            "the file names no columns; they are taken as {}",
            names.join(", ")
        )],
    })
}

/// Message on columns whose heading names no unit although the quantity has one.
pub(super) fn without_unit(sheet: &Sheet) -> Option<String> {
    let columns = sheet.columns.iter().filter(|column| !column.named_unit);
    let taken = columns
        .map(|column| with_unit(column.quantity))
        .filter(|name| name.ends_with(')'));
    let taken: Vec<String> = taken.collect();
    (sheet.headed && !taken.is_empty()).then(|| {
        format!(
            "the heading names no unit for what is taken as {}",
            taken.join(", ")
        )
    })
}

fn with_unit(quantity: Quantity) -> String {
    let (name, units) = (quantity.names().0, quantity.units().0);
    match units.split(',').next() {
        Some("none") | None => name.to_owned(),
        Some("deg") if name.ends_with("_deg") => name.to_owned(),
        Some(unit) => format!("{name} ({unit})"),
    }
}

fn expected(layout: &Layout) -> String {
    let names: Vec<&str> = layout
        .quantities
        .iter()
        .filter(|q| **q != Quantity::CapitalH)
        .map(|q| q.names().0)
        .collect();
    names.join(", ")
}
