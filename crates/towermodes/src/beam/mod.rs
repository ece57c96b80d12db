//! Beams of flexible elements in D components: the element of BModes, the spectral element, and
//! those of rotating blades.

mod assembly;
mod centrifugal;
mod curves;
mod element;
mod elimination;
mod general;
mod legendre;
mod model;
mod phasors;
mod product;
mod rotating;
mod space_vectors;
mod steady;
mod strain;
mod substitution;
mod subsystem;
mod tensor;
mod turning;
mod turning_section;
mod turning_vectors;

pub(crate) use assembly::assemble_in_space;
pub use assembly::{BeamRecipe, BeamWorkspace, assemble_beams};
pub use elimination::Condensed;
pub(crate) use elimination::{eliminate, first_block};
pub use model::Beam;
pub(crate) use rotating::{assemble_blade, blade_coordinates};
pub(crate) use space_vectors::TopWorkspace;
pub(crate) use substitution::{reduce, substitute};
pub(crate) use subsystem::SpaceBeam;
pub use subsystem::{BeamAssembly, Beams};
pub(crate) use turning::congruent;
pub use turning::{BladeFactors, TurningBlade};
