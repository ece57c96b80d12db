//! Tables of the page.

use super::{text, verdict};
use crate::report::table::{Cell, Column, MOST_ROWS, Table};
use crate::svg::DataTable;

/// Tables with at most this number of rows are not broken across printed pages.
const SHORT: usize = 24;
/// Numbers with more characters may be broken across lines.
const LONG_NUMBER: usize = 24;
/// Texts with more characters have a width of their own.
const LONG_TEXT: usize = 40;
/// Data of pictures with more columns are divided into several tables, because they do not fit on
/// paper.
const WIDE: usize = 14;
/// Units with at most this number of characters are not broken across lines.
const UNIT: usize = 12;

/// A table of a section; a long one is shown shortened, with all of its rows in a collapsed part.
pub(super) fn of_table(table: &Table) -> String {
    let caption = format!("Table {}. {}.", table.number, table.caption);
    let all: Vec<String> = (table.rows.iter())
        .map(|row| of_row(&table.columns, row))
        .collect();
    let Some(brief) = &table.brief else {
        return scrolling(&caption, &table.columns, &all.concat(), all.len());
    };
    let rows = brief.shown.iter().map(|row| &table.rows[*row]);
    let mut rows: Vec<String> = rows.map(|row| of_row(&table.columns, row)).collect();
    if let Some(after) = brief.gap_after {
        rows.insert(after, of_gap(&table.columns));
    }
    let shown = scrolling(&caption, &table.columns, &rows.concat(), rows.len());
    let name = all_name(table);
    let whole = format!("{caption} Here: {name}.");
    let whole = scrolling(&whole, &table.columns, &all.concat(), usize::MAX);
    format!(
        "{shown}<p class=\"remark\">Shown: {}.</p>\n\
         <details class=\"all\">\n<summary>Show {name}</summary>\n{whole}</details>\n",
        text(&brief.which)
    )
}

/// The data of a picture; many columns are divided into tables below each other, each with the
/// first column.
pub(super) fn of_data(number: usize, title: &str, data: &DataTable) -> String {
    let is_number = |index: usize| data.rows.iter().all(|row| is_number(row.get(index)));
    let column = |(index, name): (usize, &String)| Column {
        name: name.clone(),
        is_number: is_number(index),
    };
    let columns: Vec<Column> = data.header.iter().enumerate().map(column).collect();
    let note = match data.rows.len().saturating_sub(MOST_ROWS) {
        0 => String::new(),
        left_out => format!(" ({left_out} more rows are left out)"),
    };
    let caption = format!("Data of figure {number}. {title}{note}");
    let Some((first, others)) = columns.split_first().filter(|_| columns.len() > WIDE) else {
        return of_columns(&format!("{caption}."), &columns, |row| row.to_vec(), data);
    };
    // About equally many in each.
    let size = others.len().div_ceil(others.len().div_ceil(WIDE - 1));
    let part = |(part, own): (usize, &[Column])| {
        let from = 1 + part * size;
        let to = from + own.len();
        let caption = format!(
            "{caption}, columns {} to {to} of {}.",
            from + 1,
            columns.len()
        );
        let own: Vec<Column> = std::iter::once(first).chain(own).cloned().collect();
        let cells = |row: &[String]| {
            let own = row.get(from..to.min(row.len())).unwrap_or_default();
            row.iter().take(1).chain(own).cloned().collect()
        };
        of_columns(&caption, &own, cells, data)
    };
    others.chunks(size).enumerate().map(part).collect()
}

/// Some columns of the data of a picture; `cells` selects their cells from a row.
fn of_columns(
    caption: &str,
    columns: &[Column],
    cells: impl Fn(&[String]) -> Vec<String>,
    data: &DataTable,
) -> String {
    let rows = data.rows.iter().take(MOST_ROWS).map(|row| {
        let cells = cells(row).into_iter().map(Cell::from);
        of_row(columns, &cells.collect::<Vec<Cell>>())
    });
    scrolling(caption, columns, &rows.collect::<String>(), data.rows.len())
}

/// A table that can be scrolled sideways; its rows are already HTML.
fn scrolling(caption: &str, columns: &[Column], rows: &str, count: usize) -> String {
    let caption = text(caption);
    let short = if count <= SHORT { " short" } else { "" };
    let head = columns.iter().map(|column| {
        let class = if column.is_number {
            " class=\"number\""
        } else {
            ""
        };
        let name = unbroken_units(&column.name);
        format!("<th scope=\"col\"{class}>{}</th>", text(&name))
    });
    let head: String = head.collect();
    format!(
        "<div class=\"scroll{short}\" tabindex=\"0\" role=\"region\" aria-label=\"{caption}\">\n\
         <table>\n<caption><span>{caption}</span></caption>\n\
         <thead><tr>{head}</tr></thead>\n<tbody>\n{rows}</tbody>\n</table>\n</div>\n"
    )
}

/// The name of a column with non-breaking spaces within its units: "inertia (kg m²)".
fn unbroken_units(name: &str) -> String {
    let parts = name.split_inclusive(')').map(|part| match part.rfind('(') {
        Some(at) if part[at..].chars().count() <= UNIT => {
            let (before, unit) = part.split_at(at);
            before.to_owned() + &unit.replace(' ', "\u{a0}")
        }
        _ => part.to_owned(),
    });
    parts.collect()
}

/// A row; its first cell is its heading.
fn of_row(columns: &[Column], cells: &[Cell]) -> String {
    let cells = columns.iter().zip(cells).enumerate();
    let cells = cells.map(|(index, (column, cell))| of_cell(column, cell, index == 0));
    format!("<tr>{}</tr>\n", cells.collect::<String>())
}

/// The row that replaces rows that are not shown.
fn of_gap(columns: &[Column]) -> String {
    let cells = vec![Cell::from("\u{2026}"); columns.len()];
    of_row(columns, &cells).replacen("<tr>", "<tr class=\"gap\">", 1)
}

fn of_cell(column: &Column, cell: &Cell, is_first: bool) -> String {
    let length = cell.text.chars().count();
    let class = match column.is_number {
        true if length > LONG_NUMBER => " class=\"number long\"",
        true => " class=\"number\"",
        false if cell.verdict.is_some() => " class=\"mark\"",
        false if length > LONG_TEXT && !is_first => " class=\"words\"",
        false => "",
    };
    let content = match cell.verdict {
        Some(mark) => verdict(mark, &cell.text),
        None => text(&cell.text),
    };
    match is_first {
        true => format!("<th scope=\"row\"{class}>{content}</th>"),
        false => format!("<td{class}>{content}</td>"),
    }
}

/// "all 41 rows", or the number at each end if there are more than a report contains.
fn all_name(table: &Table) -> String {
    match table.left_out {
        0 => format!("all {} rows", table.rows.len()),
        left_out => format!(
            "the first and the last {} of {} rows",
            table.rows.len() / 2,
            table.rows.len() + left_out
        ),
    }
}

/// Whether a cell is a number, or one that becomes another ("0.7039 → 0.6876"), or empty.
fn is_number(cell: Option<&String>) -> bool {
    let text = cell.map_or("", |text| text.trim()).replace('\u{2212}', "-");
    let mut numbers = text.split(" \u{2192} ");
    text.is_empty() || numbers.all(|number| number.parse::<f64>().is_ok())
}
