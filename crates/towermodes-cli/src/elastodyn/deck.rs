//! A deck of ElastoDyn with the tower that its modes are taken from.

use std::path::Path;

use towermodes::elastodyn::{TowerShapes, tower_shapes};
use towermodes::{Method, Options, Tower};
use towermodes_files::elastodyn::{ElastoDynDeck, MakeError, read_elastodyn};
use towermodes_files::{Beside, InputError, Source};

use crate::args::DeckArguments;
use crate::failure::{Failure, note};
use crate::input::tower_of;

/// A deck and the shapes that its tower has.
pub(super) struct Judged {
    pub(super) deck: ElastoDynDeck,
    pub(super) tower: Tower,
    pub(super) shapes: TowerShapes,
}

/// Reads a deck and finds the shapes of its tower, or of the description that was given instead.
pub(super) fn judged(arguments: &DeckArguments) -> Result<Judged, Failure> {
    let reading = &arguments.reading;
    let options = reading.options();
    let source = Source::from_path(&arguments.deck)
        .map_err(InputError::from)
        .map_err(Failure::Input)?;
    let beside = Beside::file(&arguments.deck);
    let deck = read_elastodyn(source, &beside, &options).map_err(Failure::Input)?;
    note(&deck.input.notes);
    let tower = match &arguments.from {
        Some(from) => of_description(from, arguments)?,
        None => deck.input.tower().map_err(Failure::Input)?,
    };
    let solve = Options {
        method: Method::Spectral,
        ..Options::default()
    };
    // The same part of the tower that the file is of, measured from its top.
    let flexible_m = deck.main.tower_top_m - deck.main.tower_base_m;
    let from_m = (tower.top_m() - flexible_m).max(tower.base_m());
    let shapes = tower_shapes(&tower, &solve, from_m);
    let shapes = shapes.map_err(|error| Failure::TowerFile(MakeError::Shapes(error)))?;
    Ok(Judged {
        deck,
        tower,
        shapes,
    })
}

fn of_description(from: &Path, arguments: &DeckArguments) -> Result<Tower, Failure> {
    let (tower, notes) = tower_of(from, &arguments.reading)?;
    note(&notes);
    Ok(tower)
}
