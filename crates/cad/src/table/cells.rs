//! Lines of a text and their cells.
//!
//! ```text
//! separator:   semicolon, tab, bar, comma or blanks, whichever splits the most lines into equal counts of numbers; or
//! sep=
//! comment:     a line that opens with #, %, ! or //
//! quotes:      "a ""b"", c" is one cell and may hold line ends
//! ```
//!
//! # Valid
//! One separator per file.
//!
//! # References
//! - \[rfc-4180\] for the quotes.

use super::number;
use super::separator::Separator;
use std::borrow::Cow;

/// Number of lines examined to find the separator.
const LOOKED_AT: usize = 1000;
/// Largest number of lines of a quoted cell; a quote open for longer is an ordinary character.
const MOST_QUOTED_LINES: usize = 5;

/// Line with content.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<'t> {
    /// Line number in the file, from 1.
    pub number: u64,
    /// Content without the comment sign.
    pub text: &'t str,
    /// Characters before the content.
    pub indent: usize,
    /// Whether it is a comment.
    pub comment: bool,
}

/// Lines with content, and the separator that a first line `sep=;` names. Line ends are `\n` here.
pub fn lines(text: &str) -> (Vec<Line<'_>>, Option<Separator>) {
    let (mut lines, mut named) = (Vec::new(), None);
    let (mut rest, mut number) = (text, 1);
    while !rest.is_empty() {
        let end = end_of_line(rest);
        let (line, after) = rest.split_at(end);
        let trimmed = line.trim();
        if number == 1 && trimmed.len() <= 5 && trimmed.to_lowercase().starts_with("sep=") {
            named = line
                .trim_end_matches('\n')
                .chars()
                .nth(4)
                .map(Separator::Sign);
        } else if !trimmed.is_empty() {
            let opened = ["#", "%", "!", "//"];
            let comment = opened.iter().any(|sign| trimmed.starts_with(sign));
            let text = if comment {
                trimmed.trim_start_matches(['#', '%', '!', '/']).trim()
            } else {
                // tabs at the ends are separators, blanks are not
                line.trim_matches(['\n', ' '])
            };
            let before = text.as_ptr().addr() - line.as_ptr().addr();
            lines.push(Line {
                number,
                text,
                indent: line
                    .get(..before)
                    .map_or(0, |blanks| blanks.chars().count()),
                comment,
            });
        }
        number += line.matches('\n').count() as u64;
        rest = after;
    }
    (lines, named)
}

/// Bytes up to the end of the first line, not counting line ends in quoted cells.
fn end_of_line(text: &str) -> usize {
    let first = text.find('\n').map_or(text.len(), |place| place + 1);
    let (mut quoted, mut opens, mut breaks) = (false, true, 0);
    for (place, sign) in text.char_indices() {
        match sign {
            '"' if quoted || opens => quoted = !quoted,
            '\n' if !quoted => return place + 1,
            '\n' => {
                breaks += 1;
                if breaks >= MOST_QUOTED_LINES {
                    return first;
                }
            }
            _ => {}
        }
        opens = !quoted && matches!(sign, ';' | ',' | '\t' | '|' | ' ' | '"');
    }
    if quoted { first } else { text.len() }
}

/// Trimmed cells of a line; a trailing separator adds no cell.
pub fn split(text: &str, separator: Separator) -> Vec<Cow<'_, str>> {
    let mut cells: Vec<Cow<str>> = match separator {
        Separator::Blanks if !text.contains('"') => {
            text.split_whitespace().map(Cow::Borrowed).collect()
        }
        Separator::Sign(sign) if !text.contains('"') => text
            .split(sign)
            .map(|cell| Cow::Borrowed(cell.trim()))
            .collect(),
        _ => split_quoted(text, separator),
    };
    while cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

fn split_quoted(text: &str, separator: Separator) -> Vec<Cow<'_, str>> {
    let separates = |sign: char| match separator {
        Separator::Blanks => sign.is_whitespace(),
        Separator::Sign(separator) => sign == separator,
    };
    let mut cells = Vec::new();
    let mut rest = text;
    loop {
        let start = match separator {
            Separator::Sign('\t') => rest.trim_start_matches(' '),
            _ => rest.trim_start(),
        };
        let (cell, after) = match start.strip_prefix('"').and_then(quoted) {
            Some((cell, after)) => {
                let next = after.find(separates);
                (
                    Cow::Owned(cell.split_whitespace().collect::<Vec<_>>().join(" ")),
                    next.and_then(|place| after.get(place..)),
                )
            }
            None => {
                let next = start.find(separates);
                let cell = next.map_or(start, |place| start.get(..place).unwrap_or_default());
                (
                    Cow::Borrowed(cell.trim()),
                    next.and_then(|place| start.get(place..)),
                )
            }
        };
        if !(separator == Separator::Blanks && cell.is_empty()) {
            cells.push(cell);
        }
        match after {
            Some(after) => rest = after.strip_prefix(separates).unwrap_or_default(),
            None => return cells,
        }
    }
}

/// Text up to the closing quote, and the text after it.
fn quoted(text: &str) -> Option<(String, &str)> {
    let (mut cell, mut rest) = (String::new(), text);
    loop {
        let (before, after) = rest.split_once('"')?;
        cell.push_str(before);
        match after.strip_prefix('"') {
            Some(after) => {
                cell.push('"');
                rest = after;
            }
            None => return Some((cell, after)),
        }
    }
}

/// The separator that splits the most lines into the same number of numeric cells, at least two.
pub fn separator(lines: &[Line]) -> Separator {
    let candidates = [
        Separator::Sign(';'),
        Separator::Sign('\t'),
        Separator::Sign('|'),
        Separator::Sign(','),
        Separator::Blanks,
    ];
    let content = || lines.iter().filter(|line| !line.comment).take(LOOKED_AT);
    let mut best = ((0, 0), Separator::Sign(','));
    for candidate in candidates {
        let (mut counts, mut numbers) = (Vec::new(), 0);
        for cells in content().map(|line| split(line.text, candidate)) {
            if cells.len() < 2 {
                continue;
            }
            numbers += cells.iter().filter(|cell| number::is_number(cell)).count();
            if cells.iter().all(|cell| number::is_number_or_hole(cell)) {
                counts.push(cells.len());
            }
        }
        counts.sort_unstable();
        let alike = counts.chunk_by(|a, b| a == b).map(<[usize]>::len).max();
        // where no line is all numbers, count the numeric cells instead
        let score = alike.map_or((0, numbers), |alike| (alike, 0));
        if score > best.0 {
            best = (score, candidate);
        }
    }
    best.1
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(text: &str) -> Separator {
        separator(&lines(text).0)
    }

    #[test]
    fn the_separator_cuts_most_lines_alike() {
        assert_eq!(found("T, K\tp, Pa\n1\t2\n3\t4\n"), Separator::Sign('\t'));
        assert_eq!(found("a;b\n0;1,2250\n5;0,7361\n"), Separator::Sign(';'));
        assert_eq!(found("0, 1.2\n5, 0.7\n"), Separator::Sign(','));
        assert_eq!(found("  0   1,2250\n5000  0,7361\n"), Separator::Blanks);
        assert_eq!(found("0|1\n2|3\n"), Separator::Sign('|'));
        // an extra tab for alignment
        assert_eq!(
            found("0\t\t290.0\t1.2\n1000\t280.0\t1.1\n2000\t270.0\t1.0\n"),
            Separator::Blanks
        );
        // a blank cell
        assert_eq!(
            found("0\t\t1.2\n1000\t280.0\t1.1\n2000\t270.0\t1.0\n"),
            Separator::Sign('\t')
        );
        let (lines, named) = lines("sep=|\n1|2\n");
        assert_eq!((lines[0].number, named), (2, Some(Separator::Sign('|'))));
    }

    #[test]
    fn quotes_hold_separators_and_line_ends() {
        let (found, _) = lines("\"alt\nitude (m)\",\"a \"\"b\"\", c\"\n1,x (\"),\n# \"open\n2,3\n");
        assert_eq!(
            found.iter().map(|l| l.number).collect::<Vec<_>>(),
            [1, 3, 4, 5]
        );
        assert_eq!(
            split(found[0].text, Separator::Sign(',')),
            ["alt itude (m)", "a \"b\", c"]
        );
        assert_eq!(split(found[1].text, Separator::Sign(',')), ["1", "x (\")"]);
        assert!(found[2].comment);
        assert_eq!(
            split("\"1 2\"  3 \"4\"", Separator::Blanks),
            ["1 2", "3", "4"]
        );
        assert_eq!(split("\t1\t\t2", Separator::Sign('\t')), ["", "1", "", "2"]);
    }
}
