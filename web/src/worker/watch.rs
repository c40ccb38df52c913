//! Decides when a worker is given up: times only, so that it can be tested without one.

/// A worker that got a question says so within this time, ms, or it is gone. Assumed: many times what a busy machine needs.
const BEGINS_MS: f64 = 5_000.0;
/// Longest loading, ms. Assumed: 1 MB at 300 kbit/s.
const LOADS_MS: f64 = 30_000.0;
/// Longest silence on one question, ms. Assumed: several times the longest run that the core's limits of work allow.
const ANSWERS_MS: f64 = 120_000.0;
/// Time that a newer edit gives an older run to end, ms.
const YIELDS_MS: f64 = 1_000.0;
/// After this time the user is told that it takes long, ms.
const LONG_MS: f64 = 2_000.0;
/// A gap between two looks that is longer than this is a page that slept, ms.
const SLEPT_MS: f64 = 3_000.0;
/// Wait before the second start in a row, ms; it doubles with each that follows.
const RESTART_MS: f64 = 1_000.0;
/// Starts in a row that may fail before the next is left to the user. Assumed: with the waits between them half a minute.
const STARTS_MAX: u32 = 6;

/// What a worker does, and since when, ms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phase {
    /// It loads.
    Starting(f64),
    /// It waits for a question.
    Idle,
    /// It was sent a question.
    Sent(f64),
    /// It works on a question.
    Busy(f64),
    /// There is none until then.
    Down(f64),
    /// There is none until it is asked for.
    Stopped,
}

/// What is to be done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// Nothing.
    Wait,
    /// To tell that it takes long: so many ms so far.
    Long(f64),
    /// There is no worker for so many ms to come.
    Down(f64),
    /// To start a worker.
    Start,
    /// To give the worker up since it does not load.
    NotLoaded,
    /// To give the worker up since it is gone; its question is asked again.
    Gone,
    /// To give the worker up since it does not answer.
    Silent,
    /// To give the worker up since a newer edit waits.
    Outdated,
}

/// What is known of a worker.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watch {
    /// What it does.
    pub phase: Phase,
    /// Since when an edit waits, ms.
    pub edit_waits: Option<f64>,
    /// Starts in a row that failed.
    pub failures: u32,
    looked: f64,
}

impl Watch {
    /// There is no worker yet.
    pub fn new(now_ms: f64) -> Watch {
        Watch {
            phase: Phase::Down(now_ms),
            edit_waits: None,
            failures: 0,
            looked: now_ms,
        }
    }

    /// Looks at it, `needed` where something waits for it. A page that slept heard nothing, which is no fault of its worker.
    pub fn look(&mut self, now_ms: f64, needed: bool) -> Verdict {
        let gap = now_ms - self.looked;
        self.looked = now_ms;
        if gap > SLEPT_MS {
            self.sleep(gap);
        }
        match self.phase {
            Phase::Idle | Phase::Stopped => Verdict::Wait,
            Phase::Down(_) if !needed => Verdict::Wait,
            Phase::Down(until) if now_ms >= until => Verdict::Start,
            Phase::Down(until) => Verdict::Down(until - now_ms),
            Phase::Starting(since) if now_ms - since > LOADS_MS => Verdict::NotLoaded,
            Phase::Sent(since) if now_ms - since > BEGINS_MS => Verdict::Gone,
            Phase::Busy(since) if now_ms - since > ANSWERS_MS => Verdict::Silent,
            Phase::Busy(since) if self.is_outdated(since, now_ms) => Verdict::Outdated,
            Phase::Starting(_) if !needed => Verdict::Wait,
            Phase::Starting(since) | Phase::Sent(since) | Phase::Busy(since) => {
                match now_ms - since {
                    so_far if so_far > LONG_MS => Verdict::Long(so_far),
                    _ => Verdict::Wait,
                }
            }
        }
    }

    fn is_outdated(&self, since: f64, now_ms: f64) -> bool {
        self.edit_waits
            .is_some_and(|waits| now_ms - waits.max(since) >= YIELDS_MS)
    }

    fn sleep(&mut self, gap: f64) {
        if let Phase::Starting(since) | Phase::Sent(since) | Phase::Busy(since) = &mut self.phase {
            *since += gap;
        }
        if let Some(waits) = &mut self.edit_waits {
            *waits += gap;
        }
    }

    /// The worker is gone. After how many ms the next one may come: at once the first time, then later each time; nothing when
    /// that has been tried often enough.
    pub fn fail(&mut self, now_ms: f64) -> Option<f64> {
        let wait_ms = match self.failures {
            0 => Some(0.0),
            failures if failures < STARTS_MAX => {
                Some(RESTART_MS * f64::from(1_u32 << (failures - 1)))
            }
            _ => None,
        };
        self.failures = self.failures.saturating_add(1);
        self.phase = wait_ms.map_or(Phase::Stopped, |wait_ms| Phase::Down(now_ms + wait_ms));
        wait_ms
    }

    /// Whether a worker may be started now for what is asked.
    pub fn may_start(&self, now_ms: f64) -> bool {
        match self.phase {
            Phase::Stopped => true,
            Phase::Down(until) => now_ms >= until,
            _ => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Looks four times a second until something is to be done.
    fn first(watch: &mut Watch, from_ms: f64) -> (Verdict, f64) {
        (1..)
            .map(|count| from_ms + 250.0 * f64::from(count))
            .map(|now| (watch.look(now, true), now))
            .find(|(verdict, _)| {
                !matches!(verdict, Verdict::Wait | Verdict::Long(_) | Verdict::Down(_))
            })
            .unwrap()
    }

    fn at(phase: Phase) -> Watch {
        let mut watch = Watch::new(0.0);
        watch.phase = phase;
        watch
    }

    #[test]
    fn a_long_run_is_told_and_left_alone_until_an_edit_waits() {
        let mut watch = at(Phase::Busy(0.0));
        assert_eq!(watch.look(1_500.0, true), Verdict::Wait);
        assert_eq!(watch.look(2_500.0, true), Verdict::Long(2_500.0));
        let mut now = 2_500.0;
        while now < 60_000.0 {
            now += 250.0;
            assert!(matches!(watch.look(now, true), Verdict::Long(_)));
        }
        watch.edit_waits = Some(now);
        assert_eq!(first(&mut watch, now), (Verdict::Outdated, now + 1_000.0));
    }

    #[test]
    fn an_edit_gives_a_run_that_has_just_begun_a_second() {
        let mut watch = at(Phase::Busy(5_000.0));
        (watch.edit_waits, watch.looked) = (Some(3_000.0), 5_000.0);
        assert_eq!(first(&mut watch, 5_000.0), (Verdict::Outdated, 6_000.0));
    }

    #[test]
    fn a_worker_that_is_gone_or_silent_or_does_not_load_is_given_up() {
        assert_eq!(first(&mut at(Phase::Sent(0.0)), 0.0).0, Verdict::Gone);
        let (verdict, when) = first(&mut at(Phase::Busy(0.0)), 0.0);
        assert_eq!((verdict, when), (Verdict::Silent, ANSWERS_MS + 250.0));
        assert_eq!(
            first(&mut at(Phase::Starting(0.0)), 0.0).0,
            Verdict::NotLoaded
        );
    }

    #[test]
    fn a_page_that_slept_blames_nobody() {
        let mut watch = at(Phase::Sent(0.0));
        assert_eq!(watch.look(1e7, true), Verdict::Wait);
        assert_eq!(watch.look(1e7 + 1e3, true), Verdict::Wait);
        assert_eq!(first(&mut watch, 1e7 + 1e3).0, Verdict::Gone);
    }

    #[test]
    fn starts_in_a_row_come_later_each_time_and_come_to_an_end() {
        let mut watch = Watch::new(0.0);
        let waits: Vec<Option<f64>> = (0..8).map(|_| watch.fail(0.0)).collect();
        let wanted = [0.0, 1e3, 2e3, 4e3, 8e3, 16e3].map(Some);
        assert_eq!(waits[..6], wanted);
        assert_eq!((waits[6], waits[7]), (None, None));
        assert_eq!(watch.look(1e9, true), Verdict::Wait);
        assert!(watch.may_start(1e9));
    }

    #[test]
    fn a_start_waits_for_its_time_and_for_something_to_do() {
        let mut watch = Watch::new(0.0);
        (watch.fail(0.0), watch.fail(0.0)).1.unwrap();
        assert_eq!(watch.look(250.0, true), Verdict::Down(750.0));
        assert_eq!(watch.look(1_000.0, false), Verdict::Wait);
        assert_eq!(watch.look(1_250.0, true), Verdict::Start);
        assert!(!watch.may_start(999.0) && watch.may_start(1_000.0));
    }

    #[test]
    fn loading_is_told_only_where_something_waits_for_it() {
        let mut watch = at(Phase::Starting(0.0));
        assert_eq!(watch.look(2_500.0, false), Verdict::Wait);
        assert_eq!(watch.look(2_750.0, true), Verdict::Long(2_750.0));
        let mut silent = at(Phase::Starting(0.0));
        silent.looked = LOADS_MS;
        assert_eq!(silent.look(LOADS_MS + 1.0, false), Verdict::NotLoaded);
    }

    #[test]
    fn a_run_that_was_stopped_is_started_by_nobody() {
        let mut watch = at(Phase::Stopped);
        watch.edit_waits = Some(0.0);
        assert_eq!(watch.look(250.0, true), Verdict::Wait);
    }
}
