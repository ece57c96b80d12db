//! The proof that no mode is missing if the added mass depends on frequency.
//!
//! N(ω), the number of negative eigenvalues of K − ω²(M + A(ω)), is the number of modes below ω if
//! the matrix decreases with ω. On intervals where that is not certain, N is enclosed by the counts
//! of two constant added masses: where both are equal there is no mode at all.

use super::super::error::SolveError;
use super::super::on_mesh::cut::Cut;
use super::super::on_mesh::spectrum::{MARGINS, count_below};
use super::super::request::options::Options;
use super::super::results::solution::Certificate;
use super::super::workspace::Workspace;
use super::roots::Root;
use crate::eigen::{CountCheck, EigenError, verify};
use crate::tower::Tower;
use std::f64::consts::TAU;

/// Number of halvings of an interval in the search for parts without a mode.
const HALVINGS: usize = 12;
/// Ends of intervals are compared with this relative tolerance.
const SAME: f64 = 1e-12;

/// Proves that the modes at `roots` are all modes below a frequency above the last one, which has
/// this certificate with the added mass of its frequency.
pub(super) fn prove(
    tower: &Tower,
    options: &Options,
    roots: &[Root],
    last: &Certificate,
    workspace: &mut Workspace,
) -> Result<Certificate, SolveError> {
    let cut = match options.method.converges_by_degree() {
        true => workspace.spectral_cut.take().unwrap_or_default(),
        false => workspace.cut.take(tower, options)?,
    };
    let mut counts = Counts {
        tower,
        options,
        cut: &cut,
        workspace,
    };
    let certificate = counts.prove(roots, last);
    match options.method.converges_by_degree() {
        true => workspace.spectral_cut = Some(cut),
        false => workspace.cut.put_back(cut, options),
    }
    certificate
}

/// Counts of modes on a mesh.
struct Counts<'a> {
    tower: &'a Tower,
    options: &'a Options,
    cut: &'a Cut,
    workspace: &'a mut Workspace,
}

impl Counts<'_> {
    fn prove(&mut self, roots: &[Root], last: &Certificate) -> Result<Certificate, SolveError> {
        let frequency = roots.last().map_or(0.0, |root| root.frequency);
        let own = frequency * frequency;
        let check = verify(own, last.count, &MARGINS, |lambda| {
            self.below(&self.tower.with_added_mass_at(lambda.sqrt()), lambda)
        });
        let below = match check {
            // Motions without stiffness are counted with the tower fixed.
            _ if own == 0.0 => return Ok(*last),
            CountCheck::Complete { margin } => (own * (1.0 + margin)).sqrt(),
            CountCheck::Disagrees { count, shift } => {
                return Err(EigenError::Incomplete {
                    found: roots.len(),
                    counted: count,
                    below_hz: shift.sqrt() / TAU,
                    restarts: 0,
                }
                .into());
            }
        };
        let uncertain = self.uncertain_below(below);
        let uncertain = uncertain.map(|ends| self.with_lost_modes(ends, below, roots));
        let uncertain_hz = uncertain.map(|ends| ends.map(|end| end / TAU));
        Ok(Certificate {
            complete: uncertain_hz.is_none(),
            count: last.count,
            below_hz: below / TAU,
            uncertain_hz,
        })
    }

    /// The number of modes of an ordinary tower below λ, rad²/s².
    fn below(&mut self, tower: &Tower, lambda: f64) -> usize {
        let model = &mut self.workspace.model;
        model.assemble(tower, &self.cut.mesh, self.cut.degree, self.options);
        count_below(model, lambda)
    }

    /// The smallest interval (rad/s) below an angular frequency that contains all parts in which
    /// there may be other modes.
    fn uncertain_below(&mut self, limit: f64) -> Option<[f64; 2]> {
        let by_frequency = self.tower.inertia_by_frequency()?;
        let mut uncertain: Option<[f64; 2]> = None;
        for interval in by_frequency.not_monotone_below(limit) {
            let mut parts = vec![(interval, HALVINGS)];
            while let Some(([from, to], halvings)) = parts.pop() {
                if self.has_no_mode([from, to]) {
                    continue;
                }
                let middle = 0.5 * (from + to);
                if halvings > 0 && to - from > SAME * to {
                    parts.push(([from, middle], halvings - 1));
                    parts.push(([middle, to], halvings - 1));
                    continue;
                }
                let [low, high] = uncertain.unwrap_or([from, to]);
                uncertain = Some([low.min(from), high.max(to)]);
            }
        }
        uncertain
    }

    /// The interval, extended to 0 if other modes than those listed are below it, and to `limit` if
    /// other modes are above it. N at its ends decides: where N falls within the interval, a mode
    /// of the same number stands above it again, and the list has only the first of the two.
    fn with_lost_modes(&mut self, ends: [f64; 2], limit: f64, roots: &[Root]) -> [f64; 2] {
        let [is_low, is_high] = ends.map(|end| {
            let listed = roots.iter().filter(|root| root.frequency < end).count();
            self.below(&self.tower.with_added_mass_at(end), end * end) == listed
        });
        let [low, high] = ends;
        [
            if is_low { low } else { 0.0 },
            if is_high { high } else { limit },
        ]
    }

    /// Whether the counts at the ends of a part of an interval prove that no mode is in it: with
    /// the least added mass in it at the lower end, and with the largest at the upper end.
    fn has_no_mode(&mut self, [from, to]: [f64; 2]) -> bool {
        let by_frequency = self.tower.inertia_by_frequency();
        let bounds = by_frequency.and_then(|by_frequency| by_frequency.bounds([from, to]));
        bounds.is_some_and(|[least, largest]| {
            let fewest = self.below(&self.tower.with_base_inertia(least), from * from);
            let most = self.below(&self.tower.with_base_inertia(largest), to * to);
            fewest == most
        })
    }
}
