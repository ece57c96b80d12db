//! The progress of a solve, and its observer.

use crate::subsystem::ProductObserver;

/// A stage of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[non_exhaustive]
pub enum Stage {
    /// The modes are computed; with the spectral method once for each degree.
    Modes {
        /// Number of segments or elements.
        segments: usize,
        /// Polynomial degree of the elements; only with the spectral method.
        degree: Option<usize>,
    },
    /// Eigenvalue counts prove that no mode is missing.
    Certificate,
    /// The buckling load factor is computed.
    Buckling,
    /// The modes are named and their shapes sampled.
    Shapes,
    /// The same modes are computed on another mesh to estimate their errors.
    Errors {
        /// Which of the meshes, from 1.
        mesh: usize,
        /// Number of other meshes.
        meshes: usize,
        /// Number of segments of this mesh.
        segments: usize,
    },
    /// The same modes are computed by the reference beam solution, because the meshes do not
    /// converge regularly.
    Reference {
        /// Number of spectral elements.
        elements: usize,
        /// Their polynomial degree.
        degree: usize,
    },
}

/// The progress of a solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// The stage.
    pub stage: Stage,
    /// Products with the mass matrix since the stage began. The number that is needed is not known
    /// in advance; a dozen per mode is usual.
    pub products: usize,
    /// Estimated fraction of the whole solve that is done, 0 to 1. It never decreases and ends near
    /// 1.
    pub fraction: f64,
}

/// The observer function.
type Observer = Box<dyn FnMut(Progress) + Send + Sync>;

/// A progress observer, or none. The results are the same.
#[derive(Default)]
pub(super) struct Monitor {
    observer: Option<Observer>,
    progress: Option<Progress>,
    /// Expected work: segments of all meshes of this solve together, and products for each mesh.
    expected: [f64; 2],
    /// Completed segments of the meshes, and of the present one.
    done: [f64; 2],
}

/// The fraction reaches 1 only when the solve has ended.
const NEARLY_ALL: f64 = 0.99;

impl Monitor {
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

    /// Announces the number of segments of all meshes and the expected number of products per mesh.
    pub(super) fn expect(&mut self, segments: f64, products: f64) {
        self.expected = [segments, products];
    }

    /// Another stage begins.
    pub(super) fn enter(&mut self, stage: Stage) {
        let segments = match stage {
            Stage::Modes { segments, .. } | Stage::Errors { segments, .. } => segments as f64,
            Stage::Certificate | Stage::Buckling | Stage::Shapes | Stage::Reference { .. } => 0.0,
        };
        self.done = [self.done[0] + self.done[1], segments];
        self.report(stage, 0);
    }

    fn report(&mut self, stage: Stage, products: usize) {
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

    /// The fraction that is done after `products` products on the present mesh; it never decreases.
    fn fraction(&self, products: usize) -> f64 {
        let ([all, of_a_cut], [before, now]) = (self.expected, self.done);
        let least = self.progress.map_or(0.0, |progress| progress.fraction);
        let of_this_cut = (products as f64 / of_a_cut).min(1.0);
        let fraction = (before + now * of_this_cut) / all;
        // Without expected work the fraction is not known.
        if fraction.is_finite() {
            fraction.clamp(least, NEARLY_ALL)
        } else {
            least
        }
    }

    /// This object as an observer of products, if there is a progress observer.
    pub(super) fn observer(&mut self) -> Option<&mut dyn ProductObserver> {
        match self.observer {
            None => None,
            Some(_) => Some(self),
        }
    }
}

impl ProductObserver for Monitor {
    fn count_product(&mut self) {
        if let Some(Progress {
            stage, products, ..
        }) = self.progress
        {
            self.report(stage, products + 1);
        }
    }
}
