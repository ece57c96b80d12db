//! The structural files of HAWC2, `…_st.dat`: tables of section properties along a body.
//!
//! `#1 name` begins a set, `$1 20 name` a subset of 20 rows of 19 columns, which follow
//! immediately; lines before a `$` are free text. Format and meaning of the columns: *How 2 HAWC2,
//! the user's manual* (DTU), "Format definition of the structural data file", and the class
//! `StFile` of wetb.
//!
//! HAWC2's y axis is downwind, x lies sideways and z points down. A tower is modelled in these
//! axes, so I_x, about the sideways axis, resists fore-aft bending; a fore-aft force acts along y,
//! so k_y is its shear factor; and r_x is the gyration of fore-aft rotation.

mod layout;
mod notes;
mod row;
mod rows;
mod sections;

use towermodes::{Place, TowerDescription};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{FileFormat, ReadOptions, TowerInput};
use crate::places::TABLE;
use crate::source::Source;
use layout::Layout;
use row::Row;

/// Reads a tower from a structural file of HAWC2: the first subset of the first set, or the subset
/// [`ReadOptions::hawc2_subset`].
///
/// r is measured from the tower base, which is at [`ReadOptions::tower_base_m`]; the base is
/// clamped, and there is no RNA.
///
/// # Errors
/// [`ReadError::Mistakes`].
pub fn read_hawc2(source: Source, options: &ReadOptions) -> Result<TowerInput, ReadError> {
    match read(&source, options) {
        Ok(input) => Ok(TowerInput {
            sources: vec![source],
            ..input
        }),
        Err(mistakes) => Err(ReadError::mistakes(&source, mistakes)),
    }
}

/// The tower, without its sources yet.
fn read(source: &Source, options: &ReadOptions) -> Result<TowerInput, Vec<Diagnostic>> {
    if !is_hawc2(&source.text, &source.name) {
        return Err(vec![not_hawc2()]);
    }
    let layout = Layout::of(&source.text).map_err(|mistake| vec![mistake])?;
    let subset = layout
        .choose(options.hawc2_subset)
        .map_err(|mistake| vec![mistake])?;
    let table = rows::read_rows(subset)?;
    let (properties, found) = sections::sections(&table.rows, options.tower_base_m.unwrap_or(0.0))?;
    let description = TowerDescription {
        name: layout.name_of(subset).to_owned(),
        properties,
        ..TowerDescription::default()
    };
    let mut input = TowerInput::new(FileFormat::Hawc2, description, Vec::new());
    remember(&mut input, &table.rows, subset.span.clone());
    input.notes = notes::notes(source, &layout, subset, &table, &found, options);
    Ok(input)
}

/// Stores the places of the rows for the checks of the whole tower.
fn remember(input: &mut TowerInput, rows: &[Row<'_>], subset: std::ops::Range<usize>) {
    input.places.remember(Place::Stations, 0, subset);
    for (index, row) in rows.iter().enumerate() {
        let at = |key| Place::Station { index, key };
        input.places.remember(at(TABLE), 0, row.line.span());
        input.places.remember(at("height"), 0, row.span(row::R));
    }
}

fn not_hawc2() -> Diagnostic {
    let found = "not a structural file of HAWC2: no line begins with `#` and the number of a set"
        .to_owned();
    Diagnostic::new(0..0, DiagnosticKind::WrongFile { found }).with_hint(
        "such a file has lines `#1 name` and `$1 20 name` followed by 20 rows of 19 columns",
    )
}

/// Whether a text is a structural file of HAWC2: a line `#1 …` and then a line `$1 20 …`; if the
/// file is called `…_st.dat`, the first line is enough, so that the error for a truncated file
/// names the missing part.
pub(crate) fn is_hawc2(text: &str, name: &str) -> bool {
    let (sets, subsets) = layout::headers(text);
    let lower = name.to_ascii_lowercase();
    let is_called_so = lower.ends_with("_st.dat") || lower.ends_with(".st");
    sets && (subsets || is_called_so)
}

#[cfg(test)]
mod tests {
    use super::is_hawc2;

    #[test]
    fn a_structural_file_is_known_by_its_headers() {
        assert!(is_hawc2("#1 Tower\nr m\n$1 20 Flexible\n", "x.dat"));
        assert!(is_hawc2("1 sets\n---\n#1\n$1 2\n", "x.dat"));
        assert!(is_hawc2("#1 Tower\nr m\n", "Tower_st.dat"));
        assert!(!is_hawc2("#1 Soil\nlateral\n10 2\n", "Soil.dat"));
        assert!(!is_hawc2("# a comment\n[tower]\n", "x_st.dat"));
        assert!(!is_hawc2("#1 costs\n$5 a piece\n", "x.toml"));
        assert!(!is_hawc2("$1 20\n#1\n", "x.dat"));
        assert!(!is_hawc2("", ""));
    }
}
