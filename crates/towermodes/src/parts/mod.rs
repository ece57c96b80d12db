//! The independent parts of a tower's model, whatever it is made of, and each as an eigenvalue
//! problem.

mod model;
mod part;
mod pencil;
mod structure;

pub use model::Parts;
pub use part::{Kind, Member, Part};
pub(crate) use part::{
    SPACE, embedded, on_components, on_structure, plane_and_line_components, plane_components,
};
pub use pencil::{Problem, StructurePencil};
pub use structure::{Balance, Combination, Role, Structure};
