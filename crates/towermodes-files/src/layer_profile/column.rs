//! The header of a column: a height, a depth or a quantity of the soil, and its unit.

use std::sync::LazyLock;

use towermodes::inputs::{Given, Input};
use towermodes::{GroundLayer, LayerSoil};

use super::unit::{Dimension, Factor, units};
use crate::csv_table::Cell;
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};

/// The content of a column.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Content {
    /// Height in the datum of the stations, upwards.
    Height,
    /// Depth below the surface of the ground before scour.
    Depth,
    /// A quantity of the soil, by its key in `[[ground.layer]]`.
    Quantity(&'static str),
}

/// A column that the reader knows.
struct Known {
    name: &'static str,
    content: Content,
    dimension: Dimension,
    /// Other names, separated by blanks.
    synonyms: &'static str,
}

/// The columns of a profile: its heights, and the values that a layer has at its top and bottom.
static KNOWN: LazyLock<Vec<Known>> = LazyLock::new(|| {
    let place = |name, content, synonyms| Known {
        name,
        content,
        dimension: Dimension::Length,
        synonyms,
    };
    let quantity = |(input, _): &(&'static Input, Given)| Known {
        name: input.key,
        content: Content::Quantity(input.key),
        dimension: match input.unit() {
            "Pa" => Dimension::Pressure,
            "m/s" => Dimension::Velocity,
            _ => Dimension::Number,
        },
        synonyms: input.synonyms,
    };
    let places = [
        place("height", Content::Height, "z elevation level"),
        place("depth", Content::Depth, ""),
    ];
    let inputs = GroundLayer::every_input(&LayerSoil::blanks());
    let pairs = inputs
        .iter()
        .filter(|(_, given)| matches!(given, Given::Pair(_)));
    places.into_iter().chain(pairs.map(quantity)).collect()
});

impl Known {
    fn is_called(&self, name: &str) -> bool {
        let mut synonyms = self.synonyms.split_whitespace();
        self.name == name || synonyms.any(|other| other == name)
    }
}

/// Columns that are not read.
const REMARKS: [&str; 12] = [
    "name", "id", "no", "nr", "number", "remark", "remarks", "comment", "comments", "note",
    "notes", "soil",
];

/// Other names of quantities that have one value per layer.
const OF_LAYER: [&str; 3] = ["unit_weight", "phi", "eps50"];

/// A column that is read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Column {
    pub(super) content: Content,
    /// Its name in messages.
    pub(super) name: &'static str,
    /// Index of the column.
    pub(super) index: usize,
    pub(super) unit: Factor,
}

/// The column that a header cell names; none if the cell is empty or names a remark.
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
    let (name, content, dimension) = (known.name, known.content, known.dimension);
    let unit =
        unit_of(name, dimension, unit).map_err(|(kind, hint)| wrong(kind).with_hint(hint))?;
    Ok(Some(Column {
        content,
        name,
        index,
        unit,
    }))
}

/// The known column with a name, and its unit, in brackets or at the end of the name.
fn named<'n>(
    name: &'n str,
    bracketed: Option<&'n str>,
) -> Option<(&'static Known, Option<&'n str>)> {
    if let Some(known) = KNOWN.iter().find(|known| known.is_called(name)) {
        return Some((known, bracketed));
    }
    if bracketed.is_some() {
        return None;
    }
    let cuts = name
        .match_indices('_')
        .map(|(at, _)| (&name[..at], &name[at + 1..]));
    let mut cuts = cuts.filter_map(|(name, unit)| {
        let known = KNOWN.iter().find(|known| known.is_called(name))?;
        Some((known, Some(unit)))
    });
    // The longest name: `v_s_m_per_s` is `v_s`.
    cuts.next_back()
}

/// The unit of a column, or the mistake with a hint.
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

/// Suggestion for an unknown name.
fn unknown(name: &str) -> String {
    let inputs = GroundLayer::every_input(&LayerSoil::blanks());
    let single = inputs.iter().filter(|(_, given)| given.is_number());
    let mut of_layer = single.map(|(input, _)| input.key).chain(OF_LAYER);
    if of_layer.any(|key| name.starts_with(key)) {
        return "this value is constant in a layer: write it in [[ground.layer]], in each layer with another value".to_owned();
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
    match KNOWN.iter().find(|known| is_near(known.name)) {
        Some(known) => format!("did you mean `{}`?", known.name),
        None => {
            let quantities = KNOWN.iter().skip(2).map(|known| known.name);
            let quantities: Vec<&str> = quantities.collect();
            format!(
                "columns are depth or height; {}; and remark, which is not read",
                quantities.join(", ")
            )
        }
    }
}
