//! The format and the file of the output.

use std::path::{Path, PathBuf};

use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, Args, ValueEnum};

use super::ending::{Ending, EndingError};

/// The format of a result and the file it is written to.
#[derive(Debug, Args)]
pub(crate) struct Destination<F: Ending = Format> {
    /// Format of the result
    /// [default: from the extension of --output: .json, .csv or .txt (table); otherwise the table]
    #[arg(long, short, value_enum)]
    format: Option<F>,

    /// Write the result to a file instead of standard output (-)
    #[arg(long, short, value_name = "PATH")]
    output: Option<PathBuf>,
}

impl<F: Ending> Destination<F> {
    /// The format of the result: that of the option, otherwise that of the extension of the output
    /// file.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    pub(crate) fn format(&self) -> Result<F, EndingError> {
        let asked = F::asked(self.format, self.output())?;
        Ok(asked.unwrap_or(F::DEFAULT))
    }

    /// The file that the result is written to; none for standard output.
    pub(crate) fn output(&self) -> Option<&Path> {
        file_of(self.output.as_deref())
    }

    /// The output as given, including `-` for standard output.
    pub(crate) fn asked_output(&self) -> Option<&Path> {
        self.output.as_deref()
    }
}

/// The path of a file; none for `-`, which is standard output.
pub(crate) fn file_of(path: Option<&Path>) -> Option<&Path> {
    path.filter(|path| *path != Path::new("-"))
}

/// The format of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// Human-readable table.
    Table,
    /// All results.
    Json,
    /// One line per value of the table.
    Csv,
}

impl Ending for Format {
    const ENDINGS: &'static [(&'static str, Self)] = &[
        ("json", Self::Json),
        ("csv", Self::Csv),
        ("txt", Self::Table),
    ];
    const DEFAULT: Self = Self::Table;
}

/// The format of a result without CSV.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum TextFormat {
    /// Human-readable table.
    Table,
    /// All results.
    Json,
}

/// The option `--format` of a command, with a description of the lines of its CSV.
pub(crate) fn csv_lines(format: Arg, lines: &'static str) -> Arg {
    let described = |format: &Format| {
        let value = format.to_possible_value()?;
        Some(match format {
            Format::Csv => value.help(lines),
            _ => value,
        })
    };
    let values = Format::value_variants().iter().filter_map(described);
    let parser = PossibleValuesParser::new(values.collect::<Vec<_>>());
    format.value_parser(parser.try_map(|name| Format::from_str(&name, false)))
}
