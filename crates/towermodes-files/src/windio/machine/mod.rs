//! The rotor-nacelle assembly of a windIO turbine: masses, rotor, shaft, speeds.

pub(super) mod body;
pub(super) mod chords;
pub(super) mod given_masses;
pub(super) mod plausible;
pub(super) mod rna;
pub(super) mod rotor;
pub(super) mod shaft;
pub(super) mod speeds;
pub(super) mod turbine;
