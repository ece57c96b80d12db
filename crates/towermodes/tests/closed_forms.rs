//! Foundations by closed form: published digits, exact limits, and the pile that they stand for.

use crate::towers;

use towermodes::{
    BeamFormula, Change, Foundation, HeadStiffness, Material, Method, Monopile, Options,
    PileBehaviour, PileFormula, PileTube, Place, Problem, Rna, SoilProfile, SoilRow, SoilSpring,
    SoilStiffness, Solver, Station, Tower, TowerDescription, Warning, WinklerPile,
};
use towermodes_testing::{Says, assert_matches, changed, number, numbers, rows, tube, with};
use towers::{all_frequencies, assert_close, solved};

/// A short pile without shear deformation below a tower with it.
#[test]
fn a_short_pile_without_shear_deformation_is_warned_of() {
    let told = |embedded_length_m, shear| {
        let mut pile = unit_pile(0.0, 1.0);
        pile.tube = PileTube {
            diameter_m: 7.0,
            wall_thickness_m: 0.07,
            embedded_length_m,
            youngs_modulus_pa: 2.1e11,
        };
        let description = TowerDescription {
            shear,
            ..tower_on(Foundation::WinklerPile(Box::new(pile)))
        };
        let tower = Tower::new(description).expect("a possible tower");
        let is_so = |warning: &Warning| matches!(warning, Warning::PileWithoutShear { .. });
        tower.warnings().iter().any(is_so)
    };
    assert!(told(27.0, towermodes::Shear::Cowper));
    assert!(!told(29.0, towermodes::Shear::Cowper));
    assert!(!told(27.0, towermodes::Shear::Rigid));
}

/// A solid pile with EI = 1 for E = 64/π, in springs z^m; its length is the reduced one.
fn unit_pile(exponent: f64, length: f64) -> WinklerPile {
    WinklerPile {
        tube: PileTube {
            diameter_m: 1.0,
            wall_thickness_m: 0.5,
            embedded_length_m: length,
            youngs_modulus_pa: 64.0 / std::f64::consts::PI,
        },
        formula: BeamFormula::Exact,
        soil_spring: SoilSpring::Given {
            spring_n_per_m2: 1.0,
        },
        exponent,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    }
}

fn factors(exponent: f64, length: f64) -> [f64; 3] {
    let head = unit_pile(exponent, length).head();
    [head.lateral_n_per_m, -head.coupling_n, head.rocking_n_m]
}

/// A finite element analysis with 4000 elements, in the digits that it was printed with. (Its
/// shortest piles are left out: so many elements lose their digits there.)
#[test]
fn piles_on_springs_have_the_stiffness_of_a_finite_element_analysis() {
    let table = "
        0.0 | 1.4142135623730951 1.0 1.4142135623730951 | 1.295 0.989 1.204 | 1.319 0.970 1.388 | 1.382 0.975 1.393
        0.5 | 1.165 0.986 1.454 | 1.022 0.965 1.269 | 1.062 0.939 1.422 | 1.141 0.965 1.434
        0.6 | 1.139 0.987 1.463 | 0.991 0.963 1.282 | 1.035 0.937 1.429 | 1.118 0.968 1.443
        1.0 | 1.0777 0.9992 1.4988 | 0.908 0.966 1.339 | 0.973 0.940 1.459 | 1.064 0.986 1.484
        2.0 | 1.065 1.063 1.591 | 0.832 0.999 1.474 | 0.978 1.001 1.544 | 1.064 1.061 1.588
    ";
    for [m, long, short @ ..] in rows::<5>(table) {
        let exponent = number(m);
        let case = format!("m = {m}, long");
        near(factors(exponent, 8.0), numbers(long), 6e-4, &case);
        for (length, expected) in [2.0, 3.0, 4.0].into_iter().zip(short) {
            let case = format!("m = {m}, {length}");
            near(factors(exponent, length), numbers(expected), 2e-3, &case);
        }
    }
}

/// The least energy of polynomials of degree 12, whose error is the square of that of the shape.
#[test]
fn piles_on_springs_have_the_stiffness_of_a_ritz_analysis() {
    for m in [0.0, 0.5, 0.6, 1.0, 2.0, 3.7] {
        for length in [0.1, 0.5, 1.0, 1.5, 2.0, 3.0] {
            let expected = by_polynomials(m, length);
            for (got, expected) in factors(m, length).into_iter().zip(expected) {
                assert_close(got, expected, 1e-7, &format!("m = {m}, length {length}"));
            }
        }
    }
}

/// c₁, c₂, c₃ by Ritz with y = Σ c_j (z/L)^j: y(0) = c_0, L y′(0) = c_1, the others are free.
fn by_polynomials(m: f64, length: f64) -> [f64; 3] {
    let entry = |i: usize, j: usize| {
        let (i, j) = (i as f64, j as f64);
        let bending = match i * (i - 1.0) * j * (j - 1.0) {
            0.0 => 0.0,
            factors => factors / (i + j - 3.0),
        };
        bending / length.powi(3) + length.powf(m + 1.0) / (i + j + m + 1.0)
    };
    let energy = nalgebra::DMatrix::from_fn(13, 13, entry);
    let free = energy.view((2, 2), (11, 11)).clone_owned();
    let coupled = energy.view((2, 0), (11, 2)).clone_owned();
    let moved = free.lu().solve(&coupled).expect("stiff polynomials");
    let head = energy.view((0, 0), (2, 2)) - coupled.transpose() * moved;
    [
        head[(0, 0)],
        head[(0, 1)] * length,
        head[(1, 1)] * length * length,
    ]
}

fn near(got: [f64; 3], expected: [f64; 3], most: f64, case: &str) {
    for (got, expected) in got.into_iter().zip(expected) {
        let holds = (got - expected).abs() < most;
        assert!(holds, "{case}: {got} for {expected}");
    }
}

/// Constant springs: the closed form with trigonometric and hyperbolic functions (Psaroudakis,
/// Mylonakis & Antonopoulos 2021).
#[test]
fn constant_springs_have_the_closed_form() {
    for length in [0.3, 1.0, 2.5, 6.0, 12.0, 20.0] {
        // EI = 1, k = 1.
        let b = 0.25_f64.powf(0.25);
        let x = 2.0 * b * length;
        let d = 2.0 + x.cos() + x.cosh();
        let expected = [
            4.0 * b.powi(3) * (x.sin() + x.sinh()) / d,
            2.0 * b * b * (x.cosh() - x.cos()) / d,
            2.0 * b * (x.sinh() - x.sin()) / d,
        ];
        for (got, expected) in factors(0.0, length).into_iter().zip(expected) {
            assert_close(got, expected, 2e-12, &format!("length {length}"));
        }
    }
}

/// A short pile turns as a whole: ∫ k dz, ∫ k z dz, ∫ k z² dz. A long one does not feel its tip.
#[test]
fn piles_on_springs_have_both_limits() {
    for m in [0.0, 0.5, 1.0, 2.0, 4.0] {
        let length = 1e-3_f64;
        let expected = [1.0, 2.0, 3.0].map(|power| length.powf(m + power) / (m + power));
        for (got, expected) in factors(m, length).into_iter().zip(expected) {
            assert_close(got, expected, 1e-10, &format!("short, m = {m}"));
        }
        for length in [40.0, 1e3, 1e9] {
            for (got, expected) in factors(m, length).into_iter().zip(factors(m, 30.0)) {
                assert_close(got, expected, 1e-10, &format!("long, m = {m}, {length}"));
            }
        }
    }
}

/// The pile of the DTU 10 MW turbine in soil of 30 MPa.
fn dtu() -> Monopile {
    Monopile {
        tube: PileTube {
            diameter_m: 9.0,
            wall_thickness_m: 0.11,
            embedded_length_m: 42.0,
            youngs_modulus_pa: 2.1e11,
        },
        formula: PileFormula::ShadlouBhattacharya,
        soil_profile: SoilProfile::Homogeneous,
        soil_youngs_modulus_pa: 3e7,
        soil_poissons_ratio: 0.3,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    }
}

fn digits(head: HeadStiffness, expected: [f64; 3], most: f64, case: &str) {
    let got = [head.lateral_n_per_m, head.coupling_n, head.rocking_n_m];
    for (got, expected) in got.into_iter().zip(expected) {
        assert_close(got, expected, most, case);
    }
}

/// Yu & Amdahl (2023), table 9, whose digits leave the factor of Poisson's ratio out: that of 0.25.
#[test]
fn shadlou_and_bhattacharya_have_the_published_digits() {
    let quarter = changed!(dtu(), soil_poissons_ratio = 0.25);
    digits(quarter.head(), [1.31e9, -18.7e9, 469e9], 2e-3, "flexible");
    // A pile that hardly bends.
    let mut stiff = quarter;
    stiff.tube.youngs_modulus_pa *= 1e6;
    assert_eq!(stiff.form(), PileBehaviour::Rigid);
    digits(stiff.head(), [2.25e9, -47.7e9, 1700e9], 3e-3, "rigid");
    let expected = [1.349e9, -19.29e9, 482.9e9];
    digits(dtu().head(), expected, 5e-4, "with the factor");
    // A factor of the whole matrix: 1 + 0.6 × 0.05.
    let factor = dtu().head().lateral_n_per_m / quarter.head().lateral_n_per_m;
    assert_close(factor, 1.03, 1e-12, "the factor");
}

#[test]
fn a_pile_is_rigid_flexible_or_neither() {
    let slenderness = dtu().slenderness();
    assert_close(slenderness.ratio, 4.667, 1e-3, "L/D");
    assert_close(slenderness.flexible_at_least, 7.92, 1e-3, "flexible from");
    assert_close(slenderness.rigid_at_most, 1.87, 3e-3, "rigid up to");
    assert_eq!(slenderness.behaviour(), PileBehaviour::Between);
    // The smaller of both forms.
    assert_eq!(dtu().form(), PileBehaviour::Flexible);
    let mut long = dtu();
    long.tube.embedded_length_m = 9.0 * 8.0;
    assert_eq!(long.slenderness().behaviour(), PileBehaviour::Flexible);
    long.tube.embedded_length_m = 9.0 * 1.8;
    assert_eq!(long.slenderness().behaviour(), PileBehaviour::Rigid);
}

/// Values of another implementation.
#[test]
fn formulas_for_flexible_piles() {
    let by = |formula| Monopile { formula, ..dtu() }.head();
    let expected = [1.14e9, -13.7e9, 456e9];
    digits(by(PileFormula::En1998), expected, 1e-2, "EN 1998-5");
    let expected = [1.14e9, -15.3e9, 489e9];
    digits(by(PileFormula::Randolph), expected, 1e-2, "Randolph");
}

/// Randolph in soil that grows with depth, by fixed-point iteration for the critical length.
#[test]
fn randolph_in_linear_soil() {
    let pile = Monopile {
        formula: PileFormula::Randolph,
        soil_profile: SoilProfile::Linear,
        ..dtu()
    };
    let (d, nu) = (9.0, 0.3);
    let g_star = 3e7 / (2.0 * (1.0 + nu)) * (1.0 + 0.75 * nu);
    let solid = pile.tube.solid_modulus_pa();
    let mut critical: f64 = d;
    for _ in 0..200 {
        let mean = g_star * 0.5 * critical / d;
        critical = d * (solid / mean).powf(2.0 / 7.0);
    }
    let mean = g_star * 0.5 * critical / d;
    let (q, h) = (
        (solid / mean).powf(1.0 / 7.0) / (0.5 * mean),
        0.5 * critical,
    );
    let head = pile.head();
    // A force of 1 N: displacement and rotation by the formula, force and moment by the matrix.
    let (u, theta) = (q * 0.27 / h, q * 0.30 / (h * h));
    let force = head.lateral_n_per_m * u + head.coupling_n * theta;
    let moment = head.coupling_n * u + head.rocking_n_m * theta;
    assert_close(force, 1.0, 1e-10, "force");
    assert!(moment.abs() < 1e-10 * head.rocking_n_m * theta, "{moment}");
}

/// Carter & Kulhawy as stiffness, in another fit of the same authors' results: within 3 %.
#[test]
fn carter_and_kulhawy_have_two_forms() {
    for slenderness in [1.0, 2.0, 4.0, 10.0] {
        let (d, nu) = (9.0, 0.3);
        let mut pile = changed!(dtu(), formula = PileFormula::CarterKulhawy);
        pile.tube.embedded_length_m = slenderness * d;
        let l = slenderness * d;
        let g_star = 3e7 / (2.0 * (1.0 + nu)) * (1.0 + 0.75 * nu);
        let n = 1.0 - 0.28 * (2.0 * l / d).powf(0.25);
        let expected = [
            3.15 * g_star * d.powf(2.0 / 3.0) * l.powf(1.0 / 3.0) / n,
            -2.0 * g_star * d.powf(7.0 / 8.0) * l.powf(9.0 / 8.0) / n,
            4.0 * g_star * d.powf(4.0 / 3.0) * l.powf(5.0 / 3.0) / n,
        ];
        digits(pile.head(), expected, 0.03, &format!("L/D = {slenderness}"));
    }
}

/// Poulos & Davis against the exact beam: within 1.5 % for long piles and 1 % for short ones; the
/// rigid form is an upper bound everywhere.
#[test]
fn poulos_and_davis_are_near_the_exact_beam() {
    let by = |formula, m, length| changed!(unit_pile(m, length), formula);
    let largest = |m, length| {
        let theirs = by(BeamFormula::PoulosDavis, m, length).head();
        let exact = by(BeamFormula::Exact, m, length).head();
        let pairs = [
            (theirs.lateral_n_per_m, exact.lateral_n_per_m),
            (theirs.coupling_n, exact.coupling_n),
            (theirs.rocking_n_m, exact.rocking_n_m),
        ];
        let off = pairs.map(|(theirs, exact)| (theirs / exact - 1.0).abs());
        off.into_iter().fold(0.0, f64::max)
    };
    for m in [0.0, 1.0] {
        for length in [8.0, 12.0, 30.0] {
            let holds = largest(m, length) < 0.015;
            assert!(holds, "long, {m}: {}", largest(m, length));
        }
        for length in [0.1, 0.3, 0.5] {
            let holds = largest(m, length) < 0.01;
            assert!(holds, "short, {m}: {}", largest(m, length));
        }
        let [rigid, flexible] = by(BeamFormula::PoulosDavis, m, 1.0).limits_of_poulos_davis();
        for length in [rigid, 0.5 * (rigid + flexible), flexible] {
            let theirs = by(BeamFormula::PoulosDavis, m, length).head();
            let exact = by(BeamFormula::Exact, m, length).head();
            let ratio = theirs.free_rocking_n_m() / exact.free_rocking_n_m();
            assert!((0.97..1.6).contains(&ratio), "{m}, {length}: {ratio}");
        }
    }
}

/// Springs from the modulus of the soil: 1.2 E, and Vesić's, which grow with E^(13/12).
#[test]
fn springs_from_the_modulus_of_the_soil() {
    let tube = dtu().tube;
    let youngs_modulus_pa = 3e7;
    let gazetas = SoilSpring::Gazetas { youngs_modulus_pa };
    assert_close(gazetas.of(&tube), 3.6e7, 1e-15, "Gazetas");
    let vesic = |youngs_modulus_pa| SoilSpring::Vesic {
        youngs_modulus_pa,
        poissons_ratio: 0.3,
    };
    let ratio = vesic(2.0 * youngs_modulus_pa).of(&tube) / vesic(youngs_modulus_pa).of(&tube);
    assert_close(ratio, 2.0_f64.powf(13.0 / 12.0), 1e-13, "Vesic");
    assert_close(vesic(1.0).exponent(1.0), 13.0 / 12.0, 1e-15, "exponent");
    // K_L, K_LR, K_R of the pile of the DTU 10 MW turbine by another implementation.
    let pile = |soil_spring| WinklerPile {
        tube,
        formula: BeamFormula::Exact,
        soil_spring,
        exponent: 0.0,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    };
    let expected = [0.96e9, -15.1e9, 382e9];
    digits(pile(gazetas).head(), expected, 6e-3, "k = 1.2 E");
    let expected = [0.50e9, -9.0e9, 242e9];
    let vesic = SoilSpring::Vesic {
        youngs_modulus_pa,
        poissons_ratio: 0.25,
    };
    digits(pile(vesic).head(), expected, 2.5e-2, "Vesic");
}

fn tower_on(foundation: Foundation) -> TowerDescription {
    TowerDescription {
        rna: Rna::point(500e3),
        foundation,
        ..tube(&[(0.0, 8.0, 0.08), (100.0, 5.0, 0.03)])
    }
}

fn warnings(pile: Monopile) -> Vec<Warning> {
    let description = tower_on(Foundation::Monopile(Box::new(pile)));
    let tower = Tower::new(description).expect("a possible tower");
    let of_foundation =
        |warning: &&Warning| matches!(warning.place(), Some(Place::Foundation { .. }));
    tower
        .warnings()
        .iter()
        .filter(of_foundation)
        .cloned()
        .collect()
}

#[test]
fn a_pile_outside_its_formula_is_told_with_the_numbers() {
    let [warning] = &warnings(dtu())[..] else {
        panic!("{:?}", warnings(dtu()));
    };
    assert!(matches!(warning, Warning::BetweenRigidAndFlexible { .. }));
    let text = warning.to_string();
    text.says_all("4.67 & 1.87 & 7.92");
    for formula in [PileFormula::Randolph, PileFormula::En1998] {
        let told = warnings(Monopile { formula, ..dtu() });
        let [Warning::OutsideFormula { value, least, .. }] = told[..] else {
            panic!("{told:?}");
        };
        assert_close(value, 42.0 / 9.0, 1e-12, "value");
        assert_close(least, 7.92, 1e-3, "least");
    }
    let mut long = dtu();
    long.tube.embedded_length_m = 75.0;
    assert_eq!(warnings(long), []);
    // kPa for Pa.
    long.soil_youngs_modulus_pa = 3e4;
    assert!(
        warnings(long)
            .iter()
            .any(|w| matches!(w, Warning::Unusual { .. }))
    );
}

/// Piles on springs by Poulos & Davis between their limits, and rigid ones that bend.
#[test]
fn formulas_with_limits_tell_where_they_end() {
    let pile = |length| {
        let mut pile = unit_pile(1.0, length);
        pile.formula = BeamFormula::PoulosDavis;
        pile.tube.diameter_m = 8.0;
        pile.tube.wall_thickness_m = 0.08;
        pile.tube.youngs_modulus_pa = 2.1e11;
        pile.soil_spring = SoilSpring::Given {
            spring_n_per_m2: 1e8,
        };
        pile.tube.embedded_length_m *= length / pile.reduced_length();
        assert_close(pile.reduced_length(), length, 1e-12, "reduced length");
        let description = tower_on(Foundation::WinklerPile(Box::new(pile)));
        let tower = Tower::new(description).expect("a possible tower");
        tower.warnings().to_vec()
    };
    for (length, is_between) in [(1.9, false), (3.0, true), (4.1, false)] {
        let warned = pile(length)
            .iter()
            .any(|w| matches!(w, Warning::BetweenRigidAndFlexible { .. }));
        assert_eq!(warned, is_between, "{length}: {:?}", pile(length));
    }
    let formula = PileFormula::CarterKulhawy;
    let told = warnings(Monopile { formula, ..dtu() });
    let [Warning::OutsideFormula { value, most, .. }] = told[..] else {
        panic!("{told:?}");
    };
    assert_close(value, 42.0 / 9.0, 1e-12, "value");
    assert_close(most, 1.87, 3e-3, "most");
    let mut pile = unit_pile(0.5, 3.0);
    pile.formula = BeamFormula::PoulosDavis;
    let refused = Tower::new(tower_on(Foundation::WinklerPile(Box::new(pile))));
    let problem = refused.expect_err("no form for this exponent").problem;
    let is_so = matches!(
        problem,
        Problem::ExponentWithoutFormula { exponent: 0.5, .. }
    );
    assert!(is_so, "{problem:?}");
}

#[test]
fn impossible_piles_are_refused() {
    let problem = |change: fn(&mut Monopile)| {
        let mut pile = dtu();
        change(&mut pile);
        let tower = Tower::new(tower_on(Foundation::Monopile(Box::new(pile))));
        tower.expect_err("an impossible pile").problem
    };
    let wall = problem(|pile| pile.tube.wall_thickness_m = 5.0);
    assert_matches!(wall, Problem::TooLarge { most: 4.5, .. });
    let length = problem(|pile| pile.tube.embedded_length_m = 0.0);
    assert!(matches!(length, Problem::NotPositive { .. }), "{length:?}");
    let soil = problem(|pile| pile.soil_youngs_modulus_pa = -3e7);
    assert!(matches!(soil, Problem::NotPositive { .. }), "{soil:?}");
    let ratio = problem(|pile| pile.soil_poissons_ratio = 0.6);
    assert_matches!(ratio, Problem::SoilPoissonsRatio { .. });
    let profile = problem(|pile| {
        pile.formula = PileFormula::Randolph;
        pile.soil_profile = SoilProfile::Parabolic;
    });
    assert!(matches!(profile, Problem::ProfileWithoutFormula { .. }));
    let profile = problem(|pile| {
        pile.formula = PileFormula::CarterKulhawy;
        pile.soil_profile = SoilProfile::Linear;
    });
    assert!(matches!(profile, Problem::ProfileWithoutFormula { .. }));
    // So soft a soil that the coupling is larger than both stiffnesses allow.
    let soft = problem(|pile| {
        pile.soil_youngs_modulus_pa = 1.0;
        pile.tube.embedded_length_m = 1e6;
    });
    assert!(matches!(soft, Problem::Indefinite { .. }), "{soft:?}");
}

/// A pile without mass that is part of the tower, on springs that grow with depth, and the same
/// pile condensed to its head.
#[test]
fn a_condensed_pile_is_the_pile_in_the_tower() {
    let length_m = 30.0;
    let spring = 2e8;
    let tube = PileTube {
        diameter_m: 8.0,
        wall_thickness_m: 0.08,
        embedded_length_m: length_m,
        youngs_modulus_pa: 2.1e11,
    };
    let condensed = tower_on(Foundation::WinklerPile(Box::new(WinklerPile {
        tube,
        formula: BeamFormula::Exact,
        soil_spring: SoilSpring::Given {
            spring_n_per_m2: spring,
        },
        exponent: 1.0,
        vertical_n_per_m: f64::INFINITY,
        torsion_n_m: f64::INFINITY,
    })));
    let mut whole = condensed.clone();
    let pile = Material::from_shear_modulus(1e-6, 2.1e11, 8.08e10);
    whole.materials.push(pile);
    let below = |height_m| changed!(Station::new(height_m, 8.0, 0.08), material = 1);
    whole.stations.splice(0..0, [below(-length_m), below(0.0)]);
    whole.foundation = Foundation::Springs(towermodes::FoundationSprings {
        lateral_n_per_m: 0.0,
        rocking_n_m: 0.0,
        ..towermodes::FoundationSprings::RIGID
    });
    let row = |height_m: f64| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: spring * -height_m / 8.0,
            y_n_per_m2: spring * -height_m / 8.0,
            ..SoilStiffness::default()
        },
    };
    whole.soil = vec![vec![row(-length_m), row(0.0)]];
    let options = with!(Options, method = Method::Spectral, modes = 4);
    let of = |description: &TowerDescription| all_frequencies(&solved(description, &options));
    let (short, long) = (of(&condensed), of(&whole));
    for (mode, (short, long)) in short.iter().zip(&long).take(4).enumerate() {
        assert_close(*short, *long, 1e-9, &format!("mode {mode}"));
    }
}

/// The stiffness of a rigid pile is proportional to the modulus of the soil: its derivative is the
/// sum of those of the springs.
#[test]
fn the_derivative_by_the_soil_is_that_of_all_springs() {
    let mut pile = dtu();
    pile.tube.youngs_modulus_pa = 2.1e15;
    let description = tower_on(Foundation::Monopile(Box::new(pile)));
    let springs = tower_on(Foundation::Springs(pile.springs()));
    let relative = |description: &TowerDescription, names: &[&str]| -> f64 {
        let changes: Vec<Change> = names
            .iter()
            .map(|name| Change::parse(&format!("scale({name})"), description).expect("a number"))
            .collect();
        let options = Options::default();
        let result = Solver::new(options).sensitivities(description, &changes);
        let result = result.expect("derivatives");
        let of = |change: &towermodes::ChangeSensitivity| {
            change.modes[0].as_ref().expect("a derivative").hz_per_unit
        };
        result.changes.iter().map(of).sum()
    };
    let by_soil = relative(&description, &["foundation.soil_youngs_modulus"]);
    let keys = ["lateral", "rocking", "coupling"];
    let names = keys.map(|key| format!("foundation.{key}"));
    let by_springs = relative(&springs, &names.each_ref().map(|name| &**name));
    assert!(by_soil > 0.0);
    assert_close(by_soil, by_springs, 1e-6, "the sum");
}

/// The springs of a pile depend on powers of its diameter, so one central difference is not exact:
/// it misses the derivative, here by differences of sixth order, by twice the error that it states.
#[test]
fn the_derivative_by_the_diameter_of_a_pile_is_that_of_frequencies() {
    let base = tower_on(Foundation::Monopile(Box::new(dtu())));
    let diameter = Change::parse("foundation.diameter", &base).expect("a number");
    let mut solver = Solver::new(Options {
        method: Method::Spectral,
        degree: Some(14),
        modes: 2,
        ..Options::default()
    });
    let own_m = diameter.parameters()[0].value(&base);
    let h = 2e-2 * own_m;
    let mut hz = |steps: f64| {
        let mut changed = base.clone();
        diameter.apply(&mut changed, own_m + steps * h);
        let tower = Tower::new(changed).expect("a tower");
        solver.frequencies(&tower).expect("solved").modes[0].extrapolated_hz
    };
    let mut central = |k: f64| (hz(k) - hz(-k)) / (2.0 * k * h);
    let expected = 1.5 * central(1.0) - 0.6 * central(2.0) + 0.1 * central(3.0);
    let found = Solver::default().sensitivities(&base, std::slice::from_ref(&diameter));
    let found = found.expect("derivatives").changes[0].modes[0].expect("a derivative");
    let missed = (found.hz_per_unit - expected).abs();
    assert!(missed <= found.error_hz_per_unit, "{missed:e} {found:?}");
}
