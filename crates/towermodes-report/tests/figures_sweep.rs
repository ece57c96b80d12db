//! Pictures of sweeps: curves, panels, histograms; rows without a frequency; labels inside.

use crate::pictures;

use pictures::{check, check_labels};
use towermodes_report::figures::{
    self, ModeColumn, SweepBand, SweepBands, SweepColumns, VariedColumn, ViolatedShare,
};
use towermodes_report::svg::{Figure, Look};
use towermodes_testing::Says;

const LABELS: [&str; 3] = [
    "1st side-side bending",
    "1st fore-aft bending",
    "1st torsion",
];

fn varied<'a>(name: &'a str, unit: &'a str, values: Vec<f64>) -> VariedColumn<'a> {
    VariedColumn { name, unit, values }
}

fn modes(frequency_hz: impl Fn(usize, usize) -> f64, rows: usize) -> Vec<ModeColumn<'static>> {
    let mode = |(index, label): (usize, &&'static str)| ModeColumn {
        label,
        frequency_hz: (0..rows).map(|row| frequency_hz(index, row)).collect(),
    };
    LABELS.iter().enumerate().map(mode).collect()
}

#[track_caller]
fn checked(columns: &SweepColumns<'_>) -> Figure {
    let figure = figures::sweep(columns);
    check("sweep", &figure);
    check_labels("sweep", &figure);
    figure
}

fn has(figure: &Figure, text: &str) -> bool {
    figure.labels().iter().any(|label| label.text == text)
}

#[test]
fn one_varied_number_gives_a_curve_for_each_mode() {
    // Not in order, and the third row has no result.
    let masses: [f64; 4] = [4e5, 2e5, 3e5, 5e5];
    let frequency_hz = |mode: usize, row: usize| match row {
        2 => f64::NAN,
        _ => (mode as f64 + 1.0) * 0.3 * (4e5 / masses[row]).sqrt(),
    };
    let figure = checked(&SweepColumns {
        rows: 4,
        varied: vec![varied("rna.mass", "kg", masses.to_vec())],
        modes: modes(frequency_hz, 4),
        bands: SweepBands::default(),
    });
    assert!(has(&figure, "rna.mass (kg)"));
    assert!(LABELS.iter().all(|label| has(&figure, label)));
    // By rising mass, with an empty cell where there is no frequency.
    let rows = &figure.table.rows;
    assert_eq!(rows.len(), 12);
    assert_eq!(rows[0][1..], ["200000", "0.424264"]);
    assert_eq!(rows[1][1..], ["300000", ""]);
    assert_eq!(rows[2][1..], ["400000", "0.300000"]);
}

#[test]
fn two_varied_numbers_give_a_panel_for_each_mode_and_a_curve_for_each_level() {
    let rows = 30;
    let wall = |row: usize| 0.9 + 0.1 * (row % 3) as f64;
    let mass = |row: usize| 3e5 + 1e4 * (row / 3) as f64;
    let figure = checked(&SweepColumns {
        rows: rows as u64,
        varied: vec![
            varied("scale(stations[*].wall)", "", (0..rows).map(wall).collect()),
            varied("rna.mass", "kg", (0..rows).map(mass).collect()),
        ],
        modes: modes(
            |mode, row| (mode + 1) as f64 * wall(row) * 1e5 / mass(row),
            rows,
        ),
        bands: SweepBands::default(),
    });
    // The number with few values distinguishes the curves.
    assert!(has(&figure, "rna.mass (kg)"));
    assert!(has(&figure, "scale(stations[*].wall) = 0.9"));
    assert!(LABELS.iter().all(|label| has(&figure, label)));
    assert_eq!(figure.table.rows.len(), 3 * rows);
}

#[test]
fn more_varied_numbers_give_histograms_with_quantiles() {
    let rows = 1000;
    let value = |row: usize| (row as f64 * 0.618_034).fract();
    let figure = checked(&SweepColumns {
        rows: rows as u64,
        varied: ["a", "b", "c"]
            .map(|name| varied(name, "", (0..rows).map(value).collect()))
            .to_vec(),
        modes: modes(|mode, row| mode as f64 + 1.0 + value(row), rows),
        bands: SweepBands::default(),
    });
    assert!(has(&figure, "share of the rows (%)"));
    // Uniform between 1 and 2 Hz: the median is 1.5 Hz within twice the spacing of the rows.
    let words = figure.description.split("50 % of the rows below ").nth(1);
    let median = words.and_then(|words| words.split(' ').next()?.parse::<f64>().ok());
    let holds = median.is_some_and(|hz| (hz - 1.5).abs() < 2e-3);
    assert!(holds, "{median:?}");
    let total: f64 = figure
        .table
        .rows
        .iter()
        .filter(|row| row[0] == LABELS[0])
        .map(|row| row[3].parse::<f64>().expect("a number"))
        .sum();
    assert!((total - 100.0).abs() < 0.1, "{total}");
}

#[test]
fn sweeps_without_results_or_differences_are_drawn() {
    for (names, rows) in [(1, 0), (1, 1), (2, 5), (3, 0), (3, 5)] {
        for frequency_hz in [f64::NAN, 0.0, 0.3] {
            let columns = SweepColumns {
                rows: rows as u64,
                varied: ["a", "b", "c"][..names]
                    .iter()
                    .map(|name| varied(name, "", vec![1.0; rows]))
                    .collect(),
                modes: modes(|_, _| frequency_hz, rows),
                bands: SweepBands::default(),
            };
            let figure = figures::sweep(&columns);
            check_labels("sweep", &figure);
            assert!(!figure.to_svg(Look::Standalone).contains("NaN"));
        }
    }
    let nothing = figures::sweep(&SweepColumns::default());
    assert!(!nothing.to_svg(Look::Standalone).contains("NaN"));
}

/// Many rows are thinned out: the description counts all of them, and the curve has both ends.
#[test]
fn a_thinned_curve_has_both_ends_and_the_number_of_all_rows() {
    let rows = 40_001;
    let of_rows = |all: u64| SweepColumns {
        rows: all,
        varied: vec![varied("a", "", (0..rows).map(|row| row as f64).collect())],
        modes: modes(|mode, row| mode as f64 + row as f64 / 1e5, rows),
        bands: SweepBands::default(),
    };
    let figure = figures::sweep(&of_rows(40_001));
    let words = "against a, 40001 rows. Each curve shows 2000 of these rows.";
    figure.description.says(words);
    assert!(!figure.description.contains("at random"));
    let of_first = figure.table.rows.iter().filter(|row| row[0] == LABELS[0]);
    let values: Vec<&str> = of_first.map(|row| row[1].as_str()).collect();
    assert_eq!(values.len(), 2000);
    assert_eq!(values[0], "0");
    assert_eq!(values[1999], "40000");
    // The rows are a selection of those of the sweep.
    let figure = figures::sweep(&of_rows(4_000_000));
    let words = "The picture shows 40001 rows, selected at random from 4000000.";
    figure.description.says(words);
}

/// The margin of 3P, which cuts a histogram, and that of 1P, which is far away.
#[test]
fn histograms_show_the_margins_of_the_rotor() {
    let rows = 1000;
    let value = |row: usize| (row as f64 * 0.618_034).fract();
    let band = |multiple: usize, share| {
        let n = multiple as f64 / 60.0;
        SweepBand {
            multiple,
            operation_hz: [6.9 * n, 12.1 * n],
            margin_hz: [6.9 * n / 1.05, 12.1 * n / 0.95],
            violated: vec![Some(share); 3],
        }
    };
    let share = |share, interval| ViolatedShare { share, interval };
    let columns = |are_random| SweepColumns {
        rows: rows as u64,
        varied: ["a", "b", "c"]
            .map(|name| varied(name, "", (0..rows).map(value).collect()))
            .to_vec(),
        modes: modes(
            |mode, row| 0.3 * (mode as f64 + 1.0) + 0.06 * value(row),
            rows,
        ),
        bands: SweepBands {
            margin: 0.05,
            are_random,
            bands: vec![
                band(1, share(0.0, [0.0, 0.0038])),
                band(3, share(0.5, [0.469, 0.531])),
            ],
        },
    };
    let figure = checked(&columns(true));
    let remark = "probability of a distance below 5 %: 1P below 0.38 %, 3P 50.0 % (46.9 to 53.1 %)";
    assert!(has(&figure, remark), "{:?}", figure.labels());
    figure.description.says(remark);
    assert!(has(&figure, "within 5 % of 1P or 3P in operation"));
    // In the field of each mode that is near: the first, and the second at 0.6 to 0.66 Hz.
    let names = figure
        .labels()
        .iter()
        .filter(|label| label.text == "3P")
        .count();
    assert_eq!(names, 2);
    let figure = checked(&columns(false));
    assert!(has(
        &figure,
        "share of rows with a distance below 5 %: 1P 0 %, 3P 50.0 %"
    ));
    assert!(
        !figure
            .labels()
            .iter()
            .any(|label| label.text.contains("confidence"))
    );
}
