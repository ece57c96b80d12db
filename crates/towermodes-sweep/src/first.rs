//! The first names of a list, for messages.

use std::fmt::Display;

/// The first names of a list, with an ellipsis if it has more.
pub(crate) fn first(names: &[impl Display]) -> String {
    const SHOWN: usize = 12;
    let shown: Vec<String> = names.iter().take(SHOWN).map(ToString::to_string).collect();
    let more = if names.len() > SHOWN { ", …" } else { "" };
    shown.join(", ") + more
}
