//! Groups of a DXF file, each a code and a value, from text or binary files.
//!
//! ```text
//! text:    a line with the code, a line with the value
//! binary:  "AutoCAD Binary DXF\r\n", 1A, 00; codes of two bytes (of one byte before release 13; FF before two more); values by code
//! ```
//!
//! # Valid
//! Text in any encoding that extends ASCII: names that are not UTF-8 are read byte by byte as Latin-1, on both sides of
//! a comparison.
//!
//! # References
//! - \[autodesk-dxf\] group code value types; binary DXF files.

use crate::outline::{ImportFault, MOST_SHOWN};
use std::fmt;
use std::str::from_utf8;

/// First bytes of a binary file.
const SENTINEL: &[u8] = b"AutoCAD Binary DXF\r\n\x1a\0";

/// Place in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Line of a text file, from 1.
    Line(u64),
    /// Byte of a binary file, from 1.
    Byte(u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// Value as stored in the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<'a> {
    /// Text; all values of a text file.
    Text(&'a [u8]),
    /// Floating-point number of a binary file.
    Real(f64),
    /// Whole number of a binary file.
    Whole(i64),
}

/// Group code and value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Group<'a> {
    /// Group code.
    pub code: i32,
    /// Value.
    pub value: Value<'a>,
    /// Place of the code.
    pub place: Place,
}

impl Group<'_> {
    /// Whether the group has this code and this word as value.
    pub fn is(&self, code: i32, word: &str) -> bool {
        self.code == code && self.value == Value::Text(word.as_bytes())
    }

    /// The value as text.
    pub fn name(&self) -> String {
        match self.value {
            Value::Text(bytes) => from_utf8(bytes).map_or_else(
                |_| bytes.iter().map(|byte| char::from(*byte)).collect(),
                str::to_owned,
            ),
            Value::Real(number) => number.to_string(),
            Value::Whole(number) => number.to_string(),
        }
    }

    /// The value as a whole number, if it is one.
    pub fn whole(&self) -> Option<i64> {
        match self.value {
            Value::Text(bytes) => from_utf8(bytes).ok()?.parse().ok(),
            Value::Real(_) => None,
            Value::Whole(number) => Some(number),
        }
    }

    /// The value as a finite number, or a fault.
    pub fn number(&self) -> Result<f64, ImportFault> {
        let number = match self.value {
            Value::Text(bytes) => from_utf8(bytes).ok().and_then(|text| text.parse().ok()),
            Value::Real(number) => Some(number),
            Value::Whole(number) => Some(number as f64),
        };
        number.filter(|n: &f64| n.is_finite()).ok_or_else(|| {
            let shown: String = self.name().chars().take(MOST_SHOWN).collect();
            let place = match self.place {
                Place::Line(line) => Place::Line(line + 1),
                byte => byte,
            };
            ImportFault::Drawing {
                place,
                reason: format!("got \"{shown}\", must be a number"),
            }
        })
    }
}

/// Groups of a file.
pub fn groups(bytes: &[u8]) -> Result<Vec<Group<'_>>, ImportFault> {
    let groups = match bytes.strip_prefix(SENTINEL) {
        Some(rest) => binary(rest)?,
        None => text(bytes)?,
    };
    match groups.is_empty() {
        true => Err(ImportFault::Empty("DXF group")),
        false => Ok(groups),
    }
}

fn text(bytes: &[u8]) -> Result<Vec<Group<'_>>, ImportFault> {
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    // files of old Macintosh systems end lines with a carriage return only
    let end = if bytes.contains(&b'\n') { b'\n' } else { b'\r' };
    let mut lines = bytes
        .split(|byte| *byte == end)
        .map(<[u8]>::trim_ascii)
        .zip(1..);
    let mut groups: Vec<Group> = Vec::new();
    while let Some((code, line)) = lines.next() {
        let number = from_utf8(code).ok().and_then(|code| code.parse().ok());
        let Some(code) = number else {
            // the rest after the last line feed
            if code.is_empty() && lines.all(|(rest, _)| rest.is_empty()) {
                break;
            }
            let shown: String = String::from_utf8_lossy(code)
                .chars()
                .take(MOST_SHOWN)
                .collect();
            let reason = format!("got \"{shown}\", must be the group code of a DXF file");
            let place = Place::Line(line);
            return Err(ImportFault::Drawing { place, reason });
        };
        let group = Group {
            code,
            value: Value::Text(lines.next().map_or(b"", |(value, _)| value)),
            place: Place::Line(line),
        };
        groups.push(group);
        if group.is(0, "EOF") {
            break;
        }
    }
    Ok(groups)
}

/// Unread bytes.
struct Rest<'a> {
    bytes: &'a [u8],
    /// Number of bytes read, including the sentinel.
    read: u64,
}

impl<'a> Rest<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], ImportFault> {
        let Some((taken, rest)) = self.bytes.split_at_checked(count) else {
            return Err(ImportFault::Drawing {
                place: Place::Byte(self.read + 1),
                reason: "the file ends within a group".to_owned(),
            });
        };
        self.bytes = rest;
        self.read += count as u64;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], ImportFault> {
        let mut array = [0; N];
        array.copy_from_slice(self.take(N)?);
        Ok(array)
    }

    /// A zero-terminated text.
    fn text(&mut self) -> Result<&'a [u8], ImportFault> {
        let end = self.bytes.iter().position(|byte| *byte == 0);
        let text = self.take(end.unwrap_or(self.bytes.len()))?;
        self.take(1)?;
        Ok(text.trim_ascii())
    }

    fn value(&mut self, code: i32) -> Result<Value<'a>, ImportFault> {
        let whole = |number: i64| Ok(Value::Whole(number));
        match code {
            10..=59 | 110..=149 | 210..=239 | 460..=469 | 1010..=1059 => {
                Ok(Value::Real(f64::from_le_bytes(self.array()?)))
            }
            60..=79 | 170..=179 | 270..=289 | 370..=389 | 400..=409 | 1060..=1070 => {
                whole(i64::from(i16::from_le_bytes(self.array()?)))
            }
            90..=99 | 420..=429 | 440..=459 | 1071 => {
                whole(i64::from(i32::from_le_bytes(self.array()?)))
            }
            160..=169 => whole(i64::from_le_bytes(self.array()?)),
            290..=299 => whole(i64::from(u8::from_le_bytes(self.array()?))),
            310..=319 | 1004 => {
                let [length] = self.array()?;
                Ok(Value::Text(self.take(usize::from(length))?))
            }
            _ => Ok(Value::Text(self.text()?)),
        }
    }
}

fn binary(bytes: &[u8]) -> Result<Vec<Group<'_>>, ImportFault> {
    // the file begins with code 0 and a word, or with a comment, code 999
    let wide = match bytes {
        [0, second, ..] => *second == 0,
        [first, ..] => *first != 0xff,
        [] => true,
    };
    let mut rest = Rest {
        bytes,
        read: SENTINEL.len() as u64,
    };
    let mut groups: Vec<Group> = Vec::new();
    while !rest.bytes.is_empty() {
        let place = Place::Byte(rest.read + 1);
        let code = match (wide, rest.bytes) {
            (false, [first, ..]) if *first != 0xff => {
                rest.take(1)?;
                i32::from(*first)
            }
            (false, _) => {
                let [_, low, high] = rest.array()?;
                i32::from(i16::from_le_bytes([low, high]))
            }
            (true, _) => i32::from(i16::from_le_bytes(rest.array()?)),
        };
        let value = rest.value(code)?;
        let group = Group { code, value, place };
        groups.push(group);
        if group.is(0, "EOF") {
            break;
        }
    }
    Ok(groups)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shown(bytes: &[u8]) -> Vec<(i32, String)> {
        let groups = groups(bytes).unwrap();
        groups.iter().map(|g| (g.code, g.name())).collect()
    }

    #[test]
    fn both_binary_codes_and_text_say_the_same() {
        let wanted = [
            (0, "LINE"),
            (8, "0"),
            (10, "0.5"),
            (62, "-7"),
            (1071, "70000"),
            (0, "EOF"),
        ]
        .map(|(code, name)| (code, name.to_owned()));
        let narrow = [SENTINEL, b"\x00LINE\0\x080\0\x0a\0\0\0\0\0\0\xe0\x3f\x3e\xf9\xff\xff\x2f\x04\x70\x11\x01\0\0EOF\0"];
        let wide = [SENTINEL, b"\0\0LINE\0\x08\x000\0\x0a\0\0\0\0\0\0\0\xe0\x3f\x3e\0\xf9\xff\x2f\x04\x70\x11\x01\0\0\0EOF\0"];
        assert_eq!(shown(&narrow.concat()), wanted);
        assert_eq!(shown(&wide.concat()), wanted);
        let text =
            "  0\r\nLINE\r\n8\r\n0\r\n10\r\n0.5\r\n62\r\n-7\r\n1071\r\n70000\r\n0\r\nEOF\r\n";
        assert_eq!(shown(text.as_bytes()), wanted);
        assert_eq!(shown(text.replace('\n', "").as_bytes()), wanted);
        assert_eq!(
            shown(format!("\u{feff}{text}\n\nrubbish").as_bytes()),
            wanted
        );
    }

    #[test]
    fn a_file_that_is_cut_off_says_at_which_byte() {
        let cut = [SENTINEL, b"\0\0LINE\0\x0a\0\0\0\0"].concat();
        let fault = groups(&cut).unwrap_err().to_string();
        assert_eq!(fault, "byte 32: the file ends within a group");
        assert!(
            groups(SENTINEL)
                .unwrap_err()
                .to_string()
                .contains("no DXF group")
        );
    }

    #[test]
    fn names_in_another_encoding_are_kept_apart() {
        assert_eq!(shown(b"8\nUmri\xdf\n0\nEOF\n")[0].1, "Umri\u{df}");
        assert_eq!(shown("8\nUmriß\n".as_bytes())[0].1, "Umri\u{df}");
    }
}
