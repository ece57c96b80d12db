//! The ranges of the axes of a Campbell diagram: a main field with the first bending modes and the
//! blade passing frequency, and an upper field for higher modes.

use towermodes_analysis::resonance::{BEYOND_OPERATION, Campbell, StiffnessClass};

use crate::svg::extent;

/// The number of tower modes that are shown even if they are above the excitations, …
const TOWER_MODES: usize = 5;
/// … up to this multiple of the highest excitation in operation.
const WORTH: f64 = 2.0;
/// Pairs that fail or warn are shown up to this multiple of the highest excitation.
const FAR: f64 = 6.0;
/// The diagram extends to this multiple of its highest line.
const ABOVE: f64 = 1.06;
/// The main field extends to this multiple of the first bending modes …
const ABOVE_FIRST: f64 = 1.3;
/// … and at this multiple of the end of the ray of the blade passing frequency.
const ABOVE_RAY: f64 = 1.03;
/// The end of the main field is raised by at most this factor, so that it does not cut a curve, …
const MOVED: f64 = 2.2;
/// … and keeps this relative distance from the curves.
const BESIDE: f64 = 0.015;
/// Higher modes get the upper field if they would increase the height of the diagram by more than
/// this factor.
const SQUEEZED: f64 = 1.35;

/// The speed at the right end, rpm.
pub(super) fn last_rpm(campbell: &Campbell) -> f64 {
    let ends = campbell.lines.iter().filter_map(|line| line.points.last());
    let last = ends.map(|[rpm, _]| *rpm).fold(0.0, f64::max);
    let last = last.max(campbell.rotor.highest_rpm);
    if last > campbell.rotor.highest_rpm && last.is_finite() {
        return last;
    }
    let highest = BEYOND_OPERATION * campbell.rotor.highest_rpm;
    if highest.is_finite() && highest > 0.0 {
        highest
    } else {
        1.0
    }
}

/// The upper ends of the fields, Hz: one field, or the main field and the upper one.
pub(super) fn ends_hz(campbell: &Campbell, multiples: &[usize], last_rpm: f64) -> Vec<f64> {
    let highest_hz = highest_hz(campbell, multiples, last_rpm);
    let decisive_hz = beside_curves(campbell, decisive_hz(campbell, last_rpm));
    let is_drawn = |hz: f64| decisive_hz < hz && hz <= highest_hz;
    let mut lines = campbell.lines.iter();
    let is_higher = lines.any(|line| line.points.iter().any(|[_, hz]| is_drawn(*hz)));
    match decisive_hz {
        hz if !(hz.is_finite() && hz > 0.0) => vec![highest_hz],
        hz if !is_higher => vec![hz],
        hz if highest_hz <= SQUEEZED * hz => vec![highest_hz],
        hz => vec![hz, highest_hz],
    }
}

/// The next higher frequency that no curve crosses or touches, Hz; the given one if the next is far
/// above.
fn beside_curves(campbell: &Campbell, from_hz: f64) -> f64 {
    let ranges = campbell.lines.iter().filter_map(|line| {
        let hz = line.points.iter().map(|[_, hz]| *hz);
        let [low, high] = extent(hz)?;
        Some([low * (1.0 - BESIDE), high * (1.0 + BESIDE)])
    });
    beside(ranges.collect(), from_hz)
}

/// The next higher value outside all ranges; the given one if the next is far above.
fn beside(mut ranges: Vec<[f64; 2]>, from: f64) -> f64 {
    ranges.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let above = |end: f64, [low, high]: [f64; 2]| match low < end && end < high {
        true => high,
        false => end,
    };
    match ranges.into_iter().fold(from, above) {
        end if end <= MOVED * from => end,
        _ => from,
    }
}

/// The upper end of the main field: above the first bending modes and the ray of the blade passing
/// frequency at the right end; if all these modes are below 1P, above the ray of 1P.
fn decisive_hz(campbell: &Campbell, last_rpm: f64) -> f64 {
    let mut classes = campbell.classes.iter().map(|(_, class)| *class);
    let is_soft_soft =
        !campbell.classes.is_empty() && classes.all(|class| class == StiffnessClass::SoftSoft);
    let multiple = if is_soft_soft {
        1
    } else {
        campbell.rotor.blades
    };
    let ray_hz = multiple as f64 * last_rpm / 60.0;
    (ABOVE_FIRST * first_hz(campbell)).max(ABOVE_RAY * ray_hz)
}

/// The highest of the first bending modes, Hz; if there are none, the lowest tower mode above 0 Hz.
fn first_hz(campbell: &Campbell) -> f64 {
    let lines = campbell.first_bending.iter();
    let lines = lines.filter_map(|line| campbell.lines.get(*line));
    let first = lines.filter_map(|line| line.points.first().map(|[_, hz]| *hz));
    match first.fold(0.0, f64::max) {
        0.0 => tower_hz(campbell).find(|hz| *hz > 0.0).unwrap_or(0.0),
        hz => hz,
    }
}

/// The upper end of the diagram, Hz: above every line that the highest excitation crosses, the
/// lowest tower modes, and every pair with FAIL or WARN.
fn highest_hz(campbell: &Campbell, multiples: &[usize], last_rpm: f64) -> f64 {
    let highest = multiples.iter().max().map_or(0.0, |n| *n as f64);
    let excitation_hz = highest * campbell.rotor.highest_rpm / 60.0;
    let end_hz = highest * last_rpm / 60.0;
    let highest_hz = [
        excitation_hz,
        worthy_hz(campbell, excitation_hz),
        passed_hz(campbell, end_hz),
        judged_hz(campbell, multiples, end_hz),
    ];
    let highest_hz = ABOVE * highest_hz.into_iter().fold(0.0, f64::max);
    if highest_hz.is_finite() && highest_hz > 0.0 {
        highest_hz
    } else {
        ABOVE
    }
}

/// The frequencies of the tower's modes, Hz.
fn tower_hz(campbell: &Campbell) -> impl Iterator<Item = f64> {
    let tower = campbell.lines.iter().filter(|line| !line.is_of_blade());
    tower.filter_map(|line| line.points.first().map(|[_, hz]| *hz))
}

/// The highest tower mode to show: the first mode, and the next few modes not far above the
/// excitations.
fn worthy_hz(campbell: &Campbell, excitation_hz: f64) -> f64 {
    let mut tower_hz = tower_hz(campbell);
    let first_hz = tower_hz.find(|hz| *hz > 0.0).unwrap_or(0.0);
    let worth = |hz: &f64| *hz <= WORTH * excitation_hz;
    let others_hz = tower_hz.take(TOWER_MODES - 1).filter(worth);
    others_hz.fold(first_hz, f64::max)
}

/// The highest line that is below the highest excitation at the right end.
fn passed_hz(campbell: &Campbell, end_hz: f64) -> f64 {
    let ends = campbell.lines.iter().filter_map(|line| line.points.last());
    let below = ends.map(|[_, hz]| *hz).filter(|hz| *hz <= end_hz);
    below.fold(0.0, f64::max)
}

/// The highest frequency with a FAIL or WARN.
fn judged_hz(campbell: &Campbell, multiples: &[usize], end_hz: f64) -> f64 {
    let judged = campbell.margins.iter().filter(|margin| {
        margin.verdict.is_objection()
            && margin.natural_hz <= FAR * end_hz
            && multiples.contains(&margin.multiple)
    });
    judged.map(|margin| margin.natural_hz).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::beside;

    /// From 1 on, the ranges 0.9 to 1.2 and 1.1 to 1.5 are skipped; 2.5 is more than 2.2 times as
    /// high.
    #[test]
    fn the_break_between_fields_cuts_no_curve() {
        let ranges = vec![[1.1, 1.5], [0.2, 0.3], [0.9, 1.2], [1.6, 2.0]];
        assert_eq!(beside(ranges, 1.0), 1.5);
        assert_eq!(beside(vec![[1.1, 1.5]], 1.0), 1.0);
        assert_eq!(beside(vec![[0.9, 2.5]], 1.0), 1.0);
        assert_eq!(beside(vec![[0.9, 2.1], [1.0, 1.1]], 1.0), 2.1);
    }
}
