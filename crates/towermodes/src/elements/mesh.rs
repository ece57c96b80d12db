//! The mesh of a tower: where it is cut into segments.
//!
//! Every row of every quantity is a segment border: steps and kinks of the tower, the soil and the
//! water, and every attachment. Spectral elements also end where the tower is steep. Between
//! borders the segments are equal, and their number is distributed by length.

use thiserror::Error;

use crate::number::Plain;
use crate::tower::Tower;

/// The largest ratio of a dimension or property at the ends of a span between [`Borders::Gradual`]
/// ones: the apex of a cone is then two thirds of the span away from it, and a polynomial of degree
/// p is exact to 3⁻ᵖ in its strains.
const STEEPEST_SPAN: f64 = 4.0;

/// Heights that differ by this fraction of the tower's height are the same.
const ROUNDED: f64 = 1e-9;

/// Why given heights cannot be the segment borders of a tower.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum BorderError {
    /// An attachment, or an end of the tower, is not at an element boundary.
    #[error("no element border is at {} m, where the tower ends or something is attached", Plain(*.height_m))]
    Missing {
        /// The height, m.
        height_m: f64,
    },
    /// There are some below the base or above the top.
    #[error("the element borders must begin at the base and end at the top of the tower")]
    Beyond,
    /// They do not increase.
    #[error("the element border at {} m is not above the one before it", Plain(*.height_m))]
    NotRising {
        /// The height, m.
        height_m: f64,
    },
}

/// Which heights must be segment borders.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Borders {
    /// Every end of a linear piece, and every point mass.
    Pieces,
    /// Those, and as many more that no dimension of a tube and no stiffness of a table changes by
    /// more than a factor of 4 over a span, so that polynomials converge fast.
    Gradual,
}

/// A stretch of a tower that is cut into equal segments.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Span {
    /// Index of the linear piece at its lower end, into [`Tower::pieces`].
    pub piece: usize,
    /// Height of its lower end, m.
    pub base_m: f64,
    /// Height of its upper end, m.
    pub top_m: f64,
    /// Into how many equal segments it is cut.
    pub segments: usize,
}

impl Span {
    /// Length, m.
    pub fn length_m(&self) -> f64 {
        self.top_m - self.base_m
    }
}

/// The segments of a tower from the base to the top.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Mesh {
    spans: Vec<Span>,
    borders_m: Vec<f64>,
}

impl Mesh {
    /// Cuts a tower into `segments`, or as many as it has spans if that is more.
    ///
    /// An even number that gives every span four and more is shared out in pairs, so that
    /// [`halved`](Self::halved) exists.
    pub fn new(tower: &Tower, borders: Borders, segments: usize) -> Self {
        let spans = spans_of(tower, borders);
        if segments.is_multiple_of(2) && segments / 4 >= spans.len() {
            Self::in_pairs(spans, segments / 2)
        } else {
            Self::distribute(spans, segments, 1)
        }
    }

    /// Cuts a tower into about `segments`, an even number in each span: what is shorter than two of
    /// them is cut in two, and the rest is shared out as if the short spans were not there.
    pub fn at_least(tower: &Tower, borders: Borders, segments: usize) -> Self {
        let spans = spans_of(tower, borders);
        let pair_m = tower.height_m() / (segments / 2) as f64;
        let short = spans.iter().filter(|span| span.length_m() < pair_m).count();
        let short = if short == spans.len() { 0 } else { short };
        Self::in_pairs(spans, segments / 2 + short)
    }

    /// Cuts a tower into equal segments, if every required border is one of theirs, up to
    /// rounding.
    pub fn equal(tower: &Tower, borders: Borders, segments: usize) -> Option<Self> {
        let mut spans = spans_of(tower, borders);
        let segment_m = tower.height_m() / segments as f64;
        for span in &mut spans {
            let ideal = span.length_m() / segment_m;
            span.segments = ideal.round() as usize;
            let is_whole = (ideal - ideal.round()).abs() <= ROUNDED * segments as f64;
            if span.segments == 0 || !is_whole {
                return None;
            }
        }
        let total: usize = spans.iter().map(|span| span.segments).sum();
        (total == segments).then(|| Self::from_spans(spans))
    }

    /// Cuts a tower at the required borders only.
    pub fn coarsest(tower: &Tower, borders: Borders) -> Self {
        Self::from_spans(spans_of(tower, borders))
    }

    /// Cuts a tower at given heights, m, strictly increasing from its base to its top. Every
    /// attachment must be at one of them, up to rounding.
    ///
    /// # Errors
    /// [`BorderError`]: the first condition that is violated.
    pub fn with_borders(tower: &Tower, heights_m: &[f64]) -> Result<Self, BorderError> {
        let mut borders_m = heights_m.to_vec();
        // With NaN as a height, the list does not increase.
        let rises = |pair: &[f64]| pair[0] < pair[1];
        if let Some(row) = borders_m.windows(2).position(|pair| !rises(pair)) {
            let height_m = borders_m[row + 1];
            return Err(BorderError::NotRising { height_m });
        }
        let rounding_m = ROUNDED * tower.height_m();
        let attached = tower.attachments().iter().map(|a| a.height_m);
        for height_m in attached.chain([tower.base_m(), tower.top_m()]) {
            let near = borders_m.partition_point(|border| *border < height_m - rounding_m);
            match borders_m.get_mut(near) {
                Some(border) if *border <= height_m + rounding_m => *border = height_m,
                _ => return Err(BorderError::Missing { height_m }),
            }
        }
        let ends = (borders_m.first().copied(), borders_m.last().copied());
        if ends != (Some(tower.base_m()), Some(tower.top_m())) {
            return Err(BorderError::Beyond);
        }
        let pieces = tower.pieces();
        let spans = borders_m.windows(2).map(|pair| Span {
            piece: pieces.partition_point(|piece| piece.top_m <= pair[0]),
            base_m: pair[0],
            top_m: pair[1],
            segments: 1,
        });
        Ok(Self::from_spans(spans.collect()))
    }

    fn in_pairs(spans: Vec<Span>, pairs: usize) -> Self {
        Self::distribute(spans, pairs, 2)
    }

    /// Distributes `shares` by length, each of `segments_each` segments.
    fn distribute(mut spans: Vec<Span>, shares: usize, segments_each: usize) -> Self {
        let lengths: Vec<f64> = spans.iter().map(Span::length_m).collect();
        let counts = shared_by_length(&lengths, shares);
        for (span, count) in spans.iter_mut().zip(counts) {
            span.segments = segments_each * count;
        }
        Self::from_spans(spans)
    }

    /// The fewest segments of a tower: its steps, kinks and attachments require them.
    pub fn fewest_segments(tower: &Tower, borders: Borders) -> usize {
        spans_of(tower, borders).len()
    }

    /// How often every two segments of this mesh can be merged.
    pub fn halvings(&self) -> u32 {
        let spans = self.spans.iter();
        let halvings = spans.map(|span| span.segments.trailing_zeros());
        halvings.min().unwrap_or(0)
    }

    /// The mesh with every two segments merged, if every span has an even number of them.
    pub fn halved(&self) -> Option<Self> {
        let mut halved = Self::default();
        (self.halvings() > 0).then(|| {
            self.write_halved(1, &mut halved);
            halved
        })
    }

    /// The mesh with every segment halved.
    pub fn doubled(&self) -> Self {
        let mut doubled = Self::default();
        self.write_doubled(1, &mut doubled);
        doubled
    }

    /// Writes into `mesh` this mesh with every two segments merged, `halvings` times. Every span
    /// must have a multiple of 2^`halvings` segments; see [`halvings`](Self::halvings).
    pub fn write_halved(&self, halvings: u32, mesh: &mut Self) {
        self.write_with_segments(|segments| segments >> halvings, mesh);
    }

    /// Writes into `mesh` this mesh with every segment halved, `doublings` times.
    pub fn write_doubled(&self, doublings: u32, mesh: &mut Self) {
        self.write_with_segments(|segments| segments << doublings, mesh);
    }

    fn write_with_segments(&self, change: impl Fn(usize) -> usize, mesh: &mut Self) {
        let changed = self.spans.iter().map(|span| Span {
            segments: change(span.segments),
            ..*span
        });
        mesh.spans.clear();
        mesh.spans.extend(changed);
        mesh.set_borders();
    }

    /// The mesh with the end of each span moved to another height, m.
    pub(crate) fn moved(&self, moved_m: impl Fn(f64) -> f64) -> Self {
        let spans = self.spans.iter().map(|span| Span {
            base_m: moved_m(span.base_m),
            top_m: moved_m(span.top_m),
            ..*span
        });
        Self::from_spans(spans.collect())
    }

    fn from_spans(spans: Vec<Span>) -> Self {
        let mut mesh = Self {
            spans,
            borders_m: Vec::new(),
        };
        mesh.set_borders();
        mesh
    }

    /// Sets the borders between the segments of the spans.
    fn set_borders(&mut self) {
        let Self { spans, borders_m } = self;
        let total: usize = spans.iter().map(|span| span.segments).sum();
        borders_m.clear();
        borders_m.reserve_exact(total + 1);
        for span in &*spans {
            let border =
                |k: usize| span.base_m + span.length_m() * (k as f64 / span.segments as f64);
            borders_m.extend((0..span.segments).map(border));
        }
        borders_m.extend(spans.last().map(|span| span.top_m));
    }

    /// Whether the spans of this mesh are those between the ends of pieces and attachments of a
    /// tower: then a mesh of [`Borders::Pieces`] with as many segments of this tower is this mesh.
    pub fn has_spans_of(&self, tower: &Tower) -> bool {
        let (mut spans, mut are_same) = (self.spans.iter(), true);
        for_each_smooth_span(tower, |span| {
            are_same &= spans.next().is_some_and(|own| {
                let ends = |span: &Span| (span.piece, span.base_m, span.top_m);
                ends(own) == ends(&span)
            });
        });
        are_same && spans.next().is_none()
    }

    /// Number of segments.
    pub fn segments(&self) -> usize {
        self.borders_m.len().saturating_sub(1)
    }

    /// The segment borders from the base to the top, m: one more than there are segments.
    pub fn borders_m(&self) -> &[f64] {
        &self.borders_m
    }

    /// The spans with the borders of each: a slice one longer than the span's number of segments.
    pub fn spans_with_borders(&self) -> impl Iterator<Item = (&Span, &[f64])> {
        let mut first = 0;
        self.spans.iter().map(move |span| {
            let borders = &self.borders_m[first..=first + span.segments];
            first += span.segments;
            (span, borders)
        })
    }
}

/// The spans between the required borders, each as one segment.
fn spans_of(tower: &Tower, borders: Borders) -> Vec<Span> {
    let spans = smooth_spans(tower);
    if borders != Borders::Gradual {
        return spans;
    }
    let mut gradual = Vec::with_capacity(spans.len());
    for span in spans {
        add_gradual(tower, span, &mut gradual);
    }
    gradual
}

/// Adds a span, divided until it is gradual.
fn add_gradual(tower: &Tower, span: Span, spans: &mut Vec<Span>) {
    let piece = &tower.pieces()[span.piece];
    match piece.even_cut_m(span.base_m, span.top_m, STEEPEST_SPAN) {
        None => spans.push(span),
        Some(cut_m) => {
            add_gradual(
                tower,
                Span {
                    top_m: cut_m,
                    ..span
                },
                spans,
            );
            add_gradual(
                tower,
                Span {
                    base_m: cut_m,
                    ..span
                },
                spans,
            );
        }
    }
}

/// The spans between the ends of pieces and attachments.
fn smooth_spans(tower: &Tower) -> Vec<Span> {
    let mut spans = Vec::with_capacity(tower.pieces().len());
    for_each_smooth_span(tower, |span| spans.push(span));
    spans
}

/// Tells `add` the spans between the ends of pieces and attachments.
fn for_each_smooth_span(tower: &Tower, mut add: impl FnMut(Span)) {
    let attachments = tower.attachments();
    // They are sorted by height.
    let from = |height_m: f64| attachments.partition_point(|a| a.height_m < height_m);
    for (piece, ends) in tower.pieces().iter().enumerate() {
        let mut base_m = ends.base_m;
        let mut add_up_to = |top_m: f64| {
            if base_m < top_m {
                add(Span {
                    piece,
                    base_m,
                    top_m,
                    segments: 1,
                });
                base_m = top_m;
            }
        };
        let within = &attachments[from(ends.base_m)..from(ends.top_m)];
        within.iter().for_each(|a| add_up_to(a.height_m));
        add_up_to(ends.top_m);
    }
}

/// Distributes `total` over the lengths, at least one to each: the whole parts first, then the
/// largest remainders.
fn shared_by_length(lengths: &[f64], total: usize) -> Vec<usize> {
    let total = total.max(lengths.len());
    let ideal = ideal_shares(lengths, total);
    let mut counts: Vec<usize> = ideal.iter().map(|&share| (share as usize).max(1)).collect();
    let mut by_remainder: Vec<usize> = (0..lengths.len()).collect();
    by_remainder.sort_by(|&a, &b| {
        let remainder = |i: usize| ideal[i] - counts[i] as f64;
        remainder(b).total_cmp(&remainder(a))
    });
    let missing = total.saturating_sub(counts.iter().sum());
    for index in by_remainder.into_iter().cycle().take(missing) {
        counts[index] += 1;
    }
    counts
}

/// Shares proportional to the lengths that add up to `total`; a length whose share would be below
/// one has one.
fn ideal_shares(lengths: &[f64], total: usize) -> Vec<f64> {
    let mut is_short = vec![false; lengths.len()];
    loop {
        let shorts = is_short.iter().filter(|short| **short).count();
        let others = |(l, short): (&f64, &bool)| if *short { 0.0 } else { *l };
        let length: f64 = lengths.iter().zip(&is_short).map(others).sum();
        // The quotient first: it is at most one, however long or short the lengths are.
        let share = |l: f64| (total - shorts) as f64 * (l / length);
        let newly_short = |i: &usize| !is_short[*i] && share(lengths[*i]) < 1.0;
        let newly: Vec<usize> = (0..lengths.len()).filter(newly_short).collect();
        // Rounding must not make the last one short too.
        if newly.is_empty() || shorts + newly.len() >= lengths.len() {
            let shares = lengths.iter().zip(&is_short);
            return shares
                .map(|(l, short)| if *short { 1.0 } else { share(*l) })
                .collect();
        }
        newly.into_iter().for_each(|i| is_short[i] = true);
    }
}

#[cfg(test)]
mod tests {
    use super::shared_by_length;

    #[test]
    fn equal_lengths_share_equally() {
        assert_eq!(shared_by_length(&[2.0, 2.0, 2.0], 9), [3, 3, 3]);
    }

    #[test]
    fn everything_gets_at_least_one_and_the_sum_is_kept() {
        assert_eq!(shared_by_length(&[1e-3, 10.0, 30.0], 9), [1, 2, 6]);
        assert_eq!(shared_by_length(&[1.0, 1e-9, 1e-9], 3), [1, 1, 1]);
        assert_eq!(shared_by_length(&[1.0, 2.0, 3.0, 4.0], 2), [1, 1, 1, 1]);
        assert_eq!(shared_by_length(&[5e-324], 7), [7]);
        assert_eq!(shared_by_length(&[1e308, 5e-324, 5e307], 7), [4, 1, 2]);
        for total in 3..200 {
            let counts = shared_by_length(&[0.7, 13.1, 55.5], total);
            assert_eq!(counts.iter().sum::<usize>(), total);
        }
    }
}
