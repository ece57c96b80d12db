//! Public offshore models of OpenFAST, unedited, with the frequencies of an independent program.

use std::path::PathBuf;

use towermodes::{
    AddedMassAt, Family, Foundation, Method, Options, Tower, TowerDescription, solve,
};
use towermodes_files::{
    ConvertOptions, Input, OutputFormat, ReadOptions, SiblingFiles, Source, TowerInput, convert,
    read_source,
};
use towermodes_testing::Close;

fn peer_data() -> Option<PathBuf> {
    let folder = std::env::var_os("TOWERMODES_PEER_DATA");
    if folder.is_none() {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
    }
    Some(PathBuf::from(folder?).join("offshore"))
}

fn read(path: &str, is_dry: bool, options: &ReadOptions) -> Option<TowerInput> {
    let path = peer_data()?.join(path);
    let mut source = Source::from_path(&path).expect("the file is there");
    if is_dry {
        source.text = without_water(&source.text);
    }
    match read_source(source, &SiblingFiles::of(&path), options) {
        Ok(Input::Tower(input)) => Some(*input),
        Ok(Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_)) => {
            panic!("{}: no tower", path.display())
        }
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

/// Whether each mode bends fore-aft, and its frequency.
fn frequencies(description: TowerDescription, modes: usize) -> Vec<(bool, f64)> {
    frequencies_at(description, modes, AddedMassAt::Own)
}

/// The same with the added mass of a floating platform at some frequency.
fn frequencies_at(
    description: TowerDescription,
    modes: usize,
    added_mass: AddedMassAt,
) -> Vec<(bool, f64)> {
    let tower = Tower::new(description).expect("a tower");
    let options = Options {
        method: Method::Spectral,
        modes,
        added_mass,
        ..Options::default()
    };
    let solution = solve(&tower, &options).expect("a solution");
    assert!(solution.certificate.complete);
    let modes = solution.modes.iter();
    modes
        .map(|mode| (mode.name().family == Family::ForeAft, mode.frequency_hz))
        .collect()
}

/// The tower on its frame, with or without the geometric stiffness of the weight on the members.
fn weighed(input: &TowerInput, weight_on_members: bool) -> TowerDescription {
    let mut description = input.description.clone();
    let Foundation::Frame(foundation) = &mut description.foundation else {
        panic!("no frame");
    };
    foundation.weight_on_members = weight_on_members;
    // The reference program leaves it out.
    foundation.buoyancy_on_members = false;
    description
}

/// A `.fst` file with CompHydro 0.
fn without_water(fst: &str) -> String {
    let lines = fst.lines().map(|line| match line.contains("CompHydro") {
        true => "0 CompHydro",
        false => line,
    });
    lines.collect::<Vec<_>>().join("\n")
}

/// Tolerances of fore-aft modes, and of the others.
///
/// The reference program has two terms of gravity differently. It gives the weight of the
/// rotor-nacelle assembly, whose centre is beside the axis, a coupling between rotations about x
/// and z, as if the tower below it carried no bending moment: this shifts side-side modes. And it
/// leaves out that the weight of the tower turns over on the stiff stretch between the reference
/// point of the platform and the base of the tower, where there is one.
type Tolerances = [f64; 2];

fn assert_close(what: &str, found: &[(bool, f64)], expected: &[f64], tolerances: Tolerances) {
    for ((is_fore_aft, found), expected) in found.iter().zip(expected) {
        let error = (found / expected - 1.0).abs();
        let tolerance = tolerances[usize::from(!is_fore_aft)];
        assert!(
            error < tolerance,
            "{what}: {found} Hz, expected {expected} Hz: {error:e}"
        );
    }
}

/// A model that stands on the ground: its frequencies without and with water, and with the weight
/// on its members too, as far as the reference program gives them.
struct Fixed {
    path: &'static str,
    dry: &'static [f64],
    tolerances: Tolerances,
    wet: (&'static [f64], Tolerances),
    weighed: &'static [f64],
}

const FIXED: [Fixed; 4] = [
    Fixed {
        path: "fast8/Test19.fst",
        tolerances: [2e-9, 2e-6],
        dry: &[
            0.2723592764,
            0.2740640344,
            1.6422188442,
            1.8574882147,
            3.6123057022,
            3.9362599828,
            4.9468333078,
            7.6704205330,
        ],
        wet: (
            &[
                0.2723331643,
                0.2740370899,
                1.6355967290,
                1.8454376645,
                3.4949172875,
                3.7994399071,
                4.9458892868,
                6.7998067287,
            ],
            [2e-9, 2e-6],
        ),
        weighed: &[
            0.272236039,
            0.273938207,
            1.635067294,
            1.844705015,
            3.493518799,
            3.798156469,
            4.945885149,
            6.798837896,
        ],
    },
    Fixed {
        path: "fast8/Test21.fst",
        tolerances: [1e-4, 1e-4],
        dry: &[
            0.3132157527,
            0.3152118400,
            1.1383741470,
            1.1647989203,
            2.2717182055,
            2.5652027237,
            2.9777780476,
            5.9285115598,
        ],
        wet: (
            &[
                0.3129901984,
                0.3149775704,
                1.0981347146,
                1.1205261512,
                2.0921231186,
                2.4621427044,
                2.8075902210,
                3.7364757668,
            ],
            [1e-4; 2],
        ),
        weighed: &[
            0.312630977,
            0.314610457,
            1.095982203,
            1.118317312,
            2.090032803,
            2.461547566,
            2.806540021,
            3.731095200,
        ],
    },
    Fixed {
        path: "fast8/Test20.fst",
        tolerances: [2e-9, 2e-5],
        dry: &[
            0.3074970424,
            0.3088868051,
            2.1936510650,
            2.3199043985,
            2.3748028052,
            4.0404233218,
            4.0405428341,
            4.0557104415,
        ],
        wet: (
            &[
                0.3074763520,
                0.3088657372,
                2.0690357,
                2.1751461,
                2.3265692,
                2.504433,
                2.505287,
                2.516098,
            ],
            [1e-6, 2e-5],
        ),
        weighed: &[],
    },
    Fixed {
        path: "iea15-monopile/OpenFAST/IEA-15-240-RWT-Monopile/IEA-15-240-RWT-Monopile.fst",
        tolerances: [2e-9, 2e-4],
        dry: &[
            0.1704631748,
            0.1715410888,
            0.8918378642,
            0.9756273830,
            2.0374315688,
            2.2289205493,
            2.3183662588,
            4.6787431549,
        ],
        wet: (
            &[
                0.1704095326,
                0.1714857255,
                0.8841489,
                0.9640659,
                1.918706,
                2.057559,
                2.265117,
                3.45903,
            ],
            [1e-6, 2e-4],
        ),
        weighed: &[],
    },
];

#[test]
fn models_on_the_ground_have_the_frequencies_of_an_independent_program_without_water() {
    for model in &FIXED {
        let Some(input) = read(model.path, true, &ReadOptions::default()) else {
            return;
        };
        let found = frequencies(weighed(&input, false), 8);
        assert_close(model.path, &found, model.dry, model.tolerances);
    }
}

#[test]
fn models_on_the_ground_have_the_frequencies_of_an_independent_program_with_water() {
    for model in &FIXED {
        let Some(input) = read(model.path, false, &ReadOptions::default()) else {
            return;
        };
        let (expected, tolerances) = model.wet;
        let found = frequencies(weighed(&input, false), 8);
        assert_close(model.path, &found, expected, tolerances);
        let found = frequencies(weighed(&input, true), 8);
        // The reference program leaves out forces in rigid links, which lower the first modes of
        // the jacket, whose interface joints are 2 m below its reference point, by 1e-4.
        assert_close(model.path, &found, model.weighed, [2e-4; 2]);
    }
}

/// A floating model with the added mass of each mode's own frequency, at infinite frequency and, as
/// far as the reference program gives it, at zero.
struct Floating {
    path: &'static str,
    own: &'static [f64],
    infinite: &'static [f64],
    zero: &'static [f64],
}

const FLOATING: [Floating; 3] = [
    Floating {
        path: "fast8/Test24.fst",
        own: &[
            0.0080619601,
            0.0080622465,
            0.0324095712,
            0.0342993963,
            0.0343100733,
            0.1212124619,
            0.4807465321,
            0.4875582539,
        ],
        infinite: &[
            0.0081186564,
            0.0081189451,
            0.0324291835,
            0.0347517774,
            0.0347629072,
            0.1212128493,
            0.4788968971,
            0.4856915078,
        ],
        zero: &[
            0.0080622136,
            0.0080624995,
            0.0324115037,
            0.0343193362,
            0.0343300452,
            0.1212125714,
            0.4734384857,
            0.4800302880,
        ],
    },
    Floating {
        path: "fast8/Test25.fst",
        own: &[
            0.0088408320,
            0.0088408371,
            0.0124003341,
            0.0396918748,
            0.0397109814,
            0.0578749246,
            0.4272592534,
            0.4320432525,
        ],
        infinite: &[
            0.0093139900,
            0.0093140340,
            0.0129381516,
            0.0399245238,
            0.0399438681,
            0.0581371251,
            0.4267428577,
            0.4314303892,
        ],
        zero: &[],
    },
    Floating {
        path: "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi.fst",
        own: &[
            0.0074025396,
            0.0074025779,
            0.0113024954,
            0.0371200406,
            0.0371344882,
            0.0489107636,
            0.5076477939,
            0.5161342615,
        ],
        infinite: &[
            0.0077671094,
            0.0077671586,
            0.0120272986,
            0.0373786955,
            0.0373902816,
            0.0503766765,
            0.5069001000,
            0.5154176149,
        ],
        zero: &[],
    },
];

/// The same with a stiffness that undoes what the reference program leaves out: the weight of the
/// tower turns over on the stretch from the origin to its base.
fn without_arm(mut description: TowerDescription) -> TowerDescription {
    let tower = Tower::new(description.clone()).expect("a tower");
    let weight_n = (tower.mass_kg() + tower.rna().mass_kg) * tower.gravity_m_per_s2();
    let Foundation::Floating(platform) = &mut description.foundation else {
        panic!("it does not float");
    };
    for rotation in [3, 4] {
        platform.hydrostatic.matrix[rotation][rotation] += weight_n * tower.base_m();
    }
    description
}

#[test]
fn floating_models_have_the_frequencies_of_an_independent_program() {
    for model in FLOATING {
        let Some(input) = read(model.path, false, &ReadOptions::default()) else {
            return;
        };
        let description = without_arm(input.description);
        let cases = [
            (AddedMassAt::Own, model.own),
            (AddedMassAt::Infinite, model.infinite),
            (AddedMassAt::Zero, model.zero),
        ];
        for (added_mass, expected) in cases {
            let found = frequencies_at(description.clone(), 8, added_mass);
            assert_close(model.path, &found, expected, [1e-8, 2e-3]);
        }
    }
}

#[test]
fn a_clamped_model_is_that_without_the_structure_below_the_tower() {
    let options = ReadOptions {
        clamped: true,
        ..ReadOptions::default()
    };
    let Some(input) = read("fast8/Test21.fst", false, &options) else {
        return;
    };
    assert_eq!(input.description.foundation, Foundation::Clamped);
    assert!(!input.description.missing_parts.is_empty());
}

#[test]
fn a_tower_on_members_is_not_written_where_they_have_no_place() {
    let Some(input) = read("fast8/Test21.fst", true, &ReadOptions::default()) else {
        return;
    };
    let options = ConvertOptions {
        sections_file: Some("sections.dat".to_owned()),
        ..ConvertOptions::default()
    };
    let refused = convert(&input, OutputFormat::Bmodes, &options).expect_err("a frame");
    assert!(refused.to_string().contains("--clamped"), "{refused}");
}

/// Weight, and what buoyancy and lines leave of it. The lines of Test24 are those of MAP++ with
/// friction on the seabed; the independent program has those of MoorDyn without: 46 N.
#[test]
fn floaters_have_the_static_balance_of_an_independent_program() {
    const VOLTURNUS: &str =
        "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi.fst";
    let rows = [
        (
            "fast8/Test24.fst",
            [79_097_050.631, 80_708_143.553, 3863.0],
            47.0,
        ),
        (
            "fast8/Test25.fst",
            [138_032_074.010, 139_891_126.751, -34_264.0],
            1.0,
        ),
        (
            VOLTURNUS,
            [198_676_457.582, 203_179_889.676, -1_581_086.0],
            1.0,
        ),
    ];
    for (path, [weight_n, buoyancy_n, left_n], most_n) in rows {
        let Some(input) = read(path, false, &ReadOptions::default()) else {
            return;
        };
        let tower = Tower::new(input.description).expect("a tower");
        let balance = tower
            .static_balance()
            .expect("its buoyancy is in its files");
        balance.weight_n().close_to(weight_n, 1e-11);
        balance.buoyancy_n.close_to(buoyancy_n, 1e-11);
        let found_n = balance.residual_force_n[2];
        assert!((found_n - left_n).abs() < most_n, "{path}: {found_n}");
    }
}

/// Of an independent program: VolturnUS-S tilts by −1.45°, and with its lines there the lower of
/// the two frequencies of surge and sway falls by 0.45 %, the other one by 0.05 %, yaw by 0.3 %;
/// those of the spar and of OC4 change by less than 0.01 % and 0.02 %.
#[test]
fn lines_at_the_equilibrium_lower_frequencies_as_in_an_independent_program() {
    const VOLTURNUS: &str =
        "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi.fst";
    let at_equilibrium = ReadOptions {
        at_equilibrium: true,
        ..ReadOptions::default()
    };
    let changes = |path: &str| -> Option<Vec<f64>> {
        let [reference, equilibrium] = [ReadOptions::default(), at_equilibrium]
            .map(|options| Some(frequencies(read(path, false, &options)?.description, 6)));
        let pairs = reference?.into_iter().zip(equilibrium?);
        Some(
            pairs
                .map(|((_, from), (_, to))| 100.0 * (to / from - 1.0))
                .collect(),
        )
    };
    let Some(of_volturnus) = changes(VOLTURNUS) else {
        return;
    };
    for (found, expected) in of_volturnus.iter().zip([-0.45, -0.05, -0.3]) {
        assert!((found - expected).abs() < 0.015, "{of_volturnus:?}");
    }
    for (path, most) in [("fast8/Test24.fst", 0.01), ("fast8/Test25.fst", 0.02)] {
        let found = changes(path).expect("its files");
        assert!(
            found.iter().all(|change| change.abs() < most),
            "{path} {found:?}"
        );
    }
    let input = read(VOLTURNUS, false, &at_equilibrium).expect("its files");
    let tower = Tower::new(input.description).expect("a tower");
    let balance = tower.static_balance().expect("a balance");
    let pose = balance.equilibrium.expect("an equilibrium");
    assert!((pose.pitch_deg + 1.45).abs() < 0.005, "{pose:?}");
    assert!(balance.linearized_at_equilibrium);
}
