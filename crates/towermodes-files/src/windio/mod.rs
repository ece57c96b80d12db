//! Turbines in windIO, the ontology of IEA Wind, versions 1 and 2: reads
//! tower, monopile, jacket and floating platform with its mooring lines, writes towers.
//!
//! Sources: the schemas of windIO 1.0 and 2.x (`IEAontology_schema.yaml`, `turbine_schema.yaml`).

mod floater;
mod jacket;
mod machine;
mod support;
mod text;
mod write;

use towermodes::mooring::MooringDescription;
use towermodes::{Damping, Foundation, MissingPart, Rna, Rotor, Tower, TowerDescription};

use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::input::{FileFormat, ReadOptions, TowerInput, TowerPart};
use crate::note::Note;
use crate::source::Source;
use support::structure::Structure;
use text::airfoils::without_airfoils;
use text::outline::{Outline, Version};
use text::reading::Reading;

pub use write::{WindIoWriteError, write_windio};

/// Whether a file looks like windIO: by its keys, or because it is YAML.
pub(crate) fn is_windio(text: &str, name: &str) -> bool {
    let keys = ["windIO_version:", "components:", "\"windIO_version\""];
    let has_key = |line: &str| keys.iter().any(|key| line.starts_with(key));
    let extension = name.rsplit_once('.').map(|(_, extension)| extension);
    let is_yaml = |e: &str| e.eq_ignore_ascii_case("yaml") || e.eq_ignore_ascii_case("yml");
    extension.is_some_and(is_yaml) || text.lines().any(has_key)
}

/// Reads the tower of a turbine, on its monopile if there is one, from a file in windIO 1 or 2.
///
/// A monopile of tubes stands in the elastic soil of the file below the mudline. Without such soil
/// the base is clamped: at the mudline if the file gives the water depth, otherwise at the lowest
/// height. The rotor-nacelle assembly is combined from the bodies in the file; notes list the
/// missing ones.
///
/// # Errors
/// [`ReadError::Mistakes`].
pub fn read_windio(source: Source, options: &ReadOptions) -> Result<TowerInput, ReadError> {
    let mut reading = Reading::new(&source);
    let found = describe(options, &mut reading);
    let Reading {
        notes,
        rotor_notes,
        mistakes,
        places,
        ..
    } = reading;
    let Some(described) = found else {
        return Err(ReadError::mistakes(&source, mistakes));
    };
    Ok(TowerInput {
        joint_m: described.joint_m,
        blades: described.blades,
        notes,
        rotor_notes,
        places,
        turbine_missing: described.turbine_missing,
        ..TowerInput::new(FileFormat::WindIo, described.description, vec![source])
    })
}

/// The description of a tower.
struct Described {
    description: TowerDescription,
    /// Height of the joint between monopile and tower, m.
    joint_m: Option<f64>,
    /// The number of the rotor's blades.
    blades: Option<usize>,
    /// Why there is no turbine with rotating rotor; none if there is no rotor.
    turbine_missing: Option<Note>,
}

fn describe(options: &ReadOptions, reading: &mut Reading<'_>) -> Option<Described> {
    let found = outline(reading);
    let outline = reading.keep(found)?;
    let version = outline.version(&reading.source.text);
    text::known_keys::note_lookalikes(&outline, options.part, reading);
    machine::given_masses::note_structures(&outline, options.part, reading);
    let (rna, rotor) = top(&outline, version, options, reading);
    let structure = Structure::read(&outline, version, options.part, reading);
    let ((rna, without_mass), mut structure) = (rna?, structure?);
    let is_whole = options.part == TowerPart::All && !options.clamped;
    let mut missing_parts = missing_parts(&outline, is_whole, reading);
    missing_parts.extend(without_mass);
    let in_soil = support::water::stand(&mut structure, &outline, options.part, reading);
    let in_soil = reading.keep(in_soil)?;
    support::comparison::compare(&structure, reading);
    let (joint_m, base_m) = (structure.joint_m(), structure.base_m());
    // A mistake in it is reported where it matters.
    let blades = machine::speeds::blade_count(&outline).ok().flatten();
    let blades = blades.filter(|_| options.part != TowerPart::Monopile);
    let description = structure.describe(reading);
    let mut description = reading.keep(description)?;
    if let Some((soil, mudline_m)) = in_soil {
        soil.surround(mudline_m, &mut description, reading);
    }
    let name = outline.name.as_ref();
    let name = name.map(|name| name.name(&reading.source.text));
    let has_rotor = options.part != TowerPart::Monopile;
    let aerodynamics = has_rotor
        .then(|| machine::chords::aerodynamics(&outline))
        .flatten();
    let has_machine = has_rotor && !options.without_rna;
    let turbine_missing =
        has_machine.then(|| machine::turbine::missing(&outline, version, reading));
    let mut description = TowerDescription {
        name: name.unwrap_or_default().to_owned(),
        rna,
        damping: Damping {
            rotor: aerodynamics,
            ..Damping::default()
        },
        rotor: rotor?,
        missing_parts,
        is_clamped_by_request: options.clamped,
        ..description
    };
    if is_whole {
        let on_jacket = jacket::stand(&outline, base_m, &mut description, reading);
        reading.keep(on_jacket)?;
        let afloat = afloat(&outline, version, options, &mut description, reading);
        reading.keep(afloat)?;
    }
    Some(Described {
        description,
        joint_m,
        blades,
        turbine_missing,
    })
}

/// The acceleration of gravity of the site, m/s².
fn gravity(outline: &Outline, reading: &mut Reading<'_>) -> Result<f64, Diagnostic> {
    let environment = outline.environment.as_ref();
    let node = environment.and_then(|environment| environment.get("gravity"));
    let Some(node) = node else {
        let standard = MooringDescription::GRAVITY_M_PER_S2;
        let message =
            format!("the file has no gravity in its environment: {standard} m/s2 is assumed");
        reading.note(Note::assumption(message));
        return Ok(standard);
    };
    let found = node.number("gravity")?;
    match found > 0.0 {
        true => Ok(found),
        false => {
            let kind = DiagnosticKind::out_of_range_in("gravity", found, "m/s2", "positive");
            Err(Diagnostic::new(node.span.clone(), kind))
        }
    }
}

/// Adds the floating platform of the file below a tower.
fn afloat(
    outline: &Outline,
    version: Version,
    options: &ReadOptions,
    description: &mut TowerDescription,
    reading: &mut Reading<'_>,
) -> Result<(), Diagnostic> {
    let components = outline.components.as_ref();
    if components.is_none_or(|components| components.floating_platform.is_none()) {
        return Ok(());
    }
    description.gravity_m_per_s2 = gravity(outline, reading)?;
    // What no tower can have is reported when the tower is made.
    let Ok(tower) = Tower::new(description.clone()) else {
        return Ok(());
    };
    let afloat = floater::Afloat {
        carried_kg: tower.mass_kg() + tower.rna().mass_kg,
        gravity_m_per_s2: tower.gravity_m_per_s2(),
        base_m: tower.base_m(),
        member_ends: options.member_ends,
    };
    if let Some(platform) = floater::float(outline, version, &afloat, reading)? {
        description.foundation = Foundation::Floating(Box::new(platform));
    }
    Ok(())
}

/// The rotor-nacelle assembly and its parts without mass.
type Assembly = (Rna, Vec<MissingPart>);

/// The rotor-nacelle assembly, its parts without mass and the rotor; a single monopile has none of
/// these.
fn top(
    outline: &Outline,
    version: Version,
    options: &ReadOptions,
    reading: &mut Reading<'_>,
) -> (Option<Assembly>, Option<Option<Rotor>>) {
    if options.part == TowerPart::Monopile {
        return (Some((Rna::default(), Vec::new())), Some(None));
    }
    let rna = match options.without_rna {
        true => Ok((Rna::default(), Vec::new())),
        false => machine::rna::rna(outline, version, reading),
    };
    let rna = reading.keep(rna);
    let rotor = machine::speeds::rotor(outline, reading);
    (rna, reading.keep(rotor))
}

/// The parts of the file that are read.
fn outline(reading: &Reading<'_>) -> Result<Outline, Diagnostic> {
    let text = &reading.source.text;
    if text.trim().is_empty() {
        let hint = "windIO has at least components and materials";
        return Err(Diagnostic::new(0..0, DiagnosticKind::EmptyFile).with_hint(hint));
    }
    Outline::of(text::yaml::parse(&without_airfoils(text))?)
}

/// The parts under the tower that are omitted, with notes.
fn missing_parts(outline: &Outline, is_whole: bool, reading: &mut Reading<'_>) -> Vec<MissingPart> {
    let Some(components) = &outline.components else {
        return Vec::new();
    };
    let parts = [
        (
            components.floating_platform.is_some() && !is_whole,
            MissingPart::Platform,
            "the floating platform is left out: the tower is clamped at its base",
        ),
        (
            components.mooring.is_some() && !(is_whole && components.floating_platform.is_some()),
            MissingPart::MooringLines,
            "the mooring lines are left out",
        ),
        (
            components.jacket.is_some() && !is_whole,
            MissingPart::Substructure,
            "the jacket is left out: the tower is clamped at its base",
        ),
    ];
    let found = parts.into_iter().filter(|(is_there, ..)| *is_there);
    let found = found.map(|(_, part, message)| {
        reading.note(Note::missing_part(message));
        part
    });
    found.collect()
}

#[cfg(test)]
mod tests {
    use super::is_windio;

    #[test]
    fn windio_is_known_by_its_keys_or_its_name() {
        assert!(is_windio("name: x\ncomponents:\n  tower:\n", "-"));
        assert!(is_windio("windIO_version: '2.0'\n", "turbine"));
        assert!(is_windio("", "a.b/turbine.YAML"));
        assert!(!is_windio("[material]\ndensity = 1\n", "tower.toml"));
        assert!(!is_windio("  components: x\n", "deck.bmi"));
    }
}
