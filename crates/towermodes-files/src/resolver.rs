//! Finds the files that a main file names.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use crate::note::Note;
use crate::source::{FileError, Source};

/// Gives the text of the files that a main file names: section tables of BModes decks, tower and
/// blade files of ElastoDyn, station tables of tower files.
pub trait FileResolver {
    /// The file that the main file calls `path`; both kinds of slash separate folders.
    ///
    /// # Errors
    /// [`FileError`].
    fn read(&self, path: &str) -> Result<Source, FileError>;

    /// Whether files are in folders; if not, files are found only by their names, without a note.
    fn has_folders(&self) -> bool {
        true
    }
}

/// A path relative to a folder, expressed relative to the folder of that folder.
pub(crate) fn beside(folder: &str, path: &str) -> String {
    if is_absolute(path) || folder.is_empty() {
        path.to_owned()
    } else {
        format!("{folder}/{path}")
    }
}

/// The folder of a file that was found by this path: the folder of the path, or none if the file
/// was found elsewhere by its name.
pub(crate) fn folder_of<'a>(path: &'a str, found: &Source) -> &'a str {
    let slash = path
        .rfind(['/', '\\'])
        .filter(|_| is_absolute(path) || !is_elsewhere(path, found));
    slash.map_or("", |slash| &path[..slash])
}

/// The note that there is no file at a path, which `key` gives, if another one of the same name was
/// found: in another folder, or with other capital letters.
pub(crate) fn found_elsewhere(
    files: &dyn FileResolver,
    key: &str,
    path: &str,
    found: &Source,
) -> Option<Note> {
    let other = match (is_elsewhere(path, found), is_absolute(path)) {
        (true, true) => format!("{} is used", found.name),
        (true, false) => {
            "the file of this name beside the file that refers to it is used".to_owned()
        }
        (false, _) if has_other_capitals(path, found) => {
            format!(
                "{} is used, whose name has other capital letters",
                found.name
            )
        }
        (false, _) => return None,
    };
    let message = format!("{key}: there is no {path}; {other}");
    files.has_folders().then(|| Note::new(message))
}

/// Whether a file was found at another place than at its path; capital letters do not matter.
fn is_elsewhere(path: &str, found: &Source) -> bool {
    let [path, name] = [path, &found.name].map(str::to_ascii_lowercase);
    !parts(&name).ends_with(&parts(&path))
}

/// Whether the path to a file that was found differs from its path in capital letters.
fn has_other_capitals(path: &str, found: &Source) -> bool {
    !parts(&found.name).ends_with(&parts(path))
}

/// The folders and the name of a path.
fn parts(path: &str) -> Vec<&str> {
    let parts = path.split(['/', '\\']);
    parts
        .filter(|part| !part.is_empty() && *part != ".")
        .collect()
}

/// Whether a path is absolute on this system or on Windows.
fn is_absolute(path: &str) -> bool {
    path.starts_with(['/', '\\']) || path.chars().nth(1) == Some(':')
}

/// Regular files on disk, relative to the folder of the main file or to the current folder.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SiblingFiles {
    folder: PathBuf,
}

impl SiblingFiles {
    /// The files relative to the folder of a main file.
    pub fn of(main: &Path) -> Self {
        let folder = main.parent().map(Path::to_path_buf).unwrap_or_default();
        Self { folder }
    }

    /// The location of the file that the main file refers to as `path`. Three places are tried: the
    /// path relative to the folder of the main file; the file name in that folder, because decks
    /// are often copied without their subfolders; the path relative to the current folder. If none
    /// of them exists, the first one is searched without regard to case, because decks written on
    /// Windows do not distinguish it. For an absolute path of another machine the leading folders
    /// are omitted one by one.
    pub fn path(&self, path: &str) -> PathBuf {
        let relative: PathBuf = path.split(['/', '\\']).collect();
        let relative = if path.starts_with('/') {
            Path::new("/").join(relative)
        } else {
            relative
        };
        let named = self.folder.join(&relative);
        let beside = relative.file_name().map(|name| self.folder.join(name));
        let candidates = [Some(named.clone()), beside, Some(relative.clone())];
        let found = candidates.into_iter().flatten().find(|path| path.is_file());
        let found = found.or_else(|| ignoring_case(&self.folder, &relative));
        let found = found.or_else(|| self.end_of(path, &relative));
        found.unwrap_or(named)
    }

    /// The file at the longest trailing part of an absolute path that exists in the folder.
    fn end_of(&self, path: &str, relative: &Path) -> Option<PathBuf> {
        if !is_absolute(path) {
            return None;
        }
        let mut parts = relative.components();
        std::iter::from_fn(|| {
            parts.next()?;
            Some(self.folder.join(parts.as_path()))
        })
        .find(|path| path.is_file())
    }
}

/// The file at a path relative to a folder, without regard to the case of names; of several the
/// first in alphabetical order.
fn ignoring_case(folder: &Path, relative: &Path) -> Option<PathBuf> {
    let mut found = folder.to_path_buf();
    for part in relative.components() {
        let exact = found.join(part);
        if exact.exists() {
            found = exact;
            continue;
        }
        let Component::Normal(name) = part else {
            return None;
        };
        let here = match found.as_os_str().is_empty() {
            true => Path::new("."),
            false => &found,
        };
        let entries = here.read_dir().ok()?.flatten();
        let same = entries.filter(|entry| entry.file_name().eq_ignore_ascii_case(name));
        found = same.map(|entry| entry.path()).min()?;
    }
    found.is_file().then_some(found)
}

impl FileResolver for SiblingFiles {
    fn read(&self, path: &str) -> Result<Source, FileError> {
        Source::from_regular_file(&self.path(path))
    }
}

/// Files in memory by name, for tests and for programs without a disk.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct InMemory {
    /// The text of each file.
    pub files: BTreeMap<String, String>,
}

impl FileResolver for InMemory {
    fn read(&self, path: &str) -> Result<Source, FileError> {
        let missing = || FileError::Missing { name: path.into() };
        let text = self.files.get(path).cloned().ok_or_else(missing)?;
        let name = path.to_owned();
        Ok(Source { name, text })
    }
}
