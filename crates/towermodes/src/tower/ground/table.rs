//! A table of points of p-y curves.

use super::layer::PyRow;

/// The secant p/y at a height, N/m², linear between the rows.
pub(super) fn secant_n_per_m2(rows: &[PyRow], height_m: f64) -> f64 {
    let secant = |row: &PyRow| row.reaction_n_per_m / row.displacement_m;
    let below = rows.partition_point(|row| row.height_m >= height_m);
    let (Some(upper), lower) = (rows.get(below.saturating_sub(1)), rows.get(below)) else {
        return f64::NAN;
    };
    let Some(lower) = lower.filter(|_| below > 0) else {
        return secant(upper);
    };
    let share = (upper.height_m - height_m) / (upper.height_m - lower.height_m);
    secant(upper) + share * (secant(lower) - secant(upper))
}
