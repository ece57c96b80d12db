//! The sentences of remarks.

use std::fmt;

use towermodes::ModeName;
use towermodes::number::Rounded;

use super::pairing::Ambiguity;
use super::remark::{Remark, UnknownChange};

impl fmt::Display for UnknownChange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let amount = self.amount;
        match self.is_factor {
            true => write!(f, "{} times {}", self.name, Rounded(rounded(amount))),
            false => write!(f, "{} plus {}", self.name, Rounded(rounded(amount))),
        }
    }
}

/// Four digits, so that the printed value of an unknown with a large effect has the stated effect.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}

/// "a, b and c".
fn listed(parts: &[String]) -> String {
    match parts {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => parts.concat(),
    }
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotToldApart {
                changes,
                deviations,
            } => {
                let names: Vec<String> = changes.iter().map(|one| one.name.clone()).collect();
                let changes: Vec<String> = changes.iter().map(ToString::to_string).collect();
                let subject = match &names[..] {
                    [one] => format!("the measurements hardly determine {one}"),
                    _ => format!("the measurements cannot distinguish {}", listed(&names)),
                };
                let changes = listed(&changes);
                write!(f, "{subject}: with {changes} the measured frequencies ")?;
                match *deviations < 0.005 {
                    true => f.write_str("hardly change"),
                    false => write!(f, "change by only {deviations:.2} standard deviations"),
                }
            }
            Self::Correlated {
                first,
                second,
                correlation,
            } => write!(
                f,
                "{first} and {second} have the correlation {correlation:.3}: a combination of them is known better than either"
            ),
            Self::Bound { name, bound, value } => {
                let value = Rounded(*value);
                write!(f, "{name} is at its {bound} bound {value}: the measurements require a value beyond this bound")
            }
            Self::FromPrior { name, share } => write!(
                f,
                "{name} is known mostly from its prior: {:.0} % of its variance comes from the prior",
                100.0 * share
            ),
            Self::FromOtherPriors {
                name,
                other,
                share,
                has_prior,
            } => {
                let percent = 100.0 * share;
                match has_prior {
                    true => write!(
                        f,
                        "{name} is known mostly from priors: {percent:.0} % of its variance comes from its own prior and from the priors of other inputs, such as {other}"
                    ),
                    false => write!(
                        f,
                        "{name} has no prior, but {percent:.0} % of its variance comes from the priors of other inputs, mostly from the prior of {other}"
                    ),
                }
            }
            Self::NoEffect {
                name,
                stationary_at: None,
                has_prior,
            } => write!(
                f,
                "{name} does not change any measured frequency: {}",
                if *has_prior {
                    "its value and deviation are those of its prior"
                } else {
                    "its value is arbitrary; do not fit it"
                }
            ),
            Self::NoEffect {
                name,
                stationary_at: Some(value),
                has_prior,
            } => write!(
                f,
                "at {name} = {} no measured frequency changes to first order with this input, only with a larger change: {}",
                Rounded(*value),
                if *has_prior {
                    "its standard deviation is that of its prior"
                } else {
                    "the fit gives no standard deviation for it"
                }
            ),
            Self::Pairing {
                index,
                mode,
                ambiguity,
            } => pairing(f, *index, *mode, *ambiguity),
            Self::Shared(shared) => write!(
                f,
                "{shared}: the frequency measured as {} may be that of {}",
                shared.name,
                if shared.modes.len() == 2 { "either mode" } else { "any of these modes" }
            ),
            Self::UnstablePairing => f.write_str(
                "the modes of the fitted tower would be paired differently; name the mode of each measurement",
            ),
            Self::Uncertified => f.write_str(
                "the list of modes of the fitted tower is not proved complete: a mode may be missing, and the measurements may belong to other modes",
            ),
            Self::LargeResidual { mode, residual } => write!(
                f,
                "{mode} is not reproduced by the fit: the fitted frequency differs by {residual:+.1} standard deviations"
            ),
            Self::OutsideBounds {
                mode,
                measured_hz,
                fitted_hz,
                residual,
                bounds,
            } => {
                let bounds = bounds.iter().map(|(name, bound, value)| {
                    format!("the {bound} bound {} of {name}", Rounded(*value))
                });
                let bounds: Vec<String> = bounds.collect();
                write!(
                    f,
                    "{mode} is not explained: {} Hz was measured, {} Hz is fitted ({residual:+.1} standard deviations), limited by {}",
                    Rounded(*measured_hz),
                    Rounded(*fitted_hz),
                    listed(&bounds)
                )
            }
            Self::PoorFit {
                chi_square,
                degrees_of_freedom,
            } => write!(
                f,
                "the residuals are larger than the standard deviations allow (chi-square {chi_square:.1} with {degrees_of_freedom} {} of freedom): the model is incomplete, or the measurements are less accurate than stated",
                if *degrees_of_freedom == 1 { "degree" } else { "degrees" }
            ),
            Self::NoDegreesOfFreedom => f.write_str(
                "there are as many unknowns as measurements and priors: any measurement can be fitted, so the residuals do not test the model",
            ),
        }
    }
}

fn pairing(
    f: &mut fmt::Formatter<'_>,
    index: usize,
    mode: ModeName,
    ambiguity: Ambiguity,
) -> fmt::Result {
    let number = index + 1;
    match ambiguity {
        Ambiguity::Frequency { other, distance_hz } => write!(
            f,
            "measurement {number} is taken for {mode}, but may be {other}, whose frequency differs from the measured one by {distance_hz:.4} Hz; name the mode"
        ),
        Ambiguity::Shape {
            other,
            mac,
            other_mac,
        } => write!(
            f,
            "measurement {number} is taken for {mode} (MAC {mac:.2}), but may be {other} (MAC {other_mac:.2}); name the mode"
        ),
    }
}
