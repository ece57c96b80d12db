//! Rigid rods on lag hinges on an elastic support: the rotor that Coleman & Feingold, NACA TR 1351
//! (1958), solved, with whirls of negative energy and ground resonance.
//!
//! The characteristic equation, with l = w²:
//!
//! Y Z A₊ A₋ − c (Y + Z)(A₊ + A₋) + 4 c² = 0, c = N/4 S² l²,
//!
//! A± = k + Ω² e S − I (w ∓ Ω)², Y and Z = k − M l; the roots are those of this polynomial.

use std::f64::consts::TAU;

use super::assert_near;
use towermodes::internal::beam::Condensed;
use towermodes::internal::rotor::{Multiblade, TurningBody};
use towermodes::turbine::Complex;

/// Mass (kg), length (m), distance of the hinge (m), spring (N m/rad) of a rod.
const MASS: f64 = 60.0;
const LENGTH: f64 = 5.0;
const HINGE: f64 = 0.3;
const SPRING: f64 = 1500.0;
/// Mass of the support, kg.
const SUPPORT: f64 = 500.0;

type Matrix7 = [[f64; 7]; 7];

/// A rod in the frame that turns with the rotor: the motion of the apex and its lag angle.
struct Rod;

impl Rod {
    /// M, C and K_g − S: sums over two Gauss points, exact for a rigid rod.
    fn matrices() -> [Matrix7; 3] {
        let mut sums = [[[0.0; 7]; 7]; 3];
        for sign in [-1.0, 1.0] {
            let r = 0.5 * LENGTH * (1.0 + sign / 3_f64.sqrt());
            let (mass, x) = (0.5 * MASS, HINGE + r);
            // Rows: motion along the axis, against the rotation, outwards.
            let motion = [
                [1.0, 0.0, 0.0, 0.0, x, 0.0, 0.0],
                [0.0, 1.0, 0.0, -x, 0.0, 0.0, r],
                [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
            ];
            for i in 0..7 {
                for j in 0..7 {
                    let product = |a: usize, b: usize| mass * motion[a][i] * motion[b][j];
                    sums[0][i][j] += product(0, 0) + product(1, 1) + product(2, 2);
                    sums[1][i][j] += product(2, 1) - product(1, 2);
                    sums[2][i][j] -= product(1, 1) + product(2, 2);
                }
            }
            // What the second order of the motion moves inwards.
            sums[2][3][3] += mass * x * x;
            sums[2][4][4] += mass * x * x;
            sums[2][3][6] -= mass * x * r;
            sums[2][6][3] -= mass * x * r;
            sums[2][6][6] += mass * x * r;
        }
        sums
    }
}

impl TurningBody for Rod {
    fn seen_from_apex(&mut self, s: f64, speed: f64) -> Condensed {
        let [mass, coriolis, spin] = Self::matrices();
        let entry = |i: usize, j: usize| {
            let spring = if (i, j) == (6, 6) { SPRING } else { 0.0 };
            Complex::new(
                spring + speed * speed * spin[i][j] - s * s * mass[i][j],
                2.0 * s * speed * coriolis[i][j],
            )
        };
        let pivot = entry(6, 6).re;
        let matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let through = entry(i, 6) * entry(6, j);
                entry(i, j) - Complex::new(through.re / pivot, through.im / pivot)
            })
        });
        Condensed {
            matrix,
            negative: usize::from(pivot < 0.0),
        }
    }
}

/// The number of negative eigenvalues of rotor and support at a frequency and a speed, Hz.
fn count(springs: [f64; 2], frequency_hz: f64, speed_hz: f64) -> usize {
    let w = TAU * frequency_hz;
    let mut rotor = Multiblade::new(Rod, 3).expect("three rods");
    let hub = rotor.seen_from_hub(w, TAU * speed_hz);
    let own = springs.map(|spring| spring - SUPPORT * w * w);
    let (y, z) = (hub.matrix[1][1].re + own[0], hub.matrix[2][2].re + own[1]);
    let between = hub.matrix[1][2];
    let rest = z - (between.re * between.re + between.im * between.im) / y;
    hub.negative + usize::from(y < 0.0) + usize::from(rest < 0.0)
}

/// A frequency in Hz and the count there.
type At = (f64, usize);

/// Where the count changes up to 8 Hz, and whether it falls there: a mode of negative energy.
fn steps(springs: [f64; 2], speed_hz: f64) -> Vec<(f64, bool)> {
    let at = |hz: f64| (hz, count(springs, hz, speed_hz));
    let mut found = Vec::new();
    let mut low = at(0.0);
    // A grid without common measure with the speeds.
    for k in 1..=20_000 {
        let high = at(f64::from(k) * 8.0 / 20_011.3);
        halve(low, high, &at, &mut found);
        low = high;
    }
    found
}

/// Halves an interval whose counts differ until nothing is left of it.
fn halve(low: At, high: At, at: &impl Fn(f64) -> At, found: &mut Vec<(f64, bool)>) {
    if high.1 == low.1 {
        return;
    }
    if high.0 - low.0 < 1e-13 {
        let change = high.1.abs_diff(low.1);
        found.extend(std::iter::repeat_n((high.0, high.1 < low.1), change));
        return;
    }
    let middle = at(0.5 * (low.0 + high.0));
    halve(low, middle, at, found);
    halve(middle, high, at, found);
}

const ROUND: [f64; 2] = [4e5, 4e5];
const UNEQUAL: [f64; 2] = [4e5, 7e5];

/// Nine decimals are given.
#[track_caller]
fn assert_modes(springs: [f64; 2], speed_hz: f64, exact: &[f64], falling: &[f64], negative: usize) {
    let steps = steps(springs, speed_hz);
    let mut all: Vec<f64> = exact.to_vec();
    all.sort_by(f64::total_cmp);
    let frequencies: Vec<f64> = steps.iter().map(|step| step.0).collect();
    let smallest = all.first().copied().unwrap_or(1.0);
    assert_near(&frequencies, &all, 6e-10 / smallest);
    let found = steps.iter().filter(|step| step.1).map(|step| step.0);
    assert_near(&found.collect::<Vec<_>>(), falling, 6e-10 / smallest);
    assert_eq!(count(springs, 0.0, speed_hz), negative);
}

#[test]
fn rods_on_a_round_support_vibrate_as_the_polynomial() {
    let single = [4.068248665; 2];
    // At rest rods that whirl either way have one frequency.
    let at_rest = [0.275594375, 0.275594375, 0.275664448, single[0], single[1]];
    assert_modes(ROUND, 0.0, &at_rest, &[], 0);
    let slow = [
        0.082118033,
        0.481473306,
        4.047650605,
        4.092376965,
        0.282118570,
    ];
    assert_modes(ROUND, 0.2, &slow, &[], 0);
}

#[test]
fn rods_that_turn_faster_than_they_vibrate_have_a_mode_of_negative_energy() {
    let exact = [
        0.010015711,
        0.588569580,
        4.038471069,
        4.106008227,
        0.289984289,
    ];
    assert_modes(ROUND, 0.3, &exact, &[0.010015711], 2);
    let exact = [
        0.593621371,
        1.372708579,
        3.989625007,
        4.243703221,
        0.407419793,
    ];
    assert_modes(ROUND, 1.0, &exact, &[0.593621371], 2);
    let exact = [
        1.359691190,
        2.343329209,
        3.948487791,
        4.686283719,
        0.660296061,
    ];
    assert_modes(ROUND, 2.0, &exact, &[1.359691190], 2);
    let exact = [
        0.593393701,
        1.380363570,
        4.105240143,
        5.427614499,
        0.407419793,
    ];
    assert_modes(UNEQUAL, 1.0, &exact, &[0.593393701], 2);
}

/// A whirl that meets a mode of the support is unstable: its frequency is complex, and the falling
/// step that the stiffness asks for is missing.
#[test]
fn ground_resonance_is_a_missing_step() {
    let exact = [3.908949289, 6.896773164, 1.231255817];
    assert_modes(ROUND, 4.0, &exact, &[], 2);
    let exact = [4.670480815, 7.214531955, 1.231255817];
    assert_modes(UNEQUAL, 4.0, &exact, &[], 2);
}
