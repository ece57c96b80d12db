//! Results as text tables, which the program prints and the Python package shows.

mod agreement;
mod blade;
mod calibration;
mod campbell;
mod comparison;
mod convergence;
mod damping;
mod design;
mod elastodyn;
mod first_order;
mod parameters;
mod sensitivities;
mod several;
mod soil_band;
mod solution;
mod sweep;
mod text;
mod verification;

pub use agreement::{agreement, examination};
pub(crate) use blade::blade;
pub use calibration::calibration;
pub use campbell::campbell;
pub use comparison::comparison;
pub(crate) use convergence::convergence;
pub use damping::damping;
pub use design::design;
pub(crate) use elastodyn::{changes, fits, judgements};
pub use first_order::first_order;
pub(crate) use parameters::parameters;
pub(crate) use sensitivities::sensitivities;
pub(crate) use several::several;
pub use soil_band::soil_band;
pub use solution::{MODE_HEADER, below_modes, mode_rows, solution};
pub(crate) use sweep::sweep_summary;
pub(crate) use verification::verification;
