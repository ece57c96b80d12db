//! The classes of random turbines on random towers.

use std::f64::consts::PI;

use towermodes::turbine::{Generator, Hub, Turbine, TurbineDescription, TurbineError};
use towermodes::{BladeDescription, BladeSection, Inertia, RigidBody, TowerDescription};

use super::class::Class;
use super::seed::Seed;

/// A class of random turbines with a rotating rotor.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TurbineClass {
    /// 20 to 50 blade sections, as public models have.
    Many,
    /// 2 to 8 blade sections at random positions.
    Few,
    /// Blade sections whose stiffness decreases by up to 1000:1, also within one element.
    Tapered,
    /// Blades with torsional and axial flexibility, and with the centres of mass and tension away
    /// from the axis.
    Twisting,
    /// A heavy body at the blade tips, or a heavy last section.
    Tips,
    /// Four to seven blades, so that there are modes that do not move the hub.
    Blades,
    /// A tower on soft springs, under gravity, with a yaw drive.
    Soft,
    /// A tower with steps or many cans.
    Steps,
    /// On a floating platform.
    Floating,
    /// Rotors with up to four times the usual speed.
    Fast,
}

/// A turbine on its tower at a rotor speed.
#[derive(Debug, Clone)]
pub struct RandomTurbine {
    /// The tower.
    pub tower: TowerDescription,
    /// The turbine above the tower.
    pub machine: TurbineDescription,
    /// The rotor speed, rpm.
    pub speed_rpm: f64,
    /// Number of the lowest modes to compare.
    pub modes: usize,
}

impl TurbineClass {
    /// All classes.
    pub const ALL: [Self; 10] = [
        Self::Many,
        Self::Few,
        Self::Tapered,
        Self::Twisting,
        Self::Tips,
        Self::Blades,
        Self::Soft,
        Self::Steps,
        Self::Floating,
        Self::Fast,
    ];

    /// The name of the class in tables.
    pub fn name(self) -> &'static str {
        match self {
            Self::Many => "many sections",
            Self::Few => "few sections",
            Self::Tapered => "tapered blades",
            Self::Twisting => "twisting blades",
            Self::Tips => "heavy tips",
            Self::Blades => "four to seven blades",
            Self::Soft => "soft springs",
            Self::Steps => "steps in the tower",
            Self::Floating => "floating",
            Self::Fast => "fast rotors",
        }
    }

    /// The random turbine with this number.
    pub fn turbine(self, number: u64) -> RandomTurbine {
        // Each class has a random sequence of its own.
        let mut seed = Seed::new(number << 8 | 0x80 | self as u64);
        let seed = &mut seed;
        let mut tower = self.class_of_tower(seed).description(number);
        let machine = machine(self, &tower, seed);
        let tip_m = machine.blade.tip_radius_m;
        if self == Self::Soft {
            tower.gravity_m_per_s2 = 9.81;
        }
        let fastest = if self == Self::Fast { 4.0 } else { 1.1 };
        RandomTurbine {
            tower,
            speed_rpm: seed.between(0.0, fastest) * TIP_SPEED_M_PER_S / tip_m * 30.0 / PI,
            modes: seed.whole(6, 24),
            machine,
        }
    }

    fn class_of_tower(self, seed: &mut Seed) -> Class {
        match self {
            Self::Soft => Class::Soft,
            Self::Steps if seed.chance(0.5) => Class::Cans,
            Self::Steps => Class::Steps,
            Self::Floating => Class::Floating,
            _ => Class::Plain,
        }
    }
}

impl RandomTurbine {
    /// The turbine on its tower.
    ///
    /// # Errors
    /// [`TurbineError`] if the tower buckles under the weight of the turbine.
    pub fn build(&self) -> Result<Turbine, TurbineError> {
        Turbine::in_place_of_rna(self.tower.clone(), self.machine.clone())
    }
}

/// Tip speed at the highest usual rotor speed.
const TIP_SPEED_M_PER_S: f64 = 80.0;
/// The blade of the NREL 5 MW turbine: radius, mass per length and flapwise bending stiffness at
/// the root.
const USUAL: (f64, f64, f64) = (63.0, 700.0, 1.8e10);

fn machine(class: TurbineClass, tower: &TowerDescription, seed: &mut Seed) -> TurbineDescription {
    let heights_m = tower.stations.iter().map(|station| station.height_m);
    let height_m = heights_m.fold(0.0, f64::max);
    let tip_m = height_m * seed.between(0.4, 0.8);
    let size = tip_m / USUAL.0;
    // Machines lighter than usual stand on any tower.
    let mass_kg = size.powf(2.5) * seed.between(0.3, 1.0);
    let nacelle_kg = 240e3 * mass_kg;
    let moment = nacelle_kg * (4.0 * size).powi(2);
    TurbineDescription {
        nacelle: RigidBody {
            mass_kg: nacelle_kg,
            center_m: [size * seed.between(-2.0, 2.0), 0.0, 1.7 * size],
            inertia_kg_m2: Inertia::from([0.4 * moment, moment, moment, 0.0, 0.0, 0.0]),
        },
        yaw_bearing_mass_kg: if seed.chance(0.3) {
            0.05 * nacelle_kg
        } else {
            0.0
        },
        yaw_n_m_per_rad: match class == TurbineClass::Soft || seed.chance(0.3) {
            true => seed.log_between(1e8, 1e10) * mass_kg,
            false => f64::INFINITY,
        },
        overhang_m: size * if seed.chance(0.8) { -5.0 } else { 4.0 },
        tower_to_shaft_m: 2.0 * size,
        tilt_rad: seed.between(-0.12, 0.0),
        hub: Hub {
            mass_kg: 56e3 * mass_kg,
            center_m: 0.0,
            polar_inertia_kg_m2: 1.1e5 * mass_kg * size * size,
            transverse_inertia_kg_m2: if seed.chance(0.5) { 0.0 } else { 8e4 * mass_kg },
        },
        shaft_n_m_per_rad: match seed.chance(0.8) {
            true => seed.log_between(1e8, 1e10) * mass_kg,
            false => f64::INFINITY,
        },
        generator: Generator {
            inertia_kg_m2: 530.0 * mass_kg * size * size,
            gear_ratio: seed.between(50.0, 120.0),
            is_locked: seed.chance(0.5),
        },
        blades: match class {
            TurbineClass::Blades => seed.whole(4, 7),
            _ => 3,
        },
        cone_rad: seed.between(-0.08, 0.02),
        blade: blade(class, (tip_m, mass_kg / size), seed),
    }
}

/// A blade with dimensions of wind turbines.
fn blade(class: TurbineClass, (tip_m, heavier): (f64, f64), seed: &mut Seed) -> BladeDescription {
    let size = tip_m / USUAL.0;
    let count = match class {
        TurbineClass::Few | TurbineClass::Tips => seed.whole(2, 8),
        TurbineClass::Tapered => seed.whole(3, 14),
        TurbineClass::Many => seed.whole(20, 50),
        _ => seed.whole(4, 40),
    };
    let spans = seed.heights_m(0.0, 1.0, count - 1);
    let (mass, stiffness) = (USUAL.1 * heavier, USUAL.2 * heavier * size.powi(3));
    let least = match class {
        TurbineClass::Tapered => seed.log_between(1e-3, 1e-1),
        _ => 10.0_f64.powf(seed.between(-2.3, -0.7)),
    };
    let (fall, wider) = (seed.between(1.0, 2.5), seed.between(1.0, 4.0));
    let twist_rad = seed.between(0.0, 0.3);
    let twists = class == TurbineClass::Twisting;
    let section = |span: f64, seed: &mut Seed| {
        let rest = (1.0 - span).powf(fall);
        let flap_n_m2 = stiffness * (least + (1.0 - least) * rest) * seed.between(0.7, 1.4);
        let mass_kg_per_m = mass * (0.04 + 0.96 * (1.0 - span)) * seed.between(0.8, 1.2);
        let chord_m = size * (1.0 + 3.0 * (1.0 - span));
        let center_of_mass_m = if twists {
            chord_m * seed.between(-0.05, 0.05)
        } else {
            0.0
        };
        let inertia = mass_kg_per_m * chord_m * chord_m / 16.0;
        BladeSection {
            span,
            twist_rad: twist_rad * (1.0 - span),
            mass_kg_per_m,
            flap_inertia_kg_m: if twists { 0.1 * inertia } else { 0.0 },
            edge_inertia_kg_m: if twists { inertia } else { 0.0 },
            flap_n_m2,
            edge_n_m2: wider * flap_n_m2,
            torsion_n_m2: if twists {
                0.3 * flap_n_m2
            } else {
                f64::INFINITY
            },
            axial_n: if twists {
                30.0 * flap_n_m2 / (chord_m * chord_m)
            } else {
                f64::INFINITY
            },
            center_of_mass_m,
            tension_center_m: if twists {
                chord_m * seed.between(-0.03, 0.03)
            } else {
                0.0
            },
        }
    };
    let mut sections: Vec<BladeSection> = Vec::new();
    for span in &spans {
        sections.push(section(*span, seed));
    }
    let blade_kg = 0.4 * mass * tip_m;
    let mut tip = RigidBody::default();
    if class == TurbineClass::Tips {
        let tip_kg = blade_kg * seed.log_between(1e-3, 0.3);
        match seed.chance(0.5) {
            true => tip = RigidBody::point(tip_kg, [0.0; 3]),
            false => {
                let last = sections.len() - 1;
                let length_m = (spans[last] - spans[last - 1]) * tip_m;
                sections[last].mass_kg_per_m += 2.0 * tip_kg / length_m;
            }
        }
    }
    BladeDescription {
        hub_radius_m: tip_m * seed.between(0.01, 0.05),
        tip_radius_m: tip_m,
        borders: spans,
        sections,
        pitch_rad: if seed.chance(0.3) {
            seed.between(0.0, 0.5 * PI)
        } else {
            0.0
        },
        tip,
        tip_is_pulled: true,
        ..BladeDescription::default()
    }
}
