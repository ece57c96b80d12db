//! The tower or blade that a deck describes.

pub(super) mod blade;
pub(super) mod building;
pub(super) mod foundation;
pub(super) mod matrix;
pub(super) mod notes;
pub(super) mod surroundings;
pub(super) mod tower;
