//! The `.fst` file of OpenFAST: the name of the main file of ElastoDyn, gravity, and the modules.

use towermodes::MissingPart;
use towermodes::tower::STANDARD_GRAVITY_M_PER_S2;

use super::main_input::main_file::MainFile;
use super::names::{is_fst, is_main_file, is_named, line_of};
use super::positional::Parameter;
use super::record::{Kind, NON_NEGATIVE, Record, record};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::records::{Lines, Token};
use crate::resolver::{FileResolver, folder_of, found_elsewhere};
use crate::source::Source;

const GRAVITY: Record = record("Gravity", "acceleration of gravity, m/s2", NON_NEGATIVE);
const ED_FILE: Record = record("EDFile", "name of the main file of ElastoDyn", Kind::Other);

/// A main file of ElastoDyn, and the way in which it was found.
#[derive(Debug)]
pub(super) struct Main {
    /// The main file.
    pub(super) source: Source,
    /// The `.fst` file that refers to it, if this was given.
    pub(super) fst: Option<Source>,
    /// The folder of the main file, relative to the given file; empty if it is the same.
    pub(super) folder: String,
    /// Acceleration of gravity that the `.fst` file gives, m/s².
    pub(super) gravity_m_per_s2: Option<f64>,
    pub(super) notes: Vec<Note>,
    /// The note on the blades of a turbine, if they are those of BeamDyn.
    pub(super) beamdyn_note: Option<Note>,
}

/// The main file itself, or the one that an `.fst` file names.
pub(super) fn main_source(source: Source, files: &dyn FileResolver) -> Result<Main, ReadError> {
    if !is_main_file(&source.text) && is_fst(&source.text) {
        return named_by(source, files);
    }
    Ok(Main {
        source,
        fst: None,
        folder: String::new(),
        gravity_m_per_s2: None,
        notes: Vec::new(),
        beamdyn_note: None,
    })
}

/// The main file that an `.fst` file names.
fn named_by(fst: Source, files: &dyn FileResolver) -> Result<Main, ReadError> {
    let mistake = |mistake| ReadError::mistake(&fst, mistake);
    check_rotors(&fst).map_err(mistake)?;
    let parameter = ed_file(&fst).map_err(mistake)?;
    let gravity_m_per_s2 = gravity_of_fst(&fst).map_err(mistake)?;
    let path = parameter.token.text.trim();
    let source = files.read(path).map_err(|error| {
        let kind = DiagnosticKind::unreadable("EDFile", &error);
        let hint = "files are looked for in the folder of the .fst file";
        mistake(Diagnostic::new(parameter.span(), kind).with_hint(hint))
    })?;
    let elsewhere = found_elsewhere(files, "EDFile", path, &source);
    let elsewhere = elsewhere.map(|note| note.at(&fst, parameter.span().start));
    let notes = elsewhere.into_iter().chain(beamdyn(&fst));
    Ok(Main {
        folder: folder_of(path, &source).to_owned(),
        source,
        gravity_m_per_s2,
        notes: notes.chain(in_current(&fst)).collect(),
        beamdyn_note: blades_of_beamdyn(&fst),
        fst: Some(fst),
    })
}

/// The acceleration of gravity in an `.fst` file, since OpenFAST 3.0.
pub(super) fn gravity_of_fst(source: &Source) -> Result<Option<f64>, Diagnostic> {
    let Some(line) = line_of(&source.text, "Gravity") else {
        return Ok(None);
    };
    Parameter::of(&line, &GRAVITY)?.number().map(Some)
}

/// The line that names the main file of ElastoDyn.
fn ed_file(source: &Source) -> Result<Parameter<'_>, Diagnostic> {
    let missing = || Diagnostic::new(0..0, DiagnosticKind::missing_key("the .fst file", "EDFile"));
    let line = line_of(&source.text, "EDFile").ok_or_else(missing)?;
    let parameter = Parameter::of(&line, &ED_FILE)?;
    parameter.file()?;
    Ok(parameter)
}

/// The notes on modules that complete the model of ElastoDyn and are not among the parts that were
/// read. The main file tells whether a platform moves.
pub(super) fn notes(
    source: &Source,
    main: &MainFile,
    read: &[MissingPart],
    is_clamped: bool,
) -> Vec<Note> {
    let mut notes: Vec<Note> = Vec::new();
    let mut named: Vec<MissingPart> = read.to_vec();
    for module in &MODULES {
        // The sea is part of the water.
        if !named.contains(&module.part)
            && let Some(note) = left_out(source, module, || {
                why_not_read(source, main, module, is_clamped)
            })
        {
            named.push(module.part);
            notes.push(note);
        }
    }
    notes
}

/// Refuses a model with several rotors (OpenFAST 5), whose other towers have separate files.
fn check_rotors(source: &Source) -> Result<(), Diagnostic> {
    let Some((rotors, at)) = switch(source, "NRotors") else {
        return Ok(());
    };
    if rotors <= 1 {
        return Ok(());
    }
    let message = format!("NRotors is {rotors}: a model with more than one rotor is not solved");
    let kind = DiagnosticKind::Unsupported(message);
    let hint =
        "give the main file of ElastoDyn of one rotor (EDFile) for its tower, clamped at its base";
    let end = at + rotors.to_string().len();
    Err(Diagnostic::new(at..end, kind).with_hint(hint))
}

/// The note that the turbine is in water, which acts not only on the platform.
fn in_current(source: &Source) -> Option<Note> {
    let (value, at) = switch(source, "MHK")?;
    (value > 0).then(|| {
        let message = format!(
            "MHK is {value}, so the turbine is in water: the added mass and the buoyancy of tower, nacelle and blades, which AeroDyn has, are left out, and the frequencies of the tower are too high"
        );
        Note::missing_part(message).at(source, at)
    })
}

/// The note that weight and buoyancy of a fixed turbine under water are omitted, if the turbine is
/// in water.
pub(super) fn under_water(source: &Source) -> Option<Note> {
    let (value, at) = switch(source, "MHK").filter(|(value, _)| *value > 0)?;
    let message = format!(
        "MHK is {value}, so the turbine is in water: its weight and its buoyancy, which act against each other, are both left out of the stiffness"
    );
    Some(Note::approximation(message).at(source, at))
}

/// The note that the blades of the simulation are not those of ElastoDyn.
fn beamdyn(source: &Source) -> Option<Note> {
    let (value, at) = switch(source, "CompElast")?;
    (value == 2).then(|| {
        let message = "CompElast is 2, so the blades are defined in BeamDyn, but their masses are taken from ElastoDyn's blade files";
        Note::approximation(message).at(source, at)
    })
}

/// The note that the blades of the turbine with rotating rotor are not those of the simulation.
fn blades_of_beamdyn(source: &Source) -> Option<Note> {
    let (value, at) = switch(source, "CompElast")?;
    (value == 2).then(|| {
        let message = "CompElast is 2, so the blades are defined in BeamDyn, but the blades of the operating turbine are taken from ElastoDyn's blade files";
        Note::approximation(message).at(source, at)
    })
}

/// A module of OpenFAST that supports or loads the base of a tower.
struct Module {
    /// The switch that turns it on.
    switch: &'static str,
    /// The name of the line with its file, in OpenFAST and in FAST 8.
    files: &'static [&'static str],
    /// The part that it models, with its verb.
    what: &'static str,
    /// The same component as a missing part of the structure.
    part: MissingPart,
    /// Values of the switch for programs whose files are not read.
    other_programs: &'static [(i64, &'static str)],
}

/// The modules whose files are not read.
const MODULES: [Module; 6] = [
    Module {
        switch: "CompHydro",
        files: &["HydroFile", "HDFile"],
        what: "the mass and stiffness of the water are",
        part: MissingPart::Water,
        other_programs: &[],
    },
    Module {
        switch: "CompSeaSt",
        files: &["SeaStFile"],
        what: "the sea is",
        part: MissingPart::Water,
        other_programs: &[],
    },
    Module {
        switch: "CompSub",
        files: &["SubFile", "SDFile"],
        what: "the substructure is",
        part: MissingPart::Substructure,
        other_programs: &[(2, "ExtPtfm, which is not modelled; SubDyn is 1")],
    },
    Module {
        switch: "CompMooring",
        files: &["MooringFile"],
        what: "the mooring lines are",
        part: MissingPart::MooringLines,
        other_programs: &[
            (
                2,
                "FEAMooring, which is not modelled; MAP++ is 1, MoorDyn 3",
            ),
            (4, "OrcaFlex, which is not modelled; MAP++ is 1, MoorDyn 3"),
        ],
    },
    Module {
        switch: "CompMAP",
        files: &["MAPFile"],
        what: "the mooring lines are",
        part: MissingPart::MooringLines,
        other_programs: &[],
    },
    Module {
        switch: "CompSoil",
        files: &["SoilFile"],
        what: "the soil is",
        part: MissingPart::Soil,
        other_programs: &[],
    },
];

/// The parts whose modules are switched on and that were not read, each once.
pub(super) fn missing_parts(source: &Source, read: &[MissingPart]) -> Vec<MissingPart> {
    let is_on = |module: &&Module| {
        let is_read = read.contains(&module.part);
        !is_read && is_on(source, module.switch)
    };
    let mut parts: Vec<MissingPart> = MODULES.iter().filter(is_on).map(|of| of.part).collect();
    parts.sort_unstable();
    parts.dedup();
    parts
}

/// The note that a module is omitted, if it is switched on.
fn left_out(source: &Source, module: &Module, why: impl Fn() -> String) -> Option<Note> {
    let (value, at) = switch(source, module.switch)?;
    if value < 1 {
        return None;
    }
    let file = module.file(source);
    let file = file.map_or_else(String::new, |name| format!(" ({name})"));
    let message = format!(
        "{} is switched on, but its file{file} is not read{}: {} left out",
        module.switch,
        why(),
        module.what
    );
    Some(Note::missing_part(message).at(source, at))
}

impl Module {
    /// The name of its file.
    fn file(&self, source: &Source) -> Option<String> {
        let mut names = self.files.iter();
        let token = names.find_map(|name| line_of(&source.text, name)?.first())?;
        Some(token.text.to_owned())
    }
}

/// Why the file of a module that is switched on is not read, after a comma.
fn why_not_read(source: &Source, main: &MainFile, module: &Module, is_clamped: bool) -> String {
    let value = switch(source, module.switch).map_or(0, |(value, _)| value);
    let has_substructure = matches!(switch(source, "CompSub"), Some((1, _)));
    let others = module.other_programs.iter();
    let other = others.clone().find(|(number, _)| *number == value);
    let reason = if is_clamped {
        "because of --clamped"
    } else if let Some((_, program)) = other {
        return format!(", because {} {value} is {program}", module.switch);
    } else if module.file(source).is_none() {
        "because the .fst file does not name it"
    } else if module.part == MissingPart::Soil && !has_substructure {
        "because CompSub is 0"
    } else if has_substructure {
        "because the substructure stands on the ground"
    } else if !main.platform_dofs.contains(&true) {
        "because CompSub is 0 and no motion of the platform is switched on (PtfmSgDOF to PtfmYDOF)"
    } else if !is_on(source, "CompHydro") {
        "because CompHydro is 0, and without water the platform has no buoyancy"
    } else {
        return String::new();
    };
    format!(", {reason}")
}

/// Whether a switch exists and is on.
pub(super) fn is_on(source: &Source, name: &str) -> bool {
    matches!(switch(source, name), Some((1.., _)))
}

/// The value of a switch (a number or, in the first versions, true or false) and its byte.
pub(super) fn switch(source: &Source, name: &str) -> Option<(i64, usize)> {
    let lines = Lines::new(&source.text).filter(|line| is_named(line, name));
    let value = |token: &Token<'_>| token.integer(name).ok();
    let flag = |token: &Token<'_>| token.logical(name).ok().map(i64::from);
    let first = |value: &dyn Fn(&Token<'_>) -> Option<i64>| {
        lines.clone().find_map(|line| {
            let token = line.first()?;
            Some((value(&token)?, token.span.start))
        })
    };
    // A title may have the name behind a word that begins as a flag: "Floating MHK turbine".
    first(&value).or_else(|| first(&flag))
}

/// The acceleration of gravity, and a note on its source.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Gravity {
    /// Acceleration, m/s².
    pub(super) m_per_s2: f64,
    pub(super) note: Option<Note>,
}

/// The gravity of a model: from the `.fst` file, as in OpenFAST since 3.0, otherwise from the main
/// file, as in earlier versions, otherwise standard gravity with a note. For a tower that hangs
/// under water it is omitted. Files are given by their names, a `.fst` file with its value if it
/// has one.
pub(super) fn gravity(
    main: &MainFile,
    main_name: &str,
    fst: Option<(Option<f64>, &str)>,
) -> Gravity {
    if main.tower_hangs() {
        let (m_per_s2, note) = (0.0, None);
        return Gravity { m_per_s2, note };
    }
    let (m_per_s2, message) = match (fst, main.gravity_m_per_s2) {
        (Some((Some(of_fst), name)), Some(of_main)) if of_fst != of_main => {
            let message = format!(
                "Gravity is {of_fst} m/s2 in {name} and {of_main} m/s2 in {main_name}: the first is used"
            );
            (of_fst, Some(message))
        }
        (Some((Some(of_fst), _)), _) => (of_fst, None),
        (_, Some(of_main)) => (of_main, None),
        (Some((None, name)), None) => {
            let message = format!(
                "neither {name} nor {main_name} has Gravity: {STANDARD_GRAVITY_M_PER_S2} m/s2 is assumed (--no-gravity omits it)"
            );
            (STANDARD_GRAVITY_M_PER_S2, Some(message))
        }
        (None, None) => {
            let message = format!(
                "{main_name} has no Gravity, which is in the .fst file: {STANDARD_GRAVITY_M_PER_S2} m/s2 is assumed (--no-gravity omits it)"
            );
            (STANDARD_GRAVITY_M_PER_S2, Some(message))
        }
    };
    let note = message.map(Note::assumption);
    Gravity { m_per_s2, note }
}
