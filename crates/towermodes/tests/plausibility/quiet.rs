//! Towers that are right have no warnings.

use super::quiet;
use super::towers::{
    elliptic, floater, monopile, reference, reference_350t, reference_eccentric,
    reference_on_springs, reference_table, reference_with_machine, rich,
};
use towermodes::{
    Foundation, FoundationSprings, Inertia, Material, Properties, PropertyStation, Rna, Station,
    Tower, TowerDescription,
};
use towermodes_testing::with;

#[test]
fn the_towers_of_the_manual_are_not_warned_of() {
    let towers = [
        reference(),
        reference_350t(),
        reference_with_machine(),
        reference_eccentric(),
        reference_on_springs(),
        reference_table(1.0, 350e3),
        rich(),
        elliptic(),
        monopile(),
        floater(),
    ];
    for tower in towers {
        quiet(tower, |_| {});
    }
}

/// Numbers between 0 and 1, the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }

    /// Evenly over the powers of ten.
    fn over(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }
}

/// A steel tower of proportions that are built: 20 to 170 m high, 12 to 28 diameters high at the
/// base, cans of different walls.
fn built(random: &mut Random) -> TowerDescription {
    let height_m = random.over(20.0, 170.0);
    let base_m = height_m / random.between(12.0, 28.0);
    let top_m = base_m * random.between(0.5, 1.0);
    let slimness = random.between(80.0, 260.0);
    let cans = 2 + (random.next() * 12.0) as usize;
    let diameter = |s: f64| base_m + s * (top_m - base_m);
    let mut stations = Vec::new();
    for can in 0..cans {
        let [low, high] = [can, can + 1].map(|k| k as f64 / cans as f64);
        let wall_m = diameter(low) / slimness * random.between(0.7, 1.4);
        stations.push(Station::new(height_m * low, diameter(low), wall_m));
        stations.push(Station::new(height_m * high, diameter(high), wall_m));
    }
    TowerDescription {
        materials: vec![Material::from_poissons_ratio(
            random.between(7850.0, 8600.0),
            2.1e11,
            0.3,
        )],
        stations,
        outfitting_factor: random.between(1.0, 1.1),
        ..TowerDescription::default()
    }
}

/// With a machine of its size, whose radii of gyration are 4 to 20 % of the height.
fn with_machine(random: &mut Random, mut tower: TowerDescription) -> TowerDescription {
    let height_m = tower.stations[tower.stations.len() - 1].height_m;
    let tower_kg = Tower::new(tower.clone()).expect("a tower").mass_kg();
    let mass_kg = tower_kg * random.over(0.15, 2.0);
    let size = mass_kg * (height_m * random.between(0.04, 0.2)).powi(2);
    tower.rna = Rna {
        mass_kg,
        center_m: [-0.01 * height_m, 0.0, 0.02 * height_m],
        inertia_kg_m2: with!(Inertia, xx = size, yy = 0.6 * size, zz = 0.55 * size),
    };
    tower
}

/// On a footing or on the head of a pile: 1.5 to 50 times EI/H, a lever of one to three radii, a
/// coupling of what is below.
fn on_ground(random: &mut Random, mut tower: TowerDescription) -> TowerDescription {
    let checked = Tower::new(tower.clone()).expect("a tower");
    let bending = checked.pieces()[0].section_at(0.0).bending_n_m2.fore_aft;
    let lever_m = 0.5 * tower.stations[0].outer_diameter_m * random.between(1.0, 3.0);
    let rocking_n_m = random.over(1.5, 50.0) * bending / checked.height_m();
    let lateral_n_per_m = rocking_n_m / (lever_m * lever_m);
    tower.foundation = Foundation::Springs(FoundationSprings {
        lateral_n_per_m,
        rocking_n_m,
        coupling_n: -0.5 * lever_m * lateral_n_per_m,
        vertical_n_per_m: 3.0 * lateral_n_per_m,
        torsion_n_m: rocking_n_m,
    });
    tower
}

/// The same as a table of its sections.
fn as_table(tower: &TowerDescription) -> TowerDescription {
    let checked = Tower::new(tower.clone()).expect("a tower");
    let row = |height_m: f64, section: &towermodes::tower::Section| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: section.masses.mass_kg_per_m,
            rotary_inertia_kg_m: section.masses.rotary_inertia_kg_m,
            polar_inertia_kg_m: section.masses.polar_inertia_kg_m,
            bending_n_m2: section.bending_n_m2,
            torsion_n_m2: section.torsion_n_m2,
            axial_n: section.axial_n,
            shear_n: None,
        },
    };
    let pieces = checked.pieces().iter();
    let ends = pieces.flat_map(|p| [p.base_m, p.top_m].map(|z| row(z, &p.section_at(z))));
    TowerDescription {
        properties: ends.collect(),
        rna: tower.rna,
        foundation: tower.foundation.clone(),
        ..TowerDescription::default()
    }
}

#[test]
fn thousands_of_built_proportions_are_not_warned_of() {
    let mut random = Random(7);
    for _ in 0..1000 {
        let tower = built(&mut random);
        let tower = with_machine(&mut random, tower);
        quiet(as_table(&tower), |_| {});
        quiet(tower.clone(), |_| {});
        let tower = on_ground(&mut random, tower);
        quiet(as_table(&tower), |_| {});
        quiet(tower, |_| {});
    }
}
