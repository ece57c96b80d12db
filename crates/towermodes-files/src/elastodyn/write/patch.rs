//! Puts new coefficients into the text of a tower file and changes no other byte.

use std::ops::Range;

use thiserror::Error;

use super::super::tower_input::rules::{TowerFileError, coefficient_texts};
use super::super::tower_input::tower_file::CoefficientSpans;
use super::super::tower_input::tower_records::SHAPES;

/// Why a tower file cannot be patched.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum PatchError {
    /// Coefficients that cannot be written.
    #[error(transparent)]
    Coefficients(#[from] TowerFileError),
    /// Byte ranges that do not contain successive numbers of this text.
    #[error("the coefficients are not at bytes {start} to {end} of this text")]
    Place {
        /// The first byte.
        start: usize,
        /// The byte after the last.
        end: usize,
    },
}

/// The text with new coefficients, printed as decimals whose sum is exactly 1.
///
/// Numbers keep their width if possible: shorter ones are padded with blanks; longer ones replace
/// blanks before them, or after them if one remains, so that the following text stays in its
/// column. An unchanged number keeps its bytes. Line ends, comments and everything else are not
/// changed.
///
/// # Errors
/// [`PatchError`].
pub fn patched(
    text: &str,
    spans: &CoefficientSpans,
    coefficients: &[[f64; 5]; 4],
) -> Result<String, PatchError> {
    let mut result = String::with_capacity(text.len() + 400);
    let mut done = 0;
    for ((shape, spans), coefficients) in SHAPES.iter().zip(spans).zip(coefficients) {
        let texts = coefficient_texts(shape, *coefficients)?;
        for (span, new) in spans.iter().zip(&texts) {
            let old = text.get(span.clone()).filter(|old| {
                let is_behind = span.start >= done;
                is_behind && number(old).is_some()
            });
            let Some(old) = old else {
                let Range { start, end } = *span;
                return Err(PatchError::Place { start, end });
            };
            if is_same(old, new) {
                continue;
            }
            let (field, filled) = fitted(text, span, done, new);
            result.push_str(&text[done..field.start]);
            result.push_str(&filled);
            done = field.end;
        }
    }
    result.push_str(&text[done..]);
    Ok(result)
}

fn is_same(old: &str, new: &str) -> bool {
    number(old) == number(new)
}

/// The number that Fortran reads.
fn number(text: &str) -> Option<f64> {
    text.replace(['d', 'D'], "e").parse().ok()
}

/// The byte range that a new number replaces, entirely after `done`, and the text that replaces it.
fn fitted(text: &str, span: &Range<usize>, done: usize, new: &str) -> (Range<usize>, String) {
    let blanks_before = blanks(text[done..span.start].bytes().rev());
    let line_starts = text[..span.start - blanks_before].bytes().next_back();
    let is_first = line_starts.is_none_or(|byte| byte == b'\n');
    let width = span.len();
    if new.len() <= width {
        // Numbers with blanks before them end in one column, others begin in one.
        let filled = match blanks_before {
            0 => format!("{new:<width$}"),
            _ => format!("{new:>width$}"),
        };
        return (span.clone(), filled);
    }
    let missing = new.len() - width;
    let free_before = blanks_before - usize::from(!is_first).min(blanks_before);
    let before = missing.min(free_before);
    let free_after = blanks(text[span.end..].bytes()).saturating_sub(1);
    let after = missing - before;
    let after = if after <= free_after { after } else { 0 };
    (span.start - before..span.end + after, new.to_owned())
}

fn blanks(bytes: impl Iterator<Item = u8>) -> usize {
    bytes.take_while(|byte| *byte == b' ').count()
}
