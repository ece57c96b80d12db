//! The format of an output: given by an option or by the file extension.

use std::fmt;
use std::path::Path;

use clap::ValueEnum;

/// An output format that can be selected by the file extension.
pub(crate) trait Ending: ValueEnum + Copy + PartialEq + Send + Sync + 'static {
    /// File extensions, without the dot, and their formats.
    const ENDINGS: &'static [(&'static str, Self)];
    /// The format if neither the option nor the extension gives one.
    const DEFAULT: Self;
    /// The option that selects the format.
    const OPTION: &'static str = "--format";

    /// The selected format: that of the option, otherwise that of the file extension; none if
    /// neither is given.
    ///
    /// # Errors
    /// The option and the extension contradict each other, or the extension is unknown.
    fn asked(option: Option<Self>, output: Option<&Path>) -> Result<Option<Self>, EndingError> {
        let Some(ending) = ending_of(output) else {
            return Ok(option);
        };
        let known = Self::ENDINGS.iter().find(|(own, _)| *own == ending);
        let by_ending = known.map(|(_, format)| *format);
        match (option, by_ending) {
            (Some(option), Some(by_ending)) if option != by_ending => Err(EndingError::Differ {
                said: format!("{} {}", Self::OPTION, name_of(&option)),
                ending,
                of: name_of(&by_ending),
            }),
            (Some(option), _) => Ok(Some(option)),
            (None, Some(by_ending)) => Ok(Some(by_ending)),
            (None, None) => Err(EndingError::Unknown {
                ending,
                known: Self::ENDINGS.iter().map(|(own, _)| *own).collect(),
                option: Self::OPTION,
            }),
        }
    }
}

/// Why the format of an output is not known.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum EndingError {
    /// Unknown file extension.
    Unknown {
        /// The extension.
        ending: String,
        /// The known extensions.
        known: Vec<&'static str>,
        /// The option that selects the format.
        option: &'static str,
    },
    /// The option and the extension contradict each other.
    Differ {
        /// The option with its value, as given.
        said: String,
        /// The extension.
        ending: String,
        /// The format of the extension.
        of: String,
    },
}

impl fmt::Display for EndingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unknown {
                ending,
                known,
                option,
            } => write!(
                f,
                "unknown file extension .{ending} of --output; use .{}, or give {option}",
                known.join(", .")
            ),
            Self::Differ { said, ending, of } => write!(
                f,
                "{said} contradicts the file extension .{ending} of --output, which means {of}; change one of them"
            ),
        }
    }
}

/// The file extension in lower case; none for a path without one, such as `/dev/null`.
fn ending_of(output: Option<&Path>) -> Option<String> {
    let ending = output?.extension()?.to_string_lossy();
    Some(ending.to_ascii_lowercase())
}

fn name_of(format: &impl ValueEnum) -> String {
    let value = format.to_possible_value();
    value.map_or_else(String::new, |value| value.get_name().to_owned())
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Ending, EndingError};
    use crate::args::Format;
    use crate::commands::{PageFormat, SolveFormat, Target, VerifyFormat};

    fn asked<F: Ending>(option: Option<F>, output: &str) -> Result<Option<F>, EndingError> {
        F::asked(option, Some(Path::new(output)))
    }

    #[test]
    fn the_ending_says_the_format() {
        assert_eq!(asked(None, "a/m.JSON"), Ok(Some(SolveFormat::Json)));
        assert_eq!(asked(None, "m.csv"), Ok(Some(Format::Csv)));
        assert_eq!(asked(None, "m.txt"), Ok(Some(Format::Table)));
        assert_eq!(asked(None, "v.md"), Ok(Some(VerifyFormat::Markdown)));
        assert_eq!(asked(None, "r.htm"), Ok(Some(PageFormat::Html)));
        assert_eq!(asked(None, "t.yml"), Ok(Some(Target::WindIo)));
        // Neither the option nor the extension gives a format.
        assert_eq!(asked::<Format>(None, "/dev/null"), Ok(None));
        assert_eq!(Format::asked(None, None), Ok(None));
    }

    #[test]
    fn an_option_and_an_ending_agree() {
        assert_eq!(asked(Some(Format::Csv), "m.csv"), Ok(Some(Format::Csv)));
        assert_eq!(asked(Some(Format::Csv), "m.data"), Ok(Some(Format::Csv)));
        let error = asked(Some(Format::Csv), "m.json").expect_err("refused");
        assert_eq!(
            error.to_string(),
            "--format csv contradicts the file extension .json of --output, which means json; change one of them"
        );
        assert!(asked(Some(Target::Toml), "t.bmi").is_err());
    }

    #[test]
    fn an_ending_of_no_format_is_refused_with_those_that_are() {
        let error = asked::<PageFormat>(None, "r.pdf").expect_err("refused");
        assert_eq!(
            error.to_string(),
            "unknown file extension .pdf of --output; use .html, .htm, .md, .markdown, or give --format"
        );
    }
}
