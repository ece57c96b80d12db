//! Every method beside the others: observed orders, honest estimates, complete pairs, one limit.
//! Their digits are in the manual.

use crate::towers;

use towermodes::{Family, Method, Options, TowerDescription};
use towermodes_testing::{changed, with};
use towers::{Uniform, assert_close, frequencies, reference, reference_350t, solved};

fn bending(description: &TowerDescription, options: &Options) -> Vec<f64> {
    frequencies(&solved(description, options), Family::ForeAft)
}

fn options(method: Method, segments: usize) -> Options {
    with!(Options, method, segments = Some(segments), modes = 10)
}

/// log₂ of the ratio of successive differences for n, 2n and 4n segments in one bending frequency.
fn order(description: &TowerDescription, base: &Options, n: usize, mode: usize) -> f64 {
    let frequency = |segments| {
        let options = changed!(base.clone(), segments = Some(segments));
        bending(description, &options)[mode - 1]
    };
    let (coarse, middle, fine) = (frequency(n), frequency(2 * n), frequency(4 * n));
    ((coarse - middle) / (middle - fine)).log2()
}

fn assert_order(observed: f64, expected: f64, case: &str) {
    assert!(
        (observed - expected).abs() < 0.1,
        "{case}: observed order {observed:.3}, expected {expected}"
    );
}

#[test]
fn two_hinges_have_order_4_on_a_uniform_euler_bernoulli_beam() {
    let beam = Uniform::new(0.02, None);
    for method in [Method::Cardanic, Method::CardanicExact] {
        let base = changed!(options(method, 0), rotary_inertia = false);
        for mode in [1, 2, 3] {
            let observed = order(&beam.description, &base, 40, mode);
            assert_order(observed, 4.0, &format!("{} {mode}", method.name()));
        }
        // Hinges elsewhere are statically wrong: order 2.
        if method == Method::Cardanic {
            let quarter = changed!(base, hinge_position = 0.25);
            assert_order(order(&beam.description, &quarter, 20, 1), 2.0, "k = 1/4");
        }
    }
}

#[test]
fn bmodes_has_order_4_on_a_uniform_beam_and_2_on_a_taper() {
    let beam = Uniform::new(0.02, None);
    let base = options(Method::Bmodes, 0);
    for mode in [1, 2, 3] {
        let uniform = order(&beam.description, &base, 10, mode);
        assert_order(uniform, 4.0, &format!("uniform {mode}"));
        let case = format!("tapered {mode}");
        assert_order(order(&reference(), &base, 40, mode), 2.0, &case);
    }
}

#[test]
fn exact_hinges_keep_order_4_on_a_taper_without_rotary_inertia() {
    let base = changed!(options(Method::CardanicExact, 0), rotary_inertia = false);
    // The Euler-Bernoulli beam: 0.8921691531, 4.3781396, 11.4006474 Hz (spectral solutions).
    let first = |n| {
        let options = changed!(base.clone(), segments = Some(n));
        bending(&reference(), &options)[0]
    };
    assert_close(first(10), 0.892169153, 1e-6, "10 segments");
    assert_close(first(20), 0.892169153, 1e-7, "20 segments");
    for mode in [1, 2, 3] {
        assert_order(order(&reference(), &base, 40, mode), 4.0, "tapered");
    }
}

#[test]
fn prismatic_sections_or_rotary_inertia_bring_the_order_down_to_2() {
    for method in [Method::Cardanic, Method::CardanicExact, Method::Lumped] {
        for mode in [1, 2, 3] {
            let observed = order(&reference(), &options(method, 0), 100, mode);
            assert_order(observed, 2.0, &format!("{} {mode}", method.name()));
        }
    }
}

fn segmented() -> impl Iterator<Item = Method> {
    Method::ALL
        .into_iter()
        .filter(|&method| method != Method::Spectral)
}

#[test]
fn error_estimates_of_every_element_are_honest() {
    let rayleigh = [0.8912624087, 4.3537118608, 11.2461953172, 21.33701097];
    let euler_bernoulli = [0.8921691544, 4.3781396436, 11.40064744, 21.88358035];
    let truth = |method: Method, family: Family, order: usize| match (family, method) {
        (Family::Torsion, _) => 11.9613216,
        (Family::Axial, _) => 16.5228378,
        (_, Method::Bmodes) => euler_bernoulli[order - 1],
        _ => rayleigh[order - 1],
    };
    // The spectral beam's estimates are below what the reference values have digits for.
    for method in segmented() {
        for segments in [20, 40, 100] {
            for mode in solved(&reference(), &options(method, segments)).modes {
                let error = (mode.frequency_hz - truth(method, mode.family, mode.order)).abs();
                let ratio = mode.discretization_error_hz / error;
                let case = format!(
                    "{}, {segments} segments, {}: {ratio:.3}",
                    method.name(),
                    mode.label()
                );
                assert!(ratio > 1.0 / 3.0 && ratio < 3.0, "{case}");
            }
        }
    }
}

#[test]
fn every_element_finds_both_members_of_every_pair() {
    for method in Method::ALL {
        let solution = solved(&reference_350t(), &options(method, 30));
        let of = |family| frequencies(&solution, family);
        let expected = of(Family::SideSide);
        assert_eq!(of(Family::ForeAft), expected, "{}", method.name());
        assert_eq!(of(Family::ForeAft).len(), 4);
        assert_eq!(solution.certificate.count, 10);
    }
}

#[test]
fn shear_has_the_same_limit_in_every_element() {
    let sheared = changed!(reference(), shear = towermodes::Shear::Coefficient(0.5));
    let truth = [0.885153338, 4.206221834, 10.435474971];
    // BModes has no shear.
    for method in segmented().filter(|&method| method != Method::Bmodes) {
        for mode in solved(&sheared, &options(method, 400)).modes {
            if mode.family == Family::ForeAft && mode.order <= 3 {
                // The published element's third power remains; the others are at n⁻⁴.
                let tolerance = if method == Method::Rmje { 1e-6 } else { 2e-8 };
                let expected = truth[mode.order - 1];
                assert_close(mode.extrapolated_hz, expected, tolerance, method.name());
            }
        }
    }
}
