//! All subsystems of a tower that are made of the same kind of model.

use super::{MatrixKind, Subsystem};
use crate::space::SpatialMatrix;
use crate::tower::{Attachment, Motion, Motions, Plane, Tower};

/// Subsystems of one kind `S`: one for each smallest set of coupled motions. Of two equal bending
/// planes only the first is there.
///
/// The memory is kept when another tower is assembled.
pub struct Subsystems<S: Subsystem + ?Sized> {
    members: Vec<Box<S>>,
    /// How many members are in use; the others only keep their memory.
    count: usize,
    planes_are_equal: bool,
}

impl<S: Subsystem + ?Sized> Default for Subsystems<S> {
    fn default() -> Self {
        Self {
            members: Vec::new(),
            count: 0,
            planes_are_equal: false,
        }
    }
}

impl<S: Subsystem + ?Sized> Subsystems<S> {
    /// Begins with the base of a tower; `new` makes an empty subsystem for a set of motions.
    pub(crate) fn restart(&mut self, tower: &Tower, new: impl Fn(Motions) -> Box<S>) {
        self.planes_are_equal = tower.planes_are_equal();
        let side_side = Motions::only(Motion::Bending(Plane::SideSide));
        let is_twin = |set: &&Motions| tower.planes_are_equal() && **set == side_side;
        let sets = tower.independent_motions().iter();
        self.restart_with(sets.filter(|set| !is_twin(set)).copied(), new);
        self.add_base(tower);
    }

    /// Begins with one subsystem in which all motions are coupled, on the base of a tower.
    pub(crate) fn restart_coupled(&mut self, tower: &Tower, new: impl Fn(Motions) -> Box<S>) {
        self.planes_are_equal = false;
        let all = Motion::ALL.into_iter().map(Motions::only);
        let all = all.fold(Motions::default(), Motions::and);
        self.restart_with(std::iter::once(all), new);
        self.add_base(tower);
    }

    /// Begins with empty subsystems for sets of motions.
    pub(crate) fn restart_with(
        &mut self,
        sets: impl Iterator<Item = Motions> + Clone,
        new: impl Fn(Motions) -> Box<S>,
    ) {
        if !sets
            .clone()
            .eq(self.members.iter().map(|member| member.motions()))
        {
            self.members = sets.map(new).collect();
        }
        self.members.iter_mut().for_each(|member| member.clear());
        self.count = self.members.len();
    }

    /// Returns the subsystem, if it is the only one in use, and removes it from the list.
    pub(crate) fn take_only(&mut self) -> Option<Box<S>> {
        let only = if self.count == 1 {
            self.members.pop()
        } else {
            None
        };
        if only.is_some() {
            self.release();
        }
        only
    }

    /// Marks all subsystems as unused and keeps their memory.
    pub(crate) fn release(&mut self) {
        self.count = 0;
        self.planes_are_equal = false;
    }

    fn add_base(&mut self, tower: &Tower) {
        let (base, base_m) = (tower.base(), tower.base_m());
        if base.is_clamped() {
            return;
        }
        for member in &mut self.members {
            member.add_base(base_m, &base.units);
        }
        self.add_unless_zero(MatrixKind::Inertia, base_m, &base.inertia);
        self.add_unless_zero(MatrixKind::Foundation, base_m, &base.stiffness);
        self.add_geometric_stiffness(tower.gravity_m_per_s2() * base.overturning_kg_m);
    }

    /// Adds a matrix, given for the motion of the point at `reference_m` (m), to what was added
    /// last.
    #[inline]
    pub(crate) fn add(&mut self, kind: MatrixKind, reference_m: f64, matrix: &SpatialMatrix) {
        for member in &mut self.members {
            member.add(kind, reference_m, matrix);
        }
    }

    fn add_unless_zero(&mut self, kind: MatrixKind, reference_m: f64, matrix: &SpatialMatrix) {
        if matrix.iter().flatten().any(|entry| *entry != 0.0) {
            self.add(kind, reference_m, matrix);
        }
    }

    /// Adds a geometric stiffness −`moment_n_m` (N m/rad) against rotation in the bending planes to
    /// what was added last.
    #[inline]
    pub(crate) fn add_geometric_stiffness(&mut self, moment_n_m: f64) {
        if moment_n_m == 0.0 {
            return;
        }
        for member in &mut self.members {
            member.add_geometric_stiffness(moment_n_m);
        }
    }

    /// Adds the matrices of the attachments, sorted by height, up to a height (m); returns the
    /// attachments above.
    pub(crate) fn attach_up_to<'a>(
        &mut self,
        height_m: f64,
        attachments: &'a [Attachment],
        gravity_m_per_s2: f64,
    ) -> &'a [Attachment] {
        let count = attachments.partition_point(|a| a.height_m <= height_m);
        let (here, above) = attachments.split_at(count);
        for attachment in here {
            let z = attachment.height_m;
            self.add_unless_zero(MatrixKind::Inertia, z, &attachment.inertia);
            self.add_unless_zero(MatrixKind::Foundation, z, &attachment.stiffness);
            self.add_geometric_stiffness(gravity_m_per_s2 * attachment.overturning_kg_m);
        }
        above
    }

    /// The subsystems; the first one has the bending in the fore-aft plane.
    pub fn members(&self) -> &[Box<S>] {
        &self.members[..self.count]
    }

    /// The subsystems, to be worked on.
    pub fn members_mut(&mut self) -> &mut [Box<S>] {
        &mut self.members[..self.count]
    }

    /// How many times the modes of a subsystem are in the spectrum: twice for the first of two
    /// equal bending planes.
    pub fn multiplicity(&self, index: usize) -> usize {
        1 + usize::from(index == 0 && self.planes_are_equal)
    }
}
