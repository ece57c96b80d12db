//! Parsers of option values.

use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use towermodes::tower::FASTEST_RPM;
use towermodes::{AddedMassAt, Method};
use towermodes_analysis::influence::Tolerance;
use towermodes_files::{Setting, SettingError};

/// A method by its name, with its one-line description in the help.
pub(crate) fn method_parser() -> impl TypedValueParser<Value = Method> {
    let value = |method: Method| PossibleValue::new(method.name()).help(method.description());
    PossibleValuesParser::new(Method::ALL.map(value))
        .map(|name| Method::named(&name).unwrap_or_default())
}

/// An input value of a tower that is set by name.
pub(crate) fn setting_parser(text: &str) -> Result<Setting, String> {
    text.parse()
        .map_err(|error: SettingError| error.to_string())
}

/// A tolerance: `2%`, `NAME=2%` or `NAME=AMOUNT`.
pub(crate) fn tolerance_parser(text: &str) -> Result<(Option<String>, Tolerance), String> {
    let (name, value) = match text.rsplit_once('=') {
        Some((name, value)) => (Some(name.trim().to_owned()), value),
        None => (None, text),
    };
    let (number, is_percent) = match value.trim().strip_suffix('%') {
        Some(number) => (number.trim(), true),
        None => (value.trim(), false),
    };
    let amount: f64 = number.parse().map_err(|_| match &name {
        Some(name) => {
            format!("`{value}` is not a tolerance value; write {name}=2% or {name}=AMOUNT")
        }
        None => format!("`{value}` has no tolerance value; write 2%, {value}=2% or {value}=AMOUNT"),
    })?;
    if !(amount.is_finite() && amount >= 0.0) {
        return Err("a tolerance is a number of at least 0".to_owned());
    }
    match (is_percent, &name) {
        (true, _) => Ok((name, Tolerance::Percent(amount))),
        (false, Some(_)) => Ok((name, Tolerance::Amount(amount))),
        (false, None) => Err(format!(
            "an absolute tolerance needs the name of its input value, because units differ; write NAME={number}, or {number}% for every input"
        )),
    }
}

/// A number that satisfies `is_right`; otherwise the message.
fn number(text: &str, is_right: fn(f64) -> bool, message: &str) -> Result<f64, String> {
    let number = text.trim().parse().ok();
    let number = number.filter(|number| is_right(*number));
    number.ok_or_else(|| message.to_owned())
}

/// The position of a hinge as a fraction of the segment length.
pub(crate) fn hinge_parser(text: &str) -> Result<f64, String> {
    number(
        text,
        |k| k > 0.0 && k < 0.5,
        "must be greater than 0 and less than 0.5 (the middle of the segment)",
    )
}

/// The frequency at which a floating platform has its added mass.
pub(crate) fn added_mass_parser(text: &str) -> Result<AddedMassAt, String> {
    AddedMassAt::named(text.trim())
        .ok_or_else(|| "must be own, infinite, zero or a frequency in Hz, 0 or positive".to_owned())
}

/// A whole number from `least` to `most`; the message gives both limits.
pub(crate) fn number_parser(
    least: usize,
    most: usize,
) -> impl Fn(&str) -> Result<usize, String> + Clone + Send + Sync {
    move |text| match text.parse::<usize>() {
        Ok(number) if (least..=most).contains(&number) => Ok(number),
        _ if most == usize::MAX => Err(format!("must be a whole number, at least {least}")),
        _ => Err(format!("must be a whole number from {least} to {most}")),
    }
}

/// A height in m.
pub(crate) fn height_parser(text: &str) -> Result<f64, String> {
    number(text, f64::is_finite, "must be a number, in m")
}

/// A positive number.
pub(crate) fn positive_parser(text: &str) -> Result<f64, String> {
    number(
        text,
        |x| x > 0.0 && x.is_finite(),
        "must be a number greater than 0",
    )
}

/// The loss factor of a part: `soil=0.02`.
pub(crate) fn loss_factor_parser(text: &str) -> Result<(String, f64), String> {
    let (part, value) = text
        .rsplit_once('=')
        .filter(|(part, _)| !part.trim().is_empty())
        .ok_or("must be PART=VALUE, for example soil=0.02")?;
    let value = value.trim().parse().ok();
    let value = value.filter(|value: &f64| (0.0..=1.0).contains(value));
    let value = value.ok_or(
        "a loss factor is a number from 0 to 1: twice the damping ratio, as a fraction and not in percent",
    )?;
    Ok((part.trim().to_owned(), value))
}

/// A damping ratio in percent of critical.
pub(crate) fn damping_parser(text: &str) -> Result<f64, String> {
    number(
        text,
        |p| (0.0..=100.0).contains(&p),
        "must be a number from 0 to 100 (percent of critical damping)",
    )
}

/// A set and a subset, both counted from 1.
pub(crate) fn subset_parser(text: &str) -> Result<(usize, usize), String> {
    let parsed = text.split_once(',').and_then(|(set, subset)| {
        let number = |text: &str| text.trim().parse().ok().filter(|n: &usize| *n > 0);
        Some((number(set)?, number(subset)?))
    });
    parsed.ok_or_else(|| "must be two whole numbers greater than 0, for example 1,2".into())
}

/// A version of OpenFAST, for example 4.2.
pub(crate) fn openfast_parser(text: &str) -> Result<(u32, u32), String> {
    let text = text.strip_prefix('v').unwrap_or(text);
    let mut parts = text.split('.').map(|part| part.parse::<u32>().ok());
    let parsed = match (parts.next(), parts.next()) {
        (Some(Some(major)), None) => Some((major, 0)),
        (Some(Some(major)), Some(Some(minor))) => Some((major, minor)),
        _ => None,
    };
    match parsed {
        // FAST 7 and 8 came before OpenFAST 1.
        Some((7 | 8, _)) => Ok((0, 0)),
        Some(version) if (1..=6).contains(&version.0) => Ok(version),
        _ => Err("must be a version of OpenFAST, for example 4.2, or 8 for FAST 8".into()),
    }
}

/// Pixels per unit of the drawing.
pub(crate) fn scale_parser(text: &str) -> Result<f64, String> {
    number(
        text,
        |x| x > 0.0 && x.is_finite(),
        "must be a number greater than 0, for example 2",
    )
}

/// A margin in percent.
pub(crate) fn margin_parser(text: &str) -> Result<f64, String> {
    number(
        text,
        |p| p > 0.0 && p < 100.0,
        "must be a number between 0 and 100 (percent), for example 5",
    )
}

/// A frequency in Hz above 0.
pub(crate) fn frequency_parser(text: &str) -> Result<f64, String> {
    number(
        text,
        |hz| hz > 0.0 && hz.is_finite(),
        "must be a frequency above 0 Hz, for example 3.5",
    )
}

/// The lowest and the highest rotor speed, or one constant speed, in rpm.
pub(crate) fn speeds_parser(text: &str) -> Result<(f64, f64), String> {
    let speed = |text: &str| {
        let rpm = text.trim().parse().ok();
        rpm.filter(|rpm| (0.0..=FASTEST_RPM).contains(rpm))
            .ok_or_else(|| {
                format!(
                    "`{}` is not a rotor speed from 0 to {FASTEST_RPM} rpm; give LOWEST,HIGHEST or one speed",
                    text.trim()
                )
            })
    };
    let count = text.split(',').count();
    if count > 2 {
        return Err(format!(
            "{count} speeds are given; give LOWEST,HIGHEST or one speed, for example 6.9,12.1"
        ));
    }
    let (lowest, highest) = match text.split_once(',') {
        Some((lowest, highest)) => (speed(lowest)?, speed(highest)?),
        None => (speed(text)?, speed(text)?),
    };
    if lowest > highest {
        return Err(format!(
            "the lowest speed must come first: {highest},{lowest}"
        ));
    }
    if highest == 0.0 {
        return Err(
            "the highest speed must be greater than 0: a rotor at standstill has no excitation"
                .into(),
        );
    }
    Ok((lowest, highest))
}
