//! What a rotor excites: its speeds, the multiples of them, how far natural frequencies are from
//! these, and what its blades do as it turns.

mod campbell;
mod class;
mod conclusion;
mod diagram;
mod margin;
mod percent;
mod reach;
mod sweep;
mod track;

pub use campbell::{
    BEYOND_OPERATION, Campbell, CampbellError, CampbellOptions, DEFAULT_MARGIN, Excited,
    FrequencyLine, LineEnd, Margin, StiffnessClass,
};
pub use diagram::campbell;
pub use reach::reach_hz;
