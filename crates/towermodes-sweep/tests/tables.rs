//! Tables: what is read, and every mistake at its place.

use std::fs;
use std::path::PathBuf;

use towermodes_sweep::{Table, TableProblem};
use towermodes_testing::{Says, rows};

use crate::towers::{Folder, tower};

fn opened(text: &[u8], ignore: &[&str]) -> Result<(Folder, Table), String> {
    let folder = Folder::new();
    let path = folder.path("towers.csv");
    fs::write(&path, text).expect("a file");
    let ignore: Vec<String> = ignore.iter().map(ToString::to_string).collect();
    let table = Table::open(&path, &tower(4e7), &ignore).map_err(|error| {
        let sentence = error.to_string();
        let without = sentence.strip_prefix(&format!("{}: ", path.display()));
        without.expect("the name of the file first").to_owned()
    })?;
    Ok((folder, table))
}

fn values(text: &str) -> Vec<f64> {
    let (_folder, table) = opened(text.as_bytes(), &[]).expect("a table");
    table.read(0..table.rows()).expect("values")
}

fn refused(text: &str) -> String {
    opened(text.as_bytes(), &[])
        .map(|(_, table)| table)
        .expect_err("refused")
}

const MASS_AND_WALL: [f64; 4] = [3.3e5, 1.02, 3.4e5, 0.98];

#[test]
fn every_dialect_gives_the_same_values() {
    for text in [
        "rna.mass,scale(stations[*].wall)\n3.3e5,1.02\n340000,0.98\n",
        "rna.mass,scale(stations[*].wall)\r\n3.3e5,1.02\r\n340000,0.98\r\n",
        "\u{feff}rna.mass; scale(stations[*].wall)\n3.3e5; 1.02\n340000; .98",
        "rna.mass\tscale(stations[*].wall)\n3.3e5\t1.02\n+340000\t0.98\n\n\n",
        "\"rna.mass\",\"scale(stations[*].wall)\"\n\"3.3e5\",\"1.02\"\n\"340000\",\"0.98\"\n",
        "rna.mass,#note,scale(stations[*].wall)\n3.3e5,\"a, b\nc\",1.02\n340000,,0.98\n",
        "rna.mass,scale(stations[*].wall)\r3.3e5,1.02\r340000,0.98\r",
        "\u{feff}\"rna.mass\",#note,scale(stations[*].wall)\n3.3e5,\"a\n\n\nb\",1.02\n340000,5\" pipe,0.98\n",
        "rna.mass,#note,scale(stations[*].wall)\n3.3e5,\"a \"\"b\"\"\",1.02\n340000,\"\",0.98\n",
    ] {
        assert_eq!(values(text), MASS_AND_WALL, "{text}");
    }
}

/// A quotation mark that is closed thousands of rows below would take them for the text of a cell.
#[test]
fn a_stray_quotation_mark_does_not_take_rows_away() {
    let mut text = String::from("rna.mass,#site\n350000,a\n360000,\"north\n");
    for row in 0..100_000 {
        text += &format!("{row},x\n");
    }
    text += "370000,south\"\n";
    let expected = "line 3: a cell begins with a quotation mark that is not closed";
    refused(&text).begins(expected);
    // 80 MB of text in a cell are not read into the memory.
    let large = format!("rna.mass,#site\n1,\"{}\"\n", "x".repeat(80 << 20));
    refused(&large).begins("line 2 is longer than 64 MiB");
    // A mistake above is found first.
    let above = text.replacen("350000", "wrong", 1);
    refused(&above).begins("line 2");
}

#[test]
fn any_range_of_rows_is_read() {
    let mut text = String::from("rna.mass,#name,stations[1].wall\n");
    for row in 0..5000 {
        text += &format!("{row},x,{}\n", 0.5 * f64::from(row));
    }
    let (_folder, table) = opened(text.as_bytes(), &[]).expect("a table");
    assert_eq!(table.rows(), 5000);
    for (first, end) in [
        (0, 1),
        (0, 5000),
        (1023, 1025),
        (1024, 1024),
        (2048, 4097),
        (4999, 5000),
    ] {
        let values = table.read(first..end).expect("values");
        let expected = (first..end).flat_map(|row| [row as f64, 0.5 * row as f64]);
        assert_eq!(values, expected.collect::<Vec<f64>>(), "{first} {end}");
    }
}

#[test]
fn mistakes_are_shown_with_line_and_column_and_what_is_right() {
    let unknown = "unknown input name `rna.mas`; did you mean `rna.mass`?";
    let table = r#"
        | has no columns;␣
        \n\n | has no columns;␣
        rna.mass\n | has no rows below the names of its columns
        3.5e5,1\n | the first line begins with the number `3.5e5`; it must name the input values
        row,rna.mass\n1,2\n | column 1: unknown input name `row`
        rna.mass,a,b,c\n1,2,3,4\n | column 2: unknown input name `a`
        rna.mass,\n1,2\n | column 2 has no name
        rna.mass,rna.mass\n1,2\n | columns 1 and 2 have the same name `rna.mass`
        stations[*].wall,stations[1].wall\n1,2\n | `stations[1].wall` sets stations[1].wall
        #a,#b\n1,2\n | all columns are skipped
        rna.mass,stations[1].wall\nkg,m\n3e5,0.02\n | line 2 contains no number, only text such as `kg`; if these are units
        rna.mass,stations[1].wall\n3e5,0.02\n3e5,\n | line 3, column `stations[1].wall`: the cell is empty
        rna.mass\n3e5\nabc\n | line 3, column `rna.mass`: `abc` is not a number
        rna.mass\n3e5\nNaN\n | line 3, column `rna.mass`: the value is NaN; it must be a finite number
        rna.mass\n3e5\n-inf\n | line 3, column `rna.mass`: the value is -inf
        rna.mass\n1e999\n | line 2, column `rna.mass`: the value is inf
        rna.mass;stations[1].wall\n3e5;0,02\n | line 2, column `stations[1].wall`: `0,02` has a decimal comma; write `0.02`
        rna.mass;stations[1].wall\n350,000;0.02\n | line 2, column `rna.mass`: `350,000` has a comma; write `350000` if it separates thousands, `350.000` if it is a decimal comma
        rna.mass,stations[1].wall\n3e5\n | line 2 has 1 cells, but the first line has 2
        rna.mass\n3e5,2\n | line 2 has 2 cells, but the first line has 1
        rna.mass\n3e5\n\n3e5\n | line 3 is empty
        rna.mass\r\n3e5\r\n\r\n\r\n3e5\r\n | line 3 is empty
        rna.mass\n3e5\n\n3e5\nabc\n | line 3 is empty
        \nrna.mass\n3e5\n | line 1 is empty
        rna.mass\n3e5\nabc\n\n3e5\n | line 3, column `rna.mass`
        rna.mass,#site\n3e5,"a\r\rb"\n\n3e5,c\n | line 5 is empty
        rna.mass,#site\n350000,"north\n360000,b\n370000,c\n | line 2: a cell begins with a quotation mark that is not closed in the next 100 lines; close it or remove it
        #n,rna.mass\n"a\nb",3e5\nc,x\n | line 4, column `rna.mass`: `x` is not a number
        add(stations[0].height, stations[1].height)\n1\n | column 1: `add(stations[0].height` is not a change
    "#;
    let format = "is an Arrow file, not a table in CSV or Parquet; save it as Parquet";
    let others = [
        ("rna.mas,rna.mass\n1,2\n", &*format!("column 1: {unknown}")),
        (
            "\u{feff}\"rna.mass\n3e5\n",
            "line 1: a cell begins with a quotation mark",
        ),
        ("ARROW1\0\0", format),
        ("PK\u{3}\u{4}", "is a spreadsheet or a ZIP archive"),
    ];
    for (text, expected) in rows(table)
        .map(|[text, expected]| (text, expected))
        .chain(others)
    {
        refused(text).begins(expected);
    }
}

#[test]
fn columns_are_left_out_by_name() {
    let text = b"row,rna.mass,fore_aft_1_hz\n7,3e5,0.3\n";
    let (_folder, table) = opened(text, &["row", "fore_aft_1_hz"]).expect("a table");
    assert_eq!(table.changes().len(), 1);
    assert_eq!(table.read(0..1).expect("values"), [3e5]);
    let sentence = opened(text, &["rows"]).map(|_| ()).expect_err("refused");
    sentence.begins("has no column `rows` to ignore; its columns are `row`, `rna.mass`");
    let sentence = opened(text, &["row"]).map(|_| ()).expect_err("refused");
    sentence.begins("column 3: unknown input name `fore_aft_1_hz`");
}

#[test]
fn a_million_columns_are_refused_with_their_number() {
    let mut text: String = (0..1_000_000).map(|i| format!("c{i},")).collect();
    text.push_str("rna.mass\n");
    refused(&text).begins("has 1000001 columns; the limit is 10000");
    let several: String = (0..9000).map(|i| format!("c{i},")).collect();
    refused(&format!("{several}rna.mass\n")).says("8999 other columns are not either");
}

#[test]
fn what_is_no_file_is_refused() {
    let folder = Folder::new();
    let open = |path: PathBuf| Table::open(&path, &tower(4e7), &[]).expect_err("refused");
    let missing = open(folder.path("none.csv"));
    assert!(matches!(*missing.problem, TableProblem::Io(_)));
    missing.says("none.csv");
    let is_a_folder = open(folder.path("."));
    assert!(matches!(
        *is_a_folder.problem,
        TableProblem::NotAFile | TableProblem::Io(_)
    ));
    #[cfg(target_os = "linux")]
    {
        let endless = open(PathBuf::from("/dev/zero"));
        assert!(matches!(*endless.problem, TableProblem::NotAFile));
        // A pipe to which nobody writes.
        let pipe = folder.path("pipe");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        if made.is_ok_and(|status| status.success()) {
            assert!(matches!(*open(pipe).problem, TableProblem::NotAFile));
        }
    }
}

#[test]
fn names_that_are_not_text_are_refused() {
    let sentence = opened(b"rna.mass,\xff\xfe\n1,2\n", &[])
        .map(|_| ())
        .expect_err("refused");
    sentence.begins("the names of the columns are not UTF-8");
}

/// A table that another program writes while the sweep runs.
#[test]
fn a_table_that_changes_is_noticed() {
    let (folder, table) = opened(b"rna.mass\n3e5\n", &[]).expect("a table");
    fs::write(folder.path("towers.csv"), "rna.mass\n4e5\n3e5\n").expect("a file");
    let error = table.read(0..1).expect_err("changed");
    assert!(matches!(*error.problem, TableProblem::Changed), "{error}");
}

/// SHA-256 of the bytes by `sha256sum`.
#[test]
fn the_digest_is_that_of_the_file() {
    let (_folder, table) = opened(b"rna.mass\n350000\n", &[]).expect("a table");
    let expected = "83c07e714d7b4dcac80cd2352949369069cb0febdb9d48ad9245f10b0db57ae0";
    assert_eq!(table.digest(), expected);
}
