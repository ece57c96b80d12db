//! The columns of the tables, with all names that they have in different versions.

/// The program of a file, for files with other column names: then columns are identified by their
/// order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Layout {
    MoorDyn2,
    /// MoorDyn 1, with the number of rows above each table.
    MoorDyn1,
    Map,
}

/// A column of a table.
#[derive(Debug, Clone, Copy)]
pub(super) struct Column {
    /// Its name in messages.
    pub(super) name: &'static str,
    /// The names that files give it, in the form of [`plain`].
    names: &'static [&'static str],
    /// Its index in MoorDyn 2, MoorDyn 1 and MAP++.
    order: [Option<usize>; 3],
}

impl Column {
    /// A column with one index in all files.
    pub(super) const fn new(
        name: &'static str,
        names: &'static [&'static str],
        index: usize,
    ) -> Self {
        Self {
            name,
            names,
            order: [Some(index); 3],
        }
    }

    /// A column with its index in MoorDyn 2, MoorDyn 1 and MAP++.
    pub(super) const fn ordered(
        name: &'static str,
        names: &'static [&'static str],
        order: [Option<usize>; 3],
    ) -> Self {
        Self { name, names, order }
    }

    /// Its index according to the names in a file.
    pub(super) fn named(&self, header: &[String]) -> Option<usize> {
        let is_it = |name: &String| self.names.contains(&name.as_str());
        header.iter().position(is_it)
    }

    /// Its index in files of a layout.
    pub(super) fn usual(&self, layout: Layout) -> Option<usize> {
        match layout {
            Layout::MoorDyn2 => self.order[0],
            Layout::MoorDyn1 => self.order[1],
            Layout::Map => self.order[2],
        }
    }
}

/// A name without differences between files: letters and digits in lower case.
pub(super) fn plain(name: &str) -> String {
    let letters = name.chars().filter(char::is_ascii_alphanumeric).take(40);
    letters.map(|letter| letter.to_ascii_lowercase()).collect()
}
