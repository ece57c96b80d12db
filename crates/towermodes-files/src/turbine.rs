//! What a reader found of the turbine on a tower.

use towermodes::turbine::{Turbine, TurbineDescription, TurbineError};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::TowerInput;
use crate::note::Note;

/// More sections than any table of a blade has; each is the border of an element.
pub(crate) const MOST_SECTIONS: usize = 1000;

/// A turbine with its notes, or why there is none.
#[derive(Debug, Clone, Default)]
pub(crate) struct TurbineReading {
    pub(crate) description: Option<TurbineDescription>,
    pub(crate) missing: Option<Note>,
    pub(crate) notes: Vec<Note>,
}

impl TurbineReading {
    /// No turbine, for a reason.
    pub(crate) fn missing(reason: Note) -> Self {
        Self {
            missing: Some(reason),
            ..Self::default()
        }
    }

    /// A turbine that the library accepts.
    pub(crate) fn checked(
        description: TurbineDescription,
        notes: Vec<Note>,
    ) -> Result<Self, TurbineError> {
        description.rna()?;
        Ok(Self {
            description: Some(description),
            missing: None,
            notes,
        })
    }
}

impl TowerInput {
    /// The turbine on its tower, in place of the rotor-nacelle assembly as a rigid body; none if
    /// the files have none, or none that can be solved ([`Self::turbine_missing`]).
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the place of what no tower can have.
    ///
    /// # Example
    /// ```
    /// use towermodes_files::TowerInput;
    ///
    /// let input = TowerInput::from_description(towermodes::TowerDescription::default());
    /// assert!(input.whole_turbine()?.is_none());
    /// # Ok::<(), towermodes_files::ReadError>(())
    /// ```
    pub fn whole_turbine(&self) -> Result<Option<Turbine>, ReadError> {
        let Some(machine) = &self.turbine else {
            return Ok(None);
        };
        let turbine = Turbine::in_place_of_rna(self.description.clone(), machine.clone());
        turbine.map(Some).map_err(|error| match error {
            TurbineError::Tower(error) => self.tower_mistake(&error),
            other => {
                let kind = DiagnosticKind::Turbine(Box::new(other));
                ReadError::mistake(self.source(0), Diagnostic::new(0..0, kind))
            }
        })
    }

    /// Keeps what a reader found of the turbine.
    pub(crate) fn with_turbine(mut self, reading: TurbineReading) -> Self {
        self.turbine = reading.description;
        self.turbine_missing = reading.missing;
        self.turbine_notes = reading.notes;
        self
    }

    /// Takes the turbine away, for a reason if there was one.
    pub(crate) fn remove_turbine(&mut self, reason: Option<Note>) {
        self.turbine_notes.clear();
        if self.turbine.take().is_some() || reason.is_none() {
            self.turbine_missing = reason;
        }
    }
}
