//! Checks for angles and lengths of the RNA in the wrong unit: version 1 has radians, version 2
//! degrees, both have metres.

use super::super::text::outline::Version;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::number::Rounded;

/// Largest tilt or cone angle, degrees; real rotors have up to 10.
const LARGEST_DEG: f64 = 20.0;
/// A larger value, degrees, is not a tilt or cone angle in any unit.
const IMPOSSIBLE_DEG: f64 = 90.0;
/// A tilt or cone angle of version 2 that is smaller than this, degrees, is probably in radians:
/// 0.1047 is 6 degrees. Real angles are 0 or larger.
const SMALLEST_DEG: f64 = 0.2;
/// Largest distance of a hub from the tower top, m; for rotors of 280 m it is 14 m.
const FARTHEST_M: f64 = 50.0;

/// An angle of the rotor in radians. If it is probably in the other unit, there is a note; if it is
/// impossible in both units, it is a mistake.
pub(crate) fn angle(
    node: &Node,
    key: &str,
    version: Version,
    reading: &mut Reading<'_>,
) -> Result<f64, Diagnostic> {
    let written = node.number(key)?;
    let (unit, degrees) = (version.angle_unit(), version.radians(written).to_degrees());
    // In degrees whatever the version says.
    if degrees.abs() > IMPOSSIBLE_DEG && written.abs() > IMPOSSIBLE_DEG {
        let rule = "at most 90 degrees";
        let kind = DiagnosticKind::out_of_range_in(key, written, unit, rule);
        let hint = match version {
            Version::One => "in windIO 1 it is in radians: 6 degrees are 0.10472",
            Version::Two => "in windIO 2 it is in degrees, for example 6.0",
        };
        return Err(Diagnostic::new(node.span.clone(), kind).with_hint(hint));
    }
    if let Some(message) = doubt(key, written, degrees, version) {
        reading.note_at(node.span.start, Note::suspicious(message));
    }
    Ok(version.radians(written))
}

/// The reason if an angle is probably in the other unit.
fn doubt(key: &str, written: f64, degrees: f64, version: Version) -> Option<String> {
    let size = degrees.abs();
    Some(match version {
        Version::One if size > LARGEST_DEG => format!(
            "{key} is {written} rad, which is {} degrees: in windIO 1 it is in radians; {written} degrees are {} rad",
            Rounded(degrees),
            Rounded(written.to_radians())
        ),
        Version::Two if size > LARGEST_DEG => {
            format!("{key} is {written} degrees: rotors have less than {LARGEST_DEG}")
        }
        Version::Two if written != 0.0 && size < SMALLEST_DEG => format!(
            "{key} is {written} degrees: in windIO 2 it is in degrees; {written} rad are {} degrees",
            Rounded(written.to_degrees())
        ),
        _ => return None,
    })
}

/// A distance from the tower top to the hub, m; if it is probably in millimetres, there is a note.
pub(crate) fn length_m(
    node: &Node,
    key: &str,
    reading: &mut Reading<'_>,
) -> Result<f64, Diagnostic> {
    let length_m = node.number(key)?;
    if length_m.abs() > FARTHEST_M {
        let message = format!(
            "{key} is {} m: hubs are within {FARTHEST_M} m of the tower top; lengths are in metres",
            Rounded(length_m)
        );
        reading.note_at(node.span.start, Note::suspicious(message));
    }
    Ok(length_m)
}
