//! The modes of a rotating blade.

use std::f64::consts::TAU;

use super::error::SolveError;
use super::errors::tracking::{Ladder, Levels, MORE};
use super::on_mesh::spectrum::Found;
use super::request::checks::{check_modes, check_segments, check_size};
use super::request::cost::Cost;
use super::results::solution::Certificate;
use super::solver::Solver;
use super::workspace::Workspace;
use crate::Method;
use crate::beam::blade_coordinates;
use crate::blade::Blade;
use crate::eigen::EigenError;
use crate::modes::{ByMotion, ModeCurve, Ordinal, ShapePoint};
use crate::subsystem::Coefficients;

/// Largest number of elements of a blade: each element has a full matrix, and the error estimate
/// takes eight times as many elements.
pub const MAX_BLADE_ELEMENTS: usize = 10_000;

/// The type of motion of a blade's mode: the motion with most of the kinetic energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
pub enum BladeFamily {
    /// Bending out of the rotor's plane.
    Flap,
    /// Bending in the rotor's plane (edgewise).
    Lag,
    /// Torsion about the span.
    Torsion,
    /// Axial motion along the span.
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
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BladeMode {
    /// Number in the list, from 1.
    pub number: usize,
    /// Natural frequency in the rotating frame, Hz.
    pub frequency_hz: f64,
    /// The kind of motion.
    pub family: BladeFamily,
    /// Order within the family, from 1.
    pub order: usize,
    /// Bound on the error of the eigenvalue computation, Hz.
    pub algebraic_error_hz: f64,
    /// Estimate of the discretization error, Hz.
    pub discretization_error_hz: f64,
    /// The frequency extrapolated from elements cut in two, Hz.
    pub extrapolated_hz: f64,
    /// Fractions of the kinetic energy: `fore_aft` is edgewise (lag), `side_side` flapwise.
    #[cfg_attr(
        feature = "serde",
        serde(serialize_with = "crate::modes::serialized::blade_energy")
    )]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "crate::modes::serialized::BladeEnergy")
    )]
    pub kinetic: ByMotion,
    /// The shape at the radii requested: X edgewise, Y flap, Z along the span, and rotations about
    /// these. Its largest translation (for torsion its largest rotation) is 1; `height_m` is the
    /// distance from the rotor's axis.
    #[cfg_attr(
        feature = "serde",
        serde(serialize_with = "crate::modes::serialized::shape")
    )]
    #[cfg_attr(feature = "schema", schemars(with = "crate::modes::serialized::Shape"))]
    pub shape: Vec<ShapePoint>,
}

/// The lowest modes of a rotating blade, with their errors and the proof that none is missing.
#[derive(Debug, Clone, PartialEq)]
pub struct BladeSolution {
    /// Number of elements.
    pub elements: usize,
    /// Degrees of freedom.
    pub degrees_of_freedom: usize,
    /// The modes by frequency.
    pub modes: Vec<BladeMode>,
    /// The proof that no mode is missing.
    pub certificate: Certificate,
}

impl Solver {
    /// Computes the lowest modes of a rotating blade by the element of BModes, with the shapes at
    /// distances from the rotor's axis, m. The options have no effect.
    ///
    /// # Errors
    /// [`SolveError`]: more modes than there are, or a rotation that makes the blade unstable.
    ///
    /// # Example
    /// A uniform cantilever at standstill: f₁ = 1.8751²/(2π) √(EI/(m L⁴)).
    /// ```
    /// use towermodes::{Blade, BladeDescription, BladeSection, Solver};
    ///
    /// let section = |span| BladeSection {
    ///     span,
    ///     mass_kg_per_m: 100.0,
    ///     flap_n_m2: 1e8,
    ///     edge_n_m2: 4e8,
    ///     torsion_n_m2: 1e8,
    ///     axial_n: 1e10,
    ///     flap_inertia_kg_m: 10.0,
    ///     edge_inertia_kg_m: 40.0,
    ///     ..BladeSection::default()
    /// };
    /// let blade = Blade::new(BladeDescription {
    ///     tip_radius_m: 40.0,
    ///     sections: vec![section(0.0), section(1.0)],
    ///     borders: (0..=20).map(|k| f64::from(k) / 20.0).collect(),
    ///     ..BladeDescription::default()
    /// })?;
    /// let solution = Solver::default().blade(&blade, 2, &[])?;
    /// let (flap, edgewise) = (&solution.modes[0], &solution.modes[1]);
    /// assert!((flap.frequency_hz - 0.34975).abs() < 1e-4);
    /// assert!((edgewise.frequency_hz / flap.frequency_hz - 2.0).abs() < 1e-6);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn blade(
        &mut self,
        blade: &Blade,
        modes: usize,
        radii_m: &[f64],
    ) -> Result<BladeSolution, SolveError> {
        let mut solution = self.blade_once(blade, modes, radii_m)?;
        estimate_errors(blade, &mut solution.modes, &mut self.workspace)?;
        Ok(solution)
    }

    /// The same as [`blade`](Self::blade) on one mesh, without the discretization error of the
    /// modes (it is 0 in the result), which takes most of the time.
    ///
    /// # Errors
    /// As [`blade`](Self::blade).
    pub fn blade_once(
        &mut self,
        blade: &Blade,
        modes: usize,
        radii_m: &[f64],
    ) -> Result<BladeSolution, SolveError> {
        on_own_elements(blade, modes, radii_m, &mut self.workspace)
    }
}

impl Blade {
    /// The number of degrees of freedom of the blade, which is the number of its modes.
    pub fn degrees_of_freedom(&self) -> usize {
        unknowns(self, &self.description().borders)
    }
}

fn unknowns(blade: &Blade, borders: &[f64]) -> usize {
    blade_coordinates(blade) * (borders.len() - 1)
}

fn on_own_elements(
    blade: &Blade,
    modes: usize,
    radii_m: &[f64],
    workspace: &mut Workspace,
) -> Result<BladeSolution, SolveError> {
    let borders = &blade.description().borders;
    let elements = borders.len() - 1;
    check_segments(elements, MAX_BLADE_ELEMENTS)?;
    check_modes(modes)?;
    let found = solve_cut(blade, borders, modes, workspace)?;
    let Workspace {
        model, spectrum, ..
    } = &mut *workspace;
    let proof = spectrum.prove(model, &found, modes)?;
    let borders_m: Vec<f64> = borders.iter().map(|b| blade.radius_m(*b)).collect();
    let shapes = found[..modes].iter().enumerate();
    let mut modes: Vec<BladeMode> = shapes
        .map(|(index, found)| mode(index, found, &borders_m, radii_m, workspace))
        .collect();
    number_families(&mut modes);
    Ok(BladeSolution {
        elements,
        degrees_of_freedom: workspace.model.degrees_of_freedom(),
        modes,
        certificate: Certificate::of(&proof),
    })
}

/// Assembles a blade with elements between these fractions of its span and solves it for at least
/// the modes requested.
fn solve_cut(
    blade: &Blade,
    borders: &[f64],
    modes: usize,
    workspace: &mut Workspace,
) -> Result<Vec<Found>, SolveError> {
    let (elements, unknowns) = (borders.len() - 1, unknowns(blade, borders));
    check_size(modes, elements, unknowns)?;
    Cost::of_blade(unknowns, elements, modes).check(modes)?;
    let Workspace {
        model, spectrum, ..
    } = workspace;
    model.assemble_blade(blade, borders);
    if !model.is_finite() {
        return Err(EigenError::NotFinite.into());
    }
    spectrum
        .solve(model, modes, None)
        .map_err(|error| match error {
            // Without rotation every blade is stable.
            EigenError::Unstable { negative } => SolveError::UnstableBlade {
                rotor_speed_rpm: 60.0 * blade.description().rotor_speed_rad_per_s / TAU,
                negative,
            },
            error => error.into(),
        })
}

/// A mode with its shape; the discretization error is not known yet.
fn mode(
    index: usize,
    found: &Found,
    borders_m: &[f64],
    radii_m: &[f64],
    workspace: &mut Workspace,
) -> BladeMode {
    let Workspace {
        model, spectrum, ..
    } = workspace;
    let vector = spectrum.vector(found.key);
    let forces = model.resultant(found.key.subsystem, &Coefficients::MASS, vector);
    let kinetic = ByMotion::sums(forces.energy).shares();
    let family = BladeFamily::of(&kinetic);
    let subsystem = model.subsystem(found.key.subsystem);
    let curves = subsystem.curves(borders_m, &|_, _, _| 0.0, vector);
    let normalized_by: &[usize] = match family {
        BladeFamily::Torsion => &[5],
        BladeFamily::Flap | BladeFamily::Lag | BladeFamily::Axial => &[0, 1, 2],
    };
    let curve = ModeCurve::new(borders_m, &*curves, normalized_by);
    let frequency_hz = found.eigenvalue.frequency_hz();
    BladeMode {
        number: index + 1,
        frequency_hz,
        family,
        order: 0,
        kinetic,
        algebraic_error_hz: found.eigenvalue.frequency_error_hz(),
        discretization_error_hz: 0.0,
        extrapolated_hz: frequency_hz,
        shape: curve.sample(radii_m),
    }
}

fn number_families(modes: &mut [BladeMode]) {
    for index in 0..modes.len() {
        let family = modes[index].family;
        let before = modes[..index].iter().filter(|mode| mode.family == family);
        modes[index].order = before.count() + 1;
    }
}

/// Solves again on finer elements and extrapolates.
fn estimate_errors(
    blade: &Blade,
    modes: &mut [BladeMode],
    workspace: &mut Workspace,
) -> Result<(), SolveError> {
    let powers = Method::Bmodes.bending_powers(false);
    let ladder = ladder(blade, powers.len() + MORE);
    let own_hz = modes.iter().map(|mode| mode.frequency_hz);
    let mut levels = Levels::default();
    ladder.solve(own_hz, &mut levels, |_, borders, level| {
        let found = solve_cut(blade, borders, modes.len(), workspace)?;
        let found = found[..modes.len()].iter();
        level.clear();
        level.extend(found.map(|mode| Some(mode.eigenvalue.frequency_hz())));
        Ok(())
    })?;
    for (index, mode) in modes.iter_mut().enumerate() {
        let estimate = levels.extrapolate(index, mode.frequency_hz, powers);
        mode.discretization_error_hz = estimate.error_hz;
        mode.extrapolated_hz = estimate.extrapolated_hz;
    }
    Ok(())
}

/// `steps` meshes beside the blade's own elements, each with half the elements of the one before.
/// Elements with sections inside are cut at these first, and are not one of the meshes: halving
/// alone would not show what they miss.
fn ladder(blade: &Blade, steps: usize) -> Ladder<Vec<f64>> {
    let borders = &blade.description().borders;
    let cut = with_sections(blade, borders);
    let is_own = cut.len() == borders.len();
    let finer = std::iter::successors(Some(cut), |borders| Some(halved(borders)));
    let mut meshes: Vec<Vec<f64>> = finer.take(steps + usize::from(is_own)).collect();
    meshes.reverse();
    Ladder {
        own: is_own.then(|| meshes.len() - 1),
        meshes,
    }
}

/// Fractions of the span that differ by less are the same.
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
