//! Beams of flexible elements in D components: the elements of BModes, of the spectral method and
//! of rotating blades.

mod assembly;
mod blade;
mod branch;
mod curves;
mod element;
mod elimination;
mod general;
mod legendre;
mod member;
mod model;
mod product;
mod space_vectors;
mod strain;
mod substitution;
mod subsystem;

pub(crate) use assembly::assemble_in_space;
pub use assembly::{BeamRecipe, BeamWorkspace, assemble_beams};
pub(crate) use blade::rotating::{assemble_blade, blade_coordinates};
pub(crate) use blade::turning::congruent;
pub use blade::turning::{BladeFactors, TurningBlade};
pub use elimination::Condensed;
pub(crate) use elimination::{eliminate, eliminate_rows, first_block};
pub(crate) use member::{MemberElement, MemberPart, MemberSlice, MemberStrains, SoilPart};
pub use model::Beam;
pub(crate) use space_vectors::TopWorkspace;
pub(crate) use substitution::{reduce, substitute};
pub(crate) use subsystem::SpaceBeam;
pub use subsystem::{BeamAssembly, Beams};

/// Highest degree of elements; more elements are better than a higher degree.
pub const MAX_DEGREE: usize = 60;
