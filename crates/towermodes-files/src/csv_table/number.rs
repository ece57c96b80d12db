//! Numbers in cells, with a decimal point, or with a decimal comma if commas do not separate
//! columns.

use super::cells::Cell;
use crate::diagnostic::{Diagnostic, DiagnosticKind, line_and_column, quoted};

/// The format of the numbers of a table.
#[derive(Debug)]
pub(crate) struct Numbers<'a> {
    text: &'a str,
    delimiter: char,
    /// The place of the first number with a decimal separator, and the separator.
    first: Option<(usize, char)>,
}

impl<'a> Numbers<'a> {
    pub(crate) fn new(text: &'a str, delimiter: char) -> Self {
        Self {
            text,
            delimiter,
            first: None,
        }
    }

    /// The finite number of a cell.
    pub(crate) fn number(&mut self, cell: &Cell<'_>, what: &str) -> Result<f64, Diagnostic> {
        let text = &*cell.text;
        if text.is_empty() {
            let what = what.to_owned();
            let kind = DiagnosticKind::Missing { what };
            return Err(Diagnostic::new(cell.span.clone(), kind));
        }
        let signs = || text.chars().filter(|c| matches!(c, ',' | '.'));
        if signs().count() > 1 {
            return Err(wrong(cell, what).with_hint("write no separators between thousands"));
        }
        let sign = signs().next();
        if sign == Some(',') && self.delimiter == ',' {
            let hint = "write a decimal point, or separate the columns by semicolons";
            return Err(wrong(cell, what).with_hint(hint));
        }
        let number = text.replace(',', ".").parse::<f64>();
        let Ok(number) = number else {
            return Err(explained(wrong(cell, what), text));
        };
        if !number.is_finite() {
            let kind = DiagnosticKind::not_finite(what, number);
            return Err(Diagnostic::new(cell.span.clone(), kind));
        }
        self.check_sign(cell, sign)?;
        Ok(number)
    }

    /// Refuses a decimal separator that differs from that of other numbers, because one of the two
    /// separates thousands.
    fn check_sign(&mut self, cell: &Cell<'_>, sign: Option<char>) -> Result<(), Diagnostic> {
        let Some(sign) = sign else { return Ok(()) };
        let (first, expected) = *self.first.get_or_insert((cell.span.start, sign));
        if sign == expected {
            return Ok(());
        }
        let name = |sign: char| if sign == ',' { "comma" } else { "point" };
        let (line, _) = line_and_column(self.text, first);
        let kind = DiagnosticKind::Contradiction(format!(
            "`{}` has a decimal {}, but line {line} has a decimal {}",
            cell.text,
            name(sign),
            name(expected)
        ));
        let hint = "use one decimal sign, without separators between thousands";
        Err(Diagnostic::new(cell.span.clone(), kind).with_hint(hint))
    }
}

fn wrong(cell: &Cell<'_>, what: &str) -> Diagnostic {
    let kind = DiagnosticKind::wrong_type(what, "a number", quoted(&cell.text));
    Diagnostic::new(cell.span.clone(), kind)
}

/// The mistake of a text that is not a number, with a hint if it begins with one.
fn explained(mistake: Diagnostic, text: &str) -> Diagnostic {
    let begins = text.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    match begins && text.ends_with(char::is_alphabetic) {
        true => mistake.with_hint("write the unit in the header, for example `wall [mm]`"),
        false => mistake,
    }
}
