//! Ground, soil and water as blocks around the tower.

use towermodes::Support;

use super::solids::{block, solid};
use super::{Body, HALF_SIDE, Substance};
use crate::figures::parts::Parts;

/// Thickness of the ground if only its surface matters, as a fraction of the tower height.
const SLAB: f64 = 0.02;
/// Depth of water below a platform's keel, as a fraction of the tower's height.
const BELOW_KEEL: f64 = 0.08;
/// Half the side of the water around a platform, as a fraction of the tower's height.
const SEA: f64 = 0.5;

/// Layers are cut at this depth below the lower end of the tower, as a fraction of the tower
/// height.
const BELOW_FOOT: f64 = 0.1;

/// The largest number of layers of soil.
const MOST_LAYERS: usize = 12;

/// Largest half side of a scour hole, as a fraction of the half side of the soil.
const WIDEST_HOLE: f64 = 0.9;

/// Distance to which ground and water extend around a frame, as a multiple of the frame's distance
/// from the axis.
const BESIDE: f64 = 1.25;

/// The ground: soil with springs, the seabed, or the ground that the tower is clamped to.
pub(super) fn ground(parts: &Parts<'_>) -> Vec<Body> {
    let (description, tower) = (parts.description, parts.tower);
    let (height_m, base_m) = (tower.height_m(), tower.base_m());
    let half_m = half_side_m(parts);
    let slab_m = SLAB * height_m;
    let surface_m = parts.ground_m();
    if let (Some(lowest_m), Some(surface_m)) = (lowest_soil_m(parts), surface_m) {
        let low_m = lowest_m.min(base_m);
        let surface_m = surface_m.max(low_m + slab_m);
        return soil(parts, half_m, [low_m, surface_m]);
    }
    let is_held_below =
        matches!(description.foundation.support(), Support::Clamped) || tower.base().is_clamped();
    let top_m = surface_m.or(is_held_below.then_some(base_m));
    let slab = |top_m| block(Substance::Ground, half_m, [top_m - slab_m, top_m]);
    top_m.map(slab).into_iter().collect()
}

/// A block for each layer of soil; around a hole of local scour four pieces per layer.
fn soil(parts: &Parts<'_>, half_m: f64, [low_m, surface_m]: [f64; 2]) -> Vec<Body> {
    let description = parts.description;
    let layers = description.ground.iter().flat_map(|of| &of.layers);
    let lists = description.soil.iter().filter_map(|rows| rows.first());
    let inner_m = layers.map(|layer| layer.bottom_m);
    let inner_m = inner_m.chain(lists.map(|row| row.height_m));
    let hole = parts.hole();
    let inner_m = inner_m.chain(hole.map(|hole| hole.bottom_m));
    let mut cuts_m: Vec<f64> = inner_m
        .filter(|cut_m| low_m < *cut_m && *cut_m < surface_m)
        .collect();
    cuts_m.sort_by(|a, b| b.total_cmp(a));
    cuts_m.dedup();
    cuts_m.truncate(MOST_LAYERS - 1);
    let tops_m = std::iter::once(surface_m).chain(cuts_m.iter().copied());
    let bottoms_m = cuts_m.iter().copied().chain([low_m]);
    let pieces = tops_m.zip(bottoms_m).map(|(top_m, bottom_m)| match hole {
        Some(hole) if bottom_m >= hole.bottom_m => {
            let radius_m = parts.radius_m(hole.bottom_m);
            let inside_m = [bottom_m, top_m].map(|height_m| {
                let reach_m = radius_m + hole.beside_m(height_m);
                (height_m, reach_m.min(WIDEST_HOLE * half_m))
            });
            around_hole(half_m, inside_m)
        }
        _ => vec![block(Substance::Soil, half_m, [bottom_m, top_m])],
    });
    pieces.flatten().collect()
}

/// The four sides of a layer around a square hole; `inside_m` gives the half side of the hole at
/// two heights.
fn around_hole(half_m: f64, inside_m: [(f64, f64); 2]) -> Vec<Body> {
    let side = |[x, y]: [f64; 2]| {
        let corners = inside_m.into_iter().flat_map(|(height_m, inside_m)| {
            [inside_m, half_m].into_iter().flat_map(move |distance_m| {
                [-distance_m, distance_m].map(|across_m| {
                    [
                        x * distance_m - y * across_m,
                        y * distance_m + x * across_m,
                        height_m,
                    ]
                })
            })
        });
        solid(None, Substance::Soil, corners.collect())
    };
    [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.0]]
        .map(side)
        .into()
}

/// The lowest height of soil that is given by rows of springs or by layers, m.
fn lowest_soil_m(parts: &Parts<'_>) -> Option<f64> {
    let rows = parts.description.soil.iter().flatten();
    let rows_m = rows.map(|row| row.height_m);
    let deepest_m = parts.foot_m() - BELOW_FOOT * parts.tower.height_m();
    let layers = parts.description.ground.iter().flat_map(|of| &of.layers);
    let layers_m = layers.map(|layer| layer.bottom_m.max(deepest_m));
    rows_m.chain(layers_m).reduce(f64::min)
}

/// Half of the side of soil, ground and water: larger than the frame under the tower.
fn half_side_m(parts: &Parts<'_>) -> f64 {
    let of_frame_m = parts.substructure().map_or(0.0, |frame| frame.reach_m());
    (HALF_SIDE * parts.tower.height_m()).max(BESIDE * of_frame_m)
}

/// Water from the bed, or from below the keel of a platform, to its surface.
pub(super) fn water(parts: &Parts<'_>) -> Option<Body> {
    let tower = parts.tower;
    let level_m = parts.water_m()?;
    let floats = parts
        .platform()
        .filter(|platform| platform.surface_m().is_some());
    // Moorings end in the water, and the ground reaches beyond it.
    let (low_m, half_m) = match floats {
        Some(platform) => (
            platform.keel_m() - BELOW_KEEL * tower.height_m(),
            SEA * tower.height_m(),
        ),
        None => (
            parts.ground_m().unwrap_or(tower.base_m()),
            0.96 * half_side_m(parts),
        ),
    };
    let is_near = (level_m - tower.top_m()).abs() < 2.0 * tower.height_m();
    (low_m < level_m && is_near).then(|| block(Substance::Water, half_m, [low_m, level_m]))
}
