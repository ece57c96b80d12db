//! The floating platform of a windIO file with its mooring lines.
//!
//! Sources: the schemas of windIO 1.0 and 2.x; WISDEM (NREL), which reads these files, for the ends
//! of members at the surface of others and for ballast that balances the platform.

mod balance;
mod ballast;
mod chains;
mod joints;
mod lines;
mod members;
mod steel;
mod stiffeners;

pub(super) use balance::{Afloat, float};
