//! Observed orders of convergence and honesty of the error estimates.

use crate::towers;

use towermodes::{Family, Method, Options, Shear, Station, TowerDescription};
use towermodes_testing::{changed, with};
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
    let options = with!(Options, method, segments = Some(segments), modes = 10);
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
    // Multiples of 44 cut every tower used here so that the finer mesh halves the coarser one's
    // segments.
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
    // Its sliding joint sits at L/4. Without shear the sliding is O(n⁻³) of a segment and does not
    // matter; with shear it is O(n⁻¹).
    let sheared = changed!(reference(), shear = Shear::Coefficient(0.5));
    let f = |n| frequency(&sheared, Method::Rmje, n, Family::ForeAft, 2);
    let (coarse, middle, fine) = (f(2000), f(4000), f(8000));
    let observed = ((coarse - middle) / (middle - fine)).log2();
    assert!((observed - 1.0).abs() < 0.05, "{observed}");
    // Between the orders, where users are, both powers are needed, and three meshes give both;
    // where the two are alike the estimate errs on the safe side.
    for segments in [20, 60, 200] {
        let options = with!(Options, method = Method::Rmje, segments = Some(segments));
        for mode in solved(&sheared, &options)
            .modes
            .iter()
            .filter(|m| m.family == Family::ForeAft)
        {
            let truth = [0.885153338, 4.206221834, 10.435474971, 18.846211207][mode.order - 1];
            let ratio = mode.discretization_error_hz / (mode.frequency_hz - truth).abs();
            assert!(ratio > 0.8, "{segments}: {} {ratio}", mode.label());
            assert!(ratio < 3.0, "{segments}: {} {ratio}", mode.label());
        }
    }
    check_order(&sheared, Method::RmjeExact, Family::ForeAft, 2.0);
}

#[test]
fn error_estimates_at_100_segments_are_within_a_factor_3_of_the_truth() {
    let solution = solved(&reference(), &with!(Options, modes = 10));
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
fn errors_of_two_powers_that_cancel_are_still_seen() {
    // Torsion of the published element under a heavy machine: a/n and b/n² have opposite signs and
    // cancel near 30 segments, where the difference of two meshes says 2e-5 Hz and the error is
    // 2.6e-4 Hz. The truth is the exact element's extrapolated value.
    let mut machine = reference_350t();
    machine.rna.inertia_kg_m2.zz = 2.2652099e7;
    for stations in &mut machine.stations {
        stations.wall_thickness_m *= 1.3;
    }
    let options = |method, segments| with!(Options, method, segments = Some(segments), modes = 10);
    let torsion = |solution: towermodes::Solution| {
        let mut modes = solution.modes.into_iter();
        modes
            .find(|m| m.family == Family::Torsion)
            .expect("among the lowest")
    };
    let truth = torsion(solved(&machine, &options(Method::RmjeExact, 800))).extrapolated_hz;
    for segments in [20, 24, 28, 30, 32, 36, 40, 60] {
        let mode = torsion(solved(&machine, &options(Method::Rmje, segments)));
        let ratio = mode.discretization_error_hz / (mode.frequency_hz - truth).abs();
        assert!(ratio > 1.0 / 3.0, "{segments} segments: {ratio}");
        assert!(ratio < 3.0, "{segments} segments: {ratio}");
    }
}

#[test]
fn short_spans_do_not_starve_long_ones() {
    // Sixty rings of 5 cm between two pieces of 40 m: the default gives the rings two segments each
    // on top of the hundred.
    let mut rings = reference();
    rings.stations.clear();
    for k in 0..=60 {
        let z = 40.0 + 0.05 * f64::from(k);
        let d = if k % 2 == 0 { 5.0 } else { 5.2 };
        rings.stations.push(Station::new(z, d, 0.03));
    }
    rings.stations.insert(0, Station::new(0.0, 6.0, 0.03));
    rings.stations.push(Station::new(83.0, 4.0, 0.02));
    let solution = solved(&rings, &Options::default());
    assert_eq!(solution.segments, 220);
    for mode in &solution.modes {
        let holds = mode.discretization_error_hz < 1e-3 * mode.frequency_hz;
        assert!(holds, "{mode:?}");
    }
}

#[test]
fn odd_numbers_of_segments_are_estimated_too() {
    for segments in [1, 3, 75] {
        let options = with!(Options, segments = Some(segments), modes = 2);
        let mode = &solved(&reference(), &options).modes[0];
        let ratio = mode.discretization_error_hz / (mode.frequency_hz - BENDING[0]).abs();
        assert!(ratio > 1.0 / 3.0, "{segments} segments: {ratio}");
        assert!(ratio < 3.0, "{segments} segments: {ratio}");
    }
}

#[test]
fn a_million_segments_keep_all_digits() {
    // 10⁵ here, where a test may take a moment; the order-2 remainder there is 3e-11.
    let f = |order| frequency(&reference(), Method::Rmje, 100_000, Family::ForeAft, order);
    assert_close(f(1), 0.89126240866, 1e-10, "bending 1");
    assert_close(f(2), 4.353711860807, 2e-10, "bending 2");
}
