//! Numbers of a table in SI, column by column.
//!
//! ```text
//! numbers     from the first to the last line that is mostly numbers
//! notes       lines below the last one, left out with a message
//! ```
//!
//! # Valid
//! One table per file.
//!
//! # References
//! - Own convention.

use super::cells;
use super::columns::columns;
use super::layout::{Column, Cut, Layout, Sheet, is_rule};
use super::number::{Cell, Spelling, is_number};
use super::places::place;
use super::quantity::Quantity;
use super::separator::Separator;
use super::units;
use super::{MOST_FAULTS, TableFault, shown};

/// Columns and numbers of a text.
pub fn sheet(text: &str, layout: &Layout) -> Result<Sheet, Vec<TableFault>> {
    let (lines, named) = cells::lines(text);
    let separator = named.unwrap_or_else(|| cells::separator(&lines));
    let mut cuts: Vec<Cut> = lines
        .into_iter()
        .map(|line| {
            let cells = cells::split(line.text, separator);
            let numbers = cells.iter().filter(|cell| is_number(cell)).count();
            let filled = cells.iter().filter(|cell| !cell.is_empty()).count();
            Cut {
                data: !line.comment && numbers > 0 && 2 * numbers >= filled,
                line,
                cells,
                placed: false,
            }
        })
        .collect();
    if separator == Separator::Blanks {
        place(&mut cuts, layout.quantities);
    }
    let first = first_row(&cuts);
    let last = cuts.iter().rposition(|cut| cut.data);
    let (Some(first), Some(last)) = (first, last) else {
        return Err(vec![TableFault::Empty]);
    };
    let (above, rest) = cuts.split_at(first);
    let (body, below) = rest.split_at(last + 1 - first);
    let width = width(body);
    let mut sheet = columns(above, width, separator, layout)?;
    if let (Some(from), Some(to)) = (below.first(), below.last()) {
        let lines = if from.line.number == to.line.number {
            format!("line {}", from.line.number)
        } else {
            format!("lines {} to {}", from.line.number, to.line.number)
        };
        if below
            .iter()
            .any(|cut| !cut.line.comment && !is_rule(&cut.cells))
        {
            sheet
                .remarks
                .push(format!("{lines} below the numbers are left out"));
        }
    }
    numbers(&mut sheet, body, (width, separator), layout)?;
    units::agree(&sheet)?;
    Ok(sheet)
}

/// Index of the first row of numbers; a title that ends in a number, with words between it and the rows, does not
/// count.
fn first_row(cuts: &[Cut]) -> Option<usize> {
    let first = cuts.iter().position(|cut| cut.data)?;
    let whole = cuts
        .iter()
        .position(|cut| cut.data && cut.cells.len() == width(cuts))?;
    let words = |cut: &Cut| !cut.data && !cut.line.comment && !is_rule(&cut.cells);
    let between = cuts.get(first..whole).unwrap_or_default();
    Some(if between.iter().any(words) {
        whole
    } else {
        first
    })
}

/// Number of cells of most lines.
fn width(body: &[Cut]) -> usize {
    let mut counts: Vec<usize> = body
        .iter()
        .filter(|cut| cut.data)
        .map(|cut| cut.cells.len())
        .collect();
    counts.sort_unstable();
    let most = counts
        .chunk_by(|a, b| a == b)
        .max_by_key(|alike| (alike.len(), alike[0]));
    most.and_then(|alike| alike.first())
        .copied()
        .unwrap_or_default()
}

/// Fills the rows of a sheet.
fn numbers(
    sheet: &mut Sheet,
    body: &[Cut],
    (width, separator): (usize, Separator),
    layout: &Layout,
) -> Result<(), Vec<TableFault>> {
    let content = || {
        body.iter()
            .filter(|cut| !cut.line.comment && !is_rule(&cut.cells))
    };
    let all = content().filter(|cut| cut.data);
    let cells = all.flat_map(|cut| {
        cut.cells
            .iter()
            .map(move |cell| (cut.line.number, cell.as_ref()))
    });
    let spelling = Spelling::of(cells, separator).map_err(|fault| vec![fault])?;
    if spelling.decimal == ',' {
        sheet
            .remarks
            .push("the comma is the decimal sign".to_owned());
    }
    let columns = sheet.columns.clone();
    let mut faults = grouped(sheet, &columns, body, spelling);
    let (mut holes, mut short) = (Vec::new(), Vec::new());
    for cut in content() {
        if faults.len() >= MOST_FAULTS {
            break;
        }
        let (line, found) = (cut.line.number, cut.cells.len());
        let blanks = separator == Separator::Blanks && !cut.placed;
        let misses = found < width && (layout.whole || blanks);
        if found > width || misses && (layout.whole || !cut.data) {
            faults.push(TableFault::Fields {
                line,
                found,
                wanted: width,
            });
            continue;
        }
        if misses {
            short.push(line);
            continue;
        }
        let mut row = Vec::with_capacity(columns.len());
        let mut hole = false;
        for column in &columns {
            let cell = cut.cells.get(column.place).map_or("", AsRef::as_ref);
            match spelling.read(cell) {
                Cell::Number(value) => {
                    let value = value * column.factor + column.offset;
                    if value.is_finite() {
                        row.push(value);
                    } else {
                        faults.push(TableFault::TooLarge {
                            line,
                            column: column.place + 1,
                            text: shown(cell),
                        });
                    }
                }
                Cell::Hole | Cell::Words if column.spare => row.push(f64::NAN),
                Cell::Hole if !layout.whole => hole = true,
                Cell::Hole => faults.push(TableFault::Hole {
                    line,
                    column: column.place + 1,
                    text: shown(cell),
                }),
                Cell::Words => faults.push(TableFault::NotANumber {
                    line,
                    column: column.place + 1,
                    text: shown(cell),
                }),
            }
        }
        if hole && cut.placed && found < width {
            short.push(line);
        } else if hole {
            holes.push(line);
        } else if row.len() == columns.len() {
            sheet.rows.push((line, row));
        }
    }
    for (lines, what) in [
        (&holes, "a blank in a column that is read"),
        (&short, "fewer cells than the others"),
    ] {
        if let Some(first) = lines.first() {
            sheet.remarks.push(format!(
                "{} with {what} left out, the first in line {first}",
                rows_of(lines.len())
            ));
        }
    }
    if sheet.rows.is_empty() && faults.is_empty() {
        faults.push(TableFault::Empty);
    }
    if faults.is_empty() {
        Ok(())
    } else {
        Err(faults)
    }
}

fn rows_of(count: usize) -> String {
    if count == 1 {
        "1 row".to_owned()
    } else {
        format!("{count} rows")
    }
}

/// Faults of numbers with a possible thousands separator; altitudes in m and ft without a decimal sign may have one.
fn grouped(
    sheet: &mut Sheet,
    columns: &[Column],
    body: &[Cut],
    spelling: Spelling,
) -> Vec<TableFault> {
    let mut faults = Vec::new();
    for column in columns {
        let cells = || {
            body.iter()
                .filter(|cut| cut.data)
                .filter_map(|cut| Some((cut.line.number, cut.cells.get(column.place)?.as_ref())))
        };
        let Some((line, text)) = cells().find(|(_, cell)| spelling.is_doubtful(cell)) else {
            continue;
        };
        let long = [1.0, 0.3048].contains(&column.factor);
        let altitude = matches!(
            column.quantity,
            Quantity::Altitude
                | Quantity::Geopotential
                | Quantity::CapitalH
                | Quantity::PressureAltitude
        );
        if altitude && long && !cells().any(|(_, cell)| spelling.has_plain_decimals(cell)) {
            let sign = if spelling.decimal == '.' {
                "commas"
            } else {
                "points"
            };
            sheet.remarks.push(format!(
                "{sign} group the thousands of the altitude, such as {} in line {line}",
                shown(text)
            ));
        } else {
            faults.push(TableFault::Thousands {
                line,
                text: shown(text),
            });
        }
    }
    faults
}
