//! A tower on one mesh: subsystems, lowest modes, the proof that none is missing, names.

pub(super) mod alignment;
pub(super) mod cut;
pub(super) mod guesses;
pub(super) mod listing;
pub(super) mod model;
pub(super) mod naming;
pub(super) mod one_mesh;
pub(super) mod spectral_cut;
pub(super) mod spectrum;
pub(super) mod stability;
