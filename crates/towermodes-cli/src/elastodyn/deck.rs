//! A deck of ElastoDyn with the tower that its modes are taken from.

use std::path::Path;

use towermodes::{Method, Options, Planes, Tower};
use towermodes_analysis::elastodyn::{
    PointMasses, Rows, TowerModel, TowerShapes, TowerStation, tower_rows, tower_shapes,
};
use towermodes_files::elastodyn::{ElastoDynDeck, MakeError, read_elastodyn, torsion_notes};
use towermodes_files::{Beside, FileFormat, InputError, Note, ReadOptions, Source, TowerInput};

use crate::args::{DeckArguments, ReadingArguments};
use crate::failure::{Failure, note};
use crate::input::input_of;

/// Towers whose mass or flexibility differ by more than this are not one.
const OTHER: f64 = 0.05;
/// … and by more than this it is worth a word.
const UNLIKE: f64 = 0.005;

/// A deck and the shapes that its tower has.
pub(super) struct Judged {
    pub(super) deck: ElastoDynDeck,
    pub(super) tower: Tower,
    /// Height at which the flexible tower begins, m.
    pub(super) from_m: f64,
    pub(super) shapes: TowerShapes,
}

/// Reads a deck and finds the shapes of its tower, or of the description that was given instead.
pub(super) fn judged(arguments: &DeckArguments) -> Result<Judged, Failure> {
    let deck = read_deck(arguments)?;
    let (tower, notes) = match &arguments.from {
        Some(from) => of_description(from, &arguments.reading)?,
        None => {
            let checked = arguments.reading.check(&[FileFormat::ElastoDyn]);
            checked.map_err(Failure::Usage)?;
            let tower = deck.input.tower_for_shapes().map_err(Failure::Input)?;
            (tower, notes_for_shapes(&deck.input))
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
    let shapes = shapes.map_err(|error| Failure::TowerFile(MakeError::Shapes(error)))?;
    note(&torsion_notes(&shapes));
    Ok(Judged {
        deck,
        tower,
        from_m,
        shapes,
    })
}

fn of_description(from: &Path, reading: &ReadingArguments) -> Result<(Tower, Vec<Note>), Failure> {
    let input = input_of(from, reading)?;
    let checked = reading.check(&[FileFormat::ElastoDyn, input.format]);
    checked.map_err(Failure::Usage)?;
    let tower = input.tower_for_shapes().map_err(Failure::Input)?;
    Ok((tower, notes_for_shapes(&input)))
}

/// What the user should know of a description whose modes become shapes.
pub(super) fn notes_for_shapes(input: &TowerInput) -> Vec<Note> {
    let mut notes = input.notes.clone();
    notes.extend(input.note_on_shapes());
    notes
}

/// The deck; where the modes come from another description, files of its machine need not be there.
fn read_deck(arguments: &DeckArguments) -> Result<ElastoDynDeck, Failure> {
    let own = arguments.reading.options();
    let options = ReadOptions {
        without_rna: own.without_rna || arguments.from.is_some(),
        ..own
    };
    let source = Source::from_path(&arguments.deck)
        .map_err(InputError::from)
        .map_err(Failure::Input)?;
    let beside = Beside::file(&arguments.deck);
    read_elastodyn(source, &beside, &options).map_err(Failure::Input)
}

/// Where the deck's flexible tower begins in another description, m, if that is of the same tower:
/// measured from the top, as heights may have another datum.
fn flexible_base(deck: &ElastoDynDeck, tower: &Tower, from: &Path) -> Result<f64, Failure> {
    let length_m = deck.main.tower_length_m();
    let from_m = tower.top_m() - length_m;
    let name = from.display();
    // Heights are printed in millimetres.
    if from_m < tower.base_m() - 1e-3 {
        return Err(Failure::Refused(format!(
            "{name} is not the deck's tower: it is {:.3} m high, and the flexible tower of the deck {length_m:.3} m",
            tower.height_m()
        )));
    }
    let from_m = from_m.max(tower.base_m());
    let likeness = model(deck).likeness(&model_of(tower, from_m)?);
    let differences = format!(
        "its mass differs by {:+.2} %, its flexibility by {:+.2} % fore-aft and {:+.2} % side-side",
        100.0 * likeness.mass,
        100.0 * likeness.flexibility.fore_aft,
        100.0 * likeness.flexibility.side_side
    );
    if likeness.largest() > OTHER {
        let text = format!("{name} is not the deck's tower: {differences}");
        return Err(Failure::Refused(text));
    }
    if likeness.largest() > UNLIKE {
        note(&[Note::new(format!(
            "{name} is not quite the deck's tower: {differences}"
        ))]);
    }
    Ok(from_m)
}

fn model(deck: &ElastoDynDeck) -> TowerModel {
    deck.tower
        .model(deck.main.tower_length_m(), deck.main.tower_nodes, 0.0)
}

fn model_of(tower: &Tower, from_m: f64) -> Result<TowerModel, Failure> {
    let rows = tower_rows(tower, from_m, Rows::Accurate, PointMasses::Listed);
    let rows = rows.map_err(|error| Failure::TowerFile(MakeError::Rows(error)))?;
    let stations: Vec<TowerStation> = rows.stations;
    Ok(TowerModel {
        flexible_length_m: tower.top_m() - from_m,
        stations,
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        // A mass at the very base does not swing, and may be counted with what is below.
        concentrated_masses: rows
            .concentrated_masses
            .into_iter()
            .filter(|mass| mass.height_fraction > 1e-9)
            .collect(),
        ..TowerModel::default()
    })
}
