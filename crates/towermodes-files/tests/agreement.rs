//! Files of one OpenFAST model that contradict each other: SubDyn, HydroDyn, SeaState and MoorDyn.

use towermodes_files::{
    InMemory, Input, NoteKind, ReadError, ReadOptions, SiblingFiles, Source, TowerInput,
    read_source,
};
use towermodes_testing::Says;

use crate::elastodyn::texts::{BLADE, MASSES, TOWER, main_text};
use crate::hydrodyn::texts::{Layout, deck as hydrodyn};
use crate::moorings::texts::MOORDYN_2;
use crate::subdyn::texts::deck as subdyn;

type Rows<'a> = &'a [(&'a str, &'a str)];

/// Two tubes of 15 m, from the seabed to the tower.
const TUBES: [(&str, &str); 3] = [
    (
        "NJoints",
        "1 0 0 -20 1 0 0 0 0\n2 0 0 -5 1 0 0 0 0\n3 0 0 10 1 0 0 0 0",
    ),
    ("NMembers", "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0"),
    ("NPropSetsCyl", "1 2.1e11 8.08e10 7850 4.0 0.06"),
];
/// The same in HydroDyn.
const WATER: [(&str, &str); 4] = [
    ("NJoints", "1 0 0 -20 1 0\n2 0 0 -5 1 0\n3 0 0 10 1 0"),
    ("NMembers", "1 1 2 1 1 1 0.5 1 F\n2 2 3 1 1 1 0.5 1 F"),
    ("NPropSets", "1 4.0 0.06"),
    ("NFillGroups", ""),
];

/// The rows of one list, with those of another in place of their namesakes.
fn changed<'a>(rows: Rows<'a>, changes: Rows<'a>) -> Vec<(&'a str, &'a str)> {
    let is_changed = |name: &str| changes.iter().any(|(other, _)| *other == name);
    let kept = rows.iter().filter(|(name, _)| !is_changed(name));
    kept.chain(changes).copied().collect()
}

/// A monopile whose depth is in the `.fst` file and in the one of SeaState.
fn monopile(frame: Rows<'_>, water: Rows<'_>, depths: [&str; 2]) -> Result<TowerInput, ReadError> {
    let [of_fst, of_sea] = depths;
    let fst = format!(
        "------- OpenFAST INPUT FILE -------\na monopile\n1 CompElast - switch\n\
         1 CompSub - switch\n1 CompHydro - switch\n1 CompSeaSt - switch\n9.81 Gravity - m/s2\n\
         1025 WtrDens - kg/m3\n{of_fst} WtrDpth - m\n0 MSL2SWL - m\n\"main.dat\" EDFile - name\n\
         \"sub.dat\" SubFile - name\n\"wet.dat\" HydroFile - name\n\"sea.dat\" SeaStFile - name\n"
    );
    let main = main_text(5, &[("TowerBsHt", "10"), ("PtfmRefzt", "10")]);
    let files = [
        ("main.dat", main),
        ("tower.dat", TOWER.to_owned() + MASSES),
        ("parts\\blade.dat", BLADE.to_owned()),
        ("sub.dat", subdyn(&changed(&TUBES, frame))),
        ("wet.dat", hydrodyn(Layout::V41, &changed(&WATER, water))),
        (
            "sea.dat",
            format!("------- SeaState -------\n\"default\" WtrDens - rho\n{of_sea} WtrDpth - m\n"),
        ),
    ];
    let files = InMemory {
        files: files.map(|(name, text)| (name.to_owned(), text)).into(),
    };
    let source = Source {
        name: "model.fst".to_owned(),
        text: fst,
    };
    match read_source(source, &files, &ReadOptions::default())? {
        Input::Tower(input) => Ok(*input),
        Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => panic!("no tower"),
    }
}

/// The notes of a model, each on a line.
fn notes(frame: Rows<'_>, water: Rows<'_>, depths: [&str; 2]) -> String {
    let input = monopile(frame, water, depths).unwrap_or_else(|error| panic!("{error}"));
    input.notes.iter().map(|note| format!("{note}\n")).collect()
}

/// What only contradictions say.
const SAID: [&str; 5] = [
    "diameter of",
    "nearest member of SubDyn",
    "lowest reaction joint",
    "coefficient of added mass",
    "the value here is used",
];

#[test]
fn files_that_agree_are_not_doubted() {
    let agreeing: [(Rows<'_>, Rows<'_>, [&str; 2]); 4] = [
        (&[], &[], ["20", "default"]),
        // A pile in the ground, with and without a joint at the seabed.
        (
            &[(
                "NJoints",
                "1 0 0 -45 1 0 0 0 0\n2 0 0 -20 1 0 0 0 0\n3 0 0 10 1 0 0 0 0",
            )],
            &[],
            ["20", "20"],
        ),
        (
            &[(
                "NJoints",
                "1 0 0 -28 1 0 0 0 0\n2 0 0 -5 1 0 0 0 0\n3 0 0 10 1 0 0 0 0",
            )],
            &[],
            ["20", "default"],
        ),
        // Feet on piles that stand out of the seabed.
        (
            &[(
                "NJoints",
                "1 0 0 -18.5 1 0 0 0 0\n2 0 0 -5 1 0 0 0 0\n3 0 0 10 1 0 0 0 0",
            )],
            &[],
            ["20", "default"],
        ),
    ];
    for (frame, water, depths) in agreeing {
        let notes = notes(frame, water, depths);
        for said in SAID {
            assert!(!notes.contains(said), "{said}: {notes}");
        }
    }
}

/// The unedited public models: nothing in them is doubted.
#[test]
fn public_models_are_not_doubted() {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let models = [
        "fast8/Test19.fst",
        "fast8/Test20.fst",
        "fast8/Test21.fst",
        "fast8/Test24.fst",
        "fast8/Test25.fst",
        "iea15-monopile/OpenFAST/IEA-15-240-RWT-Monopile/IEA-15-240-RWT-Monopile.fst",
        "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi.fst",
    ];
    for model in models {
        let path = std::path::Path::new(&folder).join("offshore").join(model);
        let source = Source::from_path(&path).expect("the file is there");
        let files = SiblingFiles::of(&path);
        let Ok(Input::Tower(input)) = read_source(source, &files, &ReadOptions::default()) else {
            panic!("{model}: no tower");
        };
        let notes = input.notes.iter();
        let doubts: Vec<_> = notes
            .filter(|note| note.kind == NoteKind::Suspicious)
            .collect();
        assert!(doubts.is_empty(), "{model}: {doubts:?}");
        let tower = input
            .tower()
            .unwrap_or_else(|error| panic!("{model}: {error}"));
        let said: Vec<String> = tower.warnings().iter().map(ToString::to_string).collect();
        assert!(said.is_empty(), "{model}: {said:?}");
    }
}

#[test]
fn another_depth_is_doubted() {
    let deep = notes(&[], &[], ["200", "default"]);
    deep.says_all("model.fst:9: WtrDpth is 200 m, but the lowest reaction joint of sub.dat is at z = -20 m, 180 m above the seabed");
    let shallow = notes(&[], &[], ["9", "default"]);
    shallow.says_all("model.fst:9: WtrDpth is 9 m & is at z = -20 m, 11 m below the seabed");
}

#[test]
fn two_depths_are_doubted() {
    let two = notes(&[], &[], ["200", "20"]);
    two.says_all("sea.dat:3: WtrDpth is 20 here, but 200 in model.fst:9: the value here is used");
    assert!(!two.contains("lowest reaction joint"), "{two}");
}

#[test]
fn other_diameters_and_coefficients_are_doubted() {
    let thin = notes(&[], &[("NPropSets", "1 0.4 0.06")], ["20", "default"]);
    thin.says_all(
        "wet.dat: & : member 1 has a diameter of 0.4 m at z = -12.5 m, but member 1 of sub.dat: & has a diameter of 4 m there & ; another member has the same problem",
    );
    let simple = "1.0 1.1 9.0 1.2 1 1 0.3 0.4 1 1";
    let heavy = notes(&[], &[("Simpl", simple)], ["20", "default"]);
    heavy.says_all(
        "wet.dat: & member 1 has a coefficient of added mass Ca of up to 9, as has 1 other member;",
    );
}

#[test]
fn members_elsewhere_are_doubted() {
    let joints = "1 0 0 -20 1 0\n2 30 0 -5 1 0\n3 0 0 10 1 0";
    let away = notes(&[], &[("NJoints", joints)], ["20", "default"]);
    away.says_all("wet.dat: & : member 1 is up to 30.0 m away from member & of sub.dat: & , the nearest member of SubDyn & another member has the same problem");
}

/// Without reaction joints a structure floats, unless it stands on the seabed.
#[test]
fn a_structure_on_the_seabed_is_held() {
    let loose: Rows<'_> = &[("NReact", "")];
    let error = monopile(loose, &[], ["20", "default"]).expect_err("nothing holds it");
    error.says("no reaction joint is fixed, so the substructure floats, but its joint 1 at z = -20 m is on the seabed, which is at z = -20 m");
    let shown = format!("{error:?}");
    assert!(shown.contains("sub.dat"), "{shown}");
}

/// MoorDyn with a depth, a density and a gravity of its own.
#[test]
fn mooring_lines_in_another_water_are_doubted() {
    let site = towermodes_files::MooringSite {
        depth_m: Some(200.0),
        water_density_kg_per_m3: Some(1000.0),
        gravity_m_per_s2: Some(9.81),
    };
    let source = Source {
        name: "lines.dat".to_owned(),
        text: MOORDYN_2.to_owned(),
    };
    let input = towermodes_files::read_moordyn(source, &site).expect("a mooring");
    let notes: String = input.notes.iter().map(|note| format!("{note}\n")).collect();
    notes.says_all("WtrDpth is 320 m here, but 200 m in the other files of the model");
    notes.says_all("rhoW is 1025 kg/m3 here, but 1000 kg/m3 in the other files of the model");
    assert!(!notes.contains("g is 9.8"), "{notes}");
}
