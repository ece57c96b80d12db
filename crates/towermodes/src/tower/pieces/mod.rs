//! Pieces of the tower along its height: linear pieces, sections and their integrals, soil and
//! water around them.

pub(super) mod axisymmetric;
pub(super) mod environment;
pub(super) mod fronts;
pub(super) mod immersion;
pub(super) mod integrals;
pub(super) mod piece;
pub(super) mod planes;
pub(super) mod section;
pub(super) mod shear;
pub(super) mod slopes;
pub(super) mod weight;
