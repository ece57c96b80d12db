//! Resonance: the multiples of the rotor speed that excite the tower, their distances from natural
//! frequencies (the Campbell diagram), the stiffness class, and the blade modes against the rotor
//! speed.

mod campbell;
mod clamped;
mod class;
mod conclusion;
mod diagram;
mod margin;
mod mode_class;
mod not_checked;
mod percent;
mod reach;
mod remark;
mod rotor;
mod sweep;
mod track;
mod unchecked;
mod weight;
mod without;

pub use campbell::{
    BEYOND_OPERATION, Campbell, CampbellError, CampbellOptions, DEFAULT_MARGIN, Excited,
    FrequencyLine, LineEnd, Margin, SharedFirst, StiffnessClass,
};
pub use clamped::ClampedBase;
pub(crate) use class::class_along;
pub use diagram::campbell;
pub(crate) use diagram::{check_options, margins};
pub use margin::{TowerMargin, tower_margin};
pub use mode_class::ModeClass;
pub(crate) use not_checked::not_checked;
pub use not_checked::{NotChecked, unknown_speeds};
pub use reach::{MOST_MODES, reach_hz, solve_to_reach};
pub(crate) use remark::mode_lost;
pub use remark::{Assessment, Covered, Remark, assess};
pub use rotor::{ChosenRotor, GivenRotor};
pub(crate) use sweep::speeds_rpm;
pub use weight::WeightLeftOut;
pub use without::verdicts_without;
