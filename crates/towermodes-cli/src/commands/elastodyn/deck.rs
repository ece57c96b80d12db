//! An ElastoDyn deck and the tower from which the modes are computed.

use std::path::Path;

use towermodes::{Method, Options, Tower};
use towermodes_analysis::elastodyn::{
    MakeError, OtherTower, TowerShapes, same_tower, tower_shapes,
};
use towermodes_files::elastodyn::{ElastoDynDeck, read_elastodyn, torsion_notes};
use towermodes_files::{
    FileFormat, Note, ReadError, ReadOptions, SiblingFiles, Source, TowerInput,
};

use super::arguments::DeckArguments;
use crate::args::ReadingArguments;
use crate::failure::Failure;
use crate::input::input_of;
use crate::messages::{note, warn};

/// A deck and the mode shapes of its tower.
pub(super) struct Judged {
    pub(super) deck: ElastoDynDeck,
    pub(super) tower: Tower,
    /// Height at which the flexible tower begins, m.
    pub(super) from_m: f64,
    pub(super) shapes: TowerShapes,
}

/// Reads a deck and computes the mode shapes of its tower, or of the file given by `--from`.
pub(super) fn judged(arguments: &DeckArguments) -> Result<Judged, Failure> {
    let deck = read_deck(arguments)?;
    let (tower, input, notes) = match &arguments.from {
        Some(from) => of_description(from, &arguments.reading)?,
        None => {
            if !arguments.reading.settings.is_empty() {
                return Err(Failure::usage(
                    "--set applies only to the file of --from; without --from the modes are computed from the deck",
                ));
            }
            arguments.reading.check(&[FileFormat::ElastoDyn])?;
            let tower = deck.input.tower_for_shapes()?;
            (tower, None, notes_for_shapes(&deck.input))
        }
    };
    note(&notes);
    let solve = Options {
        method: Method::Spectral,
        ..Options::default()
    };
    let from_m = match &arguments.from {
        Some(from) => flexible_base(&deck, &tower, from)?,
        None => tower.base_m(),
    };
    let shapes = tower_shapes(&tower, &solve, from_m);
    let shapes = shapes.map_err(|error| {
        warn(tower.warnings(), input.as_ref().unwrap_or(&deck.input));
        Failure::from(MakeError::Shapes(error))
    })?;
    note(&torsion_notes(&shapes));
    Ok(Judged {
        deck,
        tower,
        from_m,
        shapes,
    })
}

fn of_description(
    from: &Path,
    reading: &ReadingArguments,
) -> Result<(Tower, Option<TowerInput>, Vec<Note>), Failure> {
    let input = input_of(from, reading)?;
    reading.check(&[FileFormat::ElastoDyn, input.format])?;
    let tower = input.tower_for_shapes()?;
    let notes = notes_for_shapes(&input);
    Ok((tower, Some(input), notes))
}

/// The notes of an input for whose modes polynomials are fitted.
fn notes_for_shapes(input: &TowerInput) -> Vec<Note> {
    let mut notes = input.notes.clone();
    notes.extend(input.note_on_shapes());
    notes
}

/// The deck; with `--from`, its files of the RNA are not needed.
fn read_deck(arguments: &DeckArguments) -> Result<ElastoDynDeck, Failure> {
    let own = arguments.reading.options();
    let options = ReadOptions {
        without_rna: own.without_rna || arguments.from.is_some(),
        ..own
    };
    let source = Source::from_path(&arguments.deck).map_err(ReadError::from)?;
    let beside = SiblingFiles::of(&arguments.deck);
    read_elastodyn(source, &beside, &options).map_err(Failure::from)
}

/// The height in another description at which the flexible tower of the deck begins, m, if it
/// describes the same tower.
fn flexible_base(deck: &ElastoDynDeck, tower: &Tower, from: &Path) -> Result<f64, Failure> {
    let name = from.display();
    let model = deck
        .tower
        .model(deck.main.tower_length_m(), deck.main.tower_nodes, 0.0);
    let same = same_tower(&model, tower).map_err(|error| match error {
        OtherTower::Rows(error) => Failure::failed(error),
        error => Failure::failed(format!("{name} is not the tower of the deck: {error}")),
    })?;
    if same.is_noticeable() {
        note(&[Note::suspicious(format!(
            "{name} differs from the tower of the deck: {}",
            same.difference
        ))]);
    }
    Ok(same.from_m)
}
