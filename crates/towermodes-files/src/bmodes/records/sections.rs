//! Reads the section file of a deck.

use std::iter::repeat_n;

use super::deck::{Beam, Section};
use super::diagnose::left_out;
use super::parameters::{COLUMNS, N_SECS};
use super::reader::{Reader, Value};
use super::section_checks::{check_locations, wrong};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::records::{Items, Line, Token};

/// Largest number of mistakes that are listed.
const MAX_MISTAKES: usize = 20;

/// All rows, and the byte of the first number beyond the columns.
#[derive(Debug, Clone)]
pub(crate) struct Sections {
    pub(crate) rows: Vec<Section>,
    pub(crate) extra_columns: Option<usize>,
}

/// Reads and checks the rows.
pub(crate) fn sections(text: &str, beam: Beam) -> Result<Sections, Vec<Diagnostic>> {
    let (mut rows, extra_columns) = rows(text).map_err(|mistake| vec![mistake])?;
    let mut mistakes: Vec<Diagnostic> = rows.iter().flat_map(|row| wrong(row, beam)).collect();
    if let Err(mistake) = check_locations(&mut rows) {
        mistakes.push(mistake);
    }
    if !mistakes.is_empty() {
        mistakes.sort_by_key(|mistake| mistake.span.start);
        mistakes.truncate(MAX_MISTAKES);
        return Err(mistakes);
    }
    Ok(Sections {
        rows,
        extra_columns,
    })
}

fn rows(text: &str) -> Result<(Vec<Section>, Option<usize>), Diagnostic> {
    let mut reader = Reader::new(text);
    reader.comment("the first line of the section file, a comment,")?;
    let count = reader.count(&N_SECS)?;
    for what in [
        "the line before the columns' names",
        "the columns' names",
        "the columns' units",
    ] {
        reader.comment(what)?;
    }
    let mut rows = Vec::new();
    let mut extra_columns = None;
    for index in 0..count.value {
        let (row, extra) = row(&mut reader, index, count.value)?;
        rows.push(row);
        extra_columns = extra_columns.or(extra);
    }
    check_end(&reader, &count)?;
    Ok((rows, extra_columns))
}

/// A row of the table, and the byte of its first number beyond the columns.
fn row(
    reader: &mut Reader<'_>,
    index: usize,
    count: usize,
) -> Result<(Section, Option<usize>), Diagnostic> {
    let what = format!("row {} of n_secs = {count}", index + 1);
    let first = reader.lines.expect_filled(&what)?;
    let values = values_of_row(reader, &first, &what, index)?;
    let extra = values.get(COLUMNS.len()).map(|value| value.span.start);
    if extra.is_some() && has_joined_numbers(&first) {
        let kind = DiagnosticKind::wrong_count_of("numbers", what, values.len(), COLUMNS.len());
        let hint = "write decimal points, for example 0.5, and blanks between numbers";
        return Err(Diagnostic::new(first.span(), kind).with_hint(hint));
    }
    let mut values = values.into_iter();
    let empty = || Value {
        value: 0.0,
        span: first.span(),
    };
    let row = std::array::from_fn(|_| values.next().unwrap_or_else(empty));
    Ok((Section(row), extra))
}

/// The numbers of a row, in one record or in several that together contain exactly these numbers.
fn values_of_row(
    reader: &mut Reader<'_>,
    first: &Line<'_>,
    what: &str,
    index: usize,
) -> Result<Vec<Value<f64>>, Diagnostic> {
    let mut values = numbers(first)?;
    if values.is_empty() {
        return Err(no_row(first, what, index));
    }
    let on_first = values.len();
    while values.len() < COLUMNS.len() {
        let next = reader.lines.clone().find(|line| !line.is_blank());
        let more = next.map_or(Ok(Vec::new()), |line| numbers(&line))?;
        if more.is_empty() || values.len() + more.len() > COLUMNS.len() {
            return Err(too_few(first, what, on_first));
        }
        reader.lines.expect_filled(what)?;
        values.extend(more);
    }
    Ok(values)
}

fn no_row(line: &Line<'_>, what: &str, index: usize) -> Diagnostic {
    let expected = format!("{what}, 13 numbers,");
    let kind = DiagnosticKind::misplaced(expected, quoted(line.text.trim()));
    let diagnostic = Diagnostic::new(line.span(), kind);
    if index == 0 {
        diagnostic.with_hint("three lines precede the rows: a blank one, names, units")
    } else {
        diagnostic.with_hint(format!("there are {index} rows: write n_secs = {index}"))
    }
}

fn too_few(line: &Line<'_>, what: &str, found: usize) -> Diagnostic {
    let kind = DiagnosticKind::wrong_count_of("numbers", what, found, COLUMNS.len());
    let names = COLUMNS.map(|(name, _)| name);
    let missing = names.get(found).copied().unwrap_or_default();
    let hint = format!("`{missing}` is missing; a row is {}", names.join(" "));
    Diagnostic::new(line.span(), kind).with_hint(hint)
}

/// The numbers of a line up to its first text; text within its columns is a mistake.
fn numbers(line: &Line<'_>) -> Result<Vec<Value<f64>>, Diagnostic> {
    let mut values = Vec::new();
    let mut items = Items::new(*line);
    while let Some(item) = items.next_item()? {
        let column = COLUMNS.get(values.len());
        let name = column.map_or("a number", |(name, _)| name);
        if item.commas > usize::from(!values.is_empty()) {
            return Err(left_out(name, &item.token));
        }
        match item.token.number(name) {
            Ok(value) => {
                let span = item.token.span;
                let repeats = item.repeats.min(COLUMNS.len());
                values.extend(repeat_n(Value { value, span }, repeats));
            }
            Err(mistake) if !values.is_empty() && column.is_some() => {
                return Err(unreadable(mistake, &item.token));
            }
            Err(_) => break,
        }
        if values.len() > 2 * COLUMNS.len() {
            break;
        }
    }
    Ok(values)
}

fn unreadable(mistake: Diagnostic, token: &Token<'_>) -> Diagnostic {
    let begins = token
        .text
        .starts_with(|c: char| c.is_ascii_digit() || c == '.');
    if begins && token.text.ends_with(char::is_alphabetic) {
        mistake.with_hint("write numbers without units")
    } else {
        mistake.with_hint("a row is 13 numbers; text may follow them")
    }
}

/// Number of values at the beginning of a line.
fn columns(line: &Line<'_>) -> usize {
    let tokens = line.tokens().take(COLUMNS.len());
    tokens.take_while(|token| token.is_number()).count()
}

/// Whether numbers are joined by commas without blanks, as decimal commas are.
fn has_joined_numbers(line: &Line<'_>) -> bool {
    let bytes = line.text.as_bytes();
    let is_joined =
        |three: &[u8]| three[0].is_ascii_digit() && three[1] == b',' && three[2].is_ascii_digit();
    bytes.windows(3).any(is_joined)
}

/// Refuses more rows than `n_secs`.
fn check_end(reader: &Reader<'_>, count: &Value<usize>) -> Result<(), Diagnostic> {
    let rest = reader.lines.clone().filter(|line| !line.is_blank());
    let more = rest.take_while(|line| columns(line) == COLUMNS.len());
    let more = more.count();
    if more == 0 {
        return Ok(());
    }
    let found = count.value + more;
    let kind = DiagnosticKind::wrong_count_of("rows", "the section file", found, count.value);
    let hint = format!("write n_secs = {}", count.value + more);
    Err(count.wrong(kind).with_hint(hint))
}
