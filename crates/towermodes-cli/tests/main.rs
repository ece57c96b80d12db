//! All tests of the program.

mod book;
mod coupled;
mod explore;
mod files;
mod formats;
mod found;
mod outputs;
mod page;
mod pages;
mod peers;
mod pictures;
mod plot;
mod program;
mod reports;
mod rotors;
mod sandbox;
mod settings;
mod several;
mod sweeps;
mod terminal;
mod texts;
