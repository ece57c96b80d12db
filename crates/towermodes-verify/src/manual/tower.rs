//! The reference tower as a beam.

use towermodes::{Family, Shear, TowerDescription};

use super::Chapter;
use super::uniform::{runs, runs_without_rotary_inertia};
use crate::case::{Case, Run, Unit};
use crate::expected::{Digits, Expected};
use crate::towers::{reference, reference_350t, reference_with_machine};

pub(super) const CHAPTER: Chapter = Chapter {
    name: "tower",
    title: "The reference tower as a beam",
    introduction: "The limit of all methods: the reference tower as an Euler-Bernoulli, a Rayleigh and a Timoshenko beam, from Ritz solutions with 40 or \
        more digits.",
};

pub(super) fn cases() -> Vec<Case> {
    let bending = |values: &[&str]| Expected::series(Family::ForeAft, values);
    let mut rayleigh = bending(&["0.89126241", "4.35371186", "11.24619532", "21.33701097"]);
    rayleigh.push(Expected::of(Family::Torsion, 1, "11.9613216"));
    rayleigh.push(Expected::of(Family::Axial, 1, "16.5228378"));
    let mut heavy = bending(&["0.30020574", "3.0452761", "9.0970095"]);
    heavy.push(Expected::of(Family::Axial, 1, "7.1141451"));
    let mut machine = bending(&["0.28678522", "2.07484399", "4.92265"]);
    let side_side = ["0.28425472", "1.73461203", "4.58349"];
    machine.extend(Expected::series(Family::SideSide, &side_side));
    let euler = bending(&[
        "0.8921691544",
        "4.3781396436",
        "11.4006474352",
        "21.8835803280",
        "35.8568026965",
    ]);
    let half = bending(&[
        "0.885153338",
        "4.206221834",
        "10.435474971",
        "18.846211207",
        "28.866082698",
    ]);
    let cowper = bending(&["0.885502299", "4.214341967", "10.477621612"]);
    vec![
        case("Rayleigh", reference(), rayleigh, runs()),
        case(
            "Rayleigh, 350 t point mass",
            reference_350t(),
            heavy,
            runs(),
        ),
        case(
            "Euler-Bernoulli",
            reference(),
            euler,
            runs_without_rotary_inertia(),
        ),
        case(
            "Euler-Bernoulli, 350 t point mass",
            reference_350t(),
            bending(&["0.3002420125", "3.0523001605", "9.1717458683"]),
            runs_without_rotary_inertia(),
        ),
        case(
            "Euler-Bernoulli, RNA with inertia",
            reference_with_machine(),
            machine,
            runs_without_rotary_inertia(),
        ),
        case("Timoshenko, κ = 0.5", sheared(0.5), half, runs()),
        case(
            "Timoshenko, κ of a thin tube",
            sheared(thin_tube()),
            cowper,
            runs(),
        ),
    ]
}

fn sheared(kappa: f64) -> TowerDescription {
    TowerDescription {
        shear: Shear::Coefficient(kappa),
        ..reference()
    }
}

/// Cowper's κ of a thin tube of this steel, 2(1+ν)/(4+3ν) = 0.53057.
fn thin_tube() -> f64 {
    let nu = reference().materials[0].poissons_ratio();
    2.0 * (1.0 + nu) / (4.0 + 3.0 * nu)
}

fn case(name: &str, tower: TowerDescription, expected: Vec<Expected>, runs: Vec<Run>) -> Case {
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: "Ritz solution in 40 digits or more",
        tower,
        unit: Unit::HZ,
        digits: Digits::Computed,
        expected,
        runs,
    }
}
