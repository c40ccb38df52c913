//! IGES 5.3: the surfaces of each part as surfaces of revolution (entity 120), in millimeters, for systems that do not
//! read STEP.
//!
//! A surface revolves a line (110) or an arc (100) of the half-section about the x axis by a full turn. The surfaces of
//! a part form a group (402, form 7) with its name (406, form 15) and color (314), on its own level.
//!
//! # References
//! - \[iges-5.3\].

mod record;

use crate::export::Info;
use crate::export::chain::{NOTHING_M, chains};
use crate::export::model::{Model, Part};
use msape::vehicle::segment::{Point, Segment};
use numerics::math::PI;
use record::{Entity, File, real, text};

/// Lengths in the file are in millimeters.
const MM_PER_M: f64 = 1000.0;

/// Status "physically dependent": drawn only as part of the entity that refers to it.
const DEPENDENT: &str = "00010000";
const INDEPENDENT: &str = "00000000";
/// Status "definition": no geometry.
const DEFINITION: &str = "00000200";

/// The model as the text of an IGES file.
pub fn iges(model: &Model, info: &Info) -> String {
    let mut file = File::default();
    let [nose, aft, widest] = model.extent_m();
    let far_mm = widest.max(aft).max(-nose) * MM_PER_M;
    let axis = file.add(Entity {
        kind: 110,
        status: DEPENDENT,
        parameters: coordinates(&[[0.0, 0.0, 0.0], [far_mm, 0.0, 0.0]]),
        ..Entity::default()
    });
    for (part, level) in model.parts.iter().zip(1..) {
        add(&mut file, part, level, axis);
    }
    let day: String = info
        .time_stamp
        .chars()
        .filter(char::is_ascii_digit)
        .collect();
    let (date, time) = day.split_at_checked(8).unwrap_or(("20000101", "120000"));
    let stamp = text(&format!("{date}.{time}"));
    let (name, program) = (text(&model.name), text(info.program));
    let global = [
        text(","),
        text(";"),
        name.clone(),
        name.clone(),
        program.clone(),
        program,
        "32".to_owned(),
        "38".to_owned(),
        "6".to_owned(),
        "308".to_owned(),
        "15".to_owned(),
        name,
        "1.".to_owned(),
        // units: millimeters
        "2".to_owned(),
        text("MM"),
        "1".to_owned(),
        "0.1".to_owned(),
        stamp.clone(),
        real(NOTHING_M * MM_PER_M),
        real(far_mm),
        text(""),
        text(""),
        // version 5.3, no drafting standard
        "11".to_owned(),
        "0".to_owned(),
        stamp,
    ];
    file.into_text(
        &format!("{}: surfaces of revolution, mm", model.name),
        &global,
    )
}

/// Adds a part as one group of its surfaces.
fn add(file: &mut File, part: &Part, level: usize, axis: usize) {
    let percent = part.color.map(|c| real(f64::from(c) / 2.55));
    let [red, green, blue] = percent;
    let color = file.add(Entity {
        kind: 314,
        status: DEFINITION,
        parameters: vec![red, green, blue, text(&part.name)],
        ..Entity::default()
    });
    let name = file.add(Entity {
        kind: 406,
        form: 15,
        status: DEPENDENT,
        parameters: vec!["1".to_owned(), text(&part.name)],
        ..Entity::default()
    });
    // no associativities, one property: the name
    let named = || ["0".to_owned(), "1".to_owned(), name.to_string()];
    let mut surfaces = Vec::new();
    let chains = part.profiles.iter().flat_map(chains);
    for segment in chains.flat_map(|chain| chain.segments) {
        let (kind, parameters) = generatrix(&segment);
        let curve = file.add(Entity {
            kind,
            level,
            status: DEPENDENT,
            parameters,
            ..Entity::default()
        });
        let mut parameters = vec![
            axis.to_string(),
            curve.to_string(),
            real(0.0),
            real(2.0 * PI),
        ];
        parameters.extend(named());
        surfaces.push(file.add(Entity {
            kind: 120,
            level,
            color,
            status: INDEPENDENT,
            label: &part.key,
            parameters,
            ..Entity::default()
        }));
    }
    let mut parameters = vec![surfaces.len().to_string()];
    parameters.extend(surfaces.iter().map(usize::to_string));
    parameters.extend(named());
    file.add(Entity {
        kind: 402,
        form: 7,
        level,
        status: INDEPENDENT,
        label: &part.key,
        parameters,
        ..Entity::default()
    });
}

/// Entity type and parameters of a segment's curve in the plane z = 0. Arcs run counter-clockwise.
fn generatrix(segment: &Segment) -> (usize, Vec<String>) {
    let mm = |p: Point| [p.x_m * MM_PER_M, p.r_m * MM_PER_M];
    match *segment {
        Segment::Line { start, end } => {
            let ends = [start, end].map(mm).map(|[x, r]| [x, r, 0.0]);
            (110, coordinates(&ends))
        }
        Segment::Arc {
            start,
            end,
            center,
            sweep_rad,
            ..
        } => {
            let (from, to) = if sweep_rad > 0.0 {
                (start, end)
            } else {
                (end, start)
            };
            // the plane z = 0 comes first
            let plane = std::iter::once(real(0.0));
            let points = [center, from, to].map(mm);
            (
                100,
                plane
                    .chain(points.into_iter().flatten().map(real))
                    .collect(),
            )
        }
    }
}

fn coordinates(points: &[[f64; 3]]) -> Vec<String> {
    points.iter().flatten().map(|&v| real(v)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::model::Measures;
    use msape::vehicle::profile::Profile;

    fn ball() -> String {
        let half = Segment::arc(Point::on_axis(1.0), 0.5, PI, -PI);
        let profile = Profile {
            segments: vec![half],
        }
        .closed();
        iges(
            &Model::of_outline("Ball 60°", &profile, Measures::default()),
            &Info::default(),
        )
    }

    #[test]
    fn every_line_has_80_columns_and_its_number() {
        let text = ball();
        let mut counts = [0; 5];
        for line in text.lines() {
            assert_eq!(line.len(), 80, "{line}");
            let section = "SGDPT".find(&line[72..73]).unwrap();
            counts[section] += 1;
            assert_eq!(line[73..].trim().parse::<usize>().unwrap(), counts[section]);
        }
        assert_eq!(
            text.lines().last().unwrap()[..32],
            format!(
                "S{:7}G{:7}D{:7}P{:7}",
                counts[0], counts[1], counts[2], counts[3]
            )
        );
        assert!(text.contains("Ball 60?"));
    }

    #[test]
    fn a_ball_is_one_arc_turned_about_the_axis() {
        let text = ball();
        // center 1000, from (1500, 0) counter-clockwise to (500, 0)
        assert!(text.contains("100,0.,1000.,0.,1500.,0.,500.,0.;"), "{text}");
        assert_eq!(text.matches("     120").count(), 2);
    }
}
