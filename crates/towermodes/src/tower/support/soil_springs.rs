//! The springs of the soil along a tower, under its tip, and along the piles of its frame.

use super::super::model::Tower;
use super::super::parts::surroundings::SoilStiffness;

/// Springs of the soil at a height of a tower.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SpringsAt {
    /// The height, m.
    pub height_m: f64,
    /// Against translation x and y, N/m².
    pub lateral_n_per_m2: f64,
    /// Against translation z, N/m².
    pub vertical_n_per_m2: f64,
    /// Against rotation of the section about x and y, N m per radian and metre.
    pub rotation_n: f64,
    /// Against rotation about the axis, N m per radian and metre.
    pub torsion_n: f64,
}

/// Springs of the soil under the tip of a pile.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct TipSprings {
    /// Height of the tip, m.
    pub height_m: f64,
    /// Against translation x and y, N/m.
    pub lateral_n_per_m: f64,
    /// Against rotation about x and y, N m.
    pub rocking_n_m: f64,
    /// Against translation z, N/m.
    pub vertical_n_per_m: f64,
    /// Against rotation about the axis, N m.
    pub torsion_n_m: f64,
}

impl Tower {
    /// The springs of the soil in layers under the tip of the pile, with the motions that the base
    /// is free in; none if a model of the layer at the tip gives no springs there, without
    /// [ground](crate::TowerDescription::ground), and on a frame. The stiffness of the
    /// [base](Self::base) contains them.
    pub fn springs_at_tip(&self) -> Option<TipSprings> {
        let at_tip = self.ground.as_ref()?.at_tip;
        let moves = self.base().moves;
        let acting = |i: usize| if moves[i] { at_tip[i] } else { 0.0 };
        let springs = TipSprings {
            height_m: self.base_m(),
            lateral_n_per_m: acting(0),
            rocking_n_m: acting(4),
            vertical_n_per_m: acting(2),
            torsion_n_m: acting(5),
        };
        (0..6).any(|i| acting(i) > 0.0).then_some(springs)
    }

    /// The springs of the soil along a tower in [ground](crate::TowerDescription::ground) by rising
    /// height: at both ends of each piece of the tower that is in soil, so twice at a step, with
    /// rows of [`soil`](crate::TowerDescription::soil) there. Empty without ground.
    pub fn springs_of_soil(&self) -> Vec<SpringsAt> {
        let mut springs: Vec<SpringsAt> = Vec::new();
        if self.ground.is_none() {
            return springs;
        }
        for piece in self.pieces() {
            if let Some([low, high]) = &piece.environment.soil {
                springs.push(SpringsAt::new(piece.base_m, low));
                springs.push(SpringsAt::new(piece.top_m, high));
            }
        }
        springs.dedup();
        springs
    }
}

/// Springs of the soil along a member of the frame below a tower.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SpringsOfMember {
    /// Name of the member.
    pub member: String,
    /// By rising height, twice where they jump: lateral across the member, vertical along it, per
    /// length of the member.
    pub springs: Vec<SpringsAt>,
}

impl Tower {
    /// The springs of the soil along the piles of the frame below a tower in
    /// [ground](crate::TowerDescription::ground), member by member. Empty without both.
    pub fn springs_of_members(&self) -> Vec<SpringsOfMember> {
        let frame = self.frame.as_ref().filter(|_| self.ground.is_some());
        let Some(frame) = frame.map(|foundation| foundation.frame.description()) else {
            return Vec::new();
        };
        let members = frame
            .members
            .iter()
            .filter(|member| !member.soil.is_empty());
        let of_member = members.map(|member| {
            let [from_m, to_m] = member.joints.map(|joint| frame.joints[joint].position_m[2]);
            let rows = member.soil.iter().flat_map(|soil| &soil.rows);
            let mut springs: Vec<SpringsAt> = rows
                .map(|row| SpringsAt::new(from_m + row.fraction * (to_m - from_m), &row.stiffness))
                .collect();
            if to_m < from_m {
                springs.reverse();
            }
            springs.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
            springs.dedup();
            SpringsOfMember {
                member: member.name.clone(),
                springs,
            }
        });
        of_member.collect()
    }
}

impl SpringsAt {
    fn new(height_m: f64, soil: &SoilStiffness) -> Self {
        Self {
            height_m,
            lateral_n_per_m2: soil.x_n_per_m2,
            vertical_n_per_m2: soil.z_n_per_m2,
            rotation_n: soil.rotation_y_n,
            torsion_n: soil.torsion_n,
        }
    }
}
