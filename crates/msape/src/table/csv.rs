//! CSV after RFC 4180: commas, lines ended by CR LF, cells quoted only where they must be.

use super::Table;

impl Table {
    /// The table as CSV, headers first.
    pub fn to_csv(&self) -> String {
        let mut text = String::new();
        for row in std::iter::once(&self.headers).chain(&self.rows) {
            for (i, cell) in row.iter().enumerate() {
                if i > 0 {
                    text.push(',');
                }
                push_cell(&mut text, cell);
            }
            text.push_str("\r\n");
        }
        text
    }
}

fn push_cell(text: &mut String, cell: &str) {
    if cell.contains([',', '"', '\r', '\n']) {
        text.push('"');
        text.push_str(&cell.replace('"', "\"\""));
        text.push('"');
    } else {
        text.push_str(cell);
    }
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
}
