//! Piles of a frame in the ground: piles close to each other, members without springs, joints just
//! above or below the surface.

use crate::tower::frame::{FrameDescription, MemberKind, difference, norm};
use crate::tower::ground::{FramePile, Ground, buried};
use crate::tower::{Place, Site, Warning};

/// Piles with a smaller distance, in diameters, reduce the stiffness of each other: in tests of
/// groups the lateral stiffness decreases by a fifth at four diameters.
const GROUP_DIAMETERS: f64 = 3.0;
/// Suction buckets of jackets have an embedded length of about one diameter, piles of ten and more.
const SHORT_DIAMETERS: f64 = 1.0;
/// A joint within this distance of the surface, m, is probably meant to be at the surface.
const NEAR_M: f64 = 0.05;

pub(super) fn check(frame: &FrameDescription, ground: &Ground, warnings: &mut Vec<Warning>) {
    let piles = FramePile::all(frame, ground).unwrap_or_default();
    let site = Site::at(Place::Ground { key: "surface" });
    warnings.extend(group(frame, ground, &piles, site));
    short(frame, ground, &piles, site, warnings);
    without_springs(frame, ground, site, warnings);
    near_surface(frame, ground, &piles, site, warnings);
}

/// The two piles with the smallest distance in diameters, if they are a group.
fn group(
    frame: &FrameDescription,
    ground: &Ground,
    piles: &[FramePile],
    site: Site,
) -> Option<Warning> {
    let heads = piles.iter().map(|pile| head(frame, ground, pile));
    let heads: Vec<Head> = heads.collect::<Option<_>>()?;
    let pairs = heads.iter().enumerate().flat_map(|(index, first)| {
        let others = heads[..index].iter();
        others.map(move |second| {
            let apart_m = norm(difference(first.position_m, second.position_m));
            let diameters = apart_m / first.diameter_m.max(second.diameter_m);
            (diameters, second.member, first.member)
        })
    });
    let (diameters, first, second) = pairs.min_by(|a, b| a.0.total_cmp(&b.0))?;
    let name = |member: usize| frame.members[member].name.clone();
    (diameters < GROUP_DIAMETERS).then(|| Warning::PileGroup {
        site,
        first: name(first),
        second: name(second),
        diameters,
        least: GROUP_DIAMETERS,
    })
}

/// Piles that end just below the surface.
fn short(
    frame: &FrameDescription,
    ground: &Ground,
    piles: &[FramePile],
    site: Site,
    warnings: &mut Vec<Warning>,
) {
    let lengths = piles.iter().filter_map(|pile| {
        let head = head(frame, ground, pile)?;
        let [_, tip] = pile.members.last()?.ends_m(frame);
        let length_m = norm(difference(head.position_m, tip));
        Some((length_m / head.diameter_m, length_m, head))
    });
    let shortest = lengths.min_by(|a, b| a.0.total_cmp(&b.0));
    let found = shortest.filter(|(slenderness, ..)| *slenderness < SHORT_DIAMETERS);
    warnings.extend(found.map(|(_, length_m, head)| Warning::ShortPile {
        site,
        member: frame.members[head.member].name.clone(),
        length_m,
        diameter_m: head.diameter_m,
    }));
}

/// A pile at the surface of the ground, or at its upper end if that is below the surface.
struct Head {
    member: usize,
    position_m: [f64; 3],
    diameter_m: f64,
}

fn head(frame: &FrameDescription, ground: &Ground, pile: &FramePile) -> Option<Head> {
    let uppermost = pile.members.first()?;
    let [upper, lower] = uppermost.ends_m(frame);
    let rise = (ground.scoured_surface_m() - lower[2]) / (upper[2] - lower[2]);
    let share = rise.clamp(0.0, 1.0);
    let alone = pile.alone(frame, ground);
    Some(Head {
        member: uppermost.member,
        position_m: std::array::from_fn(|i| lower[i] + share * (upper[i] - lower[i])),
        diameter_m: alone.stations.last()?.outer_diameter_m,
    })
}

/// Members in the ground that are no piles.
fn without_springs(
    frame: &FrameDescription,
    ground: &Ground,
    site: Site,
    warnings: &mut Vec<Warning>,
) {
    let (_, flat) = buried(frame, ground);
    let flat = flat.into_iter().map(|part| {
        let why =
            "it is closer to horizontal than 30 degrees, and the models of springs are for piles";
        (part.member, why)
    });
    let members = frame.members.iter().enumerate();
    let others = members.filter_map(|(index, member)| {
        let ends = member.joints.map(|joint| frame.joints[joint].position_m);
        let lowest_m = ends[0][2].min(ends[1][2]);
        let is_in_ground = lowest_m < ground.scoured_surface_m() && ends[0] != ends[1];
        let why = match member.kind {
            MemberKind::Beam { .. } | MemberKind::Spring(_) => return None,
            MemberKind::Cable { .. } => "it is a cable",
            MemberKind::Rigid { .. } => "it is a rigid link, which has no diameter",
        };
        is_in_ground.then_some((index, why))
    });
    warnings.extend(flat.chain(others).map(|(member, why)| {
        let member = frame.members[member].name.clone();
        Warning::NoSpringsOfSoil { site, member, why }
    }));
}

/// Joints of piles that are close to the surface but not at it.
fn near_surface(
    frame: &FrameDescription,
    ground: &Ground,
    piles: &[FramePile],
    site: Site,
    warnings: &mut Vec<Warning>,
) {
    let surface_m = ground.surface_m;
    let members = piles.iter().flat_map(|pile| &pile.members);
    let joints = members.flat_map(|part| frame.members[part.member].joints);
    let mut seen = Vec::new();
    for joint in joints.map(|joint| &frame.joints[joint]) {
        let off_m = (joint.position_m[2] - surface_m).abs();
        if off_m > 0.0 && off_m < NEAR_M && !seen.contains(&&joint.name) {
            seen.push(&joint.name);
            warnings.push(Warning::JointNearSurface {
                site,
                joint: joint.name.clone(),
                height_m: joint.position_m[2],
                surface_m,
            });
        }
    }
}
