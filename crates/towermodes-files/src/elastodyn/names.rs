//! The names that the lines of ElastoDyn's files say after their values.

use crate::records::Line;

/// No name is longer; what follows would only cost time.
const LONGEST: usize = 40;

/// A name without what files differ in: case, brackets, underscores.
pub(super) fn plain(name: &str) -> String {
    let letters = name.chars().take(LONGEST);
    letters
        .filter(char::is_ascii_alphanumeric)
        .map(|letter| letter.to_ascii_lowercase())
        .collect()
}

/// The name on a line, in plain form: its second value. The titles of sections are no names.
pub(super) fn name_on(line: &Line<'_>) -> Option<String> {
    if is_ruler(line) {
        return None;
    }
    line.tokens().nth(1).map(|token| plain(token.text))
}

/// Which of some names a line says after its value, if it says one of them.
pub(super) fn said<'k>(line: &Line<'_>, known: &[&'k str]) -> Option<&'k str> {
    let name = name_on(line)?;
    known.iter().copied().find(|known| plain(known) == name)
}

/// Whether a line is a ruler with the title of a section.
pub(super) fn is_ruler(line: &Line<'_>) -> bool {
    let text = line.text.trim_start();
    text.starts_with("---") || text.starts_with("===")
}

#[cfg(test)]
mod tests {
    use super::{is_ruler, plain, said};
    use crate::records::Line;

    #[test]
    fn names_differ_in_brackets_and_case() {
        assert_eq!(plain("TwrFADmp(1)"), plain("twrfadmp1"));
        assert_eq!(plain("HubIner_Teeter"), "hubinerteeter");
        let line = |text| Line { text, start: 0 };
        let known = ["BldFile(1)", "BldFile(2)"];
        assert_eq!(
            said(&line("\"a b.dat\" BldFile2 - a file"), &known),
            Some("BldFile(2)")
        );
        assert_eq!(said(&line("12.1"), &known), None);
        assert_eq!(said(&line("---- FURLING ----"), &["Furling"]), None);
        assert!(is_ruler(&line(" --- TOWER ---")) && !is_ruler(&line("-5 ShftTilt")));
    }
}
