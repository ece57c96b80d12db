//! Beams with known frequencies.
//!
//! Reference digits: 40-digit Ritz and transcendental solutions that agree with the literature named at each case.
//! The chains are extrapolated from two meshes (n and n/2). That leaves an O(n⁻⁴) error for the exact element and an O(n⁻³) one for the
//! published element, whose joints are not symmetric; tolerances are what these are at the n used.

mod towers;

use towermodes::chain::{Chain, ChainPencil, ChainWorkspace};
use towermodes::eigen::{EigenWorkspace, lowest};
use towermodes::elements::{Borders, Mesh};
use towermodes::tower::{Piece, compliance};
use towermodes::{
    EigenError, Family, Inertia, Method, Options, Rna, Shear, Tower, TowerDescription,
};
use towers::{
    Uniform, assert_close, cone, extrapolated, frequencies, reference, reference_350t, solved,
};

const SEGMENTS: usize = 800;

fn options(rotary_inertia: bool) -> Options {
    Options {
        segments: Some(SEGMENTS),
        modes: 12,
        rotary_inertia,
        ..Options::default()
    }
}

/// Extrapolated bending frequencies of both elements against expected ones; the exact element alone where shear makes the published one
/// an element of order 1.
fn check_bending(
    description: &TowerDescription,
    rotary_inertia: bool,
    expected_hz: &[f64],
    tolerance: f64,
    case: &str,
) {
    for (method, allowance) in [(Method::RmjeExact, 0.0), (Method::Rmje, 4e-8)] {
        if method == Method::Rmje && description.shear != Shear::Rigid {
            continue;
        }
        let tolerance = tolerance + allowance;
        let options = Options {
            method,
            modes: 30,
            ..options(rotary_inertia)
        };
        let got = extrapolated(&solved(description, &options), Family::ForeAft);
        for (order, (got, expected)) in got.iter().zip(expected_hz).enumerate() {
            let case = format!("{case}, {}, bending {}", method.name(), order + 1);
            assert_close(*got, *expected, tolerance, &case);
        }
    }
}

fn check_uniform(
    r: f64,
    s: Option<f64>,
    rotary: bool,
    lambdas: &[f64],
    tolerance: f64,
    case: &str,
) {
    let beam = Uniform::new(r, s);
    let expected: Vec<f64> = lambdas.iter().map(|&l| beam.frequency_hz(l)).collect();
    check_bending(&beam.description, rotary, &expected, tolerance, case);
}

#[test]
fn uniform_euler_bernoulli_cantilever() {
    // cos β cosh β = −1.
    let lambdas = [3.51601527, 22.03449156, 61.69721441, 120.90191605];
    check_uniform(0.01, None, false, &lambdas, 1e-8, "uniform");
}

#[test]
fn uniform_rayleigh_cantilever() {
    let cases = [
        (0.01, [3.51519844, 21.99885939, 61.46012685, 120.04718119]),
        (0.02, [3.51275106, 21.89294826, 60.76491472, 117.58782978]),
        (0.05, [3.49574816, 21.19068974, 56.48625593, 103.82375334]),
        (0.1, [3.43680762, 19.13637025, 46.49355294, 78.21309740]),
    ];
    for (r, lambdas) in cases {
        check_uniform(r, None, true, &lambdas, 2e-8, &format!("Rayleigh r = {r}"));
    }
}

#[test]
fn uniform_timoshenko_cantilever() {
    let cases = [
        (
            0.02,
            3.12,
            [3.50264107, 21.46982418, 58.14983171, 109.02914327],
        ),
        (
            0.02,
            5.2,
            [3.49594476, 21.20042304, 56.58123949, 104.24462738],
        ),
        (
            0.05,
            5.2,
            [3.39648755, 18.00128078, 42.30363627, 69.52644438],
        ),
        (
            0.1,
            5.2,
            [3.10464548, 12.76142890, 27.06648650, 39.78129211],
        ),
    ];
    for (r, s, lambdas) in cases {
        let case = format!("Timoshenko r = {r}, s = {s}");
        check_uniform(r, Some(s), true, &lambdas, 2e-8, &case);
    }
}

#[test]
fn tip_mass_on_a_uniform_cantilever() {
    let cases: [(f64, [f64; 3]); 5] = [
        (0.1, [2.96783835, 19.35580101, 55.51824555]),
        (0.5, [2.01629898, 16.90141772, 51.70092089]),
        (1.0, [1.55729786, 16.25008516, 50.89584283]),
        (5.0, [0.756937339, 15.60234588, 50.16233890]),
        (10.0, [0.541375033, 15.51151312, 50.06434697]),
    ];
    for (mu, lambdas) in cases {
        let beam = Uniform::new(0.01, None).with_tip(mu, 0.0, 0.0);
        let expected = lambdas.map(|l| beam.frequency_hz(l));
        check_bending(
            &beam.description,
            false,
            &expected,
            1e-8,
            &format!("tip mass {mu}"),
        );
    }
}

#[test]
fn tip_inertia_and_raised_centre() {
    // (μ, j = J/(mL³), ε = e/L). Published tables of this case whose frequencies rise with j have a sign wrong; these fall.
    let cases: [(f64, f64, f64, [f64; 2]); 5] = [
        (1.0, 0.01, 0.0, [1.54367680, 13.23958856]),
        (1.0, 0.1, 0.0, [1.42962634, 6.27532570]),
        (1.0, 0.0, 0.1, [1.38612621, 13.54779090]),
        (1.3, 0.02, 0.0224, [1.34027316, 11.06198354]),
        (0.5, 0.05, 0.2, [1.57345557, 8.30098534]),
    ];
    for (mu, j, eps, lambdas) in cases {
        let beam = Uniform::new(0.01, None).with_tip(mu, j, eps);
        let expected = lambdas.map(|l| beam.frequency_hz(l));
        let case = format!("tip μ = {mu}, j = {j}, ε = {eps}");
        check_bending(&beam.description, false, &expected, 1e-8, &case);
    }
}

#[test]
fn tip_inertia_with_timoshenko() {
    let mut beam = Uniform::new(0.02, Some(5.2)).with_tip(1.3, 0.02, 0.0224);
    let expected = [1.33615395, 10.9082116, 27.3074008, 58.6488251].map(|l| beam.frequency_hz(l));
    beam.description.name = "Timoshenko with tip".into();
    check_bending(
        &beam.description,
        true,
        &expected,
        2e-8,
        "Timoshenko with tip",
    );
}

#[test]
fn solid_cones() {
    // Euler-Bernoulli, A ∝ (1−cx)², I ∝ (1−cx)⁴ (Mabie & Rogers 1972; Naguleswaran 1994; Banerjee & Williams 1985).
    let cases: [(f64, [f64; 3], f64); 4] = [
        (0.2, [3.85511680, 21.05674543, 56.63034506], 1e-8),
        (0.5, [4.62515025, 19.54761318, 48.57889933], 1e-8),
        (0.8, [6.19639101, 18.38546739, 39.83362986], 3e-8),
        (0.9, [7.20487165, 18.68016121, 37.12383466], 1e-7),
    ];
    for (c, lambdas, tolerance) in cases {
        let (description, unit_hz) = cone(c);
        let expected = lambdas.map(|l| l * unit_hz);
        let options = options(false);
        let got = extrapolated(&solved(&description, &options), Family::SideSide);
        for (got, expected) in got.iter().zip(expected) {
            assert_close(*got, expected, tolerance, &format!("cone c = {c}"));
        }
    }
}

#[test]
fn torsion_and_axial_of_a_uniform_rod() {
    // f = (2k − 1)/4 · √(G/ρ)/L and √(E/ρ)/L.
    let beam = Uniform::new(0.02, None);
    let solution = solved(&beam.description, &options(true));
    for (family, modulus) in [(Family::Torsion, 0.8e11), (Family::Axial, 2.0e11)] {
        let expected = 0.25 * (modulus / 8000.0_f64).sqrt() / 50.0;
        assert_close(
            extrapolated(&solution, family)[0],
            expected,
            1e-10,
            family.name(),
        );
    }
}

#[test]
fn the_reference_tower_converges_to_the_rayleigh_beam() {
    let no_mass = [0.89126241, 4.35371186, 11.24619532, 21.33701097];
    check_bending(&reference(), true, &no_mass, 1e-8, "reference");
    let mass = [0.30020574, 3.0452761, 9.0970095];
    check_bending(&reference_350t(), true, &mass, 3e-8, "reference, 350 t");
    let exact = solved(&reference(), &options(true));
    assert_close(
        extrapolated(&exact, Family::Torsion)[0],
        11.9613216,
        1e-8,
        "torsion",
    );
    assert_close(
        extrapolated(&exact, Family::Axial)[0],
        16.5228378,
        1e-8,
        "axial",
    );
    let exact = solved(&reference_350t(), &options(true));
    assert_close(
        extrapolated(&exact, Family::Axial)[0],
        7.1141451,
        1e-8,
        "axial, 350 t",
    );
}

#[test]
fn the_reference_tower_without_rotary_inertia() {
    let no_mass = [0.89216915, 4.37813963, 11.40064744, 21.88358035];
    check_bending(
        &reference(),
        false,
        &no_mass,
        1e-8,
        "reference, Euler-Bernoulli",
    );
    let mass = [0.30024201, 3.05230018, 9.171746];
    check_bending(
        &reference_350t(),
        false,
        &mass,
        5e-8,
        "350 t, Euler-Bernoulli",
    );
}

#[test]
fn the_reference_tower_with_a_real_machine() {
    // Euler-Bernoulli, the NREL 5 MW rotor-nacelle assembly centred on the axis: yy resists fore-aft rotation, xx side-side.
    let machine = TowerDescription {
        rna: Rna {
            mass_kg: 349_606.5,
            center_m: [0.0, 0.0, 1.966427],
            inertia_kg_m2: Inertia {
                xx: 42_620_975.3,
                yy: 24_376_664.3,
                zz: 22_652_099.0,
                ..Inertia::default()
            },
        },
        ..reference()
    };
    let solution = solved(&machine, &options(false));
    let cases = [
        (Family::ForeAft, [0.28678522, 2.07484399, 4.92265]),
        (Family::SideSide, [0.28425472, 1.73461203, 4.58349]),
    ];
    for (family, expected) in cases {
        for (got, expected) in extrapolated(&solution, family).iter().zip(expected) {
            // The third value is given to six digits.
            let tolerance = if expected > 4.0 { 1.1e-6 } else { 2e-8 };
            assert_close(*got, expected, tolerance, family.name());
        }
    }
}

#[test]
fn the_reference_tower_with_shear() {
    let half = TowerDescription {
        shear: Shear::Coefficient(0.5),
        ..reference()
    };
    let expected = [0.885153338, 4.206221834, 10.435474971, 18.846211207];
    check_bending(&half, true, &expected, 1e-8, "κ = 0.5");
    // Cowper's thin tube, 2(1+ν)/(4+3ν), with the material's ν: 0.53057.
    let nu = reference().materials[0].poissons_ratio();
    let thin_tube = 2.0 * (1.0 + nu) / (4.0 + 3.0 * nu);
    let cowper = TowerDescription {
        shear: Shear::Coefficient(thin_tube),
        ..reference()
    };
    let expected = [0.885502299, 4.214341967, 10.477621612];
    check_bending(&cowper, true, &expected, 1e-8, "Cowper, thin tube");
    // Cowper's value of the tower's own thick walls is within 1e-4 of the thin tube's, and matters less than that.
    let own = TowerDescription {
        shear: Shear::Cowper,
        ..reference()
    };
    check_bending(&own, true, &expected, 2e-5, "Cowper");
}

/// A bending chain of a uniform Euler-Bernoulli beam whose every rigid piece, of length l, has the ground stiffness that `ground(l)`
/// says, about its middle.
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
        chain.add_joint(joint_m, flexibility);
        add_tied_body(&mut chain, piece, joint_m, border[1], &ground);
    }
    chain.add_body(tower.top_m(), [[tower.rna().mass_kg, 0.0], [0.0, 0.0]]);
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
    chain.add_body(middle, [[mass, 0.0], [0.0, mass * length * length / 12.0]]);
    chain.add_ground_stiffness(middle, ground(length));
}

/// Frequencies of a tied chain, extrapolated from 200 and 400 segments, Hz.
fn tied_frequencies(
    beam: &Uniform,
    modes: usize,
    ground: impl Fn(f64) -> [[f64; 2]; 2],
) -> Result<Vec<f64>, EigenError> {
    let frequencies = |segments| {
        let chain = tied_chain(beam, segments, &ground);
        let (mut work, mut eigen) = (ChainWorkspace::default(), EigenWorkspace::default());
        lowest(&mut ChainPencil::new(&chain, &mut work), modes, &mut eigen)?;
        let values = eigen.eigenvalues().iter();
        Ok(values
            .map(towermodes::eigen::Eigenvalue::frequency_hz)
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
fn winkler_foundation() {
    // λ² = λ₀² + kL⁴/EI. A spring k along a rod of length l: k l at its middle and k l³/12 against its rotation.
    let beam = Uniform::new(0.01, None);
    let k = 100.0 * stiffness_over_length(&beam, 4);
    let ground = |l: f64| [[k * l, 0.0], [0.0, k * l.powi(3) / 12.0]];
    let got = tied_frequencies(&beam, 3, ground).expect("stable");
    for (got, lambda) in got.iter().zip([10.60011148, 24.19749612, 62.50237009]) {
        assert_close(*got, beam.frequency_hz(lambda), 1e-8, "Winkler");
    }
}

#[test]
fn a_weight_on_top_lowers_the_frequencies_and_buckles_the_column_at_its_critical_load() {
    // μ = 1, γ = P L²/EI; a rigid piece of length l below the weight has −P l θ²/2. Critical: γ = π²/4.
    let beam = Uniform::new(0.01, None).with_tip(1.0, 0.0, 0.0);
    let weight = stiffness_over_length(&beam, 2);
    let with_weight = |gamma: f64, modes: usize| {
        tied_frequencies(&beam, modes, |l| [[0.0, 0.0], [0.0, -gamma * weight * l]])
    };
    let cases = [(0.5, 1.39354322), (1.0, 1.20617729), (2.0, 0.683975487)];
    for (gamma, lambda) in cases {
        let got = with_weight(gamma, 1).expect("stable");
        assert_close(
            got[0],
            beam.frequency_hz(lambda),
            1e-7,
            &format!("γ = {gamma}"),
        );
    }
    let second = with_weight(0.5, 2).expect("stable")[1];
    assert_close(
        second,
        beam.frequency_hz(16.04030475),
        1e-8,
        "γ = 0.5, second",
    );
    let critical = std::f64::consts::PI.powi(2) / 4.0;
    assert!(with_weight(critical * 0.9999, 1).is_ok());
    assert_eq!(
        with_weight(critical * 1.0001, 1),
        Err(EigenError::Unstable { negative: 1 })
    );
}

#[test]
fn frequencies_are_those_of_the_method_not_extrapolated() {
    let solution = solved(
        &reference(),
        &Options {
            segments: Some(100),
            ..Options::default()
        },
    );
    let plain = frequencies(&solution, Family::ForeAft)[1];
    assert!((plain - 4.353_484_2).abs() < 1e-6, "{plain}");
    assert!((extrapolated(&solution, Family::ForeAft)[1] - 4.353_711_86).abs() < 1e-6);
}
