//! Assemblies of rigid links, each of which may contain only one interface joint.

use towermodes::frame::{FrameMember, MemberKind};

/// A rigid link by its index, and two interface joints that it connects, directly or through
/// others, if there are such joints.
pub(super) fn two_interfaces(
    members: &[FrameMember],
    joints: usize,
    interfaces: &[usize],
) -> Option<(usize, [usize; 2])> {
    let mut groups: Vec<usize> = (0..joints).collect();
    let mut owner: Vec<Option<usize>> = vec![None; joints];
    interfaces
        .iter()
        .for_each(|joint| owner[*joint] = Some(*joint));
    for (index, member) in members.iter().enumerate() {
        if !matches!(member.kind, MemberKind::Rigid { .. }) {
            continue;
        }
        let [a, b] = member.joints.map(|joint| root(&mut groups, joint));
        if a == b {
            continue;
        }
        if let (Some(first), Some(second)) = (owner[a], owner[b]) {
            return Some((index, [first, second]));
        }
        owner[b] = owner[b].or(owner[a]);
        groups[a] = b;
    }
    None
}

/// The joint that represents the group of a joint; the path to it is shortened.
fn root(groups: &mut [usize], joint: usize) -> usize {
    let mut at = joint;
    while groups[at] != at {
        groups[at] = groups[groups[at]];
        at = groups[at];
    }
    at
}
