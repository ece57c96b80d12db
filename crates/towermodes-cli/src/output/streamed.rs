//! A result that is written while it is computed.

use std::fs::File;
use std::io::{self, ErrorKind, IsTerminal, Stdout, Write};
use std::path::Path;

use towermodes_report::wording::printable;

use super::closed;
use super::place::Place;
use super::whole::{Staged, open_stream};
use crate::failure::Failure;
use crate::terminal::NOT_SHOWN;

/// A result that is written while it is computed: to a file, which gets its name when it is
/// complete, or to a stream.
pub(crate) struct Streamed {
    name: String,
    target: Target,
}

enum Target {
    File(Staged),
    Stream(File),
    Standard(Stdout),
    /// A terminal: control characters are replaced.
    Terminal(Stdout),
}

impl Streamed {
    /// Opens a file or standard output.
    pub(crate) fn to(output: Option<&Path>) -> Result<Self, Failure> {
        let name = output.map_or("standard output".into(), |path| path.display().to_string());
        match target(output) {
            Ok(target) => Ok(Self { name, target }),
            Err(error) => Err(Failure::unwritable(name, &error)),
        }
    }

    /// Gives the complete file its name.
    pub(crate) fn finish(self) -> Result<(), Failure> {
        let done = match self.target {
            Target::File(staged) => staged.finish(),
            Target::Stream(mut file) => file.flush(),
            Target::Standard(mut out) | Target::Terminal(mut out) => out.flush(),
        };
        match done {
            Ok(()) => Ok(()),
            Err(error) => Self::failed(self.name, &error),
        }
    }

    /// Its name in messages.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// The failure of a write. If the reader of a pipe has closed it, this is not a failure.
    pub(crate) fn failed(name: String, error: &io::Error) -> Result<(), Failure> {
        match error.kind() {
            ErrorKind::BrokenPipe => Ok(()),
            _ => Err(Failure::unwritable(name, error)),
        }
    }
}

fn target(output: Option<&Path>) -> io::Result<Target> {
    let Some(path) = output else {
        return match closed::is_closed() {
            true => Err(io::Error::other("it is closed; give --output PATH")),
            false if io::stdout().is_terminal() => Ok(Target::Terminal(io::stdout())),
            false => Ok(Target::Standard(io::stdout())),
        };
    };
    Ok(match Place::of(path)? {
        Place::File(target) => Target::File(Staged::begin(target)?),
        Place::Stream => Target::Stream(open_stream(path)?),
    })
}

/// Whole lines are written at a time, so that no character is divided.
impl Write for Streamed {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        match &mut self.target {
            Target::File(staged) => staged.write(bytes),
            Target::Stream(file) => file.write(bytes),
            Target::Standard(out) => out.write(bytes),
            Target::Terminal(out) => {
                let text = String::from_utf8_lossy(bytes);
                out.write_all(printable(&text, NOT_SHOWN).as_bytes())?;
                Ok(bytes.len())
            }
        }
    }

    fn flush(&mut self) -> io::Result<()> {
        match &mut self.target {
            Target::File(staged) => staged.flush(),
            Target::Stream(file) => file.flush(),
            Target::Standard(out) | Target::Terminal(out) => out.flush(),
        }
    }
}
