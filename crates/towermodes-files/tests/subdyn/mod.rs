//! Files of SubDyn: layouts of all versions, refusals with their places, damaged files, and public
//! substructures if they are at hand.

pub mod damaged;
mod frequencies;
mod layouts;
mod public;
mod refused;
pub mod soildyn;
pub mod texts;
