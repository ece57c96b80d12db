//! The table of points of MoorDyn: anchors, fairleads, free points, points on bodies.

use std::ops::Range;

use towermodes::mooring::{Attachment, MooringPoint};

use super::attachment::{Hold, hold, index};
use super::column::Column;
use super::row::Row;
use super::tables::Rows;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

pub(super) const ID: Column = Column::new(
    "ID",
    &[
        "id", "node", "point", "pointid", "conn", "connid", "number", "num",
    ],
    0,
);
pub(super) const TYPE: Column = Column::new(
    "Attachment",
    &["attachment", "type", "attach", "pointtype"],
    1,
);
pub(super) const X: Column = Column::new("X", &["x"], 2);
pub(super) const Y: Column = Column::new("Y", &["y"], 3);
pub(super) const Z: Column = Column::new("Z", &["z"], 4);
pub(super) const MASS: Column = Column::new("M", &["m", "mass"], 5);
pub(super) const VOLUME: Column = Column::new("V", &["v", "vol", "volume", "b"], 6);
pub(super) const FORCES: [Column; 3] = [
    Column::ordered("FX", &["fx"], [None, Some(7), Some(7)]),
    Column::ordered("FY", &["fy"], [None, Some(8), Some(8)]),
    Column::ordered("FZ", &["fz"], [None, Some(9), Some(9)]),
];

/// The columns that a point must have.
pub(super) const NEEDED: [Column; 5] = [ID, TYPE, X, Y, Z];
/// All columns that are read.
pub(super) const READ: [Column; 10] = [
    ID, TYPE, X, Y, Z, MASS, VOLUME, FORCES[0], FORCES[1], FORCES[2],
];

/// A point with its place in the file.
#[derive(Debug, Clone)]
pub(super) struct ReadPoint {
    pub(super) point: MooringPoint,
    /// Whether a word instead of its height places it on the seabed.
    pub(super) is_on_seabed: bool,
    pub(super) span: Range<usize>,
}

/// Reads the table; `bodies` is the number of bodies.
pub(super) fn points(table: &Rows<'_>, bodies: usize) -> Result<Vec<ReadPoint>, Diagnostic> {
    let rows = table.rows.iter().enumerate();
    rows.map(|(k, row)| point(row, k, bodies)).collect()
}

fn point(row: &Row<'_>, k: usize, bodies: usize) -> Result<ReadPoint, Diagnostic> {
    row.check_id(&ID, k)?;
    let attachment = match hold(row, &TYPE)? {
        Hold::Fixed => Attachment::Fixed,
        Hold::Platform => Attachment::Platform,
        Hold::Free => Attachment::Free,
        Hold::Body(body) => Attachment::Body(index(row, &TYPE, "body", body, bodies)?),
    };
    for force in FORCES {
        no_force(row, &force)?;
    }
    let z = row.token(&Z)?;
    let words = z.text.to_ascii_lowercase();
    let is_on_seabed = ["seabed", "ground", "floor", "depth"]
        .iter()
        .any(|w| words.contains(w));
    let z_m = if is_on_seabed { 0.0 } else { row.number(&Z)? };
    Ok(ReadPoint {
        point: MooringPoint {
            attachment,
            position_m: [row.number(&X)?, row.number(&Y)?, z_m],
            mass_kg: row.number_or_0(&MASS)?,
            volume_m3: row.number_or_0(&VOLUME)?,
        },
        is_on_seabed,
        span: row.span(),
    })
}

/// Refuses an external force on a point.
fn no_force(row: &Row<'_>, column: &Column) -> Result<(), Diagnostic> {
    let force = row.number_or_0(column)?;
    if force == 0.0 {
        return Ok(());
    }
    let message = format!(
        "{} is {}: external forces on points are not modelled",
        row.what(column),
        crate::diagnostic::Exact(force)
    );
    let token = row.token(column)?;
    Err(token
        .wrong(DiagnosticKind::Unsupported(message))
        .with_hint("write 0; a constant vertical force can be given as a mass or a volume"))
}
