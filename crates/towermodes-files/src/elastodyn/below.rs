//! The structure below the tower of a model of OpenFAST: the substructure in the SubDyn file to
//! which the `.fst` file refers, or the floating platform with its water and its mooring lines.

use std::ops::Range;

use towermodes::frame::{FrameFoundation, Restoring};
use towermodes::tower::STANDARD_GRAVITY_M_PER_S2;
use towermodes::{
    FloatingPlatform, Foundation, Inertia, MissingPart, MooringLines, Place, RigidBody,
};

use super::agreement::doubts;
use super::fst::{gravity_of_fst, is_on, switch};
use super::hanging;
use super::machine::structural_control::with_masses;
use super::main_input::main_file::{MainFile, Platform};
use super::names::line_of;
use super::sea::Sea;
use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact};
use crate::error::ReadError;
use crate::hydrodyn::{HydrodynInput, HydrodynPlatform, read_hydrodyn};
use crate::mooring::{MooringInput, MooringSite, read_map, read_moordyn};
use crate::note::Note;
use crate::places::TABLE;
use crate::resolver::{FileResolver, folder_of, found_elsewhere};
use crate::source::Source;
use crate::subdyn::{Interface, SoildynInput, SubdynInput, read_soildyn, read_subdyn};

/// The structure below the tower, with the files that describe it.
#[derive(Debug, Default)]
pub(super) struct Below {
    /// The foundation; clamped if there are no files of a structure below the tower.
    pub(super) foundation: Foundation,
    pub(super) notes: Vec<Note>,
    pub(super) sources: Vec<Source>,
    /// The parts of the structure that were read.
    pub(super) parts: Vec<MissingPart>,
    /// Places of its values: the file among `sources`, and the bytes there.
    pub(super) places: Vec<(Place, usize, Range<usize>)>,
}

/// Reads the structure below the tower.
///
/// # Errors
/// The first mistake in one of the files, or that one of them cannot be read.
pub(super) fn below(
    fst: &Source,
    main: &MainFile,
    on_platform: &[RigidBody],
    files: &dyn FileResolver,
) -> Result<Below, ReadError> {
    let model = Model {
        fst,
        main,
        on_platform,
        files,
    };
    match switch(fst, "CompSub") {
        Some((1, at)) if main.tower_hangs() => {
            Err(ReadError::mistake(fst, hangs_below(at..at + 1)))
        }
        Some((1, _)) => model.substructure(),
        _ if main.platform_dofs.contains(&true) => model.floater(),
        _ => Ok(Below::default()),
    }
}

/// An `.fst` file, the main file of ElastoDyn that it names, and access to the other files.
struct Model<'a> {
    fst: &'a Source,
    main: &'a MainFile,
    /// Masses on the platform, from its reference point.
    on_platform: &'a [RigidBody],
    files: &'a dyn FileResolver,
}

/// A file that the `.fst` file names.
struct Found<'a> {
    source: Source,
    /// Its folder as seen from the `.fst` file.
    folder: &'a str,
    /// The byte range of its name.
    span: Range<usize>,
    /// The note that it was found elsewhere.
    note: Option<Note>,
}

impl<'a> Model<'a> {
    /// The file whose name is on one of these lines of the `.fst` file; none if the `.fst` file has
    /// no such line: then the part is missing, which the result states.
    ///
    /// # Errors
    /// The file cannot be read: without it the model would be another structure.
    fn file(&self, module: &str, names: &[&str]) -> Result<Option<Found<'a>>, ReadError> {
        let lines = names.iter();
        let Some(line) = lines.clone().find_map(|name| line_of(&self.fst.text, name)) else {
            return Ok(None);
        };
        let named = line.file_name(names[0]);
        let Some(named) = named.map_err(|mistake| ReadError::mistake(self.fst, mistake))? else {
            return Ok(None);
        };
        let path = named.text.trim();
        let source = self.files.read(path).map_err(|error| {
            let kind = DiagnosticKind::unreadable(names[0], &error);
            let hint = format!(
                "files are looked for in the folder of the .fst file; {module} 0 leaves this part out of the model, --clamped clamps the tower at its base"
            );
            ReadError::mistake(self.fst, Diagnostic::new(named.span.clone(), kind).with_hint(hint))
        })?;
        let note = found_elsewhere(self.files, names[0], path, &source);
        Ok(Some(Found {
            folder: folder_of(path, &source),
            note: note.map(|note| note.at(self.fst, named.span.start)),
            source,
            span: named.span,
        }))
    }

    /// The substructure of SubDyn, with the platform of ElastoDyn as its transition piece, and the
    /// water on its members. If no reaction joint is fixed, it floats: its restoring stiffness is
    /// that of water plane, buoyancy and mooring lines.
    fn substructure(&self) -> Result<Below, ReadError> {
        let Some(file) = self.file("CompSub", &["SubFile", "SDFile"])? else {
            return Ok(Below::default());
        };
        let within = Within {
            folder: file.folder,
            files: self.files,
        };
        let mut subdyn = read_subdyn(file.source, &within)?;
        subdyn.notes.extend(file.note);
        let mut parts = vec![MissingPart::Substructure];
        if let Some(soil) = self.soil()? {
            subdyn.stand_on(&soil)?;
            parts.push(MissingPart::Soil);
        }
        let floats = subdyn.description.supports.is_empty();
        let reference = || Interface::Rigid(self.main.platform.reference_m);
        let structure = subdyn.frame(reference())?.body();
        let mut sea = self.sea()?;
        let water = self.water(&mut sea)?;
        if let Some(water) = water.as_ref().filter(|_| floats) {
            check_afloat(&subdyn, water)?;
        }
        let mut below = Below {
            notes: subdyn.notes.clone(),
            parts,
            ..Below::default()
        };
        if let Some(water) = &water {
            below.notes.extend(doubts(&subdyn, water, &sea));
            let on_frame = water.put_on_frame(&mut subdyn.description);
            below.notes.extend(water.notes.iter().cloned());
            below.notes.extend(on_frame);
            below.parts.push(MissingPart::Water);
        }
        let piece = with_masses(transition_piece(self.main), self.on_platform);
        let mut foundation =
            FrameFoundation::new(subdyn.frame(reference())?, piece).map_err(|error| {
                let kind = DiagnosticKind::Frame(Box::new(error));
                ReadError::mistake(self.fst, Diagnostic::new(file.span.clone(), kind))
            })?;
        below.notes.extend(held_note(
            self.main,
            "the transition piece moves with the substructure",
        ));
        let places = subdyn.places();
        let places = places.map(|(part, span)| (Place::Substructure { part }, 0, span));
        below.places = places.collect();
        below.sources = subdyn.sources;
        if floats {
            let water = water.as_ref();
            let water =
                water.ok_or_else(|| ReadError::mistake(self.fst, nothing_holds(file.span)))?;
            foundation.restoring =
                Some(self.restoring(&foundation, &structure, water, &mut below)?);
        } else if let Some(water) = water {
            below.sources.extend(water.sources);
        }
        below.foundation = Foundation::Frame(Box::new(foundation));
        Ok(below)
    }

    /// The restoring stiffness of a floating substructure: water and mooring lines.
    fn restoring(
        &self,
        foundation: &FrameFoundation,
        structure: &RigidBody,
        water: &HydrodynInput,
        below: &mut Below,
    ) -> Result<Restoring, ReadError> {
        let (mut restoring, notes) =
            water.restoring(foundation, structure, self.gravity_m_per_s2());
        below.notes.extend(notes);
        below.sources.extend(water.sources.iter().cloned());
        self.moor(&mut restoring.platform, &self.site(water), below)?;
        Ok(restoring)
    }

    /// The rigid platform with its water and its mooring lines, at its reference position.
    fn floater(&self) -> Result<Below, ReadError> {
        let Some(water) = self.water(&mut self.sea()?)? else {
            return Ok(Below::default());
        };
        let Platform {
            center_m,
            reference_m,
            ..
        } = self.main.platform;
        let masses = self.on_platform.iter();
        let masses: Vec<RigidBody> = masses.map(|body| body.moved(reference_m)).collect();
        let platform = RigidBody {
            center_m,
            ..transition_piece(self.main)
        };
        let structure = with_masses(platform, &masses);
        let gravity_m_per_s2 = self.gravity_m_per_s2();
        let HydrodynPlatform {
            mut platform,
            notes,
            ..
        } = water.platform(&structure, gravity_m_per_s2);
        let mut below = Below {
            notes: water.notes.iter().cloned().chain(notes).collect(),
            parts: vec![MissingPart::Platform, MissingPart::Water],
            ..Below::default()
        };
        let site = self.site(&water);
        // Values that no other file contains are those of HydroDyn.
        below
            .places
            .push((Place::Foundation { key: TABLE }, 0, 0..0));
        below.sources.extend(water.sources);
        self.moor(&mut platform, &site, &mut below)?;
        if self.main.tower_hangs() {
            platform = hanging::mirrored(&platform, gravity_m_per_s2);
            below.notes.push(hanging::note());
        }
        below
            .notes
            .extend(held_note(self.main, "the platform moves"));
        below.foundation = Foundation::Floating(Box::new(platform));
        Ok(below)
    }

    /// Adds the mooring lines of the MAP++ or MoorDyn file to a platform, if there is one.
    fn moor(
        &self,
        platform: &mut FloatingPlatform,
        site: &MooringSite,
        below: &mut Below,
    ) -> Result<(), ReadError> {
        let Some(lines) = self.mooring(site)? else {
            return Ok(());
        };
        let mooring = lines.mooring()?;
        let at_rest = lines.at_rest(&mooring)?;
        platform.mooring_lines = Some(Box::new(MooringLines {
            description: lines.description.clone(),
            still_water_m: 0.0,
        }));
        below.notes.extend(lines.notes.iter().cloned());
        if self.main.tower_hangs() {
            // Only a matrix can be mirrored with the tower.
            *platform = platform
                .with_linear_moorings()
                .map_err(|error| lines.mistake(error))?;
            below.notes.extend(lines.warnings(&mooring, &at_rest));
        }
        let file = below.sources.len();
        let places = lines.places();
        below
            .places
            .extend(places.map(|(place, span)| (place, file, span)));
        below.sources.push(lines.source);
        below.parts.push(MissingPart::MooringLines);
        Ok(())
    }

    fn site(&self, water: &HydrodynInput) -> MooringSite {
        MooringSite {
            depth_m: Some(water.water.depth_m),
            water_density_kg_per_m3: Some(water.water.density_kg_per_m3),
            gravity_m_per_s2: Some(self.gravity_m_per_s2()),
        }
    }

    /// The files that give the water, if there is water: the `.fst` file and the SeaState file.
    fn sea(&self) -> Result<Sea, ReadError> {
        let mut sea = Sea::default();
        sea.add(self.fst.clone());
        if is_on(self.fst, "CompHydro")
            && is_on(self.fst, "CompSeaSt")
            && let Some(file) = self.file("CompSeaSt", &["SeaStFile"])?
        {
            sea.add(file.source);
        }
        Ok(sea)
    }

    /// The content of the HydroDyn file, if there is one; the file is added to those of the water.
    fn water(&self, sea: &mut Sea) -> Result<Option<HydrodynInput>, ReadError> {
        if !is_on(self.fst, "CompHydro") {
            return Ok(None);
        }
        let Some(file) = self.file("CompHydro", &["HydroFile", "HDFile"])? else {
            return Ok(None);
        };
        let defaults = sea.defaults()?;
        sea.add(file.source.clone());
        let mut water = read_hydrodyn(file.source, self.files, file.folder, defaults)?;
        water.notes.extend(file.note);
        water.notes.extend(sea.notes());
        Ok(Some(water))
    }

    /// The content of the file of SoilDyn, if there is one.
    fn soil(&self) -> Result<Option<SoildynInput>, ReadError> {
        if !is_on(self.fst, "CompSoil") {
            return Ok(None);
        }
        let file = self.file("CompSoil", &["SoilFile"])?;
        file.map(|file| read_soildyn(file.source)).transpose()
    }

    /// The content of the file of MAP++ or MoorDyn, if there is one.
    fn mooring(&self, site: &MooringSite) -> Result<Option<MooringInput>, ReadError> {
        let is_map = match switch(self.fst, "CompMooring") {
            Some((1, _)) => true,
            Some((3, _)) => false,
            _ => return Ok(None),
        };
        let Some(file) = self.file("CompMooring", &["MooringFile"])? else {
            return Ok(None);
        };
        let mut lines = match is_map {
            true => read_map(file.source, site),
            false => read_moordyn(file.source, site),
        }?;
        lines.notes.extend(file.note);
        Ok(Some(lines))
    }

    /// Gravity as in OpenFAST: from the `.fst` file, or in earlier versions from the main file of
    /// ElastoDyn.
    fn gravity_m_per_s2(&self) -> f64 {
        let of_fst = gravity_of_fst(self.fst).ok().flatten();
        of_fst
            .or(self.main.gravity_m_per_s2)
            .unwrap_or(STANDARD_GRAVITY_M_PER_S2)
    }
}

/// The mistake of a tower that hangs below a substructure.
fn hangs_below(span: Range<usize>) -> Diagnostic {
    let message = "the tower hangs (TowerHt is below TowerBsHt), and a tower that hangs below a substructure of SubDyn is not solved";
    let hint = "CompSub 0 solves it below a rigid platform, --clamped clamped at its base";
    Diagnostic::new(span, DiagnosticKind::Unsupported(message.to_owned())).with_hint(hint)
}

/// The mistake of a substructure without any support, including water.
fn nothing_holds(span: Range<usize>) -> Diagnostic {
    let message = "the substructure of SubDyn has no support: no reaction joint is fixed, and no HydroDyn file gives buoyancy";
    let hint = "fix reaction joints, give CompHydro 1 and a HydroFile for a floater, or use --clamped for the tower alone";
    Diagnostic::new(span, DiagnosticKind::Unsupported(message.to_owned())).with_hint(hint)
}

/// Refuses a structure without supports that stands on the seabed.
fn check_afloat(subdyn: &SubdynInput, water: &HydrodynInput) -> Result<(), ReadError> {
    let joints = subdyn.description.joints.iter();
    let lowest = joints.min_by(|a, b| a.position_m[2].total_cmp(&b.position_m[2]));
    let Some(lowest) = lowest.filter(|joint| water.water.is_on_seabed(joint.position_m[2])) else {
        return Ok(());
    };
    let message = format!(
        "no reaction joint is fixed, so the substructure floats, but its joint {} at z = {} m is on the seabed, which is at z = {} m",
        lowest.name,
        Exact(lowest.position_m[2]),
        Exact(-water.water.depth_m)
    );
    let source = &subdyn.sources[0];
    let count = line_of(&source.text, "NReact").and_then(|line| line.first());
    let span = count.map_or(0..0, |token| token.span);
    let hint = "add the joints on the seabed to the table of reaction joints, with flags 1 or a file of soil stiffness; the joints of a floater end above the seabed";
    let kind = DiagnosticKind::Contradiction(message);
    Err(ReadError::mistake(
        source,
        Diagnostic::new(span, kind).with_hint(hint),
    ))
}

/// The platform of ElastoDyn, with its centre from the reference point.
fn transition_piece(main: &MainFile) -> RigidBody {
    let platform = &main.platform;
    let [roll, pitch, yaw] = platform.inertia_kg_m2;
    let [xy, yz, xz] = platform.products_kg_m2;
    RigidBody {
        mass_kg: platform.mass_kg,
        center_m: std::array::from_fn(|i| platform.center_m[i] - platform.reference_m[i]),
        inertia_kg_m2: Inertia {
            xx: roll,
            yy: pitch,
            zz: yaw,
            xy,
            yz,
            xz,
        },
    }
}

/// The note that motions of the platform that the file fixes are free in this program.
fn held_note(main: &MainFile, what_moves: &str) -> Option<Note> {
    let is_held = main.platform_dofs.contains(&false);
    is_held.then(|| {
        let message = format!(
            "some motions of the platform are switched off in ElastoDyn (PtfmSgDOF to PtfmYDOF), but {what_moves} in all six"
        );
        Note::assumption(message)
    })
}

/// The files of a folder, as seen from the folder of the `.fst` file.
struct Within<'a> {
    folder: &'a str,
    files: &'a dyn FileResolver,
}

impl FileResolver for Within<'_> {
    fn read(&self, path: &str) -> Result<Source, crate::source::FileError> {
        self.files.read(&crate::resolver::beside(self.folder, path))
    }
}
