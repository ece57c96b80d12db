//! Names of modes along random paths: the rotor-nacelle assembly of the towers couples all motions,
//! and all input values change simultaneously in small steps.
//!
//! `cargo run --release -p towermodes-random --example name_study` counts the jumps.

use towermodes::{
    Family, Foundation, FoundationSprings, HalfSpace, Inertia, Material, ModeFrequency, Options,
    Rna, Shares, Solver, Station, Tower, TowerDescription,
};

use crate::Seed;

/// Number of names that are followed, from the lowest mode.
pub const NAMES: usize = 10;
/// Number of computed modes: enough to cover the frequency window of every followed name.
const MODES: usize = 16;
/// A smaller change of the logarithm of a frequency in one step is no jump.
const JUMP: f64 = 0.01;
/// Jumps are located to 2⁻¹⁷ of a step.
const BISECTIONS: usize = 17;
/// Largest number of jumps of a path that are recorded.
const MOST_JUMPS: usize = 12;

/// A path of towers.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    number: u64,
    ends: [Numbers; 2],
}

/// The quantities that vary along a path.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Numbers {
    /// Logarithms of height, diameters, wall thicknesses, mass, three radii of gyration and soil
    /// stiffness.
    logarithms: [f64; 10],
    /// Centre of mass of the assembly, relative to the height of the tower.
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
    /// The path with this number: clamped towers, towers on springs, on soil, and with a heavy
    /// assembly, in turn.
    pub fn new(number: u64) -> Self {
        let mut seed = Seed::new(number);
        let ends = [Numbers::random(&mut seed), Numbers::random(&mut seed)];
        Self { number, ends }
    }

    /// The tower at the position `t` of the path, from 0 to 1.
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

/// A rule that names modes by the shares of their families. It gives family and order of each mode;
/// family 4 means none of the four motions.
pub type Rule = fn(&[Shares]) -> Vec<(usize, usize)>;

/// The rule of towermodes until 2026: the family with at least 60 % of the energy, or none.
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
    /// `rule` is `None` for the names of the program.
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

    /// The frequency of the mode with a name, and its position in the list.
    fn find(&self, name: (usize, usize)) -> Option<(usize, f64)> {
        let place = self.names.iter().position(|other| *other == name)?;
        Some((place, self.modes[place].frequency_hz))
    }

    /// C(n, f): the energy of a family in the modes up to this position of the list.
    fn energy(&self, family: Family, places: usize) -> f64 {
        let modes = self.modes[..places].iter();
        modes.map(|mode| mode.shares.of(family)).sum()
    }

    /// The logarithm of the ratio of the frequencies between which the j-th unit of the energy of a
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

/// Shares can be slightly negative if masses couple motions.
const SLACK: f64 = 0.01;

/// A name whose frequency jumps.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Jump {
    /// The position along the path, from 0 to 1.
    pub at: f64,
    /// The size of the jump, ln f; infinite if the name is not in the list after the jump.
    pub by: f64,
    /// The largest jump that the rule of the program permits at this position.
    pub bound: f64,
}

/// The behaviour of the names along a path.
#[derive(Debug, Clone, Default)]
pub struct Outcome {
    /// The jumps, at most the first twelve.
    pub jumps: Vec<Jump>,
    /// Number of modes, among those followed at all points, that have none of the four motions as
    /// family.
    pub unnamed: usize,
    /// Number of names that occur twice in a list or are skipped in it.
    pub irregular: usize,
}

/// Follows the lowest names along a path in equal steps, named by the program or by another rule.
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

/// Number of names whose order does not follow the previous order of their family.
fn irregular(names: &[(usize, usize)]) -> usize {
    let mut orders = [0; Family::ALL.len()];
    let follows = |(family, order): &&(usize, usize)| {
        orders[*family] += 1;
        orders[*family] != *order
    };
    names.iter().filter(follows).count()
}

/// The change of ln f of a name between two towers: 0 if its mode has the same position in both
/// lists, infinite if one list does not have the name.
fn distance(before: &Point, after: &Point, name: (usize, usize)) -> f64 {
    match (before.find(name), after.find(name)) {
        (Some((i, _)), Some((j, _))) if i == j => 0.0,
        (Some((_, a)), Some((_, b))) => (b / a).ln().abs(),
        _ => f64::INFINITY,
    }
}

/// Bisects a step to locate the jump of a name; none if the jump vanishes.
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
