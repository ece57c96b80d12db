//! The body of a potential-flow solution: volume, hydrostatic stiffness and added mass.

use towermodes::AddedMassTable;
use towermodes::space::SpatialMatrix;

use super::spatial::{NONE, add, from_point, of_force, symmetric_part, turned_back};
use super::values::Values;
use super::wamit::{Read, read_added_mass, read_hydrostatic};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::error::ReadError;
use crate::note::Note;
use crate::resolver::{FileResolver, beside};
use crate::source::Source;

/// A rigid body whose water is described by a potential-flow solution.
#[derive(Debug, Clone, PartialEq)]
pub struct PotentialFlow {
    /// Displaced volume, m³.
    pub volume_m3: f64,
    /// Centre of buoyancy in x and y, m; its height is part of the stiffness.
    pub center_of_buoyancy_m: [f64; 2],
    /// Hydrostatic stiffness of water plane and buoyancy divided by ρ g, for motions (x, y, z,
    /// rotation about x, y, z) of the origin (0, 0, 0): m², m³, m⁴.
    pub hydrostatic: SpatialMatrix,
    /// Added mass for motions of the origin.
    pub added_mass: AddedMassTable,
}

/// A body with its notes and files.
pub(super) struct Found {
    pub(super) flow: PotentialFlow,
    pub(super) notes: Vec<Note>,
    pub(super) sources: Vec<Source>,
}

/// The axes and the unit of length of the files.
struct Frame {
    reference_m: [f64; 3],
    turned_deg: f64,
    unit_m: f64,
}

impl Frame {
    fn of(values: &Values<'_>) -> Result<Self, Diagnostic> {
        let [x, y, z] = ["PtfmRefxt", "PtfmRefyt", "PtfmRefzt"];
        let number = |name| values.number_or(name, 0.0);
        Ok(Self {
            reference_m: [number(x)?, number(y)?, number(z)?],
            turned_deg: number("PtfmRefztRot")?,
            unit_m: values.positive("WAMITULEN")?,
        })
    }

    /// The matrix about the origin with dimensions: the factor L^k for two translations, L^(k+1)
    /// for a translation and a rotation, L^(k+2) for two rotations.
    fn about_origin(&self, matrix: &SpatialMatrix, k: i32, factor: f64) -> SpatialMatrix {
        let rotations = |i: usize| i32::from(i > 2);
        let scaled = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let power = k + rotations(i) + rotations(j);
                factor * matrix[i][j] * self.unit_m.powi(power)
            })
        });
        from_point(&turned_back(&scaled, self.turned_deg), self.reference_m)
    }
}

/// The body of a file, if it has one (PotMod 1).
pub(super) fn read(
    values: &Values<'_>,
    source: &Source,
    files: &dyn FileResolver,
    folder: &str,
    density_kg_per_m3: f64,
) -> Result<Option<Found>, ReadError> {
    let wrong = |mistake| ReadError::mistake(source, mistake);
    if !is_used(values).map_err(wrong)? {
        return Ok(None);
    }
    check_one_body(values).map_err(wrong)?;
    let frame = Frame::of(values).map_err(wrong)?;
    let mut notes = Vec::new();
    let added_source = file(values, source, files, folder, ".1")?;
    let added = read_added_mass(&added_source).map_err(|m| ReadError::mistake(&added_source, m))?;
    let stiffness_source = file(values, source, files, folder, ".hst")?;
    let stiffness = read_hydrostatic(&stiffness_source)
        .map_err(|m| ReadError::mistake(&stiffness_source, m))?;
    let added_mass = symmetric_table(added, &added_source, &mut notes)
        .map_err(|m| ReadError::mistake(&added_source, m))?
        .map(|matrix| frame.about_origin(matrix, 3, density_kg_per_m3));
    let block = heave_block(&stiffness, &stiffness_source, &mut notes)
        .map_err(|m| ReadError::mistake(&stiffness_source, m))?;
    let mut hydrostatic = frame.about_origin(&block, 2, 1.0);
    let number = |name: &str| values.number(name).map_err(wrong);
    let volume_m3 = number("PtfmVol0")?;
    if volume_m3 < 0.0 {
        let kind = DiagnosticKind::out_of_range_in("PtfmVol0", volume_m3, "m3", "0 or positive");
        let token = values.expect("PtfmVol0").map_err(wrong)?;
        return Err(wrong(token.wrong(kind)));
    }
    if volume_m3 == 0.0 {
        let message = "PtfmVol0 is 0, so the buoyancy of the potential-flow body is not known and there is no static balance; give the displaced volume of WAMIT in m3";
        let token = values.expect("PtfmVol0").map_err(wrong)?;
        notes.push(Note::suspicious(message).at(source, token.span.start));
    }
    let [x, y] = [number("PtfmCOBxt")?, number("PtfmCOByt")?];
    // The stiffness of the files is for a centre of buoyancy above or below their own origin.
    let buoyancy = of_force([0.0, 0.0, volume_m3], [x, y, frame.reference_m[2]]);
    add(&mut hydrostatic, 1.0, &buoyancy);
    notes.extend(left_out(values, source));
    let flow = PotentialFlow {
        volume_m3,
        center_of_buoyancy_m: [x, y],
        hydrostatic,
        added_mass,
    };
    let sources = vec![added_source, stiffness_source];
    Ok(Some(Found {
        flow,
        notes,
        sources,
    }))
}

/// Whether the file has a potential-flow body: PotMod, or HasWAMIT in the first versions of FAST 8.
fn is_used(values: &Values<'_>) -> Result<bool, Diagnostic> {
    if let (None, Some(token)) = (values.token("PotMod"), values.token("HasWAMIT")) {
        return token.logical("HasWAMIT");
    }
    let token = values.expect("PotMod")?;
    match token.integer("PotMod (potential-flow model)")? {
        0 => Ok(false),
        1 => Ok(true),
        2 => {
            let message =
                "PotMod is 2 (fluid-impulse theory), which has no added mass by frequency";
            let mistake = token.wrong(DiagnosticKind::Unsupported(message.to_owned()));
            Err(mistake.with_hint("use files of WAMIT (PotMod 1) or strip theory (PotMod 0)"))
        }
        other => {
            let rule = "0 (none) or 1 (files of WAMIT)";
            Err(token.wrong(DiagnosticKind::out_of_range("PotMod", other as f64, rule)))
        }
    }
}

fn check_one_body(values: &Values<'_>) -> Result<(), Diagnostic> {
    let refused = |name: &str, most: i64, message: &str| match values.token(name) {
        Some(token) if token.integer(name)? > most => {
            let message = format!("{name} is {}: {message}", token.text);
            Err(token.wrong(DiagnosticKind::Unsupported(message)))
        }
        _ => Ok(()),
    };
    refused(
        "NBody",
        1,
        "only one rigid body with potential flow can be solved",
    )?;
    refused(
        "NAddDOF",
        0,
        "a body with generalized motions is not rigid and cannot be solved",
    )
}

/// The name of the files without extension.
fn file(
    values: &Values<'_>,
    source: &Source,
    files: &dyn FileResolver,
    folder: &str,
    ending: &str,
) -> Result<Source, ReadError> {
    let token = values
        .token("PotFile")
        .or_else(|| values.token("WAMITFile"));
    let token = match token {
        Some(token) => token,
        None => values
            .expect("PotFile")
            .map_err(|m| ReadError::mistake(source, m))?,
    };
    let name = format!("{}{ending}", token.text.trim());
    files.read(&beside(folder, &name)).map_err(|error| {
        let kind = DiagnosticKind::unreadable(format!("the {ending} file of PotFile"), &error);
        let hint = "PotFile is the name of the WAMIT files without their extensions, relative to the HydroDyn file";
        ReadError::mistake(source, token.wrong(kind).with_hint(hint))
    })
}

/// The table with symmetric matrices.
fn symmetric_table(
    read: Read<AddedMassTable>,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<AddedMassTable, Diagnostic> {
    let skews = read
        .content
        .matrices()
        .map(|matrix| symmetric_part(matrix).1);
    let skew = skews.fold(0.0, f64::max);
    notes.extend(on_triangle(read.is_upper_triangle, source));
    notes.extend(on_skew(skew, "the added mass", source)?);
    notes.extend(on_outlier(&read.content, source));
    Ok(read.content.map(|matrix| symmetric_part(matrix).0))
}

/// Heave, roll and pitch of the stiffness, made symmetric: HydroDyn uses no other rows and columns.
fn heave_block(
    read: &Read<SpatialMatrix>,
    source: &Source,
    notes: &mut Vec<Note>,
) -> Result<SpatialMatrix, Diagnostic> {
    let used = 2..5;
    let mut block = NONE;
    let mut largest = 0.0_f64;
    for (i, row) in read.content.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            match used.contains(&i) && used.contains(&j) {
                true => block[i][j] = *entry,
                false => largest = largest.max(entry.abs()),
            }
        }
    }
    if largest > 0.0 {
        let message = format!(
            "only heave, roll and pitch (rows and columns 3 to 5) are used, as in HydroDyn; the others have entries up to {largest}"
        );
        notes.push(Note::compatibility(message).at(source, 0));
    }
    let (symmetric, skew) = symmetric_part(&block);
    notes.extend(on_triangle(read.is_upper_triangle, source));
    notes.extend(on_skew(skew, "the hydrostatic stiffness", source)?);
    Ok(symmetric)
}

fn on_triangle(is_upper: bool, source: &Source) -> Option<Note> {
    let message = "the file has only entries on and above the diagonal: they are used below it too, where HydroDyn takes zeros";
    is_upper.then(|| Note::compatibility(message).at(source, 0))
}

/// The largest relative difference due to rounding.
const ROUNDED_SKEW: f64 = 1e-4;
/// The largest usual relative difference between entries that should be equal, due to the panels.
const USUAL_SKEW: f64 = 0.01;
/// A larger difference is caused by a wrong sign or a wrong entry.
const LARGEST_SKEW: f64 = 0.1;

fn on_skew(skew: f64, what: &str, source: &Source) -> Result<Option<Note>, Diagnostic> {
    let message = format!(
        "{what} is not symmetric: half the difference of opposite entries is up to {skew:.1e} of their size"
    );
    if skew > LARGEST_SKEW {
        let hint = "entries (i, j) and (j, i) of each period must be equal; check their signs, for example (1, 5) and (5, 1)";
        let kind = DiagnosticKind::Contradiction(message);
        return Err(Diagnostic::new(0..0, kind).with_hint(hint));
    }
    let message = format!("{message}; the mean of both is used");
    let note = match skew > USUAL_SKEW {
        true => Note::suspicious(message),
        false => Note::approximation(message),
    };
    Ok((skew > ROUNDED_SKEW).then(|| note.at(source, 0)))
}

/// The added mass of a body at any frequency is smaller than this multiple of its median over the
/// frequencies.
const OUTLIER: f64 = 100.0;

/// The note on a diagonal entry that differs by more than this at one frequency, for example
/// because of a wrong exponent.
fn on_outlier(table: &AddedMassTable, source: &Source) -> Option<Note> {
    let found = (0..6).find_map(|i| {
        let mut sizes: Vec<f64> = table.matrices().map(|matrix| matrix[i][i].abs()).collect();
        sizes.sort_by(f64::total_cmp);
        let (median, largest) = (sizes[sizes.len() / 2], *sizes.last()?);
        (largest > OUTLIER * median).then_some((i + 1, median, largest))
    });
    let (i, median, largest) = found?;
    let message = format!(
        "entry ({i}, {i}) of the added mass is up to {largest:e}, and {median:e} in the middle of its values: check the exponents of its lines"
    );
    Some(Note::suspicious(message).at(source, 0))
}

/// Notes on data that the model uses in another form than HydroDyn.
fn left_out(values: &Values<'_>, source: &Source) -> Vec<Note> {
    let mut notes = Vec::new();
    let token = values.token("FKMod");
    if let Some(token) = token.filter(|token| token.integer("FKMod").is_ok_and(|of| of != 0)) {
        let message = "FKMod is not 0, so HydroDyn has the buoyancy of the hull in GeoFile, which is not read: the stiffness of the .hst file, PtfmVol0 and the centre of buoyancy are used";
        notes.push(Note::approximation(message).at(source, token.span.start));
    }
    notes
}
