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
    /// Acceleration of gravity that the `.fst` file gives, m/s².
    pub(super) gravity_m_per_s2: Option<f64>,
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
            gravity_m_per_s2: None,
            notes,
        });
    }
    let mistake = |mistake| InputError::mistake(&source, mistake);
    let parameter = ed_file(&source).map_err(mistake)?;
    let gravity_m_per_s2 = gravity(&source).map_err(mistake)?;
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
        gravity_m_per_s2,
        notes,
    })
}

/// The acceleration of gravity, which `.fst` files have since OpenFAST 3.0.
fn gravity(source: &Source) -> Result<Option<f64>, Diagnostic> {
    let Some(line) = line_of(&source.text, &plain("Gravity")) else {
        return Ok(None);
    };
    let parameter = Parameter::of(&line, "Gravity", "acceleration of gravity, m/s2")?;
    parameter.not_negative().map(Some)
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
    let mut notes: Vec<Note> = beamdyn(source).into_iter().collect();
    notes.extend(MODULES.iter().filter_map(|module| left_out(source, module)));
    notes
}

/// That the blades are not those of ElastoDyn.
fn beamdyn(source: &Source) -> Option<Note> {
    let (value, at) = switch(source, "CompElast")?;
    (value == 2).then(|| {
        let message = "CompElast is 2: the blades are those of BeamDyn, but the masses are taken from ElastoDyn's blade files";
        Note::at(source, at, message)
    })
}

/// A part of OpenFAST that holds, surrounds or loads the foot of a tower.
struct Module {
    /// The switch that turns it on.
    switch: &'static str,
    /// The name of the line with its file, in OpenFAST and in FAST 8.
    files: &'static [&'static str],
    /// What is left out with it, with its verb.
    what: &'static str,
}

/// Those whose files are not read.
const MODULES: [Module; 5] = [
    Module {
        switch: "CompHydro",
        files: &["HydroFile", "HDFile"],
        what: "the water's mass and stiffness are",
    },
    Module {
        switch: "CompSub",
        files: &["SubFile", "SDFile"],
        what: "the substructure is",
    },
    Module {
        switch: "CompMooring",
        files: &["MooringFile"],
        what: "the mooring lines are",
    },
    Module {
        switch: "CompMAP",
        files: &["MAPFile"],
        what: "the mooring lines are",
    },
    Module {
        switch: "CompSoil",
        files: &["SoilFile"],
        what: "the soil is",
    },
];

/// That a module is left out, if it is on.
fn left_out(source: &Source, module: &Module) -> Option<Note> {
    let (value, at) = switch(source, module.switch)?;
    if value == 0 {
        return None;
    }
    let mut files = module.files.iter();
    let file = files.find_map(|name| line_of(&source.text, &plain(name))?.first());
    let file = file.map_or_else(String::new, |token| format!(" ({})", token.text));
    let message = format!(
        "{} is on, and its file{file} is not read: {} left out",
        module.switch, module.what
    );
    Some(Note::at(source, at, message).of_missing_part())
}

/// The value of a switch, a number or, in the first versions, true or false; and where it stands.
fn switch(source: &Source, name: &str) -> Option<(i64, usize)> {
    let token = line_of(&source.text, &plain(name))?.first()?;
    let value = match token.integer(name) {
        Ok(value) => value,
        Err(_) => i64::from(token.logical(name).ok()?),
    };
    Some((value, token.span.start))
}
