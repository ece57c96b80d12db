//! The sections of a tower from the columns of HAWC2.

use towermodes::{Planes, Properties, PropertyStation};

use super::row::{self, Row};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A larger offset than this fraction of the tube's radius is refused, because it couples bending
/// with torsion.
const LARGEST_OFFSET: f64 = 0.05;
/// Rotated principal axes are refused if they couple the planes by more than this fraction of EI.
const LARGEST_COUPLING: f64 = 0.01;

/// Properties of the rows that are not in the sections, for the notes.
#[derive(Debug, Default)]
pub(super) struct Found {
    /// Whether the rows have shear factors.
    pub(super) shears: bool,
    /// Whether the rows have radii of gyration.
    pub(super) has_gyration: bool,
    /// The largest offset: row, column, fraction of the tube's radius.
    pub(super) offset: Option<(usize, usize, f64)>,
    /// The first row with rotated axes.
    pub(super) turned: Option<usize>,
}

/// The sections at their heights, and the properties that they do not contain.
pub(super) fn sections(
    rows: &[Row<'_>],
    base_m: f64,
) -> Result<(Vec<PropertyStation>, Found), Vec<Diagnostic>> {
    let mut found = Found {
        shears: rows[0].pair(row::SHEAR_FACTOR).iter().any(|k| *k > 0.0),
        has_gyration: rows[0].pair(row::GYRATION).iter().any(|ri| *ri > 0.0),
        ..Found::default()
    };
    let mut stations = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        let checked = same_kind(row, &found)
            .and_then(|()| axis(index, row, &mut found))
            .and_then(|()| properties(row, &found));
        // All rows usually have the same mistake: the first is enough.
        let properties = checked.map_err(|mistake| vec![mistake])?;
        stations.push(PropertyStation {
            height_m: base_m + row.of(row::R),
            properties,
        });
    }
    Ok((stations, found))
}

/// Checks that shear factors and radii of gyration are positive in all rows or in none.
fn same_kind(row: &Row<'_>, found: &Found) -> Result<(), Diagnostic> {
    let kinds = [
        (row::SHEAR_FACTOR, found.shears, "shear factors"),
        (row::GYRATION, found.has_gyration, "radii of gyration"),
    ];
    for (columns, expected, what) in kinds {
        let odd = columns.into_iter().find(|&c| (row.of(c) > 0.0) != expected);
        let Some(column) = odd else { continue };
        let (name, unit) = row::name_and_unit(column);
        let rule = match expected {
            true => format!("positive as the other {what} of the subset"),
            false => format!("0 as the other {what} of the subset"),
        };
        let kind = DiagnosticKind::out_of_range_in(name, row.of(column), unit.trim(), rule);
        return Err(Diagnostic::new(row.span(column), kind)
            .with_hint("give all rows positive values for both axes, or all 0"));
    }
    Ok(())
}

/// Checks that all centres are on one axis and the principal axes are fore-aft and side-side,
/// within tolerances.
fn axis(index: usize, row: &Row<'_>, found: &mut Found) -> Result<(), Diagnostic> {
    let [i_x, i_y] = row.pair(row::SECOND_MOMENT);
    // A thin tube of radius R has I/A = R²/2.
    let radius_m = (2.0 * i_x.max(i_y) / row.of(row::AREA)).sqrt();
    offsets(index, row, radius_m, found)?;
    let pitch = row.of(row::PITCH).to_radians();
    let coupling = (0.5 * (i_x - i_y) * (2.0 * pitch).sin()).abs() / i_x.max(i_y);
    let is_swapped =
        pitch.cos().abs() < pitch.sin().abs() && (i_x / i_y - 1.0).abs() > LARGEST_COUPLING;
    if coupling > LARGEST_COUPLING || is_swapped {
        return Err(turned(row));
    }
    if row.of(row::PITCH) != 0.0 && i_x != i_y {
        found.turned.get_or_insert(index);
    }
    Ok(())
}

/// Finds the largest offset of a centre from the axis; refuses one that is too large.
fn offsets(
    index: usize,
    row: &Row<'_>,
    radius_m: f64,
    found: &mut Found,
) -> Result<(), Diagnostic> {
    let columns = [row::CG, row::SHEAR_CENTRE, row::ELASTIC_CENTRE];
    for column in columns.into_iter().flatten() {
        let fraction = row.of(column).abs() / radius_m;
        if row.of(column) == 0.0 {
            continue;
        }
        if fraction > LARGEST_OFFSET {
            return Err(off_axis(row, column, fraction));
        }
        let largest = found.offset.map(|(_, _, largest)| largest);
        if largest.is_none_or(|largest| fraction > largest) {
            found.offset = Some((index, column, fraction));
        }
    }
    Ok(())
}

fn off_axis(row: &Row<'_>, column: usize, fraction: f64) -> Diagnostic {
    let (name, unit) = row::name_and_unit(column);
    let kind = DiagnosticKind::Unsupported(format!(
        "{name} (column {}) is {}{unit}, {:.0} % of the radius of a tube with this I and A; \
         centres that far off the axis are not modelled",
        column + 1,
        row.of(column),
        100.0 * fraction
    ));
    Diagnostic::new(row.span(column), kind)
        .with_hint("is this the file of a blade? for towers this value is 0")
}

fn turned(row: &Row<'_>) -> Diagnostic {
    let kind = DiagnosticKind::Unsupported(format!(
        "pitch (column {}) rotates the principal axes by {} degrees, and I_x = {} m4 differs from I_y = {} m4, \
         which couples both bending planes; this is not modelled",
        row::PITCH + 1,
        row.of(row::PITCH),
        row.of(row::SECOND_MOMENT[0]),
        row.of(row::SECOND_MOMENT[1])
    ));
    Diagnostic::new(row.span(row::PITCH), kind).with_hint("is this the file of a blade?")
}

/// The section of a row.
fn properties(row: &Row<'_>, found: &Found) -> Result<Properties, Diagnostic> {
    let [e, g, mass, area] =
        [row::YOUNG, row::SHEAR_MODULUS, row::MASS, row::AREA].map(|column| row.of(column));
    let squares = row.pair(row::GYRATION).map(|ri| ri * ri);
    // About the sideways axis x: fore-aft; of a force along y: fore-aft.
    let about = |[x, y]: [f64; 2]| Planes {
        fore_aft: x,
        side_side: y,
    };
    let along = |[x, y]: [f64; 2]| Planes {
        fore_aft: y,
        side_side: x,
    };
    let shear = found
        .shears
        .then(|| row.pair(row::SHEAR_FACTOR).map(|k| k * g * area));
    let mut properties = Properties {
        mass_kg_per_m: mass,
        rotary_inertia_kg_m: about(squares.map(|square| mass * square)),
        polar_inertia_kg_m: mass * (squares[0] + squares[1]),
        bending_n_m2: about(row.pair(row::SECOND_MOMENT).map(|i| e * i)),
        torsion_n_m2: g * row.of(row::TORSION),
        axial_n: e * area,
        shear_n: shear.map(along),
    };
    check_range(row, &properties, found.has_gyration)?;
    // Without inertia about the axis a torsional mode has no frequency.
    if !found.has_gyration {
        properties.torsion_n_m2 = f64::INFINITY;
    }
    Ok(properties)
}

/// Checks that products of values, each of which is possible, are neither too large nor too small
/// for a number.
fn check_range(row: &Row<'_>, p: &Properties, has_gyration: bool) -> Result<(), Diagnostic> {
    let mut products = vec![
        ("E I_x, the bending stiffness", p.bending_n_m2.fore_aft),
        ("E I_y, the bending stiffness", p.bending_n_m2.side_side),
        ("G K, the torsional stiffness", p.torsion_n_m2),
        ("E A, the axial stiffness", p.axial_n),
    ];
    if let Some(shear) = p.shear_n {
        products.push(("k_x G A, the shear stiffness", shear.side_side));
        products.push(("k_y G A, the shear stiffness", shear.fore_aft));
    }
    if has_gyration {
        let (rotary, polar) = (p.rotary_inertia_kg_m, p.polar_inertia_kg_m);
        products.push(("m ri_x^2, the rotary inertia", rotary.fore_aft));
        products.push(("m ri_y^2, the rotary inertia", rotary.side_side));
        products.push(("m (ri_x^2 + ri_y^2), the polar inertia", polar));
    }
    let Some((what, _)) = products.iter().find(|(_, v)| !(v.is_finite() && *v > 0.0)) else {
        return Ok(());
    };
    let what = format!("{what}, in this row");
    let kind = DiagnosticKind::Overflow { what };
    Err(Diagnostic::new(row.line.span(), kind).with_hint("the units are m, kg/m and Pa"))
}
