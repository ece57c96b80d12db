//! Files that are written whole or not at all: a new one beside the old one takes its place when
//! all of it is on the disk.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use super::place::{Place, folder_of};

/// Names that are tried for a new file: each one that is taken is left of a process that was
/// killed.
const MOST_NAMES: usize = 1000;
/// Looks at a lock before the work goes on without it, and the time between two of them.
const LOOKS: usize = 250;
const BETWEEN_LOOKS: Duration = Duration::from_millis(20);

/// Writes a file, or to what is none.
pub(super) fn write(path: &Path, content: &[u8]) -> io::Result<()> {
    match Place::of(path)? {
        Place::File(target) => Staged::new(target, content)?.take_place(),
        Place::Stream => {
            // At its end, if a file is behind it that others write to.
            let mut stream = OpenOptions::new().append(true).open(path)?;
            stream.write_all(content).and_then(|()| stream.flush())
        }
    }
}

/// Writes two files that belong together: both, or neither.
pub(super) fn write_both(first: (&Path, &[u8]), second: (&Path, &[u8])) -> io::Result<()> {
    let staged = |(path, content): (&Path, &[u8])| match Place::of(path)? {
        Place::File(target) => Staged::new(target, content),
        Place::Stream => Err(io::Error::new(
            ErrorKind::InvalidInput,
            "two files belong together here; give the path of a file",
        )),
    };
    let (one, other) = (staged(first)?, staged(second)?);
    // Two writers at once do not mix their files.
    let _lock = locked(&folder_of(first.0)?);
    let old = Kept::of(&one.target)?;
    one.take_place()?;
    other.take_place().inspect_err(|_| old.put_back())
}

/// Writes a file under the first of several names that is free.
pub(super) fn write_anew(
    names: impl Iterator<Item = PathBuf>,
    content: &[u8],
) -> io::Result<PathBuf> {
    let mut staged = None;
    for name in names {
        let staged = match &mut staged {
            Some(staged) => staged,
            None => staged.insert(Staged::new(name.clone(), content)?),
        };
        // A second name for the file, unless there is one already: nobody else gets it at the same
        // time.
        match fs::hard_link(&staged.new, &name) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Ok(()) => return Ok(name),
            // A disk without second names.
            Err(_) if !name.exists() => return fs::copy(&staged.new, &name).map(|_| name),
            Err(_) => {}
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}

/// A complete new file beside the one whose place it will take; dropped before that it is gone.
struct Staged {
    new: PathBuf,
    target: PathBuf,
}

impl Staged {
    /// Writes it, down to the disk.
    fn new(target: PathBuf, content: &[u8]) -> io::Result<Self> {
        // A file that may not be written is not replaced either.
        match OpenOptions::new().write(true).open(&target) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        let (file, new) = create_beside(&target)?;
        let staged = Self { new, target };
        staged.fill(file, content).map(|()| staged)
    }

    fn fill(&self, mut file: File, content: &[u8]) -> io::Result<()> {
        file.write_all(content)?;
        if let Ok(old) = fs::metadata(&self.target) {
            keep_owner(&file, &old);
            file.set_permissions(old.permissions())?;
        }
        // A full disk may be found out here.
        file.sync_all()
    }

    fn take_place(self) -> io::Result<()> {
        fs::rename(&self.new, &self.target)?;
        // Done already; that the name outlasts a loss of power is asked for, not needed.
        if let Some(folder) = self.target.parent().and_then(|f| File::open(f).ok()) {
            let _ = folder.sync_all();
        }
        Ok(())
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        // After it took its place there is none.
        let _ = fs::remove_file(&self.new);
    }
}

/// A file under a name of its own in the folder of another.
fn create_beside(target: &Path) -> io::Result<(File, PathBuf)> {
    let process = std::process::id();
    for number in 0..MOST_NAMES {
        let new = target.with_file_name(format!(".towermodes-{process}-{number}.tmp"));
        match OpenOptions::new().write(true).create_new(true).open(&new) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            created => return created.map(|file| (file, new)),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}

/// Gives a new file to the owner and the group of the old one, as far as that is allowed.
#[cfg(unix)]
fn keep_owner(file: &File, old: &fs::Metadata) {
    use std::os::unix::fs::{MetadataExt, fchown};
    let is_same = |new: fs::Metadata| (new.uid(), new.gid()) == (old.uid(), old.gid());
    if !file.metadata().is_ok_and(is_same) {
        let _ = fchown(file, None, Some(old.gid()));
        let _ = fchown(file, Some(old.uid()), None);
    }
}

#[cfg(not(unix))]
fn keep_owner(_: &File, _: &fs::Metadata) {}

/// An old file under a second name, until it is certain that it is not needed any more.
struct Kept {
    name: PathBuf,
    /// None if there was none.
    second: Option<PathBuf>,
}

impl Kept {
    fn of(name: &Path) -> io::Result<Self> {
        let name = name.to_path_buf();
        if !name.exists() {
            return Ok(Self { name, second: None });
        }
        let (_, second) = create_beside(&name)?;
        fs::copy(&name, &second)?;
        let second = Some(second);
        Ok(Self { name, second })
    }

    /// Makes all as it was.
    fn put_back(&self) {
        let _ = match &self.second {
            Some(second) => fs::rename(second, &self.name),
            None => fs::remove_file(&self.name),
        };
    }
}

impl Drop for Kept {
    fn drop(&mut self) {
        if let Some(second) = &self.second {
            let _ = fs::remove_file(second);
        }
    }
}

/// A lock of a folder, where the system has such: one writer of two files at a time. Who waits too
/// long goes on.
fn locked(folder: &Path) -> Option<File> {
    let folder = File::open(folder).ok()?;
    for _ in 0..LOOKS {
        match folder.try_lock() {
            Ok(()) => return Some(folder),
            Err(fs::TryLockError::WouldBlock) => thread::sleep(BETWEEN_LOOKS),
            Err(fs::TryLockError::Error(_)) => return None,
        }
    }
    None
}
