//! The lowest eigenvalues of a symmetric pencil, with error bounds and a proof that none is
//! missing.

mod certificate;
mod error;
mod lanczos;
mod pencil;
mod refine;
mod tridiagonal;
mod vector;

pub(crate) use certificate::{CountCheck, verify};
pub use error::EigenError;
pub use pencil::{Pencil, ShiftInvert};
pub(crate) use refine::{OF_ESTIMATES, Refinement, Sought, refine};

use std::f64::consts::TAU;

use certificate::Residual;
use lanczos::Lanczos;

/// Restarts after a count that disagrees, before giving up.
const MAX_RESTARTS: usize = 8;

/// The relative distances above the last eigenvalue at which a count is tried.
const MARGINS: [f64; 4] = [1e-2, 1e-4, 1e-6, 1e-9];

/// The relative residual of a vector that is listed.
const OF_VECTORS: f64 = 1e-13;

/// Above a list that was found from guesses a relative gap of less than this is counted again: a
/// wider one proves more digits of the last eigenvalue.
const WIDE: f64 = 1e-2;

/// With larger residuals relative to the mode the rounding errors of the lowest mode are larger
/// than the mode. It is below the widest of [`MARGINS`], so one of them is beyond the residuals.
const MAX_RESIDUAL: f64 = 1e-4;

/// If cancellation in the stiffness causes a larger relative error, the tower is refused: soil or
/// guy wires 10¹⁴ times as stiff as the tower.
const MAX_ROUNDING: f64 = 1e-7;

/// The relative error that an eigenvalue from a guess of its vector may have.
const ACCURATE: f64 = 1e-13;

/// One eigenvalue with its bound.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Eigenvalue {
    /// λ = ω², rad²/s².
    pub lambda: f64,
    /// Bound on |λ − λ_exact|, algebraic and rounding error together, rad²/s².
    pub error: f64,
}

impl Eigenvalue {
    /// Whether it is zero within its error.
    pub fn is_zero(&self) -> bool {
        self.lambda <= self.error
    }

    /// The frequency √λ/2π, Hz; 0 where λ is zero within its error.
    pub fn frequency_hz(&self) -> f64 {
        if self.is_zero() {
            return 0.0;
        }
        self.lambda.sqrt() / TAU
    }

    /// The bound on the error of the frequency, Hz.
    pub fn frequency_error_hz(&self) -> f64 {
        let least = (self.lambda - self.error).max(0.0);
        self.error / (self.lambda.max(self.error).sqrt() + least.sqrt()) / TAU
    }

    /// The eigenvalue λ + `origin` (rad²/s²), where λ was counted from the origin.
    pub fn shifted(&self, origin: f64) -> Self {
        Self {
            lambda: self.lambda + origin,
            error: self.error + f64::EPSILON * origin.abs(),
        }
    }
}

/// The cost of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Statistics {
    /// Products with the mass matrix.
    pub products: usize,
    /// Restarts because an eigenvalue count disagreed with the list.
    pub restarts: usize,
}

impl std::ops::AddAssign for Statistics {
    fn add_assign(&mut self, other: Self) {
        self.products += other.products;
        self.restarts += other.restarts;
    }
}

/// The result of [`lowest`] and the memory of its computation. A second solve of the same size in
/// the same workspace allocates nothing.
#[derive(Debug, Default)]
pub struct EigenWorkspace {
    lanczos: Lanczos,
    vectors: Vec<Vec<f64>>,
    thetas: Vec<f64>,
    lambdas: Vec<f64>,
    residuals: Vec<Residual>,
    eigenvalues: Vec<Eigenvalue>,
    /// No eigenvalue beyond those of the list is below this; 0 without a proof.
    gap_end: f64,
    scratch: Vec<f64>,
}

impl EigenWorkspace {
    /// The eigenvalues of the last [`lowest`], rising.
    pub fn eigenvalues(&self) -> &[Eigenvalue] {
        &self.eigenvalues
    }

    /// The eigenvector u of an eigenvalue of the last [`lowest`]: uᵀ K u = 1, so uᵀ M u = 1/λ.
    ///
    /// # Panics
    /// If there is no such eigenvalue.
    pub fn vector(&self, index: usize) -> &[f64] {
        assert!(index < self.eigenvalues.len(), "no eigenvector {index}");
        &self.vectors[index]
    }

    /// The sum of the eigenvectors, each times the lowest eigenvalue over its own; none without
    /// eigenvalues.
    pub(crate) fn sum_of_vectors(&self) -> Option<Vec<f64>> {
        let lowest = self.eigenvalues.first()?.lambda;
        let factors = self.eigenvalues.iter().map(|e| lowest / e.lambda);
        let factors: Vec<f64> = factors.collect();
        let mut sum = vec![0.0; self.vectors[0].len()];
        vector::add_combination(&self.vectors[..factors.len()], &factors, &mut sum);
        Some(sum)
    }

    /// The number of eigenvalues below λ, if the proof of the last list gives it.
    pub(crate) fn proved_count(&self, lambda: f64) -> Option<usize> {
        let above = self.eigenvalues.last().map_or(0.0, |e| e.lambda + e.error);
        (above < lambda && lambda <= self.gap_end).then_some(self.eigenvalues.len())
    }

    /// Notes that a count proved that no eigenvalue beyond those of the list is below `gap_end`.
    pub(crate) fn prove_gap(&mut self, gap_end: f64) {
        self.gap_end = gap_end;
    }

    /// Begins with an empty list, of which nothing is proved.
    pub(crate) fn begin_empty(&mut self) {
        self.eigenvalues.clear();
        self.gap_end = 0.0;
    }

    /// Replaces the eigenvectors `first..first + count`, which have one eigenvalue, by orthonormal
    /// mixtures of them: a row for each.
    pub(crate) fn mix<const N: usize>(&mut self, first: usize, count: usize, rows: &[[f64; N]; N]) {
        let old: Vec<Vec<f64>> = self.vectors[first..first + count].to_vec();
        for (vector, row) in self.vectors[first..].iter_mut().zip(rows).take(count) {
            vector.fill(0.0);
            vector::add_combination(&old, &row[..count], vector);
        }
    }

    /// Copies the converged Ritz pairs, sorted by λ. Returns false if they are not numbers.
    fn extract(&mut self, pencil: &mut dyn Pencil, wanted: usize) -> bool {
        self.vectors
            .resize_with(self.vectors.len().max(wanted), Vec::new);
        self.thetas.clear();
        self.lambdas.clear();
        self.residuals.clear();
        for index in 0..wanted {
            let (theta, residual) = self
                .lanczos
                .ritz_pair(pencil, index, &mut self.vectors[index]);
            self.thetas.push(theta);
            self.lambdas.push(1.0 / theta);
            self.residuals.push(Residual::OfTheta(residual));
        }
        self.sort();
        self.lambdas.iter().all(is_usable) && self.residuals.iter().all(|r| r.value().is_finite())
    }

    /// Rayleigh quotients differ from Ritz values in the last digit, which can swap a
    /// near-degenerate pair: insertion sort.
    fn sort(&mut self) {
        for end in 1..self.lambdas.len() {
            let mut i = end;
            while i > 0 && self.lambdas[i] < self.lambdas[i - 1] {
                self.lambdas.swap(i, i - 1);
                self.thetas.swap(i, i - 1);
                self.residuals.swap(i, i - 1);
                self.vectors.swap(i, i - 1);
                i -= 1;
            }
        }
    }

    /// Checks the list just found by a count: nothing if it is complete, and then the eigenvalues
    /// are filled with their bounds; else how many eigenvalues there are.
    ///
    /// # Errors
    /// [`EigenError::Unresolved`], [`EigenError::TooStiff`], or [`EigenError::Incomplete`] if no
    /// other attempt would help.
    fn check(
        &mut self,
        pencil: &mut dyn Pencil,
        wanted: usize,
        restarts: usize,
    ) -> Result<Option<usize>, EigenError> {
        let mut norm = 0.0;
        let norms = certificate::residual_norms(&self.thetas, &self.residuals);
        for (resolved, of_first) in norms.enumerate() {
            if of_first > MAX_RESIDUAL {
                return Err(EigenError::Unresolved { wanted, resolved });
            }
            norm = of_first;
        }
        let last = self.lambdas[wanted - 1];
        // Nearer to the last one a count may leave it out and take another one in.
        let margins = certificate::beyond(certificate::reach(norm), &MARGINS);
        match verify(last, wanted, margins, |shift| pencil.count_below(shift)) {
            CountCheck::Complete { margin } => self.bound(pencil, margin).map(|()| None),
            CountCheck::Disagrees { count, shift }
                if restarts == MAX_RESTARTS || count <= wanted =>
            {
                Err(EigenError::Incomplete {
                    found: wanted,
                    counted: count,
                    below_hz: shift.sqrt() / TAU,
                    restarts,
                })
            }
            CountCheck::Disagrees { count, .. } => Ok(Some(count)),
        }
    }

    /// Copies the eigenvalues and vectors of a refinement.
    fn adopt(&mut self, wanted: usize, refinement: &mut Refinement) {
        let most = self.vectors.len().max(wanted);
        self.vectors.resize_with(most, Vec::new);
        let refined = refinement.vectors.iter_mut();
        for (vector, refined) in self.vectors.iter_mut().zip(refined).take(wanted) {
            std::mem::swap(vector, refined);
        }
        self.lambdas.clear();
        self.lambdas.extend_from_slice(&refinement.lambdas);
        let residuals = refinement.residuals.iter().copied();
        self.residuals.clear();
        self.residuals.extend(residuals.map(Residual::OfLambda));
    }

    /// Whether an eigenvalue is as accurate as one of the Lanczos process.
    fn is_accurate(&self, index: usize, margin: f64) -> bool {
        let residual = self.residuals[index];
        certificate::residual_bound(&self.lambdas, index, residual, margin) <= ACCURATE
    }

    /// Keeps the vectors found; missing modes are in their orthogonal complement.
    fn lock(&mut self, found: usize) {
        self.lanczos.lock(&self.vectors[..found], &self.thetas);
    }

    /// Fills the eigenvalues with the bounds that a proved margin above the last one allows.
    ///
    /// # Errors
    /// [`EigenError::TooStiff`].
    fn bound(&mut self, pencil: &mut dyn Pencil, margin: f64) -> Result<(), EigenError> {
        self.eigenvalues.clear();
        for (index, &lambda) in self.lambdas.iter().enumerate() {
            let cancellation =
                pencil.stiffness_cancellation(&self.vectors[index], &mut self.scratch);
            if certificate::rounding(&self.lambdas, 0, pencil.size(), cancellation) > MAX_ROUNDING {
                return Err(EigenError::TooStiff);
            }
            let residual = self.residuals[index];
            let relative = certificate::residual_bound(&self.lambdas, index, residual, margin)
                + certificate::rounding(&self.lambdas, index, pencil.size(), cancellation);
            let error = relative * lambda;
            self.eigenvalues.push(Eigenvalue { lambda, error });
        }
        self.gap_end = self
            .lambdas
            .last()
            .map_or(0.0, |last| last * (1.0 + margin));
        Ok(())
    }
}

/// Computes the `wanted` lowest eigenvalues of K u = λ M u and proves that none is missing.
///
/// The results are in the workspace. The list may be longer than `wanted`: no count can be taken
/// between repeated eigenvalues, and every eigenvalue that a count revealed is computed too.
///
/// # Errors
/// [`EigenError`]: more wanted than there are, K not positive definite, numbers out of range, or a
/// count that never agrees.
pub fn lowest(
    pencil: &mut dyn Pencil,
    wanted: usize,
    workspace: &mut EigenWorkspace,
) -> Result<Statistics, EigenError> {
    let size = pencil.size();
    workspace.eigenvalues.clear();
    if wanted > size {
        return Err(EigenError::TooMany {
            wanted,
            available: size,
        });
    }
    if wanted == 0 {
        return Ok(Statistics::default());
    }
    workspace.begin_empty();
    factorize(pencil)?;
    workspace.lanczos.reset(size, OF_VECTORS);
    let (mut wanted, mut restarts) = (wanted, 0);
    loop {
        let done = workspace.lanczos.start(pencil, restarts)
            && workspace.lanczos.run(pencil, wanted)
            && workspace.extract(pencil, wanted);
        if !done {
            return Err(EigenError::NotFinite);
        }
        let Some(count) = workspace.check(pencil, wanted, restarts)? else {
            let products = workspace.lanczos.products;
            return Ok(Statistics { products, restarts });
        };
        workspace.lock(wanted);
        wanted = count.min(size);
        restarts += 1;
    }
}

/// Nearer to the ends of the range counts overflow, which would look like missing modes.
fn is_usable(lambda: &f64) -> bool {
    (1e-200..1e200).contains(lambda)
}

/// The results of [`lowest`] from guesses of the vectors. None if the guesses do not lead to a list
/// that is proved complete and accurate; then [`lowest`] must find it.
pub(crate) fn lowest_near(
    pencil: &mut dyn ShiftInvert,
    sought: Sought,
    refinement: &mut Refinement,
    workspace: &mut EigenWorkspace,
) -> Option<Statistics> {
    let wanted = sought.wanted;
    workspace.eigenvalues.clear();
    if wanted == 0 {
        return Some(Statistics::default());
    }
    workspace.gap_end = 0.0;
    if wanted > pencil.size() {
        return None;
    }
    let limit = refine(pencil, sought, refine::OF_LISTS, refinement)?;
    workspace.adopt(wanted, refinement);
    let last = workspace.lambdas[wanted - 1];
    let mut margin = limit / last - 1.0;
    if margin < WIDE {
        let count_below = |shift| pencil.count_below(shift);
        let check = verify(last, wanted, &sought.margins(), count_below);
        let CountCheck::Complete { margin: wider } = check else {
            return None;
        };
        margin = wider;
    }
    let is_accurate = (0..wanted).all(|index| workspace.is_accurate(index, margin));
    if !(workspace.lambdas.iter().all(is_usable) && is_accurate) {
        return None;
    }
    workspace.bound(pencil, margin).ok()?;
    Some(Statistics {
        products: refinement.products(),
        restarts: 0,
    })
}

/// Factors K.
///
/// # Errors
/// [`EigenError::Unstable`] if K is not positive definite.
fn factorize(pencil: &mut dyn Pencil) -> Result<(), EigenError> {
    match pencil.factorize() {
        0 => Ok(()),
        negative => Err(EigenError::Unstable { negative }),
    }
}

/// The relative distance below the least eigenvalue at which a count proves that no eigenvalue is
/// below it, and the relative residual of its vector. The error of the eigenvalue is the square of
/// the residual over the gap, and at most the distance of the count.
const LEAST: f64 = 1e-9;

/// Computes the smallest eigenvalue alone and proves that none is below it; it may be repeated.
///
/// # Errors
/// As [`lowest`].
pub(crate) fn least(
    pencil: &mut dyn Pencil,
    workspace: &mut EigenWorkspace,
) -> Result<f64, EigenError> {
    factorize(pencil)?;
    workspace.begin_empty();
    workspace.lanczos.reset(pencil.size(), LEAST);
    let mut below = 0;
    for restarts in 0..=MAX_RESTARTS {
        workspace.lanczos.lock(&[], &[]);
        let done = workspace.lanczos.start(pencil, restarts)
            && workspace.lanczos.run(pencil, 1)
            && workspace.extract(pencil, 1);
        if !done {
            return Err(EigenError::NotFinite);
        }
        let lambda = workspace.lambdas[0];
        below = pencil.count_below(lambda * (1.0 - LEAST));
        if below == 0 && workspace.residuals[0].value() <= MAX_RESIDUAL {
            return Ok(lambda);
        }
    }
    Err(EigenError::Incomplete {
        found: 0,
        counted: below,
        below_hz: workspace.lambdas[0].sqrt() / TAU,
        restarts: MAX_RESTARTS,
    })
}
