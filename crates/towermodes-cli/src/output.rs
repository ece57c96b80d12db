//! Where results go.

use std::io::{IsTerminal, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use same_file::Handle;

use crate::failure::Failure;

/// Writes a finished result to a file, or to standard output.
pub(crate) fn deliver(result: &[u8], output: Option<&Path>) -> Result<(), Failure> {
    let (name, done) = match output {
        Some(path) => (path.display().to_string(), std::fs::write(path, result)),
        None => ("standard output".into(), to_standard_output(result)),
    };
    done.map_err(|error| Failure::Unwritable(name, error))
}

/// Writes a file anew.
pub(crate) fn replace(path: &Path, text: &[u8]) -> Result<(), Failure> {
    deliver(text, Some(path))
}

fn to_standard_output(result: &[u8]) -> std::io::Result<()> {
    let mut stdout = anstream::stdout().lock();
    stdout.write_all(result)?;
    stdout.flush()
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

/// Work that takes no longer than this is done without a word.
const QUIET: Duration = Duration::from_secs(1);

/// Says what is done, to people who wait.
pub(crate) struct Progress {
    started: Instant,
    is_watched: bool,
}

impl Progress {
    /// From now on.
    pub(crate) fn start() -> Self {
        Self {
            started: Instant::now(),
            is_watched: std::io::stderr().is_terminal(),
        }
    }

    /// Says that something is done, if somebody has waited for long.
    pub(crate) fn say(&self, what: &str) {
        if self.is_watched && self.started.elapsed() > QUIET {
            anstream::eprintln!(
                "done: {what} ({:.1} s)",
                self.started.elapsed().as_secs_f64()
            );
        }
    }
}
