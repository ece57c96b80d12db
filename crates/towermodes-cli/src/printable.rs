//! Text that does nothing to a terminal but stand on it.

use std::borrow::Cow;

use towermodes::is_printable;

/// Stands where something was that is not shown.
const NOT_SHOWN: char = '\u{fffd}';

/// A text without control characters and without marks that turn the direction of writing: names
/// come from files, and what a terminal is told by them could hide or forge what is said.
pub(crate) fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(disturbs) {
        return Cow::Borrowed(text);
    }
    let shown = text
        .chars()
        .map(|c| if disturbs(c) { NOT_SHOWN } else { c });
    Cow::Owned(shown.collect())
}

/// Whether a character tells a terminal something; lines end and columns begin as they do.
fn disturbs(c: char) -> bool {
    !is_printable(c) && !matches!(c, '\n' | '\t')
}

#[cfg(test)]
mod tests {
    use super::printable;

    #[test]
    fn what_would_disturb_a_terminal_is_replaced() {
        assert_eq!(
            printable("a\u{202e}b\u{1b}[2Jc\u{9b}d"),
            "a\u{fffd}b\u{fffd}[2Jc\u{fffd}d"
        );
        assert_eq!(printable("a\rb\u{7f}"), "a\u{fffd}b\u{fffd}");
        let plain = "Türme, 塔\n\tB";
        assert_eq!(printable(plain), plain);
    }
}
