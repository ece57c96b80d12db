//! The names of parameters on the lines of ElastoDyn's files, after their values; and the kind of a
//! file according to its names.

use crate::records::{Line, Lines};

/// Largest length of a name.
const LONGEST: usize = 40;

/// A name without the differences between files: case, brackets, underscores.
pub(super) fn plain(name: &str) -> String {
    letters(name).map(char::from).collect()
}

fn letters(name: &str) -> impl Iterator<Item = u8> {
    let letters = name.bytes().take(LONGEST);
    letters
        .filter(u8::is_ascii_alphanumeric)
        .map(|letter| letter.to_ascii_lowercase())
}

/// Whether two names are equal except for differences between files.
fn is_same(a: &str, b: &str) -> bool {
    letters(a).eq(letters(b))
}

/// The name on a line: its second value. Section titles are not names.
fn name_on<'a>(line: &Line<'a>) -> Option<&'a str> {
    if is_ruler(line) {
        return None;
    }
    let second = line.tokens().nth(1).map(|token| token.text);
    second.or_else(|| line.name_behind_path())
}

/// Whether a line has a name after its value.
pub(super) fn is_named(line: &Line<'_>, name: &str) -> bool {
    name_on(line).is_some_and(|found| is_same(found, name))
}

/// The name on a line in plain form.
pub(super) fn plain_name_on(line: &Line<'_>) -> Option<String> {
    name_on(line).map(plain)
}

/// The name of this list that a line has after its value.
pub(super) fn named<'k>(line: &Line<'_>, known: &[&'k str]) -> Option<&'k str> {
    let name = name_on(line)?;
    known.iter().copied().find(|known| is_same(known, name))
}

/// Whether a line is a ruler with a section title.
pub(super) fn is_ruler(line: &Line<'_>) -> bool {
    let text = line.text.trim_start();
    text.starts_with("---") || text.starts_with("===")
}

/// Number of lines of a file in which names are searched.
const FIRST_LINES: usize = 400;
/// Number of lines in which the number of rows of a tower or blade file is searched.
const COUNT_LINES: usize = 12;

/// Whether the text is a main file of ElastoDyn, or of FAST 7, which is refused with a reason.
pub(crate) fn is_main_file(text: &str) -> bool {
    has_all(text, &["TwrFile", "NumBl", "TipRad"])
}

/// Whether the text is a tower file of ElastoDyn or FAST 7.
pub(crate) fn is_tower_file(text: &str) -> bool {
    line_among(COUNT_LINES, text, "NTwInpSt").is_some()
}

/// Whether the text is a blade file of ElastoDyn or FAST 7.
pub(super) fn is_blade_file(text: &str) -> bool {
    line_among(COUNT_LINES, text, "NBlInpSt").is_some()
}

/// Whether the text is the `.fst` file, which names the files of all modules of OpenFAST.
pub(crate) fn is_fst(text: &str) -> bool {
    has_all(text, &["EDFile"])
}

/// The line of a file that has a name.
pub(super) fn line_of<'a>(text: &'a str, name: &str) -> Option<Line<'a>> {
    line_among(FIRST_LINES, text, name)
}

fn line_among<'a>(count: usize, text: &'a str, name: &str) -> Option<Line<'a>> {
    let mut lines = Lines::new(text).take(count);
    lines.find(|line| is_named(line, name))
}

fn has_all(text: &str, names: &[&str]) -> bool {
    names.iter().all(|name| line_of(text, name).is_some())
}

#[cfg(test)]
mod tests {
    use super::{is_ruler, named, plain};
    use crate::records::Line;

    #[test]
    fn names_differ_in_brackets_and_case() {
        assert_eq!(plain("TwrFADmp(1)"), plain("twrfadmp1"));
        assert_eq!(plain("HubIner_Teeter"), "hubinerteeter");
        let line = |text| Line { text, start: 0 };
        let known = ["BldFile(1)", "BldFile(2)"];
        assert_eq!(
            named(&line("\"a b.dat\" BldFile2 - a file"), &known),
            Some("BldFile(2)")
        );
        assert_eq!(named(&line("12.1"), &known), None);
        assert_eq!(named(&line("---- FURLING ----"), &["Furling"]), None);
        assert!(is_ruler(&line(" --- TOWER ---")) && !is_ruler(&line("-5 ShftTilt")));
    }
}
