//! The rotor of an ElastoDyn model, and one of its blades.

use towermodes::{BladeDescription, BladeSection, RigidBody, Rotor};

use super::super::main_input::main_file::MainFile;
use super::super::main_input::main_reader::BLADES;
use super::blade_file::BladeFile;
use super::controller::OperatingSpeeds;
use crate::note::{Note, RotorNotes};
use crate::source::Source;

/// Number of elements of a blade; larger if its table has more intervals, up to [`MOST_ELEMENTS`].
const ELEMENTS: usize = 50;
const MOST_ELEMENTS: usize = 400;

/// The rotor; `None` if its operating speeds are unknown.
///
/// The files of ElastoDyn contain only the initial speed of a simulation (`RotSpeed`). The
/// operating speeds depend on the controller.
pub(crate) fn rotor(main: &MainFile, speeds: Option<&OperatingSpeeds>) -> Option<Rotor> {
    match speeds? {
        OperatingSpeeds::Unknown(_) => None,
        OperatingSpeeds::Known(controlled) => Some(Rotor {
            blades: main.blade_count,
            lowest_rpm: controlled.rpm[0],
            highest_rpm: controlled.rpm[1],
        }),
    }
}

/// The first blade at standstill, as in ElastoDyn: it is rigid in torsion and axially, and its
/// sections have no offsets.
///
/// In ElastoDyn and BModes twist and pitch are positive towards feather, in the library in the
/// opposite direction.
pub(crate) fn blade(main: &MainFile, file: &BladeFile) -> BladeDescription {
    let elements = (file.rows.len() - 1).clamp(ELEMENTS, MOST_ELEMENTS);
    let sections = file.rows.iter().map(|row| BladeSection {
        span: row.length_fraction,
        twist_rad: 0.0 - row.twist_deg.to_radians(),
        mass_kg_per_m: file.mass_factor * row.mass_kg_per_m,
        flap_n_m2: file.flap_factor * row.flap_n_m2,
        edge_n_m2: file.edge_factor * row.edge_n_m2,
        torsion_n_m2: f64::INFINITY,
        axial_n: f64::INFINITY,
        ..BladeSection::default()
    });
    BladeDescription {
        name: main.blade_files.first().cloned().unwrap_or_default(),
        hub_radius_m: main.hub_radius_m,
        tip_radius_m: main.tip_radius_m,
        sections: sections.collect(),
        borders: (0..=elements).map(|k| k as f64 / elements as f64).collect(),
        rotor_speed_rad_per_s: 0.0,
        pitch_rad: 0.0 - main.blade_pitch_deg[0].to_radians(),
        tip: RigidBody::point(main.tip_masses_kg[0], [0.0; 3]),
        tip_is_pulled: true,
    }
}

/// The notes on the rotor, and on its blade if that was read.
pub(crate) fn notes(
    main: &MainFile,
    source: &Source,
    speeds: Option<&OperatingSpeeds>,
    has_blade: bool,
) -> RotorNotes {
    let at = |key: &str, note: Note| note.at(source, main.place(key).start);
    let mut notes = RotorNotes {
        speeds: match speeds {
            Some(OperatingSpeeds::Known(controlled)) => controlled.notes.clone(),
            Some(OperatingSpeeds::Unknown(reason)) => vec![reason.clone()],
            None => {
                let message = format!(
                    "RotSpeed = {} rpm is the initial speed of the simulation, not the range of operating speeds; read the .fst file, which refers to the controller with this range",
                    main.rotor_speed_rpm
                );
                vec![at("RotSpeed", Note::assumption(message))]
            }
        },
        ..RotorNotes::default()
    };
    if has_blade {
        let others = blade_notes(main).into_iter();
        notes.others = others.map(|(key, note)| at(key, note)).collect();
    }
    notes
}

/// The notes on the blade, each with its parameter.
fn blade_notes(main: &MainFile) -> Vec<(&'static str, Note)> {
    let mut notes = Vec::new();
    let precone_deg = main.precone_deg[0];
    if precone_deg != 0.0 {
        let message = format!(
            "PreCone(1) = {precone_deg} degrees is ignored: the blade modes are computed without cone angle"
        );
        notes.push(("PreCone(1)", Note::left_out(message)));
    }
    let pitch_deg = main.blade_pitch_deg[0];
    if pitch_deg != 0.0 {
        let message = format!(
            "BlPitch(1) = {pitch_deg} degrees, the initial pitch, is used for the blade modes at all speeds"
        );
        notes.push(("BlPitch(1)", Note::assumption(message)));
    }
    for (blade, key) in BLADES
        .into_iter()
        .enumerate()
        .take(main.blade_count)
        .skip(1)
    {
        let is_other = main.blade_files[blade] != main.blade_files[0]
            || main.tip_masses_kg[blade] != main.tip_masses_kg[0]
            || main.blade_pitch_deg[blade] != main.blade_pitch_deg[0];
        if is_other {
            let message = format!(
                "blade {} has another file, tip mass or pitch than the first; the modes are those of the first",
                blade + 1
            );
            notes.push((key, Note::assumption(message)));
        }
    }
    notes
}
