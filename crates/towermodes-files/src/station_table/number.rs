//! Numbers of cells, with a decimal point or, where commas separate no columns, a decimal comma.

use super::cells::Cell;
use crate::diagnostic::Diagnostic;

/// How the numbers of a table are written, as far as is known.
#[derive(Debug)]
pub(super) struct Numbers<'a> {
    text: &'a str,
    delimiter: char,
    /// Where the first number with a decimal sign stands, and the sign.
    first: Option<(usize, char)>,
}

impl<'a> Numbers<'a> {
    pub(super) fn new(text: &'a str, delimiter: char) -> Self {
        Self {
            text,
            delimiter,
            first: None,
        }
    }

    /// The finite number of a cell.
    pub(super) fn number(&mut self, cell: &Cell<'_>, what: &str) -> Result<f64, Diagnostic> {
        let text = &*cell.text;
        if text.is_empty() {
            return Err(Diagnostic::new(
                cell.span.clone(),
                format!("{what} is missing"),
            ));
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
            let message = format!("{what} is {text}, which is not a finite number");
            return Err(Diagnostic::new(cell.span.clone(), message));
        }
        self.check_sign(cell, sign)?;
        Ok(number)
    }

    /// Refuses a decimal sign that is not that of the other numbers: one of them separates
    /// thousands.
    fn check_sign(&mut self, cell: &Cell<'_>, sign: Option<char>) -> Result<(), Diagnostic> {
        let Some(sign) = sign else { return Ok(()) };
        let (first, expected) = *self.first.get_or_insert((cell.span.start, sign));
        if sign == expected {
            return Ok(());
        }
        let name = |sign: char| if sign == ',' { "comma" } else { "point" };
        let (line, _) = Diagnostic::new(first..first, "").line_and_column(self.text);
        let message = format!(
            "`{}` has a decimal {}, but line {line} has a decimal {}",
            cell.text,
            name(sign),
            name(expected)
        );
        let hint = "write all numbers alike, without separators between thousands";
        Err(Diagnostic::new(cell.span.clone(), message).with_hint(hint))
    }
}

fn wrong(cell: &Cell<'_>, what: &str) -> Diagnostic {
    let found: String = cell.text.chars().take(40).collect();
    let message = format!("{what} must be a number; found `{found}`");
    Diagnostic::new(cell.span.clone(), message)
}

/// A text that is no number, with what would be right where it begins like one.
fn explained(mistake: Diagnostic, text: &str) -> Diagnostic {
    let begins = text.starts_with(|c: char| c.is_ascii_digit() || c == '-');
    match begins && text.ends_with(char::is_alphabetic) {
        true => mistake.with_hint("write the unit in the header, as in `wall [mm]`"),
        false => mistake,
    }
}
