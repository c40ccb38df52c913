//! Records of 80 columns: start, global, directory, parameter and terminate sections.

/// Entity before it is written to the file.
#[derive(Clone, Debug)]
pub struct Entity<'a> {
    /// Entity type.
    pub kind: usize,
    /// Form number of the type.
    pub form: usize,
    /// Level.
    pub level: usize,
    /// Directory entry of the color; zero for none.
    pub color: usize,
    /// Blank status, subordinate switch, use, hierarchy.
    pub status: &'static str,
    /// Label; the first eight characters are kept.
    pub label: &'a str,
    /// Parameters after the entity type.
    pub parameters: Vec<String>,
}

impl Default for Entity<'_> {
    fn default() -> Self {
        Self {
            kind: 0,
            form: 0,
            level: 0,
            color: 0,
            status: "00000000",
            label: "",
            parameters: Vec::new(),
        }
    }
}

/// Directory and parameter sections of a file.
#[derive(Default)]
pub struct File {
    directory: Vec<String>,
    parameters: Vec<String>,
}

impl File {
    /// Adds an entity and returns its directory entry number, by which others refer to it.
    pub fn add(&mut self, entity: Entity) -> usize {
        let place = self.directory.len() + 1;
        let first = self.parameters.len() + 1;
        let mut tokens = vec![entity.kind.to_string()];
        tokens.extend(entity.parameters);
        let lines = wrapped(&tokens, 64);
        for line in &lines {
            let number = self.parameters.len() + 1;
            self.parameters
                .push(format!("{line:<64} {place:7}P{number:7}"));
        }
        let color = match entity.color {
            0 => "0".to_owned(),
            place => format!("-{place}"),
        };
        let label: String = entity.label.chars().take(8).collect();
        let (kind, level, status) = (entity.kind, entity.level, entity.status);
        self.directory.push(format!(
            "{kind:8}{first:8}{:8}{:8}{level:8}{:8}{:8}{:8}{status:>8}D{place:7}",
            0, 1, 0, 0, 0
        ));
        self.directory.push(format!(
            "{kind:8}{:8}{color:>8}{:8}{:8}{:8}{:8}{label:>8}{:8}D{:7}",
            0,
            lines.len(),
            entity.form,
            "",
            "",
            0,
            place + 1
        ));
        place
    }

    /// The complete file.
    pub fn into_text(self, remark: &str, global: &[String]) -> String {
        let mut text = String::new();
        let remark = ascii(remark);
        let numbered = |lines: &[String], section: char, text: &mut String| {
            for (line, number) in lines.iter().zip(1..) {
                text.push_str(&format!("{line:<72}{section}{number:7}\n"));
            }
            lines.len()
        };
        let remark: Vec<String> = pieces(&remark, 72);
        let start = numbered(&remark, 'S', &mut text);
        let global = numbered(&wrapped(global, 72), 'G', &mut text);
        let (directory, parameters) = (self.directory.len(), self.parameters.len());
        for line in self.directory.iter().chain(&self.parameters) {
            text.push_str(line);
            text.push('\n');
        }
        let last = format!("S{start:7}G{global:7}D{directory:7}P{parameters:7}");
        text.push_str(&format!("{last:<72}T{:7}\n", 1));
        text
    }
}

/// Parameters with their delimiters in lines of at most `width` columns; only a string longer than a line is split.
fn wrapped(parameters: &[String], width: usize) -> Vec<String> {
    let mut lines = Vec::new();
    let mut line = String::new();
    for (parameter, number) in parameters.iter().zip(1..) {
        let delimiter = if number == parameters.len() { ';' } else { ',' };
        let token = format!("{parameter}{delimiter}");
        if !line.is_empty() && line.len() + token.len() > width {
            lines.push(std::mem::take(&mut line));
        }
        let mut whole = pieces(&token, width);
        line.push_str(&whole.pop().unwrap_or_default());
        lines.extend(whole);
    }
    lines.push(line);
    lines
}

/// ASCII text in pieces of `width` characters, at least one piece.
fn pieces(text: &str, width: usize) -> Vec<String> {
    let letters: Vec<char> = text.chars().collect();
    match letters.is_empty() {
        true => vec![String::new()],
        false => letters.chunks(width).map(|c| c.iter().collect()).collect(),
    }
}

fn ascii(text: &str) -> String {
    let plain = |c: char| if (' '..='~').contains(&c) { c } else { '?' };
    text.chars().map(plain).collect()
}

/// A string with its length as prefix (Hollerith form).
pub fn text(text: &str) -> String {
    let text = ascii(text);
    format!("{}H{text}", text.len())
}

/// A double-precision number, always with a decimal point.
pub fn real(value: f64) -> String {
    let text = format!("{:?}", value + 0.0);
    match text.split_once('e') {
        Some((digits, exponent)) if digits.contains('.') => format!("{digits}D{exponent}"),
        Some((digits, exponent)) => format!("{digits}.D{exponent}"),
        None => text.trim_end_matches('0').to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_strings() {
        assert_eq!(real(0.25), "0.25");
        assert_eq!(real(900.0), "900.");
        assert_eq!(real(1e-7), "1.D-7");
        assert_eq!(text("a,b"), "3Ha,b");
        assert_eq!(text("°"), "1H?");
    }

    #[test]
    fn only_strings_are_cut() {
        let parameters = ["110".to_owned(), "1234.5".to_owned(), text("abcdefghijkl")];
        assert_eq!(
            wrapped(&parameters, 8),
            ["110,", "1234.5,", "12Habcde", "fghijkl;"]
        );
    }
}
