//! What the targets share: several files in one input, and what must hold of whatever is read.
#![forbid(unsafe_code)]

use towermodes_files::{InMemory, Input, ReadError, Note, Source, TowerInput};

/// A line that ends one file and begins the next.
pub const MARKER: &str = "%%%% next file %%%%\n";

/// The texts of an input, as many as asked for; those that are not there are empty, and the last
/// takes what is left.
pub fn texts<const N: usize>(bytes: &[u8]) -> Option<[String; N]> {
    let text = std::str::from_utf8(bytes).ok()?;
    let mut parts = text.splitn(N, MARKER).map(str::to_owned);
    Some(std::array::from_fn(|_| parts.next().unwrap_or_default()))
}

/// A file of a name.
pub fn source(name: &str, text: impl Into<String>) -> Source {
    Source {
        name: name.to_owned(),
        text: text.into(),
    }
}

/// Files that a main file may name.
pub fn companions<const N: usize>(files: [(&str, String); N]) -> InMemory {
    InMemory {
        files: files.map(|(name, text)| (name.to_owned(), text)).into(),
    }
}

/// Looks at a tower or at why there is none.
pub fn look_at_tower(result: Result<TowerInput, ReadError>) {
    match result {
        Ok(input) => {
            look_at_notes(&input.notes);
            if let Err(error) = input.tower() {
                look_at_error(&error);
            }
        }
        Err(error) => look_at_error(&error),
    }
}

/// Looks at what a file describes or at why it describes nothing.
pub fn look_at_input(result: Result<Input, ReadError>) {
    match result {
        Ok(Input::Tower(tower)) => look_at_tower(Ok(*tower)),
        Ok(Input::Blade(blade)) => look_at_notes(&blade.notes),
        Ok(Input::Substructure(input)) => look_at_notes(&input.notes),
        Err(error) => look_at_error(&error),
    }
}

/// A note says something.
fn look_at_notes(notes: &[Note]) {
    for note in notes {
        assert!(!note.to_string().is_empty());
    }
}

/// A mistake says something about a place in its file.
pub fn look_at_error(error: &ReadError) {
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = error
    else {
        return;
    };
    assert!(!mistakes.is_empty());
    for mistake in mistakes {
        assert!(!mistake.message().is_empty(), "{mistake:?}");
        assert!(
            source_file.text.get(mistake.span.clone()).is_some(),
            "{mistake:?}"
        );
        let (line, column) = mistake.line_and_column(&source_file.text);
        assert!(line >= 1 && column >= 1);
    }
}
