//! A mode shape in one plane as samples along the flexible tower.

use towermodes::modes::ShapePoint;
use towermodes::tower::Plane;

/// Samples of a mode shape in one plane, and the motion of the base.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct ShapeSamples {
    /// Height x as a fraction of the flexible tower, rising from 0 at its base to 1 at its top, and
    /// the deflection there.
    pub points: Vec<(f64, f64)>,
    /// Deflection of the base.
    pub base_translation: f64,
    /// Deflection of the top due to the rotation of the base alone: the slope at the base times the
    /// length of the flexible tower.
    pub base_slope: f64,
}

impl ShapeSamples {
    /// The samples of a shape between its first and last point, in one plane: deflection x and
    /// rotation about y fore-aft, deflection y and rotation about −x side-side.
    pub fn of(shape: &[ShapePoint], plane: Plane) -> Self {
        let deflection = |point: &ShapePoint| match plane {
            Plane::ForeAft => point.translation[0],
            Plane::SideSide => point.translation[1],
        };
        let (Some(base), Some(top)) = (shape.first(), shape.last()) else {
            return Self::default();
        };
        let length_m = top.height_m - base.height_m;
        let slope = match plane {
            Plane::ForeAft => base.rotation[1],
            Plane::SideSide => -base.rotation[0],
        };
        let sample = |point: &ShapePoint| {
            let x = (point.height_m - base.height_m) / length_m;
            (x, deflection(point))
        };
        Self {
            points: shape.iter().map(sample).collect(),
            base_translation: deflection(base),
            base_slope: slope * length_m,
        }
    }

    /// The deflection of each sample without the contribution of the base motion.
    pub(super) fn bent(&self) -> impl Iterator<Item = (f64, f64)> {
        let (translation, slope) = (self.base_translation, self.base_slope);
        let points = self.points.iter();
        points.map(move |&(x, value)| (x, value - translation - slope * x))
    }
}
