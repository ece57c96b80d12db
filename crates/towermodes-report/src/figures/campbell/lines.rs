//! The lines of a Campbell diagram that are drawn, and their labels.

use towermodes_analysis::resonance::{Campbell, Excited, FrequencyLine};

use super::extent::{ends_hz, last_rpm};
use super::kind::Kind;
use crate::number::four_digits;

/// The largest number of excitations, because more would look like a grey area.
const EXCITATIONS: usize = 100;
/// Tower lines closer than this relative distance look like one line and have one label.
const ONE_LINE: f64 = 1e-3;
/// Frequencies closer than this relative distance are shown as one number.
const ONE_NUMBER: f64 = 1e-4;

/// The drawn part of a diagram.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shown {
    /// The speed at the right end, rpm.
    pub(super) last_rpm: f64,
    /// The frequencies at which the fields end, Hz, from the lowest: one or two.
    pub(super) ends_hz: Vec<f64>,
    /// The multiples; if there are very many, the lowest.
    pub(super) multiples: Vec<usize>,
    /// Number of multiples that are not drawn.
    pub(super) more_multiples: usize,
    /// Lines of modes; tower lines with the same frequency are one group.
    pub(super) groups: Vec<Group>,
    /// The lines above the upper end.
    pub(super) above: Vec<usize>,
    /// Number of lines that are not drawn because their frequency is 0 or NaN.
    pub(super) unresisted: usize,
    /// Where curves of a turbine change their names: rotor speed (rpm) and frequency (Hz).
    pub(super) changes: Vec<[f64; 2]>,
}

impl Shown {
    /// The frequency at the upper end of all fields, Hz.
    pub(super) fn highest_hz(&self) -> f64 {
        self.ends_hz.last().copied().unwrap_or(1.0)
    }

    /// The field of a frequency, counted from the lowest field; the last field for higher
    /// frequencies.
    pub(super) fn field_of(&self, hz: f64) -> usize {
        let below = self.ends_hz.iter().filter(|end_hz| **end_hz < hz).count();
        below.min(self.ends_hz.len().saturating_sub(1))
    }

    /// Whether a line and a multiple are both drawn.
    pub(super) fn has(&self, line: usize, multiple: usize) -> bool {
        let is_member = self
            .groups
            .iter()
            .any(|group| group.members.contains(&line));
        is_member && self.multiples.contains(&multiple)
    }
}

/// Lines that coincide.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Group {
    /// The indices of its lines in the diagram.
    pub(super) members: Vec<usize>,
    /// Their common label with the frequency.
    pub(super) label: String,
    /// Their kind.
    pub(super) kind: Kind,
    /// Rotor speed (rpm) and frequency (Hz).
    pub(super) points: Vec<[f64; 2]>,
    /// Whether its curve continues in another line.
    pub(super) goes_on: bool,
    /// Whether the continuation has another name.
    pub(super) is_renamed: bool,
}

impl Group {
    /// The lowest of its frequencies, Hz; infinite if it has none.
    fn lowest_hz(&self) -> f64 {
        let hz = self.points.iter().map(|[_, hz]| *hz);
        hz.fold(f64::INFINITY, f64::min)
    }
}

/// Selects the drawn lines and excitations.
pub(super) fn shown(campbell: &Campbell) -> Shown {
    let last_rpm = last_rpm(campbell);
    let multiples: Vec<usize> = campbell
        .multiples
        .iter()
        .copied()
        .take(EXCITATIONS)
        .collect();
    let ends_hz = ends_hz(campbell, &multiples, last_rpm);
    let highest_hz = ends_hz.last().copied().unwrap_or(1.0);
    let (drawn, others): (Vec<Group>, Vec<Group>) = groups(campbell)
        .into_iter()
        .partition(|group| (f64::MIN_POSITIVE..=highest_hz).contains(&group.lowest_hz()));
    let ends = drawn.iter().filter(|group| group.is_renamed);
    let changes = ends.filter_map(|group| group.points.last().copied());
    let changes = changes.filter(|[_, hz]| *hz <= highest_hz).collect();
    let (above, unresisted): (Vec<Group>, Vec<Group>) = others.into_iter().partition(|group| {
        let lowest_hz = group.lowest_hz();
        lowest_hz > highest_hz && !group.points.is_empty()
    });
    let lines = |groups: &[Group]| -> Vec<usize> {
        let members = groups.iter().flat_map(|group| group.members.iter());
        members.copied().collect()
    };
    Shown {
        last_rpm,
        ends_hz,
        more_multiples: campbell.multiples.len() - multiples.len(),
        multiples,
        groups: drawn,
        above: lines(&above),
        unresisted: lines(&unresisted).len(),
        changes,
    }
}

/// The groups of lines; coinciding lines of a tower with a rigid rotor, which are horizontal, form
/// one group.
fn groups(campbell: &Campbell) -> Vec<Group> {
    let first_hz = |line: &FrequencyLine| line.points.first().map_or(f64::NAN, |[_, hz]| *hz);
    let are_one = |a: &FrequencyLine, b: &FrequencyLine| {
        let (a_hz, b_hz) = (first_hz(a), first_hz(b));
        let are_level = [a, b].iter().all(|line| Kind::of(line) == Kind::Tower);
        are_level && (b_hz - a_hz).abs() <= ONE_LINE * a_hz
    };
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (index, line) in campbell.lines.iter().enumerate() {
        match groups.last_mut() {
            // All of a group lie upon its first.
            Some(members) if are_one(&campbell.lines[members[0]], line) => members.push(index),
            _ => groups.push(vec![index]),
        }
    }
    let group = |members: Vec<usize>| {
        let lines: Vec<&FrequencyLine> =
            members.iter().map(|line| &campbell.lines[*line]).collect();
        Group {
            label: label(&lines),
            kind: Kind::of(lines[0]),
            points: lines[0].points.clone(),
            goes_on: next(campbell, lines[0]).is_some(),
            is_renamed: next(campbell, lines[0])
                .is_some_and(|next| !next.is_of_same_mode(lines[0])),
            members,
        }
    };
    groups.into_iter().map(group).collect()
}

/// The line in which the curve of a turbine line continues at higher speeds.
fn next<'a>(campbell: &'a Campbell, line: &FrequencyLine) -> Option<&'a FrequencyLine> {
    let Excited::Turbine { curve, .. } = line.of else {
        return None;
    };
    let mut others = campbell.lines.iter();
    others.find(|other| {
        let is_of_curve = matches!(other.of, Excited::Turbine { curve: own, .. } if own == curve);
        is_of_curve && other.points.first() == line.points.last() && *other != line
    })
}

/// "1st side-side, 1st fore-aft: 0.3187 Hz".
fn label(lines: &[&FrequencyLine]) -> String {
    let names: Vec<String> = lines
        .iter()
        .map(|line| line.label.replace(" bending", "").replace(" whirl", ""))
        .collect();
    let hz = match lines {
        [line] => range_hz(&line.points),
        lines => {
            let hz = lines.iter().filter_map(|line| line.points.first());
            together_hz(&hz.map(|[_, hz]| *hz).collect::<Vec<f64>>())
        }
    };
    format!("{}: {hz}", together(&names))
}

/// "1st fore-aft, 1st side-side", "1st flap and 3 more".
fn together(names: &[String]) -> String {
    match names {
        [first, rest @ ..] if rest.len() > 1 => format!("{first} and {} more", rest.len()),
        names => names.join(", "),
    }
}

/// The frequency of coinciding lines; the first and the last if four digits distinguish them.
fn together_hz(hz: &[f64]) -> String {
    let (low, high) = hz.iter().fold((f64::INFINITY, 0.0_f64), |(low, high), hz| {
        (low.min(*hz), high.max(*hz))
    });
    let is_one = high - low <= ONE_NUMBER * high || four_digits(low) == four_digits(high);
    match hz {
        // Both sides of a rounding limit are no two numbers.
        _ if is_one => format!("{} Hz", four_digits(0.5 * (low + high))),
        [a, b] => format!("{}, {} Hz", four_digits(*a), four_digits(*b)),
        _ => format!("{} to {} Hz", four_digits(low), four_digits(high)),
    }
}

/// The frequency of a line, or its frequencies at the ends.
fn range_hz(points: &[[f64; 2]]) -> String {
    let [Some(first), Some(last)] =
        [points.first(), points.last()].map(|point| point.map(|[_, hz]| four_digits(*hz)))
    else {
        return String::new();
    };
    if first == last {
        format!("{first} Hz")
    } else {
        format!("{first} to {last} Hz")
    }
}

#[cfg(test)]
mod tests {
    use super::{together, together_hz};

    /// Frequencies on both sides of a rounding limit are shown as one number; frequencies that
    /// differ in the fourth digit are shown as two.
    #[test]
    fn frequencies_of_one_line_are_told_apart_or_said_once() {
        assert_eq!(together_hz(&[0.242_48, 0.242_51]), "0.2425 Hz");
        assert_eq!(together_hz(&[0.242_545, 0.242_552]), "0.2425 Hz");
        assert_eq!(together_hz(&[0.242_34, 0.242_51]), "0.2423, 0.2425 Hz");
        assert_eq!(together_hz(&[0.3, 0.3, 0.3]), "0.3000 Hz");
        assert_eq!(together_hz(&[1.0, 1.0004, 1.0009]), "1.000 to 1.001 Hz");
    }

    #[test]
    fn two_names_are_said_and_more_are_counted() {
        let names = ["1st fore-aft", "1st side-side", "1st torsion"].map(str::to_owned);
        assert_eq!(together(&names[..2]), "1st fore-aft, 1st side-side");
        assert_eq!(together(&names), "1st fore-aft and 2 more");
    }
}
