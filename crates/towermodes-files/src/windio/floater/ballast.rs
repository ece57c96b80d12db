//! Ballast of a member: a volume of a material from the lower limit of its range upwards, or water
//! that balances the platform.

use std::f64::consts::PI;
use std::ops::Range;

use towermodes::RigidBody;

use super::super::support::materials::Materials;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::joints::{capped, is_true};
use super::members::{Member, Piece, distance};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::hydrodyn::{Stretch, StripMember, ring};
use crate::number::Rounded;

/// Ballast in a range of a member.
#[derive(Debug)]
pub(super) struct Ballast {
    /// Positions along the whole member.
    pub(super) range: [f64; 2],
    /// Density (kg/m³) and volume (m³) of fixed ballast; none for ballast water that balances the
    /// platform.
    fixed: Option<[f64; 2]>,
    span: Range<usize>,
}

/// The ballasts of a member.
pub(super) fn ballasts(
    member: &Member<'_>,
    materials: &Materials<'_>,
    reading: &Reading<'_>,
) -> Result<Vec<Ballast>, Diagnostic> {
    let structure = member.structure;
    let Some(list) = structure
        .get("ballasts")
        .or_else(|| structure.get("ballast"))
    else {
        return Ok(Vec::new());
    };
    let what = format!("ballast of member `{}`", member.name);
    let list = capped(list, &what)?.iter();
    list.map(|node| ballast(node, &what, materials, reading))
        .collect()
}

fn ballast(
    node: &Node,
    what: &str,
    materials: &Materials<'_>,
    reading: &Reading<'_>,
) -> Result<Ballast, Diagnostic> {
    let grid = node.require("grid", what)?;
    let limits = grid.numbers(&format!("grid of the {what}"))?;
    let range = match limits.as_slice() {
        [from, to] if *from >= 0.0 && from < to && *to <= 1.0 => [*from, *to],
        _ => {
            let message =
                format!("the grid of the {what} must be two rising positions from 0 to 1");
            let kind = DiagnosticKind::Contradiction(message);
            return Err(Diagnostic::new(grid.span.clone(), kind));
        }
    };
    let fixed = match is_true(node, "variable_flag") {
        true => None,
        false => {
            let volume = node.require("volume", what)?;
            let volume_m3 = volume.number(&format!("volume of the {what}"))?;
            if volume_m3 < 0.0 {
                let kind = DiagnosticKind::out_of_range_in(what, volume_m3, "m3", "0 or positive");
                return Err(Diagnostic::new(volume.span.clone(), kind));
            }
            let density = materials.density(node.require("material", what)?, reading)?;
            Some([density, volume_m3])
        }
    };
    Ok(Ballast {
        range,
        fixed,
        span: node.span.clone(),
    })
}

/// Fixed ballast, and water that fills its ranges completely.
#[derive(Debug, Default)]
pub(super) struct Filled {
    pub(super) fixed: Vec<RigidBody>,
    pub(super) water: Vec<RigidBody>,
}

impl Ballast {
    pub(super) fn fill(
        &self,
        strip: &StripMember,
        pieces: &[Piece],
        water_kg_per_m3: f64,
        filled: &mut Filled,
    ) -> Result<(), Diagnostic> {
        let [from, to] = self.range;
        let inside = pieces.iter().filter(|piece| {
            let middle = 0.5 * (piece.from + piece.to);
            middle > from && middle < to
        });
        let Some([density, volume_m3]) = self.fixed else {
            let bodies = inside.map(|piece| core(strip, &piece.stretch, water_kg_per_m3));
            filled.water.extend(bodies);
            return Ok(());
        };
        let mut left_m3 = volume_m3;
        for piece in inside {
            let holds_m3 = volume(strip, &piece.stretch);
            if holds_m3 >= left_m3 {
                let part = lower_part(strip, &piece.stretch, left_m3);
                filled.fixed.push(core(strip, &part, density));
                return Ok(());
            }
            filled.fixed.push(core(strip, &piece.stretch, density));
            left_m3 -= holds_m3;
        }
        match left_m3 <= 1e-6 * volume_m3 {
            true => Ok(()),
            false => {
                let message = format!(
                    "the ballast of {} m3 does not fit into its part of member `{}`, which holds {} m3",
                    Rounded(volume_m3),
                    strip.name,
                    Rounded(volume_m3 - left_m3)
                );
                let kind = DiagnosticKind::Contradiction(message);
                Err(Diagnostic::new(self.span.clone(), kind))
            }
        }
    }
}

/// The filling of a part of a member.
fn core(strip: &StripMember, stretch: &Stretch, density: f64) -> RigidBody {
    ring(
        strip,
        stretch,
        density,
        stretch.section.inner_radius_m(),
        [0.0; 2],
    )
}

fn volume(strip: &StripMember, stretch: &Stretch) -> f64 {
    let [a, b] = stretch.section.inner_radius_m();
    let [from, to] = strip.ends_m;
    let length_m = distance(from, to) * (stretch.range[1] - stretch.range[0]);
    PI / 3.0 * length_m * (a * a + a * b + b * b)
}

/// The part of a stretch, beginning at its first end, that contains a volume (m³).
fn lower_part(strip: &StripMember, stretch: &Stretch, volume_m3: f64) -> Stretch {
    let part = |share: f64| {
        let [from, to] = stretch.range;
        Stretch {
            range: [from, from + share * (to - from)],
            section: stretch.section.part([0.0, share]),
            ..*stretch
        }
    };
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        match volume(strip, &part(middle)) < volume_m3 {
            true => low = middle,
            false => high = middle,
        }
    }
    part(0.5 * (low + high))
}
