//! Towers from files and texts.

use std::path::PathBuf;

use pyo3::prelude::*;
use towermodes_files::{
    FileFormat, MemberEnds, ReadOptions, RotorLock, SiblingFiles, Source, TowerPart, read_source,
    tower_file_schema,
};

use crate::error::{MADE_HERE, of_read, usage};
use crate::input::{input_of_text, tower_input};
use crate::lock::released;
use crate::tower::Tower;

/// Options for reading a file.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct Reading {
    part: String,
    rotor: String,
    member_ends: String,
    no_rna: bool,
    no_gravity: bool,
    clamped: bool,
    equilibrium: bool,
    bmodes_quirks: bool,
    tower_height_m: Option<f64>,
    tower_base_m: Option<f64>,
    subset: Option<(usize, usize)>,
}

/// The tower of a file.
#[pyfunction]
#[pyo3(signature = (path: "str", options: "dict[str, object]"))]
pub fn read(py: Python<'_>, path: PathBuf, options: Reading) -> PyResult<Tower> {
    let read_options = options.of_library()?;
    let input = released(py, || {
        let source = Source::from_path(&path)?;
        read_source(source, &SiblingFiles::of(&path), &read_options)
    });
    let input = tower_input(input.map_err(of_read)?)?;
    options.check(input.format)?;
    Tower::of_input(input)
}

/// The tower of a text in any format; `name` is used as the name of the file.
#[pyfunction]
#[pyo3(signature = (text, name))]
pub fn read_text(text: String, name: String) -> PyResult<Tower> {
    let is_made_here = name == MADE_HERE;
    let input = input_of_text(text, name)?;
    match is_made_here {
        true => Tower::of_changed(input),
        false => Tower::of_input(input),
    }
}

/// The keys of a tower file, and those of its table `[tower]`.
#[pyfunction]
pub fn tower_file_keys() -> [Vec<&'static str>; 2] {
    let keys = |name: &str| {
        let mut tables = tower_file_schema().iter();
        let table = tables.find(|table| table.name == name);
        table.map_or_else(Vec::new, |table| table.key_names().collect())
    };
    [keys("the file"), keys("[tower]")]
}

impl Reading {
    fn of_library(&self) -> PyResult<ReadOptions> {
        Ok(ReadOptions {
            bmodes_quirks: self.bmodes_quirks,
            tower_height_m: self.tower_height_m,
            tower_base_m: self.tower_base_m,
            without_rna: self.no_rna,
            part: self.part()?,
            hawc2_subset: self.subset,
            rotor: self.rotor()?,
            without_gravity: self.no_gravity,
            clamped: self.clamped,
            at_equilibrium: self.equilibrium,
            member_ends: self.member_ends()?,
        })
    }

    fn part(&self) -> PyResult<TowerPart> {
        match self.part.as_str() {
            "all" => Ok(TowerPart::All),
            "tower" => Ok(TowerPart::Tower),
            "monopile" => Ok(TowerPart::Monopile),
            part => Err(usage(format!(
                "part is '{part}'; it must be 'all', 'tower' or 'monopile'"
            ))),
        }
    }

    fn member_ends(&self) -> PyResult<MemberEnds> {
        match self.member_ends.as_str() {
            "balance" => Ok(MemberEnds::Balance),
            "cut" => Ok(MemberEnds::Cut),
            "whole" => Ok(MemberEnds::Whole),
            ends => Err(usage(format!(
                "member_ends is '{ends}'; it must be 'balance', 'cut' or 'whole'"
            ))),
        }
    }

    fn rotor(&self) -> PyResult<RotorLock> {
        match self.rotor.as_str() {
            "locked" => Ok(RotorLock::Locked),
            "free" => Ok(RotorLock::Free),
            rotor => Err(usage(format!(
                "rotor is '{rotor}'; it must be 'locked' or 'free'"
            ))),
        }
    }

    /// Refuses an option that has no effect on files of this format.
    fn check(&self, format: FileFormat) -> PyResult<()> {
        use FileFormat::{Bmodes, ElastoDyn, ElastoDynTower, Hawc2, Toml, WindIo};
        let options: [(bool, &[FileFormat], &str); 9] = [
            (
                self.equilibrium,
                &[Toml, ElastoDyn, WindIo],
                "equilibrium applies only to floating towers in tower files, OpenFAST models and windIO turbines",
            ),
            (
                self.clamped,
                &[ElastoDyn, WindIo],
                "clamped applies only to OpenFAST models and windIO turbines",
            ),
            (
                self.bmodes_quirks,
                &[Bmodes],
                "bmodes_quirks applies only to BModes decks",
            ),
            (
                self.rotor != "locked",
                &[ElastoDyn, Toml],
                "rotor applies only to ElastoDyn models and tower files, which contain rotor and generator data",
            ),
            (
                self.part != "all",
                &[WindIo],
                "part applies only to windIO turbines",
            ),
            (
                self.member_ends != "balance",
                &[WindIo],
                "member_ends applies only to windIO turbines",
            ),
            (
                self.subset.is_some(),
                &[Hawc2],
                "subset applies only to HAWC2 files",
            ),
            (
                self.tower_height_m.is_some(),
                &[ElastoDynTower, Hawc2],
                "tower_height_m applies only to an ElastoDyn tower file; this file contains the height of the tower",
            ),
            (
                self.tower_base_m.is_some(),
                &[ElastoDynTower, Hawc2],
                "tower_base_m applies only to an ElastoDyn tower file or a HAWC2 file; this file contains the height of the tower base",
            ),
        ];
        let idle = options
            .iter()
            .find(|(is_given, own, _)| *is_given && !own.contains(&format));
        idle.map_or(Ok(()), |(.., message)| Err(usage(*message)))
    }
}
