//! The frequencies of modes if the added mass depends on frequency: μₖ(ω) = ω².

use super::super::error::SolveError;
use super::super::errors::p_refinement;
use super::super::on_mesh::cut::Cut;
use super::super::on_mesh::one_mesh::solve_cut;
use super::super::on_mesh::spectrum::Found;
use super::super::request::options::Options;
use super::super::workspace::Workspace;
use crate::subsystem::Eigenproblem;
use crate::tower::Tower;
use std::f64::consts::TAU;

/// The permitted relative difference of μ(ω) and ω².
const TOLERANCE: f64 = 1e-12;
/// If the difference was smaller than this before, a step of Newton's method is the last one.
const NEARLY: f64 = 1e-7;
/// Limit of the steps; bisection needs fewer from any start.
const MAX_STEPS: usize = 200;
/// A slope below this is not used for a step.
const LEAST_SLOPE: f64 = 0.1;

/// A mode at its own frequency.
#[derive(Debug, Clone, Copy)]
pub(super) struct Root {
    /// ω, rad/s.
    pub(super) frequency: f64,
    /// 1 − dμ/dλ at λ = ω²: uᵀ(M + A + ½ω dA/dω)u/uᵀ(M + A)u.
    pub(super) slope: f64,
    /// The remaining relative difference of μ(ω) and ω².
    pub(super) residual: f64,
    /// Whether the added mass is constant from this frequency on.
    pub(super) is_constant: bool,
}

/// The modes requested at their own frequencies, rising.
pub(super) fn roots(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<Vec<Root>, SolveError> {
    let mut search = Search {
        tower,
        options: options.clone(),
        most: options.modes,
        workspace,
    };
    let mut roots: Vec<Root> = Vec::with_capacity(options.modes);
    let mut last = search.sample(0.0, 0)?;
    for place in 0..options.modes {
        let least = roots.last().map_or(0.0, |root| root.frequency);
        let root = search.root(place, least, &mut last)?;
        roots.push(root);
    }
    Ok(roots)
}

/// The tower with the added mass at one frequency.
struct Sample {
    /// Its eigenvalues μ, rad²/s², in increasing order, with the bounds of their errors; 0 for a
    /// motion without stiffness.
    eigenvalues: Vec<(f64, f64)>,
    /// 1 − dμ/dλ of one mode.
    slope: f64,
}

struct Search<'a> {
    tower: &'a Tower,
    /// The options with the number of modes that a sample needs.
    options: Options,
    most: usize,
    workspace: &'a mut Workspace,
}

impl Search<'_> {
    /// The mode at a place in the list, not below the one before it: by Newton's method, held
    /// between frequencies below which there are fewer modes and more.
    fn root(&mut self, place: usize, least: f64, last: &mut Sample) -> Result<Root, SolveError> {
        let [mut low, mut high] = [least, f64::INFINITY];
        let mut frequency = last.eigenvalues[place].0.sqrt().max(least);
        for _ in 0..MAX_STEPS {
            *last = self.sample(frequency, place)?;
            let (eigenvalue, error) = last.eigenvalues[place];
            // Bisection would never reach the frequency 0 of a motion without stiffness.
            if eigenvalue == 0.0 {
                return Ok(Root {
                    frequency: least,
                    slope: last.slope,
                    residual: 0.0,
                    is_constant: self.is_constant(least),
                });
            }
            let lambda = frequency * frequency;
            let residual = (eigenvalue / lambda - 1.0).abs();
            let permitted = TOLERANCE.max(2.0 * error / eigenvalue);
            let is_narrow = high.is_finite() && high - low <= 4.0 * f64::EPSILON * high;
            if residual <= permitted || is_narrow {
                return Ok(Root {
                    frequency,
                    slope: last.slope,
                    residual,
                    is_constant: self.is_constant(frequency),
                });
            }
            match eigenvalue > lambda {
                true => low = frequency,
                false => high = frequency,
            }
            let step = lambda + (eigenvalue - lambda) / last.slope.max(LEAST_SLOPE);
            let next = within(step.max(0.0).sqrt(), low, high);
            // Newton's method squares the remaining difference where the added mass is linear.
            if residual < NEARLY && self.end(next) == self.end(frequency) {
                return Ok(Root {
                    frequency: next,
                    slope: last.slope,
                    residual: residual * residual,
                    is_constant: self.is_constant(next),
                });
            }
            frequency = next;
        }
        Err(SolveError::OwnAddedMass {
            mode: place + 1,
            hz: frequency / TAU,
        })
    }

    /// The end of the interval of an angular frequency (rad/s) in which the added mass is linear.
    fn end(&self, frequency: f64) -> Option<f64> {
        self.tower
            .inertia_by_frequency()?
            .end_of_interval(frequency)
    }

    /// Whether the added mass is constant from an angular frequency (rad/s) on.
    fn is_constant(&self, frequency: f64) -> bool {
        self.end(frequency).is_none()
    }

    /// The tower with the added mass at an angular frequency (rad/s), with the slope of the mode at
    /// a place in the list. The mode above it begins the search for the next one.
    fn sample(&mut self, frequency: f64, place: usize) -> Result<Sample, SolveError> {
        let held = self.tower.with_added_mass_at(frequency);
        self.options.modes = self.most.min(place + 2);
        let (cut, found) = lowest(&held, &self.options, self.workspace)?;
        let eigenvalue = |found: &Found| match found.eigenvalue {
            zero if zero.is_zero() => (0.0, 0.0),
            other => (other.lambda, other.error),
        };
        let eigenvalues = found.iter().map(eigenvalue).collect();
        let slope = self.slope(frequency, &cut, &found[place]);
        self.workspace.spectrum.recycle(found);
        give_back(cut, &self.options, self.workspace);
        Ok(Sample { eigenvalues, slope })
    }

    /// 1 − dμ/dλ of a mode that was just found on a cut with the added mass at an angular
    /// frequency, rad/s. The added mass is linear up to the end of its interval.
    fn slope(&mut self, frequency: f64, cut: &Cut, found: &Found) -> f64 {
        let Some(end) = self.end(frequency) else {
            return 1.0;
        };
        let mut mass = |frequency: f64| {
            let Workspace {
                model, spectrum, ..
            } = &mut *self.workspace;
            let held = self.tower.with_added_mass_at(frequency);
            model.assemble(&held, &cut.mesh, cut.degree, &self.options);
            let vibration = Eigenproblem::Vibration { origin: 0.0 };
            let mut pencil = model.pencil(found.key.subsystem, vibration);
            let [_, mass] =
                crate::eigen::ShiftInvert::energies(&mut pencil, spectrum.vector(found.key));
            mass
        };
        let (own, there) = (mass(frequency), mass(end));
        1.0 + 0.5 * frequency * (there - own) / ((end - frequency) * own)
    }
}

/// A frequency, or one between two others if it is not between them.
fn within(frequency: f64, low: f64, high: f64) -> f64 {
    match frequency > low && frequency < high {
        true => frequency,
        false if high.is_finite() => 0.5 * (low + high),
        false => 2.0 * low,
    }
}

/// The lowest modes of an ordinary tower and the cut that they were found on.
fn lowest(
    tower: &Tower,
    options: &Options,
    workspace: &mut Workspace,
) -> Result<(Cut, Vec<Found>), SolveError> {
    if options.method.converges_by_degree() {
        return p_refinement::lowest(tower, options, workspace);
    }
    let cut = workspace.cut.take(tower, options)?;
    let found = solve_cut(tower, &cut, options, None, workspace)?;
    Ok((cut, found))
}

/// Takes a cut back for the next tower.
fn give_back(cut: Cut, options: &Options, workspace: &mut Workspace) {
    match options.method.converges_by_degree() {
        true => workspace.spectral_cut = Some(cut),
        false => workspace.cut.put_back(cut, options),
    }
}
