//! A mode as curves over the segments, normalized and sampled.

use super::family::Family;
use super::shape::ShapePoint;

/// What a model knows of a mode between its segment borders; heights within a segment are shares s from 0 to 1.
pub trait SegmentCurves {
    /// The motion at s: deflection and rotation of the section in bending; otherwise the motion itself and zero.
    fn motion(&self, segment: usize, s: f64) -> [f64; 2];

    /// The motion of largest magnitude on the segment.
    fn extreme(&self, segment: usize) -> f64;
}

/// A mode, ready to be sampled.
pub struct ModeCurve<'a> {
    borders_m: &'a [f64],
    curves: &'a dyn SegmentCurves,
    /// The largest motion, with the sign of the top's.
    largest: f64,
}

impl<'a> ModeCurve<'a> {
    /// The mode with these curves between the segment borders (m).
    pub fn new(borders_m: &'a [f64], curves: &'a dyn SegmentCurves) -> Self {
        let segments = borders_m.len() - 1;
        let largest = (0..segments)
            .map(|segment| curves.extreme(segment).abs())
            .fold(0.0, f64::max);
        Self {
            borders_m,
            curves,
            largest: largest.copysign(curves.motion(segments - 1, 1.0)[0]),
        }
    }

    /// The number by which the eigenvector is divided.
    pub fn largest(&self) -> f64 {
        self.largest
    }

    /// The shape at heights (m) on the tower, as motion of the given family.
    pub fn sample(&self, family: Family, heights_m: &[f64]) -> Vec<ShapePoint> {
        let point = |&height_m: &f64| {
            let borders = self.borders_m;
            let above = borders.partition_point(|&border| border <= height_m);
            let segment = above.clamp(1, borders.len() - 1) - 1;
            let s = (height_m - borders[segment]) / (borders[segment + 1] - borders[segment]);
            let [value, rotation] = self.curves.motion(segment, s).map(|x| x / self.largest);
            shape_point(family, height_m, value, rotation)
        };
        heights_m.iter().map(point).collect()
    }
}

fn shape_point(family: Family, height_m: f64, value: f64, rotation: f64) -> ShapePoint {
    let (translation, rotation) = match family {
        Family::ForeAft | Family::SideSide => ([value, 0.0, 0.0], [0.0, rotation, 0.0]),
        Family::Axial => ([0.0, 0.0, value], [0.0; 3]),
        Family::Torsion => ([0.0; 3], [0.0, 0.0, value]),
    };
    let point = ShapePoint {
        height_m,
        translation,
        rotation,
    };
    match family {
        Family::SideSide => point.turned_to_side_side(),
        _ => point,
    }
}
