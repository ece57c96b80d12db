//! All tests of the library, in one program: a newcomer compiles and links them once.

mod allocation;
mod analytic;
mod architecture;
mod beams;
mod blade;
mod buckling;
mod certain;
mod closed_forms;
mod convergence;
mod dense;
mod eigensolver;
mod estimates;
mod frequencies;
mod ground;
mod independence;
mod invariance;
mod methods;
mod parameters;
mod pencils;
mod plausibility;
mod real_towers;
mod refusal;
mod sensitivities;
mod tables;
mod towers;
mod watch;
