//! A tower from the files of an ElastoDyn model: main file, tower file, blade files.

use std::collections::HashMap;
use std::ops::Range;

use towermodes::{Foundation, MissingPart, Place, Plain, RigidBody};

use super::below::{Below, below};
use super::fst;
use super::fst::{Gravity, Main, gravity, main_source};
use super::machine::blade_file::{BladeFile, BladeMasses, read_blade_file};
use super::machine::controller::{OperatingSpeeds, operating_speeds};
use super::machine::lump;
use super::machine::rotor;
use super::machine::servodyn::{YawSpring, yaw_spring};
use super::machine::structural_control::{Controls, structural_controls, with_masses};
use super::machine::turbine;
use super::machine::turbine::Parts;
use super::main_input::main_file::MainFile;
use super::main_input::main_reader::{BLADES, read_main_file};
use super::names::{is_blade_file, is_main_file, is_tower_file};
use super::tower_input::description::{
    Ends, ONLY_BENDS, description, hanging_note, remember, tuner_note, upside_down,
};
use super::tower_input::tower_file::{CoefficientSpans, TowerFile};
use super::tower_input::tower_reader::{TowerReading, read_with_places};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{FileFormat, ReadOptions, RotorLock, TowerInput};
use crate::note::Note;
use crate::places::{Places, TABLE};
use crate::resolver::{FileResolver, beside, found_elsewhere};
use crate::source::Source;
use crate::turbine::TurbineReading;

/// Nacelles of turbines on towers above [`HIGH_TOWER_M`] have at least this mass, kg.
const LIGHTEST_NACELLE_KG: f64 = 1e3;
/// Smallest usual shaft tilt other than 0, degrees: 12 degrees are 0.209 rad.
const LEAST_TILT_DEG: f64 = 0.21;
/// Small turbines stand on lower towers, m.
const HIGH_TOWER_M: f64 = 40.0;

/// An ElastoDyn model and the tower that it describes.
#[derive(Debug, Clone)]
pub struct ElastoDynDeck {
    /// The content of the main file.
    pub main: MainFile,
    /// The main file.
    pub main_source: Source,
    /// The content of the tower file.
    pub tower: TowerFile,
    /// The places of the coefficients in the tower file.
    pub coefficient_spans: CoefficientSpans,
    /// The tower file.
    pub tower_source: Source,
    /// Mass and moments of each blade.
    pub blades: Vec<BladeMasses>,
    /// Everything above the tower top as one body.
    pub rna: RigidBody,
    /// The tower.
    pub input: TowerInput,
}

/// Reads an ElastoDyn model from its main file, or from the `.fst` file that refers to it; `files`
/// gives the files that it names.
///
/// # Errors
/// The first mistake in one of the files, or that one of them cannot be read.
pub fn read_elastodyn(
    source: Source,
    files: &dyn FileResolver,
    options: &ReadOptions,
) -> Result<ElastoDynDeck, ReadError> {
    refuse_parts(&source)?;
    let model = Model::read(source, files, options)?;
    let rna = model.rna(options)?;
    let input = model.input(rna, options);
    Ok(ElastoDynDeck {
        main: model.main,
        main_source: model.found.source,
        tower: model.reading.file,
        coefficient_spans: model.reading.spans.coefficients,
        tower_source: model.tower_source,
        blades: model.blades.masses,
        rna,
        input,
    })
}

/// The files of a model and their content.
struct Model {
    found: Main,
    main: MainFile,
    tower_source: Source,
    reading: TowerReading,
    blades: Blades,
    /// The note on a tower file that is not at its path.
    tower_elsewhere: Option<Note>,
    /// The yaw spring, if the nacelle yaws and there is an `.fst` file.
    yaw: Option<YawSpring>,
    /// The operating speeds, if there is an `.fst` file.
    speeds: Option<OperatingSpeeds>,
    /// The structural controls.
    controls: Controls,
    below: Below,
}

impl Model {
    fn read(
        source: Source,
        files: &dyn FileResolver,
        options: &ReadOptions,
    ) -> Result<Self, ReadError> {
        let found = main_source(source, files)?;
        let main = read_main_file(&found.source);
        let main = main.map_err(|mistake| ReadError::mistake(&found.source, mistake))?;
        let named = Named {
            source: &found.source,
            folder: &found.folder,
            files,
        };
        let tower_source = named.read(&main.tower_file, "TwrFile", main.place("TwrFile"))?;
        let (key, at) = ("TwrFile", main.place("TwrFile"));
        let tower_elsewhere = named.elsewhere(&main.tower_file, key, at.start, &tower_source);
        let reading = read_with_places(&tower_source);
        let reading = reading.map_err(|mistake| ReadError::mistake(&tower_source, mistake))?;
        let blades = match options.without_rna {
            true => Blades::default(),
            false => match blades(&main, &named) {
                // With BeamDyn, ElastoDyn reads no blade files.
                Err(_) if found.beamdyn_note.is_some() && !named.has_blades(&main) => {
                    Blades::default()
                }
                blades => blades?,
            },
        };
        let fst = found.fst.as_ref().filter(|_| main.machine_dofs.yaw);
        let yaw = fst.filter(|_| !options.without_rna);
        let yaw = yaw.map(|fst| yaw_spring(fst, files));
        let speeds = found.fst.as_ref();
        let speeds = speeds.map(|fst| operating_speeds(fst, &main, files));
        let controls = found.fst.as_ref();
        let controls = controls.map_or_else(Controls::default, |fst| {
            structural_controls(fst, &main, files)
        });
        let below = match &found.fst {
            Some(fst) if !options.clamped => below(fst, &main, &controls.platform, files)?,
            _ => Below::default(),
        };
        Ok(Self {
            speeds,
            below,
            found,
            main,
            tower_source,
            reading,
            blades,
            tower_elsewhere,
            yaw,
            controls,
        })
    }

    /// Everything above the tower top as one body; without mass if the options omit it.
    fn rna(&self, options: &ReadOptions) -> Result<RigidBody, ReadError> {
        if options.without_rna {
            return Ok(RigidBody::default());
        }
        let (main, blades) = (&self.main, &self.blades.masses);
        if options.rotor == RotorLock::Free {
            let checked = lump::check_free_rotor(main, blades);
            checked.map_err(|mistake| ReadError::mistake(&self.found.source, mistake))?;
        }
        let rna = lump::lump_rna(main, blades, options.rotor);
        let rna = with_masses(rna, &self.controls.nacelle);
        Ok(match main.tower_hangs() {
            true => upside_down(&rna),
            false => rna,
        })
    }

    /// The tower, clamped, with its notes.
    fn input(&self, rna: RigidBody, options: &ReadOptions) -> TowerInput {
        let main = &self.main;
        let ends = Ends::of(main.tower_base_m, main.tower_top_m);
        let mut notes = self.notes(ends, options);
        let mut description = description(&self.reading.file, ends, &main.header[1]);
        let dampers = self.controls.tower.iter();
        description
            .point_masses
            .extend(dampers.map(|body| ends.point_mass(body)));
        description.rna = rna.into();
        description.rotor = rotor::rotor(main, self.speeds.as_ref());
        description.missing_parts = self.missing_parts();
        description.is_clamped_by_request = options.clamped;
        description.foundation = self.below.foundation.clone();
        description.rna_inertia_is_partial = true;
        // Only as a matrix, from the lines, moorings are mirrored with a tower that hangs.
        let has_lines = self.below.parts.contains(&MissingPart::MooringLines);
        description.mooring_is_computed = has_lines && main.tower_hangs();
        if self.has_no_blades(options) {
            description.missing_parts.push(MissingPart::Blades);
        }
        let under_water = self.under_water();
        if !options.without_gravity && under_water.is_some() {
            notes.extend(under_water);
        } else if !options.without_gravity {
            let fst = self.found.fst.as_ref();
            let of_fst = fst.map(|fst| (self.found.gravity_m_per_s2, fst.name.as_str()));
            let Gravity { m_per_s2, note } = gravity(main, &self.found.source.name, of_fst);
            description.gravity_m_per_s2 = m_per_s2;
            notes.extend(note);
        }
        let blade = self.blades.files.first();
        let blade = blade.map(|file| rotor::blade(main, file));
        TowerInput {
            blades: Some(main.blade_count),
            rotor_notes: rotor::notes(
                main,
                &self.found.source,
                self.speeds.as_ref(),
                blade.is_some(),
            ),
            blade,
            notes,
            places: self.places(),
            modal_values: Some(self.reading.file.modal_values()),
            ..TowerInput::new(FileFormat::ElastoDyn, description, self.sources())
        }
        .with_turbine(self.turbine(options))
    }

    /// The note on weight and buoyancy of a turbine under water with a fixed foundation.
    fn under_water(&self) -> Option<Note> {
        let below = &self.below.foundation;
        let frame_floats = below.frame().is_some_and(|own| own.restoring.is_some());
        let floats = below.platform().is_some() || frame_floats;
        let fst = self.found.fst.as_ref();
        let fst = fst.filter(|_| !floats && !self.main.tower_hangs())?;
        fst::under_water(fst)
    }

    /// The turbine, unless the options omit the rotor-nacelle assembly.
    fn turbine(&self, options: &ReadOptions) -> TurbineReading {
        if options.without_rna {
            return TurbineReading::default();
        }
        if self.has_no_blades(options) {
            return TurbineReading::missing(self.no_blades());
        }
        let mut turbine = turbine::turbine(&Parts {
            main: &self.main,
            source: &self.found.source,
            blades: &self.blades.files,
            on_nacelle: &self.controls.nacelle,
            yaw: self.yaw.clone(),
            lock: options.rotor,
        });
        if turbine.description.is_some() {
            turbine.notes.extend(self.found.beamdyn_note.clone());
        }
        turbine
    }

    /// Whether the blades are described only by BeamDyn, without blade files of ElastoDyn.
    fn has_no_blades(&self, options: &ReadOptions) -> bool {
        !options.without_rna && self.blades.files.is_empty() && self.found.beamdyn_note.is_some()
    }

    /// The note on blades without a file of ElastoDyn.
    fn no_blades(&self) -> Note {
        let message = "CompElast is 2 and BldFile(1) is not there: the blades are defined in BeamDyn, whose files are not read, so the rotor-nacelle assembly has no blades";
        let at = self.main.place(BLADES[0]).start;
        Note::missing_part(message).at(&self.found.source, at)
    }

    /// The notes on the files, on the tower and on the rotor-nacelle assembly.
    fn notes(&self, ends: Ends, options: &ReadOptions) -> Vec<Note> {
        let main = &self.main;
        let mut notes = self.found.notes.clone();
        notes.extend(self.tower_elsewhere.clone());
        notes.extend_from_slice(&self.blades.elsewhere);
        notes.extend_from_slice(&self.controls.notes);
        if let Some(fst) = &self.found.fst {
            notes.extend(fst::notes(fst, main, &self.below.parts, options.clamped));
        }
        notes.extend_from_slice(&self.below.notes);
        notes.extend_from_slice(&self.reading.notes);
        notes.extend(tuner_note(&self.reading.file));
        notes.push(Note::new(ONLY_BENDS));
        if self.below.foundation == Foundation::Clamped {
            let fst = self.found.fst.as_ref().filter(|_| !options.clamped);
            notes.extend(foundation_note(main, fst));
        }
        notes.extend(main.tower_hangs().then(|| hanging_note(ends)));
        if !options.without_rna {
            notes.extend(self.has_no_blades(options).then(|| self.no_blades()));
            let masses = &self.blades.masses;
            notes.extend(lump::notes(main, &self.found.source, masses, options.rotor));
            notes.extend(self.light_nacelle(ends));
            notes.extend(self.tilt_in_radians());
        }
        notes
    }

    /// The note on a nacelle whose mass is probably given in t.
    fn light_nacelle(&self, ends: Ends) -> Option<Note> {
        let (mass_kg, height_m) = (self.main.nacelle_mass_kg, ends.top_m - ends.base_m);
        let is_light = mass_kg > 0.0 && mass_kg < LIGHTEST_NACELLE_KG;
        (is_light && height_m > HIGH_TOWER_M).then(|| {
            let message = format!(
                "NacMass is {} kg on a tower of {} m; nacelles of such towers weigh many tonnes: the unit is kg",
                Plain(mass_kg),
                Plain(height_m)
            );
            let at = self.main.place("NacMass").start;
            Note::suspicious(message).at(&self.found.source, at)
        })
    }

    /// The note on a shaft tilt that is probably in radians.
    fn tilt_in_radians(&self) -> Option<Note> {
        let tilt_deg = self.main.shaft_tilt_deg;
        (tilt_deg != 0.0 && tilt_deg.abs() < LEAST_TILT_DEG).then(|| {
            let message = format!(
                "ShftTilt is {} degrees, but rotor shafts are tilted by several degrees or not at all; give degrees, not radians (5 degrees are 0.0873 rad)",
                Plain(tilt_deg)
            );
            let at = self.main.place("ShftTilt").start;
            Note::suspicious(message).at(&self.found.source, at)
        })
    }

    /// The parts that the model has and the tower lacks: those of the `.fst` file, and a platform
    /// that moves where no substructure does.
    fn missing_parts(&self) -> Vec<MissingPart> {
        let read = &self.below.parts;
        let fst = self.found.fst.as_ref();
        let mut parts = fst.map_or_else(Vec::new, |fst| fst::missing_parts(fst, read));
        let moves = self.main.platform_dofs.contains(&true);
        let is_known = |part| parts.contains(&part) || read.contains(&part);
        if moves && !is_known(MissingPart::Substructure) && !is_known(MissingPart::Platform) {
            parts.insert(0, MissingPart::Platform);
        }
        parts
    }

    /// The `.fst` file if there is one, the main file, the tower file, the blade files, the
    /// controller file if it is read.
    fn sources(&self) -> Vec<Source> {
        let mut sources: Vec<Source> = self.found.fst.iter().cloned().collect();
        sources.extend([self.found.source.clone(), self.tower_source.clone()]);
        sources.extend_from_slice(&self.blades.sources);
        sources.extend_from_slice(&self.below.sources);
        if let Some(OperatingSpeeds::Known(controlled)) = &self.speeds {
            sources.push(controlled.source.clone());
        }
        sources
    }

    /// The place of each value, in the order of [`Self::sources`].
    fn places(&self) -> Places {
        let in_main = [
            (Place::Rna { key: "mass" }, "NacMass"),
            (Place::Rna { key: "center" }, "NacCMxn"),
            (Place::Rna { key: "inertia" }, "NacYIner"),
            (Place::Rna { key: TABLE }, "NacMass"),
            (Place::Gravity, "Gravity"),
            (Place::Foundation { key: "mass" }, "PtfmMass"),
            (Place::Foundation { key: "center" }, "PtfmCMzt"),
            (Place::Foundation { key: "inertia" }, "PtfmRIner"),
            (Place::Rotor { key: "blades" }, "NumBl"),
        ];
        let main = usize::from(self.found.fst.is_some());
        let mut places = Places::default();
        remember(&mut places, main + 1, &self.reading.spans);
        for (place, name) in in_main {
            places.remember(place, main, self.main.place(name));
        }
        let below = main + 2 + self.blades.sources.len();
        for (place, file, span) in &self.below.places {
            places.remember(*place, below + file, span.clone());
        }
        if let Some(OperatingSpeeds::Known(controlled)) = &self.speeds {
            let last = self.sources().len() - 1;
            places.remember(Place::Rotor { key: "rpm" }, last, controlled.place.clone());
        }
        places
    }
}

/// Refuses files that are only a part of a model.
fn refuse_parts(source: &Source) -> Result<(), ReadError> {
    let part = match &source.text {
        text if is_main_file(text) => return Ok(()),
        text if is_tower_file(text) => "tower",
        text if is_blade_file(text) => "blade",
        _ => return Ok(()),
    };
    let found = format!("a {part} file of ElastoDyn, not a main file");
    let mistake = Diagnostic::new(0..0, DiagnosticKind::WrongFile { found })
        .with_hint("give the main file that refers to it");
    Err(ReadError::mistake(source, mistake))
}

/// The files that a main file names.
struct Named<'a> {
    source: &'a Source,
    /// The folder of the main file, relative to the folder of the given file.
    folder: &'a str,
    files: &'a dyn FileResolver,
}

impl Named<'_> {
    fn read(&self, path: &str, key: &str, span: Range<usize>) -> Result<Source, ReadError> {
        self.files
            .read(&beside(self.folder, path))
            .map_err(|error| {
                let kind = DiagnosticKind::unreadable(key, &error);
                let hint = match key.starts_with("Bld") {
                    true => "files are looked for in the folder of the main file; without the rotor-nacelle assembly (--no-rna) blade files are not needed",
                    false => "files are looked for in the folder of the main file",
                };
                ReadError::mistake(self.source, Diagnostic::new(span, kind).with_hint(hint))
            })
    }
}

impl Named<'_> {
    /// The note on a file that was found at another place than at its path.
    fn elsewhere(&self, path: &str, key: &str, at: usize, found: &Source) -> Option<Note> {
        let note = found_elsewhere(self.files, key, path, found);
        note.map(|note| note.at(self.source, at))
    }

    /// Whether the file of the first blade is there.
    fn has_blades(&self, main: &MainFile) -> bool {
        let first = main.blade_files.first();
        first.is_some_and(|path| self.files.read(&beside(self.folder, path)).is_ok())
    }
}

/// The content of the blade files.
#[derive(Default)]
struct Blades {
    /// The files, each once.
    sources: Vec<Source>,
    /// Mass and moments of each blade.
    masses: Vec<BladeMasses>,
    /// The content of each blade's file.
    files: Vec<BladeFile>,
    /// Notes on files that are not at their paths.
    elsewhere: Vec<Note>,
}

fn blades(main: &MainFile, named: &Named<'_>) -> Result<Blades, ReadError> {
    let mut blades = Blades::default();
    let mut read: HashMap<&str, BladeFile> = HashMap::new();
    for (path, key) in main.blade_files.iter().zip(BLADES) {
        if !read.contains_key(path.as_str()) {
            let source = named.read(path, key, main.place(key))?;
            let at = main.place(key).start;
            blades
                .elsewhere
                .extend(named.elsewhere(path, key, at, &source));
            let blade = read_blade_file(&source).map_err(|m| ReadError::mistake(&source, m))?;
            blades.sources.push(source);
            read.insert(path, blade);
        }
        if let Some(blade) = read.get(path.as_str()) {
            blades.masses.push(blade.masses(main.blade_length_m()));
            blades.files.push(blade.clone());
        }
    }
    Ok(blades)
}

/// The note on a foundation that is not described in these files.
fn foundation_note(main: &MainFile, fst: Option<&Source>) -> Option<Note> {
    let moves = main.platform_dofs.contains(&true);
    let base_m = main.tower_base_m;
    if !moves && base_m == 0.0 {
        return None;
    }
    // A substructure that is not read (ExtPtfm) carries the platform.
    let is_dry =
        fst.is_some_and(|fst| !fst::is_on(fst, "CompHydro") && !fst::is_on(fst, "CompSub"));
    let why = match moves {
        true if is_dry => {
            " although the platform moves: CompHydro is 0, and without water it has no buoyancy"
        }
        true => " (the platform moves); its foundation is in other files",
        false => "; its foundation is in other files",
    };
    let message = format!("the tower is clamped at z = {base_m} m{why}");
    Some(match moves {
        true => Note::missing_part(message),
        false => Note::assumption(message),
    })
}
