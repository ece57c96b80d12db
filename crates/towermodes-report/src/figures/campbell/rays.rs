//! The excitations of a Campbell diagram: one ray each, and as many labels as fit.

use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::Campbell;

use super::lines::Shown;
use crate::svg::{Anchor, Axes, Colour, Drawing, Stroke, TextStyle, spread, text_width};

/// Size of the labels.
const SIZE: f64 = 11.0;
/// Distance between two labels.
const BETWEEN: f64 = 8.0;
/// If there are more rays than this, they are thinner.
const MANY: usize = 12;
/// Largest number of labels of rays that end at the right, beside the labels of the modes.
const MOST_AT_RIGHT: usize = 10;

/// The frequency of a multiple at the right end, Hz.
pub(super) fn end_hz(multiple: usize, shown: &Shown) -> f64 {
    multiple as f64 * shown.last_rpm / 60.0
}

/// The strong excitations that are drawn: 1P and the blade passing frequency.
pub(super) fn strong(campbell: &Campbell, shown: &Shown) -> Vec<usize> {
    let multiples = shown.multiples.iter().copied();
    multiples
        .filter(|multiple| is_strong(campbell, *multiple))
        .collect()
}

pub(super) fn is_strong(campbell: &Campbell, multiple: usize) -> bool {
    [1, campbell.rotor.blades].contains(&multiple)
}

/// The stroke of a ray: strong excitations are thick and dark.
pub(super) fn stroke(shown: &Shown, is_strong: bool) -> Stroke {
    match is_strong {
        true => Stroke::new(Colour::Ink, 2.4),
        false if shown.multiples.len() > MANY => Stroke::new(Colour::Muted, 0.6),
        false => Stroke::new(Colour::Muted, 0.9),
    }
}

/// The rays, strong excitations on top.
pub(super) fn draw(drawing: &mut Drawing, campbell: &Campbell, shown: &Shown, axes: &Axes) {
    let (strong, weak): (Vec<usize>, Vec<usize>) = shown
        .multiples
        .iter()
        .partition(|multiple| is_strong(campbell, **multiple));
    for (multiples, is_strong) in [(weak, false), (strong, true)] {
        for multiple in multiples {
            let end = axes.at(shown.last_rpm, end_hz(multiple, shown));
            drawing.line(axes.at(0.0, 0.0), end, &stroke(shown, is_strong));
        }
    }
}

/// The multiples that have a label.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Labelled {
    /// The multiples whose ray ends at the right.
    pub(super) right: Vec<usize>,
    /// The multiples whose ray ends at the top.
    pub(super) above: Vec<usize>,
}

impl Labelled {
    /// As many labels as fit a field of this width.
    pub(super) fn new(campbell: &Campbell, shown: &Shown, width: f64) -> Self {
        let is_right = |multiple: &usize| end_hz(*multiple, shown) <= shown.highest_hz();
        let (right, above): (Vec<usize>, Vec<usize>) =
            shown.multiples.iter().copied().partition(is_right);
        let room = (width / (widest(&above) + BETWEEN)).max(0.0) as usize;
        Self {
            right: foremost(campbell, right, MOST_AT_RIGHT),
            above: foremost(campbell, above, room),
        }
    }
}

/// This number of multiples: 1P, the blade passing frequency and those that fail, and an evenly
/// spaced selection of the others.
fn foremost(campbell: &Campbell, multiples: Vec<usize>, most: usize) -> Vec<usize> {
    if multiples.len() <= most {
        return multiples;
    }
    let fails = |multiple: usize| {
        let mut margins = campbell.margins.iter();
        margins.any(|m| m.multiple == multiple && m.verdict == Verdict::Fail)
    };
    let is_first =
        |multiple: &usize| [1, campbell.rotor.blades].contains(multiple) || fails(*multiple);
    let (mut chosen, others): (Vec<usize>, Vec<usize>) = multiples.into_iter().partition(is_first);
    chosen.truncate(most);
    let room = most - chosen.len();
    // From the last, which is the highest.
    let evenly = (0..room).filter_map(|k| {
        let back = k * others.len() / room;
        others.get(others.len().checked_sub(back + 1)?).copied()
    });
    chosen.extend(evenly);
    chosen.sort_unstable();
    chosen.dedup();
    chosen
}

/// "3P".
pub(super) fn text(multiple: usize) -> String {
    format!("{multiple}P")
}

fn widest(multiples: &[usize]) -> f64 {
    let widths = multiples
        .iter()
        .map(|multiple| text_width(&text(*multiple), SIZE, true));
    widths.fold(0.0, f64::max)
}

/// Labels the rays that end at the top.
pub(super) fn upper_ends(
    drawing: &mut Drawing,
    multiples: &[usize],
    (campbell, shown): (&Campbell, &Shown),
    axes: &Axes,
) {
    let place = |multiple: &usize| axes.x.at(60.0 * shown.highest_hz() / *multiple as f64);
    let ends: Vec<f64> = multiples.iter().map(place).collect();
    let widest = widest(multiples);
    let range = [axes.frame.left.max(0.5 * widest), axes.frame.right];
    let style = TextStyle::new(SIZE).anchor(Anchor::Middle);
    let leader = Stroke::new(Colour::Muted, 0.8);
    let top = axes.frame.top;
    for (multiple, (end, x)) in
        multiples
            .iter()
            .zip(ends.iter().zip(spread(&ends, widest + BETWEEN, range)))
    {
        drawing.line((*end, top), (x, top - 4.0), &leader);
        let style = match is_strong(campbell, *multiple) {
            true => style.bold(),
            false => style.colour(Colour::Muted),
        };
        drawing.text((x, top - 7.0), &text(*multiple), &style);
    }
}

#[cfg(test)]
mod tests {
    use towermodes::Rotor;
    use towermodes_analysis::resonance::Campbell;

    use super::foremost;

    #[test]
    fn labels_are_those_of_the_blades_and_some_of_the_others() {
        let campbell = Campbell {
            rotor: Rotor {
                blades: 3,
                lowest_rpm: 6.9,
                highest_rpm: 12.1,
            },
            margin: 0.05,
            multiples: Vec::new(),
            known_to_hz: None,
            lines: Vec::new(),
            margins: Vec::new(),
            classes: Vec::new(),
            first_bending: Vec::new(),
            shared: Vec::new(),
            not_checked: Vec::new(),
        };
        let foremost = |last, most| foremost(&campbell, (1..=last).collect(), most);
        assert_eq!(foremost(4, 4), [1, 2, 3, 4]);
        // 2 and 4 to 30 are 28 others: 28/4 = 7 from one to the next, from 30 down.
        assert_eq!(foremost(30, 6), [1, 3, 9, 16, 23, 30]);
        assert_eq!(foremost(30, 1), [1]);
        assert!(foremost(30, 0).is_empty());
    }
}
