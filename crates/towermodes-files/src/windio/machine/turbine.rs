//! Why the program cannot solve a windIO turbine with rotating rotor.
//!
//! Blades of windIO have curved axes and matrices of six by six entries at each section; those of
//! the library have straight axes and the stiffnesses of uncoupled motions.

use super::super::support::curve::Curve;
use super::super::text::outline::{Outline, Version};
use super::super::text::reading::Reading;
use crate::note::Note;

/// If the axis of a blade is farther off a straight line, as a fraction of its length, the blade is
/// curved.
const STRAIGHT: f64 = 1e-6;

/// The reason, with the key that shows it.
pub(crate) fn missing(outline: &Outline, version: Version, reading: &Reading<'_>) -> Note {
    let blade = outline.components.as_ref().and_then(|c| c.blade.as_ref());
    let Some(blade) = blade else {
        let message = "components has no blade: the operating turbine needs blades with mass and stiffness; write [turbine] after `convert --to toml`";
        return Note::missing_part(message);
    };
    let Some(stiffness) = blade.stiffness_matrix() else {
        let key = match version {
            Version::One => "elastic_properties_mb.six_x_six.stiff_matrix",
            Version::Two => "structure.elastic_properties.stiffness_matrix",
        };
        return Note::missing_part(format!(
            "the blade has no {key}: the operating turbine needs the stiffness of its blades; write [turbine] after `convert --to toml`"
        ));
    };
    let message = match (blade.axis(), off_axis_m(outline)) {
        (Some(axis), Some(off_m)) => {
            let message = format!(
                "the axis of the blade is curved, {off_m:.2} m off a straight line: the blades of the operating turbine have straight axes; write [turbine] after `convert --to toml`"
            );
            return Note::missing_part(message).at(reading.source, axis.span.start);
        }
        _ => {
            "the stiffness matrices of windIO's blades are not read: write [turbine] with the stiffnesses in flap and edge after `convert --to toml`"
        }
    };
    Note::missing_part(message).at(reading.source, stiffness.span.start)
}

/// The distance of the blade axis from the straight line from root to tip in x or y, m; none if the
/// axis is straight or cannot be read.
fn off_axis_m(outline: &Outline) -> Option<f64> {
    let axis = outline.components.as_ref()?.blade.as_ref()?.axis()?;
    let curve = |key: &str| {
        let node = axis.get(key)?;
        Curve::read(node, &format!("axis {key} of the blade")).ok()
    };
    let length_m = curve("z")?.above(1.0).abs();
    let of_curve = |curve: Curve| {
        let (root, tip) = (curve.above(0.0), curve.below(1.0));
        let places = (0..=100).map(|k| f64::from(k) / 100.0);
        let off = places.map(|s| (curve.above(s) - root - s * (tip - root)).abs());
        off.fold(0.0, f64::max)
    };
    let off_m = ["x", "y"].into_iter().filter_map(curve).map(of_curve);
    let off_m = off_m.fold(0.0, f64::max);
    (off_m > STRAIGHT * length_m).then_some(off_m)
}
