//! The tables of sections: tubes, and since OpenFAST 4.1 rectangles.

use super::section::{Form, StripSection};
use super::tables::{Ids, Row, Table};
use super::values::Values;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Sections by their numbers.
pub(super) struct Sections {
    tubes: (Ids, Vec<Walled<1>>),
    rectangles: (Ids, Vec<Walled<2>>),
}

/// Outer and inner dimensions: a diameter, or two sides, m.
#[derive(Debug, Clone, Copy)]
struct Walled<const N: usize> {
    outer_m: [f64; N],
    inner_m: [f64; N],
}

impl Sections {
    pub(super) fn of(values: &Values<'_>) -> Result<Self, Diagnostic> {
        let tubes = Table::of(values, &["NPropSets", "NPropSetsCyl"], usize::MAX)?;
        let rectangles = Table::of(values, &["NPropSetsRec"], usize::MAX)?;
        Ok(Self {
            tubes: read(&tubes, ["PropD"])?,
            rectangles: read(&rectangles, ["PropA", "PropB"])?,
        })
    }

    /// The section of a member between its joints.
    pub(super) fn of_member(
        &self,
        table: &Table<'_>,
        row: &Row<'_>,
    ) -> Result<StripSection, Diagnostic> {
        match form(table, row)? {
            Form::Circle => {
                let ends = ends(&self.tubes, table, row)?;
                Ok(StripSection::Circle {
                    outer_radius_m: ends.map(|end| 0.5 * end.outer_m[0]),
                    inner_radius_m: ends.map(|end| 0.5 * end.inner_m[0]),
                })
            }
            Form::Rectangle => {
                let ends = ends(&self.rectangles, table, row)?;
                Ok(StripSection::Rectangle {
                    outer_sides_m: ends.map(|end| end.outer_m),
                    inner_sides_m: ends.map(|end| end.inner_m),
                })
            }
        }
    }
}

/// Whether a member is rectangular; before OpenFAST 4.1 all are circular.
pub(super) fn form(table: &Table<'_>, row: &Row<'_>) -> Result<Form, Diagnostic> {
    let Some(column) = table.column_if_any(&["MSecGeom"]) else {
        return Ok(Form::Circle);
    };
    match row.integer(column, "MSecGeom")? {
        1 => Ok(Form::Circle),
        2 => Ok(Form::Rectangle),
        other => {
            let rule = "1 (circular) or 2 (rectangular)";
            let kind = DiagnosticKind::out_of_range("MSecGeom", other as f64, rule);
            Err(row.wrong(column, kind))
        }
    }
}

fn ends<const N: usize>(
    (ids, sections): &(Ids, Vec<Walled<N>>),
    table: &Table<'_>,
    row: &Row<'_>,
) -> Result<[Walled<N>; 2], Diagnostic> {
    let find = |name| ids.find(row, table.column(&[name])?, name);
    Ok([find("MPropSetID1")?, find("MPropSetID2")?].map(|end| sections[end]))
}

fn read<const N: usize>(
    table: &Table<'_>,
    sizes: [&str; N],
) -> Result<(Ids, Vec<Walled<N>>), Diagnostic> {
    let rows = table.rows.iter().map(|row| walled(table, row, sizes));
    let sections: Result<Vec<_>, Diagnostic> = rows.collect();
    Ok((table.ids("member property set")?, sections?))
}

fn walled<const N: usize>(
    table: &Table<'_>,
    row: &Row<'_>,
    sizes: [&str; N],
) -> Result<Walled<N>, Diagnostic> {
    let wall_m = table.not_negative(row, "PropThck")?;
    let mut outer_m = [0.0; N];
    for (size_m, name) in outer_m.iter_mut().zip(sizes) {
        *size_m = table.number(row, name)?;
        if *size_m <= 0.0 {
            let kind = DiagnosticKind::out_of_range_in(name, *size_m, "m", "positive");
            return Err(row.wrong(table.column(&[name])?, kind));
        }
        if wall_m > 0.5 * *size_m {
            let rule = format!("at most half of {name}, {} m", 0.5 * *size_m);
            let kind = DiagnosticKind::out_of_range_in("PropThck", wall_m, "m", rule);
            return Err(row.wrong(table.column(&["PropThck"])?, kind));
        }
    }
    let inner_m = outer_m.map(|size_m| size_m - 2.0 * wall_m);
    Ok(Walled { outer_m, inner_m })
}
