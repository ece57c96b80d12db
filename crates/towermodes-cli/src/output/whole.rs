//! Files are written completely or not at all: a new file in the same folder replaces the old one
//! when it is completely on the disk.

use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::thread;
use std::time::Duration;

use super::place::{Place, folder_of};

/// Number of names that are tried for a new file; a name in use belongs to a file that a killed
/// process left.
const MOST_NAMES: usize = 1000;
/// Number of attempts to get a lock before the program continues without it, and the time between
/// them.
const LOOKS: usize = 250;
const BETWEEN_LOOKS: Duration = Duration::from_millis(20);

/// Writes a file or a stream.
pub(super) fn write(path: &Path, content: &[u8]) -> io::Result<()> {
    match Place::of(path)? {
        Place::File(target) => Staged::new(target, content)?.take_place(),
        Place::Stream => {
            let mut stream = open_stream(path)?;
            stream.write_all(content).and_then(|()| stream.flush())
        }
    }
}

/// Opens a stream at its end, because it may be a file to which other programs write too.
pub(super) fn open_stream(path: &Path) -> io::Result<File> {
    OpenOptions::new().append(true).open(path)
}

/// Writes two files: both or neither.
pub(super) fn write_both(first: (&Path, &[u8]), second: (&Path, &[u8])) -> io::Result<()> {
    let staged = |(path, content): (&Path, &[u8])| match Place::of(path)? {
        Place::File(target) => Staged::new(target, content),
        Place::Stream => Err(io::Error::new(
            ErrorKind::InvalidInput,
            "two files are written; give the path of a file",
        )),
    };
    let (one, other) = (staged(first)?, staged(second)?);
    // Two simultaneous writers do not mix their files.
    let _lock = locked(&folder_of(first.0)?);
    let old = Kept::of(&one.target)?;
    one.take_place()?;
    other.take_place().inspect_err(|_| old.put_back())
}

/// Writes a new file under the first of several names that is not in use.
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

/// A new file in the folder of the file that it will replace; removed on drop.
pub(super) struct Staged {
    file: File,
    new: PathBuf,
    target: PathBuf,
}

impl Staged {
    /// An empty new file.
    pub(super) fn begin(target: PathBuf) -> io::Result<Self> {
        // A write-protected file is not replaced.
        match OpenOptions::new().write(true).open(&target) {
            Err(error) if error.kind() != ErrorKind::NotFound => return Err(error),
            _ => {}
        }
        let (file, new) = create_beside(&target)?;
        Ok(Self { file, new, target })
    }

    /// A complete new file.
    fn new(target: PathBuf, content: &[u8]) -> io::Result<Self> {
        let mut staged = Self::begin(target)?;
        staged.write_all(content)?;
        staged.complete()?;
        Ok(staged)
    }

    /// Completes the file: sets the owner of the old file and writes everything to the disk.
    fn complete(&self) -> io::Result<()> {
        if let Ok(old) = fs::metadata(&self.target) {
            keep_owner(&self.file, &old);
            self.file.set_permissions(old.permissions())?;
        }
        // A full disk may be detected here.
        self.file.sync_all()
    }

    /// Completes the new file and replaces the old file by it.
    pub(super) fn finish(self) -> io::Result<()> {
        self.complete()?;
        self.take_place()
    }

    fn take_place(self) -> io::Result<()> {
        fs::rename(&self.new, &self.target)?;
        // The file is complete; syncing the folder is best effort.
        if let Some(folder) = self.target.parent().and_then(|f| File::open(f).ok()) {
            let _ = folder.sync_all();
        }
        Ok(())
    }
}

impl Write for Staged {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for Staged {
    fn drop(&mut self) {
        // The temporary file no longer exists after the rename.
        let _ = fs::remove_file(&self.new);
    }
}

/// Creates a new file with a unique name in the folder of another file.
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

/// Sets owner and group of the old file on the new one, if permitted.
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

/// The old file under a second name until it is no longer needed.
struct Kept {
    name: PathBuf,
    /// The second name; none if there was no old file.
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

    /// Restores the old file.
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

/// Locks a folder, if the system supports it, so that only one process writes two files there at a
/// time. After a timeout the program continues without the lock.
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
