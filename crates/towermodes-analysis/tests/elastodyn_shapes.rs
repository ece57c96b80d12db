//! The rows and shapes of ElastoDyn's tower files, and how shapes are judged.

use crate::elastodyn_towers;

use std::f64::consts::TAU;

use elastodyn_towers::{
    BENDING_N_M2, HEIGHT_M, MASS_KG_PER_M, near, options, tower, uniform, uniform_model,
};
use towermodes::{Foundation, FoundationSprings, Plane, Planes, SolveError, TowerDescription};
use towermodes_analysis::Verdict;
use towermodes_analysis::elastodyn::{
    PlaneModes, ShapesError, TowerPolynomial, TowerShapes, ValidatedShape, ValidationLimits,
    tower_shapes, validate_shapes,
};

/// βL of the cantilever's first two modes.
const WAVES: [f64; 2] = [1.875_104_068_711_961, 4.694_091_132_974_175];

/// A cantilever's mode at a share of its length, 1 at the tip.
fn cantilever(mode: usize, x: f64) -> f64 {
    let b = WAVES[mode];
    let sigma = (b.cosh() + b.cos()) / (b.sinh() + b.sin());
    let raw = |x: f64| (b * x).cosh() - (b * x).cos() - sigma * ((b * x).sinh() - (b * x).sin());
    raw(x) / raw(1.0)
}

/// The slope of a cantilever's mode over its length.
fn cantilever_slope(mode: usize, x: f64) -> f64 {
    let h = 1e-5;
    (cantilever(mode, x + h) - cantilever(mode, x - h)) / (2.0 * h)
}

fn shapes_of(description: TowerDescription, from_m: f64) -> Result<TowerShapes, ShapesError> {
    tower_shapes(&tower(description), &options(), from_m)
}

fn own() -> TowerShapes {
    shapes_of(uniform(), 0.0).expect("shapes")
}

#[test]
fn the_shapes_of_a_cantilever_are_its_modes() {
    let shapes = own();
    assert!(shapes.passed_over.is_empty());
    let wave = (BENDING_N_M2 / (MASS_KG_PER_M * HEIGHT_M.powi(4))).sqrt() / TAU;
    for (i, shape) in shapes.shapes.iter().enumerate() {
        let plane = [Plane::ForeAft, Plane::SideSide][i / 2];
        assert_eq!((shape.plane, shape.number), (plane, i % 2 + 1));
        near(shape.frequency_hz, wave * WAVES[i % 2].powi(2), 1e-10);
        let tip = shape.samples.points.last().expect("samples").1;
        for (x, value) in &shape.samples.points {
            let exact = cantilever(i % 2, *x);
            assert!((value / tip - exact).abs() < 1e-8, "{i} {x}: {value}");
        }
        let decimals = shape.decimals.polynomial();
        near(decimals.sum(), 1.0, 1e-15);
        let pairs = decimals.coefficients.into_iter();
        for (decimal, fitted) in pairs.zip(shape.fit.polynomial.coefficients) {
            // Eight decimals, of which the last may move to make the sum 1.
            assert!((decimal - fitted).abs() < 2.6e-8, "{decimal} {fitted}");
        }
    }
    let found = shapes.polynomials(Plane::SideSide)[1].coefficients;
    assert_eq!(found, shapes.coefficients()[3]);
    let found = shapes.polynomials(Plane::ForeAft)[0].coefficients;
    assert_eq!(found, shapes.coefficients()[0]);
}

/// What is above a height moves and turns with it, and that is taken off.
#[test]
fn a_flexible_tower_that_begins_higher_has_the_rest_of_the_modes() {
    let shapes = shapes_of(uniform(), 0.3 * HEIGHT_M).expect("shapes");
    for (i, shape) in shapes.shapes.iter().enumerate() {
        let (mode, x0) = (i % 2, 0.3);
        let bent = |x: f64| {
            let z = x0 + (1.0 - x0) * x;
            let moved = cantilever(mode, x0) + cantilever_slope(mode, x0) * (z - x0);
            cantilever(mode, z) - moved
        };
        for k in 0..=10 {
            let x = f64::from(k) / 10.0;
            let off = shape.fit.polynomial.value(x) - bent(x) / bent(1.0);
            // As far as the polynomials of the whole are at most: four hundredths of a per cent.
            assert!(off.abs() < 4e-4, "{i} {x}: {off:e}");
        }
        assert!(shape.fit.rms_residual < 4e-4);
    }
}

/// Springs let the base turn: that is no bending, but the first fore-aft mode is still the first
/// shape.
#[test]
fn the_motion_of_the_base_is_taken_off() {
    let mut description = uniform();
    description.foundation = Foundation::Springs(FoundationSprings {
        rocking_n_m: 1e11,
        ..FoundationSprings::RIGID
    });
    let shapes = shapes_of(description, 0.0).expect("shapes");
    let first = &shapes.shapes[0];
    // k θ = EI w″ at the base: the slope there over the curvature is EI/k = 3 m.
    let slope = first.samples.base_slope / HEIGHT_M;
    let c2 = first.fit.polynomial.coefficients[0] * first.fit.tip_deflection;
    let curvature = 2.0 * c2 / (HEIGHT_M * HEIGHT_M);
    // The polynomial's curvature at its end is as good as four digits of the shape let it be.
    near(slope / curvature, BENDING_N_M2 / 1e11, 0.01);
    assert!(first.frequency_hz < own().shapes[0].frequency_hz);
}

#[test]
fn where_no_tower_is_no_shape_is() {
    for from_m in [-0.1, HEIGHT_M, 2.0 * HEIGHT_M, f64::NAN, f64::INFINITY] {
        let refused = shapes_of(uniform(), from_m);
        let Err(ShapesError::Outside { base_m, top_m, .. }) = refused else {
            panic!("{from_m}: {refused:?}");
        };
        assert_eq!((base_m, top_m), (0.0, HEIGHT_M));
    }
    let mut options = options();
    options.degree = Some(1);
    let refused = tower_shapes(&tower(uniform()), &options, 0.0);
    let degree = SolveError::Degree { degree: 1 };
    assert_eq!(refused.err(), Some(ShapesError::Solve(degree)));
}

fn modes(shapes: [TowerPolynomial; 2]) -> PlaneModes {
    PlaneModes {
        shapes,
        tuners: [1.0; 2],
        damping_percent: [1.0; 2],
    }
}

/// Judges these two shapes in the fore-aft plane; the side-side ones are the tower's own.
fn judged(fore_aft: [TowerPolynomial; 2]) -> [ValidatedShape; 4] {
    let own = own();
    let shipped = Planes {
        fore_aft: modes(fore_aft),
        side_side: modes(own.polynomials(Plane::SideSide)),
    };
    let limits = ValidationLimits::default();
    validate_shapes(&uniform_model(), &shipped, &own, &limits)
        .expect("validated")
        .shapes
}

/// a + k b.
fn sum(a: TowerPolynomial, k: f64, b: TowerPolynomial) -> TowerPolynomial {
    TowerPolynomial {
        coefficients: std::array::from_fn(|i| a.coefficients[i] + k * b.coefficients[i]),
    }
}

fn multiplied(a: TowerPolynomial, k: f64) -> TowerPolynomial {
    sum(TowerPolynomial::default(), k, a)
}

#[test]
fn own_shapes_pass() {
    let wave = (BENDING_N_M2 / (MASS_KG_PER_M * HEIGHT_M.powi(4))).sqrt() / TAU;
    for (i, judgement) in judged(own().polynomials(Plane::ForeAft)).iter().enumerate() {
        assert_eq!(judgement.verdict, Verdict::Pass, "{judgement:?}");
        // Printed they are off by some 1e-8 more, beside the fit's 1e-5.
        near(judgement.rms_ratio, 1.0, 1e-3);
        assert!(1.0 - judgement.mac < 1e-6, "{judgement:?}");
        assert!(judgement.rms_of_both <= judgement.rms * (1.0 + 1e-9));
        near(judgement.sum, 1.0, 1e-15);
        // By Rayleigh's quotient the fitted shapes are 1.05e-7 and 3.7e-5 too high.
        let exact_hz = wave * WAVES[i % 2].powi(2);
        near(judgement.implied_hz, exact_hz, [3e-7, 5e-5][i % 2]);
        assert_eq!(judgement.implied_hz, judgement.best_implied_hz);
        near(judgement.mode_hz, exact_hz, 1e-10);
    }
}

/// Both modes of a cantilever have ∫φ² = 1/4 and are orthogonal, so nothing of one is in the other.
#[test]
fn the_shape_of_another_mode_fails() {
    let [first, second] = own().polynomials(Plane::ForeAft);
    let judgements = judged([second, first]);
    for judgement in &judgements[..2] {
        assert_eq!(judgement.verdict, Verdict::Fail);
        near(judgement.rms, 0.5, 2e-3);
        assert!(judgement.mac < 1e-3, "{judgement:?}");
        // Together they are still the right ones.
        assert!(judgement.rms_of_both <= judgement.best_rms * 1.001);
    }
    for judgement in &judgements[2..] {
        assert_eq!(judgement.verdict, Verdict::Pass);
    }
}

#[test]
fn a_factor_changes_nothing_but_the_sum() {
    let [first, second] = own().polynomials(Plane::ForeAft);
    // The second mode itself makes rms something to compare.
    let off = multiplied(sum(second, 0.3, first), 1.0 / 1.3);
    let plain = judged([first, off]);
    for factor in [3.0, -0.01, 1e6] {
        let scaled = judged([multiplied(first, factor), multiplied(off, factor)]);
        for (scaled, plain) in scaled.iter().zip(&plain).take(2) {
            near(scaled.rms, plain.rms, 1e-6);
            near(scaled.mac, plain.mac, 1e-12);
            near(scaled.implied_hz, plain.implied_hz, 1e-12);
            near(scaled.sum, factor, 1e-12);
            assert_eq!(scaled.verdict, Verdict::Fail, "OpenFAST refuses the sum");
        }
    }
}

/// Of (φ₂ + kφ₁)/(1 + k) what φ₂ is off is k/√(1 + k²) of its own size 1/2, and MAC is 1/(1 + k²).
#[test]
fn a_second_shape_with_some_of_the_first_is_right_for_both_together() {
    let [first, second] = own().polynomials(Plane::ForeAft);
    for (k, verdict) in [
        (0.01_f64, Verdict::Pass),
        (0.04, Verdict::Warn),
        (0.5, Verdict::Fail),
    ] {
        let mixed = multiplied(sum(second, k, first), 1.0 / (1.0 + k));
        let judgement = &judged([first, mixed])[1];
        let expected = 0.5 * k / (1.0 + k * k).sqrt();
        // The fit's own part is 2e-3 of a deflection at most.
        assert!((judgement.rms - expected).abs() < 2e-3, "{judgement:?}");
        assert!((judgement.mac - 1.0 / (1.0 + k * k)).abs() < 5e-3 * k);
        assert!(judgement.rms_of_both < 1.001 * judgement.best_rms);
        assert_eq!(judgement.verdict, verdict, "{k}: {judgement:?}");
    }
}

#[test]
fn sums_that_openfast_refuses_fail() {
    let [first, second] = own().polynomials(Plane::ForeAft);
    let by = |off: f64| {
        let mut shape = first;
        shape.coefficients[0] += off;
        judged([shape, second])[0].clone()
    };
    for off in [0.0014, -0.0014] {
        assert_eq!(by(off).verdict, Verdict::Pass);
    }
    for off in [0.0016, -0.0016] {
        let judgement = by(off);
        assert_eq!(judgement.verdict, Verdict::Fail);
        near(judgement.sum, 1.0 + off, 1e-12);
        assert!(judgement.rms < 0.01, "for its sum alone: {judgement:?}");
    }
    // No frequency of a shape that does not move.
    let own = own();
    let none = Planes::both(modes([TowerPolynomial::default(); 2]));
    assert!(validate_shapes(&uniform_model(), &none, &own, &ValidationLimits::default()).is_err());
}
