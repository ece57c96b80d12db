//! The target of an output path.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Maximum number of links in a chain.
const MOST_LINKS: usize = 40;

/// The target of a path.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A regular file, existing or not: the path at the end of all links.
    File(PathBuf),
    /// A terminal, a pipe, a device, or an open stream such as `/dev/stdout`.
    Stream,
}

impl Place {
    /// Finds the target of a path.
    ///
    /// # Errors
    /// The path is a folder, or its folder does not exist.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(found) if found.is_dir() => return Err(is_folder()),
            Ok(found) if !found.is_file() => return Ok(Self::Stream),
            _ => {}
        }
        // `results/` is a folder, whether it exists or not.
        if path.as_os_str().as_encoded_bytes().ends_with(b"/") {
            return Err(is_folder());
        }
        let mut path = path.to_path_buf();
        for _ in 0..MOST_LINKS {
            let name = path.file_name().ok_or_else(is_folder)?;
            let folder = folder_of(&path)?;
            // An open file of a process has a position in a stream; it cannot be replaced by
            // another file.
            if folder.starts_with("/proc") {
                return Ok(Self::Stream);
            }
            let end = folder.join(name);
            match fs::read_link(&end) {
                Ok(target) => path = folder.join(target),
                Err(_) => return Ok(Self::File(end)),
            }
        }
        Err(io::Error::other("the symbolic link refers to itself"))
    }
}

/// The folder of a path, without links.
pub(super) fn folder_of(path: &Path) -> io::Result<PathBuf> {
    let folder = path
        .parent()
        .filter(|folder| !folder.as_os_str().is_empty());
    let folder = folder.unwrap_or(Path::new("."));
    fs::canonicalize(folder).map_err(|error| match error.kind() {
        ErrorKind::NotFound => {
            let text = format!("the folder {} does not exist", folder.display());
            io::Error::new(ErrorKind::NotFound, text)
        }
        _ => error,
    })
}

fn is_folder() -> io::Error {
    let text = "this is a folder; give the path of a file in it";
    io::Error::new(ErrorKind::IsADirectory, text)
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs;
    use std::os::unix::fs::symlink;
    use std::path::Path;

    use super::Place;

    #[test]
    fn links_are_followed_and_streams_are_none() {
        let folder = std::env::temp_dir().join(format!("towermodes-place-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let folder = folder.canonicalize().expect("a folder");
        symlink("b", folder.join("a")).expect("a link");
        symlink("c", folder.join("b")).expect("a link");
        let end = Place::File(folder.join("c"));
        // Nothing is there yet, and then a file.
        assert_eq!(Place::of(&folder.join("a")).ok(), Some(end));
        fs::write(folder.join("c"), "").expect("written");
        let end = Place::File(folder.join("c"));
        assert_eq!(Place::of(&folder.join("a")).ok(), Some(end));
        symlink("round", folder.join("round")).expect("a link");
        assert!(Place::of(&folder.join("round")).is_err());
        assert!(Place::of(&folder.join("missing/file")).is_err());
        assert!(Place::of(&folder.join("missing/")).is_err());
        assert!(Place::of(&folder).is_err());
        fs::remove_dir_all(&folder).expect("ours");
        assert_eq!(Place::of(Path::new("/dev/null")).ok(), Some(Place::Stream));
    }

    /// Whatever it is: in a test often a pipe or a file.
    #[cfg(target_os = "linux")]
    #[test]
    fn what_is_open_already_is_a_stream() {
        for path in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"] {
            assert_eq!(Place::of(Path::new(path)).ok(), Some(Place::Stream));
        }
    }
}
