//! The file of soil stiffness and mass of a reaction joint (SSI file): a value and its name on each
//! line, in any order.

use towermodes::frame::FrameSupport;

use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact, quoted};
use crate::records::{Lines, Token};
use crate::source::Source;

/// The motions in the names of entries: `Kxty` is the force in x for a rotation about y.
const MOTIONS: [&str; 6] = ["x", "y", "z", "tx", "ty", "tz"];

/// Due to rounding an entry may exceed the limit set by the diagonal entries by this factor.
const ROUNDED: f64 = 1.0 + 1e-6;

/// An entry of the file.
struct Entry<'a> {
    name: Token<'a>,
    is_stiffness: bool,
    row: usize,
    column: usize,
    value: f64,
}

/// Reads the entries into the matrices of a support; missing entries are 0.
///
/// # Errors
/// The first mistake in the file.
pub(super) fn read_soil(source: &Source, support: &mut FrameSupport) -> Result<(), Diagnostic> {
    let mut given: Vec<Entry<'_>> = Vec::new();
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
        let Some(entry) = entry_of(&name, number) else {
            return Err(unknown(&name));
        };
        if let Some(before) = given.iter().find(|before| before.is_same_as(&entry)) {
            return Err(entry.repeats(before, source));
        }
        if entry.row == entry.column && number < 0.0 {
            let kind = DiagnosticKind::out_of_range(entry.name.text, number, "0 or positive");
            return Err(value.wrong(kind));
        }
        given.push(entry);
    }
    // SubDyn knows entries on and above the diagonal only.
    if let Some(below) = given.iter().find(|entry| entry.row > entry.column) {
        return Err(unknown(&below.name));
    }
    for entry in &given {
        entry.check_size(&given, support, source)?;
        let matrix = match entry.is_stiffness {
            true => &mut support.stiffness,
            false => &mut support.inertia,
        };
        matrix[entry.row][entry.column] = entry.value;
        matrix[entry.column][entry.row] = entry.value;
    }
    Ok(())
}

/// The entry with a name, above or below the diagonal.
fn entry_of<'a>(name: &Token<'a>, value: f64) -> Option<Entry<'a>> {
    let (is_stiffness, row, column) = entry(&name.text.to_ascii_lowercase())?;
    Some(Entry {
        name: name.clone(),
        is_stiffness,
        row,
        column,
        value,
    })
}

/// The mistake of a name that SubDyn does not know.
fn unknown(name: &Token<'_>) -> Diagnostic {
    let kind = DiagnosticKind::UnknownName {
        what: "entry of the soil matrices",
        name: quoted(name.text).trim_matches('`').to_owned(),
    };
    let hint = "the names are Kxx, Kxy, Kyy, Kxz, … Ktztz and Mxx, … Mtztz: K or M and two of x, y, z, tx, ty, tz, the earlier one first";
    name.wrong(kind).with_hint(hint)
}

impl Entry<'_> {
    fn is_same_as(&self, other: &Self) -> bool {
        let entry = |of: &Self| {
            let (first, second) = (of.row.min(of.column), of.row.max(of.column));
            (of.is_stiffness, first, second)
        };
        entry(self) == entry(other)
    }

    /// The mistake of an entry that was given before.
    fn repeats(&self, before: &Self, source: &Source) -> Diagnostic {
        let hint = "the matrices are symmetric: give each entry once";
        let (own, other) = (self.name.text, before.name.text);
        if self.value == before.value || (self.row, self.column) == (before.row, before.column) {
            let what = format!("the entry {own}");
            let kind = DiagnosticKind::Repeated { what, times: 2 };
            return self.name.wrong(kind).with_hint(hint);
        }
        let message = format!(
            "{own} is {}, but {other} is {} in {}: the matrix must be symmetric",
            Exact(self.value),
            Exact(before.value),
            source.place(before.name.span.start)
        );
        let kind = DiagnosticKind::Contradiction(message);
        self.name.wrong(kind).with_hint(hint)
    }

    /// Refuses a stiffness that is larger than the diagonal entries allow, because some motion
    /// would have a negative stiffness. Motions that the support fixes are not checked; for masses
    /// there is no such check, because the mass of the structure is added.
    fn check_size(
        &self,
        given: &[Self],
        support: &FrameSupport,
        source: &Source,
    ) -> Result<(), Diagnostic> {
        let (row, column) = (self.row, self.column);
        if !self.is_stiffness || row == column || support.fixed[row] || support.fixed[column] {
            return Ok(());
        }
        let on_diagonal = |i: usize| {
            let mut entries = given.iter();
            entries.find(|of| of.is_stiffness && (of.row, of.column) == (i, i))
        };
        let [first, second] = [row, column].map(on_diagonal);
        let size = |entry: Option<&Self>| entry.map_or(0.0, |entry| entry.value);
        if self.value * self.value <= size(first) * size(second) * ROUNDED {
            return Ok(());
        }
        let described = |entry: Option<&Self>, i: usize| match entry {
            Some(entry) => format!(
                "{} is {} ({})",
                entry.name.text,
                Exact(entry.value),
                source.place(entry.name.span.start)
            ),
            None => format!("K{0}{0} is not given", MOTIONS[i]),
        };
        let message = format!(
            "{} is {}, but {} and {}: the square of an entry is at most the product of the two on the diagonal, or some motion has a negative stiffness",
            self.name.text,
            Exact(self.value),
            described(first, row),
            described(second, column)
        );
        Err(self.name.wrong(DiagnosticKind::Contradiction(message)))
    }
}

/// Whether an entry belongs to the stiffness, its row and its column.
fn entry(name: &str) -> Option<(bool, usize, usize)> {
    let (matrix, motions) = name.split_at_checked(1)?;
    let is_stiffness = match matrix {
        "k" => true,
        "m" => false,
        _ => return None,
    };
    let mut entries = (0..6).flat_map(|column| (0..6).map(move |row| (row, column)));
    let is_it = |(row, column): &(usize, usize)| {
        motions.strip_prefix(MOTIONS[*row]) == Some(MOTIONS[*column])
    };
    entries
        .find(is_it)
        .map(|(row, column)| (is_stiffness, row, column))
}
