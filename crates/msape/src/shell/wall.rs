//! Results of the shell model for one wall of the vehicle.
//!
//! ```text
//! σ_allowed = σ (1 + margin)                 stress at the limit load at which the margin of safety is zero
//! u = √(u_x² + u_r²)
//! ```
//!
//! with stresses in Pa, u the displacement at entry and its parts along and away from the axis in m.
//!
//! # Valid
//! Same as [`super::analysis`]. The edge member, a stand-in, is left out.
//!
//! # References
//! - \[nasa-std-5001\] margin of safety.

use super::analysis::{CarrierAnalysis, CaseStress, Distributions, PartStress};
use super::carrier::Part;
use crate::vehicle::WallPlace;

impl Part {
    /// Wall to which the part belongs.
    pub fn wall(self) -> WallPlace {
        match self {
            Self::Nose | Self::Cone | Self::Edge => WallPlace::Forebody,
            Self::Wing | Self::Lid => WallPlace::Aftbody,
            Self::Primary => WallPlace::Primary,
        }
    }
}

impl PartStress {
    /// Least margin of laminate or faces and core.
    pub fn least_margin(&self) -> f64 {
        self.core_margin
            .map_or(self.margin, |core| core.min(self.margin))
    }

    /// Stress in laminate or faces at which the margin of safety is zero, Pa.
    pub fn allowed_stress_pa(&self) -> f64 {
        self.stress_pa * (1.0 + self.margin)
    }
}

impl CaseStress {
    /// The parts of a wall.
    pub fn of_wall(&self, wall: WallPlace) -> impl Iterator<Item = &PartStress> {
        self.parts.iter().filter(move |p| p.part.wall() == wall)
    }

    /// The part of a wall with the least margin.
    pub fn weakest(&self, wall: WallPlace) -> Option<&PartStress> {
        self.of_wall(wall)
            .min_by(|a, b| a.least_margin().total_cmp(&b.least_margin()))
    }
}

/// A place on a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Part.
    pub part: Part,
    /// Axial position, m.
    pub x_m: f64,
    /// Distance from the axis, m.
    pub r_m: f64,
    /// Equivalent stress at entry, Pa.
    pub entry_stress_pa: f64,
    /// Displacement at entry, m.
    pub entry_displacement_m: f64,
    /// Equivalent stress at launch, Pa.
    pub launch_stress_pa: f64,
    /// Displacement at launch, m.
    pub launch_displacement_m: f64,
}

impl Place {
    /// Position along the wall: the distance from the axis, or for the primary structure the axial position, m.
    pub fn along_m(&self) -> f64 {
        match self.part.wall() {
            WallPlace::Primary => self.x_m,
            WallPlace::Forebody | WallPlace::Aftbody => self.r_m,
        }
    }
}

impl Distributions {
    /// The places of a wall from the axis outwards, or from the nose aft.
    pub fn of_wall(&self, wall: WallPlace) -> Vec<Place> {
        let place = |(i, part): (usize, &Part)| {
            let [u_x, u_r] = [&self.axial_displacement_m, &self.radial_displacement_m]
                .map(|u| u.get(i).copied());
            let (u_x, u_r) = (u_x?, u_r?);
            Some(Place {
                part: *part,
                x_m: *self.x_m.get(i)?,
                r_m: *self.r_m.get(i)?,
                entry_stress_pa: *self.stress_pa.get(i)?,
                entry_displacement_m: (u_x * u_x + u_r * u_r).sqrt(),
                launch_stress_pa: *self.launch_stress_pa.get(i)?,
                launch_displacement_m: *self.launch_displacement_m.get(i)?,
            })
        };
        let all = self.part.iter().enumerate();
        let those = all.filter(|(_, part)| part.wall() == wall && **part != Part::Edge);
        let mut places: Vec<Place> = those.filter_map(place).collect();
        if let (Some(first), Some(last)) = (places.first(), places.last())
            && first.along_m() > last.along_m()
        {
            places.reverse();
        }
        places
    }
}

impl CarrierAnalysis {
    /// Largest displacement of a wall at entry and at launch, m.
    pub fn displacement_m(&self, wall: WallPlace) -> [f64; 2] {
        let places = self.distributions.of_wall(wall);
        let most = |of: fn(&Place) -> f64| places.iter().map(of).fold(0.0, f64::max);
        [
            most(|p| p.entry_displacement_m),
            most(|p| p.launch_displacement_m),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vehicle::segment::Point;

    fn stress(part: Part, margin: f64, core_margin: Option<f64>) -> PartStress {
        PartStress {
            part,
            stress_pa: 2.0e6,
            at: Point::default(),
            margin,
            shear_pa: 0.0,
            shear_at: Point::default(),
            core_margin,
        }
    }

    #[test]
    fn two_megapascals_with_a_margin_of_a_half_may_be_three() {
        assert_eq!(stress(Part::Nose, 0.5, None).allowed_stress_pa(), 3.0e6);
    }

    #[test]
    fn the_weakest_part_of_a_wall_may_be_so_by_its_core() {
        let case = CaseStress {
            parts: vec![
                stress(Part::Nose, 2.0, Some(1.0)),
                stress(Part::Cone, 1.5, None),
                stress(Part::Lid, 0.1, None),
            ],
            largest_displacement_m: 0.0,
        };
        let weakest = |wall| {
            case.weakest(wall)
                .map(|part| (part.part, part.least_margin()))
        };
        assert_eq!(weakest(WallPlace::Forebody), Some((Part::Nose, 1.0)));
        assert_eq!(weakest(WallPlace::Aftbody), Some((Part::Lid, 0.1)));
        assert_eq!(weakest(WallPlace::Primary), None);
    }

    #[test]
    fn a_wall_runs_from_the_axis_outwards_without_the_edge_member() {
        let distributions = Distributions {
            part: vec![Part::Primary, Part::Edge, Part::Wing, Part::Wing, Part::Lid],
            x_m: vec![0.1, 0.2, 0.3, 0.4, 0.5],
            r_m: vec![0.3, 0.6, 0.5, 0.4, 0.1],
            axial_displacement_m: vec![0.0, 0.0, 0.003, 0.0, 0.0],
            radial_displacement_m: vec![0.0, 0.0, 0.004, 0.0, 0.001],
            stress_pa: vec![1.0, 2.0, 3.0, 4.0, 5.0],
            shear_pa: vec![0.0; 5],
            launch_stress_pa: vec![0.0; 5],
            launch_displacement_m: vec![0.0; 5],
        };
        let aft = distributions.of_wall(WallPlace::Aftbody);
        let along: Vec<f64> = aft.iter().map(Place::along_m).collect();
        assert_eq!(along, [0.1, 0.4, 0.5]);
        // √(3² + 4²) mm
        assert!((aft[2].entry_displacement_m - 0.005).abs() < 1e-15);
        assert_eq!(distributions.of_wall(WallPlace::Primary)[0].along_m(), 0.1);
        assert!(distributions.of_wall(WallPlace::Forebody).is_empty());
    }
}
