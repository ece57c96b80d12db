//! Variants of a tower: with slightly changed values for derivatives, in softer soil, without some
//! of its springs.

pub(super) mod neighbour;
pub(super) mod numbers;
pub(super) mod soil_factor;
pub(super) mod stripped;
