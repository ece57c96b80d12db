//! Names of modes along random paths: towers whose rotor-nacelle assembly couples all motions, all
//! of whose numbers change at once in small steps.
//!
//! `cargo run --release -p towermodes-random --example name_study` counts the jumps.

use towermodes::{
    Family, Foundation, FoundationSprings, HalfSpace, Inertia, Material, ModeFrequency, Options,
    Rna, Shares, Solver, Station, Tower, TowerDescription,
};

use crate::Seed;

/// Names that are followed, from the lowest.
pub const NAMES: usize = 10;
/// Modes that are solved for: above the window of every name that is followed.
const MODES: usize = 16;
/// A smaller change of a frequency (its logarithm) in one step is no jump.
const JUMP: f64 = 0.01;
/// Jumps are located to 2⁻¹⁷ of a step.
const BISECTIONS: usize = 17;
/// A path is followed to its end with the first of its jumps.
const MOST_JUMPS: usize = 12;

/// A path of towers.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    number: u64,
    ends: [Numbers; 2],
}

/// What varies along a path.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Numbers {
    /// Logarithms: height, diameters, walls, mass, three radii of gyration, stiffness of the soil.
    logarithms: [f64; 10],
    /// Centre of the assembly over the height of the tower.
    center: [f64; 3],
}

impl Numbers {
    fn random(seed: &mut Seed) -> Self {
        let ranges = [
            (50.0, 130.0),
            (3.0, 8.0),
            (2.0, 5.0),
            (0.015, 0.06),
            (0.01, 0.04),
            (5e4, 1e6),
            (0.02, 0.15),
            (0.02, 0.15),
            (0.02, 0.15),
            (3e7, 3e9),
        ];
        Self {
            logarithms: ranges.map(|(low, high)| seed.log_between(low, high).ln()),
            center: [0.06, 0.06, 0.03].map(|most| seed.between(-most, most)),
        }
    }

    fn between(&self, other: &Self, t: f64) -> Self {
        let mixed = |a: f64, b: f64| (1.0 - t) * a + t * b;
        Self {
            logarithms: std::array::from_fn(|i| mixed(self.logarithms[i], other.logarithms[i])),
            center: std::array::from_fn(|i| mixed(self.center[i], other.center[i])),
        }
    }
}

impl Path {
    /// The path of a number: clamped towers, towers on springs, on soil, and towers with a heavy
    /// assembly in turn.
    pub fn new(number: u64) -> Self {
        let mut seed = Seed::new(number);
        let ends = [Numbers::random(&mut seed), Numbers::random(&mut seed)];
        Self { number, ends }
    }

    /// The tower at 0 to 1 along the path.
    fn tower(&self, t: f64) -> Tower {
        let Numbers { logarithms, center } = self.ends[0].between(&self.ends[1], t);
        let [
            height_m,
            base_m,
            top_m,
            base_wall_m,
            top_wall_m,
            mass_kg,
            x,
            y,
            z,
            soil_pa,
        ] = logarithms.map(f64::exp);
        let mass_kg = if self.number % 4 == 3 { 10.0 } else { 1.0 } * mass_kg;
        let moment = |a: f64, b: f64| mass_kg * height_m * height_m * (a * a + b * b);
        let description = TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![
                Station::new(0.0, base_m, base_wall_m),
                Station::new(height_m, top_m, top_wall_m),
            ],
            rna: Rna {
                center_m: center.map(|part| part * height_m),
                inertia_kg_m2: Inertia {
                    xx: moment(y, z),
                    yy: moment(x, z),
                    zz: moment(x, y),
                    ..Inertia::default()
                },
                ..Rna::point(mass_kg)
            },
            foundation: match self.number % 4 {
                1 => Foundation::Springs(FoundationSprings {
                    lateral_n_per_m: 5.0 * soil_pa,
                    rocking_n_m: 500.0 * soil_pa,
                    ..FoundationSprings::RIGID
                }),
                2 => Foundation::HalfSpace(HalfSpace {
                    radius_m: 1.5 * base_m,
                    shear_modulus_pa: soil_pa,
                    poissons_ratio: 0.35,
                    embedment_m: 2.0,
                }),
                _ => Foundation::Clamped,
            },
            ..TowerDescription::default()
        };
        Tower::new(description).expect("a valid tower")
    }
}

/// A rule that names modes by the shares of their families: family and order of each. The family 4
/// is none of the four motions.
pub type Rule = fn(&[Shares]) -> Vec<(usize, usize)>;

/// The rule of towermodes until 2026: the family with 60 % of the energy, or none.
pub fn by_majority(shares: &[Shares]) -> Vec<(usize, usize)> {
    let mut orders = [0; 5];
    let name = |shares: &Shares| {
        let largest = shares.largest();
        let is_clear = shares.of(largest) >= 0.6;
        let family = if is_clear { largest as usize } else { 4 };
        orders[family] += 1;
        (family, orders[family])
    };
    shares.iter().map(name).collect()
}

/// A tower on a path: its modes with their names by a rule.
#[derive(Debug, Clone)]
struct Point {
    modes: Vec<ModeFrequency>,
    names: Vec<(usize, usize)>,
}

impl Point {
    /// `None` for the names that the program gives.
    fn at(path: &Path, t: f64, rule: Option<Rule>, solver: &mut Solver) -> Self {
        let tower = path.tower(t);
        let solved = solver.frequencies(&tower);
        let modes = solved.expect("modes").modes.clone();
        let shares: Vec<Shares> = modes.iter().map(|mode| mode.shares).collect();
        let own = || {
            let name = |mode: &ModeFrequency| (mode.family as usize, mode.order);
            modes.iter().map(name).collect()
        };
        let names = rule.map_or_else(own, |rule| rule(&shares));
        Self { modes, names }
    }

    /// The frequency of a name, and its place.
    fn find(&self, name: (usize, usize)) -> Option<(usize, f64)> {
        let place = self.names.iter().position(|other| *other == name)?;
        Some((place, self.modes[place].frequency_hz))
    }

    /// C(n, f): the energy of a family in the modes up to a place.
    fn energy(&self, family: Family, places: usize) -> f64 {
        let modes = self.modes[..places].iter();
        modes.map(|mode| mode.shares.of(family)).sum()
    }

    /// The ratio of the frequencies, in logarithm, between which the j-th unit of the energy of a
    /// family lies: from C = j − 3/4 to C = j + 1/12.
    fn window(&self, (family, order): (usize, usize)) -> f64 {
        let family = Family::ALL[family];
        let reaches = |n: &usize| self.energy(family, n + 1) >= order as f64 - 0.75 - SLACK;
        let within = |n: &usize| self.energy(family, *n) <= order as f64 + 1.0 / 12.0 + SLACK;
        let places = 0..self.modes.len();
        let first = places.clone().find(reaches).unwrap_or(0);
        let last = places.rev().find(within).unwrap_or(0);
        let [low, high] = [first, last].map(|n| self.modes[n].frequency_hz);
        (high / low).ln().max(0.0)
    }
}

/// Shares can be slightly negative where masses couple motions.
const SLACK: f64 = 0.01;

/// A name whose frequency jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// Where, from 0 to 1 along the path.
    pub at: f64,
    /// How far, ln f; infinite if the name is not in the list beyond.
    pub by: f64,
    /// What the rule of the program permits there.
    pub bound: f64,
}

/// What happens to the names along a path.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// The jumps, at most the first twelve.
    pub jumps: Vec<Jump>,
    /// Among the modes followed at all points, those without one of the four motions as family.
    pub unnamed: usize,
    /// Names that a mode has twice in a list, or that are left out in it.
    pub irregular: usize,
}

/// Follows the lowest names along a path in equal steps; by the names of the program, or by a rule.
pub fn follow(path: &Path, steps: usize, rule: Option<Rule>) -> Outcome {
    let mut solver = Solver::new(Options {
        modes: MODES,
        segments: Some(12),
        ..Options::default()
    });
    let mut outcome = Outcome::default();
    let mut before = Point::at(path, 0.0, rule, &mut solver);
    for step in 1..=steps {
        let [from, to] = [step - 1, step].map(|step| step as f64 / steps as f64);
        let after = Point::at(path, to, rule, &mut solver);
        let unnamed = after.names[..NAMES]
            .iter()
            .filter(|(family, _)| *family == 4);
        outcome.unnamed += unnamed.count();
        outcome.irregular += irregular(&after.names);
        for &name in &before.names[..NAMES] {
            if outcome.jumps.len() >= MOST_JUMPS || distance(&before, &after, name) < JUMP {
                continue;
            }
            let jump = locate(path, name, [from, to], [&before, &after], rule, &mut solver);
            outcome.jumps.extend(jump);
        }
        before = after;
    }
    outcome
}

/// Names that do not follow the one before them in their family.
fn irregular(names: &[(usize, usize)]) -> usize {
    let mut orders = [0; Family::ALL.len()];
    let follows = |(family, order): &&(usize, usize)| {
        orders[*family] += 1;
        orders[*family] != *order
    };
    names.iter().filter(follows).count()
}

/// How far a name moves between two towers, ln f, if another mode has it: none of its frequencies
/// is the other's mode of the same place.
fn distance(before: &Point, after: &Point, name: (usize, usize)) -> f64 {
    match (before.find(name), after.find(name)) {
        (Some((i, _)), Some((j, _))) if i == j => 0.0,
        (Some((_, a)), Some((_, b))) => (b / a).ln().abs(),
        _ => f64::INFINITY,
    }
}

/// Halves a step towards the jump of a name; none if it vanishes.
fn locate(
    path: &Path,
    name: (usize, usize),
    [mut from, mut to]: [f64; 2],
    [before, after]: [&Point; 2],
    rule: Option<Rule>,
    solver: &mut Solver,
) -> Option<Jump> {
    let (mut before, mut after) = (before.clone(), after.clone());
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (from + to);
        let between = Point::at(path, middle, rule, solver);
        if distance(&before, &between, name) >= distance(&between, &after, name) {
            (to, after) = (middle, between);
        } else {
            (from, before) = (middle, between);
        }
        if distance(&before, &after, name) < JUMP {
            return None;
        }
    }
    Some(Jump {
        at: from,
        by: distance(&before, &after, name),
        bound: before.window(name).max(after.window(name)),
    })
}
