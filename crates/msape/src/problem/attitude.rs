//! Checks the attitude of the start.

use super::forms::one_row;
use crate::case::Reader;
use crate::flight::six_dof::attitude::Given;
use crate::flight::six_dof::quaternion;
use crate::quantity::input::{Input, attitude as ways};
use numerics::math::RADIANS_PER_DEGREE;

/// Attitude that the case gives; along the velocity if it gives none.
pub(super) fn given(reader: &mut Reader) -> Option<Given> {
    let angles = |reader: &mut Reader, inputs: [&'static Input; 3]| -> Option<[f64; 3]> {
        let [first, second, third] = inputs.map(|input| match reader.given(input) {
            true => reader.number(input),
            false => Some(0.0),
        });
        Some([first?, second?, third?].map(|angle| angle * RADIANS_PER_DEGREE))
    };
    let horizon = [&ways::YAW_DEG, &ways::PITCH_DEG, &ways::ROLL_DEG];
    let against_horizon = angles(reader, horizon);
    let velocity = [&ways::ALPHA_DEG, &ways::BETA_DEG, &ways::BANK_DEG];
    let against_velocity = angles(reader, velocity);
    let quaternion = one_row::<4>(reader, &ways::QUATERNION);
    let ways = reader.ways(&ways::ATTITUDE);
    if let [first, second, ..] = ways.as_slice() {
        let message = format!(
            "given together with {first}; give yaw, pitch and roll, or alpha, beta and bank, or the quaternion"
        );
        reader.fault(second, message);
        return None;
    }
    match ways.first() {
        Some(way) if horizon.contains(way) => against_horizon.map(Given::YawPitchRoll),
        Some(way) if **way == ways::QUATERNION => {
            let parts = quaternion??;
            let quaternion = quaternion::of_parts(parts);
            let squared = quaternion.norm_squared();
            if !(squared > 0.0 && squared.is_finite()) {
                let message = format!(
                    "got {parts:?}, whose length is {}; must have a length above 0",
                    squared.sqrt()
                );
                reader.fault(way, message);
                return None;
            }
            Some(Given::Quaternion(quaternion::unit(quaternion)))
        }
        _ => against_velocity.map(Given::AlphaBetaBank),
    }
}
