//! The table of nodes of MAP++.
//!
//! A number after `#` is an initial guess of a value that MAP++ computes, and `#` alone is such a
//! value without a guess: forces of fixed nodes, positions of nodes that connect lines.

use towermodes::mooring::{Attachment, MooringPoint};

use super::attachment::{Hold, hold};
use super::column::Column;
use super::points::{FORCES, ID, MASS, ReadPoint, TYPE, VOLUME, X, Y, Z};
use super::row::Row;
use super::tables::Rows;
use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact, quoted};
use crate::records::Token;

/// Reads the table.
pub(super) fn nodes(table: &Rows<'_>) -> Result<Vec<ReadPoint>, Diagnostic> {
    let rows = table.rows.iter().enumerate();
    rows.map(|(k, row)| node(row, k)).collect()
}

fn node(row: &Row<'_>, k: usize) -> Result<ReadPoint, Diagnostic> {
    row.check_id(&ID, k)?;
    let attachment = match hold(row, &TYPE)? {
        Hold::Fixed => Attachment::Fixed,
        Hold::Platform => Attachment::Platform,
        Hold::Free => Attachment::Free,
        Hold::Body(_) => {
            let kind =
                DiagnosticKind::wrong_type(row.what(&TYPE), "fix, vessel or connect", "a body");
            return Err(row.token(&TYPE)?.wrong(kind));
        }
    };
    let is_free = attachment == Attachment::Free;
    let is_on_seabed = row.token(&Z)?.text.to_ascii_lowercase().contains("depth");
    let z_m = if is_on_seabed {
        0.0
    } else {
        position(row, &Z, is_free)?
    };
    if is_free {
        check_forces(row)?;
    }
    Ok(ReadPoint {
        point: MooringPoint {
            attachment,
            position_m: [
                position(row, &X, is_free)?,
                position(row, &Y, is_free)?,
                z_m,
            ],
            mass_kg: load(row, &MASS, is_free)?,
            volume_m3: load(row, &VOLUME, is_free)?,
        },
        is_on_seabed,
        span: row.span(),
    })
}

/// A coordinate; for a free node also one after `#`.
fn position(row: &Row<'_>, column: &Column, is_free: bool) -> Result<f64, Diagnostic> {
    let token = row.token(column)?;
    match token.text.strip_prefix('#').filter(|_| is_free) {
        // Where there is no guess, the search begins at the origin.
        Some("") => Ok(0.0),
        Some(text) => Token {
            text,
            ..token.clone()
        }
        .number(&row.what(column)),
        None => row.number(column),
    }
}

/// Mass or volume, which MAP++ can compute so that a connection stays at its position.
fn load(row: &Row<'_>, column: &Column, is_free: bool) -> Result<f64, Diagnostic> {
    let Some(token) = row.get(column).filter(|token| token.text.starts_with('#')) else {
        return row.number_or_0(column);
    };
    if !is_free {
        return Ok(0.0);
    }
    let message = format!(
        "{} is {}: a value computed by MAP++ that keeps the node at its position is not modelled",
        row.what(column),
        quoted(token.text)
    );
    let hint = "give the value; the position of the node is computed";
    Err(row.unsupported(column, message).with_hint(hint))
}

/// Refuses external forces on a free node, including those that would keep it in place.
fn check_forces(row: &Row<'_>) -> Result<(), Diagnostic> {
    for column in &FORCES {
        let Some(token) = row.get(column) else {
            continue;
        };
        let force = match token.text.starts_with('#') {
            true => f64::NAN,
            false => row.number(column)?,
        };
        if force == 0.0 {
            continue;
        }
        let found = if force.is_nan() {
            quoted(token.text)
        } else {
            Exact(force).to_string()
        };
        let message = format!(
            "{} is {found}: external forces on nodes, and nodes at given positions, are not modelled",
            row.what(column)
        );
        let hint = "write 0; a constant vertical force can be given as a mass or a volume";
        return Err(row.unsupported(column, message).with_hint(hint));
    }
    Ok(())
}
