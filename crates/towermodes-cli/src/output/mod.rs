//! Output of the results.

mod closed;
mod finished;
mod place;
mod streamed;
mod verdicts;
mod whole;

pub(crate) use finished::Finished;
pub(crate) use streamed::Streamed;

use std::io::{ErrorKind, IsTerminal, Write};
use std::path::{Path, PathBuf};

use same_file::Handle;
use towermodes_report::wording::printable;

use crate::failure::Failure;
use crate::terminal::NOT_SHOWN;

/// Writes data to a file or to standard output. For a terminal control characters are
/// replaced.
pub(crate) fn deliver(result: &[u8], output: Option<&Path>) -> Result<(), Failure> {
    match std::str::from_utf8(result) {
        Ok(text) if output.is_none() && std::io::stdout().is_terminal() => write(
            printable(text, NOT_SHOWN).as_bytes(),
            None,
            anstream::stdout().lock(),
        ),
        _ => write(result, output, anstream::stdout().lock()),
    }
}

/// As [`deliver`], for binary data, which are written to standard output unchanged.
pub(crate) fn deliver_bytes(result: &[u8], output: Option<&Path>) -> Result<(), Failure> {
    write(result, output, std::io::stdout().lock())
}

/// Writes a result of two files: both or neither.
pub(crate) fn deliver_both(first: (&Path, &[u8]), second: (&Path, &[u8])) -> Result<(), Failure> {
    let names = format!("{} and {}", first.0.display(), second.0.display());
    whole::write_both(first, second).map_err(|error| Failure::unwritable(names, &error))
}

fn write(result: &[u8], output: Option<&Path>, mut stdout: impl Write) -> Result<(), Failure> {
    let (name, done) = match output {
        Some(path) => (path.display().to_string(), whole::write(path, result)),
        None if closed::is_closed() => {
            let error = std::io::Error::other("it is closed; give --output PATH");
            ("standard output".into(), Err(error))
        }
        None => {
            let done = stdout.write_all(result).and_then(|()| stdout.flush());
            ("standard output".into(), done)
        }
    };
    match done {
        // The reader of a pipe has closed it; this is not an error.
        Err(error) if error.kind() == ErrorKind::BrokenPipe => Ok(()),
        done => done.map_err(|error| Failure::unwritable(name, &error)),
    }
}

/// Refuses to write pictures and pages to a terminal, unless `--output -` is given.
pub(crate) fn check_terminal(
    output: Option<&Path>,
    what: &'static str,
    example: &'static str,
) -> Result<(), Failure> {
    match output {
        None if std::io::stdout().is_terminal() => Err(Failure::usage(format!(
            "standard output is a terminal, which cannot display {what}"
        ))
        .hint_of(format!(
            "give --output {example}, a pipe or a redirection; --output - writes to the terminal anyway"
        ))),
        _ => Ok(()),
    }
}

/// Refuses a path at which no file can be written: a folder, or a file in a folder that does not
/// exist.
pub(crate) fn check_place(path: &Path) -> Result<(), Failure> {
    match place::Place::of(path) {
        Ok(_) => Ok(()),
        Err(error) => Err(Failure::unwritable(path.display(), &error)),
    }
}

/// Replaces a file, completely or not at all.
pub(crate) fn replace(path: &Path, content: &[u8]) -> Result<(), Failure> {
    let done = whole::write(path, content);
    done.map_err(|error| Failure::unwritable(path.display(), &error))
}

/// Copies a file to a name with `.bak` appended, or `.bak2` and so on if it exists; returns the
/// name.
pub(crate) fn back_up(path: &Path, content: &[u8]) -> Result<PathBuf, Failure> {
    let named = |ending: String| {
        let mut name = path.as_os_str().to_owned();
        name.push(ending);
        PathBuf::from(name)
    };
    let numbered = (2..MOST_BACKUPS).map(|number| named(format!(".bak{number}")));
    let names = std::iter::once(named(".bak".to_owned())).chain(numbered);
    whole::write_anew(names, content)
        .map_err(|error| Failure::unwritable(named(".bak".to_owned()).display(), &error))
}

/// Maximum number of backups of a file.
const MOST_BACKUPS: usize = 10_000;

/// Refuses an output that is the input file, also through links.
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
        (Ok(a), Ok(b)) if a == b && output.is_file() => Err(Failure::usage(format!(
            "{} is an input file; the result would overwrite it",
            output.display()
        ))
        .hint("give another path with --output")),
        _ => Ok(()),
    }
}

/// As [`check_not_input`], for all files of an input.
pub(crate) fn check_not_inputs<'a>(
    mut files: impl Iterator<Item = &'a str>,
    output: Option<&Path>,
) -> Result<(), Failure> {
    files.try_for_each(|file| check_not_input(Path::new(file), output))
}
