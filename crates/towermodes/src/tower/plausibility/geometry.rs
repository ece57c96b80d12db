//! Heights, diameters and wall thicknesses.

use super::Given;
use super::out_of_line::{Spike, worst};
use crate::tower::Site;
use crate::tower::Warning;
use crate::tower::{Material, Place, Station, Tower};

/// Largest usual diameter, m.
const WIDEST_M: f64 = 30.0;
/// Largest usual tower height, m.
const TALLEST_M: f64 = 1000.0;
/// Largest ratio of diameter to wall of a tube.
const THINNEST: f64 = 500.0;
/// Lowest ratio of concrete tubes and masts of small turbines.
const THICKEST: f64 = 10.0;
/// Lowest ratio of steel tubes wider than [`WIDE_M`], except flanges, which are short: built towers
/// and piles have 50 to 300.
const THICKEST_STEEL: f64 = 30.0;
/// A tube of at least this diameter is wide, m.
const WIDE_M: f64 = 1.5;
/// Metals have a Young's modulus above this, concrete and wood below, Pa.
const METAL_PA: f64 = 6e10;
/// Parts of one material that are welded to each other have diameters that differ by less than this
/// fraction of the diameter, and by less than this many walls.
const STEP: f64 = 0.1;
const STEP_WALLS: f64 = 4.0;
/// Where the wall changes by more than this factor, another structure begins, such as a tower on a
/// monopile.
const SAME_WALLS: f64 = 1.5;
/// Largest length of a flange as a fraction of its diameter.
const FLANGE: f64 = 0.5;

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    widest(tower.stations(), warnings);
    lines(tower.stations(), warnings);
    walls(tower.stations(), given.materials, warnings);
    useless_rows(tower, warnings);
    steps(tower.stations(), given.materials, warnings);
    if tower.height_m() > TALLEST_M {
        let (index, key) = (tower.station_heights_m().len() - 1, "height");
        warnings.push(Warning::TallTower {
            site: Site::at(Place::Station { index, key }),
            height_m: tower.height_m(),
        });
    }
}

fn widest(stations: &[Station], warnings: &mut Vec<Warning>) {
    let stations = stations.iter().enumerate();
    let widest =
        stations.max_by(|(_, a), (_, b)| a.outer_diameter_m.total_cmp(&b.outer_diameter_m));
    if let Some((index, s)) = widest.filter(|(_, s)| s.outer_diameter_m > WIDEST_M) {
        let key = "diameter";
        warnings.push(Warning::LargeDiameter {
            site: Site::at(Place::Station { index, key }).high(s.height_m),
            outer_diameter_m: s.outer_diameter_m,
        });
    }
}

/// The wall whose ratio is farthest outside the range of built towers.
fn walls(stations: &[Station], materials: &[Material], warnings: &mut Vec<Warning>) {
    let mut furthest: Option<(f64, Warning)> = None;
    // A row that does not fit its neighbours has a warning already.
    let has_one = |index| {
        let place = Some(Place::Station { index, key: "wall" });
        warnings.iter().any(|warning| warning.place() == place)
    };
    for (index, station) in stations.iter().enumerate() {
        let (d, t) = (station.outer_diameter_m, station.wall_thickness_m);
        let least = thickest(stations, materials, index);
        let excess = (least * t / d).max(d / t / THINNEST);
        let is_further = furthest.as_ref().is_none_or(|(most, _)| excess > *most);
        if excess <= 1.0 || !is_further || has_one(index) {
            continue;
        }
        let site = Site::at(Place::Station { index, key: "wall" }).high(station.height_m);
        let warning = Warning::UnusualWall {
            site,
            wall_thickness_m: t,
            outer_diameter_m: d,
            least,
            most: THINNEST,
        };
        furthest = Some((excess, warning));
    }
    warnings.extend(furthest.map(|(_, warning)| warning));
}

/// The lowest ratio of diameter to wall of the tube at a station.
fn thickest(stations: &[Station], materials: &[Material], index: usize) -> f64 {
    let station = &stations[index];
    let below = stations[index.saturating_sub(1)].height_m;
    let above = stations[(index + 1).min(stations.len() - 1)].height_m;
    // Between rows the wall is linear: half of the distance to each neighbour belongs to a row.
    let length_m = 0.5 * (above - below);
    let is_flange = length_m < FLANGE * station.outer_diameter_m;
    let is_metal = !is_end_of(stations, index, |material| {
        materials[material].youngs_modulus_pa <= METAL_PA
    });
    let is_wide = station.outer_diameter_m > WIDE_M;
    if is_metal && is_wide && !is_flange {
        THICKEST_STEEL
    } else {
        THICKEST
    }
}

/// Whether a station is an end of a part of the tower whose material is of a kind: a row's material
/// reaches up to the next row.
fn is_end_of(stations: &[Station], index: usize, is_of_kind: impl Fn(usize) -> bool) -> bool {
    let below = index.saturating_sub(1);
    let above = (index + 2).min(stations.len());
    let mut parts = stations[below..above].windows(2);
    parts.any(|pair| pair[0].height_m != pair[1].height_m && is_of_kind(pair[0].material))
}

/// A diameter or a wall of one row that is wrong by a power of ten.
fn lines(stations: &[Station], warnings: &mut Vec<Warning>) {
    type Column = fn(&Station) -> f64;
    let columns: [(&'static str, &'static str, Column); 2] = [
        ("diameter", "the outer diameter", |s| s.outer_diameter_m),
        ("wall", "the wall thickness", |s| s.wall_thickness_m),
    ];
    let heights_m: Vec<f64> = stations.iter().map(|s| s.height_m).collect();
    for (key, column, value) in columns {
        let values: Vec<f64> = stations.iter().map(value).collect();
        let Some((index, expected)) = worst(&heights_m, &values, Spike::PowerOfTen) else {
            continue;
        };
        let site = Site::at(Place::Station { index, key }).high(heights_m[index]);
        warnings.push(Warning::RowOutOfLine {
            site,
            column,
            unit: " m",
            value: values[index],
            expected,
        });
    }
}

/// The largest step of the outer diameter of a wide tube of metal, if nobody builds it.
fn steps(stations: &[Station], materials: &[Material], warnings: &mut Vec<Warning>) {
    let step_m = |index: usize| {
        (stations[index].outer_diameter_m - stations[index - 1].outer_diameter_m).abs()
    };
    let is_odd = |index: &usize| {
        let (below, above) = (&stations[index - 1], &stations[*index]);
        let wide_m = below.outer_diameter_m.max(above.outer_diameter_m);
        let wall_m = below.wall_thickness_m.max(above.wall_thickness_m);
        let thin_m = below.wall_thickness_m.min(above.wall_thickness_m);
        below.height_m == above.height_m
            && below.material == above.material
            && materials[above.material].youngs_modulus_pa > METAL_PA
            && wide_m > WIDE_M
            && wall_m <= SAME_WALLS * thin_m
            && step_m(*index) > (STEP * wide_m).max(STEP_WALLS * wall_m)
    };
    // Steps at the ends have a warning of their own.
    let inner = 2..stations.len().saturating_sub(1);
    let largest = inner.filter(is_odd);
    let largest = largest.max_by(|a, b| step_m(*a).total_cmp(&step_m(*b)));
    warnings.extend(largest.map(|index| {
        Warning::DiameterStep {
            site: Site::at(Place::Station {
                index,
                key: "diameter",
            })
            .high(stations[index].height_m),
            below_m: stations[index - 1].outer_diameter_m,
            above_m: stations[index].outer_diameter_m,
        }
    }));
}

/// Rows at the ends that have no length.
fn useless_rows(tower: &Tower, warnings: &mut Vec<Warning>) {
    let heights_m = tower.station_heights_m();
    let last = heights_m.len() - 1;
    for (index, neighbour) in [(0, 1), (last, last - 1)] {
        if heights_m[index] == heights_m[neighbour] {
            let site = Site::at(Place::Station {
                index,
                key: "height",
            })
            .high(heights_m[index]);
            warnings.push(Warning::UselessStation { site });
        }
    }
}
