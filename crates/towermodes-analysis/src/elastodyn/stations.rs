//! The rows of a tower file: mass and bending stiffness by height, linear between the rows.

use thiserror::Error;

use super::model::{ConcentratedMass, TowerStation};
use towermodes::Plain;
use towermodes::tower::{Piece, Planes, PointMass, Section, Tower};

/// The relative error of mass and frequencies with rows chosen automatically.
const ACCURACY: f64 = 1e-6;
/// The distance of the two rows of a step as a fraction of the height, because ElastoDyn needs
/// increasing heights.
const STEP: f64 = 1e-6;
/// Cuts closer than this fraction of the height are merged.
const CLOSEST: f64 = 4.0 * STEP;
/// The largest number of rows.
pub const MAX_STATIONS: usize = 100_000;

/// The number of rows.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Rows {
    /// As many as needed for frequencies with a relative error below 1e-6, with mass and stiffness
    /// linear between the rows.
    #[default]
    Accurate,
    /// About this number, but at least as many rows as steps and kinks need.
    Count(usize),
}

/// The treatment of point masses.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PointMasses {
    /// They are listed separately from the rows.
    Listed,
    /// Each is distributed over one part of the tower, which is as long as an ElastoDyn element.
    Spread {
        /// Number of parts of the height.
        parts: usize,
    },
}

/// The rows of a tower, and its point masses.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct TowerRows {
    /// The rows, from the base to the top.
    pub stations: Vec<TowerStation>,
    /// Point masses that are not in the rows.
    pub concentrated_masses: Vec<ConcentratedMass>,
}

/// Why a tower has no rows for ElastoDyn.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
#[non_exhaustive]
pub enum RowsError {
    /// The flexible tower begins outside the tower.
    #[error("the flexible tower begins at {} m, but the tower reaches from {} m to {} m", Plain(*.from_m), Plain(*.base_m), Plain(*.top_m))]
    Outside {
        /// Height where the flexible tower would begin, m.
        from_m: f64,
        /// Base of the tower, m.
        base_m: f64,
        /// Top of the tower, m.
        top_m: f64,
    },
    /// The number of rows is too large.
    #[error("the tower would have {rows} rows, more than {MAX_STATIONS}")]
    TooMany {
        /// The number.
        rows: usize,
    },
}

/// A part of the tower over which mass and stiffness have no step and no kink, with its distributed
/// mass.
struct Part<'a> {
    piece: &'a Piece,
    base_m: f64,
    top_m: f64,
    /// Mass per length of the point masses that are distributed over it, kg/m.
    spread_kg_per_m: f64,
    /// The number of intervals between its rows.
    intervals: usize,
}

/// The rows of a tower above a height (m): mass per length of its sections, without water, and
/// bending stiffness.
///
/// # Errors
/// [`RowsError`]: the height is not on the tower, or the rows are too many.
pub fn tower_rows(
    tower: &Tower,
    from_m: f64,
    rows: Rows,
    masses: PointMasses,
) -> Result<TowerRows, RowsError> {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    if !(base_m..top_m).contains(&from_m) {
        return Err(RowsError::Outside {
            from_m,
            base_m,
            top_m,
        });
    }
    let above = tower.point_masses().iter();
    let point_masses: Vec<&PointMass> = above.filter(|m| m.height_m >= from_m).collect();
    let fraction = |height_m: f64| (height_m - from_m) / (top_m - from_m);
    let concentrated = |mass: &PointMass| ConcentratedMass {
        height_fraction: fraction(mass.height_m),
        mass_kg: mass.mass_kg,
    };
    let (listed, spread) = match masses {
        PointMasses::Listed => (point_masses, Vec::new()),
        PointMasses::Spread { parts } => {
            (Vec::new(), spread_over(&point_masses, from_m, top_m, parts))
        }
    };
    let mut parts = parts_of(tower, from_m, &spread);
    share_out(&mut parts, rows)?;
    Ok(TowerRows {
        stations: stations(&parts, fraction),
        concentrated_masses: listed.into_iter().map(concentrated).collect(),
    })
}

/// A point mass that is distributed over a part of the tower.
struct Spread {
    base_m: f64,
    top_m: f64,
    mass_kg: f64,
}

/// Distributes each mass over a part of the height whose middle is at the mass, or as near as
/// possible at an end of the tower.
fn spread_over(masses: &[&PointMass], from_m: f64, top_m: f64, parts: usize) -> Vec<Spread> {
    let whole_m = top_m - from_m;
    let length_m = whole_m / parts.max(1) as f64;
    let spread = masses.iter().map(|mass| {
        let base_m = (mass.height_m - 0.5 * length_m)
            .min(top_m - length_m)
            .max(from_m);
        Spread {
            base_m,
            top_m: (base_m + length_m).min(top_m),
            mass_kg: mass.mass_kg,
        }
    });
    spread.collect()
}

/// The heights of kinks and steps, m: the ends of pieces and of distributed masses. Heights that
/// are closer together than rows can be are replaced by their middle, so that each part is longer
/// than a step is wide and a step that was read from two rows keeps its height.
fn cuts(tower: &Tower, from_m: f64, spread: &[Spread]) -> Vec<f64> {
    let top_m = tower.top_m();
    let closest_m = CLOSEST * (top_m - from_m);
    let ends = tower.pieces().iter().map(|piece| piece.top_m);
    let spread = spread.iter().flat_map(|s| [s.base_m, s.top_m]);
    let mut all_m: Vec<f64> = ends.chain(spread).filter(|z| *z > from_m).collect();
    all_m.sort_by(f64::total_cmp);
    let mut cuts_m = vec![from_m];
    let mut from = 0;
    while from < all_m.len() {
        let first_m = all_m[from];
        let count = all_m[from..].partition_point(|z| z - first_m <= closest_m);
        let middle_m = 0.5 * (first_m + all_m[from + count - 1]);
        if middle_m - from_m > closest_m && top_m - middle_m > closest_m {
            cuts_m.push(middle_m);
        }
        from += count;
    }
    cuts_m.push(top_m);
    cuts_m
}

/// The parts between the cuts with the masses distributed over them; the total mass is exact
/// although the ends of the distributed masses are rounded.
fn parts_of<'a>(tower: &'a Tower, from_m: f64, spread: &[Spread]) -> Vec<Part<'a>> {
    let cuts_m = cuts(tower, from_m, spread);
    let nearest = |height_m: f64| {
        let above = cuts_m.partition_point(|cut| *cut < height_m);
        let above = above.clamp(1, cuts_m.len() - 1);
        let is_below = height_m - cuts_m[above - 1] < cuts_m[above] - height_m;
        if is_below { above - 1 } else { above }
    };
    // The change of the distributed mass per length at each cut, kg/m.
    let mut changes = vec![0.0; cuts_m.len()];
    for mass in spread {
        let first = nearest(mass.base_m).min(cuts_m.len() - 2);
        let last = nearest(mass.top_m).max(first + 1);
        let mass_kg_per_m = mass.mass_kg / (cuts_m[last] - cuts_m[first]);
        changes[first] += mass_kg_per_m;
        changes[last] -= mass_kg_per_m;
    }
    let mut spread_kg_per_m = 0.0;
    let pairs = cuts_m.windows(2).zip(changes);
    pairs
        .map(|(pair, change)| {
            spread_kg_per_m += change;
            Part {
                piece: tower.piece_at(0.5 * (pair[0] + pair[1])),
                base_m: pair[0],
                top_m: pair[1],
                // Sums and differences leave a rounding error.
                spread_kg_per_m: f64::max(spread_kg_per_m, 0.0),
                intervals: 1,
            }
        })
        .collect()
}

fn share_out(parts: &mut [Part<'_>], rows: Rows) -> Result<(), RowsError> {
    let whole_m: f64 = parts.iter().map(|part| part.top_m - part.base_m).sum();
    for part in &mut *parts {
        part.intervals = match rows {
            Rows::Accurate => part.accurate_intervals(),
            Rows::Count(count) => {
                let share = (part.top_m - part.base_m) / whole_m;
                let intervals = (share * count.saturating_sub(1) as f64).round();
                (intervals as usize).max(1)
            }
        };
    }
    let rows = parts
        .iter()
        .fold(1_usize, |sum, part| sum.saturating_add(part.intervals));
    if rows > MAX_STATIONS {
        return Err(RowsError::TooMany { rows });
    }
    Ok(())
}

impl Part<'_> {
    /// Equally spaced rows from the base to the top of the part.
    fn stations(&self, fraction: impl Fn(f64) -> f64) -> Vec<TowerStation> {
        let station = |k: usize| {
            let s = k as f64 / self.intervals as f64;
            let height_m = self.base_m * (1.0 - s) + self.top_m * s;
            let [mass_kg_per_m, fore_aft, side_side] = self.values_at(height_m);
            TowerStation {
                height_fraction: fraction(height_m),
                mass_kg_per_m,
                bending_n_m2: Planes {
                    fore_aft,
                    side_side,
                },
            }
        };
        (0..=self.intervals).map(station).collect()
    }

    fn values_at(&self, height_m: f64) -> [f64; 3] {
        let Section {
            masses,
            bending_n_m2,
            ..
        } = self
            .piece
            .section_at(height_m.clamp(self.piece.base_m, self.piece.top_m));
        let mass = masses.mass_kg_per_m + self.spread_kg_per_m;
        [mass, bending_n_m2.fore_aft, bending_n_m2.side_side]
    }

    /// The number of intervals for [`ACCURACY`]: linear interpolation over an interval h has the
    /// mean error h² f″/12, and a frequency is the square root of stiffness over mass.
    fn accurate_intervals(&self) -> usize {
        let [mass, fore_aft, side_side] = self.bends();
        let frequency = 0.5 * (mass + fore_aft.max(side_side));
        let relative = frequency.max(mass) / 12.0;
        // Linear except for rounding.
        if relative < 1e-9 {
            1
        } else {
            (relative / ACCURACY).sqrt().ceil() as usize
        }
    }

    /// The largest h² f″/f over the whole part, from the curvature of each quarter, because it may
    /// vary over the part.
    fn bends(&self) -> [f64; 3] {
        let values: [[f64; 3]; 5] = std::array::from_fn(|k| {
            let s = k as f64 / 4.0;
            self.values_at(self.base_m * (1.0 - s) + self.top_m * s)
        });
        std::array::from_fn(|i| {
            let bends = values.windows(3).map(|three| {
                let [below, middle, above] = [three[0][i], three[1][i], three[2][i]];
                16.0 * (below - 2.0 * middle + above).abs() / below.min(above)
            });
            bends.fold(0.0, f64::max)
        })
    }
}

/// The rows of all parts: one row between two parts, or two a little apart at a step.
fn stations(parts: &[Part<'_>], fraction: impl Fn(f64) -> f64) -> Vec<TowerStation> {
    let mut stations: Vec<TowerStation> = Vec::new();
    for part in parts {
        let mut own = part.stations(&fraction);
        if let (Some(below), Some(above)) = (stations.last_mut(), own.first_mut()) {
            if is_same(below, above) {
                own.remove(0);
            } else {
                below.height_fraction -= 0.5 * STEP;
                above.height_fraction += 0.5 * STEP;
            }
        }
        stations.extend(own);
    }
    stations
}

/// Whether there is no step between two rows at one height.
fn is_same(a: &TowerStation, b: &TowerStation) -> bool {
    let values = |s: &TowerStation| {
        let bending = s.bending_n_m2;
        [s.mass_kg_per_m, bending.fore_aft, bending.side_side]
    };
    let pairs = values(a).into_iter().zip(values(b));
    pairs
        .into_iter()
        .all(|(a, b)| (a - b).abs() <= 1e-9 * a.abs())
}
