//! The shape of an eigenvector within each segment.

use crate::tower::Plane;

/// An eigenvector as a continuous motion of the axis. A place within a segment is its fraction s
/// from 0 to 1; motions are (x, y, z, rotation about x, y, z).
pub trait SegmentCurves {
    /// The motion of the section at s.
    fn motion(&self, segment: usize, s: f64) -> [f64; 6];

    /// The value of largest magnitude of a translation, or of the rotation about z, on the segment.
    fn extreme(&self, segment: usize, component: usize) -> f64;
}

/// The fraction of the transverse flexibility of a segment that is shear, for a bending plane and
/// the heights of the segment's ends, m.
pub type ShearFraction<'a> = dyn Fn(Plane, f64, f64) -> f64 + 'a;
