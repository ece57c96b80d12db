//! Results of BModes for tables of eleven rows with 1 to 200 elements.

use towermodes::Family;

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::reference_table;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "bmodes",
    title: "BModes",
    introduction: "The frequencies of BModes v3.00 for the reference tower as a table of eleven equally spaced rows, with the original wall and with a wall that \
        is 30 % thicker, with and without a point mass of 350 t at the top. Up to 100 elements the values are those of BModes, printed with more \
        digits. Its solver loses digits as the number of elements increases (5e-7 at 100), which the tolerance for 100 elements includes. BModes \
        cannot solve 200 elements; those values are from its matrices, assembled and solved independently, with an accuracy of 2e-6.",
};

/// Elements, and bending 1 to 3, torsion, axial; one element has no third bending mode.
type Row = (usize, &'static str);

const NO_MASS: [Row; 8] = [
    (1, "0.632471 6.231542 - 8.832008 14.186189"),
    (2, "0.814305 3.984256 13.603422 11.061160 15.939826"),
    (5, "0.878616 4.306699 11.250721 11.811955 16.430868"),
    (10, "0.889446 4.363707 11.365387 11.931311 16.498971"),
    (20, "0.891838 4.376681 11.397228 11.957532 16.516405"),
    (50, "0.892511 4.380386 11.406995 11.964884 16.521284"),
    (100, "0.892607 4.380918 11.408422 11.965935 16.521981"),
    (200, "0.892631 4.381051 11.408780 11.966197 16.522155"),
];

const NO_MASS_THICK: [Row; 8] = [
    (1, "0.631588 6.222836 - 8.832008 14.186189"),
    (2, "0.813205 3.978660 13.584495 11.061624 15.940091"),
    (5, "0.877440 4.300740 11.234993 11.812638 16.431224"),
    (10, "0.888258 4.357683 11.349536 11.932032 16.499340"),
    (20, "0.890648 4.370641 11.381340 11.958260 16.516777"),
    (50, "0.891320 4.374341 11.391095 11.965615 16.521657"),
    (100, "0.891416 4.374873 11.392521 11.966666 16.522354"),
    (200, "0.891440 4.375005 11.392878 11.966928 16.522528"),
];

const TOP_MASS: [Row; 8] = [
    (1, "0.248210 3.863410 - 8.832008 6.984320"),
    (2, "0.285952 2.886799 10.783869 11.061160 7.084462"),
    (5, "0.297859 3.020172 9.094269 11.811955 7.109298"),
    (10, "0.299969 3.047346 9.157953 11.931311 7.114095"),
    (20, "0.300336 3.052681 9.173082 11.957532 7.114713"),
    (50, "0.300438 3.054185 9.177642 11.964884 7.114886"),
    (100, "0.300453 3.054401 9.178305 11.965935 7.114910"),
    (200, "0.300457 3.054454 9.178472 11.966197 7.114917"),
];

const TOP_MASS_THICK: [Row; 8] = [
    (1, "0.276221 3.910084 - 8.832008 7.712724"),
    (2, "0.319733 2.906466 10.807557 11.061624 7.876468"),
    (5, "0.333472 3.041065 9.106611 11.812638 7.919240"),
    (10, "0.335895 3.068406 9.170378 11.932032 7.926656"),
    (20, "0.336322 3.073769 9.185516 11.958260 7.927906"),
    (50, "0.336441 3.075281 9.190080 11.965615 7.928256"),
    (100, "0.336459 3.075498 9.190744 11.966666 7.928306"),
    (200, "0.336463 3.075552 9.190911 11.966928 7.928319"),
];

pub(super) fn cases() -> Vec<Case> {
    let towers = [
        ("no point mass", 1.0, 0.0, NO_MASS),
        ("no point mass, wall 30 % thicker", 1.3, 0.0, NO_MASS_THICK),
        ("350 t point mass", 1.0, 350e3, TOP_MASS),
        (
            "350 t point mass, wall 30 % thicker",
            1.3,
            350e3,
            TOP_MASS_THICK,
        ),
    ];
    let mut cases = Vec::new();
    for (name, wall, top_kg, rows) in towers {
        for (elements, values) in rows {
            cases.push(Case {
                chapter: CHAPTER,
                name: name.into(),
                source: if elements > 100 {
                    "independent assembly of BModes' matrices"
                } else {
                    "BModes v3.00, run"
                },
                subject: Subject::tower(reference_table(wall, top_kg)),
                remark: "",
                unit: Unit::HZ,
                digits: Digits::Computed,
                expected: expected(values),
                runs: vec![Run::bmodes(0.0, 87.6, elements).allowing(noise(elements))],
            });
        }
    }
    cases
}

fn expected(values: &str) -> Vec<Expected> {
    let places = [
        (Family::ForeAft, 1),
        (Family::ForeAft, 2),
        (Family::ForeAft, 3),
        (Family::Torsion, 1),
        (Family::Axial, 1),
    ];
    let values = places.into_iter().zip(values.split(' '));
    values
        .filter(|(_, value)| *value != "-")
        .map(|((family, order), value)| Expected::of(family, order, value))
        .collect()
}

/// The relative error of the reference values.
fn noise(elements: usize) -> f64 {
    match elements {
        0..=50 => 0.0,
        51..=100 => 5e-7,
        _ => 2e-6,
    }
}
