//! The input file of SubDyn, the OpenFAST module for jackets, tripods and monopiles, with the files
//! of soil stiffness that it names, and the file of SoilDyn.
//!
//! Source: `SD_Input` in `SubDyn.f90` (OpenFAST) reads it by position; the layouts are those of
//! FAST 8 to OpenFAST 5.

mod input;
mod joints;
mod masses;
mod members;
mod properties;
mod read;
mod rigid;
mod rows;
mod sections;
mod settings;
mod soil;
mod soildyn;
mod supports;

pub use input::{Interface, SubdynInput};
pub use read::read_subdyn;
pub use soildyn::{SoildynInput, read_soildyn};

pub(crate) use settings::is_subdyn;
