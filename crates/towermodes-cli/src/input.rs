//! Where towers come from.

use std::path::Path;

use towermodes::Tower;
use towermodes_files::{
    Input, ReadError, Reading, SiblingFiles, Source, TowerInput, read, read_source,
};

use crate::args::{InputArguments, ReadingArguments};
use crate::failure::Failure;

/// Reads what a file, or standard input, describes.
pub(crate) fn input(file: &Path, reading: &ReadingArguments) -> Result<Input, Failure> {
    let options = reading.options();
    let input = if file == Path::new("-") {
        Source::from_stdin()
            .map_err(ReadError::from)
            .and_then(|source| read_source(source, &SiblingFiles::of(file), &options))
    } else {
        read(file, &options)
    };
    input.map_err(Failure::Input)
}

/// Reads the tower of a file, or of standard input; a rotating blade is none.
pub(crate) fn tower_input(arguments: &InputArguments) -> Result<TowerInput, Failure> {
    let input = input_of(&arguments.file, &arguments.reading)?;
    let checked = arguments.reading.check(&[input.format]);
    checked.map_err(Failure::Usage)?;
    Ok(input)
}

/// The same of any path, whatever the options.
pub(crate) fn input_of(file: &Path, reading: &ReadingArguments) -> Result<TowerInput, Failure> {
    match input(file, reading)? {
        Input::Tower(tower) => Ok(*tower),
        Input::Blade(_) => Err(Failure::Usage(
            "this is a deck of a rotating blade; only solve reads these",
        )),
    }
}

/// The tower of a file, and what its reader made of it.
pub(crate) fn tower(arguments: &InputArguments) -> Result<(Tower, TowerInput), Failure> {
    let input = tower_input(arguments)?;
    let Reading { tower, input } = input.check().map_err(Failure::Input)?;
    Ok((tower, input))
}
