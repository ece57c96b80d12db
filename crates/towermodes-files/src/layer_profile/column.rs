//! The header of a column: a height, a depth or a quantity of the soil, and its unit.

use super::unit::{Dimension, Factor, units};
use crate::csv_table::Cell;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

/// What a column holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Content {
    /// In the datum of the stations, upwards.
    Height,
    /// Below the surface of the ground before scour.
    Depth,
    /// A quantity of the soil, by its key in `[[ground.layer]]`.
    Quantity(&'static str),
}

/// A name of a column with its content, dimension and other names.
type Known = (&'static str, Content, Dimension, &'static [&'static str]);

/// The columns of a profile.
const KNOWN: [Known; 9] = {
    use Content::{Depth, Height, Quantity};
    use Dimension::{Length, Number, Pressure, Velocity};
    [
        ("height", Height, Length, &["z", "elevation", "level"]),
        ("depth", Depth, Length, &[]),
        (
            "undrained_strength",
            Quantity("undrained_strength"),
            Pressure,
            &["undrained_shear_strength", "su", "s_u", "cu", "c_u"],
        ),
        (
            "shear_modulus",
            Quantity("shear_modulus"),
            Pressure,
            &["g", "g0", "g_0", "gmax", "g_max"],
        ),
        (
            "youngs_modulus",
            Quantity("youngs_modulus"),
            Pressure,
            &["young_s_modulus", "e", "e0", "e_0", "e_ir"],
        ),
        (
            "shear_wave_velocity",
            Quantity("shear_wave_velocity"),
            Velocity,
            &["vs", "v_s"],
        ),
        (
            "cone_resistance",
            Quantity("cone_resistance"),
            Pressure,
            &["qc", "q_c", "qt", "q_t"],
        ),
        (
            "blow_count",
            Quantity("blow_count"),
            Number,
            &["n", "spt", "spt_n", "n_spt"],
        ),
        (
            "shaft_friction",
            Quantity("shaft_friction"),
            Pressure,
            &["t_max"],
        ),
    ]
};

/// Columns that are not read.
const REMARKS: [&str; 12] = [
    "name", "id", "no", "nr", "number", "remark", "remarks", "comment", "comments", "note",
    "notes", "soil",
];

/// Quantities that have one value for a layer.
const OF_LAYER: [&str; 15] = [
    "effective_unit_weight",
    "unit_weight",
    "friction_angle",
    "phi",
    "subgrade_modulus",
    "relative_density",
    "strain_at_half_strength",
    "eps50",
    "strength_factor",
    "stiffness_factor",
    "behaviour_index",
    "void_ratio",
    "density",
    "poissons_ratio",
    "end_bearing",
];

const COLUMNS: &str = "columns are depth or height; undrained_strength, shear_modulus, youngs_modulus, shear_wave_velocity, cone_resistance, blow_count, shaft_friction; and remark, which is not read";

/// A column that is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Column {
    pub(super) content: Content,
    /// Its name in messages.
    pub(super) name: &'static str,
    /// Which column it is.
    pub(super) index: usize,
    pub(super) unit: Factor,
}

/// The column that a cell of the header names; none if it is empty or a remark.
pub(super) fn column(index: usize, cell: &Cell<'_>) -> Result<Option<Column>, Diagnostic> {
    let lower = cell.text.to_lowercase();
    let (name, bracketed) = match lower.split_once(['[', '(']) {
        Some((name, rest)) => (name, Some(rest.trim_end_matches([']', ')', ' ']).trim())),
        None => (&*lower, None),
    };
    let words = name.split(|c: char| !c.is_alphanumeric());
    let words: Vec<&str> = words.filter(|word| !word.is_empty()).collect();
    let name = words.join("_");
    if bracketed.is_none() && (name.is_empty() || REMARKS.contains(&&*name)) {
        return Ok(None);
    }
    let wrong = |kind| Diagnostic::new(cell.span.clone(), kind);
    let Some((known, unit)) = named(&name, bracketed) else {
        let kind = DiagnosticKind::misplaced("a column of a soil profile", quoted(&cell.text));
        return Err(wrong(kind).with_hint(unknown(&name)));
    };
    let (name, content, dimension, _) = *known;
    let unit =
        unit_of(name, dimension, unit).map_err(|(kind, hint)| wrong(kind).with_hint(hint))?;
    Ok(Some(Column {
        content,
        name,
        index,
        unit,
    }))
}

/// The known column of a name and its unit, in brackets or at the end of the name.
fn named<'n>(
    name: &'n str,
    bracketed: Option<&'n str>,
) -> Option<(&'static Known, Option<&'n str>)> {
    let is_called = |known: &&Known, name: &str| known.0 == name || known.3.contains(&name);
    if let Some(known) = KNOWN.iter().find(|known| is_called(known, name)) {
        return Some((known, bracketed));
    }
    if bracketed.is_some() {
        return None;
    }
    let cuts = name
        .match_indices('_')
        .map(|(at, _)| (&name[..at], &name[at + 1..]));
    let mut cuts = cuts.filter_map(|(name, unit)| {
        let known = KNOWN.iter().find(|known| is_called(known, name))?;
        Some((known, Some(unit)))
    });
    // The longest name: `v_s_m_per_s` is `v_s`.
    cuts.next_back()
}

/// The unit of a column, or what is wrong with a hint.
fn unit_of(
    name: &str,
    dimension: Dimension,
    unit: Option<&str>,
) -> Result<Factor, (DiagnosticKind, String)> {
    let listed = units(dimension);
    let hint = |listed: String| match dimension {
        Dimension::Number => "a blow count has no unit".to_owned(),
        _ => format!("units are {listed}"),
    };
    let Some(unit) = unit.filter(|unit| !matches!(*unit, "-" | "")) else {
        if dimension == Dimension::Number {
            return Ok(Factor::One);
        }
        let what = format!("the unit of the column {name}");
        let example = dimension.example();
        let hint = format!("write `{name} [{example}]`; {}", hint(listed));
        return Err((DiagnosticKind::Missing { what }, hint));
    };
    match dimension.unit(unit) {
        Some(factor) => Ok(factor),
        None => {
            let (what, name) = (dimension.what(), unit.to_owned());
            Err((DiagnosticKind::UnknownName { what, name }, hint(listed)))
        }
    }
}

/// What would be right in place of a name that is not known.
fn unknown(name: &str) -> String {
    if OF_LAYER.iter().any(|key| name.starts_with(key)) {
        return "it has one value for each layer: write it in [[ground.layer]], once for each layer with another value".to_owned();
    }
    let distance = |known: &str| {
        // The unit at the end of a name is not a mistake of it.
        let ends = name
            .match_indices('_')
            .map(|(at, _)| at)
            .chain([name.len()]);
        let start = ends.map(|end| strsim::damerau_levenshtein(&name[..end], known));
        start.min().unwrap_or(usize::MAX)
    };
    let is_near = |known: &str| name.len() < 60 && distance(known) <= 1 + known.len() / 8;
    match KNOWN.iter().find(|known| is_near(known.0)) {
        Some(known) => format!("did you mean `{}`?", known.0),
        None => COLUMNS.to_owned(),
    }
}
