//! Random towers of tapered tubes: the basis of all classes.

use towermodes::{
    Inertia, Material, Planes, PointMass, Properties, PropertyStation, Rna, Station,
    TowerDescription,
};

use super::seed::Seed;

pub(super) fn steel() -> Material {
    Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)
}

/// A rotor-nacelle assembly of a mass (kg) with the dimensions of wind turbines.
fn rna(mass_kg: f64, seed: &mut Seed) -> Rna {
    let radius_m = seed.between(3.0, 12.0);
    let moment = mass_kg * radius_m * radius_m;
    Rna {
        mass_kg,
        center_m: [0.0, 0.0, seed.between(0.0, 4.0)],
        inertia_kg_m2: Inertia {
            xx: moment,
            yy: moment * seed.between(0.5, 0.7),
            zz: moment * seed.between(0.5, 0.7),
            ..Inertia::default()
        },
    }
}

/// One tapered tube with a rotor-nacelle assembly.
pub(super) fn plain(seed: &mut Seed) -> TowerDescription {
    let height_m = seed.between(40.0, 160.0);
    let diameter_m = height_m / seed.between(12.0, 25.0);
    let wall_m = diameter_m / seed.between(80.0, 250.0);
    let taper = seed.between(0.4, 1.0);
    let thinning = seed.between(0.4, 1.0);
    let tower_kg = 8500.0 * 2.5 * diameter_m * wall_m * height_m;
    let rna_kg = tower_kg * seed.log_between(0.1, 3.0);
    TowerDescription {
        materials: vec![steel()],
        stations: vec![
            Station::new(0.0, diameter_m, wall_m),
            Station::new(height_m, taper * diameter_m, thinning * taper * wall_m),
        ],
        rna: rna(rna_kg, seed),
        ..TowerDescription::default()
    }
}

/// The diameter and the wall thickness (m) of a tapered tube at a fraction of the height.
fn along(description: &TowerDescription, fraction: f64) -> (f64, f64) {
    let [base, top] = [
        &description.stations[0],
        description.stations.last().expect("a tower has stations"),
    ];
    let blend = |a: f64, b: f64| a + fraction * (b - a);
    (
        blend(base.outer_diameter_m, top.outer_diameter_m),
        blend(base.wall_thickness_m, top.wall_thickness_m),
    )
}

/// A tapered tube of 8 to 40 cans with different wall thicknesses and with flanges.
pub(super) fn cans(seed: &mut Seed) -> TowerDescription {
    let tube = plain(seed);
    let height_m = tube.stations[1].height_m;
    let count = seed.whole(8, 40);
    let heights_m = seed.heights_m(0.0, height_m, count);
    let mut stations = Vec::new();
    let mut point_masses = Vec::new();
    for pair in heights_m.windows(2) {
        let wall_m = along(&tube, pair[0] / height_m).1 * seed.between(0.8, 1.2);
        for z_m in [pair[0], pair[1]] {
            stations.push(Station::new(z_m, along(&tube, z_m / height_m).0, wall_m));
        }
        if seed.chance(0.2) {
            point_masses.push(PointMass {
                height_m: pair[1],
                mass_kg: seed.log_between(500.0, 10_000.0),
                ..PointMass::default()
            });
        }
    }
    TowerDescription {
        stations,
        point_masses,
        ..tube
    }
}

/// A tapered tube with 2 to 6 sections of different diameter and wall.
pub(super) fn steps(seed: &mut Seed) -> TowerDescription {
    let tube = plain(seed);
    let height_m = tube.stations[1].height_m;
    let count = seed.whole(2, 6);
    let heights_m = seed.heights_m(0.0, height_m, count);
    let mut stations = Vec::new();
    for pair in heights_m.windows(2) {
        let (wider, thicker) = (seed.between(0.7, 1.4), seed.between(0.5, 2.0));
        for z_m in [pair[0], pair[1]] {
            let (diameter_m, wall_m) = along(&tube, z_m / height_m);
            stations.push(Station::new(z_m, wider * diameter_m, thicker * wall_m));
        }
    }
    TowerDescription { stations, ..tube }
}

/// A cone with a taper of up to 100:1, upright or inverted.
pub(super) fn cone(seed: &mut Seed) -> TowerDescription {
    let ratio = seed.log_between(2.0, 100.0);
    let thinning = seed.between(0.1, 1.0);
    let mut ends = [(6.0, 0.03), (6.0 / ratio, 0.03 / ratio.powf(thinning))];
    ends[1].1 = ends[1].1.min(0.4 * ends[1].0);
    if seed.chance(0.5) {
        ends.reverse();
    }
    let station = |z_m, (diameter_m, wall_m)| Station::new(z_m, diameter_m, wall_m);
    TowerDescription {
        materials: vec![steel()],
        stations: vec![station(0.0, ends[0]), station(87.6, ends[1])],
        rna: Rna::point(seed.log_between(10.0, 1e4)),
        ..TowerDescription::default()
    }
}

/// A table of properties of a tube that is a little wider in one plane.
pub(super) fn property_table(seed: &mut Seed) -> TowerDescription {
    let tube = plain(seed);
    let height_m = tube.stations[1].height_m;
    let rows = seed.whole(1, 12);
    let heights_m = seed.heights_m(0.0, height_m, rows);
    let (wider, shears) = (seed.between(0.8, 1.25), seed.chance(0.3));
    let row = |z_m: f64| {
        let (diameter_m, wall_m) = along(&tube, z_m / height_m);
        let area_m2 = std::f64::consts::PI * wall_m * (diameter_m - wall_m);
        let second_m4 = area_m2 * diameter_m * diameter_m / 8.0;
        PropertyStation {
            height_m: z_m,
            properties: Properties {
                mass_kg_per_m: 8500.0 * area_m2 * seed.between(0.8, 1.2),
                rotary_inertia_kg_m: Planes::both(8500.0 * second_m4),
                polar_inertia_kg_m: 2.0 * 8500.0 * second_m4,
                bending_n_m2: Planes {
                    fore_aft: 2.1e11 * second_m4,
                    side_side: 2.1e11 * second_m4 * wider,
                },
                torsion_n_m2: 2.0 * 8.08e10 * second_m4,
                axial_n: 2.1e11 * area_m2,
                shear_n: shears.then_some(Planes::both(0.5 * 8.08e10 * area_m2)),
            },
        }
    };
    TowerDescription {
        properties: heights_m.into_iter().map(row).collect(),
        stations: Vec::new(),
        materials: Vec::new(),
        ..tube
    }
}
