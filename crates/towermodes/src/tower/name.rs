//! Checks of names: control characters are not allowed.

/// Whether a character shows in a line of text without disturbing the rest of it: no control
/// character, and no mark that turns the direction of writing (Unicode Standard Annex 9), with
/// which a name could make a line read as another.
pub fn is_printable(c: char) -> bool {
    let turns = matches!(
        c,
        '\u{061c}' | '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}'
    );
    let breaks = matches!(c, '\u{2028}' | '\u{2029}');
    !(c.is_control() || turns || breaks)
}

/// A name with a space for each character that is not [printable](is_printable).
///
/// # Example
/// ```
/// assert_eq!(towermodes::printable("NREL\u{202e}5\tMW"), "NREL 5 MW");
/// ```
pub fn printable(name: &str) -> String {
    // Most names need no look at each character.
    let is_plain = |byte: u8| byte == b' ' || byte.is_ascii_graphic();
    if name.bytes().all(is_plain) {
        return name.to_owned();
    }
    name.chars()
        .map(|c| if is_printable(c) { c } else { ' ' })
        .collect()
}
