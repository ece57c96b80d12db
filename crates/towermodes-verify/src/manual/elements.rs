//! The elements compared with independent dense solutions, which have more digits than the paper.

use towermodes::{Family, Method, TowerDescription};

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::{reference, reference_350t};

pub(super) const CHAPTER: Chapter = Chapter {
    name: "elements",
    title: "The elements, more digits",
    introduction: "The same elements on the same tower compared with independent solutions by dense matrices, with more digits than in the paper.",
};

const SOURCE: &str = "independent dense solution";

/// Method, segments, 350 t point mass, bending, torsion, axial.
type Solution = (Method, usize, bool, &'static str, Option<[&'static str; 2]>);

const SOLUTIONS: [Solution; 9] = [
    (
        Method::Rmje,
        60,
        false,
        "0.89118235 4.35252508 11.23882895 21.31042958",
        Some(["11.8832344", "16.4362808"]),
    ),
    (
        Method::Cardanic,
        10,
        false,
        "0.8878359 4.3346322 11.193374",
        None,
    ),
    (
        Method::Cardanic,
        20,
        false,
        "0.8904036 4.3489152 11.2329341",
        None,
    ),
    (
        Method::Cardanic,
        10,
        true,
        "0.2996087 3.0369401 9.0699751",
        None,
    ),
    (
        Method::Cardanic,
        20,
        true,
        "0.3000564 3.0431939 9.0903078",
        None,
    ),
    (
        Method::Lumped,
        20,
        false,
        "0.8905483969 4.3432510318 11.1815469657",
        Some(["11.946278", "16.511351"]),
    ),
    (
        Method::Lumped,
        20,
        true,
        "0.3000646260 3.0394682000 9.0494833116",
        None,
    ),
    (
        Method::Bmodes,
        20,
        false,
        "0.891309 4.373352 11.387920",
        Some(["11.951946", "16.517106"]),
    ),
    (
        Method::Bmodes,
        50,
        true,
        "0.300218 3.051969 9.170718",
        Some(["11.959821", "7.114097"]),
    ),
];

pub(super) fn cases() -> Vec<Case> {
    SOLUTIONS.into_iter().map(case).collect()
}

fn case((method, segments, has_top_mass, bending, others): Solution) -> Case {
    let (name, tower): (&str, TowerDescription) = if has_top_mass {
        ("350 t point mass", reference_350t())
    } else {
        ("no point mass", reference())
    };
    let mut expected = Expected::series(Family::ForeAft, bending);
    if let Some([torsion, axial]) = others {
        expected.push(Expected::of(Family::Torsion, 1, torsion));
        expected.push(Expected::of(Family::Axial, 1, axial));
    }
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: SOURCE,
        subject: Subject::tower(tower),
        remark: "",
        unit: Unit::HZ,
        digits: Digits::Computed,
        expected,
        runs: vec![Run::of(method, segments)],
    }
}
