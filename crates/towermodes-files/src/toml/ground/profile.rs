//! `profile` of `[[ground.layer]]`: a layer that is divided at the rows of a CSV table.

use serde_spanned::Spanned;
use toml::de::{DeTable, DeValue};
use towermodes::Place;

use super::super::text::kind::{TableKind, owners};
use super::super::text::reading::{ProfileFile, Reading};
use super::super::text::values::{Value, text};
use super::layer::{Layer, layer};
use super::soil::{KINDS, Kind};
use crate::diagnostic::{Diagnostic, DiagnosticKind, quoted};
use crate::layer_profile::{Profile, Row, SAME_M, profile};
use crate::number::Rounded;
use crate::resolver::FileResolver;
use crate::source::Source;

const KEY: &str = "profile";

/// The files that the layers of a file name as profiles; the first has this index among the tower's
/// files.
pub(in crate::toml) fn profile_files(
    root: &DeTable<'_>,
    first: usize,
    files: Option<&dyn FileResolver>,
) -> Vec<ProfileFile> {
    let mut found: Vec<ProfileFile> = Vec::new();
    let ground = root
        .get("ground")
        .and_then(|ground| ground.get_ref().as_table());
    let layers = ground.and_then(|ground| ground.get("layer")?.get_ref().as_array());
    let (Some(layers), Some(files)) = (layers, files) else {
        return found;
    };
    let tables = layers.iter().filter_map(|layer| layer.get_ref().as_table());
    for path in tables.filter_map(|layer| layer.get(KEY)?.get_ref().as_str()) {
        if !found.iter().any(|file| file.path == path) {
            found.push(ProfileFile {
                path: path.to_owned(),
                index: first + found.len(),
                source: files.read(path),
            });
        }
    }
    found
}

/// The layers of an entry with their names: one, or those between the rows of its profile. The
/// first is layer `first` of the ground.
pub(super) fn layers(
    first: usize,
    value: &Value<'_>,
    surface_m: Option<f64>,
    reading: &mut Reading,
) -> Option<Vec<(Layer, String)>> {
    let Some((entry, kind, named)) = with_profile(value) else {
        return layer(first, value, reading).map(|one| vec![one]);
    };
    let path = text(named, KEY, reading)?;
    let (source, file) = source_of(path, named, reading)?;
    let profile = match profile(&source.text, surface_m?).and_then(|p| of_kind(p, kind)) {
        Ok(profile) => profile,
        Err(mistakes) => return in_file(source, mistakes, reading),
    };
    for quantity in &profile.quantities {
        if let Some(value) = entry.get(quantity.key) {
            let (key, because) = (
                quantity.key.to_owned(),
                "together with its column in profile".to_owned(),
            );
            let kind = DiagnosticKind::UnusedKey { key, because };
            let mistake = Diagnostic::new(value.span(), kind);
            return reading
                .refuse(mistake.with_hint("give either the key or the column, not both"));
        }
    }
    let part = |numbers: &str, index: usize, reading: &mut Reading| {
        let table = DeValue::Table(with_numbers(entry, named, numbers));
        layer(index, &Spanned::new(value.span(), table), reading)
    };
    // All of the layer but its profile is checked once; the parts have no mistakes of their own.
    let ends = [0, profile.rows.len() - 1].map(|row| values(&profile.rows[row]));
    let (whole, name) = part(&numbers(&profile, None, &ends), first, reading)?;
    let [top_m, bottom_m] = whole.ends_m();
    if top_m.partial_cmp(&bottom_m) != Some(std::cmp::Ordering::Greater) {
        return Some(vec![(whole, name)]);
    }
    if let Some(mistake) = uncovered(&profile, [top_m, bottom_m]) {
        return in_file(source, vec![mistake], reading);
    }
    let mut layers = Vec::new();
    for cut in cuts(&profile, [top_m, bottom_m]) {
        let index = first + layers.len();
        let numbers = numbers(&profile, Some(cut.ends_m), &cut.values);
        layers.push(part(&numbers, index, reading)?);
        remember(index, &cut, &profile, [top_m, bottom_m], file, reading);
    }
    Some(layers)
}

/// The table of an entry with its kind of soil and its profile, if it has one and the kind allows
/// one.
fn with_profile<'v>(
    value: &'v Value<'v>,
) -> Option<(&'v DeTable<'v>, &'static Kind, &'v Value<'v>)> {
    let entry = value.get_ref().as_table()?;
    let name = entry.get("type")?.get_ref().as_str()?;
    let kind = KINDS.iter().find(|kind| kind.name() == name)?;
    kind.schema.key(KEY)?;
    Some((entry, kind, entry.get(KEY)?))
}

/// The file that an entry names, and its index among the tower's files.
fn source_of(path: &str, named: &Value<'_>, reading: &mut Reading) -> Option<(Source, usize)> {
    let unreadable = |reason: &dyn std::fmt::Display| {
        let kind = DiagnosticKind::unreadable("the profile of the layer", &reason.to_string());
        Diagnostic::new(named.span(), kind)
    };
    let found = reading.profiles.iter().find(|file| file.path == path);
    let mistake = match found.map(|file| (&file.source, file.index)) {
        Some((Ok(source), index)) => return Some((source.clone(), index)),
        Some((Err(error), _)) => unreadable(error).with_hint(
            "it is looked for in the folder of the tower file; names may be case-sensitive",
        ),
        None => unreadable(&"a text without a folder cannot refer to files")
            .with_hint("write one [[ground.layer]] for each piece of the profile"),
    };
    reading.refuse(mistake)
}

fn in_file<T>(source: Source, mistakes: Vec<Diagnostic>, reading: &mut Reading) -> Option<T> {
    reading.in_other_file.get_or_insert((source, mistakes));
    None
}

/// The profile, if all of its quantities belong to one kind of soil.
fn of_kind(profile: Profile, kind: &Kind) -> Result<Profile, Vec<Diagnostic>> {
    let is_foreign = |key: &str| kind.schema.key(key).is_none();
    let foreign = profile
        .quantities
        .iter()
        .filter(|quantity| is_foreign(quantity.key));
    let mistake = |quantity: &crate::layer_profile::Quantity| {
        let expected = format!("a quantity of a layer of type \"{}\"", kind.name());
        let found = DiagnosticKind::misplaced(expected, quoted(quantity.key));
        let hint = owners(quantity.key, &KINDS).unwrap_or_default();
        Diagnostic::new(quantity.span.clone(), found).with_hint(hint)
    };
    let mistakes: Vec<Diagnostic> = foreign.map(mistake).collect();
    match mistakes.is_empty() {
        true => Ok(profile),
        false => Err(mistakes),
    }
}

/// The values of a piece of a layer as they would be written by hand; `ends_m` are top and bottom,
/// if they differ from those of the entry.
fn numbers(profile: &Profile, ends_m: Option<[f64; 2]>, values: &[Vec<f64>; 2]) -> String {
    let [upper, lower] = values;
    let mut text = String::new();
    for (key, end_m) in ["top", "bottom"].iter().zip(ends_m.iter().flatten()) {
        text.push_str(&format!("{key} = {end_m:?}\n"));
    }
    for ((quantity, top), bottom) in profile.quantities.iter().zip(upper).zip(lower) {
        text.push_str(&format!("{} = [{top:?}, {bottom:?}]\n", quantity.key));
    }
    text
}

/// The entry with numbers instead of its profile; their place is that of the key that they replace,
/// or of the profile.
fn with_numbers<'t>(entry: &DeTable<'t>, named: &Value<'_>, numbers: &'t str) -> DeTable<'t> {
    let mut table = entry.clone();
    table.remove(KEY);
    let numbers = DeTable::parse(numbers).map(Spanned::into_inner);
    for (key, value) in numbers.into_iter().flatten() {
        let place = entry
            .get(&**key.get_ref())
            .map_or(named.span(), Value::span);
        let (key, value) = (key.into_inner(), value.into_inner());
        table.insert(Spanned::new(place.clone(), key), Spanned::new(place, value));
    }
    table
}

fn values(row: &Row) -> Vec<f64> {
    row.values.iter().map(|(value, _)| *value).collect()
}

/// The mistake of a profile that ends within its layer.
fn uncovered(profile: &Profile, [top_m, bottom_m]: [f64; 2]) -> Option<Diagnostic> {
    let (first, last) = (&profile.rows[0], &profile.rows[profile.rows.len() - 1]);
    let (row, message, hint) = if first.height_m < top_m - SAME_M {
        let hint = "add a row at the top of the layer or above it";
        (
            first,
            format!("begins below the top of the layer, {} m", Rounded(top_m)),
            hint,
        )
    } else if last.height_m > bottom_m + SAME_M {
        let hint = "add a row at the bottom of the layer or below it";
        (
            last,
            format!(
                "ends above the bottom of the layer, {} m",
                Rounded(bottom_m)
            ),
            hint,
        )
    } else {
        return None;
    };
    let height = Rounded(row.height_m);
    let message = format!("the profile {message}, at the height {height} m");
    let kind = DiagnosticKind::Contradiction(message);
    Some(Diagnostic::new(row.span.clone(), kind).with_hint(hint))
}

/// A piece of a layer between two rows.
struct Cut {
    /// Heights of top and bottom, m.
    ends_m: [f64; 2],
    /// The quantities at top and bottom.
    values: [Vec<f64>; 2],
    /// The row at the top or above it.
    row: usize,
}

/// The pieces of a layer from the top down, in each of which all quantities are linear in height.
fn cuts(profile: &Profile, [top_m, bottom_m]: [f64; 2]) -> Vec<Cut> {
    let mut cuts = Vec::new();
    let mut upper_m = top_m;
    for (row, pair) in profile.rows.windows(2).enumerate() {
        let lower_m = match pair[1].height_m <= bottom_m + SAME_M {
            true => bottom_m,
            false => pair[1].height_m,
        };
        // A step, or rows above the layer.
        if upper_m - lower_m <= SAME_M || pair[0].height_m - pair[1].height_m <= SAME_M {
            continue;
        }
        cuts.push(Cut {
            ends_m: [upper_m, lower_m],
            values: [upper_m, lower_m].map(|height_m| between(pair, height_m)),
            row,
        });
        upper_m = lower_m;
        if lower_m == bottom_m {
            break;
        }
    }
    cuts
}

/// The quantities at a height between two rows; at the height of a row those of the row.
fn between(rows: &[Row], height_m: f64) -> Vec<f64> {
    let (upper, lower) = (&rows[0], &rows[1]);
    if let Some(row) = rows
        .iter()
        .find(|row| (row.height_m - height_m).abs() <= SAME_M)
    {
        return values(row);
    }
    let share = (upper.height_m - height_m) / (upper.height_m - lower.height_m);
    let pairs = values(upper).into_iter().zip(values(lower));
    pairs
        .map(|(upper, lower)| upper + share * (lower - upper))
        .collect()
}

/// Stores the places of the values of a piece that are in the file of the profile.
fn remember(
    index: usize,
    cut: &Cut,
    profile: &Profile,
    [top_m, bottom_m]: [f64; 2],
    file: usize,
    reading: &mut Reading,
) {
    let row = &profile.rows[cut.row];
    let mut remember = |key, span: &std::ops::Range<usize>| {
        let place = Place::GroundLayer { index, key };
        reading.places.remember(place, file, span.clone());
    };
    if cut.ends_m[0] != top_m {
        remember("top", &row.span);
    }
    if cut.ends_m[1] != bottom_m {
        remember("bottom", &profile.rows[cut.row + 1].span);
    }
    for (quantity, (_, span)) in profile.quantities.iter().zip(&row.values) {
        remember(quantity.key, span);
    }
}
