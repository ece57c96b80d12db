//! Modes in the layout of BModes.

pub(super) mod norm;
pub(super) mod out;
pub(super) mod out_nodes;
