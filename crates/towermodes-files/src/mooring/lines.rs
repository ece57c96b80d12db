//! The table of lines.

use towermodes::mooring::{Attachment, MooringLine, MooringPoint};

use super::attachment::{End, end, index};
use super::column::Column;
use super::line_types::LineTypes;
use super::row::Row;
use super::tables::Rows;
use crate::diagnostic::Diagnostic;

const ID: Column = Column::new("ID", &["id", "line", "lineid"], 0);
const TYPE: Column = Column::new("LineType", &["linetype", "type", "typename"], 1);
const LENGTH: Column = Column::ordered(
    "UnstrLen",
    &["unstrlen", "unstrlength", "length", "len"],
    [Some(4), Some(2), Some(2)],
);
const FIRST: Column = Column::ordered(
    "AttachA",
    &[
        "attacha",
        "nodeanch",
        "nodea",
        "enda",
        "pointa",
        "anch",
        "anchor",
        "attachanch",
    ],
    [Some(2), Some(4), Some(3)],
);
const SECOND: Column = Column::ordered(
    "AttachB",
    &[
        "attachb",
        "nodefair",
        "nodeb",
        "endb",
        "pointb",
        "fair",
        "fairlead",
        "attachfair",
    ],
    [Some(3), Some(5), Some(4)],
);
/// The flags of MAP++ for a line, in any number of words.
pub(super) const FLAGS: Column =
    Column::ordered("Flags", &["flags", "flag"], [None, None, Some(5)]);

/// The columns that a line must have.
pub(super) const NEEDED: [Column; 5] = [ID, TYPE, LENGTH, FIRST, SECOND];

/// Reads the table; points at the ends of rods are added.
pub(super) fn lines(
    table: &Rows<'_>,
    types: &LineTypes<'_>,
    rods: usize,
    points: &mut Vec<MooringPoint>,
) -> Result<Vec<MooringLine>, Diagnostic> {
    let count = points.len();
    let rows = table.rows.iter().enumerate();
    rows.map(|(k, row)| {
        row.check_id(&ID, k)?;
        let mut point = |column: &Column| match end(row, column)? {
            End::Point(number) => index(row, column, "point", number, count),
            End::Rod(number, end) => {
                let rod = index(row, column, "rod", number, rods)?;
                let attachment = Attachment::Rod(rod, end);
                points.push(MooringPoint::new(attachment, [0.0; 3]));
                Ok(points.len() - 1)
            }
        };
        Ok(MooringLine {
            points: [point(&FIRST)?, point(&SECOND)?],
            line_type: types.find(row, &TYPE)?,
            length_m: length_m(row)?,
        })
    })
    .collect()
}

/// The length of a line; MAP++ computes a length that begins with `#`.
fn length_m(row: &Row<'_>) -> Result<f64, Diagnostic> {
    let token = row.token(&LENGTH)?;
    if token.text.starts_with('#') {
        let message = format!(
            "{} is `#`, a length computed by MAP++: here lines need a given length",
            row.what(&LENGTH)
        );
        let hint = "write the length of the summary that MAP++ prints, in m";
        return Err(row.unsupported(&LENGTH, message).with_hint(hint));
    }
    row.number(&LENGTH)
}
