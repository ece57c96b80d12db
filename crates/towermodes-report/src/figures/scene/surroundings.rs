//! Ground, soil and water as blocks around the tower.

use towermodes::{Foundation, Tower, TowerDescription};

use super::solids::block;
use super::{Body, HALF_SIDE, Substance};
use crate::figures::tower::{ground_m, keel_m, platform, surface_m, water_m};

/// Thickness of ground of which only the surface matters, as a fraction of the tower's height.
const SLAB: f64 = 0.02;
/// Depth of water below a platform's keel, as a fraction of the tower's height.
const BELOW_KEEL: f64 = 0.08;
/// Half the side of the water around a platform, as a fraction of the tower's height.
const SEA: f64 = 0.5;

/// The ground: soil with springs, the seabed, or the ground that the tower is clamped to.
pub(super) fn ground(description: &TowerDescription, tower: &Tower) -> Vec<Body> {
    let (height_m, base_m) = (tower.height_m(), tower.base_m());
    let half_m = HALF_SIDE * height_m;
    let slab_m = SLAB * height_m;
    let rows = description.soil.iter().flatten();
    let lowest_m = rows.map(|row| row.height_m).reduce(f64::min);
    if let (Some(lowest_m), Some(surface_m)) = (lowest_m, ground_m(description, tower)) {
        let low_m = lowest_m.min(base_m);
        return vec![block(
            Substance::Soil,
            half_m,
            [low_m, surface_m.max(low_m + slab_m)],
        )];
    }
    let is_held_below =
        matches!(description.foundation, Foundation::Clamped) || tower.base().is_clamped();
    let top_m = match (ground_m(description, tower), is_held_below) {
        (Some(bed_m), _) => bed_m,
        (None, true) => base_m,
        (None, false) => return Vec::new(),
    };
    vec![block(Substance::Ground, half_m, [top_m - slab_m, top_m])]
}

/// Water from the bed, or from below the keel of a platform, to its surface.
pub(super) fn water(description: &TowerDescription, tower: &Tower) -> Option<Body> {
    let level_m = water_m(description)?;
    let floats = platform(description).filter(|platform| surface_m(platform).is_some());
    let low_m = match floats {
        Some(platform) => keel_m(platform, tower) - BELOW_KEEL * tower.height_m(),
        None => ground_m(description, tower).unwrap_or(tower.base_m()),
    };
    let is_near = (level_m - tower.top_m()).abs() < 2.0 * tower.height_m();
    // Moorings end in the water, and the ground reaches beyond it.
    let half = if floats.is_some() {
        SEA
    } else {
        0.96 * HALF_SIDE
    };
    let half_m = half * tower.height_m();
    (low_m < level_m && is_near).then(|| block(Substance::Water, half_m, [low_m, level_m]))
}
