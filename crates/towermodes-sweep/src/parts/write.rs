//! Files are written whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::PartsError;

/// Number of names that are tried for a temporary file; those in use are left over from killed
/// processes.
const MOST_NAMES: usize = 1000;

/// Writes a file of the folder: to a hidden temporary file, to the disk, under its name. A file
/// with this name is replaced.
///
/// # Errors
/// [`PartsError::Io`] with the name of the file, if the disk is full for example; nothing is left
/// then.
pub(super) fn write(folder: &Path, name: &str, content: &[u8]) -> Result<(), PartsError> {
    let path = folder.join(name);
    let temporary = Temporary::new(folder, name, content).map_err(PartsError::io(&path))?;
    match temporary.take_name(&path) {
        Ok(()) => Ok(()),
        // Another run that completed the folder removed the temporary file; it wrote the same.
        Err(error) if error.kind() == ErrorKind::NotFound && path.exists() => Ok(()),
        Err(error) => Err(PartsError::Io { path, error }),
    }
}

/// Writes a file that must not exist yet; false if it does.
///
/// # Errors
/// As [`write`].
pub(super) fn write_new(folder: &Path, name: &str, content: &[u8]) -> Result<bool, PartsError> {
    let path = folder.join(name);
    let temporary = Temporary::new(folder, name, content).map_err(PartsError::io(&path))?;
    // A second name for the file, unless there is a file with this name.
    match fs::hard_link(&temporary.path, &path) {
        Ok(()) => Ok(true),
        Err(_) if path.exists() => Ok(false),
        // A disk without second names.
        Err(_) => match temporary.take_name(&path) {
            Ok(()) => Ok(true),
            Err(error) => Err(PartsError::Io { path, error }),
        },
    }
}

/// The beginning and the end of the names of temporary files.
pub(super) fn is_temporary(name: &str) -> bool {
    let is_ours = name.starts_with(".part-") || name.starts_with("._");
    is_ours && name.ends_with(".tmp")
}

/// Makes the names in a folder permanent, where the system can.
pub(super) fn sync_folder(folder: &Path) {
    if let Ok(folder) = File::open(folder) {
        // The files themselves are on the disk.
        let _ = folder.sync_all();
    }
}

/// A complete temporary file, removed on drop unless it has its final name: a process on another
/// computer may have a file with the old name by then.
struct Temporary {
    path: PathBuf,
    is_named: bool,
}

impl Temporary {
    fn new(folder: &Path, name: &str, content: &[u8]) -> io::Result<Self> {
        let (mut file, path) = create(folder, name)?;
        let is_named = false;
        let temporary = Self { path, is_named };
        file.write_all(content)?;
        // A full disk may be detected here.
        file.sync_all()?;
        Ok(temporary)
    }

    fn take_name(mut self, path: &Path) -> io::Result<()> {
        fs::rename(&self.path, path)?;
        self.is_named = true;
        Ok(())
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        if !self.is_named {
            // What cannot be removed is ignored by all readers.
            let _ = fs::remove_file(&self.path);
        }
    }
}

fn create(folder: &Path, name: &str) -> io::Result<(File, PathBuf)> {
    let process = std::process::id();
    let name = name.trim_start_matches('.');
    for number in 0..MOST_NAMES {
        let path = folder.join(format!(".{name}.{process}-{number}.tmp"));
        match OpenOptions::new().write(true).create_new(true).open(&path) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            created => return created.map(|file| (file, path)),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}
