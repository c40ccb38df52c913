//! Text encoding of ISO 10303-21: instances, numbers, strings.

/// Instances of the data section, numbered from 1.
#[derive(Default)]
pub struct Instances {
    text: String,
    count: usize,
}

/// Instance number.
pub type Id = usize;

impl Instances {
    /// Adds an instance, `NAME(parameters)`.
    pub fn add(&mut self, instance: &str) -> Id {
        self.count += 1;
        self.text
            .push_str(&format!("#{}={instance};\n", self.count));
        self.count
    }

    /// Adds an instance from its name and parameters.
    pub fn put(&mut self, name: &str, parameters: &[String]) -> Id {
        self.add(&format!("{name}({})", parameters.join(",")))
    }

    /// The instances, one per line.
    pub fn into_text(self) -> String {
        self.text
    }
}

/// Reference to an instance.
pub fn of(id: Id) -> String {
    format!("#{id}")
}

/// References in parentheses.
pub fn list(ids: &[Id]) -> String {
    let ids: Vec<String> = ids.iter().map(|&id| of(id)).collect();
    format!("({})", ids.join(","))
}

/// The number in the shortest form that reads back to the same bits, always with a decimal point.
pub fn real(value: f64) -> String {
    // turns negative zero into positive zero
    let text = format!("{:?}", value + 0.0).to_uppercase();
    match text.split_once('E') {
        Some((digits, exponent)) if !digits.contains('.') => format!("{digits}.E{exponent}"),
        Some(_) => text,
        None => text.trim_end_matches('0').to_owned(),
    }
}

/// Numbers in parentheses.
pub fn reals(values: &[f64]) -> String {
    let values: Vec<String> = values.iter().map(|&v| real(v)).collect();
    format!("({})", values.join(","))
}

/// A quoted string; characters outside ASCII are escaped by code.
pub fn string(text: &str) -> String {
    let mut out = String::from("'");
    for c in text.chars() {
        match c {
            '\'' => out.push_str("''"),
            '\\' => out.push_str("\\\\"),
            ' '..='~' => out.push(c),
            c if u32::from(c) <= 0xffff => {
                out.push_str(&format!("\\X2\\{:04X}\\X0\\", u32::from(c)));
            }
            c => out.push_str(&format!("\\X4\\{:08X}\\X0\\", u32::from(c))),
        }
    }
    out.push('\'');
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_a_point_and_read_back() {
        let rows = [
            (0.0, "0."),
            (-0.0, "0."),
            (900.0, "900."),
            (-0.25, "-0.25"),
            (1e-7, "1.E-7"),
            (1.5e20, "1.5E20"),
            (100.0, "100."),
        ];
        for (value, want) in rows {
            assert_eq!(real(value), want);
        }
        assert_eq!(real(0.1 + 0.2).parse::<f64>(), Ok(0.1 + 0.2));
    }

    #[test]
    fn strings_are_ascii() {
        assert_eq!(string("it's a \\"), "'it''s a \\\\'");
        assert_eq!(string("60°"), "'60\\X2\\00B0\\X0\\'");
    }
}
