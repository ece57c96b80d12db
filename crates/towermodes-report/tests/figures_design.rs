//! Pictures of designs: before and after, bands without an end, towers without stations.

use crate::pictures;

use pictures::{check, check_labels};
use towermodes::{Station, TowerDescription};
use towermodes_report::figures::{self, DesignedMode};
use towermodes_report::svg::Figure;
use towermodes_testing::Says;

const MASS_KG: [f64; 2] = [347_374.0, 242_392.0];

fn tower(stations: &[[f64; 3]]) -> TowerDescription {
    let station =
        |[height_m, diameter_m, wall_m]: &[f64; 3]| Station::new(*height_m, *diameter_m, *wall_m);
    TowerDescription {
        stations: stations.iter().map(station).collect(),
        ..TowerDescription::default()
    }
}

fn mode(label: &str, band_hz: [f64; 2], before_hz: Option<f64>) -> DesignedMode<'_> {
    DesignedMode {
        label,
        band_hz,
        before_hz,
        after_hz: 0.2386,
    }
}

#[track_caller]
fn checked(towers: [&TowerDescription; 2], modes: &[DesignedMode<'_>]) -> Figure {
    let figure = figures::design(towers, MASS_KG, modes);
    check("design", &figure);
    check_labels("design", &figure);
    figure
}

fn has(figure: &Figure, text: &str) -> bool {
    figure.labels().iter().any(|label| label.text == text)
}

#[test]
fn a_design_shows_the_tower_before_and_after_and_its_bands() {
    // Cans: two stations at one height.
    let cans = [
        [0.0, 6.0, 0.035],
        [40.0, 5.0, 0.035],
        [40.0, 5.0, 0.025],
        [87.6, 3.87, 0.025],
    ];
    let before = tower(&cans);
    let after = tower(&cans.map(|[height, diameter, wall]| [height, 0.9 * diameter, 0.8 * wall]));
    let figure = checked(
        [&before, &after],
        &[
            mode("1st fore-aft bending", [0.237, 0.3], Some(0.321)),
            mode("1st torsion", [0.2, f64::INFINITY], None),
            mode("2nd side-side bending", [0.0, 0.3], Some(0.2386)),
        ],
    );
    assert!(has(&figure, "outer diameter (m)") && has(&figure, "wall thickness (mm)"));
    assert!(has(&figure, "1st torsion") && has(&figure, "natural frequency (Hz)"));
    assert_eq!(figure.title, "Design: 347.4 t before, 242.4 t after");
    let rows = &figure.table.rows;
    assert_eq!(rows[0][3..], ["347374", "242392"]);
    let expected = ["0.237000", "0.300000", "0.321000", "0.238600"];
    assert_eq!(rows[1][1..], expected);
    assert_eq!(rows[2][1..], ["0.200000", "", "", "0.238600"]);
    assert_eq!(rows[3][1..], ["", "0.300000", "0.238600", "0.238600"]);
    figure
        .description
        .says("1st torsion is 0.2386 Hz; its goal is at least 0.2000 Hz");
}

#[test]
fn a_table_of_properties_has_no_diameters() {
    let table = tower(&[]);
    let modes = [mode(
        "1st fore-aft bending",
        [0.0, f64::INFINITY],
        Some(0.3),
    )];
    let figure = checked([&table, &table], &modes);
    assert!(!has(&figure, "outer diameter (m)") && has(&figure, "natural frequency (Hz)"));
    checked([&table, &table], &[]);
}
