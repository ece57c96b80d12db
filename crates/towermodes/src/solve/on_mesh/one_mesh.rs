//! A tower on one mesh: solved, proved complete, named, its shapes sampled.

use super::super::error::SolveError;
use super::super::errors::reference::buckles;
use super::super::progress::Stage;
use super::super::request::checks::check_size;
use super::super::request::cost::Cost;
use super::super::request::options::Options;
use super::super::results::energy_parts::energy_parts;
use super::super::results::solution::{Certificate, ErrorBasis, Mode, Solution};
use super::super::workspace::Workspace;
use super::cut::Cut;
use super::naming::{Naming, Wanted, identify};
use super::spectrum::{Found, SimilarModes};
use super::stability::{VERGE, begin_below_zero, buckling_load_factor, can_buckle, find_origin};
use crate::eigen::{EigenError, Statistics};
use crate::elements::{Mesh, shear_fraction};
use crate::modes::ModeCurve;
use crate::space::SpatialMatrix;
use crate::tower::Warning;
use crate::tower::{Plane, Tower};

/// If a tower on a frame has a lower frequency, Hz, the frame may be a mechanism.
const SLOW_HZ: f64 = 1e-3;

/// Assembles a tower on a mesh and solves it for at least the modes requested, from the modes of a
/// similar tower if there are any.
pub(crate) fn solve_cut(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    mut base: Option<&mut dyn SimilarModes>,
    workspace: &mut Workspace,
) -> Result<Vec<Found>, SolveError> {
    let cost = Cost::of(tower, cut, options);
    // More modes than the model has is another error, which is reported below.
    if options.limits && options.modes as f64 <= cost.unknowns {
        options.check_shapes()?;
        cost.check(options.modes)?;
    }
    let Workspace {
        model, spectrum, ..
    } = workspace;
    model.monitor.expect(cost.segments, cost.products);
    model.monitor.enter(Stage::Modes {
        segments: cut.mesh.segments(),
        degree: cut.degree_of(options.method),
    });
    model.forget_frame();
    model.assemble(tower, &cut.mesh, cut.degree, options);
    if let Some(error) = model.take_frame_error() {
        return Err(error.into());
    }
    if !model.is_finite() {
        return Err(EigenError::NotFinite.into());
    }
    check_size(
        options.modes,
        cut.mesh.segments(),
        model.degrees_of_freedom(),
    )?;
    find_origin(tower, model)?;
    let as_base = base
        .as_deref_mut()
        .and_then(|base| spectrum.solve_as_base(model, options.modes, base));
    let solved = match as_base {
        Some(found) => Ok(found),
        None => spectrum.solve(model, options.modes, base),
    };
    let is_slow = |found: &Found| found.eigenvalue.frequency_hz() < SLOW_HZ;
    let is_doubtful = solved
        .as_ref()
        .map_or(true, |found| found.first().is_some_and(is_slow));
    if is_doubtful
        && !tower.base().floats
        && let Some(mechanism) = model.frame_mechanism()
    {
        return Err(mechanism.into());
    }
    match solved {
        Ok(found) => Ok(found),
        Err(error) if can_buckle(tower) => solve_again(tower, cut, options, error, workspace),
        Err(error) => Err(not_solved(error)),
    }
}

/// Near buckling the lowest mode of a tower is below the rounding of the others: solves it once
/// more with an origin below zero, or gives the reason why it has no modes.
fn solve_again(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    error: EigenError,
    workspace: &mut Workspace,
) -> Result<Vec<Found>, SolveError> {
    let Workspace {
        model, spectrum, ..
    } = workspace;
    match buckling_load_factor(tower, model, None) {
        Ok(Some(factor)) if factor < VERGE => {
            begin_below_zero(model);
            Ok(spectrum.solve(model, options.modes, None)?)
        }
        Err(SolveError::Buckles { load_factor }) => {
            Err(buckles(tower, cut, options, load_factor, workspace))
        }
        _ => Err(not_solved(error)),
    }
}

/// A tower on a foundation that does not buckle can be unstable only because of rounding.
fn not_solved(error: EigenError) -> SolveError {
    match error {
        EigenError::Unstable { .. } => EigenError::TooStiff.into(),
        _ => error.into(),
    }
}

/// The modes on one mesh before their errors are known.
pub(crate) struct Described {
    pub(crate) modes: Vec<Mode>,
    /// Polynomial degree of spectral elements.
    pub(crate) degree: Option<usize>,
    pub(crate) certificate: Certificate,
    /// The end of the proved list, λ, rad²/s².
    pub(crate) below: f64,
    /// The mode that repeats the last of the list and is not in it: label and frequency (Hz).
    pub(crate) cut_off: Option<(String, f64)>,
    degrees_of_freedom: usize,
    rigid_inertia: SpatialMatrix,
    pub(crate) buckling_load_factor: Option<f64>,
}

impl Described {
    pub(crate) fn into_solution(
        self,
        options: &Options,
        segments: usize,
        warnings: Vec<Warning>,
        statistics: Statistics,
    ) -> Solution {
        Solution {
            method: options.method,
            segments,
            degree: self.degree,
            degrees_of_freedom: self.degrees_of_freedom,
            certificate: self.certificate,
            modes: self.modes,
            error_basis: ErrorBasis::default(),
            rigid_inertia: self.rigid_inertia,
            buckling_load_factor: self.buckling_load_factor,
            added_mass: None,
            warnings,
            statistics,
        }
    }
}

/// Proves that no mode is missing below those found, and describes the modes requested.
pub(crate) fn describe(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    found: &[Found],
    workspace: &mut Workspace,
) -> Result<Described, SolveError> {
    let Workspace {
        model,
        spectrum,
        naming,
        ..
    } = &mut *workspace;
    model.monitor.enter(Stage::Certificate);
    let proof = spectrum.prove(model, found, options.modes)?;
    model.monitor.enter(Stage::Buckling);
    let buckling_load_factor = buckling_load_factor(tower, model, Some(spectrum))?;
    model.monitor.enter(Stage::Shapes);
    let rigid_inertia = model.rigid_inertia(tower, options.has_rotary_inertia());
    let listed = &found[..found.len().min(options.modes + 1)];
    identify(
        tower,
        options,
        model,
        spectrum,
        (listed, Wanted::All),
        naming,
    );
    let inertia = std::array::from_fn(|i| rigid_inertia[i][i]);
    let mut modes = shapes(tower, &cut.mesh, options, (listed, inertia), workspace)?;
    if options.energy_parts {
        let listed = &listed[..modes.len()];
        let parts = energy_parts(tower, cut, options, listed, workspace);
        for (mode, parts) in modes.iter_mut().zip(parts) {
            mode.energy_parts = Some(parts);
        }
    }
    let (origin, last) = (workspace.model.origin, &found[options.modes - 1]);
    let identities = &workspace.naming.identities;
    let next = listed.get(options.modes).zip(identities.get(options.modes));
    let cut_off = next.filter(|(found, _)| found.repeats(last, origin));
    Ok(Described {
        modes,
        degree: cut.degree_of(options.method),
        certificate: Certificate::of(&proof),
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

/// The requested modes with their shapes, of a tower with this inertia in the directions of rigid
/// motions; the discretization error is not known yet.
fn shapes(
    tower: &Tower,
    mesh: &Mesh,
    options: &Options,
    (found, inertia): (&[Found], [f64; 6]),
    workspace: &Workspace,
) -> Result<Vec<Mode>, SolveError> {
    let Workspace {
        model, spectrum, ..
    } = workspace;
    let Naming { identities, .. } = &workspace.naming;
    let heights_m = equal_heights(tower, options.points);
    let stations_m = tower.station_heights_m();
    let heights_m = [&heights_m[..], &stations_m, &options.heights_m];
    let shear = |plane: Plane, base_m, top_m| shear_fraction(tower, plane, base_m, top_m);
    let mut modes: Vec<Mode> = Vec::with_capacity(options.modes);
    for (found, identity) in found.iter().zip(identities).take(options.modes) {
        let number = modes.len() + 1;
        // The second mode of a repeated pair is the first one in the other plane.
        let twin = modes.last().filter(|_| found.key.is_turned);
        let mode = match twin {
            Some(twin) => twin.in_side_side(number, found, identity),
            None => {
                let subsystem = model.subsystem(found.key.subsystem);
                let vector = spectrum.vector(found.key);
                let curves = subsystem.curves(mesh.borders_m(), &shear, vector);
                let motion = identity.shares.scale(identity.family);
                let (component, _) = motion.components()[0];
                let curve = ModeCurve::new(mesh.borders_m(), &*curves, &[component]);
                let origin = model.origin;
                let mut mode =
                    Mode::new(number, found, identity, origin, &curve, inertia, heights_m);
                mode.frame = model.frame_shape(vector, curve.largest());
                mode
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
