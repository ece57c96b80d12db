//! The front door: a tower in, its modes out.

mod alignment;
mod blade;
mod certain;
mod cost;
mod degree;
mod estimate;
mod model;
mod naming;
mod options;
mod reference;
mod solution;
mod spectrum;
mod stability;
mod until;
mod warnings;
mod watch;

pub use blade::{
    BladeFamily, BladeMode, BladeSolution, blade_degrees_of_freedom, solve_blade, solve_blade_once,
};
pub use certain::solve_certain;
pub use options::{
    DEFAULT_MODES, DEFAULT_POINTS, DEFAULT_SEGMENTS, MAX_BYTES, MAX_DEGREE, MAX_POINTS,
    MAX_SECONDS, MAX_SEGMENTS, MAX_SPECTRAL_ELEMENTS, Options, SolveError,
};
pub use solution::{Certificate, Mode, Solution};
pub use until::solve_until;
pub use watch::{Progress, Stage};

use crate::eigen::{EigenError, Statistics};
use crate::elements::Mesh;
use crate::modes::ModeCurve;
use crate::space::SpatialMatrix;
use crate::tower::Tower;
use crate::{Method, Warning};
use cost::Cost;
use estimate::estimate_errors;
use model::{Cut, Model};
use naming::{Identity, identify};
pub use spectrum::ModeKey;
use spectrum::{Found, Proof, Spectrum};
use stability::{VERGE, begin_below_zero, buckles, buckling_load_factor, find_origin, is_pressed};
use warnings::{irregular, uncertain_end, warnings};
use watch::Watch;

/// Memory that is reused from solve to solve.
#[derive(Debug, Default)]
pub struct Workspace {
    model: Model,
    spectrum: Spectrum,
}

impl Workspace {
    /// Memory whose solves tell somebody what they are at, many times a second or never for a long
    /// time, as the tower is. What is computed is the same.
    ///
    /// # Example
    /// ```
    /// use towermodes::{Material, Options, Station, Tower, TowerDescription, Workspace, solve_with};
    ///
    /// let tower = Tower::new(TowerDescription {
    ///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
    ///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
    ///     ..TowerDescription::default()
    /// })?;
    /// let mut workspace = Workspace::watched(|progress| eprintln!("{progress:?}"));
    /// let solution = solve_with(&tower, &Options::default(), &mut workspace)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn watched(observer: impl FnMut(Progress) + Send + Sync + 'static) -> Self {
        let mut workspace = Self::default();
        workspace.model.watch = Watch::new(Box::new(observer));
        workspace
    }
}

/// Finds the lowest modes of a tower.
///
/// # Errors
/// [`SolveError`]: impossible options, or a computation that failed; never an incomplete list.
///
/// # Example
/// See the [crate's front page](crate).
pub fn solve(tower: &Tower, options: &Options) -> Result<Solution, SolveError> {
    solve_with(tower, options, &mut Workspace::default())
}

/// [`solve`] in memory that was used before: for those who ask a million times.
///
/// # Errors
/// As [`solve`].
pub fn solve_with(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    options.check()?;
    workspace.model.watch.restart();
    match options.method {
        Method::Spectral => degree::solve(tower, options, workspace),
        _ => solve_segments(tower, options, workspace),
    }
}

/// On segments of a fixed kind: solved once, the errors estimated from meshes of half or twice as
/// many.
fn solve_segments(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Solution, SolveError> {
    let cut = Cut {
        mesh: mesh_of(tower, options)?,
        degree: 0,
    };
    let found = solve_cut(tower, &cut, options, workspace)?;
    let statistics = workspace.spectrum.statistics;
    let mut result = describe(tower, &cut, options, &found, workspace)?;
    let estimates = estimate_errors(tower, &cut, options, &mut result, workspace)?;
    let mut warnings = warnings(tower, &cut.mesh, options, &result);
    warnings.extend(irregular(&result.modes, &estimates.irregular));
    let elsewhere = estimates.elsewhere;
    warnings.extend(uncertain_end(&result.modes, &result.certificate, elsewhere));
    let segments = cut.mesh.segments();
    Ok(result.into_solution(options.method, segments, warnings, statistics))
}

/// What a solved cut gives before its errors are known.
struct Described {
    modes: Vec<Mode>,
    /// Polynomial degree, if it is the spectral beam.
    degree: Option<usize>,
    certificate: Certificate,
    /// Where the list was certified to end, λ, rad²/s².
    below: f64,
    /// The mode that repeats the last of the list and is not in it: label and frequency (Hz).
    cut_off: Option<(String, f64)>,
    degrees_of_freedom: usize,
    rigid_inertia: SpatialMatrix,
    buckling_load_factor: Option<f64>,
}

impl Described {
    fn into_solution(
        self,
        method: Method,
        segments: usize,
        warnings: Vec<Warning>,
        statistics: Statistics,
    ) -> Solution {
        Solution {
            method,
            segments,
            degree: self.degree,
            degrees_of_freedom: self.degrees_of_freedom,
            certificate: self.certificate,
            modes: self.modes,
            rigid_inertia: self.rigid_inertia,
            buckling_load_factor: self.buckling_load_factor,
            warnings,
            statistics,
        }
    }
}

/// Proves that nothing is missing below what was found, and describes the modes asked for.
fn describe(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    found: &[Found],
    workspace: &mut Workspace,
) -> Result<Described, SolveError> {
    let Workspace { model, spectrum } = workspace;
    model.watch.enter(Stage::Certificate);
    let proof = spectrum.prove(model, found, options.modes)?;
    model.watch.enter(Stage::Buckling);
    let buckling_load_factor = buckling_load_factor(tower, model, Some(spectrum))?;
    model.watch.enter(Stage::Shapes);
    let rigid_inertia = tower.rigid_inertia(options.has_rotary_inertia());
    let listed = &found[..found.len().min(options.modes + 1)];
    let identities = identify(tower, model, spectrum, listed, &rigid_inertia);
    let modes = shapes(tower, &cut.mesh, options, listed, &identities, workspace)?;
    let (origin, last) = (workspace.model.origin, &found[options.modes - 1]);
    let next = listed.get(options.modes).zip(identities.get(options.modes));
    let cut_off = next.filter(|(found, _)| found.repeats(last, origin));
    Ok(Described {
        modes,
        degree: (options.method == Method::Spectral).then_some(cut.degree),
        certificate: certificate(&proof),
        below: proof.below,
        cut_off: cut_off.map(|(found, identity)| {
            let label = identity.family.label(identity.order);
            (label, found.eigenvalue.frequency_hz())
        }),
        degrees_of_freedom: workspace.model.degrees_of_freedom(),
        rigid_inertia,
        buckling_load_factor,
    })
}

fn certificate(proof: &Proof) -> Certificate {
    Certificate {
        complete: true,
        count: proof.count,
        below_hz: proof.below.max(0.0).sqrt() / std::f64::consts::TAU,
    }
}

fn mesh_of(tower: &Tower, options: &Options) -> Result<Mesh, SolveError> {
    let (borders, most) = (options.borders(), MAX_SEGMENTS);
    if let Some(borders_m) = &options.borders_m {
        within_limit(borders_m.len().saturating_sub(1), most)?;
        return Ok(Mesh::with_borders(tower, borders_m)?);
    }
    let fewest = Mesh::fewest_segments(tower, borders);
    let Some(segments) = options.segments else {
        return within_limit(fewest, most)
            .map(|()| Mesh::at_least(tower, borders, DEFAULT_SEGMENTS));
    };
    within_limit(segments, most)?;
    within_limit(fewest, most)?;
    // BModes' own elements are equal wherever they can be.
    let equal = match options.method {
        Method::Bmodes => Mesh::equal(tower, borders, segments),
        _ => None,
    };
    Ok(equal.unwrap_or_else(|| Mesh::new(tower, borders, segments)))
}

fn within_limit(segments: usize, most: usize) -> Result<(), SolveError> {
    if (1..=most).contains(&segments) {
        Ok(())
    } else {
        Err(SolveError::Segments { segments, most })
    }
}

/// Assembles the tower as cut and solves it for at least the modes asked for.
fn solve_cut(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Vec<Found>, SolveError> {
    let cost = Cost::of(tower, cut, options);
    // More modes than there are is another mistake, which is said below.
    if options.limits && options.modes as f64 <= cost.unknowns {
        options.check_shapes()?;
        cost.check(options.modes)?;
    }
    let Workspace { model, spectrum } = workspace;
    model.watch.expect(cost.segments, cost.products);
    model.watch.enter(Stage::Modes {
        segments: cut.mesh.segments(),
        degree: (options.method == Method::Spectral).then_some(cut.degree),
    });
    model.assemble(tower, cut, options);
    if !model.is_finite() {
        return Err(EigenError::NotFinite.into());
    }
    options.check_size(cut.mesh.segments(), model.degrees_of_freedom())?;
    find_origin(tower, model)?;
    let error = match spectrum.solve(tower, model, options.modes) {
        Ok(found) => return Ok(found),
        Err(error) => error,
    };
    if !is_pressed(tower) {
        return Err(not_solved(error));
    }
    // Where weights nearly buckle a tower its lowest mode is below the rounding of the others.
    match buckling_load_factor(tower, model, None) {
        Ok(Some(factor)) if factor < VERGE => {
            begin_below_zero(model);
            Ok(spectrum.solve(tower, model, options.modes)?)
        }
        Err(SolveError::Buckles { load_factor }) => {
            Err(buckles(tower, cut, options, load_factor, workspace))
        }
        _ => Err(not_solved(error)),
    }
}

/// What is held and does not buckle cannot be unstable but by rounding.
fn not_solved(error: EigenError) -> SolveError {
    match error {
        EigenError::Unstable { .. } => EigenError::TooStiff.into(),
        _ => error.into(),
    }
}

/// The modes asked for with their shapes; the discretization error is still missing.
fn shapes(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    found: &[Found],
    identities: &[Identity],
    workspace: &mut Workspace,
) -> Result<Vec<Mode>, SolveError> {
    let Workspace { model, spectrum } = workspace;
    let heights_m = equal_heights(tower, options.points);
    let stations_m = tower.station_heights_m();
    let mut modes: Vec<Mode> = Vec::with_capacity(options.modes);
    for (found, identity) in found.iter().zip(identities).take(options.modes) {
        let number = modes.len() + 1;
        // Of a repeated pair the second is the first in the other plane.
        let twin = modes.last().filter(|_| found.key.is_turned);
        let mode = match twin {
            Some(twin) => twin.in_side_side(number, found, identity),
            None => {
                let vector = spectrum.vector(found.key);
                let curves = model.curves(tower, mesh, found.key.part, vector);
                let components = identity.family.normalized_by();
                let curve = ModeCurve::new(mesh.borders_m(), &*curves, components);
                let origin = model.origin;
                let heights_m = [&heights_m[..], &stations_m, &options.heights_m];
                Mode::new(number, found, identity, origin, &curve, heights_m)
            }
        };
        if !mode.is_finite() {
            return Err(EigenError::NotFinite.into());
        }
        modes.push(mode);
    }
    Ok(modes)
}

/// Heights from the base to the top in equal steps, both ends exactly.
fn equal_heights(tower: &Tower, points: usize) -> Vec<f64> {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    let height = |k: usize| {
        let s = k as f64 / (points - 1) as f64;
        base_m * (1.0 - s) + top_m * s
    };
    (0..points).map(height).collect()
}
