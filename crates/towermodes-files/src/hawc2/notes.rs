//! Notes on the parts of a HAWC2 file that were read, and on those that were not.

use super::layout::{Layout, Subset};
use super::row::{self, Row};
use super::rows::Table;
use super::sections::Found;
use crate::input::ReadOptions;
use crate::note::Note;
use crate::number::Rounded;
use crate::records::Lines;
use crate::source::Source;

/// A modulus above this value, Pa, is larger than that of any material and means that the body is
/// intended to be rigid.
const STIFFEST_PA: f64 = 1e13;
/// Largest number of subsets that are listed; the others are only counted.
const LISTED: usize = 8;

/// All notes on a file that was read.
pub(super) fn notes(
    source: &Source,
    layout: &Layout<'_>,
    subset: &Subset<'_>,
    table: &Table<'_>,
    found: &Found,
    options: &ReadOptions,
) -> Vec<Note> {
    let at = |start: usize, note: Note| note.at(source, start);
    let start = subset.span.start;
    let mut notes = Vec::new();
    if layout.subsets.len() > 1 {
        notes.push(at(start, Note::assumption(which(layout, subset))));
    }
    if let Some((line, count)) = &table.unread {
        notes.push(at(line.start, Note::left_out(unread(subset, *count))));
    }
    notes.extend(rigid(&table.rows).map(|message| at(start, Note::suspicious(message))));
    notes.push(at(start, Note::new(shear(found.shears))));
    for (row, message) in left_out(&table.rows, found) {
        notes.push(at(table.rows[row].line.start, Note::left_out(message)));
    }
    if !found.has_gyration {
        let message =
            "the radii of gyration are 0: the tower has no rotary inertia and is rigid in torsion";
        notes.push(at(start, Note::assumption(message)));
    }
    notes.extend(direction(&table.rows).map(|message| at(start, Note::suspicious(message))));
    notes.push(Note::missing_part(ends(&table.rows, options)));
    notes
}

fn unread(subset: &Subset<'_>, count: usize) -> String {
    format!(
        "{count} rows after the {} rows that {} announces are not read, as in HAWC2",
        subset.announced,
        subset.label()
    )
}

/// The text on the subset that was read, and on the others.
fn which(layout: &Layout<'_>, taken: &Subset<'_>) -> String {
    let is_other = |subset: &&Subset<'_>| subset.span != taken.span;
    let others = layout.subsets.iter().filter(is_other);
    let listed: Vec<String> = others.clone().take(LISTED).map(described).collect();
    let more = match others.count() - listed.len() {
        0 => String::new(),
        more => format!("; and {more} more"),
    };
    let (taken, listed) = (described(taken), listed.join("; "));
    format!("{taken} is read; not read: {listed}{more}")
}

/// A subset with its name and the moduli of its first row.
fn described(subset: &Subset<'_>) -> String {
    let mut parts = Vec::new();
    if !subset.name.is_empty() {
        parts.push(subset.name.chars().take(60).collect());
    }
    if let Some(row) = first_row(subset.after.clone()) {
        parts.push(format!(
            "E {} Pa, G {} Pa",
            Rounded(row.of(row::YOUNG)),
            Rounded(row.of(row::SHEAR_MODULUS))
        ));
    }
    match parts.is_empty() {
        true => subset.label(),
        false => format!("{} ({})", subset.label(), parts.join("; ")),
    }
}

fn first_row(mut lines: Lines<'_>) -> Option<Row<'_>> {
    Row::parse(lines.find(|line| !line.is_blank())?).ok()
}

/// The note on a body that is intended to be rigid.
fn rigid(rows: &[Row<'_>]) -> Option<String> {
    let largest = |column: usize| rows.iter().map(|row| row.of(column)).fold(0.0, f64::max);
    let (e, g) = (largest(row::YOUNG), largest(row::SHEAR_MODULUS));
    let what = match (e > STIFFEST_PA, g > STIFFEST_PA) {
        (true, _) => "the body is intended to be rigid, so its frequencies have no meaning",
        (false, true) => "torsion and shear are intended to be rigid",
        (false, false) => return None,
    };
    let (e, g) = (Rounded(e), Rounded(g));
    Some(format!("E = {e} Pa and G = {g} Pa: {what}"))
}

fn shear(shears: bool) -> String {
    if shears {
        "sections deform in shear with the stiffness k G A, as in the Timoshenko beams of HAWC2; ElastoDyn and BModes have no shear deformation".to_owned()
    } else {
        "the shear factors k_x and k_y are 0: there is no shear deformation".to_owned()
    }
}

/// The notes on offsets and rotated axes, with their rows.
fn left_out(rows: &[Row<'_>], found: &Found) -> Vec<(usize, String)> {
    let mut notes = Vec::new();
    if let Some((index, column, fraction)) = found.offset {
        let (name, unit) = row::name_and_unit(column);
        let value = Rounded(rows[index].of(column));
        let percent = 100.0 * fraction;
        notes.push((
            index,
            format!(
                "offsets of centres from the axis are ignored; the largest is {name} = {value}{unit}, {percent:.2} % of the tube's radius"
            ),
        ));
    }
    if let Some(index) = found.turned {
        let message = "the rotation of the principal axes is ignored: it couples the bending planes by less than 1 %";
        notes.push((index, message.to_owned()));
    }
    notes
}

/// The note on a tower that becomes stiffer upwards: its rows may run from the top down.
fn direction(rows: &[Row<'_>]) -> Option<String> {
    let stiffness = |row: &Row<'_>| row.of(row::YOUNG) * row.of(row::SECOND_MOMENT[0]);
    let (first, last) = (rows.first()?, rows.last()?);
    let (base, top) = (stiffness(first), stiffness(last));
    (top > 1.01 * base).then(|| {
        format!(
            "r is assumed to run upwards from the base, but EI is {base:.4e} N m2 at r = {} m and {top:.4e} N m2 at r = {} m; \
             if the body runs downwards, the tower is upside down here",
            Rounded(first.of(row::R)),
            Rounded(last.of(row::R))
        )
    })
}

/// The text on the heights of the tower, which the file does not contain.
fn ends(rows: &[Row<'_>], options: &ReadOptions) -> String {
    let base_m = options.tower_base_m.unwrap_or(0.0);
    let of = |row: Option<&Row<'_>>| base_m + row.map_or(0.0, |row| row.of(row::R));
    let (base_m, top_m) = (of(rows.first()), of(rows.last()));
    let mut text = format!(
        "a HAWC2 structural file has no RNA, no foundation and no datum: the tower extends from {} m, where it is clamped, to {} m \
         and has no RNA",
        Rounded(base_m),
        Rounded(top_m)
    );
    if let Some(height_m) = options.tower_height_m.filter(|h| (h - top_m).abs() > 1e-3) {
        text.push_str(&format!(
            "; a top at {} m, as requested, needs a base at {} m",
            Rounded(height_m),
            Rounded(height_m - (top_m - base_m))
        ));
    }
    text
}
