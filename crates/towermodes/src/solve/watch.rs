//! What a solve is at, told to those who wait.

use crate::eigen::Pencil;

/// What a solve is at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// The modes are looked for. The spectral beam comes here for each degree that it is raised to.
    Modes {
        /// Number of segments, or of elements.
        segments: usize,
        /// Polynomial degree of the elements of the spectral beam.
        degree: Option<usize>,
    },
    /// Counts prove that none is missing.
    Certificate,
    /// The factor by which weights would have to be multiplied for the tower to buckle is looked
    /// for.
    Buckling,
    /// Modes are named and their shapes sampled.
    Shapes,
    /// The same modes are looked for on another mesh, which says how large their errors are.
    Errors {
        /// Which of the meshes, from 1.
        mesh: usize,
        /// How many there are.
        meshes: usize,
        /// Number of segments of this one.
        segments: usize,
    },
    /// The same modes are looked for of the beam itself, because meshes do not say how large their
    /// errors are.
    Reference {
        /// Number of elements of the spectral beam.
        elements: usize,
        /// Their polynomial degree.
        degree: usize,
    },
}

/// How far a solve has come.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// What it is at.
    pub stage: Stage,
    /// Products with the mass matrix since that began: how many are needed is not known before, a
    /// dozen for each mode is usual.
    pub products: usize,
    /// Share of the whole solve that is done, 0 to 1, as estimated: it never falls, and ends near
    /// 1.
    pub fraction: f64,
}

/// Who is told.
type Observer = Box<dyn FnMut(Progress) + Send + Sync>;

/// Somebody who is told what a solve is at, or nobody. What is computed is the same.
#[derive(Default)]
pub(super) struct Watch {
    observer: Option<Observer>,
    progress: Option<Progress>,
    /// Segments of all cuts of this solve, and products that each takes, as estimated.
    expected: [f64; 2],
    /// Segments of the cuts that are done, and of the one that is at hand.
    done: [f64; 2],
}

/// All is done when the solve ends, not before.
const NEARLY_ALL: f64 = 0.99;

impl Watch {
    pub(super) fn new(observer: Observer) -> Self {
        Self {
            observer: Some(observer),
            ..Self::default()
        }
    }

    /// A new solve begins.
    pub(super) fn restart(&mut self) {
        self.progress = None;
        self.done = [0.0; 2];
    }

    /// So many segments will be solved, all cuts together, with so many products each.
    pub(super) fn expect(&mut self, segments: f64, products: f64) {
        self.expected = [segments, products];
    }

    /// Another stage begins.
    pub(super) fn enter(&mut self, stage: Stage) {
        let segments = match stage {
            Stage::Modes { segments, .. } | Stage::Errors { segments, .. } => segments as f64,
            _ => 0.0,
        };
        self.done = [self.done[0] + self.done[1], segments];
        self.tell(stage, 0);
    }

    fn count_product(&mut self) {
        if let Some(Progress {
            stage, products, ..
        }) = self.progress
        {
            self.tell(stage, products + 1);
        }
    }

    fn tell(&mut self, stage: Stage, products: usize) {
        let fraction = self.fraction(products);
        if let Some(observer) = &mut self.observer {
            let progress = Progress {
                stage,
                products,
                fraction,
            };
            self.progress = Some(progress);
            observer(progress);
        }
    }

    /// The share that is done after so many products of the cut at hand; never less than before.
    fn fraction(&self, products: usize) -> f64 {
        let ([all, of_a_cut], [before, now]) = (self.expected, self.done);
        let least = self.progress.map_or(0.0, |progress| progress.fraction);
        let share = (products as f64 / of_a_cut).min(1.0);
        let fraction = (before + now * share) / all;
        // Nothing expected is nothing known.
        if fraction.is_finite() {
            fraction.clamp(least, NEARLY_ALL)
        } else {
            least
        }
    }

    /// Lets `act` work on a pencil whose products are told, if somebody watches.
    pub(super) fn over<R>(
        &mut self,
        pencil: &mut dyn Pencil,
        act: impl FnOnce(&mut dyn Pencil) -> R,
    ) -> R {
        match self.observer {
            None => act(pencil),
            Some(_) => act(&mut WatchedPencil {
                pencil,
                watch: self,
            }),
        }
    }
}

/// A pencil whose products are told.
struct WatchedPencil<'a> {
    pencil: &'a mut dyn Pencil,
    watch: &'a mut Watch,
}

impl Pencil for WatchedPencil<'_> {
    fn size(&self) -> usize {
        self.pencil.size()
    }

    fn mass_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.pencil.mass_times(x, out);
        self.watch.count_product();
    }

    fn stiffness_times(&mut self, x: &[f64], out: &mut [f64]) {
        self.pencil.stiffness_times(x, out);
    }

    fn stiffness_is_identity(&self) -> bool {
        self.pencil.stiffness_is_identity()
    }

    fn count_below(&mut self, shift: f64) -> usize {
        self.pencil.count_below(shift)
    }

    fn factorize(&mut self) -> usize {
        self.pencil.factorize()
    }

    fn solve(&mut self, x: &mut [f64]) {
        self.pencil.solve(x);
    }

    fn stiffness_cancellation(&mut self, x: &[f64]) -> f64 {
        self.pencil.stiffness_cancellation(x)
    }

    fn start(&mut self, out: &mut [f64]) {
        self.pencil.start(out);
    }
}
