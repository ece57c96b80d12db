//! The names of a study, found in the tower that it varies.

use std::ops::Range;

use towermodes::{Change, ParameterError, TowerDescription};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::study::{SweepRows, SweepStudy};

impl SweepStudy {
    /// The changes that `[sweep.vary]` names, found in the base; none if a table has the names.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at each name that is no number of the base, and at a name whose
    /// number another one sets too.
    pub fn changes(&self, base: &TowerDescription) -> Result<Vec<Change>, ReadError> {
        let SweepRows::Sampled { sampling, spans } = &self.rows else {
            return Ok(Vec::new());
        };
        let names = || sampling.vary.iter().map(|varied| varied.name.as_str());
        let one_by_one = names().zip(spans).filter_map(|(name, span)| {
            let error = Change::parse(name, base).err()?;
            Some(mistake(span, error))
        });
        let mistakes: Vec<Diagnostic> = one_by_one.collect();
        if !mistakes.is_empty() {
            return Err(ReadError::mistakes(&self.source, mistakes));
        }
        Change::parse_all(names(), base).map_err(|error| {
            let second = match &error {
                ParameterError::Repeated { second, .. } => second.as_str(),
                _ => "",
            };
            let index = names().position(|name| name.trim() == second);
            let span = index.and_then(|index| spans.get(index)).unwrap_or(&(0..0));
            ReadError::mistake(&self.source, mistake(span, error))
        })
    }
}

fn mistake(span: &Range<usize>, error: ParameterError) -> Diagnostic {
    Diagnostic::new(span.clone(), DiagnosticKind::Parameter(error))
}
