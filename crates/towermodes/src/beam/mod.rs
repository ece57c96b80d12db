//! Chains of flexible beam elements: the finite element of BModes and the spectral beam, one kind of element in both.

mod assembly;
mod count;
mod decoupled;
mod element;
mod legendre;
mod model;
mod pencil;
mod product;

pub use assembly::{BeamRecipe, BeamWorkspace, assemble_beams};
pub use count::count_below;
pub use decoupled::DecoupledBeams;
pub use legendre::{Legendre, Term, gauss_points};
pub use model::Beam;
pub use pencil::{BeamPencil, BeamPencilWorkspace};
pub use product::{base_excitation, mass_times, motions};
