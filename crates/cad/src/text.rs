//! Decoding of file bytes to text, whatever the encoding.
//!
//! ```text
//! byte order mark:   UTF-8, UTF-16 little or big endian
//! without one:       UTF-16 where every second byte is zero, UTF-8 where it is valid, else Windows-1252
//! ```
//!
//! # Valid
//! Text in one of these encodings. Bytes with control characters that do not occur in text are refused.
//!
//! # References
//! - \[whatwg-encoding\] for the index of Windows-1252.

/// Windows-1252 characters of 0x80 to 0x9F; the five undefined codes map to themselves.
const WINDOWS_1252: [char; 32] = [
    '€', '\u{81}', '‚', 'ƒ', '„', '…', '†', '‡', 'ˆ', '‰', 'Š', '‹', 'Œ', '\u{8d}', 'Ž', '\u{8f}',
    '\u{90}', '‘', '’', '“', '”', '•', '–', '—', '˜', '™', 'š', '›', 'œ', '\u{9d}', 'ž', 'Ÿ',
];
/// Number of bytes examined for zeros.
const LOOKED_AT: usize = 4096;

/// Fewest 16-bit units for which text without a byte order mark is taken for UTF-16.
const FEWEST: usize = 4;

/// Decoded text of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Decoded {
    /// Text without byte order mark.
    pub text: String,
    /// Encoding, if not UTF-8.
    pub encoding: Option<&'static str>,
}

/// Reason why bytes are not text.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum NotText {
    /// Invalid UTF-16.
    #[error("is not text: it opens as UTF-16 and goes on as something else")]
    Utf16,
    /// A control character that does not occur in text.
    #[error("is not text: byte {0} is a control character")]
    Control(usize),
}

/// The text of a file.
///
/// # Errors
/// Bytes that are not text.
pub fn decode(bytes: &[u8]) -> Result<Decoded, NotText> {
    let decoded = match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => utf_8(rest),
        [0xff, 0xfe, rest @ ..] => utf_16(rest, u16::from_le_bytes, "UTF-16 little endian")?,
        [0xfe, 0xff, rest @ ..] => utf_16(rest, u16::from_be_bytes, "UTF-16 big endian")?,
        _ => match zeros(bytes) {
            Zeros::Second => utf_16(bytes, u16::from_le_bytes, "UTF-16 little endian")?,
            Zeros::First => utf_16(bytes, u16::from_be_bytes, "UTF-16 big endian")?,
            Zeros::Elsewhere => utf_8(bytes),
        },
    };
    let strange = |c: char| {
        c.is_control()
            && !matches!(
                c,
                '\t' | '\n' | '\r' | '\u{c}' | '\u{1a}' | '\u{80}'..='\u{9f}'
            )
    };
    match decoded.text.find(strange) {
        Some(place) => Err(NotText::Control(place + 1)),
        None => Ok(decoded),
    }
}

fn utf_8(bytes: &[u8]) -> Decoded {
    match std::str::from_utf8(bytes) {
        Ok(text) => Decoded {
            text: text.to_owned(),
            encoding: None,
        },
        Err(_) => Decoded {
            text: bytes.iter().copied().map(windows_1252).collect(),
            encoding: Some("Windows-1252"),
        },
    }
}

fn windows_1252(byte: u8) -> char {
    let place = usize::from(byte).checked_sub(0x80);
    let listed = place.and_then(|place| WINDOWS_1252.get(place)).copied();
    listed.unwrap_or(char::from(byte))
}

fn utf_16(
    bytes: &[u8],
    unit: fn([u8; 2]) -> u16,
    encoding: &'static str,
) -> Result<Decoded, NotText> {
    let (pairs, rest) = bytes.as_chunks::<2>();
    let text: Result<String, _> =
        char::decode_utf16(pairs.iter().map(|pair| unit(*pair))).collect();
    match text {
        Ok(text) if rest.is_empty() => Ok(Decoded {
            text: text.trim_start_matches('\u{feff}').to_owned(),
            encoding: Some(encoding),
        }),
        _ => Err(NotText::Utf16),
    }
}

/// Positions of zero bytes in possible UTF-16 without byte order mark.
enum Zeros {
    First,
    Second,
    Elsewhere,
}

fn zeros(bytes: &[u8]) -> Zeros {
    let (pairs, _) = bytes.get(..LOOKED_AT).unwrap_or(bytes).as_chunks::<2>();
    if bytes.len() % 2 == 1 || pairs.len() < FEWEST {
        return Zeros::Elsewhere;
    }
    let count = |place: usize| pairs.iter().filter(|pair| pair[place] == 0).count();
    let (first, second) = (count(0), count(1));
    // Latin text in UTF-16: nearly every unit has one zero byte, always the same one.
    let most = pairs.len() * 3 / 4;
    match (first, second) {
        (0, second) if second > 0 && second >= most => Zeros::Second,
        (first, 0) if first > 0 && first >= most => Zeros::First,
        _ => Zeros::Elsewhere,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn text(bytes: &[u8]) -> (String, Option<&'static str>) {
        let Decoded { text, encoding } = decode(bytes).unwrap();
        (text, encoding)
    }

    #[test]
    fn one_text_in_five_encodings() {
        let plain = "T [°C];ρ\n1;2\n";
        let utf_16 =
            |unit: fn(u16) -> [u8; 2]| -> Vec<u8> { plain.encode_utf16().flat_map(unit).collect() };
        let (le, be) = (utf_16(u16::to_le_bytes), utf_16(u16::to_be_bytes));
        assert_eq!(text(plain.as_bytes()), (plain.to_owned(), None));
        assert_eq!(text(&[b"\xef\xbb\xbf", plain.as_bytes()].concat()).0, plain);
        assert_eq!(text(&[&[0xff, 0xfe][..], &le].concat()).0, plain);
        assert_eq!(text(&[&[0xfe, 0xff][..], &be].concat()).0, plain);
        assert_eq!(text(&le), (plain.to_owned(), Some("UTF-16 little endian")));
        assert_eq!(text(&be), (plain.to_owned(), Some("UTF-16 big endian")));
        assert_eq!(
            text(b"T [\xb0C] \x80"),
            ("T [°C] €".to_owned(), Some("Windows-1252"))
        );
    }

    #[test]
    fn what_is_no_text_is_refused() {
        assert_eq!(decode(b"a\0b=c"), Err(NotText::Control(2)));
        assert_eq!(
            decode(b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR"),
            Err(NotText::Control(11))
        );
        assert_eq!(decode(b"\xff\xfea"), Err(NotText::Utf16));
        assert_eq!(decode(b"").unwrap().text, "");
    }
}
