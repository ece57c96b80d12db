//! Which lines of a Campbell diagram are drawn, and what they are called.

use towermodes::rotor::{Campbell, Excited, FrequencyLine};

use super::extent::{highest_hz, last_rpm};

/// Most excitations: more are a grey surface.
const EXCITATIONS: usize = 100;

/// What of a diagram is drawn.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shown {
    /// The speed at the right end, rpm.
    pub(super) last_rpm: f64,
    /// The frequency at the upper end, Hz.
    pub(super) highest_hz: f64,
    /// The multiples, the lowest of very many.
    pub(super) multiples: Vec<usize>,
    /// How many multiples are not drawn.
    pub(super) more_multiples: usize,
    /// Lines of modes, those of the tower with one frequency together.
    pub(super) groups: Vec<Group>,
    /// The lines above the upper end.
    pub(super) above: Vec<usize>,
    /// How many lines are not drawn because their frequency is 0, or no number.
    pub(super) unresisted: usize,
}

impl Shown {
    /// Whether a line and a multiple are both drawn.
    pub(super) fn has(&self, line: usize, multiple: usize) -> bool {
        let is_member = self
            .groups
            .iter()
            .any(|group| group.members.contains(&line));
        is_member && self.multiples.contains(&multiple)
    }
}

/// Lines that lie upon each other.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Group {
    /// Which lines of the diagram.
    pub(super) members: Vec<usize>,
    /// What they are, with their frequency.
    pub(super) label: String,
    /// Whether they are of a blade.
    pub(super) is_blade: bool,
    /// Rotor speed (rpm) and frequency (Hz).
    pub(super) points: Vec<[f64; 2]>,
}

impl Group {
    /// The lowest of its frequencies, Hz; infinite if it has none.
    fn lowest_hz(&self) -> f64 {
        let hz = self.points.iter().map(|[_, hz]| *hz);
        hz.fold(f64::INFINITY, f64::min)
    }
}

/// Chooses what is drawn.
pub(super) fn shown(campbell: &Campbell) -> Shown {
    let last_rpm = last_rpm(campbell);
    let multiples: Vec<usize> = campbell
        .multiples
        .iter()
        .copied()
        .take(EXCITATIONS)
        .collect();
    let highest_hz = highest_hz(campbell, &multiples, last_rpm);
    let (drawn, others): (Vec<Group>, Vec<Group>) = groups(campbell)
        .into_iter()
        .partition(|group| (f64::MIN_POSITIVE..=highest_hz).contains(&group.lowest_hz()));
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
        highest_hz,
        more_multiples: campbell.multiples.len() - multiples.len(),
        multiples,
        groups: drawn,
        above: lines(&above),
        unresisted: lines(&unresisted).len(),
    }
}

pub(super) fn is_blade(line: &FrequencyLine) -> bool {
    matches!(line.of, Excited::Blade { .. })
}

/// The lines, those of the tower together whose frequencies are one to three digits.
fn groups(campbell: &Campbell) -> Vec<Group> {
    let mut groups: Vec<Group> = Vec::new();
    let mut names: Vec<Vec<String>> = Vec::new();
    for (index, line) in campbell.lines.iter().enumerate() {
        let is_blade = is_blade(line);
        let name = line.label.replace(" bending", "");
        let digits = |points: &[[f64; 2]]| points.first().map(|[_, hz]| three_digits(*hz));
        match groups.last_mut() {
            Some(last)
                if !is_blade && !last.is_blade && digits(&last.points) == digits(&line.points) =>
            {
                last.members.push(index);
                if let Some(names) = names.last_mut() {
                    names.push(name);
                }
            }
            _ => {
                groups.push(Group {
                    members: vec![index],
                    label: String::new(),
                    is_blade,
                    points: line.points.clone(),
                });
                names.push(vec![name]);
            }
        }
    }
    for (group, names) in groups.iter_mut().zip(&names) {
        group.label = format!("{}: {}", together(names), range_hz(&group.points));
    }
    groups
}

/// "1st fore-aft, 1st side-side", "1st flap and 3 more".
fn together(names: &[String]) -> String {
    match names {
        [first, rest @ ..] if rest.len() > 1 => format!("{first} and {} more", rest.len()),
        names => names.join(", "),
    }
}

/// The frequency of a line, or its frequencies at the ends.
fn range_hz(points: &[[f64; 2]]) -> String {
    let [Some(first), Some(last)] =
        [points.first(), points.last()].map(|point| point.map(|[_, hz]| three_digits(*hz)))
    else {
        return String::new();
    };
    if first == last {
        format!("{first} Hz")
    } else {
        format!("{first} to {last} Hz")
    }
}

/// Three significant digits.
pub(super) fn three_digits(value: f64) -> String {
    if !(1e-4..1e6).contains(&value) {
        return if value == 0.0 {
            "0".to_owned()
        } else {
            format!("{value:.2e}")
        };
    }
    let decimals = (2.0 - value.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{value:.decimals$}")
}

#[cfg(test)]
mod tests {
    use super::{three_digits, together};

    #[test]
    fn three_digits_whatever_the_size() {
        assert_eq!(three_digits(0.321_46), "0.321");
        assert_eq!(three_digits(12.34), "12.3");
        assert_eq!(three_digits(0.007_9), "0.00790");
        assert_eq!(three_digits(1234.6), "1235");
        assert_eq!(three_digits(0.0), "0");
        assert_eq!(three_digits(3.2e-7), "3.20e-7");
    }

    #[test]
    fn two_names_are_said_and_more_are_counted() {
        let names = ["1st fore-aft", "1st side-side", "1st torsion"].map(str::to_owned);
        assert_eq!(together(&names[..2]), "1st fore-aft, 1st side-side");
        assert_eq!(together(&names), "1st fore-aft and 2 more");
    }
}
