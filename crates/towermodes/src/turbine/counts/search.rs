//! The frequencies of a gyroscopic eigenproblem below a limit, each between two eigenvalue counts,
//! if counts only increase.

use super::super::equations::gyroscopic::Gyroscopic;
use super::super::equations::model::UNRESISTED;
use crate::scalar::Complex;

/// Frequencies in a bracket narrower than this, relative, are treated as equal.
pub(super) const POINT: f64 = 4e-12;

/// H at a frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Sample {
    /// Frequency, rad/s.
    pub(crate) w: f64,
    /// Number of negative eigenvalues.
    pub(crate) negative: usize,
}

/// A mode near which another is expected.
#[derive(Debug, Clone)]
pub(crate) struct Guess<'a> {
    /// Frequency, rad/s.
    pub(crate) w: f64,
    /// Its vector; empty if it is not known.
    pub(crate) vector: &'a [Complex],
}

/// A mode, or one of several with the same frequency.
#[derive(Debug, Clone)]
pub(crate) struct Found {
    /// Frequency, rad/s.
    pub(crate) w: f64,
    /// The counts below and above it.
    pub(crate) bounds: [Sample; 2],
    /// Its vector.
    pub(crate) vector: Vec<Complex>,
}

/// A search in a system.
pub(super) struct Search<'a, G: ?Sized> {
    pub(super) system: &'a mut G,
    /// Known counts in increasing frequency.
    samples: Vec<Sample>,
    pub(crate) right: Vec<Complex>,
    pub(crate) vector: Vec<Complex>,
}

impl<'a, G: Gyroscopic + ?Sized> Search<'a, G> {
    pub(crate) fn new(system: &'a mut G) -> Self {
        let size = system.degrees_of_freedom();
        Self {
            system,
            samples: Vec::new(),
            right: vec![Complex::default(); size],
            vector: vec![Complex::default(); size],
        }
    }

    /// All frequencies up to a limit if the count only increases, except motions without stiffness.
    /// A guess for each mode reduces the work. Also returns the number of these motions.
    pub(crate) fn rising(&mut self, limit: f64, guesses: &[Guess<'_>]) -> (usize, Vec<Found>) {
        self.samples.clear();
        let base = self.sample(UNRESISTED.min(limit)).negative;
        let end = self.sample(limit);
        let mut all = Vec::new();
        let mut number = base + 1;
        while number <= end.negative {
            let guess = guesses.get(number - base - 1);
            if guess.is_none() {
                self.isolate(number);
            }
            let (low, high) = self.bracket(number);
            all.extend(self.find(low, high, |negative| negative < number, guess));
            number = base + all.len() + 1;
        }
        (base, all)
    }

    /// The count at the lower end of all searches.
    pub(crate) fn base(&mut self, limit: f64) -> usize {
        self.system.count(UNRESISTED.min(limit))
    }

    /// All frequencies between known counts that differ.
    pub(super) fn between_samples(&mut self) -> Vec<Found> {
        let mut brackets = Vec::new();
        let samples = self.samples.clone();
        for pair in samples.windows(2) {
            self.separate(pair[0], pair[1], &mut brackets);
        }
        let mut all = Vec::new();
        for (low, high) in brackets {
            let rises = high.negative > low.negative;
            let is_low = |negative: usize| match rises {
                true => negative <= low.negative,
                false => negative >= low.negative,
            };
            all.extend(self.find(low, high, is_low, None));
        }
        all
    }

    /// Halves an interval until counts at both ends differ by one, or until it is a point.
    fn separate(&mut self, low: Sample, high: Sample, brackets: &mut Vec<(Sample, Sample)>) {
        let is_point = high.w - low.w <= POINT * high.w;
        match high.negative.abs_diff(low.negative) {
            0 => {}
            1 => brackets.push((low, high)),
            _ if is_point => brackets.push((low, high)),
            _ => {
                let middle = self.sample(0.5 * (low.w + high.w));
                self.separate(low, middle, brackets);
                self.separate(middle, high, brackets);
            }
        }
    }

    /// Sum of the decreases of the known counts: at least this number of frequencies have negative
    /// energy.
    pub(crate) fn falls(&self) -> usize {
        let pairs = self.samples.windows(2);
        let falls = pairs.map(|pair| pair[0].negative.saturating_sub(pair[1].negative));
        falls.sum()
    }

    pub(super) fn sample(&mut self, w: f64) -> Sample {
        let negative = self.system.count(w);
        self.record(Sample { w, negative })
    }

    pub(super) fn record(&mut self, sample: Sample) -> Sample {
        let place = self.samples.partition_point(|other| other.w < sample.w);
        self.samples.insert(place, sample);
        sample
    }

    /// The closest known samples around the mode with this number.
    fn bracket(&self, number: usize) -> (Sample, Sample) {
        let above = self
            .samples
            .partition_point(|sample| sample.negative < number);
        (self.samples[above - 1], self.samples[above])
    }

    /// Halves the bracket of a mode until it contains no other mode.
    fn isolate(&mut self, number: usize) {
        loop {
            let (low, high) = self.bracket(number);
            let is_point = high.w - low.w <= POINT * high.w;
            if high.negative - low.negative == 1 || is_point {
                return;
            }
            self.sample(0.5 * (low.w + high.w));
        }
    }
}
