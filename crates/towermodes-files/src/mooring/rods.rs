//! The tables of rods of MoorDyn: their types and their positions.

use towermodes::mooring::MooringRod;

use super::attachment::carrier;
use super::column::Column;
use super::row::Row;
use super::tables::Rows;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::note::Note;
use crate::source::Source;

const TYPE_NAME: Column = Column::new("TypeName", &["typename", "name", "rodtype", "type"], 0);
const DIAMETER: Column = Column::new("Diam", &["diam", "diameter", "d"], 1);
const MASS: Column = Column::new("Mass/m", &["massm", "massden", "massdeninair", "mass"], 2);
/// The columns of the types that are read.
pub(super) const TYPES_READ: [Column; 3] = [TYPE_NAME, DIAMETER, MASS];

const ID: Column = Column::new("ID", &["id", "rod", "rodid"], 0);
const TYPE: Column = Column::new("RodType", &["rodtype", "type", "typename"], 1);
const HOLDER: Column = Column::new("Attachment", &["attachment", "attach", "typebodyid"], 2);
const ENDS: [[Column; 3]; 2] = [
    [
        Column::new("Xa", &["xa"], 3),
        Column::new("Ya", &["ya"], 4),
        Column::new("Za", &["za"], 5),
    ],
    [
        Column::new("Xb", &["xb"], 6),
        Column::new("Yb", &["yb"], 7),
        Column::new("Zb", &["zb"], 8),
    ],
];
const SEGMENTS: Column = Column::new("NumSegs", &["numsegs", "numseg", "nseg", "n"], 9);
/// The columns of the rods that are read.
pub(super) const READ: [Column; 10] = [
    ID, TYPE, HOLDER, ENDS[0][0], ENDS[0][1], ENDS[0][2], ENDS[1][0], ENDS[1][1], ENDS[1][2],
    SEGMENTS,
];

/// The rods, and notes on them.
#[derive(Debug, Default)]
pub(super) struct Rods {
    pub(super) rods: Vec<MooringRod>,
    pub(super) notes: Vec<Note>,
}

/// Reads the tables.
pub(super) fn rods(
    types: Option<&Rows<'_>>,
    table: &Rows<'_>,
    source: &Source,
) -> Result<Rods, Diagnostic> {
    let types = types.map_or(&[][..], |types| &types.rows);
    let mut found = Rods::default();
    for (k, row) in table.rows.iter().enumerate() {
        row.check_id(&ID, k)?;
        let kind = rod_type(row, types)?;
        found.rods.push(MooringRod {
            carrier: carrier(row, &HOLDER)?,
            ends_m: [row.numbers(&ENDS[0])?, row.numbers(&ENDS[1])?],
            diameter_m: kind.number(&DIAMETER)?,
            mass_kg_per_m: kind.number(&MASS)?,
        });
        if row
            .get(&SEGMENTS)
            .is_some_and(|n| n.number("").is_ok_and(|n| n == 0.0))
        {
            let message = "NumSegs of the rod is 0, with which MoorDyn neglects length and weight of a rod; here the rod has the length between its ends, with weight and buoyancy";
            found
                .notes
                .push(Note::compatibility(message).at(source, row.span().start));
        }
    }
    Ok(found)
}

/// The row of the type of a rod.
fn rod_type<'t, 'a>(row: &Row<'_>, types: &'t [Row<'a>]) -> Result<&'t Row<'a>, Diagnostic> {
    let token = row.token(&TYPE)?;
    let is_it = |kind: &&Row<'a>| {
        kind.get(&TYPE_NAME)
            .is_some_and(|name| name.text == token.text)
    };
    types.iter().find(is_it).ok_or_else(|| {
        let name = token.text.chars().take(40).collect();
        let names = types.iter().filter_map(|kind| kind.get(&TYPE_NAME));
        let names: Vec<String> = names.take(10).map(|name| quoted(name.text)).collect();
        let kind = DiagnosticKind::UnknownName {
            what: "rod type",
            name,
        };
        token.wrong(kind).with_hint(match names.is_empty() {
            true => "the file has no table ROD TYPES".to_owned(),
            false => format!("the file has {}", names.join(", ")),
        })
    })
}
