//! A trajectory as KML 2.2: a track with times and a placemark for each event.
//!
//! Altitudes are geodetic; a viewer takes `absolute` for heights above mean sea level, which on Earth differ by at most
//! about 110 m (the undulation of the geoid). A body other than the Earth is named, with the hint \[kml-reference\] if one exists.

mod instant;

pub use instant::Instant;

use crate::answer::{Answer, PlanetNames};
use crate::flight::{Flight, Trajectory};
use crate::units::number::{rounded, shortest};
use std::fmt;

/// A place on the track.
#[derive(Clone, Copy)]
struct Place {
    longitude_deg: f64,
    latitude_deg: f64,
    altitude_m: f64,
}

/// The trajectory of an answer from its start at `epoch`; `None` when the answer has no trajectory.
pub fn kml(answer: &Answer, epoch: Instant) -> Option<String> {
    let mut text = String::new();
    // Writing into a String cannot fail.
    write(answer, epoch, &mut text).map(|_| text)
}

/// Writes that text piece by piece.
///
/// # Errors
/// The error of the writer.
pub fn write(answer: &Answer, epoch: Instant, text: &mut dyn fmt::Write) -> Option<fmt::Result> {
    let flight = answer.flight.as_ref()?;
    let track = Track::of(flight.trajectory.as_ref()?)?;
    Some(write_track(answer, flight, &track, (epoch, text)))
}

fn write_track(
    answer: &Answer,
    flight: &Flight,
    track: &Track,
    (epoch, text): (Instant, &mut dyn fmt::Write),
) -> fmt::Result {
    let Body { hint, remark } = Body::of(&answer.planet);
    let name = escaped(&answer.name);
    write!(
        text,
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <kml xmlns=\"http://www.opengis.net/kml/2.2\" xmlns:gx=\"http://www.google.com/kml/ext/2.2\"{hint}>\n<Document>\n\
         <name>{name}</name>\n\
         <description>Starts at {}. Altitudes are geodetic, above the reference ellipsoid.{remark}</description>\n\
         <Style id=\"track\"><LineStyle><color>ff1478ff</color><width>3</width></LineStyle></Style>\n\
         <Placemark>\n<name>{name}</name>\n<styleUrl>#track</styleUrl>\n\
         <gx:Track>\n<altitudeMode>absolute</altitudeMode>\n",
        epoch.after(0.0)
    )?;
    for time_s in track.time_s {
        writeln!(text, "<when>{}</when>", epoch.after(*time_s))?;
    }
    for time_s in track.time_s {
        let place = track.at(*time_s);
        writeln!(
            text,
            "<gx:coord>{} {} {}</gx:coord>",
            shortest(place.longitude_deg),
            shortest(place.latitude_deg),
            shortest(place.altitude_m)
        )?;
    }
    text.write_str("</gx:Track>\n</Placemark>\n")?;
    for event in events(flight) {
        event.write(text, track, epoch)?;
    }
    text.write_str("</Document>\n</kml>\n")
}

/// Way in which a file names the body of the track; viewers assume the Earth where none is named.
struct Body {
    hint: String,
    remark: String,
}

impl Body {
    fn of(planet: &PlanetNames) -> Body {
        let title = escaped(&planet.title);
        match planet.kml_target.as_deref() {
            Some(EARTH) => Body {
                hint: String::new(),
                remark: String::new(),
            },
            Some(target) => Body {
                hint: format!(" hint=\"target={}\"", escaped(target)),
                remark: format!(" The body is {title}."),
            },
            None => Body {
                hint: String::new(),
                remark: format!(
                    " The body is {title}: a viewer that knows only others draws the track over one of them."
                ),
            },
        }
    }
}

/// Body that viewers assume where none is named.
const EARTH: &str = "earth";

struct Event<'a> {
    name: &'a str,
    time_s: f64,
    what: String,
}

fn event_at(name: &str, time_s: f64, what: String) -> Event<'_> {
    Event { name, time_s, what }
}

fn events(flight: &Flight) -> Vec<Event<'_>> {
    let heating = &flight.peak_total_heat_flux_w_m2;
    let load = &flight.peak_deceleration_earth_g;
    let event = event_at;
    let heat_flux_w_cm2 = heating.value / 1e4;
    let phases = flight.phases.iter().map(|phase| {
        let what = format!("Mach {}", rounded(phase.mach, 4));
        event(&phase.name, phase.time_s, what)
    });
    let mut events = vec![
        event(
            "Entry",
            0.0,
            format!("{} m/s", rounded(flight.entry_relative.speed_m_s, 6)),
        ),
        event(
            "Peak heating",
            heating.time_s,
            format!("{} W/cm^2 without margins", rounded(heat_flux_w_cm2, 6)),
        ),
        event(
            "Peak deceleration",
            load.time_s,
            format!("{} Earth g", rounded(load.value, 6)),
        ),
        event(
            "End",
            flight.time_of_flight_s,
            format!("{} m/s", rounded(flight.final_speed_m_s, 6)),
        ),
    ];
    events.extend(phases);
    events
}

impl Event<'_> {
    fn write(&self, text: &mut dyn fmt::Write, track: &Track, epoch: Instant) -> fmt::Result {
        let place = track.at(self.time_s);
        write!(
            text,
            "<Placemark>\n<name>{}</name>\n<description>{}, {} s after the start, geodetic altitude {} m</description>\n\
             <TimeStamp><when>{}</when></TimeStamp>\n\
             <Point><altitudeMode>absolute</altitudeMode><coordinates>{},{},{}</coordinates></Point>\n</Placemark>\n",
            escaped(self.name),
            escaped(&self.what),
            rounded(self.time_s, 6),
            rounded(place.altitude_m, 6),
            epoch.after(self.time_s),
            shortest(place.longitude_deg),
            shortest(place.latitude_deg),
            shortest(place.altitude_m)
        )
    }
}

/// Columns of a trajectory that give the position.
struct Track<'a> {
    time_s: &'a [f64],
    longitude_deg: &'a [f64],
    latitude_deg: &'a [f64],
    altitude_m: &'a [f64],
}

impl<'a> Track<'a> {
    fn of(trajectory: &'a Trajectory) -> Option<Track<'a>> {
        let track = Track {
            time_s: trajectory.column("time_s")?,
            longitude_deg: trajectory.column("longitude_deg")?,
            latitude_deg: trajectory.column("latitude_deg")?,
            altitude_m: trajectory.column("altitude_m")?,
        };
        (!track.time_s.is_empty()).then_some(track)
    }

    /// The place at a time, linear between the rows, held beyond them.
    fn at(&self, time_s: f64) -> Place {
        let later = self.time_s.partition_point(|t| *t < time_s);
        let last = self.time_s.len().saturating_sub(1);
        let (a, b) = (later.saturating_sub(1).min(last), later.min(last));
        let value = |column: &[f64], i: usize| column.get(i).copied().unwrap_or_default();
        let (t_a, t_b) = (value(self.time_s, a), value(self.time_s, b));
        let part = if t_b > t_a {
            ((time_s - t_a) / (t_b - t_a)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        let between = |from: f64, to: f64| {
            if part == 1.0 {
                to
            } else {
                from + part * (to - from)
            }
        };
        let (east_a, mut east_b) = (value(self.longitude_deg, a), value(self.longitude_deg, b));
        // the shorter way, across the date line
        if (east_b - east_a).abs() > 180.0 {
            east_b += if east_b < east_a { 360.0 } else { -360.0 };
        }
        let mut longitude_deg = between(east_a, east_b);
        if longitude_deg > 180.0 {
            longitude_deg -= 360.0;
        } else if longitude_deg < -180.0 {
            longitude_deg += 360.0;
        }
        Place {
            longitude_deg,
            latitude_deg: between(value(self.latitude_deg, a), value(self.latitude_deg, b)),
            altitude_m: between(value(self.altitude_m, a), value(self.altitude_m, b)),
        }
    }
}

fn escaped(text: &str) -> String {
    text.chars()
        .filter(|c| !c.is_control() && !matches!(c, '\u{fffe}' | '\u{ffff}'))
        .map(|c| match c {
            '&' => "&amp;".to_string(),
            '<' => "&lt;".to_string(),
            '>' => "&gt;".to_string(),
            other => other.to_string(),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::answer::sample;

    #[test]
    fn a_track_has_times_places_and_events() {
        let mut answer = sample::flight();
        answer.name = "a < b & c".to_string();
        let epoch = Instant::parse("2006-01-15T09:56:59.5Z").unwrap();
        let text = kml(&answer, epoch).unwrap();
        assert!(text.contains("<name>a &lt; b &amp; c</name>"));
        assert_eq!(text.matches("<gx:coord>").count(), 3);
        assert!(text.contains(
            "<when>2006-01-15T09:56:59.500Z</when>\n<when>2006-01-15T09:57:01.500Z</when>"
        ));
        assert!(text.contains("<gx:coord>179 33 125000</gx:coord>"));
        // Halfway from 179 to -179 deg is 180 deg, halfway from 125 to 60 km is 92.5 km.
        assert!(text.contains("<coordinates>180,32.75,92500</coordinates>"));
        for name in ["Entry", "Peak heating", "Peak deceleration", "End"] {
            assert_eq!(
                text.matches(&format!("<name>{name}</name>")).count(),
                1,
                "{name}"
            );
        }
        assert!(text.contains("<coordinates>-178,32,0</coordinates>"));
    }

    #[test]
    fn without_a_trajectory_there_is_nothing_to_draw() {
        let epoch = Instant::parse("2000-01-01T12:00:00Z").unwrap();
        assert_eq!(kml(&sample::not_closed(), epoch), None);
    }
}
