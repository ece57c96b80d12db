//! How values on the command line are read.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use towermodes::Method;

/// A method by its name.
pub(super) fn method_parser() -> impl TypedValueParser<Value = Method> {
    PossibleValuesParser::new(Method::ALL.map(Method::name))
        .map(|name| Method::named(&name).unwrap_or_default())
}

/// The place of a hinge.
pub(super) fn hinge_parser(text: &str) -> Result<f64, String> {
    let position = text.parse().ok().filter(|k: &f64| *k > 0.0 && *k < 0.5);
    position.ok_or_else(|| "must be more than 0 and less than 0.5, the middle of a segment".into())
}

/// A whole number from `least` to `most`, with both in the message.
pub(super) fn number_parser(
    least: usize,
    most: usize,
) -> impl Fn(&str) -> Result<usize, String> + Clone + Send + Sync {
    move |text| match text.parse::<usize>() {
        Ok(number) if (least..=most).contains(&number) => Ok(number),
        _ if most == usize::MAX => Err(format!("must be a whole number, at least {least}")),
        _ => Err(format!("must be a whole number from {least} to {most}")),
    }
}
