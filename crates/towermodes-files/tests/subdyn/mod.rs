//! Files of SubDyn: layouts of all versions, refusals with their places, damaged files, and public
//! substructures if they are at hand.

mod damaged;
mod frequencies;
mod layouts;
mod public;
mod refused;
mod soildyn;
pub mod texts;
