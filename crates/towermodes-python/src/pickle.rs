//! The state of a tower as Python values, for pickles.
//!
//! The description is stored as the text of a tower file, which is read back with exactly the same
//! values; other data are stored with this text. The places of the values in the original files are
//! not stored.

use pyo3::prelude::*;
use pyo3::types::PyTuple;
use towermodes::{BladeDescription, BladeSection, Inertia, Method, RigidBody};
use towermodes_files::{
    FileFormat, Note, NoteKind, RotorNotes, TowerInput, write_toml, write_toml_with,
};

use crate::error::usage;
use crate::input::input_of_text;

/// The name of the text of a tower from a pickle.
pub const PICKLED: &str = "<pickle>.toml";

/// The kind, the sentence and the place of a note.
type NoteState = (u8, String, Option<(String, usize)>);

/// Notes on rotor speeds, notes on blades, and other notes.
type RotorState = (Vec<NoteState>, Vec<NoteState>, Vec<NoteState>);

/// Name; radii of hub and tip, rotor speed and pitch angle; sections; element boundaries; body at
/// the tip; whether the centrifugal force acts on this body.
type BladeState = (String, [f64; 4], Vec<[f64; 11]>, Vec<f64>, [f64; 10], bool);

/// Method, modes, blades.
type Prescribed = (Option<String>, Option<usize>, Option<usize>);

/// Whether only some moments of inertia of the assembly are given, and whether the mooring
/// stiffness was computed.
type Origins = (bool, bool);

/// Text of the tower file, format, notes, rotor notes, prescribed options, element borders, joint
/// with the monopile, blade, text of a tower file with the turbine, origins of values.
type State = (
    String,
    String,
    Vec<NoteState>,
    RotorState,
    Prescribed,
    Option<Vec<f64>>,
    Option<f64>,
    Option<BladeState>,
    Option<String>,
    Origins,
);

const FORMATS: [FileFormat; 9] = [
    FileFormat::Toml,
    FileFormat::Bmodes,
    FileFormat::ElastoDyn,
    FileFormat::ElastoDynTower,
    FileFormat::WindIo,
    FileFormat::Hawc2,
    FileFormat::SubDyn,
    FileFormat::MoorDyn,
    FileFormat::Map,
];

const KINDS: [NoteKind; 8] = [
    NoteKind::Information,
    NoteKind::Assumption,
    NoteKind::LeftOut,
    NoteKind::Approximation,
    NoteKind::MissingPart,
    NoteKind::RigidRotor,
    NoteKind::Compatibility,
    NoteKind::Suspicious,
];

/// The state of an input.
pub fn state<'py>(py: Python<'py>, input: &TowerInput) -> PyResult<Bound<'py, PyTuple>> {
    let method = input
        .prescribed
        .method
        .map(|method| method.name().to_owned());
    let rotor = &input.rotor_notes;
    let state: State = (
        write_toml(&input.description).0,
        input.format.name().to_owned(),
        notes_state(&input.notes),
        (
            notes_state(&rotor.speeds),
            notes_state(&rotor.blades),
            notes_state(&rotor.others),
        ),
        (method, input.prescribed.modes, input.blades),
        input.prescribed.borders_m.clone(),
        input.joint_m,
        input.blade.as_ref().map(blade_state),
        with_turbine(input),
        (
            input.description.rna_inertia_is_partial,
            input.description.mooring_is_computed,
        ),
    );
    state.into_pyobject(py)
}

/// The input of a state.
///
/// # Errors
/// `ValueError` if the state is of another version.
pub fn restored(state: &Bound<'_, PyTuple>) -> PyResult<TowerInput> {
    let state: State = state.extract()?;
    let (
        text,
        format,
        notes,
        rotor,
        (method, modes, blades),
        borders_m,
        joint_m,
        blade,
        whole,
        (rna_inertia_is_partial, mooring_is_computed),
    ) = state;
    let mut input = input_of_text(text, PICKLED.to_owned())?;
    input.description.rna_inertia_is_partial = rna_inertia_is_partial;
    input.description.mooring_is_computed = mooring_is_computed;
    let format = FORMATS.into_iter().find(|own| own.name() == format);
    input.format = format.ok_or_else(unknown)?;
    input.notes = notes_of(notes)?;
    input.rotor_notes = RotorNotes {
        speeds: notes_of(rotor.0)?,
        blades: notes_of(rotor.1)?,
        others: notes_of(rotor.2)?,
    };
    let named = |name: String| Method::named(&name).ok_or_else(unknown);
    input.prescribed = towermodes_files::Prescribed {
        method: method.map(named).transpose()?,
        borders_m,
        modes,
    };
    input.blades = blades;
    input.joint_m = joint_m;
    input.blade = blade.map(blade_of);
    if let Some(whole) = whole {
        // The tower is that of the other text, to the last digit.
        input.turbine = input_of_text(whole, PICKLED.to_owned())?.turbine;
    }
    Ok(input)
}

/// The text of a tower file with the turbine.
fn with_turbine(input: &TowerInput) -> Option<String> {
    let turbine = input.turbine.as_ref()?;
    Some(write_toml_with(&input.description, Some(turbine)).0)
}

fn unknown() -> PyErr {
    usage("the pickle was written by another version of towermodes")
}

fn notes_state(notes: &[Note]) -> Vec<NoteState> {
    let kind = |note: &Note| KINDS.iter().position(|kind| *kind == note.kind);
    let state = |note: &Note| {
        // A kind that this list lacks is read as information.
        let kind = kind(note).unwrap_or(0) as u8;
        (kind, note.message.clone(), note.place.clone())
    };
    notes.iter().map(state).collect()
}

fn notes_of(notes: Vec<NoteState>) -> PyResult<Vec<Note>> {
    let note = |(kind, message, place): NoteState| {
        let kind = *KINDS.get(usize::from(kind)).ok_or_else(unknown)?;
        Ok(Note {
            kind,
            message,
            place,
        })
    };
    notes.into_iter().map(note).collect()
}

fn blade_state(blade: &BladeDescription) -> BladeState {
    let section = |section: &BladeSection| {
        [
            section.span,
            section.twist_rad,
            section.mass_kg_per_m,
            section.flap_inertia_kg_m,
            section.edge_inertia_kg_m,
            section.flap_n_m2,
            section.edge_n_m2,
            section.torsion_n_m2,
            section.axial_n,
            section.center_of_mass_m,
            section.tension_center_m,
        ]
    };
    let RigidBody {
        mass_kg,
        center_m: [x, y, z],
        inertia_kg_m2: inertia,
    } = blade.tip;
    let Inertia {
        xx,
        yy,
        zz,
        xy,
        xz,
        yz,
    } = inertia;
    (
        blade.name.clone(),
        [
            blade.hub_radius_m,
            blade.tip_radius_m,
            blade.rotor_speed_rad_per_s,
            blade.pitch_rad,
        ],
        blade.sections.iter().map(section).collect(),
        blade.borders.clone(),
        [mass_kg, x, y, z, xx, yy, zz, xy, xz, yz],
        blade.tip_is_pulled,
    )
}

fn blade_of(state: BladeState) -> BladeDescription {
    let (name, [hub, tip, speed, pitch], sections, borders, body, tip_is_pulled) = state;
    let section = |row: [f64; 11]| BladeSection {
        span: row[0],
        twist_rad: row[1],
        mass_kg_per_m: row[2],
        flap_inertia_kg_m: row[3],
        edge_inertia_kg_m: row[4],
        flap_n_m2: row[5],
        edge_n_m2: row[6],
        torsion_n_m2: row[7],
        axial_n: row[8],
        center_of_mass_m: row[9],
        tension_center_m: row[10],
    };
    let [mass_kg, x, y, z, xx, yy, zz, xy, xz, yz] = body;
    BladeDescription {
        name,
        hub_radius_m: hub,
        tip_radius_m: tip,
        sections: sections.into_iter().map(section).collect(),
        borders,
        rotor_speed_rad_per_s: speed,
        pitch_rad: pitch,
        tip: RigidBody {
            mass_kg,
            center_m: [x, y, z],
            inertia_kg_m2: Inertia::from([xx, yy, zz, xy, xz, yz]),
        },
        tip_is_pulled,
    }
}
