//! Footings and caissons by closed form: half-space limits, values of other programs, signs,
//! warnings and refusals.

use crate::towers;

use towermodes::{
    CircularFooting, FootingFormula, Foundation, FoundationSprings, Method, Options, Place,
    Problem, RectangularFooting, Rna, SoilProfile, SoilRow, SoilStiffness, StiffnessFoundation,
    SuctionCaisson, Tower, TowerDescription, Warning,
};
use towermodes_testing::{Says, assert_matches, changed, parts, tube, with};
use towers::{all_frequencies, assert_close, solved};

const INF: f64 = f64::INFINITY;

fn circular() -> CircularFooting {
    CircularFooting {
        radius_m: 9.0,
        embedment_m: 0.0,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.3,
        stratum_thickness_m: INF,
        lower_shear_modulus_pa: INF,
        is_coupled: false,
    }
}

fn rectangular(formula: FootingFormula) -> RectangularFooting {
    RectangularFooting {
        formula,
        length_x_m: 20.0,
        length_y_m: 12.0,
        embedment_m: 0.0,
        shear_modulus_pa: 5e7,
        poissons_ratio: 0.3,
        is_coupled: false,
    }
}

fn caisson() -> SuctionCaisson {
    SuctionCaisson {
        diameter_m: 12.0,
        skirt_length_m: 9.0,
        soil_profile: SoilProfile::Homogeneous,
        soil_youngs_modulus_pa: 4e7,
        soil_poissons_ratio: 0.2,
        vertical_n_per_m: INF,
        torsion_n_m: INF,
    }
}

fn values(springs: &FoundationSprings) -> [f64; 5] {
    [
        springs.lateral_n_per_m,
        springs.rocking_n_m,
        springs.vertical_n_per_m,
        springs.torsion_n_m,
        springs.coupling_n,
    ]
}

fn all_close(got: &FoundationSprings, expected: &FoundationSprings, most: f64, case: &str) {
    let pairs = values(got).into_iter().zip(values(expected));
    for (got, expected) in pairs.filter(|(_, expected)| *expected != 0.0) {
        assert_close(got, expected, most, case);
    }
    assert_eq!(got.coupling_n, expected.coupling_n, "{case}");
}

/// A deep stratum, a stratum over soil as stiff as itself: the half-space. A stratum over very
/// stiff soil: rock.
#[test]
fn strata_have_the_half_space_as_their_limits() {
    let (g, r, nu) = (5e7, 9.0_f64, 0.3);
    let half_space = FoundationSprings {
        lateral_n_per_m: 8.0 * g * r / (2.0 - nu),
        rocking_n_m: 8.0 * g * r.powi(3) / (3.0 * (1.0 - nu)),
        coupling_n: 0.0,
        vertical_n_per_m: 4.0 * g * r / (1.0 - nu),
        torsion_n_m: 16.0 * g * r.powi(3) / 3.0,
    };
    let case = "without a stratum";
    all_close(&circular().springs(), &half_space, 1e-15, case);
    for stratum_thickness_m in [10.0, 20.0, 100.0] {
        let over = |lower_shear_modulus_pa| {
            changed!(circular(), stratum_thickness_m, lower_shear_modulus_pa).springs()
        };
        all_close(&over(g), &half_space, 1e-15, "over the same soil");
        all_close(&over(1e30), &over(INF), 1e-15, "over very stiff soil");
        assert!(over(2.0 * g).lateral_n_per_m > half_space.lateral_n_per_m);
        assert!(over(INF).lateral_n_per_m > over(2.0 * g).lateral_n_per_m);
    }
    let deep = changed!(circular(), stratum_thickness_m = 1e9);
    all_close(&deep.springs(), &half_space, 2e-8, "deep rock");
    // The factors of rock at a depth of two radii, and of an embedment of half a radius.
    let rock = changed!(circular(), stratum_thickness_m = 18.0);
    let expected = 1.64 * half_space.vertical_n_per_m;
    assert_close(rock.springs().vertical_n_per_m, expected, 1e-14, "vertical");
    let expected = 13.0 / 12.0 * half_space.rocking_n_m;
    assert_close(rock.springs().rocking_n_m, expected, 1e-14, "rocking");
    let embedded = changed!(circular(), embedment_m = 4.5);
    let factors = [4.0 / 3.0, 2.0, 1.25, 7.0 / 3.0];
    let pairs = values(&embedded.springs())
        .into_iter()
        .zip(values(&half_space));
    for ((got, without), factor) in pairs.zip(factors) {
        assert_close(got, factor * without, 1e-14, "embedment");
    }
}

/// The type half-space has another lateral formula, 32 (1 − ν)GR/(7 − 8ν); the others are equal.
#[test]
fn both_circular_footings_differ_by_the_lateral_spring() {
    let other = parts::half_space(9.0, 0.0, 5e7, 0.3);
    let (ours, other) = (circular().springs(), other.springs());
    let ratio = other.lateral_n_per_m / ours.lateral_n_per_m;
    assert_close(ratio, 1.0348, 1e-4, "lateral");
    let lateral_n_per_m = other.lateral_n_per_m;
    let case = "the others";
    all_close(&changed!(ours, lateral_n_per_m), &other, 1e-15, case);
}

/// Entries along x, y, z, about x, y of a footing of 20 m along x and 12 m along y, by the program
/// geofound 0.6; its rocking stiffness by Pais & Kausel has the factor of the embedment squared.
#[test]
fn rectangular_footings_have_the_stiffness_of_another_program() {
    let table = [
        (
            FootingFormula::Gazetas,
            0.0,
            [
                2040201600.5364292,
                2129090489.425318,
                2542666706.594242,
                86147421242.59436,
                195698736508.55606,
            ],
        ),
        (
            FootingFormula::Gazetas,
            3.0,
            [
                3329829308.3425016,
                3267923531.027044,
                3107241152.13619,
                161440090876.27963,
                385933057591.2395,
            ],
        ),
        (
            FootingFormula::PaisKausel,
            0.0,
            [
                2096094137.4652445,
                2190211784.524068,
                2634533131.4710855,
                94628571428.57144,
                200262983722.1799,
            ],
        ),
        (
            FootingFormula::PaisKausel,
            3.0,
            [
                3098332515.689257,
                3237452110.067376,
                3239789906.33229,
                (272945033028.57928_f64 * 94628571428.57144).sqrt(),
                (480877672611.51117_f64 * 200262983722.1799).sqrt(),
            ],
        ),
    ];
    for (formula, embedment_m, expected) in table {
        let footing = changed!(rectangular(formula), embedment_m);
        let k = footing.stiffness();
        let case = format!("{}, {embedment_m} m", formula.name());
        for (i, expected) in expected.into_iter().enumerate() {
            assert_close(k[i][i], expected, 1e-13, &format!("{case}, row {i}"));
        }
        // Turned by a quarter.
        let turned = changed!(footing, length_x_m = 12.0, length_y_m = 20.0);
        let t = turned.stiffness();
        for (i, j) in [(0, 1), (2, 2), (3, 4), (5, 5)] {
            assert_eq!(t[i][i], k[j][j], "{case}");
            assert_eq!(t[j][j], k[i][i], "{case}");
        }
    }
}

/// Two independent fits to the same half-space: torsion, which no program was found for, within
/// 6 %, everything else within 10 %; and a square is near the circle of equal area.
#[test]
fn both_formulas_for_rectangular_footings_agree() {
    for ratio in [1.0, 1.5, 2.0, 3.0, 4.0] {
        let of = |formula| changed!(rectangular(formula), length_x_m = 12.0 * ratio).stiffness();
        let (first, second) = (of(FootingFormula::Gazetas), of(FootingFormula::PaisKausel));
        for i in 0..6 {
            let most = if i == 5 { 0.06 } else { 0.12 };
            let case = format!("sides 1:{ratio}, row {i}");
            assert_close(first[i][i], second[i][i], most, &case);
        }
    }
    let square = changed!(rectangular(FootingFormula::Gazetas), length_x_m = 12.0);
    let circle = changed!(circular(), radius_m = 12.0 / std::f64::consts::PI.sqrt());
    let (k, springs) = (square.stiffness(), circle.springs());
    assert_close(k[0][0], springs.lateral_n_per_m, 0.01, "lateral");
    assert_close(k[2][2], springs.vertical_n_per_m, 0.01, "vertical");
    assert_eq!(k[0][0], k[1][1]);
}

/// Digits of Jalbi, Shadlou & Bhattacharya's fit: K_L/(RG) and K_R/(R³G) for ν = 0.2; the paper's
/// finite elements are within 1 % of them.
#[test]
fn caissons_have_the_published_digits() {
    for (slenderness, [lateral, rocking], [paper_lateral, paper_rocking]) in [
        (0.5, [8.99, 13.0], [9.08, 13.1]),
        (2.0, [19.7, 187.0], [19.9, 187.0]),
    ] {
        let caisson = changed!(caisson(), skirt_length_m = slenderness * 12.0);
        let head = caisson.head();
        let g = 4e7 / 2.4;
        let of_lateral = head.lateral_n_per_m / (6.0 * g);
        let of_rocking = head.rocking_n_m / (6.0_f64.powi(3) * g);
        assert_close(of_lateral, lateral, 3e-3, "lateral");
        assert_close(of_rocking, rocking, 3e-3, "rocking");
        assert_close(of_lateral, paper_lateral, 0.012, "lateral of the paper");
        assert_close(of_rocking, paper_rocking, 0.012, "rocking of the paper");
        assert!(head.coupling_n < 0.0 && head.free_rocking_n_m() > 0.0);
    }
}

fn tower_on(foundation: Foundation) -> TowerDescription {
    TowerDescription {
        rna: Rna::point(500e3),
        foundation,
        ..tube(&[(0.0, 8.0, 0.08), (100.0, 5.0, 0.03)])
    }
}

/// Every foundation by closed form against the same stiffness as a matrix.
#[test]
fn the_frequencies_are_those_of_the_matrix() {
    let embedded = |formula| changed!(rectangular(formula), embedment_m = 3.0, is_coupled = true);
    let foundations = [
        Foundation::CircularFooting(Box::new(CircularFooting {
            embedment_m: 3.0,
            stratum_thickness_m: 20.0,
            is_coupled: true,
            ..circular()
        })),
        Foundation::RectangularFooting(Box::new(embedded(FootingFormula::Gazetas))),
        Foundation::RectangularFooting(Box::new(embedded(FootingFormula::PaisKausel))),
        Foundation::SuctionCaisson(Box::new(caisson())),
    ];
    let options = with!(Options, method = Method::Spectral, modes = 6);
    for foundation in foundations {
        let stiffness = foundation.derived_stiffness().expect("by its dimensions");
        let matrix = Foundation::Stiffness(Box::new(with!(StiffnessFoundation, stiffness)));
        let of = |foundation| all_frequencies(&solved(&tower_on(foundation), &options));
        assert_eq!(of(foundation.clone()), of(matrix), "{foundation:?}");
    }
}

/// A foundation that is rigid itself gets twice as stiff in soil that is twice as stiff; rock stays
/// rigid.
#[test]
fn rigid_foundations_are_as_stiff_as_their_soil() {
    let foundations = [
        Foundation::CircularFooting(Box::new(changed!(circular(), stratum_thickness_m = 20.0))),
        Foundation::CircularFooting(Box::new(CircularFooting {
            stratum_thickness_m: 20.0,
            lower_shear_modulus_pa: 3e8,
            ..circular()
        })),
        Foundation::RectangularFooting(Box::new(rectangular(FootingFormula::PaisKausel))),
        Foundation::SuctionCaisson(Box::new(caisson())),
    ];
    for foundation in foundations {
        let tower = tower_on(foundation);
        assert!(tower.stands_in_soil());
        let stiffness = |tower: &TowerDescription| tower.foundation.derived_stiffness();
        let once = stiffness(&tower).expect("by its dimensions");
        let twice = stiffness(&tower.with_soil_factor(2.0)).expect("by its dimensions");
        for (once, twice) in once.into_iter().flatten().zip(twice.into_iter().flatten()) {
            let is_zero = once == 0.0 && twice == 0.0;
            let is_rigid = once == INF && twice == INF;
            assert!(is_zero || is_rigid || (twice / once - 2.0).abs() < 1e-12);
        }
    }
}

/// The sides of an embedded footing are held above its underside: the coupling is positive, and
/// without it the footing is as stiff as one whose springs are at the underside.
#[test]
fn the_coupling_of_an_embedded_footing() {
    let footing = |is_coupled| changed!(circular(), embedment_m = 3.0, is_coupled);
    let springs = footing(true).springs();
    let case = "e/3 = 1 m";
    assert_close(springs.coupling_n, springs.lateral_n_per_m, 1e-15, case);
    let uncoupled = changed!(springs, coupling_n = 0.0);
    assert_eq!(footing(false).springs(), uncoupled);
    let surface = changed!(circular(), is_coupled = true);
    assert_eq!(surface.springs().coupling_n, 0.0);
}

fn warnings(foundation: Foundation) -> Vec<Warning> {
    let tower = Tower::new(tower_on(foundation)).expect("a possible tower");
    let of_foundation =
        |warning: &&Warning| matches!(warning.place(), Some(Place::Foundation { .. }));
    let warnings = tower.warnings().iter();
    warnings.filter(of_foundation).cloned().collect()
}

#[track_caller]
fn warned(foundation: Foundation, key: &'static str, texts: &[&str]) {
    let all = warnings(foundation);
    let [warning] = &all[..] else {
        panic!("{all:?}");
    };
    assert_eq!(warning.place(), Some(Place::Foundation { key }));
    for text in texts {
        warning.says(text);
    }
}

#[test]
fn footings_and_caissons_outside_their_range_are_told_with_the_numbers() {
    let of_circular = |change: fn(&mut CircularFooting)| {
        let mut footing = circular();
        change(&mut footing);
        Foundation::CircularFooting(Box::new(footing))
    };
    assert_eq!(warnings(of_circular(|_| {})), []);
    warned(
        of_circular(|footing| footing.stratum_thickness_m = 7.2),
        "soil_thickness",
        &["0.8", "at least 2"],
    );
    warned(
        of_circular(|footing| {
            footing.stratum_thickness_m = 18.0;
            footing.lower_shear_modulus_pa = 1e7;
        }),
        "lower_shear_modulus",
        &["is 5", "at most 1"],
    );
    warned(
        of_circular(|footing| footing.lower_shear_modulus_pa = 1e7),
        "lower_shear_modulus",
        &["lower_shear_modulus has no effect without soil_thickness; add the thickness"],
    );
    warned(
        of_circular(|footing| {
            footing.stratum_thickness_m = 20.0;
            footing.embedment_m = 12.0;
        }),
        "embedment",
        &["0.6", "at most 0.5"],
    );
    warned(
        of_circular(|footing| footing.embedment_m = 22.5),
        "embedment",
        &["2.5", "at most 2"],
    );
    // kPa for Pa, and mm for m.
    warned(
        of_circular(|footing| footing.shear_modulus_pa = 5e4),
        "soil_shear_modulus",
        &["50000 Pa"],
    );
    let mut narrow = rectangular(FootingFormula::Gazetas);
    narrow.length_y_m = 1.2;
    let foundation = Foundation::RectangularFooting(Box::new(narrow));
    warned(foundation, "length_y", &["0.15"]);
    let mut deep = rectangular(FootingFormula::PaisKausel);
    deep.embedment_m = 15.0;
    let foundation = Foundation::RectangularFooting(Box::new(deep));
    warned(foundation, "embedment", &["2.5", "Pais & Kausel"]);
    let mut long = caisson();
    long.skirt_length_m = 30.0;
    let foundation = Foundation::SuctionCaisson(Box::new(long));
    warned(foundation, "skirt_length", &["2.5", "0.5 to 2", "Jalbi"]);
    let mut soft = caisson();
    soft.soil_youngs_modulus_pa = 4e4;
    let foundation = Foundation::SuctionCaisson(Box::new(soft));
    warned(foundation, "soil_youngs_modulus", &["40000 Pa"]);
}

#[test]
fn impossible_footings_are_refused() {
    let refused = |change: fn(&mut CircularFooting)| {
        let mut footing = circular();
        change(&mut footing);
        let foundation = Foundation::CircularFooting(Box::new(footing));
        Tower::new(tower_on(foundation)).expect_err("an impossible footing")
    };
    let error = refused(|footing| footing.radius_m = -9.0);
    assert_matches!(error.problem, Problem::NotPositive { .. });
    let error = refused(|footing| footing.embedment_m = -1.0);
    assert!(matches!(error.problem, Problem::Negative { .. }), "{error}");
    let error = refused(|footing| footing.stratum_thickness_m = 0.0);
    assert_matches!(error.problem, Problem::NotPositive { .. });
    let error = refused(|footing| {
        footing.stratum_thickness_m = 4.0;
        footing.embedment_m = 5.0;
    });
    assert!(
        matches!(
            error.problem,
            Problem::EmbeddedBelowStratum {
                embedment_m: 5.0,
                thickness_m: 4.0
            }
        ),
        "{error}"
    );
    let error = refused(|footing| {
        footing.stratum_thickness_m = 30.0;
        footing.lower_shear_modulus_pa = 1e9;
        footing.embedment_m = 5.0;
    });
    assert_matches!(
        error.problem,
        Problem::EmbeddedInTwoStrata { embedment_m: 5.0 }
    );
    let error = refused(|footing| {
        footing.embedment_m = 900.0;
        footing.is_coupled = true;
    });
    assert_matches!(error.problem, Problem::Indefinite { .. });
    let mut footing = rectangular(FootingFormula::Gazetas);
    footing.length_x_m = f64::NAN;
    let foundation = Foundation::RectangularFooting(Box::new(footing));
    let error = Tower::new(tower_on(foundation)).expect_err("no length");
    assert_eq!(error.place, Place::Foundation { key: "length_x" });
    let mut short = caisson();
    short.skirt_length_m = -2.0;
    let foundation = Foundation::SuctionCaisson(Box::new(short));
    let error = Tower::new(tower_on(foundation)).expect_err("a negative length");
    assert_matches!(
        error.place,
        Place::Foundation {
            key: "skirt_length"
        }
    );
}

fn is_twice(warning: &Warning) -> bool {
    matches!(warning, Warning::SoilTwice { .. })
}

/// A caisson under a tower with soil springs counts the soil twice; a footing does not.
#[test]
fn soil_is_not_counted_twice() {
    let row = |height_m| SoilRow {
        height_m,
        stiffness: with!(SoilStiffness, x_n_per_m2 = 1e8, y_n_per_m2 = 1e8),
    };
    let with = |foundation: Foundation, rows: Vec<SoilRow>| {
        let description = changed!(tower_on(foundation), soil = vec![rows]);
        let tower = Tower::new(description).expect("a possible tower");
        tower.warnings().iter().any(is_twice)
    };
    let caisson = Foundation::SuctionCaisson(Box::new(caisson()));
    let footing = Foundation::CircularFooting(Box::new(circular()));
    assert!(with(caisson, vec![row(0.0), row(5.0)]));
    assert!(!with(footing, vec![row(0.0), row(5.0)]));
}

/// The head of a footing whose sides differ has the values of its matrix in each plane.
#[test]
fn the_head_of_a_footing_is_its_matrix_in_both_planes() {
    let footing = changed!(
        rectangular(FootingFormula::Gazetas),
        embedment_m = 2.0,
        is_coupled = true
    );
    let k = footing.stiffness();
    let foundation = Foundation::RectangularFooting(Box::new(footing));
    let tower = Tower::new(tower_on(foundation)).expect("a tower");
    let head = tower.foundation_head().expect("springs");
    let side_side = head.side_side.expect("springs");
    assert_eq!(head.height_m, tower.base_m());
    let of =
        |head: towermodes::HeadStiffness| [head.lateral_n_per_m, head.coupling_n, head.rocking_n_m];
    assert_eq!(of(head.fore_aft), [k[0][0], k[0][4], k[4][4]]);
    assert_eq!(of(side_side), [k[1][1], -k[1][3], k[3][3]]);
    assert_eq!(
        [head.vertical_n_per_m, head.torsion_n_m],
        [Some(k[2][2]), Some(k[5][5])]
    );
}

/// The underside of a footing is at the base, so the bed of the water is higher by its embedment.
#[test]
fn the_bed_of_the_water_is_at_the_soil_around_a_footing() {
    let told = |embedment_m, bed_m| {
        let footing = changed!(rectangular(FootingFormula::Gazetas), embedment_m);
        let description = TowerDescription {
            water: Some(parts::water(20.0, bed_m, 1025.0, 1.0, false)),
            ..tower_on(Foundation::RectangularFooting(Box::new(footing)))
        };
        let tower = Tower::new(description).expect("a possible tower");
        let mut warnings = tower.warnings().to_vec();
        warnings.retain(|warning| matches!(warning, Warning::BedOffFooting { .. }));
        warnings
    };
    assert_eq!(told(0.0, None), []);
    assert_eq!(told(2.0, Some(2.0)), []);
    for bed_m in [None, Some(0.0)] {
        let warnings = told(2.0, bed_m);
        assert_eq!(warnings.len(), 1, "{bed_m:?}");
        warnings[0].says("the soil around the footing reaches up to 2 m");
        assert_eq!(warnings[0].place(), Some(Place::Water { key: "bed" }));
    }
}

/// Springs without coupling under water: of a pile by their lever, or of a footing.
#[test]
fn the_head_of_a_pile_is_coupled() {
    let told = |coupling_n, rocking_n_m, level_m| {
        let springs = parts::springs(2.5e9, rocking_n_m, coupling_n, INF, INF);
        let description = TowerDescription {
            water: Some(parts::water(level_m, None, 1025.0, 1.0, false)),
            ..tower_on(Foundation::Springs(springs))
        };
        let tower = Tower::new(description).expect("a possible tower");
        let is_so = |warning: &Warning| matches!(warning, Warning::NoCoupling { .. });
        tower.warnings().iter().any(is_so)
    };
    assert!(told(0.0, 2.6e11, 20.0));
    assert!(!told(-2.2e10, 2.6e11, 20.0));
    assert!(!told(0.0, 9e10, 20.0), "the lever of a footing");
}
