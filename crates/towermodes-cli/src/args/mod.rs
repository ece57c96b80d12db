//! Groups of options that several commands share.

mod deferred;
mod ending;
mod found;
mod input;
mod output;
pub(crate) mod parsers;
mod picture;
mod rotor;
mod soil;
mod solver;
mod turbine;
pub(crate) mod words;

pub(crate) use deferred::Deferred;
pub(crate) use ending::{Ending, EndingError};
pub(crate) use found::FoundArguments;
pub(crate) use input::{InputArguments, ReadingArguments};
pub(crate) use output::{Destination, Format, TextFormat, csv_lines, file_of};
pub(crate) use picture::PictureFile;
pub(crate) use rotor::RotorArguments;
pub(crate) use soil::SoilArguments;
pub(crate) use solver::{ModelArguments, SolverArguments, up_to_excitations};
pub(crate) use turbine::TurbineArguments;
