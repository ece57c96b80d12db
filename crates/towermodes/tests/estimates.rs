//! Claimed errors hold where meshes alone would not know: what is narrower than an element, cones
//! to 70:1, high modes of few segments, elements that are given.
//!
//! The reference is the spectral beam of each method's own physics. A claim holds if the error is
//! at most three times as large.

use crate::towers;

use towermodes::{
    AddedMassRow, Family, Method, Options, Planes, Properties, PropertyStation, Rna, Shear,
    SoilRow, SoilStiffness, Solution, Station, TowerDescription, Warning,
};
use towermodes_testing::{changed, parts, rna, stations, with};
use towers::{assert_close, reference, reference_table, solved};

/// A tower and the beam that it is, with rotary inertia and shear or, for BModes, without.
struct Case {
    description: TowerDescription,
    beams: [Solution; 2],
}

impl Case {
    /// With more modes of the beam than are asked for, as errors bring others into the list.
    fn new(description: TowerDescription, modes: usize) -> Self {
        let beam = |has_all: bool| {
            let mut description = description.clone();
            if !has_all {
                description.shear = Shear::Rigid;
            }
            let options = Options {
                rotary_inertia: has_all,
                ..by(Method::Spectral, None, modes + 8)
            };
            solved(&description, &options)
        };
        let beams = [beam(true), beam(false)];
        Self { description, beams }
    }

    fn beam(&self, method: Method) -> &Solution {
        &self.beams[usize::from(method == Method::Bmodes)]
    }

    /// Asserts that every claim of a solution holds; gives the solution.
    #[track_caller]
    fn assert_holds(&self, options: &Options) -> Solution {
        let solution = solved(&self.description, options);
        for mode in &solution.modes {
            let mut same = self.beam(options.method).modes.iter();
            let same = same.find(|other| other.is_same_as(mode));
            // What is not even among so many modes of the beam must not claim to be known.
            let true_hz = same.map_or(mode.frequency_hz, |same| {
                (mode.frequency_hz - same.frequency_hz).abs() - same.error_hz()
            });
            assert!(
                true_hz <= 3.0 * mode.error_hz() + 1e-9 * mode.frequency_hz,
                "{} {} {:?} {}: {} Hz, claimed {:e}, true {true_hz:e}",
                self.description.name,
                options.method.name(),
                options.segments,
                mode.label(),
                mode.frequency_hz,
                mode.error_hz(),
            );
        }
        solution
    }
}

fn by(method: Method, segments: Option<usize>, modes: usize) -> Options {
    with!(Options, method, segments, modes, points = 2)
}

fn segmented() -> impl Iterator<Item = Method> {
    let methods = Method::ALL.into_iter();
    methods.filter(|method| *method != Method::Spectral)
}

fn added_mass(rows: [(f64, f64); 3]) -> Vec<Vec<AddedMassRow>> {
    let row = |(height_m, mass_kg_per_m)| parts::added_mass_row(height_m, mass_kg_per_m);
    vec![rows.map(row).to_vec()]
}

/// 50 t of added mass within 0.2 m below the second mode's belly, under a machine.
fn added_mass_50t() -> TowerDescription {
    TowerDescription {
        name: "added mass of 50 t".into(),
        added_mass: added_mass([(56.0574, 0.0), (56.1574, 5e5), (56.2574, 0.0)]),
        rna: Rna::point(350e3),
        ..reference()
    }
}

fn added_mass_500t() -> TowerDescription {
    TowerDescription {
        name: "added mass of 500 t".into(),
        added_mass: added_mass([(80.2, 0.0), (80.205, 1e8), (80.21, 0.0)]),
        ..reference()
    }
}

fn soil_spike() -> TowerDescription {
    let row = |height_m, k| SoilRow {
        height_m,
        stiffness: with!(SoilStiffness, x_n_per_m2 = k, y_n_per_m2 = k),
    };
    TowerDescription {
        name: "soil over 1 cm".into(),
        soil: vec![vec![row(60.2, 0.0), row(60.205, 1e10), row(60.21, 0.0)]],
        ..reference()
    }
}

fn polar_inertia_spike() -> TowerDescription {
    let row = |height_m, polar_inertia_kg_m| PropertyStation {
        height_m,
        properties: Properties {
            mass_kg_per_m: 5000.0,
            rotary_inertia_kg_m: Planes::both(0.0),
            polar_inertia_kg_m,
            bending_n_m2: Planes::both(5e11),
            torsion_n_m2: 4e11,
            axial_n: 1.2e11,
            shear_n: None,
        },
    };
    let usual = 5e4;
    TowerDescription {
        name: "polar inertia over 1 cm".into(),
        properties: vec![
            row(0.0, usual),
            row(40.4, usual),
            row(40.405, 1e9),
            row(40.41, usual),
            row(87.6, usual),
        ],
        ..TowerDescription::default()
    }
}

fn narrow() -> [TowerDescription; 4] {
    [
        added_mass_50t(),
        added_mass_500t(),
        soil_spike(),
        polar_inertia_spike(),
    ]
}

fn cone(base: (f64, f64), top: (f64, f64), rna_kg: f64) -> TowerDescription {
    TowerDescription {
        name: "cone".into(),
        stations: stations(&[(0.0, base.0, base.1), (87.6, top.0, top.1)]),
        rna: Rna::point(rna_kg),
        ..reference()
    }
}

fn cone_30_to_1() -> TowerDescription {
    cone(
        (6.0, 0.03),
        (0.199_464_363_155_933_23, 0.011_544_990_722_062_642),
        27.518_384_091_693_29,
    )
}

fn cone_46_to_1() -> TowerDescription {
    cone(
        (6.0, 0.03),
        (0.130_247_520_483_334_07, 0.001_249_310_628_758_520_5),
        2_651.457_472_991_726_7,
    )
}

fn cone_70_to_1() -> TowerDescription {
    cone(
        (0.085_437_208_710_778_08, 0.001_037_124_865_558_109_5),
        (6.0, 0.03),
        792.993_665_412_049_7,
    )
}

/// A short tube under 860 t beside its axis.
fn heavy() -> TowerDescription {
    TowerDescription {
        name: "heavy".into(),
        stations: vec![
            Station::new(-30.0, 3.117_347_196_038_424_3, 0.030_608_125_931_475_248),
            Station::new(
                1.688_225_163_799_416,
                2.431_411_760_113_917_4,
                0.012_456_108_763_820_129,
            ),
        ],
        rna: rna(
            860_111.216_102_178_1,
            [-1.612_207_0, -1.837_471_0, 1.305_370_9],
            [31_078_459.3, 40_285_384.6, 46_683_426.8],
        ),
        ..reference()
    }
}

/// A wall that falls to nothing at one station.
fn wall_to_nothing() -> TowerDescription {
    let stations = [
        (-30.0, 7.398_210_330_255_056, 0.062_146_412_915_085_35),
        (
            -25.161_594_340_836_096,
            7.401_050_843_129_438,
            0.063_908_953_816_186_39,
        ),
        (
            -21.157_633_347_667_59,
            7.403_401_473_388_825,
            0.065_367_522_095_492_7,
        ),
        (
            21.510_503_345_715_264,
            7.428_450_921_521_372,
            0.080_910_728_141_769_65,
        ),
        (
            32.870_867_531_842_82,
            7.435_120_321_113_209,
            0.085_049_096_840_047_63,
        ),
        (36.209_925_946_837_77, 7.437_080_602_884_569, 1e-12),
        (
            50.101_524_519_301_634,
            7.445_236_029_975_742,
            0.091_325_903_671_181_49,
        ),
    ];
    TowerDescription {
        name: "wall to 1e-12 m".into(),
        stations: stations.map(|(z_m, d, t)| Station::new(z_m, d, t)).to_vec(),
        shear: Shear::Coefficient(0.1),
        rna: rna(
            3_466_759.840_660_326,
            [1.742_736_5, 1.102_714_3, 2.140_994_3],
            [3_081_489_427.9, 3_292_663_509.4, 2_439_558_708.0],
        ),
        ..reference()
    }
}

#[test]
fn no_method_misses_what_is_narrower_than_its_segments() {
    for description in narrow() {
        let case = Case::new(description, 8);
        for method in segmented() {
            for segments in [None, Some(20)] {
                case.assert_holds(&by(method, segments, 8));
            }
        }
    }
}

/// An independent hp Ritz code gives the four frequencies.
#[test]
fn bmodes_finds_what_is_narrow() {
    let frequency = |description: &TowerDescription, mode: usize| {
        let solution = solved(description, &by(Method::Bmodes, None, 8));
        let mode = &solution.modes[mode];
        assert!(mode.error_hz() < 1e-3 * mode.frequency_hz);
        mode.frequency_hz
    };
    assert_close(frequency(&added_mass_50t(), 2), 2.530869, 2e-4, "50 t");
    assert_close(frequency(&added_mass_500t(), 0), 0.293, 2e-3, "500 t");
    assert_close(frequency(&soil_spike(), 0), 2.575, 2e-3, "soil");
    let twisting = solved(&polar_inertia_spike(), &by(Method::Bmodes, None, 8));
    let torsion = twisting
        .mode(towermodes::Family::Torsion, 1)
        .expect("there");
    assert_close(torsion.frequency_hz, 5.48, 2e-3, "polar inertia");
}

#[test]
fn errors_on_steep_cones_hold() {
    for description in [cone_30_to_1(), cone_46_to_1(), cone_70_to_1()] {
        let case = Case::new(description, 9);
        for method in segmented() {
            for segments in [None, Some(7), Some(12), Some(20), Some(34), Some(60)] {
                case.assert_holds(&by(method, segments, 9));
            }
        }
    }
    // Two meshes agreed by chance, to 1e-7 where 1e-5 were wrong.
    let default = solved(&cone_30_to_1(), &by(Method::RmjeExact, None, 8));
    let fifth = &default.modes[4];
    assert!(fifth.error_hz() > 5e-5, "{fifth:?}");
    assert_close(fifth.extrapolated_hz, 6.7352737, 1e-7, "the beam");
}

/// An independent hp Ritz code gives 0.1647 Hz.
#[test]
fn a_wall_that_falls_to_nothing_is_no_regular_convergence() {
    for method in [Method::Lumped, Method::RmjeExact] {
        let solution = solved(&wall_to_nothing(), &by(method, None, 2));
        let first = &solution.modes[0];
        let error_hz = (first.frequency_hz - 0.1647).abs() - 5e-5;
        assert!(error_hz <= 3.0 * first.error_hz(), "{first:?}");
    }
}

#[test]
fn high_modes_of_few_segments_are_not_claimed_to_be_known() {
    let case = Case::new(heavy(), 60);
    for method in segmented() {
        let solution = case.assert_holds(&by(method, Some(20), 60));
        let is_told = |warning: &Warning| matches!(warning, Warning::Unresolved { .. });
        assert!(solution.warnings.iter().any(is_told), "{}", method.name());
    }
}

/// With one element of degree 2 the fourth mode is torsion, which is the sixth with degree 4: the
/// list with which it is compared must be longer. Uniform tube with a point mass: f = √(G/ρ)/4L
/// in torsion; in axial motion x tan x = tube/mass with x = 2πf L √(ρ/E).
#[test]
fn the_error_of_a_given_degree_is_no_whole_frequency() {
    let (length_m, mass_kg) = (80.0, 200e3);
    let description = TowerDescription {
        stations: stations(&[(0.0, 4.0, 0.03), (length_m, 4.0, 0.03)]),
        rna: Rna::point(mass_kg),
        ..towers::reference()
    };
    let of_degree_two = Options {
        degree: Some(2),
        ..by(Method::Spectral, Some(1), 4)
    };
    let material = description.materials[0];
    let exact = solved(&description, &by(Method::Spectral, None, 8));
    let torsion_hz =
        (material.shear_modulus_pa / material.density_kg_per_m3).sqrt() / (4.0 * length_m);
    for mode in &solved(&description, &of_degree_two).modes[2..] {
        let true_hz = exact
            .mode(mode.family, mode.order)
            .expect("it is among the lowest eight")
            .frequency_hz;
        if mode.family == Family::Torsion {
            assert_close(true_hz, torsion_hz, 1e-9, "torsion");
        }
        let error_hz = mode.frequency_hz - true_hz;
        let ratio = mode.error_hz() / error_hz;
        assert!((0.9..1.1).contains(&ratio), "{}: {ratio}", mode.label());
    }
}

/// An element of BModes has the section at its middle, whatever is narrower.
#[test]
fn given_elements_are_judged_by_what_they_miss_of_every_quantity() {
    let missed = [
        "added mass",
        "added mass",
        "transverse soil stiffness",
        "polar inertia",
    ];
    for (description, missed) in narrow().into_iter().zip(missed) {
        let case = Case::new(description, 8);
        for elements in [1, 7, 40] {
            let borders_m: Vec<f64> = (0..=elements)
                .map(|k| 87.6 * f64::from(k) / f64::from(elements))
                .collect();
            let options = changed!(by(Method::Bmodes, None, 8), borders_m = Some(borders_m));
            let solution = case.assert_holds(&options);
            let told = solution.warnings.iter().find_map(|w| match w {
                Warning::RowsMissed {
                    quantity,
                    base_m,
                    top_m,
                    ..
                } => Some((*quantity, *base_m, *top_m)),
                _ => None,
            });
            let (quantity, base_m, top_m) = told.expect("a warning");
            assert_eq!(quantity, missed);
            assert!(base_m < 81.0 && top_m > 40.0, "{base_m} to {top_m}");
        }
    }
    // Elements that meet every row miss nothing.
    let elements = |count: usize| Options {
        borders_m: Some(
            (0..=count)
                .map(|k| 87.6 * k as f64 / count as f64)
                .collect(),
        ),
        ..by(Method::Bmodes, None, 5)
    };
    let is_told = |w: &Warning| matches!(w, Warning::RowsMissed { .. });
    let meeting = Case::new(reference_table(1.0, 0.0), 5).assert_holds(&elements(10));
    assert!(!meeting.warnings.iter().any(is_told));
}

/// Equal elements stay equal where they meet every row, and rows that they do not meet become
/// borders.
#[test]
fn elements_of_bmodes_are_equal_where_they_can_be() {
    let run = |segments| {
        solved(
            &reference_table(1.0, 0.0),
            &by(Method::Bmodes, Some(segments), 8),
        )
    };
    // BModes 3.00 itself with fifty elements.
    let fifty = run(50);
    assert_eq!(fifty.segments, 50);
    let case = "fifty elements";
    assert_close(fifty.modes[0].frequency_hz, 0.892511, 1e-6, case);
    assert_eq!(run(5).segments, 10);
}
