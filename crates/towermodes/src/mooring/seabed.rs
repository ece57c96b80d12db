//! The seabed under the lines.

use super::description::{Attachment, MooringDescription};

/// Heights that differ by less than this fraction of the depth are treated as equal.
const ROUNDED: f64 = 1e-6;

impl MooringDescription {
    /// The depth of all anchors, m, if they are at one depth and nothing is below them.
    pub fn depth_of_anchors_m(&self) -> Option<f64> {
        let points = self.points.iter();
        let mut anchors = points
            .clone()
            .filter(|point| point.attachment == Attachment::Fixed)
            .map(|point| point.position_m[2]);
        let first_m = anchors.next()?;
        let near_m = ROUNDED * first_m.abs();
        let is_level = anchors.all(|z_m| (z_m - first_m).abs() <= near_m);
        let placed = points.filter(|point| match point.attachment {
            Attachment::Fixed | Attachment::Platform | Attachment::Free => true,
            Attachment::Body(_) | Attachment::Rod(..) => false,
        });
        let bodies = self.bodies.iter().map(|body| body.position_m[2]);
        let rods = self.rods.iter().flat_map(|rod| rod.ends_m);
        let mut heights_m = placed
            .map(|point| point.position_m[2])
            .chain(bodies)
            .chain(rods.map(|end_m| end_m[2]));
        let is_lowest = heights_m.all(|z_m| z_m >= first_m - near_m);
        (first_m < 0.0 && is_level && is_lowest).then_some(-first_m)
    }

    /// The depth of the seabed under the lines, m: that of the anchors, if all are at one depth and
    /// nothing is below them. Where the given depth is that of another place, the lines would hang
    /// from their anchors as from poles.
    pub(super) fn depth_under_lines_m(&self) -> f64 {
        let anchors_m = self.depth_of_anchors_m();
        let is_above = |anchors_m: &f64| *anchors_m < self.depth_m * (1.0 - ROUNDED);
        anchors_m.filter(is_above).unwrap_or(self.depth_m)
    }
}
