//! The given options as arguments of a command line that repeats them.

use std::fmt::Display;

/// An option with its value; nothing if it is not given.
pub(crate) fn valued(name: &str, value: Option<impl Display>) -> Vec<String> {
    let words = value.map(|value| vec![name.to_owned(), value.to_string()]);
    words.unwrap_or_default()
}

/// An option without a value; nothing if it is not given.
pub(crate) fn flag(name: &str, is_given: bool) -> Vec<String> {
    let words = is_given.then(|| vec![name.to_owned()]);
    words.unwrap_or_default()
}
