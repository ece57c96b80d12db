//! The equations of motion of a turbine at a frequency and a speed of its rotor.

pub(super) mod below;
pub(super) mod blade_elements;
pub(super) mod bordered;
pub(super) mod coupled;
pub(super) mod gyroscopic;
pub(super) mod machine;
pub(super) mod machine_vectors;
pub(super) mod mesh;
pub(super) mod model;
