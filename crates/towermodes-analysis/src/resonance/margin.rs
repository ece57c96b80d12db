//! The distances of the multiples of the rotor speed from natural frequencies in operation.

use super::campbell::{FrequencyLine, Margin, is_strong};
use crate::verdict::Verdict;
use towermodes::tower::Rotor;

/// The distance of a line from a multiple of the rotor speed, at the operating speed where both are
/// closest; none for a frequency of 0, for a mode that is not assessed, and for a line without
/// operating speeds. A line that is lost within the operating speeds does not pass, because its
/// rest is unknown; a line that begins or ends there without being lost is outside the frequency
/// range of the diagram at the other speeds.
///
/// Between neighbouring points of a line f² is linear in Ω²: constant for a tower mode, Southwell's
/// rule for a blade mode. Therefore n Ω/f is monotonic between two points, and it is closest to 1
/// at one of them or at a crossing, which is computed exactly.
pub(super) fn margin(
    (number, line): (usize, &FrequencyLine),
    multiple: usize,
    rotor: &Rotor,
    least: f64,
) -> Option<Margin> {
    if !line.class().is_judged() {
        return None;
    }
    let [first_rpm, last_rpm] = [line.points.first()?[0], line.points.last()?[0]];
    let range_rpm = [
        rotor.lowest_rpm.max(first_rpm),
        rotor.highest_rpm.min(last_rpm),
    ];
    if range_rpm[0] > range_rpm[1] {
        return None;
    }
    let is_partly_known = line.lost.is_some() && last_rpm < rotor.highest_rpm;
    let nearest = nearest(&line.points, multiple, range_rpm)?;
    let distance = cautious(line, multiple, range_rpm, nearest.distance);
    let is_strong = !line.is_of_blade() && is_strong(multiple, rotor);
    Some(Margin {
        line: number,
        multiple,
        nearest_rpm: nearest.rpm,
        excitation_hz: nearest.excitation_hz,
        natural_hz: nearest.natural_hz,
        distance: nearest.distance,
        verdict: match verdict(nearest.distance.abs(), distance, least, is_strong) {
            Verdict::Pass if is_partly_known => Verdict::Warn,
            verdict => verdict,
        },
    })
}

/// The distance of a multiple of the rotor speed from a natural frequency of a tower, which does
/// not depend on the rotor speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TowerMargin {
    /// n Ω/f − 1 at the operating speed where its absolute value is smallest; 0 if they cross.
    pub distance: f64,
    /// Whether |n Ω/f − 1| is below the required distance if the frequency is shifted by its error
    /// towards the excitation.
    pub is_violated: bool,
    /// The verdict, as in a [`Campbell`](super::Campbell) diagram.
    pub verdict: Verdict,
}

/// The distance of a multiple of the rotor speed from a natural frequency of a tower, and its
/// verdict by the rules of [`campbell`](super::campbell()), for many towers: without a diagram and
/// without memory allocation. `least` is the required distance, for example
/// [`DEFAULT_MARGIN`](super::DEFAULT_MARGIN); `error_hz` is the error of the frequency.
///
/// None for a frequency that is 0 or not a number.
///
/// # Example
/// ```
/// use towermodes::Rotor;
/// use towermodes_analysis::Verdict;
/// use towermodes_analysis::resonance::tower_margin;
///
/// let rotor = Rotor { blades: 3, lowest_rpm: 6.9, highest_rpm: 12.1 };
/// let margin = tower_margin(0.21, 1e-6, 1, &rotor, 0.05).expect("a frequency");
/// assert!((margin.distance - (12.1 / 60.0 / 0.21 - 1.0)).abs() < 1e-15);
/// assert!(margin.is_violated && margin.verdict == Verdict::Fail);
/// ```
#[must_use]
pub fn tower_margin(
    frequency_hz: f64,
    error_hz: f64,
    multiple: usize,
    rotor: &Rotor,
    least: f64,
) -> Option<TowerMargin> {
    let distance = nearest_distance(frequency_hz, multiple, rotor)?;
    let moved_hz = frequency_hz + error_hz.copysign(distance);
    let cautious = match nearest_distance(moved_hz, multiple, rotor) {
        Some(moved) if distance != 0.0 && moved.signum() == distance.signum() => moved.abs(),
        // They may meet.
        _ => 0.0,
    };
    Some(TowerMargin {
        distance,
        is_violated: cautious < least,
        verdict: verdict(distance.abs(), cautious, least, is_strong(multiple, rotor)),
    })
}

/// The n Ω/f − 1 with the smallest absolute value over all operating speeds; of two equal ones that
/// at the lower speed.
fn nearest_distance(frequency_hz: f64, multiple: usize, rotor: &Rotor) -> Option<f64> {
    if frequency_hz.is_nan() || frequency_hz <= 0.0 {
        return None;
    }
    let distance = |rpm: f64| Pair::new(multiple, rpm, frequency_hz).distance;
    let [low, high] = [rotor.lowest_rpm, rotor.highest_rpm].map(distance);
    Some(match (low * high < 0.0, low.abs() <= high.abs()) {
        (true, _) => 0.0,
        (false, true) => low,
        (false, false) => high,
    })
}

/// The verdict on a distance. 1P and the blade passing frequency excite a tower most; higher
/// multiples, and the excitation of blade modes, are weaker and do not fail.
///
/// A pair that would pass without the error of its frequency does not fail, because the frequency
/// is not known accurately enough.
fn verdict(distance: f64, cautious: f64, least: f64, is_strong: bool) -> Verdict {
    match is_strong {
        true if cautious < least && distance < 2.0 * least => Verdict::Fail,
        true if cautious < 2.0 * least => Verdict::Warn,
        false if cautious < least => Verdict::Warn,
        _ => Verdict::Pass,
    }
}

/// |n Ω/f − 1| with the frequency shifted by its error towards the excitation.
fn cautious(line: &FrequencyLine, multiple: usize, range_rpm: [f64; 2], distance: f64) -> f64 {
    let towards_hz = line.error_hz.copysign(distance);
    let moved = line.points.iter().map(|[rpm, hz]| [*rpm, hz + towards_hz]);
    let moved: Vec<[f64; 2]> = moved.collect();
    if distance == 0.0 || moved.iter().any(|[_, hz]| !hz.is_finite()) {
        return 0.0;
    }
    match nearest(&moved, multiple, range_rpm) {
        // They may meet.
        None => 0.0,
        Some(nearest) if nearest.distance.signum() != distance.signum() => 0.0,
        Some(nearest) => nearest.distance.abs(),
    }
}

/// A point of a line with the distance of the excitation at its speed.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Pair {
    rpm: f64,
    excitation_hz: f64,
    natural_hz: f64,
    /// n Ω/f − 1.
    distance: f64,
}

impl Pair {
    fn new(multiple: usize, rpm: f64, natural_hz: f64) -> Self {
        let excitation_hz = multiple as f64 * rpm / 60.0;
        Self {
            rpm,
            excitation_hz,
            natural_hz,
            distance: excitation_hz / natural_hz - 1.0,
        }
    }

    /// The intersection of excitation and line between two points on different sides of it: between
    /// them (n Ω)² − f² is linear in Ω².
    fn meeting(a: &Self, b: &Self) -> Self {
        let above = |pair: &Self| pair.excitation_hz.powi(2) - pair.natural_hz.powi(2);
        let (above_a, above_b) = (above(a), above(b));
        let share = above_a / (above_a - above_b);
        let natural_hz = between([a.natural_hz, b.natural_hz], share);
        Self {
            rpm: between([a.rpm, b.rpm], share),
            excitation_hz: natural_hz,
            natural_hz,
            distance: 0.0,
        }
    }
}

/// The closest point of a line to a multiple within a range of speeds; of equal ones the lowest
/// speed.
fn nearest(points: &[[f64; 2]], multiple: usize, range_rpm: [f64; 2]) -> Option<Pair> {
    if points.iter().any(|[_, hz]| hz.is_nan() || *hz <= 0.0) {
        return None;
    }
    let [lowest, highest] = range_rpm;
    let inside = points.iter().map(|[rpm, _]| *rpm);
    let inside = inside.filter(|rpm| lowest < *rpm && *rpm < highest);
    let speeds = [lowest].into_iter().chain(inside).chain([highest]);
    let pair = |rpm: f64| Pair::new(multiple, rpm, frequency_hz(points, rpm));
    let pairs: Vec<Pair> = speeds.map(pair).collect();
    let meets = |pair: &&[Pair]| pair[0].distance * pair[1].distance < 0.0;
    let meetings = pairs.windows(2).filter(meets);
    let meetings = meetings.map(|pair| Pair::meeting(&pair[0], &pair[1]));
    let all = meetings.chain(pairs.iter().copied());
    all.min_by(|a, b| {
        let sizes = a.distance.abs().total_cmp(&b.distance.abs());
        sizes.then(a.rpm.total_cmp(&b.rpm))
    })
}

/// The frequency of a line at a speed: exact at its points, f² linear in Ω² between them.
fn frequency_hz(points: &[[f64; 2]], rpm: f64) -> f64 {
    let above = points.partition_point(|point| point[0] < rpm);
    let Some(&[above_rpm, above_hz]) = points.get(above.min(points.len() - 1)) else {
        return f64::NAN;
    };
    if above == 0 || above == points.len() || above_rpm == rpm {
        return above_hz;
    }
    let [below_rpm, below_hz] = points[above - 1];
    let share =
        (rpm * rpm - below_rpm * below_rpm) / (above_rpm * above_rpm - below_rpm * below_rpm);
    between([below_hz, above_hz], share)
}

/// Interpolation of a number so that its square is linear between the squares of two numbers.
fn between([a, b]: [f64; 2], share: f64) -> f64 {
    if a == b {
        return a;
    }
    (a * a + share * (b * b - a * a)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::super::campbell::{Excited, LineEnd};
    use super::*;
    use towermodes::BladeFamily;

    /// f² = 1 + Ω²/100 at 0, 10 and 20 rpm.
    const LINE: [[f64; 2]; 3] = [
        [0.0, 1.0],
        [10.0, std::f64::consts::SQRT_2],
        [20.0, 2.236_067_977_499_79],
    ];

    /// The line up to 20 rpm, lost at 25 rpm, against 1P in a range of speeds.
    fn margin_of_lost(lowest_rpm: f64, highest_rpm: f64) -> Option<Margin> {
        let (family, order) = (BladeFamily::Flap, 1);
        let line = FrequencyLine {
            of: Excited::Blade { family, order },
            label: "blade 1st flap".to_owned(),
            points: LINE.to_vec(),
            error_hz: 0.0,
            lost: Some(LineEnd {
                rotor_speed_rpm: 25.0,
                mac: 0.1,
            }),
        };
        let rotor = Rotor {
            blades: 3,
            lowest_rpm,
            highest_rpm,
        };
        margin((0, &line), 1, &rotor, 0.05)
    }

    /// 20 rpm are 1/3 Hz, far below √5 Hz.
    #[test]
    fn what_is_lost_in_operation_does_not_pass() {
        let known = margin_of_lost(10.0, 20.0).expect("a margin");
        assert_eq!((known.nearest_rpm, known.verdict), (20.0, Verdict::Pass));
        let partly = margin_of_lost(10.0, 24.0).expect("a margin");
        assert_eq!((partly.nearest_rpm, partly.verdict), (20.0, Verdict::Warn));
        assert!((partly.distance - (1.0 / 45.0_f64.sqrt() - 1.0)).abs() < 1e-15);
        assert_eq!(margin_of_lost(21.0, 24.0), None);
    }

    #[test]
    fn frequencies_between_points_follow_southwell() {
        assert!((frequency_hz(&LINE, 5.0) - 1.25_f64.sqrt()).abs() < 1e-15);
        assert!((frequency_hz(&LINE, 15.0) - 3.25_f64.sqrt()).abs() < 1e-15);
        assert_eq!(frequency_hz(&LINE, 10.0), LINE[1][1]);
        assert_eq!(frequency_hz(&LINE, 30.0), LINE[2][1]);
    }

    /// n Ω/60 = f where Ω² (n²/3600 − 1/100) = 1: for n = 12 Ω² = 1/0.03.
    #[test]
    fn meetings_are_exact() {
        let met = nearest(&LINE, 12, [2.0, 8.0]).expect("a pair");
        assert!((met.rpm - (1.0_f64 / 0.03).sqrt()).abs() < 1e-14);
        assert!((met.natural_hz - met.rpm / 5.0).abs() < 1e-15);
        assert_eq!(met.distance, 0.0);
        // For n = 6 both rise alike and never meet: Ω/10 over sqrt(1 + Ω²/100) is nearest at the
        // highest speed.
        let apart = nearest(&LINE, 6, [2.0, 20.0]).expect("a pair");
        assert_eq!(apart.rpm, 20.0);
        assert!((apart.distance - (2.0 / 5.0_f64.sqrt() - 1.0)).abs() < 1e-15);
    }

    #[test]
    fn a_single_speed_is_a_range() {
        let at = nearest(&LINE, 12, [5.0, 5.0]).expect("a pair");
        assert_eq!(at.rpm, 5.0);
        assert!((at.distance - (1.0 / 1.25_f64.sqrt() - 1.0)).abs() < 1e-15);
    }
}
