//! Uniform beams with a tip mass.

use super::uniform::{bending_case, runs, runs_without_rotary_inertia};
use crate::case::Case;
use crate::chapter::Chapter;
use crate::expected::Expected;
use crate::towers::Uniform;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "tips",
    title: "Uniform beams with a mass on top",
    introduction: "A clamped uniform Euler-Bernoulli beam with a tip mass μ = M/(mL), the inertia j = J/(mL³) about its centre, and the \
        centre ε = e/L above the tip. Frequencies must decrease as j increases; in a published table of this case they increase, because of a wrong \
        sign, and the table is not used. With the centre at the fore-aft distance d = x/L from the axis the mass couples side-side bending with \
        torsion, and fore-aft bending with axial motion.",
};

const TIP_MASS: [(f64, &str); 6] = [
    (0.1, "2.96783835 19.35580101 55.51824555"),
    (0.5, "2.01629898 16.90141772 51.70092089"),
    (1.0, "1.55729786 16.25008516 50.89584283 105.19827585"),
    (1.3, "1.39719417 16.07649805 50.69306613"),
    (5.0, "0.756937339 15.60234588 50.16233890"),
    (10.0, "0.541375033 15.51151312 50.06434697"),
];

/// (μ, j, ε).
const TIP_BODY: [([f64; 3], &str); 7] = [
    ([1.0, 0.01, 0.0], "1.54367680 13.23958856 32.06958081"),
    ([1.0, 0.1, 0.0], "1.42962634 6.27532570 24.75160447"),
    ([1.0, 1.0, 0.0], "0.867899771 3.39057215 24.01855767"),
    ([1.0, 0.0, 0.1], "1.38612621 13.54779090 42.80136353"),
    ([1.0, 0.01, 0.1], "1.37573374 11.85106268 33.76276317"),
    (
        [1.3, 0.02, 0.0224],
        "1.34027316 11.06198354 28.56469155 65.25837468",
    ),
    ([0.5, 0.05, 0.2], "1.57345557 8.30098534 28.39532770"),
];

const BESIDE_SOURCE: &str = "frequency equations of bending with torsion and of bending with axial motion, coupled at the tip, 40 digits";

/// r, (μ, j, ε), d and the values of all modes: side-side bending with torsion, and fore-aft
/// bending with axial motion.
///
/// With L = m = EI = 1 a tube has EA = 1/r², GJ = 0.8 (G = 0.4 E) and the polar inertia 2r² per
/// length. For the clamped beam the deflection v is a sum of cosh βx − cos βx and sinh βx − sin βx
/// with λ = β², the twist φ of sin(λ r √2.5 x), the axial displacement u of sin(λ r x). At the tip,
/// with the velocities of the centre of mass divided by λ, y = v + ε v′ + d φ, x = w + ε w′ and z =
/// u − d w′:
///
/// | side-side and torsion | fore-aft and stretch |
/// |---|---|
/// | v‴ = −λ² μ y | w‴ = −λ² μ x |
/// | v″ = λ² (j v′ + μ ε y) | w″ = λ² (j w′ + μ ε x − μ d z) |
/// | 0.8 φ′ = λ² (j φ + μ d y) | u′/r² = λ² μ z |
///
/// The zeros of both determinants, merged, in 40 digits.
const BESIDE: [(f64, [f64; 3], f64, &str); 4] = [
    (
        0.02,
        [1.0, 0.01, 0.0],
        0.1,
        "1.5250884043 1.5302264575 8.0896947241 11.0938752265 13.4914614601 27.3207856633 32.3567687801 53.2207315045",
    ),
    (
        0.02,
        [1.0, 0.0, 0.0],
        0.05,
        "1.5525435946 1.5538723357 15.3437876936 15.5786225048 35.5155574147 36.7517160960 55.5101302347 57.8757496708",
    ),
    (
        0.05,
        [0.5, 0.05, 0.0],
        0.2,
        "1.8171138338 1.8277946074 3.7731029119 7.2175213962 8.2245150504 22.8478473159 26.8871465391 26.9955874950",
    ),
    (
        0.02,
        [1.3, 0.02, 0.0224],
        0.05,
        "1.3360280146 1.3373036256 6.2167017873 10.5800513766 11.0708069426 27.4997466213 28.6468521189 41.6299096267",
    ),
];

pub(super) fn cases() -> Vec<Case> {
    let source = "frequency equation, 40 digits";
    let mut cases = Vec::new();
    let tip_mass = TIP_MASS.map(|(mu, values)| ([mu, 0.0, 0.0], format!("μ = {mu}"), values));
    let tip_body = TIP_BODY.map(|(tip, values)| {
        let [mu, j, eps] = tip;
        (tip, format!("μ = {mu}, j = {j}, ε = {eps}"), values)
    });
    for ([mu, j, eps], name, values) in tip_mass.into_iter().chain(tip_body) {
        let beam = Uniform::new(0.01, None).with_tip(mu, j, eps);
        let runs = runs_without_rotary_inertia();
        cases.push(bending_case(CHAPTER, name, source, beam, values, runs));
    }
    let beam = Uniform::new(0.02, Some(5.2)).with_tip(1.3, 0.02, 0.0224);
    cases.push(bending_case(
        CHAPTER,
        "Timoshenko, r = 0.02, s = 5.2, μ = 1.3, j = 0.02, ε = 0.0224".into(),
        source,
        beam,
        "1.33615395 10.9082116 27.3074008 58.6488251",
        runs(),
    ));
    cases.extend(BESIDE.map(beside));
    cases
}

/// A tip mass beside the axis, which couples the motions.
fn beside((r, [mu, j, eps], d, values): (f64, [f64; 3], f64, &str)) -> Case {
    let beam = Uniform::new(r, None).with_tip(mu, j, eps).with_offset(d);
    let name = format!("r = {r}, μ = {mu}, j = {j}, ε = {eps}, d = {d}");
    let runs = runs_without_rotary_inertia();
    Case {
        expected: Expected::lowest(values),
        ..bending_case(CHAPTER, name, BESIDE_SOURCE, beam, "", runs)
    }
}
