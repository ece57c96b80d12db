//! Springs against the rotation of the sections, distributed along the tower.

use crate::towers;

use towermodes::{
    Family, Method, Options, Planes, Properties, PropertyStation, SoilRow, SoilStiffness,
    TowerDescription,
};
use towermodes_testing::with;
use towers::{assert_close, assert_same, frequencies, solved};

const LENGTH_M: f64 = 60.0;
const MASS_KG_PER_M: f64 = 5000.0;
const BENDING_N_M2: f64 = 4e11;
/// T L²/EI = 9, so that the first frequency rises by a third.
const ROTATION_N: f64 = 1e9;

/// A uniform beam without rotary inertia, with these springs about y from base to top.
fn uniform(rotation_y_n: f64, shear_n: Option<f64>) -> TowerDescription {
    let row = |height_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: MASS_KG_PER_M,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m: 3e4,
            bending_n_m2: Planes::both(BENDING_N_M2),
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            shear_n: shear_n.map(Planes::both),
        },
    };
    let soil = |height_m| SoilRow {
        height_m,
        stiffness: with!(SoilStiffness, rotation_y_n),
    };
    TowerDescription {
        properties: vec![row(0.0), row(LENGTH_M)],
        soil: vec![vec![soil(0.0), soil(LENGTH_M)]],
        ..TowerDescription::default()
    }
}

/// The determinant of the end conditions of a clamped beam under the tension `t`: springs T w'²/2
/// per length are the work of a tension T.
///
/// EI w⁗ − T w″ = μω² w, w = w' = 0 at the base, w″ = 0 and EI w‴ = T w' at the top.
fn determinant(t: f64, omega: f64) -> f64 {
    let (ei, l) = (BENDING_N_M2, LENGTH_M);
    let root = (t * t + 4.0 * ei * MASS_KG_PER_M * omega * omega).sqrt();
    let a = ((root + t) / (2.0 * ei)).sqrt();
    let b = ((root - t) / (2.0 * ei)).sqrt();
    let (sh, ch, s, c) = ((a * l).sinh(), (a * l).cosh(), (b * l).sin(), (b * l).cos());
    // w = A (cosh az − cos bz) + B (sinh az − (a/b) sin bz)
    let moment = [a * a * ch + b * b * c, a * a * sh + a * b * s];
    let slope = [a * sh + b * s, a * ch - a * c];
    let third = [
        a.powi(3) * sh - b.powi(3) * s,
        a.powi(3) * ch + a * b * b * c,
    ];
    let force = [0, 1].map(|i| ei * third[i] - t * slope[i]);
    moment[0] * force[1] - moment[1] * force[0]
}

/// The first `count` roots by steps and bisection, Hz.
fn exact_hz(t: f64, count: usize) -> Vec<f64> {
    let step = 0.01;
    let signs = |k: usize| determinant(t, step * k as f64).signum();
    let brackets = (1..).filter(|k| signs(*k) != signs(k + 1)).take(count);
    let roots = brackets.map(|k| {
        let (mut low, mut high) = (step * k as f64, step * (k + 1) as f64);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if determinant(t, middle).signum() == determinant(t, low).signum() {
                low = middle;
            } else {
                high = middle;
            }
        }
        0.5 * (low + high) / std::f64::consts::TAU
    });
    roots.collect()
}

fn fore_aft_hz(tower: &TowerDescription, method: Method, segments: Option<usize>) -> Vec<f64> {
    let options = with!(Options, method, segments, modes = 8);
    frequencies(&solved(tower, &options), Family::ForeAft)
}

#[test]
fn springs_against_rotation_are_a_tension_in_a_slender_beam() {
    let tower = uniform(ROTATION_N, None);
    let exact = exact_hz(ROTATION_N, 4);
    let bare = exact_hz(0.0, 1);
    assert!(exact[0] > 1.3 * bare[0], "{exact:?} against {bare:?}");
    let spectral = fore_aft_hz(&tower, Method::Spectral, None);
    for (got, expected) in spectral.iter().zip(&exact) {
        assert_close(*got, *expected, 1e-10, "spectral");
    }
}

#[test]
fn they_leave_the_order_of_each_method_as_it_is() {
    let tower = uniform(ROTATION_N, None);
    let exact = exact_hz(ROTATION_N, 1)[0];
    for method in Method::ALL {
        let expected = match method {
            Method::Spectral => continue,
            Method::Bmodes => 4.0,
            _ => 2.0,
        };
        let segments = if method == Method::Bmodes { 4 } else { 40 };
        let error = |n| fore_aft_hz(&tower, method, Some(n))[0] / exact - 1.0;
        let (coarse, fine) = (error(segments), error(2 * segments));
        let order = (coarse / fine).log2();
        assert!(
            (order - expected).abs() < 0.1 && fine.abs() < 1e-3,
            "{}: errors {coarse:.3e}, {fine:.3e}, order {order:.3}",
            method.name()
        );
    }
}

#[test]
fn a_beam_whose_sections_cannot_rotate_only_shears() {
    // f_n = (2n − 1)/(4L) √(κGA/μ), however stiff the bending is.
    let shear_n = 5e8;
    let tower = uniform(1e20, Some(shear_n));
    let first = (shear_n / MASS_KG_PER_M).sqrt() / (4.0 * LENGTH_M);
    let got = fore_aft_hz(&tower, Method::Spectral, None);
    for (n, got) in got.iter().take(3).enumerate() {
        let expected = (2 * n + 1) as f64 * first;
        assert_close(*got, expected, 1e-9, "spectral");
    }
    for method in Method::ALL {
        if method.unit() != "segment" {
            continue;
        }
        // The published element slides at a quarter of its length, which is of first order.
        let tolerance = if method == Method::Rmje { 2e-3 } else { 1e-4 };
        let got = fore_aft_hz(&tower, method, Some(200))[0];
        assert_close(got, first, tolerance, method.name());
    }
}

#[test]
fn springs_about_x_hold_the_side_side_plane_alone() {
    let mut tower = uniform(ROTATION_N, None);
    let about_y = solved(&tower, &Options::default());
    for row in tower.soil.iter_mut().flatten() {
        std::mem::swap(
            &mut row.stiffness.rotation_x_n,
            &mut row.stiffness.rotation_y_n,
        );
    }
    let about_x = solved(&tower, &Options::default());
    let pairs = [
        (Family::ForeAft, Family::SideSide),
        (Family::SideSide, Family::ForeAft),
    ];
    for (one, other) in pairs {
        let (got, expected) = (frequencies(&about_x, other), frequencies(&about_y, one));
        assert_same(&got, &expected, 1e-13, one.name());
    }
    let bare = exact_hz(0.0, 1)[0];
    let case = "bare";
    assert_close(frequencies(&about_x, Family::ForeAft)[0], bare, 1e-3, case);
}
