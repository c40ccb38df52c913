//! Checks the attitude of the start.

use super::forms::one_row;
use crate::case::Reader;
use crate::flight::six_dof::attitude::Given;
use crate::flight::six_dof::quaternion;
use numerics::math::RADIANS_PER_DEGREE;

const AGAINST_HORIZON: [&str; 3] = [
    "attitude.yaw_deg",
    "attitude.pitch_deg",
    "attitude.roll_deg",
];
const AGAINST_VELOCITY: [&str; 3] = [
    "attitude.alpha_deg",
    "attitude.beta_deg",
    "attitude.bank_deg",
];
const QUATERNION: &str = "attitude.quaternion";

/// Attitude as the case gives it; along the velocity where it says nothing.
pub(super) fn given(reader: &mut Reader) -> Option<Given> {
    let angles = |reader: &mut Reader, keys: [&str; 3]| -> Option<[f64; 3]> {
        let mut all = Some([0.0; 3]);
        for (i, key) in keys.iter().enumerate() {
            let angle = if reader.given(key) {
                reader.number(key)
            } else {
                Some(0.0)
            };
            match (&mut all, angle) {
                (Some(all), Some(angle)) => all[i] = angle * RADIANS_PER_DEGREE,
                _ => all = None,
            }
        }
        all
    };
    let against_horizon = angles(reader, AGAINST_HORIZON);
    let against_velocity = angles(reader, AGAINST_VELOCITY);
    let quaternion = one_row::<4>(reader, QUATERNION);
    let first = |keys: &[&'static str]| keys.iter().copied().find(|key| reader.given(key));
    let ways: Vec<&str> = [
        first(&AGAINST_HORIZON),
        first(&AGAINST_VELOCITY),
        first(&[QUATERNION]),
    ]
    .into_iter()
    .flatten()
    .collect();
    if let [first, second, ..] = ways.as_slice() {
        let message = format!(
            "given together with {first}; give yaw, pitch and roll, or alpha, beta and bank, or the quaternion"
        );
        reader.fault(second, message);
        return None;
    }
    match ways.first() {
        Some(key) if AGAINST_HORIZON.contains(key) => against_horizon.map(Given::YawPitchRoll),
        Some(key) if *key == QUATERNION => {
            let parts = quaternion??;
            let quaternion = quaternion::of_parts(parts);
            let squared = quaternion.norm_squared();
            if !(squared > 0.0 && squared.is_finite()) {
                let message = format!(
                    "got {parts:?}, whose length is {}; must have a length above 0",
                    squared.sqrt()
                );
                reader.fault(QUATERNION, message);
                return None;
            }
            Some(Given::Quaternion(quaternion::unit(quaternion)))
        }
        _ => against_velocity.map(Given::AlphaBetaBank),
    }
}
