//! What a rotor excites: its speeds, the multiples of them, how far natural frequencies are from these, and what its blades do as it turns.

mod campbell;
mod description;

pub use campbell::{
    Campbell, CampbellError, CampbellOptions, DEFAULT_MARGIN, Excited, FrequencyLine, Margin,
    StiffnessClass,
};
pub use description::Rotor;
