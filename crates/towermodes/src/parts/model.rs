//! All parts of a tower's model together.

use super::part::{Kind, Part};
use super::structure::Role;
use crate::tower::{Attachment, Motion, Motions, OnAxis, Plane, Tower};

/// The parts of a model: one for each smallest set of coupled motions, the second of two equal
/// bending planes left out.
pub struct Parts<K: Kind> {
    parts: Vec<Part<K>>,
    planes_are_equal: bool,
}

impl<K: Kind> Default for Parts<K> {
    fn default() -> Self {
        Self {
            parts: Vec::new(),
            planes_are_equal: false,
        }
    }
}

impl<K: Kind> Parts<K> {
    /// Forgets everything but the memory and begins with the base of a tower.
    pub fn restart(&mut self, tower: &Tower) {
        self.planes_are_equal = tower.planes_are_equal();
        let side_side = Motions::only(Motion::Bending(Plane::SideSide));
        let sets = tower.independent_motions().iter().copied();
        let sets = sets.filter(|set| !(self.planes_are_equal && *set == side_side));
        if sets.clone().eq(self.parts.iter().map(Part::motions)) {
            self.parts.iter_mut().for_each(Part::clear);
        } else {
            self.parts = sets.map(Part::new).collect();
        }
        self.add_base(tower);
    }

    fn add_base(&mut self, tower: &Tower) {
        let (base, base_m) = (tower.base(), tower.base_m());
        if base.is_clamped() {
            return;
        }
        let overturning_n_m = tower.gravity_m_per_s2() * base.overturning_kg_m;
        for part in &mut self.parts {
            part.add_base(base_m, base.units);
            part.add_spatial(Role::Inertia, base_m, &base.inertia);
            part.add_spatial(Role::Ground, base_m, &base.stiffness);
            part.overturn(overturning_n_m);
        }
    }

    /// Adds a matrix of a piece of tower, given about a height (m), to what was added last.
    #[inline]
    pub fn add(&mut self, role: Role, reference_m: f64, body: &OnAxis) {
        for part in &mut self.parts {
            part.add(role, reference_m, body);
        }
    }

    /// Takes a stiffness (N m) against rotation about x and y from what was added last.
    #[inline]
    pub fn overturn(&mut self, stiffness_n_m: f64) {
        for part in &mut self.parts {
            part.overturn(stiffness_n_m);
        }
    }

    /// Adds those of the attachments, sorted by height, that are not above a height (m); returns
    /// those above.
    pub fn attach_up_to<'a>(
        &mut self,
        height_m: f64,
        attachments: &'a [Attachment],
        gravity_m_per_s2: f64,
    ) -> &'a [Attachment] {
        let count = attachments.partition_point(|a| a.height_m <= height_m);
        let (here, above) = attachments.split_at(count);
        for attachment in here {
            let z = attachment.height_m;
            let overturning_n_m = gravity_m_per_s2 * attachment.overturning_kg_m;
            for part in &mut self.parts {
                part.add_spatial(Role::Inertia, z, &attachment.inertia);
                part.add_spatial(Role::Ground, z, &attachment.stiffness);
                part.overturn(overturning_n_m);
            }
        }
        above
    }

    /// A part; the first one bends fore-aft.
    pub fn part(&self, index: usize) -> &Part<K> {
        &self.parts[index]
    }

    /// A part, to be worked on.
    pub fn part_mut(&mut self, index: usize) -> &mut Part<K> {
        &mut self.parts[index]
    }

    /// The parts in order, to be changed.
    pub fn iter_mut(&mut self) -> std::slice::IterMut<'_, Part<K>> {
        self.parts.iter_mut()
    }

    /// Whether the side-side plane is the fore-aft one again, and left out.
    pub fn planes_are_equal(&self) -> bool {
        self.planes_are_equal
    }

    /// Number of parts.
    pub fn count(&self) -> usize {
        self.parts.len()
    }

    /// How many times the modes of a part are there.
    pub fn multiplicity(&self, part: usize) -> usize {
        1 + usize::from(part == 0 && self.planes_are_equal)
    }

    /// Degrees of freedom of the whole tower, an equal plane counted twice.
    pub fn degrees_of_freedom(&self) -> usize {
        let parts = self.parts.iter().enumerate();
        parts
            .map(|(index, part)| self.multiplicity(index) * part.degrees_of_freedom())
            .sum()
    }

    /// Whether every number is finite.
    pub fn is_finite(&self) -> bool {
        self.parts.iter().all(Part::is_finite)
    }
}
