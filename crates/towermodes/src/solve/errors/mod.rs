//! The errors of frequencies, from other meshes, other degrees and the reference solution.

pub(super) mod estimate;
pub(super) mod p_refinement;
pub(super) mod pairing;
pub(super) mod reference;
pub(super) mod tracking;
