//! Changes of an eigenvalue when a body or a spring that is attached at the end of a piece moves
//! away from this end.
//!
//! A tower with a slightly changed value keeps its mesh: the end of the piece carries the body
//! through a rigid arm of length a. Between the end and the true height of the body, the mesh has
//! the internal force F of the mode instead of the true one F'. With the flexibility c per length,
//! the eigenvalue changes by −c a (F'² − F²).
//!
//! F and F' are sums of the forces of all inertia, soil and weight above the end, so they do not
//! depend on the element.

use std::ops::Range;

use crate::elements::Mesh;
use crate::space::{times, transform_force};
use crate::subsystem::SegmentCurves;
use crate::tower::{Attachment, Piece, SectionMasses, SoilStiffness, Tower, for_each_mass_point};

/// Lowest number of parts into which a tower is divided for the sums of its forces.
const LEAST_PARTS: usize = 64;

/// The attachments at one height.
#[derive(Debug, Clone)]
struct Group {
    height_m: f64,
    /// Indices of the attachments.
    attached: Range<usize>,
    /// Index of its segment, and the position as a fraction of the segment.
    at: (usize, f64),
    /// 1/κGA in x and y, 1/EA, 1/EI about x and y, 1/GJ of the pieces that end below and above;
    /// none where nothing can leave the end of a piece.
    flexibilities: Option<[[f64; 6]; 2]>,
}

/// A point of the tower with its fraction of the moving mass.
struct Point {
    at: (usize, f64),
    height_m: f64,
    weight_m: f64,
    masses: SectionMasses,
    soil: [f64; SoilStiffness::SPRINGS],
}

/// A tower on a mesh, to sum the forces of its modes.
pub(super) struct AttachedForces<'a> {
    tower: &'a Tower,
    rotary_inertia: bool,
    groups: Vec<Group>,
    points: Vec<Point>,
}

/// The force of a mode above the end of a piece, and the change of the force below by each
/// attachment there.
#[derive(Debug, Clone)]
struct EndForces {
    above: [f64; 6],
    attached: Vec<[f64; 6]>,
}

/// The ends of pieces with attachments in one mode with xᵀMx = 1.
#[derive(Debug, Clone, Default)]
pub(crate) struct AttachedEnds {
    ends: Vec<(Group, EndForces)>,
}

impl<'a> AttachedForces<'a> {
    /// None if no attachment can leave the end of a piece.
    pub(super) fn of(
        tower: &'a Tower,
        mesh: &Mesh,
        (shears, rotary_inertia): (bool, bool),
    ) -> Option<Self> {
        let groups = groups(tower, mesh, shears);
        let lowest = groups.iter().find(|group| group.flexibilities.is_some())?;
        let points = points_above(tower, mesh, lowest.at.0);
        Some(Self {
            tower,
            rotary_inertia,
            groups,
            points,
        })
    }

    /// The forces of a mode with an eigenvalue λ (rad²/s²), these curves and xᵀMx.
    pub(super) fn in_mode(
        &self,
        lambda: f64,
        curves: &dyn SegmentCurves,
        mass: f64,
    ) -> AttachedEnds {
        let mut ends = Vec::new();
        let mut above = Above {
            lambda,
            rotary_inertia: self.rotary_inertia,
            gravity: self.tower.gravity_m_per_s2(),
            ..Above::default()
        };
        let mut points = self.points.iter().rev().peekable();
        for group in self.groups.iter().rev() {
            while let Some(point) = points.next_if(|point| point.height_m > group.height_m) {
                above.add_point(point, &curves.motion(point.at.0, point.at.1));
            }
            let motion = curves.motion(group.at.0, group.at.1);
            let attached = &self.tower.attachments()[group.attached.clone()];
            if group.flexibilities.is_some() {
                let per_mass = |force: [f64; 6]| force.map(|f| f / mass.sqrt());
                let own = attached.iter().map(|one| above.jump_at(one, &motion));
                let forces = EndForces {
                    above: per_mass(above.at(group.height_m, &motion)),
                    attached: own.map(per_mass).collect(),
                };
                ends.push((group.clone(), forces));
            }
            attached.iter().for_each(|one| above.add(one, &motion));
        }
        AttachedEnds { ends }
    }
}

/// The attachments of a tower by height, with the data needed at ends of pieces.
fn groups(tower: &Tower, mesh: &Mesh, shears: bool) -> Vec<Group> {
    let (attached, borders_m) = (tower.attachments(), mesh.borders_m());
    let mut groups = Vec::new();
    let mut first = 0;
    for same in attached.chunk_by(|a, b| a.height_m == b.height_m) {
        let height_m = same[0].height_m;
        let places = first..first + same.len();
        first = places.end;
        let border = borders_m.partition_point(|border| *border < height_m);
        // The rotor-nacelle assembly, the last of them, is always on top.
        let can_leave = height_m < tower.top_m() || same.len() > 1;
        let end = can_leave.then(|| tower.border_of(height_m)).flatten();
        groups.push(Group {
            height_m,
            attached: places,
            at: match border < mesh.segments() {
                true => (border, 0.0),
                false => (mesh.segments().saturating_sub(1), 1.0),
            },
            flexibilities: end.map(|end| flexibilities(tower, end, shears)),
        });
    }
    groups
}

/// The flexibilities below and above a border between pieces; none beyond the ends of the tower.
fn flexibilities(tower: &Tower, border: usize, shears: bool) -> [[f64; 6]; 2] {
    let pieces = tower.pieces();
    let of = |piece: &Piece, height_m: f64| {
        let section = piece.section_at(height_m);
        let (bending, shear) = (section.bending_n_m2, section.shear_flexibility_per_n);
        let sliding = if shears { 1.0 } else { 0.0 };
        [
            sliding * shear.fore_aft,
            sliding * shear.side_side,
            1.0 / section.axial_n,
            1.0 / bending.side_side,
            1.0 / bending.fore_aft,
            1.0 / section.torsion_n_m2,
        ]
    };
    let below = border.checked_sub(1).map(|below| &pieces[below]);
    [
        below.map_or([0.0; 6], |piece| of(piece, piece.top_m)),
        pieces
            .get(border)
            .map_or([0.0; 6], |piece| of(piece, piece.base_m)),
    ]
}

/// The points of all segments from this index on.
fn points_above(tower: &Tower, mesh: &Mesh, lowest: usize) -> Vec<Point> {
    let parts = LEAST_PARTS.div_ceil(mesh.segments().max(1));
    let mut points = Vec::new();
    let mut segment = 0;
    for (span, borders) in mesh.spans_with_borders() {
        let piece = &tower.pieces()[span.piece];
        for ends in borders.windows(2) {
            let (base_m, length_m) = (ends[0], ends[1] - ends[0]);
            let border = |part: usize| base_m + length_m * (part as f64 / parts as f64);
            for part in (0..parts).filter(|_| segment >= lowest) {
                let (from_m, to_m) = (border(part), border(part + 1));
                for_each_mass_point(piece, from_m, to_m, |height_m, weight_m, masses| {
                    let soil = piece
                        .environment
                        .soil
                        .map(|_| piece.section_at(height_m).soil);
                    points.push(Point {
                        at: (segment, (height_m - base_m) / length_m),
                        height_m,
                        weight_m,
                        masses: *masses,
                        soil: soil.unwrap_or_default().values(),
                    });
                });
            }
            segment += 1;
        }
    }
    points
}

/// The forces of all parts above the current height of the walk.
#[derive(Default)]
struct Above {
    lambda: f64,
    rotary_inertia: bool,
    gravity: f64,
    /// The force (λM − S) v and its moment about the height 0.
    force: [f64; 6],
    /// The weight, N.
    weight_n: f64,
    /// The moments of the weight by its displacement in x and y, N m.
    displaced: [f64; 2],
}

impl Above {
    fn add_force(&mut self, height_m: f64, mut force: [f64; 6]) {
        transform_force(&mut force, height_m);
        for (sum, force) in self.force.iter_mut().zip(force) {
            *sum += force;
        }
    }

    fn add_weight(&mut self, mass_kg: f64, motion: &[f64; 6]) {
        let weight_n = self.gravity * mass_kg;
        self.weight_n += weight_n;
        for (sum, moved) in self.displaced.iter_mut().zip(motion) {
            *sum += weight_n * moved;
        }
    }

    fn add_point(&mut self, point: &Point, motion: &[f64; 6]) {
        let masses = &point.masses;
        let transverse = masses.mass_kg_per_m + masses.water_kg_per_m;
        let rotary = masses.rotary_inertia_kg_m;
        let turning = if self.rotary_inertia { 1.0 } else { 0.0 };
        let inertia = [
            transverse,
            transverse,
            masses.mass_kg_per_m,
            turning * rotary.side_side,
            turning * rotary.fore_aft,
            masses.polar_inertia_kg_m,
        ];
        let [x, y, z, torsion, about_x, about_y] = point.soil;
        let soil = [x, y, z, about_x, about_y, torsion];
        let force = std::array::from_fn(|i| {
            point.weight_m * (self.lambda * inertia[i] - soil[i]) * motion[i]
        });
        self.add_force(point.height_m, force);
        self.add_weight(point.weight_m * masses.mass_kg_per_m, motion);
    }

    fn add(&mut self, attached: &Attachment, motion: &[f64; 6]) {
        self.add_force(attached.height_m, self.force_of(attached, motion));
        self.add_weight(attached.mass_kg, motion);
    }

    /// The force of an attachment about its height.
    fn force_of(&self, attached: &Attachment, motion: &[f64; 6]) -> [f64; 6] {
        let inertia = times(&attached.inertia, motion);
        let stiffness = times(&attached.stiffness, motion);
        let mut force = std::array::from_fn(|i| self.lambda * inertia[i] - stiffness[i]);
        for i in [3, 4] {
            force[i] += self.gravity * attached.overturning_kg_m * motion[i];
        }
        force
    }

    /// The difference of the internal force below and above an attachment.
    fn jump_at(&self, attached: &Attachment, motion: &[f64; 6]) -> [f64; 6] {
        let mut force = self.force_of(attached, motion);
        lean(&mut force, self.gravity * attached.mass_kg, motion);
        force
    }

    /// The internal force at a height (m) with this motion.
    fn at(&self, height_m: f64, motion: &[f64; 6]) -> [f64; 6] {
        let mut force = self.force;
        transform_force(&mut force, -height_m);
        let [x, y] = [0, 1].map(|i| self.displaced[i] - self.weight_n * motion[i]);
        force[4] += x;
        force[3] -= y;
        lean(&mut force, self.weight_n, motion);
        force
    }
}

/// Adds the component of a weight (N) in the plane of a rotated section.
fn lean(force: &mut [f64; 6], weight_n: f64, motion: &[f64; 6]) {
    force[0] += weight_n * motion[4];
    force[1] -= weight_n * motion[3];
}

impl AttachedEnds {
    /// The change of the eigenvalue (rad²/s²) if the attachments are at these distances (m) above
    /// the ends that carry them.
    pub(crate) fn change(&self, arms_m: &[f64]) -> f64 {
        let ends = self.ends.iter();
        ends.map(|(group, forces)| {
            let flexibilities = group.flexibilities.unwrap_or_default();
            forces.change(&arms_m[group.attached.clone()], &flexibilities)
        })
        .sum()
    }
}

impl EndForces {
    fn change(&self, arms_m: &[f64], [below, above]: &[[f64; 6]; 2]) -> f64 {
        let all = self.attached.iter();
        let under = all.fold(self.above, |sum, own| {
            std::array::from_fn(|i| sum[i] + own[i])
        });
        let up = self.change_on_side(arms_m, 1.0, &self.above, above);
        up + self.change_on_side(arms_m, -1.0, &under, below)
    }

    /// The change by the attachments that leave in one direction, along a tower of these
    /// flexibilities in which the force was `carried`.
    fn change_on_side(
        &self,
        arms_m: &[f64],
        side: f64,
        carried: &[f64; 6],
        flexibilities: &[f64; 6],
    ) -> f64 {
        let mut left: Vec<(f64, &[f64; 6])> = arms_m
            .iter()
            .map(|arm_m| side * arm_m)
            .zip(&self.attached)
            .filter(|(arm_m, _)| *arm_m > 0.0)
            .collect();
        // From the farthest to the nearest: the force in each part of the tower includes all
        // attachments that are farther away.
        left.sort_by(|a, b| b.0.total_cmp(&a.0));
        let mut force = *carried;
        let mut change = 0.0;
        for (index, (arm_m, own)) in left.iter().enumerate() {
            for (sum, own) in force.iter_mut().zip(*own) {
                *sum += side * own;
            }
            let next_m = left.get(index + 1).map_or(0.0, |next| next.0);
            let parts = flexibilities.iter().zip(&force).zip(carried);
            let squares = parts.map(|((c, new), old)| c * (new - old) * (new + old));
            change -= (arm_m - next_m) * squares.sum::<f64>();
        }
        change
    }
}
