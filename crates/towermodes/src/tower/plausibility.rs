//! Inputs that are possible but look like a slip: millimetres, tonnes, a misplaced digit.

use super::Tower;
use crate::Warning;

/// The warnings that the input alone gives rise to.
pub(super) fn plausibility(tower: &Tower) -> Vec<Warning> {
    let mut warnings = Vec::new();
    stations(tower, &mut warnings);
    if tower.height_m() > 1000.0 {
        warnings.push(Warning::TallTower {
            height_m: tower.height_m(),
        });
    }
    rna(tower, &mut warnings);
    warnings
}

/// The worst diameter and the worst wall: one warning of a kind is enough.
fn stations(tower: &Tower, warnings: &mut Vec<Warning>) {
    let stations = tower.stations();
    let largest = stations
        .iter()
        .max_by(|a, b| a.outer_diameter_m.total_cmp(&b.outer_diameter_m));
    if let Some(s) = largest.filter(|s| s.outer_diameter_m > 30.0) {
        warnings.push(Warning::LargeDiameter {
            outer_diameter_m: s.outer_diameter_m,
            height_m: s.height_m,
        });
    }
    let unusual = stations.iter().find(|s| {
        let ratio = s.wall_thickness_m / s.outer_diameter_m;
        !(1.0 / 500.0..=1.0 / 10.0).contains(&ratio)
    });
    if let Some(s) = unusual {
        warnings.push(Warning::UnusualWall {
            wall_thickness_m: s.wall_thickness_m,
            outer_diameter_m: s.outer_diameter_m,
            height_m: s.height_m,
        });
    }
    let (first, last) = (&stations[..2], &stations[stations.len() - 2..]);
    for end in [first, last] {
        if end[0].height_m == end[1].height_m {
            warnings.push(Warning::UselessStation {
                height_m: end[0].height_m,
            });
        }
    }
}

fn rna(tower: &Tower, warnings: &mut Vec<Warning>) {
    let rna = tower.rna();
    if rna.mass_kg > 5.0 * tower.mass_kg() {
        warnings.push(Warning::HeavyRna {
            rna_kg: rna.mass_kg,
            tower_kg: tower.mass_kg(),
        });
    }
    let inertia = &rna.inertia_kg_m2;
    let sum = inertia.xx + inertia.yy + inertia.zz;
    let largest_kg_m2 = inertia.xx.max(inertia.yy).max(inertia.zz);
    let others_kg_m2 = sum - largest_kg_m2;
    // A flat disc has equality; the tolerance is for rounded inputs.
    if largest_kg_m2 > others_kg_m2 * (1.0 + 1e-6) {
        warnings.push(Warning::TriangleInequality {
            largest_kg_m2,
            others_kg_m2,
        });
    }
}
