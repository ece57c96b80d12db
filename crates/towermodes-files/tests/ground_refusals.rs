//! Mistakes in what holds and surrounds a tower: their line and column, what is wrong and what
//! would be right.

use crate::refused;

use refused::refused_text;
use towermodes_files::tower_from_toml;
use towermodes_testing::rows;

/// Every file begins with this tower, so that what each test is about begins in line 7.
const TOWER: &str = "[material]
density = 8500.0
youngs_modulus = 2.1e11
shear_modulus = 8.08e10
[tower]
stations = [[-20.0, 6.0, 0.06], [80.0, 4.0, 0.02]]
";
const STIFFNESS: &str = r#"[foundation]
type = "stiffness"
matrix = [
  [2e9, 0, 0, 0, -1e10, 0],
  [0, 2e9, 0, 1e10, 0, 0],
  [0, 0, 5e9, 0, 0, 0],
  [0, 1e10, 0, 3e11, 0, 0],
  [-1e10, 0, 0, 0, 3e11, 0],
  [0, 0, 0, 0, 0, 1e11],
]
"#;
const SPRINGS: &str = r#"[foundation]
type = "springs"
lateral = 1e8
rocking = 2e10
vertical = 3e9
torsion = inf
coupling = -4e8
"#;
const HALF_SPACE: &str = r#"[foundation]
type = "half-space"
radius = 8.0
soil_shear_modulus = 5e7
soil_poissons_ratio = 0.35
embedment = 2.0
"#;
const MONOPILE: &str = r#"[foundation]
type = "monopile"
formula = "shadlou-bhattacharya"
diameter = 7.0
wall_thickness = 0.08
embedded_length = 60.0
youngs_modulus = 2.1e11
soil_profile = "homogeneous"
soil_youngs_modulus = 3e7
soil_poissons_ratio = 0.3
"#;
const CIRCULAR_FOOTING: &str = r#"[foundation]
type = "circular-footing"
radius = 9.0
soil_shear_modulus = 5e7
soil_poissons_ratio = 0.35
soil_thickness = 20.0
embedment = 2.0
"#;
const RECTANGULAR_FOOTING: &str = r#"[foundation]
type = "rectangular-footing"
formula = "gazetas"
length_x = 18.0
length_y = 14.0
soil_shear_modulus = 5e7
soil_poissons_ratio = 0.35
"#;
const SUCTION_CAISSON: &str = r#"[foundation]
type = "suction-caisson"
diameter = 10.0
skirt_length = 9.0
soil_profile = "linear"
soil_youngs_modulus = 4e7
soil_poissons_ratio = 0.3
"#;
const WINKLER_PILE: &str = r#"[foundation]
type = "winkler-pile"
diameter = 7.0
wall_thickness = 0.08
embedded_length = 30.0
youngs_modulus = 2.1e11
spring_formula = "vesic"
soil_youngs_modulus = 3e7
soil_poissons_ratio = 0.3
exponent = 0.0
"#;
const FLOATING: &str = r#"[foundation]
type = "floating"
mass = 7.5e6
center = [0.0, 0.0, -90.0]
inertia = { xx = 4e9, yy = 4e9, zz = 1.6e8 }
hydrostatic_height = -5.0
hydrostatic = [
  [0, 0, 0, 0, 0, 0],
  [0, 0, 0, 0, 0, 0],
  [0, 0, 3.3e5, 0, 0, 0],
  [0, 0, 0, 5e9, 0, 0],
  [0, 0, 0, 0, 5e9, 0],
  [0, 0, 0, 0, 0, 1e8],
]
"#;
const SOIL: &str = r#"[[soil]]
name = "sand"
rows = [
  [-30.0, 2e7, 3e7],
  [-10.0, 0, 0],
]
"#;
const WATER: &str = r#"[water]
level = 10.0
bed = -15.0
density = 1000.0
added_mass_coefficient = 0.9
flooded = true
"#;
const WIRES: &str = r#"[[wires]]
name = "stays"
height = 60.0
count = 3
stiffness = 1e6
angle_deg = 45.0
azimuth_deg = 30.0
"#;

/// Replaces `from` by `to` in what follows the tower and expects the first mistake there, as
/// [`refused_text`].
#[track_caller]
fn refused(good: &str, from: &str, to: &str, place: &str, message: &str, hint: &str) {
    assert!(good.contains(from), "the test is wrong: {from}");
    let text = format!("{TOWER}{}", good.replacen(from, to, 1));
    refused_text(&text, place, message, hint);
}

/// Mistakes one after the other: what is replaced, by what, place, message, hint.
fn all_refused(good: &str, table: &str) {
    for [from, to, place, message, hint] in rows(table) {
        refused(good, from, to, place, message, hint);
    }
}

#[test]
fn without_a_mistake_all_are_good() {
    for good in [
        STIFFNESS,
        SPRINGS,
        HALF_SPACE,
        CIRCULAR_FOOTING,
        RECTANGULAR_FOOTING,
        SUCTION_CAISSON,
        MONOPILE,
        WINKLER_PILE,
        FLOATING,
        SOIL,
        WATER,
        WIRES,
    ] {
        let tower = tower_from_toml(&format!("{TOWER}{good}"));
        assert!(tower.is_ok(), "{good}{tower:?}");
    }
}

#[test]
fn matrices_of_another_size() {
    let hint = "six rows of six numbers, in the order x, y, z";
    let message = "matrix has 5 rows instead of 6";
    let from = "  [0, 0, 0, 0, 0, 1e11],\n";
    refused(STIFFNESS, from, "", "9:10", message, hint);
    let message = "row 3 of matrix has 5 values instead of 6";
    let from = "[0, 0, 5e9, 0, 0, 0]";
    refused(STIFFNESS, from, "[0, 0, 5e9, 0, 0]", "12:3", message, hint);
    all_refused(
        STIFFNESS,
        r#"
        [0, 0, 5e9, 0, 0, 0] | 5e9 | 12:3 | row 3 of matrix must be a list in brackets, found a number
        5e9 | "5e9" | 12:10 | row 3 of matrix, column 3, must be a number, found a text | without quotation marks
        5e9 | nan | 12:10 | row 3 of matrix, column 3, is NaN
        "#,
    );
}

#[test]
fn matrices_that_no_foundation_has() {
    refused(
        STIFFNESS,
        "0, -1e10",
        "0, 1e10",
        "9:10",
        "the stiffness is not symmetric: row 1, column 5 is 1e10 and row 5, column 1 is -1e10",
        "x, y, z, rotation about x, y, z",
    );
    let indefinite = STIFFNESS.replace("3e11", "3e10");
    let message = "the stiffness has a negative eigenvalue, -1.20465e9";
    let hint = "square of a coupling term";
    refused(&indefinite, "2e9", "2e9", "9:10", message, hint);
    let message = "stiffness is inf, not a finite number";
    refused(STIFFNESS, "0, 0, 5e9", "inf, 0, 5e9", "9:10", message, "");
    let masses = format!("{STIFFNESS}mass = [{}]\n", "[0, 0, 0, 0, 0, 0], ".repeat(6));
    let message = "the mass matrix has a negative eigenvalue, -1";
    let to = "mass = [[-1, ";
    refused(&masses, "mass = [[0, ", to, "17:8", message, "");
    refused(&masses, "mass = [", "mass = [[0], ", "17:8", "7 rows", "");
}

#[test]
fn springs_that_no_base_has() {
    all_refused(
        SPRINGS,
        r#"
        rocking = 2e10\n |  | 7:1 | [foundation] of type "springs" has no `rocking` | rocking in N m; inf is rigid, 0 is none
        = 1e8 | = -1e8 | 9:11 | the lateral stiffness in x and y is -1e8 N/m; it must not be negative
        = 3e9 | = -inf | 11:12 | the vertical stiffness is -inf | finite number
        = inf | = 1e999 | 12:11 | torsion is inf
        = -4e8 | = inf | 13:12 | coupling is inf
        = 1e8 | = inf | 13:12 | a coupling spring cannot be combined | omit coupling
        = -4e8 | = -4e9 | 13:12 | coupling and rocking springs has a negative eigenvalue | square of a coupling term
        lateral | latteral | 9:1 | `latteral` is not a key of [foundation] of type "springs" | did you mean `lateral`?
        "#,
    );
}

#[test]
fn towers_that_nothing_holds() {
    let free = SPRINGS.replace("coupling = -4e8\n", "");
    let message = "there is no stiffness against translation in x and translation in y";
    refused(&free, "= 1e8", "= 0", "8:8", message, "soil");
    let message = "there is no stiffness against rotation about z";
    let hint = "type = \"floating\"";
    refused(&free, "= inf", "= 0.0", "8:8", message, hint);
    // Wires hold it laterally.
    let held = free.replace("= 1e8", "= 0");
    assert!(tower_from_toml(&format!("{TOWER}{held}{WIRES}")).is_ok());
}

#[test]
fn footings_that_cannot_be() {
    all_refused(
        HALF_SPACE,
        r#"
        radius = 8.0\n |  | 7:1 | of type "half-space" has no `radius` | radius of the footing in m
        8.0 | 0 | 9:10 | the radius of the footing is 0 m
        "#,
    );
    all_refused(
        MONOPILE,
        r#"
        shadlou-bhattacharya | gazetas | 9:11 | there is no formula `gazetas` | names: shadlou-bhattacharya, randolph, en-1998-5, carter-kulhawy
        "homogeneous" | 3 | 14:16 | profile of Young's modulus over the depth
        0.08 | 80 | 11:18 | the wall thickness of the pile is 80 m; it must be above 0 and at most 3.5 m | check value and unit
        3e7 | 0 | 15:23 | Young's modulus of the soil at the depth of one diameter is 0 Pa
        soil_youngs_modulus = 3e7\n | soil_shear_modulus = 3e7\n | 15:1 | `soil_shear_modulus` is not a key | belongs to type = "half-space"
        "#,
    );
    all_refused(
        HALF_SPACE,
        r#"
        0.35 | 0.6 | 11:23 | Poisson's ratio of the soil is 0.6; it must be from 0 to 0.5 | clay 0.5
        = 2.0 | = -2.0 | 12:13 | the depth of embedment is -2 m
        5e7 | inf | 10:22 | soil_shear_modulus is inf
        "#,
    );
}

#[test]
fn platforms_that_do_not_float() {
    all_refused(
        FLOATING,
        r#"
        3.3e5 | inf | 13:15 | the hydrostatic stiffness has an infinite entry, but a floating platform cannot be rigidly supported | type = "springs", where inf is allowed
        3.3e5 | 1e999 | 16:10 | row 3 of hydrostatic, column 3, is inf
        mass = 7.5e6 | lateral = inf\nmass = 7.5e6 | 9:1 | `lateral` is not a key of [foundation] of type "floating" | it belongs to type = "springs"; the stiffness of a floating platform is given by
        hydrostatic_height = -5.0\n |  | 7:1 | has no `hydrostatic_height` | of the reference point of the matrix
        hydrostatic_height | mooring_height = -70.0\nhydrostatic_height | 12:18 | `mooring_height` has no effect without `mooring` | add the matrix
        [0.0, 0.0, -90.0] | -90.0 | 10:10 | center must be a list
        [0.0, 0.0, -90.0] | [-90.0] | 10:10 | center has 1 value instead of 3 | z in the datum of the stations
        yy = 4e9,␣ |  | 11:11 | inertia has no `yy` | about the centre of mass
        xx = 4e9 | xx = -4e9 | 11:11 | moments of inertia are -4e9, 1.6e8 and 4e9 kg m2
        7.5e6 | 0 | 9:8 | the platform's mass is 0 kg
        [0, 0, 0, 0, 5e9, 0] | [1e6, 0, 0, 0, 5e9, 0] | 13:15 | the hydrostatic stiffness is not symmetric: row 1, column 5 is 0 and row 5, column 1 is 1000000
        "#,
    );
}

/// Strata, sides, skirts and springs: each mistake at its place.
#[test]
fn strata_caissons_and_springs_that_cannot_be() {
    all_refused(
        CIRCULAR_FOOTING,
        r#"
        20.0 | 1.5 | 13:13 | the underside of the footing is 2 m below the surface of the soil, and the stratum ends at 1.5 m | soil_thickness is the depth of the rock
        soil_thickness = 20.0 | soil_thickness = 20.0\nlower_shear_modulus = 5e8 | 14:13 | the footing is embedded by 2 m in a stratum over another stratum | write embedment = 0, or omit lower_shear_modulus
        embedment = 2.0 | coupled = 1 | 13:11 | coupled
        "#,
    );
    all_refused(
        RECTANGULAR_FOOTING,
        r#"
        18.0 | -18.0 | 10:12 | the side along x is -18 m
        length_y | width | 11:1 | `width` is not a key | `length_y`
        gazetas | arya | 9:11 | there is no formula `arya` | names: gazetas, pais-kausel
        "#,
    );
    refused(
        SUCTION_CAISSON,
        "skirt_length = 9.0",
        "skirt_length = 0",
        "10:16",
        "the length of the skirt is 0 m",
        "",
    );
    all_refused(
        WINKLER_PILE,
        r#"
        spring_formula = "vesic"\n |  | 13:23 | `soil_youngs_modulus` has no effect without `spring_formula` | add spring_formula
        "vesic" | "gazetas" | 15:23 | `soil_poissons_ratio` has no effect with spring_formula = "gazetas" | remove it
        exponent | soil_spring = 1e8\nexponent | 16:15 | `soil_spring` has no effect together with `spring_formula` | keep one of the two
        exponent = 0.0 | exponent = 1.0\nformula = "poulos-davis" | 16:12 | here they grow with the power 1.0833 of the depth | use formula = "exact"
        "#,
    );
}

#[test]
fn types_and_their_keys() {
    all_refused(
        SPRINGS,
        r#"
        "springs" | "spring" | 8:8 | there is no foundation of type `spring` | did you mean `springs`?
        "springs" | "jelly" | 8:8 | there is no foundation of type `jelly` | types: clamped, stiffness, springs, half-space, circular-footing, rectangular-footing, suction-caisson, monopile, winkler-pile, floating
        "springs" | "clamped" | 9:1 | `lateral` is not a key of [foundation] of type "clamped" | it belongs to type = "springs"; a clamped base does not move
        lateral | mass = 1e5\nlateral | 9:1 | `mass` is not a key | it belongs to type = "stiffness" or "floating"
        type = "springs"\n |  | 7:1 | [foundation] has no `type` | "clamped" or "stiffness" or "springs"
        type | tpye | 8:1 | `tpye` is not a key of [foundation] | did you mean `type`?
        "#,
    );
    let text = format!("{TOWER}{}", SPRINGS.replace("type", "tpye"));
    assert_eq!(tower_from_toml(&text).expect_err("no tower").len(), 1);
}

#[test]
fn soil_that_cannot_be() {
    all_refused(
        SOIL,
        r#"
        [-10.0, | [90.0, | 11:4 | the soil extends from -30 m to 90 m, but the tower from -20 m to 80 m | heights below it are negative
        [-30.0, 2e7, 3e7] | [-30.0, 2e7] | 10:3 | row 1 of the soil has 2 values instead of 3 to 5 or 7 | a row is [height in m, spring in x, spring in y]
        [-30.0, 2e7, 3e7] | [-30.0, 1, 2, 3, 4, 5] | 10:3 | row 1 of the soil has 6 values instead of 3 to 5 or 7 | in torsion and against rotation about x and y (N)
        [-10.0, 0, 0] | [-10.0, 0, 0, 0] | 11:3 | row 2 of the soil has 4 values instead of 3 as the first row
        [-10.0, 0, 0] | -10.0 | 11:3 | row 2 of the soil must be a list in brackets, found a number
        3e7 | -3e7 | 10:16 | the soil spring in y is -3e7 N/m2; it must not be negative
        2e7 | inf | 10:11 | the soil spring in x is inf
        [-10.0, | [-40.0, | 11:4 | height -40 m is below the previous row at -30 m | from the bottom to the surface
        ␣␣[-10.0, 0, 0],\n |  | 9:8 | the soil needs at least two rows, but has 1
        [-30.0, | [-10.0, | 11:4 | the soil has no depth: all rows are at -10 m
        rows | row | 9:1 | `row` is not a key of [[soil]] | did you mean `rows`?
        [[soil]] | [soil] | 7:1 | soil must be a list of tables | write [[soil]] in double brackets, once for each layer
        "#,
    );
    let second = format!("{SOIL}{}", SOIL.replace("2e7", "-2e7"));
    refused(&second, "name", "name", "16:11", "spring in x is -2e7", "");
}

#[test]
fn water_that_cannot_be() {
    refused(
        &WATER.replace("bed = -15.0\n", ""),
        "10.0",
        "-30.0",
        "8:9",
        "the water does not touch the tower",
        "datum",
    );
    all_refused(
        WATER,
        r#"
        -15.0 | 12.0 | 9:7 | the seabed at 12 m is not below the water level at 10 m | lowest station
        level = 10.0\n |  | 7:1 | [water] has no `level` | height of the surface
        1000.0 | 0 | 10:11 | the density of the water is 0 kg/m3
        0.9 | -1 | 11:26 | the added mass coefficient is -1
        = true | = 1 | 12:11 | flooded must be true or false, found a number
        density | desnity | 10:1 | `desnity` is not a key of [water] | did you mean `density`?
        "#,
    );
}

#[test]
fn wires_that_cannot_be() {
    let message = "the number of guy wires in the set is 2; it must be at least 3";
    let words = "equally spaced";
    refused(WIRES, "count = 3", "count = 2", "10:9", message, words);
    for (count, said) in [
        ("0.5", "count is 0.5"),
        ("-3", "count is -3"),
        ("3.5", "count is 3.5"),
        ("1e300", "count is 1e300"),
    ] {
        let hint = "";
        let to = format!("count = {count}");
        refused(WIRES, "count = 3", &to, "10:9", said, hint);
    }
    all_refused(
        WIRES,
        r#"
        60.0 | 81.0 | 9:10 | height 81 m is not on the tower, which reaches from -20 m to 80 m
        45.0 | 120 | 12:13 | the angle of the guy wires from the horizontal is 120 degrees; it must be from 0 to 90 | angle_deg = 45
        1e6 | 0 | 11:13 | the stiffness EA/L of each wire is 0 N/m
        30.0 | "north" | 13:15 | azimuth_deg must be a number
        angle_deg | angle | 12:1 | `angle` is not a key of [[wires]] | did you mean `angle_deg`?
        count = 3\n |  | 7:1 | [[wires]] has no `count` | equally spaced
        [[wires]] | [wires] | 7:1 | wires must be a list of tables | once for each set of wires
        "#,
    );
}

#[test]
fn gravity_that_cannot_be() {
    let gravity = "[gravity]\nacceleration = 9.81\n";
    let message = "the acceleration of gravity is -9.81 m/s2; it must not be negative";
    refused(gravity, "9.81", "-9.81", "8:16", message, "");
    let words = "`accelaration` is not a key of [gravity]";
    let hint = "did you mean `acceleration`?";
    refused(gravity, "acceleration", "accelaration", "8:1", words, hint);
}
