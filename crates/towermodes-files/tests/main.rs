//! All tests of the readers and writers.

mod bmodes;
mod bmodes_errors;
mod bmodes_mutations;
mod bmodes_out;
mod bmodes_write;
mod bmodes_write_support;
mod damaged_files;
mod decks;
mod elastodyn;
mod elastodyn_formulas;
mod elastodyn_writer;
mod ground;
mod ground_refusals;
mod hawc2;
mod large_files;
mod mutations;
mod plausible_files;
mod refusals;
mod refused;
mod round_trips;
mod toml_write;
mod windio;
mod windio_files;
mod written_decks;
