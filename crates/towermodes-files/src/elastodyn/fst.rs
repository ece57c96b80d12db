//! The `.fst` file of OpenFAST, as far as it leads to the main file of ElastoDyn.

use super::names::plain;
use super::positional::Parameter;
use super::recognise::{is_fst, is_main_file, line_of};
use crate::companions::Companions;
use crate::diagnostic::Diagnostic;
use crate::input::{InputError, Note};
use crate::source::Source;

/// A main file of ElastoDyn, and how it was found.
pub(super) struct Main {
    /// The main file.
    pub(super) source: Source,
    /// The `.fst` file that names it, if that was given.
    pub(super) fst: Option<Source>,
    /// The main file's folder as seen from the file that was given; empty if it is the same.
    pub(super) folder: String,
    pub(super) notes: Vec<Note>,
}

/// The main file itself, or the one that an `.fst` file names.
pub(super) fn main_source(source: Source, companions: &dyn Companions) -> Result<Main, InputError> {
    if is_main_file(&source.text) || !is_fst(&source.text) {
        let (fst, folder, notes) = (None, String::new(), Vec::new());
        return Ok(Main {
            source,
            fst,
            folder,
            notes,
        });
    }
    let parameter = match ed_file(&source) {
        Ok(parameter) => parameter,
        Err(mistake) => return Err(InputError::mistake(&source, mistake)),
    };
    let path = parameter.token.text.trim().to_owned();
    let main = companions.read(&path).map_err(|error| {
        let message = format!("EDFile cannot be read: {error}");
        let mistake = Diagnostic::new(parameter.span(), message);
        InputError::mistake(
            &source,
            mistake.with_hint("files are looked for beside the .fst file"),
        )
    })?;
    let folder = path
        .rfind(['/', '\\'])
        .map_or("", |slash| &path[..slash])
        .to_owned();
    let notes = notes(&source);
    Ok(Main {
        source: main,
        fst: Some(source),
        folder,
        notes,
    })
}

/// The line that names the main file of ElastoDyn.
fn ed_file(source: &Source) -> Result<Parameter<'_>, Diagnostic> {
    let missing = || Diagnostic::new(0..0, "the .fst file has no EDFile");
    let line = line_of(&source.text, &plain("EDFile")).ok_or_else(missing)?;
    let parameter = Parameter::of(&line, "EDFile", "name of the main file of ElastoDyn")?;
    parameter.file()?;
    Ok(parameter)
}

/// What the `.fst` file says that changes what ElastoDyn's files mean.
fn notes(source: &Source) -> Vec<Note> {
    let value = |name| {
        let token = line_of(&source.text, name)?.first()?;
        Some((token.number(name).ok()?, token.span.start))
    };
    match value("compelast") {
        Some((2.0, at)) => {
            let message = "CompElast is 2: the blades are those of BeamDyn, but the masses are taken from ElastoDyn's blade files";
            vec![Note::at(source, at, message)]
        }
        _ => Vec::new(),
    }
}
