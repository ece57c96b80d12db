//! The animated modes of a turbine with its turning rotor.

use super::text;
use crate::figures::{AnimatedWhirl, WhirlAnimation};
use crate::number::four_digits;
use crate::report::error::ReportError;

/// How many modes are chosen at first.
const CHOSEN: usize = 2;

/// The controls, the stage and the data of the animation.
pub(super) fn of_whirl(data: &WhirlAnimation) -> Result<String, ReportError> {
    let json = serde_json::to_string(data).map_err(|error| ReportError::Data {
        message: error.to_string(),
    })?;
    let chosen = chosen(data);
    let modes = data.modes.iter();
    let modes: String = modes
        .map(|mode| of_mode(mode, chosen.contains(&mode.number)))
        .collect();
    Ok(format!(
        include_str!("whirl.html"),
        modes = modes,
        motion = motion(data),
        // Neither `</script` nor `<!--` may be in a script.
        data = json.replace('<', "\\u003c"),
    ))
}

/// The numbers of the modes that are shown at first: the lowest whirl of each direction, which a
/// tower without its rotor does not have, or the lowest modes.
fn chosen(data: &WhirlAnimation) -> Vec<usize> {
    let first = |what: &str| {
        let mut modes = data.modes.iter();
        modes
            .find(|mode| mode.label.ends_with(what))
            .map(|mode| mode.number)
    };
    let whirls = [first("backward whirl"), first("forward whirl")];
    let whirls: Vec<usize> = whirls.into_iter().flatten().collect();
    match whirls.len() {
        CHOSEN => whirls,
        _ => (1..=CHOSEN).collect(),
    }
}

/// How the motions on the page relate to those of the turbine.
fn motion(data: &WhirlAnimation) -> String {
    match data.rotor_speed_rpm > 0.0 {
        true => format!(
            "The rotor turns at {} rpm, seen from downwind counterclockwise. In each picture vibration and rotation are slowed down by the same factor, so that a period of every mode takes equally long.",
            four_digits(data.rotor_speed_rpm)
        ),
        false => {
            "The rotor is at rest. Every mode is slowed down so that a period takes equally long."
                .to_owned()
        }
    }
}

/// The box that chooses a mode.
fn of_mode(mode: &AnimatedWhirl, is_chosen: bool) -> String {
    let checked = if is_chosen { " checked" } else { "" };
    let (index, number) = (mode.number - 1, mode.number);
    let label = format!("{}, {} Hz", mode.label, mode.frequency_hz);
    format!(
        "<label><input type=\"checkbox\" name=\"whirl-mode\" value=\"{index}\"{checked}> <span>{number}. {}</span></label>\n",
        text(&label)
    )
}
