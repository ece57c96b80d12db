//! Input files as they are included in the report.

use super::content::InputFile;
use super::mark::printable;
use crate::wording::counted;

/// Longer files are cut at this number of bytes.
const MOST_OF_A_FILE: usize = 256 * 1024;
/// All files together are cut at this number of bytes.
const MOST_OF_ALL: usize = 1024 * 1024;

/// An input file, as far as it is included in the report.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct EmbeddedFile {
    /// Its path as it was given.
    pub name: String,
    /// Its text; lines end with a line feed.
    pub text: String,
    /// Whether each of its lines ends with a carriage return and a line feed.
    pub has_crlf: bool,
    /// The difference between the text and the bytes of the file, if there is one.
    pub differs: Option<String>,
}

/// The files of the input, the main one first, each as far as it fits.
pub(super) fn embedded(files: &[InputFile]) -> Vec<EmbeddedFile> {
    let mut room = MOST_OF_ALL;
    let embed = |file: &InputFile| {
        let embedded = EmbeddedFile::new(file, room.min(MOST_OF_A_FILE));
        room -= embedded.text.len().min(room);
        embedded
    };
    files.iter().map(embed).collect()
}

impl EmbeddedFile {
    /// The whole lines at the beginning of a file that together have at most `most` bytes.
    fn new(file: &InputFile, most: usize) -> Self {
        let shown = beginning(&file.text, most);
        let line_feeds = shown.matches('\n').count();
        let has_crlf = line_feeds > 0 && shown.matches("\r\n").count() == line_feeds;
        let text = shown.replace("\r\n", "\n");
        let printed = printable(&text);
        let mut differs = Vec::new();
        if shown.len() < file.text.len() {
            let all = counted(file.text.lines().count(), "line");
            let shown = shown.lines().count();
            differs.push(format!(
                "only the first {shown} of {all} are included (at most {} kB of a file and {} kB of all files)",
                MOST_OF_A_FILE / 1024,
                MOST_OF_ALL / 1024
            ));
        }
        if printed != text || (!has_crlf && shown.contains('\r')) {
            differs.push("control characters are shown as spaces".to_owned());
        }
        if !file.is_of_text && file.text.len() as u64 != file.bytes {
            differs.push("the file is not encoded in UTF-8, or begins with a byte order mark; the text shown here is in UTF-8 without this mark".to_owned());
        }
        Self {
            name: file.name.clone(),
            text: printed,
            has_crlf,
            differs: (!differs.is_empty()).then(|| differs.join("; ")),
        }
    }
}

/// The whole text if it has at most `most` bytes, otherwise the whole lines within this limit.
fn beginning(text: &str, most: usize) -> &str {
    if text.len() <= most {
        return text;
    }
    let end = text.as_bytes()[..most]
        .iter()
        .rposition(|byte| *byte == b'\n');
    // A line feed is one byte, so no character is cut.
    &text[..end.map_or(0, |end| end + 1)]
}

#[cfg(test)]
mod tests {
    use super::{EmbeddedFile, MOST_OF_A_FILE, MOST_OF_ALL, embedded};
    use crate::report::InputFile;

    fn file(text: &str) -> InputFile {
        InputFile {
            name: "tower.toml".to_owned(),
            is_of_text: false,
            bytes: text.len() as u64,
            sha256: String::new(),
            text: text.to_owned(),
        }
    }

    #[test]
    fn a_file_is_whole_up_to_the_limit() {
        let line = "0123456\n";
        let whole = line.repeat(MOST_OF_A_FILE / 8);
        let kept = &embedded(&[file(&whole)])[0];
        assert_eq!((kept.text.len(), &kept.differs), (MOST_OF_A_FILE, &None));
        let longer = format!("{whole}8\n");
        let kept = &embedded(&[file(&longer)])[0];
        assert_eq!(kept.text.len(), MOST_OF_A_FILE);
        let said = kept.differs.as_deref().expect("a note");
        assert!(
            said.contains("only the first 32768 of 32769 lines are included"),
            "{said}"
        );
    }

    #[test]
    fn all_files_together_have_a_limit() {
        let whole = file(&"0123456\n".repeat(MOST_OF_A_FILE / 8));
        let files = vec![whole; 5];
        let kept = embedded(&files);
        let sizes: Vec<usize> = kept.iter().map(|file| file.text.len()).collect();
        assert_eq!(sizes.iter().sum::<usize>(), MOST_OF_ALL);
        assert_eq!(sizes[4], 0);
        assert!(kept[3].differs.is_none() && kept[4].differs.is_some());
    }

    #[test]
    fn letters_are_never_cut() {
        let kept = EmbeddedFile::new(&file("a\n\u{e9}\u{e9}\u{e9}\n"), 5);
        assert_eq!(kept.text, "a\n");
        assert_eq!(EmbeddedFile::new(&file("\u{e9}\u{e9}"), 3).text, "");
    }

    #[test]
    fn ends_of_lines_are_remembered_and_control_characters_said() {
        let kept = EmbeddedFile::new(&file("a\r\nb\r\n"), 100);
        assert_eq!(
            (&*kept.text, kept.has_crlf, kept.differs),
            ("a\nb\n", true, None)
        );
        for odd in ["a\r\nb\n", "a\u{202e}b\n", "a\u{1}\n"] {
            let kept = EmbeddedFile::new(&file(odd), 100);
            let said = kept.differs.unwrap_or_default();
            assert!(said.contains("control characters"), "{odd:?}: {said}");
        }
        let mut latin1 = file("\u{e9}t\u{e9}\n");
        latin1.bytes = 4;
        let said = EmbeddedFile::new(&latin1, 100).differs.unwrap_or_default();
        assert!(said.contains("UTF-8"), "{said}");
    }
}
