//! Warnings: possible values of a frame that are probably mistakes.

use std::cmp::Ordering;
use std::collections::HashMap;

use thiserror::Error;

use super::super::parts::material::Material;
use super::super::pieces::section::Tube;
use super::description::FrameDescription;
use super::member::{FrameMember, MemberKind, SectionEnds};
use super::part::FramePart;
use super::validate::Frame;
use crate::number::{Plain, Rounded};

/// Diameter over wall of tubes: grouted legs have 4, the thinnest cans of a tower 250.
const SLENDER: [f64; 2] = [3.0, 300.0];
/// Largest usual diameter: columns of floaters have at most 20 m.
const WIDEST_M: f64 = 30.0;
const LONGEST_M: f64 = 200.0;
const FARTHEST_M: f64 = 1000.0;
/// Usual range of the modulus: plastics have 1e9, and members that represent rigid ones have up to
/// 1e5 times the modulus of steel.
const MODULUS_PA: [f64; 2] = [1e9, 1e17];

/// Densities of solid materials in t/m³. Members without mass have 0, and members with nearly no
/// mass up to 1 kg/m³.
const IN_TONNES: [f64; 2] = [1.0, 30.0];

/// A probable mistake that the user should check, with its numbers. There is one warning of each
/// kind, with the part that deviates most and the number of other parts with the same problem.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum FrameWarning {
    /// A tube whose wall is too thin or too thick.
    #[error(
        "member {name}{}: wall {} m is 1/{} of the diameter {} m; expected 1/{:.0} to 1/{:.0}: check unit and decimal point of both",
        and_others(*.others), Plain(*.wall_m), Rounded(.diameter_m / .wall_m), Plain(*.diameter_m), SLENDER[0], SLENDER[1]
    )]
    UnusualWall {
        /// The member, from 0.
        member: usize,
        /// Its name.
        name: String,
        /// How many other members have such a wall.
        others: usize,
        /// Outer diameter, m.
        diameter_m: f64,
        /// Wall thickness, m.
        wall_m: f64,
    },
    /// A tube with a larger diameter than any real tube.
    #[error(
        "member {name}{}: outer diameter {} m is larger than 30 m; lengths are in m, not mm",
        and_others(*.others), Plain(*.diameter_m)
    )]
    LargeDiameter {
        /// The member, from 0.
        member: usize,
        /// Its name.
        name: String,
        /// How many other members are so wide.
        others: usize,
        /// Outer diameter, m.
        diameter_m: f64,
    },
    /// A member that is longer than any real member.
    #[error(
        "member {name}{} is {} m long, more than 200 m; check the positions of its joints, in m",
        and_others(*.others), Rounded(*.length_m)
    )]
    Long {
        /// The member, from 0.
        member: usize,
        /// Its name.
        name: String,
        /// How many other members are so long.
        others: usize,
        /// Its length, m.
        length_m: f64,
    },
    /// A joint far from the others.
    #[error(
        "joint {name}{} is at {} m, more than 1 km from the origin; positions are in m, not mm",
        and_others(*.others), Plain(*.coordinate_m)
    )]
    Far {
        /// The joint, from 0.
        joint: usize,
        /// Its name.
        name: String,
        /// How many other joints are so far away.
        others: usize,
        /// The largest of its coordinates, m.
        coordinate_m: f64,
    },
    /// Two beams between the same two joints.
    #[error(
        "members {first} and {second} are between the same two joints: their stiffness and mass add up; remove one of them"
    )]
    SameJoints {
        /// The second of them, from 0.
        member: usize,
        /// Name of the first.
        first: String,
        /// Name of the second.
        second: String,
    },
    /// A modulus that no material has.
    #[error(
        "member {name}{}: Young's modulus is {} Pa; expected 1e9 to 1e17 Pa; steel has 2.1e11; the unit is Pa",
        and_others(*.others), Plain(*.youngs_modulus_pa)
    )]
    UnusualModulus {
        /// The member, from 0.
        member: usize,
        /// Its name.
        name: String,
        /// How many other members have such a modulus.
        others: usize,
        /// Young's modulus, Pa.
        youngs_modulus_pa: f64,
    },
    /// A density that is probably in t/m³.
    #[error(
        "member {name}{}: the density is {} kg/m3, less than that of any structural material (steel: 7850); the unit is kg/m3",
        and_others(*.others), Plain(*.density_kg_per_m3)
    )]
    UnusualDensity {
        /// The member, from 0.
        member: usize,
        /// Its name.
        name: String,
        /// How many other members have such a density.
        others: usize,
        /// Density, kg/m³.
        density_kg_per_m3: f64,
    },
    /// Moduli that are probably exchanged.
    #[error(
        "member {name}{}: the shear modulus {} Pa is larger than Young's modulus {} Pa: this is impossible for an isotropic material; steel has 8.08e10 and 2.1e11: check whether both are exchanged",
        and_others(*.others), Plain(*.shear_modulus_pa), Plain(*.youngs_modulus_pa)
    )]
    ShearAboveYoungs {
        /// The member, from 0.
        member: usize,
        /// Its name.
        name: String,
        /// How many other members have such moduli.
        others: usize,
        /// Young's modulus, Pa.
        youngs_modulus_pa: f64,
        /// Shear modulus, Pa.
        shear_modulus_pa: f64,
    },
}

/// " (and 3 others)", or nothing.
fn and_others(others: usize) -> String {
    match others {
        0 => String::new(),
        1 => " (and another one)".to_owned(),
        _ => format!(" (and {others} others)"),
    }
}

impl FrameWarning {
    /// The part that the warning concerns.
    pub fn part(&self) -> FramePart {
        match *self {
            Self::UnusualWall { member, .. }
            | Self::LargeDiameter { member, .. }
            | Self::Long { member, .. }
            | Self::SameJoints { member, .. }
            | Self::UnusualModulus { member, .. }
            | Self::UnusualDensity { member, .. }
            | Self::ShearAboveYoungs { member, .. } => FramePart::Member(member),
            Self::Far { joint, .. } => FramePart::Joint(joint),
        }
    }
}

impl Frame {
    /// Probable mistakes in the frame.
    pub fn warnings(&self) -> Vec<FrameWarning> {
        let description = self.description();
        let of_kinds = [
            far(description),
            long(self),
            large(description),
            unusual_wall(description),
            unusual_modulus(description),
            unusual_density(description),
            shear_above_youngs(description),
        ];
        let mut warnings: Vec<FrameWarning> = of_kinds.into_iter().flatten().collect();
        warnings.extend(same_joints(description));
        warnings
    }
}

/// The entry with the largest value among those outside the range, and the number of the others.
fn worst<T>(wrong: impl Iterator<Item = (f64, T)>) -> Option<(T, usize)> {
    let wrong: Vec<(f64, T)> = wrong.collect();
    let others = wrong.len().saturating_sub(1);
    let largest = wrong.into_iter().reduce(|a, b| match b.0.total_cmp(&a.0) {
        Ordering::Greater => b,
        Ordering::Less | Ordering::Equal => a,
    })?;
    Some((largest.1, others))
}

fn members(frame: &FrameDescription) -> impl Iterator<Item = (usize, &FrameMember)> {
    frame.members.iter().enumerate()
}

/// The ends of all tubes.
fn tubes(frame: &FrameDescription) -> impl Iterator<Item = (usize, &FrameMember, [Tube; 2])> {
    members(frame).filter_map(|(index, member)| match member.kind {
        MemberKind::Beam {
            ends: SectionEnds::Tube(ends),
            ..
        } => Some((index, member, ends)),
        MemberKind::Beam { .. }
        | MemberKind::Cable { .. }
        | MemberKind::Rigid { .. }
        | MemberKind::Spring(_) => None,
    })
}

fn materials(frame: &FrameDescription) -> impl Iterator<Item = (usize, &FrameMember, Material)> {
    members(frame).filter_map(|(index, member)| match member.kind {
        MemberKind::Beam { material, .. } => Some((index, member, material)),
        MemberKind::Cable { .. } | MemberKind::Rigid { .. } | MemberKind::Spring(_) => None,
    })
}

fn far(frame: &FrameDescription) -> Option<FrameWarning> {
    let joints = frame.joints.iter().enumerate().map(|(index, joint)| {
        let largest = joint
            .position_m
            .into_iter()
            .reduce(|a, b| if b.abs() > a.abs() { b } else { a });
        let coordinate_m = largest.unwrap_or(0.0);
        (coordinate_m.abs(), (index, joint, coordinate_m))
    });
    let wrong = joints.filter(|(size_m, _)| *size_m > FARTHEST_M);
    let ((joint, found, coordinate_m), others) = worst(wrong)?;
    Some(FrameWarning::Far {
        joint,
        name: found.name.clone(),
        others,
        coordinate_m,
    })
}

fn long(frame: &Frame) -> Option<FrameWarning> {
    let all = members(frame.description());
    let lengths = all.map(|(index, member)| (frame.length_m(member), (index, member)));
    let wrong = lengths.filter(|(length_m, _)| *length_m > LONGEST_M);
    let ((member, found), others) = worst(wrong)?;
    Some(FrameWarning::Long {
        member,
        name: found.name.clone(),
        others,
        length_m: frame.length_m(found),
    })
}

fn large(frame: &FrameDescription) -> Option<FrameWarning> {
    let widths = tubes(frame).map(|(index, member, ends)| {
        let diameter_m = ends[0].outer_diameter_m.max(ends[1].outer_diameter_m);
        (diameter_m, (index, member, diameter_m))
    });
    let wrong = widths.filter(|(diameter_m, _)| *diameter_m > WIDEST_M);
    let ((member, found, diameter_m), others) = worst(wrong)?;
    Some(FrameWarning::LargeDiameter {
        member,
        name: found.name.clone(),
        others,
        diameter_m,
    })
}

/// A solid bar has a wall of half the diameter.
fn unusual_wall(frame: &FrameDescription) -> Option<FrameWarning> {
    let ends = tubes(frame).flat_map(|(index, member, ends)| ends.map(|end| (index, member, end)));
    let excess = ends.map(|(index, member, tube)| {
        let ratio = tube.outer_diameter_m / tube.wall_thickness_m;
        let is_solid = ratio == 2.0;
        let excess = (SLENDER[0] / ratio).max(ratio / SLENDER[1]);
        (if is_solid { 0.0 } else { excess }, (index, member, tube))
    });
    let wrong: Vec<_> = excess.filter(|(excess, _)| *excess > 1.0).collect();
    let mut indices: Vec<usize> = wrong.iter().map(|(_, (index, ..))| *index).collect();
    indices.dedup();
    let ((member, found, tube), _) = worst(wrong.into_iter())?;
    Some(FrameWarning::UnusualWall {
        member,
        name: found.name.clone(),
        others: indices.len() - 1,
        diameter_m: tube.outer_diameter_m,
        wall_m: tube.wall_thickness_m,
    })
}

fn unusual_modulus(frame: &FrameDescription) -> Option<FrameWarning> {
    let excess = materials(frame).map(|(index, member, material)| {
        let modulus_pa = material.youngs_modulus_pa;
        let excess = (MODULUS_PA[0] / modulus_pa).max(modulus_pa / MODULUS_PA[1]);
        (excess, (index, member, modulus_pa))
    });
    let wrong = excess.filter(|(excess, _)| *excess > 1.0);
    let ((member, found, youngs_modulus_pa), others) = worst(wrong)?;
    Some(FrameWarning::UnusualModulus {
        member,
        name: found.name.clone(),
        others,
        youngs_modulus_pa,
    })
}

fn unusual_density(frame: &FrameDescription) -> Option<FrameWarning> {
    let densities = materials(frame).map(|(index, member, material)| {
        let density = material.density_kg_per_m3;
        (density, (index, member, density))
    });
    let [least, most] = IN_TONNES;
    let wrong = densities.filter(|(density, _)| least < *density && *density < most);
    let ((member, found, density_kg_per_m3), others) = worst(wrong)?;
    Some(FrameWarning::UnusualDensity {
        member,
        name: found.name.clone(),
        others,
        density_kg_per_m3,
    })
}

fn shear_above_youngs(frame: &FrameDescription) -> Option<FrameWarning> {
    let ratios = materials(frame).map(|(index, member, material)| {
        let ratio = material.shear_modulus_pa / material.youngs_modulus_pa;
        (ratio, (index, member, material))
    });
    let wrong = ratios.filter(|(ratio, _)| *ratio > 1.0);
    let ((member, found, material), others) = worst(wrong)?;
    Some(FrameWarning::ShearAboveYoungs {
        member,
        name: found.name.clone(),
        others,
        youngs_modulus_pa: material.youngs_modulus_pa,
        shear_modulus_pa: material.shear_modulus_pa,
    })
}

/// Each beam that connects the same joints as an earlier beam.
fn same_joints(frame: &FrameDescription) -> Vec<FrameWarning> {
    let mut before: HashMap<[usize; 2], &FrameMember> = HashMap::new();
    let mut warnings = Vec::new();
    for (index, found, _) in materials(frame) {
        let [a, b] = found.joints;
        if let Some(first) = before.insert([a.min(b), a.max(b)], found) {
            warnings.push(FrameWarning::SameJoints {
                member: index,
                first: first.name.clone(),
                second: found.name.clone(),
            });
        }
    }
    warnings
}
