//! The Rust module of the Python package: classes and functions that wrap the library.
//!
//! The items of this module are used only by `python/towermodes`, which adds names, defaults, types
//! and documentation for users.

mod agreement;
mod answer;
mod array;
mod arrow;
mod campbell;
mod comparison;
mod converted;
mod damping;
mod error;
mod first_order;
mod found;
mod input;
mod interrupt;
mod lock;
mod model;
mod mooring;
mod options;
mod pickle;
mod planned;
mod program;
mod reading;
mod sensitivity;
mod solution;
mod substructure;
mod sweep;
mod tower;
mod turbine;
mod turbine_campbell;

/// The classes and functions of the package.
#[pyo3::pymodule(gil_used = false)]
mod _towermodes {
    #[pymodule_export]
    use crate::agreement::{check, examine};
    #[pymodule_export]
    use crate::answer::Answer;
    #[pymodule_export]
    use crate::arrow::{columns_of_stream, stream_of_columns, stream_of_results};
    #[pymodule_export]
    use crate::campbell::campbell;
    #[pymodule_export]
    use crate::comparison::compare;
    #[pymodule_export]
    use crate::converted::Converted;
    #[pymodule_export]
    use crate::damping::damping;
    #[pymodule_export]
    use crate::first_order::first_order;
    #[pymodule_export]
    use crate::found::{Found, calibrate, design, source};
    #[pymodule_export]
    use crate::lock::close;
    #[pymodule_export]
    use crate::mooring::solve_mooring;
    #[pymodule_export]
    use crate::planned::{rows_within_table, values_of_study, values_of_table};
    #[pymodule_export]
    use crate::program::run;
    #[pymodule_export]
    use crate::reading::{read, read_text, tower_file_keys};
    #[pymodule_export]
    use crate::sensitivity::sensitivities;
    #[pymodule_export]
    use crate::solution::Solution;
    #[pymodule_export]
    use crate::substructure::solve_substructure;
    #[pymodule_export]
    use crate::sweep::{mode_named, sweep};
    #[pymodule_export]
    use crate::tower::Tower;
    #[pymodule_export]
    use crate::turbine::TurbineModes;
    #[pymodule_export]
    use crate::turbine_campbell::turbine_campbell;

    /// The version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
