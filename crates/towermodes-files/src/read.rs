//! Reads any file that describes a tower or a blade, in any format.

use std::path::Path;

use towermodes::number::Plain;
use towermodes::{Tower, TowerDescription};

use crate::bmodes::{BmodesInput, read_bmodes};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::elastodyn::{read_elastodyn, read_elastodyn_tower};
use crate::error::ReadError;
use crate::hawc2::read_hawc2;
use crate::input::{BladeInput, FileFormat, ReadOptions, RotorLock, TowerInput};
use crate::mooring::{MooringInput, MooringSite, read_map, read_moordyn};
use crate::note::Note;
use crate::recognize::{recognize, unknown_file};
use crate::resolver::{FileResolver, SiblingFiles};
use crate::source::Source;
use crate::subdyn::{SubdynInput, read_subdyn};
use crate::toml::read_toml;
use crate::turbine::as_rigid_body;
use crate::windio::read_windio;

/// The note that there is no rotor-nacelle assembly to omit.
pub const NOTHING_LEFT_OUT: &str = "the file has no rotor-nacelle assembly: --no-rna has no effect";

/// The object that a file describes.
#[derive(Debug, Clone)]
pub enum Input {
    /// A tower.
    Tower(Box<TowerInput>),
    /// A rotating blade.
    Blade(Box<BladeInput>),
    /// A jacket, tripod or monopile without a tower.
    Substructure(Box<SubdynInput>),
    /// The mooring lines of a floater, without the floater.
    Mooring(Box<MooringInput>),
}

/// A tower that is ready to be solved, and the input from which it was made.
#[derive(Debug, Clone)]
pub struct Reading {
    /// The tower, checked.
    pub tower: Tower,
    /// Its description, the notes of the reader and the place of each value.
    pub input: TowerInput,
}

/// Reads the tower of a file on disk, with the files that it names. The format is recognized:
/// TOML, BModes, ElastoDyn, windIO or HAWC2.
///
/// # Errors
/// [`ReadError`]: the file cannot be read, has mistakes, or describes a blade.
///
/// # Example
/// ```no_run
/// let reading = towermodes_files::read_tower("monopile.toml")?;
/// for note in &reading.input.notes {
///     eprintln!("{note}");
/// }
/// let solution = towermodes::solve(&reading.tower, &towermodes::Options::default())?;
/// println!("{:.4} Hz", solution.modes[0].frequency_hz);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_tower(path: impl AsRef<Path>) -> Result<Reading, ReadError> {
    let source = Source::from_path(path.as_ref())?;
    let files = SiblingFiles::of(path.as_ref());
    match read_source(source.clone(), &files, &ReadOptions::default())? {
        Input::Tower(input) => input.check(),
        Input::Blade(_) => Err(ReadError::mistake(&source, wrong_file_of_blade())),
        Input::Substructure(_) => Err(ReadError::mistake(&source, wrong_file_of_substructure())),
        Input::Mooring(_) => Err(ReadError::mistake(&source, wrong_file_of_mooring())),
    }
}

fn wrong_file_of_blade() -> Diagnostic {
    let found = "a deck of a rotating blade, not of a tower".to_owned();
    Diagnostic::new(0..0, DiagnosticKind::WrongFile { found })
        .with_hint("beam_type = 2 is a tower; `read` reads blades too")
}

fn wrong_file_of_substructure() -> Diagnostic {
    let found = "a SubDyn file, which describes a substructure without a tower".to_owned();
    Diagnostic::new(0..0, DiagnosticKind::WrongFile { found })
        .with_hint("`read_subdyn` reads it; for the tower give the main file of ElastoDyn")
}

fn wrong_file_of_mooring() -> Diagnostic {
    let found =
        "a file of MoorDyn or MAP++, which describes mooring lines without a tower".to_owned();
    Diagnostic::new(0..0, DiagnosticKind::WrongFile { found }).with_hint(
        "`read_moordyn` and `read_map` read it; for the tower give the main file of ElastoDyn or the .fst file",
    )
}

impl TowerInput {
    /// Checks the description: the tower together with this input.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the place of a value that is impossible for a tower.
    pub fn check(self) -> Result<Reading, ReadError> {
        let tower = self.tower()?;
        Ok(Reading { tower, input: self })
    }
}

/// Reads a file from disk, with the files that it names.
///
/// # Errors
/// [`ReadError`].
pub fn read(path: &Path, options: &ReadOptions) -> Result<Input, ReadError> {
    read_source(Source::from_path(path)?, &SiblingFiles::of(path), options)
}

/// Reads a file whose text is given; `files` gives the files that it names.
///
/// # Errors
/// [`ReadError`].
pub fn read_source(
    source: Source,
    files: &dyn FileResolver,
    options: &ReadOptions,
) -> Result<Input, ReadError> {
    source.check_is_itself()?;
    let mut tower = match recognize(&source) {
        Some(FileFormat::Toml) => with_rotor(read_toml(source, files)?, options)?,
        Some(FileFormat::Bmodes) => match read_bmodes(source, files, options)? {
            BmodesInput::Tower(tower) => *tower,
            BmodesInput::Blade(blade) => return Ok(Input::Blade(blade)),
        },
        Some(FileFormat::ElastoDyn) => read_elastodyn(source, files, options)?.input,
        Some(FileFormat::ElastoDynTower) => read_elastodyn_tower(source, options)?,
        Some(FileFormat::WindIo) => read_windio(source, options)?,
        Some(FileFormat::Hawc2) => read_hawc2(source, options)?,
        Some(FileFormat::SubDyn) => {
            return Ok(Input::Substructure(Box::new(read_subdyn(source, files)?)));
        }
        Some(FileFormat::MoorDyn) => return mooring(read_moordyn(source, &MooringSite::default())),
        Some(FileFormat::Map) => return mooring(read_map(source, &MooringSite::default())),
        None => return Err(unknown_file(&source)),
    };
    if options.without_rna {
        remove_rna(&mut tower);
    }
    if options.without_gravity {
        check_stands(&tower)?;
        tower.description.gravity_m_per_s2 = 0.0;
    }
    if options.at_equilibrium {
        put_at_equilibrium(&mut tower)?;
    }
    Ok(Input::Tower(Box::new(tower)))
}

fn mooring(input: Result<MooringInput, ReadError>) -> Result<Input, ReadError> {
    input.map(|input| Input::Mooring(Box::new(input)))
}

/// Refuses to omit the gravity of a floating tower: buoyancy, the stiffness of the water plane and
/// the weight of the lines exist only with gravity, and without them the tower has no restoring
/// stiffness.
fn check_stands(tower: &TowerInput) -> Result<(), ReadError> {
    if tower.description.foundation.floating().is_none() {
        return Ok(());
    }
    let message = "a floating tower needs gravity: its buoyancy, the stiffness of its water plane and the weight of its mooring lines exist only with gravity";
    let kind = DiagnosticKind::Unsupported(message.to_owned());
    let hint = "omit --no-gravity (in Python: no_gravity), or use --clamped for the tower of an OpenFAST or windIO model alone";
    let mistake = Diagnostic::new(0..0, kind).with_hint(hint);
    Err(ReadError::mistakes(&tower.sources[0], vec![mistake]))
}

/// Changes the stiffness of mooring lines to that at the equilibrium.
fn put_at_equilibrium(tower: &mut TowerInput) -> Result<(), ReadError> {
    match tower.description.foundation.floating_mut() {
        Some(platform) if platform.mooring_lines.is_some() => {
            platform.at_equilibrium = true;
            Ok(())
        }
        _ => {
            let message = "there is no floating platform with mooring lines, whose stiffness could be computed at the equilibrium";
            let kind = DiagnosticKind::Unsupported(message.to_owned());
            let hint = "omit --equilibrium (in Python: equilibrium)";
            let mistake = Diagnostic::new(0..0, kind).with_hint(hint);
            Err(ReadError::mistakes(&tower.sources[0], vec![mistake]))
        }
    }
}

/// The tower of a tower file with free rotor, if the options request this.
fn with_rotor(mut tower: TowerInput, options: &ReadOptions) -> Result<TowerInput, ReadError> {
    if options.rotor == RotorLock::Locked || options.without_rna {
        return Ok(tower);
    }
    if tower.turbine.is_some() {
        return with_free_turbine(tower);
    }
    let Some(freed) = tower.description.with_free_rotor() else {
        let kind = DiagnosticKind::missing_key("the file", "drivetrain");
        let hint =
            "a free rotor needs [drivetrain] with rotor_inertia, generator_inertia and gear_ratio";
        let mistake = Diagnostic::new(0..0, kind).with_hint(hint);
        return Err(ReadError::mistakes(&tower.sources[0], vec![mistake]));
    };
    // The drivetrain is checked with the tower in which it is locked.
    tower.tower()?;
    let xx = |description: &TowerDescription| description.rna.inertia_kg_m2.xx;
    tower.notes.push(Note::new(format!(
        "the rotor rotates freely: the inertia xx of the RNA is {} kg m2 instead of {} kg m2",
        Plain(xx(&freed)),
        Plain(xx(&tower.description))
    )));
    tower.description = freed;
    Ok(tower)
}

/// The tower of a tower file with a turbine, with free rotor.
fn with_free_turbine(mut tower: TowerInput) -> Result<TowerInput, ReadError> {
    let Some(turbine) = &mut tower.turbine else {
        return Ok(tower);
    };
    turbine.generator.is_locked = false;
    match as_rigid_body(turbine, RotorLock::Free) {
        Ok(rna) => tower.description.rna = rna,
        Err(error) => {
            let kind = DiagnosticKind::Turbine(Box::new(error));
            let hint = "a free rotor needs generator_inertia in [turbine]";
            let mistake = Diagnostic::new(0..0, kind).with_hint(hint);
            return Err(ReadError::mistake(&tower.sources[0], mistake));
        }
    }
    let message = "the rotor rotates freely: rotor and generator of [turbine] do not roll with the nacelle about the shaft";
    tower.notes.push(Note::new(message));
    Ok(tower)
}

fn remove_rna(tower: &mut TowerInput) {
    let rna = std::mem::take(&mut tower.description.rna);
    tower.remove_turbine(None);
    // Readers of turbines leave the assembly out themselves.
    let is_tower_file = matches!(
        tower.format,
        FileFormat::Toml | FileFormat::Bmodes | FileFormat::ElastoDynTower | FileFormat::Hawc2
    );
    if is_tower_file && rna.is_absent() {
        tower.notes.push(Note::new(NOTHING_LEFT_OUT));
    }
}
