//! Mooring systems from the input files of MoorDyn (versions 1 and 2) and of MAP++.
//!
//! Sources: `MD_Init` in `MoorDyn.f90` and `Rod_Setup` in `MoorDyn_Rod.f90` (OpenFAST); the input
//! file in the documentation of MAP++. Tables are found by the words of their headings and columns
//! by their names, because files of different versions differ in the order of their columns.

mod attachment;
mod bodies;
mod column;
mod input;
mod line_types;
mod lines;
mod map;
mod map_nodes;
mod moordyn;
mod options;
mod points;
mod repeat;
mod rods;
mod row;
mod site;
mod tables;
mod unused;

pub(crate) use input::Spans;
pub use input::{MooringInput, MooringSite};
pub(crate) use map::is_map;
pub use map::read_map;
pub(crate) use moordyn::is_moordyn;
pub use moordyn::read_moordyn;
