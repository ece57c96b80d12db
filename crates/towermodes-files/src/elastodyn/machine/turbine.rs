//! The turbine with rotating rotor of an ElastoDyn model: nacelle, drivetrain and flexible blades.

use towermodes::turbine::RotorError;
use towermodes::turbine::{Generator, Hub, TurbineDescription, TurbineError};
use towermodes::{BladeDescription, Plain, RigidBody};

use super::super::main_input::main_file::MainFile;
use super::super::main_input::main_reader::{BLADE_DOFS, BLADES, PITCH, PRECONE, TIP_MASS};
use super::blade_file::BladeFile;
use super::lump::nacelle;
use super::rotor;
use super::servodyn::YawSpring;
use super::structural_control::with_masses;
use crate::input::RotorLock;
use crate::note::Note;
use crate::source::Source;
use crate::turbine::{MOST_SECTIONS, TurbineReading, blade_borders};

/// The parts of the turbine of a model.
pub(crate) struct Parts<'a> {
    pub(crate) main: &'a MainFile,
    /// The main file.
    pub(crate) source: &'a Source,
    /// The content of each blade's file.
    pub(crate) blades: &'a [BladeFile],
    /// The masses of structural controls on the nacelle, measured from the tower top.
    pub(crate) on_nacelle: &'a [RigidBody],
    /// The yaw spring; none if the nacelle does not yaw or if there is no `.fst` file.
    pub(crate) yaw: Option<YawSpring>,
    pub(crate) lock: RotorLock,
}

/// Why there is no turbine: the parameter that shows it, and the sentence.
type Reason = (&'static str, String);

/// The turbine, or the reason why there is none.
pub(crate) fn turbine(parts: &Parts<'_>) -> TurbineReading {
    if let Some(YawSpring::Impossible(reason)) = &parts.yaw {
        return TurbineReading::missing(reason.clone());
    }
    let missing = |(key, message): Reason| {
        let at = parts.main.place(key).start;
        TurbineReading::missing(Note::missing_part(message).at(parts.source, at))
    };
    if let Some(reason) = reason(parts) {
        return missing(reason);
    }
    let checked = TurbineReading::checked(description(parts), notes(parts));
    checked.unwrap_or_else(|error| missing((parameter_of(&error), error.to_string())))
}

/// The first property of a model that is impossible for a turbine, or that the program does not
/// solve.
fn reason(parts: &Parts<'_>) -> Option<Reason> {
    let main = parts.main;
    let blades = main.blade_count;
    if main.tower_hangs() {
        let message =
            "a turbine on a hanging tower is not supported: its rotor would be below the tower";
        return Some(("TowerHt", message.to_owned()));
    }
    if main.furling {
        let message = "Furling is True: a furling rotor and tail (FurlFile) are not supported; for the frequencies of the turbine Furling must be False";
        return Some(("Furling", message.to_owned()));
    }
    if blades < 3 {
        let of_teeter = match blades == 2 && main.machine_dofs.teeter {
            true => "; teeter (TeetDOF) is not supported either",
            false => "",
        };
        let message = RotorError::TooFewBlades { blades };
        return Some(("NumBl", format!("{message}{of_teeter}")));
    }
    unlike_blades(parts)
        .or_else(|| too_many_rows(parts))
        .or_else(|| missing_spring(main))
}

/// Different blades would make the coefficients of the equations periodic.
fn unlike_blades(parts: &Parts<'_>) -> Option<Reason> {
    let main = parts.main;
    let (first, others) = parts.blades.split_first()?;
    if let Some(index) = others.iter().position(|blade| blade != first) {
        let key = BLADES.get(index + 1).copied()?;
        let (number, own, other) = (
            index + 2,
            main.blade_files.get(index + 1)?,
            main.blade_files.first()?,
        );
        let message = format!(
            "blade {number} ({own}) has another table or other factors than blade 1 ({other}): different blades are not supported; all files BldFile must have the same content"
        );
        return Some((key, message));
    }
    let of_blades = [
        (PRECONE, main.precone_deg, "degrees"),
        (PITCH, main.blade_pitch_deg, "degrees"),
        (TIP_MASS, main.tip_masses_kg, "kg"),
    ];
    of_blades.into_iter().find_map(|(keys, values, unit)| {
        let values = &values[..main.blade_count.min(3)];
        let index = values.iter().position(|value| *value != values[0])?;
        let (key, own, first) = (keys[index], values[index], values[0]);
        let message = format!(
            "{key} is {} {unit} and {} is {} {unit}: different blades are not supported; both must be equal",
            Plain(own),
            keys[0],
            Plain(first)
        );
        Some((key, message))
    })
}

fn too_many_rows(parts: &Parts<'_>) -> Option<Reason> {
    let rows = parts.blades.first()?.rows.len();
    (rows > MOST_SECTIONS).then(|| {
        let message = format!(
            "the blade file has {rows} rows: blades of more than {MOST_SECTIONS} sections are not supported on a tower; keep every second row, or fewer"
        );
        (BLADES[0], message)
    })
}

fn missing_spring(main: &MainFile) -> Option<Reason> {
    (main.machine_dofs.shaft && main.shaft_n_m_per_rad == 0.0).then(|| {
        let message = "DTTorSpr is 0 N m/rad although DrTrDOF is True: nothing holds rotor and generator together; DTTorSpr must be greater than 0, or DrTrDOF False for a rigid shaft";
        ("DTTorSpr", message.to_owned())
    })
}

/// The turbine of a model that has one.
fn description(parts: &Parts<'_>) -> TurbineDescription {
    let main = parts.main;
    TurbineDescription {
        nacelle: with_masses(nacelle(main), parts.on_nacelle),
        yaw_bearing_mass_kg: main.yaw_bearing_mass_kg,
        yaw_n_m_per_rad: match parts.yaw {
            Some(YawSpring::Given(stiffness)) => stiffness,
            _ => f64::INFINITY,
        },
        overhang_m: main.overhang_m,
        tower_to_shaft_m: main.tower_to_shaft_m,
        tilt_rad: main.shaft_tilt_deg.to_radians(),
        hub: Hub {
            mass_kg: main.hub_mass_kg,
            center_m: main.hub_center_m,
            polar_inertia_kg_m2: main.hub_inertia_kg_m2,
            transverse_inertia_kg_m2: 0.0,
        },
        shaft_n_m_per_rad: match main.machine_dofs.shaft {
            true => main.shaft_n_m_per_rad,
            false => f64::INFINITY,
        },
        generator: Generator {
            inertia_kg_m2: main.generator_inertia_kg_m2,
            gear_ratio: main.gearbox_ratio,
            is_locked: !turns_freely(parts),
        },
        blades: main.blade_count,
        cone_rad: main.precone_deg[0].to_radians(),
        blade: parts
            .blades
            .first()
            .map(|file| blade(main, file))
            .unwrap_or_default(),
    }
}

/// Whether the generator rotates freely: in the model, or by an option of the user.
fn turns_freely(parts: &Parts<'_>) -> bool {
    parts.main.machine_dofs.generator || parts.lock == RotorLock::Free
}

/// A blade whose twist and pitch are positive towards feather, as in ElastoDyn.
fn blade(main: &MainFile, file: &BladeFile) -> BladeDescription {
    let mut blade = rotor::blade(main, file);
    // A tower file, which a turbine is written to, has no names of blades.
    blade.name.clear();
    for section in &mut blade.sections {
        section.twist_rad = 0.0 - section.twist_rad;
    }
    blade.pitch_rad = 0.0 - blade.pitch_rad;
    blade.borders = blade_borders(&blade.sections);
    blade
}

/// The notes on the turbine.
fn notes(parts: &Parts<'_>) -> Vec<Note> {
    let main = parts.main;
    let at = |key: &str, note: Note| note.at(parts.source, main.place(key).start);
    let mut notes = Vec::new();
    notes.push(at("GenDOF", generator_note(parts)));
    let stiffness = main.shaft_n_m_per_rad;
    if !main.machine_dofs.shaft && stiffness > 0.0 {
        let message = format!(
            "DrTrDOF is False: the shaft is rigid, and DTTorSpr = {} N m/rad is left out",
            Plain(stiffness)
        );
        notes.push(at("DrTrDOF", Note::left_out(message)));
    }
    notes.extend(yaw_note(parts));
    if let Some(index) = main.blade_dofs.iter().position(|moves| !moves) {
        let key = BLADE_DOFS[index];
        let message =
            format!("{key} is False, but here all bending modes of the blades are included");
        notes.push(at(key, Note::assumption(message)));
    }
    if main.pitch_dof {
        let message = "PitchDOF is True, but the blades do not rotate on their pitch bearings here";
        notes.push(at("PitchDOF", Note::left_out(message)));
    }
    let pitch_deg = main.blade_pitch_deg[0];
    if pitch_deg != 0.0 {
        let message = format!(
            "BlPitch(1) = {pitch_deg} degrees, the initial pitch, applies to all blades at all speeds"
        );
        notes.push(at("BlPitch(1)", Note::assumption(message)));
    }
    notes
}

/// The note on the state of the generator.
fn generator_note(parts: &Parts<'_>) -> Note {
    match (parts.main.machine_dofs.generator, parts.lock) {
        (true, _) => {
            Note::new("GenDOF is True: the generator of the operating turbine rotates freely")
        }
        (false, RotorLock::Free) => Note::assumption(
            "GenDOF is False, but the generator of the operating turbine rotates freely, as requested by --rotor free",
        ),
        (false, RotorLock::Locked) => Note::new(
            "GenDOF is False: the generator of the operating turbine has a constant speed",
        ),
    }
}

/// The note on a nacelle that should yaw but does not.
fn yaw_note(parts: &Parts<'_>) -> Option<Note> {
    if !parts.main.machine_dofs.yaw {
        return None;
    }
    match &parts.yaw {
        Some(YawSpring::Unknown(note)) => Some(note.clone()),
        Some(_) => None,
        None => {
            let message = "YawDOF is True, but the spring YawSpr of the yaw drive is in the file of ServoDyn: the nacelle does not yaw on the tower; give the .fst file, which names that file";
            let at = parts.main.place("YawDOF").start;
            Some(Note::assumption(message).at(parts.source, at))
        }
    }
}

/// The parameter that an error of the library is about.
fn parameter_of(error: &TurbineError) -> &'static str {
    let quantity = match error {
        TurbineError::Blade(_) => return BLADES[0],
        TurbineError::Generator { .. } => "the inertia of the generator",
        TurbineError::Angle { quantity, .. }
        | TurbineError::NotFinite { quantity, .. }
        | TurbineError::Negative { quantity, .. }
        | TurbineError::NotPositive { quantity, .. } => *quantity,
        _ => "",
    };
    let of_quantities = [
        ("tilt", "ShftTilt"),
        ("cone", PRECONE[0]),
        ("gear ratio", "GBRatio"),
        ("generator", "GenIner"),
        ("hub", "HubMass"),
        ("nacelle", "NacMass"),
    ];
    let mut of_quantities = of_quantities.into_iter();
    of_quantities
        .find(|(word, _)| quantity.contains(word))
        .map_or("NumBl", |(_, key)| key)
}
