//! Ring and longitudinal stiffeners of a member: a web inside the wall with a flange on it.

use std::f64::consts::{PI, TAU};

use towermodes::RigidBody;

use super::super::support::materials::Materials;
use super::super::text::outline::Version;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::members::{Member, Piece};
use super::steel::disc;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::hydrodyn::{StripMember, ring};

/// No member has more rings.
const MOST_RINGS: f64 = 10_000.0;

/// A web with a flange, m, its density and its spacing.
struct Profile {
    web_m: [f64; 2],
    flange_m: [f64; 2],
    density: f64,
    spacing: f64,
}

impl Profile {
    /// Those of a key; none without spacing.
    fn read(
        structure: &Node,
        key: &str,
        materials: &Materials<'_>,
        reading: &Reading<'_>,
    ) -> Result<Option<Self>, Diagnostic> {
        let Some(node) = structure.get(key) else {
            return Ok(None);
        };
        let length = |key: &str| -> Result<f64, Diagnostic> {
            let value = node.require(key, "the stiffeners")?;
            let found = value.number(&format!("{key} of the stiffeners"))?;
            match found >= 0.0 {
                true => Ok(found),
                false => {
                    let kind = DiagnosticKind::out_of_range(key, found, "0 or positive");
                    Err(Diagnostic::new(value.span.clone(), kind))
                }
            }
        };
        let profile = Self {
            web_m: [length("web_height")?, length("web_thickness")?],
            flange_m: [length("flange_width")?, length("flange_thickness")?],
            density: materials.density(node.require("material", "the stiffeners")?, reading)?,
            spacing: length("spacing")?,
        };
        Ok((profile.spacing > 0.0).then_some(profile))
    }
}

/// The rings, at multiples of their spacing (a fraction of the member) between its ends.
pub(super) fn rings(
    member: &Member<'_>,
    strip: &StripMember,
    range: [f64; 2],
    materials: &Materials<'_>,
    reading: &Reading<'_>,
) -> Result<Vec<RigidBody>, Diagnostic> {
    let Some(profile) = Profile::read(member.structure, "ring_stiffeners", materials, reading)?
    else {
        return Ok(Vec::new());
    };
    let count = ((1.0 - 1e-9) / profile.spacing).floor();
    if count > MOST_RINGS {
        let message = format!(
            "member `{}` has more than {MOST_RINGS} ring stiffeners",
            member.name
        );
        let kind = DiagnosticKind::Contradiction(message);
        return Err(Diagnostic::new(member.structure.span.clone(), kind));
    }
    let mut bodies = Vec::new();
    for k in 1..=count as usize {
        let at = k as f64 * profile.spacing;
        if at < range[0] || at > range[1] {
            continue;
        }
        let local = (at - range[0]) / (range[1] - range[0]);
        let wall = member.inner_m(at, true);
        let web = (wall - profile.web_m[0]).max(0.0);
        let flange = (web - profile.flange_m[1]).max(0.0);
        for ([outer, inner], length_m) in [
            ([wall, web], profile.web_m[1]),
            ([web, flange], profile.flange_m[0]),
        ] {
            let area = PI * (outer * outer - inner * inner);
            let mass_kg = profile.density * area * length_m;
            bodies.push(disc(strip, local, mass_kg, [outer, inner]));
        }
    }
    Ok(bodies)
}

/// The longitudinal stiffeners, whose spacing is an angle, spread over the circumference.
pub(super) fn longitudinal(
    member: &Member<'_>,
    strip: &StripMember,
    pieces: &[Piece],
    version: Version,
    (materials, reading): (&Materials<'_>, &Reading<'_>),
) -> Result<Vec<RigidBody>, Diagnostic> {
    let key = "longitudinal_stiffeners";
    let Some(profile) = Profile::read(member.structure, key, materials, reading)? else {
        return Ok(Vec::new());
    };
    let count = (TAU / version.radians(profile.spacing)).round();
    let [height_m, web_m] = profile.web_m;
    let [width_m, flange_m] = profile.flange_m;
    let area = count * (height_m * web_m + width_m * flange_m);
    let bodies = pieces.iter().map(|piece| {
        let outer = piece.stretch.inner_radius_m;
        // The ring between the wall and the flange has the area of the stiffeners.
        let inner = outer.map(|outer| (outer - height_m - flange_m).max(0.0));
        let ring_area = |end: usize| PI * (outer[end] * outer[end] - inner[end] * inner[end]);
        let mean = 0.5 * (ring_area(0) + ring_area(1));
        let density = if mean > 0.0 {
            profile.density * area / mean
        } else {
            0.0
        };
        ring(strip, &piece.stretch, density, outer, inner)
    });
    Ok(bodies.collect())
}
