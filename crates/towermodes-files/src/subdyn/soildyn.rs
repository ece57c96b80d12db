//! The input file of SoilDyn, the OpenFAST module for soil: stiffness at points of the
//! substructure (CalcOption 1).
//!
//! Source: `SoilDyn_IO.f90` (OpenFAST), which reads it by position. The number of points is not in
//! the file, because there is only one.

use towermodes::frame::FrameSupport;
use towermodes::space::SpatialMatrix;

use super::input::SubdynInput;
use crate::diagnostic::{Diagnostic, DiagnosticKind, Exact};
use crate::error::ReadError;
use crate::note::Note;
use crate::records::{Line, Lines, Token};
use crate::source::Source;

/// A joint belongs to a point of soil if its distance is smaller than this, m, as in OpenFAST.
const NEAR_M: f64 = 0.1;

/// Soil at a point, as its file describes it.
#[derive(Debug, Clone, PartialEq)]
pub struct SoildynInput {
    /// Position of the point, m.
    pub position_m: [f64; 3],
    /// Stiffness for motions (x, y, z, rotation about x, y, z) of the point: N/m, N, N m.
    pub stiffness: SpatialMatrix,
    /// Notes on omitted data.
    pub notes: Vec<Note>,
    pub(crate) source: Source,
    /// The byte of the position.
    at: usize,
}

/// Reads an input file of SoilDyn.
///
/// # Errors
/// The first mistake in the file; curves of pressure (CalcOption 2) and a DLL (CalcOption 3) are
/// refused.
pub fn read_soildyn(source: Source) -> Result<SoildynInput, ReadError> {
    let found = found(&source).map_err(|mistake| ReadError::mistake(&source, mistake))?;
    let (position_m, stiffness, damped, at) = found;
    let message = "the damping of the soil is not used: modes have no damping";
    let notes = damped.map(|at| Note::left_out(message).at(&source, at));
    Ok(SoildynInput {
        position_m,
        stiffness,
        notes: notes.into_iter().collect(),
        source,
        at,
    })
}

/// Position, stiffness, the byte of a damping that is not zero, the byte of the position.
type Found = ([f64; 3], SpatialMatrix, Option<usize>, usize);

fn found(source: &Source) -> Result<Found, Diagnostic> {
    let mut lines = Lines::new(&source.text);
    let option = lines
        .by_ref()
        .find(|line| is_named(line, "CalcOption"))
        .ok_or_else(|| {
            let found = "no input file of SoilDyn".to_owned();
            Diagnostic::new(0..0, DiagnosticKind::WrongFile { found })
                .with_hint("such a file has CalcOption on one of its first lines")
        })?;
    check_option(&option)?;
    let mut numeric = lines.filter(|line| line.first().is_some_and(|token| token.is_number()));
    let mut row = |what: &str| {
        numeric.next().ok_or_else(|| {
            let end = source.text.trim_end().len();
            let expected = what.to_owned();
            Diagnostic::new(end..end, DiagnosticKind::EndOfFile { expected })
        })
    };
    let place = row("the location of the soil")?;
    let position_m = numbers::<3>(&place, "the location of the soil")?;
    let mut matrix = |of: &str| -> Result<(SpatialMatrix, usize), Diagnostic> {
        let mut matrix = [[0.0; 6]; 6];
        let mut start = 0;
        for (k, values) in matrix.iter_mut().enumerate() {
            let what = format!("row {} of the {of} matrix", k + 1);
            let line = row(&what)?;
            start = if k == 0 { line.start } else { start };
            *values = numbers::<6>(&line, &what)?;
        }
        Ok((matrix, start))
    };
    let (stiffness, at) = matrix("stiffness")?;
    check_symmetric(&stiffness, at, &source.text)?;
    let (damping, damping_at) = matrix("damping")?;
    let damped = (damping != [[0.0; 6]; 6]).then_some(damping_at);
    Ok((position_m, stiffness, damped, place.start))
}

fn is_named(line: &Line<'_>, name: &str) -> bool {
    let second = line.tokens().nth(1);
    second.is_some_and(|token| token.text.eq_ignore_ascii_case(name))
}

fn check_option(line: &Line<'_>) -> Result<(), Diagnostic> {
    let Some(token) = line.first() else {
        let what = "CalcOption".to_owned();
        return Err(Diagnostic::new(
            line.span(),
            DiagnosticKind::Missing { what },
        ));
    };
    let refused = |reason: &str| {
        let hint = "give the stiffness of the soil at the working point as a matrix (CalcOption 1), or in an SSI file of SubDyn";
        Err(token
            .wrong(DiagnosticKind::Unsupported(reason.to_owned()))
            .with_hint(hint))
    };
    match token.integer("CalcOption (model of the soil)")? {
        1 => Ok(()),
        2 => refused("CalcOption is 2 (P-Y curves), which OpenFAST does not support yet either"),
        3 => refused(
            "CalcOption is 3 (REDWIN): the stiffness of the soil is inside a DLL, which cannot be run here",
        ),
        other => {
            let rule = "1 (stiffness matrix), 2 (P-Y curves) or 3 (REDWIN)";
            Err(token.wrong(DiagnosticKind::out_of_range(
                "CalcOption",
                other as f64,
                rule,
            )))
        }
    }
}

/// The numbers at the beginning of a line.
fn numbers<const N: usize>(line: &Line<'_>, what: &str) -> Result<[f64; N], Diagnostic> {
    line.check_commas(what)?;
    let tokens: Vec<Token<'_>> = line.tokens().take(N).collect();
    let count = tokens.iter().take_while(|token| token.is_number()).count();
    if count < N {
        let kind = DiagnosticKind::wrong_count_of("numbers", what, count, N);
        let hint = "after CalcOption follow the location (x, y, z), six rows of the stiffness and six of the damping";
        return Err(Diagnostic::new(line.span(), kind).with_hint(hint));
    }
    let mut values = [0.0; N];
    for (value, token) in values.iter_mut().zip(&tokens) {
        *value = token.number(what)?;
    }
    Ok(values)
}

/// Entries count as equal if they differ only by rounding of printed digits.
const SYMMETRIC: f64 = 1e-6;

fn check_symmetric(matrix: &SpatialMatrix, at: usize, text: &str) -> Result<(), Diagnostic> {
    let size = matrix
        .as_flattened()
        .iter()
        .fold(0.0_f64, |a, x| a.max(x.abs()));
    for (i, row) in matrix.iter().enumerate() {
        for (j, lower) in row[..i].iter().enumerate() {
            let upper = matrix[j][i];
            if (lower - upper).abs() > SYMMETRIC * size {
                let message = format!(
                    "entry ({}, {}) of the stiffness is {}, but entry ({}, {}) is {}: the matrix must be symmetric",
                    i + 1,
                    j + 1,
                    Exact(*lower),
                    j + 1,
                    i + 1,
                    Exact(upper)
                );
                let end = text[at..]
                    .find('\n')
                    .map_or(text.len(), |length| at + length);
                return Err(Diagnostic::new(
                    at..end,
                    DiagnosticKind::Contradiction(message),
                ));
            }
        }
    }
    Ok(())
}

impl SubdynInput {
    /// Adds the soil of a SoilDyn file to the joint at its point.
    ///
    /// # Errors
    /// [`ReadError::Mistakes`] in the SoilDyn file if no joint is within 0.1 m of the point, or if
    /// all motions of this joint are fixed.
    pub fn stand_on(&mut self, soil: &SoildynInput) -> Result<(), ReadError> {
        let joint = self.joint_at(soil).map_err(|kind| {
            let text = &soil.source.text;
            let end = text[soil.at..]
                .find('\n')
                .map_or(text.len(), |n| soil.at + n);
            ReadError::mistake(&soil.source, Diagnostic::new(soil.at..end, kind))
        })?;
        let supports = &mut self.description.supports;
        let index = supports.iter().position(|support| support.joint == joint);
        let index = index.unwrap_or_else(|| {
            let mut support = FrameSupport::clamped(joint);
            support.fixed = [false; 6];
            supports.push(support);
            self.spans.supports.push(self.spans.joints[joint].clone());
            supports.len() - 1
        });
        let sum = supports[index].stiffness.as_flattened_mut();
        for (sum, own) in sum.iter_mut().zip(soil.stiffness.as_flattened()) {
            *sum += own;
        }
        // The note that nothing holds the joint is wrong now.
        let held = self.loose.extract_if(.., |(loose, _)| *loose == joint);
        let held: Vec<Note> = held.map(|(_, note)| note).collect();
        self.notes.retain(|note| !held.contains(note));
        self.notes.extend(soil.notes.iter().cloned());
        self.sources.push(soil.source.clone());
        Ok(())
    }

    /// The joint at the point of soil, which must have a free motion.
    fn joint_at(&self, soil: &SoildynInput) -> Result<usize, DiagnosticKind> {
        let distance = |position_m: &[f64; 3]| {
            let squares = position_m.iter().zip(&soil.position_m);
            squares.map(|(a, b)| (a - b) * (a - b)).sum::<f64>().sqrt()
        };
        let joints = self.description.joints.iter().enumerate();
        let distances = joints.map(|(index, joint)| (distance(&joint.position_m), index));
        let nearest = distances.min_by(|a, b| a.0.total_cmp(&b.0));
        let Some((_, joint)) = nearest.filter(|(distance_m, _)| *distance_m <= NEAR_M) else {
            let nearest = nearest.map_or_else(String::new, |(distance_m, joint)| {
                let name = &self.description.joints[joint].name;
                format!("; the nearest one, {name}, is {distance_m:.3} m away")
            });
            let message = format!(
                "no joint of SubDyn is within {NEAR_M} m of the location of the soil{nearest}"
            );
            return Err(DiagnosticKind::Contradiction(message));
        };
        let mut supports = self.description.supports.iter();
        match supports.any(|support| support.joint == joint && support.is_clamped()) {
            false => Ok(joint),
            true => {
                let name = &self.description.joints[joint].name;
                let message = format!(
                    "SubDyn holds all motions of joint {name}, so the soil there has no effect: its flags must be 0 where the soil acts"
                );
                Err(DiagnosticKind::Contradiction(message))
            }
        }
    }
}
