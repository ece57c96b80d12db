//! The walls and bulkheads of a member.

use std::f64::consts::PI;

use towermodes::{Inertia, RigidBody};

use super::super::support::curve::Curve;
use super::super::support::materials::Materials;
use super::super::text::reading::Reading;
use super::members::{Member, Piece, value};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::hydrodyn::{StripMember, ring};

/// The walls of a member in its pieces, layer by layer from outside in.
pub(super) fn walls(
    member: &Member<'_>,
    strip: &StripMember,
    pieces: &[Piece],
    materials: &Materials<'_>,
) -> Result<Vec<RigidBody>, Diagnostic> {
    let mut bodies = Vec::new();
    for piece in pieces {
        let mut outer = piece.stretch.section.outer_radius_m();
        for layer in &member.layers {
            let thickness = [
                value(&layer.thickness, piece.from, true),
                value(&layer.thickness, piece.to, false),
            ];
            let inner: [f64; 2] = std::array::from_fn(|end| outer[end] - thickness[end]);
            if inner.iter().any(|radius| *radius < -1e-9) {
                let message = format!(
                    "the wall of member `{}` is thicker than its radius",
                    member.name
                );
                let kind = DiagnosticKind::Contradiction(message);
                return Err(Diagnostic::new(member.span.clone(), kind));
            }
            let density =
                member.outfitting * materials.used[layer.material].material.density_kg_per_m3;
            bodies.push(ring(strip, &piece.stretch, density, outer, inner));
            outer = inner;
        }
    }
    Ok(bodies)
}

/// The bulkheads: discs of the inner radius at the positions of their grid.
pub(super) fn bulkheads(
    member: &Member<'_>,
    strip: &StripMember,
    range: [f64; 2],
    materials: &Materials<'_>,
    reading: &Reading<'_>,
) -> Result<Vec<RigidBody>, Diagnostic> {
    let Some(node) = member.structure.get("bulkhead") else {
        return Ok(Vec::new());
    };
    let what = format!("bulkheads of member `{}`", member.name);
    let density = materials.density(node.require("material", &what)?, reading)?;
    let thickness = Curve::read(node.require("thickness", &what)?, &what)?;
    let mut bodies = Vec::new();
    for (&at, &thickness_m) in thickness.grid().iter().zip(thickness.values()) {
        if thickness_m < 0.0 {
            let kind = DiagnosticKind::out_of_range_in(what, thickness_m, "m", "0 or positive");
            return Err(Diagnostic::new(node.span.clone(), kind));
        }
        if at < range[0] || at > range[1] {
            continue;
        }
        let radius_m = member.inner_m(at, at < 1.0);
        let mass_kg = density * PI * radius_m * radius_m * thickness_m;
        let local = (at - range[0]) / (range[1] - range[0]);
        bodies.push(disc(strip, local, mass_kg, [radius_m, 0.0]));
    }
    Ok(bodies)
}

/// A thin disc or ring about the axis of a member, at a position along it.
pub(super) fn disc(
    strip: &StripMember,
    at: f64,
    mass_kg: f64,
    [outer_m, inner_m]: [f64; 2],
) -> RigidBody {
    let [from, to] = strip.ends_m;
    let axis: [f64; 3] = std::array::from_fn(|i| (to[i] - from[i]) / strip.length_m());
    let across = 0.25 * mass_kg * (outer_m * outer_m + inner_m * inner_m);
    let tensor = std::array::from_fn(|i| {
        std::array::from_fn(|j| across * (f64::from(i == j) + axis[i] * axis[j]))
    });
    RigidBody {
        mass_kg,
        center_m: std::array::from_fn(|i| from[i] + at * (to[i] - from[i])),
        inertia_kg_m2: Inertia::from_tensor(tensor),
    }
}
