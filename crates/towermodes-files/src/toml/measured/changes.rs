//! The names of unknowns, found in the tower.

use towermodes::{Change, TowerDescription};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::measured::MeasuredFile;

impl MeasuredFile {
    /// The changes that the unknowns name, in their order.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at each name that is not an input value of the tower.
    pub fn changes(&self, tower: &TowerDescription) -> Result<Vec<Change>, ReadError> {
        let mut mistakes = Vec::new();
        let mut changes = Vec::new();
        for unknown in &self.unknowns {
            match Change::parse(&unknown.name.value, tower) {
                Ok(change) => changes.push(change),
                Err(error) => {
                    let kind = DiagnosticKind::Parameter(error);
                    mistakes.push(Diagnostic::new(unknown.name.span.clone(), kind));
                }
            }
        }
        match mistakes.is_empty() {
            true => Ok(changes),
            false => Err(ReadError::mistakes(&self.source, mistakes)),
        }
    }
}
