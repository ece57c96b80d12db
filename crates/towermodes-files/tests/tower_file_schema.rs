//! The schema of the tower file against the help of `solve`, the book, and the reader.

use std::path::Path;

use ValueKind::{Matrix, Number, Numbers, Rows};
use towermodes::inputs::Named;
use towermodes::{AxialModel, LayerSoil, Parameter, TowerDescription};
use towermodes_files::{
    KeySchema, TableSchema, ValueKind, description_from_toml, tower_file_schema,
};

fn text(path: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    std::fs::read_to_string(root.join(path)).expect("a file of the project")
}

/// Whether a key or a name is in a text as a word: `side` is not in "side-side".
fn names(text: &str, key: &str) -> bool {
    let is_part = |c: char| c.is_alphanumeric() || c == '_' || c == '-';
    text.match_indices(key).any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + key.len()..].chars().next();
        !before.is_some_and(is_part) && !after.is_some_and(is_part)
    })
}

/// The parts of a page in code marks: blocks, and words in lines.
fn in_code_marks(page: &str) -> String {
    let mut code = String::new();
    for (index, part) in page.split("```").enumerate() {
        let marked = part.split('`').skip(1).step_by(2);
        match index % 2 {
            1 => code += part,
            _ => marked.for_each(|words| code += &format!("{words}\n")),
        }
    }
    code
}

const HELP: &str = "crates/towermodes-cli/src/commands/solve/tower-file.txt";
const BOOK: &str = "book/src/tower-file.md";

#[test]
fn the_help_and_the_book_name_each_key_and_each_choice() {
    let (help, book) = (text(HELP), in_code_marks(&text(BOOK)));
    let mut missing = Vec::new();
    let mut check = |name: &str, what: &str| {
        if !names(&help, name) && !SHORT.contains(&name) {
            missing.push(format!("{HELP} lacks `{name}`, {what}"));
        }
        if !names(&book, name) {
            missing.push(format!("{BOOK} lacks `{name}` in code marks, {what}"));
        }
    };
    for table in tower_file_schema() {
        for key in table.keys {
            check(key.name, &format!("a key of {}", table.name));
        }
        if let Some((head, kind)) = table.name.split_once(" of type ") {
            check(kind.trim_matches('"'), &format!("a type of {head}"));
        }
    }
    for (name, what) in models() {
        check(name, what);
    }
    assert!(missing.is_empty(), "{}", missing.join("\n"));
}

/// The models of springs by soil, and what they are.
fn models() -> impl Iterator<Item = (&'static str, &'static str)> {
    let across = LayerSoil::models().map(|model| (model.name(), "a model of soil"));
    let axial = AxialModel::CHOICES.iter();
    across.chain(axial.map(|model| (model.name(), "a model of axial springs")))
}

/// Recorded runs compare the outputs of two builds for each foundation, soil and model.
#[test]
fn the_recorded_runs_have_a_tower_of_each_kind() {
    const KINDS: &str = "recorded-runs/kinds";
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(KINDS);
    let files = std::fs::read_dir(folder).expect("the folder");
    let texts = files.map(|file| std::fs::read_to_string(file.expect("a file").path()));
    let texts: Vec<String> = texts.map(|text| text.expect("a tower file")).collect();
    let types = tower_file_schema().iter();
    let types = types.filter_map(|table| table.name.split_once(" of type "));
    let types = types.map(|(head, kind)| (kind.trim_matches('"'), head));
    let has = |name: &str| {
        texts
            .iter()
            .any(|text| text.contains(&format!("\"{name}\"")))
    };
    // The base of examples/nrel-5mw.toml is clamped.
    let mut missing = types
        .chain(models())
        .filter(|(name, _)| *name != "clamped" && !has(name));
    let missing = missing.next();
    assert_eq!(missing, None, "add a tower with it to {KINDS}");
}

/// Keys that the help describes with a similar one.
const SHORT: [&str; 8] = [
    "azimuth_deg",
    "hydrostatic_height",
    "mooring_height",
    "rotary_inertia_side_side_kg_m",
    "shear_stiffness_side_side_n",
    "xy",
    "xz",
    "yz",
];

#[test]
fn every_required_key_is_missed_by_the_reader() {
    for table in tower_file_schema() {
        let is_plain = table.name.starts_with('[') && !table.name.contains("type");
        if !is_plain || table.keys.iter().all(|key| !key.is_required) {
            continue;
        }
        let text = format!("{}\n", table.name);
        let mistakes = description_from_toml(&text).expect_err("keys are missing");
        for key in table.keys.iter().filter(|key| key.is_required) {
            let missing = format!("{} has no `{}`", table.name, key.name);
            let is_said = mistakes.iter().any(|m| m.message() == missing);
            // The columns of a table of properties are asked for after their heights.
            assert!(is_said || table.name == "[tower.properties]", "{missing}");
        }
    }
}

/// A file with one table: its required keys, and one key whose value has a type that no key has, a
/// date.
fn file_with_a_date(table: &TableSchema, key: &str) -> String {
    // [tower] requires stations or properties.
    let is_required = |k: &KeySchema| k.is_required || k.name == "stations";
    let required = table.keys.iter();
    let required = required.filter(|k| is_required(k) && k.name != key);
    let mut lines: Vec<String> = required.map(example).collect();
    lines.push(format!("{key} = {DATE}"));
    match table.name.split_once(" of type ") {
        Some((head, name)) if key != "type" => {
            lines.retain(|line| !line.starts_with("type"));
            format!("{head}\ntype = {name}\n{}\n", lines.join("\n"))
        }
        Some((head, _)) => format!("{head}\n{}\n", lines.join("\n")),
        None if table.name == "the file" => lines.join("\n"),
        None if table.name == "inertia" => {
            format!("[rna]\nmass = 1\ninertia = {{ {} }}\n", lines.join(", "))
        }
        None if table.name == "coats" => {
            let coat = lines.join(", ");
            format!("[substructure]\nmember = [{{ coats = [{{ {coat} }}] }}]\n")
        }
        None if table.name == "scour" => {
            format!("[ground]\nscour = {{ {} }}\n", lines.join(", "))
        }
        None if table.name == "[tower]" => {
            format!("[tower]\n{}\n[material]\n{STEEL}", lines.join("\n"))
        }
        None => format!("{}\n{}\n", table.name, lines.join("\n")),
    }
}

/// A key with a value of its type.
fn example(key: &KeySchema) -> String {
    let value = match key.kind {
        ValueKind::Number | ValueKind::Any => "1.0",
        ValueKind::Flag => "true",
        ValueKind::Text => "\"steel\"",
        ValueKind::Numbers => "[1.0, 2.0]",
        ValueKind::Rows => "[[0, 6, 0.03], [80, 4, 0.02]]",
        ValueKind::Table => "{ stations = [[0, 6, 0.03], [80, 4, 0.02]] }",
        ValueKind::Matrix => &format!("[{}]", ["[1, 0, 0, 0, 0, 0]"; 6].join(", ")),
    };
    format!("{} = {value}", key.name)
}

const STEEL: &str = "density = 7850\nyoungs_modulus = 2.1e11\nshear_modulus = 8e10\n";

const DATE: &str = "1979-05-27";

/// A reader that forgets a key would accept the file, and the key would have no effect.
#[test]
fn every_key_is_read() {
    let mut forgotten = Vec::new();
    for table in tower_file_schema() {
        for key in table.keys {
            let text = file_with_a_date(table, key.name);
            let date = text.find(DATE).expect("the value");
            let mistakes = description_from_toml(&text).expect_err("a date is no value");
            if !mistakes.iter().any(|mistake| mistake.span.start == date) {
                forgotten.push(text);
            }
        }
    }
    assert!(forgotten.is_empty(), "{}", forgotten.join("\n"));
}

/// Numbers of the tower file that are no parameters: whole numbers, text for the eye, and what
/// other numbers stand for.
const NO_PARAMETERS: [(&str, &str); 17] = [
    (
        "[foundation] of type \"floating\"",
        "added_mass_by_frequency",
    ),
    ("[substructure]", "reference"),
    ("[[substructure.joint]]", "axis"),
    ("[[substructure.member]]", "spin"),
    ("[[substructure.member]]", "area"),
    ("[[substructure.member]]", "shear_areas"),
    ("[[substructure.member]]", "second_moments"),
    ("[[substructure.member]]", "polar_moment"),
    ("[[substructure.member]]", "torsion_constant"),
    ("[[substructure.member]]", "stiffness"),
    ("[[substructure.member]]", "axes"),
    ("[drivetrain]", "rotor_inertia"),
    ("[drivetrain]", "generator_inertia"),
    ("[drivetrain]", "gear_ratio"),
    ("[rotor]", "blades"),
    ("[[wires]]", "count"),
    ("[[wires]]", "azimuth_deg"),
];

/// Tables without parameters: no frequency depends on `[damping]`, and the turbine is no part of
/// the description of the tower, which has it as a rigid body. The matrices on a frame and the
/// bodies of a mooring system have no names.
const TABLES_WITHOUT_PARAMETERS: [&str; 12] = [
    "coats",
    "[[substructure.support]]",
    "[[substructure.added_mass]]",
    "[[substructure.rider]]",
    "[[substructure.water_plane]]",
    "[[mooring.body]]",
    "[[mooring.rod]]",
    "[damping]",
    "[turbine]",
    "[turbine.nacelle]",
    "[turbine.hub]",
    "[turbine.blade]",
];

/// A file with every number of the schema has a parameter with the name and the unit of each.
#[test]
fn every_number_of_the_tower_file_is_a_parameter() {
    let floating = text("examples/floating-lines.toml");
    let jacket = text("examples/jacket.toml");
    let ground = with_other_numbers(GROUND);
    let files = [
        TUBES,
        TABLE,
        STIFFNESS,
        CIRCULAR_FOOTING,
        RECTANGULAR_FOOTING,
        SUCTION_CAISSON,
        MONOPILE,
        WINKLER_PILE,
        VESIC_PILE,
        &ground,
        &floating,
        &jacket,
        FRAME,
    ];
    let towers = files.map(description);
    for table in tower_file_schema() {
        for key in table.keys {
            let is_exempt = NO_PARAMETERS.contains(&(table.name, key.name))
                || TABLES_WITHOUT_PARAMETERS.contains(&table.name);
            if is_exempt || !matches!(key.kind, Number | Numbers | Rows | Matrix) {
                continue;
            }
            let names = names_of_parameters(table, key);
            for name in names {
                // Layers of the ground have different numbers.
                // So have joints and members.
                let one = |i: usize| {
                    let lists = ["layer", "joint", "member"].into_iter();
                    lists.fold(name.clone(), |name, list| {
                        name.replace(&format!("{list}[*]"), &format!("{list}[{i}]"))
                    })
                };
                let of_layers = (0..4).map(one);
                let found = of_layers.into_iter().find_map(|name| {
                    towers.iter().find_map(|tower| {
                        let every = Parameter::parse_every(&name, tower).ok()?;
                        Some(every[0].unit())
                    })
                });
                let unit = found.unwrap_or_else(|| {
                    panic!("no tower of this test has a parameter {name}: add a file with `{}` in {} to the list `files` of this test; if one has it, `parameter/` of the library lacks the name", key.name, table.name)
                });
                if key.kind != Rows {
                    assert_eq!(unit, key.unit, "{} {name}", table.name);
                }
            }
        }
    }
}

/// A ground with those numbers of `[ground]` and its layers that its text has nowhere.
fn with_other_numbers(ground: &str) -> String {
    let mut all = ground.to_owned();
    for table in tower_file_schema() {
        let head = match table.name.strip_prefix("[[ground.layer]] of type ") {
            Some(kind) => format!("type = {kind}\n"),
            None if table.name == "[ground]" => "[ground]\n".to_owned(),
            None => continue,
        };
        let numbers = table.keys.iter().filter(|key| key.kind == Number);
        for key in numbers.filter(|key| !names(ground, key.name)) {
            all = all.replacen(&head, &format!("{head}    {} = 1.0\n", key.name), 1);
        }
    }
    all
}

/// The names of the parameters of a key, with `*` for every row.
fn names_of_parameters(table: &TableSchema, key: &KeySchema) -> Vec<String> {
    let part = table.name.split(' ').next().unwrap_or_default();
    let part = match part {
        "[tower.properties]" => "properties[*]".to_owned(),
        "inertia" => "rna.inertia".to_owned(),
        "scour" => "ground.scour".to_owned(),
        part => part
            .replace("[[", "")
            .replace("]]", "[*]")
            .replace(['[', ']'], "")
            .replace('*', "[*]"),
    };
    let rows = |of: &str, columns: &[&str]| columns.iter().map(|c| format!("{of}.{c}")).collect();
    match (part.as_str(), key.kind, key.name) {
        ("tower", Rows, _) => rows("stations[*]", &["height", "diameter", "wall"]),
        ("soil[*]", Rows, _) => rows(
            "soil[*].rows[*]",
            &["height", "x", "y", "z", "torsion", "rotation_x"],
        ),
        ("added_mass[*]", Rows, _) => rows("added_mass[*].rows[*]", &["height", "mass"]),
        ("ground.layer[*]", Rows, _) => rows(
            "ground.layer[*].rows[*]",
            &["height", "displacement", "reaction"],
        ),
        (_, Matrix, name) => vec![format!("{part}.{name}[*][*]")],
        (_, Numbers, name @ ("center" | "position" | "buoyancy_center")) => {
            let count = if name == "buoyancy_center" { 2 } else { 3 };
            (0..count).map(|i| format!("{part}.{name}[{i}]")).collect()
        }
        (_, _, name) => vec![format!("{part}.{name}")],
    }
}

fn description(text: &str) -> TowerDescription {
    match description_from_toml(text) {
        Ok(description) => description,
        Err(mistakes) => panic!("{mistakes:?}"),
    }
}

/// A frame with a cable, a pin and a mass.
const FRAME: &str = r#"
    [material]
    density = 7850.0
    youngs_modulus = 2.1e11
    poissons_ratio = 0.3
    [tower]
    stations = [[10.0, 5.0, 0.03], [80.0, 4.0, 0.02]]
    [substructure]
    reference = [0.0, 0.0, 10.0]
    interface = ["top"]
    clamped = ["foot", "anchor"]
    joint = [
      { name = "foot", position = [0.0, 0.0, 0.0] },
      { name = "pin", position = [0.0, 0.0, 5.0], kind = "pin", axis = [0.0, 1.0, 0.0], stiffness = 1e9 },
      { name = "top", position = [0.0, 0.0, 10.0] },
      { name = "anchor", position = [9.0, 0.0, 0.0] },
    ]
    member = [
      { name = "lower", joints = ["foot", "pin"], outer_diameter = 5.0, wall_thickness = 0.04 },
      { name = "upper", joints = ["pin", "top"], outer_diameter = [5.0, 4.0], wall_thickness = 0.04 },
      { name = "stay", joints = ["top", "anchor"], kind = "cable", axial_stiffness = 1e9, mass_per_length = 50.0, pretension = 1e6 },
    ]
    mass = [{ joint = "top", mass = 1e4, center = [0.0, 0.0, 1.0], inertia = { xx = 1.0, yy = 2.0, zz = 3.0 } }]
"#;

const TUBES: &str = "
    [material]
    density = 8500.0
    youngs_modulus = 2.1e11
    poissons_ratio = 0.3
    [tower]
    stations = [[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]]
    [rna]
    mass = 350e3
    [rotor]
    blades = 3
    rpm = [6.9, 12.1]
    [[point_mass]]
    height = 40.0
    mass = 1000.0
    [[soil]]
    rows = [[0.0, 1e6, 1e6], [5.0, 1e6, 1e6]]
    [[added_mass]]
    rows = [[0.0, 1e3], [5.0, 1e3]]
    [water]
    level = 10.0
    [[wires]]
    height = 40.0
    count = 3
    stiffness = 1e6
    angle_deg = 45.0
    [foundation]
    type = \"springs\"
    lateral = 1e9
    rocking = 1e11
    vertical = 1e10
    torsion = 1e11
";

const TABLE: &str = "
    [tower.properties]
    z_m = [0.0, 80.0]
    mass_kg_per_m = [4e3, 2e3]
    ei_fore_aft_n_m2 = [5e11, 1e11]
    gj_n_m2 = [4e11, 1e11]
    ea_n = [1e11, 5e10]
    polar_inertia_kg_m = [2e4, 1e4]
    shear_stiffness_fore_aft_n = [1e10, 1e10]
    shear_stiffness_side_side_n = [1e10, 2e10]
    [foundation]
    type = \"half-space\"
    radius = 8.0
    soil_shear_modulus = 5e7
    soil_poissons_ratio = 0.3
";

/// A tube on a foundation.
macro_rules! tube_on {
    ($foundation:literal) => {
        concat!(
            "
    [material]
    density = 8500.0
    youngs_modulus = 2.1e11
    shear_modulus = 8.08e10
    [tower]
    stations = [[0.0, 6.0, 0.027], [87.6, 3.87, 0.019]]
    [foundation]",
            $foundation
        )
    };
}

const MONOPILE: &str = tube_on!(
    "
    type = \"monopile\"
    formula = \"en-1998-5\"
    diameter = 6.0
    wall_thickness = 0.06
    embedded_length = 36.0
    youngs_modulus = 2.1e11
    soil_profile = \"linear\"
    soil_youngs_modulus = 5e7
    soil_poissons_ratio = 0.3
"
);

const WINKLER_PILE: &str = tube_on!(
    "
    type = \"winkler-pile\"
    diameter = 6.0
    wall_thickness = 0.06
    embedded_length = 36.0
    youngs_modulus = 2.1e11
    soil_spring = 5e7
    exponent = 1.0
    vertical = 1e10
"
);

const GROUND: &str = "
    [tower.properties]
    z_m = [-40.0, 80.0]
    mass_kg_per_m = [4e3, 2e3]
    ei_fore_aft_n_m2 = [5e11, 1e11]
    gj_n_m2 = [4e11, 1e11]
    ea_n = [1e11, 5e10]
    polar_inertia_kg_m = [2e4, 1e4]
    [ground]
    surface = 0.0
    submerged = true
    model = \"api\"
    axial = \"api\"
    factor = 2.0
    pile_diameter = 6.0
    scour = { general = 1.0, local = 2.0 }
    [[ground.layer]]
    type = \"sand\"
    top = 0.0
    bottom = -8.0
    effective_unit_weight = 10e3
    friction_angle = 35.0
    subgrade_modulus = 2e7
    relative_density = 0.6
    cone_resistance = [1e7, 2e7]
    correlation = \"robertson-cabal\"
    behaviour_index = 2.0
    density = 1900
    poissons_ratio = 0.3
    shaft_friction = [0, 5e4]
    end_bearing = 5e6
    [[ground.layer]]
    type = \"clay\"
    top = -8.0
    bottom = -16.0
    undrained_strength = 5e4
    strain_at_half_strength = 0.01
    strength_factor = 0.5
    stiffness_factor = 10
    shear_wave_velocity = 150
    density = 1800
    [[ground.layer]]
    type = \"elastic\"
    model = \"winkler\"
    top = -16.0
    bottom = -24.0
    void_ratio = 0.7
    earth_pressure_at_rest = 0.4
    [[ground.layer]]
    type = \"py\"
    top = -24.0
    bottom = -40.0
    rows = [[-24.0, 0.01, 1e5], [-40.0, 0.01, 3e5]]
";

const VESIC_PILE: &str = tube_on!(
    "
    type = \"winkler-pile\"
    formula = \"poulos-davis\"
    diameter = 6.0
    wall_thickness = 0.06
    embedded_length = 36.0
    youngs_modulus = 2.1e11
    spring_formula = \"vesic\"
    soil_youngs_modulus = 5e7
    soil_poissons_ratio = 0.3
    exponent = 0.0
"
);

const CIRCULAR_FOOTING: &str = tube_on!(
    "
    type = \"circular-footing\"
    radius = 9.0
    embedment = 1.0
    soil_shear_modulus = 5e7
    soil_poissons_ratio = 0.3
    soil_thickness = 20.0
    coupled = true
"
);

const RECTANGULAR_FOOTING: &str = tube_on!(
    "
    type = \"rectangular-footing\"
    formula = \"pais-kausel\"
    length_x = 18.0
    length_y = 14.0
    embedment = 1.0
    soil_shear_modulus = 5e7
    soil_poissons_ratio = 0.3
    coupled = false
"
);

const SUCTION_CAISSON: &str = tube_on!(
    "
    type = \"suction-caisson\"
    diameter = 10.0
    skirt_length = 9.0
    soil_profile = \"parabolic\"
    soil_youngs_modulus = 4e7
    soil_poissons_ratio = 0.3
    torsion = 1e11
"
);

const STIFFNESS: &str = tube_on!(
    "
    type = \"stiffness\"
    matrix = [
        [1e9, 0, 0, 0, 0, 0], [0, 1e9, 0, 0, 0, 0], [0, 0, 1e9, 0, 0, 0],
        [0, 0, 0, 1e11, 0, 0], [0, 0, 0, 0, 1e11, 0], [0, 0, 0, 0, 0, 1e11],
    ]
    [gravity]
"
);
