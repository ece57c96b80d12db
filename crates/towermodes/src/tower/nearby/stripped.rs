//! A tower without some of its springs and masses, with the same elements.

use super::super::frame::{FrameFoundation, Substance};
use super::super::model::Tower;
use crate::space::{SpatialMatrix, add_scaled};

/// A part of a tower that has springs to the ground, masses or both, and does not bend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Strippable {
    /// The springs and the inertia of the base, with a platform and the water plane, but without
    /// moorings and added mass; those of the supports and the transition piece of a frame.
    Base,
    /// The moorings.
    Moorings,
    /// Soil springs and water along the tower, and along the members of its frame; the added mass
    /// of a platform.
    Surroundings,
    /// The mass of the members of the frame, and masses on its joints.
    Members,
    /// Marine growth on members.
    Growth,
    /// The filling of members.
    Filling,
    /// Guy wires and point masses.
    WiresAndMasses,
    /// The rotor-nacelle assembly.
    Rna,
}

impl Strippable {
    pub(crate) const ALL: [Self; 8] = [
        Self::Base,
        Self::Moorings,
        Self::Surroundings,
        Self::Members,
        Self::Growth,
        Self::Filling,
        Self::WiresAndMasses,
        Self::Rna,
    ];
}

impl Tower {
    /// The tower without the springs and the inertia of a part; none if it has no such part.
    ///
    /// Its elements and the coordinates of its base are those of the whole tower, so that vectors
    /// of the whole tower are vectors of this one. So is the compression by its weight, but for the
    /// members of a frame, which have none.
    pub(crate) fn without(&self, part: Strippable) -> Option<Self> {
        let mut stripped = self.clone();
        match part {
            Strippable::Base | Strippable::Moorings => stripped.remove_from_base(part),
            Strippable::Surroundings => {
                for piece in &mut stripped.pieces {
                    piece.environment = Default::default();
                }
                stripped.base.inertia = stripped.base.dry_inertia;
                stripped.change_frame(FrameFoundation::remove_surroundings);
            }
            Strippable::Members => {
                stripped.change_frame(FrameFoundation::remove_masses_of_members);
            }
            Strippable::Growth => stripped.change_frame(|f| f.remove_coats(Substance::Growth)),
            Strippable::Filling => stripped.change_frame(|f| f.remove_coats(Substance::Filling)),
            Strippable::WiresAndMasses | Strippable::Rna => {
                // The rotor-nacelle assembly is the last attachment.
                let last = stripped.attachments.len().saturating_sub(1);
                let (others, rna) = stripped.attachments.split_at_mut(last);
                let own = if part == Strippable::Rna { rna } else { others };
                for attachment in own {
                    attachment.stiffness = SpatialMatrix::default();
                    attachment.inertia = SpatialMatrix::default();
                }
            }
        }
        if stripped == *self {
            return None;
        }
        stripped.change_frame(|frame| frame.weight_on_members = false);
        Some(stripped)
    }

    /// Removes the moorings of the base, or everything except the moorings and the water around a
    /// platform.
    fn remove_from_base(&mut self, part: Strippable) {
        let base = &mut self.base;
        if part == Strippable::Moorings {
            let moorings = std::mem::take(&mut base.mooring_stiffness);
            add_scaled(&mut base.stiffness, -1.0, &moorings);
            self.change_frame(FrameFoundation::remove_moorings);
            return;
        }
        base.stiffness = base.mooring_stiffness;
        let dry = std::mem::take(&mut base.dry_inertia);
        add_scaled(&mut base.inertia, -1.0, &dry);
        self.change_frame(FrameFoundation::remove_platform_and_supports);
    }

    fn change_frame(&mut self, change: impl FnOnce(&mut FrameFoundation)) {
        if let Some(frame) = &mut self.frame {
            change(frame);
        }
    }

    /// The index of the material at a height (m), at a border the lower one; 0 for a table of
    /// properties.
    pub(crate) fn material_index_at(&self, height_m: f64) -> usize {
        let above = self.stations.partition_point(|s| s.height_m < height_m);
        let station = self.stations.get(above.saturating_sub(1));
        station.map_or(0, |station| station.material)
    }

    /// One more than the highest index of the materials of the stations; 1 for a table of
    /// properties.
    pub(crate) fn material_count(&self) -> usize {
        let highest = self.stations.iter().map(|station| station.material).max();
        1 + highest.unwrap_or(0)
    }
}
