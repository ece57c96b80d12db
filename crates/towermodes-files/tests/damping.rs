//! `[damping]`: read, refused with line and column, written and read back, left out with a note.

use crate::refused;

use refused::refused_text;
use towermodes::{Damping, LossFactors, Rna, RotorAerodynamics, TowerDescription};
use towermodes_files::{
    ConvertOptions, OutputFormat, TowerInput, convert, description_from_toml, write_toml,
};
use towermodes_testing::rows;

const GOOD: &str = r#"[material]
density = 8500.0
youngs_modulus = 2.1e11
shear_modulus = 8.08e10
[materials.concrete]
density = 2500.0
youngs_modulus = 3.6e10
poissons_ratio = 0.2
[tower]
stations = [
  [ 0.0, 6.00, 0.300, "concrete"],
  [40.0, 5.50, 0.300, "concrete"],
  [40.0, 5.00, 0.027],
  [87.6, 3.87, 0.019],
]
[damping]
tower_loss_factor = 0.004
material_loss_factors = { concrete = 0.01 }
foundation_loss_factor = 0.02
soil_loss_factor = 0.03
wires_loss_factor = 0.05
water_loss_factor = 0.0
chord_moment = 6073
lift_slope = 6.0
air_density = 1.2
substructure_loss_factor = 0.006
"#;

fn good() -> TowerDescription {
    description_from_toml(GOOD).expect("the file is good")
}

#[track_caller]
fn refused(from: &str, to: &str, place: &str, message: &str, hint: &str) {
    assert!(GOOD.contains(from), "the test is wrong: {from}");
    refused_text(&GOOD.replacen(from, to, 1), place, message, hint);
}

/// Mistakes one after the other: what is replaced, by what, place, message, hint.
fn all_refused(table: &str) {
    for [from, to, place, message, hint] in rows(table) {
        refused(from, to, place, message, hint);
    }
}

#[test]
fn every_key_is_read() {
    let expected = Damping {
        loss_factors: LossFactors {
            tower: Some(0.004),
            substructure: Some(0.006),
            // The material without a name comes first.
            materials: vec![None, Some(0.01)],
            foundation: Some(0.02),
            soil: Some(0.03),
            wires: Some(0.05),
            water: Some(0.0),
        },
        rotor: Some(RotorAerodynamics {
            chord_moment_m3: 6073.0,
            lift_slope: 6.0,
            air_density_kg_per_m3: 1.2,
        }),
    };
    assert_eq!(good().damping, expected);
}

#[test]
fn defaults_of_the_rotor_are_those_that_the_book_lists() {
    let text = GOOD.replace("lift_slope = 6.0\nair_density = 1.2\n", "");
    let rotor = description_from_toml(&text).expect("a tower").damping.rotor;
    let rotor = rotor.expect("it has a chord moment");
    assert_eq!(rotor.lift_slope, std::f64::consts::TAU);
    assert_eq!(rotor.air_density_kg_per_m3, 1.225);
}

#[test]
fn mistakes_have_their_place() {
    let percent = "as a fraction and not in percent";
    refused("0.004", "-0.004", "17:21", "must be from 0 to 1", percent);
    let message = "the loss factor of the soil is 3";
    refused("0.03", "3", "20:20", message, percent);
    refused("0.01 }", "1.5 }", "18:25", "of a material is 1.5", percent);
    all_refused(
        r#"
        0.03 | nan | 20:20 | NaN
        0.03 | "3 %" | 20:20 | must be a number
        concrete = 0.01 | concret = 0.01 | 18:27 | concret | did you mean `concrete`?
        { concrete = 0.01 } | 0.01 | 18:25 | must be a table
        soil_loss_factor | sol_loss_factor | 20:1 | is not a key of [damping] | did you mean `soil_loss_factor`?
        6073 | -6073 | 23:16 | must be positive
        air_density = 1.2 | air_density = 0 | 25:15 | must be positive
        chord_moment = 6073\n |  | 23:14 | without `chord_moment` | add chord_moment
        "#,
    );
}

#[test]
fn what_is_written_is_read_back() {
    let (text, notes) = write_toml(&good());
    assert!(notes.is_empty(), "{notes:?}");
    let found = description_from_toml(&text).expect("a tower");
    assert_eq!(found, good(), "{text}");
    // Materials without names of their own get numbers.
    let mut unnamed = good();
    unnamed.part_names.materials.clear();
    unnamed.damping.loss_factors.materials = vec![Some(0.007), Some(0.01)];
    let (text, _) = write_toml(&unnamed);
    let read = description_from_toml(&text).expect("a tower");
    assert_eq!(read.damping, unnamed.damping, "{text}");
}

#[test]
fn other_formats_note_that_they_leave_it_out() {
    let mut input = TowerInput::from_description(good());
    input.description.rna = Rna::point(350e3);
    let options = ConvertOptions {
        sections_file: Some("sections.dat".to_owned()),
        ..ConvertOptions::default()
    };
    for (format, words) in [
        (OutputFormat::Bmodes, "the loss factors are left out"),
        (OutputFormat::WindIo, "the loss factors are left out"),
        (OutputFormat::ElastoDyn, "the loss factors"),
    ] {
        let converted = convert(&input, format, &options).expect("a tower that can be written");
        let mut notes = converted.notes.iter().map(ToString::to_string);
        assert!(notes.any(|note| note.contains(words)), "{format:?}");
    }
}
