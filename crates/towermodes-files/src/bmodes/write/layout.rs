//! The cuts of a deck along a tower: heights between which all properties are smooth, and heights
//! at which elements must end.

use towermodes::number::Rounded;
use towermodes::tower::Piece;
use towermodes::{Tower, TowerDescription};

use super::spread::Attached;
use crate::note::Note;

/// Heights closer than this fraction of the tower's length are merged: a step takes 1e-7 of the
/// length, so the rows around it remain in order.
pub(super) const CLOSEST: f64 = 1e-6;

/// A height at which something begins or ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Cut {
    pub(super) height_m: f64,
    pub(super) need: Need,
}

impl Cut {
    fn essential(height_m: f64) -> Self {
        let need = Need::Essential;
        Self { height_m, need }
    }
}

/// How necessary an element boundary is at a cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Need {
    /// A kink: an element uses its section at its middle anyway.
    None,
    /// A step.
    Wanted,
    /// The end of the tower, of a mass or of wires.
    Essential,
}

/// Distributed masses and springs per metre of the tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct PerMetre {
    pub(super) mass_kg_per_m: f64,
    pub(super) polar_inertia_kg_m: f64,
    pub(super) horizontal_n_per_m2: f64,
}

/// A tower between cuts, with its point masses and guy wires.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Layout {
    pub(super) base_m: f64,
    pub(super) top_m: f64,
    /// The cuts, from the base to the top.
    pub(super) cuts: Vec<Cut>,
    /// Point masses and guy wires; distributed ones begin and end at cuts.
    pub(super) attached: Attached,
    /// The distributed masses and springs between neighbouring cuts.
    per_metre: Vec<PerMetre>,
}

impl Layout {
    pub(super) fn new(
        tower: &Tower,
        description: &TowerDescription,
        is_offshore: bool,
        notes: &mut Vec<Note>,
    ) -> Self {
        let mut layout = Self {
            base_m: tower.base_m(),
            top_m: tower.top_m(),
            cuts: Vec::new(),
            attached: Attached::of(tower, description, is_offshore, notes),
            per_metre: Vec::new(),
        };
        layout.cut(tower, notes);
        layout.snap();
        layout.add_up();
        layout
    }

    pub(super) fn length_m(&self) -> f64 {
        self.top_m - self.base_m
    }

    /// A height as a fraction of the tower's length.
    pub(super) fn fraction(&self, height_m: f64) -> f64 {
        (height_m - self.base_m) / self.length_m()
    }

    /// The intervals between neighbouring cuts, m.
    pub(super) fn intervals_m(&self) -> impl Iterator<Item = (f64, f64)> {
        self.cuts
            .windows(2)
            .map(|pair| (pair[0].height_m, pair[1].height_m))
    }

    /// The distributed masses and springs at a height.
    pub(super) fn spread_at(&self, height_m: f64) -> PerMetre {
        let above = self.cuts.partition_point(|cut| cut.height_m < height_m);
        let here = above
            .checked_sub(1)
            .and_then(|interval| self.per_metre.get(interval));
        here.copied().unwrap_or_default()
    }

    /// Adds up the distributed masses and springs between neighbouring cuts, once for all heights.
    fn add_up(&mut self) {
        self.per_metre = vec![PerMetre::default(); self.cuts.len() - 1];
        let index = |height_m: f64| self.cuts.partition_point(|cut| cut.height_m < height_m);
        for spread in &self.attached.spreads {
            let over_m = spread.to_m - spread.from_m;
            for sum in &mut self.per_metre[index(spread.from_m)..index(spread.to_m)] {
                sum.mass_kg_per_m += spread.mass_kg / over_m;
                sum.polar_inertia_kg_m += spread.polar_inertia_kg_m2 / over_m;
                sum.horizontal_n_per_m2 += spread.horizontal_n_per_m / over_m;
            }
        }
    }

    fn cut(&mut self, tower: &Tower, notes: &mut Vec<Note>) {
        let mut wanted = self.wanted_cuts(tower);
        wanted.sort_by(|a, b| a.height_m.total_cmp(&b.height_m));
        self.cuts = vec![Cut::essential(self.base_m)];
        let mut merged = 0;
        for cut in wanted {
            merged += usize::from(self.add(cut));
        }
        if merged > 0 {
            let message = format!(
                "{merged} heights are merged with neighbours nearer than {} m",
                Rounded(CLOSEST * self.length_m())
            );
            notes.push(Note::approximation(message));
        }
    }

    /// All cuts above the base: at sections of the tower, at ends of distributed masses and
    /// springs, at wires.
    fn wanted_cuts(&self, tower: &Tower) -> Vec<Cut> {
        let closest_m = CLOSEST * self.length_m();
        // Rows so close together are a step, as in decks, also where a distributed mass begins.
        let is_step = |pair: &[Piece]| {
            !pair[0].meets(&pair[1]) || pair.iter().any(|piece| piece.length_m() < closest_m)
        };
        let between = |pair: &[Piece]| Cut {
            height_m: pair[0].top_m,
            need: match is_step(pair) {
                true => Need::Wanted,
                false => Need::None,
            },
        };
        let ends = self
            .attached
            .spreads
            .iter()
            .flat_map(|s| [s.from_m, s.to_m]);
        let nodes = self
            .attached
            .wires_at_nodes
            .iter()
            .map(|(_, height_m)| *height_m);
        let mut cuts = vec![Cut::essential(self.top_m)];
        cuts.extend(tower.pieces().windows(2).map(between));
        cuts.extend(ends.chain(nodes).map(Cut::essential));
        cuts
    }

    /// Adds a cut, or merges it with the last one if that is too close; returns whether two
    /// different heights were merged.
    fn add(&mut self, cut: Cut) -> bool {
        let closest_m = CLOSEST * self.length_m();
        let is_first = self.cuts.len() == 1;
        match self.cuts.last_mut() {
            Some(last) if cut.height_m - last.height_m < closest_m => {
                let differ = cut.height_m != last.height_m;
                last.need = last.need.max(cut.need);
                // The tower ends where it ends.
                if cut.height_m == self.top_m && !is_first {
                    last.height_m = self.top_m;
                }
                differ
            }
            _ => {
                self.cuts.push(cut);
                false
            }
        }
    }

    /// Moves the ends of distributed masses and springs to cuts.
    fn snap(&mut self) {
        let cuts = &self.cuts;
        for spread in &mut self.attached.spreads {
            spread.from_m = nearest(cuts, spread.from_m);
            spread.to_m = nearest(cuts, spread.to_m);
        }
        for (_, height_m) in &mut self.attached.wires_at_nodes {
            *height_m = nearest(cuts, *height_m);
        }
    }
}

/// The height of the nearest cut, m.
fn nearest(cuts: &[Cut], height_m: f64) -> f64 {
    let above = cuts.partition_point(|cut| cut.height_m < height_m);
    let around = cuts[above.saturating_sub(1)..cuts.len().min(above + 1)].iter();
    let distance = |cut: &&Cut| (cut.height_m - height_m).abs();
    let nearest = around.min_by(|a, b| distance(a).total_cmp(&distance(b)));
    nearest.map_or(height_m, |cut| cut.height_m)
}
