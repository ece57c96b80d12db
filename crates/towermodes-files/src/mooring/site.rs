//! Depth, density and gravity: of the file, else of the caller, else assumed.

use towermodes::mooring::{Attachment, MooringDescription};

use super::input::MooringSite;
use super::points::ReadPoint;
use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact};
use crate::note::Note;
use crate::source::Source;

/// Heights that differ by less than this fraction of the depth are one.
const ROUNDED: f64 = 1e-6;

/// Density and gravity.
pub(super) fn water(site: &MooringSite, notes: &mut Vec<Note>) -> (f64, f64) {
    let mut or_assumed = |given: Option<f64>, assumed: f64, what: &str| {
        given.unwrap_or_else(|| {
            let message = format!("{what} is not given: {} is assumed", Exact(assumed));
            notes.push(Note::assumption(message));
            assumed
        })
    };
    let density = "the density of the water (kg/m3)";
    let gravity = "the acceleration of gravity (m/s2)";
    (
        or_assumed(
            site.water_density_kg_per_m3,
            MooringDescription::SEA_KG_PER_M3,
            density,
        ),
        or_assumed(
            site.gravity_m_per_s2,
            MooringDescription::GRAVITY_M_PER_S2,
            gravity,
        ),
    )
}

/// The depth of the seabed under the lines. All anchors at one height are on it, even if the water
/// is said to be deeper, unless a part of the mooring is below them.
pub(super) fn depth_m(
    given_m: Option<f64>,
    points: &[ReadPoint],
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<f64, Diagnostic> {
    let anchors = anchors(points);
    let (depth_m, message) = match (given_m, anchors) {
        (None, None) => {
            let what = "the depth of the water".to_owned();
            let hint = "add a line such as `200.0 WtrDpth` to the table OPTIONS of a MoorDyn file; a MAP++ file cannot contain it: give the .fst file that names the MAP++ file";
            return Err(Diagnostic::new(0..0, DiagnosticKind::Missing { what }).with_hint(hint));
        }
        (None, Some((anchor_m, place))) => {
            let message = format!(
                "the depth of the water is not given: the seabed is at the fixed points, at z = {} m",
                Exact(-anchor_m)
            );
            (anchor_m, Some((message, place)))
        }
        (Some(given_m), Some((anchor_m, place))) if anchor_m < given_m * (1.0 - ROUNDED) => {
            let message = format!(
                "all fixed points are at z = {} m, but the depth of the water is {} m: the seabed under the lines is taken at the fixed points",
                Exact(-anchor_m),
                Exact(given_m)
            );
            (anchor_m, Some((message, place)))
        }
        (Some(given_m), _) => (given_m, None),
    };
    let note = message.map(|(message, place)| Note::assumption(message).at(source, place));
    notes.extend(note);
    Ok(depth_m)
}

/// The depth of all anchors and the place of the first one, if it is one depth, and if no other
/// point is below it.
fn anchors(points: &[ReadPoint]) -> Option<(f64, usize)> {
    let z_m = |read: &ReadPoint| read.point.position_m[2];
    let is_anchor = |read: &&ReadPoint| read.point.attachment == Attachment::Fixed;
    let is_placed = |read: &&ReadPoint| {
        matches!(
            read.point.attachment,
            Attachment::Fixed | Attachment::Platform | Attachment::Free
        )
    };
    let first = points.iter().find(is_anchor)?;
    let depth_m = -z_m(first);
    let near_m = ROUNDED * depth_m;
    let mut anchors = points.iter().filter(is_anchor);
    let is_level = anchors.all(|read| !read.is_on_seabed && (z_m(read) + depth_m).abs() <= near_m);
    let mut placed = points.iter().filter(is_placed);
    let is_lowest = placed.all(|read| z_m(read) >= -depth_m - near_m);
    (depth_m > 0.0 && is_level && is_lowest).then_some((depth_m, first.span.start))
}
