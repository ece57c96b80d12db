//! The comparison of two towers.

use super::bare::bare;
use super::columns::{Columns, HeightRange, SAME_HEIGHT_M, is_same_height, tip_flexibility};
use super::compared::{AgreementLimits, Compared};
use super::frequencies::{ComparedFrequency, frequencies};
use super::heights::Heights;
use super::parts::{Described, compared_parts};
use super::{Agreement, AgreementError, WhichTower};
use crate::verdict::Verdict;
use towermodes::tower::{Foundation, Planes, PointMass, Tower, TowerDescription};

/// Compares two descriptions of the same tower.
///
/// Mass per length and bending stiffness are averages over a hundredth of the common height. The
/// frequencies are those of the reference beam solution (spectral elements).
///
/// # Errors
/// [`AgreementError`]: a description is invalid, the towers have no common height, or a tower
/// cannot be solved.
///
/// # Example
/// See the [crate's front page](crate).
pub fn agree(
    first: &TowerDescription,
    second: &TowerDescription,
    limits: &AgreementLimits,
) -> Result<Agreement, AgreementError> {
    let pair = Pair::new([first, second])?;
    let columns = pair.columns();
    let heights = Heights {
        columns: columns.each_ref(),
        overlap: pair.overlap,
        limits: *limits,
    };
    let stations_m = pair.towers.iter().flat_map(Tower::station_heights_m);
    let (largest_mass, largest_bending) = heights.largest(&stations_m.collect::<Vec<_>>());
    let (fore_aft, side_side) = (largest_bending.fore_aft, largest_bending.side_side);
    let furthest_m = [largest_mass, fore_aft, side_side].map(|largest| largest.height_m);
    let [mass_kg, point_masses_kg, center_of_mass_m] = pair.masses(&columns, limits.mass);
    let [first_range, second_range] = pair.ranges;
    let agreement = Agreement {
        verdict: Verdict::Pass,
        first_range,
        second_range,
        overlap: pair.overlap,
        shift_m: pair.shift_m(),
        window_m: heights.window_m(),
        mass_kg,
        point_masses_kg,
        center_of_mass_m,
        tip_flexibility_m_per_n: pair.tip_flexibility(limits.stiffness),
        largest_mass,
        largest_bending,
        rows: heights.rows(&furthest_m),
        parts: compared_parts(pair.described(), limits),
        frequencies_bare: pair.frequencies_bare(limits.frequency)?,
        frequencies_as_given: pair.frequencies_as_given(limits.frequency)?,
    };
    Ok(Agreement {
        verdict: agreement.worst(),
        ..agreement
    })
}

/// Two towers and their common heights.
struct Pair<'a> {
    descriptions: [&'a TowerDescription; 2],
    towers: [Tower; 2],
    ranges: [HeightRange; 2],
    overlap: HeightRange,
}

impl<'a> Pair<'a> {
    fn new(descriptions: [&'a TowerDescription; 2]) -> Result<Self, AgreementError> {
        let towers = both(descriptions.map(TowerDescription::clone))?;
        let ranges = towers.each_ref().map(HeightRange::of);
        let overlap = ranges[0].and(&ranges[1]);
        if overlap.length_m() <= SAME_HEIGHT_M {
            return Err(AgreementError::NothingShared { ranges });
        }
        Ok(Self {
            descriptions,
            towers,
            ranges,
            overlap,
        })
    }

    fn described(&self) -> [Described<'_>; 2] {
        [0, 1].map(|i| Described {
            description: self.descriptions[i],
            tower: &self.towers[i],
        })
    }

    fn point_masses(&self) -> [&'a [PointMass]; 2] {
        self.descriptions
            .map(|description| description.point_masses.as_slice())
    }

    fn columns(&self) -> [Columns<'_>; 2] {
        let masses = self.point_masses();
        [0, 1].map(|i| Columns::new(&self.towers[i], masses[i], self.overlap.base_m))
    }

    /// The masses over the overlap; point masses as fractions of the first mass; height of the
    /// centre of mass as a fraction of the length.
    fn masses(&self, columns: &[Columns<'_>; 2], limit: f64) -> [Compared; 3] {
        let sums = columns.each_ref().map(|columns| columns.mass(self.overlap));
        let [kg, other_kg] = sums.map(|(kg, _)| kg);
        let [center_m, other_center_m] = sums.map(|(kg, kg_m)| self.overlap.base_m + kg_m / kg);
        let [attached_kg, other_attached_kg] = self.point_masses_kg();
        [
            Compared::ratio(kg, other_kg, limit),
            Compared::on_scale(attached_kg, other_attached_kg, kg, limit),
            Compared::on_scale(center_m, other_center_m, self.overlap.length_m(), limit),
        ]
    }

    fn tip_flexibility(&self, limit: f64) -> Planes<Compared> {
        let towers = self.towers.each_ref();
        let [first, second] = towers.map(|tower| tip_flexibility(tower, self.overlap));
        first.zip(second, |first, second| {
            Compared::ratio(first, second, limit)
        })
    }

    /// The point masses of each tower on the overlap, kg.
    fn point_masses_kg(&self) -> [f64; 2] {
        self.point_masses().map(|masses| {
            let shared = masses.iter().filter(|m| self.overlap.holds(m.height_m));
            shared.map(|mass| mass.mass_kg).sum()
        })
    }

    /// The height of the second tower above the first, if both are equally long.
    fn shift_m(&self) -> Option<f64> {
        let [first, second] = &self.ranges;
        let shift_m = second.base_m - first.base_m;
        let is_as_long = is_same_height(first.length_m(), second.length_m());
        (is_as_long && !is_same_height(shift_m, 0.0)).then_some(shift_m)
    }

    /// The frequencies without the quantities that the files of some programs do not contain.
    fn frequencies_bare(&self, limit: f64) -> Result<Vec<ComparedFrequency>, AgreementError> {
        let masses = self.point_masses();
        let towers = both([0, 1].map(|i| bare(&self.towers[i], masses[i], self.overlap)))?;
        frequencies(towers.each_ref(), false, limit)
    }

    /// The frequencies with RNA, foundation and environment, if a description has them.
    fn frequencies_as_given(&self, limit: f64) -> Result<Vec<ComparedFrequency>, AgreementError> {
        if !self.descriptions.into_iter().any(is_more_than_bare) {
            return Ok(Vec::new());
        }
        frequencies(self.towers.each_ref(), true, limit)
    }
}

/// The towers of two descriptions.
fn both([first, second]: [TowerDescription; 2]) -> Result<[Tower; 2], AgreementError> {
    let tower = |description, which| {
        Tower::new(description).map_err(|error| AgreementError::Tower { which, error })
    };
    Ok([
        tower(first, WhichTower::First)?,
        tower(second, WhichTower::Second)?,
    ])
}

/// Whether the description contains more than a clamped wall with point masses.
fn is_more_than_bare(description: &TowerDescription) -> bool {
    description.rna.mass_kg != 0.0
        || description.foundation != Foundation::Clamped
        || description.has_soil()
        || !description.added_mass.is_empty()
        || description.water.is_some()
        || !description.wires.is_empty()
        || description.gravity_m_per_s2 != 0.0
}
