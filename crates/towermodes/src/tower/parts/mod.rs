//! The parts of the description of a tower: materials, properties of sections, bodies, rotor,
//! surroundings, damping.

pub(super) mod added_mass;
pub(super) mod damping;
pub(super) mod drivetrain;
pub(super) mod floating_platform;
pub(super) mod foundation_springs;
pub(super) mod inertia;
pub(super) mod material;
pub(super) mod missing;
pub(super) mod mooring_lines;
pub(super) mod part_names;
pub(super) mod properties;
pub(super) mod rigid_body;
pub(super) mod rotor;
pub(super) mod surroundings;
