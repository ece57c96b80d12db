//! Where the springs of the ground are cut into rows: the same for a tower and for those near it.

use super::description::Ground;
use super::layer::LayerSoil;
use super::pile::Pile;
use super::reaction::{are_linear, ignore_diameter};
use super::rock::GROWS_DIAMETERS;
use crate::tower::description::TowerDescription;

/// Parts of a pile in soil whose springs are not linear in height, at equal steps of the root of
/// the depth: springs that grow with a power of the depth bend most near the surface. Straight
/// lines with the force and the moment of the springs of each part then change no first frequency
/// by more than 1e-6.
const PARTS: f64 = 16.0;

/// The sections of the pile within which springs are smooth, and how they are divided.
#[derive(Debug, Clone, PartialEq, Default)]
pub(in crate::tower) struct Plan {
    pub(super) sections: Vec<Section>,
    /// The layer under the tip.
    pub(super) tip_layer: usize,
}

/// A section of the pile in one layer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Section {
    pub(super) layer: usize,
    pub(super) lower: Guide,
    pub(super) upper: Guide,
    /// Into how many parts it is divided.
    pub(super) parts: usize,
}

/// What the end of a section moves with.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Guide {
    Tip,
    /// The bottom of the hole of local scour, or the surface.
    Hole,
    LayerTop(usize),
    LayerBottom(usize),
    /// A row of the tower, by its number.
    Row(usize),
    /// The depth below which local scour does not reduce the effective stress.
    FullOverburden,
    /// The depth below which weak rock does not get stiffer.
    FullRock(usize),
    /// A row of a table of p-y curves.
    TableRow(usize, usize),
}

impl Plan {
    /// Of a tower; empty without ground.
    pub(in crate::tower) fn of(description: &TowerDescription) -> Self {
        let Some(pile) = Pile::of(description) else {
            return Self::default();
        };
        let layers = 0..pile.ground.layers.len();
        Self {
            sections: layers
                .flat_map(|layer| sections_of(description, &pile, layer))
                .collect(),
            tip_layer: tip_layer(pile.ground, pile.tip_m),
        }
    }
}

/// The layer under the tip: at a border the lower one, if there is one.
fn tip_layer(ground: &Ground, tip_m: f64) -> usize {
    let below = ground
        .layers
        .iter()
        .position(|layer| layer.bottom_m < tip_m);
    below.unwrap_or(ground.layers.len().saturating_sub(1))
}

/// The sections of one layer by rising height.
fn sections_of(description: &TowerDescription, pile: &Pile<'_>, layer: usize) -> Vec<Section> {
    let own = &pile.ground.layers[layer];
    let upper = match own.top_m >= pile.hole_m {
        true => Guide::Hole,
        false => Guide::LayerTop(layer),
    };
    let lower = match own.bottom_m <= pile.tip_m {
        true => Guide::Tip,
        false => Guide::LayerBottom(layer),
    };
    let height = |guide: &Guide| guide.height_m(description, pile);
    let (lower_m, upper_m) = (height(&lower), height(&upper));
    if lower_m.partial_cmp(&upper_m) != Some(std::cmp::Ordering::Less) {
        return Vec::new();
    }
    let mut ends = knees(description, pile, layer);
    ends.retain(|guide| (lower_m..=upper_m).contains(&height(guide)));
    ends.retain(|guide| height(guide) != lower_m && height(guide) != upper_m);
    ends.extend([lower, upper]);
    ends.sort_by(|a, b| height(a).total_cmp(&height(b)));
    ends.dedup_by(|a, b| height(a) == height(b));
    let pairs = ends.windows(2).map(|pair| (pair[0], pair[1]));
    let section = |(lower, upper): (Guide, Guide)| Section {
        layer,
        lower,
        upper,
        parts: parts(pile, layer, [height(&lower), height(&upper)]),
    };
    pairs.map(section).collect()
}

/// Into how many parts a section between two heights is divided.
fn parts(pile: &Pile<'_>, layer: usize, [lower_m, upper_m]: [f64; 2]) -> usize {
    let (own, axial) = (&pile.ground.layers[layer], pile.ground.axial);
    let inside = |s: f64| pile.diameter_m(lower_m + s * (upper_m - lower_m));
    let is_prism = inside(0.25) == inside(0.75) || ignore_diameter(own, axial);
    if is_prism && are_linear(own, axial) {
        return 1;
    }
    let root = |height_m: f64| (pile.depth_m(height_m) / pile.length_m()).sqrt();
    let steps = PARTS * (root(lower_m) - root(upper_m));
    steps.ceil().clamp(2.0, PARTS) as usize
}

/// Where the springs of a layer may change their slope.
fn knees(description: &TowerDescription, pile: &Pile<'_>, layer: usize) -> Vec<Guide> {
    let rows = description.stations.len().max(description.properties.len());
    let mut knees: Vec<Guide> = (0..rows).map(Guide::Row).collect();
    if pile.ground.scour.local_m > 0.0 {
        knees.push(Guide::FullOverburden);
    }
    match &pile.ground.layers[layer].soil {
        LayerSoil::Rock(_) => knees.push(Guide::FullRock(layer)),
        LayerSoil::Table(rows) => {
            knees.extend((0..rows.len()).map(|row| Guide::TableRow(layer, row)));
        }
        LayerSoil::Sand(_) | LayerSoil::Clay(_) | LayerSoil::Elastic => {}
    }
    knees
}

impl Guide {
    /// The height that it has on a tower, m.
    pub(super) fn height_m(&self, description: &TowerDescription, pile: &Pile<'_>) -> f64 {
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
            Self::FullRock(layer) => {
                let surface_m = pile.rock_surface_m(layer);
                surface_m - GROWS_DIAMETERS * pile.diameter_m(surface_m)
            }
            Self::TableRow(layer, row) => match &layers[layer].soil {
                LayerSoil::Table(rows) => rows.get(row).map_or(f64::NAN, |row| row.height_m),
                _ => f64::NAN,
            },
        }
    }
}
