//! Counts, lists, and names that come from files.

use std::borrow::Cow;
use std::fmt::Display;

use towermodes::is_printable;

/// A count with its noun: "1 mode", "2 modes".
pub fn counted<N: Copy + Display + PartialEq + From<u8>>(count: N, noun: &str) -> String {
    let plural = if count == N::from(1) { "" } else { "s" };
    format!("{count} {noun}{plural}")
}

/// A list as text: "a", "a and b", "a, b and c".
pub fn listed(items: &[String]) -> String {
    match items {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        items => items.concat(),
    }
}

/// A message as a sentence of a document: its first word with a capital unless it is a name (of a
/// file, of a value), without code marks.
pub fn sentence(message: &str) -> String {
    let message = match message.matches('`').count() % 2 {
        0 => message.replace('`', ""),
        _ => message.to_owned(),
    };
    let word = message.split([' ', ',', ':']).next().unwrap_or_default();
    let is_word = word.chars().all(|c| c.is_ascii_lowercase() || c == '-');
    let mut letters = message.chars();
    match letters.next() {
        Some(first) if is_word => first.to_ascii_uppercase().to_string() + letters.as_str(),
        _ => message,
    }
}

/// A text in which `replacement` replaces every control character, every mark that changes the
/// writing direction, and the two noncharacters U+FFFE and U+FFFF. Line feeds and tabs remain.
///
/// Names come from files: without this they could hide or forge the output on a terminal or a page.
pub fn printable(text: &str, replacement: char) -> Cow<'_, str> {
    if !text.contains(disturbs) {
        return Cow::Borrowed(text);
    }
    let shown = text
        .chars()
        .map(|c| if disturbs(c) { replacement } else { c });
    Cow::Owned(shown.collect())
}

fn disturbs(c: char) -> bool {
    (!is_printable(c) && !matches!(c, '\n' | '\t')) || matches!(c, '\u{fffe}' | '\u{ffff}')
}

#[cfg(test)]
mod tests {
    use super::{listed, printable, sentence};

    #[test]
    fn messages_become_sentences() {
        assert_eq!(sentence("the mass is zero"), "The mass is zero");
        for name in ["a.dat:34: no speed", "wall_thickness is 0", "/a/b: no"] {
            assert_eq!(sentence(name), name);
        }
        assert_eq!(sentence("`PtfmRefzt` is read"), "PtfmRefzt is read");
        assert_eq!(sentence("A ` alone"), "A ` alone");
    }

    #[test]
    fn lists_end_with_and() {
        let items = ["a", "b", "c"].map(str::to_owned);
        assert_eq!(listed(&items), "a, b and c");
        assert_eq!(listed(&items[..2]), "a and b");
        assert_eq!(listed(&items[..1]), "a");
    }

    #[test]
    fn what_would_disturb_a_terminal_or_a_page_is_replaced() {
        let shown = |text| printable(text, '\u{fffd}').into_owned();
        assert_eq!(
            shown("a\u{202e}b\u{1b}[2Jc\u{9b}d"),
            "a\u{fffd}b\u{fffd}[2Jc\u{fffd}d"
        );
        assert_eq!(shown("a\rb\u{7f}"), "a\u{fffd}b\u{fffd}");
        let plain = "Türme, 塔\n\tB";
        assert_eq!(shown(plain), plain);
        assert_eq!(printable("a\u{202e}b\u{0}c\n", ' '), "a b c\n");
    }
}
