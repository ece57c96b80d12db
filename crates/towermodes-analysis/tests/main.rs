//! All tests of the analyses, in one program: a newcomer compiles and links them once.

mod blade_sweep;
mod campbell;
mod damping;
mod elastodyn_model;
mod elastodyn_modes;
mod elastodyn_rows;
mod elastodyn_shapes;
mod elastodyn_towers;
mod soil_band;
mod study;
mod towers;
mod whirl;
