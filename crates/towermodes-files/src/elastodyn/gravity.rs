//! The acceleration of gravity of an ElastoDyn model, which always has one.

use super::main_file::MainFile;
use crate::input::Note;

/// Standard acceleration of gravity, m/s² (3rd General Conference on Weights and Measures, 1901).
const STANDARD_M_PER_S2: f64 = 9.80665;

/// Gravity, and what the user should know of where it is from.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Gravity {
    /// Acceleration, m/s².
    pub(super) m_per_s2: f64,
    pub(super) note: Option<Note>,
}

/// The gravity of a model: that of the `.fst` file, as OpenFAST takes it since 3.0, else that of
/// the main file, where it was before, else the standard one with a note. A tower that hangs under
/// water has none here. Files are given by their names.
pub(super) fn gravity(main: &MainFile, main_name: &str, fst: Option<(f64, &str)>) -> Gravity {
    if main.tower_hangs() {
        let (m_per_s2, note) = (0.0, None);
        return Gravity { m_per_s2, note };
    }
    let (m_per_s2, message) = match (fst, main.gravity_m_per_s2) {
        (Some((of_fst, name)), Some(of_main)) if of_fst != of_main => {
            let message = format!(
                "Gravity is {of_fst} m/s2 in {name} and {of_main} m/s2 in {main_name}; the first is taken"
            );
            (of_fst, Some(message))
        }
        (Some((of_fst, _)), _) => (of_fst, None),
        (None, Some(of_main)) => (of_main, None),
        (None, None) => {
            let message = format!(
                "{main_name} does not say Gravity, which is in the .fst file: {STANDARD_M_PER_S2} m/s2 is taken (--no-gravity leaves it out)"
            );
            (STANDARD_M_PER_S2, Some(message))
        }
    };
    let note = message.map(Note::new);
    Gravity { m_per_s2, note }
}
