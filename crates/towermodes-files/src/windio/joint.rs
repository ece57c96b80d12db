//! Where the tower stands on the monopile.

use super::part::{Part, SAME_M};
use super::reading::Reading;
use crate::diagnostic::Diagnostic;
use crate::number::Rounded;

/// A gap between monopile and tower up to this, m, is closed.
const SMALL_GAP_M: f64 = 0.1;

/// Makes the top of the monopile the base of the tower.
pub(super) fn meet(parts: &mut [Part], reading: &mut Reading<'_>) -> Result<(), Diagnostic> {
    let [monopile, tower] = parts else {
        return Ok(());
    };
    let (top_m, base_m) = (monopile.top_m(), tower.base_m());
    let span = tower.z.spans()[0].clone();
    let gap_m = base_m - top_m;
    if gap_m < -SAME_M {
        let message = format!(
            "the tower begins at z = {base_m} m, {} m below the top of the monopile at z = {top_m} m",
            Rounded(-gap_m)
        );
        return Err(Diagnostic::new(span, message)
            .with_hint("they must meet; or read the tower alone (--part tower) or the monopile alone (--part monopile)"));
    }
    if gap_m > SMALL_GAP_M {
        let message = format!(
            "the tower begins at z = {base_m} m, {} m above the top of the monopile at z = {top_m} m",
            Rounded(gap_m)
        );
        return Err(Diagnostic::new(span, message)
            .with_hint("they must meet; or read the tower alone (--part tower) or the monopile alone (--part monopile)"));
    }
    if gap_m > SAME_M {
        let message = format!(
            "the gap of {} m between monopile (up to z = {} m) and tower (from z = {} m) is closed: the monopile is that much longer",
            Rounded(gap_m),
            Rounded(top_m),
            Rounded(base_m)
        );
        reading.note_at(span.start, message);
    }
    if let Some(last) = monopile.stops.last_mut() {
        last.height_m = base_m;
    }
    Ok(())
}
