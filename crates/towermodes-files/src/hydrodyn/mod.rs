//! The input file of HydroDyn, the OpenFAST module for water, with the files of WAMIT that it
//! names.
//!
//! Source: `HydroDyn_Input.f90`, `Morison.f90` and `WAMIT.f90` (OpenFAST); the layouts are those of
//! FAST 8 to OpenFAST 5. Values and tables are found by their names, because their positions differ
//! between versions.

mod added_stiffness;
mod afloat;
mod beams;
mod beside_frame;
mod coats;
mod coefficients;
mod ends;
mod growth;
mod input;
mod members;
mod on_frame;
mod platform;
mod potential;
mod profile;
mod read;
mod section;
mod sections;
mod spatial;
mod strip;
mod strip_inertia;
mod strips;
mod tables;
mod values;
mod wamit;
mod water;
mod water_plane;

pub use ends::StripEnd;
pub use input::HydrodynInput;
pub use platform::HydrodynPlatform;
pub use potential::PotentialFlow;
pub use read::read_hydrodyn;
pub use section::StripSection;
pub use strip::{MarineGrowth, Stretch, StripAddedMass, StripMember};
pub(crate) use strips::{StripWater, ring, strip_water};
pub(crate) use water::{GivenWater, given_in, water_of_fst};
pub use water::{SeaWater, WaterDefaults, read_water};
