//! The files that a user chose, and the tower in them.

use std::cell::RefCell;
use std::collections::BTreeSet;

use towermodes_files::{
    Diagnostic, DiagnosticKind, FileError, FileResolver, Input, ReadError, ReadOptions, Source,
    TowerInput, read_source, recognize,
};

/// Files in memory, without their folders.
#[derive(Default)]
pub(crate) struct ChosenFiles {
    files: Vec<Source>,
}

impl ChosenFiles {
    /// Adds a file.
    ///
    /// # Errors
    /// The bytes are no text.
    pub(crate) fn add(&mut self, name: String, bytes: Vec<u8>) -> Result<(), FileError> {
        self.files.push(Source::from_bytes(name, bytes)?);
        Ok(())
    }

    /// The tower of the files: the tower of the only file that no other file refers to.
    ///
    /// # Errors
    /// Why there is no tower, or more than one.
    pub(crate) fn tower(&self) -> Result<TowerInput, String> {
        let mut readings = self.readings();
        let named: BTreeSet<String> = readings.iter().flat_map(|of| of.named.clone()).collect();
        readings.retain(|of| !named.contains(&of.name));
        match readings.len() {
            0 => Err("no file has been chosen that is the main file of a tower".to_owned()),
            1 => readings.remove(0).tower,
            _ => {
                let names: Vec<String> = readings.into_iter().map(|of| of.name).collect();
                Err(format!(
                    "each of these files describes a tower: {}; choose one of them, with the files that it names",
                    names.join(", ")
                ))
            }
        }
    }

    /// Each file read as the main file; files of unknown format only if all are of unknown format,
    /// then only the first.
    fn readings(&self) -> Vec<ReadAsMain> {
        let known: Vec<&Source> = self
            .files
            .iter()
            .filter(|file| recognize(file).is_some())
            .collect();
        match known.is_empty() {
            true => self
                .files
                .iter()
                .take(1)
                .map(|file| self.read(file))
                .collect(),
            false => known.into_iter().map(|file| self.read(file)).collect(),
        }
    }

    fn read(&self, main: &Source) -> ReadAsMain {
        let siblings = Siblings {
            files: &self.files,
            named: RefCell::default(),
            missing: RefCell::default(),
        };
        let tower = match read_source(main.clone(), &siblings, &ReadOptions::default()) {
            Ok(Input::Tower(input)) => input.check().map(|of| of.input),
            Ok(Input::Blade(_)) => Err(only_for_solve(main, "a deck of a rotating blade")),
            Ok(Input::Substructure(_)) => Err(only_for_solve(main, "a SubDyn file")),
            Ok(Input::Mooring(_)) => Err(only_for_solve(main, "a file of mooring lines")),
            Err(error) => Err(error),
        };
        let tower = tower.map_err(|error| error.to_string() + &siblings.remedy(&main.name));
        ReadAsMain {
            name: main.name.clone(),
            named: siblings.named.into_inner(),
            tower,
        }
    }
}

/// A file read as the main file.
struct ReadAsMain {
    name: String,
    /// The chosen files that it refers to.
    named: BTreeSet<String>,
    tower: Result<TowerInput, String>,
}

fn only_for_solve(main: &Source, what: &str) -> ReadError {
    let found = format!("{what}, which only the command solve reads");
    ReadError::mistake(
        main,
        Diagnostic::new(0..0, DiagnosticKind::WrongFile { found }),
    )
}

/// The chosen files, which a main file can refer to.
struct Siblings<'f> {
    files: &'f [Source],
    named: RefCell<BTreeSet<String>>,
    missing: RefCell<BTreeSet<String>>,
}

impl Siblings<'_> {
    /// The remedy for missing files, for the user of the page.
    fn remedy(&self, main: &str) -> String {
        let missing: Vec<String> = self.missing.borrow().iter().cloned().collect();
        match missing.is_empty() {
            true => String::new(),
            false => format!("\nOpen {main} together with {}.", missing.join(", ")),
        }
    }
}

impl FileResolver for Siblings<'_> {
    /// The file with this name in any folder; if there is none, a file whose name differs only in
    /// upper and lower case, as in file systems of Windows.
    fn read(&self, path: &str) -> Result<Source, FileError> {
        let name = path.rsplit(['/', '\\']).next().unwrap_or(path);
        let exact = self.files.iter().find(|file| file.name == name);
        let mut alike = self
            .files
            .iter()
            .filter(|file| file.name.eq_ignore_ascii_case(name));
        let found = exact.or_else(|| alike.next());
        let Some(found) = found else {
            self.missing.borrow_mut().insert(name.to_owned());
            return Err(FileError::Missing {
                name: path.to_owned(),
            });
        };
        self.named.borrow_mut().insert(found.name.clone());
        Ok(found.clone())
    }

    fn has_folders(&self) -> bool {
        false
    }
}
