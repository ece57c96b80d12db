//! Compares the SubDyn file and the HydroDyn file of a model: diameters and positions of members,
//! the seabed.

use towermodes::frame::FrameDescription;

use super::sea::{Sea, place};
use crate::diagnostic::Exact;
use crate::hydrodyn::HydrodynInput;
use crate::note::Note;
use crate::source::Source;
use crate::subdyn::SubdynInput;

/// The largest length of piles as a fraction of the depth, if no joint is at the seabed.
const PILES: f64 = 0.5;

/// Notes on contradictions between the SubDyn file and the HydroDyn file, each with its line.
pub(super) fn doubts(subdyn: &SubdynInput, water: &HydrodynInput, sea: &Sea) -> Vec<Note> {
    let stands = !subdyn.description.supports.is_empty();
    let pair = Pair { subdyn, water };
    let mut notes = Vec::new();
    if stands {
        notes.extend(pair.seabed(sea));
        // For a floater the tubes of SubDyn are often simplified hulls.
        notes.extend(pair.diameters());
    }
    notes.extend(pair.far_members());
    notes
}

struct Pair<'a> {
    subdyn: &'a SubdynInput,
    water: &'a HydrodynInput,
}

impl Pair<'_> {
    fn file(&self) -> &Source {
        &self.water.sources[0]
    }

    fn frame(&self) -> &FrameDescription {
        &self.subdyn.description
    }

    /// The name of a member of SubDyn with its file and line.
    fn member(&self, index: usize) -> String {
        let name = &self.frame().members[index].name;
        let row = self.subdyn.member_row(index);
        format!("member {name} of {}", place(&self.subdyn.sources[0], row))
    }

    /// A note on the first of some strip members, which counts the others.
    fn note(&self, strip: usize, others: usize, message: String) -> Note {
        let others = match others {
            0 => String::new(),
            1 => "; another member has the same problem".to_owned(),
            _ => format!("; {others} other members have the same problem"),
        };
        let row = self.water.member_rows[strip];
        Note::suspicious(message + &others).at(self.file(), row)
    }

    /// Members with another diameter than the tube at the same place.
    fn diameters(&self) -> Option<Note> {
        let found = self.water.other_diameters(self.frame());
        let first = found.first()?;
        let message = format!(
            "member {} has a diameter of {} m at z = {} m, but {} has a diameter of {} m there: the added mass follows from the first diameter; correct one of the two files",
            self.water.members[first.strip].name,
            Exact(first.strip_m),
            Exact(first.z_m),
            self.member(first.member),
            Exact(first.tube_m)
        );
        Some(self.note(first.strip, found.len() - 1, message))
    }

    /// Members far from all members of SubDyn.
    fn far_members(&self) -> Option<Note> {
        let found = self.water.far_away(self.frame());
        let first = found.first()?;
        let message = format!(
            "member {} is up to {:.1} m away from {}, the nearest member of SubDyn, to which its added mass is attached; both files use the same axes: compare the joints",
            self.water.members[first.strip].name,
            first.distance_m,
            self.member(first.member)
        );
        Some(self.note(first.strip, found.len() - 1, message))
    }

    /// A seabed far above or below the lowest supports.
    fn seabed(&self, sea: &Sea) -> Option<Note> {
        let frame = self.frame();
        let supports = frame.supports.iter();
        let heights = supports.map(|support| frame.joints[support.joint].position_m[2]);
        let lowest_m = heights.min_by(f64::total_cmp)?;
        let depth_m = self.water.water.depth_m;
        let near_m = self.water.water.near_seabed_m();
        let has_joint_there = || {
            let mut joints = frame.joints.iter();
            joints.any(|joint| (joint.position_m[2] + depth_m).abs() <= near_m)
        };
        let hangs = lowest_m > -depth_m + near_m;
        let is_deep = lowest_m < -(1.0 + PILES) * depth_m && !has_joint_there();
        let message = format!(
            "WtrDpth is {} m, but the lowest reaction joint of {} is at z = {} m, {} m {} the seabed: correct one of them",
            Exact(depth_m),
            self.subdyn.sources[0].name,
            Exact(lowest_m),
            Exact((lowest_m + depth_m).abs()),
            if hangs { "above" } else { "below" }
        );
        let note = Note::suspicious(message);
        (hangs || is_deep).then(|| match sea.depth() {
            Some((file, given)) => note.at(file, given.at),
            None => note,
        })
    }
}
