//! The modes of a substructure as JSON and CSV.

use std::io::Write;

use serde::Serialize;
use towermodes::frame::{
    Frame, FrameFoundation, FrameMasses, FrameMember, FrameMode, FrameSolution,
};

use super::columns::Cell::{Count, Number, Small, Text};
use super::columns::{Column, write_columns_csv};
use super::{ResultError, write_result_json};
use crate::input::Note;

/// The directions of motions.
const DIRECTIONS: [&str; 6] = ["x", "y", "z", "rotation_x", "rotation_y", "rotation_z"];

/// The joint with the largest motion in a mode, and this motion.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LargestMotion {
    /// The joint, by its name in the file.
    pub joint: String,
    /// The direction: `x`, `y`, `z`; `rotation_x`, `rotation_y` or `rotation_z` if the largest
    /// rotation (rad) exceeds 1000 times the largest translation (m).
    pub direction: &'static str,
    /// The motion of the joint in this direction, m or rad, for a modal mass of 1 kg.
    pub motion: f64,
}

/// A motion is a rotation if it has fewer metres per radian than this.
const LARGEST_M: f64 = 1e-3;

impl LargestMotion {
    /// The largest motion of a mode: the largest translation of a joint, or the largest rotation if
    /// no joint is translated.
    pub fn of(mode: &FrameMode, frame: &Frame) -> Self {
        let largest = |components: std::ops::Range<usize>| {
            let motions = mode.shape.joints.iter().enumerate();
            let all = motions.flat_map(|(joint, motion)| {
                let own = components.clone();
                own.map(move |component| (joint, component, motion[component]))
            });
            // Of equal motions the first: mirror images differ by rounding.
            all.fold((0, components.start, 0.0_f64), |most, next| {
                match next.2.abs() > most.2.abs() * (1.0 + 1e-6) {
                    true => next,
                    false => most,
                }
            })
        };
        let (translation, rotation) = (largest(0..3), largest(3..6));
        let is_rotation = translation.2.abs() < LARGEST_M * rotation.2.abs();
        let (joint, component, motion) = if is_rotation { rotation } else { translation };
        let joints = &frame.description().joints;
        Self {
            joint: joints
                .get(joint)
                .map_or_else(String::new, |joint| joint.name.clone()),
            direction: DIRECTIONS[component],
            motion,
        }
    }
}

/// The result of `towermodes solve` for a file of SubDyn.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SubstructureDocument<'a> {
    /// The element type of the members: `spectral`, beams whose degree increases until the
    /// frequencies have converged, or `subdyn`, the element of SubDyn with the divisions of the
    /// file.
    method: &'static str,
    /// Degree of the elements of `spectral`; null for `subdyn`.
    degree: Option<usize>,
    /// Degrees of freedom.
    degrees_of_freedom: usize,
    /// The substructure that was solved.
    substructure: SubstructureSummary<'a>,
    /// The lowest modes by frequency.
    modes: Vec<SubstructureMode<'a>>,
    /// The frequency, Hz, up to which no mode is missing, which an eigenvalue count proves.
    complete_below_hz: f64,
    /// Assumptions of the reader and data that it omits.
    warnings: Vec<String>,
}

/// The substructure that was solved.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct SubstructureSummary<'a> {
    /// The second line of the file; may be empty.
    name: &'a str,
    /// Whether the interface joints are fixed (`--clamped`); otherwise they are free.
    clamped: bool,
    /// Mass of members, masses on joints and soil mass at the supports, kg.
    mass_kg: f64,
    /// The mass by substance.
    masses: FrameMasses,
    /// Number of members.
    members: usize,
    /// The joints in the order of the file.
    joints: Vec<SubstructureJoint<'a>>,
}

/// A joint.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct SubstructureJoint<'a> {
    /// Its number in the file.
    name: &'a str,
    /// Its position, m: x fore-aft (downwind), y side-side, z up.
    position_m: [f64; 3],
}

/// The members under a tower.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct FrameSummary<'a> {
    /// The joints, in the order of the shapes of the modes.
    joints: Vec<SubstructureJoint<'a>>,
    /// The members, in the order of the shapes of the modes.
    members: Vec<FrameMemberSummary<'a>>,
    /// Their mass by kind.
    masses: FrameMasses,
    /// Mass of the transition piece, kg.
    transition_piece_kg: f64,
}

/// A member.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct FrameMemberSummary<'a> {
    /// Its name or its number in the file.
    name: &'a str,
    /// The indices of its first and its second joint in the list of joints, from 0.
    joints: [usize; 2],
}

impl<'a> FrameSummary<'a> {
    pub(super) fn of(foundation: &'a FrameFoundation) -> Self {
        let description = foundation.frame.description();
        let member = |member: &'a FrameMember| FrameMemberSummary {
            name: &member.name,
            joints: member.joints,
        };
        Self {
            joints: joints_of(&foundation.frame),
            members: description.members.iter().map(member).collect(),
            masses: foundation.frame.masses(),
            transition_piece_kg: foundation.platform.mass_kg,
        }
    }
}

fn joints_of(frame: &Frame) -> Vec<SubstructureJoint<'_>> {
    let joints = frame.description().joints.iter();
    let joint = joints.map(|joint| SubstructureJoint {
        name: &joint.name,
        position_m: joint.position_m,
    });
    joint.collect()
}

/// A mode.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct SubstructureMode<'a> {
    /// Number in the list, from 1.
    number: usize,
    /// Natural frequency, Hz.
    frequency_hz: f64,
    /// Bound on the error of the eigenvalue computation, Hz.
    algebraic_error_hz: f64,
    /// Estimate of the discretization error, Hz; 0 for `subdyn`, whose elements are prescribed.
    discretization_error_hz: f64,
    /// The joint with the largest motion, and this motion.
    largest: LargestMotion,
    /// Motion of each joint (x, y, z, rotation about x, y, z; m and rad) for a modal mass of 1 kg,
    /// in the order of the joints.
    motions: &'a [[f64; 6]],
    /// Translation of each member (x, y, z; m) at a quarter, a half and three quarters of its
    /// length from its first joint, in the order of the members.
    members: &'a [[[f64; 3]; 3]],
}

/// A substructure with its solution.
#[derive(Debug, Clone, Copy)]
pub struct SolvedSubstructure<'a> {
    /// Its name.
    pub name: &'a str,
    /// The frame that was solved.
    pub frame: &'a Frame,
    /// Its modes.
    pub solution: &'a FrameSolution,
}

impl SolvedSubstructure<'_> {
    /// Whether the interface joints are fixed.
    pub fn is_clamped(&self) -> bool {
        let transition = self.frame.description().transition.as_ref();
        transition.is_some_and(|transition| transition.is_held)
    }

    /// The warning on motions without stiffness.
    pub fn mechanism(&self) -> Option<Note> {
        let mechanism = self.solution.mechanism.as_ref()?;
        Some(Note::suspicious(mechanism.to_string()))
    }

    /// The element type of the members.
    pub fn method(&self) -> &'static str {
        match self.solution.degree {
            Some(_) => "spectral",
            None => "subdyn",
        }
    }
}

/// Writes the modes of a substructure as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_substructure_json(
    solved: &SolvedSubstructure<'_>,
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    let SolvedSubstructure {
        name,
        frame,
        solution,
    } = *solved;
    let description = frame.description();
    let modes = solution.modes.iter().enumerate();
    let modes = modes.map(|(index, mode)| SubstructureMode {
        number: index + 1,
        frequency_hz: mode.frequency_hz,
        algebraic_error_hz: mode.error_hz,
        discretization_error_hz: mode.discretization_error_hz,
        largest: LargestMotion::of(mode, frame),
        motions: &mode.shape.joints,
        members: &mode.shape.members,
    });
    let document = SubstructureDocument {
        method: solved.method(),
        degree: solution.degree,
        degrees_of_freedom: solution.degrees_of_freedom,
        substructure: SubstructureSummary {
            name,
            clamped: solved.is_clamped(),
            mass_kg: frame.mass_kg(),
            members: description.members.len(),
            joints: joints_of(frame),
            masses: frame.masses(),
        },
        modes: modes.collect(),
        complete_below_hz: solution.complete_below_hz,
        warnings: notes.iter().map(ToString::to_string).collect(),
    };
    write_result_json(&document, writer)
}

/// A line of the CSV.
struct Line {
    number: usize,
    mode: FrameMode,
    largest: LargestMotion,
}

/// Writes the modes of a substructure as CSV with a header.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_substructure_csv(
    solved: &SolvedSubstructure<'_>,
    writer: impl Write,
) -> Result<(), ResultError> {
    let modes = solved.solution.modes.iter().enumerate();
    let lines = modes.map(|(index, mode)| Line {
        number: index + 1,
        mode: mode.clone(),
        largest: LargestMotion::of(mode, solved.frame),
    });
    let lines: Vec<Line> = lines.collect();
    write_columns_csv(&COLUMNS, &lines, writer)
}

/// The quantities of a mode of a substructure: the columns of the CSV.
#[rustfmt::skip]
static COLUMNS: [Column<Line>; 7] = [
    Column { key: "number", unit: "", meaning: "place in the list, from 1", value: |l| Count(l.number) },
    Column { key: "frequency_hz", unit: "Hz", meaning: "natural frequency", value: |l| Number(l.mode.frequency_hz) },
    Column { key: "algebraic_error_hz", unit: "Hz", meaning: "bound on the error of the eigenvalue computation", value: |l| Small(l.mode.error_hz) },
    Column { key: "discretization_error_hz", unit: "Hz", meaning: "estimate of the discretization error", value: |l| Small(l.mode.discretization_error_hz) },
    Column { key: "largest.joint", unit: "", meaning: "joint that moves most", value: |l| Text(l.largest.joint.clone()) },
    Column { key: "largest.direction", unit: "", meaning: "direction of its motion", value: |l| Text(l.largest.direction.to_owned()) },
    Column { key: "largest.motion", unit: "m or rad", meaning: "its motion for a modal mass of 1 kg", value: |l| Small(l.largest.motion) },
];
