//! The animated modes of a tower, and of a turbine with rotating rotor.

use serde::Serialize;

use super::text;
use crate::figures::{AnimationData, Body, Substance, WhirlAnimation};
use crate::number::four_digits;
use crate::report::error::ReportError;

/// Number of modes that are selected at first.
const CHOSEN: usize = 2;

const SCALE: &str = "Height and diameter are to the same scale.";
const NOMINAL_SCALE: &str = "Heights are to scale; the input has no diameter, so the width shown is the width of a steel tube with the same bending stiffness and a wall thickness of 1/200 of its diameter, to the same scale.";

/// The texts of an animation.
struct Words<'a> {
    id: &'a str,
    title: &'a str,
    /// The place where a reader without JavaScript finds the modes.
    instead: &'a str,
    noun: &'a str,
    remark: String,
}

/// A mode: its number, its name and its frequency, Hz.
type Named<'a> = (usize, &'a str, f64);

/// The controls, the stage and the data of the modes of a tower.
pub(super) fn of_tower(data: &AnimationData) -> Result<String, ReportError> {
    let scale = if data.is_nominal {
        NOMINAL_SCALE
    } else {
        SCALE
    };
    let bodies = bodies(&data.bodies);
    let words = Words {
        id: "animation",
        title: "Animated mode shapes",
        instead: "the same shapes are in the figure above.",
        noun: "tower",
        remark: format!(
            "Grey line: the undeformed tower. {scale} The amplitude of a mode is arbitrary: the largest deflection is the chosen amplitude in percent of the height, or, for torsion, 3 degrees of rotation per percent of this amplitude if that is less. All modes are animated at the same frequency. The dashed line is a line on the shell; it shows the rotation of the sections.{bodies}"
        ),
    };
    let modes = data.modes.iter();
    let modes = modes.map(|mode| (mode.number, &*mode.label, mode.frequency_hz));
    section(&words, &modes.collect::<Vec<_>>(), &[1, 2], data)
}

/// The controls, the stage and the data of the modes of a turbine.
pub(super) fn of_turbine(data: &WhirlAnimation) -> Result<String, ReportError> {
    let motion = motion(data);
    let words = Words {
        id: "whirl",
        title: "Animated modes of the operating turbine",
        instead: "stills of the same modes are in the figure above.",
        noun: "turbine",
        remark: format!(
            "{motion} The amplitude of a mode is arbitrary: the largest deflection is the chosen amplitude in percent of the tower's height. Grey lines: the undeformed turbine. Dashed line: positions of the tips at all azimuths; in a whirl mode this curve moves around the rotor, forward in the direction of rotation or backward against it. The dot marks the tip of the first blade. The widths of blades and nacelle are nominal."
        ),
    };
    let modes = data.modes.iter();
    let modes = modes.map(|mode| (mode.number, &*mode.label, mode.frequency_hz));
    section(&words, &modes.collect::<Vec<_>>(), &chosen(data), data)
}

fn section(
    words: &Words<'_>,
    modes: &[Named<'_>],
    chosen: &[usize],
    data: &impl Serialize,
) -> Result<String, ReportError> {
    let json = serde_json::to_string(data).map_err(|error| ReportError::Data {
        message: error.to_string(),
    })?;
    let boxes = modes.iter().enumerate();
    let boxes = boxes.map(|(index, mode)| of_mode(words.id, index, mode, chosen.contains(&mode.0)));
    Ok(format!(
        include_str!("animation.html"),
        id = words.id,
        title = words.title,
        instead = words.instead,
        noun = words.noun,
        remark = words.remark,
        modes = boxes.collect::<String>(),
        // Neither `</script` nor `<!--` may be in a script.
        data = json.replace('<', "\\u003c"),
    ))
}

/// The check box of a mode.
fn of_mode(id: &str, index: usize, (number, label, hz): &Named<'_>, is_chosen: bool) -> String {
    let checked = if is_chosen { " checked" } else { "" };
    let label = text(&format!("{label}, {hz} Hz"));
    format!(
        "<label><input type=\"checkbox\" name=\"{id}-mode\" value=\"{index}\"{checked}> <span>{number}. {label}</span></label>\n"
    )
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

/// The relation of the motions on the page to those of the turbine.
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

/// The sentence on the bodies around the animated tower, if there are any: "Also drawn: ground,
/// soil, water."
fn bodies(bodies: &[Body]) -> String {
    let names = [
        (Substance::Ground, "ground"),
        (Substance::Soil, "soil"),
        (Substance::Water, "water"),
        (Substance::Foundation, "the foundation or platform"),
        (Substance::Link, "springs, guy wires or moorings"),
        (Substance::Mass, "centres of mass as balls"),
        (
            Substance::Rna,
            "nacelle, hub and blades in a nominal shape, because the input does not give their dimensions",
        ),
    ];
    let is_there = |of: Substance| bodies.iter().any(|body| body.of == of);
    let there = names.into_iter().filter(|(of, _)| is_there(*of));
    let there: Vec<&str> = there.map(|(_, name)| name).collect();
    match there.is_empty() {
        true => String::new(),
        false => format!(" Also drawn: {}.", there.join(", ")),
    }
}
