//! The rows of ElastoDyn's tower files: a tower's mass and stiffness, linear between them.

use crate::elastodyn_towers;

use std::f64::consts::PI;

use elastodyn_towers::{
    HEIGHT_M, accurate, bending_only, near, options, stepped, tapered, tower, tube, uniform,
};
use towermodes::{Family, PointMass, Tower, TowerDescription, solve};
use towermodes_analysis::elastodyn::{
    MAX_STATIONS, PointMasses, Rows, RowsError, TowerRows, TowerStation, tower_rows,
};
use towermodes_testing::{assert_matches, with};

/// The mass of the lines between rows, of a tower so long, kg.
fn mass_kg(rows: &TowerRows, length_m: f64) -> f64 {
    let pairs = rows.stations.windows(2);
    let lines = pairs.map(|pair| {
        let rise_m = length_m * (pair[1].height_fraction - pair[0].height_fraction);
        0.5 * rise_m * (pair[0].mass_kg_per_m + pair[1].mass_kg_per_m)
    });
    lines.sum()
}

/// The tower that rows describe.
fn described(rows: &TowerRows, base_m: f64, length_m: f64) -> Tower {
    let height_m = |fraction: f64| base_m + fraction * length_m;
    let row = |row: &TowerStation| {
        let height_m = height_m(row.height_fraction);
        bending_only(height_m, row.mass_kg_per_m, row.bending_n_m2)
    };
    let masses = rows.concentrated_masses.iter();
    tower(TowerDescription {
        properties: rows.stations.iter().map(row).collect(),
        point_masses: masses
            .map(|mass| point_mass(height_m(mass.height_fraction), mass.mass_kg))
            .collect(),
        ..TowerDescription::default()
    })
}

fn bending_hz(tower: &Tower) -> [f64; 4] {
    let mut options = options();
    options.modes = 14;
    let solution = solve(tower, &options).expect("modes");
    let of = |family, order| {
        let mode = solution.mode(family, order).expect("a mode");
        mode.frequency_hz
    };
    let (fore_aft, side_side) = (Family::ForeAft, Family::SideSide);
    [
        of(fore_aft, 1),
        of(fore_aft, 2),
        of(side_side, 1),
        of(side_side, 2),
    ]
}

fn point_mass(height_m: f64, mass_kg: f64) -> PointMass {
    with!(PointMass, height_m, mass_kg)
}

#[test]
fn a_straight_line_is_two_rows() {
    let rows = accurate(&tower(uniform()), 0.0, PointMasses::Listed);
    assert_eq!(rows.stations.len(), 2);
    near(mass_kg(&rows, HEIGHT_M), 5e5, 1e-15);
}

/// ρπ(d − t)t with d and t linear: by Simpson's rule exact.
#[test]
fn rows_have_the_mass_of_the_tube() {
    let area = |d: f64, t: f64| PI * t * (d - t);
    let exact = |[low, high]: [(f64, f64); 2], length_m: f64| {
        let middle = (0.5 * (low.0 + high.0), 0.5 * (low.1 + high.1));
        let [a, b, c] = [low, middle, high].map(|(d, t)| area(d, t));
        8500.0 * length_m / 6.0 * (a + 4.0 * b + c)
    };
    let rows = accurate(&tower(tapered()), 10.0, PointMasses::Listed);
    let whole_kg = exact([(6.0, 0.035), (3.87, 0.02)], 87.6);
    near(mass_kg(&rows, 87.6), whole_kg, 1e-6);
    let rows = accurate(&tower(stepped()), 10.0, PointMasses::Listed);
    let parts_kg = [
        exact([(6.5, 0.05), (6.5, 0.04)], 30.0),
        exact([(6.5, 0.04), (5.5, 0.03)], 20.0),
        exact([(5.0, 0.03), (4.0, 0.02)], 50.0),
    ];
    near(mass_kg(&rows, 100.0), parts_kg.iter().sum(), 1e-6);
    // Above a height in the middle of a part: the tube there is 6 - 0.5 * 2.13 wide.
    let rows = accurate(&tower(tapered()), 53.8, PointMasses::Listed);
    let upper_kg = exact([(4.935, 0.0275), (3.87, 0.02)], 43.8);
    near(mass_kg(&rows, 43.8), upper_kg, 1e-6);
    assert_eq!(rows.stations[0].height_fraction, 0.0);
    let expected = 8500.0 * area(4.935, 0.0275);
    near(rows.stations[0].mass_kg_per_m, expected, 1e-13);
}

#[test]
fn rows_have_the_frequencies_of_the_tower_to_a_millionth() {
    let towers = [
        tapered(),
        stepped(),
        tube(&[(0.0, 8.0, 0.06), (150.0, 3.0, 0.02)]),
        // Nearly cylinders, so that no error is small beside what is elsewhere.
        tube(&[(0.0, 6.0, 0.03), (90.0, 5.0, 0.03)]),
        tube(&[(0.0, 6.0, 0.03), (90.0, 5.9, 0.03)]),
        // A wall that grows upwards: the stiffness first rises and then falls.
        tube(&[(0.0, 6.0, 0.02), (90.0, 4.0, 0.06)]),
        // Wider above.
        tube(&[(0.0, 4.0, 0.05), (90.0, 7.0, 0.03)]),
    ];
    for description in towers {
        let tower = tower(description);
        let (base_m, length_m) = (tower.base_m(), tower.height_m());
        let rows = accurate(&tower, base_m, PointMasses::Listed);
        let (found, exact) = (
            bending_hz(&described(&rows, base_m, length_m)),
            bending_hz(&tower),
        );
        eprintln!(
            "{} rows: {:.1e}",
            rows.stations.len(),
            found[0] / exact[0] - 1.0
        );
        for (found, exact) in found.into_iter().zip(exact) {
            near(found, exact, 1e-6);
        }
    }
}

#[test]
fn a_step_is_two_rows_a_millionth_apart() {
    let rows = accurate(&tower(stepped()), 10.0, PointMasses::Listed);
    let fractions: Vec<f64> = rows
        .stations
        .iter()
        .map(|row| row.height_fraction)
        .collect();
    assert!(fractions.windows(2).all(|pair| pair[0] < pair[1]));
    assert_eq!((fractions[0], fractions[fractions.len() - 1]), (0.0, 1.0));
    let above = fractions.partition_point(|fraction| *fraction < 0.5);
    let (below, above) = (&rows.stations[above - 1], &rows.stations[above]);
    assert!((below.height_fraction - 0.499_999_5).abs() < 1e-12);
    assert!((above.height_fraction - 0.500_000_5).abs() < 1e-12);
    near(below.mass_kg_per_m, 8500.0 * PI * 0.03 * 5.47, 1e-13);
    near(above.mass_kg_per_m, 8500.0 * PI * 0.03 * 4.97, 1e-13);
    // At the kink, where there is no step, is one row, exactly there.
    let at_kink = |fraction: &&f64| (**fraction - 0.3).abs() < 1e-5;
    let kink: Vec<&f64> = fractions.iter().filter(at_kink).collect();
    assert_eq!(kink.len(), 1);
    near(*kink[0], 0.3, 1e-15);
}

#[test]
fn rows_are_as_many_as_asked_for() {
    let tapered = tower(tapered());
    let count = |tower: &Tower, wanted| {
        let expected = Rows::Count(wanted);
        let rows = tower_rows(tower, tower.base_m(), expected, PointMasses::Listed);
        rows.expect("rows").stations.len()
    };
    assert_eq!(
        [2, 11, 500].map(|wanted| count(&tapered, wanted)),
        [2, 11, 500]
    );
    // No fewer than the ends', the kink's and the step's.
    let stepped = tower(stepped());
    assert_eq!(
        [0, 1, 2, 5].map(|wanted| count(&stepped, wanted)),
        [5, 5, 5, 6]
    );
    let expected = Rows::Count(MAX_STATIONS);
    let most = tower_rows(&tapered, 10.0, expected, PointMasses::Listed);
    assert_eq!(most.expect("rows").stations.len(), MAX_STATIONS);
}

#[test]
fn masses_that_are_spread_are_kept() {
    let masses = [
        // At the ends, in the middle, two that overlap, and one across the step.
        point_mass(10.0, 900.0),
        point_mass(110.0, 800.0),
        point_mass(42.5, 7e3),
        point_mass(44.0, 5e3),
        point_mass(60.0, 3e3),
    ];
    let mut description = stepped();
    let bare = accurate(&tower(description.clone()), 10.0, PointMasses::Listed);
    description.point_masses = masses.into();
    let tower = tower(description);
    let spread = accurate(&tower, 10.0, PointMasses::Spread { parts: 20 });
    assert!(spread.concentrated_masses.is_empty());
    let added_kg = mass_kg(&spread, 100.0) - mass_kg(&bare, 100.0);
    // Rows move by half a millionth of 100 m at each step.
    assert!((added_kg - 16_700.0).abs() < 0.1, "{added_kg}");
    // Over 5 m each, of which the ends' lie inside.
    let at = |fraction: f64| {
        let above = spread
            .stations
            .partition_point(|row| row.height_fraction < fraction);
        let (low, high) = (&spread.stations[above - 1], &spread.stations[above]);
        let s = (fraction - low.height_fraction) / (high.height_fraction - low.height_fraction);
        low.mass_kg_per_m + s * (high.mass_kg_per_m - low.mass_kg_per_m)
    };
    let tube = |d: f64, t: f64| 8500.0 * PI * t * (d - t);
    // At 12.4 m the wall is 0.05 - 0.08 * 0.01 thick; at 43 m 0.04 - 0.15 * 0.01, 6.35 m wide.
    near(at(0.024), tube(6.5, 0.0492) + 180.0, 1e-5);
    near(at(0.051), tube(6.5, 0.05 - 0.01 * 5.1 / 30.0), 1e-5);
    near(at(0.33), tube(6.35, 0.0385) + 1400.0 + 1000.0, 1e-5);
    let listed = accurate(&tower, 10.0, PointMasses::Listed);
    assert_eq!(listed.stations, bare.stations);
    let kept = listed.concentrated_masses.iter();
    let kept: Vec<(f64, f64)> = kept.map(|m| (m.height_fraction, m.mass_kg)).collect();
    assert_eq!(
        kept,
        [
            (0.0, 900.0),
            (1.0, 800.0),
            (0.325, 7e3),
            (0.34, 5e3),
            (0.5, 3e3)
        ]
    );
    // Those below where the flexible tower begins are none of it.
    let upper = accurate(&tower, 43.0, PointMasses::Listed);
    assert_eq!(upper.concentrated_masses.len(), 3);
}

#[test]
fn rows_that_cannot_be_are_refused() {
    let tower = tower(tapered());
    for from_m in [9.9, 97.6, 120.0, f64::NAN, f64::NEG_INFINITY] {
        let refused = tower_rows(&tower, from_m, Rows::Accurate, PointMasses::Listed);
        let Err(RowsError::Outside { base_m, top_m, .. }) = refused else {
            panic!("{from_m}: {refused:?}");
        };
        assert_eq!((base_m, top_m), (10.0, 97.6));
    }
    for wanted in [MAX_STATIONS + 1, usize::MAX] {
        let refused = tower_rows(&tower, 10.0, Rows::Count(wanted), PointMasses::Listed);
        assert_matches!(refused, Err(RowsError::TooMany { rows }) if *rows > MAX_STATIONS);
    }
    // A cone that ends in a needle would need millions of rows.
    let needle = tube(&[(0.0, 6.0, 0.03), (100.0, 1e-3, 4e-4)]);
    let needle = elastodyn_towers::tower(needle);
    let refused = tower_rows(&needle, 0.0, Rows::Accurate, PointMasses::Listed);
    assert_matches!(refused, Err(RowsError::TooMany { .. }));
}

/// Masses anywhere: beside the base, a step and each other, at the very spacing of the elements,
/// spread over all of the tower, on a tower that begins higher. Rows rise and keep the mass
/// whatever rounding makes of the ends of what is spread.
#[test]
fn spread_masses_never_cross() {
    let mut description = stepped();
    let step_m = description.stations[1].height_m;
    let bare = tower(description.clone());
    let (base_m, height_m) = (bare.base_m(), bare.top_m());
    for parts in [1, 2, 17, 20, 30] {
        for from_m in [base_m, base_m + 4.21, base_m + 5.0] {
            let element_m = (height_m - from_m) / parts as f64;
            let steps = (0..=parts).map(|k| from_m + k as f64 * element_m);
            let others = [
                from_m,
                from_m + 0.5,
                step_m - 0.5 * element_m,
                step_m + 0.5 * element_m,
                step_m,
                step_m + 1e-7,
                height_m - 5.0,
                height_m,
            ];
            let masses = steps.chain(others).map(|z_m| z_m.clamp(from_m, height_m));
            description.point_masses = masses.map(|z_m| point_mass(z_m, 100.0)).collect();
            let own_kg = 100.0 * description.point_masses.len() as f64;
            let tower = tower(description.clone());
            let masses = PointMasses::Spread { parts };
            let rows = tower_rows(&tower, from_m, Rows::Accurate, masses).expect("rows");
            let fractions = rows.stations.iter().map(|row| row.height_fraction);
            let fractions: Vec<f64> = fractions.collect();
            assert_eq!((fractions[0], fractions[fractions.len() - 1]), (0.0, 1.0));
            let holds = fractions.windows(2).all(|pair| pair[0] < pair[1]);
            assert!(holds, "{parts} {from_m}");
            let without = tower_rows(&bare, from_m, Rows::Accurate, masses).expect("rows");
            let length_m = height_m - from_m;
            let added_kg = mass_kg(&rows, length_m) - mass_kg(&without, length_m);
            // Steps are ramps of a millionth of the height.
            let holds = (added_kg / own_kg - 1.0).abs() < 1e-4;
            assert!(holds, "{parts} {from_m}: {added_kg}");
        }
    }
}
