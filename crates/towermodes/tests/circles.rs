//! No files of a crate import each other in a circle. A name that a folder hands on counts as
//! imported from the file that defines it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

/// The path of a module or a name from the root of its crate.
type ModulePath = Vec<String>;

#[derive(Default)]
struct House {
    files: BTreeMap<ModulePath, PathBuf>,
    /// The paths that each file uses.
    paths: BTreeMap<ModulePath, BTreeSet<ModulePath>>,
    /// The names that a file imports, which its folder can take from it: name and origin.
    names: BTreeMap<ModulePath, BTreeMap<String, ModulePath>>,
}

impl House {
    fn of(source: &Path) -> Self {
        let mut house = Self::default();
        house.add(source, &mut ModulePath::new());
        for (module, file) in &house.files {
            let code = super::architecture::code(file);
            let mut paths = BTreeSet::new();
            for (at, _) in code
                .match_indices("::")
                .filter(|(at, _)| begins(&code, *at))
            {
                let start = code[..at]
                    .rfind(|c: char| !is_of_name(c))
                    .map_or(0, |i| i + 1);
                open(&code[start..], &mut ModulePath::new(), &mut |path, _| {
                    paths.extend(house.in_crate(module, path));
                });
            }
            house.paths.insert(module.clone(), paths);
            let mut names = BTreeMap::new();
            for used in code
                .match_indices("use ")
                .map(|(at, word)| &code[at + word.len()..])
            {
                open(used, &mut ModulePath::new(), &mut |path, name| {
                    let origin = house.in_crate(module, path);
                    names.extend(origin.map(|origin| (name.to_owned(), origin)));
                });
            }
            house.names.insert(module.clone(), names);
        }
        house
    }

    fn add(&mut self, folder: &Path, module: &mut ModulePath) {
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            let name = path
                .file_stem()
                .expect("a name")
                .to_string_lossy()
                .into_owned();
            if path.is_dir() {
                module.push(name);
                self.add(&path, module);
                module.pop();
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let mut own = module.clone();
                own.extend((!["mod", "lib", "main"].contains(&name.as_str())).then_some(name));
                self.files.insert(own, path);
            }
        }
    }

    /// A path as written in a module, from the root; none if it leads out of the crate.
    fn in_crate(&self, module: &ModulePath, path: &[String]) -> Option<ModulePath> {
        let supers = path.iter().take_while(|part| *part == "super").count();
        let base = match path.first()?.as_str() {
            "crate" => return Some(path[1..].to_vec()),
            "self" => return Some([module, &path[1..]].concat()),
            "super" => &module[..module.len().checked_sub(supers)?],
            first => {
                let child = [module.clone(), vec![first.to_owned()]].concat();
                self.files.contains_key(&child).then_some(&module[..])?
            }
        };
        Some([base, &path[supers..]].concat())
    }

    /// The module whose file defines what a path names.
    fn home(&self, path: &[String], depth: usize) -> ModulePath {
        let mut module = ModulePath::new();
        for (index, part) in path.iter().enumerate() {
            let child = [module.clone(), vec![part.clone()]].concat();
            if self.files.contains_key(&child) {
                module = child;
                continue;
            }
            let origin = self.origin(&module, part);
            if let Some(origin) = origin.filter(|origin| depth < 8 && **origin != path) {
                return self.home(&[origin, &path[index + 1..]].concat(), depth + 1);
            }
            break;
        }
        module
    }

    /// What a name of a module stands for, by itself or as one of all names of a folder.
    fn origin(&self, module: &ModulePath, name: &str) -> Option<&ModulePath> {
        let names = self.names.get(module)?;
        let of_folder = || self.names.get(names.get("*")?)?.get(name);
        names.get(name).or_else(of_folder)
    }

    /// The files that each file imports. What a folder only hands on is no import of its `mod.rs`.
    fn imports(&self) -> BTreeMap<ModulePath, BTreeSet<ModulePath>> {
        let imports = self.paths.iter().map(|(module, paths)| {
            let homes = paths.iter().map(|path| self.home(path, 0));
            let is_folder = |other: &ModulePath| other.starts_with(module);
            let others = homes.filter(|other| other != module && !is_folder(other));
            (module.clone(), others.collect())
        });
        imports.collect()
    }
}

fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// Whether the name before `::` at this place is the first of its path.
fn begins(code: &str, at: usize) -> bool {
    let before = code[..at].trim_end_matches(is_of_name);
    before.len() < at && !before.ends_with("::") && !before.ends_with('$')
}

/// Calls with every path that a text begins with, braces opened, and the name that stands for it;
/// returns what follows.
fn open<'t>(
    text: &'t str,
    prefix: &mut ModulePath,
    each: &mut impl FnMut(&[String], &str),
) -> &'t str {
    let length = prefix.len();
    let mut rest = text.trim_start();
    loop {
        let end = rest.find(|c| !is_of_name(c)).unwrap_or(rest.len());
        if end == 0 {
            break;
        }
        prefix.push(rest[..end].to_owned());
        rest = &rest[end..];
        match rest.strip_prefix("::") {
            Some(after) => rest = after,
            None => break,
        }
    }
    if let Some(mut list) = rest.strip_prefix('{') {
        while !list.trim_start().starts_with('}') && !list.trim_start().is_empty() {
            list = open(list, prefix, each);
            list = list.trim_start_matches(|c| c != ',' && c != '}');
            list = list.strip_prefix(',').unwrap_or(list);
        }
        rest = list.trim_start().strip_prefix('}').unwrap_or("");
    } else if prefix.len() > length {
        let own = prefix.last().is_some_and(|last| last == "self");
        let path = &prefix[..prefix.len() - usize::from(own)];
        let alias = rest.trim_start().strip_prefix("as ");
        let alias = alias.and_then(|alias| alias.split(|c| !is_of_name(c)).next());
        let every = rest.starts_with('*').then_some("*");
        each(
            path,
            alias
                .or(every)
                .unwrap_or(path.last().map_or("", |name| name)),
        );
    }
    prefix.truncate(length);
    rest
}

/// The files that can be reached from each file of a circle, and from which it can be reached.
fn circles(
    imports: &BTreeMap<ModulePath, BTreeSet<ModulePath>>,
) -> BTreeSet<BTreeSet<&ModulePath>> {
    let reached = |from| {
        let (mut reached, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(module) = open.pop() {
            let next = imports.get(module).into_iter().flatten();
            open.extend(next.filter(|other| reached.insert(*other)));
        }
        reached
    };
    let reached: BTreeMap<_, _> = imports
        .keys()
        .map(|module| (module, reached(module)))
        .collect();
    let both = |a: &ModulePath, b: &ModulePath| reached[a].contains(b) && reached[b].contains(a);
    let circle = |a| {
        reached
            .keys()
            .copied()
            .filter(|b| both(a, b))
            .collect::<BTreeSet<_>>()
    };
    let all = imports.keys().map(circle);
    all.filter(|circle| !circle.is_empty()).collect()
}

#[test]
fn no_files_import_each_other_in_a_circle() {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut found = Vec::new();
    for entry in fs::read_dir(crates).expect("the crates") {
        let imports = House::of(&entry.expect("a crate").path().join("src")).imports();
        let all = circles(&imports);
        let joined = all
            .iter()
            .map(|circle| circle.iter().map(|module| module.join("/")));
        found.extend(joined.map(|circle| circle.collect::<Vec<_>>().join(", ")));
    }
    assert!(found.is_empty(), "files that import each other: {found:#?}");
}

#[test]
fn a_circle_is_found() {
    let path = |name: &str| vec![name.to_owned()];
    let uses = |pairs: &[(&str, &str)]| {
        let pair = |(from, to): &(&str, &str)| (path(from), BTreeSet::from([path(to)]));
        pairs.iter().map(pair).collect::<BTreeMap<_, _>>()
    };
    let round = uses(&[("a", "b"), ("b", "c"), ("c", "b")]);
    assert_eq!(
        circles(&round),
        BTreeSet::from([BTreeSet::from([&path("b"), &path("c")])])
    );
    assert!(circles(&uses(&[("a", "b"), ("b", "c")])).is_empty());
    let mut paths = Vec::new();
    open(
        "super::{a::{self, B as C}, d}; e::f",
        &mut Vec::new(),
        &mut |path, name| {
            paths.push(format!("{} {name}", path.join("/")));
        },
    );
    assert_eq!(paths, ["super/a a", "super/a/B C", "super/d d"]);
}
