//! Soil, water and narrow features of random towers.

use towermodes::{
    AddedMassRow, Foundation, FoundationSprings, Planes, Properties, PropertyStation, SoilRow,
    SoilStiffness, Station, TowerDescription, Water,
};

use super::seed::Seed;
use super::tubes::{plain, steel};

/// Embeds the lower 10 to 40 m of a tower in soil.
pub(super) fn in_soil(mut tower: TowerDescription, seed: &mut Seed) -> TowerDescription {
    let depth_m = seed.between(10.0, 40.0);
    for station in &mut tower.stations {
        station.height_m -= depth_m;
    }
    let base_m = tower.stations[0].height_m;
    let layers = seed.whole(1, 5);
    let heights_m = seed.heights_m(base_m, 0.0, layers);
    let mut rows: Vec<SoilRow> = Vec::new();
    let stepped = seed.chance(0.5);
    for pair in heights_m.windows(2) {
        let stiffness = stiffness(seed.log_between(3e6, 3e8));
        let below = rows.last().map_or(stiffness, |row| row.stiffness);
        rows.push(SoilRow {
            height_m: pair[0],
            stiffness: if stepped { stiffness } else { below },
        });
        rows.push(SoilRow {
            height_m: pair[1],
            stiffness,
        });
    }
    TowerDescription {
        soil: vec![rows],
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: seed.log_between(1e7, 1e9),
            rocking_n_m: seed.log_between(1e8, 1e10),
            coupling_n: 0.0,
            vertical_n_per_m: 1e10,
            torsion_n_m: 1e10,
        }),
        ..tower
    }
}

fn stiffness(transverse: f64) -> SoilStiffness {
    SoilStiffness {
        x_n_per_m2: transverse,
        y_n_per_m2: transverse,
        z_n_per_m2: 0.3 * transverse,
        torsion_n: 2.0 * transverse,
        rotation_x_n: 20.0 * transverse,
        rotation_y_n: 30.0 * transverse,
    }
}

/// Puts a tower into water.
pub(super) fn in_water(tower: TowerDescription, seed: &mut Seed) -> TowerDescription {
    let height_m = tower.stations.last().map_or(0.0, |top| top.height_m);
    let level_m = height_m * seed.between(0.1, 0.5);
    let mut added_mass = Vec::new();
    if seed.chance(0.3) {
        let row = |height_m, mass_kg_per_m| AddedMassRow {
            height_m,
            mass_kg_per_m,
        };
        let thickest = seed.log_between(1e3, 3e4);
        added_mass.push(vec![row(0.0, 0.3 * thickest), row(level_m, thickest)]);
    }
    TowerDescription {
        water: Some(Water {
            level_m,
            bed_m: seed.chance(0.5).then_some(0.3 * level_m),
            density_kg_per_m3: 1025.0,
            added_mass_coefficient: 1.0,
            flooded: seed.chance(0.5),
        }),
        added_mass,
        ..tower
    }
}

/// The number of quantities that can have a narrow feature.
const NARROW: usize = 9;

/// A tower with one quantity that is much larger or smaller over a small part of the height.
pub(super) fn with_something_narrow(seed: &mut Seed) -> TowerDescription {
    let tower = plain(seed);
    let height_m = tower.stations[1].height_m;
    let half_m = 0.5 * seed.log_between(0.005, 1.0);
    let middle_m = seed.between(0.05 * height_m, 0.95 * height_m);
    let heights_m = [middle_m - half_m, middle_m, middle_m + half_m];
    let is_step = seed.chance(0.5);
    // The value at these heights as a fraction of the largest: a step, or a triangle.
    let ends = if is_step { 1.0 } else { 0.0 };
    let profile = heights_m.into_iter().zip([ends, 1.0, ends]);
    match seed.whole(1, NARROW) {
        1 => {
            // 0.1 to 30 t in total.
            let largest = seed.log_between(1e2, 3e4) / half_m;
            let row = |(height_m, fraction)| AddedMassRow {
                height_m,
                mass_kg_per_m: fraction * largest,
            };
            TowerDescription {
                added_mass: vec![profile.map(row).collect()],
                ..tower
            }
        }
        2 => {
            let largest = seed.log_between(1e4, 1e7) / half_m;
            let row = |(height_m, fraction)| SoilRow {
                height_m,
                stiffness: stiffness(fraction * largest),
            };
            TowerDescription {
                soil: vec![profile.map(row).collect()],
                ..tower
            }
        }
        3 => narrow_wall(tower, heights_m, seed.log_between(0.2, 5.0), is_step),
        quantity => narrow_row(&tower, heights_m, quantity, is_step, seed),
    }
}

/// A wall that is thicker by a factor near a height.
fn narrow_wall(
    tower: TowerDescription,
    [lower_m, middle_m, upper_m]: [f64; 3],
    thicker: f64,
    is_step: bool,
) -> TowerDescription {
    let [base, top] = [tower.stations[0], tower.stations[1]];
    let at = |z_m: f64, factor: f64| {
        let s = (z_m - base.height_m) / (top.height_m - base.height_m);
        let blend = |a: f64, b: f64| a + s * (b - a);
        Station::new(
            z_m,
            blend(base.outer_diameter_m, top.outer_diameter_m),
            factor * blend(base.wall_thickness_m, top.wall_thickness_m),
        )
    };
    let mut stations = vec![base, at(lower_m, 1.0)];
    if is_step {
        stations.extend([at(lower_m, thicker), at(upper_m, thicker)]);
    } else {
        stations.push(at(middle_m, thicker));
    }
    stations.extend([at(upper_m, 1.0), top]);
    TowerDescription { stations, ..tower }
}

/// A table of the properties of a tube with one quantity larger or smaller near a height.
fn narrow_row(
    tower: &TowerDescription,
    [lower_m, middle_m, upper_m]: [f64; 3],
    quantity: usize,
    is_step: bool,
    seed: &mut Seed,
) -> TowerDescription {
    let top_m = tower.stations[1].height_m;
    let usual = thin_tube(&tower.stations[0]);
    let more = 1.0 + seed.log_between(0.1, 100.0) / (upper_m - lower_m).min(1.0);
    let less = seed.log_between(1e-3, 0.5);
    let odd = changed(usual, quantity, more, less);
    let row = |height_m, properties| PropertyStation {
        height_m,
        properties,
    };
    let mut properties = vec![row(0.0, usual), row(lower_m, usual)];
    if is_step {
        properties.extend([row(lower_m, odd), row(upper_m, odd)]);
    } else {
        properties.push(row(middle_m, odd));
    }
    properties.extend([row(upper_m, usual), row(top_m, usual)]);
    TowerDescription {
        properties,
        stations: Vec::new(),
        materials: Vec::new(),
        ..tower.clone()
    }
}

/// The properties of a thin steel tube.
fn thin_tube(tube: &Station) -> Properties {
    let (d, t) = (tube.outer_diameter_m, tube.wall_thickness_m);
    let area_m2 = std::f64::consts::PI * t * (d - t);
    let second_m4 = area_m2 * d * d / 8.0;
    let steel = steel();
    Properties {
        mass_kg_per_m: steel.density_kg_per_m3 * area_m2,
        rotary_inertia_kg_m: Planes::both(steel.density_kg_per_m3 * second_m4),
        polar_inertia_kg_m: 2.0 * steel.density_kg_per_m3 * second_m4,
        bending_n_m2: Planes::both(steel.youngs_modulus_pa * second_m4),
        torsion_n_m2: 2.0 * steel.shear_modulus_pa * second_m4,
        axial_n: steel.youngs_modulus_pa * area_m2,
        shear_n: None,
    }
}

/// The properties with one quantity increased or decreased by a factor.
fn changed(usual: Properties, quantity: usize, more: f64, less: f64) -> Properties {
    let mut odd = usual;
    match quantity {
        4 => odd.mass_kg_per_m *= more,
        5 => odd.bending_n_m2 = Planes::both(less * usual.bending_n_m2.fore_aft),
        6 => odd.torsion_n_m2 *= less,
        7 => odd.polar_inertia_kg_m *= 10.0 * more,
        8 => {
            odd.rotary_inertia_kg_m =
                Planes::both(10.0 * more * usual.rotary_inertia_kg_m.fore_aft);
        }
        _ => odd.axial_n *= less,
    }
    odd
}
