//! How an output is written: as an option says, or as the ending of its name does.

use std::fmt;
use std::path::Path;

use clap::ValueEnum;

/// A format of outputs that files have endings for.
pub(crate) trait Ending: ValueEnum + Copy + PartialEq + 'static {
    /// The endings that say a format, without the dot.
    const ENDINGS: &'static [(&'static str, Self)];
    /// The option that says it.
    const OPTION: &'static str = "--format";

    /// The format asked for: by the option, else by the ending of the file; none if neither says
    /// one.
    ///
    /// # Errors
    /// The two say different formats, or the ending is of none.
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

/// Why it is not known how an output is to be written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum EndingError {
    /// No format has this ending.
    Unknown {
        /// The ending.
        ending: String,
        /// Those that say a format.
        known: Vec<&'static str>,
        /// The option that says it too.
        option: &'static str,
    },
    /// The option says another format than the ending.
    Differ {
        /// The option with its value.
        said: String,
        /// The ending.
        ending: String,
        /// The format that it says.
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
                "the ending .{ending} of --output says no format of this command: use .{}, or {option} with any ending",
                known.join(", .")
            ),
            Self::Differ { said, ending, of } => write!(
                f,
                "{said} does not go with an --output that ends in .{ending}, which is for {of}; change one of them"
            ),
        }
    }
}

/// The ending of a file's name in small letters; what is no file, as `/dev/null`, has none.
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
    use crate::args::{Format, PageFormat, SolveFormat, Target, VerifyFormat};

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
        // Neither the option nor the ending says one.
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
            "--format csv does not go with an --output that ends in .json, which is for json; change one of them"
        );
        assert!(asked(Some(Target::Toml), "t.bmi").is_err());
    }

    #[test]
    fn an_ending_of_no_format_is_refused_with_those_that_are() {
        let error = asked::<PageFormat>(None, "r.pdf").expect_err("refused");
        assert_eq!(
            error.to_string(),
            "the ending .pdf of --output says no format of this command: use .html, .htm, .md, .markdown, or --format with any ending"
        );
    }
}
