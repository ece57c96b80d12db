//! The element boundaries of a deck.

use super::layout::{Layout, Need};
use crate::note::Note;

/// The boundaries as fractions of the length, from 0 to 1: at least `wanted` elements and at most
/// `most`, unless essential cuts need more.
pub(super) fn borders(
    layout: &Layout,
    most: usize,
    wanted: usize,
    notes: &mut Vec<Note>,
) -> Vec<f64> {
    let mut ends = ends(layout, Need::Wanted);
    let mut note = |message: String| notes.push(Note::approximation(message));
    if ends.len() - 1 > most {
        note(format!(
            "element borders at every step need {} elements, but BModes 3.00 has at most {most}: some steps are within elements",
            ends.len() - 1
        ));
        ends = self::ends(layout, Need::Essential);
    }
    let spans = ends.len() - 1;
    if spans > most {
        note(format!(
            "masses and guy wires need {spans} elements, but BModes 3.00 has at most {most}: it will refuse this deck"
        ));
    } else if wanted > most {
        note(format!(
            "BModes 3.00 has at most {most} elements: {wanted} were requested"
        ));
    }
    divided(&ends, wanted.min(most).max(spans))
}

/// Positions where elements must end for this need, as fractions of the length.
fn ends(layout: &Layout, need: Need) -> Vec<f64> {
    let needed = layout.cuts.iter().filter(|cut| cut.need >= need);
    needed.map(|cut| layout.fraction(cut.height_m)).collect()
}

/// The nodes of the wires, from 1 at the base.
pub(super) fn wire_nodes(layout: &Layout, borders: &[f64]) -> Vec<usize> {
    let node = |(_, height_m): &(usize, f64)| {
        let fraction = layout.fraction(*height_m);
        borders.partition_point(|border| *border < fraction) + 1
    };
    layout.attached.wires_at_nodes.iter().map(node).collect()
}

/// The boundaries of `total` elements; further boundaries divide the longest elements.
fn divided(ends: &[f64], total: usize) -> Vec<f64> {
    let lengths: Vec<f64> = ends.windows(2).map(|pair| pair[1] - pair[0]).collect();
    let mut counts = vec![1_usize; lengths.len()];
    for _ in lengths.len()..total {
        let size = |i: &usize| lengths[*i] / counts[*i] as f64;
        let longest = (0..lengths.len()).max_by(|a, b| size(a).total_cmp(&size(b)));
        if let Some(longest) = longest {
            counts[longest] += 1;
        }
    }
    let mut borders = Vec::with_capacity(total + 1);
    for (pair, count) in ends.windows(2).zip(counts) {
        let border = |k: usize| pair[0] + (pair[1] - pair[0]) * (k as f64 / count as f64);
        borders.extend((0..count).map(border));
    }
    borders.extend(ends.last());
    borders
}

#[cfg(test)]
mod tests {
    use super::divided;

    #[test]
    fn elements_are_shared_out_by_length() {
        assert_eq!(divided(&[0.0, 1.0], 4), [0.0, 0.25, 0.5, 0.75, 1.0]);
        assert_eq!(divided(&[0.0, 0.1, 0.9, 1.0], 4), [0.0, 0.1, 0.5, 0.9, 1.0]);
        assert_eq!(divided(&[0.0, 0.1, 1.0], 2), [0.0, 0.1, 1.0]);
    }
}
