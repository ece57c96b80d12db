//! The data of a script that animates a tower in its modes.

use serde::Serialize;
use towermodes::frame::{FrameJoint, FrameMember};
use towermodes::{Mode, ShapePoint, Solution, Tower, TowerDescription};

use super::outline::{is_nominal, outer_diameter_m};
use super::parts::Parts;
use super::scene::{Body, scene};
use super::substructure::{Substructure, largest_translation, radii_m};
use crate::number::five_digits;

/// The largest number of heights of an animated tower.
const MOST_HEIGHTS: usize = 60;

/// A tower and its modes at a few heights, with five significant digits.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimationData {
    /// Heights from the base to the top in the datum of the stations, m; at most 60.
    pub height_m: Vec<f64>,
    /// Outer radius at these heights, m; for a table of properties the radius of the steel tube of
    /// the same bending stiffness with a wall of 1/200 of its diameter.
    pub radius_m: Vec<f64>,
    /// Whether the radius is this nominal radius.
    pub is_nominal: bool,
    /// RNA, foundation and surroundings.
    pub bodies: Vec<Body>,
    /// The frame under the tower.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub frame: Option<AnimatedFrame>,
    /// The modes by frequency.
    pub modes: Vec<AnimatedMode>,
}

/// A frame at rest, about the axis of the tower, m.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimatedFrame {
    /// The joints.
    pub joints: Vec<[f64; 3]>,
    /// The members between them.
    pub members: Vec<AnimatedMember>,
}

/// A member of an animated frame.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct AnimatedMember {
    /// Its joints, from 0.
    pub joints: [usize; 2],
    /// Outer radius at both joints, m; 0 if the member has no section.
    pub radius_m: [f64; 2],
}

/// One mode of an animated tower.
///
/// The largest translation (for torsion and yaw the largest rotation) is about 1; rotations of
/// other modes are per metre.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct AnimatedMode {
    /// Number in the list of modes, from 1.
    pub number: usize,
    /// Its name: "1st fore-aft bending".
    pub label: String,
    /// The name of its family: `fore-aft`.
    pub family: &'static str,
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Translation fore-aft at each height.
    pub x: Vec<f64>,
    /// Translation side-side at each height.
    pub y: Vec<f64>,
    /// Translation upwards at each height.
    pub z: Vec<f64>,
    /// Rotation about x.
    pub rotation_x: Vec<f64>,
    /// Rotation about y.
    pub rotation_y: Vec<f64>,
    /// Rotation about the tower's axis.
    pub rotation_z: Vec<f64>,
    /// Translations x, y, z of the joints of the frame, then of three points of each member, one
    /// after the other.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub frame: Vec<f64>,
}

/// The data of an animation of these modes, from their shapes at equally spaced heights.
pub fn animation_data(
    description: &TowerDescription,
    tower: &Tower,
    solution: &Solution,
) -> AnimationData {
    let points = solution.modes.first().map_or(&[][..], |mode| &mode.shape);
    let heights_m: Vec<f64> = few(points).map(|point| point.height_m).collect();
    let radius_m = heights_m
        .iter()
        .map(|height_m| five_digits(0.5 * outer_diameter_m(tower, *height_m)));
    AnimationData {
        radius_m: radius_m.collect(),
        is_nominal: is_nominal(tower),
        bodies: scene(description, tower),
        frame: Parts::new(description, tower).substructure().map(frame_of),
        modes: solution.modes.iter().map(animated).collect(),
        height_m: heights_m.into_iter().map(five_digits).collect(),
    }
}

fn frame_of(substructure: Substructure<'_>) -> AnimatedFrame {
    let [x, y, _] = substructure.of.reference_m();
    let description = substructure.description();
    let joint = |joint: &FrameJoint| {
        let [a, b, c] = joint.position_m;
        [a - x, b - y, c].map(five_digits)
    };
    let member = |member: &FrameMember| AnimatedMember {
        joints: member.joints,
        radius_m: radii_m(member).unwrap_or_default().map(five_digits),
    };
    AnimatedFrame {
        joints: description.joints.iter().map(joint).collect(),
        members: description.members.iter().map(member).collect(),
    }
}

/// The translations of joints and of points of members, rounded to a ten-thousandth of the largest,
/// which is less than a pixel.
fn frame_motion(mode: &Mode) -> Vec<f64> {
    let Some(shape) = &mode.frame else {
        return Vec::new();
    };
    let digit = 1e-4 * largest_translation(mode);
    let joints = shape.joints.iter().flat_map(|joint| joint[..3].iter());
    let values = joints.chain(shape.members.iter().flatten().flatten());
    let rounded = |value: &f64| match digit > 0.0 {
        true => five_digits((value / digit).round() * digit),
        false => 0.0,
    };
    values.map(rounded).collect()
}

fn animated(mode: &Mode) -> AnimatedMode {
    let values = |of: fn(&ShapePoint) -> &[f64; 3], axis: usize| {
        let points = few(&mode.shape);
        points.map(|point| five_digits(of(point)[axis])).collect()
    };
    let translation = |axis| values(|point| &point.translation, axis);
    let rotation = |axis| values(|point| &point.rotation, axis);
    AnimatedMode {
        number: mode.number,
        label: mode.label(),
        family: mode.family.name(),
        frequency_hz: five_digits(mode.frequency_hz),
        x: translation(0),
        y: translation(1),
        z: translation(2),
        rotation_x: rotation(0),
        rotation_y: rotation(1),
        rotation_z: rotation(2),
        frame: frame_motion(mode),
    }
}

/// At most [`MOST_HEIGHTS`] of the points, including the first and the last.
fn few(points: &[ShapePoint]) -> impl Iterator<Item = &ShapePoint> {
    let intervals = points.len().saturating_sub(1);
    let step = intervals.div_ceil(MOST_HEIGHTS - 1).max(1);
    let between = points.iter().take(intervals).step_by(step);
    between.chain(points.last())
}

#[cfg(test)]
mod tests {
    use towermodes::ShapePoint;

    use super::few;

    #[test]
    fn heights_are_few_and_reach_both_ends() {
        for count in [0, 1, 2, 59, 60, 61, 101, 119, 120, 1000] {
            let points: Vec<ShapePoint> = (0..count)
                .map(|k| ShapePoint {
                    height_m: k as f64,
                    ..ShapePoint::default()
                })
                .collect();
            let chosen: Vec<f64> = few(&points).map(|point| point.height_m).collect();
            assert!(chosen.len() <= 60, "{count}: {}", chosen.len());
            assert!(chosen.is_sorted_by(|a, b| a < b));
            assert_eq!(chosen.first(), points.first().map(|point| &point.height_m));
            assert_eq!(chosen.last(), points.last().map(|point| &point.height_m));
        }
        let points = vec![ShapePoint::default(); 101];
        assert_eq!(few(&points).count(), 51);
    }
}
