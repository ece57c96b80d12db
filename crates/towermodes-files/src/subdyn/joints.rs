//! The table of joints: 4 columns until FAST 8, 9 columns since.

use towermodes::frame::{FrameJoint, JointKind};

use super::rows::Row;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::source::Source;

const COORDINATES: [&str; 3] = ["JointXss", "JointYss", "JointZss"];
const DIRECTIONS: [&str; 3] = ["JointDirX", "JointDirY", "JointDirZ"];
/// The column of the joint type, and its name.
const TYPE: (usize, &str) = (4, "JointType");
const STIFFNESS: (usize, &str) = (8, "JointStiff");

/// The joints, and notes on unused values.
pub(super) fn joints(
    rows: &[Row<'_>],
    source: &Source,
) -> Result<(Vec<FrameJoint>, Vec<Note>), Diagnostic> {
    let mut notes = Vec::new();
    let is_old = is_old(rows);
    let joints = rows
        .iter()
        .map(|row| joint(row, is_old, source, &mut notes));
    let joints: Result<Vec<FrameJoint>, Diagnostic> = joints.collect();
    Ok((joints?, notes))
}

/// Whether all joints are welded and all members circular, as in files of FAST 8, according to the
/// first row.
pub(super) fn is_old(rows: &[Row<'_>]) -> bool {
    rows.first().is_some_and(|row| row.numbers() == 4)
}

fn joint(
    row: &Row<'_>,
    is_old: bool,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<FrameJoint, Diagnostic> {
    let columns = row.numbers();
    if columns < 9 && !(is_old && columns >= 4) {
        let hint = "a joint has JointID, three coordinates, JointType, three components of JointDir and JointStiff, or in files of FAST 8 only JointID and the coordinates";
        return Err(row.wrong_count(if is_old { "4" } else { "4 or 9" }, hint));
    }
    let name = row.integer(0, "JointID")?.to_string();
    let joint = FrameJoint::new(name, row.numbers_from(1, COORDINATES)?);
    if is_old {
        return Ok(joint);
    }
    let kind = kind(row, source, notes)?;
    Ok(FrameJoint { kind, ..joint })
}

fn kind(row: &Row<'_>, source: &Source, notes: &mut Vec<Note>) -> Result<JointKind, Diagnostic> {
    let axis = row.numbers_from(5, DIRECTIONS)?;
    let stiffness_n_m_per_rad = row.number(STIFFNESS.0, STIFFNESS.1)?;
    let number = row.integer(TYPE.0, TYPE.1)?;
    let kind = match number {
        1 => JointKind::Cantilever,
        2 => JointKind::Universal {
            stiffness_n_m_per_rad,
        },
        3 => JointKind::Pin {
            axis,
            stiffness_n_m_per_rad,
        },
        4 => JointKind::Ball {
            stiffness_n_m_per_rad,
        },
        other => {
            let rule = "1 (cantilever), 2 (universal), 3 (pin) or 4 (ball)";
            let kind = DiagnosticKind::out_of_range(TYPE.1, other as f64, rule);
            return Err(row.wrong(TYPE.0, kind));
        }
    };
    if kind == JointKind::Cantilever && stiffness_n_m_per_rad != 0.0 {
        let message = format!(
            "JointStiff is {stiffness_n_m_per_rad} N m/rad, but the joint is a cantilever joint, which does not rotate"
        );
        let mistake = row.wrong(STIFFNESS.0, DiagnosticKind::Contradiction(message));
        return Err(mistake.with_hint("write 0, or JointType 2, 3 or 4"));
    }
    if number != 3 && axis != [0.0; 3] {
        let id = row.integer(0, "JointID")?;
        let message =
            format!("JointDir of joint {id} is not used: only a pin (JointType 3) has an axis");
        notes.push(Note::left_out(message).at(source, row.span().start));
    }
    Ok(kind)
}
