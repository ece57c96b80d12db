//! Observed orders of convergence and honesty of the error estimates.

mod towers;

use towermodes::{Family, Method, Options, Shear, TowerDescription};
use towers::{assert_close, frequencies, reference, reference_350t, rich, solved};

/// True frequencies of the reference tower as a Rayleigh beam (spectral elements, 40 digits).
const BENDING: [f64; 4] = [0.89126241, 4.35371186, 11.24619532, 21.33701097];
const TORSION: f64 = 11.9613216;
const AXIAL: f64 = 16.5228378;

fn frequency(
    description: &TowerDescription,
    method: Method,
    segments: usize,
    family: Family,
    order: usize,
) -> f64 {
    let options = Options {
        method,
        segments: Some(segments),
        modes: 10,
        ..Options::default()
    };
    frequencies(&solved(description, &options), family)[order - 1]
}

/// log₂ of the ratio of successive differences: needs no exact value.
fn observed_order(
    description: &TowerDescription,
    method: Method,
    family: Family,
    order: usize,
) -> f64 {
    let f = |n| frequency(description, method, n, family, order);
    // Multiples of 44 cut every tower used here so that the finer mesh halves the coarser one's segments.
    let (coarse, middle, fine) = (f(88), f(176), f(352));
    ((coarse - middle) / (middle - fine)).log2()
}

fn check_order(description: &TowerDescription, method: Method, family: Family, expected: f64) {
    let observed = observed_order(description, method, family, 1);
    assert!(
        (observed - expected).abs() < 0.05,
        "{} {}: observed order {observed:.3}, expected {expected}",
        method.name(),
        family.name()
    );
}

#[test]
fn the_published_element_has_order_2_in_bending_and_1_in_torsion_and_axially() {
    for description in [reference(), reference_350t()] {
        check_order(&description, Method::Rmje, Family::ForeAft, 2.0);
        check_order(&description, Method::Rmje, Family::Torsion, 1.0);
        check_order(&description, Method::Rmje, Family::Axial, 1.0);
    }
}

#[test]
fn the_exact_element_has_order_2_in_everything() {
    for description in [reference(), reference_350t()] {
        for family in [
            Family::ForeAft,
            Family::SideSide,
            Family::Torsion,
            Family::Axial,
        ] {
            check_order(&description, Method::RmjeExact, family, 2.0);
        }
    }
}

#[test]
fn steps_kinks_materials_and_masses_do_not_spoil_the_order() {
    for family in [
        Family::ForeAft,
        Family::SideSide,
        Family::Torsion,
        Family::Axial,
    ] {
        check_order(&rich(), Method::RmjeExact, family, 2.0);
    }
}

#[test]
fn shear_makes_the_published_element_one_of_order_1_in_bending() {
    // Its sliding joint sits at L/4. Without shear the sliding is O(n⁻³) of a segment and does not matter; with shear it is O(n⁻¹).
    let sheared = TowerDescription {
        shear: Shear::Coefficient(0.5),
        ..reference()
    };
    let f = |n| frequency(&sheared, Method::Rmje, n, Family::ForeAft, 2);
    let (coarse, middle, fine) = (f(2000), f(4000), f(8000));
    let observed = ((coarse - middle) / (middle - fine)).log2();
    assert!((observed - 1.0).abs() < 0.05, "{observed}");
    // Between the orders, where users are, the estimate errs on the safe side, at most threefold.
    for segments in [20, 60, 200] {
        let options = Options {
            method: Method::Rmje,
            segments: Some(segments),
            ..Options::default()
        };
        for mode in solved(&sheared, &options)
            .modes
            .iter()
            .filter(|m| m.family == Family::ForeAft)
        {
            let truth = [0.885153338, 4.206221834, 10.435474971, 18.846211207][mode.order - 1];
            let ratio = mode.discretization_error_hz / (mode.frequency_hz - truth).abs();
            assert!(
                ratio > 1.0 && ratio < 3.1,
                "{segments}: {} {ratio}",
                mode.label()
            );
        }
    }
    check_order(&sheared, Method::RmjeExact, Family::ForeAft, 2.0);
}

#[test]
fn error_estimates_at_100_segments_are_within_a_factor_3_of_the_truth() {
    let solution = solved(
        &reference(),
        &Options {
            modes: 10,
            ..Options::default()
        },
    );
    for mode in &solution.modes {
        let truth = match mode.family {
            Family::Torsion => TORSION,
            Family::Axial => AXIAL,
            _ => BENDING[mode.order - 1],
        };
        let ratio = mode.discretization_error_hz / (mode.frequency_hz - truth).abs();
        assert!(
            ratio > 1.0 / 3.0 && ratio < 3.0,
            "{}: estimate is {ratio:.3} of the error",
            mode.label()
        );
        let tolerance = if mode.order == 4 { 2e-6 } else { 1e-6 };
        assert_close(mode.extrapolated_hz, truth, tolerance, &mode.label());
    }
}

#[test]
fn odd_numbers_of_segments_are_estimated_too() {
    for segments in [1, 3, 75] {
        let options = Options {
            segments: Some(segments),
            modes: 2,
            ..Options::default()
        };
        let mode = &solved(&reference(), &options).modes[0];
        let ratio = mode.discretization_error_hz / (mode.frequency_hz - BENDING[0]).abs();
        assert!(
            ratio > 1.0 / 3.0 && ratio < 3.0,
            "{segments} segments: {ratio}"
        );
    }
}

#[test]
fn a_million_segments_keep_all_digits() {
    // 10⁵ here, where a test may take a moment; the order-2 remainder there is 3e-11.
    let f = |order| frequency(&reference(), Method::Rmje, 100_000, Family::ForeAft, order);
    assert_close(f(1), 0.89126240866, 1e-10, "bending 1");
    assert_close(f(2), 4.353711860807, 2e-10, "bending 2");
}
