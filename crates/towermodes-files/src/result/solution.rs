//! A solution as JSON. Keys are stable: new keys may be added, the meaning of a key does not
//! change.

use std::io::Write;

use serde::Serialize;
use towermodes::modes::serialized::Directions;
use towermodes::{
    AddedMassAt, Certificate, FoundationHead, Method, MissingParts, Mode, Solution, SpringsAt,
    SpringsOfMember, StaticBalance, Statistics, TipSprings, Tower, TowerDescription,
};
use towermodes_analysis::influence::{Influences, Tolerances};

use super::sensitivities::InfluencesJson;
use super::substructure::FrameSummary;
use super::{ResultError, write_result_json};
use crate::input::Note;

/// The result of `towermodes solve`: the solution with the tower and the notes of the reader.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub(super) struct SolutionDocument<'a> {
    /// The version of the program.
    version: &'static str,
    /// The method, by its name on the command line.
    method: Method,
    /// Number of segments, or of elements.
    segments: usize,
    /// Polynomial degree of the elements of the method spectral; null for other methods.
    degree: Option<usize>,
    /// Degrees of freedom of the whole tower.
    degrees_of_freedom: usize,
    /// The tower that was solved.
    tower: TowerSummary<'a>,
    /// The lowest modes by frequency; in a repeated pair the fore-aft mode is first.
    modes: &'a [Mode],
    /// The proof that no mode is missing.
    certificate: Certificate,
    /// The frequency of the added mass of the floating platform: `own` (each mode at its own
    /// frequency), `infinite`, `zero`, or `hz` with the frequency; null if its added mass does not
    /// depend on frequency.
    added_mass: Option<AddedMassAt>,
    /// Weights, buoyancy and mooring lines of a floating tower at its reference position, and the
    /// equilibrium position; null if it does not float, without gravity, or if its buoyancy is not
    /// known.
    static_balance: Option<StaticBalance>,
    /// The buckling load factor: the factor on gravity at which the tower buckles; null without
    /// gravity, or if the tower floats.
    buckling_load_factor: Option<f64>,
    /// Sums of the effective masses of the listed modes, as fractions of the total masses of the
    /// tower; null if each mode has the added mass at its own frequency, because such masses do not
    /// add up.
    effective_mass_shares: Option<Directions>,
    /// The derivatives of the frequencies with respect to every input value of the tower; null
    /// unless they are requested.
    sensitivities: Option<InfluencesJson<'a>>,
    /// The cost of the solution.
    solver: Statistics,
    /// Assumptions of the reader, data that it omits, and possible input mistakes.
    warnings: Vec<String>,
}

/// The tower that was solved.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct TowerSummary<'a> {
    /// The name in the file; may be empty.
    name: &'a str,
    /// Height from base to top, m.
    height_m: f64,
    /// Mass with outfitting and point masses, without the rotor-nacelle assembly, kg.
    mass_kg: f64,
    /// Mass of the rotor-nacelle assembly, kg.
    top_mass_kg: f64,
    /// Acceleration of gravity, m/s2; 0 if gravity is omitted.
    gravity_m_per_s2: f64,
    /// Inertia matrix of all moving masses for rigid motions (x, y, z, rotation about x, y, z) of
    /// the whole tower about its base: kg, kg m, kg m2.
    rigid_inertia: [[f64; 6]; 6],
    /// The static stiffness of the foundation at the surface of the soil: stiffness of `[ground]`,
    /// of the highest row of `[[soil]]`, or of `[foundation]` at the base; null for a fixed base or
    /// pile tip, for a floating tower, and for a tower on members.
    foundation_head: Option<FoundationHead>,
    /// The soil in layers as springs; null for a tower without `[ground]`.
    ground: Option<GroundSummary>,
    /// Parts of the structure that the source of the tower has and this model lacks; null if it is
    /// complete. The frequencies are those of the structure without these parts.
    missing: Option<&'a MissingParts>,
    /// The members under the tower; null for a tower that does not stand on members.
    frame: Option<FrameSummary<'a>>,
}

/// The springs that follow from soil in layers.
#[derive(Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
struct GroundSummary {
    /// Height of the surface at the pile after scour, m.
    surface_m: f64,
    /// The springs by increasing height; linear in between, twice at a height where they have a
    /// step.
    springs: Vec<SpringsAt>,
    /// The springs of the soil under the tip of the pile, which add to the foundation at the base;
    /// null if the models give none, and on members.
    tip: Option<TipSprings>,
    /// The springs along the piles of the members below the tower, member by member.
    members: Vec<SpringsOfMember>,
}

impl GroundSummary {
    fn of(tower: &Tower) -> Option<Self> {
        Some(Self {
            surface_m: tower.ground_surface_m()?,
            springs: tower.springs_of_soil(),
            tip: tower.springs_at_tip(),
            members: tower.springs_of_members(),
        })
    }
}

impl<'a> SolutionDocument<'a> {
    /// The document of a solution; the notes of the reader come before the warnings.
    pub(super) fn of(tower: &'a Tower, solution: &'a Solution, notes: &[Note]) -> Self {
        let notes = notes.iter().map(ToString::to_string);
        let warnings = solution.warnings.iter().map(ToString::to_string);
        Self {
            version: env!("CARGO_PKG_VERSION"),
            method: solution.method,
            segments: solution.segments,
            degree: solution.degree,
            degrees_of_freedom: solution.degrees_of_freedom,
            tower: TowerSummary {
                name: tower.name(),
                height_m: tower.height_m(),
                mass_kg: tower.mass_kg(),
                top_mass_kg: tower.rna().mass_kg,
                gravity_m_per_s2: tower.gravity_m_per_s2(),
                rigid_inertia: solution.rigid_inertia,
                ground: GroundSummary::of(tower),
                foundation_head: tower.foundation_head(),
                missing: tower.missing_parts(),
                frame: tower.frame().map(FrameSummary::of),
            },
            modes: &solution.modes,
            certificate: solution.certificate,
            added_mass: solution.added_mass,
            static_balance: tower.static_balance(),
            buckling_load_factor: solution.buckling_load_factor,
            effective_mass_shares: solution.effective_mass_shares().map(Directions::from),
            sensitivities: None,
            solver: solution.statistics,
            warnings: notes.chain(warnings).collect(),
        }
    }
}

/// Writes a solution as indented JSON with a newline at the end; the notes of the reader come
/// before the warnings.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_json(
    tower: &Tower,
    solution: &Solution,
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    write_result_json(&SolutionDocument::of(tower, solution, notes), writer)
}

/// Writes a solution as JSON with the influence of the input values of the tower.
///
/// # Errors
/// [`ResultError`] if writing fails.
pub fn write_json_with_sensitivities(
    tower: &Tower,
    solution: &Solution,
    (description, influences): (&TowerDescription, &Influences),
    notes: &[Note],
    writer: impl Write,
) -> Result<(), ResultError> {
    let none = Tolerances::default();
    let document = SolutionDocument {
        sensitivities: Some(InfluencesJson::of(description, influences, &none)),
        ..SolutionDocument::of(tower, solution, notes)
    };
    write_result_json(&document, writer)
}
