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
use crate::note::Note;
use crate::number::Rounded;

/// Largest number of rings of a member.
const MOST_RINGS: f64 = 10_000.0;

/// A web with a flange, m, its density and its spacing.
struct Profile {
    web_m: [f64; 2],
    flange_m: [f64; 2],
    density: f64,
    spacing: f64,
}

impl Profile {
    /// The profile under a key; none without spacing.
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

    /// The angle between longitudinal stiffeners inside a radius (m), rad, and whether it is in the
    /// unit of the other version: in the unit of its own version it would be more than a full turn,
    /// or the stiffeners would overlap.
    fn angle_rad(&self, radius_m: f64, version: Version) -> (f64, bool) {
        let own = version.radians(self.spacing);
        let other = version.other().radians(self.spacing);
        let width_m = self.web_m[1].max(self.flange_m[0]);
        let is_possible = |angle: f64| angle <= TAU * (1.0 + 1e-9) && angle * radius_m >= width_m;
        match !is_possible(own) && is_possible(other) {
            true => (other, true),
            false => (own, false),
        }
    }
}

const LONGITUDINAL: &str = "longitudinal_stiffeners";

/// Notes that angles between longitudinal stiffeners are in the unit of the other version.
pub(super) fn note_angles(
    members: &[Member<'_>],
    version: Version,
    materials: &Materials<'_>,
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    for member in members {
        let Some(profile) = Profile::read(member.structure, LONGITUDINAL, materials, reading)?
        else {
            continue;
        };
        let (angle, is_other) = profile.angle_rad(member.widest_m(), version);
        let node = member.structure.find(&[LONGITUDINAL, "spacing"]);
        if let Some(node) = node.filter(|_| is_other) {
            let message = format!(
                "longitudinal stiffeners with spacing = {} {} are impossible: spacing = {} {} ({} degrees) is assumed; in windIO {} the spacing is in {}",
                profile.spacing,
                version.angle_unit(),
                profile.spacing,
                version.other().angle_unit(),
                Rounded(angle.to_degrees()),
                version.number(),
                version.angle_unit(),
            );
            reading.note_at(node.span.start, Note::assumption(message));
        }
    }
    Ok(())
}

/// The rings, at multiples of their spacing (a fraction of the member length) between its ends.
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

/// The longitudinal stiffeners, whose spacing is an angle, smeared over the circumference.
pub(super) fn longitudinal(
    member: &Member<'_>,
    strip: &StripMember,
    pieces: &[Piece],
    version: Version,
    (materials, reading): (&Materials<'_>, &Reading<'_>),
) -> Result<Vec<RigidBody>, Diagnostic> {
    let Some(profile) = Profile::read(member.structure, LONGITUDINAL, materials, reading)? else {
        return Ok(Vec::new());
    };
    let (angle, _) = profile.angle_rad(member.widest_m(), version);
    let count = (TAU / angle).round();
    let [height_m, web_m] = profile.web_m;
    let [width_m, flange_m] = profile.flange_m;
    let area = count * (height_m * web_m + width_m * flange_m);
    let bodies = pieces.iter().map(|piece| {
        let outer = piece.stretch.section.inner_radius_m();
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
