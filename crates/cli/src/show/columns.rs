//! Text in aligned columns.

/// Alignment of a column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// Left, for names.
    Left,
    /// Right, for numbers.
    Right,
}

/// Rows of cells, padded to the widest of their column.
#[derive(Clone, Debug)]
pub struct Columns {
    aligns: Vec<Align>,
    rows: Vec<Vec<String>>,
}

impl Columns {
    /// Columns without rows.
    pub fn new(aligns: &[Align]) -> Columns {
        Columns {
            aligns: aligns.to_vec(),
            rows: Vec::new(),
        }
    }

    /// Adds a row.
    pub fn push(&mut self, row: Vec<String>) {
        self.rows.push(row);
    }

    /// The rows as lines, two spaces between columns, no trailing spaces.
    pub fn lines(&self) -> impl Iterator<Item = String> + '_ {
        let width = |i: usize| {
            let cells = self.rows.iter().filter_map(move |row| row.get(i));
            cells.map(|cell| cell.chars().count()).max().unwrap_or(0)
        };
        let widths: Vec<usize> = (0..self.aligns.len()).map(width).collect();
        self.rows.iter().map(move |row| {
            let cells: Vec<String> = row
                .iter()
                .zip(self.aligns.iter().zip(&widths))
                .map(|(cell, (align, &width))| match align {
                    Align::Left => format!("{cell:<width$}"),
                    Align::Right => format!("{cell:>width$}"),
                })
                .collect();
            cells.join("  ").trim_end().to_string()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_stand_left_and_numbers_right() {
        let mut columns = Columns::new(&[Align::Left, Align::Right, Align::Left]);
        columns.push(["a", "1.5", "m"].map(String::from).to_vec());
        columns.push(["long", "12", ""].map(String::from).to_vec());
        let lines: Vec<String> = columns.lines().collect();
        assert_eq!(lines, ["a     1.5  m", "long   12"]);
    }
}
