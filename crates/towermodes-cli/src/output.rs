//! Where results go.

use std::fs;
use std::io::{ErrorKind, Write};
use std::path::{Path, PathBuf};

use same_file::Handle;

use crate::failure::Failure;

/// Writes a finished result to a file, or to standard output.
pub(crate) fn deliver(result: &[u8], output: Option<&Path>) -> Result<(), Failure> {
    write(result, output, anstream::stdout().lock())
}

/// The same for what is no text: it goes to standard output byte by byte.
pub(crate) fn deliver_bytes(result: &[u8], output: Option<&Path>) -> Result<(), Failure> {
    write(result, output, std::io::stdout().lock())
}

fn write(result: &[u8], output: Option<&Path>, mut stdout: impl Write) -> Result<(), Failure> {
    let (name, done) = match output {
        Some(path) => (path.display().to_string(), fs::write(path, result)),
        None => {
            let done = stdout.write_all(result).and_then(|()| stdout.flush());
            ("standard output".into(), done)
        }
    };
    match done {
        // The reader of a pipe has seen enough: nothing is wrong, and what was judged still counts.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        done => done.map_err(|error| Failure::Unwritable(name, error)),
    }
}

/// Writes a file anew: a new one beside it takes its place when it is complete, so that no interruption leaves half of one. Links stay.
pub(crate) fn replace(path: &Path, text: &[u8]) -> Result<(), Failure> {
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_path_buf());
    let mut name = path.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}.tmp", std::process::id()));
    let new = path.with_file_name(name);
    let done = fs::write(&new, text)
        .and_then(|()| match fs::metadata(&path) {
            Ok(old) => fs::set_permissions(&new, old.permissions()),
            Err(_) => Ok(()),
        })
        .and_then(|()| fs::rename(&new, &path));
    done.map_err(|error| {
        let _ = fs::remove_file(&new);
        Failure::Unwritable(path.display().to_string(), error)
    })
}

/// Keeps a file as it is under a name with `.bak` at its end, or `.bak2` and so on where that is taken; gives the name.
pub(crate) fn back_up(path: &Path, text: &[u8]) -> Result<PathBuf, Failure> {
    let named = |ending: String| {
        let mut name = path.as_os_str().to_owned();
        name.push(ending);
        PathBuf::from(name)
    };
    let numbered = (2..).map(|number| named(format!(".bak{number}")));
    let mut names = std::iter::once(named(".bak".to_owned())).chain(numbered);
    let free = names.find(|name| !name.exists());
    let free = free.unwrap_or_else(|| named(".bak".to_owned()));
    replace(&free, text)?;
    Ok(free)
}

/// Refuses an output that is the input, by whatever name or link.
pub(crate) fn check_not_input(input: &Path, output: Option<&Path>) -> Result<(), Failure> {
    let Some(output) = output else {
        return Ok(());
    };
    let input = if input == Path::new("-") {
        Handle::stdin()
    } else {
        Handle::from_path(input)
    };
    match (input, Handle::from_path(output)) {
        (Ok(a), Ok(b)) if a == b && output.is_file() => {
            Err(Failure::OverwritesInput(output.display().to_string()))
        }
        _ => Ok(()),
    }
}

/// The same for every file that an input was read from.
pub(crate) fn check_not_inputs<'a>(
    mut files: impl Iterator<Item = &'a str>,
    output: Option<&Path>,
) -> Result<(), Failure> {
    files.try_for_each(|file| check_not_input(Path::new(file), output))
}
