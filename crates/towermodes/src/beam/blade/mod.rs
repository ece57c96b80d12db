//! Rotating blades: steady forces, sections and elements in the rotating frame.

pub(super) mod centrifugal;
pub(super) mod phasors;
pub(super) mod rotating;
pub(super) mod steady;
pub(super) mod tensor;
pub(super) mod turning;
pub(super) mod turning_section;
pub(super) mod turning_vectors;
