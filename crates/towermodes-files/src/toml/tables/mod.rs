//! The tables of the tower file that have their own readers.

pub(super) mod added_mass;
pub(super) mod body;
pub(super) mod damping;
pub(super) mod drivetrain;
pub(super) mod gravity;
pub(super) mod masses;
pub(super) mod materials;
pub(super) mod matrix;
pub(super) mod missing_parts;
pub(super) mod properties;
pub(super) mod rotor;
pub(super) mod soil;
pub(super) mod stations;
pub(super) mod water;
pub(super) mod wires;
