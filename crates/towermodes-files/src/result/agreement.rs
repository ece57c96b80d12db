//! How two descriptions of one tower compare, and what one says, as JSON.

use std::io::Write;

use schemars::JsonSchema;
use serde::Serialize;
use towermodes::Planes;
use towermodes_analysis::agreement::{
    Agreement, AgreementRow, Compared, ComparedFrequency, Examination, HeightRange,
    LargestDifference,
};

use super::{ResultError, write_pretty};

/// The result of `towermodes check FILE OTHER --format json`. Keys are stable: new ones may be
/// added, none is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes check")]
pub(super) struct AgreementJson {
    /// The worst verdict: `pass`, `warn` or `fail`.
    verdict: &'static str,
    /// From where to where the first tower reaches.
    first_range: RangeJson,
    /// From where to where the second tower reaches.
    second_range: RangeJson,
    /// The heights that are compared.
    overlap: RangeJson,
    /// How far the second must be lowered for both to be at one height, m, if they are equally
    /// long.
    shift_m: Option<f64>,
    /// Length that values by height are means over, m.
    window_m: f64,
    /// Mass with outfitting and point masses, kg.
    mass_kg: ComparedJson,
    /// The point masses in it, kg; no part of the verdict.
    point_masses_kg: ComparedJson,
    /// Height of the centre of mass, m.
    center_of_mass_m: ComparedJson,
    /// Deflection of the top by a unit force there, m/N.
    tip_flexibility_m_per_n: PlanesJson<ComparedJson>,
    /// Where the masses per length are furthest apart.
    largest_mass: LargestJson,
    /// Where EI is furthest apart.
    largest_bending: PlanesJson<LargestJson>,
    /// By height.
    rows: Vec<RowJson>,
    /// Frequencies of the clamped tower with nothing on it, without rotary inertia and shear.
    frequencies_bare: Vec<FrequencyJson>,
    /// Frequencies of both towers as they are described; empty if neither has anything beside
    /// itself.
    frequencies_as_given: Vec<FrequencyJson>,
}

/// Heights, m.
#[derive(Serialize, JsonSchema)]
struct RangeJson {
    /// The lower end, m.
    base_m: f64,
    /// The upper end, m.
    top_m: f64,
}

/// A value of each tower.
#[derive(Serialize, JsonSchema)]
struct ComparedJson {
    /// That of the first.
    first: f64,
    /// That of the second.
    second: f64,
    /// The relative difference; null where only the first is zero.
    difference: Option<f64>,
    /// `pass`, `warn` or `fail`.
    verdict: &'static str,
}

/// A value for each bending plane.
#[derive(Serialize, JsonSchema)]
struct PlanesJson<T> {
    /// Fore-aft.
    fore_aft: T,
    /// Side-side.
    side_side: T,
}

/// Where a quantity is furthest apart.
#[derive(Serialize, JsonSchema)]
struct LargestJson {
    /// The height, m.
    height_m: f64,
    /// Both values there.
    compared: ComparedJson,
}

/// Both towers at a height.
#[derive(Serialize, JsonSchema)]
struct RowJson {
    /// The height, m.
    height_m: f64,
    /// Mass per length, kg/m.
    mass_kg_per_m: ComparedJson,
    /// EI, N m2.
    bending_n_m2: PlanesJson<ComparedJson>,
    /// Mass from the base of the overlap to here, kg.
    mass_below_kg: ComparedJson,
}

/// A mode of both towers.
#[derive(Serialize, JsonSchema)]
struct FrequencyJson {
    /// What it is.
    label: String,
    /// That of the first, Hz; null if it has no such mode.
    first_hz: Option<f64>,
    /// That of the second, Hz; null if it has no such mode.
    second_hz: Option<f64>,
    /// The relative difference, if both have it.
    difference: Option<f64>,
    /// `pass`, `warn` or `fail`.
    verdict: &'static str,
}

/// The result of `towermodes check FILE --format json`. Keys are stable: new ones may be added,
/// none is renamed.
#[derive(Serialize, JsonSchema)]
#[schemars(title = "towermodes check of one file")]
pub(super) struct ExaminationJson {
    /// From where to where the tower reaches.
    range: RangeJson,
    /// Mass with outfitting and point masses, kg.
    mass_kg: f64,
    /// The point masses in it, kg.
    point_masses_kg: f64,
    /// Height of the centre of mass, m.
    center_of_mass_m: f64,
    /// Inertia of the tower alone against rigid motions (x, y, z, rotation about x, y, z) about its
    /// base: kg, kg m, kg m2.
    inertia_about_base: [[f64; 6]; 6],
    /// Deflection of the top by a unit force there, from bending, if the base is clamped, m/N.
    tip_flexibility_m_per_n: PlanesJson<f64>,
    /// By height.
    rows: Vec<ExaminationRowJson>,
}

/// The tower at a height.
#[derive(Serialize, JsonSchema)]
struct ExaminationRowJson {
    /// The height, m.
    height_m: f64,
    /// Mass per length, kg/m.
    mass_kg_per_m: f64,
    /// EI, N m2.
    bending_n_m2: PlanesJson<f64>,
    /// Mass from the base to here, kg.
    mass_below_kg: f64,
}

/// Writes how two descriptions compare as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_agreement_json(agreement: &Agreement, writer: impl Write) -> Result<(), ResultError> {
    let [first, second] = &agreement.ranges;
    let frequencies = |list: &[ComparedFrequency]| list.iter().map(frequency_json).collect();
    let result = AgreementJson {
        verdict: agreement.verdict().name(),
        first_range: range_json(first),
        second_range: range_json(second),
        overlap: range_json(&agreement.overlap),
        shift_m: agreement.shift_m,
        window_m: agreement.window_m,
        mass_kg: compared_json(&agreement.mass_kg),
        point_masses_kg: compared_json(&agreement.point_masses_kg),
        center_of_mass_m: compared_json(&agreement.center_of_mass_m),
        tip_flexibility_m_per_n: planes_json(&agreement.tip_flexibility_m_per_n, compared_json),
        largest_mass: largest_json(&agreement.largest_mass),
        largest_bending: planes_json(&agreement.largest_bending, largest_json),
        rows: agreement.rows.iter().map(row_json).collect(),
        frequencies_bare: frequencies(&agreement.frequencies_bare),
        frequencies_as_given: frequencies(&agreement.frequencies_as_given),
    };
    write_pretty(&result, writer)
}

/// Writes what a description says of a tower as indented JSON with a newline at the end.
///
/// # Errors
/// [`ResultError`] if the writer refuses.
pub fn write_examination_json(
    examination: &Examination,
    writer: impl Write,
) -> Result<(), ResultError> {
    let rows = examination.rows.iter().map(|row| ExaminationRowJson {
        height_m: row.height_m,
        mass_kg_per_m: row.mass_kg_per_m,
        bending_n_m2: planes_json(&row.bending_n_m2, |ei| *ei),
        mass_below_kg: row.mass_below_kg,
    });
    let result = ExaminationJson {
        range: range_json(&examination.range),
        mass_kg: examination.mass_kg,
        // A sum of none is a negative zero.
        point_masses_kg: examination.point_masses_kg + 0.0,
        center_of_mass_m: examination.center_of_mass_m,
        inertia_about_base: examination.inertia_about_base,
        tip_flexibility_m_per_n: planes_json(&examination.tip_flexibility_m_per_n, |tip| *tip),
        rows: rows.collect(),
    };
    write_pretty(&result, writer)
}

fn range_json(range: &HeightRange) -> RangeJson {
    RangeJson {
        base_m: range.base_m,
        top_m: range.top_m,
    }
}

fn compared_json(compared: &Compared) -> ComparedJson {
    ComparedJson {
        first: compared.first,
        second: compared.second,
        difference: Some(compared.difference).filter(|difference| difference.is_finite()),
        verdict: compared.verdict.name(),
    }
}

fn planes_json<T, U>(planes: &Planes<T>, json: impl Fn(&T) -> U) -> PlanesJson<U> {
    PlanesJson {
        fore_aft: json(&planes.fore_aft),
        side_side: json(&planes.side_side),
    }
}

fn largest_json(largest: &LargestDifference) -> LargestJson {
    LargestJson {
        height_m: largest.height_m,
        compared: compared_json(&largest.compared),
    }
}

fn row_json(row: &AgreementRow) -> RowJson {
    RowJson {
        height_m: row.height_m,
        mass_kg_per_m: compared_json(&row.mass_kg_per_m),
        bending_n_m2: planes_json(&row.bending_n_m2, compared_json),
        mass_below_kg: compared_json(&row.mass_below_kg),
    }
}

fn frequency_json(frequency: &ComparedFrequency) -> FrequencyJson {
    let [first_hz, second_hz] = frequency.frequencies_hz;
    FrequencyJson {
        label: frequency.label(),
        first_hz,
        second_hz,
        difference: frequency.compared.map(|compared| compared.difference),
        verdict: frequency.verdict().name(),
    }
}
