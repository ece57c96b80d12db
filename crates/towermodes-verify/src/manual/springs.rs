//! Uniform beams on springs.

use super::uniform::{bending_case, runs_without_rotary_inertia};
use crate::case::Case;
use crate::chapter::Chapter;
use crate::towers::Uniform;

pub(super) const CHAPTER: Chapter = Chapter {
    name: "springs",
    title: "Uniform beams on springs",
    introduction: "A uniform Euler-Bernoulli beam with a translational spring k_T = K_T L³/(EI) and a rotational spring k_R = K_R L/(EI) at its base, clamped \
        vertically and in torsion. With only a rocking spring it has the frequencies of a clamped beam with the tip mass μ = 1/k_R.",
};

const RIGID: f64 = f64::INFINITY;

/// k_T, k_R.
const SPRINGS: [([f64; 2], &str); 8] = [
    (
        [RIGID, 1.0],
        "1.55729786 16.25008516 50.89584283 105.19827585",
    ),
    ([RIGID, 10.0], "2.96783835 19.35580101 55.51824555"),
    ([RIGID, 100.0], "3.44765788 21.61995637 60.56997163"),
    ([10.0, 10.0], "2.27356625 6.79308903 28.52682664"),
    ([100.0, 100.0], "3.32236744 14.24690373 33.84678500"),
    ([1000.0, 100.0], "3.43498753 20.64908442 52.63408971"),
    ([1000.0, 1000.0], "3.49575737 20.97243122 53.10793196"),
    // Nearly free: the first mode is √(0.01), except for the inertia of bending.
    ([0.01, 100.0], "0.0999737522 5.52540072 29.93764202"),
];

/// The same quantities with a tip mass μ = 1.3.
const SPRINGS_AND_TIP: [([f64; 2], &str); 3] = [
    ([RIGID, 10.0], "1.21781731 14.05509831 45.42558088"),
    ([RIGID, 100.0], "1.37565700 15.77747054 49.76673411"),
    ([1000.0, 100.0], "1.37327244 15.28768445 44.51194471"),
];

pub(super) fn cases() -> Vec<Case> {
    let bare = SPRINGS.map(|(springs, values)| case(springs, 0.0, values));
    let carrying = SPRINGS_AND_TIP.map(|(springs, values)| case(springs, 1.3, values));
    bare.into_iter().chain(carrying).collect()
}

fn case([k_t, k_r]: [f64; 2], mu: f64, values: &str) -> Case {
    let beam = Uniform::new(0.01, None)
        .with_tip(mu, 0.0, 0.0)
        .on_springs(k_t, k_r);
    let tip = if mu == 0.0 {
        String::new()
    } else {
        format!(", μ = {mu}")
    };
    let lateral = if k_t == RIGID {
        "∞".into()
    } else {
        k_t.to_string()
    };
    bending_case(
        CHAPTER,
        format!("k_T = {lateral}, k_R = {k_r}{tip}"),
        "frequency equation, 40 digits",
        beam,
        values,
        runs_without_rotary_inertia(),
    )
}
