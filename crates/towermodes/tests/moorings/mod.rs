//! Mooring systems: lines by hand and of MAP++, the 6×6 stiffness of public floaters, free points,
//! bodies and rods, differences of the force, invariances, refusals, random lines.

mod decks;
mod free_parts;
mod platforms;
mod single_lines;
