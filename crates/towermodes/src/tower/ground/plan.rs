//! The heights at which the springs of the ground are computed as rows: the same for a tower and
//! slightly changed towers.

use super::super::parts::surroundings::SoilStiffness;
use super::description::Ground;
use super::kink::Kink;
use super::lines::Part;
use super::pile::Pile;
use super::reaction::Reactions;
use crate::tower::description::TowerDescription;

/// Lowest number of parts of a pile whose springs are not linear in height, so that the derivatives
/// with respect to their input values are accurate too.
const LEAST_PARTS: f64 = 4.0;
/// Largest number of parts of one section.
const MOST_PARTS: usize = 32;
/// Permitted relative change of a frequency by the linear interpolation.
const TOLERANCE: f64 = 1e-9;
/// The stated error is the estimate times this factor: on 80 random sites no frequency changes by
/// more than 10 times the estimate, which uses the absolute values of the first terms of a series.
const SAFETY: f64 = 20.0;

/// The sections of the pile within which springs are smooth, and how they are divided.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::tower) struct Plan {
    /// The ends of sections; each depends only on those before it.
    ends: Vec<End>,
    pub(super) sections: Vec<Section>,
    /// Index of the layer under the tip.
    pub(super) tip_layer: usize,
    /// Estimated relative change of a frequency by the linear interpolation.
    pub(in crate::tower) error: f64,
}

/// A section of the pile in one layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Section {
    pub(super) layer: usize,
    /// Index of its lower end.
    lower: usize,
    upper: usize,
    pub(super) lines: Lines,
}

/// The linear springs of a section.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Lines {
    /// One line: the springs are linear in height.
    One,
    /// Two lines in each of this number of parts.
    Pairs(usize),
}

/// The object that determines the height of an end of a section.
#[derive(Debug, Clone, Copy, PartialEq)]
enum End {
    Tip,
    /// The bottom of the hole of local scour, or the surface.
    Hole,
    LayerTop(usize),
    LayerBottom(usize),
    /// A row of the tower, by its index.
    Row(usize),
    /// The depth below which local scour does not reduce the effective stress.
    FullOverburden,
    /// A row of a table of p-y curves.
    TableRow(usize, usize),
    /// A kink between two other ends.
    Kink {
        kink: Kink,
        layer: usize,
        lower: usize,
        upper: usize,
    },
}

impl Plan {
    /// The plan of a tower; empty without ground.
    pub(in crate::tower) fn of(description: &TowerDescription) -> Self {
        let Some(reactions) = Reactions::of(description) else {
            return Self::default();
        };
        let pile = &reactions.pile;
        let mut plan = Self {
            tip_layer: tip_layer(pile.ground, pile.tip_m),
            ..Self::default()
        };
        let mut heights_m = Vec::new();
        for layer in 0..pile.ground.layers.len() {
            plan.add_sections(description, &reactions, layer, &mut heights_m);
        }
        plan.divide(&reactions, &heights_m);
        plan
    }

    /// Adds the sections of one layer by rising height, and the heights of their ends, m.
    fn add_sections(
        &mut self,
        description: &TowerDescription,
        reactions: &Reactions<'_>,
        layer: usize,
        heights_m: &mut Vec<f64>,
    ) {
        let pile = &reactions.pile;
        let own = &pile.ground.layers[layer];
        let upper = match own.top_m >= pile.hole_m {
            true => End::Hole,
            false => End::LayerTop(layer),
        };
        let lower = match own.bottom_m <= pile.tip_m {
            true => End::Tip,
            false => End::LayerBottom(layer),
        };
        let height = |end: &End| end.height_m(description, reactions, &[]);
        let (lower_m, upper_m) = (height(&lower), height(&upper));
        if lower_m.partial_cmp(&upper_m) != Some(std::cmp::Ordering::Less) {
            return;
        }
        let mut ends = knees(description, pile, layer);
        ends.retain(|end| (lower_m..=upper_m).contains(&height(end)));
        ends.retain(|end| height(end) != lower_m && height(end) != upper_m);
        ends.extend([lower, upper]);
        ends.sort_by(|a, b| height(a).total_cmp(&height(b)));
        ends.dedup_by(|a, b| height(a) == height(b));
        let first = self.ends.len();
        self.ends.extend(&ends);
        heights_m.extend(ends.iter().map(height));
        let mut borders: Vec<usize> = (first..self.ends.len()).collect();
        for kink in Kink::all() {
            borders = self.with_kinks(reactions, layer, kink, &borders, heights_m);
        }
        for pair in borders.windows(2) {
            self.sections.push(Section {
                layer,
                lower: pair[0],
                upper: pair[1],
                lines: Lines::One,
            });
        }
    }

    /// The indices of the ends, including kinks of one kind between them.
    fn with_kinks(
        &mut self,
        reactions: &Reactions<'_>,
        layer: usize,
        kink: Kink,
        borders: &[usize],
        heights_m: &mut Vec<f64>,
    ) -> Vec<usize> {
        let mut cut = Vec::with_capacity(borders.len());
        for pair in borders.windows(2) {
            cut.push(pair[0]);
            let [lower_m, upper_m] = [heights_m[pair[0]], heights_m[pair[1]]];
            if let Some(share) = kink.share(reactions, layer, [lower_m, upper_m]) {
                cut.push(self.ends.len());
                heights_m.push(lower_m + share * (upper_m - lower_m));
                self.ends.push(End::Kink {
                    kink,
                    layer,
                    lower: pair[0],
                    upper: pair[1],
                });
            }
        }
        cut.extend(borders.last());
        cut
    }

    /// Divides the sections until the linear interpolation changes no frequency.
    fn divide(&mut self, reactions: &Reactions<'_>, heights_m: &[f64]) {
        let pile = &reactions.pile;
        let weight = Weight::of(reactions, self, heights_m);
        let sections = self.sections.len().max(1) as f64;
        let mut error = 0.0;
        for section in &mut self.sections {
            if reactions.are_linear(section.layer) {
                continue;
            }
            let ends_m = [heights_m[section.lower], heights_m[section.upper]];
            let root = |height_m: f64| (pile.depth_m(height_m) / pile.length_m()).max(0.0).sqrt();
            let least = (LEAST_PARTS * (root(ends_m[0]) - root(ends_m[1]))).ceil();
            let mut parts = least.clamp(1.0, LEAST_PARTS) as usize;
            let mut missed = weight.missed(reactions, section.layer, ends_m, parts);
            while missed > TOLERANCE / sections && 2 * parts <= MOST_PARTS {
                parts *= 2;
                missed = weight.missed(reactions, section.layer, ends_m, parts);
            }
            section.lines = Lines::Pairs(parts);
            if missed.is_finite() {
                error += SAFETY * missed;
            }
        }
        self.error = error;
    }

    /// The heights of all ends on a tower, m.
    pub(super) fn heights_m(
        &self,
        description: &TowerDescription,
        reactions: &Reactions<'_>,
    ) -> Vec<f64> {
        let mut heights_m = Vec::with_capacity(self.ends.len());
        for end in &self.ends {
            heights_m.push(end.height_m(description, reactions, &heights_m));
        }
        heights_m
    }
}

impl Section {
    /// Its parts for these heights of the ends, in increasing height.
    pub(super) fn parts<'p>(
        &self,
        pile: &'p Pile<'_>,
        heights_m: &[f64],
    ) -> impl Iterator<Item = Part> + use<'p> {
        let count = match self.lines {
            Lines::One => 1,
            Lines::Pairs(parts) => parts,
        };
        parts(pile, self.layer, self.ends_m(heights_m), count)
    }

    /// The heights of its lower and its upper end on a tower with these heights of the ends, m.
    pub(super) fn ends_m(&self, heights_m: &[f64]) -> [f64; 2] {
        [heights_m[self.lower], heights_m[self.upper]]
    }
}

/// A part of a layer, divided at equal steps of the square root of the depth: springs that grow
/// with a power of the depth have their largest curvature near the surface.
fn parts<'p>(
    pile: &'p Pile<'_>,
    layer: usize,
    [lower_m, upper_m]: [f64; 2],
    count: usize,
) -> impl Iterator<Item = Part> + use<'p> {
    let [deep, shallow] = [lower_m, upper_m].map(|end_m| pile.depth_m(end_m).max(0.0).sqrt());
    let hole_m = pile.hole_m;
    let border_m = move |part: usize| match part {
        0 => lower_m,
        part if part == count => upper_m,
        part => {
            let share = part as f64 / count as f64;
            hole_m - (deep + share * (shallow - deep)).powi(2)
        }
    };
    (0..count).map(move |part| Part {
        layer,
        lower_m: border_m(part),
        upper_m: border_m(part + 1),
    })
}

/// The relation between an error of the springs and the change of a frequency, from the work of the
/// springs on a pile that bends over the length l = (4 EI/k̄)^¼: its deflection decreases at least
/// as e^(−z/2l).
#[derive(Debug, Clone, Copy)]
struct Weight {
    length_m: f64,
    /// ∫ k e^(−z/l) dz of each spring.
    work: [f64; SoilStiffness::SPRINGS],
}

impl Weight {
    fn of(reactions: &Reactions<'_>, plan: &Plan, heights_m: &[f64]) -> Self {
        let pile = &reactions.pile;
        let parts = || {
            let sections = plan.sections.iter();
            sections.flat_map(|section| {
                let ends_m = [heights_m[section.lower], heights_m[section.upper]];
                parts(pile, section.layer, ends_m, LEAST_PARTS as usize)
            })
        };
        let sums: Vec<_> = parts().map(|part| (part, part.sum(reactions))).collect();
        let lateral = sums.iter().map(|(_, sums)| sums[0]).sum::<f64>() / pile.length_m();
        let bending_n_m2 = pile.bending_n_m2(pile.hole_m - 0.5 * pile.length_m());
        let length_m = (4.0 * bending_n_m2 / lateral).powf(0.25);
        let mut weight = Self {
            length_m,
            work: [0.0; SoilStiffness::SPRINGS],
        };
        for (part, sums) in &sums {
            let fade = weight.fade(pile, part);
            for (work, sum) in weight.work.iter_mut().zip(sums) {
                *work += fade * sum;
            }
        }
        weight
    }

    fn fade(&self, pile: &Pile<'_>, part: &Part) -> f64 {
        (-pile.depth_m(0.5 * (part.lower_m + part.upper_m)) / self.length_m).exp()
    }

    /// The largest relative change of a frequency by the linear interpolation in a section.
    fn missed(
        &self,
        reactions: &Reactions<'_>,
        layer: usize,
        ends_m: [f64; 2],
        count: usize,
    ) -> f64 {
        let pile = &reactions.pile;
        let mut sum = [0.0; SoilStiffness::SPRINGS];
        for part in parts(pile, layer, ends_m, count) {
            let fade = self.fade(pile, &part);
            let missed = part.missed(reactions, self.length_m);
            for (sum, missed) in sum.iter_mut().zip(missed) {
                *sum += fade * missed;
            }
        }
        let shares = sum
            .iter()
            .zip(self.work)
            .map(|(missed, work)| match work > 0.0 {
                true => 0.5 * missed / work,
                false => 0.0,
            });
        shares.fold(0.0, f64::max)
    }
}

/// The layer under the tip; if the tip is at a border of layers, the lower one, if there is one.
fn tip_layer(ground: &Ground, tip_m: f64) -> usize {
    let below = ground
        .layers
        .iter()
        .position(|layer| layer.bottom_m < tip_m);
    below.unwrap_or(ground.layers.len().saturating_sub(1))
}

/// Heights at which the springs of a layer may change their slope, besides the kinks of their
/// formulas.
fn knees(description: &TowerDescription, pile: &Pile<'_>, layer: usize) -> Vec<End> {
    let rows = description.stations.len().max(description.properties.len());
    let mut knees: Vec<End> = (0..rows).map(End::Row).collect();
    if pile.ground.scour.local_m > 0.0 {
        knees.push(End::FullOverburden);
    }
    let rows = pile.ground.layers[layer].soil.rows();
    knees.extend((0..rows.len()).map(|row| End::TableRow(layer, row)));
    knees
}

impl End {
    /// Its height on a tower, m; the heights of the ends before it are known.
    fn height_m(
        &self,
        description: &TowerDescription,
        reactions: &Reactions<'_>,
        heights_m: &[f64],
    ) -> f64 {
        let pile = &reactions.pile;
        let layers = &pile.ground.layers;
        match *self {
            Self::Tip => pile.tip_m,
            Self::Hole => pile.hole_m,
            Self::LayerTop(layer) => layers[layer].top_m,
            Self::LayerBottom(layer) => layers[layer].bottom_m,
            Self::Row(row) => {
                let station = description.stations.get(row).map(|row| row.height_m);
                let of_table = || description.properties.get(row).map(|row| row.height_m);
                station.or_else(of_table).unwrap_or(f64::NAN)
            }
            Self::FullOverburden => pile.full_overburden_m(),
            Self::TableRow(layer, row) => {
                let row = layers[layer].soil.rows().get(row);
                row.map_or(f64::NAN, |row| row.height_m)
            }
            Self::Kink {
                kink,
                layer,
                lower,
                upper,
            } => {
                let [lower_m, upper_m] = [heights_m[lower], heights_m[upper]];
                let share = kink.share(reactions, layer, [lower_m, upper_m]);
                lower_m + share.unwrap_or(f64::NAN) * (upper_m - lower_m)
            }
        }
    }
}
