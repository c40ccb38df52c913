//! A moment of the proleptic Gregorian calendar, Coordinated Universal Time without leap seconds.

/// A moment, to a millisecond.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Instant {
    /// Milliseconds after 1970-01-01T00:00:00Z.
    pub milliseconds: i64,
}

const DAY_MS: i64 = 86_400_000;

impl Instant {
    /// Reads `2006-01-15T09:57:00Z`, with or without a fraction of a second; a date alone is its midnight.
    pub fn parse(text: &str) -> Option<Instant> {
        let text = text.trim();
        let (date, time) = text.split_once(['T', ' ']).unwrap_or((text, "00:00:00Z"));
        let [year, month, day] = parts(date, '-')?;
        let [hour, minute, rest] = parts(time.strip_suffix('Z').unwrap_or(time), ':')?;
        let (year, month, day) = (whole(year, 4)?, whole(month, 2)?, whole(day, 2)?);
        let (hour, minute) = (whole(hour, 2)?, whole(minute, 2)?);
        let (second, fraction) = rest.split_once('.').unwrap_or((rest, "0"));
        let second = whole(second, 2)?;
        if fraction.is_empty()
            || fraction.len() > 9
            || !fraction.bytes().all(|b| b.is_ascii_digit())
        {
            return None;
        }
        let thousandths = format!("{fraction:0<3}").get(..3)?.parse::<i64>().ok()?;
        let instant = Instant {
            milliseconds: days(year, month, day) * DAY_MS
                + ((hour * 60 + minute) * 60 + second) * 1000
                + thousandths,
        };
        let in_range = (1..=12).contains(&month) && hour < 24 && minute < 60 && second < 60;
        (in_range && date_of(instant.milliseconds.div_euclid(DAY_MS)) == (year, month, day))
            .then_some(instant)
    }

    /// The moment some seconds later, as `2006-01-15T09:57:00.500Z`.
    pub fn after(self, seconds: f64) -> String {
        let milliseconds = self
            .milliseconds
            .saturating_add((seconds * 1000.0).round() as i64);
        let (day, ms) = (
            milliseconds.div_euclid(DAY_MS),
            milliseconds.rem_euclid(DAY_MS),
        );
        let (year, month, day) = date_of(day);
        let (hour, minute, second) = (ms / 3_600_000, ms / 60_000 % 60, ms / 1000 % 60);
        format!(
            "{year:04}-{month:02}-{day:02}T{hour:02}:{minute:02}:{second:02}.{:03}Z",
            ms % 1000
        )
    }
}

fn parts(text: &str, separator: char) -> Option<[&str; 3]> {
    let mut parts = text.split(separator);
    let three = [parts.next()?, parts.next()?, parts.next()?];
    parts.next().is_none().then_some(three)
}

fn whole(text: &str, digits: usize) -> Option<i64> {
    (text.len() == digits && text.bytes().all(|b| b.is_ascii_digit())).then(|| text.parse().ok())?
}

/// Days from 1970-01-01 to a date; years are taken to begin in March, so that the leap day is their last.
fn days(year: i64, month: i64, day: i64) -> i64 {
    let year = if month <= 2 { year - 1 } else { year };
    let era = year.div_euclid(400);
    let year_of_era = year.rem_euclid(400);
    let day_of_year = (153 * ((month + 9) % 12) + 2) / 5 + day - 1;
    era * 146_097 + year_of_era * 365 + year_of_era / 4 - year_of_era / 100 + day_of_year - 719_468
}

/// Year, month and day of a number of days after 1970-01-01.
fn date_of(days: i64) -> (i64, i64, i64) {
    let days = days + 719_468;
    let era = days.div_euclid(146_097);
    let day_of_era = days.rem_euclid(146_097);
    let year_of_era =
        (day_of_era - day_of_era / 1460 + day_of_era / 36_524 - day_of_era / 146_096) / 365;
    let day_of_year = day_of_era - (365 * year_of_era + year_of_era / 4 - year_of_era / 100);
    let march_month = (5 * day_of_year + 2) / 153;
    let day = day_of_year - (153 * march_month + 2) / 5 + 1;
    let month = if march_month < 10 {
        march_month + 3
    } else {
        march_month - 9
    };
    let year = era * 400 + year_of_era + i64::from(month <= 2);
    (year, month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_days_are_found() {
        assert_eq!(days(1970, 1, 1), 0);
        // 30 years of 365 days and 7 leap days: 1972 to 1996.
        assert_eq!(days(2000, 1, 1), 30 * 365 + 7);
        for day in (-800_000..800_000).step_by(97) {
            let (y, m, d) = date_of(day);
            assert_eq!(days(y, m, d), day);
        }
    }

    #[test]
    fn seconds_run_over_midnight_and_leap_day() {
        let start = Instant::parse("2024-02-28T23:59:59.25Z").unwrap();
        assert_eq!(start.after(0.0), "2024-02-28T23:59:59.250Z");
        assert_eq!(start.after(0.75), "2024-02-29T00:00:00.000Z");
        assert_eq!(start.after(86_400.75), "2024-03-01T00:00:00.000Z");
        assert_eq!(
            Instant::parse("2006-01-15").unwrap().after(1.0),
            "2006-01-15T00:00:01.000Z"
        );
    }

    #[test]
    fn what_is_no_date_is_refused() {
        for text in [
            "",
            "tomorrow",
            "2023-02-29",
            "2024-13-01",
            "2024-01-01T25:00:00Z",
            "2024-01-01T00:00:0xZ",
            "24-1-1",
        ] {
            assert_eq!(Instant::parse(text), None, "{text}");
        }
    }
}
