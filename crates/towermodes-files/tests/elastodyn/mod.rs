//! ElastoDyn models: synthetic decks, the rules of OpenFAST with their lines, and public decks if
//! they are at hand.

mod assembly;
mod controller;
mod dampers;
mod decks;
mod doubts;
mod hanging;
mod hostile;
mod main_file;
mod public;
mod public_turbine;
mod rotor;
pub mod texts;
mod tower;
mod turbine;
