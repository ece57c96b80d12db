//! Cans on top of each other: the stations at their ends.

use std::ops::Range;

use towermodes::Station;

use super::Placed;
use crate::csv_table::MAX_MISTAKES;
use crate::diagnostic::{Diagnostic, DiagnosticKind, line_and_column};
use crate::number::Rounded;

/// Ends of neighbouring cans whose distance is smaller than this, m, are at one height, because
/// lengths are converted.
const SAME_M: f64 = 1e-6;

/// A piece of tower with linear taper and one wall thickness.
#[derive(Debug, Clone)]
pub(super) struct Can {
    /// Heights of bottom and top.
    pub(super) ends_m: [f64; 2],
    /// Outer diameters at bottom and top.
    pub(super) diameters_m: [f64; 2],
    pub(super) wall_m: f64,
    pub(super) material: usize,
    /// The places of bottom, top, both diameters and the wall.
    pub(super) spans: [Range<usize>; 5],
}

impl Can {
    /// Refuses a can without height.
    pub(super) fn check(&self) -> Result<(), Diagnostic> {
        let [bottom_m, top_m] = self.ends_m;
        if top_m > bottom_m {
            return Ok(());
        }
        let rule = format!("above its bottom, {} m", Rounded(bottom_m));
        let kind = DiagnosticKind::out_of_range_in("the top of the can", top_m, "m", rule);
        Err(Diagnostic::new(self.spans[1].clone(), kind))
    }

    /// The station at its bottom (0) or top (1).
    fn station(&self, end: usize) -> Placed {
        Placed {
            station: Station {
                height_m: self.ends_m[end],
                outer_diameter_m: self.diameters_m[end],
                wall_thickness_m: self.wall_m,
                material: self.material,
            },
            spans: [&self.spans[end], &self.spans[2 + end], &self.spans[4]].map(Clone::clone),
        }
    }
}

/// The stations at the ends of all cans from the base to the top; two at one height if diameter,
/// wall or material has a step. Cans that are listed from the top down are reversed; a gap or an
/// overlap is a mistake.
pub(super) fn stations(
    mut cans: Vec<Can>,
    text: &str,
    mistakes: &mut Vec<Diagnostic>,
) -> Vec<Placed> {
    // A row with a mistake of its own would be reported again as a gap.
    let is_complete = mistakes.is_empty();
    if let [first, .., last] = &cans[..]
        && first.ends_m[0] > last.ends_m[0]
    {
        cans.reverse();
    }
    let gaps = join(&mut cans, text);
    if is_complete {
        mistakes.extend(gaps.into_iter().take(MAX_MISTAKES));
    }
    let mut stations: Vec<Placed> = Vec::with_capacity(2 * cans.len());
    for can in &cans {
        let bottom = can.station(0);
        let last = stations.last().map(|last| &last.station);
        if last != Some(&bottom.station) {
            stations.push(bottom);
        }
        stations.push(can.station(1));
    }
    stations
}

/// Sets the bottom of each can exactly to the top of the one below; returns the mistakes where they
/// differ.
fn join(cans: &mut [Can], text: &str) -> Vec<Diagnostic> {
    let mut mistakes = Vec::new();
    for above in 1..cans.len() {
        let (below, rest) = cans.split_at_mut(above);
        let (below, can) = (&below[above - 1], &mut rest[0]);
        match joint(below, can, text) {
            Ok(()) => can.ends_m[0] = below.ends_m[1],
            Err(mistake) => mistakes.push(mistake),
        }
    }
    mistakes
}

/// Checks that a can begins where the one below it ends.
fn joint(below: &Can, can: &Can, text: &str) -> Result<(), Diagnostic> {
    let (top_m, bottom_m) = (below.ends_m[1], can.ends_m[0]);
    let gap_m = bottom_m - top_m;
    if gap_m.abs() <= SAME_M {
        return Ok(());
    }
    let (line, _) = line_and_column(text, below.spans[1].start);
    let side = if gap_m > 0.0 { "above" } else { "below" };
    let kind = DiagnosticKind::Contradiction(format!(
        "the bottom of this can, {} m, is {} m {side} the top of the can below it, {} m (line {line})",
        Rounded(bottom_m),
        Rounded(gap_m.abs()),
        Rounded(top_m)
    ));
    let hint = match gap_m > 0.0 {
        true => "cans must be adjacent: is a row missing?",
        false => "cans must be adjacent without overlap, from the base up or from the top down",
    };
    Err(Diagnostic::new(can.spans[0].clone(), kind).with_hint(hint))
}
