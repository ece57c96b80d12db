//! The tables of reaction joints and of interface joints.

use towermodes::frame::FrameSupport;

use super::rows::{Ids, Row};
use super::soil::read_soil;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::resolver::FileResolver;
use crate::source::Source;

const REACTIONS: [&str; 6] = [
    "RctTDXss", "RctTDYss", "RctTDZss", "RctRDXss", "RctRDYss", "RctRDZss",
];
const INTERFACES: [&str; 6] = [
    "ItfTDXss", "ItfTDYss", "ItfTDZss", "ItfRDXss", "ItfRDYss", "ItfRDZss",
];
/// The column of the file of soil stiffness.
const SOIL_FILE: usize = 7;

/// The reaction joints.
#[derive(Debug, Default)]
pub(super) struct Reactions {
    /// The supports, each with the index of its row; joints without support are not included.
    pub(super) supports: Vec<(usize, FrameSupport)>,
    pub(super) notes: Vec<Note>,
    /// The joints of the table without support, each with its note.
    pub(super) loose: Vec<(usize, Note)>,
    /// The files of soil stiffness.
    pub(super) sources: Vec<Source>,
}

/// Reads the reaction joints, and the files of soil stiffness that they name.
pub(super) fn reactions(
    rows: &[Row<'_>],
    joints: &Ids,
    source: &Source,
    files: &dyn FileResolver,
) -> Result<Reactions, ReadError> {
    let mut reactions = Reactions::default();
    for (index, row) in rows.iter().enumerate() {
        let read = reaction(row, joints).map_err(|mistake| ReadError::mistake(source, mistake))?;
        let mut support = read;
        soil(row, &mut support, source, files, &mut reactions)?;
        if row.numbers() == 1 {
            let message = "the reaction joint has no flags: all its motions are held, as in SubDyn";
            let note = Note::assumption(message).at(source, row.span().start);
            reactions.notes.push(note);
        }
        let has_soil = [support.stiffness, support.inertia] != [[[0.0; 6]; 6]; 2];
        if has_soil || support.fixed.contains(&true) {
            reactions.supports.push((index, support));
        } else {
            let message =
                "all flags are 0 and there is no soil stiffness: this joint has no support";
            let note = Note::suspicious(message).at(source, row.span().start);
            reactions.notes.push(note.clone());
            reactions.loose.push((support.joint, note));
        }
    }
    Ok(reactions)
}

/// The joint and its flags: 1 column, or 7.
fn reaction(row: &Row<'_>, joints: &Ids) -> Result<FrameSupport, Diagnostic> {
    let mut support = FrameSupport::clamped(joints.find(row, 0, "RJointID")?);
    match row.numbers() {
        1 => {}
        7.. => {
            for (k, (fixed, name)) in support.fixed.iter_mut().zip(REACTIONS).enumerate() {
                *fixed = row.flag(k + 1, name)?;
            }
        }
        _ => {
            let hint = "a reaction joint has RJointID, six flags, and since OpenFAST 2.4 the name of an SSI file in quotes";
            return Err(row.wrong_count("7", hint));
        }
    }
    Ok(support)
}

/// Reads the file of soil stiffness, if there is one and a flag is 0.
fn soil(
    row: &Row<'_>,
    support: &mut FrameSupport,
    source: &Source,
    files: &dyn FileResolver,
    reactions: &mut Reactions,
) -> Result<(), ReadError> {
    // What follows one number without flags, or begins with an exclamation mark, is a comment.
    let token = row.get(SOIL_FILE).filter(|_| row.numbers() >= SOIL_FILE);
    let is_name = |text: &str| !text.trim().is_empty() && !text.starts_with(['!', '-', '#', '[']);
    let token = token.filter(|token| token.is_quoted || !token.is_number());
    let Some(token) = token.filter(|token| is_name(token.text)) else {
        return Ok(());
    };
    if support.is_clamped() {
        let message = format!(
            "the SSI file \"{}\" is not read, as in SubDyn: all six flags are 1, so the joint is held; a flag of 0 lets the soil act",
            token.text
        );
        let note = Note::compatibility(message).at(source, token.span.start);
        reactions.notes.push(note);
        return Ok(());
    }
    let file = files.read(token.text).map_err(|error| {
        let kind = DiagnosticKind::unreadable("SSIfile", &error);
        let hint = "files are looked for in the folder of the SubDyn file; \"\" is for no file";
        ReadError::mistake(source, token.wrong(kind).with_hint(hint))
    })?;
    read_soil(&file, support).map_err(|mistake| ReadError::mistake(&file, mistake))?;
    reactions.sources.push(file);
    Ok(())
}

/// The joints of the transition piece: 1 or 7 columns, or 2 or 8 with the number of the transition
/// piece, since OpenFAST 5.
pub(super) fn interfaces(rows: &[Row<'_>], joints: &Ids) -> Result<Vec<usize>, Diagnostic> {
    let mut pieces = Vec::new();
    let mut found = Vec::new();
    for row in rows {
        let joint = joints.find(row, 0, "IJointID")?;
        let (piece, flags) = match row.numbers() {
            1 => (None, None),
            2 => (Some(1), None),
            7 => (None, Some(1)),
            8.. => (Some(1), Some(2)),
            _ => {
                let hint = "an interface joint has IJointID and six flags, since OpenFAST 5 with TPID between them";
                return Err(row.wrong_count("7 or 8", hint));
            }
        };
        if let Some(column) = piece {
            let number = row.integer(column, "TPID")?;
            if !pieces.is_empty() && !pieces.contains(&number) {
                return Err(several(row, column, &pieces, number));
            }
            pieces.push(number);
        }
        if let Some(first) = flags {
            check_flags(row, first)?;
        }
        if found.contains(&joint) {
            let what = "the interface joint".to_owned();
            return Err(row.wrong(0, DiagnosticKind::Repeated { what, times: 2 }));
        }
        found.push(joint);
    }
    Ok(found)
}

fn several(row: &Row<'_>, column: usize, pieces: &[i64], number: i64) -> Diagnostic {
    let message = format!(
        "there is more than one transition piece (TPID {} and {number}): only one can be solved",
        pieces[0]
    );
    row.wrong(column, DiagnosticKind::Unsupported(message))
        .with_hint("give all interface joints the same TPID")
}

fn check_flags(row: &Row<'_>, first: usize) -> Result<(), Diagnostic> {
    for (k, name) in INTERFACES.iter().enumerate() {
        if !row.flag(first + k, name)? {
            let message = format!(
                "{name} is 0, but an interface joint must follow the transition piece in all motions, as in SubDyn"
            );
            let mistake = row.wrong(first + k, DiagnosticKind::Unsupported(message));
            return Err(
                mistake.with_hint("write 1; a joint with a free motion needs a pin or a spring")
            );
        }
    }
    Ok(())
}
