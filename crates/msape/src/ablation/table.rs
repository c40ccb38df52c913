//! Columns of a card's CSV file by their names.

/// Numbers of the columns with these names, row by row; a blank line and one that begins with `#` are skipped.
pub(super) fn rows<const N: usize>(text: &str, names: [&str; N]) -> Result<Vec<[f64; N]>, String> {
    let mut lines = text
        .lines()
        .zip(1..)
        .filter(|(line, _)| !line.starts_with('#') && !line.trim().is_empty());
    let (header, _) = lines.next().ok_or("holds no heading")?;
    let headings: Vec<&str> = header.split(',').map(str::trim).collect();
    if let Some(unknown) = headings.iter().find(|heading| !names.contains(heading)) {
        return Err(format!(
            "column \"{unknown}\" is not known; must be {}",
            names.join(", ")
        ));
    }
    let mut places = [0; N];
    for (place, name) in places.iter_mut().zip(names) {
        let found = headings.iter().position(|heading| *heading == name);
        *place = found
            .ok_or_else(|| format!("column {name} is missing; must be {}", names.join(", ")))?;
    }
    let mut rows = Vec::new();
    for (line, number) in lines {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        let mut row = [0.0; N];
        for ((value, place), name) in row.iter_mut().zip(places).zip(names) {
            let cell = cells.get(place).copied().unwrap_or_default();
            let read = cell.parse::<f64>().ok().filter(|value| value.is_finite());
            *value = read.ok_or_else(|| {
                format!("line {number}: {name}: got \"{cell}\", must be a finite number")
            })?;
        }
        rows.push(row);
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_found_by_name_and_faults_name_line_and_value() {
        let text = "# a\nb,a\n1,2\n\n3,4\n";
        assert_eq!(rows(text, ["a", "b"]), Ok(vec![[2.0, 1.0], [4.0, 3.0]]));
        let of = |text: &str| rows(text, ["a", "b"]).unwrap_err();
        assert_eq!(
            of("a,b\n1,x\n"),
            "line 2: b: got \"x\", must be a finite number"
        );
        assert_eq!(
            of("a,b\n1,NaN\n"),
            "line 2: b: got \"NaN\", must be a finite number"
        );
        assert_eq!(of("a,c\n"), "column \"c\" is not known; must be a, b");
        assert_eq!(of("a\n"), "column b is missing; must be a, b");
    }
}
