//! A mode as curves over the segments, normalized and sampled.

use super::shape::ShapePoint;
use crate::subsystem::SegmentCurves;

/// A mode, ready to be sampled.
pub struct ModeCurve<'a> {
    borders_m: &'a [f64],
    curves: &'a dyn SegmentCurves,
    /// The component with the largest absolute value over the height, signed so that the motion of
    /// the top is positive after division by it.
    largest: f64,
}

impl<'a> ModeCurve<'a> {
    /// The mode with these curves between the segment borders (m), normalized by the largest of
    /// these components.
    pub fn new(borders_m: &'a [f64], curves: &'a dyn SegmentCurves, components: &[usize]) -> Self {
        let segments = borders_m.len() - 1;
        let largest_of = |component: usize| {
            let extremes = (0..segments).map(|segment| curves.extreme(segment, component).abs());
            extremes.fold(0.0, f64::max)
        };
        let mut largest = (components[0], largest_of(components[0]));
        for &component in &components[1..] {
            let other = largest_of(component);
            if other > largest.1 {
                largest = (component, other);
            }
        }
        Self {
            borders_m,
            curves,
            largest: largest
                .1
                .copysign(curves.motion(segments - 1, 1.0)[largest.0]),
        }
    }

    /// The component of the eigenvector by which the shape is divided, so that its largest
    /// component is 1.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// The shape at heights (m) on the tower.
    pub fn sample(&self, heights_m: &[f64]) -> Vec<ShapePoint> {
        let point = |&height_m: &f64| {
            let borders = self.borders_m;
            let above = borders.partition_point(|&border| border <= height_m);
            let segment = above.clamp(1, borders.len() - 1) - 1;
            let s = (height_m - borders[segment]) / (borders[segment + 1] - borders[segment]);
            // A zero keeps its sign for any sign of the largest component.
            let motion = self
                .curves
                .motion(segment, s)
                .map(|x| if x == 0.0 { 0.0 } else { x / self.largest });
            let [x, y, z, rx, ry, rz] = motion;
            ShapePoint {
                height_m,
                translation: [x, y, z],
                rotation: [rx, ry, rz],
            }
        };
        heights_m.iter().map(point).collect()
    }
}
