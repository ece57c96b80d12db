//! The input file, and options for formats that do not define everything.

use std::path::PathBuf;

use clap::builder::PossibleValue;
use clap::{Args, ValueEnum};
use towermodes_files::{FileFormat, MemberEnds, ReadOptions, RotorLock, Setting, TowerPart};
use towermodes_report::report::quoted;

use super::parsers::{height_parser, setting_parser, subset_parser};
use super::words::{flag, valued};

/// Heading in the help of the options for all input files.
const MODEL: &str = "Model";
/// Heading in the help of the options for certain formats.
const OTHERS: &str = "Files of other programs";

/// The input file and the options for reading it.
#[derive(Debug, Args)]
pub(crate) struct InputArguments {
    /// Tower file (.toml), BModes deck (.bmi), ElastoDyn main or tower file (.dat, or the .fst that
    /// refers to it), windIO turbine (.yaml) or HAWC2 _st.dat; the format is detected from content
    /// and name; use - for standard input
    pub(crate) file: PathBuf,

    #[command(flatten)]
    pub(crate) reading: ReadingArguments,
}

/// Options that change how the input file is read.
#[derive(Debug, Clone, Args)]
pub(crate) struct ReadingArguments {
    /// Omit the rotor-nacelle assembly
    #[arg(help_heading = MODEL, long)]
    pub(crate) no_rna: bool,

    /// Omit gravity (no geometric stiffness); not for a floating tower, because buoyancy exists
    /// only with gravity
    #[arg(help_heading = MODEL, long)]
    no_gravity: bool,

    /// Clamp a tower of OpenFAST or windIO at its base, without the jacket or platform below it;
    /// for a SubDyn file, fix the interface joints
    #[arg(help_heading = OTHERS, long)]
    pub(crate) clamped: bool,

    /// Use the stiffness of mooring lines at the equilibrium of weights, buoyancy and lines,
    /// instead of their stiffness at the reference position of the file
    #[arg(help_heading = MODEL, long)]
    equilibrium: bool,

    /// Change an input value of the tower by name; may be repeated: 'rna.mass=360000' replaces the
    /// value, 'scale(stations[*].wall)=1.1' multiplies it, 'add(stations[*].height)=2' adds to it;
    /// values in the units of the tower file. Single quotes protect brackets and parentheses from
    /// the shell; `towermodes parameters FILE` lists the names
    #[arg(help_heading = MODEL, long = "set", value_name = "NAME=VALUE", value_parser = setting_parser)]
    pub(crate) settings: Vec<Setting>,

    /// Rotor parked (locked) or free to rotate about its shaft (free), in an ElastoDyn model or a
    /// tower file with [drivetrain]
    #[arg(help_heading = OTHERS, long, value_enum, default_value_t = Rotor::Locked, conflicts_with = "no_rna")]
    rotor: Rotor,

    /// Interpret a BModes deck exactly as BModes 3.00 does, including the known errors of that
    /// program
    #[arg(help_heading = OTHERS, long)]
    bmodes_quirks: bool,

    /// Part of a windIO turbine to read
    #[arg(help_heading = OTHERS, long, value_enum, default_value_t = Part::All)]
    part: Part,

    /// Ends of the members of the floating platform of a windIO turbine that the file lets begin at
    /// the axis of another member; the choice changes frequencies by some percent
    #[arg(help_heading = OTHERS, long, value_name = "ENDS", value_enum, default_value_t = Ends::Balance)]
    member_ends: Ends,

    /// Height of the tower top above ground or sea level, m; only for an ElastoDyn tower file that
    /// is read without its main file
    #[arg(help_heading = OTHERS, long, value_name = "M", value_parser = height_parser)]
    tower_height: Option<f64>,

    /// Height of the tower base above ground or sea level, m; only for an ElastoDyn tower file that
    /// is read without its main file, or a HAWC2 file [default: 0]
    #[arg(help_heading = OTHERS, long, value_name = "M", value_parser = height_parser)]
    tower_base: Option<f64>,

    /// Set and subset of a HAWC2 file, for example 1,2 [default: the first of each]
    #[arg(help_heading = OTHERS, long, value_name = "SET,SUBSET", value_parser = subset_parser)]
    subset: Option<(usize, usize)>,
}

/// Part of a turbine.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Part {
    /// The tower, with its monopile if there is one.
    All,
    /// Only the tower, clamped at its base.
    Tower,
    /// Only the monopile.
    Monopile,
}

/// Where members of a floating platform end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Ends {
    /// Cut, or whole if the sum of weight, buoyancy and mooring force is then closer to zero.
    Balance,
    /// At the surface of the other member, as in WISDEM.
    Cut,
    /// At the axis of the other member: the volume of the overlap counts twice.
    Whole,
}

/// Whether the rotor can rotate about its shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum Rotor {
    /// Parked with the brake on: rotor and generator move with the nacelle.
    Locked,
    /// Free to rotate: no torque acts on the shaft.
    Free,
}

impl ReadingArguments {
    /// Checks that each option applies to at least one of the files.
    ///
    /// # Errors
    /// The message for the first option that applies to none.
    pub(crate) fn check(&self, formats: &[FileFormat]) -> Result<(), &'static str> {
        let names = self.settings.iter().map(Setting::name);
        Self::check_names(&self.options(), names)?;
        Self::check_options(&self.options(), formats)
    }

    /// Checks that no setting changes an input value that the readers omit.
    ///
    /// # Errors
    /// The message for the first setting that does.
    pub(crate) fn check_names<'a>(
        given: &ReadOptions,
        names: impl Iterator<Item = &'a str>,
    ) -> Result<(), &'static str> {
        let names: Vec<&str> = names.collect();
        let is_changed = |text: &str| names.iter().any(|name| name.contains(text));
        if given.without_rna && is_changed("rna.") {
            return Err(
                "--set of an input value of the RNA contradicts --no-rna; remove one of them",
            );
        }
        if given.without_gravity && is_changed("gravity") {
            return Err("--set of gravity contradicts --no-gravity; remove one of them");
        }
        Ok(())
    }

    /// Checks that no column changes an input value that the readers omit.
    ///
    /// # Errors
    /// The message for the first column that does, beginning with the option.
    pub(crate) fn check_columns<'a>(
        given: &ReadOptions,
        names: impl Iterator<Item = &'a str>,
    ) -> Result<(), &'static str> {
        Self::check_names(given, names).map_err(|_| match given.without_rna {
            true => "--no-rna omits the RNA, but a column changes an input value of the RNA; remove one of them",
            false => "--no-gravity omits gravity, but a column changes it; remove one of them",
        })
    }

    /// Checks that each option of the readers applies to at least one of the files.
    ///
    /// # Errors
    /// The message for the first option that applies to none, beginning with its name.
    pub(crate) fn check_options(
        given: &ReadOptions,
        formats: &[FileFormat],
    ) -> Result<(), &'static str> {
        let is_one_of = |own: &[FileFormat]| formats.iter().any(|format| own.contains(format));
        let without_heights = [FileFormat::ElastoDynTower, FileFormat::Hawc2];
        let options = [
            (
                given.clamped,
                &[
                    FileFormat::ElastoDyn,
                    FileFormat::SubDyn,
                    FileFormat::WindIo,
                ][..],
                "--clamped applies only to OpenFAST models, SubDyn files and windIO turbines; [foundation] type = \"clamped\" clamps a tower",
            ),
            (
                given.at_equilibrium,
                &[FileFormat::Toml, FileFormat::ElastoDyn, FileFormat::WindIo],
                "--equilibrium applies only to floating towers in tower files, OpenFAST models and windIO turbines",
            ),
            (
                given.bmodes_quirks,
                &[FileFormat::Bmodes][..],
                "--bmodes-quirks applies only to BModes decks",
            ),
            (
                given.rotor != RotorLock::Locked,
                &[FileFormat::ElastoDyn, FileFormat::Toml],
                "--rotor applies only to ElastoDyn models and tower files, which contain rotor and generator data",
            ),
            (
                given.part != TowerPart::All,
                &[FileFormat::WindIo],
                "--part applies only to windIO turbines",
            ),
            (
                given.member_ends != MemberEnds::Balance,
                &[FileFormat::WindIo],
                "--member-ends applies only to windIO turbines",
            ),
            (
                given.hawc2_subset.is_some(),
                &[FileFormat::Hawc2],
                "--subset applies only to HAWC2 files",
            ),
            (
                given.tower_height_m.is_some(),
                &without_heights,
                "--tower-height applies only to an ElastoDyn tower file; this file contains the height of the tower",
            ),
            (
                given.tower_base_m.is_some(),
                &without_heights,
                "--tower-base applies only to an ElastoDyn tower file or a HAWC2 file; this file contains the height of the tower base",
            ),
        ];
        let ignored = options
            .into_iter()
            .find(|(is_given, own, _)| *is_given && !is_one_of(own));
        ignored.map_or(Ok(()), |(.., message)| Err(message))
    }

    /// These options as text for a command line.
    pub(crate) fn typed(&self) -> String {
        let options = self.words().into_iter().map(|word| quoted(&word));
        let settings = self.settings.iter().map(Setting::to_string);
        let settings = settings.map(|setting| format!("--set {}", quoted(&setting)));
        options.chain(settings).collect::<Vec<_>>().join(" ")
    }

    /// The given options as arguments of a command line, without the settings.
    pub(crate) fn words(&self) -> Vec<String> {
        let part = self.part.to_possible_value();
        let part = part.filter(|_| self.part != Part::All);
        let ends = self.member_ends.to_possible_value();
        let ends = ends.filter(|_| self.member_ends != Ends::Balance);
        let subset = self.subset.map(|(set, subset)| format!("{set},{subset}"));
        [
            flag("--no-rna", self.no_rna),
            flag("--no-gravity", self.no_gravity),
            flag("--clamped", self.clamped),
            flag("--equilibrium", self.equilibrium),
            valued("--rotor", (self.rotor == Rotor::Free).then_some("free")),
            flag("--bmodes-quirks", self.bmodes_quirks),
            valued("--part", part.as_ref().map(PossibleValue::get_name)),
            valued("--member-ends", ends.as_ref().map(PossibleValue::get_name)),
            valued("--tower-height", self.tower_height),
            valued("--tower-base", self.tower_base),
            valued("--subset", subset),
        ]
        .concat()
    }

    /// The options of the readers.
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
            clamped: self.clamped,
            at_equilibrium: self.equilibrium,
            member_ends: match self.member_ends {
                Ends::Balance => MemberEnds::Balance,
                Ends::Cut => MemberEnds::Cut,
                Ends::Whole => MemberEnds::Whole,
            },
        }
    }
}
