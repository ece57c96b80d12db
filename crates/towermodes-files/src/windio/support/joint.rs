//! The joint of monopile and tower.

use std::ops::Range;

use super::super::text::reading::Reading;
use super::part::{Part, SAME_M};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::number::Rounded;

/// A gap between monopile and tower up to this height, m, is closed.
const SMALL_GAP_M: f64 = 0.1;

/// Makes the top of the monopile the base of the tower.
pub(super) fn join_monopile(
    parts: &mut [Part],
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    let [monopile, tower] = parts else {
        return Ok(());
    };
    let (top_m, base_m) = (monopile.top_m(), tower.base_m());
    let span = tower.z.spans()[0].clone();
    let gap_m = base_m - top_m;
    if !(-SAME_M..=SMALL_GAP_M).contains(&gap_m) {
        return Err(apart(top_m, base_m, span));
    }
    if gap_m > SAME_M {
        let message = format!(
            "the gap of {} m between monopile (up to z = {} m) and tower (from z = {} m) is closed by extending the monopile",
            Rounded(gap_m),
            Rounded(top_m),
            Rounded(base_m)
        );
        reading.note_at(span.start, Note::approximation(message));
    }
    if let Some(last) = monopile.stops.last_mut() {
        last.height_m = base_m;
    }
    Ok(())
}

/// The mistake of a tower that does not begin at the top of the monopile.
fn apart(top_m: f64, base_m: f64, span: Range<usize>) -> Diagnostic {
    let gap_m = base_m - top_m;
    let side = if gap_m > 0.0 { "above" } else { "below" };
    let kind = DiagnosticKind::Contradiction(format!(
        "the tower begins at z = {base_m} m, {} m {side} the top of the monopile at z = {top_m} m",
        Rounded(gap_m.abs())
    ));
    let hint = "they must be adjacent: add the distance to one reference axis (WISDEM moves the monopile to the tower by itself); or read only one of them (--part tower or --part monopile)";
    Diagnostic::new(span, kind).with_hint(hint)
}
