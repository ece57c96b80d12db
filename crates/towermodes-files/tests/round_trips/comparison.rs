//! Towers beside each other by what they compute to.

use towermodes::{
    Family, FloatingPlatform, Foundation, Method, Options, Rna, Shear, Solution, Tower,
    TowerDescription, solve,
};

use super::formats::tower;

fn solution(tower: &Tower, modes: usize, rotary_inertia: bool) -> Solution {
    let options = Options {
        method: Method::Spectral,
        modes,
        points: 2,
        rotary_inertia,
        ..Options::default()
    };
    solve(tower, &options).expect("modes")
}

/// The eight lowest frequencies, Hz.
pub fn frequencies_hz(tower: &Tower) -> Vec<f64> {
    let solution = solution(tower, 8, true);
    let modes = solution.modes.iter();
    modes.map(|mode| mode.frequency_hz).collect()
}

/// The first two bending frequencies of each plane of a beam without rotary inertia, Hz.
pub fn bending_hz(tower: &Tower) -> [f64; 4] {
    let solution = solution(tower, 16, false);
    let of = |family, order| {
        let mode = solution.mode(family, order).expect("a mode");
        mode.frequency_hz
    };
    [
        of(Family::ForeAft, 1),
        of(Family::ForeAft, 2),
        of(Family::SideSide, 1),
        of(Family::SideSide, 2),
    ]
}

/// The largest relative difference.
pub fn largest_difference(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len());
    let pairs = found.iter().zip(expected);
    let off = pairs.map(|(found, expected)| (found / expected - 1.0).abs());
    off.fold(0.0, |worst, off| {
        if off > worst || off.is_nan() {
            off
        } else {
            worst
        }
    })
}

#[track_caller]
pub fn assert_near(found: f64, expected: f64, share: f64, what: &str) {
    let off = largest_difference(&[found], &[expected]);
    assert!(off <= share, "{what}: {found} instead of {expected}");
}

/// The same tower, clamped and alone, as ElastoDyn's tower files have it: tubes or table with
/// masses, no shear, nothing around.
pub fn alone(description: &TowerDescription) -> TowerDescription {
    let mut alone = TowerDescription {
        rna: Rna::default(),
        foundation: Foundation::Clamped,
        ..in_the_air(description)
    };
    for mass in &mut alone.point_masses {
        mass.inertia_kg_m2 = Default::default();
    }
    alone
}

/// Clamped and without what windIO has no place for.
pub fn in_the_air(description: &TowerDescription) -> TowerDescription {
    let mut reduced = TowerDescription {
        foundation: Foundation::Clamped,
        soil: Vec::new(),
        added_mass: Vec::new(),
        water: None,
        wires: Vec::new(),
        ..without_shear_and_weights(description)
    };
    for mass in &mut reduced.point_masses {
        mass.inertia_kg_m2 = Default::default();
    }
    reduced
}

/// What BModes has no place for.
pub fn without_shear_and_weights(description: &TowerDescription) -> TowerDescription {
    let mut reduced = TowerDescription {
        shear: Shear::Rigid,
        gravity_m_per_s2: 0.0,
        ..description.clone()
    };
    for row in &mut reduced.properties {
        row.properties.shear_n = None;
    }
    reduced
}

/// What the weights of a platform and all that stands on it do to its rotations, N m: −g Σ m (z − z
/// of the surface, which the buoyancy's part in the hydrostatic stiffness is about), by Simpson's
/// rule over tubes that are smooth between stations.
pub fn weights_n_m(description: &TowerDescription, platform: &FloatingPlatform) -> f64 {
    let tower = tower(description);
    let surface_m = platform.hydrostatic.height_m;
    let mut moment_kg_m = 0.0;
    for piece in tower.pieces() {
        let steps = 200;
        let h_m = piece.length_m() / f64::from(steps);
        for k in 0..=steps {
            let height_m = (piece.base_m + f64::from(k) * h_m).min(piece.top_m);
            let weight = match k {
                0 => 1.0,
                _ if k == steps => 1.0,
                _ if k % 2 == 1 => 4.0,
                _ => 2.0,
            };
            let density = piece.section_at(height_m).masses.mass_kg_per_m;
            moment_kg_m += weight * h_m / 3.0 * density * (height_m - surface_m);
        }
    }
    let rna = &description.rna;
    moment_kg_m += rna.mass_kg * (tower.top_m() + rna.center_m[2] - surface_m);
    for mass in &description.point_masses {
        moment_kg_m += mass.mass_kg * (mass.height_m - surface_m);
    }
    moment_kg_m += platform.mass_kg * (platform.center_m[2] - surface_m);
    -description.gravity_m_per_s2 * moment_kg_m
}
