//! The Lanczos process for the lowest eigenvalues.
//!
//! The operator K⁻¹M is symmetric in the inner product xᵀ K y and has eigenvalues θ = 1/λ, so the
//! lowest modes are its largest and come first. In that inner product the projection coefficients
//! vᵢᵀ K (K⁻¹M v) = vᵢᵀ M v cost nothing extra, M is never factored, and a joint-coordinate K is
//! the identity. All vectors are kept, and every new one is orthogonalized against the last two and
//! then against all of them: for the few dozen that towers need this is the cheap and safe way
//! (Parlett, *The Symmetric Eigenvalue Problem*, 1998, ch. 13).

use super::pencil::Pencil;
use super::tridiagonal::diagonalize;
use super::vector::{add_combination, dot, fill_pseudo_random, project, scale};

/// The smallest permitted residual of a Ritz value, relative to the largest Ritz value: no product
/// is more accurate.
const FLOOR: f64 = 2.0 * f64::EPSILON;
/// A projected matrix up to this size is diagonalized at once with its eigenvectors.
const SMALL: usize = 64;
/// The Ritz values are computed when the estimated residual is small enough, and at every so many
/// steps regardless.
const LOOK_ANYWAY: usize = 8;

/// The state and the memory of a Lanczos process; a second process of the same size allocates
/// nothing.
#[derive(Debug, Default)]
pub(super) struct Lanczos {
    /// K-orthonormal vectors; the first `used` are in use, the rest keeps its memory.
    basis: Vec<Vec<f64>>,
    used: usize,
    /// The permitted relative residual of a Ritz value.
    tolerance: f64,
    /// The projected operator: diagonal and off-diagonal.
    alpha: Vec<f64>,
    beta: Vec<f64>,
    /// M v, then the next vector, then (only if K is not the identity) K times this vector before
    /// its last change.
    image: Vec<f64>,
    next: Vec<f64>,
    stiff: Vec<f64>,
    coefficients: Vec<f64>,
    /// Copies of alpha, beta for diagonalization, the eigenvectors of the projected operator, and
    /// their falling order.
    values: Vec<f64>,
    off_diagonal: Vec<f64>,
    components: Vec<f64>,
    order: Vec<usize>,
    /// Mass products so far.
    pub(super) products: usize,
}

impl Lanczos {
    /// Resets the state and keeps the memory; Ritz values converge to a relative residual of
    /// `tolerance`.
    pub(super) fn reset(&mut self, size: usize, tolerance: f64) {
        self.used = 0;
        self.tolerance = tolerance;
        self.alpha.clear();
        self.beta.clear();
        self.products = 0;
        for vector in [&mut self.image, &mut self.next, &mut self.stiff] {
            vector.clear();
            vector.resize(size, 0.0);
        }
    }

    /// Starts again with `locked` eigenvectors (K-orthonormal, with their θ), to which the new
    /// process stays orthogonal.
    pub(super) fn lock(&mut self, locked: &[Vec<f64>], thetas: &[f64]) {
        self.used = 0;
        self.alpha.clear();
        self.beta.clear();
        for (vector, &theta) in locked.iter().zip(thetas) {
            self.next.copy_from_slice(vector);
            self.append(1.0);
            self.alpha.push(theta);
            self.beta.push(0.0);
        }
    }

    /// Sets the starting vector: that of the pencil, or a pseudo-random one for later attempts.
    /// False if there is none.
    pub(super) fn start(&mut self, pencil: &mut dyn Pencil, attempt: usize) -> bool {
        if attempt == 0 {
            pencil.start(&mut self.next);
        } else {
            fill_pseudo_random(&mut self.next, attempt as u64);
        }
        self.append_orthonormalized(pencil, attempt)
    }

    /// Runs until the `wanted` largest Ritz values have converged or the space is exhausted.
    ///
    /// Returns false if the numbers are not finite.
    pub(super) fn run(&mut self, pencil: &mut dyn Pencil, wanted: usize) -> bool {
        let size = self.next.len();
        let mut next_look = wanted + 1;
        loop {
            let beta = self.step(pencil);
            if !beta.is_finite() || !self.alpha[self.used - 1].is_finite() {
                return false;
            }
            if self.used == size {
                return self.diagonalize_fully();
            }
            if self.used >= next_look && self.is_hopeful(wanted, beta) {
                if self.has_converged(wanted, beta) {
                    return true;
                }
                // The cost of the Ritz values is the cube of the number of steps, so they are
                // computed less often as the steps increase.
                next_look = self.used + 1 + (self.used - wanted) / 8;
            }
            if !self.extend(pencil, beta) {
                return false;
            }
        }
    }

    /// One step: α of the newest vector; leaves the residual vector in `next` and returns its
    /// K-norm β.
    fn step(&mut self, pencil: &mut dyn Pencil) -> f64 {
        let newest = self.used - 1;
        pencil.mass_times(&self.basis[newest], &mut self.image);
        self.products += 1;
        self.next.copy_from_slice(&self.image);
        pencil.solve(&mut self.next);
        // First against the two vectors of exact arithmetic, then against all vectors because of
        // rounding.
        let alpha = dot(&self.basis[newest], &self.image);
        let last_two = &self.basis[newest.saturating_sub(1)..=newest];
        let factors = [-self.beta.last().copied().unwrap_or(0.0), -alpha];
        add_combination(last_two, &factors[2 - last_two.len()..], &mut self.next);
        let correction = self.orthogonalize(pencil);
        self.alpha.push(alpha + correction);
        self.norm(pencil)
    }

    /// The K-norm of `next` after [`orthogonalize`](Self::orthogonalize): what that subtracted is
    /// K-orthogonal to what is left, so K times the vector before serves as well as K times it now.
    fn norm(&self, pencil: &dyn Pencil) -> f64 {
        let stiff = if pencil.stiffness_is_identity() {
            &self.next
        } else {
            &self.stiff
        };
        dot(&self.next, stiff).max(0.0).sqrt()
    }

    /// next ← next − V Vᵀ K next, once; returns the part along the newest vector.
    fn orthogonalize(&mut self, pencil: &mut dyn Pencil) -> f64 {
        let stiff = if pencil.stiffness_is_identity() {
            &self.next
        } else {
            pencil.stiffness_times(&self.next, &mut self.stiff);
            &self.stiff
        };
        self.coefficients.resize(self.used, 0.0);
        project(&self.basis[..self.used], stiff, &mut self.coefficients);
        let along_newest = self.coefficients.last().copied().unwrap_or(0.0);
        self.subtract_coefficients();
        along_newest
    }

    fn subtract_coefficients(&mut self) {
        self.coefficients.iter_mut().for_each(|c| *c = -*c);
        add_combination(&self.basis[..self.used], &self.coefficients, &mut self.next);
    }

    /// Makes `next` the newest vector. If it vanishes, the space is invariant, and the process
    /// continues in a new direction. False if there is none.
    fn extend(&mut self, pencil: &mut dyn Pencil, beta: f64) -> bool {
        let largest = self.alpha.iter().fold(0.0_f64, |a, x| a.max(x.abs()));
        if beta > FLOOR * largest {
            self.beta.push(beta);
            self.append(1.0 / beta);
            true
        } else {
            self.beta.push(0.0);
            fill_pseudo_random(&mut self.next, self.used as u64);
            self.append_orthonormalized(pencil, self.used)
        }
    }

    /// Orthonormalizes `next` against the basis and appends it; if it lies in the basis's span,
    /// random ones are tried. False if none of these has a component outside the span.
    fn append_orthonormalized(&mut self, pencil: &mut dyn Pencil, seed: usize) -> bool {
        for attempt in 0..4 {
            pencil.stiffness_times(&self.next, &mut self.stiff);
            let before = dot(&self.next, &self.stiff).max(0.0).sqrt();
            // The first vector has no previous vector.
            if self.used > 0 {
                self.orthogonalize(pencil);
                self.orthogonalize(pencil);
            }
            let norm = self.norm(pencil);
            if norm > 1e-8 * before {
                self.append(1.0 / norm);
                return true;
            }
            fill_pseudo_random(&mut self.next, (seed as u64) << 8 | (attempt + 1));
        }
        false
    }

    /// Copies factor·next to the end of the basis, in existing memory if an earlier process
    /// allocated it.
    fn append(&mut self, factor: f64) {
        if self.used == self.basis.len() {
            self.basis.push(Vec::new());
        }
        let vector = &mut self.basis[self.used];
        vector.clear();
        vector.extend(self.next.iter().map(|x| factor * x));
        self.used += 1;
    }

    /// Whether computing the Ritz values is worth its cost.
    ///
    /// The projected matrix is nearly diagonal where the spectrum falls fast, so the last component
    /// of the wanted-th Ritz vector is about the product of the couplings after it over its Ritz
    /// value.
    fn is_hopeful(&self, wanted: usize, beta: f64) -> bool {
        let Some(&theta) = self.alpha.get(wanted - 1) else {
            return false;
        };
        let couplings = self.beta[wanted - 1..].iter();
        let forecast = beta * couplings.map(|b| (b / theta).min(1.0)).product::<f64>();
        forecast <= self.allowed(theta, self.alpha[0].max(theta))
            || (self.used - wanted).is_multiple_of(LOOK_ANYWAY)
    }

    /// The permitted residual of a Ritz value θ, relative to the largest one.
    fn allowed(&self, theta: f64, largest: f64) -> f64 {
        (self.tolerance * theta).max(FLOOR * largest)
    }

    /// Whether the residual estimates β |last component| of the `wanted` largest Ritz values are
    /// small.
    fn has_converged(&mut self, wanted: usize, beta: f64) -> bool {
        // Only the last components cost the square of the size, whole eigenvectors its cube: used
        // if convergence is still far.
        if self.used > SMALL && !(self.diagonalize_rows(1) && self.are_small(wanted, beta, 1)) {
            return false;
        }
        self.diagonalize_fully() && self.are_small(wanted, beta, self.used)
    }

    /// Whether the residual estimates are small, from the last `rows` rows of the eigenvectors of
    /// the projected matrix.
    fn are_small(&self, wanted: usize, beta: f64, rows: usize) -> bool {
        let largest = self.values[self.order[0]];
        self.order.iter().take(wanted).all(|&i| {
            let last_component = self.components[(i + 1) * rows - 1];
            beta * last_component.abs() <= self.allowed(self.values[i], largest)
        })
    }

    /// Ritz values and the eigenvectors of the projected matrix; false if they are not numbers.
    fn diagonalize_fully(&mut self) -> bool {
        self.diagonalize_rows(self.used)
    }

    /// Ritz values and the last `rows` rows of the eigenvectors of the projected matrix; false
    /// if they are not numbers.
    fn diagonalize_rows(&mut self, rows: usize) -> bool {
        let size = self.used;
        self.components.clear();
        self.components.resize(size * rows, 0.0);
        (0..rows).for_each(|row| self.components[(size - rows + row) * rows + row] = 1.0);
        self.values.clear();
        self.values.extend_from_slice(&self.alpha);
        self.off_diagonal.clear();
        self.off_diagonal.extend_from_slice(&self.beta[..size - 1]);
        let done = diagonalize(
            &mut self.values,
            &mut self.off_diagonal,
            &mut self.components,
            rows,
        );
        self.order.clear();
        self.order.extend(0..size);
        let values = &self.values;
        self.order
            .sort_unstable_by(|&a, &b| values[b].total_cmp(&values[a]));
        done
    }

    /// The Ritz pair of the `index`-th largest Ritz value after [`run`](Self::run): writes the
    /// K-normalized vector and returns θ, its Rayleigh quotient, and the relative residual ‖M u − θ
    /// K u‖/θ in the K⁻¹-norm.
    pub(super) fn ritz_pair(
        &mut self,
        pencil: &mut dyn Pencil,
        index: usize,
        vector: &mut Vec<f64>,
    ) -> (f64, f64) {
        let size = self.used;
        let column = self.order[index];
        let components = &self.components[column * size..(column + 1) * size];
        vector.clear();
        vector.resize(self.next.len(), 0.0);
        add_combination(&self.basis[..size], components, vector);
        pencil.stiffness_times(vector, &mut self.stiff);
        let norm = dot(vector, &self.stiff).sqrt();
        scale(vector, 1.0 / norm);
        scale(&mut self.stiff, 1.0 / norm);
        pencil.mass_times(vector, &mut self.image);
        self.products += 1;
        let theta = dot(vector, &self.image);
        for (image, stiff) in self.image.iter_mut().zip(&self.stiff) {
            *image -= theta * stiff;
        }
        self.next.copy_from_slice(&self.image);
        pencil.solve(&mut self.next);
        let residual = dot(&self.image, &self.next).max(0.0).sqrt();
        (theta, residual / theta)
    }
}
