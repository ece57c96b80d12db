//! `file` of `[substructure]`: a file of SubDyn with joints and members.

use towermodes::frame::Transition;

use super::super::schema;
use super::super::text::reading::Reading;
use super::super::text::table::Table;
use super::super::text::values::{Value, text};
use super::{Read, reference};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::resolver::FileResolver;
use crate::source::{FileError, Source};
use crate::subdyn::{SubdynInput, read_subdyn};

/// The keys that may be given together with `file`.
const BESIDE: [&str; 6] = [
    "file",
    "reference",
    "platform",
    "weight_on_members",
    "buoyancy_on_members",
    "growth",
];

/// The content of the file that a tower file names.
pub(in crate::toml) fn subdyn_file(
    named: Option<Result<Source, FileError>>,
    files: Option<&dyn FileResolver>,
) -> Option<Result<SubdynInput, ReadError>> {
    let (named, files) = (named?, files?);
    Some(match named {
        Ok(source) => read_subdyn(source, files),
        Err(error) => Err(error.into()),
    })
}

/// The frame of the file.
pub(super) fn frame(table: &Table<'_>, path: &Value<'_>, reading: &mut Reading) -> Option<Read> {
    for key in schema::SUBSTRUCTURE.key_names() {
        if !BESIDE.contains(&key) {
            let hint = "the file has it: keep one of the two";
            table.refuse_unused(key, "together with `file`", hint, reading)?;
        }
    }
    text(path, "file", reading)?;
    let position_m = reference(table, reading);
    let mistake = |reason: &str| {
        let kind = DiagnosticKind::unreadable("the file of the substructure", &reason);
        Diagnostic::new(path.span(), kind)
    };
    let input = match reading.substructure_file.take() {
        None => {
            let hint = "write joints and members here";
            return reading
                .refuse(mistake("a text without a folder cannot refer to files").with_hint(hint));
        }
        Some(Ok(input)) => input,
        Some(Err(ReadError::Unreadable(error))) => {
            let hint =
                "it is looked for in the folder of the tower file; names may be case-sensitive";
            return reading.refuse(mistake(&error.to_string()).with_hint(hint));
        }
        Some(Err(ReadError::Mistakes {
            source_file,
            mistakes,
        })) => {
            reading.in_other_file = Some((*source_file, mistakes));
            return None;
        }
    };
    reading.substructure_places = input.places().collect();
    reading.substructure_notes.extend(input.notes);
    reading.substructure_sources = input.sources;
    let mut description = input.description;
    description.transition = Some(Transition {
        position_m: position_m?,
        joints: input.interface_joints,
        is_held: false,
    });
    Some(Read {
        description,
        ..Read::default()
    })
}
