//! Floating platforms in windIO: masses, water, ballast and mooring lines against an independent
//! program, refusals with their lines.

mod platforms;
mod refused;
pub mod texts;
