//! The result of a reader: the description of a tower or blade, and the place of each value.

use towermodes::turbine::TurbineDescription;
use towermodes::{Place, Plain, Planes, Tower, TowerDescription, TowerError};
use towermodes_analysis::elastodyn::Damping;

use crate::diagnostic::line_and_column;
use crate::error::ReadError;
pub(crate) use crate::note::{Note, RotorNotes};
use crate::places::Places;
use crate::prescribed::Prescribed;
use crate::source::Source;

/// The kinds of file that describe a tower, a blade, a substructure or a mooring system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileFormat {
    /// A tower file of this program.
    Toml,
    /// A main input file of BModes.
    Bmodes,
    /// A main input file of ElastoDyn, with its tower and blade files.
    ElastoDyn,
    /// An ElastoDyn tower file without a main file.
    ElastoDynTower,
    /// A turbine in windIO, version 1 or 2.
    WindIo,
    /// A structural file of HAWC2.
    Hawc2,
    /// An input file of SubDyn.
    SubDyn,
    /// An input file of MoorDyn.
    MoorDyn,
    /// An input file of MAP++.
    Map,
}

impl FileFormat {
    /// The name of the format.
    pub fn name(self) -> &'static str {
        match self {
            Self::Toml => "TOML",
            Self::Bmodes => "BModes",
            Self::ElastoDyn => "ElastoDyn",
            Self::ElastoDynTower => "ElastoDyn tower",
            Self::WindIo => "windIO",
            Self::Hawc2 => "HAWC2",
            Self::SubDyn => "SubDyn",
            Self::MoorDyn => "MoorDyn",
            Self::Map => "MAP++",
        }
    }
}

/// A tower as its files describe it, before the library has checked it.
#[derive(Debug, Clone)]
pub struct TowerInput {
    /// The kind of file.
    pub format: FileFormat,
    /// The content of the files; it may be changed before it is checked.
    pub description: TowerDescription,
    /// Options that the file prescribes for the solution.
    pub prescribed: Prescribed,
    /// Number of blades, if the files give it; they may give it without the rotor speed.
    pub blades: Option<usize>,
    /// One of the rotor's blades at standstill, if the files describe it.
    pub blade: Option<towermodes::BladeDescription>,
    /// Nacelle, drivetrain and flexible blades, if the files describe them and if the program can
    /// solve the modes of this turbine ([`Self::whole_turbine`]). The description of the tower
    /// contains all of it as a rigid body.
    pub turbine: Option<TurbineDescription>,
    /// Why there is no turbine, if the files describe a rotor on the tower; [`None`] if they
    /// describe only the tower, or if there is a turbine.
    pub turbine_missing: Option<Note>,
    /// Notes on the turbine, which apply only if it is used.
    pub turbine_notes: Vec<Note>,
    /// Height of the joint between monopile and tower, m, if there is a monopile.
    pub joint_m: Option<f64>,
    /// The damping and the tuners of the modes, if a tower file of ElastoDyn gives them.
    pub(crate) modal_values: Option<ModalValues>,
    /// The layout of results that the file prescribes.
    pub layout: OutLayout,
    /// Notes on decisions of the reader and on omitted or unusable data.
    pub notes: Vec<Note>,
    /// Notes on the rotor and the blade, which apply only if these are used.
    pub rotor_notes: RotorNotes,
    /// The files, the main one first.
    pub(crate) sources: Vec<Source>,
    /// Texts with the input values that were set by name after the files were read.
    pub(crate) settings: Vec<Source>,
    /// The places of the values: first in the files, then in the settings.
    pub(crate) places: Places,
}

impl TowerInput {
    /// A description from files that prescribe nothing for the solution.
    pub(crate) fn new(
        format: FileFormat,
        description: TowerDescription,
        sources: Vec<Source>,
    ) -> Self {
        Self {
            format,
            blades: description.rotor.map(|rotor| rotor.blades),
            description,
            prescribed: Prescribed::default(),
            blade: None,
            turbine: None,
            turbine_missing: None,
            turbine_notes: Vec::new(),
            joint_m: None,
            modal_values: None,
            layout: OutLayout::default(),
            notes: Vec::new(),
            rotor_notes: RotorNotes::default(),
            sources,
            settings: Vec::new(),
            places: Places::default(),
        }
    }

    /// The input of a program that makes the description itself: a tower file without text.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Material, Rna, Station, TowerDescription};
    /// use towermodes_files::TowerInput;
    ///
    /// let input = TowerInput::from_description(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     rna: Rna::point(350e3),
    ///     ..TowerDescription::default()
    /// });
    /// assert_eq!(input.tower()?.height_m(), 87.6);
    /// # Ok::<(), towermodes_files::ReadError>(())
    /// ```
    pub fn from_description(description: TowerDescription) -> Self {
        let source = Source {
            name: "<description>".to_owned(),
            text: String::new(),
        };
        Self::new(FileFormat::Toml, description, vec![source])
    }

    /// The tower.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] at the place of a value that is impossible for a tower.
    pub fn tower(&self) -> Result<Tower, ReadError> {
        Tower::new(self.description.clone()).map_err(|error| self.tower_mistake(&error))
    }

    /// An error of the tower, at its place in the file.
    pub(crate) fn tower_mistake(&self, error: &TowerError) -> ReadError {
        let is_toml = self.format == FileFormat::Toml;
        let (file, mut diagnostic) = self.places.mistake(error, is_toml, self.sources.len());
        if let Place::Mooring { item } = error.place
            && let Some(name) = self.description.part_names.of_mooring(item)
            && name != item.to_string()
        {
            let hint = diagnostic.hint.map_or(String::new(), |hint| hint + "; ");
            diagnostic.hint = Some(format!("{hint}{item} is `{name}`"));
        }
        if let Some(settings) = self.settings.last().filter(|_| file < self.sources.len()) {
            let hint = diagnostic.hint.map_or(String::new(), |hint| hint + "; ");
            let by = &settings.name;
            diagnostic.hint = Some(format!(
                "{hint}the line shown is from the file, without the change by {by}"
            ));
        }
        ReadError::mistake(self.source(file), diagnostic)
    }

    /// A file by its index among the files and settings.
    pub(crate) fn source(&self, file: usize) -> &Source {
        let mut sources = self.sources.iter().chain(&self.settings);
        sources.nth(file).unwrap_or(&self.sources[0])
    }

    /// The tower whose mode shapes are fitted for ElastoDyn, from [`Self::description_for_shapes`].
    ///
    /// # Errors
    /// As [`TowerInput::tower`].
    pub fn tower_for_shapes(&self) -> Result<Tower, ReadError> {
        let input = Self {
            description: self.description_for_shapes(),
            ..self.clone()
        };
        input.tower()
    }

    /// The description for the mode shapes of ElastoDyn.
    ///
    /// An ElastoDyn model is then without gravity, as are the modes of BModes, from which these
    /// shapes are usually made: ElastoDyn adds the geometric stiffness of the self-weight itself. A
    /// floating model keeps gravity, because its stiffness depends on weight and buoyancy. Any
    /// other tower is as its file describes it.
    pub fn description_for_shapes(&self) -> TowerDescription {
        let mut description = self.description.clone();
        if self.format == FileFormat::ElastoDyn && description.foundation.floating().is_none() {
            description.gravity_m_per_s2 = 0.0;
        }
        description
    }

    /// The note on gravity in these modes, if the description is of an ElastoDyn model with
    /// gravity.
    pub fn note_on_shapes(&self) -> Option<Note> {
        let has_gravity = self.description.gravity_m_per_s2 != 0.0;
        let floats = self.description.foundation.floating().is_some();
        (self.format == FileFormat::ElastoDyn && has_gravity).then(|| {
            Note::new(match floats {
                false => "the shapes are computed without gravity, as in BModes, because ElastoDyn itself adds the geometric stiffness of the self-weight",
                true => "the shapes are computed with gravity, because the stiffness of the floating platform depends on weight and buoyancy",
            })
        })
    }

    /// The damping ratios for an ElastoDyn tower file made from this tower: those of the tower file
    /// that was read, otherwise 1 %.
    pub fn damping_for_tower_file(&self) -> Damping {
        let given = self.modal_values.as_ref();
        given.map_or(Damping::Written(1.0), |values| {
            Damping::Kept(values.damping_percent)
        })
    }

    /// The notes on a tower file made from this tower: on gravity, and on the tuners.
    pub fn notes_on_tower_file(&self) -> Vec<Note> {
        let notes = [self.note_on_shapes(), self.note_on_written_tuners()];
        notes.into_iter().flatten().collect()
    }

    /// The note that the tuners of the tower file that was read are 1 in a newly written one.
    fn note_on_written_tuners(&self) -> Option<Note> {
        let values = self.modal_values.as_ref()?;
        let [fore_aft, side_side] = [values.tuners.fore_aft, values.tuners.side_side];
        let is_tuned = [fore_aft, side_side]
            .as_flattened()
            .iter()
            .any(|tuner| *tuner != 1.0);
        is_tuned.then(|| {
            let list = |[first, second]: [f64; 2]| {
                format!("{} and {}", Plain(first), Plain(second))
            };
            Note::left_out(format!(
                "the tuners FAStTunr ({}) and SSStTunr ({}) are reset to 1 in the written file: they were chosen for other shapes",
                list(fore_aft),
                list(side_side)
            ))
        })
    }

    /// File and line (from 1) of a value; none if no file contains it.
    pub fn line_of(&self, place: Place) -> Option<(&str, usize)> {
        let (file, span) = self.places.own(place)?;
        let source = self.source(*file);
        let (line, _) = line_and_column(&source.text, span.start);
        Some((&source.name, line))
    }

    /// The setting by name that determines a value, such as `rna.mass=360000`; none for a value of
    /// a file.
    pub fn setting_of(&self, place: Place) -> Option<&str> {
        let (file, span) = self.places.own(place)?;
        let settings = self.settings.get(file.checked_sub(self.sources.len())?)?;
        let before = settings.text.get(..span.start)?;
        let start = before.rfind('\n').map_or(0, |end| end + 1);
        settings.text.get(start..)?.lines().next()
    }

    /// The radius of the rotor, m, if the files have a blade.
    pub fn tip_radius_m(&self) -> Option<f64> {
        let of_turbine = self.turbine.as_ref().map(|turbine| &turbine.blade);
        of_turbine
            .or(self.blade.as_ref())
            .map(|blade| blade.tip_radius_m)
    }

    /// The files that were read, the main one first.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|source| source.name.as_str())
    }

    /// The files that were read, with their texts.
    pub fn sources(&self) -> &[Source] {
        &self.sources
    }
}

/// Values of an ElastoDyn tower file that describe the modes instead of the tower.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ModalValues {
    /// Structural damping of the first and second mode, percent of critical.
    pub(crate) damping_percent: Planes<[f64; 2]>,
    /// Factors on their modal stiffnesses.
    pub(crate) tuners: Planes<[f64; 2]>,
}

/// The layout of results that a BModes deck prescribes.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct OutLayout {
    /// The length by which deflections are divided, m: the radius plus the draft, if it is
    /// prescribed.
    pub radius_m: Option<f64>,
    /// Whether tabs separate the columns (`TabDelim`).
    pub tab_delimited: bool,
    /// Whether the twist at the middle of elements is printed too (`mid_node_tw`).
    pub mid_node_twist: bool,
}

/// Options for reading files whose format leaves a choice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReadOptions {
    /// Whether a BModes deck is interpreted as by BModes 3.00, including its errors.
    pub bmodes_quirks: bool,
    /// Height of the tower's top above ground or sea level, m, for files that do not give it.
    pub tower_height_m: Option<f64>,
    /// Height of the tower's base above ground or sea level, m, for files that do not give it; by
    /// default 0.
    pub tower_base_m: Option<f64>,
    /// Whether the rotor-nacelle assembly is omitted; files that describe only this are then not
    /// needed.
    pub without_rna: bool,
    /// The part of a turbine.
    pub part: TowerPart,
    /// The numbers of the set and of the subset in a structural file of HAWC2; by default the first
    /// ones.
    pub hawc2_subset: Option<(usize, usize)>,
    /// The state of the rotor of an ElastoDyn model: parked or free.
    pub rotor: RotorLock,
    /// Whether gravity is omitted, even if the file has it.
    pub without_gravity: bool,
    /// Whether a tower of OpenFAST is clamped at its base, even if there are files of the structure
    /// below it.
    pub clamped: bool,
    /// Whether the mooring lines of a floating platform have their stiffness at the equilibrium
    /// instead of the reference position, even if the file does not request this.
    pub at_equilibrium: bool,
    /// Ends of the members of the floating platform of a windIO file.
    pub member_ends: MemberEnds,
}

/// The state of a rotor, which determines the inertia of rotor and generator that acts on the
/// nacelle about the shaft.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum RotorLock {
    /// The rotor moves with the nacelle, as with a brake on the shaft.
    #[default]
    Locked,
    /// The rotor rotates freely: no torque acts on the shaft.
    Free,
}

impl Default for ReadOptions {
    fn default() -> Self {
        Self {
            bmodes_quirks: false,
            tower_height_m: None,
            tower_base_m: None,
            without_rna: false,
            part: TowerPart::All,
            hawc2_subset: None,
            rotor: RotorLock::Locked,
            without_gravity: false,
            clamped: false,
            at_equilibrium: false,
            member_ends: MemberEnds::Balance,
        }
    }
}

/// Ends of the members of the floating platform of a windIO file that the file lets begin or end at
/// the axis of another member. The file does not contain this choice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum MemberEnds {
    /// At the surface of the other member, unless the sum of weight, buoyancy and mooring force is
    /// closer to zero with members that end at the axis.
    #[default]
    Balance,
    /// At the surface of the other member, as in WISDEM.
    Cut,
    /// At the axis of the other member: the volume where they overlap counts twice.
    Whole,
}

/// The part of a turbine that is read from a file with several parts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum TowerPart {
    /// The tower, on its monopile if there is one.
    #[default]
    All,
    /// Only the tower, from its own base.
    Tower,
    /// Only the monopile.
    Monopile,
}

/// A blade as its files describe it.
#[derive(Debug, Clone)]
pub struct BladeInput {
    /// The content of the files.
    pub description: towermodes::BladeDescription,
    /// The number of modes that the file requests.
    pub modes: usize,
    /// The layout of results that the file prescribes.
    pub layout: OutLayout,
    /// Notes on decisions of the reader and on omitted or unusable data.
    pub notes: Vec<Note>,
    /// The files, the main one first.
    pub(crate) sources: Vec<Source>,
}

impl BladeInput {
    /// The files that were read, the main one first.
    pub fn files(&self) -> impl Iterator<Item = &str> {
        self.sources.iter().map(|source| source.name.as_str())
    }
}
