//! The coats of a stretch of a circular strip member.

use towermodes::frame::CoatKind;

use super::section::{StripSection, blend};
use super::strip::Stretch;

impl Stretch {
    /// Whether the stretch has added mass, growth or filling.
    pub(super) fn moves(&self) -> bool {
        let added = self
            .added_mass
            .is_some_and(|of| of.across != [[0.0; 2]; 2] || of.along != [0.0; 2]);
        added || self.growth.is_some() || self.fill_density_kg_per_m3 > 0.0
    }

    /// The coats of the part between two fractions of the stretch, if its section is circular.
    pub(super) fn coats(&self, part: [f64; 2], density_kg_per_m3: f64) -> Vec<CoatKind> {
        let StripSection::Circle {
            outer_radius_m,
            inner_radius_m,
        } = self.section
        else {
            return Vec::new();
        };
        let at = |values: [f64; 2]| part.map(|fraction| blend(values, fraction));
        let grown_radius_m = part.map(|fraction| self.grown(fraction).radius_m());
        let mut coats = Vec::new();
        if let Some(added) = self.added_mass {
            coats.push(CoatKind::AddedMass {
                density_kg_per_m3,
                radius_m: grown_radius_m,
                across: at(added.across.map(|[x, _]| x)),
                along: at(added.along),
            });
        }
        if let Some(growth) = self.growth {
            coats.push(CoatKind::Solid {
                density_kg_per_m3: at(growth.density_kg_per_m3),
                outer_radius_m: grown_radius_m,
                inner_radius_m: at(outer_radius_m),
            });
        }
        if self.fill_density_kg_per_m3 > 0.0 {
            coats.push(CoatKind::Solid {
                density_kg_per_m3: [self.fill_density_kg_per_m3; 2],
                outer_radius_m: at(inner_radius_m),
                inner_radius_m: [0.0; 2],
            });
        }
        coats
    }
}

/// The coat with reversed direction.
pub(super) fn reversed(coat: CoatKind) -> CoatKind {
    let turned = |[from, to]: [f64; 2]| [to, from];
    match coat {
        CoatKind::Solid {
            density_kg_per_m3,
            outer_radius_m,
            inner_radius_m,
        } => CoatKind::Solid {
            density_kg_per_m3: turned(density_kg_per_m3),
            outer_radius_m: turned(outer_radius_m),
            inner_radius_m: turned(inner_radius_m),
        },
        CoatKind::AddedMass {
            density_kg_per_m3,
            radius_m,
            across,
            along,
        } => CoatKind::AddedMass {
            density_kg_per_m3,
            radius_m: turned(radius_m),
            across: turned(across),
            along: turned(along),
        },
    }
}
