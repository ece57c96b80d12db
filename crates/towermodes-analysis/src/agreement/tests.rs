//! Towers whose differences are known by hand.

use super::*;
use towermodes::Family;
use towermodes::tower::{Material, PointMass, Rna, Station, TowerDescription};

fn steel() -> Vec<Material> {
    vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)]
}

/// A tube of 6 m diameter with these heights and wall thicknesses (m).
fn tube(walls: &[(f64, f64)]) -> TowerDescription {
    let station = |&(z, t): &(f64, f64)| Station::new(z, 6.0, t);
    TowerDescription {
        materials: steel(),
        stations: walls.iter().map(station).collect(),
        ..TowerDescription::default()
    }
}

fn cone(heights_m: &[f64]) -> TowerDescription {
    let station = |&z: &f64| Station::new(z, 6.0 - 0.02 * z, 0.03 - 0.0001 * z);
    TowerDescription {
        materials: steel(),
        stations: heights_m.iter().map(station).collect(),
        ..TowerDescription::default()
    }
}

#[track_caller]
fn compare(first: &TowerDescription, second: &TowerDescription) -> Agreement {
    agree(first, second, &AgreementLimits::default()).expect("comparable")
}

#[track_caller]
fn close(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-9, "{value} {expected}");
}

/// Area divided by π, m², for the wall thickness t: t (6 − t).
fn area(t: f64) -> f64 {
    t * (6.0 - t)
}

/// Second moment of area divided by π, m⁴, times 16.
fn second_moment(t: f64) -> f64 {
    area(t) * (36.0 + (6.0 - 2.0 * t) * (6.0 - 2.0 * t))
}

fn differences(agreement: &Agreement) -> Vec<f64> {
    let rows = agreement.rows.iter();
    let modes = agreement.frequencies_bare.iter();
    let modes = modes.chain(&agreement.frequencies_as_given);
    rows.flat_map(|row| {
        let bending = row.bending_n_m2;
        let compared = [row.mass_kg_per_m, bending.fore_aft, bending.side_side];
        compared.map(|c| c.difference)
    })
    .chain(modes.map(|mode| mode.difference.expect("both")))
    .chain([
        agreement.mass_kg.difference,
        agreement.center_of_mass_m.difference,
        agreement.tip_flexibility_m_per_n.fore_aft.difference,
        agreement.largest_mass.compared.difference,
        agreement.largest_bending.side_side.compared.difference,
    ])
    .collect()
}

#[test]
fn a_tower_agrees_with_itself_exactly() {
    let walls = [(0.0, 0.04), (50.0, 0.035), (50.0, 0.02), (100.0, 0.018)];
    let description = TowerDescription {
        rna: Rna::point(2e5),
        ..tube(&walls)
    };
    let agreement = compare(&description, &description);
    assert!(differences(&agreement).iter().all(|d| *d == 0.0));
    assert_eq!(agreement.verdict, Verdict::Pass);
    assert_eq!(agreement.frequencies_bare.len(), 4);
    assert_eq!(agreement.frequencies_as_given.len(), 4);
    assert_eq!(agreement.shift_m, None);
    assert_eq!(agreement.window_m, 1.0);
    assert_eq!(agreement.rows.len(), 22);
}

#[test]
fn more_stations_on_the_same_cone_change_nothing() {
    let agreement = compare(
        &cone(&[0.0, 100.0]),
        &cone(&[0.0, 7.0, 33.3, 61.0, 99.0, 100.0]),
    );
    assert!(differences(&agreement).iter().all(|d| d.abs() < 1e-9));
    assert_eq!(agreement.verdict, Verdict::Pass);
    assert!(agreement.frequencies_as_given.is_empty());
}

#[test]
fn a_table_with_the_columns_of_a_tube_agrees_with_it() {
    use towermodes::tower::{Properties, PropertyStation};
    let first = tube(&[(0.0, 0.03), (100.0, 0.03)]);
    let (pi, a, i) = (std::f64::consts::PI, area(0.03), second_moment(0.03) / 16.0);
    let properties = Properties {
        mass_kg_per_m: 8500.0 * pi * a,
        rotary_inertia_kg_m: Planes::both(8500.0 * pi * i),
        polar_inertia_kg_m: 2.0 * 8500.0 * pi * i,
        bending_n_m2: Planes::both(2.1e11 * pi * i),
        torsion_n_m2: 2.0 * 8.08e10 * pi * i,
        axial_n: 2.1e11 * pi * a,
        // Left out of the bare tower.
        shear_n: Some(Planes::both(0.5 * 8.08e10 * pi * a)),
    };
    let row = |height_m| PropertyStation {
        height_m,
        properties,
    };
    let second = TowerDescription {
        properties: vec![row(0.0), row(100.0)],
        ..TowerDescription::default()
    };
    let agreement = compare(&first, &second);
    assert!(differences(&agreement).iter().all(|d| d.abs() < 1e-9));
}

#[test]
fn a_step_moved_by_a_millimetre_passes() {
    let step = |z| tube(&[(0.0, 0.04), (z, 0.04), (z, 0.02), (100.0, 0.02)]);
    let agreement = compare(&step(50.0), &step(50.001));
    assert_eq!(agreement.verdict, Verdict::Pass);
    // The window that the step enters last has 1 mm of the thicker wall in 1 m.
    let expected = 0.001 * (area(0.04) - area(0.02)) / area(0.02);
    close(agreement.largest_mass.compared.difference, expected);
    assert!((agreement.largest_mass.height_m - 50.5).abs() < 1.5e-3);
    // A step that is a ramp of 1 mm, as HAWC2 and ElastoDyn write it.
    let ramp = tube(&[(0.0, 0.04), (50.0, 0.04), (50.001, 0.02), (100.0, 0.02)]);
    assert_eq!(compare(&step(50.0), &ramp).verdict, Verdict::Pass);
}

#[test]
fn a_wall_one_percent_thicker_is_seen_at_its_heights() {
    let first = tube(&[(0.0, 0.03), (100.0, 0.03)]);
    let walls = [
        (0.0, 0.03),
        (40.0, 0.03),
        (40.0, 0.0303),
        (60.0, 0.0303),
        (60.0, 0.03),
        (100.0, 0.03),
    ];
    let agreement = compare(&first, &tube(&walls));
    let mass = area(0.0303) / area(0.03) - 1.0;
    let bending = second_moment(0.0303) / second_moment(0.03) - 1.0;
    close(agreement.largest_mass.compared.difference, mass);
    close(
        agreement.largest_bending.fore_aft.compared.difference,
        bending,
    );
    assert!((40.5..=59.5).contains(&agreement.largest_mass.height_m));
    // 0.99 % of mass is over 0.5 %, 0.98 % of EI just below 1 %, a fifth of the mass's below a
    // quarter.
    assert_eq!(agreement.largest_mass.compared.verdict, Verdict::Fail);
    let of_bending = agreement.largest_bending.fore_aft.compared.verdict;
    assert_eq!(of_bending, Verdict::Warn);
    assert_eq!(agreement.mass_kg.verdict, Verdict::Pass);
    close(agreement.mass_kg.difference, 0.2 * mass);
    for row in &agreement.rows {
        let is_thicker = row.height_m > 40.6 && row.height_m < 59.4;
        let is_beside = row.height_m < 39.4 || row.height_m > 60.6;
        if is_thicker {
            close(row.mass_kg_per_m.difference, mass);
        } else if is_beside {
            assert!(row.mass_kg_per_m.difference.abs() < 1e-12);
        }
        // So one sees where they part.
        let share = 0.01 * (row.height_m - 40.0).clamp(0.0, 20.0);
        close(row.mass_below_kg.difference, share * mass);
    }
}

#[test]
fn a_step_read_as_a_taper_fails_with_the_mass_it_loses() {
    let step = tube(&[(0.0, 0.04), (50.0, 0.04), (50.0, 0.02), (100.0, 0.02)]);
    let taper = tube(&[(0.0, 0.04), (50.0, 0.02), (100.0, 0.02)]);
    let agreement = compare(&step, &taper);
    // Step: 50 (0.04·5.96 + 0.02·5.98) = 17.9. Taper: the mean of t (6 − t) from 0.04 to 0.02 is
    // 0.18 − (0.04² + 0.04·0.02 + 0.02²)/3 = 0.18 − 0.0028/3.
    let tapered = 50.0 * (0.18 - 0.0028 / 3.0) + 50.0 * 0.02 * 5.98;
    close(agreement.mass_kg.difference, tapered / 17.9 - 1.0);
    assert!((agreement.mass_kg.difference + 0.165_735_568).abs() < 1e-8);
    // Furthest apart in the metre below the step: the mean from 0.0204 to 0.02.
    let mean = 6.0 * 0.0202 - (0.0204 * 0.0204 + 0.0204 * 0.02 + 0.02 * 0.02) / 3.0;
    close(
        agreement.largest_mass.compared.difference,
        mean / 0.2384 - 1.0,
    );
    assert!((agreement.largest_mass.height_m - 49.5).abs() < 1e-9);
    assert_eq!(agreement.mass_kg.verdict, Verdict::Fail);
    assert_eq!(agreement.frequencies_bare[0].verdict, Verdict::Fail);
    assert_eq!(agreement.verdict, Verdict::Fail);
}

#[test]
fn towers_of_different_lengths_are_compared_where_both_are() {
    let long = TowerDescription {
        point_masses: vec![PointMass {
            height_m: 20.0,
            mass_kg: 1e4,
            ..PointMass::default()
        }],
        ..tube(&[(0.0, 0.03), (100.0, 0.03)])
    };
    let short = tube(&[(40.0, 0.03), (100.0, 0.03)]);
    let agreement = compare(&long, &short);
    assert!(!agreement.ranges_agree());
    // What is compared agrees, but two fifths of the tower are not compared.
    assert!((agreement.uncompared_share() - 0.4).abs() < 1e-15);
    assert_eq!(agreement.verdict, Verdict::Fail);
    assert_eq!(agreement.shift_m, None);
    assert_eq!(agreement.overlap.length_m(), 60.0);
    // A hundredth may be missing.
    let whole = tube(&[(0.0, 0.03), (100.0, 0.03)]);
    let nearly = compare(&whole, &tube(&[(0.5, 0.03), (100.0, 0.03)]));
    assert_eq!(nearly.verdict, Verdict::Warn);
    // 3.516015²/l² √(EI/m)/2π of the upper 60 m, E I/ρ A with I/A = (36 + 5.94²)/16.
    let gyration = (36.0 + 5.94 * 5.94) / 16.0_f64;
    let speed = (2.1e11 / 8500.0 * gyration).sqrt();
    let root = 1.875_104_068_711_961_f64;
    let expected = root * root / 3600.0 * speed / std::f64::consts::TAU;
    let first = &agreement.frequencies_bare[0];
    for frequency in [first.first_hz, first.second_hz] {
        assert!((frequency.expect("there") / expected - 1.0).abs() < 1e-9);
    }
}

#[test]
fn another_datum_and_no_shared_height_are_said() {
    let at = |base: f64| tube(&[(base, 0.03), (base + 100.0, 0.03)]);
    assert_eq!(compare(&at(0.0), &at(15.0)).shift_m, Some(15.0));
    let apart = agree(&at(0.0), &at(100.0), &AgreementLimits::default());
    let error = apart.expect_err("no shared height").to_string();
    let words = "the first reaches from 0 m to 100 m, the second from 100 m to 200 m";
    assert!(error.contains(words), "{error}");
}

#[test]
fn point_masses_and_machines_are_part_of_the_comparison() {
    let first = tube(&[(0.0, 0.03), (100.0, 0.03)]);
    let second = TowerDescription {
        point_masses: vec![PointMass {
            height_m: 100.001,
            mass_kg: 1e4,
            ..PointMass::default()
        }],
        rna: Rna::point(3e5),
        ..tube(&[(0.0, 0.03), (100.001, 0.03)])
    };
    let agreement = compare(&first, &second);
    let wall = 8500.0 * std::f64::consts::PI * area(0.03) * 100.0;
    close(agreement.mass_kg.difference, 1e4 / wall);
    close(agreement.point_masses_kg.difference, 1e4 / wall);
    assert!(agreement.ranges_agree());
    // The machine is not in the bare frequencies, where 10 t on 478 t change f by about −2 ·
    // 10/478.
    let bare = agreement.frequencies_bare[0].difference.expect("both");
    assert!((-0.05..-0.03).contains(&bare));
    let given = agreement.frequencies_as_given[0].difference.expect("both");
    assert!(given < -0.4);
}

#[test]
fn what_is_no_tower_is_answered_with_which() {
    let good = tube(&[(0.0, 0.03), (100.0, 0.03)]);
    let bad = tube(&[(0.0, 0.03), (100.0, -0.03)]);
    let error = agree(&good, &bad, &AgreementLimits::default()).expect_err("no tower");
    assert!(matches!(
        error,
        AgreementError::Tower {
            which: WhichTower::Second,
            ..
        }
    ));
    assert!(error.to_string().starts_with("the second tower: station 2"));
}

/// Softer moorings change no quantity except the surge frequency, by the square root of the
/// stiffness, if only the moorings resist surge.
#[test]
fn a_floater_with_other_moorings_fails() {
    let floater = towermodes_verify::towers::floater();
    let mut softer = floater.clone();
    let platform = softer.foundation.floating_mut().expect("it floats");
    let matrix = &mut platform.mooring.matrix;
    matrix.as_flattened_mut().iter_mut().for_each(|k| *k *= 0.8);
    let agreement = compare(&floater, &softer);
    assert_eq!(agreement.verdict, Verdict::Fail);
    let part = |name: &str| agreement.parts.iter().find(|part| part.name == name);
    let surge = part("mooring stiffness in surge").expect("moorings");
    close(surge.difference.expect("both"), -0.2);
    assert_eq!(surge.verdict, Verdict::Fail);
    assert_eq!(
        part("platform mass").expect("a platform").verdict,
        Verdict::Pass
    );
    assert_eq!(part("substructure mass"), None);
    let modes = &agreement.frequencies_as_given;
    let surge = modes
        .iter()
        .find(|mode| mode.label == Family::Surge.label(1))
        .expect("surge");
    let change = surge.difference.expect("both");
    assert!((change - (0.8_f64.sqrt() - 1.0)).abs() < 0.02, "{change}");
    assert_eq!(compare(&floater, &floater).verdict, Verdict::Pass);
}

#[test]
fn another_rotor_nacelle_assembly_fails() {
    let with = |kg: f64| TowerDescription {
        rna: Rna::point(kg),
        ..tube(&[(0.0, 0.04), (100.0, 0.03)])
    };
    let agreement = compare(&with(3e5), &with(3.1e5));
    let rna = agreement.parts.iter().find(|part| part.name == "RNA mass");
    assert_eq!(rna.map(|part| part.verdict), Some(Verdict::Fail));
}
