//! Tapered beams.

use towermodes::{Family, Method};

use crate::case::{Case, Run, Unit};
use crate::chapter::Chapter;
use crate::expected::{Digits, Expected};
use crate::subject::Subject;
use crate::towers::Tapered;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "tapers",
    title: "Tapered beams",
    introduction: "Euler-Bernoulli cantilevers, clamped at the large end: λ in ω = λ √(EI₀/(m₀L⁴)) with the properties of the clamped end. The wedge (A ∝ 1 − cx, \
        I ∝ (1 − cx)³) is a tapered tube with a wall of 1e-9 times its diameter; the linearly tapered width (A, I ∝ 1 − cx) is a table of two rows, \
        with four times the stiffness in the side-side plane; the cone (A ∝ (1 − cx)², I ∝ (1 − cx)⁴) is a solid rod. The cone with c = 1 has a tip \
        of 1e-9 times its base diameter.",
};

const WEDGE: [(f64, &str); 4] = [
    (0.2, "3.60827487 20.62101759 56.19227837"),
    (0.5, "3.82378485 18.31726090 47.26482701 90.45047766"),
    (0.8, "4.29249454 15.74270017 36.88455326"),
    (0.9, "4.63072386 14.93079267 32.83312118"),
];

const WIDTH: [(f64, &str); 4] = [
    (0.2, "3.76285907 22.50181397 62.15251626"),
    (0.5, "4.31517030 23.51925664 63.19919642"),
    (0.8, "5.39758833 25.65582730 65.74696073"),
    (0.9, "6.07038679 27.29894404 68.11449600"),
];

const CONE: [(f64, &str); 5] = [
    (0.2, "3.85511680 21.05674543 56.63034506"),
    (0.5, "4.62515025 19.54761318 48.57889933 91.81276826"),
    (0.8, "6.19639101 18.38546739 39.83362986"),
    (0.9, "7.2048716486 18.6801611890 37.1238343594"),
    (1.0 - 1e-9, "8.719259 21.145662 38.453771 60.680139"),
];

/// Depth ratio 4, width ratios 4 and 5: λ of the small end.
const SDLL09: [(f64, &str); 2] = [
    (4.0, "23.292263 73.918819 165.285370 299.779885 478.180089"),
    (5.0, "24.311231 75.577907 167.251966 301.933697 480.458534"),
];

const LITERATURE: &str =
    "Downs 1977; Mabie & Rogers 1972; Naguleswaran 1994; more digits by a 40-digit Ritz solution";

fn spectral() -> Run {
    Run::spectral().without_rotary_inertia()
}

/// The error of equal segments increases with the taper c.
fn chain(c: f64) -> Run {
    let allowance = if c > 0.85 { 1e-7 } else { 3e-8 };
    Run::extrapolated(Method::RmjeExact, 800, allowance).without_rotary_inertia()
}

pub(super) fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for (c, values) in WEDGE {
        // The wall is 1e-9 times the diameter at the base; this ratio increases upwards.
        let thin = 1e-9 / (1.0 - c);
        let runs = vec![spectral().allowing(thin), chain(c).allowing(1e-7)];
        cases.push(case(
            &format!("wedge, c = {c}"),
            Tapered::wedge(c, 0.0),
            values,
            runs,
        ));
    }
    for (c, values) in WIDTH {
        let beam = Tapered::width(c);
        cases.push(case(
            &format!("width, c = {c}"),
            beam,
            values,
            vec![spectral(), chain(c)],
        ));
    }
    for (c, values) in CONE {
        let (name, runs) = match c > 0.95 {
            true => ("cone, c = 1".to_owned(), vec![spectral()]),
            false => (format!("cone, c = {c}"), vec![spectral(), chain(c)]),
        };
        cases.push(case(&name, Tapered::cone(c), values, runs));
    }
    for (ratio, values) in SDLL09 {
        // The unit is that of the small end, whose depth is a quarter.
        let mut beam = Tapered::wedge(0.75, 1.0 - 1.0 / ratio);
        beam.unit_hz *= 0.25;
        let name = format!("depth ratio 4, width ratio {ratio}, λ of the small end");
        cases.push(case(&name, beam, values, vec![spectral().allowing(5e-9)]));
    }
    cases
}

fn case(name: &str, beam: Tapered, values: &str, runs: Vec<Run>) -> Case {
    Case {
        chapter: CHAPTER,
        name: name.into(),
        source: LITERATURE,
        remark: "",
        unit: Unit::dimensionless(beam.unit_hz),
        subject: Subject::tower(beam.description),
        digits: Digits::Computed,
        expected: Expected::series(Family::ForeAft, values),
        runs,
    }
}
