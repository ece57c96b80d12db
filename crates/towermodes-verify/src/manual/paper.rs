//! The tables of the paper, to every printed digit.

use towermodes::{Family, Method, TowerDescription};

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::{reference, reference_350t, reference_table};

pub(super) const CHAPTER: Chapter = Chapter {
    name: "paper",
    title: "The tables of the paper",
    introduction: "Nikolić & Šalinić compare their element, RMJE, with the cardanic element of Zhao, Maißer & Wu, with BModes and with \
        Adams. Of the 30 RMJE values 27 are reproduced to the printed digit, for both modes of each bending pair. Three differ, marked MISPRINT: \
        the torsional frequency of Table 1 with 60 segments, 11.8834, is a thin-wall value; two axial values of Table 2 are 7.101747 and 7.105936 \
        instead of 7.1018 and 7.1060, for an unknown reason. The labels of the last two rows of Table 2 are exchanged; here they are corrected. The torsional and axial values of Zhao's element are also \
        reproduced. Its bending values are not: the paper gives 0.8857, 4.2929 and 11.0090 Hz for 20 segments, and the element gives 0.8904, 4.3489 \
        and 11.2329 Hz. The BModes column is for a tower with a wall that is 30 % thicker, given by eleven rows.",
};

const TABLE_1: &str = "Nikolić & Šalinić, Table 1";
const TABLE_2: &str = "Nikolić & Šalinić, Table 2";

/// A column of a table: method, segments, bending, torsion, axial; no bending values if those of
/// the table cannot be reproduced.
type Column = (Method, usize, &'static str, &'static str, &'static str);

const NO_MASS: [Column; 5] = [
    (
        Method::Rmje,
        20,
        "0.8905 4.3427 11.1776",
        "11.7211",
        "16.2587",
    ),
    (
        Method::Rmje,
        40,
        "0.8911 4.3510 11.2295",
        "11.8434",
        "16.3924",
    ),
    (
        Method::Rmje,
        60,
        "0.8912 4.3525 11.2388",
        "11.8834",
        "16.4363",
    ),
    (Method::Cardanic, 10, "", "11.9013", "16.4770"),
    (Method::Cardanic, 20, "", "11.9463", "16.5114"),
];

const TOP_MASS: [Column; 5] = [
    (
        Method::Rmje,
        20,
        "0.3001 3.0394 9.0486",
        "11.7211",
        "7.0888",
    ),
    (
        Method::Rmje,
        40,
        "0.3002 3.0438 9.0850",
        "11.8434",
        "7.1018",
    ),
    (
        Method::Rmje,
        60,
        "0.3002 3.0446 9.0917",
        "11.8832",
        "7.1060",
    ),
    (Method::Cardanic, 10, "", "11.9013", "7.1095"),
    (Method::Cardanic, 20, "", "11.9463", "7.1130"),
];

/// A value printed for `rmje` that differs from the result of the element: source, segments,
/// family, correct value, reason.
type Misprinted = (&'static str, usize, Family, f64, &'static str);

const MISPRINTS: [Misprinted; 3] = [
    (
        TABLE_1,
        60,
        Family::Torsion,
        11.8832,
        "computed with the polar inertia of a thin ring; Table 2 prints 11.8832",
    ),
    (TABLE_2, 40, Family::Axial, 7.1017, "the cause is unknown"),
    (TABLE_2, 60, Family::Axial, 7.1059, "the cause is unknown"),
];

pub(super) fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    for column in NO_MASS {
        cases.push(case("no point mass", TABLE_1, reference(), column));
    }
    for column in TOP_MASS {
        cases.push(case("350 t point mass", TABLE_2, reference_350t(), column));
    }
    let bmodes: Column = (
        Method::Bmodes,
        50,
        "0.8913 4.3743 11.3911",
        "11.9656",
        "16.5217",
    );
    let name = "no point mass, wall 30 % thicker, eleven rows";
    cases.push(case(name, TABLE_1, reference_table(1.3, 0.0), bmodes));
    cases
}

fn case(
    name: &str,
    source: &'static str,
    tower: TowerDescription,
    (method, segments, bending, torsion, axial): Column,
) -> Case {
    let mut expected = Expected::series(Family::ForeAft, bending);
    for (family, text) in [(Family::Torsion, torsion), (Family::Axial, axial)] {
        let value = Expected::of(family, 1, text);
        expected.push(with_misprint(value, (source, method, segments, family)));
    }
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source,
        subject: Subject::tower(tower),
        remark: "",
        unit: Unit::HZ,
        digits: Digits::Printed,
        expected,
        runs: vec![Run::of(method, segments)],
    }
}

/// The value, marked if it is one of the misprints.
fn with_misprint(value: Expected, place: (&str, Method, usize, Family)) -> Expected {
    let mut misprints = MISPRINTS.iter();
    let found = misprints
        .find(|&&(source, segments, family, ..)| place == (source, Method::Rmje, segments, family));
    match found {
        Some(&(.., correct, reason)) => value.instead_of(correct, reason),
        None => value,
    }
}
