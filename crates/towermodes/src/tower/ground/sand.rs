//! Sand: the initial stiffness of p-y curves.

use super::description::{ApiEdition, Ground};
use super::layer::Sand;

/// Reference depth and diameter of Kallehave et al., m.
const REFERENCE_DEPTH_M: f64 = 2.5;
const REFERENCE_DIAMETER_M: f64 = 0.61;
/// The modulus of the loosest sand, MN/m³.
const LEAST_MN_PER_M3: f64 = 5.4;
/// Exponent of the depth of Kallehave et al. and of Sørensen et al.
const EXPONENT: f64 = 0.6;

/// The modulus k of the springs k z of API, N/m³: the given one, or that of the friction angle φ′
/// by the edition of the ground.
pub(super) fn subgrade_modulus_n_per_m3(sand: &Sand, ground: &Ground) -> f64 {
    if let Some(given) = sand.subgrade_modulus_n_per_m3 {
        return given;
    }
    let angle_deg = sand.friction_angle_deg.unwrap_or(f64::NAN);
    1e6 * match ground.edition {
        ApiEdition::Rp2Geo => table_mn_per_m3(angle_deg),
        ApiEdition::Rp2A => figure_mn_per_m3(angle_deg, ground.submerged),
    }
}

/// The table of API RP 2GEO, MN/m³ over degrees; linear between the rows.
const TABLE: [(f64, f64); 4] = [(25.0, 5.4), (30.0, 11.0), (35.0, 22.0), (40.0, 45.0)];

/// Linear in the table, and its first and last value outside. The table is for sand under water;
/// the standard has no other.
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
    // Below its minimum the parabola rises towards smaller angles, which the figure does not.
    let is_below_minimum = 2.0 * square * phi + slope < 0.0;
    // `max` would hide a value that is missing.
    match fit < LEAST_MN_PER_M3 || is_below_minimum {
        true => LEAST_MN_PER_M3,
        false => fit,
    }
}

/// k z₀ (z/z₀)^0.6 (D/D₀)^0.5 with z₀ = 2.5 m, D₀ = 0.61 m, N/m².
///
/// It corrects API's stiffness for wide piles, for which that is too soft near the surface and too
/// stiff at depth. The exponent fitted to single sites was 0.4 to 0.7.
///
/// Source: Kallehave, Le Blanc Thilsted & Liingaard, *Modification of the API p-y formulation of
/// initial stiffness of sand*, OSIG 2012, as quoted by Beuckelaers (2013).
pub(super) fn kallehave(k_n_per_m3: f64, depth_m: f64, diameter_m: f64) -> f64 {
    let depth = (depth_m / REFERENCE_DEPTH_M).max(0.0).powf(EXPONENT);
    k_n_per_m3 * REFERENCE_DEPTH_M * depth * (diameter_m / REFERENCE_DIAMETER_M).sqrt()
}

/// 50 MPa (z/1 m)^0.6 (D/1 m)^0.5 φ′^3.6 with φ′ in radians, N/m².
///
/// Much softer than Kallehave: about six times, as Beuckelaers found.
///
/// Source: Sørensen, Ibsen & Augustesen, *Effects of diameter on initial stiffness of p-y curves
/// for large-diameter piles in sand*, NUMGE 2010, as quoted by Beuckelaers (2013).
pub(super) fn sorensen(friction_angle_deg: f64, depth_m: f64, diameter_m: f64) -> f64 {
    let depth = depth_m.max(0.0).powf(EXPONENT);
    50e6 * depth * diameter_m.sqrt() * friction_angle_deg.to_radians().powf(3.6)
}
