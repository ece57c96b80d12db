//! A tower without some of its springs and masses, while its elements stay as they are.

use super::super::model::Tower;

/// A part of a tower that has springs to the ground, masses or both, and does not bend.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Strippable {
    /// The springs and the inertia of the base, or those of the frame that carries it.
    Base,
    /// Soil springs and water along the tower, and soil springs along the members of its frame.
    Surroundings,
    /// Guy wires and point masses.
    WiresAndMasses,
    /// The rotor-nacelle assembly.
    Rna,
}

impl Strippable {
    pub(crate) const ALL: [Self; 4] = [
        Self::Base,
        Self::Surroundings,
        Self::WiresAndMasses,
        Self::Rna,
    ];
}

impl Tower {
    /// The tower without the springs and the inertia of a part; none if it has no such part.
    ///
    /// Its elements, the coordinates of its base and the compression by its weight are those of the
    /// whole tower, so that vectors of the whole tower are vectors of this one.
    pub(crate) fn without(&self, part: Strippable) -> Option<Self> {
        let mut stripped = self.clone();
        match part {
            Strippable::Base => {
                stripped.base.stiffness = [[0.0; 6]; 6];
                stripped.base.inertia = [[0.0; 6]; 6];
                if let Some(frame) = &mut stripped.frame {
                    frame.remove_masses_and_springs();
                }
            }
            Strippable::Surroundings => {
                for piece in &mut stripped.pieces {
                    piece.environment = Default::default();
                }
                if let Some(frame) = &mut stripped.frame {
                    frame.remove_soil();
                }
            }
            Strippable::WiresAndMasses | Strippable::Rna => {
                // The rotor-nacelle assembly is the last attachment.
                let last = stripped.attachments.len().saturating_sub(1);
                let (others, rna) = stripped.attachments.split_at_mut(last);
                let own = if part == Strippable::Rna { rna } else { others };
                for attachment in own {
                    attachment.stiffness = [[0.0; 6]; 6];
                    attachment.inertia = [[0.0; 6]; 6];
                }
            }
        }
        (stripped != *self).then_some(stripped)
    }

    /// The index of the material at a height (m), of two that meet there the lower one; 0 for a
    /// table of properties.
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
