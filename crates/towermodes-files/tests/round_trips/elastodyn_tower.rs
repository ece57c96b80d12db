//! A tower file of ElastoDyn keeps the bending of the clamped tower alone.

use std::f64::consts::PI;

use towermodes::{Planes, PointMass, Properties, PropertyStation, Station, TowerDescription};
use towermodes_analysis::elastodyn::Rows;
use towermodes_analysis::elastodyn::{DEFAULT_NODES, MakeOptions};
use towermodes_files::FileFormat;
use towermodes_testing::with;

use super::comparison::{alone, assert_near, bending_hz, largest_difference};
use super::formats::{Target, elastodyn, there_and_back, tower};
use super::towers;

#[test]
fn bending_frequencies_of_the_clamped_tower_alone_are_kept_to_a_millionth() {
    for (name, description) in towers::all() {
        let input = there_and_back(&description, Target::ElastoDyn);
        assert_eq!(input.format, FileFormat::ElastoDynTower, "{name}");
        let (original, again) = (tower(&alone(&description)), input.tower().expect("a tower"));
        let off = largest_difference(&bending_hz(&again), &bending_hz(&original));
        eprintln!(
            "ElastoDyn, {name}: {off:.1e}, mass {:.1e}, rows {}",
            again.mass_kg() / original.mass_kg() - 1.0,
            input.description.properties.len()
        );
        assert_near(again.mass_kg(), original.mass_kg(), 1e-6, name);
        assert!(off <= 1e-6, "{name}: {off:e}");
    }
}

#[test]
fn masses_that_are_not_listed_are_spread_over_an_element() {
    let description = towers::with_masses();
    let written = elastodyn(&description, &MakeOptions::default());
    let said = written.notes.iter().any(|note| {
        note.message
            .contains("3 point masses are each distributed over 1/20")
    });
    assert!(said, "{:?}", written.notes);
    let input = written.read();
    assert!(input.description.point_masses.is_empty());
    // The same by many small masses: their midpoint rule is off by 1/1200 of what the width itself
    // changes.
    let mut original = alone(&description);
    let masses = std::mem::take(&mut original.point_masses);
    let width_m = 90.0 / DEFAULT_NODES as f64;
    original.point_masses = masses
        .iter()
        .flat_map(|mass| spread(mass, width_m))
        .collect();
    let (original, again) = (tower(&original), input.tower().expect("a tower"));
    assert_near(again.mass_kg(), original.mass_kg(), 1e-6, "mass");
    let off = largest_difference(&bending_hz(&again), &bending_hz(&original));
    assert!(off <= 2e-6, "{off:e}");
}

fn spread(mass: &PointMass, width_m: f64) -> impl Iterator<Item = PointMass> + use<> {
    const PARTS: usize = 100;
    let mass = *mass;
    (0..PARTS).map(move |k| PointMass {
        height_m: mass.height_m + width_m * ((k as f64 + 0.5) / PARTS as f64 - 0.5),
        mass_kg: mass.mass_kg / PARTS as f64,
        ..mass
    })
}

/// Eleven rows are the tube at eleven equal heights, by the formulas for tubes.
#[test]
fn a_number_of_rows_is_kept() {
    let description = towers::example("nrel-5mw");
    let options = with!(MakeOptions, rows = Rows::Count(11));
    let input = elastodyn(&description, &options).read();
    assert_eq!(input.description.properties.len(), 11);
    let rows = (0..=10).map(|k| {
        let s = f64::from(k) / 10.0;
        let (d, t) = (6.0 + s * (3.87 - 6.0), 0.0351 + s * (0.0247 - 0.0351));
        let inner: f64 = d - 2.0 * t;
        row(
            87.6 * s,
            8500.0 * PI / 4.0 * (d * d - inner * inner),
            2.1e11 * PI / 64.0 * (d.powi(4) - inner.powi(4)),
        )
    });
    let expected = with!(TowerDescription, properties = rows.collect());
    for (found, expected) in input
        .description
        .properties
        .iter()
        .zip(&expected.properties)
    {
        let (found_z_m, expected_z_m) = (found.height_m, expected.height_m);
        assert!((found_z_m - expected_z_m).abs() < 1e-10, "{found_z_m}");
        let (found, expected) = (&found.properties, &expected.properties);
        assert_near(found.mass_kg_per_m, expected.mass_kg_per_m, 1e-12, "mass");
        let (found, expected) = (found.bending_n_m2, expected.bending_n_m2);
        assert_near(found.fore_aft, expected.fore_aft, 1e-12, "EI");
        assert_near(found.side_side, expected.side_side, 1e-12, "EI");
    }
    let found = bending_hz(&input.tower().expect("a tower"));
    let off = largest_difference(&found, &bending_hz(&tower(&expected)));
    assert!(off <= 1e-11, "{off:e}");
}

fn row(height_m: f64, mass_kg_per_m: f64, bending_n_m2: f64) -> PropertyStation {
    PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 0.0,
            bending_n_m2: Planes::both(bending_n_m2),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: None,
        },
    }
}

/// Two cylinders: rows at the ends and around the step, and few of them are asked for.
#[test]
fn a_step_has_its_rows_whatever_the_number() {
    let description = TowerDescription {
        stations: vec![
            Station::new(0.0, 6.0, 0.05),
            Station::new(36.0, 6.0, 0.05),
            Station::new(36.0, 6.0, 0.03),
            Station::new(90.0, 6.0, 0.03),
        ],
        ..towers::plain()
    };
    let options = with!(MakeOptions, rows = Rows::Count(2));
    let input = elastodyn(&description, &options).read();
    let heights: Vec<f64> = input
        .description
        .properties
        .iter()
        .map(|row| row.height_m)
        .collect();
    let expected = [0.0, 36.0 - 45e-6, 36.0 + 45e-6, 90.0];
    assert_eq!(heights.len(), 4);
    for (found, expected) in heights.iter().zip(expected) {
        assert!((found - expected).abs() < 1e-9, "{heights:?}");
    }
    let off = largest_difference(
        &bending_hz(&input.tower().expect("a tower")),
        &bending_hz(&tower(&alone(&description))),
    );
    assert!(off <= 1e-7, "{off:e}");
}
