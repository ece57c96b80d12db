//! `[turbine]` of the tower file: values, the turbine as a rigid body, every mistake at its place,
//! written and read back.

use towermodes::turbine::{TurbineDescription, TurbineMesh, TurbineModel};
use towermodes::{Inertia, RigidBody};
use towermodes_files::{
    ConvertOptions, InMemory, Input, OutputFormat, ReadError, ReadOptions, RotorLock, Setting,
    Source, TowerInput, convert, read_source, rewritten, write_toml_with,
};
use towermodes_testing::{Close, Says, rows, with};

const EXAMPLE: &str = include_str!("../../../examples/nrel-5mw-turbine.toml");

/// A small turbine; the lines of its tables are replaced by the tests.
const SMALL: &str = "[material]
density = 7850.0
youngs_modulus = 2.1e11
poissons_ratio = 0.3
[tower]
stations = [[0.0, 3.0, 0.03], [40.0, 2.0, 0.02]]
[turbine]
overhang = -4.0
tower_to_shaft = 2.0
tilt_deg = -5.0
cone_deg = -3.0
pitch_deg = 10.0
blades = 3
shaft_stiffness = 5e7
generator = \"free\"
generator_inertia = 2.0
gear_ratio = 3.0
yaw_stiffness = 1e8
yaw_bearing_mass = 300.0
[turbine.nacelle]
mass = 2000.0
center = [1.0, 0.5, 1.0]
inertia = { xx = 1000.0, yy = 2000.0, zz = 1500.0 }
[turbine.hub]
mass = 500.0
offset = 1.0
polar_inertia = 70.0
transverse_inertia = 40.0
[turbine.blade]
hub_radius = 1.0
tip_radius = 11.0
tip_mass = 7.0
span = [0.0, 0.5, 1.0]
mass_kg_per_m = [100.0, 90.0, 80.0]
ei_flap_n_m2 = [1e7, 9e6, 8e6]
ei_edge_n_m2 = [2e7, 1.9e7, 1.8e7]
twist_deg = [13.0, 5.0, 0.1]
gj_n_m2 = [1e6, 9e5, 8e5]
ea_n = [1e9, 9e8, 8e8]
flap_inertia_kg_m = [3.0, 2.0, 1.0]
edge_inertia_kg_m = [4.0, 3.0, 2.0]
center_of_mass_m = [0.01, 0.02, 0.03]
tension_center_m = [0.001, 0.002, 0.003]
";

fn source(text: &str) -> Source {
    Source {
        name: "t.toml".to_owned(),
        text: text.to_owned(),
    }
}

fn read_with(text: &str, files: &InMemory, options: &ReadOptions) -> Result<TowerInput, ReadError> {
    match read_source(source(text), files, options)? {
        Input::Tower(tower) => Ok(*tower),
        Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => panic!("no tower"),
    }
}

fn read(text: &str) -> TowerInput {
    read_with(text, &InMemory::default(), &ReadOptions::default())
        .unwrap_or_else(|error| panic!("{error}"))
}

fn turbine(text: &str) -> TurbineDescription {
    read(text).turbine.expect("a turbine")
}

/// The error of a text, with its lines.
fn refused(text: &str) -> String {
    let read = read_with(text, &InMemory::default(), &ReadOptions::default());
    read.expect_err("a mistake").to_string()
}

/// The number of blades is known where `[rotor]` does not give it.
#[test]
fn blades_of_the_turbine_are_those_of_its_rotor() {
    let four = SMALL.replace("blades = 3", "blades = 4");
    assert_eq!(
        [SMALL, &four].map(|text| read(text).blades),
        [Some(3), Some(4)]
    );
}

#[test]
fn every_number_is_read() {
    let turbine = turbine(SMALL);
    let nacelle = RigidBody {
        mass_kg: 2000.0,
        center_m: [1.0, 0.5, 1.0],
        inertia_kg_m2: with!(Inertia, xx = 1000.0, yy = 2000.0, zz = 1500.0),
    };
    assert_eq!(turbine.nacelle, nacelle);
    assert_eq!((turbine.overhang_m, turbine.tower_to_shaft_m), (-4.0, 2.0));
    assert_eq!(turbine.tilt_rad, -5_f64.to_radians());
    assert_eq!(turbine.cone_rad, -3_f64.to_radians());
    assert_eq!(turbine.shaft_n_m_per_rad, 5e7);
    assert_eq!(turbine.yaw_n_m_per_rad, 1e8);
    assert_eq!((turbine.yaw_bearing_mass_kg, turbine.blades), (300.0, 3));
    let (hub, generator) = (turbine.hub, turbine.generator);
    assert_eq!((hub.mass_kg, hub.center_m), (500.0, 1.0));
    assert_eq!(hub.polar_inertia_kg_m2, 70.0);
    assert_eq!(hub.transverse_inertia_kg_m2, 40.0);
    assert_eq!((generator.inertia_kg_m2, generator.gear_ratio), (2.0, 3.0));
    assert!(!generator.is_locked);
    let blade = &turbine.blade;
    assert_eq!((blade.hub_radius_m, blade.tip_radius_m), (1.0, 11.0));
    assert_eq!((blade.tip.mass_kg, blade.tip_is_pulled), (7.0, true));
    assert_eq!(blade.pitch_rad, 10_f64.to_radians());
    let middle = &blade.sections[1];
    assert_eq!((middle.span, middle.mass_kg_per_m), (0.5, 90.0));
    assert_eq!((middle.flap_n_m2, middle.edge_n_m2), (9e6, 1.9e7));
    assert_eq!(middle.twist_rad, 5_f64.to_radians());
    assert_eq!((middle.torsion_n_m2, middle.axial_n), (9e5, 9e8));
    assert_eq!(middle.flap_inertia_kg_m, 2.0);
    assert_eq!(middle.edge_inertia_kg_m, 3.0);
    assert_eq!(middle.center_of_mass_m, 0.02);
    assert_eq!(middle.tension_center_m, 0.002);
}

#[test]
fn a_turbine_of_few_keys_is_rigid_where_nothing_is_said() {
    let turbine = turbine(
        "[material]\ndensity = 7850\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\n\
         [tower]\nstations = [[0, 3, 0.03], [40, 2, 0.02]]\n\
         [turbine]\noverhang = -4\ntower_to_shaft = 2\nnacelle = { mass = 2e3 }\nhub = { mass = 500 }\n\
         [turbine.blade]\nhub_radius = 1\ntip_radius = 11\nspan = [0, 1]\nmass_kg_per_m = [100, 100]\n\
         ei_flap_n_m2 = [1e7, 1e7]\nei_edge_n_m2 = [2e7, 2e7]\n",
    );
    assert_eq!(turbine.shaft_n_m_per_rad, f64::INFINITY);
    assert_eq!(turbine.yaw_n_m_per_rad, f64::INFINITY);
    assert!(turbine.generator.is_locked);
    assert_eq!((turbine.blades, turbine.generator.gear_ratio), (3, 1.0));
    assert_eq!(turbine.blade.sections[0].torsion_n_m2, f64::INFINITY);
    assert_eq!(turbine.blade.sections[0].axial_n, f64::INFINITY);
}

/// By hand: three rods of 100 kg/m from 1 to 11 m, without cone, offset and tilt: 3000 kg in the
/// rotor's plane, ∫ μ r² dr = 100 (1331 − 1)/3 each, once about the shaft and half across it.
#[test]
fn the_tower_carries_the_turbine_as_a_rigid_body() {
    let text = "[material]\ndensity = 7850\nyoungs_modulus = 2.1e11\npoissons_ratio = 0.3\n\
         [tower]\nstations = [[0, 3, 0.03], [40, 2, 0.02]]\n\
         [turbine]\noverhang = -4\ntower_to_shaft = 2\ngenerator_inertia = 50\nnacelle = { mass = 0 }\nhub = { mass = 0 }\n\
         [turbine.blade]\nhub_radius = 1\ntip_radius = 11\nspan = [0, 1]\nmass_kg_per_m = [100, 100]\n\
         ei_flap_n_m2 = [1e7, 1e7]\nei_edge_n_m2 = [2e7, 2e7]\n";
    let rna = read(text).description.rna;
    let polar = 3.0 * 100.0 * 1330.0 / 3.0;
    let close = |value: f64, expected: f64| {
        value.within(expected, 1e-9 * polar);
    };
    close(rna.mass_kg, 3000.0);
    close(rna.center_m[0], -4.0);
    close(rna.center_m[2], 2.0);
    // The generator rolls with the nacelle.
    close(rna.inertia_kg_m2.xx, polar + 50.0);
    close(rna.inertia_kg_m2.yy, 0.5 * polar);
    close(rna.inertia_kg_m2.zz, 0.5 * polar);
    let free = with!(ReadOptions, rotor = RotorLock::Free);
    let words = "generator_inertia = 50\ngear_ratio = 20\n";
    let text = text.replace("generator_inertia = 50\n", words);
    let freed = read_with(&text, &InMemory::default(), &free).expect("a tower");
    let felt = polar * 50.0 * 361.0 / (polar + 50.0 * 400.0);
    close(freed.description.rna.inertia_kg_m2.xx, felt);
    assert!(!freed.turbine.expect("a turbine").generator.is_locked);
    let still = text.replace("generator_inertia = 50\n", "");
    let error = read_with(&still, &InMemory::default(), &free).expect_err("no generator");
    error.says("a free rotor needs generator_inertia");
}

/// The example is the turbine of the tables in `elastodyn/public_turbine.rs`, but for the masses of
/// its sections, which are rounded, its yaw spring and the torsion of its tower, which is of tubes:
/// modes that do not turn the nacelle are the same.
#[test]
fn the_example_has_the_collective_modes_of_the_public_model() {
    let input = read(EXAMPLE);
    let turbine = input.whole_turbine().expect("a turbine");
    let turbine = turbine.expect("a turbine");
    let mut model = TurbineModel::new(&turbine, &TurbineMesh::default()).expect("a mesh");
    let spectrum = model.frequencies(2.1, 12.1);
    let spectrum = spectrum.expect("a spectrum");
    assert!(spectrum.is_complete);
    // Flap, shaft with edge, second flap.
    for expected in [0.749_594, 1.682_694, 2.037_548] {
        let mut all = spectrum.frequencies.iter().map(|one| one.frequency_hz);
        let is_near = all.any(|found| (found / expected - 1.0).abs() < 1e-3);
        assert!(is_near, "{expected} {spectrum:?}");
    }
    let total_kg = input.description.rna.mass_kg;
    assert!((total_kg - 349_606.49).abs() < 1.0, "{total_kg}");
}

/// Inertias are about the blade's axis. Without a list of them the centre of mass is the mistake.
#[test]
fn a_centre_of_mass_beside_the_axis_needs_inertia() {
    let text = SMALL
        .replace("flap_inertia_kg_m = [3.0, 2.0, 1.0]\n", "")
        .replace("edge_inertia_kg_m = [4.0, 3.0, 2.0]\n", "")
        .replace("gj_n_m2 = [1e6, 9e5, 8e5]\n", "");
    let at = text
        .lines()
        .position(|line| line.starts_with("center_of_mass_m"));
    let error = refused(&text);
    let place = format!("t.toml:{}:", at.expect("the line") + 1);
    error.says("the edgewise inertia of section 1 is 0 kg m");
    assert!(error.contains(&place), "{error}");
    // A line of mass beside the axis is the least that is possible.
    let least = "edge_inertia_kg_m = [0.01, 0.036, 0.072]\ncenter_of_mass_m";
    read(&text.replace("center_of_mass_m", least));
}

#[test]
fn a_written_turbine_is_read_back_number_by_number() {
    for text in [SMALL, EXAMPLE] {
        let input = read(text);
        let (written, notes) = write_toml_with(&input.description, input.turbine.as_ref());
        assert_eq!(notes, []);
        let again = read(&written);
        assert_eq!(again.turbine, input.turbine, "{written}");
        assert_eq!(again.description, input.description);
        let converted = convert(&input, OutputFormat::Toml, &ConvertOptions::default());
        assert_eq!(converted.expect("a file").text, written);
    }
}

#[test]
fn a_changed_assembly_is_written_as_a_rigid_body() {
    let mut input = read(SMALL);
    let before = input.clone();
    input
        .set(&[Setting::new("rna.mass", 1e4)], "--set")
        .expect("a number");
    assert!(input.turbine.is_none() && input.turbine_missing.is_some());
    let file = rewritten(&before, &input.description);
    assert!(file.anew.is_some() && file.text.contains("[rna]"));
    file.notes[0]
        .message
        .says("blades of the turbine are omitted");
    // Numbers of the tower are changed in the text, and the turbine stays.
    let mut thicker = before.description.clone();
    thicker.stations[0].wall_thickness_m = 0.035;
    let file = rewritten(&before, &thicker);
    assert!(file.anew.is_none());
    assert_eq!(turbine(&file.text), before.turbine.expect("a turbine"));
}

/// Each change of a line of [`SMALL`], with words of the message and the changed text at its place.
const MISTAKES: &str = r#"
    overhang = -4.0\n |  | [turbine] has no `overhang`
    overhang | overhag | did you mean `overhang`?
    overhang = -4.0 | overhang = nan | overhang is NaN, not a finite number
    tower_to_shaft = 2.0 | tower_to_shaft = inf | tower_to_shaft is inf
    blades = 3 | blades = 2 | a rotor of 2 blades is not supported
    blades = 3 | blades = 3.5 | a whole number from 3 to 10
    blades = 3 | blades = 3000 | at most
    tilt_deg = -5.0 | tilt_deg = 50.0 | the tilt of the shaft is 50.00 degrees
    cone_deg = -3.0 | cone_deg = -46.0 | the cone of the blades is -46.00 degrees
    shaft_stiffness = 5e7 | shaft_stiffness = 0.0 | the stiffness of the shaft is 0; it must be positive
    shaft_stiffness = 5e7 | shaft_stiffness = "rigid" | must be a number
    yaw_stiffness = 1e8 | yaw_stiffness = -1.0 | the stiffness of the yaw drive is -1
    "free" | "fre" | did you mean `free`?
    generator_inertia = 2.0 | generator_inertia = 0.0 | the inertia of a free generator is 0
    generator_inertia = 2.0 | generator_inertia = -2.0 | the inertia of the generator is -2
    gear_ratio = 3.0 | gear_ratio = -3.0 | the gear ratio is -3; it must be positive
    yaw_bearing_mass = 300.0 | yaw_bearing_mass = -1.0 | the mass of the yaw bearing is -1
    mass = 2000.0 | mass = -2000.0 | the mass of the nacelle is -2000
    { xx = 1000.0, | { xx = -1000.0, | the least principal inertia of the nacelle is -1000
    center = [1.0, 0.5, 1.0] | center = [1.0, 0.5] | center has 2 values instead of 3
    mass = 500.0 | mass = -1.0 | the mass of the hub is -1
    polar_inertia = 70.0 | polar_inertia = -1.0 | the hub's inertia about the shaft is -1
    transverse_inertia = 40.0 | transverse_inertia = -1.0 | the hub's inertia across the shaft is -1
    tip_radius = 11.0 | tip_radius = 0.5 | the blade extends from radius 1 m to 0.5 m
    tip_mass = 7.0 | tip_mass = -7.0 | the tip mass is -7 kg
    [0.0, 0.5, 1.0] | [0.0, 0.5, 0.9] | must be given from 0 to 1
    0.5, 1.0]\nmass | 1.5, 1.0]\nmass | the sections must increase along the span
    90.0, 80.0] | 0.0, 80.0] | the mass per length of section 2 is 0
    [1e7, 9e6, 8e6] | [1e7, 9e6] | ei_flap_n_m2 has 2 values instead of 3, the number of values in span
    1.8e7] | -1.8e7] | the edge stiffness of section 3 is -1.8e7
    [1e6, 9e5, 8e5] | [1e6, inf, 8e5] | must be infinite in all sections
    [0.001, 0.002, 0.003] | [0.001, 9.0, 0.003] | the tension centre of section 2 is too far
    [3.0, 2.0, 1.0] | [3.0, -3.0, 1.0] | the sum of both inertias of section 2 is 0
    [3.0, 2.0, 1.0] | [3.0, -0.5, 1.0] | the flap inertia of section 2 is -0.5; it must not be negative
    [4.0, 3.0, 2.0] | [4.0, 0.03, 2.0] | with a mass of 90 kg/m whose centre is 0.02 m from the axis it must be at least mass times offset squared, 0.036000 kg m
"#;

#[test]
fn every_mistake_has_its_sentence_and_its_line() {
    for [line, changed, words] in rows(MISTAKES) {
        SMALL.says(line);
        let text = SMALL.replacen(line, changed, 1);
        let error = refused(&text);
        assert!(error.contains(words), "{changed}: {error}");
        let at = SMALL.find(line).expect("the line");
        let (mut number, mut last) = (SMALL[..at].lines().count(), changed.lines().count());
        number += usize::from(SMALL[..at].ends_with('\n'));
        if changed.is_empty() {
            // What is missing is missing in its table.
            (number, last) = (7, 1);
        }
        let lines = number..number + last.max(1) + 1;
        let is_there = lines
            .clone()
            .any(|n| error.contains(&format!("t.toml:{n}:")));
        assert!(is_there, "{changed}: not at {lines:?}: {error}");
    }
}

#[test]
fn two_descriptions_of_the_same_parts_are_refused() {
    let error = refused(&format!("{SMALL}[rna]\nmass = 1e4\n"));
    error.says_all("[turbine] and [rna] both describe what the tower carries & t.toml:7:");
    let error = refused(&format!("{SMALL}[drivetrain]\nrotor_inertia = 1e4\n"));
    error.says("`drivetrain` has no effect together with [turbine]");
    let few = refused(&format!("{SMALL}[rotor]\nblades = 2\nrpm = 12\n"));
    few.says_all("a rotor of 2 blades is not supported & give [rna] in place of [turbine]");
    let error = refused(&format!("{SMALL}[rotor]\nblades = 4\nrpm = 12\n"));
    error.says_all("[turbine] has 3 blades and [rotor] has 4 & t.toml:13:");
}

#[test]
fn absurd_tables_are_refused() {
    let rows = 1001;
    let list = |value: &str| format!("[{}]", vec![value; rows].join(", "));
    let spans: Vec<String> = (0..rows).map(|k| (k as f64 / 1000.0).to_string()).collect();
    let text = SMALL
        .split("span =")
        .next()
        .expect("a beginning")
        .to_owned()
        + &format!(
            "span = [{}]\nmass_kg_per_m = {}\nei_flap_n_m2 = {}\nei_edge_n_m2 = {}\n",
            spans.join(", "),
            list("100"),
            list("1e7"),
            list("1e7")
        );
    let error = refused(&text);
    error.says("1001 sections of a blade are more than the limit of 1000");
    for empty in ["span = []", "span = [0.0]", "span = 3", "span = [[0, 1]]"] {
        let error = refused(&SMALL.replace("span = [0.0, 0.5, 1.0]", empty));
        error.says("t.toml:");
    }
    // Products of these are infinite.
    for huge in ["1e308", "1e200"] {
        let text = SMALL.replace("mass = 2000.0", &format!("mass = {huge}"));
        let text = text.replace("center = [1.0", &format!("center = [{huge}"));
        let read = read_with(&text, &InMemory::default(), &ReadOptions::default());
        let error = read.and_then(|input| input.whole_turbine().map(drop));
        assert!(error.is_err(), "{huge}");
    }
}

const BLADE: &str = "a blade\nof 10 m\n------- BLADE PARAMETERS -------\n 2 NBlInpSt\n 1 BldFlDmp(1)\n 1 BldFlDmp(2)\n 1 BldEdDmp(1)\n\
------- BLADE ADJUSTMENT FACTORS -------\n 1 FlStTunr(1)\n 1 FlStTunr(2)\n 2 AdjBlMs\n 3 AdjFlSt\n 4 AdjEdSt\n\
------- DISTRIBUTED BLADE PROPERTIES -------\n BlFract PitchAxis StrcTwst BMassDen FlpStff EdgStff\n (-) (-) (deg) (kg/m) (Nm^2) (Nm^2)\n\
 0 0.25 13 50 1e7 2e7\n 1 0.25 0 40 1e6 2e6\n";

fn with_file(blade: &str, more: &str) -> Result<TowerInput, ReadError> {
    let head = SMALL.split("span =").next().expect("a beginning");
    let text = format!("{head}file = \"blade.dat\"\n{more}");
    let mut files = InMemory::default();
    files.files.insert("blade.dat".to_owned(), blade.to_owned());
    read_with(&text, &files, &ReadOptions::default())
}

#[test]
fn a_blade_may_be_in_a_file_of_its_own() {
    let input = with_file(BLADE, "").expect("a turbine");
    assert_eq!(input.files().collect::<Vec<_>>(), ["t.toml", "blade.dat"]);
    let blade = input.turbine.expect("a turbine").blade;
    let (root, tip) = (blade.sections[0], blade.sections[1]);
    assert_eq!(root.mass_kg_per_m, 100.0);
    assert_eq!(root.flap_n_m2, 3e7);
    assert_eq!(root.edge_n_m2, 8e7);
    assert_eq!(tip.mass_kg_per_m, 80.0);
    assert_eq!(tip.flap_n_m2, 3e6);
    assert_eq!(tip.edge_n_m2, 8e6);
    assert_eq!(root.twist_rad, 13_f64.to_radians());
    assert_eq!(blade.tip.mass_kg, 7.0);
    assert_eq!(blade.pitch_rad, 10_f64.to_radians());
    let error = with_file(&BLADE.replace("1e6", "-1e6"), "")
        .expect_err("negative")
        .to_string();
    error.says_all("blade.dat:18: & FlpStff of row 2");
    let error = with_file(BLADE, "twist_deg = [0.0, 0.0]\n")
        .expect_err("both")
        .to_string();
    error.says("`twist_deg` has no effect together with file");
    let missing = SMALL
        .split("span =")
        .next()
        .expect("a beginning")
        .to_owned()
        + "file = \"x.dat\"\n";
    refused(&missing).says("file cannot be read: x.dat: no such file");
    let deck = include_str!("../../../examples/nrel-5mw.bmi");
    let error = with_file(deck, "").expect_err("a deck").to_string();
    error.says("t.toml:33:8: file names a deck of BModes");
    let error = with_file("no blade\n", "")
        .expect_err("no blade file")
        .to_string();
    error.says("blade.dat:");
}

/// Each missing part is listed once, and none that the file has.
#[test]
fn blades_that_are_there_are_not_missing() {
    let with = |parts: &str| refused(&format!("missing_parts = [{parts}]\n{SMALL}"));
    let blades = with("\"soil\", \"blades\"");
    blades.says_all("t.toml:1:26 & `blades` is listed as missing, but [turbine] describes it");
    let twice = with("\"soil\", \"water\", \"soil\"");
    twice.says_all("t.toml:1:35 & the missing part `soil` occurs 2 times");
}
