//! Layers of soil whose values are in a table in CSV: the same towers as with layers written by
//! hand, and every mistake at its place.

use crate::sources::source;
use towermodes::TowerDescription;
use towermodes_files::{
    InMemory, Input, ReadError, ReadOptions, TowerInput, description_from_toml, read_source,
    tower_from_toml, write_toml,
};
use towermodes_testing::{Says, line_and_column, rows};

/// A pile in sand over clay, which is strongest in its middle.
const TOWER: &str = "\
[material]
density = 8500.0
youngs_modulus = 2.1e11
poissons_ratio = 0.3
[tower]
stations = [[-36.0, 6.0, 0.06], [10.0, 6.0, 0.06], [87.6, 3.87, 0.019]]
[ground]
surface = -2.0
submerged = true
model = \"api\"
axial = \"api\"
[[ground.layer]]
type = \"sand\"
top = -2.0
bottom = -14.0
friction_angle = 33.0
effective_unit_weight = 10e3
shaft_friction = 5e4
[[ground.layer]]
name = \"clay\"
type = \"clay\"
top = -14.0
bottom = -40.0
profile = \"clay.csv\"
strain_at_half_strength = 0.01
strength_factor = 0.5
effective_unit_weight = 9e3
";

/// Rows above and below the clay, with a step at 22 m.
const CLAY: &str = "\
depth [m],su [kPa],shaft friction [kPa],remark
10,70,30,borehole 3
14,90,40,
22,130.5,50,
22,150,60,
30,1.005,20,
40,200,80,
";

/// Name, ends (m), strength and shaft friction at both ends (Pa).
type Piece = (&'static str, [f64; 2], [f64; 2], [f64; 2]);

/// The clay by hand: cut at -14, -16, -24, -32 and -40 m.
const PIECES: [Piece; 4] = [
    ("clay", [-14.0, -16.0], [80e3, 90e3], [35e3, 40e3]),
    ("clay", [-16.0, -24.0], [90e3, 130_500.0], [40e3, 50e3]),
    ("clay", [-24.0, -32.0], [150e3, 1005.0], [60e3, 20e3]),
    ("clay", [-32.0, -40.0], [1005.0, 160_201.0], [20e3, 68e3]),
];

fn by_hand() -> TowerDescription {
    let (sand, _) = TOWER.rsplit_once("[[ground.layer]]").expect("the clay");
    let layers = PIECES.map(|(name, [top, bottom], strength, friction)| {
        format!(
            "[[ground.layer]]\nname = \"{name}\"\ntype = \"clay\"\ntop = {top:?}\nbottom = {bottom:?}\n\
             undrained_strength = {strength:?}\nshaft_friction = {friction:?}\n\
             strain_at_half_strength = 0.01\nstrength_factor = 0.5\neffective_unit_weight = 9e3\n"
        )
    });
    let text = format!("{sand}{}", layers.concat());
    description_from_toml(&text).unwrap_or_else(|mistakes| panic!("{mistakes:?}"))
}

fn read_with(tower: &str, table: &str) -> Result<TowerInput, ReadError> {
    let source = source("tower.toml", tower);
    let cans = "height_m,diameter_m,wall_m\n-36,6,0.06\n10,6,0.06\n87.6,3.87,0.019\n";
    let files = [("clay.csv", table), ("cans.csv", cans)];
    let files = files.map(|(name, text)| (name.to_owned(), text.to_owned()));
    let files = InMemory {
        files: files.into(),
    };
    match read_source(source, &files, &ReadOptions::default())? {
        Input::Tower(tower) => Ok(*tower),
        Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => panic!("no tower"),
    }
}

#[track_caller]
fn description(tower: &str, table: &str) -> TowerDescription {
    match read_with(tower, table) {
        Ok(input) => input.description,
        Err(error) => panic!("{error}"),
    }
}

/// Expects the first mistake in a file at line:column with these words.
#[track_caller]
fn refused(tower: &str, table: &str, file: &str, place: (usize, usize), words: &[&str]) {
    let refused = read_with(tower, table).and_then(|input| input.tower());
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = refused.expect_err("no tower")
    else {
        panic!("no mistake in a file");
    };
    let said = mistakes[0].to_string();
    assert_eq!(source_file.name, file, "{said}");
    let found = mistakes[0].line_and_column(&source_file.text);
    assert_eq!(found, place, "{said}");
    for word in words {
        assert!(said.contains(word), "no `{word}` in: {said}");
    }
}

/// The same of the table with a change.
#[track_caller]
fn refused_table(old: &str, new: &str, place: (usize, usize), words: &[&str]) {
    assert_eq!(CLAY.matches(old).count(), 1, "{old}");
    refused(TOWER, &CLAY.replace(old, new), "clay.csv", place, words);
}

/// The same of the tower file with a change.
#[track_caller]
fn refused_tower(old: &str, new: &str, place: (usize, usize), words: &[&str]) {
    assert_eq!(TOWER.matches(old).count(), 1, "{old}");
    refused(&TOWER.replace(old, new), CLAY, "tower.toml", place, words);
}

#[test]
fn a_profile_is_the_layers_between_its_rows() {
    let input = read_with(TOWER, CLAY).expect("a tower");
    assert_eq!(input.description, by_hand());
    let found = input.files().collect::<Vec<_>>();
    assert_eq!(found, ["tower.toml", "clay.csv"]);
    assert!(input.tower().is_ok());
    let (text, notes) = write_toml(&input.description);
    assert!(notes.is_empty() && !text.contains("csv"), "{notes:?}{text}");
    assert_eq!(description_from_toml(&text).expect("a tower"), by_hand());
}

#[test]
fn every_spelling_of_a_profile_is_the_same_tower() {
    let mut turned: Vec<&str> = CLAY.lines().skip(1).collect();
    turned.reverse();
    let header = CLAY.lines().next().expect("a header");
    let heights = CLAY
        .replace("depth", "height")
        .replace("\n40,", "\n-42,")
        .replace("\n30,", "\n-32,")
        .replace("\n22,", "\n-24,")
        .replace("\n14,", "\n-16,")
        .replace("\n10,", "\n-12,");
    for table in [
        CLAY.replace("su [kPa]", "undrained_strength_kPa"),
        CLAY.replace("depth [m]", "Depth_m")
            .replace("su [", "S_u ("),
        CLAY.replace("\n10,", "\n1000,")
            .replace("\n14,", "\n1400,")
            .replace("\n22,", "\n2200,")
            .replace("\n30,", "\n3000,")
            .replace("\n40,", "\n4000,")
            .replace("[m]", "[cm]"),
        CLAY.replace(',', ";").replace('.', ","),
        // Rows that are not in the layer, and a row at its top by a conversion.
        CLAY.replace("\n10,", "\n0,0,0,\n10,"),
        CLAY.replace("\n14,", "\n12.0000000001,80,35,\n14,"),
        format!("{header}\n{}\n", turned.join("\n")),
        heights,
    ] {
        assert_eq!(description(TOWER, &table), by_hand(), "{table}");
    }
}

#[test]
fn a_profile_gives_the_shear_modulus_with_the_keys_of_its_layer() {
    let tower = TOWER.replace(
        "strength_factor = 0.5",
        "strength_factor = 0.5\nundrained_strength = 1e5\ncorrelation = \"mayne-rix\"",
    );
    let table = "depth_m,qc [MPa]\n12,0.5\n20,0.8\n38,1.5\n";
    let layer = |top: &str, bottom: &str, cone: &str| {
        let (_, clay) = tower.rsplit_once("[[ground.layer]]").expect("the clay");
        let clay = clay
            .replace("top = -14.0", &format!("top = {top}"))
            .replace("bottom = -40.0", &format!("bottom = {bottom}"))
            .replace(
                "profile = \"clay.csv\"",
                &format!("cone_resistance = {cone}"),
            );
        format!("[[ground.layer]]{clay}")
    };
    let (sand, _) = tower.rsplit_once("[[ground.layer]]").expect("the clay");
    let upper = layer("-14.0", "-22.0", "[5e5, 8e5]");
    let lower = layer("-22.0", "-40.0", "[8e5, 15e5]");
    let expected = description_from_toml(&format!("{sand}{upper}{lower}"));
    assert_eq!(description(&tower, table), expected.expect("a tower"));
    // The key that belongs to the column is missing: at the name of the table.
    let without = tower.replace("correlation = \"mayne-rix\"\n", "");
    let file = "tower.toml";
    refused(&without, table, file, (19, 1), &["has no `correlation`"]);
    let second = tower.replace("top = -14.0", "shear_modulus = 1e7\ntop = -14.0");
    let words = ["`cone_resistance` has no effect together with shear_modulus"];
    refused(&second, table, "tower.toml", (25, 11), &words);
}

/// The files of stations and of profiles have their own places.
#[test]
fn a_profile_beside_a_table_of_stations_keeps_its_places() {
    let stations = "[[-36.0, 6.0, 0.06], [10.0, 6.0, 0.06], [87.6, 3.87, 0.019]]";
    let tower = TOWER.replace(stations, "\"cans.csv\"");
    assert_eq!(description(&tower, CLAY), by_hand());
    // Zero at both ends of a piece is found by the check of the whole tower.
    let zero = CLAY
        .replace("\n22,150,", "\n22,0,")
        .replace("\n30,1.005,", "\n30,0,");
    let words = [
        "undrained shear strength",
        "the unit is given in the header of the column",
    ];
    refused(&tower, &zero, "clay.csv", (5, 4), &words);
    refused(TOWER, &zero, "clay.csv", (5, 4), &words);
    // The same table for two layers.
    let both = TOWER.replace(
        "friction_angle = 33.0\n",
        "friction_angle = 33.0\nmodel = \"winkler\"\nprofile = \"clay.csv\"\n",
    );
    let words = [
        "a quantity of a layer of type \"sand\"",
        "it belongs to type = \"clay\"",
    ];
    refused(
        &both.replace("shaft_friction = 5e4\n", ""),
        CLAY,
        "clay.csv",
        (1, 11),
        &words,
    );
}

#[test]
fn headers_of_profiles_that_are_wrong_are_refused() {
    let table = r#"
        su [kPa] | undrained_strenght [kPa] | 1:11 | did you mean `undrained_strength`?
        su [kPa] | undrained_strenght_kpa | 1:11 | did you mean `undrained_strength`?
        su [kPa] | water content | 1:11 | columns are depth or height
        su [kPa] | friction_angle | 1:11 | this value is constant in a layer
        su [kPa] | su | 1:11 | the unit of the column undrained_strength is missing
        su [kPa] | su [m] | 1:11 | there is no unit of pressure `m`
        depth [m] | depth [kPa] | 1:1 | there is no unit of length `kpa`
        depth [m] | depth | 1:1 | write `depth [m]`
        depth [m] | remark | 1:1 | the column depth or height is missing
        remark | z [m] | 1:1 | both a depth and a height
        remark | cu_kpa | 1:41 | the column undrained_strength occurs 2 times
        remark | friction_ratio [%] | 1:41 | expected a column of a soil profile here
    "#;
    for [old, new, place, words] in rows(table) {
        refused_table(old, new, line_and_column(place), &[words]);
    }
    let bare = "depth_m,remark\n10,a\n50,b\n";
    let words = ["a column with a quantity of the soil is missing"];
    refused(TOWER, bare, "clay.csv", (1, 1), &words);
    let numbers = "10,70\n50,90\n";
    refused(TOWER, numbers, "clay.csv", (1, 1), &["found numbers"]);
    refused(TOWER, "", "clay.csv", (1, 1), &["the file is empty"]);
    let table = "depth_m,su_kpa\n10,70\n";
    refused(TOWER, table, "clay.csv", (2, 6), &["at least two rows"]);
    let number = "depth_m,n [kPa]\n10,7\n50,9\n";
    refused(
        TOWER,
        number,
        "clay.csv",
        (1, 9),
        &["a blow count has no unit"],
    );
}

#[test]
fn rows_of_profiles_that_are_wrong_are_refused() {
    let cases = r#"
        130.5 | nan | 4:4 | undrained_strength is NaN
        130.5 | 130 kPa | 4:4 | must be a number
        130.5 |  | 4:4 | undrained_strength is missing
        130.5 | -130.5 | 4:4 | is -130.5, but must be zero or positive
        \n30, | \n21, | 6:1 | the direction of the depth reverses here, after line 5
        \n30, | \n22, | 6:1 | the height -24 m occurs 3 times
        10,70,30,borehole 3\n14, | 14.5, | 2:1 | begins below the top of the layer, -14 m, at the height -16.5 m
        40,200,80,\n |  | 6:1 | ends above the bottom of the layer, -40 m, at the height -32 m
        "#;
    for [old, new, place, words] in rows(cases) {
        let place = line_and_column(place);
        refused_table(old, new, place, &[words]);
    }
    let rows: String = (0..1002).map(|i| format!("{i},9\n")).collect();
    let long = format!("depth_m,su_kpa\n{rows}");
    let words = ["1001 rows are more than the limit of 1000"];
    refused(TOWER, &long, "clay.csv", (1002, 1), &words);
}

#[test]
fn what_is_wrong_in_the_tower_file_is_shown_there() {
    let profile = "profile = \"clay.csv\"";
    let cases = [
        (profile, "profile = 3", (24, 11), "must be a text"),
        (
            profile,
            "profile = \"other.csv\"",
            (24, 11),
            "other.csv: no such file",
        ),
        (
            profile,
            "profile = \"clay.csv\"\nundrained_strength = 1e5",
            (25, 22),
            "`undrained_strength` has no effect together with its column in profile",
        ),
        ("top = -14.0\n", "", (19, 1), "has no `top`"),
        (
            "bottom = -40.0",
            "bottom = -4.0",
            (23, 10),
            "is not below its top",
        ),
    ];
    for (old, new, place, words) in cases {
        refused_tower(old, new, place, &[words]);
    }
    let alone = tower_from_toml(TOWER).expect_err("a text without a folder cannot refer to files");
    alone[0]
        .message()
        .says("a text without a folder cannot refer to files");
}
