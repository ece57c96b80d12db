//! The classes of random towers.

use towermodes::{
    Foundation, FoundationSprings, Inertia, Material, Options, Planes, PointMass, Properties,
    PropertyStation, Rna, Shear, Station, Tower, TowerDescription, solve,
};

use super::features;
use super::seed::Seed;
use crate::towers::floater;

/// A class of random towers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// One tapered tube.
    Plain,
    /// 8 to 40 cans with walls of their own and flanges between them.
    Cans,
    /// Steps in diameter and wall.
    Steps,
    /// Single cones to 100:1, either end up, with little on top.
    Cones,
    /// A machine beside the axis, so that all motions are coupled.
    Eccentric,
    /// On soft springs.
    Soft,
    /// A pile in layers of soil.
    Soil,
    /// In water, some flooded, some with a table of added mass.
    Water,
    /// Something narrow: 5 mm to 1 m of the height where one quantity is much larger or smaller.
    Narrow,
    /// Weights within 0.01 % to 30 % of buckling.
    Buckling,
    /// On a floating platform.
    Floating,
    /// With shear deformation.
    Shear,
    /// Tables of properties whose planes differ.
    Tables,
}

impl Class {
    /// All of them.
    pub const ALL: [Self; 13] = [
        Self::Plain,
        Self::Cans,
        Self::Steps,
        Self::Cones,
        Self::Eccentric,
        Self::Soft,
        Self::Soil,
        Self::Water,
        Self::Narrow,
        Self::Buckling,
        Self::Floating,
        Self::Shear,
        Self::Tables,
    ];

    /// Its name in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Cans => "many cans",
            Self::Steps => "steps",
            Self::Cones => "cones to 100:1",
            Self::Eccentric => "eccentric machine",
            Self::Soft => "soft springs",
            Self::Soil => "soil",
            Self::Water => "water",
            Self::Narrow => "narrow features",
            Self::Buckling => "near buckling",
            Self::Floating => "floating",
            Self::Shear => "shear",
            Self::Tables => "tables",
        }
    }

    /// The tower of a number.
    ///
    /// # Panics
    /// If the tower cannot be: the classes make only valid ones.
    pub fn tower(self, number: u64) -> Tower {
        let description = self.description(number);
        Tower::new(description).expect("classes make valid towers")
    }

    /// What the tower of a number is.
    pub fn description(self, number: u64) -> TowerDescription {
        // Each class has its own numbers.
        let mut seed = Seed::new(number << 8 | self as u64);
        let seed = &mut seed;
        match self {
            Self::Plain => plain(seed),
            Self::Cans => cans(seed),
            Self::Steps => steps(seed),
            Self::Cones => cone(seed),
            Self::Eccentric => eccentric(seed),
            Self::Soft => soft(seed),
            Self::Soil => features::in_soil(plain(seed), seed),
            Self::Water => features::in_water(steps(seed), seed),
            Self::Narrow => features::with_something_narrow(seed),
            Self::Buckling => near_buckling(seed),
            Self::Floating => floating(seed),
            Self::Shear => TowerDescription {
                shear: Shear::Cowper,
                ..steps(seed)
            },
            Self::Tables => table(seed),
        }
    }
}

pub(super) fn steel() -> Material {
    Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)
}

/// A machine of a mass (kg), as large as turbines' are.
fn machine(mass_kg: f64, seed: &mut Seed) -> Rna {
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

/// One tapered tube with a machine.
pub(super) fn plain(seed: &mut Seed) -> TowerDescription {
    let height_m = seed.between(40.0, 160.0);
    let diameter_m = height_m / seed.between(12.0, 25.0);
    let wall_m = diameter_m / seed.between(80.0, 250.0);
    let taper = seed.between(0.4, 1.0);
    let thinning = seed.between(0.4, 1.0);
    let tower_kg = 8500.0 * 2.5 * diameter_m * wall_m * height_m;
    let machine_kg = tower_kg * seed.log_between(0.1, 3.0);
    TowerDescription {
        materials: vec![steel()],
        stations: vec![
            Station::new(0.0, diameter_m, wall_m),
            Station::new(height_m, taper * diameter_m, thinning * taper * wall_m),
        ],
        rna: machine(machine_kg, seed),
        ..TowerDescription::default()
    }
}

/// The diameter and the wall of a tapered tube at a share of its height, m.
fn along(description: &TowerDescription, share: f64) -> (f64, f64) {
    let [base, top] = [
        &description.stations[0],
        description.stations.last().expect("a tower has stations"),
    ];
    let blend = |a: f64, b: f64| a + share * (b - a);
    (
        blend(base.outer_diameter_m, top.outer_diameter_m),
        blend(base.wall_thickness_m, top.wall_thickness_m),
    )
}

fn cans(seed: &mut Seed) -> TowerDescription {
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

fn steps(seed: &mut Seed) -> TowerDescription {
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

fn cone(seed: &mut Seed) -> TowerDescription {
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

fn eccentric(seed: &mut Seed) -> TowerDescription {
    let mut tower = if seed.chance(0.5) {
        plain(seed)
    } else {
        steps(seed)
    };
    tower.rna.center_m[0] = seed.between(-3.0, 3.0);
    tower.rna.center_m[1] = seed.between(-1.0, 1.0);
    tower.rna.inertia_kg_m2.xz = 0.05 * tower.rna.inertia_kg_m2.xx;
    tower
}

fn soft(seed: &mut Seed) -> TowerDescription {
    let tower = steps(seed);
    let softer = seed.log_between(1e-3, 10.0);
    TowerDescription {
        foundation: Foundation::Springs(FoundationSprings {
            lateral_n_per_m: softer * 2e9,
            rocking_n_m: softer * 1e11,
            coupling_n: if seed.chance(0.5) { -softer * 3e9 } else { 0.0 },
            vertical_n_per_m: softer * 1e10,
            torsion_n_m: softer * 1e11,
        }),
        ..tower
    }
}

/// Gravity so strong that the weights are within a little of what the tower bears.
fn near_buckling(seed: &mut Seed) -> TowerDescription {
    let pressed = TowerDescription {
        gravity_m_per_s2: 9.81,
        ..if seed.chance(0.5) {
            plain(seed)
        } else {
            steps(seed)
        }
    };
    let beyond = seed.log_between(1e-4, 0.3);
    let options = Options {
        method: towermodes::Method::Spectral,
        modes: 1,
        points: 2,
        ..Options::default()
    };
    let tower = Tower::new(pressed.clone()).expect("a valid tower");
    let solution = solve(&tower, &options).expect("a tower that stands");
    let factor = solution.buckling_load_factor.expect("it carries weights");
    TowerDescription {
        gravity_m_per_s2: 9.81 * factor / (1.0 + beyond),
        ..pressed
    }
}

fn floating(seed: &mut Seed) -> TowerDescription {
    let mut tower = floater();
    let Foundation::Floating(platform) = &mut tower.foundation else {
        return tower;
    };
    platform.mass_kg *= seed.between(0.8, 1.3);
    for i in 0..6 {
        platform.mooring.matrix[i][i] *= seed.between(1.0, 3.0);
    }
    let top_m = 10.0 + seed.between(50.0, 95.0);
    let diameter_m = seed.between(5.0, 8.0);
    tower.stations = vec![
        Station::new(10.0, diameter_m, diameter_m / 200.0),
        Station::new(top_m, 0.6 * diameter_m, diameter_m / 300.0),
    ];
    if seed.chance(0.5) {
        let kink_m = 10.0 + (top_m - 10.0) * seed.between(0.2, 0.8);
        let kink = Station::new(kink_m, 0.9 * diameter_m, diameter_m / 230.0);
        tower.stations.insert(1, kink);
    }
    tower
}

/// A table of properties of a tube that is a little wider in one plane.
pub(super) fn table(seed: &mut Seed) -> TowerDescription {
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
