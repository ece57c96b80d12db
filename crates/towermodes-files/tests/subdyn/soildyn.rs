//! Files of SoilDyn: the stiffness at a point is that of an SSI file, and what is refused.

use towermodes::frame::{FrameOptions, solve_frame};
use towermodes_files::{Interface, ReadError, SoildynInput, Source, SubdynInput, read_soildyn};
use towermodes_testing::Says;

use super::texts::{SOIL, deck, input, read_with};

/// The matrix of the file `ssi.txt` without its masses.
const MATRIX: &str = "\
5.04E+07 3.10E+05 0 0 -1.98E+08 0
3.10E+05 5.60E+07 0 2.00E+08 0 0
0 0 2.54E+08 0 0 0
0 2.00E+08 0 1.30E+09 0 0
-1.98E+08 0 0 0 1.35E+09 0
0 0 0 0 0 7.00E+08
";

fn soildyn(option: &str, location: &str, matrix: &str) -> String {
    let zeros = "0 0 0 0 0 0\n".repeat(6);
    format!(
        "------- SoilDyn INPUT FILE -------\nsand\n-------\nFalse Echo - echo\n\"default\" DT - step\n\
        {option} CalcOption - model\n==== Stiffness [CalcOption 1] ====\n{location} - location\n\
        ---- Stiffness matrix ----\n{matrix}---- Damping ratio ----\n{zeros}\
        ==== P-Y curves [CalcOption 2] ====\n0 PY_NumPoints\n"
    )
}

fn read(text: &str) -> Result<SoildynInput, ReadError> {
    read_soildyn(Source {
        name: "SoilDyn.dat".to_owned(),
        text: text.to_owned(),
    })
}

/// A file for the lowest joint of the tubes.
pub fn sand() -> String {
    soildyn("1", "0 0.05 -20", MATRIX)
}

/// Two tubes whose lower end is free but for soil.
fn free() -> SubdynInput {
    input(&[("NReact", "1 0 0 0 0 0 0 \"\"")])
}

#[test]
fn a_matrix_is_that_of_an_ssi_file() {
    let mut stands = free();
    let soil = read(&sand()).expect("soil");
    stands.stand_on(&soil).expect("a joint");
    let without_mass: Vec<&str> = SOIL.lines().filter(|line| !line.contains('M')).collect();
    let with_file = deck(&[("NReact", "1 0 0 0 0 0 0 \"ssi.txt\"")]);
    let with_file = read_with(&with_file, &without_mass.join("\n")).expect("a file");
    let frequencies = [stands, with_file].map(|input| {
        let frame = input.frame(Interface::Free).expect("a frame");
        let solution = solve_frame(&frame, &FrameOptions::default()).expect("modes");
        let modes = solution.modes.iter().map(|mode| mode.frequency_hz);
        modes.collect::<Vec<_>>()
    });
    assert!(frequencies[0][0] > 1.0);
    assert_eq!(frequencies[0], frequencies[1]);
}

/// The file of SubDyn alone says that nothing holds the joint; with soil it is held.
#[test]
fn soil_takes_back_the_note_on_a_loose_joint() {
    let is_loose = |input: &SubdynInput| {
        let mut notes = input.notes.iter().map(ToString::to_string);
        notes.any(|note| note.contains("this joint has no support"))
    };
    let mut stands = free();
    assert!(is_loose(&stands));
    let soil = read(&sand()).expect("soil");
    stands.stand_on(&soil).expect("a joint");
    assert!(!is_loose(&stands));
}

#[test]
fn soil_without_a_matrix_or_a_joint_is_refused() {
    let skew = MATRIX.replacen("3.10E+05", "4.10E+05", 1);
    let rows = [
        (soildyn("2", "0 0 -20", MATRIX), 6, "P-Y curves"),
        (soildyn("3", "0 0 -20", MATRIX), 6, "inside a DLL"),
        (soildyn("4", "0 0 -20", MATRIX), 6, "must be 1"),
        (soildyn("1", "0 0", MATRIX), 8, "2 numbers"),
        (soildyn("1", "0 0 -20", &skew), 10, "symmetric"),
        (soildyn("1", "0 0 -20", "1 2 3 x 5 6\n"), 10, "3 numbers"),
        (
            soildyn("1", "0 0 -20.2", MATRIX),
            8,
            "the nearest one, 1, is 0.200 m away",
        ),
        ("title".to_owned(), 1, "no input file of SoilDyn"),
    ];
    for (text, line, message) in rows {
        let refused = read(&text).and_then(|soil| free().stand_on(&soil));
        let Err(ReadError::Mistakes {
            source_file,
            mistakes,
        }) = refused
        else {
            panic!("not refused: {message}");
        };
        assert_eq!(
            mistakes[0].line_and_column(&source_file.text).0,
            line,
            "{message}"
        );
        mistakes[0].message().says(message);
    }
    let soil = read(&soildyn("1", "0 0 -20", MATRIX)).expect("soil");
    let held = input(&[])
        .stand_on(&soil)
        .expect_err("a joint that is held");
    held.to_string().says("holds all motions of joint 1");
}
