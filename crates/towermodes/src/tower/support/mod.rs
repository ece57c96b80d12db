//! The support of a tower, and its remaining motions.

pub(crate) mod added_mass;
pub(super) mod base;
pub(super) mod foundation_head;
pub(super) mod independent;
mod moored;
pub(super) mod rigid;
pub(super) mod rigid_body_modes;
pub(super) mod soil_springs;
