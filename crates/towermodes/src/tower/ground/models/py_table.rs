//! A table of points of p-y curves.

use crate::tower::ground::layer::{LayerSoil, PyRow};
use crate::tower::ground::layer_springs::{LayerSprings, Nature};
use crate::tower::ground::spot::Spot;
use crate::tower::ground::values::{Made, NoSprings, Values};

/// The secants of a table.
#[derive(Debug)]
struct Secants<'l>(&'l [PyRow]);

pub(super) fn springs<'l>(values: &mut Values<'l>) -> Made<dyn LayerSprings + 'l> {
    match &values.layer.soil {
        LayerSoil::Table(rows) => Ok(Box::new(Secants(rows))),
        _ => Err(NoSprings::OtherSoil),
    }
}

impl LayerSprings for Secants<'_> {
    fn lateral_n_per_m2(&self, spot: &Spot<'_>) -> f64 {
        secant_n_per_m2(self.0, spot.height_m)
    }

    fn nature(&self) -> Nature {
        Nature {
            is_linear: true,
            needs_weight: false,
            depends_on_edition: false,
        }
    }
}

/// The secant p/y at a height, N/m², linear between the rows.
fn secant_n_per_m2(rows: &[PyRow], height_m: f64) -> f64 {
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
