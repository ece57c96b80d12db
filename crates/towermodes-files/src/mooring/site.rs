//! Depth, density and gravity: from the file, otherwise from the caller, otherwise assumed.

use towermodes::mooring::{Attachment, MooringDescription};

use super::input::MooringSite;
use super::options::Options;
use super::points::ReadPoint;
use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact};
use crate::note::Note;
use crate::source::Source;

/// Two values that differ by less than this fraction count as equal, for example 9.81 and 9.80665
/// m/s².
const SAME: f64 = 0.01;

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

/// The depth of the water. If it is not given, it is the depth of the anchors, provided they have
/// the same depth.
pub(super) fn depth_m(
    given_m: Option<f64>,
    points: &[ReadPoint],
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<f64, Diagnostic> {
    if let Some(given_m) = given_m {
        return Ok(given_m);
    }
    let Some((anchors_m, place)) = anchors(points) else {
        let what = "the depth of the water".to_owned();
        let hint = "add a line such as `200.0 WtrDpth` to the table OPTIONS of a MoorDyn file; a MAP++ file cannot contain it: give the .fst file that names the MAP++ file";
        return Err(Diagnostic::new(0..0, DiagnosticKind::Missing { what }).with_hint(hint));
    };
    let message = format!(
        "the depth of the water is not given: the seabed is at the fixed points, at z = {} m",
        Exact(-anchors_m)
    );
    notes.push(Note::assumption(message).at(source, place));
    Ok(anchors_m)
}

/// The depth of all anchors and the place of the first one, if they have the same depth and nothing
/// is below them.
fn anchors(points: &[ReadPoint]) -> Option<(f64, usize)> {
    if points.iter().any(|read| read.is_on_seabed) {
        return None;
    }
    let placed = MooringDescription {
        points: points.iter().map(|read| read.point).collect(),
        ..MooringDescription::default()
    };
    let is_anchor = |read: &&ReadPoint| read.point.attachment == Attachment::Fixed;
    let first = points.iter().find(is_anchor)?;
    Some((placed.depth_of_anchors_m()?, first.span.start))
}

/// The notes on options of the file that contradict the rest of the model.
pub(super) fn contradictions(
    options: &Options<'_>,
    site: &MooringSite,
    source: &Source,
) -> Vec<Note> {
    let pairs = [
        ("WtrDpth", "m", options.depth_m, site.depth_m),
        (
            "rhoW",
            "kg/m3",
            options.density_kg_per_m3,
            site.water_density_kg_per_m3,
        ),
        ("g", "m/s2", options.gravity_m_per_s2, site.gravity_m_per_s2),
    ];
    let notes = pairs.into_iter().filter_map(|(name, unit, own, other)| {
        let (own, other) = (own?, other?);
        let message = format!(
            "{name} is {} {unit} here, but {} {unit} in the other files of the model; for the lines the value here is used: make both equal",
            Exact(own),
            Exact(other)
        );
        let differ = (own / other - 1.0).abs() > SAME;
        differ.then(|| Note::suspicious(message).at(source, options.span.start))
    });
    notes.collect()
}
