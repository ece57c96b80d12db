//! The names in a sweep study, found in the tower that it varies.

use std::ops::Range;

use towermodes::{Change, ParameterError, TowerDescription};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::sampling::{Distribution, Sampling, SamplingError};
use crate::study::{SweepRows, SweepStudy};

impl SweepStudy {
    /// The changes that `[sweep.vary]` names, found in the base; none if a table contains the
    /// names.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at each name that is not an input value of the base, and at a name
    /// whose input value another one changes too.
    pub fn changes(&self, base: &TowerDescription) -> Result<Vec<Change>, ReadError> {
        let SweepRows::Sampled {
            sampling, spans, ..
        } = &self.rows
        else {
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

    /// A mistake that is found only when values are drawn, at its place in the study: correlations
    /// that contradict each other, limits that exclude all values.
    pub fn undrawn(&self, error: SamplingError) -> ReadError {
        let span = match &self.rows {
            SweepRows::Sampled {
                sampling,
                spans,
                correlation_spans,
            } => match &error {
                SamplingError::Correlation { index, .. } => correlation_spans.get(*index),
                SamplingError::Excluded { low, high } => {
                    truncated(sampling, [*low, *high]).and_then(|index| spans.get(index))
                }
                _ => None,
            },
            SweepRows::Table(_) => None,
        };
        let span = span.cloned().unwrap_or(0..0);
        let mistake = Diagnostic::new(span, DiagnosticKind::Sampling(error));
        ReadError::mistake(&self.source, mistake)
    }
}

/// The index of the first distribution with these limits.
fn truncated(sampling: &Sampling, limits: [f64; 2]) -> Option<usize> {
    let mut vary = sampling.vary.iter();
    vary.position(|varied| match varied.distribution {
        Distribution::Normal { truncated, .. } | Distribution::LogNormal { truncated, .. } => {
            truncated == Some(limits)
        }
        _ => false,
    })
}

fn mistake(span: &Range<usize>, error: ParameterError) -> Diagnostic {
    Diagnostic::new(span.clone(), DiagnosticKind::Parameter(error))
}
