//! The table of chains and ropes.

use towermodes::mooring::LineType;

use super::column::Column;
use super::row::Row;
use super::tables::Rows;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::note::Note;
use crate::source::Source;

const NAME: Column = Column::new("Name", &["name", "linetype", "typename", "type"], 0);
const DIAMETER: Column = Column::new("Diam", &["diam", "diameter", "d"], 1);
const MASS: Column = Column::new(
    "MassDen",
    &[
        "massden",
        "massdeninair",
        "massm",
        "mass",
        "massperlength",
        "massdensity",
        "m",
        "w",
    ],
    2,
);
const STIFFNESS: Column = Column::new("EA", &["ea"], 3);
const FRICTION: Column = Column::ordered("CB", &["cb"], [None, None, Some(4)]);
const BENDING: Column = Column::ordered("EI", &["ei"], [Some(5), None, None]);

/// The columns that a line type must have.
pub(super) const NEEDED: [Column; 4] = [NAME, DIAMETER, MASS, STIFFNESS];
/// All columns that are read.
pub(super) const READ: [Column; 5] = [NAME, DIAMETER, MASS, STIFFNESS, FRICTION];

/// The line types with their names.
#[derive(Debug, Default)]
pub(super) struct LineTypes<'a> {
    names: Vec<&'a str>,
    pub(super) types: Vec<LineType>,
    pub(super) notes: Vec<Note>,
}

/// Reads the table.
pub(super) fn line_types<'a>(
    table: &Rows<'a>,
    source: &Source,
) -> Result<LineTypes<'a>, Diagnostic> {
    let mut found = LineTypes::default();
    for row in &table.rows {
        let name = row.token(&NAME)?;
        if found.names.contains(&name.text) {
            let what = format!("the line type {}", quoted(name.text));
            return Err(name.wrong(DiagnosticKind::Repeated { what, times: 2 }));
        }
        found.names.push(name.text);
        let stiffness_n = stiffness(row, source, &mut found.notes)?;
        let line_type = LineType {
            seabed_friction: row.number_or_0(&FRICTION)?,
            ..LineType::new(row.number(&DIAMETER)?, row.number(&MASS)?, stiffness_n)
        };
        found.types.push(line_type);
        if row
            .get(&BENDING)
            .is_some_and(|ei| ei.number("").is_ok_and(|ei| ei != 0.0))
        {
            let message = "the bending stiffness EI of the line is not used: lines are flexible";
            found
                .notes
                .push(Note::left_out(message).at(source, row.span().start));
        }
    }
    Ok(found)
}

/// EA: a number, or `static|dynamic` for ropes whose stiffness depends on the loading rate.
fn stiffness(row: &Row<'_>, source: &Source, notes: &mut Vec<Note>) -> Result<f64, Diagnostic> {
    let token = row.token(&STIFFNESS)?;
    let values = row.bars(&STIFFNESS);
    match values {
        Ok(values) if values.len() == 1 => Ok(values[0]),
        Ok(values) if values.len() <= 3 => {
            let message = format!(
                "EA of the line is {}: the first value is used, which is the stiffness for slow changes of the tension",
                quoted(token.text)
            );
            notes.push(Note::assumption(message).at(source, token.span.start));
            Ok(values[0])
        }
        Ok(values) => {
            let kind = DiagnosticKind::wrong_count(row.what(&STIFFNESS), values.len(), "1 to 3");
            Err(token.wrong(kind))
        }
        Err(_) if is_file_name(token.text) => {
            let message = format!(
                "EA of the line is {}: tables of tension over strain are not modelled",
                quoted(token.text)
            );
            let hint = "give the stiffness EA in N, the slope of the table at the tension at rest";
            Err(row.unsupported(&STIFFNESS, message).with_hint(hint))
        }
        Err(mistake) => Err(mistake),
    }
}

/// Whether a value that should be a number is the name of a file: it begins with a letter, a point
/// or a slash.
fn is_file_name(text: &str) -> bool {
    let first = text.chars().next();
    let is_number_word = ["nan", "inf"]
        .iter()
        .any(|word| text.eq_ignore_ascii_case(word));
    !is_number_word
        && first.is_some_and(|c| c.is_alphabetic() || "./\\\"'".contains(c))
        && text.len() > 1
}

impl LineTypes<'_> {
    /// The note on types that float where others do not: the buoyancy modules of a line, which are
    /// not a mistake in the unit of the masses.
    pub(super) fn buoyant(
        &self,
        table: &Rows<'_>,
        source: &Source,
        density_kg_per_m3: f64,
    ) -> Option<Note> {
        let floats = |of: &LineType| of.floats_in(density_kg_per_m3);
        let first = self.types.iter().position(floats)?;
        if self.types.iter().all(floats) {
            return None;
        }
        let buoyant = self.names.iter().zip(&self.types);
        let buoyant = buoyant.filter(|(_, of)| floats(of));
        let names: Vec<String> = buoyant.map(|(name, _)| quoted(name)).collect();
        let message = format!(
            "these line types are lighter than the water that they displace, so they lift the lines of the other types: {}",
            names.join(", ")
        );
        Some(Note::new(message).at(source, table.rows[first].span().start))
    }

    /// The index of the type whose name is in a column.
    pub(super) fn find(&self, row: &Row<'_>, column: &Column) -> Result<usize, Diagnostic> {
        let token = row.token(column)?;
        let found = self.names.iter().position(|name| *name == token.text);
        found.ok_or_else(|| {
            let name = token.text.chars().take(40).collect();
            let what = "line type";
            let known: Vec<String> = self.names.iter().take(10).map(|n| quoted(n)).collect();
            token
                .wrong(DiagnosticKind::UnknownName { what, name })
                .with_hint(format!("the file has {}", known.join(", ")))
        })
    }
}
