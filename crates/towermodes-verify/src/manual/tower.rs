//! The reference tower as a beam.

use towermodes::{Family, Shear, TowerDescription};

use super::uniform::{runs, runs_without_rotary_inertia};
use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::{reference, reference_350t, reference_with_machine};

pub(super) const CHAPTER: Chapter = Chapter {
    name: "tower",
    title: "The reference tower as a beam",
    introduction: "The limit of all methods: the reference tower as an Euler-Bernoulli, a Rayleigh and a Timoshenko beam, from Ritz solutions with 40 or \
        more digits.",
};

pub(super) fn cases() -> Vec<Case> {
    let mut cases = rayleigh().to_vec();
    cases.extend(euler_bernoulli());
    cases.extend(timoshenko());
    cases
}

fn bending(values: &str) -> Vec<Expected> {
    Expected::series(Family::ForeAft, values)
}

fn rayleigh() -> [Case; 2] {
    let mut alone = bending("0.89126241 4.35371186 11.24619532 21.33701097");
    alone.push(Expected::of(Family::Torsion, 1, "11.9613216"));
    alone.push(Expected::of(Family::Axial, 1, "16.5228378"));
    let mut loaded = bending("0.30020574 3.0452761 9.0970095");
    loaded.push(Expected::of(Family::Axial, 1, "7.1141451"));
    let name = "Rayleigh, 350 t point mass";
    [
        case("Rayleigh", reference(), alone, runs()),
        case(name, reference_350t(), loaded, runs()),
    ]
}

fn euler_bernoulli() -> [Case; 3] {
    let alone = "0.8921691544 4.3781396436 11.4006474352 21.8835803280 35.8568026965";
    let loaded = "0.3002420125 3.0523001605 9.1717458683";
    let with_rna = Expected::planes(
        "0.28678522 2.07484399 4.92265",
        "0.28425472 1.73461203 4.58349",
    );
    [
        ("", reference(), bending(alone)),
        (", 350 t point mass", reference_350t(), bending(loaded)),
        (", RNA with inertia", reference_with_machine(), with_rna),
    ]
    .map(|(top, tower, expected)| {
        let name = format!("Euler-Bernoulli{top}");
        case(&name, tower, expected, runs_without_rotary_inertia())
    })
}

fn timoshenko() -> [Case; 2] {
    let half = bending("0.885153338 4.206221834 10.435474971 18.846211207 28.866082698");
    let cowper = bending("0.885502299 4.214341967 10.477621612");
    let name = "Timoshenko, κ of a thin tube";
    [
        case("Timoshenko, κ = 0.5", sheared(0.5), half, runs()),
        case(name, sheared(thin_tube()), cowper, runs()),
    ]
}

fn sheared(kappa: f64) -> TowerDescription {
    TowerDescription {
        shear: Shear::Coefficient(kappa),
        ..reference()
    }
}

/// Cowper's κ of a thin tube with the Poisson's ratio of this steel, 2(1+ν)/(4+3ν) = 0.53057.
fn thin_tube() -> f64 {
    let nu = reference().materials[0].poissons_ratio();
    2.0 * (1.0 + nu) / (4.0 + 3.0 * nu)
}

fn case(name: &str, tower: TowerDescription, expected: Vec<Expected>, runs: Vec<Run>) -> Case {
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: "Ritz solution in 40 digits or more",
        subject: Subject::tower(tower),
        remark: "",
        unit: Unit::HZ,
        digits: Digits::Computed,
        expected,
        runs,
    }
}
