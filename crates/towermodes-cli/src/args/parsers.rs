//! How values on the command line are read.

use clap::builder::{PossibleValuesParser, TypedValueParser};
use towermodes::Method;
use towermodes::tower::FASTEST_RPM;

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

/// A height in m.
pub(super) fn height_parser(text: &str) -> Result<f64, String> {
    let height_m = text
        .parse()
        .ok()
        .filter(|height_m: &f64| height_m.is_finite());
    height_m.ok_or_else(|| "must be a number, in m".into())
}

/// A percentage that damping can have.
pub(super) fn damping_parser(text: &str) -> Result<f64, String> {
    let percent = text.parse().ok().filter(|p| (0.0..=100.0).contains(p));
    percent.ok_or_else(|| "must be a number from 0 to 100, in percent of critical".into())
}

/// A set and a subset of it, from 1.
pub(super) fn subset_parser(text: &str) -> Result<(usize, usize), String> {
    let parsed = text.split_once(',').and_then(|(set, subset)| {
        let number = |text: &str| text.trim().parse().ok().filter(|n: &usize| *n > 0);
        Some((number(set)?, number(subset)?))
    });
    parsed.ok_or_else(|| "must be two whole numbers from 1, as 1,2".into())
}

/// A version of OpenFAST, as 4.2.
pub(super) fn openfast_parser(text: &str) -> Result<(u32, u32), String> {
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
        _ => Err("must be a version of OpenFAST, as 4.2, or 8 for FAST 8".into()),
    }
}

/// Pixels a unit of a drawing.
pub(super) fn scale_parser(text: &str) -> Result<f64, String> {
    let scale = text.parse().ok();
    let scale = scale.filter(|scale: &f64| scale.is_finite() && *scale > 0.0);
    scale.ok_or_else(|| "must be a number above 0, as 2".into())
}

/// A margin in percent.
pub(super) fn margin_parser(text: &str) -> Result<f64, String> {
    let percent = text.parse().ok().filter(|p: &f64| *p > 0.0 && *p < 100.0);
    percent.ok_or_else(|| "must be a number above 0 and below 100, in percent, as 5".into())
}

/// The lowest and the highest speed of a rotor, or its only one, rpm.
pub(super) fn speeds_parser(text: &str) -> Result<(f64, f64), String> {
    let speed = |text: &str| {
        let rpm = text.trim().parse().ok();
        rpm.filter(|rpm| (0.0..=FASTEST_RPM).contains(rpm))
            .ok_or_else(|| {
                format!(
                    "`{}` must be a speed from 0 to {FASTEST_RPM} rpm",
                    text.trim()
                )
            })
    };
    let (lowest, highest) = match text.split_once(',') {
        Some((lowest, highest)) => (speed(lowest)?, speed(highest)?),
        None => (speed(text)?, speed(text)?),
    };
    if lowest > highest {
        return Err(format!("the lowest speed comes first: {highest},{lowest}"));
    }
    if highest == 0.0 {
        return Err(
            "a rotor that stands still excites nothing; the highest speed must be above 0".into(),
        );
    }
    Ok((lowest, highest))
}
