//! Files of HydroDyn and WAMIT: layouts of all versions, masses by hand, refusals with their
//! places, damaged files, and public models if they are at hand.

mod masses;
mod public;
mod rectangles;
mod refused;
pub mod texts;
