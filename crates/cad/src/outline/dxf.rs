//! Lines and arcs of a DXF drawing as rows of points: x of the drawing is the axis, y the distance from it.
//!
//! ```text
//! a pair of lines is a group code and its value; bulge = tan(sweep / 4)
//! ```
//!
//! Read are LINE, ARC, LWPOLYLINE and POLYLINE; text, points and dimensions are passed over; anything else that could be part
//! of an outline is refused. Where a layer is called `outline`, only that layer counts.
//!
//! # Valid
//! ASCII drawings in the plane z = 0, with $INSUNITS or a unit from the case.
//!
//! # References
//! - \[autodesk-dxf\] ENTITIES section, $INSUNITS, object coordinates (group 230).

use super::chain::{Piece, rows};
use super::{ImportFault, LengthUnit, MOST_FAULTS, shown};
use msape::vehicle::segment::Point;
use numerics::math::{RADIANS_PER_DEGREE, sin_cos, tan};

/// A group: code, value, line of the code.
type Group<'a> = (i32, &'a str, u64);

/// Entities that are no part of an outline.
const PASSED_OVER: [&str; 14] = [
    "TEXT",
    "MTEXT",
    "POINT",
    "DIMENSION",
    "LEADER",
    "MULTILEADER",
    "HATCH",
    "VIEWPORT",
    "ATTDEF",
    "ATTRIB",
    "TOLERANCE",
    "IMAGE",
    "SEQEND",
    "VERTEX",
];

/// An entity: its name, line, groups.
struct Entity<'a> {
    kind: &'a str,
    line: u64,
    groups: &'a [Group<'a>],
}

/// Rows of x, r in metres and bulge, or everything that is wrong with the drawing.
pub fn read(text: &str, unit: Option<LengthUnit>) -> Result<Vec<Vec<f64>>, Vec<ImportFault>> {
    let groups = groups(text)?;
    let section = |name: &str| {
        let mut from = None;
        for (i, pair) in groups.windows(2).enumerate() {
            if let [(0, "SECTION", _), (2, found, _)] = pair
                && *found == name
            {
                from = Some(i + 2);
            }
        }
        let from = from.unwrap_or(groups.len());
        let rest = groups.get(from..).unwrap_or(&[]);
        let length = rest
            .iter()
            .position(|(code, value, _)| *code == 0 && *value == "ENDSEC");
        rest.get(..length.unwrap_or(rest.len())).unwrap_or(&[])
    };
    let mut faults = Vec::new();
    let unit = drawn_unit(section("HEADER"), &mut faults).or(unit);
    let pieces = pieces(section("ENTITIES"), &mut faults);
    if unit.is_none() && faults.is_empty() {
        faults.push(ImportFault::NoUnitInDrawing);
    }
    faults.truncate(MOST_FAULTS);
    match unit {
        Some(unit) if faults.is_empty() => {
            let scale = |p: Point| Point {
                x_m: p.x_m * unit.metres(),
                r_m: p.r_m * unit.metres(),
            };
            let pieces = pieces.into_iter().map(|p| Piece {
                start: scale(p.start),
                end: scale(p.end),
                ..p
            });
            rows(pieces.collect())
        }
        _ => Err(faults),
    }
}

fn groups(text: &str) -> Result<Vec<Group<'_>>, Vec<ImportFault>> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut groups = Vec::new();
    let mut lines = text.lines().map(str::trim).zip(1..);
    while let Some((code, line)) = lines.next() {
        if code.is_empty() && groups.last().is_some_and(|(_, value, _)| *value == "EOF") {
            break;
        }
        let Ok(code) = code.parse() else {
            let reason = format!(
                "got \"{}\", must be the group code of a DXF file",
                shown(code)
            );
            return Err(vec![ImportFault::Unreadable { line, reason }]);
        };
        let value = lines.next().map_or("", |(value, _)| value);
        groups.push((code, value, line));
    }
    if groups.is_empty() {
        return Err(vec![ImportFault::Empty("DXF group")]);
    }
    Ok(groups)
}

/// $INSUNITS; a drawing without unit says 0 there.
fn drawn_unit(header: &[Group], faults: &mut Vec<ImportFault>) -> Option<LengthUnit> {
    let at = header
        .iter()
        .position(|(code, value, _)| *code == 9 && *value == "$INSUNITS")?;
    let (_, value, line) = header.get(at + 1)?;
    match value.parse::<i32>() {
        Ok(0) => None,
        Ok(1) => Some(LengthUnit::Inch),
        Ok(2) => Some(LengthUnit::Foot),
        Ok(4) => Some(LengthUnit::Millimetre),
        Ok(5) => Some(LengthUnit::Centimetre),
        Ok(6) => Some(LengthUnit::Metre),
        _ => {
            faults.push(ImportFault::UnknownUnit {
                place: format!("line {line}: $INSUNITS"),
                unit: shown(value),
            });
            None
        }
    }
}

fn pieces(section: &[Group], faults: &mut Vec<ImportFault>) -> Vec<Piece> {
    let starts: Vec<usize> = section
        .iter()
        .enumerate()
        .filter(|(_, (code, ..))| *code == 0)
        .map(|(i, _)| i)
        .collect();
    let ends = starts.iter().skip(1).copied().chain([section.len()]);
    let entities: Vec<Entity> = starts
        .iter()
        .zip(ends)
        .filter_map(|(&from, to)| {
            let groups = section.get(from..to)?;
            let &(_, kind, line) = groups.first()?;
            Some(Entity { kind, line, groups })
        })
        .collect();
    let outline = |entity: &Entity| {
        entity
            .text(8)
            .is_some_and(|layer| layer.eq_ignore_ascii_case("outline"))
    };
    let one_layer = entities.iter().any(outline);
    let mut list = Vec::new();
    for (i, entity) in entities.iter().enumerate() {
        if faults.len() >= MOST_FAULTS {
            break;
        }
        if one_layer && !outline(entity) {
            continue;
        }
        match entity.kind {
            "LINE" => list.extend(entity.straight(faults)),
            "ARC" => list.extend(entity.arc(faults)),
            "LWPOLYLINE" => list.extend(entity.polyline(&entity.vertices(faults))),
            "POLYLINE" => {
                let vertices: Vec<[f64; 3]> = entities
                    .iter()
                    .skip(i + 1)
                    .take_while(|other| other.kind == "VERTEX")
                    .flat_map(|vertex| vertex.vertices(faults))
                    .collect();
                list.extend(entity.polyline(&vertices));
            }
            kind if PASSED_OVER.contains(&kind) => {}
            kind => faults.push(ImportFault::Entity {
                line: entity.line,
                kind: shown(kind),
            }),
        }
    }
    if list.is_empty() && faults.is_empty() {
        faults.push(ImportFault::Empty("LINE, ARC or polyline"));
    }
    list
}

impl Entity<'_> {
    fn text(&self, code: i32) -> Option<&str> {
        let group = self.groups.iter().find(|(found, ..)| *found == code);
        group.map(|(_, value, _)| *value)
    }

    fn number(&self, code: i32, faults: &mut Vec<ImportFault>) -> Option<f64> {
        let found = self.groups.iter().find(|(found, ..)| *found == code);
        let Some((_, value, line)) = found else {
            faults.push(ImportFault::Unreadable {
                line: self.line,
                reason: format!("{} has no group {code}", self.kind),
            });
            return None;
        };
        read_number(value, *line, faults)
    }

    /// Sign of the object's x axis against the drawing's: the object may be seen from behind.
    fn x_sign(&self) -> f64 {
        let z = self.text(230).and_then(|value| value.parse::<f64>().ok());
        if z.is_some_and(|z| z < 0.0) {
            -1.0
        } else {
            1.0
        }
    }

    fn straight(&self, faults: &mut Vec<ImportFault>) -> Option<Piece> {
        let [x0, r0, x1, r1] = [10, 20, 11, 21].map(|code| self.number(code, faults));
        Some(Piece {
            start: Point { x_m: x0?, r_m: r0? },
            end: Point { x_m: x1?, r_m: r1? },
            bulge: 0.0,
            line: self.line,
        })
    }

    fn arc(&self, faults: &mut Vec<ImportFault>) -> Option<Piece> {
        let [x, r, radius, from, to] = [10, 20, 40, 50, 51].map(|code| self.number(code, faults));
        let (x, r, radius, from, to) = (x?, r?, radius?, from?, to?);
        // counter-clockwise from the start angle to the end angle
        let turn = (to - from).rem_euclid(360.0);
        let sweep_deg = if turn == 0.0 { 360.0 } else { turn };
        let sign = self.x_sign();
        let at = |deg: f64| {
            let (s, c) = sin_cos(deg * RADIANS_PER_DEGREE);
            Point {
                x_m: sign * (x + radius * c),
                r_m: r + radius * s,
            }
        };
        if sweep_deg >= 360.0 {
            faults.push(ImportFault::Entity {
                line: self.line,
                kind: "ARC of a full turn".to_owned(),
            });
            return None;
        }
        Some(Piece {
            start: at(from),
            end: at(from + sweep_deg),
            bulge: sign * tan(sweep_deg * RADIANS_PER_DEGREE / 4.0),
            line: self.line,
        })
    }

    /// Vertices as x, y, bulge.
    fn vertices(&self, faults: &mut Vec<ImportFault>) -> Vec<[f64; 3]> {
        let mut vertices: Vec<[f64; 3]> = Vec::new();
        for (code, value, line) in self.groups {
            let place = match code {
                10 => {
                    vertices.push([0.0; 3]);
                    0
                }
                20 => 1,
                42 => 2,
                _ => continue,
            };
            let Some(number) = read_number(value, *line, faults) else {
                continue;
            };
            if let Some(slot) = vertices.last_mut().and_then(|vertex| vertex.get_mut(place)) {
                *slot = number;
            }
        }
        vertices
    }

    fn polyline(&self, vertices: &[[f64; 3]]) -> Vec<Piece> {
        let sign = self.x_sign();
        let point = |v: &[f64; 3]| Point {
            x_m: sign * v[0],
            r_m: v[1],
        };
        let flags = self.text(70).and_then(|value| value.parse::<i32>().ok());
        let closed = flags.is_some_and(|flags| flags & 1 == 1);
        let next = vertices
            .iter()
            .skip(1)
            .chain(vertices.iter().take(usize::from(closed)));
        vertices
            .iter()
            .zip(next)
            .map(|(from, to)| Piece {
                start: point(from),
                end: point(to),
                bulge: sign * from[2],
                line: self.line,
            })
            .collect()
    }
}

fn read_number(value: &str, line: u64, faults: &mut Vec<ImportFault>) -> Option<f64> {
    let number = value
        .parse::<f64>()
        .ok()
        .filter(|number| number.is_finite());
    if number.is_none() {
        faults.push(ImportFault::Unreadable {
            line: line + 1,
            reason: format!("got \"{}\", must be a number", shown(value)),
        });
    }
    number
}

#[cfg(test)]
mod tests {
    use super::*;
    use msape::vehicle::body::from_rows;
    use numerics::math::PI;

    fn drawing(units: &str, entities: &str) -> String {
        format!(
            "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n{units}\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n{entities}0\nENDSEC\n0\nEOF\n"
        )
    }

    const CONE: &str = "0\nLINE\n8\n0\n10\n1000\n20\n1000\n11\n0\n21\n0\n0\nLINE\n8\n0\n10\n1000.0\n20\n0.0\n11\n1000.0\n21\n1000.0\n0\nTEXT\n1\ncone\n";

    fn volume(text: &str) -> f64 {
        let rows = read(text, None).unwrap();
        from_rows("x", &rows).unwrap().outline.solid().volume_m3
    }

    #[test]
    fn two_loose_lines_in_millimetres_are_a_cone() {
        assert!((volume(&drawing("4", CONE)) - PI / 3.0).abs() < 1e-12);
    }

    #[test]
    fn a_half_circle_and_its_diameter_are_a_ball() {
        let arc = "0\nARC\n8\n0\n10\n5\n20\n0\n40\n2\n50\n0\n51\n180\n0\nLINE\n10\n3\n20\n0\n11\n7\n21\n0\n";
        assert!((volume(&drawing("6", arc)) - 4.0 / 3.0 * PI * 8.0).abs() < 1e-12);
        // the same seen from behind: the centre is at x = −5
        let behind = arc
            .replace("40\n2\n", "40\n2\n230\n-1\n")
            .replace("10\n3\n", "10\n-3\n");
        let rows = read(&drawing("6", &behind), None).unwrap();
        assert!((rows[0][0] + 7.0).abs() < 1e-12 && (rows[0][2] + 1.0).abs() < 1e-12);
    }

    #[test]
    fn polylines_with_bulges_old_and_new() {
        // quarter circle of radius 1 from the axis, then down: half a ball
        let b = tan(PI / 8.0);
        let new = format!(
            "0\nLWPOLYLINE\n90\n3\n70\n1\n10\n0\n20\n0\n42\n-{b}\n10\n1\n20\n1\n10\n1\n20\n0\n"
        );
        let old = format!(
            "0\nPOLYLINE\n66\n1\n70\n0\n0\nVERTEX\n10\n0\n20\n0\n42\n-{b}\n0\nVERTEX\n10\n1\n20\n1\n0\nVERTEX\n10\n1\n20\n0\n0\nSEQEND\n"
        );
        for text in [new, old] {
            assert!((volume(&drawing("6", &text)) - 2.0 * PI / 3.0).abs() < 1e-12);
        }
    }

    #[test]
    fn only_the_layer_outline_counts_where_there_is_one() {
        let named = CONE.replace("8\n0\n", "8\nOutline\n");
        let other = "0\nLINE\n8\nfoam\n10\n1\n20\n1\n11\n2\n21\n2\n0\nSPLINE\n8\nfoam\n";
        assert!((volume(&drawing("4", &format!("{named}{other}"))) - PI / 3.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_not_read_is_said_with_its_line() {
        let said = |text: &str, unit| {
            let faults = read(text, unit).unwrap_err();
            faults
                .iter()
                .map(ToString::to_string)
                .collect::<Vec<_>>()
                .join("; ")
        };
        let spline = drawing("4", &format!("{CONE}0\nSPLINE\n8\n0\n"));
        assert!(said(&spline, None).contains("SPLINE is not read"));
        assert!(said(&drawing("0", CONE), None).contains("no $INSUNITS"));
        assert!(read(&drawing("0", CONE), Some(LengthUnit::Metre)).is_ok());
        assert!(said(&drawing("13", CONE), None).contains("unit \"13\""));
        assert!(
            said("x,r\n1,2\n", None).starts_with("line 1: got \"x,r\", must be the group code")
        );
        assert!(
            said(
                &drawing("4", &CONE.replace("10\n1000\n", "10\nwide\n")),
                None
            )
            .contains("got \"wide\"")
        );
        assert!(said(&drawing("4", ""), None).contains("holds no LINE"));
        assert!(said("", None).contains("holds no DXF"));
    }
}
