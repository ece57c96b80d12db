//! Which file is read, and how where its format leaves a choice.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use towermodes_files::{FileFormat, ReadOptions, RotorLock, TowerPart};

use super::parsers::{height_parser, subset_parser};

/// The heading of what is about them.
const OTHERS: &str = "Files of other programs";

/// The file and how it is read.
#[derive(Debug, Args)]
pub(crate) struct InputArguments {
    /// A tower in TOML, a BModes deck (.bmi), an ElastoDyn main or tower file (.dat, or the .fst
    /// that names it), a turbine in windIO (.yaml) or a HAWC2 _st.dat, known by content and name; -
    /// is standard input
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) reading: ReadingArguments,
}

/// What files of other programs leave open.
#[derive(Debug, Clone, Copy, Args)]
pub(crate) struct ReadingArguments {
    /// Leave the rotor-nacelle assembly out: the tower alone
    #[arg(help_heading = OTHERS, long)]
    pub(crate) no_rna: bool,

    /// Leave gravity out: the frequencies of a tower without weights
    #[arg(help_heading = OTHERS, long)]
    no_gravity: bool,

    /// How the rotor of an ElastoDyn model is held on its shaft
    #[arg(help_heading = OTHERS, long, value_enum, default_value_t = Rotor::Locked, conflicts_with = "no_rna")]
    rotor: Rotor,

    /// Understand a BModes deck as BModes 3.00 does, its faults included
    #[arg(help_heading = OTHERS, long)]
    bmodes_quirks: bool,

    /// Part of a windIO turbine
    #[arg(help_heading = OTHERS, long, value_enum, default_value_t = Part::All)]
    part: Part,

    /// Height of the tower's top above ground or sea level, m, for an ElastoDyn tower file alone
    #[arg(help_heading = OTHERS, long, value_name = "M", value_parser = height_parser)]
    tower_height: Option<f64>,

    /// Height of the tower's base above ground or sea level, m, for an ElastoDyn tower file or a
    /// HAWC2 file [default: 0]
    #[arg(help_heading = OTHERS, long, value_name = "M", value_parser = height_parser)]
    tower_base: Option<f64>,

    /// Set and subset of a HAWC2 file, as 1,2 [default: the first of each]
    #[arg(help_heading = OTHERS, long, value_name = "SET,SUBSET", value_parser = subset_parser)]
    subset: Option<(usize, usize)>,
}

/// Part of a turbine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// The tower, on its monopile if there is one.
    All,
    /// The tower alone, clamped at its own base.
    Tower,
    /// The monopile alone.
    Monopile,
}

/// How a rotor is held.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Rotor {
    /// By a brake: rotor and generator roll with the nacelle.
    Locked,
    /// Not at all: no torque acts on the shaft.
    Free,
}

impl ReadingArguments {
    /// Refuses what means nothing to any of the files.
    ///
    /// # Errors
    /// What is wrong.
    pub(crate) fn check(&self, formats: &[FileFormat]) -> Result<(), &'static str> {
        let is_one_of = |own: &[FileFormat]| formats.iter().any(|format| own.contains(format));
        let without_heights = [FileFormat::ElastoDynTower, FileFormat::Hawc2];
        let options = [
            (
                self.bmodes_quirks,
                &[FileFormat::Bmodes][..],
                "--bmodes-quirks is for decks of BModes",
            ),
            (
                self.rotor != Rotor::Locked,
                &[FileFormat::ElastoDyn],
                "--rotor is for models of ElastoDyn, whose files say what rotor and generator are",
            ),
            (
                self.part != Part::All,
                &[FileFormat::WindIo],
                "--part is for turbines in windIO",
            ),
            (
                self.subset.is_some(),
                &[FileFormat::Hawc2],
                "--subset is for files of HAWC2",
            ),
            (
                self.tower_height.is_some(),
                &without_heights,
                "--tower-height is for a tower file of ElastoDyn alone; this file says how high the tower is",
            ),
            (
                self.tower_base.is_some(),
                &without_heights,
                "--tower-base is for a tower file of ElastoDyn alone and for files of HAWC2; this file says where the tower begins",
            ),
        ];
        let ignored = options
            .into_iter()
            .find(|(is_given, own, _)| *is_given && !is_one_of(own));
        ignored.map_or(Ok(()), |(.., message)| Err(message))
    }

    /// These options as they are typed.
    pub(crate) fn typed(&self) -> String {
        let part = self.part.to_possible_value();
        let part = part.filter(|_| self.part != Part::All);
        let is_free = self.rotor == Rotor::Free;
        let words = [
            self.no_rna.then(|| "--no-rna".to_owned()),
            self.no_gravity.then(|| "--no-gravity".to_owned()),
            is_free.then(|| "--rotor free".to_owned()),
            self.bmodes_quirks.then(|| "--bmodes-quirks".to_owned()),
            part.map(|part| format!("--part {}", part.get_name())),
            self.tower_height.map(|m| format!("--tower-height {m}")),
            self.tower_base.map(|m| format!("--tower-base {m}")),
            self.subset
                .map(|(set, subset)| format!("--subset {set},{subset}")),
        ];
        words.into_iter().flatten().collect::<Vec<_>>().join(" ")
    }

    /// What the readers are told.
    pub(crate) fn options(&self) -> ReadOptions {
        ReadOptions {
            bmodes_quirks: self.bmodes_quirks,
            tower_height_m: self.tower_height,
            tower_base_m: self.tower_base,
            without_rna: self.no_rna,
            part: match self.part {
                Part::All => TowerPart::All,
                Part::Tower => TowerPart::Tower,
                Part::Monopile => TowerPart::Monopile,
            },
            hawc2_subset: self.subset,
            rotor: match self.rotor {
                Rotor::Locked => RotorLock::Locked,
                Rotor::Free => RotorLock::Free,
            },
            without_gravity: self.no_gravity,
        }
    }
}
