//! The file of soil stiffness and mass of a reaction joint (SSI file): a value and its name on each
//! line, in any order.

use towermodes::frame::FrameSupport;

use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::Lines;
use crate::source::Source;

/// The motions in the names of entries: `Kxty` is the force in x for a rotation about y.
const MOTIONS: [&str; 6] = ["x", "y", "z", "tx", "ty", "tz"];

/// Reads the entries into the matrices of a support; entries that the file does not have are 0.
///
/// # Errors
/// The first mistake in the file.
pub(super) fn read_soil(source: &Source, support: &mut FrameSupport) -> Result<(), Diagnostic> {
    let mut given: Vec<String> = Vec::new();
    for line in Lines::new(&source.text) {
        let mut tokens = line.tokens();
        let Some(value) = tokens.next().filter(|token| !token.text.starts_with('!')) else {
            continue;
        };
        line.check_commas("an entry of the soil matrices")?;
        let number = value.number("an entry of the soil matrices")?;
        let Some(name) = tokens.next() else {
            let what = "the name of the entry, such as Kxx or Mxty,".to_owned();
            let kind = DiagnosticKind::Missing { what };
            return Err(Diagnostic::new(line.span(), kind));
        };
        let plain = name.text.to_ascii_lowercase();
        let Some((is_stiffness, row, column)) = entry(&plain) else {
            let kind = DiagnosticKind::UnknownName {
                what: "entry of the soil matrices",
                name: quoted(name.text).trim_matches('`').to_owned(),
            };
            let hint = "the names are Kxx, Kxy, Kyy, Kxz, … Ktztz and Mxx, … Mtztz: K or M and two of x, y, z, tx, ty, tz, the earlier one first";
            return Err(name.wrong(kind).with_hint(hint));
        };
        if given.contains(&plain) {
            let what = format!("the entry {}", name.text);
            let kind = DiagnosticKind::Repeated { what, times: 2 };
            return Err(name
                .wrong(kind)
                .with_hint("the matrices are symmetric: give each entry once"));
        }
        given.push(plain);
        let matrix = match is_stiffness {
            true => &mut support.stiffness,
            false => &mut support.inertia,
        };
        matrix[row][column] = number;
        matrix[column][row] = number;
    }
    Ok(())
}

/// Whether an entry is one of the stiffness, its row and its column.
fn entry(name: &str) -> Option<(bool, usize, usize)> {
    let (matrix, motions) = name.split_at_checked(1)?;
    let is_stiffness = match matrix {
        "k" => true,
        "m" => false,
        _ => return None,
    };
    let mut entries = (0..6).flat_map(|column| (0..=column).map(move |row| (row, column)));
    let is_it = |(row, column): &(usize, usize)| {
        motions.strip_prefix(MOTIONS[*row]) == Some(MOTIONS[*column])
    };
    entries
        .find(is_it)
        .map(|(row, column)| (is_stiffness, row, column))
}
