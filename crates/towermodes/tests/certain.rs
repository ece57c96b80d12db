//! Lists that end where rounding begins.

use std::f64::consts::TAU;

use towermodes::{
    Family, Inertia, Options, Planes, Properties, PropertyStation, Rna, SolveError, Solver, Tower,
    TowerDescription, Warning, solve,
};
use towermodes_testing::with;

const LENGTH_M: f64 = 80.0;
const BENDING_N_M2: f64 = 2e11;
const MACHINE_KG: f64 = 3e5;
const MACHINE_KG_M2: [f64; 2] = [2e7, 4e7];

/// A uniform tower of so much mass per length under a machine whose centre is at its top.
fn tower(mass_kg_per_m: f64) -> Tower {
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(BENDING_N_M2),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    };
    let description = TowerDescription {
        properties: vec![row(0.0), row(LENGTH_M)],
        rna: Rna {
            mass_kg: MACHINE_KG,
            center_m: [0.0; 3],
            inertia_kg_m2: Inertia {
                // Bending fore-aft turns it about y, side-side about x.
                xx: MACHINE_KG_M2[1],
                yy: MACHINE_KG_M2[0],
                zz: 3e7,
                ..Inertia::default()
            },
        },
        ..TowerDescription::default()
    };
    Tower::new(description).expect("a tower")
}

/// The two frequencies of a massless cantilever with m and J at its end, Hz: (12 EI/L³ − m λ)(4
/// EI/L − J λ) = (6 EI/L²)².
fn massless_hz(inertia_kg_m2: f64) -> [f64; 2] {
    let (l, ei) = (LENGTH_M, BENDING_N_M2);
    let (k, r, c) = (12.0 * ei / l.powi(3), 4.0 * ei / l, 6.0 * ei / (l * l));
    let (m, j) = (MACHINE_KG, inertia_kg_m2);
    let half = (k * j + r * m) / (2.0 * m * j);
    let product = (k * r - c * c) / (m * j);
    let root = (half * half - product).sqrt();
    [half - root, half + root].map(|lambda| lambda.sqrt() / TAU)
}

fn hz_of(tower: &Tower, options: &Options) -> (Vec<(Family, f64)>, Vec<Warning>) {
    let solution = Solver::new(options.clone())
        .solve_certain(tower)
        .expect("modes");
    let modes = solution.modes.iter();
    let found = modes.map(|mode| (mode.family, mode.frequency_hz)).collect();
    (found, solution.warnings)
}

#[test]
fn a_tower_without_mass_has_the_modes_of_its_machine() {
    let massless = tower(1e-9);
    let error = solve(&massless, &Options::default()).expect_err("rounding hides the others");
    assert!(matches!(error, SolveError::Eigen(_)), "{error}");
    let (found, warnings) = hz_of(&massless, &Options::default());
    let expected = Warning::OnlyCertain {
        listed: 4,
        wanted: 8,
    };
    assert!(warnings.contains(&expected), "{warnings:?}");
    let [fore_aft, side_side] = MACHINE_KG_M2.map(massless_hz);
    assert_eq!(found.len(), 4);
    for (family, hz) in [(Family::ForeAft, fore_aft), (Family::SideSide, side_side)] {
        let of_family = found.iter().filter(|(own, _)| *own == family);
        for ((_, found_hz), hz) in of_family.zip(hz) {
            // What a hundred segments leave.
            assert!((found_hz / hz - 1.0).abs() < 1e-5, "{found_hz} {hz}");
        }
    }
}

/// Any number that is certain is given without a word, and so is everything of a tower with mass.
#[test]
fn what_is_certain_is_listed_without_a_warning() {
    let is_short = |warning: &Warning| matches!(warning, Warning::OnlyCertain { .. });
    for (mass_kg_per_m, modes) in [(1e-9, 4), (1e-9, 1), (1e3, 8)] {
        let (found, warnings) = hz_of(&tower(mass_kg_per_m), &with!(Options, modes));
        assert_eq!(found.len(), modes);
        assert!(!warnings.iter().any(is_short), "{warnings:?}");
    }
    let none = with!(Options, modes = 0);
    let error = Solver::new(none).solve_certain(&tower(1e3));
    assert_eq!(error, Err(SolveError::NoModes));
}
