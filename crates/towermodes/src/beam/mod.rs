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
mod product;
mod rotating;
mod steady;
mod strain;
mod subsystem;
mod turning;
mod turning_section;

pub(crate) use assembly::assemble_in_space;
pub use assembly::{BeamRecipe, BeamWorkspace, assemble_beams};
pub use elimination::Condensed;
pub(crate) use elimination::eliminate;
pub use model::Beam;
pub(crate) use rotating::{assemble_blade, blade_coordinates};
pub use subsystem::{BeamAssembly, Beams};
pub(crate) use subsystem::{SpaceBeam, TopWorkspace};
pub use turning::TurningBlade;
pub(crate) use turning::congruent;
