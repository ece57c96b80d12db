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
mod strain;
mod subsystem;

pub use assembly::{BeamRecipe, BeamWorkspace, assemble_beams};
pub use model::Beam;
pub(crate) use rotating::{assemble_blade, blade_coordinates};
pub use subsystem::{BeamAssembly, Beams};
