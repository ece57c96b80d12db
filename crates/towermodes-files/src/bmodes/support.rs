//! Reads what supports a tower: wires, or a platform, a monopile and what surrounds it.

use super::deck::{Dialect, Distribution, MatrixValue, Offshore, Support, WireSet};
use super::list::MAX_COUNT;
use super::main_file::{comments, named, not_negative};
use super::quantity::{self as q, Quantity};
use super::reader::{After, Reader, Value};
use super::unread::{self, Unread};
use crate::diagnostic::Diagnostic;

/// BModes allows two places for wires; no tower has more than so many.
const MAX_ATTACHMENTS: usize = 100;

/// A tower's support, and the dialect that only this block shows.
pub(super) fn support(
    reader: &mut Reader<'_>,
    dialect: Dialect,
    nodes: usize,
) -> Result<(Dialect, Support), Diagnostic> {
    comments(reader, "the heading of the tower's support")?;
    let mut support = Support::default();
    if dialect == Dialect::V1 {
        let count = attachments(reader)?;
        support.wires = wires(reader, &count, nodes, &mut support.unread)?;
        return Ok((dialect, support));
    }
    let kind = reader.integer(&q::TOW_SUPPORT)?;
    match kind.value {
        0 => {
            support
                .unread
                .extend(unread::after_no_support(reader, &kind));
            Ok((dialect, support))
        }
        1 if begins_with_number(reader) => {
            support.offshore = Some(Box::new(offshore(reader, &mut support.unread)?));
            support.wires = wires_if_any(reader, nodes, &mut support.unread)?;
            Ok((Dialect::Later, support))
        }
        1 => {
            reader.comment("the heading of the wires")?;
            let count = attachments(reader)?;
            if count.value == 0 {
                support.unread.push(unread::no_attachments(reader, &count));
            }
            support.wires = wires(reader, &count, nodes, &mut support.unread)?;
            Ok((dialect, support))
        }
        2 => {
            support.offshore = Some(Box::new(offshore(reader, &mut support.unread)?));
            support.unread.extend(unread_wires(reader));
            Ok((dialect, support))
        }
        other => {
            let message = format!("tow_support is {other}, but must be 0, 1 or 2");
            let hint = "0 is none, 1 wires (or, in later versions, a platform or monopile), 2 a platform or monopile";
            Err(kind.wrong(message).with_hint(hint))
        }
    }
}

/// Whether the next line that is not blank begins with a number.
fn begins_with_number(reader: &Reader<'_>) -> bool {
    let next = reader.lines.clone().find(|line| !line.is_blank());
    let first = next.and_then(|line| line.first());
    first.is_some_and(|token| token.number("").is_ok())
}

/// The wires after an offshore block; decks of other programs end before them.
fn wires_if_any(
    reader: &mut Reader<'_>,
    nodes: usize,
    unread: &mut Vec<Unread>,
) -> Result<Vec<WireSet>, Diagnostic> {
    let goes_on = reader.lines.clone().any(|line| {
        let first = line.first();
        first.is_some_and(|token| token.number("").is_ok())
    });
    if !goes_on {
        return Ok(Vec::new());
    }
    comments(reader, "the heading of the wires")?;
    let count = attachments(reader)?;
    wires(reader, &count, nodes, unread)
}

/// Where version 3.00's deck goes on with wires after an offshore block, which it does not read.
fn unread_wires(reader: &Reader<'_>) -> Option<Unread> {
    let mut lines = reader.lines.clone();
    let wires = lines.find(|line| named(*line) == Some(&q::N_ATTACHMENTS))?;
    let count = wires.first()?.integer("").ok()?;
    let message = "wires after the offshore block are not read, as in BModes 3.00; tow_support = 1 reads them, as later versions do";
    (count > 0).then(|| Unread::new(wires.start, message))
}

/// At how many heights wires are attached.
fn attachments(reader: &mut Reader<'_>) -> Result<Value<usize>, Diagnostic> {
    reader.count(&q::N_ATTACHMENTS, 0, MAX_ATTACHMENTS)
}

fn wires(
    reader: &mut Reader<'_>,
    attachments: &Value<usize>,
    nodes: usize,
    unread: &mut Vec<Unread>,
) -> Result<Vec<WireSet>, Diagnostic> {
    let count = attachments.value;
    if count == 0 {
        return Ok(Vec::new());
    }
    unread.extend(unread::sets_of_wires(reader, attachments));
    let after = After::Anything;
    let counts = reader.integers(&q::N_WIRES, count, after)?;
    let counts = each(
        counts,
        "n_wires",
        3,
        1_000_000,
        "at least three hold a tower in every direction",
    )?;
    let places = reader.integers(&q::NODE_ATTACH, count, after)?;
    let hint =
        "nodes are counted from 1 at the base to nselt + 1 at the top, and the base takes no wires";
    let places = each(places, "node_attach", 2, nodes, hint)?;
    let stiffnesses = reader.numbers(&q::WIRE_STFNESS, count, after)?;
    let angles = reader.numbers(&q::TH_WIRE, count, after)?;
    let sets = counts.into_iter().zip(places).zip(stiffnesses).zip(angles);
    sets.map(|(((count, node), stiffness), angle)| wire_set(count, node, stiffness, angle))
        .collect()
}

fn wire_set(
    count: Value<usize>,
    node: Value<usize>,
    stiffness: Value<f64>,
    angle: Value<f64>,
) -> Result<WireSet, Diagnostic> {
    if stiffness.value <= 0.0 {
        let message = format!(
            "wire_stfness is {} N/m, but must be positive",
            stiffness.value
        );
        return Err(stiffness.wrong(message));
    }
    if !(0.0..=90.0).contains(&angle.value) {
        let message = format!("th_wire is {} degrees, outside 0 to 90", angle.value);
        let hint = "the angle between the wires and the horizontal, in degrees";
        return Err(angle.wrong(message).with_hint(hint));
    }
    Ok(WireSet {
        count,
        node,
        stiffness_n_per_m: stiffness,
        angle_deg: angle,
    })
}

/// Whole numbers that all lie between two bounds.
fn each(
    values: Vec<Value<i64>>,
    name: &str,
    least: usize,
    most: usize,
    hint: &str,
) -> Result<Vec<Value<usize>>, Diagnostic> {
    let one = |Value { value, span }: Value<i64>| {
        let counted = usize::try_from(value).ok();
        match counted.filter(|count| (least..=most).contains(count)) {
            Some(value) => Ok(Value { value, span }),
            None => {
                let message = format!("{name} is {value}, outside {least} to {most}");
                Err(Diagnostic::new(span, message).with_hint(hint))
            }
        }
    };
    values.into_iter().map(one).collect()
}

fn offshore(reader: &mut Reader<'_>, unread: &mut Vec<Unread>) -> Result<Offshore, Diagnostic> {
    let draft_m = reader.number(&q::DRAFT)?;
    let cm_depth_m = reader.number(&q::CM_PFORM)?;
    let mass_kg = not_negative(reader, &q::MASS_PFORM)?;
    let inertia_kg_m2 = matrix(reader, &q::I_MATRIX_PFORM)?;
    let reference_depth_m = reader.number(&q::REF_MSL)?;
    let hydro_mass = matrix(reader, &q::HYDRO_M)?;
    let hydro_stiffness = matrix(reader, &q::HYDRO_K)?;
    let mooring_stiffness = matrix(reader, &q::MOORING_K)?;
    comments(reader, "the heading of the distributed added mass")?;
    let names = [&q::N_SECS_M_DISTR, &q::Z_DISTR_M, &q::DISTR_M];
    let added_mass = distribution(reader, names, unread)?;
    comments(reader, "the heading of the distributed stiffness")?;
    let names = [&q::N_SECS_K_DISTR, &q::Z_DISTR_K, &q::DISTR_K];
    let stiffness = distribution(reader, names, unread)?;
    Ok(Offshore {
        draft_m,
        cm_depth_m,
        mass_kg,
        inertia_kg_m2,
        reference_depth_m,
        hydro_mass,
        hydro_stiffness,
        mooring_stiffness,
        added_mass,
        stiffness,
    })
}

/// A line that announces a matrix, and its rows.
fn matrix<const N: usize>(
    reader: &mut Reader<'_>,
    quantity: &Quantity,
) -> Result<MatrixValue<N>, Diagnostic> {
    reader.comment(&format!("the line that announces {}", quantity.name))?;
    let mut matrix = MatrixValue {
        rows: [[0.0; N]; N],
        spans: std::array::from_fn(|_| 0..0),
    };
    for (row, span) in matrix.rows.iter_mut().zip(&mut matrix.spans) {
        let values = reader.numbers(quantity, N, After::Text)?;
        for (entry, value) in row.iter_mut().zip(&values) {
            *entry = value.value;
        }
        let ends = values.first().zip(values.last());
        *span = ends.map_or(0..0, |(first, last)| first.span.start..last.span.end);
    }
    Ok(matrix)
}

/// A table over the height: how many rows, their heights, their values.
fn distribution(
    reader: &mut Reader<'_>,
    names @ [count, heights, values]: [&Quantity; 3],
    unread: &mut Vec<Unread>,
) -> Result<Distribution, Diagnostic> {
    let count = reader.count(count, 0, MAX_COUNT)?;
    if count.value == 0 {
        let at = count.span.start;
        unread.extend(unread::table_of_no_rows(&reader.lines, names, at));
        // Fortran takes a record for a list of nothing.
        reader.skipped(heights)?;
        reader.skipped(values)?;
        let rows = Vec::new();
        return Ok(Distribution { count, rows });
    }
    let after = match count.value {
        1 => After::Anything,
        _ => After::Text,
    };
    let heights = reader.numbers(heights, count.value, after)?;
    let (name, values) = (values.name, reader.numbers(values, count.value, after)?);
    if count.value == 1 {
        let rows = Vec::new();
        return Ok(Distribution { count, rows });
    }
    let falls = |pair: &&[Value<f64>]| pair[1].value < pair[0].value;
    if let Some(pair) = heights.windows(2).find(falls) {
        let (before, height) = (pair[0].value, pair[1].value);
        let message = format!("height {height} m is below the one before it, {before} m");
        let hint = "heights rise from the flexible base up";
        return Err(pair[1].wrong(message).with_hint(hint));
    }
    if let Some(negative) = values.iter().find(|value| value.value < 0.0) {
        let message = format!("{name} is {}, but cannot be negative", negative.value);
        return Err(negative.wrong(message));
    }
    let rows = heights.into_iter().zip(values).collect();
    Ok(Distribution { count, rows })
}
