//! Mooring systems: lines by hand and of MAP++, the 6×6 stiffness of public floaters, free points,
//! bodies and rods, differences of the force, invariances, refusals, random lines.

mod decks;
mod differences;
mod foundation;
mod free_parts;
mod invariance;
mod masses;
mod platforms;
mod random_lines;
mod random_parts;
mod refusals;
mod single_lines;
mod warnings;
