//! Mistakes in files: where, what, and what would be right.

use towermodes_files::{MooringInput, ReadError};
use towermodes_testing::{Says, rows};

use super::texts::{MAP, MOORDYN_2, SITE, changed, map, moordyn};

/// Each row: what is replaced, by what, the place, words of the
/// message, words of the hint.
fn all_refused(text: &str, read: impl Fn(&str) -> Result<MooringInput, ReadError>, cases: &str) {
    for [from, to, place, message, hint] in rows(cases) {
        let changed = changed(text, from, to);
        let error =
            match read(&changed).map(|input| input.mooring().and_then(|m| input.at_rest(&m))) {
                Ok(Ok(_)) => panic!("{to}: no mistake"),
                Ok(Err(error)) | Err(error) => error,
            };
        let ReadError::Mistakes {
            source_file,
            mistakes,
        } = error
        else {
            panic!("{to}: {error}");
        };
        let (line, column) = mistakes[0].line_and_column(&source_file.text);
        assert_eq!(format!("{line}:{column}"), place, "{}", mistakes[0]);
        mistakes[0].message().says(message);
        mistakes[0].hint.clone().unwrap_or_default().says(hint);
    }
}

#[test]
fn tables_that_are_incomplete() {
    all_refused(
        MOORDYN_2,
        |text| moordyn(text, &SITE),
        r"
        POINTS --- | PUNKTE --- | 1:1 | the table POINTS is missing | line of dashes
        LINES --- | LEINEN --- | 1:1 | the table LINES is missing |
        LINE TYPES --- | SEILE --- | 1:1 | the table LINE TYPES is missing |
        OPTIONS --- | LINES --- | 22:1 | the section LINES occurs 2 times |
        (-)       (m)      (kg/m) | x | 5:1 | expected the units of the columns of LINE TYPES here | two lines
        Name     Diam | 2 NTypes\nName Diam | 4:1 | the number of rows of LINE TYPES is 2, but there are 1 rows | correct the number
        853.87     0.0    -320.0    0     0      0     0 | 853.87 | 10:1 | Z in row 1 of POINTS is missing |
        853.87     0.0 | far     0.0 | 10:17 | X in row 1 of POINTS must be a number, found `far` |
        4      Vessel | 7      Vessel | 13:1 | ID in row 4 of POINTS is 7, but must be 4, as rows are numbered from 1 |
        2      main | 4      main | 20:1 | ID in row 2 of LINES is 4, but must be 2 |
        2      main | 2      mian | 20:8 | there is no line type `mian` | the file has `main`
        1         4   | 1         9   | 19:29 | there is no point `9` | numbers 1 to 6
        1         4   | 1         0   | 19:29 | there is no point `0` |
        1         4   | 1         R1A | 19:29 | there is no rod `1` | no rows
        1         4   | 1         four | 19:29 | AttachB in row 1 of LINES must be the number of a point |
        320.0    WtrDpth | WtrDpth  320.0 | 25:1 | expected the value of an option here, found `WtrDpth` | `320.0 WtrDpth`
        9.80665  g | fast  g | 27:1 | g (gravity) must be a number |
        320.0    WtrDpth | -320.0    WtrDpth | 25:1 | is -320 m, but must be positive |
        ",
    );
}

#[test]
fn what_is_not_modelled() {
    all_refused(
        MOORDYN_2,
        |text| moordyn(text, &SITE),
        r"
        4      Vessel | 4      Turbine2 | 13:8 | moorings that several turbines of a farm share are not modelled | with Vessel
        1         4   | 1         T2 | 19:29 | several turbines of a farm |
        4      Vessel | 4      VesselPinned | 13:8 | pinned bodies and rods are not modelled | Fixed or Coupled
        4      Vessel | 4      Body1 | 13:8 | there is no body `1` | no rows
        4      Vessel | 4      glued | 13:8 | must be Fixed, Vessel (or Coupled), Free (or Connect) or Body |
        320.0    WtrDpth | bathymetry.txt    WtrDpth | 25:1 | a seabed of varying depth (bathymetry) is not modelled | the depth at the anchors
        384.243E6 | polyester.txt | 6:30 | tables of tension over strain are not modelled | slope
        384.243E6 | 1|2|3|4 | 6:30 | has 4 values instead of 1 to 3 |
        ------------------------ OUTPUTS | --- EXTERNAL LOADS ---\nID\n(-)\n1 Point4 1|2|3 0 0 G\n--- OUTPUTS | 28:1 | external loads and damping | remove
        MoorDyn Input File | FEAM INPUT FILE | 1:1 | this is a file of FEAMooring | AddCLin
        --------------------- MoorDyn Input | %YAML 1.1\n--- | 1:1 | this is a file of OrcaFlex | AddCLin
        ",
    );
    let error = moordyn(MAP, &SITE)
        .expect_err("another program's file")
        .to_string();
    error.says("Mooring.dat:1:1: this is a file of MAP++");
    let error = map(MOORDYN_2, &SITE)
        .expect_err("another program's file")
        .to_string();
    error.says("Mooring.dat:1:1: this is a file of MoorDyn");
}

/// The tables of a body and a rod.
const PARTS: &str = "\
--- ROD TYPES ---
TypeName Diam Mass/m
(name) (m) (kg/m)
can 1.2 900
--- BODIES ---
ID  Attachment  X0 Y0 Z0 r0 p0 y0 Mass CG* I* Volume CdA* Ca*
(#) (-) (m) (m) (m) (deg) (deg) (deg) (kg) (m) (kg-m^2) (m^3) (m^2) (-)
1 Coupled 1 2 -5 10 20 30 2e5 0.5|0|-8.0 1e6 250 0 1
--- RODS ---
ID RodType Attachment Xa Ya Za Xb Yb Zb NumSegs RodOutputs
(#) (name) (#/key) (m) (m) (m) (m) (m) (m) (-) (-)
1 can Vessel 20 -6 -5 27 -9 -17 8 -
--- POINTS ---";

#[test]
fn bodies_and_rods_that_cannot_be() {
    let text = changed(MOORDYN_2, "---------------------- POINTS", PARTS);
    all_refused(
        &text,
        |text| moordyn(text, &SITE),
        r"
        1 Coupled | 1 CoupledPinned | 14:3 | pinned bodies and rods are not modelled |
        0.5|0|-8.0 | 0.5|0 | 14:31 | CG in row 1 of BODIES has 2 values instead of 1 or 3 | without blanks
        250 0 1 | 250 0 added.txt | 14:52 | tables of added mass are not modelled | no effect
        250 0 1 | 250 0 | 14:1 | Ca in row 1 of BODIES is missing |
        250 0 1 | -250 0 1 | 14:1 | the volume of body 1 is -250 m3; it must not be negative |
        1 can Vessel | 1 can Body1 | 18:7 | bodies and rods on other bodies are not modelled | mass and volume
        1 can Vessel | 1 can Pinned | 18:7 | pinned bodies and rods |
        1 can Vessel | 1 tin Vessel | 18:3 | there is no rod type `tin` | the file has `can`
        27 -9 -17 8 | 20 -6 -5 8 | 18:1 | the ends of rod 1 are at the same position |
        1 can Vessel | 1 can Free | 18:1 | rod 1 is free, but no line ends there |
        ",
    );
}

#[test]
fn moorings_that_cannot_be() {
    all_refused(
        MOORDYN_2,
        |text| moordyn(text, &SITE),
        r"
        0.09  | -0.09  | 6:1 | the diameter of line type 1 is -0.09 m; it must not be negative |
        384.243E6 | 0 | 6:1 | the axial stiffness of line type 1 is 0 N; it must be positive |
        853.87     0.0    -320.0 | 853.87     0.0    -400.0 | 10:1 | point 1 is at z = -400 m, under the seabed at z = -320 m |
        902.2       20        -\n2 | 0       20        -\n2 | 19:1 | the length of line 1 is 0 m; it must be positive |
        902.2       20        -\n2 | 100       20        -\n2 | 19:1 | line 1 is too short |
        1         4   | 1         1   | 19:1 | both ends of line 1 are point 1 |
        1025.0   rhoW | -1025.0   rhoW | 25:1 | the density of the water of the mooring is -1025 kg/m3 |
        4      Vessel | 4      Free   | 13:1 | point 4 sinks to |
        ",
    );
}

#[test]
fn files_of_map_that_cannot_be() {
    all_refused(
        MAP,
        |text| map(text, &SITE),
        r"
        902.2 | #902.2 | 13:20 | UnstrLen in row 1 of LINES is `#`, a length computed by MAP++ | summary
        5.2    0    -70.0 | #5.2    0    -70.0 | 9:16 | X in row 2 of POINTS must be a number, found `#5.2` |
        2    Vessel    5.2    0    -70.0   0     0     # | 2    connect #5 0 #-70 0 0 7 | 9:28 | FX in row 2 of POINTS is 7: external forces | write 0
        2    Vessel    5.2    0    -70.0   0     0     # | 2    connect #5 0 #-70 0 0 # | 9:28 | FX in row 2 of POINTS is `#`: external forces |
        tension_fair | linear_spring | 13:52 | the line is a linear spring | EA = k L
        tension_fair | omit_contact | 13:52 | no contact with the seabed (omit_contact), but 134.7 | remove
        repeat 240 120 | repeat 240 x | 17:12 | an angle of `repeat` (degrees) must be a number, found `x` |
        902.2 | 90.22 | 13:1 | line 1 is too short | copies that `repeat` makes
        0.09  | -0.09  | 4:1 | the diameter of line type 1 is -0.09 m |
        ",
    );
    let angles = "1 ".repeat(1100);
    let many = changed(MAP, "240 120", &angles);
    let error = map(&many, &SITE).expect_err("too many").to_string();
    error.says("2202 nodes or lines with the copies of `repeat` are more than the limit of 2000");
}
