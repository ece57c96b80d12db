//! The input values of a frame below the tower.

use super::part::{Indices, Key, Part, is_there};
use crate::inputs::Nature;
use crate::tower::frame::{
    FrameDescription, FrameFoundation, FramePart, JointKind, MarineGrowth, MemberKind, SectionEnds,
};
use crate::tower::{Foundation, Place, RigidBody, TowerDescription, Tube};

fn foundation(description: &TowerDescription) -> Option<&FrameFoundation> {
    description.foundation.frame()
}

fn foundation_mut(description: &mut TowerDescription) -> Option<&mut FrameFoundation> {
    match &mut description.foundation {
        Foundation::Frame(foundation) => Some(foundation),
        _ => None,
    }
}

fn frame(description: &TowerDescription) -> Option<&FrameDescription> {
    Some(foundation(description)?.frame.description())
}

fn frame_mut(description: &mut TowerDescription) -> Option<&mut FrameDescription> {
    Some(foundation_mut(description)?.numbers_mut())
}

/// Number of entries of a list of a frame.
macro_rules! count {
    ($list:ident) => {
        |d| frame(d).map_or(0, |frame| frame.$list.len())
    };
}

/// A coordinate of a joint.
macro_rules! position {
    ($axis:literal, $name:literal, $meaning:literal) => {
        Key {
            name: $name,
            unit: "m",
            meaning: $meaning,
            nature: Nature::Signed,
            place: |i| joint(i),
            get: |d, i| Some(frame(d)?.joints.get(i[0])?.position_m[$axis]),
            set: |d, i, value| {
                frame_mut(d)?.joints.get_mut(i[0])?.position_m[$axis] = value;
                Some(())
            },
            is_listed: is_there,
        }
    };
}

/// A dimension of a tube that is the same at both ends.
macro_rules! both_ends {
    ($name:literal, $meaning:literal, $field:ident) => {
        Key {
            name: $name,
            unit: "m",
            meaning: $meaning,
            nature: Nature::Size,
            place: |i| member(i),
            get: |d, i| {
                let [first, last] = tubes(d, i)?.map(|tube| tube.$field);
                (first == last).then_some(first)
            },
            set: |d, i, value| {
                tubes_mut(d, i)?
                    .iter_mut()
                    .for_each(|tube| tube.$field = value);
                Some(())
            },
            is_listed: |d, i| tubes(d, i).is_some_and(|tubes| tubes[0].$field == tubes[1].$field),
        }
    };
}

/// A dimension of a tube at one end.
macro_rules! one_end {
    ($end:literal, $name:literal, $meaning:literal, $field:ident) => {
        Key {
            name: $name,
            unit: "m",
            meaning: $meaning,
            nature: Nature::Size,
            place: |i| member(i),
            get: |d, i| Some(tubes(d, i)?[$end].$field),
            set: |d, i, value| {
                tubes_mut(d, i)?[$end].$field = value;
                Some(())
            },
            is_listed: |d, i| tubes(d, i).is_some_and(|tubes| tubes[0].$field != tubes[1].$field),
        }
    };
}

/// An input value of members of one or two kinds.
macro_rules! of_kind {
    ($name:literal, $unit:literal, $meaning:literal, $($kind:ident)|+, $field:ident) => {
        Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            nature: Nature::Amount,
            place: |i| member(i),
            get: |d, i| match &frame(d)?.members.get(i[0])?.kind {
                $(MemberKind::$kind { $field, .. })|+ => Some(*$field),
                _ => None,
            },
            set: |d, i, value| match &mut frame_mut(d)?.members.get_mut(i[0])?.kind {
                $(MemberKind::$kind { $field, .. })|+ => {
                    *$field = value;
                    Some(())
                }
                _ => None,
            },
            is_listed: |d, i| {
                let member = frame(d).and_then(|frame| frame.members.get(i[0]));
                member.is_some_and(|member| matches!(member.kind, $(MemberKind::$kind { .. })|+))
            },
        }
    };
}

/// An input value of a body in a list of the frame.
macro_rules! body {
    ($name:literal, $unit:literal, $meaning:literal, $nature:ident, $list:ident, $($field:tt)+) => {
        Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            nature: Nature::$nature,
            place: |i| mass(i),
            get: |d, i| Some(frame(d)?.$list.get(i[0])?.1.$($field)+),
            set: |d, i, value| {
                frame_mut(d)?.$list.get_mut(i[0])?.1.$($field)+ = value;
                Some(())
            },
            is_listed: is_there,
        }
    };
}

/// An input value of the platform.
macro_rules! platform {
    ($name:literal, $unit:literal, $meaning:literal, $nature:ident, $($field:tt)+) => {
        Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            nature: Nature::$nature,
            place: |i| transition(i),
            get: |d, _| Some(foundation(d)?.platform.$($field)+),
            set: |d, _, value| {
                foundation_mut(d)?.platform.$($field)+ = value;
                Some(())
            },
            is_listed: is_there,
        }
    };
}

/// An input value of marine growth.
macro_rules! growth {
    ($name:literal, $unit:literal, $meaning:literal, $nature:ident, $field:ident) => {
        Key {
            name: $name,
            unit: $unit,
            meaning: $meaning,
            nature: Nature::$nature,
            place: |i| growth_place(i),
            get: |d, i| Some(growth_at(d, i)?.$field),
            set: |d, i, value| {
                foundation_mut(d)?.in_water.growth.get_mut(i[0])?.$field = value;
                Some(())
            },
            is_listed: is_there,
        }
    };
}

/// `joint` of `[substructure]`.
pub(super) static JOINTS: Part = Part {
    name: "substructure.joint[]",
    noun: "joints of the substructure",
    count: count!(joints),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[
        position!(0, "position[0]", "fore-aft position"),
        position!(1, "position[1]", "side-side position"),
        position!(2, "position[2]", "height"),
        Key {
            name: "stiffness",
            unit: "N m",
            meaning: "stiffness of the springs of the joint",
            nature: Nature::Amount,
            place: |i| joint(i),
            get: |d, i| joint_stiffness(frame(d)?.joints.get(i[0])?.kind),
            set: |d, i, value| {
                let kind = &mut frame_mut(d)?.joints.get_mut(i[0])?.kind;
                *joint_stiffness_mut(kind)? = value;
                Some(())
            },
            is_listed: |d, i| {
                let joint = frame(d).and_then(|frame| frame.joints.get(i[0]));
                joint.is_some_and(|joint| joint_stiffness(joint.kind).is_some())
            },
        },
    ],
};

fn joint(indices: Indices) -> Place {
    let part = FramePart::Joint(indices[0]);
    Place::Substructure { part }
}

fn joint_stiffness(mut kind: JointKind) -> Option<f64> {
    joint_stiffness_mut(&mut kind).copied()
}

fn joint_stiffness_mut(kind: &mut JointKind) -> Option<&mut f64> {
    match kind {
        JointKind::Cantilever => None,
        JointKind::Pin {
            stiffness_n_m_per_rad,
            ..
        }
        | JointKind::Universal {
            stiffness_n_m_per_rad,
        }
        | JointKind::Ball {
            stiffness_n_m_per_rad,
        } => Some(stiffness_n_m_per_rad),
    }
}

/// `member` of `[substructure]`.
pub(super) static MEMBERS: Part = Part {
    name: "substructure.member[]",
    noun: "members of the substructure",
    count: count!(members),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[
        both_ends!("outer_diameter", "outer diameter", outer_diameter_m),
        one_end!(
            0,
            "outer_diameter[0]",
            "outer diameter at the first joint",
            outer_diameter_m
        ),
        one_end!(
            1,
            "outer_diameter[1]",
            "outer diameter at the second joint",
            outer_diameter_m
        ),
        both_ends!("wall_thickness", "wall thickness", wall_thickness_m),
        one_end!(
            0,
            "wall_thickness[0]",
            "wall thickness at the first joint",
            wall_thickness_m
        ),
        one_end!(
            1,
            "wall_thickness[1]",
            "wall thickness at the second joint",
            wall_thickness_m
        ),
        of_kind!(
            "axial_stiffness",
            "N",
            "axial stiffness of the cable",
            Cable,
            axial_n
        ),
        of_kind!(
            "pretension",
            "N",
            "pretension of the cable",
            Cable,
            pretension_n
        ),
        of_kind!(
            "mass_per_length",
            "kg/m",
            "mass per length",
            Cable | Rigid,
            mass_kg_per_m
        ),
    ],
};

fn member(indices: Indices) -> Place {
    let part = FramePart::Member(indices[0]);
    Place::Substructure { part }
}

fn tubes(description: &TowerDescription, indices: Indices) -> Option<&[Tube; 2]> {
    match &frame(description)?.members.get(indices[0])?.kind {
        MemberKind::Beam {
            ends: SectionEnds::Tube(tubes),
            ..
        } => Some(tubes),
        _ => None,
    }
}

fn tubes_mut(description: &mut TowerDescription, indices: Indices) -> Option<&mut [Tube; 2]> {
    match &mut frame_mut(description)?.members.get_mut(indices[0])?.kind {
        MemberKind::Beam {
            ends: SectionEnds::Tube(tubes),
            ..
        } => Some(tubes),
        _ => None,
    }
}

/// `mass` of `[substructure]`.
pub(super) static MASSES: Part = Part {
    name: "substructure.mass[]",
    noun: "masses of the substructure",
    count: count!(masses),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[
        body!("mass", "kg", "mass", Amount, masses, mass_kg),
        body!(
            "center[0]",
            "m",
            "centre of mass from the joint, downwind",
            Signed,
            masses,
            center_m[0]
        ),
        body!(
            "center[1]",
            "m",
            "centre of mass from the joint, side-side",
            Signed,
            masses,
            center_m[1]
        ),
        body!(
            "center[2]",
            "m",
            "centre of mass from the joint, up",
            Signed,
            masses,
            center_m[2]
        ),
    ],
};

fn mass(indices: Indices) -> Place {
    let part = FramePart::Mass(indices[0]);
    Place::Substructure { part }
}

/// `platform` of `[substructure]`.
pub(super) static PLATFORM: Part = Part {
    name: "substructure.platform",
    noun: "platform of the substructure",
    count: |d| usize::from(foundation(d).is_some_and(|of| of.platform != RigidBody::default())),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[
        platform!("mass", "kg", "mass of the platform", Amount, mass_kg),
        platform!(
            "center[0]",
            "m",
            "centre of mass of the platform, downwind",
            Signed,
            center_m[0]
        ),
        platform!(
            "center[1]",
            "m",
            "centre of mass of the platform, side-side",
            Signed,
            center_m[1]
        ),
        platform!(
            "center[2]",
            "m",
            "centre of mass of the platform, up",
            Signed,
            center_m[2]
        ),
    ],
};

fn transition(_: Indices) -> Place {
    let part = FramePart::Platform;
    Place::Substructure { part }
}

/// `growth` of `[substructure]`.
pub(super) static GROWTH: Part = Part {
    name: "substructure.growth[]",
    noun: "marine growth on the substructure",
    count: |d| foundation(d).map_or(0, |of| of.in_water.growth.len()),
    rows: |_, _| 1,
    is_symmetric: false,
    keys: &[
        growth!("top", "m", "upper end of the growth", Signed, top_m),
        growth!("bottom", "m", "lower end of the growth", Signed, bottom_m),
        growth!(
            "thickness",
            "m",
            "thickness of the growth",
            Amount,
            thickness_m
        ),
        growth!(
            "density",
            "kg/m3",
            "density of the growth",
            Amount,
            density_kg_per_m3
        ),
    ],
};

fn growth_at(description: &TowerDescription, indices: Indices) -> Option<&MarineGrowth> {
    foundation(description)?.in_water.growth.get(indices[0])
}

fn growth_place(indices: Indices) -> Place {
    let part = FramePart::Growth(indices[0]);
    Place::Substructure { part }
}
