//! The values of the file: maps, lists, numbers, names; and the mistakes of other types.

use super::yaml::{Node, Value};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

impl Node {
    /// The value of a key; an empty value counts as missing.
    pub(crate) fn get(&self, key: &str) -> Option<&Self> {
        let Value::Map(entries) = &self.value else {
            return None;
        };
        let found = entries.iter().find(|(name, _)| name == key);
        found
            .map(|(_, node)| node)
            .filter(|node| node.value != Value::Null)
    }

    /// The value at the end of a path of keys.
    pub(crate) fn find(&self, path: &[&str]) -> Option<&Self> {
        path.iter().try_fold(self, |node, key| node.get(key))
    }

    /// The value of a required key; `what` names its parent in messages.
    pub(crate) fn require(&self, key: &str, what: &str) -> Result<&Self, Diagnostic> {
        self.get(key).ok_or_else(|| match self.value {
            Value::Map(_) => {
                Diagnostic::new(self.span.clone(), DiagnosticKind::missing_key(what, key))
            }
            _ => self.wrong(what, &format!("a map with `{key}`")),
        })
    }

    /// The values of a list.
    pub(crate) fn list(&self, what: &str) -> Result<&[Self], Diagnostic> {
        match &self.value {
            Value::List(list) => Ok(list),
            _ => Err(self.wrong(what, "a list")),
        }
    }

    /// The finite number in any notation: 1e9 is text for older readers of YAML.
    pub(crate) fn number(&self, what: &str) -> Result<f64, Diagnostic> {
        let number = match &self.value {
            Value::Number(number) => Some(*number),
            Value::Text(text) => text.trim().parse().ok(),
            _ => None,
        };
        let number = number.ok_or_else(|| self.wrong(what, "a number"))?;
        if number.is_finite() {
            return Ok(number);
        }
        let kind = DiagnosticKind::not_finite(what, number);
        Err(Diagnostic::new(self.span.clone(), kind))
    }

    /// A mass, kg, that is not negative.
    pub(crate) fn mass_kg(&self, what: &str) -> Result<f64, Diagnostic> {
        let value = self.number(what)?;
        match value >= 0.0 {
            true => Ok(value),
            false => {
                let kind = DiagnosticKind::out_of_range_in(what, value, "kg", "0 or positive");
                Err(Diagnostic::new(self.span.clone(), kind))
            }
        }
    }

    /// The number of a key, or a default.
    pub(crate) fn number_or(&self, key: &str, what: &str, default: f64) -> Result<f64, Diagnostic> {
        self.get(key).map_or(Ok(default), |node| node.number(what))
    }

    /// A list of numbers.
    pub(crate) fn numbers(&self, what: &str) -> Result<Vec<f64>, Diagnostic> {
        let list = self.list(what)?.iter().enumerate();
        list.map(|(i, node)| node.number(&format!("value {} of {what}", i + 1)))
            .collect()
    }

    /// A name, which may look like a number.
    pub(crate) fn name<'a>(&'a self, text: &'a str) -> &'a str {
        match &self.value {
            Value::Text(name) => name,
            _ => text.get(self.span.clone()).unwrap_or_default().trim(),
        }
    }

    /// The mistake of a value of another type.
    pub(crate) fn wrong(&self, what: &str, expected: &str) -> Diagnostic {
        let found = match &self.value {
            Value::Null => "nothing".to_owned(),
            Value::Bool(value) => format!("`{value}`"),
            Value::Number(value) => format!("the number {value}"),
            Value::Text(text) => quoted(text),
            Value::List(_) => "a list".to_owned(),
            Value::Map(_) => "a map".to_owned(),
        };
        let kind = DiagnosticKind::wrong_type(what, expected, found);
        Diagnostic::new(self.span.clone(), kind)
    }
}
