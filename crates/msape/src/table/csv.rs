//! CSV after RFC 4180: commas, lines ended by CR LF, cells quoted only where they must be.
//!
//! A spreadsheet takes a text that opens with `=`, `+`, `-` or `@` for a formula: an apostrophe before it keeps it a text.
//! Signs that steer a terminal are spelled out.

use super::Table;

impl Table {
    /// The table as CSV, headers first.
    pub fn to_csv(&self) -> String {
        let mut text = String::new();
        for row in std::iter::once(&self.headers).chain(&self.rows) {
            push_row(&mut text, row.iter().map(String::as_str));
        }
        text
    }
}

/// Adds a line.
pub(super) fn push_row<'c>(text: &mut String, cells: impl Iterator<Item = &'c str>) {
    for (i, cell) in cells.enumerate() {
        if i > 0 {
            text.push(',');
        }
        push_cell(text, cell);
    }
    text.push_str("\r\n");
}

fn push_cell(text: &mut String, cell: &str) {
    let steers = |c: char| c.is_control() && !matches!(c, '\r' | '\n');
    let formula =
        cell.starts_with(['=', '+', '-', '@', '\t', '\r']) && cell.parse::<f64>().is_err();
    if !formula && !cell.contains(|c: char| c.is_control() || matches!(c, ',' | '"')) {
        text.push_str(cell);
        return;
    }
    let quoted = cell.contains([',', '"', '\r', '\n']);
    let mark = |text: &mut String| {
        if quoted {
            text.push('"');
        }
    };
    mark(text);
    if formula {
        text.push('\'');
    }
    for sign in cell.chars() {
        match sign {
            '"' => text.push_str("\"\""),
            sign if steers(sign) => text.extend(sign.escape_default()),
            sign => text.push(sign),
        }
    }
    mark(text);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_reader_finds_what_was_written() {
        let row = |cells: [&str; 3]| cells.map(String::from).to_vec();
        let table = Table {
            headers: row(["Run Name", "Entry Velocity (m/s)", "note"]),
            rows: vec![
                row(["a \"b\", c", "12000", "two\r\nlines"]),
                row(["", "", ""]),
            ],
        };
        let text = table.to_csv();
        assert!(
            text.starts_with("Run Name,Entry Velocity (m/s),note\r\n\"a \"\"b\"\", c\",12000,")
        );
        let mut reader = ::csv::Reader::from_reader(text.as_bytes());
        assert_eq!(reader.headers().unwrap(), &table.headers[..]);
        let read: Vec<Vec<String>> = reader
            .records()
            .map(|record| record.unwrap().iter().map(String::from).collect())
            .collect();
        assert_eq!(read, table.rows);
    }

    #[test]
    fn a_text_is_no_formula_and_steers_no_terminal() {
        let cell = |text: &str| {
            let mut written = String::new();
            push_cell(&mut written, text);
            written
        };
        assert_eq!(cell("=HYPERLINK(\"x\",1)"), "\"'=HYPERLINK(\"\"x\"\",1)\"");
        for text in ["+1 deg", "-8 deg, steep", "@SUM(A1)", "-", "=1"] {
            assert!(
                cell(text).trim_start_matches('"').starts_with('\''),
                "{text}"
            );
        }
        assert_eq!(cell("\tx"), "'\\tx");
        for number in ["-8", "-1.5e-3", "+2", "-inf"] {
            assert_eq!(cell(number), number);
        }
        assert_eq!(cell("a\u{1b}[2Jb"), "a\\u{1b}[2Jb");
    }
}
