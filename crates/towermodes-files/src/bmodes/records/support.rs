//! Reads the support of a tower: wires, or a platform or monopile with soil and water.

use super::deck::{Dialect, Distribution, MatrixValue, Offshore, Support, WireSet};
use super::diagnose::After;
use super::parameters::{self as p, Parameter};
use super::reader::{Reader, Value};
use super::unread::{self, Unread};
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// A tower's support, and the dialect, which only this block shows.
pub(crate) fn support(
    reader: &mut Reader<'_>,
    dialect: Dialect,
    nodes: usize,
) -> Result<(Dialect, Support), Diagnostic> {
    reader.heading("the heading of the tower's support")?;
    let mut support = Support::default();
    let Support {
        wires,
        offshore,
        unread,
    } = &mut support;
    if dialect == Dialect::V1 {
        *wires = wires_at_all_heights(reader, nodes, unread)?;
        return Ok((dialect, support));
    }
    let kind = reader.count(&p::TOW_SUPPORT)?;
    match kind.value {
        0 => unread.extend(unread::after_no_support(reader, &kind)),
        1 if reader.number_follows() => {
            *offshore = Some(Box::new(offshore_block(reader, unread)?));
            *wires = wires_if_any(reader, nodes, unread)?;
            return Ok((Dialect::Later, support));
        }
        1 => {
            reader.comment(WIRES_HEADING)?;
            let count = reader.count(&p::N_ATTACHMENTS)?;
            let none = (count.value == 0).then(|| unread::no_attachments(reader, &count));
            unread.extend(none);
            *wires = sets_of_wires(reader, &count, nodes, unread)?;
        }
        _ => {
            *offshore = Some(Box::new(offshore_block(reader, unread)?));
            unread.extend(unread_wires(reader));
        }
    }
    Ok((dialect, support))
}

/// The wires after an offshore block; decks of other programs end before it.
fn wires_if_any(
    reader: &mut Reader<'_>,
    nodes: usize,
    unread: &mut Vec<Unread>,
) -> Result<Vec<WireSet>, Diagnostic> {
    if !reader.values_follow() {
        return Ok(Vec::new());
    }
    reader.heading(WIRES_HEADING)?;
    wires_at_all_heights(reader, nodes, unread)
}

/// The number of heights at which wires are attached, and the wires.
fn wires_at_all_heights(
    reader: &mut Reader<'_>,
    nodes: usize,
    unread: &mut Vec<Unread>,
) -> Result<Vec<WireSet>, Diagnostic> {
    let count = reader.count(&p::N_ATTACHMENTS)?;
    sets_of_wires(reader, &count, nodes, unread)
}

/// The wires after an offshore block, which version 3.00 does not read.
fn unread_wires(reader: &Reader<'_>) -> Option<Unread> {
    let mut lines = reader.lines.clone();
    let wires = lines.find(|line| Parameter::after_value(*line) == Some(&p::N_ATTACHMENTS))?;
    let count = wires.first()?.integer("").ok()?;
    let message = "guy wires after the offshore block are not read, as in BModes 3.00; with tow_support = 1 they are read, as in later versions";
    (count > 0).then(|| Unread::new(wires.start, message))
}

fn sets_of_wires(
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
    let [counts, places, stiffnesses, angles] = p::WIRES;
    let mut list = |parameter| reader.list(parameter, count, After::Anything);
    let (counts, places) = (list(counts)?, list(places)?);
    let sets = counts.into_iter().zip(places);
    let sets = sets.zip(list(stiffnesses)?).zip(list(angles)?);
    let set = |(((count, node), stiffness_n_per_m), angle_deg)| WireSet {
        count: Value::map(count, |count: f64| count as usize),
        node: Value::map(node, |node: f64| node as usize),
        stiffness_n_per_m,
        angle_deg,
    };
    let sets: Vec<WireSet> = sets.map(set).collect();
    match sets.iter().find(|set| set.node.value > nodes) {
        Some(set) => Err(beyond_the_top(&set.node, nodes)),
        None => Ok(sets),
    }
}

fn beyond_the_top(node: &Value<usize>, nodes: usize) -> Diagnostic {
    let rule = format!("at most {nodes}: nselt + 1, the top");
    node.wrong(DiagnosticKind::out_of_range(
        "node_attach",
        node.value as f64,
        rule,
    ))
}

const STIFFNESS_HEADING: &str = "the heading of the distributed stiffness";
const WIRES_HEADING: &str = "the heading of the wires";

/// Whether the table of stiffness comes next, with its heading.
fn stiffness_follows(reader: &Reader<'_>) -> bool {
    reader.block_follows(STIFFNESS_HEADING, &p::N_SECS_K_DISTR)
}

/// Whether the wires with their heading come next, or no value at all, because version 3.00 reads
/// none.
fn wires_or_nothing_follow(reader: &Reader<'_>) -> bool {
    !reader.values_follow() || reader.block_follows(WIRES_HEADING, &p::N_ATTACHMENTS)
}

fn offshore_block(
    reader: &mut Reader<'_>,
    unread: &mut Vec<Unread>,
) -> Result<Offshore, Diagnostic> {
    let [draft_m, cm_depth_m, mass_kg] = reader.block(p::PLATFORM)?;
    let inertia_kg_m2 = matrix(reader, &p::I_MATRIX_PFORM)?;
    let reference_depth_m = reader.value(&p::REF_MSL)?;
    let [hydro_mass, hydro_stiffness, mooring_stiffness] = matrices(reader)?;
    reader.heading("the heading of the distributed added mass")?;
    let added_mass = distribution(reader, p::ADDED_MASS, stiffness_follows, unread)?;
    reader.heading(STIFFNESS_HEADING)?;
    let stiffness = distribution(reader, p::STIFFNESS, wires_or_nothing_follow, unread)?;
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

fn matrices(reader: &mut Reader<'_>) -> Result<[MatrixValue<6>; 3], Diagnostic> {
    let [mass, hydrostatic, mooring] = p::MATRICES;
    Ok([
        matrix(reader, mass)?,
        matrix(reader, hydrostatic)?,
        matrix(reader, mooring)?,
    ])
}

/// A line that announces a matrix, and its rows.
fn matrix<const N: usize>(
    reader: &mut Reader<'_>,
    parameter: &Parameter,
) -> Result<MatrixValue<N>, Diagnostic> {
    reader.comment(&format!("the line that announces {}", parameter.name))?;
    let mut matrix = MatrixValue {
        rows: [[0.0; N]; N],
        spans: std::array::from_fn(|_| 0..0),
    };
    for (row, span) in matrix.rows.iter_mut().zip(&mut matrix.spans) {
        let values = reader.list(parameter, N, After::Text)?;
        for (entry, value) in row.iter_mut().zip(&values) {
            *entry = value.value;
        }
        let ends = values.first().zip(values.last());
        *span = ends.map_or(0..0, |(first, last)| first.span.start..last.span.end);
    }
    Ok(matrix)
}

/// A table over the height: the number of rows, their heights, their values. `is_next` tells
/// whether the data that follow the table come next.
fn distribution(
    reader: &mut Reader<'_>,
    table @ [count, heights, values]: p::Table,
    is_next: fn(&Reader<'_>) -> bool,
    unread: &mut Vec<Unread>,
) -> Result<Distribution, Diagnostic> {
    let count = reader.count(count)?;
    let mut rows = Vec::new();
    if count.value == 0 {
        let at = count.span.start;
        unread.extend(unread::table_of_no_rows(&reader.lines, table, at));
        no_rows(reader, [heights, values], is_next)?;
        return Ok(Distribution { count, rows });
    }
    let after = match count.value {
        1 => After::Anything,
        _ => After::Text,
    };
    let heights = reader.list(heights, count.value, after)?;
    let values = reader.list(values, count.value, after)?;
    check_rising(&heights)?;
    if count.value > 1 {
        rows.extend(heights.into_iter().zip(values));
    }
    Ok(Distribution { count, rows })
}

/// Skips the heights and values of a table without rows. Fortran reads a record even for an empty
/// list; decks that omit one or both records are read if the data after the table show it.
fn no_rows(
    reader: &mut Reader<'_>,
    lists: [&Parameter; 2],
    is_next: fn(&Reader<'_>) -> bool,
) -> Result<(), Diagnostic> {
    let after = |records: usize| {
        let mut rest = reader.clone();
        let mut passed = lists.iter().take(records).map(|list| rest.skipped(list));
        passed.try_for_each(|result| result).map(|()| rest)
    };
    let fits = |records: usize| after(records).ok().filter(is_next);
    let shown = [2, 1, 0].into_iter().find_map(fits);
    *reader = shown.map_or_else(|| after(2), Ok)?;
    Ok(())
}

fn check_rising(heights: &[Value<f64>]) -> Result<(), Diagnostic> {
    let falls = |pair: &&[Value<f64>]| pair[1].value < pair[0].value;
    let Some(pair) = heights.windows(2).find(falls) else {
        return Ok(());
    };
    let kind = DiagnosticKind::not_rising("height", pair[1].value, pair[0].value, "m");
    let hint = "heights are listed from the flexible base upwards";
    Err(pair[1].wrong(kind).with_hint(hint))
}
