//! Eigenvalues from good guesses of their vectors, with the proof that none is missing.
//!
//! One step for a guess v with Rayleigh quotient σ is x = (K − σM)⁻¹ M v, whose quotient ρ is the
//! better value (Rayleigh quotient iteration; Parlett, *The Symmetric Eigenvalue Problem*, 1998,
//! ch. 4): the error is cubed. In the norm of M⁻¹ the residual of x at ρ is
//!
//! r² = vᵀMv/xᵀMx − (ρ − σ)²,
//!
//! so an eigenvalue is within r of ρ, and within r²/gap where no other is within the gap. The
//! factorization of K − σM counts the eigenvalues below σ; with disjoint intervals ρ ± r this
//! proves that the list is complete.

use std::ops::Range;

use super::certificate::{CountCheck, beyond, verify};
use super::pencil::ShiftInvert;
use super::vector::scale;
use crate::lanes::LANES;

/// Limit of the steps; a good guess needs fewer.
const MAX_STEPS: usize = 6;
/// A shift nearer to the eigenvalue than this fraction of the gap is kept: a step with it reduces
/// the error by as much, and saves a factorization.
const NEAR: f64 = 0.01;
/// The permitted relative error of an eigenvalue on another mesh, for an estimate …
pub(crate) const OF_ESTIMATES: f64 = 1e-14;
/// … and of one that is listed.
pub(super) const OF_LISTS: f64 = 1e-15;
/// Eigenvalues that are nearer to each other, relatively, are left to the Lanczos process.
pub(super) const NEAREST: f64 = 1e-4;
/// The relative distance within which rounding may move an eigenvalue past a shift.
const ROUNDING: f64 = 1e-9;
/// The relative gap above the highest eigenvalue known, which decides about one step more.
const GAP_ABOVE: f64 = 0.1;

/// The `wanted` lowest eigenvalues of a pencil are sought.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sought<'a> {
    pub(crate) wanted: usize,
    /// The eigenvalues of a similar pencil.
    pub(crate) known: &'a [f64],
    /// A limit between the last wanted eigenvalue of the similar pencil and its next one, divided
    /// by the last one.
    pub(crate) gap_ratio: f64,
}

impl Sought<'_> {
    /// The relative distances above the last eigenvalue at which a count is tried, widest first.
    pub(super) fn margins(&self) -> [f64; 5] {
        let mut margins = [self.gap_ratio - 1.0, 0.1, 1e-2, 1e-3, NEAREST];
        margins.sort_unstable_by(|a, b| b.total_cmp(a));
        margins
    }
}

/// Guesses of eigenvectors, and the eigenvalues that were found from them.
#[derive(Debug, Default)]
pub(crate) struct Refinement {
    /// A guess of each wanted eigenvector, lowest first.
    pub(crate) vectors: Vec<Vec<f64>>,
    /// The eigenvalues of the last [`refine`].
    pub(crate) lambdas: Vec<f64>,
    /// r/ρ of each eigenvalue.
    pub(super) residuals: Vec<f64>,
    searches: Vec<Search>,
    load: Vec<f64>,
}

/// The search for one eigenvalue from the guess of its vector.
#[derive(Debug, Clone, Copy)]
struct Search {
    /// xᵀKx and xᵀMx.
    energies: [f64; 2],
    /// The relative distance to the other eigenvalues.
    gap: f64,
    /// The last shift σ, and how many eigenvalues are below it. The first shift is NaN, so no
    /// quotient is near it.
    shift: f64,
    count: usize,
    steps: usize,
    /// ρ and r, if r is as small as required.
    found: Option<(f64, f64)>,
}

/// A limit, rad²/s², and the number of eigenvalues below it, if they were counted.
struct Limit {
    at: f64,
    count: Option<usize>,
}

/// Computes the eigenvalues that are sought from guesses of their vectors, to a relative tolerance.
/// The result is a limit above them; no other eigenvalue is below it. None if the guesses do not
/// lead to a list that is proved complete: then another process must find it.
pub(crate) fn refine(
    pencil: &mut dyn ShiftInvert,
    sought: Sought,
    tolerance: f64,
    workspace: &mut Refinement,
) -> Option<f64> {
    let wanted = sought.wanted;
    workspace.begin(pencil, sought)?;
    let mut limit = Limit {
        at: sought.gap_ratio * workspace.searches.last()?.quotient()?,
        count: None,
    };
    let mut above = wanted;
    // The highest first: its guess is the worst.
    while above > 0 {
        // Beside one search alone a count would take as long as after it.
        let limit = (above == wanted && wanted > 1).then_some(&mut limit);
        let lanes = LANES - usize::from(limit.is_some());
        let modes = above.saturating_sub(lanes)..above;
        above = modes.start;
        workspace.refine_in_step(pencil, modes, limit, tolerance)?;
    }
    let (lambda, residual) = workspace.take_disjoint()?;
    let reach = (lambda + residual) * (1.0 + ROUNDING);
    let last = &workspace.searches[wanted - 1];
    let counts = [(limit.at, limit.count), (last.shift, Some(last.count))];
    for (limit, count) in counts {
        if count == Some(wanted) && reach < limit {
            return Some(limit);
        }
    }
    let margins = sought.margins();
    let margins = beyond(residual / lambda, &margins);
    match verify(lambda, wanted, margins, |shift| pencil.count_below(shift)) {
        CountCheck::Complete { margin } => Some(lambda * (1.0 + margin)),
        CountCheck::Disagrees { .. } => None,
    }
}

/// The relative distance of an eigenvalue to its neighbours.
fn relative_gap(known: &[f64], index: usize) -> f64 {
    let own = known[index];
    let distance = |other: f64| (1.0 - other / own).abs();
    let below = index.checked_sub(1).map(|below| distance(known[below]));
    let above = known.get(index + 1).map(|above| distance(*above));
    below.unwrap_or(1.0).min(above.unwrap_or(GAP_ABOVE))
}

impl Refinement {
    /// Products with the mass matrix in the last [`refine`].
    pub(super) fn products(&self) -> usize {
        self.searches.iter().map(|search| search.steps).sum()
    }

    /// Begins a search from each guess; none if eigenvalues are too near to each other.
    fn begin(&mut self, pencil: &mut dyn ShiftInvert, sought: Sought) -> Option<()> {
        self.load.resize(pencil.size(), 0.0);
        self.searches.clear();
        for (index, x) in self.vectors[..sought.wanted].iter().enumerate() {
            let gap = relative_gap(sought.known, index);
            if gap < NEAREST {
                return None;
            }
            self.searches.push(Search::new(pencil.energies(x), gap));
        }
        Some(())
    }

    /// Iterates from some guesses until the eigenvalues are accurate; then the vectors with xᵀKx =
    /// 1 replace the guesses. The eigenvalues below a limit are counted with the first step, if the
    /// pencil takes several steps at once.
    fn refine_in_step(
        &mut self,
        pencil: &mut dyn ShiftInvert,
        modes: Range<usize>,
        mut limit: Option<&mut Limit>,
        tolerance: f64,
    ) -> Option<()> {
        let vectors = &mut self.vectors[modes.clone()];
        let searches = &mut self.searches[modes];
        loop {
            let active = searches.iter().filter(|search| search.found.is_none());
            let counts = limit.iter().filter(|limit| limit.count.is_none());
            if active.count() + counts.count() < 2 {
                break;
            }
            searches.iter_mut().try_for_each(Search::aim)?;
            let at = limit.as_ref().map_or(searches[0].shift, |limit| limit.at);
            let Some(steps) = steps(pencil, searches, vectors, at) else {
                break;
            };
            if let Some(limit) = &mut limit {
                limit.count.get_or_insert(steps[searches.len()].0);
            }
            let active = searches.iter_mut().zip(&mut *vectors).zip(steps);
            for ((search, x), step) in active.filter(|((search, _), _)| search.found.is_none()) {
                search.take(x, step, tolerance);
            }
        }
        for (search, x) in searches.iter_mut().zip(vectors) {
            search.finish(pencil, x, &mut self.load, tolerance)?;
        }
        Some(())
    }

    /// Takes the eigenvalues found, if each is in an interval of its own; the last one with its r.
    fn take_disjoint(&mut self) -> Option<(f64, f64)> {
        self.lambdas.clear();
        self.residuals.clear();
        let mut below = 0.0;
        for search in &self.searches {
            let (lambda, residual) = search.found?;
            // Two guesses may lead to one eigenvalue. Its two values differ by rounding, which is
            // not in the residuals.
            if !(lambda.is_finite() && lambda - residual > below * (1.0 + NEAREST)) {
                return None;
            }
            below = lambda + residual;
            self.lambdas.push(lambda);
            self.residuals.push(residual / lambda);
        }
        self.searches.last()?.found
    }
}

/// A step of each search that goes on, and counts up to `limit` in the lanes after those of the
/// searches; none if the pencil takes one step after the other.
fn steps(
    pencil: &mut dyn ShiftInvert,
    searches: &[Search],
    vectors: &mut [Vec<f64>],
    limit: f64,
) -> Option<[(usize, [f64; 2]); LANES]> {
    let shift = |lane: usize| searches.get(lane).map_or(limit, |search| search.shift);
    let mut lanes = searches.iter().zip(vectors);
    let moved = std::array::from_fn(|_| {
        let (search, x) = lanes.next()?;
        search.found.is_none().then_some(&mut x[..])
    });
    pencil.inverse_steps(&std::array::from_fn(shift), moved)
}

impl Search {
    fn new(energies: [f64; 2], gap: f64) -> Self {
        Self {
            energies,
            gap,
            shift: f64::NAN,
            count: 0,
            steps: 0,
            found: None,
        }
    }

    /// The Rayleigh quotient of the present vector, if it is a positive number.
    fn quotient(&self) -> Option<f64> {
        let quotient = self.energies[0] / self.energies[1];
        (quotient > 0.0 && quotient.is_finite()).then_some(quotient)
    }

    /// Sets the shift of the next step, if there is one; none if the iteration leads nowhere.
    fn aim(&mut self) -> Option<()> {
        if self.found.is_some() {
            return Some(());
        }
        let quotient = self.quotient().filter(|_| self.steps < MAX_STEPS)?;
        // A shift near the eigenvalue is used once more.
        let is_near = (quotient - self.shift).abs() <= NEAR * self.gap * quotient;
        if !is_near {
            self.shift = quotient;
        }
        Some(())
    }

    /// Takes the result of a step from the vector with the shift.
    fn take(&mut self, x: &mut [f64], (count, energies): (usize, [f64; 2]), tolerance: f64) {
        let mass = self.energies[1];
        (self.count, self.steps) = (count, self.steps + 1);
        let lambda = energies[0] / energies[1];
        let squared = mass / energies[1] - (lambda - self.shift) * (lambda - self.shift);
        let residual_squared = squared.max(0.0);
        let is_found = residual_squared <= tolerance * self.gap * lambda * lambda;
        self.found = is_found.then(|| (lambda, residual_squared.sqrt()));
        // The vector has grown as the shift is near to the eigenvalue.
        let factor = 1.0 / energies[usize::from(!is_found)].sqrt();
        scale(x, factor);
        self.energies = energies.map(|energy| energy * factor * factor);
    }

    /// Iterates until the eigenvalue is accurate.
    fn finish(
        &mut self,
        pencil: &mut dyn ShiftInvert,
        x: &mut [f64],
        load: &mut [f64],
        tolerance: f64,
    ) -> Option<()> {
        let mut factored = f64::NAN;
        while self.found.is_none() {
            self.aim()?;
            let is_new = self.shift != factored;
            factored = self.shift;
            let (count, energies) = pencil.inverse_step(is_new.then_some(factored), x, load);
            let count = if is_new { count } else { self.count };
            self.take(x, (count, energies), tolerance);
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::pencil::Pencil;
    use super::*;

    const LAMBDAS: [f64; 10] = [1.0, 1.7, 2.5, 4.1, 6.0, 9.3, 12.0, 20.0, 31.0, 50.0];

    /// K = diag(λ), M = 1.
    struct Diagonal {
        in_step: bool,
        shift: f64,
        counts: usize,
    }

    impl Diagonal {
        fn new(in_step: bool) -> Self {
            Self {
                in_step,
                shift: 0.0,
                counts: 0,
            }
        }
    }

    fn below(shift: f64) -> usize {
        LAMBDAS.iter().filter(|lambda| **lambda < shift).count()
    }

    fn divide(x: &mut [f64], shift: f64) {
        for (x, lambda) in x.iter_mut().zip(LAMBDAS) {
            *x /= lambda - shift;
        }
    }

    fn energies(x: &[f64]) -> [f64; 2] {
        let stiffness = x.iter().zip(LAMBDAS).map(|(x, lambda)| lambda * x * x);
        [stiffness.sum(), x.iter().map(|x| x * x).sum()]
    }

    impl Pencil for Diagonal {
        fn size(&self) -> usize {
            LAMBDAS.len()
        }

        fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
            out.copy_from_slice(x);
        }

        fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
            let products = x.iter().zip(LAMBDAS).map(|(x, lambda)| lambda * x);
            out.iter_mut().zip(products).for_each(|(out, x)| *out = x);
        }

        fn count_below(&mut self, shift: f64) -> usize {
            self.counts += 1;
            below(shift)
        }

        fn factorize(&mut self) -> usize {
            0
        }

        fn solve(&mut self, x: &mut [f64]) {
            divide(x, 0.0);
        }

        fn start(&mut self, out: &mut [f64]) {
            out.fill(1.0);
        }
    }

    impl ShiftInvert for Diagonal {
        fn factorize_shifted(&mut self, shift: f64) -> usize {
            self.shift = shift;
            below(shift)
        }

        fn solve_shifted(&mut self, x: &mut [f64]) {
            divide(x, self.shift);
        }

        fn energies(&mut self, x: &[f64]) -> [f64; 2] {
            energies(x)
        }

        fn inverse_steps(
            &mut self,
            shifts: &[f64; LANES],
            x: [Option<&mut [f64]>; LANES],
        ) -> Option<[(usize, [f64; 2]); LANES]> {
            if !self.in_step {
                return None;
            }
            let mut steps = shifts.iter().zip(x).map(|(shift, x)| match x {
                Some(x) => {
                    divide(x, *shift);
                    (below(*shift), energies(x))
                }
                None => (below(*shift), [0.0; 2]),
            });
            Some(std::array::from_fn(|_| steps.next().unwrap_or_default()))
        }
    }

    /// Guesses of these modes, to a few percent; the similar pencil is 3 % softer.
    fn refined(modes: &[usize], in_step: bool) -> (Option<f64>, Refinement, Diagonal) {
        let known = LAMBDAS.map(|lambda| 0.97 * lambda);
        let guess = |mode: &usize| {
            let entry = |i: usize| {
                if i == *mode {
                    1.0
                } else {
                    0.02 * (i as f64).cos()
                }
            };
            (0..LAMBDAS.len()).map(entry).collect()
        };
        let mut refinement = Refinement {
            vectors: modes.iter().map(guess).collect(),
            ..Refinement::default()
        };
        let mut pencil = Diagonal::new(in_step);
        let wanted = modes.len();
        let sought = Sought {
            wanted,
            known: &known,
            gap_ratio: (LAMBDAS[wanted] / LAMBDAS[wanted - 1]).sqrt(),
        };
        let limit = refine(&mut pencil, sought, OF_LISTS, &mut refinement);
        (limit, refinement, pencil)
    }

    #[test]
    fn lists_of_any_length_are_found_and_proved() {
        for wanted in [1, 2, 3, 4, 5, 8] {
            let modes: Vec<usize> = (0..wanted).collect();
            for in_step in [false, true] {
                let (limit, refinement, pencil) = refined(&modes, in_step);
                let limit = limit.expect("a list");
                assert_eq!(below(limit), wanted, "{wanted}");
                for (found, exact) in refinement.lambdas.iter().zip(LAMBDAS) {
                    assert!((found / exact - 1.0).abs() < 1e-14, "{found}, not {exact}");
                }
                // The count in step saves one afterwards.
                assert!(!in_step || wanted == 1 || pencil.counts == 0);
            }
        }
    }

    #[test]
    fn guesses_of_other_modes_lead_to_no_list() {
        // One is missing, one is there twice, one leads nowhere.
        for modes in [[0, 1, 3], [0, 2, 3], [0, 1, 1], [0, 0, 2], [1, 2, 3]] {
            for in_step in [false, true] {
                let (limit, ..) = refined(&modes, in_step);
                assert_eq!(limit, None, "{modes:?}");
            }
        }
        for in_step in [false, true] {
            let known = LAMBDAS;
            let sought = Sought {
                wanted: 2,
                known: &known,
                gap_ratio: 1.2,
            };
            let mut refinement = Refinement {
                vectors: vec![vec![f64::NAN; LAMBDAS.len()]; 2],
                ..Refinement::default()
            };
            let mut pencil = Diagonal::new(in_step);
            assert_eq!(refine(&mut pencil, sought, OF_LISTS, &mut refinement), None);
        }
    }
}
