//! Profiles of soil in CSV, as exported from a report or a cone penetration test; a layer of a
//! tower file refers to one with `profile = "cone.csv"`.
//!
//! A row contains a depth or height and one or more quantities there, which are linear between
//! rows; two rows at one depth are a step.

mod column;
mod unit;

use std::ops::Range;

use crate::csv_table::{
    MAX_MISTAKES, Numbers, Record, Records, Width, check_header, no_rows, rows,
};
use crate::diagnostic::{Diagnostic, DiagnosticKind, line_and_column};
use crate::number::Rounded;
use column::{Column, Content, column};

/// Largest number of rows: each is a layer.
const MAX_ROWS: usize = 1000;
/// Heights whose difference is smaller than this, m, are equal, because lengths are converted.
pub(crate) const SAME_M: f64 = 1e-6;

const EXAMPLE: &str = "write a header such as `depth [m], undrained_strength [kPa]` or `height_m, cone_resistance_MPa`";

/// A quantity of a profile.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Quantity {
    /// Its key in `[[ground.layer]]`.
    pub(crate) key: &'static str,
    /// The place of its column header.
    pub(crate) span: Range<usize>,
}

/// A row of a profile.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Row {
    /// Height in the datum of the stations, m, with its place.
    pub(crate) height_m: f64,
    pub(crate) span: Range<usize>,
    /// The quantities in SI units, with their places.
    pub(crate) values: Vec<(f64, Range<usize>)>,
}

/// The rows of a profile, from the top down.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Profile {
    pub(crate) quantities: Vec<Quantity>,
    pub(crate) rows: Vec<Row>,
}

/// The columns of a profile.
struct Header {
    /// The height or the depth.
    position: Column,
    quantities: Vec<Column>,
    width: Width,
}

/// The profile in a table; depths are measured from the surface of the ground.
///
/// # Errors
/// The mistakes at their places in the text; never an empty list.
pub(crate) fn profile(text: &str, surface_m: f64) -> Result<Profile, Vec<Diagnostic>> {
    let mut records = Records::new(text);
    let Some(first) = records.next() else {
        let mistake = Diagnostic::new(0..0, DiagnosticKind::EmptyFile);
        return Err(vec![mistake.with_hint(EXAMPLE)]);
    };
    let first = first.map_err(|mistake| vec![mistake])?;
    let header = header(&first)?;
    let mut numbers = Numbers::new(text, records.delimiter());
    let (mut found, mut mistakes) = (Vec::new(), Vec::new());
    for record in rows(records, header.width, MAX_ROWS) {
        match record.and_then(|record| row(&header, &record, surface_m, &mut numbers)) {
            Ok(row) => found.push(row),
            Err(mistake) => mistakes.push(mistake),
        }
        if mistakes.len() >= MAX_MISTAKES {
            break;
        }
    }
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    if found.len() < 2 {
        let hint = "a profile has at least two rows, at the top and at the bottom of its layer";
        return Err(vec![no_rows(text).with_hint(hint)]);
    }
    if found[0].height_m < found[found.len() - 1].height_m {
        found.reverse();
    }
    check_order(&found, text, &header.position).map_err(|mistake| vec![mistake])?;
    let quantity = |column: &Column| match column.content {
        Content::Quantity(key) => Some(Quantity {
            key,
            span: first.cells[column.index].span.clone(),
        }),
        Content::Height | Content::Depth => None,
    };
    Ok(Profile {
        quantities: header.quantities.iter().filter_map(quantity).collect(),
        rows: found,
    })
}

/// The header in a row of the table.
fn header(record: &Record<'_>) -> Result<Header, Vec<Diagnostic>> {
    check_header(record, EXAMPLE).map_err(|mistake| vec![mistake])?;
    let (mut positions, mut quantities, mut mistakes) = (Vec::new(), Vec::new(), Vec::new());
    for (index, cell) in record.cells.iter().enumerate() {
        let found = match column(index, cell) {
            Ok(Some(found)) => found,
            Ok(None) => continue,
            Err(mistake) => {
                mistakes.push(mistake);
                continue;
            }
        };
        let list: &mut Vec<Column> = match found.content {
            Content::Quantity(_) => &mut quantities,
            Content::Height | Content::Depth => &mut positions,
        };
        if list.iter().any(|other| other.content == found.content) {
            let what = format!("the column {}", found.name);
            let kind = DiagnosticKind::Repeated { what, times: 2 };
            mistakes.push(Diagnostic::new(cell.span.clone(), kind));
        }
        list.push(found);
    }
    if !mistakes.is_empty() {
        return Err(mistakes);
    }
    let wrong = |kind| vec![Diagnostic::new(record.span.clone(), kind).with_hint(EXAMPLE)];
    let missing = |what: &str| {
        wrong(DiagnosticKind::Missing {
            what: what.to_owned(),
        })
    };
    let position = match positions[..] {
        [one] => one,
        [] => return Err(missing("the column depth or height")),
        _ => {
            let message = "the header has both a depth and a height".to_owned();
            return Err(wrong(DiagnosticKind::Contradiction(message)));
        }
    };
    let Some(last) = quantities.iter().map(|column| column.index).max() else {
        return Err(missing("a column with a quantity of the soil"));
    };
    Ok(Header {
        position,
        quantities,
        width: Width {
            columns: record.cells.len(),
            needed: last.max(position.index) + 1,
        },
    })
}

fn row(
    header: &Header,
    record: &Record<'_>,
    surface_m: f64,
    numbers: &mut Numbers<'_>,
) -> Result<Row, Diagnostic> {
    let mut value = |column: &Column| {
        let cell = &record.cells[column.index];
        let given = numbers.number(cell, column.name)?;
        let kind = match column.content {
            Content::Quantity(_) if given < 0.0 => {
                let rule = "zero or positive".to_owned();
                DiagnosticKind::out_of_range_in(column.name, given, "", rule)
            }
            _ => match column.unit.si(given) {
                value if value.is_finite() => return Ok((value, cell.span.clone())),
                value => DiagnosticKind::not_finite(column.name, value),
            },
        };
        Err(Diagnostic::new(cell.span.clone(), kind))
    };
    let (position_m, span) = value(&header.position)?;
    let values = header.quantities.iter().map(value);
    let values = values.collect::<Result<Vec<_>, Diagnostic>>()?;
    let height_m = match header.position.content {
        Content::Depth => surface_m - position_m,
        Content::Height | Content::Quantity(_) => position_m,
    };
    Ok(Row {
        height_m,
        span,
        values,
    })
}

/// Refuses rows that reverse the direction, and more than two rows at one height.
fn check_order(rows: &[Row], text: &str, position: &Column) -> Result<(), Diagnostic> {
    let line = |row: &Row| line_and_column(text, row.span.start).0;
    for pair in rows.windows(2) {
        if pair[1].height_m - pair[0].height_m > SAME_M {
            // In the order of the file.
            let (first, second) = match pair[0].span.start < pair[1].span.start {
                true => (&pair[0], &pair[1]),
                false => (&pair[1], &pair[0]),
            };
            let kind = DiagnosticKind::Contradiction(format!(
                "the direction of the {} reverses here, after line {}",
                position.name,
                line(first),
            ));
            let hint =
                "rows go from the top down or from the bottom up; two rows at one depth are a step";
            return Err(Diagnostic::new(second.span.clone(), kind).with_hint(hint));
        }
    }
    for three in rows.windows(3) {
        if (three[0].height_m - three[2].height_m).abs() <= SAME_M {
            let what = format!("the height {} m", Rounded(three[1].height_m));
            let last = three[0].span.start.max(three[2].span.start);
            let span = if three[0].span.start == last {
                &three[0].span
            } else {
                &three[2].span
            };
            let kind = DiagnosticKind::Repeated { what, times: 3 };
            let hint = "two rows at one depth are a step: remove the row between them";
            return Err(Diagnostic::new(span.clone(), kind).with_hint(hint));
        }
    }
    Ok(())
}
