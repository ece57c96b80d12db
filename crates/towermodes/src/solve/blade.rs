//! The modes of a rotating blade.

use std::f64::consts::TAU;

use super::options::{MAX_BYTES, SolveError};
use super::solution::Certificate;
use crate::Method;
use crate::beam::{Beam, BeamWork, assemble_blade, blade_coordinates};
use crate::blade::Blade;
use crate::eigen::{EigenError, EigenWorkspace, Pencil, Verdict, lowest, verify};
use crate::modes::{BeamCurves, ByMotion, ModeCurve, Ordinal, ShapePoint, richardson};
use crate::parts::{Combination, SPACE, Structure, StructurePencil};

/// Relative distances above the last mode at which completeness is certified, widest first.
const MARGINS: [f64; 6] = [0.1, 0.03, 0.01, 1e-3, 1e-5, 1e-9];

/// More elements of a blade than this are refused: they hold full matrices, and errors are
/// estimated with eight times as many.
pub const MAX_BLADE_ELEMENTS: usize = 10_000;

/// The kind of motion of a blade's mode: that with most of the kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum BladeFamily {
    /// Out of the rotor's plane.
    Flap,
    /// In the rotor's plane.
    Lag,
    /// About the span.
    Torsion,
    /// Along the span.
    Axial,
}

impl BladeFamily {
    /// Its name in results.
    pub fn name(self) -> &'static str {
        match self {
            Self::Flap => "flap",
            Self::Lag => "lag",
            Self::Torsion => "torsion",
            Self::Axial => "axial",
        }
    }

    /// Its name with an ordinal: "2nd flap".
    pub fn label(self, order: usize) -> String {
        format!("{} {}", Ordinal(order), self.name())
    }

    fn of(kinetic: &ByMotion) -> Self {
        let families = [Self::Lag, Self::Flap, Self::Torsion, Self::Axial];
        let shares = families.into_iter().zip(kinetic.values());
        let most = shares.max_by(|a, b| a.1.total_cmp(&b.1));
        most.map_or(Self::Flap, |(family, _)| family)
    }
}

/// A natural mode of a rotating blade.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeMode {
    /// Place in the list, from 1.
    pub number: usize,
    /// Natural frequency in the rotating frame, Hz.
    pub frequency_hz: f64,
    /// The kind of motion.
    pub family: BladeFamily,
    /// Order within the family, from 1.
    pub order: usize,
    /// Shares of the kinetic energy: `fore_aft` is lag, `side_side` flap.
    pub kinetic: ByMotion,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the error of the elements, Hz.
    pub discretization_error_hz: f64,
    /// The frequency extrapolated from elements cut in two, Hz.
    pub extrapolated_hz: f64,
    /// The motion (X lag, Y flap, Z along the span; rotations about these) at the radii asked for,
    /// its largest translation, or for torsion rotation, 1; `height_m` is the distance from the
    /// rotor's axis.
    pub shape: Vec<ShapePoint>,
}

/// The lowest modes of a rotating blade, with their errors and the proof that they are all.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeSolution {
    /// Number of elements.
    pub elements: usize,
    /// Degrees of freedom.
    pub degrees_of_freedom: usize,
    /// The modes by frequency.
    pub modes: Vec<BladeMode>,
    /// The proof that none is missing.
    pub certificate: Certificate,
}

/// Finds the lowest modes of a rotating blade by the element of BModes, with its shapes at
/// distances from the rotor's axis, m.
///
/// # Errors
/// [`SolveError`]: more modes than there are, or a rotation that makes the blade unstable.
pub fn solve_blade(
    blade: &Blade,
    modes: usize,
    radii_m: &[f64],
) -> Result<BladeSolution, SolveError> {
    let mut solution = solve_blade_once(blade, modes, radii_m)?;
    estimate(blade, &blade.description().borders, &mut solution.modes)?;
    Ok(solution)
}

/// The number of degrees of freedom of a blade, and so of its modes.
pub fn blade_degrees_of_freedom(blade: &Blade) -> usize {
    blade_coordinates(blade) * (blade.description().borders.len() - 1)
}

/// The same as [`solve_blade`] on one mesh, without the discretization error of the modes (it is 0
/// in the result), which takes most of the time.
///
/// # Errors
/// As [`solve_blade`].
pub fn solve_blade_once(
    blade: &Blade,
    modes: usize,
    radii_m: &[f64],
) -> Result<BladeSolution, SolveError> {
    let borders = &blade.description().borders;
    let elements = borders.len() - 1;
    if elements > MAX_BLADE_ELEMENTS {
        let (segments, most) = (elements, MAX_BLADE_ELEMENTS);
        return Err(SolveError::Segments { segments, most });
    }
    if modes == 0 {
        return Err(SolveError::NoModes);
    }
    let mut found = Solved::new(blade, borders, modes)?;
    let certificate = found.prove(modes)?;
    let shapes: Vec<BladeMode> = (0..modes).map(|i| found.mode(blade, i, radii_m)).collect();
    let mut solution = BladeSolution {
        elements,
        degrees_of_freedom: found.beam.degrees_of_freedom(),
        modes: shapes,
        certificate,
    };
    number_families(&mut solution.modes);
    Ok(solution)
}

/// A blade cut and solved.
struct Solved {
    beam: Beam<6>,
    work: BeamWork,
    eigen: EigenWorkspace,
    radii_m: Vec<f64>,
}

impl Solved {
    fn new(blade: &Blade, borders: &[f64], modes: usize) -> Result<Self, SolveError> {
        let mut solved = Self {
            beam: Beam::default(),
            work: BeamWork::default(),
            eigen: EigenWorkspace::default(),
            radii_m: borders.iter().map(|b| blade.radius_m(*b)).collect(),
        };
        assemble_blade(blade, borders, &mut solved.beam);
        if !solved.beam.is_finite() {
            return Err(EigenError::NotFinite.into());
        }
        let available = solved.beam.degrees_of_freedom();
        if modes > available {
            let segments = borders.len() - 1;
            return Err(SolveError::TooManyModes {
                modes,
                segments,
                available,
            });
        }
        // Vectors for a mode as of a tower's elements of BModes, and the mode itself.
        let bytes =
            (6 * modes + 20).min(2 * available) as f64 * (available * size_of::<f64>()) as f64;
        if bytes > MAX_BYTES as f64 {
            let degrees_of_freedom = available;
            return Err(SolveError::TooLarge {
                modes,
                degrees_of_freedom,
                bytes,
            });
        }
        let Self {
            beam, work, eigen, ..
        } = &mut solved;
        let found = lowest(&mut StructurePencil::vibration(beam, work), modes, eigen);
        match found {
            // Without rotation every blade is stable.
            Err(EigenError::Unstable { negative }) => Err(SolveError::UnstableBlade {
                rotor_speed_rpm: 60.0 * blade.description().rotor_speed_rad_per_s / TAU,
                negative,
            }),
            found => Ok(found.map(|_| solved)?),
        }
    }

    /// Counts the modes below the gap above the last one asked for.
    fn prove(&mut self, modes: usize) -> Result<Certificate, SolveError> {
        let Self {
            beam, work, eigen, ..
        } = self;
        let lambdas = eigen.eigenvalues();
        let last = lambdas[modes - 1].lambda;
        let is_repeated = |e: &&crate::eigen::Eigenvalue| e.lambda <= last * (1.0 + 1e-9);
        let expected = modes + lambdas[modes..].iter().take_while(is_repeated).count();
        let mut pencil = StructurePencil::vibration(&*beam, work);
        match verify(last, expected, &MARGINS, |shift| pencil.count_below(shift)) {
            Verdict::Complete { margin } => Ok(Certificate {
                complete: true,
                count: expected,
                below_hz: (last * (1.0 + margin)).sqrt() / TAU,
            }),
            Verdict::Disagrees { count, shift } => Err(EigenError::Incomplete {
                found: expected,
                counted: count,
                below_hz: shift.sqrt() / TAU,
                restarts: 0,
            }
            .into()),
        }
    }

    /// A mode, its errors of the elements still unknown.
    fn mode(&mut self, blade: &Blade, index: usize, radii_m: &[f64]) -> BladeMode {
        let eigenvalue = self.eigen.eigenvalues()[index];
        let vector = self.eigen.vector(index);
        let base_m = blade.description().hub_radius_m;
        let (beam, work) = (&self.beam, &mut self.work);
        let balance = beam.balance(&Combination::MASS, work, vector, base_m);
        let kinetic = ByMotion::sums(balance.energy).shares();
        let family = BladeFamily::of(&kinetic);
        let curves = BeamCurves::of_beam(beam, &SPACE, vector);
        let normalized_by: &[usize] = match family {
            BladeFamily::Torsion => &[5],
            _ => &[0, 1, 2],
        };
        let curve = ModeCurve::new(&self.radii_m, &curves, normalized_by);
        let frequency_hz = eigenvalue.frequency_hz();
        BladeMode {
            number: index + 1,
            frequency_hz,
            family,
            order: 0,
            kinetic,
            algebraic_error_hz: eigenvalue.frequency_error_hz(),
            discretization_error_hz: 0.0,
            extrapolated_hz: frequency_hz,
            shape: curve.sample(radii_m),
        }
    }
}

fn number_families(modes: &mut [BladeMode]) {
    for index in 0..modes.len() {
        let family = modes[index].family;
        let before = modes[..index].iter().filter(|mode| mode.family == family);
        modes[index].order = before.count() + 1;
    }
}

/// Solves again with every element cut in two, as often as the errors have powers, and
/// extrapolates. Elements that reach over sections of the blade are cut at these first: no halving
/// alone would see what they miss.
fn estimate(blade: &Blade, borders: &[f64], modes: &mut [BladeMode]) -> Result<(), SolveError> {
    let powers = Method::Bmodes.bending_powers(false);
    let mut finer = with_sections(blade, borders);
    let mut meshes_hz: Vec<Vec<f64>> = Vec::new();
    if finer.len() == borders.len() {
        meshes_hz.push(modes.iter().map(|mode| mode.frequency_hz).collect());
        finer = halved(&finer);
    }
    // As many meshes as the powers need; where the elements' own are one more, these find out what
    // agrees by chance.
    for _ in 0..=powers.len() {
        let solved = Solved::new(blade, &finer, modes.len())?;
        let found = solved.eigen.eigenvalues().iter();
        meshes_hz.insert(0, found.map(|e| e.frequency_hz()).collect());
        finer = halved(&finer);
    }
    for (index, mode) in modes.iter_mut().enumerate() {
        let meshes_hz = meshes_hz.iter().map(|mesh| mesh[index]).collect();
        let estimate = richardson(mode.frequency_hz, meshes_hz, powers);
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
    }
    Ok(())
}

/// Shares of the span that differ by less are the same.
const ROUNDED: f64 = 1e-9;

/// The borders of the elements, and the sections that lie between them.
fn with_sections(blade: &Blade, borders: &[f64]) -> Vec<f64> {
    let sections = blade.description().sections.iter();
    let mut all = borders.to_vec();
    for span in sections.map(|section| section.span) {
        let place = all.partition_point(|border| *border < span - ROUNDED);
        let is_inside = place > 0 && place < all.len();
        if is_inside && all[place] > span + ROUNDED {
            all.insert(place, span);
        }
    }
    all
}

fn halved(borders: &[f64]) -> Vec<f64> {
    let mut finer = Vec::with_capacity(2 * borders.len());
    for pair in borders.windows(2) {
        finer.extend([pair[0], 0.5 * (pair[0] + pair[1])]);
    }
    finer.extend(borders.last());
    finer
}
