//! The modes of a turbine: names, energies, shapes.

pub(super) mod elastic;
pub(super) mod energy;
pub(super) mod mode;
pub(super) mod modes;
pub(super) mod name;
pub(super) mod naming;
pub(super) mod shape;
pub(super) mod shaping;
