//! Where the files come from that a file names.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use crate::source::{ReadError, Source};

/// Gives the text of the files that a main file names: section tables of BModes decks, tower and
/// blade files of ElastoDyn.
pub trait Companions {
    /// The file that the main file calls `path`; either kind of slash separates folders.
    ///
    /// # Errors
    /// [`ReadError`].
    fn read(&self, path: &str) -> Result<Source, ReadError>;
}

/// Regular files on disk, relative to the folder of the main file, or else to the current folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Beside {
    folder: PathBuf,
}

impl Beside {
    /// The files beside a main file.
    pub fn file(main: &Path) -> Self {
        let folder = main.parent().map(Path::to_path_buf).unwrap_or_default();
        Self { folder }
    }

    /// Where a companion is: where its path leads from the folder of the main file; or else right
    /// beside that, whatever folder the path names, because decks are often copied flat; or else
    /// where it leads from the current folder.
    pub fn path(&self, path: &str) -> PathBuf {
        let relative: PathBuf = path.split(['/', '\\']).collect();
        let relative = if path.starts_with('/') {
            Path::new("/").join(relative)
        } else {
            relative
        };
        let named = self.folder.join(&relative);
        let beside = relative.file_name().map(|name| self.folder.join(name));
        let candidates = [Some(named.clone()), beside, Some(relative)];
        let found = candidates.into_iter().flatten().find(|path| path.is_file());
        found.unwrap_or(named)
    }
}

impl Companions for Beside {
    fn read(&self, path: &str) -> Result<Source, ReadError> {
        Source::from_regular_file(&self.path(path))
    }
}

/// Files in memory by name, for tests and for programs that have no disk.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct InMemory {
    /// The text of each file.
    pub files: BTreeMap<String, String>,
}

impl Companions for InMemory {
    fn read(&self, path: &str) -> Result<Source, ReadError> {
        match self.files.get(path) {
            Some(text) => Ok(Source {
                name: path.to_owned(),
                text: text.clone(),
            }),
            None => Err(ReadError::Missing {
                name: path.to_owned(),
            }),
        }
    }
}
