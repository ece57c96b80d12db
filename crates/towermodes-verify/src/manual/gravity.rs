//! Uniform columns under gravity, and their buckling loads.

use towermodes::{Method, TowerDescription};

use super::uniform::{bending_case, runs_without_rotary_inertia};
use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::{Uniform, reference_350t, reference_eccentric};

pub(super) const CHAPTER: Chapter = Chapter {
    name: "gravity",
    title: "Columns under gravity",
    introduction: "A clamped uniform Euler-Bernoulli column under its own weight α = m g L³/(EI) and the weight of a tip mass μ = M/(mL) with its centre \
        ε = e/L above the tip. At the buckling load, α = 7.8373 without tip mass, the frequency is zero; the buckling load factor is the factor \
        on gravity that leads to this load.",
};

const COLUMN: [(f64, &str); 7] = [
    (0.5, "3.40246006 21.93615108 61.59600931"),
    (1.0, "3.28492338 21.83734378 61.49460759"),
    (2.0, "3.03603660 21.63830299 61.29121007"),
    (4.0, "2.46296720 21.23432817 60.88200906"),
    (6.0, "1.70527448 20.82211274 60.46954209"),
    (7.0, "1.15155323 20.61276058 60.26206154"),
    (7.8, "0.243259605 20.44366115 60.09547016"),
];

const SOURCE: &str = "power series of the column's equation, 40 digits";

/// Near buckling λ² is the small difference of elastic and geometric stiffness. Its relative
/// sensitivity to either is larger by the factor 1/(1 − α/7.84), and so is the error after
/// extrapolation.
const NEAR_BUCKLING: f64 = 1e-6;

pub(super) fn cases() -> Vec<Case> {
    let column = COLUMN.map(|(alpha, values)| {
        let beam = Uniform::new(0.01, None).under_gravity(alpha);
        let near = |run: Run| if alpha > 6.5 { sensitive(run) } else { run };
        let runs = runs_without_rotary_inertia().into_iter().map(near);
        let name = format!("α = {alpha}");
        bending_case(CHAPTER, name, SOURCE, beam, values, runs.collect())
    });
    let combined = bending_case(
        CHAPTER,
        "α = 0.1, μ = 1.3, ε = 0.0224".into(),
        SOURCE,
        tipped(),
        "1.31276038 15.33192959 48.44664495",
        runs_without_rotary_inertia(),
    );
    column
        .into_iter()
        .chain([combined])
        .chain(buckling())
        .collect()
}

fn sensitive(run: Run) -> Run {
    let allowance = match run.options.method {
        Method::Spectral => 1e-8,
        _ => NEAR_BUCKLING,
    };
    run.allowing(allowance)
}

/// A column with little self-weight and a heavier tip mass.
fn tipped() -> Uniform {
    Uniform::new(0.01, None)
        .with_tip(1.3, 0.0, 0.0224)
        .under_gravity(0.1)
}

fn buckling() -> Vec<Case> {
    let column = Uniform::new(0.01, None).under_gravity(2.0).description;
    let gravity = |description| TowerDescription {
        gravity_m_per_s2: 9.81,
        ..description
    };
    vec![
        // 7.83734743894348/2: the zero of J₋₁⸝₃ at (2/3)√α.
        load("α = 2", "J₋₁⸝₃(⅔ √α) = 0", column, "3.9186737195"),
        load(
            "α = 0.1, μ = 1.3, ε = 0.0224",
            "Ritz solution",
            tipped().description,
            "14.887608569",
        ),
        load(
            "reference tower, 350 t point mass",
            "Ritz solution",
            gravity(reference_350t()),
            "23.24945367",
        ),
        load(
            "reference tower, eccentric RNA",
            "Ritz solution",
            gravity(reference_eccentric()),
            "22.11544391",
        ),
    ]
}

fn load(name: &str, source: &'static str, tower: TowerDescription, factor: &str) -> Case {
    Case {
        chapter: CHAPTER,
        name: format!("buckling, {name}"),
        source,
        subject: Subject::tower(tower),
        remark: "",
        unit: Unit::NONE,
        digits: Digits::Computed,
        expected: vec![Expected::buckling_load_factor(factor)],
        runs: vec![
            // The degree is raised until the frequencies converge, not the load factor.
            Run::spectral().allowing(1e-9),
            // Joints instead of curvature: error (κl)²/12 with κ ≈ 2/L, and that of a taper.
            Run::of(Method::RmjeExact, 800).allowing(5e-6),
        ],
    }
}
