//! The piles of a frame: its members in the ground, selected by their position only.

use super::super::frame::{FrameDescription, MemberKind, SectionEnds, difference, norm};
use super::super::parts::material::Material;
use super::super::pieces::section::Tube;
use super::description::Ground;
use crate::tower::description::{Station, TowerDescription};

/// A member that rises by less than this fraction of its length (60 degrees from the vertical) is
/// not a pile: the models of springs apply to piles.
const LEAST_RISE: f64 = 0.5;

/// A pile of a frame: members in line from its head, in the ground or above it, down to its tip.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::tower) struct FramePile {
    /// Its members from the head down. If piles meet below, each of them includes the members down
    /// to the tip.
    pub(in crate::tower) members: Vec<Buried>,
    /// Number of members, from the head, that belong to no earlier pile.
    pub(super) own: usize,
}

/// A member that is in the ground, or whose lower part is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::tower) struct Buried {
    pub(in crate::tower) member: usize,
    /// Index of its upper joint: 0 or 1.
    upper: usize,
}

/// Why there is no pile.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::tower) enum NoPile {
    /// No member is in the ground.
    NoMember,
    /// The section has no outer diameter: the name of the member.
    NoTube(String),
}

impl FramePile {
    /// The piles of a frame.
    pub(in crate::tower) fn all(
        frame: &FrameDescription,
        ground: &Ground,
    ) -> Result<Vec<Self>, NoPile> {
        let (buried, _) = buried(frame, ground);
        if let Some(other) = buried.iter().find(|part| part.tubes(frame).is_none()) {
            return Err(NoPile::NoTube(frame.members[other.member].name.clone()));
        }
        let below: Vec<Option<usize>> = buried
            .iter()
            .map(|part| next_below(frame, &buried, part))
            .collect();
        let heads = (0..buried.len()).filter(|index| !below.contains(&Some(*index)));
        let mut is_taken = vec![false; buried.len()];
        let piles = heads.map(|head| {
            let line = std::iter::successors(Some(head), |part| below[*part]);
            let line: Vec<usize> = line.collect();
            let own = line.iter().take_while(|part| !is_taken[**part]).count();
            line.iter().for_each(|part| is_taken[*part] = true);
            Self {
                members: line.into_iter().map(|part| buried[part]).collect(),
                own,
            }
        });
        let piles: Vec<Self> = piles.collect();
        match piles.is_empty() {
            true => Err(NoPile::NoMember),
            false => Ok(piles),
        }
    }

    /// The pile as a tower in the ground, from its tip up, with only the data on which the springs
    /// depend.
    pub(in crate::tower) fn alone(
        &self,
        frame: &FrameDescription,
        ground: &Ground,
    ) -> TowerDescription {
        let mut alone = TowerDescription {
            ground: Some(ground.clone()),
            ..TowerDescription::default()
        };
        for part in self.members.iter().rev() {
            let Some((ends, material)) = part.tubes(frame) else {
                continue;
            };
            let [upper, lower] = part.ends_m(frame);
            for (height_m, tube) in [lower[2], upper[2]].into_iter().zip(ends) {
                alone.stations.push(Station {
                    height_m,
                    outer_diameter_m: tube.outer_diameter_m,
                    wall_thickness_m: tube.wall_thickness_m,
                    material: alone.materials.len(),
                });
            }
            alone.materials.push(material);
        }
        alone
    }

    /// Height of its tip, m.
    pub(in crate::tower) fn tip_m(&self, frame: &FrameDescription) -> f64 {
        let last = self.members.last();
        last.map_or(f64::NAN, |part| part.ends_m(frame)[1][2])
    }

    /// The joint at its tip, from 0, with the direction of the pile there; none if an earlier pile
    /// has the same tip.
    pub(super) fn tip(&self, frame: &FrameDescription) -> Option<(usize, [f64; 3])> {
        let last = self.members.last()?;
        let [_, joint] = last.joints(frame);
        (self.own == self.members.len()).then(|| (joint, last.direction(frame)))
    }

    /// The members whose springs are counted with this pile.
    pub(super) fn own(&self) -> &[Buried] {
        &self.members[..self.own]
    }
}

impl TowerDescription {
    /// Outer diameter of the pile in the [ground](Self::ground) at its tip, m: the diameter of the
    /// lowest station, of the first pile of a frame below the tower, or the given diameter for a
    /// table of properties; none without ground or pile.
    pub fn pile_diameter_m(&self) -> Option<f64> {
        let ground = self.ground.as_ref()?;
        let of_frame = self.foundation.frame().map(|foundation| {
            let frame = foundation.frame.description();
            let piles = FramePile::all(frame, ground).ok()?;
            let alone = piles.first()?.alone(frame, ground);
            alone.stations.first().copied()
        });
        let lowest = of_frame.unwrap_or_else(|| self.stations.first().copied());
        let own = lowest.map(|station| station.outer_diameter_m);
        ground.pile_diameter_m.or(own)
    }
}

impl Buried {
    /// Its upper and its lower joint, from 0.
    fn joints(&self, frame: &FrameDescription) -> [usize; 2] {
        let joints = frame.members[self.member].joints;
        [joints[self.upper], joints[1 - self.upper]]
    }

    /// The positions of its upper and its lower joint, m.
    pub(in crate::tower) fn ends_m(&self, frame: &FrameDescription) -> [[f64; 3]; 2] {
        self.joints(frame)
            .map(|joint| frame.joints[joint].position_m)
    }

    /// Its direction, upward: a unit vector.
    fn direction(&self, frame: &FrameDescription) -> [f64; 3] {
        let [upper, lower] = self.ends_m(frame);
        let along = difference(upper, lower);
        let length_m = norm(along);
        along.map(|part| part / length_m)
    }

    /// Its tubes at the lower and the upper end with the material; none of another section.
    fn tubes(&self, frame: &FrameDescription) -> Option<([Tube; 2], Material)> {
        let MemberKind::Beam { ends, material } = &frame.members[self.member].kind else {
            return None;
        };
        match ends {
            SectionEnds::Tube(ends) => Some(([ends[1 - self.upper], ends[self.upper]], *material)),
            SectionEnds::Rectangle(_) | SectionEnds::Given(_) => None,
        }
    }
}

/// The beams that are at least partly in the ground: those whose slope is that of a pile, and the
/// others.
pub(in crate::tower) fn buried(
    frame: &FrameDescription,
    ground: &Ground,
) -> (Vec<Buried>, Vec<Buried>) {
    let members = frame.members.iter().enumerate();
    let beams = members.filter(|(_, member)| matches!(member.kind, MemberKind::Beam { .. }));
    let parts = beams.map(|(member, beam)| {
        let [from, to] = beam.joints.map(|joint| frame.joints[joint].position_m[2]);
        let upper = usize::from(to > from);
        Buried { member, upper }
    });
    let is_in_ground = |part: &Buried| part.ends_m(frame)[1][2] < ground.scoured_surface_m();
    parts
        .filter(is_in_ground)
        .partition(|part| part.direction(frame)[2] >= LEAST_RISE)
}

/// The next member of a pile below a given one: the member in the ground whose upper end is at the
/// lower end of the given one; of several, the one nearest to its direction.
fn next_below(frame: &FrameDescription, buried: &[Buried], part: &Buried) -> Option<usize> {
    let [_, lower] = part.ends_m(frame);
    let own = part.direction(frame);
    let in_line = |other: &Buried| -> f64 {
        let direction = other.direction(frame);
        own.iter().zip(direction).map(|(a, b)| a * b).sum()
    };
    let parts = buried.iter().enumerate();
    let below = parts.filter(|(_, other)| other.ends_m(frame)[0] == lower);
    let most = below.max_by(|(_, a), (_, b)| in_line(a).total_cmp(&in_line(b)));
    most.map(|(index, _)| index)
}
