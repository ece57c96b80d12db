//! The house as it is written down: imports between folders, no circles, width of comments.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// Rooms of a crate (folders and files directly in `src`) and the rooms each one uses.
type Imports = BTreeMap<String, BTreeSet<String>>;

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn rust_files(folder: &Path, files: &mut Vec<PathBuf>) {
    let entries = fs::read_dir(folder).expect("a folder");
    for path in entries.map(|entry| entry.expect("an entry").path()) {
        if path.is_dir() && !path.ends_with("target") {
            rust_files(&path, files);
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            files.push(path);
        }
    }
}

/// The source of a file without its unit tests, comments and strings of documentation.
pub(crate) fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a source file");
    let code = text.split("\n#[cfg(test)]\nmod tests {").next();
    let lines = code.unwrap_or_default().lines();
    let lines = lines.filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// The first name of every path after `crate::`, braces opened: `crate::{a::B, C}` gives a and C.
fn names_after_crate(code: &str) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    for (at, _) in code.match_indices("crate::") {
        let is_other = code[..at].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$');
        let path = &code[at + "crate::".len()..];
        if !is_other {
            match path.strip_prefix('{') {
                Some(list) => names.extend(first_names(list)),
                None => names.extend(identifier(path)),
            }
        }
    }
    names
}

/// The first name of each path of a list in braces; inner lists belong to the path before them.
fn first_names(list: &str) -> Vec<String> {
    let mut names = Vec::new();
    let (mut depth, mut begins) = (0, true);
    for (at, c) in list.char_indices() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => begins = true,
            _ if begins && !c.is_whitespace() => {
                names.extend(identifier(&list[at..]));
                begins = false;
            }
            _ => {}
        }
    }
    names
}

fn identifier(path: &str) -> Option<String> {
    let end = path.find(|c: char| !(c.is_alphanumeric() || c == '_'));
    let name = &path[..end.unwrap_or(path.len())];
    (!name.is_empty()).then(|| name.to_owned())
}

/// Which room each name of the crate's root is from, by the `pub use room::{...}` of its lib.rs.
fn reexports(lib: &str) -> BTreeMap<String, String> {
    let mut rooms = BTreeMap::new();
    for statement in lib.split(';').filter_map(|part| part.split_once("use ")) {
        let Some((room, names)) = statement.1.trim().split_once("::") else {
            continue;
        };
        let names = names.trim_start_matches('{').trim_end_matches('}');
        for name in names.split(',').filter_map(|name| name.rsplit("::").next()) {
            rooms.insert(name.trim().to_owned(), room.to_owned());
        }
    }
    rooms
}

/// What each room of a crate imports from the crate's other rooms.
fn imports(source: &Path) -> Imports {
    let lib = code(&source.join("lib.rs"));
    let reexports = reexports(&lib);
    let mut files = Vec::new();
    rust_files(source, &mut files);
    let mut imports = Imports::new();
    for file in files.iter().filter(|file| !file.ends_with("lib.rs")) {
        let inside = file.strip_prefix(source).expect("inside");
        let room = inside.iter().next().expect("a name").to_string_lossy();
        let room = room.trim_end_matches(".rs").to_owned();
        let used = names_after_crate(&code(file));
        let used = used
            .iter()
            .map(|name| reexports.get(name).unwrap_or(name).clone());
        let others: Vec<String> = used.filter(|other| *other != room).collect();
        imports.entry(room).or_default().extend(others);
    }
    imports
}

/// A circle of rooms that import each other, if there is one.
fn circle(imports: &Imports) -> Option<Vec<String>> {
    fn visit(
        room: &str,
        imports: &Imports,
        path: &mut Vec<String>,
        done: &mut BTreeSet<String>,
    ) -> Option<Vec<String>> {
        if let Some(start) = path.iter().position(|name| name == room) {
            return Some(path[start..].to_vec());
        }
        if !done.insert(room.to_owned()) {
            return None;
        }
        path.push(room.to_owned());
        let used = imports.get(room).into_iter().flatten();
        let found = used.map(|other| visit(other, imports, path, done));
        let found = found.flatten().next();
        path.pop();
        found
    }
    let mut done = BTreeSet::new();
    let mut rooms = imports.keys();
    rooms.find_map(|room| visit(room, imports, &mut Vec::new(), &mut done))
}

/// The rows of ARCHITECTURE's table of a crate: room and what it imports.
fn written_imports(crate_name: &str) -> Imports {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let heading = format!("(`crates/{crate_name}/src`)");
    let (_, section) = text.split_once(&heading).expect("a section for the crate");
    let section = section.split("\n## ").next().expect("a section");
    let rows = section.lines().filter_map(|line| line.strip_prefix("| `"));
    let quoted = |cell: &str| -> BTreeSet<String> {
        let names = cell.split('`').skip(1).step_by(2);
        names
            .map(|name| name.trim_end_matches('/').to_owned())
            .collect()
    };
    rows.map(|row| {
        let (room, rest) = row.split_once('`').expect("a room");
        let cell = rest.trim_end_matches([' ', '|']).rsplit('|').next();
        let room = room.trim_end_matches('/').trim_end_matches(".rs");
        (room.to_owned(), quoted(cell.expect("a cell")))
    })
    .collect()
}

/// Crates whose table of imports is in ARCHITECTURE.md.
const WRITTEN: [&str; 1] = ["towermodes"];
const ALL: [&str; 5] = [
    "towermodes",
    "towermodes-design",
    "towermodes-files",
    "towermodes-report",
    "towermodes-sweep",
];

#[test]
fn the_table_of_imports_is_that_of_the_code() {
    for name in WRITTEN {
        let found = imports(&root().join("crates").join(name).join("src"));
        let written = written_imports(name);
        for (room, used) in &found {
            let table = written
                .get(room)
                .unwrap_or_else(|| panic!("{name}: no row for {room}"));
            assert_eq!(
                used, table,
                "{name}: ARCHITECTURE.md says what `{room}` imports"
            );
        }
        let gone: Vec<_> = written
            .keys()
            .filter(|room| !found.contains_key(*room))
            .collect();
        assert!(gone.is_empty(), "{name}: rows without a room: {gone:?}");
    }
}

#[test]
fn no_rooms_import_each_other_in_a_circle() {
    for name in ALL {
        let imports = imports(&root().join("crates").join(name).join("src"));
        assert_eq!(circle(&imports), None, "{name}");
    }
}

/// The list of closed forms in `tower/foundation.rs`.
fn closed_forms() -> Vec<String> {
    let home = root().join("crates/towermodes/src/tower/foundation.rs");
    let text = fs::read_to_string(home).expect("the list");
    let (_, list) = text.split_once("\nclosed_forms!(").expect("the list");
    let (list, _) = list.split_once(')').expect("its end");
    list.split(',').map(|name| name.trim().to_owned()).collect()
}

/// What a kind of foundation needs is asked of its trait. Only its own file, the list of all kinds
/// and the re-exports name it; random towers are made of such foundations.
#[test]
fn nothing_but_its_file_names_a_foundation_by_closed_form() {
    let homes = [
        "tower/closed_form/",
        "tower/foundation.rs",
        "tower/mod.rs",
        "src/lib.rs",
    ];
    let kinds = closed_forms();
    let holds = kinds.iter().any(|kind| kind == "SuctionCaisson");
    assert!(holds, "{kinds:?}");
    let names = kinds.iter().map(|kind| format!("Foundation::{kind}"));
    assert_only_homes_have(&names.collect::<Vec<_>>(), &homes);
}

/// What the springs of a layer need is asked of the traits of its models. Only the names, the lists
/// and the kinds of soil name a model; the manual and windIO make towers with one.
#[test]
fn nothing_but_its_file_names_a_model_of_soil() {
    let homes = [
        "tower/ground/model.rs",
        "tower/ground/models/mod.rs",
        "tower/ground/axial/mod.rs",
        "tower/ground/description.rs",
        "tower/ground/layer.rs",
        "towermodes-verify/src/manual/",
        "windio/support/soil.rs",
    ];
    assert_only_homes_have(
        &["SoilModel::".to_owned(), "AxialModel::".to_owned()],
        &homes,
    );
}

/// `Parameter::nature` and `Parameter::dimension` give what kind of number a parameter is. Code
/// that solves, fits or sweeps towers with other numbers decides nothing by the text of a name.
#[test]
fn no_name_of_a_number_decides_by_its_text() {
    let rooms = [
        "towermodes/src/sensitivity",
        "towermodes-analysis/src",
        "towermodes-design/src",
        "towermodes-sweep/src",
        "towermodes-explore/src/slider.rs",
    ];
    let decisions = [
        "starts_with(\"",
        "ends_with(\"",
        ".contains(\"",
        ".unit() ==",
        "&parameter.unit()",
        "match parameter.unit()",
    ];
    let mut files = vec![root().join("crates").join(rooms[rooms.len() - 1])];
    for room in &rooms[..rooms.len() - 1] {
        rust_files(&root().join("crates").join(room), &mut files);
    }
    assert!(files.len() > 50);
    for file in files.iter().filter(|file| !file.ends_with("tests.rs")) {
        let code = code(file);
        let found = decisions.iter().find(|text| code.contains(**text));
        assert_eq!(found, None, "{}", file.display());
    }
}

/// Asserts that the code of no file but the homes has one of the texts; random towers have all.
fn assert_only_homes_have(texts: &[String], homes: &[&str]) {
    let mut files = Vec::new();
    rust_files(&root().join("crates"), &mut files);
    for file in files {
        let path = file.to_string_lossy().replace('\\', "/");
        let is_home = homes.iter().any(|home| path.contains(home));
        let is_random = path.contains("towermodes-random");
        if is_home || is_random || !path.contains("/src/") {
            continue;
        }
        let code = code(&file).replace("SoilModel::CHOICES", "");
        let code = code.replace("AxialModel::resists_torsion", "");
        let found = texts.iter().find(|text| code.contains(*text));
        assert_eq!(found, None, "{path}");
    }
}

#[test]
fn circles_and_lists_are_found() {
    let code = "use crate::{a::{B, C}, D};\nlet x = crate::e::f(); $crate::g; other_crate::h";
    let names: Vec<String> = names_after_crate(code).into_iter().collect();
    assert_eq!(names, ["D", "a", "e"]);
    let rooms = |pairs: &[(&str, &[&str])]| -> Imports {
        let set = |used: &[&str]| used.iter().map(ToString::to_string).collect();
        pairs
            .iter()
            .map(|(room, used)| ((*room).to_owned(), set(used)))
            .collect()
    };
    let round = rooms(&[("a", &["b"]), ("b", &["c"]), ("c", &["b"])]);
    assert_eq!(circle(&round), Some(vec!["b".to_owned(), "c".to_owned()]));
    let down = rooms(&[("a", &["b", "c"]), ("b", &["c"]), ("c", &[])]);
    assert_eq!(circle(&down), None);
}

#[test]
fn comments_have_at_most_100_columns() {
    let mut files = Vec::new();
    for folder in ["crates", "fuzz", "recorded-runs"] {
        rust_files(&root().join(folder), &mut files);
    }
    let mut wide = Vec::new();
    for file in files {
        let text = fs::read_to_string(&file).expect("a source file");
        for (index, line) in text.lines().enumerate() {
            if line.trim_start().starts_with("//") && line.chars().count() > 100 {
                wide.push(format!("{}:{}", file.display(), index + 1));
            }
        }
    }
    assert!(wide.is_empty(), "wider than 100 columns: {wide:#?}");
}
