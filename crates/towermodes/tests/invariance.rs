//! Laws that hold for every tower.

use crate::towers;

use proptest::prelude::*;
use towermodes::{
    Inertia, Material, Options, PointMass, Rna, Shear, Solution, Station, Tower, TowerDescription,
    solve,
};
use towermodes_testing::with;
use towers::rich;

fn solution(description: &TowerDescription, modes: usize) -> Solution {
    let tower = Tower::new(description.clone()).expect("a valid tower");
    // A shape has a kink at each point mass, and may peak there.
    let masses = description.point_masses.iter();
    let heights_m = masses.map(|mass| mass.height_m).collect();
    let options = with!(Options, segments = Some(40), modes, heights_m);
    solve(&tower, &options).expect("solvable")
}

fn frequencies(description: &TowerDescription) -> Vec<f64> {
    solution(description, 10)
        .modes
        .iter()
        .map(|m| m.frequency_hz)
        .collect()
}

/// Towers of two to five tapered pieces, with shear, machine and platforms.
fn any_tower() -> impl Strategy<Value = TowerDescription> {
    let station = (3.0..40.0, 2.0..8.0, 0.01..0.06);
    (
        prop::collection::vec(station, 2..6),
        0.0..500e3,
        0.0..5.0,
        prop::bool::ANY,
        prop::collection::vec((0.0..1.0, 0.0..30e3), 0..3),
        1e10..3e11,
        0.0..0.45,
        1000.0..9000.0,
    )
        .prop_map(
            |(rows, mass_kg, centre, shear, masses, youngs, nu, density)| {
                let mut z = 0.0;
                let mut stations = Vec::new();
                for (rise, d, t) in rows {
                    stations.push(Station::new(z, d, t * d / 4.0));
                    z += rise;
                }
                let top = stations[stations.len() - 1].height_m;
                let inertia = mass_kg * 100.0;
                TowerDescription {
                    materials: vec![Material::from_poissons_ratio(density, youngs, nu)],
                    stations,
                    shear: if shear { Shear::Cowper } else { Shear::Rigid },
                    rna: Rna {
                        mass_kg,
                        center_m: [0.0, 0.0, centre],
                        inertia_kg_m2: Inertia {
                            xx: inertia,
                            yy: 0.6 * inertia,
                            zz: 0.5 * inertia,
                            ..Inertia::default()
                        },
                    },
                    point_masses: masses
                        .into_iter()
                        .map(|(s, mass_kg)| with!(PointMass, height_m = s * top, mass_kg))
                        .collect(),
                    ..TowerDescription::default()
                }
            },
        )
}

fn assert_scaled(a: &[f64], b: &[f64], factor: f64, tolerance: f64) -> Result<(), TestCaseError> {
    for (a, b) in a.iter().zip(b) {
        prop_assert!(
            (b / (a * factor) - 1.0).abs() < tolerance,
            "{b} is not {factor} times {a}"
        );
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, ..ProptestConfig::default() })]

    /// f ∝ √E at fixed ν.
    #[test]
    fn stiffer_by_a_factor(tower in any_tower(), factor in 0.1..10.0) {
        let mut stiffer = tower.clone();
        stiffer.materials[0].youngs_modulus_pa *= factor;
        stiffer.materials[0].shear_modulus_pa *= factor;
        assert_scaled(&frequencies(&tower), &frequencies(&stiffer), f64::sqrt(factor), 1e-11)?;
    }

    /// f ∝ 1/√ρ with all masses scaled.
    #[test]
    fn heavier_by_a_factor(tower in any_tower(), factor in 0.1..10.0) {
        let mut heavier = tower.clone();
        heavier.materials[0].density_kg_per_m3 *= factor;
        heavier.rna.mass_kg *= factor;
        let inertia = &mut heavier.rna.inertia_kg_m2;
        for value in [&mut inertia.xx, &mut inertia.yy, &mut inertia.zz] {
            *value *= factor;
        }
        heavier.point_masses.iter_mut().for_each(|m| m.mass_kg *= factor);
        assert_scaled(&frequencies(&tower), &frequencies(&heavier), 1.0 / f64::sqrt(factor), 1e-11)?;
    }

    /// f ∝ 1/L when every length is scaled, masses with L³ and inertias with L⁵.
    #[test]
    fn larger_by_a_factor(tower in any_tower(), factor in 0.2..5.0_f64) {
        let mut larger = tower.clone();
        for s in &mut larger.stations {
            s.height_m *= factor;
            s.outer_diameter_m *= factor;
            s.wall_thickness_m *= factor;
        }
        larger.rna.mass_kg *= factor.powi(3);
        larger.rna.center_m[2] *= factor;
        let inertia = &mut larger.rna.inertia_kg_m2;
        for value in [&mut inertia.xx, &mut inertia.yy, &mut inertia.zz] {
            *value *= factor.powi(5);
        }
        for m in &mut larger.point_masses {
            m.height_m *= factor;
            m.mass_kg *= factor.powi(3);
        }
        assert_scaled(&frequencies(&tower), &frequencies(&larger), 1.0 / factor, 1e-10)?;
    }

    /// The datum of heights means nothing.
    #[test]
    fn moved_up(tower in any_tower(), rise in -50.0..50.0) {
        let mut moved = tower.clone();
        moved.stations.iter_mut().for_each(|s| s.height_m += rise);
        moved.point_masses.iter_mut().for_each(|m| m.height_m += rise);
        assert_scaled(&frequencies(&tower), &frequencies(&moved), 1.0, 1e-10)?;
    }

    /// Turned by 90° about its axis, fore-aft becomes side-side and the spectrum stays.
    #[test]
    fn turned_about_its_axis(tower in any_tower()) {
        let mut turned = tower.clone();
        let inertia = &mut turned.rna.inertia_kg_m2;
        std::mem::swap(&mut inertia.xx, &mut inertia.yy);
        assert_scaled(&frequencies(&tower), &frequencies(&turned), 1.0, 1e-12)?;
    }

    /// More mass lowers every frequency (Rayleigh), here on the k-th of each family.
    #[test]
    fn more_mass_lowers_every_frequency(tower in any_tower(), extra in 1e3..200e3) {
        let mut heavier = tower.clone();
        heavier.rna.mass_kg += extra;
        for (a, b) in frequencies(&tower).iter().zip(frequencies(&heavier)) {
            prop_assert!(b <= a * (1.0 + 1e-12), "{a} rose to {b}");
        }
    }

    /// More stiffness at the same mass raises every frequency; E and G grow unequally, so this is
    /// no scaling.
    #[test]
    fn more_stiffness_raises_every_frequency(tower in any_tower(), factor in 1.0..3.0_f64) {
        let mut stiffer = tower.clone();
        // ν falls from at most 0.45 to no less than −0.4.
        stiffer.materials[0].shear_modulus_pa *= factor;
        stiffer.materials[0].youngs_modulus_pa *= 1.0 + 0.5 * (factor - 1.0);
        for (a, b) in frequencies(&tower).iter().zip(frequencies(&stiffer)) {
            prop_assert!(b >= a * (1.0 - 1e-12), "{a} fell to {b}");
        }
    }

    /// A row on the line between its neighbours changes nothing.
    #[test]
    fn splitting_a_row_changes_nothing(tower in any_tower(), place in 0.01..0.99) {
        let mut split = tower.clone();
        let (a, b) = (split.stations[0], split.stations[1]);
        let blend = |x: f64, y: f64| x + place * (y - x);
        split.stations.insert(1, Station {
            height_m: blend(a.height_m, b.height_m),
            outer_diameter_m: blend(a.outer_diameter_m, b.outer_diameter_m),
            wall_thickness_m: blend(a.wall_thickness_m, b.wall_thickness_m),
            material: a.material,
        });
        assert_scaled(&frequencies(&tower), &frequencies(&split), 1.0, 1e-10)?;
    }

    /// Modal masses are positive and no larger than what moves; shapes reach 1 and no further,
    /// positive at the top.
    #[test]
    fn shapes_are_normalized(tower in any_tower()) {
        for mode in &solution(&tower, 10).modes {
            let motion = |p: &towermodes::ShapePoint| if mode.family == towermodes::Family::Torsion {
                p.rotation[2]
            } else {
                p.translation.iter().sum()
            };
            let points = mode.shape.iter().chain(&mode.shape_there);
            let largest = points.map(|p| motion(p).abs()).fold(0.0, f64::max);
            // Between sampled heights a shape can peak; a hundredth of the height holds at most
            // this much of a mode.
            prop_assert!(largest <= 1.0 && largest > 0.95, "{}: {largest}", mode.label());
            prop_assert!(motion(&mode.shape[100]) >= 0.0);
            prop_assert!(motion(&mode.shape[0]) == 0.0);
            prop_assert!(mode.modal_mass > 0.0);
        }
    }
}

#[test]
fn modal_mass_is_the_mass_the_shape_moves() {
    // ∫ m φ² from the sampled shape (Simpson), plus what the machine and the platforms carry: modal
    // mass of an Euler-Bernoulli beam.
    let mut description = rich();
    description.shear = Shear::Rigid;
    description.rna = Rna::point(300e3);
    let tower = Tower::new(description).expect("a valid tower");
    let options = Options {
        segments: Some(400),
        points: 4001,
        modes: 4,
        rotary_inertia: false,
        ..Options::default()
    };
    let solution = solve(&tower, &options).expect("solvable");
    let h = tower.height_m() / 4000.0;
    for mode in &solution.modes {
        let phi2: Vec<f64> = mode
            .shape
            .iter()
            .map(|p| p.translation.iter().map(|t| t * t).sum())
            .collect();
        let mut sum = 0.0;
        // The last is the machine, on top.
        for mass in tower.attachments() {
            sum += mass.mass_kg * phi2[((mass.height_m - tower.base_m()) / h).round() as usize];
        }
        for (k, phi2) in phi2.iter().enumerate() {
            let weight = if k == 0 || k == 4000 { 0.5 } else { 1.0 };
            let z = tower.base_m() + k as f64 * h;
            // The piece below and above a border, half each.
            let at = |z: f64| {
                let piece = tower
                    .pieces()
                    .iter()
                    .find(|p| z <= p.top_m)
                    .expect("on the tower");
                piece.section_at(z.max(piece.base_m)).masses.mass_kg_per_m
            };
            let density = 0.5 * (at((z - 1e-9).max(10.0)) + at((z + 1e-9).min(120.0)));
            sum += weight * h * density * phi2;
        }
        let difference = mode.modal_mass / sum - 1.0;
        // Trapezoidal rule and the chain's n⁻² error.
        assert!(difference.abs() < 2e-4, "{}: {difference:e}", mode.label());
    }
}
