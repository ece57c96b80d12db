//! Words and sentences that occur in several outputs: tables on a terminal, reports, pictures.
//!
//! Each sentence is written once, so that all surfaces use the same words for the same result.

mod balance;
mod completeness;
mod mode;
mod model;
mod remedy;
mod rotor;
mod text;
mod turbine;

pub use balance::static_balance;
pub use completeness::{
    complete_below_hz, completeness, completeness_of_blade, proof_of_completeness,
};
pub use mode::{blade_mode_shape, coupled_shape, mode_shape};
pub use model::{
    buckling_load_factor, compared_segments, computed_by, levels, mesh, structure_mass,
};
pub use remedy::remedy;
pub use rotor::{operation, operation_of, speed_range, verdict_counts, verdict_word};
pub use text::{counted, listed, printable, sentence};
pub use turbine::{STRUCTURE_ONLY, proved};
