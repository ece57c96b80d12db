//! Uniform beams: Euler-Bernoulli, Rayleigh, Timoshenko; rods.

use towermodes::{Family, Method};

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::Uniform;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "uniform",
    title: "Uniform beams",
    introduction: "A clamped uniform beam. The values are λ in ω = λ √(EI/(mL⁴)); r = √(I/A)/L is the slenderness and s = E/(κG). For \
        rods they are β in ω = β √(E/ρ)/L, or √(G/ρ) in torsion.",
};

/// The error of a chain of rigid bodies after extrapolation: of order n⁻⁴, and proportional to the
/// fourth power of the order of the mode.
const CHAIN_ALLOWANCE: f64 = 2e-8;

/// The runs of the reference beam: reference solution, and the default method extrapolated.
pub(super) fn runs() -> Vec<Run> {
    vec![
        Run::spectral(),
        Run::extrapolated(Method::RmjeExact, 800, CHAIN_ALLOWANCE),
    ]
}

pub(super) fn runs_without_rotary_inertia() -> Vec<Run> {
    runs()
        .into_iter()
        .map(Run::without_rotary_inertia)
        .collect()
}

/// A case of dimensionless bending frequencies known to about a unit of their last digit.
pub(super) fn bending_case(
    chapter: Chapter,
    name: String,
    source: &'static str,
    beam: Uniform,
    values: &str,
    runs: Vec<Run>,
) -> Case {
    Case {
        chapter,
        name,
        source,
        remark: "",
        unit: Unit::dimensionless(beam.unit_hz),
        subject: Subject::tower(beam.description),
        digits: Digits::Computed,
        expected: Expected::series(Family::ForeAft, values),
        runs,
    }
}

const RAYLEIGH: [(f64, &str); 4] = [
    (0.01, "3.51519844 21.99885939 61.46012685 120.04718119"),
    (0.02, "3.51275106 21.89294826 60.76491472 117.58782978"),
    (0.05, "3.49574816 21.19068974 56.48625593 103.82375334"),
    (0.1, "3.43680762 19.13637025 46.49355294 78.21309740"),
];

const TIMOSHENKO: [(f64, f64, &str); 5] = [
    (
        0.02,
        3.12,
        "3.50264107 21.46982418 58.14983171 109.02914327",
    ),
    (0.02, 5.2, "3.49594476 21.20042304 56.58123949 104.24462738"),
    (0.05, 5.2, "3.39648755 18.00128078 42.30363627 69.52644438"),
    (0.1, 3.12, "3.22712776 14.46892810 31.50253891 47.90901878"),
    (0.1, 5.2, "3.10464548 12.76142890 27.06648650 39.78129211"),
];

pub(super) fn cases() -> Vec<Case> {
    let euler = "3.51601527 22.03449156 61.69721441 120.90191605 199.85953012";
    let mut cases = vec![bending_case(
        CHAPTER,
        "Euler-Bernoulli".into(),
        "cos β cosh β = −1, λ = β²",
        Uniform::new(0.01, None),
        euler,
        runs_without_rotary_inertia(),
    )];
    for (r, values) in RAYLEIGH {
        let name = format!("Rayleigh, r = {r}");
        let beam = Uniform::new(r, None);
        let source = "40-digit Ritz solution";
        cases.push(bending_case(CHAPTER, name, source, beam, values, runs()));
    }
    for (r, s, values) in TIMOSHENKO {
        let name = format!("Timoshenko, r = {r}, s = {s}");
        let beam = Uniform::new(r, Some(s));
        let source = "frequency equation of Timoshenko's beam, 40 digits";
        cases.push(bending_case(CHAPTER, name, source, beam, values, runs()));
    }
    let (young_pa, shear_pa) = (Uniform::YOUNGS_MODULUS_PA, 0.4 * Uniform::YOUNGS_MODULUS_PA);
    cases.extend([
        rod("rod in torsion", Family::Torsion, shear_pa, 0.0),
        rod("rod axially", Family::Axial, young_pa, 0.0),
        rod(
            "rod axially, tip mass of its own mass",
            Family::Axial,
            young_pa,
            1.0,
        ),
    ]);
    cases
}

/// A uniform rod with a tip mass that is `mu` times its own mass.
fn rod(name: &str, family: Family, modulus_pa: f64, mu: f64) -> Case {
    let wave_m_per_s = (modulus_pa / Uniform::DENSITY_KG_PER_M3).sqrt();
    let (source, values) = if mu == 0.0 {
        ("β = (2k − 1) π/2", "1.5707963268 4.7123889804 7.8539816340")
    } else {
        ("β tan β = 1", "0.8603335890 3.4256184595 6.4372981792")
    };
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source,
        subject: Subject::tower(Uniform::new(0.02, None).with_tip(mu, 0.0, 0.0).description),
        remark: "",
        unit: Unit::dimensionless(wave_m_per_s / Uniform::LENGTH_M / std::f64::consts::TAU),
        digits: Digits::Computed,
        expected: Expected::series(family, values),
        runs: runs(),
    }
}
