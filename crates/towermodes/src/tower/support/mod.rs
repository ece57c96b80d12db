//! What holds a tower, and the motions that are left to it.

pub(crate) mod added_mass;
pub(super) mod base;
pub(super) mod independent;
mod moored;
pub(super) mod pile_head;
pub(super) mod rigid;
pub(super) mod rigid_body_modes;
