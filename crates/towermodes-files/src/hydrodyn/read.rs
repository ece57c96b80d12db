//! Reads a HydroDyn file completely.

use super::added_stiffness;
use super::coefficients::Coefficients;
use super::ends;
use super::growth::Growth;
use super::input::HydrodynInput;
use super::members::{self, Members, Site};
use super::potential;
use super::strip::StripMember;
use super::values::Values;
use super::water::{self, SeaWater, WaterDefaults};
use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact};
use crate::error::ReadError;
use crate::note::Note;
use crate::resolver::FileResolver;
use crate::source::Source;

/// Reads an input file of HydroDyn; `files` gives the files of WAMIT that it names, relative to its
/// `folder` as seen from there. `water` contains the values of the `.fst` file and of SeaState; a
/// number in the HydroDyn file has priority.
///
/// # Errors
/// The first mistake in the file or in a file of WAMIT, at its place.
///
/// # Example
/// ```no_run
/// use towermodes_files::{SiblingFiles, Source, WaterDefaults, read_hydrodyn};
///
/// let path = std::path::Path::new("Semi_HydroDyn.dat");
/// let files = SiblingFiles::of(path);
/// let water = WaterDefaults::default();
/// let input = read_hydrodyn(Source::from_path(path)?, &files, "", water)?;
/// println!("{} kg of ballast water", input.filling().mass_kg);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn read_hydrodyn(
    source: Source,
    files: &dyn FileResolver,
    folder: &str,
    water: WaterDefaults,
) -> Result<HydrodynInput, ReadError> {
    let values = Values::of(&source.text);
    let main = found(&values, &source, water).map_err(|m| ReadError::mistake(&source, m))?;
    let density = main.water.density_kg_per_m3;
    let body = potential::read(&values, &source, files, folder, density)?;
    let is_static = values.line("PtfmSgF").is_some();
    let stiffness_at = values.line("AddCLin").map_or(0, |line| line.start);
    let damping = on_damping(&values, body.is_some(), &source);
    drop(values);
    let Found {
        water,
        added,
        mut members,
        growth,
    } = main;
    let ends = ends::of(
        &members.joints,
        &members.members,
        &members.joints_of,
        &growth,
        &water,
    );
    let mut notes = added.notes;
    notes.extend(damping);
    notes.append(&mut members.notes);
    notes.extend(on_strips(&members, &water, &source));
    notes.extend(on_density(&water, &source));
    notes.extend(on_added_mass(&members, &source));
    let mut sources = vec![source];
    let mut flow = None;
    if let Some(body) = body {
        notes.extend(body.notes);
        sources.extend(body.sources);
        flow = Some(body.flow);
    }
    Ok(HydrodynInput {
        water,
        potential: flow,
        additional_stiffness: added.stiffness,
        additional_load: added.force,
        members: members.members,
        member_rows: members.rows,
        ends,
        is_static,
        notes,
        sources,
        stiffness_at,
    })
}

/// The values of the main file.
struct Found {
    water: SeaWater,
    added: added_stiffness::Added,
    members: Members,
    growth: Growth,
}

fn found(
    values: &Values<'_>,
    source: &Source,
    defaults: WaterDefaults,
) -> Result<Found, Diagnostic> {
    if !is_hydrodyn(values) {
        return Err(not_hydrodyn(values));
    }
    let water = water::complete(water::given(values, defaults)?)?;
    let added = added_stiffness::read(values, source)?;
    let growth = Growth::of(values)?;
    let coefficients = Coefficients::of(values)?;
    let site = Site {
        water: &water,
        growth: &growth,
        coefficients: &coefficients,
    };
    let members = members::read(values, source, &site)?;
    Ok(Found {
        water,
        added,
        members,
        growth,
    })
}

fn is_hydrodyn(values: &Values<'_>) -> bool {
    values.line("NMembers").is_some() && has_potential_flow(values)
}

fn has_potential_flow(values: &Values<'_>) -> bool {
    ["PotMod", "HasWAMIT"]
        .iter()
        .any(|name| values.line(name).is_some())
}

/// The error for a file that is not a HydroDyn file, or is only the beginning of one.
fn not_hydrodyn(values: &Values<'_>) -> Diagnostic {
    if has_potential_flow(values) {
        let kind = DiagnosticKind::missing_key("the HydroDyn file", "NMembers");
        return Diagnostic::new(0..0, kind).with_hint("is the file complete?");
    }
    let found = "no input file of HydroDyn".to_owned();
    Diagnostic::new(0..0, DiagnosticKind::WrongFile { found })
        .with_hint("such a file has PotMod, AddCLin, NJoints and NMembers")
}

/// A common note on all data that do not affect undamped modes.
fn on_damping(values: &Values<'_>, has_body: bool, source: &Source) -> Option<Note> {
    let named =
        ["AddBLin", "AddBQuad"].map(|name| values.line(name).map(|line| (name, line.start)));
    let radiation = values.line("RdtnMod").filter(|_| has_body);
    let radiation = radiation.map(|line| ("radiation damping, wave excitation", line.start));
    let found: Vec<_> = named.into_iter().chain([radiation]).flatten().collect();
    let at = found.iter().map(|(_, at)| *at).min()?;
    let names: Vec<&str> = found.iter().map(|(name, _)| *name).collect();
    let message = format!(
        "not used by modes, which have no damping, drag and waves: {}",
        names.join(", ")
    );
    Some(Note::left_out(message).at(source, at))
}

/// The range of the density of water, kg/m³, from fresh water to the highest salinity.
const DENSITIES_KG_PER_M3: std::ops::RangeInclusive<f64> = 900.0..=1100.0;

/// The note on a density outside the range of water.
fn on_density(water: &SeaWater, source: &Source) -> Option<Note> {
    let density = water.density_kg_per_m3;
    let message = format!(
        "the density of the water (WtrDens) is {density} kg/m3; expected 900 to 1100 kg/m3; sea water has 1025"
    );
    (!DENSITIES_KG_PER_M3.contains(&density)).then(|| Note::suspicious(message).at(source, 0))
}

/// Largest plausible coefficient: a single cylinder has Ca = 1, one between others 2.
const LARGEST_CA: f64 = 3.0;

/// The note on coefficients of transverse added mass that are not plausible.
fn on_added_mass(members: &Members, source: &Source) -> Option<Note> {
    let largest = |member: &StripMember| {
        let stretches = member.stretches.iter();
        let across = stretches.filter_map(|stretch| stretch.added_mass);
        across
            .flat_map(|added| added.across)
            .flatten()
            .fold(0.0, f64::max)
    };
    let all = members.members.iter().zip(&members.rows);
    let mut large = all.filter(|(member, _)| largest(member) > LARGEST_CA);
    let (member, row) = large.next()?;
    let others = match large.count() {
        0 => String::new(),
        1 => ", as has 1 other member".to_owned(),
        others => format!(", as have {others} other members"),
    };
    let message = format!(
        "member {} has a coefficient of added mass Ca of up to {}{others}; a cylinder alone in water has 1, at most {LARGEST_CA} is expected: check SimplCa, DpthCa and MemberCa",
        member.name,
        Exact(largest(member))
    );
    Some(Note::suspicious(message).at(source, *row))
}

/// The note on effects that strip theory neglects.
fn on_strips(members: &Members, water: &SeaWater, source: &Source) -> Vec<Note> {
    let mut notes = Vec::new();
    let strips = members
        .members
        .iter()
        .filter(|member| !member.is_potential_flow);
    let below = |z_m: &[f64; 3]| z_m[2] < -water.depth_m;
    let buried = strips
        .filter(|member| member.ends_m.iter().any(below))
        .count();
    if buried > 0 {
        let (count, whose) = match buried {
            1 => ("1 member reaches".to_owned(), "it has"),
            _ => (format!("{buried} members reach"), "they have"),
        };
        let message = format!(
            "{count} below the seabed at {} m: {whose} no added mass, growth or filling there, as in HydroDyn",
            -water.depth_m
        );
        notes.push(Note::compatibility(message).at(source, 0));
    }
    notes
}
