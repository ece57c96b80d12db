//! All tests of the library, in one program: a newcomer compiles and links them once.

mod allocation;
mod analytic;
mod beams;
mod blade;
mod blade_sweep;
mod campbell;
mod convergence;
mod dense;
mod eigensolver;
mod elastodyn_model;
mod elastodyn_modes;
mod elastodyn_rows;
mod elastodyn_shapes;
mod elastodyn_towers;
mod ground;
mod independence;
mod invariance;
mod methods;
mod pencils;
mod plausibility;
mod real_towers;
mod refusal;
mod study;
mod tables;
mod towers;
mod watch;
