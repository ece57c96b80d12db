//! What a rotor excites: its speeds, the multiples of them, how far natural frequencies are from
//! these, and what its blades do as it turns.

mod campbell;
mod class;
mod conclusion;
mod description;
mod diagram;
mod margin;
mod percent;
mod reach;
mod sweep;
mod track;

pub use campbell::{
    Campbell, CampbellError, CampbellOptions, DEFAULT_MARGIN, Excited, FrequencyLine, LineEnd,
    Margin, StiffnessClass,
};
pub use description::{BEYOND_OPERATION, FASTEST_RPM, MOST_BLADES, Rotor, Rpm};
pub use diagram::campbell;
pub use reach::reach_hz;
