//! The classes of random towers.

use towermodes::{
    Foundation, FoundationSprings, Options, Shear, Station, Tower, TowerDescription, solve,
};

use super::features;
use super::seed::Seed;
use super::tubes::{cans, cone, plain, property_table, steps};
use towermodes_verify::towers::floater;

/// A class of random towers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// One tapered tube.
    Plain,
    /// 8 to 40 cans with different wall thicknesses, with flanges between them.
    Cans,
    /// Steps in diameter and wall.
    Steps,
    /// Single cones with a taper of up to 100:1, upright or inverted, with a small top mass.
    Cones,
    /// A rotor-nacelle assembly whose centre of mass is away from the tower axis, which couples all
    /// motions.
    Eccentric,
    /// On soft springs.
    Soft,
    /// A pile in layers of soil.
    Soil,
    /// In water, some flooded, some with a table of added mass.
    Water,
    /// A narrow feature: over 5 mm to 1 m of the height one quantity is much larger or smaller than
    /// elsewhere.
    Narrow,
    /// Gravity loads 0.01 % to 30 % below buckling.
    Buckling,
    /// On a floating platform.
    Floating,
    /// With shear deformation.
    Shear,
    /// Tables of properties whose planes differ.
    Tables,
}

impl Class {
    /// All classes.
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

    /// The name of the class in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Plain => "plain",
            Self::Cans => "many cans",
            Self::Steps => "steps",
            Self::Cones => "cones to 100:1",
            Self::Eccentric => "eccentric RNA",
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

    /// The random tower with this number.
    ///
    /// # Panics
    /// Never: all descriptions of the classes are valid.
    pub fn tower(self, number: u64) -> Tower {
        let description = self.description(number);
        Tower::new(description).expect("classes make valid towers")
    }

    /// The description of the random tower with this number.
    pub fn description(self, number: u64) -> TowerDescription {
        // Each class has a random sequence of its own.
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
            Self::Tables => property_table(seed),
        }
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

/// A tower with an acceleration of gravity slightly below the one at which it buckles.
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
    let solution = solve(&tower, &options).expect("a stable tower");
    let factor = solution
        .buckling_load_factor
        .expect("a tower under gravity");
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
