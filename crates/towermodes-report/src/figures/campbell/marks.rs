//! The marks of pairs with FAIL or WARN; coinciding marks are counted.

use towermodes_analysis::Verdict;
use towermodes_analysis::resonance::{Campbell, Margin};

use super::lines::Shown;
use crate::svg::{Anchor, Axes, Colour, Drawing, Marker, TextStyle, text_width};

/// Distance from the middle of a mark to its edge.
const RADIUS: f64 = 6.0;
/// Radius of the background under a mark, so that lines do not alter its outline.
const PAPER: f64 = 8.0;
/// Size of the number above a mark.
const SIZE: f64 = 9.5;
/// Distance from the middle of a mark to the baseline of its number.
const RISE: f64 = 9.0;

/// Marks that coincide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cluster {
    /// The sum of the positions of its pairs.
    sum: (f64, f64),
    /// Number of pairs with FAIL.
    fails: usize,
    /// Number of pairs with WARN.
    warns: usize,
}

impl Cluster {
    fn of(place: (f64, f64), verdict: Verdict) -> Self {
        let is = |which| usize::from(verdict == which);
        Self {
            sum: place,
            fails: is(Verdict::Fail),
            warns: is(Verdict::Warn),
        }
    }

    fn with(self, other: Self) -> Self {
        Self {
            sum: (self.sum.0 + other.sum.0, self.sum.1 + other.sum.1),
            fails: self.fails + other.fails,
            warns: self.warns + other.warns,
        }
    }

    /// The mean position of its pairs.
    fn place(&self) -> (f64, f64) {
        let count = (self.fails + self.warns) as f64;
        (self.sum.0 / count, self.sum.1 / count)
    }

    /// Its marks from left to right: kind, count and position.
    fn marks(&self) -> Vec<(Marker, Colour, usize, (f64, f64))> {
        let (x, y) = self.place();
        let both = self.fails > 0 && self.warns > 0;
        let half = if both { 0.5 * self.apart() } else { 0.0 };
        let cross = (Marker::Cross, Colour::Fail, self.fails, (x - half, y));
        let triangle = (Marker::Triangle, Colour::Warn, self.warns, (x + half, y));
        let marks = [cross, triangle].into_iter();
        marks.filter(|(_, _, count, _)| *count > 0).collect()
    }

    /// Distance from its cross to its triangle: the numbers above them must not touch.
    fn apart(&self) -> f64 {
        let half = |count| 0.5 * number_width(count);
        (half(self.fails) + half(self.warns) + 3.0).max(2.0 * PAPER)
    }

    /// Whether one of its marks represents several pairs.
    fn is_counted(&self) -> bool {
        self.fails > 1 || self.warns > 1
    }

    /// Half of its width, and its extent upwards and downwards.
    fn reach(&self) -> [f64; 3] {
        let marks = self.marks();
        let x = self.place().0;
        let half = |(_, _, count, (at, _)): &(Marker, Colour, usize, (f64, f64))| {
            (at - x).abs() + RADIUS.max(0.5 * number_width(*count))
        };
        let half_width = marks.iter().map(half).fold(0.0, f64::max);
        let up = if self.is_counted() {
            RISE + SIZE
        } else {
            RADIUS
        };
        [half_width, up, RADIUS]
    }

    fn touches(&self, other: &Self) -> bool {
        let ((x, y), (other_x, other_y)) = (self.place(), other.place());
        let ([half, up, down], [other_half, other_up, other_down]) = (self.reach(), other.reach());
        (x - other_x).abs() < half + other_half
            && y - up < other_y + other_down
            && other_y - other_up < y + down
    }
}

fn number_width(count: usize) -> f64 {
    if count > 1 {
        text_width(&count.to_string(), SIZE, true)
    } else {
        0.0
    }
}

/// The marks of all pairs in a field (counted from the lowest), without overlaps.
pub(super) fn clusters(
    campbell: &Campbell,
    shown: &Shown,
    (field, axes): (usize, &Axes),
) -> Vec<Cluster> {
    let is_marked = |margin: &&Margin| {
        margin.verdict.is_objection()
            && margin.natural_hz <= shown.highest_hz()
            && shown.field_of(margin.natural_hz) == field
            && shown.has(margin.line, margin.multiple)
    };
    let of_pair = |margin: &Margin| {
        let place = axes.at(margin.nearest_rpm, margin.natural_hz);
        let is_place = place.0.is_finite() && place.1.is_finite();
        is_place.then(|| Cluster::of(place, margin.verdict))
    };
    let pairs = campbell.margins.iter().filter(is_marked);
    apart(pairs.filter_map(of_pair))
}

/// Combines touching marks until none touch.
fn apart(pairs: impl Iterator<Item = Cluster>) -> Vec<Cluster> {
    let mut clusters: Vec<Cluster> = Vec::new();
    for pair in pairs {
        let mut joined = pair;
        // A joined mark may touch others, which are joined too.
        while let Some(index) = clusters.iter().position(|c| c.touches(&joined)) {
            joined = clusters.swap_remove(index).with(joined);
        }
        clusters.push(joined);
    }
    clusters
}

/// Whether a mark represents several pairs.
pub(super) fn are_counted(clusters: &[Cluster]) -> bool {
    clusters.iter().any(Cluster::is_counted)
}

/// Draws the marks, with a number above those that represent several pairs.
pub(super) fn draw(drawing: &mut Drawing, clusters: &[Cluster]) {
    let marks: Vec<_> = clusters.iter().flat_map(Cluster::marks).collect();
    // Below all marks, so that none hides its neighbour.
    for (_, _, count, place) in &marks {
        drawing.disc(*place, PAPER, Colour::Paper, None);
        let width = number_width(*count) + 2.0;
        if *count > 1 {
            let corner = (place.0 - 0.5 * width, place.1 - RISE - 0.8 * SIZE);
            drawing.rectangle(corner, (width, 0.8 * SIZE), Colour::Paper, None);
        }
    }
    for (marker, colour, count, place) in marks {
        drawing.marker(marker, place, RADIUS, colour);
        if count > 1 {
            let style = TextStyle::new(SIZE).bold().anchor(Anchor::Middle);
            let at = (place.0, place.1 - RISE);
            drawing.text(at, &count.to_string(), &style);
        }
    }
}

#[cfg(test)]
mod tests {
    use towermodes_analysis::Verdict::{Fail, Warn};

    use super::{Cluster, apart};

    #[test]
    fn what_is_at_one_place_is_counted() {
        let pairs = [
            Cluster::of((10.0, 10.0), Fail),
            Cluster::of((10.0, 10.0), Fail),
            Cluster::of((10.0, 10.0), Warn),
            Cluster::of((60.0, 10.0), Warn),
        ];
        let clusters = apart(pairs.into_iter());
        let counts: Vec<_> = clusters.iter().map(|c| (c.fails, c.warns)).collect();
        assert_eq!(counts, [(2, 1), (0, 1)]);
        // The cross on the left of the triangle, neither upon the other.
        let marks = clusters[0].marks();
        assert!(marks[1].3.0 - marks[0].3.0 >= 16.0);
        assert_eq!(clusters[1].marks()[0].3, (60.0, 10.0));
    }

    #[test]
    fn nothing_touches_in_the_end() {
        let place = |k: usize| {
            (
                f64::from(k as u32 * 7 % 400),
                f64::from(k as u32 * 31 % 300),
            )
        };
        let pairs = (0..3000).map(|k| Cluster::of(place(k), if k % 3 == 0 { Fail } else { Warn }));
        let clusters = apart(pairs);
        for (index, cluster) in clusters.iter().enumerate() {
            assert!(!clusters[index + 1..].iter().any(|c| c.touches(cluster)));
        }
        let all: usize = clusters.iter().map(|c| c.fails + c.warns).sum();
        assert_eq!(all, 3000);
    }
}
