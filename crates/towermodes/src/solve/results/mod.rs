//! The results of a solve: modes with shapes or only frequencies, their energies by parts,
//! warnings.

pub(super) mod energy_parts;
pub(super) mod frequencies;
#[cfg(feature = "serde")]
pub(super) mod mode_keys;
pub(super) mod solution;
pub(super) mod warnings;
