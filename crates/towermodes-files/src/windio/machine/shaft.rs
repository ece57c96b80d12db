//! The shaft of the rotor: its tilt, and the position of the rotor apex.

use super::super::text::outline::{Outline, Version};
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::plausible::{angle, length_m};
use crate::diagnostic::Diagnostic;
use crate::note::Note;

/// The position of the rotor's apex, and the direction of the shaft.
pub(crate) struct Shaft {
    pub(super) tilt_rad: f64,
    pub(super) apex_m: [f64; 3],
}

/// Whether the rotor is upwind of the tower, which is the default.
pub(super) fn is_upwind(outline: &Outline, reading: &Reading<'_>) -> bool {
    let node = outline.assembly.as_ref();
    let node = node.and_then(|node| node.get("rotor_orientation"));
    let name = node.map(|node| node.name(&reading.source.text));
    !name.is_some_and(|name| name.trim().eq_ignore_ascii_case("downwind"))
}

/// Tilt, overhang and height of the apex; missing values are zero, with a note.
pub(crate) fn shaft(
    outline: &Outline,
    version: Version,
    is_upwind: bool,
    reading: &mut Reading<'_>,
) -> Result<Shaft, Diagnostic> {
    let keys = ["uptilt", "overhang", "distance_tt_hub"];
    let [tilt, overhang, height] = keys.map(|key| of_shaft(outline, version, key));
    let found = keys.into_iter().zip([tilt, overhang, height]);
    let absent = found.filter(|(_, node)| node.is_none());
    let absent: Vec<&str> = absent.map(|(key, _)| key).collect();
    let tilt_rad = tilt.map_or(Ok(0.0), |node| angle(node, "uptilt", version, reading))?;
    let overhang_m = overhang.map_or(Ok(0.0), |node| length_m(node, "overhang", reading))?;
    let height_m = height.map_or(Ok(0.0), |node| length_m(node, "distance_tt_hub", reading))?;
    if !absent.is_empty() {
        let message = format!(
            "the file has no {}: 0 is assumed for the position of hub and blades",
            absent.join(", ")
        );
        reading.note(Note::assumption(message));
    }
    // The end of the shaft that carries the rotor is the higher one.
    let side = if is_upwind { 1.0 } else { -1.0 };
    Ok(Shaft {
        tilt_rad: side * tilt_rad,
        apex_m: [-side * overhang_m, 0.0, height_m],
    })
}

/// A key of the drive train.
fn of_shaft<'o>(outline: &'o Outline, version: Version, key: &str) -> Option<&'o Node> {
    let components = outline.components.as_ref()?;
    let shape = match version {
        Version::One => components.nacelle.as_ref()?.get("drivetrain"),
        Version::Two => components.drivetrain.as_ref()?.get("outer_shape"),
    };
    shape?.get(key)
}
