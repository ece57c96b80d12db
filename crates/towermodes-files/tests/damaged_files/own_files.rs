//! Small files of our own, one or more of each format.

use crate::sources::source;
use proptest::prelude::*;
use towermodes_files::{InMemory, ReadOptions, Source, TowerPart};

use crate::damaged_files::damage::any_damages;
use crate::damaged_files::{Where, survives};
use crate::decks::{BLADE_SECTIONS, OFFSHORE, SECTIONS, WIRES, blade_file, tower_file};
use crate::elastodyn::texts::{BLADE, MASSES, TOWER, main_text};
use crate::windio_files::{LAYERED, TABLE, VERSION_1, VERSION_2};

const TOML_TABLE: &str = include_str!("../../../../examples/nrel-5mw-table.toml");

const OF_CANS: &str = include_str!("../../../../examples/cans.toml");
const CANS: &str = include_str!("../../../../examples/cans.csv");

const HAWC2: &str = "\
1 set
#1 Mast
r m x_cg y_cg ri_x ri_y x_sh y_sh E G I_x I_y K k_x k_y A pitch x_e y_e
$1 3 as built
0  3000 0 0 1.4 1.4 0 0 2.1e11 8.1e10 1.6 1.6 3.2 0.5 0.5 0.4 0 0 0
20 2500 0 0 1.3 1.3 0 0 2.1e11 8.1e10 1.2 1.2 2.4 0.5 0.5 0.3 0 0 0
50 2000 0 0 1.2 1.2 0 0 2.1e11 8.1e10 0.8 0.8 1.6 0.5 0.5 0.2 0 0 0
$2 2 nearly rigid
0  3000 0 0 1.4 1.4 0 0 2.1e15 8.1e14 1.6 1.6 3.2 0.5 0.5 0.4 0 0 0
50 2000 0 0 1.2 1.2 0 0 2.1e15 8.1e14 0.8 0.8 1.6 0.5 0.5 0.2 0 0 0
";

const FST: &str = "\
------- OpenFAST INPUT FILE -------
a small turbine
2 CompElast - switch
\"main.dat\" EDFile - name
";

/// A main file by name and text, and the files that it names.
type Model = (&'static str, String, Vec<(&'static str, String)>);

fn models() -> Vec<Model> {
    let alone = |name: &'static str, text: &str| (name, text.to_owned(), Vec::new());
    let sections = |text: &str| vec![("secs.dat", text.to_owned())];
    let masses = TOWER.to_owned() + MASSES;
    let parts = || {
        let blade = ("parts\\blade.dat", BLADE.to_owned());
        vec![("tower.dat", masses.clone()), blade]
    };
    let from_fst = [parts(), vec![("main.dat", main_text(5, &[]))]].concat();
    vec![
        alone("tower.toml", TOML_TABLE),
        (
            "cans.toml",
            OF_CANS.to_owned(),
            vec![("cans.csv", CANS.to_owned())],
        ),
        (
            "metric.toml",
            OF_CANS.to_owned(),
            vec![("cans.csv", CANS.replace(',', ";").replace('.', ","))],
        ),
        alone("mast_st.dat", HAWC2),
        alone("layered.yaml", LAYERED),
        alone("table.yaml", TABLE),
        alone("older.yaml", VERSION_1),
        alone("small.yaml", VERSION_2),
        alone("tower.dat", &masses),
        ("main.dat", main_text(5, &[]), parts()),
        ("older.dat", main_text(1, &[]), parts()),
        ("small.fst", FST.to_owned(), from_fst),
        ("tower.bmi", tower_file(WIRES), sections(SECTIONS)),
        ("spar.bmi", tower_file(OFFSHORE), sections(SECTIONS)),
        ("blade.bmi", blade_file(), sections(BLADE_SECTIONS)),
    ]
}

fn any_options() -> impl Strategy<Value = ReadOptions> {
    let parts = [TowerPart::All, TowerPart::Tower, TowerPart::Monopile];
    let choices = (
        prop::sample::select(parts.to_vec()),
        any::<bool>(),
        prop::sample::select(vec![None, Some((1, 2)), Some((7, 7))]),
        prop::sample::select(vec![None, Some(80.0), Some(f64::NAN), Some(-1e308)]),
    );
    choices.prop_map(
        |(part, without_rna, hawc2_subset, tower_height_m)| ReadOptions {
            tower_height_m,
            without_rna,
            part,
            hawc2_subset,
            ..ReadOptions::default()
        },
    )
}

fn check(
    model: Model,
    place: Where,
    damages: &[crate::damaged_files::damage::Damage],
    options: &ReadOptions,
) -> Result<(), TestCaseError> {
    let (name, text, files) = model;
    let name = name.to_owned();
    let files = files
        .into_iter()
        .map(|(name, text)| (name.to_owned(), text));
    let companions = InMemory {
        files: files.collect(),
    };
    survives(&Source { name, text }, &companions, place, damages, options)
}

#[test]
fn undamaged_files_are_read() {
    for (name, text, files) in models() {
        let files = files
            .into_iter()
            .map(|(name, text)| (name.to_owned(), text));
        let companions = InMemory {
            files: files.collect(),
        };
        let source = source(name, text);
        let read = towermodes_files::read_source(source, &companions, &ReadOptions::default());
        assert!(read.is_ok(), "{name}: {:?}", read.err());
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 6000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_files_are_read_or_refused(
        model in prop::sample::select(models()),
        in_companions in any::<bool>(),
        damages in any_damages(),
        options in any_options(),
    ) {
        let place = if in_companions && !model.2.is_empty() { Where::Companions } else { Where::Main };
        check(model, place, &damages, &options)?;
    }
}
