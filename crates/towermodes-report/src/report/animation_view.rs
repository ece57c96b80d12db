//! The animation in the form that the template of the page needs.

use serde::Serialize;

use super::error::ReportError;
use crate::figures::{AnimatedMode, AnimationData, Body, Substance};

/// The animation of the page.
#[derive(Serialize)]
pub(super) struct AnimationView {
    pub modes: Vec<AnimatedModeView>,
    /// Whether the tower's width is nominal.
    pub is_nominal: bool,
    /// The other drawn bodies in words; empty without any.
    pub parts: String,
    /// The data of the script, as JSON that cannot end the script element.
    pub data: String,
}

/// A mode to choose from.
#[derive(Serialize)]
pub(super) struct AnimatedModeView {
    pub number: usize,
    pub label: String,
}

impl AnimationView {
    /// The animation of these data.
    pub(super) fn of(data: &AnimationData) -> Result<Self, ReportError> {
        let json = serde_json::to_string(data).map_err(|error| ReportError::Data {
            message: error.to_string(),
        })?;
        let mode = |mode: &AnimatedMode| AnimatedModeView {
            number: mode.number,
            label: format!("{}, {} Hz", mode.label, mode.frequency_hz),
        };
        Ok(Self {
            modes: data.modes.iter().map(mode).collect(),
            is_nominal: data.is_nominal,
            parts: parts(&data.bodies),
            // Neither `</script` nor `<!--` may be in a script.
            data: json.replace('<', "\\u003c"),
        })
    }
}

/// The bodies around the animated tower in words: "ground, soil, water".
fn parts(bodies: &[Body]) -> String {
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
    there.map(|(_, name)| name).collect::<Vec<_>>().join(", ")
}
