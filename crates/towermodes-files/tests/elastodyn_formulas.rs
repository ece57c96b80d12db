//! ElastoDyn's formulas on the tower file of the NREL 5 MW turbine.

use towermodes::Planes;
use towermodes::tower::Plane;
use towermodes_analysis::elastodyn::{PlaneModes, TowerModel, TowerPolynomial, TowerStation};
use towermodes_testing::parts;

/// The first so many numbers of a line.
fn numbers(line: &str, count: usize) -> Vec<f64> {
    let words = line.split_whitespace().take(count);
    words.map(|word| word.parse().expect("a number")).collect()
}

/// The mass is the published one of the tower, 347 460 kg (Jonkman et al. 2009); the other expected
/// values are the formulas worked out apart from this library, with the 349 606.5 kg of its rotor
/// and nacelle on top.
#[test]
fn the_nrel_5_mw_tower_has_its_published_mass_and_elastodyn_s_frequencies() {
    let Ok(folder) = std::env::var("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let path = "openfast/nrel5mw_land_deck/NRELOffshrBsline5MW_Tower.dat";
    let path = std::path::Path::new(&folder).join(path);
    let text = std::fs::read_to_string(path).expect("the tower file");
    let lines: Vec<&str> = text.lines().collect();
    let station = |line: &&str| {
        let row = numbers(line, 4);
        TowerStation {
            height_fraction: row[0],
            mass_kg_per_m: row[1],
            bending_n_m2: parts::planes(row[2], row[3]),
        }
    };
    let shape = |first: usize| TowerPolynomial {
        coefficients: std::array::from_fn(|k| numbers(lines[first + k], 1)[0]),
    };
    let tower = TowerModel {
        flexible_length_m: 87.6,
        nodes: 20,
        stations: lines[19..30].iter().map(station).collect(),
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        concentrated_masses: Vec::new(),
        tower_top_mass_kg: 349_606.5,
        gravity_m_per_s2: 9.80665,
    };
    let modes = PlaneModes {
        shapes: [shape(31), shape(36)],
        tuners: [1.0, 1.0],
        damping_percent: [1.0, 1.0],
    };
    let found = tower.generalized(Plane::ForeAft, &modes).expect("numbers");
    let near = |value: f64, expected: f64| (value / expected - 1.0).abs() < 1e-12;
    assert!((found.tower_mass_kg - 347_460.0).abs() < 1.0);
    assert!(near(found.mass_kg[0], 349_606.5 + 55_381.804_876_503_55));
    assert!(near(found.stiffness_n_per_m[0][0], 1_811_945.877_294_318));
    assert!(near(
        found.gravity_stiffness_n_per_m[0],
        -61_134.135_060_743_99
    ));
    assert!(near(found.frequency_alone_hz[0], 0.910_351_662_475_393_6));
    let loaded_hz = found.frequency_loaded_hz[0].expect("a frequency");
    assert!(near(loaded_hz, 0.330_916_647_588_274_77));
}
