//! `[substructure]` and `[mooring]` of the tower file: mistakes with their place, numbers by name,
//! water on members, files of SubDyn.

use towermodes::frame::FrameSupport;
use towermodes::{Change, Foundation, Options, Parameter, Solver, Tower, TowerDescription, solve};
use towermodes_files::{
    FileResolver, InMemory, Input, ReadError, ReadOptions, SiblingFiles, Source, TowerInput,
    description_from_toml, read_source, tower_from_toml, write_toml,
};
use towermodes_testing::{Says, rows};

const JACKET: &str = include_str!("../../../examples/jacket.toml");
const SPAR: &str = include_str!("../../../examples/floating-lines.toml");
const FRAME: &str = include_str!("../../../recorded-runs/kinds/substructure.toml");

fn description(text: &str) -> TowerDescription {
    description_from_toml(text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"))
}

fn frequencies_hz(description: TowerDescription) -> Vec<f64> {
    let tower = Tower::new(description).expect("a tower");
    let solution = solve(&tower, &Options::default()).expect("modes");
    solution.modes.iter().map(|m| m.frequency_hz).collect()
}

fn close(a: &[f64], b: &[f64], tolerance: f64) {
    assert_eq!(a.len(), b.len());
    for (a, b) in a.iter().zip(b) {
        assert!((a / b - 1.0).abs() <= tolerance, "{a} {b}");
    }
}

/// Changes a text at one place; the first mistake is there and says what would be right.
fn refused(text: &str, table: &str) {
    for [from, to, at, message] in rows::<4>(table) {
        assert!(text.contains(from), "no {from}");
        let changed = text.replacen(from, to, 1);
        let mistakes = tower_from_toml(&changed).expect_err(to);
        let first = &mistakes[0];
        let said = format!("{first}");
        assert!(said.contains(message), "{to}: {said}");
        let found = &changed[first.span.start..];
        // The whole table of a part, where the mistake is no single value.
        let is_around = at == "-" && first.span.start > 0;
        let is_there = found.starts_with(at) || is_around;
        assert!(is_there, "{to}: at {found:.60}");
    }
}

#[test]
fn mistakes_in_a_substructure_have_a_place() {
    refused(
        JACKET,
        r#"
        joints = ["a1", "a2"]      | joints = ["a1", "zz"]      | "zz"         | zz
        joints = ["a1", "a2"]      | joints = ["a1", "a1"]      | { name       | its joints are 0 m apart
        joints = ["a1", "a2"]      | joints = ["a1"]            | ["a1"]       | 2
        joints = ["a1", "a2"]      | joint = ["a1", "a2"]       | joint =      | did you mean `joints`?
        wall_thickness = 0.045     | wall_thickness = 0.9       | { name       | more than half of the 1.4 m
        outer_diameter = 1.4       | outer_diameter = -1.4      | { name       | must be positive
        outer_diameter = 1.4       | outer_diameter = [1, 2, 3] | [1, 2, 3]    | 2
        interface = ["a3",         | interface = ["x3",         | "x3"         | x3
        { name = "front1", position | { name = "back1", position = [0, 0, 0] }, { name = "front1", position | - | the joint `back1` occurs 2 times
        "a1", position = [-12.0,   | "a1", position = [         | [ -12        | 3
        flooded = ["leg a1"        | flooded = ["leg z1"        | "leg z1"     | leg z1
        name = "leg b1"            | name = "leg a1"            | -            | member leg a1: the name occurs twice
        [substructure]             | [foundation]\ntype = "clamped"\n[substructure] | - | keep one
        "#,
    );
}

#[test]
fn mistakes_in_supports_and_pins_have_a_place() {
    refused(
        FRAME,
        r#"
        clamped = ["foot",   | clamped = ["feet",       | "feet"  | did you mean `foot`?
        interface = ["top"]  | interface = ["foot"]     | ["foot" | supported and belongs to the transition
        clamped = ["foot", "anchor"] | clamped = ["foot", "pin"] | - | ball joint cannot be supported; make the joint welded, and fix only its translations
        kind = "pin", axis = [0.0, 1.0, 0.0] | kind = "pin" | { name | has no `axis`
        kind = "pin", axis = [0.0, 1.0, 0.0] | kind = "pin", axis = [0, 0, 0] | { name | axis of the pin is zero
        kind = "pin", axis   | kind = "ball", axis      | [0.0, 1 | only a pin
        pretension = 1e6     | pretension = -1e6        | { name  | a cable cannot be compressed
        pretension = 1e6     | area = 1.0               | 1.0     | it belongs to members of kind "section"
        joints = ["top", "anchor"] | joints = ["top", "foot"] | - | no member ends at this joint
        "#,
    );
}

#[test]
fn mistakes_in_mooring_lines_have_a_place() {
    refused(
        SPAR,
        r#"
        length = 880.0             | length = 300.0             | [[mooring.line]] | too short
        line_type = "chain"        | line_type = "chian"        | "chian"      | did you mean `chain`?
        kind = "anchor"            | kind = "ancor"             | "ancor"      | did you mean `anchor`?
        "anchor 1", "fairlead 1"]  | "anchor 1", "anchor 1"]    | -            | both ends of line 1
        depth = 300.0              | depth = 200.0              | [[mooring.point]] | under the seabed
        axial_stiffness = 3.8e8    | axial_stifness = 3.8e8     | axial_stifness | did you mean `axial_stiffness`?
        "#,
    );
}

/// The same water, given as coats of each member.
#[test]
fn coats_are_the_water_of_the_tower_file() {
    let plain = FRAME.replace("[water]\nlevel = 8.0\n", "");
    let added = |range: &str| {
        format!(
            ", coats = [{{ kind = \"added-mass\", range = {range}, density = 1025.0, radius = 2.5 }}]"
        )
    };
    let lower = "outer_diameter = 5.0, wall_thickness = 0.04";
    let upper = "outer_diameter = [5.0, 4.0], wall_thickness = 0.04";
    // The level is at 0.6 of the upper member, where the radius is 2.2 m.
    let coated = plain
        .replace(lower, &format!("{lower}{}", added("[0.0, 1.0]")))
        .replace(
            upper,
            &format!(
                "{upper}{}",
                added("[0.0, 0.6]").replace("2.5 }", "[2.5, 2.2] }")
            ),
        );
    assert_ne!(plain, coated);
    let wet = frequencies_hz(description(FRAME));
    close(&wet, &frequencies_hz(description(&coated)), 1e-12);
    let dry = frequencies_hz(description(&plain));
    assert!(wet[0] < dry[0] * (1.0 - 1e-4), "{} {}", wet[0], dry[0]);
}

/// The first warning of a changed tower file.
fn first_warning(text: &str, table: &str) {
    for [from, to, message] in rows::<3>(table) {
        assert!(text.contains(from), "no {from}");
        let tower = tower_from_toml(&text.replacen(from, to, 1)).expect(to);
        let said: Vec<String> = tower.warnings().iter().map(ToString::to_string).collect();
        let first = said.first().map_or("", String::as_str);
        assert!(first.contains(message), "{to}: {said:?}");
    }
}

/// Lines in fresh water under a tower in the sea.
#[test]
fn one_floater_is_in_one_water() {
    let warned = |density: &str| {
        let water = format!("[water]\nlevel = 12.0\ndensity = {density}\n\n[mooring]\n");
        let tower = tower_from_toml(&SPAR.replacen("[mooring]\n", &water, 1)).expect(density);
        let said: Vec<String> = tower.warnings().iter().map(ToString::to_string).collect();
        said.iter().any(|text| {
            text.starts_with(
                "the mooring lines are in water of 1025 kg/m3, and the tower is in water of 1000",
            )
        })
    };
    assert!(warned("1000.0"));
    assert!(!warned("1025.0") && !warned("1030.0"));
}

/// Lines and members of a tower file have the warnings of those of OpenFAST.
#[test]
fn slips_of_lines_and_members_are_warned_of() {
    first_warning(
        SPAR,
        r#"
        length = 880.0          | length = 1200.0        | line 1 is slack
        depth = 300.0           | depth = 301.0          | all anchors are at z = -300 m, but the depth is 301 m
        position = [840.0, 0.0, -300.0] | position = [840.0, 0.0, -299.0] | `anchor 1`: the anchor point 1 is at z = -299 m, 1 m above the seabed
        axial_stiffness = 3.8e8 | axial_stiffness = 3.8e5 | line 1 is stretched by
        "#,
    );
    first_warning(
        JACKET,
        r#"
        wall_thickness = 0.045 | wall_thickness = 0.00045 | 1/3111.11 of the diameter 1.4 m
        "#,
    );
    let negative = JACKET.replace("mass = 400e3", "mass = -400e3");
    let mistakes = tower_from_toml(&negative).expect_err("a negative mass");
    let said = mistakes[0].to_string();
    assert!(
        said.contains("the mass of the transition piece is -"),
        "{said}"
    );
}

#[test]
fn numbers_have_the_names_of_their_parts() {
    let jacket = description(JACKET);
    let by_name = Parameter::parse("substructure.member[leg a1].outer_diameter", &jacket);
    let by_index = Parameter::parse("substructure.member[4].outer_diameter", &jacket);
    assert_eq!(by_name.expect("a number"), by_index.expect("a number"));
    let foot = Parameter::parse("substructure.joint[a1].position[2]", &jacket).expect("a number");
    assert_eq!(foot.value(&jacket), -45.0);
    let wrong = Parameter::parse("substructure.member[leg x1].outer_diameter", &jacket);
    let message = wrong.expect_err("no such member").to_string();
    assert!(message.contains("names: pile a, pile b, "), "{message}");
    let spar = description(SPAR);
    let length = Parameter::parse("mooring.line[line 2].length", &spar).expect("a number");
    assert_eq!(length.value(&spar), 880.0);
    let mut shorter = spar.clone();
    length.set(&mut shorter, 870.0);
    let (before, after) = (frequencies_hz(spar), frequencies_hz(shorter));
    assert!(after[0] > before[0] * 1.001, "{} {}", after[0], before[0]);
}

/// A number of a material changes the members that are made of it.
#[test]
fn members_follow_their_material() {
    let mut changed = description(FRAME);
    let density = Parameter::parse("material.density", &changed).expect("a number");
    density.set(&mut changed, 8000.0);
    let written = description(&FRAME.replace("density = 7850.0", "density = 8000.0"));
    close(&frequencies_hz(changed), &frequencies_hz(written), 1e-15);
}

/// Derivatives against central differences of solved frequencies, whose error is h²/6 f‴ and
/// rounding.
#[test]
fn derivatives_are_differences() {
    let names = [
        "substructure.member[lower].wall_thickness",
        "substructure.joint[pin].stiffness",
        "material.youngs_modulus",
        "stations[0].diameter",
    ];
    let tower = description(FRAME);
    let changes = Change::parse_all(names, &tower).expect("numbers");
    let found = Solver::default()
        .sensitivities(&tower, &changes)
        .expect("derivatives");
    for (change, of) in changes.iter().zip(&found.changes) {
        let h = 1e-4 * of.value;
        let at = |value: f64| {
            let mut other = tower.clone();
            change.apply(&mut other, value);
            frequencies_hz(other)[0]
        };
        let difference = (at(of.value + h) - at(of.value - h)) / (2.0 * h);
        let derivative = of.modes[0].expect("a derivative").hz_per_unit;
        let scale = found.modes[0].frequency_hz / of.value;
        let is_near = (derivative - difference).abs() <= 1e-5 * scale;
        assert!(is_near, "{}: {derivative} {difference}", change.name());
    }
}

#[test]
fn written_files_are_the_same_tower() {
    for text in [JACKET, SPAR, FRAME] {
        let first = description(text);
        let (written, notes) = write_toml(&first);
        assert_eq!(notes, []);
        let again = description(&written);
        assert_eq!(again, first);
        assert_eq!(write_toml(&again).0, written);
    }
}

fn read(source: Source, files: &dyn FileResolver) -> Result<TowerInput, ReadError> {
    match read_source(source, files, &ReadOptions::default())? {
        Input::Tower(input) => Ok(*input),
        _ => panic!("no tower"),
    }
}

const OF_FILE: &str = r#"
[tower.properties]
z_m = [10.0, 80.0]
mass_kg_per_m = [4000.0, 3000.0]
ei_fore_aft_n_m2 = [4e11, 2e11]
gj_n_m2 = [inf, inf]
ea_n = [inf, inf]
polar_inertia_kg_m = [0.0, 0.0]
[substructure]
file = "tripod_SubDyn.dat"
reference = [0.0, 0.0, 10.0]
"#;

/// The members of a file of SubDyn, and the same written into the tower file.
#[test]
fn a_file_of_subdyn_is_a_substructure() {
    let mut files = InMemory::default();
    for (name, text) in [
        (
            "tripod_SubDyn.dat",
            include_str!("../../../examples/tripod_SubDyn.dat"),
        ),
        (
            "tripod_soil.txt",
            include_str!("../../../examples/tripod_soil.txt"),
        ),
    ] {
        files.files.insert(name.to_owned(), text.to_owned());
    }
    let source = |text: &str| Source {
        name: "tower.toml".to_owned(),
        text: text.to_owned(),
    };
    let input = read(source(OF_FILE), &files);
    let input = input.unwrap_or_else(|error| panic!("{error}"));
    let (written, _) = write_toml(&input.description);
    let again = description(&written);
    close(
        &frequencies_hz(input.description.clone()),
        &frequencies_hz(again),
        1e-12,
    );
    let absent = OF_FILE.replace("tripod_S", "other_S");
    let error = read(source(&absent), &files);
    error
        .expect_err("no such file")
        .to_string()
        .says("tower.toml:10:8");
}

/// The tower files that `convert` writes have the frequencies of their models: numbers are written
/// with all digits, so that only the order of sums differs.
#[test]
fn converted_models_of_openfast_keep_their_frequencies() {
    let Some(folder) = std::env::var_os("TOWERMODES_PEER_DATA") else {
        eprintln!("skipped: TOWERMODES_PEER_DATA is not set");
        return;
    };
    let folder = std::path::PathBuf::from(folder).join("offshore");
    let models = [
        "fast8/Test19.fst",
        "fast8/Test20.fst",
        "fast8/Test21.fst",
        "fast8/Test24.fst",
        "fast8/Test25.fst",
        "iea15-volturnus/OpenFAST/IEA-15-240-RWT-UMaineSemi/IEA-15-240-RWT-UMaineSemi.fst",
        "iea15-monopile/OpenFAST/IEA-15-240-RWT-Monopile/IEA-15-240-RWT-Monopile.fst",
    ];
    for model in models {
        let path = folder.join(model);
        let source = Source::from_path(&path).expect("a model");
        let input = read(source, &SiblingFiles::of(&path));
        let input = input.unwrap_or_else(|error| panic!("{error}"));
        let (written, _) = write_toml(&input.description);
        let again = description(&written);
        let own = frequencies_hz(input.description);
        close(&own, &frequencies_hz(again), 1e-12);
    }
}

/// The jacket of the example stands on soil alone; clamped at its feet it is stiffer.
#[test]
fn piles_of_a_substructure_stand_in_the_ground() {
    let piled = description(JACKET);
    let first = |description: &TowerDescription| frequencies_hz(description.clone())[0];
    let mut clamped = piled.clone();
    clamped.ground = None;
    let Foundation::Frame(frame) = &mut clamped.foundation else {
        panic!("no frame");
    };
    // The piles below the clamped feet hang there by themselves.
    let joints = &frame.frame.description().joints;
    let feet = ["a1", "b1", "c1", "d1"].map(|name| joints.iter().position(|j| j.name == name));
    let feet = feet.map(|foot| FrameSupport::clamped(foot.expect("a foot")));
    frame.numbers_mut().supports.extend(feet);
    let (own, clamped) = (first(&piled), first(&clamped));
    assert!(own < clamped && own > 0.8 * clamped, "{own} {clamped}");
    let stiff = first(&piled.with_soil_factor(1e4));
    assert!(
        stiff < clamped && stiff > 0.98 * clamped,
        "{stiff} {clamped}"
    );
    let tower = Tower::new(piled.clone()).expect("a tower");
    assert_eq!(tower.springs_of_members().len(), 4);
    let source = crate::sources::source("piles.toml", JACKET);
    let input = read(source, &InMemory::default()).expect("a tower");
    let notes = input.notes.iter().map(ToString::to_string);
    assert!(!notes.collect::<String>().contains("no [foundation]"));
    // The water stands in the hole of the scour: its bed is lower.
    let mut scoured = piled.clone();
    scoured.ground.as_mut().expect("soil").scour.general_m = 3.0;
    let coats = |description: &TowerDescription| {
        let tower = Tower::new(description.clone()).expect("a tower");
        let frame = tower.frame().expect("a frame").frame.description();
        let piles = frame.members.iter().filter(|m| m.name.starts_with("pile"));
        piles.map(|member| member.coats.len()).sum::<usize>()
    };
    assert_eq!((coats(&piled), coats(&scoured)), (0, 4));
    assert!(first(&scoured) < own);
}
