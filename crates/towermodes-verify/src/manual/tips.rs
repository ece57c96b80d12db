//! A uniform beam that carries a mass on its tip.

use super::Chapter;
use super::uniform::{bending_case, runs, runs_without_rotary_inertia};
use crate::case::Case;
use crate::towers::Uniform;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "tips",
    title: "Uniform beams with a mass on top",
    introduction: "A clamped uniform Euler-Bernoulli beam with a tip mass μ = M/(mL), its inertia j = J/(mL³) about its centre and the \
        centre ε = e/L above the tip. Frequencies must fall as j rises; a published table of this case has them rise, by a wrong sign, \
        and is not used.",
};

const TIP_MASS: [(f64, &[&str]); 6] = [
    (0.1, &["2.96783835", "19.35580101", "55.51824555"]),
    (0.5, &["2.01629898", "16.90141772", "51.70092089"]),
    (
        1.0,
        &["1.55729786", "16.25008516", "50.89584283", "105.19827585"],
    ),
    (1.3, &["1.39719417", "16.07649805", "50.69306613"]),
    (5.0, &["0.756937339", "15.60234588", "50.16233890"]),
    (10.0, &["0.541375033", "15.51151312", "50.06434697"]),
];

/// (μ, j, ε).
const TIP_BODY: [([f64; 3], &[&str]); 7] = [
    (
        [1.0, 0.01, 0.0],
        &["1.54367680", "13.23958856", "32.06958081"],
    ),
    (
        [1.0, 0.1, 0.0],
        &["1.42962634", "6.27532570", "24.75160447"],
    ),
    (
        [1.0, 1.0, 0.0],
        &["0.867899771", "3.39057215", "24.01855767"],
    ),
    (
        [1.0, 0.0, 0.1],
        &["1.38612621", "13.54779090", "42.80136353"],
    ),
    (
        [1.0, 0.01, 0.1],
        &["1.37573374", "11.85106268", "33.76276317"],
    ),
    (
        [1.3, 0.02, 0.0224],
        &["1.34027316", "11.06198354", "28.56469155", "65.25837468"],
    ),
    (
        [0.5, 0.05, 0.2],
        &["1.57345557", "8.30098534", "28.39532770"],
    ),
];

pub(super) fn cases() -> Vec<Case> {
    let source = "frequency equation, 40 digits";
    let mut cases = Vec::new();
    for (mu, values) in TIP_MASS {
        let beam = Uniform::new(0.01, None).with_tip(mu, 0.0, 0.0);
        let (name, runs) = (format!("μ = {mu}"), runs_without_rotary_inertia());
        cases.push(bending_case(CHAPTER, name, source, beam, values, runs));
    }
    for ([mu, j, eps], values) in TIP_BODY {
        let beam = Uniform::new(0.01, None).with_tip(mu, j, eps);
        let name = format!("μ = {mu}, j = {j}, ε = {eps}");
        cases.push(bending_case(
            CHAPTER,
            name,
            source,
            beam,
            values,
            runs_without_rotary_inertia(),
        ));
    }
    let beam = Uniform::new(0.02, Some(5.2)).with_tip(1.3, 0.02, 0.0224);
    cases.push(bending_case(
        CHAPTER,
        "Timoshenko, r = 0.02, s = 5.2, μ = 1.3, j = 0.02, ε = 0.0224".into(),
        source,
        beam,
        &["1.33615395", "10.9082116", "27.3074008", "58.6488251"],
        runs(),
    ));
    cases
}
