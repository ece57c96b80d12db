//! How the shapes of a deck of ElastoDyn are judged, as JSON.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes::Plane;
use towermodes_analysis::Verdict;
use towermodes_analysis::elastodyn::ValidatedShape;

use super::{ResultError, write_pretty};

/// The result of `towermodes elastodyn validate --format json`. Keys are stable: new ones may be
/// added, none is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes elastodyn validate")]
pub(super) struct JudgementsJson {
    /// The worst verdict: `pass`, `warn` or `fail`.
    verdict: &'static str,
    /// First and second fore-aft, first and second side-side shape.
    shapes: Vec<JudgementJson>,
}

/// A shape of the tower file beside the tower's own mode.
#[derive(Serialize, JsonSchema)]
struct JudgementJson {
    /// `fore-aft` or `side-side`.
    plane: &'static str,
    /// 1 or 2.
    number: usize,
    /// Frequency of the tower's own mode, Hz.
    mode_hz: f64,
    /// What the coefficients add up to.
    sum: f64,
    /// Root of the mean square of the difference to the mode, as a share of its largest deflection,
    /// the shape multiplied by what makes it least.
    rms: f64,
    /// The same of the best polynomial.
    best_rms: f64,
    /// The same of what both shapes of the plane together cannot follow.
    rms_of_both: f64,
    /// The ratio of `rms` and `best_rms`.
    rms_ratio: f64,
    /// Modal assurance criterion.
    mac: f64,
    /// Frequency that ElastoDyn makes of the shape, of the tower alone, Hz.
    implied_hz: f64,
    /// The same of the best polynomial, Hz.
    best_implied_hz: f64,
    /// `pass`, `warn` or `fail`.
    verdict: &'static str,
}

/// Writes how the shapes of a deck are judged as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_judgement_json(
    judgements: &[ValidatedShape; 4],
    writer: impl Write,
) -> Result<(), ResultError> {
    let worst = judgements.iter().map(|judgement| judgement.verdict).max();
    let result = JudgementsJson {
        verdict: worst.unwrap_or(Verdict::Fail).name(),
        shapes: judgements.iter().map(judgement_json).collect(),
    };
    write_pretty(&result, writer)
}

fn judgement_json(judgement: &ValidatedShape) -> JudgementJson {
    JudgementJson {
        plane: match judgement.plane {
            Plane::ForeAft => "fore-aft",
            Plane::SideSide => "side-side",
        },
        number: judgement.number,
        mode_hz: judgement.mode_hz,
        sum: judgement.sum,
        rms: judgement.rms,
        best_rms: judgement.best_rms,
        rms_of_both: judgement.rms_of_both,
        rms_ratio: judgement.rms_ratio(),
        mac: judgement.mac,
        implied_hz: judgement.implied_hz,
        best_implied_hz: judgement.best_implied_hz,
        verdict: judgement.verdict.name(),
    }
}
