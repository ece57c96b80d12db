//! Beams with known frequencies, by every method: the manual asks the spectral beam and the default
//! method, this file asks the others.
//!
//! And chains under a weight on top alone, which no tower is.

use crate::towers;

use towermodes::internal::chain::{Chain, ChainSubsystem};
use towermodes::internal::eigen::{EigenWorkspace, lowest};
use towermodes::internal::elements::{Borders, Mesh};
use towermodes::internal::subsystem::{Eigenproblem, MatrixKind, SubsystemPencil};
use towermodes::tower::{Motion, Motions, Piece, compliance};
use towermodes::{EigenError, Family, Method, Options, Plane, Shear, Tower};
use towermodes_testing::{assert_matches, changed, with};
use towermodes_verify::{Case, Run, manual};
use towers::{Uniform, assert_close, extrapolated, frequencies, reference, solved};

/// The cases of the manual whose answers are those of beams, but for pointed tips, where segments
/// converge slowly.
fn beams() -> impl Iterator<Item = Case> {
    let of_beams = ["uniform", "tips", "tapers", "tower"];
    manual()
        .into_iter()
        .filter(move |case| of_beams.contains(&case.chapter.name))
        .filter(|case| !case.name.ends_with("c = 1"))
}

/// Runs the beams by one method, extrapolated, for as many segments as leave it this relative
/// error.
fn check_beams(method: Method, segments: usize, allowance: f64, has: impl Fn(&Case) -> bool) {
    let mut checked = 0;
    for mut case in beams().filter(|case| has(case)) {
        let rotary_inertia = case.runs[0].options.rotary_inertia;
        // What keeps a case from its law keeps every method from it.
        let allowance = allowance + case.runs[0].allowance;
        let mut run = Run::extrapolated(method, segments, allowance);
        run.options.rotary_inertia = rotary_inertia;
        case.runs = vec![run];
        for row in case.run() {
            let (got, difference) = (row.shown(), row.shown_difference());
            let (case, what) = (&row.case, &row.what);
            let holds = row.passes();
            assert!(holds, "{}, {case}, {what}: {got}, {difference}", row.method);
            checked += 1;
        }
    }
    assert!(checked > 50, "{} has only {checked} values", method.name());
}

fn is_sheared(case: &Case) -> bool {
    let tower = case.subject.as_tower();
    tower.is_some_and(|tower| tower.shear != Shear::Rigid)
}

#[test]
fn chains_with_exact_sections_have_the_beams_frequencies() {
    check_beams(Method::RmjeExact, 800, 1e-7, |_| true);
    check_beams(Method::CardanicExact, 400, 1e-7, |_| true);
}

#[test]
fn chains_of_prismatic_segments_have_the_beams_frequencies() {
    check_beams(Method::Cardanic, 800, 2e-7, |_| true);
    check_beams(Method::Lumped, 800, 2e-7, |_| true);
    // Shear makes the published one an element of order 1, and a third power of 1/n stays.
    check_beams(Method::Rmje, 800, 2e-7, |case| !is_sheared(case));
}

#[test]
fn bmodes_has_the_frequencies_of_euler_bernoulli_beams() {
    let is_euler = |case: &Case| !case.runs[0].options.rotary_inertia;
    check_beams(Method::Bmodes, 400, 1e-7, is_euler);
}

#[test]
fn cowpers_coefficient_of_thin_walls_is_that_of_a_thin_tube() {
    // Cowper's value of the tower's own walls is within 1e-4 of the thin tube's, and matters less
    // than that.
    let own = changed!(reference(), shear = Shear::Cowper);
    let options = with!(Options, method = Method::Spectral);
    let expected = [0.885502299, 4.214341967, 10.477621612];
    let got = frequencies(&solved(&own, &options), Family::ForeAft);
    for (got, expected) in got.iter().zip(expected) {
        assert_close(*got, expected, 2e-5, "Cowper");
    }
}

/// A bending chain of a uniform Euler-Bernoulli beam whose every rigid piece, of length l, has the
/// ground stiffness that `ground(l)` says, about its middle.
fn tied_chain(beam: &Uniform, segments: usize, ground: impl Fn(f64) -> [[f64; 2]; 2]) -> Chain<2> {
    let tower = Tower::new(beam.description.clone()).expect("a valid tower");
    let piece = &tower.pieces()[0];
    let mut chain = Chain::default();
    for border in Mesh::new(&tower, Borders::Pieces, segments)
        .borders_m()
        .windows(2)
    {
        let compliance = compliance(piece, border[0], border[1]).bending.fore_aft;
        let joint_m = compliance.elastic_centre_m;
        add_tied_body(&mut chain, piece, border[0], joint_m, &ground);
        let flexibility = [compliance.deflection_m_per_n, compliance.bending_per_n_m];
        chain.add_joint(joint_m, flexibility, 0.0);
        add_tied_body(&mut chain, piece, joint_m, border[1], &ground);
    }
    let tip = [[tower.rna().mass_kg, 0.0], [0.0, 0.0]];
    chain.add(MatrixKind::Inertia, tower.top_m(), tip);
    chain
}

fn add_tied_body(
    chain: &mut Chain<2>,
    piece: &Piece,
    from: f64,
    to: f64,
    ground: &impl Fn(f64) -> [[f64; 2]; 2],
) {
    let (length, middle) = (to - from, 0.5 * (from + to));
    let mass = piece.section_at(middle).masses.mass_kg_per_m * length;
    let inertia = [[mass, 0.0], [0.0, mass * length * length / 12.0]];
    chain.add(MatrixKind::Inertia, middle, inertia);
    chain.add(MatrixKind::Foundation, middle, ground(length));
}

/// Frequencies of a tied chain, extrapolated from 200 and 400 segments, Hz.
fn tied_frequencies(
    beam: &Uniform,
    modes: usize,
    ground: impl Fn(f64) -> [[f64; 2]; 2],
) -> Result<Vec<f64>, EigenError> {
    let frequencies = |segments| {
        let chain = tied_chain(beam, segments, &ground);
        let fore_aft = Motions::only(Motion::Bending(Plane::ForeAft));
        let (mut chain, mut eigen) = (
            ChainSubsystem::new(fore_aft, chain),
            EigenWorkspace::default(),
        );
        let at_rest = Eigenproblem::Vibration { origin: 0.0 };
        lowest(
            &mut SubsystemPencil::new(&mut chain, at_rest),
            modes,
            &mut eigen,
        )?;
        let values = eigen.eigenvalues().iter();
        Ok(values
            .map(towermodes::internal::eigen::Eigenvalue::frequency_hz)
            .collect::<Vec<f64>>())
    };
    let (coarse, fine) = (frequencies(200)?, frequencies(400)?);
    Ok(coarse
        .iter()
        .zip(fine)
        .map(|(c, f)| f + (f - c) / 3.0)
        .collect())
}

/// EI of the uniform beam over a power of its length, from its unit frequency: EI/L⁴ = m (2π f)².
fn stiffness_over_length(beam: &Uniform, power: i32) -> f64 {
    let tower = Tower::new(beam.description.clone()).expect("a valid tower");
    let unit = std::f64::consts::TAU * beam.frequency_hz(1.0);
    let length = tower.height_m();
    tower.mass_kg() / length * unit * unit * length.powi(4 - power)
}

#[test]
fn a_weight_on_top_lowers_the_frequencies_and_buckles_the_column_at_its_critical_load() {
    // μ = 1, γ = P L²/EI; a rigid piece of length l below the weight has −P l θ²/2. Critical: γ =
    // π²/4.
    let beam = Uniform::new(0.01, None).with_tip(1.0, 0.0, 0.0);
    let weight = stiffness_over_length(&beam, 2);
    let with_weight = |gamma: f64, modes: usize| {
        tied_frequencies(&beam, modes, |l| [[0.0, 0.0], [0.0, -gamma * weight * l]])
    };
    let cases = [(0.5, 1.39354322), (1.0, 1.20617729), (2.0, 0.683975487)];
    for (gamma, lambda) in cases {
        let got = with_weight(gamma, 1).expect("stable");
        let expected = beam.frequency_hz(lambda);
        assert_close(got[0], expected, 1e-7, &format!("γ = {gamma}"));
    }
    let second = with_weight(0.5, 2).expect("stable")[1];
    let expected = beam.frequency_hz(16.04030475);
    assert_close(second, expected, 1e-8, "γ = 0.5, second");
    let critical = std::f64::consts::PI.powi(2) / 4.0;
    assert!(with_weight(critical * 0.9999, 1).is_ok());
    assert_matches!(
        with_weight(critical * 1.0001, 1),
        Err(EigenError::Unstable { negative: 1 })
    );
}

#[test]
fn frequencies_are_those_of_the_method_not_extrapolated() {
    let solution = solved(&reference(), &with!(Options, segments = Some(100)));
    let plain = frequencies(&solution, Family::ForeAft)[1];
    assert!((plain - 4.353_484_2).abs() < 1e-6, "{plain}");
    assert!((extrapolated(&solution, Family::ForeAft)[1] - 4.353_711_86).abs() < 1e-6);
}
