//! How far the axes of a Campbell diagram reach.

use towermodes::Verdict;
use towermodes::rotor::{BEYOND_OPERATION, Campbell};

use super::lines::is_blade;

/// This many modes of the tower are worth more height than the excitations need …
const TOWER_MODES: usize = 5;
/// … as long as they are not higher than so many times the highest excitation in operation.
const WORTH: f64 = 2.0;
/// What is warned of, or fails, is in the diagram up to so many times the highest excitation; beyond, all else would be a strip at its foot.
const FAR: f64 = 6.0;
/// The diagram reaches so much above its highest line.
const ABOVE: f64 = 1.06;

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

/// The frequency at the upper end, Hz: above every line that the highest excitation passes before the right end, the lowest of the tower
/// whatever excites it, and whatever is warned of or fails.
pub(super) fn highest_hz(campbell: &Campbell, multiples: &[usize], last_rpm: f64) -> f64 {
    let highest = multiples.iter().max().map_or(0.0, |n| *n as f64);
    let excitation_hz = highest * campbell.rotor.highest_rpm / 60.0;
    let end_hz = highest * last_rpm / 60.0;
    let highest_hz = [
        excitation_hz,
        tower_hz(campbell, excitation_hz),
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

/// The highest mode of the tower that is worth showing: the first, and the next few that are not far above the excitations.
fn tower_hz(campbell: &Campbell, excitation_hz: f64) -> f64 {
    let tower = campbell.lines.iter().filter(|line| !is_blade(line));
    let mut tower_hz = tower.filter_map(|line| line.points.first().map(|[_, hz]| *hz));
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

/// The highest frequency that is warned of or fails.
fn judged_hz(campbell: &Campbell, multiples: &[usize], end_hz: f64) -> f64 {
    let judged = campbell.margins.iter().filter(|margin| {
        margin.verdict != Verdict::Pass
            && margin.natural_hz <= FAR * end_hz
            && multiples.contains(&margin.multiple)
    });
    judged.map(|margin| margin.natural_hz).fold(0.0, f64::max)
}
