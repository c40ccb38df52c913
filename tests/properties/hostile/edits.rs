//! Changes of a file by accident or with bad intent.

use proptest::prelude::*;
use proptest::sample::{Index, select};

/// Bytes with a meaning for a reader of text, TOML, JSON, tables or drawings.
const SIGNS: &[u8] = b"0123456789.,;:-+eE#\"'[]{}()=\t\n\r \0/%$\x1b\x85\xb0\xff";

/// Numbers at the limits of floating point, and words for missing ones.
const NUMBERS: &[&str] = &[
    "0",
    "-0",
    "1",
    "-1",
    "90",
    "180",
    "360",
    "1e-320",
    "5e-324",
    "1e308",
    "1e400",
    "-1e400",
    "nan",
    "inf",
    "-inf",
    "NaN",
    "1,5",
    "1.400",
    "1,212",
    "5,000",
    "1e",
    "0x10",
    "1_000",
    "99999999999999999999",
    "",
    "\"\"",
    "[]",
    "{}",
    "true",
    "-",
    "1e-3 km",
    "9e7",
];

/// Change of a file.
#[derive(Clone, Debug)]
pub(crate) enum Edit {
    /// Replace a byte.
    Byte(Index, u8),
    /// Insert bytes.
    Put(Index, Vec<u8>),
    /// Remove a number of bytes.
    Cut(Index, usize),
    /// Truncate the file.
    End(Index),
    /// Replace a number.
    Number(Index, String),
    /// Remove a line.
    LineOut(Index),
    /// Duplicate a line elsewhere.
    LineAgain(Index, Index),
    /// Insert a line of the other file.
    LineFromOther(Index, Index),
    /// Insert an opening bracket a number of times.
    Nest(Index, u8, usize),
    /// Change the encoding.
    Encode(Encoding),
    /// Replace all occurrences of a byte.
    Each(u8, u8),
}

/// Text encoding.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Encoding {
    Utf8WithMark,
    Utf16Little,
    Utf16BigWithMark,
    Windows,
}

fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => select(NUMBERS).prop_map(str::to_string),
        1 => any::<f64>().prop_map(|x| format!("{x:?}")),
        2 => (-12.0..12.0_f64).prop_map(|power| format!("{:?}", 10.0_f64.powf(power))),
        2 => (-1000..1000_i32).prop_map(|x| x.to_string()),
    ]
}

fn edit() -> impl Strategy<Value = Edit> {
    let place = any::<Index>;
    let sign = || select(SIGNS);
    let encoding = select(vec![
        Encoding::Utf8WithMark,
        Encoding::Utf16Little,
        Encoding::Utf16BigWithMark,
        Encoding::Windows,
    ]);
    prop_oneof![
        3 => (place(), sign()).prop_map(|(at, byte)| Edit::Byte(at, byte)),
        1 => (place(), any::<u8>()).prop_map(|(at, byte)| Edit::Byte(at, byte)),
        2 => (place(), prop::collection::vec(sign(), 1..6)).prop_map(|(at, bytes)| Edit::Put(at, bytes)),
        2 => (place(), 1..40_usize).prop_map(|(at, count)| Edit::Cut(at, count)),
        1 => place().prop_map(Edit::End),
        8 => (place(), number()).prop_map(|(at, number)| Edit::Number(at, number)),
        2 => place().prop_map(Edit::LineOut),
        2 => (place(), place()).prop_map(|(from, to)| Edit::LineAgain(from, to)),
        3 => (place(), place()).prop_map(|(from, to)| Edit::LineFromOther(from, to)),
        1 => (place(), select(b"[{(\"".as_slice()), 1..200_usize).prop_map(|(at, sign, count)| Edit::Nest(at, sign, count)),
        1 => encoding.prop_map(Edit::Encode),
        1 => (sign(), sign()).prop_map(|(from, to)| Edit::Each(from, to)),
    ]
}

/// One to five changes.
pub(crate) fn edits() -> impl Strategy<Value = Vec<Edit>> {
    prop::collection::vec(edit(), 1..6)
}

fn insert(bytes: &mut Vec<u8>, at: Index, new: &[u8]) {
    let at = at.index(bytes.len() + 1);
    bytes.splice(at..at, new.iter().copied());
}

fn lines(bytes: &[u8]) -> Vec<&[u8]> {
    bytes.split_inclusive(|byte| *byte == b'\n').collect()
}

/// Positions of the numbers of a file.
fn numbers(bytes: &[u8]) -> Vec<(usize, usize)> {
    let of_number = |byte: u8| byte.is_ascii_digit() || b"+-.eE".contains(&byte);
    let mut found = Vec::new();
    let mut at = 0;
    for piece in bytes.split(|byte| !of_number(*byte)) {
        if piece.iter().any(u8::is_ascii_digit) {
            found.push((at, at + piece.len()));
        }
        at += piece.len() + 1;
    }
    found
}

fn encoded(bytes: &[u8], encoding: Encoding) -> Vec<u8> {
    let text = String::from_utf8_lossy(bytes);
    match encoding {
        Encoding::Utf8WithMark => [b"\xef\xbb\xbf", text.as_bytes()].concat(),
        Encoding::Utf16Little => text.encode_utf16().flat_map(u16::to_le_bytes).collect(),
        Encoding::Utf16BigWithMark => {
            let mark = [0xfe, 0xff].into_iter();
            mark.chain(text.encode_utf16().flat_map(u16::to_be_bytes))
                .collect()
        }
        Encoding::Windows => text
            .chars()
            .map(|c| u8::try_from(c).unwrap_or(b'?'))
            .collect(),
    }
}

fn changed(mut bytes: Vec<u8>, edit: &Edit, other: &[u8]) -> Vec<u8> {
    match edit {
        Edit::Byte(at, new) => {
            if !bytes.is_empty() {
                let at = at.index(bytes.len());
                bytes[at] = *new;
            }
        }
        Edit::Put(at, new) => insert(&mut bytes, *at, new),
        Edit::Cut(at, count) => {
            let from = at.index(bytes.len() + 1);
            bytes.drain(from..(from + count).min(bytes.len()));
        }
        Edit::End(at) => bytes.truncate(at.index(bytes.len() + 1)),
        Edit::Number(at, new) => {
            let found = numbers(&bytes);
            if !found.is_empty() {
                let (from, to) = found[at.index(found.len())];
                bytes.splice(from..to, new.bytes());
            }
        }
        Edit::LineOut(at) => {
            let mut lines = lines(&bytes);
            if !lines.is_empty() {
                lines.remove(at.index(lines.len()));
            }
            return lines.concat();
        }
        Edit::LineAgain(from, to) => {
            let mut lines = lines(&bytes);
            if !lines.is_empty() {
                lines.insert(to.index(lines.len()), lines[from.index(lines.len())]);
            }
            return lines.concat();
        }
        Edit::LineFromOther(from, to) => {
            let (mut lines, others) = (lines(&bytes), lines(other));
            if !others.is_empty() {
                lines.insert(to.index(lines.len() + 1), others[from.index(others.len())]);
            }
            return lines.concat();
        }
        Edit::Nest(at, sign, count) => insert(&mut bytes, *at, &vec![*sign; *count]),
        Edit::Encode(encoding) => return encoded(&bytes, *encoding),
        Edit::Each(from, to) => {
            for byte in bytes.iter_mut().filter(|byte| *byte == from) {
                *byte = *to;
            }
        }
    }
    bytes
}

/// A file after the changes; lines may come from another file.
pub(crate) fn after(file: &[u8], edits: &[Edit], other: &[u8]) -> Vec<u8> {
    let mut bytes = file.to_vec();
    for edit in edits {
        bytes = changed(bytes, edit, other);
    }
    bytes
}
