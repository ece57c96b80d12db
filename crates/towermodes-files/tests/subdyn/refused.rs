//! What no file of SubDyn can have, with its place and what would be right.

use towermodes_files::ReadError;
use towermodes_testing::{Says, line_and_column, rows};

use super::texts::{deck, read, read_with};

/// The mistake, its line and its column.
fn mistake(error: &ReadError) -> (String, usize, usize) {
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = error
    else {
        panic!("{error}");
    };
    let (line, column) = mistakes[0].line_and_column(&source_file.text);
    (mistakes[0].to_string(), line, column)
}

/// A table, its rows, the row and column of the mistake (from 1), what it says.
#[test]
fn wrong_rows_are_refused_with_their_place() {
    for [table, changed, place, said] in rows(
        r#"
        # References between tables.
        NMembers | 1 1 2 1 1 1c 0\n2 2 7 1 1 1c 0 | 2:5 | there is no joint `7` (the table has 3 rows, with numbers from 1 to 3)
        NMembers | 1 1 2 1 1 1c 0\n2 2 3 1 5 1c 0 | 2:9 | there is no circular section `5` (the only number in the table is 1)
        NMembers | 1 1 2 1 1 1c 0\n2 2 3 1 1 1r 0 | 2:7 | there is no rectangular section `1` (its table has no rows)
        NReact   | 9 1 1 1 1 1 1 | 1:1 | there is no joint `9`
        NInterf  | 9 1 1 1 1 1 1 | 1:1 | there is no joint `9`
        NCmass   | 9 1 1 1 1 | 1:1 | there is no joint `9`
        # Numbers that stand twice.
        NJoints  | 1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 0\n2 0 0 0 1 0 0 0 0 | 3:1 | joint 2 occurs 2 times
        NMembers | 1 1 2 1 1 1c 0\n1 2 3 1 1 1c 0 | 2:1 | member 1 occurs 2 times
        NInterf  | 3 1 1 1 1 1 1\n3 1 1 1 1 1 1 | 2:1 | the interface joint occurs 2 times
        NReact   | 1 1 1 1 1 1 1\n1 1 1 1 1 1 1 | 2:1 | the joint is supported twice
        # Columns.
        NJoints  | 1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1\n3 0 0 0 1 0 0 0 0 | 2:1 | 5 numbers instead of 4 or 9
        NReact   | 1 1 1 1 | 1:1 | 4 numbers instead of 7
        NJoints  | 1 0 0 -20 1 0 0 0 0\n2 0 NaN -10 1 0 0 0 0\n3 0 0 0 1 0 0 0 0 | 2:5 | a value in row 2 of STRUCTURE JOINTS is NaN, not a finite number
        NInterf  | 3 1 1 1 1 | 1:1 | 5 numbers instead of 7 or 8
        NCmass   | 2 8e3 1e4 | 1:1 | JMYY in row 1 of JOINT ADDITIONAL CONCENTRATED MASSES is missing
        NPropSetsCyl | 1 2.1e11 8.08e10 7850 2.0 | 1:1 | XsecT in row 1 of CIRCULAR BEAM CROSS-SECTION PROPERTIES is missing
        NPropSetsCyl | 1 2.1e11 8.08e10 steel 2.0 0.03 | 1:18 | MatDens in row 1 of CIRCULAR BEAM CROSS-SECTION PROPERTIES must be a number, found `steel`
        NPropSetsCyl | 1 2.1e11 8.08e10 7850 2,0 0.03 | 1:25 | the number ends at the comma
        # Flags and types.
        NReact   | 1 1 1 2 1 1 1 | 1:7 | RctTDZss in row 1 of BASE REACTION JOINTS is 2, but must be 1 (held) or 0 (free)
        NInterf  | 3 1 1 1 1 0 1 | 1:11 | ItfRDYss is 0, but an interface joint must follow
        NJoints  | 1 0 0 -20 1 0 0 0 0\n2 0 0 -10 7 0 0 0 0\n3 0 0 0 1 0 0 0 0 | 2:11 | JointType is 7, but must be 1 (cantilever), 2 (universal), 3 (pin) or 4 (ball)
        NJoints  | 1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 5\n3 0 0 0 1 0 0 0 0 | 2:19 | cantilever joint, which does not rotate
        NMembers | 1 1 2 1 1 1c 0\n2 2 3 1 1 6 0 | 2:11 | MType must be 1c (circular beam)
        # Unlike ends.
        NPropSetsCyl | 1 2.1e11 8.08e10 7850 2.0 0.03\n2 2.1e11 8.08e10 7800 2.0 0.03 | - | MatDens is 7.85e3 at one end and 7.8e3 at the other
        NPropSetsCyl | 1 2.1e11 8.08e10 7850 2.0 0.03\n2 2.1e11 8.08e10 7850 2.0 0 | - | solid (XsecT 0) at one end and hollow at the other
        # What the checks of the library find.
        NPropSetsCyl | 1 2.1e11 8.08e10 7850 2.0 1.1 | - | member 1: wall 1.1 m is more than half of the 2 m wide section
        NPropSetsCyl | 1 2.1e11 0 7850 2.0 0.03 | - | member 1: shear modulus is 0 Pa; it must be positive
        NMembers | 1 1 2 1 1 1c 0\n2 2 2 1 1 1c 0 | 2:1 | member 2: its joints are 0 m apart
        NMembers | 1 1 2 1 1 1c 0 | - | joint 3: no member ends at this joint
        NInterf  | 1 1 1 1 1 1 1 | 1:1 | joint 1 is supported and belongs to the transition piece
        NJoints  | 1 0 0 -20 1 0 0 0 0\n2 0 0 -10 3 0 0 0 0\n3 0 0 0 1 0 0 0 0 | 2:1 | the axis of the pin is zero
        "#,
    ) {
        let members = ("NMembers", "1 1 2 1 2 1c 0\n2 2 3 1 1 1c 0");
        let two = changed.matches("\n2 2.1e11").count() == 1;
        let changes = if two {
            vec![(table, changed), members]
        } else {
            vec![(table, changed)]
        };
        let text = deck(&changes);
        let error = read(&text).expect_err(changed);
        let (message, line, column) = mistake(&error);
        message.says(said);
        if place != "-" {
            let (row, expected) = line_and_column(place);
            let table = text
                .lines()
                .position(|line| line.contains(&format!(" {table} ")))
                .expect("a table");
            assert_eq!(
                (line, column),
                (table + 3 + row, expected),
                "{changed}: {message}"
            );
        }
    }
}

/// A part of the file, what stands there instead, the mistake and its line.
#[test]
fn wrong_tables_are_refused_with_their_line() {
    for [from, to, line, said] in rows(
        r#"
        3 FEMMod  | 2 FEMMod | 7 | FEMMod is 2, but must be 1 (Euler-Bernoulli) or 3 (Timoshenko)
        4 NDiv    | 0 NDiv   | 8 | NDiv is 0, but must be from 1 to 1000
        4 NDiv    | 4 Div    | 1 | the file has no `NDiv`
        3 NJoints | 4 NJoints | 18 | expected row 4 of STRUCTURE JOINTS here, found `------- BASE REACTION JOINTS -------` (NJoints is 4, but there are 3 rows above)
        3 NJoints | 2 NJoints | 17 | expected the heading of the table after STRUCTURE JOINTS here
        3 NJoints | many NJoints | 1 | the table STRUCTURE JOINTS is missing
        3 NJoints | -3 NJoints | 12 | the number of rows of STRUCTURE JOINTS is -3, but must be from 0 to 100000
        3 NJoints | 3e9 NJoints | 12 | must be a whole number
        ------- INTERFACE JOINTS -------\n | ␣ | 23 | expected the heading of the table after BASE REACTION JOINTS here
        JointID JointXss JointYss JointZss JointType JointDirX JointDirY JointDirZ JointStiff\n | ␣ | 14 | expected the units of the columns of STRUCTURE JOINTS here
        "#,
    ) {
        let text = deck(&[]).replacen(from, to, 1);
        let error = read(&text).expect_err(from);
        let (message, found, _) = mistake(&error);
        message.says(said);
        assert_eq!(found.to_string(), line, "{from}: {message}");
    }
    let cut = deck(&[]);
    let cut = &cut[..cut.find("\n2 0 0 -10").expect("a row")];
    mistake(&read(cut).expect_err("an end"))
        .0
        .says("the file ends where row 2 of STRUCTURE JOINTS is expected");
    mistake(&read("").expect_err("nothing"))
        .0
        .says("the file has no `FEMMod`");
}

#[test]
fn more_than_one_transition_piece_is_refused() {
    let joints = "1 0 0 -20 1 0 0 0 0\n2 0 0 -10 1 0 0 0 0\n3 0 0 0 1 0 0 0 0\n4 0 5 0 1 0 0 0 0";
    let members = "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0\n3 2 4 1 1 1c 0";
    let tables = [("NJoints", joints), ("NMembers", members)];
    let with = |interfaces| deck(&[&tables[..], &[("NInterf", interfaces)]].concat());
    let error = read(&with("3 1 1 1 1 1 1 1\n4 2 1 1 1 1 1 1")).expect_err("two");
    mistake(&error)
        .0
        .says("more than one transition piece (TPID 1 and 2): only one can be solved");
    assert!(read(&with("3 1 1 1 1 1 1 1\n4 1 1 1 1 1 1 1")).is_ok());
    // The interface joints of one piece, but connected by a link too.
    let linked = [
        (
            "NMembers",
            "1 1 2 1 1 1c 0\n2 2 3 1 1 1c 0\n3 2 4 1 1 1c 0\n4 3 4 1 1 3 -1",
        ),
        ("NRigidPropSets", "1 0"),
        ("NInterf", "3\n4"),
        ("NJoints", joints),
    ];
    let error = read(&deck(&linked)).expect_err("linked");
    let (message, ..) = mistake(&error);
    message.says("rigid links connect the interface joints 3 and 4");
}

#[test]
fn wrong_soil_is_refused_in_its_own_file() {
    let text = deck(&[("NReact", "1 0 0 0 0 0 0 \"ssi.txt\"")]);
    for [soil, line, said] in rows(
        r#"
        1e7 Kxx\n1e7 Kqq | 2 | there is no entry of the soil matrices `Kqq`
        1e7 Kxx\n1e7 kXX | 2 | the entry kXX occurs 2 times
        1e7 Kxy\n1e7 Kyx | 2 | the entry Kyx occurs 2 times
        3e6 Kxy\n5e6 Kyx | 2 | Kyx is 5000000, but Kxy is 3000000 in ssi.txt:1: the matrix must be symmetric
        5e6 Kyx\n3e6 Kxy | 2 | Kxy is 3000000, but Kyx is 5000000 in ssi.txt:1: the matrix must be symmetric
        1e7 Kxx\n5e6 Kyx | 2 | there is no entry of the soil matrices `Kyx`
        1e7 Kxx\n-1e7 Kyy | 2 | Kyy is -10000000, but must be 0 or positive
        1e3 Mxx\n-1e3 Myy | 2 | Myy is -1000, but must be 0 or positive
        1e7 Kxx\n4e9 Ktyty\n-3e8 Kxty | 3 | Kxty is -300000000, but Kxx is 10000000 (ssi.txt:1) and Ktyty is 4000000000 (ssi.txt:2): the square
        1e7 Kxx\n-3e8 Kxty | 2 | Kxty is -300000000, but Kxx is 10000000 (ssi.txt:1) and Ktyty is not given
        1e7 Ktyx         | 1 | there is no entry of the soil matrices `Ktyx`
        ! K\nKxx 1e7     | 2 | an entry of the soil matrices must be a number, found `Kxx`
        1e7              | 1 | the name of the entry, such as Kxx or Mxty, is missing
        "#,
    ) {
        let error = read_with(&text, soil).expect_err(soil);
        error.to_string().begins("ssi.txt:");
        let (message, found, _) = mistake(&error);
        message.says(said);
        assert_eq!(found.to_string(), line, "{soil}");
    }
    let missing = text.replace("ssi.txt", "other.txt");
    mistake(&read(&missing).expect_err("no file"))
        .0
        .says("SSIfile cannot be read: other.txt: no such file");
}
