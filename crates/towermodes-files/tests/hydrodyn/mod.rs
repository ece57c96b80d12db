//! Files of HydroDyn and WAMIT: layouts of all versions, refusals with their places, damaged files,
//! and public models if they are at hand.

mod public;
