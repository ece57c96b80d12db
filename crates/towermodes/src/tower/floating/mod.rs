//! A floating tower at rest: weights, buoyancy and mooring lines, their balance at the reference
//! position, and the position in which they are in balance.

pub(super) mod afloat;
pub(super) mod balance;
pub(super) mod equilibrium;
pub(super) mod mistake;
