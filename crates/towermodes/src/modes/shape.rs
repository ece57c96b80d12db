//! The shape of a mode along the tower.

/// The motion of the tower's axis at a height in a normalized mode.
///
/// The largest translation of the tower is 1 (for torsion the largest rotation), positive at the
/// top; rotations are in rad for a largest translation of 1 m (1/m).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ShapePoint {
    /// Height z in the datum of the stations, m.
    pub height_m: f64,
    /// Translation x (fore-aft), y (side-side), z (up).
    pub translation: [f64; 3],
    /// Rotation of the section about x, y, z.
    pub rotation: [f64; 3],
}

impl ShapePoint {
    /// Whether every number is finite.
    pub(crate) fn is_finite(&self) -> bool {
        let mut motion = self.translation.iter().chain(&self.rotation);
        motion.all(|value| value.is_finite())
    }

    /// The same motion in the side-side plane, if this one is in the fore-aft plane.
    ///
    /// A positive slope of y is a negative rotation about x.
    pub fn turned_to_side_side(&self) -> Self {
        Self {
            height_m: self.height_m,
            translation: [0.0, self.translation[0], 0.0],
            rotation: [0.0 - self.rotation[1], 0.0, 0.0],
        }
    }
}
