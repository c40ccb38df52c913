//! Decides when to give up a worker, from times only, so that it can be tested without a worker.

/// A worker must confirm a question within this time, ms. Assumed: many times what a busy machine needs.
const BEGINS_MS: f64 = 5_000.0;
/// Longest load time, ms. Assumed: 1 MB at 300 kbit/s.
const LOADS_MS: f64 = 30_000.0;
/// Longest time without an answer to a question, ms. Assumed: several times the longest run that the core's limits of
/// work allow.
const ANSWERS_MS: f64 = 120_000.0;
/// Time that a run has to end after a newer edit, ms.
const YIELDS_MS: f64 = 1_000.0;
/// Time after which the user is told that the work takes long, ms.
const LONG_MS: f64 = 2_000.0;
/// Interval between two checks above which the page was suspended, ms.
const SLEPT_MS: f64 = 3_000.0;
/// Delay before the second consecutive start, ms; it doubles with each further one.
const RESTART_MS: f64 = 1_000.0;
/// Number of consecutive failed starts before the next is left to the user. Assumed: half a minute in total with the
/// delays.
const STARTS_MAX: u32 = 6;

/// State of a worker, with the time at which it began, ms.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Phase {
    /// Loading.
    Starting(f64),
    /// Waiting for a question.
    Idle,
    /// A question was sent and is not confirmed yet.
    Sent(f64),
    /// Working on a question.
    Busy(f64),
    /// No worker before this time, ms.
    Down(f64),
    /// No worker until one is requested.
    Stopped,
}

/// Action to take.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// None.
    Wait,
    /// Report that the work takes long: duration so far, ms.
    Long(f64),
    /// No worker yet: remaining time, ms.
    Down(f64),
    /// Start a worker.
    Start,
    /// Give up the worker: it does not load.
    NotLoaded,
    /// Give up the worker: it is gone; repeat its question.
    Gone,
    /// Give up the worker: it does not answer.
    Silent,
    /// Give up the worker: a newer edit waits.
    Outdated,
}

/// State of the watchdog.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Watch {
    /// State of the worker.
    pub phase: Phase,
    /// Time since which an edit waits, ms.
    pub edit_waits: Option<f64>,
    /// Number of consecutive failed starts.
    pub failures: u32,
    looked: f64,
}

impl Watch {
    /// No worker yet; one may be started at once.
    pub fn new(now_ms: f64) -> Watch {
        Watch {
            phase: Phase::Down(now_ms),
            edit_waits: None,
            failures: 0,
            looked: now_ms,
        }
    }

    /// Checks the worker; `needed` if something waits for it. Time in which the page was suspended does not count.
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
        // shifting the start times excludes the suspended time
        if let Phase::Starting(since) | Phase::Sent(since) | Phase::Busy(since) = &mut self.phase {
            *since += gap;
        }
        if let Some(waits) = &mut self.edit_waits {
            *waits += gap;
        }
    }

    /// Notes a failure. Returns the delay before the next start, ms: zero the first time, then increasing; `None` after
    /// too many failures.
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

    /// Whether a worker may be started on request now.
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

    /// First verdict that requires an action, checking four times a second.
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
