//! Files are written whole or not at all.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use super::PartsError;

/// Number of names that are tried for a temporary file; those in use are left over from killed
/// processes.
const MOST_NAMES: usize = 1000;

/// Number of times that a file is written of which other runs remove the temporary file.
const MOST_TRIES: usize = 10;

/// Writes a file of the folder: to a hidden temporary file, to the disk, under its name. A file
/// with this name is replaced.
///
/// # Errors
/// [`PartsError::Io`] with the name of the file, if the disk is full for example; nothing is left
/// then.
pub(super) fn write(folder: &Path, name: &str, content: &[u8]) -> Result<(), PartsError> {
    let path = folder.join(name);
    let mut tries = MOST_TRIES;
    loop {
        let temporary = Temporary::new(folder, name, content).map_err(PartsError::io(&path))?;
        tries -= 1;
        match temporary.take_name(&path) {
            Ok(()) => return Ok(()),
            // Another run that completed the folder removed the temporary file. It has written the
            // same, or is about to.
            Err(error) if error.kind() == ErrorKind::NotFound && path.exists() => return Ok(()),
            Err(error) if error.kind() == ErrorKind::NotFound && tries > 0 => {}
            Err(error) => return Err(PartsError::Io { path, error }),
        }
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
        Err(_) => create_whole(&path, content).map_err(PartsError::io(path)),
    }
}

/// Writes a file under its name at once, unless there is one with this name; false if there is.
fn create_whole(path: &Path, content: &[u8]) -> io::Result<bool> {
    let mut file = match OpenOptions::new().write(true).create_new(true).open(path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => return Ok(false),
        created => created?,
    };
    let written = file.write_all(content).and_then(|()| file.sync_all());
    if written.is_err() {
        // The error says why; half a file must not stay.
        let _ = fs::remove_file(path);
    }
    written.map(|()| true)
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

#[cfg(test)]
mod tests {
    use std::fs;

    use super::super::names::{SUCCESS, is_temporary};
    use super::{create_whole, write};

    /// Two runs that complete a folder at once: each removes what others have left, and may see the
    /// mark that the other one is about to set.
    #[test]
    fn a_temporary_file_that_another_run_removes_is_written_again() {
        let folder = std::env::temp_dir().join(format!("towermodes-race-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let has_removed = || {
            let names = fs::read_dir(&folder).expect("the folder").flatten();
            let mut names = names.filter_map(|entry| entry.file_name().into_string().ok());
            let seen = names.find(|name| is_temporary(name));
            seen.is_some_and(|name| fs::remove_file(folder.join(name)).is_ok())
        };
        let mut removed = 0;
        for _ in 0..200 {
            let written = std::thread::scope(|scope| {
                let other = scope.spawn(|| {
                    while !has_removed() {
                        if folder.join(SUCCESS).exists() {
                            return 0;
                        }
                    }
                    1
                });
                let written = write(&folder, SUCCESS, b"");
                removed += other.join().expect("the other run");
                written
            });
            assert!(written.is_ok(), "{written:?}");
            fs::remove_file(folder.join(SUCCESS)).expect("it is there");
        }
        fs::remove_dir_all(&folder).expect("removed");
        assert!(removed > 0);
    }

    /// On a disk without hard links the second of two sweeps must not replace the plan of the
    /// first.
    #[test]
    fn a_file_that_is_there_is_not_replaced() {
        let name = format!("towermodes-new-file-{}", std::process::id());
        let path = std::env::temp_dir().join(name);
        assert!(create_whole(&path, b"first").expect("written"));
        assert!(!create_whole(&path, b"second").expect("refused"));
        assert_eq!(fs::read(&path).expect("the file"), b"first");
        fs::remove_file(&path).expect("removed");
        assert!(create_whole(&path.join("no/folder"), b"").is_err());
    }
}
