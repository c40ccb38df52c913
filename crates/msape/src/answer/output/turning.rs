//! Outputs of the entries from a set of attitudes and rates.

use super::Output;
use crate::answer::Answer;
use crate::flight::six_dof::turning::Turning;
use crate::quantity::Module;

const SECTION: &str = "NASA/TM-2014-218507, section 3.3.2";

fn turning(answer: &Answer) -> Option<&Turning> {
    answer.design.as_ref()?.turning.as_ref()
}

pub(super) static OUTPUTS: &[Output] = &[
    Output::new("nose_first_share", "Share of Entries Nose First at Max Heat Rate", Module::Flight, |a| {
        turning(a)?.nose_first_share()
    })
    .help("Share of the entries from 175, 145 and 120 deg with -2, 0 and 2 deg/s of pitch in which the nose is forward at the largest heat rate; flown where it is asked for.", SECTION),
    Output::new("reorientation_entries", "Entries Flown for it", Module::Flight, |a| {
        Some(turning(a)?.entries.len() as f64)
    })
    .help("Number of those entries that were flown.", SECTION),
];
