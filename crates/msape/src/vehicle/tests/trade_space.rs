//! Two thousand vehicles over the trade space: each closes or says why, and its components fill its outline without overlap.

use super::*;
use crate::vehicle::segment::Segment;

/// Deterministic numbers in 0..1: a multiplicative congruence.
pub(super) struct Sequence(pub u64);

impl Sequence {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

pub(super) fn sampled(sequence: &mut Sequence) -> VehicleInput {
    let mut input = if sequence.next() < 0.5 {
        msr()
    } else {
        msr_carbon()
    };
    let non_msr = sequence.next() < 0.5;
    if non_msr {
        input.concept = Concept::NonMsr;
        input.impact.crush_load_limit_earth_g = sequence.between(500.0, 2500.0);
    } else {
        input.impact.crush_load_limit_earth_g = sequence.between(1500.0, 4000.0);
    }
    input.diameter_m = sequence.between(0.5, 2.0);
    input.nose_radius_ratio = sequence.between(0.25, 0.9);
    input.shoulder_radius_ratio = sequence.between(0.02, 0.1);
    input.payload_mass_kg = sequence.between(5.0, 30.0);
    input.payload_size = if sequence.next() < 0.5 {
        PayloadSize::DensityKgM3(sequence.between(500.0, 8000.0))
    } else {
        PayloadSize::DiameterRatio(sequence.between(0.2, 0.6))
    };
    input.cone_half_angle_rad = sequence.between(45.0, 70.0) * RADIANS_PER_DEGREE;
    input.forebody.tps_thickness_m = sequence.between(0.01, 0.06);
    input.loads.terminal_speed_m_s = sequence.between(15.0, 50.0);
    input
}

/// Whether a point is inside a closed profile: crossings of the ray towards +x.
fn inside(profile: &Profile, x: f64, r: f64) -> bool {
    let mut crossings = 0;
    for segment in &profile.segments {
        match *segment {
            Segment::Line { start, end } => {
                if (start.r_m > r) != (end.r_m > r) {
                    let at =
                        start.x_m + (r - start.r_m) / (end.r_m - start.r_m) * (end.x_m - start.x_m);
                    crossings += i32::from(at > x);
                }
            }
            Segment::Arc {
                center,
                radius_m,
                start_angle_rad,
                sweep_rad,
                ..
            } => {
                let height = r - center.r_m;
                if height.abs() >= radius_m {
                    continue;
                }
                let half = (radius_m * radius_m - height * height).sqrt();
                for side in [-half, half] {
                    let angle = numerics::math::atan2(height, side);
                    let run = (angle - start_angle_rad) * sweep_rad.signum();
                    let run = run - (run / (2.0 * PI)).floor() * 2.0 * PI;
                    crossings += i32::from(run <= sweep_rad.abs() && center.x_m + side > x);
                }
            }
        }
    }
    crossings % 2 == 1
}

#[test]
fn two_thousand_vehicles_close_or_say_why_and_fill_their_outline() {
    let mut sequence = Sequence(2014);
    let mut closed = 0;
    for _ in 0..2000 {
        let input = sampled(&mut sequence);
        let vehicle = match build(&input) {
            Ok(vehicle) => vehicle,
            Err(why) => {
                assert!(
                    why.at_largest.is_some() && !why.reason.is_empty(),
                    "{input:?}"
                );
                continue;
            }
        };
        closed += 1;
        let whole = vehicle.outline.solid().volume_m3;
        let parts = vehicle.mass.volume_m3;
        assert!(
            (parts / whole - 1.0).abs() < 1e-9,
            "{parts} m³ of parts in {whole} m³: {input:?}"
        );
        for c in &vehicle.components {
            assert!(
                c.volume_m3 > 0.0,
                "{:?} has {} m³: {input:?}",
                c.kind,
                c.volume_m3
            );
            for p in &c.profiles {
                for pair in p.segments.windows(2) {
                    let gap = numerics::math::hypot(
                        pair[0].end().x_m - pair[1].start().x_m,
                        pair[0].end().r_m - pair[1].start().r_m,
                    );
                    assert!(gap < 1e-12, "{:?} is open by {gap} m", c.kind);
                }
                assert!(p.segments.iter().all(|s| s.end().r_m >= 0.0));
            }
        }
        // a point inside the outline is in exactly one component, one outside in none
        for _ in 0..20 {
            let d = &vehicle.dimensions;
            let x = d.virtual_apex_ahead_m + sequence.between(-0.05, 1.05) * d.vehicle_height_m;
            let r = sequence.between(0.0, 0.52) * d.diameter_m;
            let count = vehicle
                .components
                .iter()
                .flat_map(|c| &c.profiles)
                .filter(|p| inside(p, x, r))
                .count();
            let expected = usize::from(inside(&vehicle.outline, x, r));
            assert_eq!(
                count, expected,
                "components at ({x}, {r}): {:?}",
                vehicle.layout
            );
        }
        let slope = vehicle.dimensions.wing_slope_rad / RADIANS_PER_DEGREE;
        assert!(
            (5.0 - 1e-9..=30.0 + 1e-9).contains(&slope),
            "wing of {slope} deg"
        );
    }
    // more than nine in ten find a diameter up to 2 m
    assert!(closed > 1800, "{closed} of 2000 closed");
}

#[test]
fn numbers_far_outside_the_trade_space_neither_panic_nor_give_nonsense() {
    let mut sequence = Sequence(3);
    let mut closed = 0;
    for _ in 0..1000 {
        let mut input = sampled(&mut sequence);
        // each of these is up to a hundred times too large or too small
        let mut spoil = |value: &mut f64| {
            if sequence.next() < 0.3 {
                *value *= numerics::math::exp(sequence.between(-4.6, 4.6));
            }
        };
        spoil(&mut input.diameter_m);
        spoil(&mut input.nose_radius_ratio);
        spoil(&mut input.shoulder_radius_ratio);
        spoil(&mut input.payload_mass_kg);
        spoil(&mut input.forebody.tps_thickness_m);
        spoil(&mut input.aftbody_tps_thickness_m);
        spoil(&mut input.loads.entry_load_earth_g);
        spoil(&mut input.loads.peak_stagnation_pressure_pa);
        spoil(&mut input.loads.terminal_speed_m_s);
        spoil(&mut input.impact.crush_load_limit_earth_g);
        let Ok(vehicle) = build(&input) else { continue };
        closed += 1;
        assert!(vehicle.mass.mass_kg.is_finite() && vehicle.mass.mass_kg > input.payload_mass_kg);
        let whole = vehicle.outline.solid().volume_m3;
        let ratio = vehicle.mass.volume_m3 / whole;
        assert!((ratio - 1.0).abs() < 1e-9, "{ratio}: {input:?}");
        for c in &vehicle.components {
            assert!(c.volume_m3 > 0.0, "{:?}: {input:?}", c.kind);
        }
    }
    assert!(closed > 300, "{closed} of 1000 closed");
}
