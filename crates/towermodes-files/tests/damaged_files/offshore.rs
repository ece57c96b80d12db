//! Models of OpenFAST that stand in water, all their files damaged: read or refused at a place, and
//! solved or refused, in bounded time.

use std::time::{Duration, Instant};

use proptest::prelude::*;
use proptest::test_runner::TestCaseError;
use towermodes::{Options, solve};
use towermodes_files::{FileResolver, InMemory, Input, ReadOptions, Source, read_source};
use towermodes_testing::{Says, with};

use super::damage::{self, Damage, any_damages};
use super::is_inside_its_file;
use crate::elastodyn::texts::{BLADE, MASSES, TOWER, main_text};
use crate::hydrodyn::texts::{Layout, WAMIT_1, WAMIT_HST, deck as hydrodyn};
use crate::moorings::damaged::whole as moordyn;
use crate::moorings::texts::MAP;
use crate::subdyn::damaged::texts as subdyn;
use crate::subdyn::soildyn::sand;
use crate::subdyn::texts::{SOIL, deck};
use crate::windio_floater::texts::volturnus;
use crate::windio_jacket;

/// No damaged model may take longer: an undamaged one takes some hundredths of a second.
const LONGEST: Duration = Duration::from_secs(30);

/// The files of a model, the first one the `.fst` file.
type Model = Vec<(&'static str, String)>;

/// The `.fst` file with these switches and files.
fn fst(modules: &str) -> String {
    format!(
        "------- OpenFAST INPUT FILE -------\nin the sea\n1 CompElast - switch\n{modules}\
        9.81 Gravity - m/s2\n1025 WtrDens - kg/m3\n320 WtrDpth - m\n0 MSL2SWL - m\n\
        \"main.dat\" EDFile - name\n"
    )
}

/// ElastoDyn with a platform of 300 t.
fn elastodyn() -> String {
    let free = ["Sg", "Sw", "Hv", "R", "P", "Y"].map(|motion| format!("Ptfm{motion}DOF"));
    let mut changes: Vec<(&str, &str)> = free.iter().map(|name| (name.as_str(), "True")).collect();
    changes.extend([
        ("PtfmMass", "3e5"),
        ("PtfmRIner", "3e7"),
        ("PtfmPIner", "3e7"),
        ("PtfmYIner", "1e6"),
        ("PtfmCMzt", "-22"),
        ("TowerBsHt", "10"),
    ]);
    main_text(5, &changes)
}

fn model(modules: &str, files: Vec<(&'static str, String)>) -> Model {
    let mut all = vec![
        ("model.fst", fst(modules)),
        ("main.dat", elastodyn()),
        ("tower.dat", TOWER.to_owned() + MASSES),
        ("parts\\blade.dat", BLADE.to_owned()),
    ];
    all.extend(files);
    all
}

pub(super) fn models() -> Vec<Model> {
    let [_, jacket, given] = subdyn();
    let strips = hydrodyn(Layout::V31, &[("NFillGroups", "1 1 -20 default")]);
    let body = hydrodyn(
        Layout::V41,
        &[
            ("PotMod", "1"),
            ("NMembers", "1 1 2 1 1 1 0.5 1 T"),
            ("NMGDepths", "0 0.05 1100\n-20 0.1 1200"),
        ],
    );
    let on_sand = deck(&[("NReact", "1 0 0 0 0 0 0 \"\"")]);
    let wet = "1 CompHydro - switch\n\"wet.dat\" HydroFile - name\n";
    let sub = "1 CompSub - switch\n\"sub.dat\" SubFile - name\n";
    let lines = "CompMooring - switch\n\"lines.dat\" MooringFile - name\n";
    let wamit = |files: &mut Model| {
        files.push(("body.1", WAMIT_1.to_owned()));
        files.push(("body.hst", WAMIT_HST.to_owned()));
    };
    // Its free point is on the third line.
    let moored = moordyn()
        .replace("4 Free 400 0 -200 10 2", "4 Free -180 -310 -250 10 2")
        .replace(
            "3      main       3         6      902.2 ",
            "3 main 3 4 500 20 -\n4 main 4 6 402.2 ",
        );
    let mut floating = vec![("wet.dat", body), ("lines.dat", moored)];
    wamit(&mut floating);
    vec![
        model(
            &format!("{sub}1 CompSoil - switch\n\"soil.dat\" SoilFile - name\n"),
            vec![("sub.dat", on_sand), ("soil.dat", sand())],
        ),
        model(
            &format!("{sub}{wet}"),
            vec![
                ("sub.dat", jacket),
                ("wet.dat", strips.clone()),
                ("ssi.txt", SOIL.to_owned()),
            ],
        ),
        model(sub, vec![("sub.dat", given)]),
        model(&format!("{wet}3 {lines}"), floating),
        model(
            &format!("{wet}1 {lines}"),
            vec![("wet.dat", strips), ("lines.dat", MAP.to_owned())],
        ),
        vec![("floater.yaml", volturnus(2.4e6))],
        vec![("jacket.yaml", windio_jacket::FILE.to_owned())],
    ]
}

fn resolver(files: &[(&'static str, String)]) -> InMemory {
    let files = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), text.clone()));
    InMemory {
        files: files.collect(),
    }
}

/// Reads a model with one of its files damaged, and solves what can be read.
fn survives(model: &Model, file: usize, damages: &[Damage]) -> Result<(), TestCaseError> {
    let mut files = model.clone();
    let file = file % files.len();
    files[file].1 = damage::all(&files[file].1, damages);
    let start = Instant::now();
    let main = Source {
        name: files[0].0.to_owned(),
        text: files[0].1.clone(),
    };
    let others = resolver(&files);
    let result = read_source(main, &others as &dyn FileResolver, &ReadOptions::default());
    let tower = result.and_then(|input| match input {
        Input::Tower(input) => input.tower().map(Some),
        Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => Ok(None),
    });
    match tower {
        Ok(Some(tower)) => {
            let options = with!(Options, modes = 6);
            if let Ok(solution) = solve(&tower, &options) {
                for mode in &solution.modes {
                    prop_assert!(mode.frequency_hz.is_finite());
                }
            }
        }
        Ok(None) => {}
        Err(error) => is_inside_its_file(&error)?,
    }
    prop_assert!(start.elapsed() < LONGEST, "{:?}", start.elapsed());
    Ok(())
}

#[test]
fn undamaged_models_are_solved() {
    for model in models() {
        let main = Source {
            name: model[0].0.to_owned(),
            text: model[0].1.clone(),
        };
        let read = read_source(main, &resolver(&model), &ReadOptions::default());
        let Ok(Input::Tower(input)) = read else {
            panic!("{}: {:?}", model[0].1, read.err());
        };
        // The file in windIO has a mass at the top and no rotor.
        let missing = &input.description.missing_parts;
        assert!(missing.is_empty() || model.len() == 1, "{missing:?}");
        let tower = input.tower().unwrap_or_else(|error| panic!("{error}"));
        let solution = solve(&tower, &with!(Options, modes = 6));
        let solution = solution.unwrap_or_else(|error| panic!("{}: {error}", model[0].1));
        assert!(solution.certificate.complete, "{}", model[0].1);
    }
}

#[test]
fn a_substructure_that_floats_is_refused() {
    let mut model = models().swap_remove(2);
    model[4].1 = deck(&[("NReact", "")]);
    let main = Source {
        name: model[0].0.to_owned(),
        text: model[0].1.clone(),
    };
    let refused = read_source(main, &resolver(&model), &ReadOptions::default());
    let error = refused.map(|_| ()).expect_err("it floats").to_string();
    error.says_all("model.fst:5 & the substructure of SubDyn has no support");
}

proptest! {
    // 20 000 models are damaged with PROPTEST_CASES=20000.
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_models_are_solved_or_refused(
        model in prop::sample::select(models()),
        file in 0..12_usize,
        damages in any_damages(),
    ) {
        survives(&model, file, &damages)?;
    }
}
