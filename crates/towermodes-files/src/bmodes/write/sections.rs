//! The section file, with as many rows as linear interpolation needs.

use towermodes::Tower;
use towermodes::number::Rounded;

use super::super::records::parameters::COLUMNS;
use super::super::results::out::one_line;
use super::layout::Layout;
use super::number::{number, rounded};
use super::section::{DeckSection, MadeUp, deck_section};
use crate::note::Note;

/// Between rows the interpolation may differ from the tower by this fraction.
const OFF: f64 = 1e-5;
/// Distance of the rows on both sides of a step, as a fraction of the length, as in published decks
/// (0.27881 and 0.27882): BModes uses the first interval that contains the middle of an element,
/// and no element has its middle in such a short interval.
pub(super) const STEP: f64 = 1e-7;
/// Shorter parts of the length are not divided.
const SHORTEST: f64 = 1e-5;
/// If the values on both sides of a height differ by at most this rounding error, one row is
/// written.
const ROUNDING: f64 = 1e-11;
/// A difference of rotary inertia and half the polar inertia above this fraction gives a note.
const ROTARY_OFF: f64 = 1e-6;

/// A row: its position as a fraction of the length, and the section there.
pub(super) type Row = (f64, DeckSection);

/// All rows from the base to the top.
pub(super) fn rows(tower: &Tower, layout: &Layout, notes: &mut Vec<Note>) -> Vec<Row> {
    let mut made_up = MadeUp::default();
    let mut rows: Vec<Row> = Vec::new();
    for (from_m, to_m) in layout.intervals_m() {
        let middle_m = 0.5 * (from_m + to_m);
        let piece = tower.piece_at(middle_m);
        let spread = layout.spread_at(middle_m);
        let mut at = |height: f64| {
            let height_m = layout.base_m + height * layout.length_m();
            deck_section(piece, height_m, spread, &mut made_up)
        };
        let (from, to) = (layout.fraction(from_m), layout.fraction(to_m));
        let (first, last) = (at(from), at(to));
        match rows.last() {
            Some((_, before)) if before.is_near(&first, ROUNDING) => {}
            Some(_) => rows.push((from + STEP, first)),
            None => rows.push((from, first)),
        }
        divide((from, first), (to, last), &mut at, &mut rows);
        rows.push((to, last));
    }
    note_sections(&made_up, notes);
    rows
}

/// Adds the rows between two rows that linear interpolation needs.
fn divide(from: Row, to: Row, at: &mut impl FnMut(f64) -> DeckSection, rows: &mut Vec<Row>) {
    if to.0 - from.0 < SHORTEST {
        return;
    }
    let is_off = [0.25, 0.5, 0.75].into_iter().any(|s| {
        let section = at(from.0 + s * (to.0 - from.0));
        !from.1.between(&to.1, s).is_near(&section, OFF)
    });
    if is_off {
        let middle = 0.5 * (from.0 + to.0);
        let section = at(middle);
        divide(from, (middle, section), at, rows);
        rows.push((middle, section));
        divide((middle, section), to, at, rows);
    }
}

fn note_sections(made_up: &MadeUp, notes: &mut Vec<Note>) {
    let mut note = |message: String| notes.push(Note::approximation(message));
    if made_up.twist {
        note("the tower is rigid in torsion, which BModes does not support: GJ is written as 10000 EI".into());
    }
    if made_up.stretch {
        note(
            "the tower is axially rigid, which BModes does not support: EA is written as 10000 EI per m2"
                .into(),
        );
    }
    if made_up.polar_inertia {
        note(
            "BModes needs polar inertia: the polar inertia of a thin steel tube of the same EI is written"
                .into(),
        );
    }
    if made_up.rotary_off > ROTARY_OFF {
        note(format!(
            "the rotary inertia differs from half the polar inertia by up to {} %: a deck holds only the polar inertia, as BModes has no rotary \
             inertia in bending",
            Rounded(100.0 * made_up.rotary_off)
        ));
    }
}

/// The text of the file.
pub(super) fn text(title: &str, rows: &[Row]) -> String {
    let mut cells = vec![
        COLUMNS.map(|(name, _)| name.to_owned()),
        COLUMNS.map(|(_, unit)| unit.to_owned()),
    ];
    cells.extend(rows.iter().map(cells_of));
    let widths: [usize; 13] =
        std::array::from_fn(|i| cells.iter().map(|row| row[i].len()).max().unwrap_or(0));
    let mut text = format!("Sections of {}\n", name_or(title, "a tower"));
    text.push_str(&format!(
        "{:<8} n_secs: number of sections (-)\n\n",
        rows.len()
    ));
    for row in &cells {
        let padded = row
            .iter()
            .zip(widths)
            .map(|(cell, width)| format!("{cell:<width$}"));
        let line = padded.collect::<Vec<_>>().join("  ");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// A title on one line, or a default.
pub(super) fn name_or(title: &str, without: &str) -> String {
    let title = one_line(title);
    match title.trim() {
        "" => without.into(),
        title => title.into(),
    }
}

fn cells_of((height, section): &Row) -> [String; 13] {
    let zero = || number(0.0);
    let DeckSection {
        mass_kg_per_m,
        flp_iner_kg_m,
        bending_n_m2,
        torsion_n_m2,
        axial_n,
    } = *section;
    [
        location(*height),
        zero(),
        zero(),
        number(rounded(mass_kg_per_m)),
        number(rounded(flp_iner_kg_m)),
        number(rounded(flp_iner_kg_m)),
        number(rounded(bending_n_m2)),
        number(rounded(bending_n_m2)),
        number(rounded(torsion_n_m2)),
        number(rounded(axial_n)),
        zero(),
        zero(),
        zero(),
    ]
}

/// A fraction of the length with twelve decimals.
fn location(height: f64) -> String {
    let text = format!("{height:.12}");
    let short = text.trim_end_matches('0');
    if short.ends_with('.') {
        format!("{short}0")
    } else {
        short.into()
    }
}
