//! Why the input values describe no tower, or the tower cannot be solved, and which input values
//! are concerned.

use serde::Serialize;
use towermodes::{Parameter, Place, SolveError, TowerDescription, TowerError};
use towermodes_analysis::resonance::CampbellError;
use towermodes_files::SettingError;
use towermodes_report::wording::remedy;

/// A refused tower.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Refusal {
    /// The refusal.
    pub refused: Refused,
}

/// The error, a suggestion, and the place.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Refused {
    /// The error.
    pub message: String,
    /// The suggestion, if there is one.
    pub hint: Option<String>,
    /// The names of the input values concerned; none if the error is about the whole tower.
    pub parameters: Vec<String>,
}

impl Refusal {
    pub(crate) fn new(message: String, hint: Option<&str>, parameters: Vec<String>) -> Self {
        let hint = hint.map(str::to_owned);
        Self {
            refused: Refused {
                message,
                hint,
                parameters,
            },
        }
    }

    /// An error that is about no single input value and has no hint.
    pub(crate) fn of(error: &impl ToString) -> Self {
        Self::new(error.to_string(), None, Vec::new())
    }

    /// The refusal for input values that describe no possible tower.
    pub(crate) fn of_tower(error: &TowerError, description: &TowerDescription) -> Self {
        let parameters = names_at(error.place, description);
        Self::new(error.to_string(), error.hint(), parameters)
    }

    /// The refusal for a tower that cannot be solved.
    pub(crate) fn of_solve(error: &SolveError) -> Self {
        Self::new(error.to_string(), remedy_here(error), Vec::new())
    }

    /// The refusal for a rotor whose excitations cannot be checked.
    pub(crate) fn of_campbell(error: &CampbellError, description: &TowerDescription) -> Self {
        match error {
            CampbellError::Rotor(error) => Self::of_tower(error, description),
            error => Self::of(error),
        }
    }

    /// The refusal for input values that cannot be set.
    pub(crate) fn of_setting(error: &SettingError) -> Self {
        Self::of(error)
    }
}

/// Suggestion on a page, which has no command-line options.
fn remedy_here(error: &SolveError) -> Option<&'static str> {
    match error {
        SolveError::Buckles { .. } => {
            Some("reduce the mass, or increase the diameter or the wall thickness")
        }
        SolveError::TooManyModes { .. }
        | SolveError::TooLarge { .. }
        | SolveError::TooSlow { .. } => {
            Some("start the program again with other --modes or --segments")
        }
        error => remedy(error),
    }
}

/// The names of the input values at a place of a description.
pub(crate) fn names_at(place: Place, description: &TowerDescription) -> Vec<String> {
    let all = Parameter::all(description).into_iter();
    let here = all.filter(|parameter| parameter.place() == place);
    here.map(|parameter| parameter.to_string()).collect()
}
