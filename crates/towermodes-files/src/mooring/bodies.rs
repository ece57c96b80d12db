//! The table of bodies of MoorDyn.

use towermodes::mooring::MooringBody;

use super::attachment::carrier;
use super::column::Column;
use super::row::Row;
use super::tables::Rows;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

const ID: Column = Column::new("ID", &["id", "body", "bodyid"], 0);
const TYPE: Column = Column::new("Attachment", &["attachment", "type", "attach"], 1);
const POSITION: [Column; 3] = [
    Column::new("X0", &["x0", "x"], 2),
    Column::new("Y0", &["y0", "y"], 3),
    Column::new("Z0", &["z0", "z"], 4),
];
const ANGLES: [Column; 3] = [
    Column::new("r0", &["r0", "roll"], 5),
    Column::new("p0", &["p0", "pitch"], 6),
    Column::new("y0", &["y02", "yaw"], 7),
];
const MASS: Column = Column::new("Mass", &["mass", "m"], 8);
const CENTER: Column = Column::new("CG", &["cg"], 9);
const INERTIA: Column = Column::new("I", &["i"], 10);
const VOLUME: Column = Column::new("Volume", &["volume", "vol", "v"], 11);
const DRAG: Column = Column::new("CdA", &["cda"], 12);
const ADDED: Column = Column::new("Ca", &["ca"], 13);

/// All columns.
pub(super) const READ: [Column; 14] = [
    ID,
    TYPE,
    POSITION[0],
    POSITION[1],
    POSITION[2],
    ANGLES[0],
    ANGLES[1],
    ANGLES[2],
    MASS,
    CENTER,
    INERTIA,
    VOLUME,
    DRAG,
    ADDED,
];

/// Reads the table.
pub(super) fn bodies(table: &Rows<'_>) -> Result<Vec<MooringBody>, Diagnostic> {
    let rows = table.rows.iter().enumerate();
    rows.map(|(k, row)| body(row, k)).collect()
}

fn body(row: &Row<'_>, k: usize) -> Result<MooringBody, Diagnostic> {
    row.check_id(&ID, k)?;
    check_added(row)?;
    Ok(MooringBody {
        carrier: carrier(row, &TYPE)?,
        position_m: row.numbers(&POSITION)?,
        angles_rad: row.numbers(&ANGLES)?.map(f64::to_radians),
        mass_kg: row.number(&MASS)?,
        center_m: one_or_three(row, &CENTER, |z_m| [0.0, 0.0, z_m])?,
        inertia_kg_m2: one_or_three(row, &INERTIA, |inertia| [inertia; 3])?,
        volume_m3: row.number(&VOLUME)?,
    })
}

/// Three numbers between bars, or one that applies to all three.
fn one_or_three(
    row: &Row<'_>,
    column: &Column,
    of_one: fn(f64) -> [f64; 3],
) -> Result<[f64; 3], Diagnostic> {
    match row.bars(column)?[..] {
        [one] => Ok(of_one(one)),
        [x, y, z] => Ok([x, y, z]),
        ref values => {
            let kind = DiagnosticKind::wrong_count(row.what(column), values.len(), "1 or 3");
            let hint = "write three numbers as 0.5|0|-8, without blanks";
            Err(row.token(column)?.wrong(kind).with_hint(hint))
        }
    }
}

/// Checks that the coefficients of added mass, which have no effect at rest, are numbers and not a
/// table.
fn check_added(row: &Row<'_>) -> Result<(), Diagnostic> {
    let token = row.token(&ADDED)?;
    if row.bars(&ADDED).is_ok() {
        return Ok(());
    }
    let message = format!(
        "{} is {}: tables of added mass are not modelled",
        row.what(&ADDED),
        quoted(token.text)
    );
    let hint = "write numbers; they have no effect on the mooring at rest";
    Err(row.unsupported(&ADDED, message).with_hint(hint))
}

/// The columns that have an effect at rest.
pub(super) const USED: [Column; 12] = [
    ID,
    TYPE,
    POSITION[0],
    POSITION[1],
    POSITION[2],
    ANGLES[0],
    ANGLES[1],
    ANGLES[2],
    MASS,
    CENTER,
    INERTIA,
    VOLUME,
];
