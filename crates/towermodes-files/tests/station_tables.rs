//! Stations from tables in CSV: the same towers as in TOML, in any unit and any dialect of
//! spreadsheets, and every mistake at its place.

use crate::sources::source;
use towermodes_testing::{Says, line_and_column, rows, words};

use towermodes::{Station, TowerDescription};
use towermodes_files::{
    InMemory, Input, ReadError, ReadOptions, SiblingFiles, TowerInput, description_from_toml, read,
    read_source, tower_from_toml, write_toml,
};

/// A tower file whose stations are in a table.
const TOWER: &str = r#"
[material]
density = 8500.0
youngs_modulus = 2.1e11
shear_modulus = 8.08e10
[materials.concrete]
density = 2500.0
youngs_modulus = 3.6e10
poissons_ratio = 0.2
[tower]
stations = "cans.csv"
outfitting_factor = 1.02
"#;

/// Two cans of concrete and two of steel, with a step in wall and material and one in diameter.
const CANS: &str = "\
bottom_m,top_m,bottom diameter [mm],top diameter [mm],wall [mm],material
0,20.5,9000,8500,500,concrete
20.5,40,8500,7500,400,concrete
40,70,6000,5000,30,
70,95,5000,3870,24.7,
";

/// The stations of the same.
const STATIONS: &str = r#"[
  [0.0, 9.0, 0.5, "concrete"],
  [20.5, 8.5, 0.5, "concrete"],
  [20.5, 8.5, 0.4, "concrete"],
  [40.0, 7.5, 0.4, "concrete"],
  [40.0, 6.0, 0.03],
  [70.0, 5.0, 0.03],
  [70.0, 5.0, 0.0247],
  [95.0, 3.87, 0.0247],
]"#;

fn read_with(tower: &str, table: &str) -> Result<TowerInput, ReadError> {
    let source = source("tower.toml", tower);
    let files = [("cans.csv".to_owned(), table.to_owned())].into();
    let read = read_source(source, &InMemory { files }, &ReadOptions::default())?;
    match read {
        Input::Tower(tower) => Ok(*tower),
        Input::Blade(_) | Input::Substructure(_) | Input::Mooring(_) => panic!("no tower"),
    }
}

#[track_caller]
fn description(table: &str) -> TowerDescription {
    match read_with(TOWER, table) {
        Ok(input) => input.description,
        Err(error) => panic!("{error}"),
    }
}

fn expected() -> TowerDescription {
    let text = TOWER.replace("\"cans.csv\"", STATIONS);
    description_from_toml(&text).expect("the test's own tower")
}

/// The file that is wrong, and each mistake with its line, column and words.
#[track_caller]
fn mistakes(tower: &str, table: &str) -> (String, Vec<(usize, usize, String)>) {
    let refused = read_with(tower, table).and_then(|input| input.tower());
    let ReadError::Mistakes {
        source_file,
        mistakes,
    } = refused.expect_err("no tower")
    else {
        panic!("no mistake in a file");
    };
    let placed = mistakes.iter().map(|mistake| {
        assert!(source_file.text.get(mistake.span.clone()).is_some());
        let (line, column) = mistake.line_and_column(&source_file.text);
        (line, column, mistake.to_string())
    });
    (source_file.name.clone(), placed.collect())
}

/// Expects the only mistake of a table at line:column with these words.
#[track_caller]
fn refused(table: &str, place: (usize, usize), words: &[&str]) {
    let (file, mistakes) = mistakes(TOWER, table);
    assert_eq!(file, "cans.csv");
    assert_eq!(mistakes.len(), 1, "{mistakes:?}");
    let (line, column, said) = &mistakes[0];
    assert_eq!((*line, *column), place, "{said}");
    for word in words {
        assert!(said.contains(word), "no `{word}` in: {said}");
    }
}

/// The same of the table of cans with a change.
#[track_caller]
fn refused_with(old: &str, new: &str, place: (usize, usize), words: &[&str]) {
    assert_eq!(CANS.matches(old).count(), 1, "{old}");
    refused(&CANS.replace(old, new), place, words);
}

/// Mistakes one after the other: what is replaced, by what, place, words.
fn all_refused_with(table: &str) {
    for [old, new, place, said] in rows(table) {
        refused_with(old, new, line_and_column(place), &words(said));
    }
}

#[test]
fn cans_are_the_stations_at_their_ends() {
    assert_eq!(description(CANS), expected());
    let input = read_with(TOWER, CANS).expect("a tower");
    let found = input.files().collect::<Vec<_>>();
    assert_eq!(found, ["tower.toml", "cans.csv"]);
    assert!(input.tower().is_ok());
}

#[test]
fn a_table_of_stations_is_read_row_by_row() {
    let rows = "height [m],diameter [m],wall [mm],material
0,9,500,concrete
20.5,8.5,500,concrete
20.5,8.5,400,concrete
40,7.5,400,concrete
40,6,30,
70,5,30,
70,5,24.7,
95,3.87,24.7,
";
    assert_eq!(description(rows), expected());
}

#[test]
fn spreadsheets_write_the_same_table_in_many_ways() {
    let semicolons = CANS.replace(',', ";");
    let decimal_commas = semicolons.replace('.', ",");
    let quoted: String = CANS
        .lines()
        .map(|line| format!("\"{}\"\n", line.replace(',', "\",\"")))
        .collect();
    let mut lines: Vec<&str> = CANS.lines().collect();
    lines[1..].reverse();
    let from_the_top = lines.join("\n");
    for table in [
        semicolons.clone(),
        decimal_commas.clone(),
        decimal_commas.replace(';', "\t"),
        format!("sep=;\r\n{}", decimal_commas.replace('\n', "\r\n")),
        format!("\u{feff}{}", CANS.replace('\n', "\r\n")),
        quoted,
        from_the_top,
        CANS.trim_end().to_owned(),
        CANS.replace(',', " , "),
        format!("# made by hand\n\n{CANS}\n,,,,,\n# end\n"),
        CANS.replace("\n", ",\n"),
        CANS.replace("bottom_m,top_m", "From [m],to (m)")
            .replace("wall [mm]", "t / mm"),
        CANS.replace("\n0,", "\n0.0,").replace("9000", "9e3"),
    ] {
        assert_eq!(description(&table), expected(), "{table}");
    }
}

#[test]
fn units_are_those_of_the_header() {
    let one = |header: &str, row: &str| -> Station {
        let text = TOWER.replace("outfitting_factor = 1.02", "");
        let input = read_with(&text, &format!("{header}\n{row}\n"));
        input.expect("a tower").description.stations[1]
    };
    let words = "bottom [m],top [m],diameter [m],wall [m]";
    let metres = one(words, "0,30.48,6.096,0.0254");
    assert_eq!((metres.height_m, metres.outer_diameter_m), (30.48, 6.096));
    let table = r#"
        bottom [mm],top [mm],diameter [mm],wall [mm] | 0,30480,6096,25.4
        bottom_cm,top_cm,od_cm,wall_cm | 0,3048,609.6,2.54
        bottom (ft),top (ft),diameter (ft),wall (in) | 0,100,20,1
        "#;
    for [header, row] in rows(table) {
        let found = one(header, row);
        for (found, metres) in [
            (found.height_m, metres.height_m),
            (found.outer_diameter_m, metres.outer_diameter_m),
            (found.wall_thickness_m, metres.wall_thickness_m),
        ] {
            // The last digit of a product.
            let holds = (found - metres).abs() <= 2.0 * f64::EPSILON * metres;
            assert!(holds, "{header}: {found}");
        }
    }
}

#[test]
fn remarks_are_not_read() {
    let table = CANS
        .replace("bottom_m", "can no,bottom_m")
        .replace("material\n", "material,Remark\n");
    let mut lines = table.lines();
    let header = lines.next().expect("a header").to_owned();
    let rows = lines
        .enumerate()
        .map(|(i, row)| format!("\nC{i},{row},\"painted, twice\""));
    let table: String = std::iter::once(header).chain(rows).collect();
    assert_eq!(description(&table), expected());
}

#[test]
fn converted_towers_have_the_numbers_themselves() {
    let (text, notes) = write_toml(&description(CANS));
    assert!(notes.is_empty(), "{notes:?}");
    assert!(!text.contains("csv"));
    let found = description_from_toml(&text).expect("a tower");
    assert_eq!(found, description(CANS));
}

#[test]
fn headers_that_say_too_little_or_too_much_are_refused() {
    all_refused_with(
        r#"
        wall [mm] | wall | 1:55 | the unit of the wall is missing & `wall [mm]` or `wall_m`
        wall [mm] | wall [kN] | 1:55 | there is no unit of length `kn` & m, cm, mm, ft and in
        wall [mm] | wal [mm] | 1:55 | expected a column of cans or stations here, found `wal [mm]` & did you mean `wall`?
        top diameter [mm] | inner diameter [mm] | 1:37 | expected a column & give the outer diameter
        top diameter [mm] | ID [mm] | 1:37 | expected a column & give the outer diameter
        material\n | mass [t]\n | 1:65 | expected a column of cans or stations here, found `mass [t]` & columns are
        top diameter [mm] | bottom diameter [m] | 1:37 | the column bottom diameter occurs 2 times
        top diameter [mm] | remark | 1:1 | the column top diameter is missing & for cans
        bottom_m | height_m | 1:1 | both a height and
        bottom diameter | diameter | 1:1 | both a diameter and
        "#,
    );
    let bare: String = CANS
        .lines()
        .skip(3)
        .map(|line| format!("{line}\n"))
        .collect();
    let bare = bare.replace(",\n", "\n");
    refused(
        &bare,
        (1, 1),
        &[
            "expected a header with names of columns here, found numbers",
            "write a header such as",
        ],
    );
    let foreign = CANS.lines().skip(1).fold(
        String::from("unten [m],oben [m],D unten [mm],D oben [mm],Wand [mm],Stahl"),
        |text, line| text + "\n" + line,
    );
    let (_, mistakes) = mistakes(TOWER, &foreign);
    assert_eq!(mistakes.len(), 1, "{mistakes:?}");
    let words = [
        "expected a header with English names of columns here, found none that is known",
        "write a header such as",
    ];
    refused(&foreign, (1, 1), &words);
    refused("", (1, 1), &["the file is empty"]);
    refused("\n# nothing\n", (1, 1), &["the file is empty"]);
    let header = CANS.lines().next().expect("a header");
    refused(header, (1, 73), &["a row after the header is expected"]);
}

#[test]
fn cells_that_are_no_numbers_are_refused() {
    all_refused_with(
        r#"
        ,8500,500,concrete |  | 2:1 | the row has 3 cells instead of 6
        8500,500,concrete | 8500,,concrete | 2:18 | wall is missing
        8500,500 | 8500,500mm | 2:18 | wall must be a number, found `500mm` & unit in the header
        8500,500 | 8500,nan | 2:18 | wall is NaN, not a finite number
        8500,500 | 8500,1e999 | 2:18 | not a finite number
        8500,500 | 8500,x | 2:18 | wall must be a number, found `x`
        9000 | "9,000" | 2:8 | must be a number & semicolons
        9000 | 9,000 | 2:23 | the row has 7 cells & semicolons
        24.7, | 24.7,,7 | 5:23 | the row has 7 cells instead of 6
        9000 | "9000 | 2:8 | quotation mark is not closed
        "#,
    );
    let semicolons = CANS.replace(',', ";");
    let words = ["no separators between thousands"];
    refused(&semicolons.replace("9000", "9.000,0"), (2, 8), &words);
    refused(
        &semicolons.replace("24.7", "24,7"),
        (5, 17),
        &["`24,7` has a decimal comma, but line 2 has a decimal point"],
    );
}

#[test]
fn cans_that_do_not_join_are_refused_with_both_rows() {
    all_refused_with(
        r#"
        40,70 | 40.05,70 | 4:1 | the bottom of this can, 40.05 m & 0.05 m above & 40 m (line 3) & is a row missing?
        40,70 | 39.9,70 | 4:1 | this can, 39.9 m & 0.1 m below & (line 3) & overlap
        40,70 | 70,40 | 4:4 | top of the can is 40 m, but must be above its bottom, 70 m
        "#,
    );
    // Conversions leave a few last digits.
    let nearly = CANS.replace("\n40,70", "\n40.0000001,70");
    assert_eq!(description(&nearly), expected());
    // From the top down the upper can is the row before.
    let turned = "bottom_m,top_m,diameter_m,wall_m\n50.5,90,4,0.02\n10,50,5,0.03\n";
    let words = ["this can, 50.5 m", "0.5 m above", "50 m (line 3)"];
    refused(turned, (2, 1), &words);
}

#[test]
fn several_mistakes_are_said_together() {
    let table = CANS.replace("9000", "x").replace("24.7", "y");
    let (_, mistakes) = mistakes(TOWER, &table);
    let lines: Vec<usize> = mistakes.iter().map(|(line, ..)| *line).collect();
    assert_eq!(lines, [2, 5], "{mistakes:?}");
}

#[test]
fn materials_of_a_table_are_those_of_the_tower_file() {
    let words = ["no material `conrete`", "did you mean `concrete`?"];
    refused_with("8500,500,concrete", "8500,500,conrete", (2, 22), &words);
    let without_default = TOWER.replace("[material]", "[materials.steel]");
    let (file, mistakes) = mistakes(&without_default, CANS);
    assert_eq!(file, "cans.csv");
    let (line, _, said) = &mistakes[0];
    assert_eq!((*line, mistakes.len()), (4, 2), "{said}");
    said.says("the material of the row (the file has no [material]) is missing");
    said.says("\"concrete\" or \"steel\"");
}

#[test]
fn what_only_the_tower_shows_is_shown_in_the_table() {
    refused_with(
        "6000,5000,30",
        "6000,5000,3000",
        (4, 17),
        &[
            "outer diameter 5 m is less than twice the wall thickness 3 m",
            "the header of the column",
        ],
    );
    let falling = "height_m,diameter_m,wall_m\n0,6,0.03\n50,5,0.03\n40,4,0.02\n";
    let words = ["height 40 m is below the previous station"];
    refused(falling, (4, 1), &words);
}

#[test]
fn mistakes_of_the_tower_file_come_first() {
    let tower = TOWER.replace("density = 8500.0", "density = \"x\"");
    let (file, mistakes) = mistakes(&tower, &CANS.replace("9000", "x"));
    assert_eq!(file, "tower.toml");
    assert_eq!(mistakes[0].0, 3);
}

#[test]
fn a_table_that_cannot_be_read_is_shown_where_it_is_named() {
    let tower = TOWER.replace("cans.csv", "other.csv");
    let (file, mistakes) = mistakes(&tower, CANS);
    assert_eq!(file, "tower.toml");
    let (line, column, said) = &mistakes[0];
    assert_eq!((*line, *column), (11, 12), "{said}");
    said.says("other.csv: no such file");
    let alone = tower_from_toml(TOWER).expect_err("a text without a folder cannot refer to files");
    alone[0]
        .message()
        .says("a text without a folder cannot refer to files");
}

#[test]
fn a_table_alone_is_no_tower() {
    let source = source("cans.csv", CANS);
    let error = read_source(source, &InMemory::default(), &ReadOptions::default());
    error.expect_err("no tower").says("stations = \"cans.csv\"");
}

#[test]
fn a_table_with_too_many_rows_is_refused() {
    let row = |i: usize| format!("{i},5,0.03\n");
    let rows: String = (0..100_002).map(row).collect();
    let table = format!("height_m,diameter_m,wall_m\n{rows}");
    let words = ["100001 rows are more than the limit of 100000"];
    refused(&table, (100_002, 1), &words);
}

#[test]
fn the_example_with_a_table_is_the_tower_of_its_table() {
    let examples = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let path = examples.join("cans.toml");
    let Ok(Input::Tower(input)) = read(&path, &ReadOptions::default()) else {
        panic!("the example is no tower");
    };
    let tower = input.tower().expect("a tower");
    assert_eq!((tower.base_m(), tower.top_m()), (0.0, 87.6));
    // The table is found from any folder.
    assert!(SiblingFiles::of(&path).path("cans.csv").is_file());
}

/// Files that are not regular, which to open would be to wait for.
#[cfg(unix)]
mod special_files {
    use std::fs;
    use std::os::unix::net::UnixListener;
    use std::path::PathBuf;
    use std::process::Command;

    use super::{CANS, TOWER};
    use towermodes_files::{MAX_FILE_BYTES, ReadOptions, read};
    use towermodes_testing::Says;

    struct Folder(PathBuf);

    impl Folder {
        fn new(name: &str) -> Self {
            let name = format!("towermodes-{name}-{}", std::process::id());
            let path = std::env::temp_dir().join(name);
            fs::create_dir_all(&path).expect("a folder");
            fs::write(path.join("tower.toml"), TOWER).expect("written");
            Self(path)
        }

        /// What is said of the tower, or of another file.
        fn said(&self, file: &str) -> String {
            match read(&self.0.join(file), &ReadOptions::default()) {
                Ok(_) => String::new(),
                Err(error) => error.to_string(),
            }
        }

        fn pipe(&self, name: &str) {
            let status = Command::new("mkfifo").arg(self.0.join(name)).status();
            assert!(status.expect("mkfifo").success());
        }
    }

    impl Drop for Folder {
        fn drop(&mut self) {
            let _ = fs::remove_dir_all(&self.0);
        }
    }

    #[test]
    fn pipes_sockets_and_devices_are_refused_without_waiting() {
        let folder = Folder::new("special");
        folder.pipe("cans.csv");
        folder
            .said("tower.toml")
            .says("cans.csv: is a named pipe, not a regular file");
        folder.pipe("pipe.toml");
        let said = folder.said("pipe.toml");
        said.says("pipe.toml: is a named pipe");
        let _socket = UnixListener::bind(folder.0.join("socket.toml")).expect("a socket");
        folder.said("socket.toml").says("is a socket");
        folder.said("/dev/null").says("is a device");
        fs::remove_file(folder.0.join("cans.csv")).expect("removed");
        fs::create_dir(folder.0.join("cans.csv")).expect("a folder");
        folder.said("tower.toml").says("is a directory");
    }

    #[test]
    fn a_companion_of_gigabytes_is_refused_before_it_is_read() {
        let folder = Folder::new("large");
        let large = fs::File::create(folder.0.join("cans.csv")).expect("a file");
        // A hole: it takes no room on the disk, and would take memory.
        large.set_len(64 * MAX_FILE_BYTES).expect("a large file");
        folder.said("tower.toml").says("larger than 64 MiB");
        drop(large);
        fs::write(folder.0.join("cans.csv"), CANS).expect("written");
        assert_eq!(folder.said("tower.toml"), "");
    }

    #[test]
    fn a_pointer_of_git_lfs_is_named_as_such() {
        let folder = Folder::new("pointer");
        let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n";
        fs::write(folder.0.join("cans.csv"), pointer).expect("written");
        folder.said("tower.toml").says("Git LFS pointer");
        fs::write(folder.0.join("Tower.dat"), pointer).expect("written");
        folder.said("Tower.dat").says("`git lfs pull`");
    }
}
