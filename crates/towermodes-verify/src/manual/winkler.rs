//! Uniform beams in soil.

use towermodes::Family;

use super::uniform::{bending_case, runs_without_rotary_inertia};
use crate::case::{Case, Unit};
use crate::chapter::Chapter;
use crate::expected::Expected;
use crate::towers::Uniform;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "winkler",
    title: "Uniform beams in soil",
    introduction: "A clamped uniform Euler-Bernoulli beam in soil with the transverse stiffness k = K L⁴/(EI) per length: every λ² increases by k; torsion and \
        axial motion do not change.",
};

/// √(λ₀² + k) for the λ₀ of the clamped beam.
const VALUES: [(f64, &str); 3] = [
    (1.0, "3.65545666 22.05717159 61.70531798"),
    (100.0, "10.60011148 24.19749612 62.50237009 121.31476953"),
    (1e4, "100.06179273 102.39882235 117.50126070"),
];

pub(super) fn cases() -> Vec<Case> {
    let source = "λ = √(λ₀² + k)";
    let bending = VALUES.map(|(k, values)| {
        let beam = Uniform::new(0.01, None).in_soil(k);
        let runs = runs_without_rotary_inertia();
        bending_case(CHAPTER, format!("k = {k}"), source, beam, values, runs)
    });
    bending.into_iter().chain([rods()]).collect()
}

/// Torsion and axial motion of the beam in soil: β of both rods, which the soil does not change.
fn rods() -> Case {
    let beam = Uniform::new(0.02, None).in_soil(100.0);
    let wave_m_per_s = (Uniform::YOUNGS_MODULUS_PA / Uniform::DENSITY_KG_PER_M3).sqrt();
    let mut case = bending_case(
        CHAPTER,
        "rods, k = 100".into(),
        "β = (2k − 1) π/2, with √(G/E) in torsion",
        beam,
        "",
        runs_without_rotary_inertia(),
    );
    case.unit = Unit::dimensionless(wave_m_per_s / Uniform::LENGTH_M / std::f64::consts::TAU);
    case.expected = Expected::series(Family::Axial, "1.5707963268 4.7123889804");
    // √0.4 of these.
    case.expected.extend(Expected::series(
        Family::Torsion,
        "0.9934588266 2.9803764797",
    ));
    case
}
