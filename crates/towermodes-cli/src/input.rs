//! Reading of the input files.

use std::path::Path;

use towermodes_files::{
    Input, ReadError, SettingError, SiblingFiles, Source, TowerInput, read, read_source,
};

use crate::args::{InputArguments, ReadingArguments};
use crate::failure::{Failure, SETTING};

/// Reads a tower or blade from a file or from standard input.
pub(crate) fn input(file: &Path, reading: &ReadingArguments) -> Result<Input, Failure> {
    let options = reading.options();
    let input = if file == Path::new("-") {
        Source::from_stdin()
            .map_err(ReadError::from)
            .and_then(|source| read_source(source, &SiblingFiles::of(file), &options))
    } else {
        read(file, &options)
    };
    let mut input = input?;
    // The command refuses settings of a blade.
    if let Input::Tower(tower) = &mut input {
        set_numbers(tower, reading)?;
    }
    Ok(input)
}

/// What has no names in a file with a turbine.
const OF_TURBINE: &str = "`towermodes parameters FILE` lists the names of all input values; nacelle, hub and blades of a turbine have no names: change them in the file that describes them, for example NacMass in the main file of ElastoDyn";

/// Sets the numbers that the command line gives by name.
pub(crate) fn set_numbers(
    tower: &mut TowerInput,
    reading: &ReadingArguments,
) -> Result<(), Failure> {
    let set = tower.set(&reading.settings, SETTING);
    let is_unknown = matches!(set, Err(SettingError::Parameter(_)));
    let failed = set.map_err(Failure::from);
    match is_unknown && tower.turbine.is_some() {
        true => failed.map_err(|failure| failure.hint(OF_TURBINE)),
        false => failed,
    }
}

/// Reads a tower from a file or from standard input; a rotating blade is an error.
pub(crate) fn tower_input(arguments: &InputArguments) -> Result<TowerInput, Failure> {
    let input = input_of(&arguments.file, &arguments.reading)?;
    arguments.reading.check(&[input.format])?;
    Ok(input)
}

/// Reads a tower from any path, without a check of the options.
pub(crate) fn input_of(file: &Path, reading: &ReadingArguments) -> Result<TowerInput, Failure> {
    match input(file, reading)? {
        Input::Tower(tower) => Ok(*tower),
        Input::Substructure(_) => Err(Failure::usage(
            "this is a SubDyn file, which describes a substructure without a tower; it can be used only with solve",
        )
        .hint("for the tower, give the main file of ElastoDyn or the .fst file")),
        Input::Mooring(_) => Err(Failure::usage(
            "this file describes mooring lines without a tower; it can be used only with solve",
        )
        .hint("for the tower, give the .fst file, which names the file of the mooring lines")),
        Input::Blade(_) => Err(Failure::usage(
            "this is a deck of a rotating blade; it can be used only with solve",
        )),
    }
}
