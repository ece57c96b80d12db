//! Heights where soil and water begin, end or change slope, on a tower and on slightly changed
//! towers.
//!
//! A front can leave the height of a station, or of another front. A border between pieces goes on
//! with the station, or with the first of the fronts; what another front covers beyond the border,
//! or leaves bare, is a sliver: a spring and a mass at the border.

use super::super::description::TowerDescription;
use super::super::model::Tower;
use super::immersion::{SpringsAndMass, fronts_m, jumps_at_fronts};
use super::piece::{Piece, Profile};

/// The borders of a tower due to soil and water.
#[derive(Debug, Clone)]
pub(crate) struct Fronts {
    /// For each border, in increasing height, the object that determines its height.
    cuts: Vec<Guide>,
    /// The border at each front, if there is one.
    of_fronts: Vec<Option<usize>>,
}

/// The object that determines the height of a border.
#[derive(Debug, Clone, Copy)]
enum Guide {
    /// A row of the tower, by its index.
    Row(usize),
    /// A front, by its index.
    Front(usize),
}

/// Soil and water beyond a border between pieces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sliver {
    /// The border: 0 for the base.
    pub(crate) border: usize,
    /// Springs against x, y, z and torsion, N/m and N m, and the mass of water, kg.
    pub(crate) springs_and_mass: SpringsAndMass,
}

/// The heights of the rows of a tower, m.
fn rows_m(description: &TowerDescription) -> impl Iterator<Item = f64> {
    let stations = description.stations.iter().map(|row| row.height_m);
    let rows = description.properties.iter().map(|row| row.height_m);
    stations.chain(rows)
}

impl Fronts {
    pub(crate) fn of(description: &TowerDescription, tower: &Tower) -> Self {
        let (base_m, top_m) = (tower.base_m(), tower.top_m());
        let fronts = fronts_m(description, base_m);
        let mut heights_m = fronts.clone();
        heights_m.retain(|height| (base_m..=top_m).contains(height));
        heights_m.sort_by(f64::total_cmp);
        heights_m.dedup();
        let place = |height: &f64| heights_m.iter().position(|cut| cut == height);
        let guide = |cut: &f64| {
            let row = rows_m(description).position(|row| row == *cut);
            let front = || fronts.iter().position(|front| front == cut).unwrap_or(0);
            row.map_or_else(|| Guide::Front(front()), Guide::Row)
        };
        Self {
            cuts: heights_m.iter().map(guide).collect(),
            of_fronts: fronts.iter().map(place).collect(),
        }
    }

    /// The borders (m) of a slightly changed tower of these pieces.
    pub(crate) fn cuts_m(&self, description: &TowerDescription, pieces: &[Piece]) -> Vec<f64> {
        if self.cuts.is_empty() {
            return Vec::new();
        }
        let base_m = pieces.first().map_or(0.0, |piece| piece.base_m);
        let fronts = fronts_m(description, base_m);
        let height = |guide: &Guide| match *guide {
            Guide::Row(row) => rows_m(description).nth(row),
            Guide::Front(front) => fronts.get(front).copied(),
        };
        let cuts = self.cuts.iter();
        cuts.map(|guide| height(guide).unwrap_or(base_m)).collect()
    }

    /// The parts of the fronts of a changed tower beyond its borders (m).
    pub(crate) fn slivers(
        &self,
        description: &TowerDescription,
        tower: &Tower,
        cuts_m: &[f64],
    ) -> Vec<Sliver> {
        let mut slivers = Vec::new();
        let (base_m, top_m) = (tower.base_m(), tower.top_m());
        let fronts = fronts_m(description, base_m);
        for (index, (front_m, cut)) in fronts.iter().zip(&self.of_fronts).enumerate() {
            let Some(cut_m) = cut.map(|cut| cuts_m[cut]) else {
                continue;
            };
            // Beyond the ends of the tower there is no soil or water.
            let length_m = front_m.clamp(base_m, top_m) - cut_m;
            if length_m == 0.0 {
                continue;
            }
            let Some(border) = tower.border_of(cut_m) else {
                continue;
            };
            let jumps = jumps_at_fronts(description, tube_at(tower, border).as_ref());
            slivers.push(Sliver {
                border,
                springs_and_mass: jumps[index].map(|jump| jump * length_m),
            });
        }
        slivers
    }
}

/// The tube at a border between pieces, if the tower consists of tubes.
fn tube_at(tower: &Tower, border: usize) -> Option<super::section::Tube> {
    let piece = tower.pieces.get(border).or(tower.pieces.last())?;
    match &piece.profile {
        Profile::Tube { base, top, .. } => Some(match border < tower.pieces.len() {
            true => *base,
            false => *top,
        }),
        Profile::Table { .. } => None,
    }
}
