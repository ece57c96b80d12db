//! The modulus k of sand, which several models have: the initial stiffness of the p-y curves of
//! API is k z.

use crate::tower::ground::description::{ApiEdition, Ground};
use crate::tower::ground::values::{NoSprings, Values};
use crate::tower::warning::{Ineffective, Site, Warning};

/// The modulus of the loosest sand, MN/m³.
const LEAST_MN_PER_M3: f64 = 5.4;

/// The modulus k of a layer of sand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Subgrade {
    /// k, N/m³: the given one, or that of the friction angle φ′ by the edition of the ground.
    pub(super) modulus_n_per_m3: f64,
    /// Whether k is given.
    is_given: bool,
    /// Whether the friction angle is given too; then it has no effect.
    has_both: bool,
}

impl Subgrade {
    /// From the values of a layer.
    pub(super) fn of(values: &mut Values<'_>) -> Result<Self, NoSprings> {
        let sand = values.sand()?;
        let given = values.optional("subgrade_modulus", sand.subgrade_modulus_n_per_m3);
        let angle_deg = values.optional("friction_angle", sand.friction_angle_deg);
        let by_angle = || Some(by_angle_n_per_m3(angle_deg?, values.ground));
        let modulus_n_per_m3 = given.or_else(by_angle).ok_or(NoSprings::Missing {
            key: "friction_angle",
            value: "the friction angle or the subgrade modulus",
        })?;
        Ok(Self {
            modulus_n_per_m3,
            is_given: given.is_some(),
            has_both: given.and(angle_deg).is_some(),
        })
    }

    /// Whether it depends on the edition of the standard of API.
    pub(super) fn depends_on_edition(&self) -> bool {
        !self.is_given
    }

    /// Warns if k and the friction angle are given: then the friction angle has no effect.
    pub(super) fn doubt(&self, at: &dyn Fn(&'static str) -> Site, warnings: &mut Vec<Warning>) {
        if self.has_both {
            warnings.push(Warning::NoEffect {
                site: at("friction_angle"),
                what: Ineffective::AngleBesideModulus,
            });
        }
    }
}

fn by_angle_n_per_m3(angle_deg: f64, ground: &Ground) -> f64 {
    1e6 * match ground.edition {
        ApiEdition::Rp2Geo => table_mn_per_m3(angle_deg),
        ApiEdition::Rp2A => figure_mn_per_m3(angle_deg, ground.submerged),
    }
}

/// The table of API RP 2GEO, MN/m³ over degrees; linear between the rows.
const TABLE: [(f64, f64); 4] = [(25.0, 5.4), (30.0, 11.0), (35.0, 22.0), (40.0, 45.0)];

/// Interpolates linearly in the table; outside it uses the first or the last value. The table
/// applies to sand under water; the standard contains no other table.
///
/// Source: the table as three open programs have it (5.4, 11, 22, 45).
fn table_mn_per_m3(angle_deg: f64) -> f64 {
    let row = TABLE.partition_point(|(angle, _)| *angle <= angle_deg);
    match (row.checked_sub(1).map(|below| TABLE[below]), TABLE.get(row)) {
        (None, _) if angle_deg.is_nan() => f64::NAN,
        (None, _) => TABLE[0].1,
        (Some((_, last)), None) => last,
        (Some((low_deg, low)), Some((high_deg, high))) => {
            low + (angle_deg - low_deg) / (high_deg - low_deg) * (high - low)
        }
    }
}

/// The fit to the figure of API RP 2A, MN/m³:
///
/// - below water: max(0.1978 φ′² − 10.232 φ′ + 136.82, 5.4),
/// - above water: max(0.2153 φ′² − 8.232 φ′ + 63.657, 5.4),
///
/// with 5.4 below the minimum of each parabola; the first gives 5.4 up to 28.0 degrees, the second
/// up to 28.9. Above 40 degrees, where the figure ends, its value at 40 degrees.
///
/// Source: the fit of the open program openpile to the figure.
fn figure_mn_per_m3(angle_deg: f64, submerged: bool) -> f64 {
    const LAST_DEG: f64 = 40.0;
    let phi = if angle_deg > LAST_DEG {
        LAST_DEG
    } else {
        angle_deg
    };
    let [square, slope, constant] = match submerged {
        true => [0.1978, -10.232, 136.82],
        false => [0.2153, -8.232, 63.657],
    };
    let fit = square * phi * phi + slope * phi + constant;
    // Below its minimum the parabola rises towards smaller angles, whereas the figure stays flat.
    let is_below_minimum = 2.0 * square * phi + slope < 0.0;
    // `max` would hide a missing value.
    match fit < LEAST_MN_PER_M3 || is_below_minimum {
        true => LEAST_MN_PER_M3,
        false => fit,
    }
}
