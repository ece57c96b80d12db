//! The rotor-nacelle assembly of an ElastoDyn model: blades, shaft, drivetrain, controller.

pub(super) mod blade_file;
pub(super) mod controller;
mod damper;
pub(super) mod lump;
pub(super) mod rotor;
pub(super) mod servodyn;
pub(super) mod shaft;
pub(super) mod structural_control;
pub(super) mod turbine;
