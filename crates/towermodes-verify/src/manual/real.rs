//! The reference tower with everything that couples motions or supports them.

use towermodes::{Family, Method, TowerDescription};

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::{
    floater, reference, reference_350t, reference_eccentric, reference_in_soil,
    reference_on_springs, reference_with_machine,
};

pub(super) const CHAPTER: Chapter = Chapter {
    name: "real",
    title: "Towers as they stand",
    introduction: "The reference tower with gravity, in soil, on springs and on a spar, with an eccentric RNA of 350 t with products of inertia, so that \
        bending, torsion and axial motion are coupled; the modes are then numbered over all types of motion. The inertia of 4.37e7 kg m² about the \
        shaft is that of the OC3 deck of BModes, which multiplies the inertia of the generator by the square of the gearbox ratio; with a locked \
        rotor the turbine has 3.85e7 kg m². The values compare programs with the same input. The results of the chain of rigid bodies are not \
        extrapolated.",
};

/// The error of the chain in the modes listed here, of order n⁻².
const CHAIN_ALLOWANCE: f64 = 2e-4;

fn runs() -> Vec<Run> {
    vec![
        Run::spectral(),
        Run::of(Method::RmjeExact, 400).allowing(CHAIN_ALLOWANCE),
    ]
}

pub(super) fn cases() -> Vec<Case> {
    let mut cases = coupled();
    cases.extend(symmetric());
    cases
}

/// Modes by their index in the list of all modes.
fn coupled() -> Vec<Case> {
    let case = |name, tower, values: &str| {
        let expected = Expected::lowest(values);
        case(name, tower, expected, runs())
    };
    vec![
        case(
            "eccentric RNA",
            reference_eccentric(),
            "0.28390097 0.28670378 1.30002257 1.71993037 2.09202190 4.56106997 4.93514316 7.12327482",
        ),
        case(
            "eccentric RNA, g = 9.81",
            under(9.81, reference_eccentric()),
            "0.27750918 0.28026043 1.30001086 1.71420415 2.08445127 4.55404179 4.92852506 7.12326047",
        ),
        case(
            "eccentric RNA, springs under the base",
            reference_on_springs(),
            "0.26990122 0.27233237 1.28868725 1.65749774 1.99511347 4.23425679 4.61944069 6.78325288",
        ),
        case(
            "spar, eccentric RNA, g = 9.81",
            floater(),
            "0.008031198 0.008031198 0.032229905 0.034838456 0.034853331 0.121916602 0.478595989 0.487809377 1.570319666 2.045508398 2.543901981",
        ),
    ]
}

/// Modes by family: both modes of each bending pair, except for the RNA with inertia.
fn symmetric() -> Vec<Case> {
    let loaded = bending("0.29380746 3.03412617 9.08434108");
    let in_soil = bending("0.44758562 3.17083244 9.13145409");
    let soil = "350 t point mass, g = 9.81, soil of 1e5 N/m² over the whole height";
    let mut cases = vec![
        case(
            "350 t point mass, g = 9.81",
            under(9.81, reference_350t()),
            loaded,
            runs(),
        ),
        case(soil, under(9.81, reference_in_soil()), in_soil, runs()),
    ];
    cases.extend(euler_bernoulli());
    cases
}

fn bending(values: &str) -> Vec<Expected> {
    Expected::series(Family::ForeAft, values)
}

fn euler_bernoulli() -> [Case; 3] {
    let alone = "0.88950108 4.37569464 11.39818245";
    let loaded = "0.29384518 3.04112951 9.15897821";
    let with_rna = Expected::planes(
        "0.28034873 2.06737908 4.91600683",
        "0.27786386 1.72881893 4.57646947",
    );
    [
        ("", reference(), bending(alone)),
        (", 350 t point mass", reference_350t(), bending(loaded)),
        (", RNA with inertia", reference_with_machine(), with_rna),
    ]
    .map(|(top, tower, expected)| {
        let name = format!("Euler-Bernoulli{top}, g = 9.80665");
        let runs = runs().into_iter().map(Run::without_rotary_inertia);
        case(&name, under(9.80665, tower), expected, runs.collect())
    })
}

fn under(gravity_m_per_s2: f64, tower: TowerDescription) -> TowerDescription {
    TowerDescription {
        gravity_m_per_s2,
        ..tower
    }
}

fn case(name: &str, tower: TowerDescription, expected: Vec<Expected>, runs: Vec<Run>) -> Case {
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: "two independent Ritz solutions",
        subject: Subject::tower(tower),
        remark: "",
        unit: Unit::HZ,
        digits: Digits::Computed,
        expected,
        runs,
    }
}
