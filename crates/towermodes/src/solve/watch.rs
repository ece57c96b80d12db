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
    /// The factor by which weights would have to be multiplied for the tower to buckle is looked for.
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
    /// The same modes are looked for of the beam itself, because meshes do not say how large their errors are.
    Reference {
        /// Number of elements of the spectral beam.
        elements: usize,
        /// Their polynomial degree.
        degree: usize,
    },
}

/// How far a solve has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// What it is at.
    pub stage: Stage,
    /// Products with the mass matrix since that began: how many are needed is not known before, a dozen for each mode is usual.
    pub products: usize,
}

/// Who is told.
type Observer = Box<dyn FnMut(Progress) + Send + Sync>;

/// Somebody who is told what a solve is at, or nobody. What is computed is the same.
#[derive(Default)]
pub(super) struct Watch {
    observer: Option<Observer>,
    progress: Option<Progress>,
}

impl Watch {
    pub(super) fn new(observer: Observer) -> Self {
        Self {
            observer: Some(observer),
            progress: None,
        }
    }

    /// Another stage begins.
    pub(super) fn enter(&mut self, stage: Stage) {
        self.tell(Progress { stage, products: 0 });
    }

    fn count_product(&mut self) {
        if let Some(Progress { stage, products }) = self.progress {
            let products = products + 1;
            self.tell(Progress { stage, products });
        }
    }

    fn tell(&mut self, progress: Progress) {
        if let Some(observer) = &mut self.observer {
            self.progress = Some(progress);
            observer(progress);
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
