//! The output of commands that compute input values of a tower: the result is printed, and the
//! tower with the computed values is written to a file.

use std::path::{Path, PathBuf};

use clap::Args;

use super::output::{TextFormat, file_of};

/// The format of the printed result, and the file of the tower.
#[derive(Debug, Args)]
pub(crate) struct FoundArguments {
    /// Format of the printed result
    #[arg(long, short, value_enum, default_value_t = TextFormat::Table)]
    pub(crate) format: TextFormat,

    /// Write the resulting tower to this file, in TOML; if FILE is a tower file in TOML, only its
    /// values are changed, and its comments are kept
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl FoundArguments {
    /// The file that the tower is written to; none if it is not written.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// The message if an output with this extension is not possible.
    pub(crate) fn check(&self) -> Result<(), &'static str> {
        let Some(path) = &self.output else {
            return Ok(());
        };
        let ending = path.extension().map(|ending| ending.to_ascii_lowercase());
        match ending.as_ref().and_then(|ending| ending.to_str()) {
            Some("toml") => Ok(()),
            _ => Err(
                "the tower is written in TOML: use --output FILE.toml; `towermodes convert` writes other formats",
            ),
        }
    }
}
