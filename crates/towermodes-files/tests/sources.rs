//! Files of tests in memory.

use towermodes_files::Source;

pub fn source(name: impl Into<String>, text: impl Into<String>) -> Source {
    Source {
        name: name.into(),
        text: text.into(),
    }
}
