//! Explains texts that the TOML parser cannot read: numbers with units, decimal commas, numbers
//! without a digit before or after the point, texts without quotation marks.

use std::ops::Range;

use super::super::schema::{KeySchema, ValueKind, tower_file_schema};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

/// The mistake that caused an error of the parser.
pub(crate) fn syntax_mistake(error: &::toml::de::Error, text: &str) -> Diagnostic {
    let span = error.span().unwrap_or(text.len()..text.len());
    let ends_early = span.start >= text.trim_end().len();
    let value = value_at(span.start.min(text.len()), text);
    let value = value.filter(|value| value.key.is_some() || !ends_early);
    let explained = value.and_then(|value| value.explained().or_else(|| value.without_comma(text)));
    if let Some(mistake) = explained {
        return mistake;
    }
    let reason = error.message().lines().collect::<Vec<_>>().join("; ");
    let format = "TOML";
    let mistake = Diagnostic::new(span, DiagnosticKind::Syntax { format, reason });
    match ends_early {
        true => mistake.with_hint("the file ends here; is it complete?"),
        false => mistake,
    }
}

/// A value without brackets or quotation marks, as written.
struct Written<'a> {
    /// Its key; none within a list.
    key: Option<&'a str>,
    text: &'a str,
    span: Range<usize>,
}

/// The value at or just before a byte: that of a `key = value`, or an entry of a list.
fn value_at(byte: usize, text: &str) -> Option<Written<'_>> {
    let newline = text.get(..byte)?.rfind('\n');
    let start = newline.map_or(0, |newline| newline + 1);
    value_of_key(start, text).or_else(|| entry_at(byte, start, text))
}

/// The value of the `key = value` in the line that begins at a byte, if it is not a list or a text.
fn value_of_key(start: usize, text: &str) -> Option<Written<'_>> {
    let line = text[start..].lines().next()?;
    let (key, value) = line.split_once('=')?;
    let value = value.split('#').next().unwrap_or_default();
    let from = start + key.len() + 1 + (value.len() - value.trim_start().len());
    let text = value.trim();
    if text.is_empty() || text.contains(['[', '{', '"', '\'']) {
        return None;
    }
    let (key, span) = (Some(key.trim()), from..from + text.len());
    Some(Written { key, text, span })
}

/// The entry of a list at or just before a byte of the line that begins at `start`.
fn entry_at(byte: usize, start: usize, text: &str) -> Option<Written<'_>> {
    let is_end = |c: char| c.is_whitespace() || ",[]{}=#\"'".contains(c);
    let end = text[..byte].rfind(is_end);
    let from = end.map_or(0, |end| end + 1).max(start);
    let own = text[from..].split(is_end).next()?;
    // A unit belongs to the number before it: 45 mm.
    let behind = text[from + own.len()..].trim_start_matches([' ', '\t']);
    let unit = behind.split(is_end).next().unwrap_or_default();
    let has_unit =
        own.starts_with(|c: char| c.is_ascii_digit()) && unit.starts_with(char::is_alphabetic);
    let to = match has_unit {
        true => text.len() - behind.len() + unit.len(),
        false => from + own.len(),
    };
    let (key, span) = (None, from..to);
    let text = &text[span.clone()];
    (!text.is_empty()).then_some(Written { key, text, span })
}

impl Written<'_> {
    /// The mistake, if its cause is known.
    fn explained(&self) -> Option<Diagnostic> {
        let (number, unit) = self.number_and_unit();
        if !number.contains(|c: char| c.is_ascii_digit()) {
            return self.without_quotes();
        }
        if number.contains(',') {
            return Some(self.mistake("a number").with_hint(without_commas(number)?));
        }
        let value = number.replace('_', "").parse::<f64>();
        let value = value.ok().filter(|value| value.is_finite())?;
        let hint = if !unit.is_empty() {
            self.without_unit(number, value, unit)?
        } else if is_number_of_toml(number) {
            // The mistake is elsewhere: a key that is given twice, a missing comma or bracket.
            return None;
        } else if number.starts_with('0') && !number.contains('.') && number.len() > 1 {
            // The rest of a number with a decimal comma in a list.
            format!(
                "write a decimal point, for example 0.{number}, or the number without zeros before it"
            )
        } else {
            format!("write a digit before and after the point: {value:?}")
        };
        Some(self.mistake("a number").with_hint(hint))
    }

    /// The mistake of a number in a list that is followed by another number without a comma.
    fn without_comma(&self, file: &str) -> Option<Diagnostic> {
        let next = file[self.span.end..].trim_start_matches([' ', '\t']);
        let is_number = next.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        if self.key.is_some() || !is_number || !is_number_of_toml(self.text) {
            return None;
        }
        let (format, reason) = (
            "TOML",
            format!("a comma is missing after {}", quoted(self.text)),
        );
        let mistake = Diagnostic::new(self.span.clone(), DiagnosticKind::Syntax { format, reason });
        Some(mistake.with_hint("the values of a list are separated by commas: [0.0, 6.0, 0.03]"))
    }

    /// The number at the beginning of the text, which may be empty, and the rest.
    fn number_and_unit(&self) -> (&str, &str) {
        let is_of_number = |c: char| c.is_ascii_digit() || "+-.,eE_".contains(c);
        let length = self.text.find(|c| !is_of_number(c));
        let (mut number, mut unit) = self.text.split_at(length.unwrap_or(self.text.len()));
        // The `e` of a unit or a word is no exponent.
        if !number.ends_with(|c: char| c.is_ascii_digit() || c == '.') {
            let last = number.rfind(|c: char| c.is_ascii_digit());
            (number, unit) = self.text.split_at(last.map_or(0, |at| at + 1));
        }
        (number, unit.trim())
    }

    fn mistake(&self, expected: &str) -> Diagnostic {
        let what = self.key.unwrap_or("a value");
        let kind = DiagnosticKind::wrong_type(what, expected, quoted(self.text));
        Diagnostic::new(self.span.clone(), kind)
    }

    /// The suggestion for a number with a unit: the number in the unit of the key.
    fn without_unit(&self, number: &str, value: f64, unit: &str) -> Option<String> {
        if !unit.starts_with(char::is_alphabetic) {
            return None;
        }
        let keys = tower_file_schema()
            .iter()
            .filter_map(|table| table.key(self.key?));
        let base = keys.map(|key| key.unit).find(|unit| !unit.is_empty());
        let is_it = |of: &str| base.is_none_or(|base| base == of);
        let factor = UNITS
            .iter()
            .find(|(name, _, of)| *name == unit && is_it(of));
        Some(match (factor, base) {
            (Some((_, factor, base)), _) => {
                let value = without_noise(value * factor);
                format!("write {value} ({base}), without a unit")
            }
            (None, Some(base)) => format!("write the number in {base}, without a unit"),
            (None, None) => format!("write {number} without a unit: units are m, kg, N and Pa"),
        })
    }

    /// Whether its key can be true or false.
    fn is_flag(&self) -> bool {
        let is_it = |key: &KeySchema| key.kind == ValueKind::Flag || key.meaning.contains("true");
        let mut tables = tower_file_schema().iter();
        tables.any(|table| self.key.and_then(|key| table.key(key)).is_some_and(is_it))
    }

    /// A text without quotation marks.
    fn without_quotes(&self) -> Option<Diagnostic> {
        let is_text = self.text.starts_with(char::is_alphabetic) && self.key.is_some();
        let hint = match self.text {
            "True" | "TRUE" | "False" | "FALSE" => {
                format!("write {}, in small letters", self.text.to_lowercase())
            }
            text => match as_flag(text).filter(|_| self.is_flag()) {
                Some(flag) => format!("write {flag}"),
                None => format!("write \"{text}\""),
            },
        };
        let expected = "a number, true, false or a text in quotation marks";
        is_text.then(|| self.mistake(expected).with_hint(hint))
    }
}

/// What to write in place of a word that means `true` or `false`.
pub(crate) fn as_flag(word: &str) -> Option<bool> {
    match &*word.to_lowercase() {
        "yes" | "on" | "true" => Some(true),
        "no" | "off" | "false" => Some(false),
        _ => None,
    }
}

/// What to write in place of a number in quotation marks, if it is one.
pub(crate) fn without_marks(text: &str, what: &str) -> Option<String> {
    let text = text.trim();
    if text.parse::<f64>().is_ok() {
        return Some("write the number without quotation marks".to_owned());
    }
    let (key, span) = (Some(what), 0..text.len());
    let written = Written { key, text, span };
    let (number, unit) = written.number_and_unit();
    let value = number.replace('_', "").parse().ok()?;
    written.without_unit(number, value, unit)
}

/// Without the digits that a product of two short numbers gets.
fn without_noise(product: f64) -> f64 {
    format!("{product:.12e}").parse().unwrap_or(product)
}

/// Whether a text is a number by the rules of TOML.
fn is_number_of_toml(text: &str) -> bool {
    ::toml::from_str::<::toml::Table>(&format!("number = {text}")).is_ok()
}

/// The suggestion for a number with commas, which may separate thousands.
fn without_commas(number: &str) -> Option<String> {
    let is_group = |group: &str| group.len() == 3 && group.bytes().all(|b| b.is_ascii_digit());
    let (whole, rest) = number.split_once('.').unwrap_or((number, ""));
    let is_grouped = !whole.starts_with('0') && whole.split(',').skip(1).all(is_group);
    let plain = number
        .replace(',', "")
        .parse::<f64>()
        .ok()
        .filter(|_| is_grouped);
    let decimal = number.replacen(',', ".", 1).parse::<f64>().ok();
    match (plain, decimal.filter(|_| rest.is_empty())) {
        (Some(plain), Some(decimal)) => Some(format!(
            "write {plain} if the comma separates thousands, {decimal:?} if it is a decimal comma"
        )),
        (Some(plain), None) => Some(format!("write {plain}, without commas")),
        (None, Some(decimal)) => Some(format!("write a decimal point: {decimal}")),
        (None, None) => None,
    }
}

/// Units after a number, their factor to the unit of the key, and this unit.
const UNITS: [(&str, f64, &str); 24] = [
    ("t", 1e3, "kg"),
    ("kg", 1.0, "kg"),
    ("m", 1.0, "m"),
    ("km", 1e3, "m"),
    ("cm", 1e-2, "m"),
    ("mm", 1e-3, "m"),
    ("N", 1.0, "N"),
    ("kN", 1e3, "N"),
    ("MN", 1e6, "N"),
    ("N m", 1.0, "N m"),
    ("kN m", 1e3, "N m"),
    ("MN m", 1e6, "N m"),
    ("kg m2", 1.0, "kg m2"),
    ("t m2", 1e3, "kg m2"),
    ("Pa", 1.0, "Pa"),
    ("kPa", 1e3, "Pa"),
    ("MPa", 1e6, "Pa"),
    ("GPa", 1e9, "Pa"),
    ("N/m", 1.0, "N/m"),
    ("kN/m", 1e3, "N/m"),
    ("MN/m", 1e6, "N/m"),
    ("kg/m3", 1.0, "kg/m3"),
    ("t/m3", 1e3, "kg/m3"),
    ("m/s2", 1.0, "m/s2"),
];

#[cfg(test)]
mod tests {
    use crate::tower_from_toml;

    #[test]
    fn slips_of_pen_are_explained() {
        for (text, message, hint) in [
            (
                "[rna]\nmass = 3 t\n",
                "mass must be a number, found `3 t`",
                "write 3000 (kg), without a unit",
            ),
            (
                "[rna]\nmass = 350e3 kg # x\n",
                "mass must be a number, found `350e3 kg`",
                "write 350000 (kg), without a unit",
            ),
            (
                "[rna]\nmass = 310 lb\n",
                "mass must be a number, found `310 lb`",
                "write the number in kg, without a unit",
            ),
            (
                "[tower]\nstations = [[0.0, 6.0, 45 mm]]\n",
                "a value must be a number, found `45 mm`",
                "write 0.045 (m), without a unit",
            ),
            (
                "[tower]\nshear = yes\n",
                "shear must be a number, true, false or a text in quotation marks, found `yes`",
                "write true",
            ),
            (
                "name = yes\n",
                "name must be a number, true, false or a text in quotation marks, found `yes`",
                "write \"yes\"",
            ),
            (
                "[rna]\nmass = 0,027\n",
                "mass must be a number, found `0,027`",
                "write a decimal point: 0.027",
            ),
            (
                "[rna]\nmass = 350,000\n",
                "mass must be a number, found `350,000`",
                "write 350000 if the comma separates thousands, 350.0 if it is a decimal comma",
            ),
            (
                "[rna]\nmass = 1,350,000.5\n",
                "mass must be a number, found `1,350,000.5`",
                "write 1350000.5, without commas",
            ),
            (
                "[rna]\nmass = .027\n",
                "mass must be a number, found `.027`",
                "write a digit before and after the point: 0.027",
            ),
            (
                "[rna]\nmass = 5.\n",
                "mass must be a number, found `5.`",
                "write a digit before and after the point: 5.0",
            ),
            (
                "[tower]\nstations = [[0.0, 6.0, .027]]\n",
                "a value must be a number, found `.027`",
                "write a digit before and after the point: 0.027",
            ),
            (
                "name = My tower\n",
                "name must be a number, true, false or a text in quotation marks, found `My tower`",
                "write \"My tower\"",
            ),
        ] {
            let mistakes = tower_from_toml(text).expect_err("a mistake");
            assert_eq!(mistakes.len(), 1, "{text}");
            assert_eq!(mistakes[0].message(), message);
            assert_eq!(mistakes[0].hint.as_deref(), Some(hint), "{text}");
        }
    }

    /// A correct number is not reported because of a mistake elsewhere.
    #[test]
    fn numbers_beside_a_mistake_are_not_blamed() {
        for (text, reason) in [
            ("[rna]\nmass = 350e3\nmass = 350e3\n", "duplicate key"),
            (
                "[tower]\nstations = [[0.0 6.0, 0.03]]\n",
                "a comma is missing after `0.0`",
            ),
            ("[rna]\nmass: 350e3\n", "key"),
        ] {
            let mistakes = tower_from_toml(text).expect_err("a mistake");
            let message = mistakes[0].message();
            assert!(message.starts_with("invalid TOML: "), "{text}: {message}");
            assert!(message.contains(reason), "{text}: {message}");
        }
    }
}
