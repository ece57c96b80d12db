//! The animated mode shapes.

use super::text;
use crate::figures::{AnimatedMode, AnimationData, Body, Substance};
use crate::report::error::ReportError;
use crate::view::VIEW_SCRIPT;

/// How many modes are chosen at first.
const CHOSEN: usize = 2;

const SCALE: &str = "Height and diameter are to the same scale.";
const NOMINAL_SCALE: &str = "Heights are to scale; the input has no diameter, so the width is that of a steel tube with the same bending stiffness and a wall thickness of 1/200 of its diameter, to the same scale.";

/// The controls, the stage and the data of the animation.
pub(super) fn of_animation(data: &AnimationData) -> Result<String, ReportError> {
    let json = serde_json::to_string(data).map_err(|error| ReportError::Data {
        message: error.to_string(),
    })?;
    let modes = data.modes.iter().enumerate();
    let modes: String = modes.map(|(index, mode)| of_mode(index, mode)).collect();
    Ok(format!(
        include_str!("animation.html"),
        modes = modes,
        scale = if data.is_nominal {
            NOMINAL_SCALE
        } else {
            SCALE
        },
        bodies = bodies(&data.bodies),
        view = VIEW_SCRIPT,
        // Neither `</script` nor `<!--` may be in a script.
        data = json.replace('<', "\\u003c"),
    ))
}

/// The box that chooses a mode.
fn of_mode(index: usize, mode: &AnimatedMode) -> String {
    let checked = if index < CHOSEN { " checked" } else { "" };
    let label = format!("{}, {} Hz", mode.label, mode.frequency_hz);
    format!(
        "<label><input type=\"checkbox\" name=\"animation-mode\" value=\"{index}\"{checked}> <span>{}. {}</span></label>\n",
        mode.number,
        text(&label)
    )
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
            "nacelle, hub and blades in a nominal shape, because the input has no dimensions of them",
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
