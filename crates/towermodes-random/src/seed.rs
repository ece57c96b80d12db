//! Pseudo-random numbers that are the same on all machines.

/// A generator of pseudo-random numbers: splitmix64 (Steele, Lea & Flood, 2014).
#[derive(Debug, Clone)]
pub struct Seed(u64);

impl Seed {
    /// The generator with this seed.
    pub fn new(number: u64) -> Self {
        Self(number)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A uniformly distributed number from `low` to `high`.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        let share = (self.next() >> 11) as f64 / (1_u64 << 53) as f64;
        low + share * (high - low)
    }

    /// A number whose logarithm is uniformly distributed from that of `low` to that of `high`.
    pub fn log_between(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// A whole number from `low` to `high`, both included.
    pub fn whole(&mut self, low: usize, high: usize) -> usize {
        low + (self.next() % (high - low + 1) as u64) as usize
    }

    /// True with the probability `share`.
    pub fn chance(&mut self, share: f64) -> bool {
        self.between(0.0, 1.0) < share
    }

    /// Increasing heights from `base_m` to `top_m`, both included: `parts` parts of random lengths,
    /// none shorter than a tenth of the mean.
    pub fn heights_m(&mut self, base_m: f64, top_m: f64, parts: usize) -> Vec<f64> {
        let lengths: Vec<f64> = (0..parts).map(|_| self.between(0.1, 1.9)).collect();
        let whole: f64 = lengths.iter().sum();
        let mut heights_m = vec![base_m];
        let mut below = 0.0;
        for length in &lengths[..parts - 1] {
            below += length;
            heights_m.push(base_m + (top_m - base_m) * (below / whole));
        }
        heights_m.push(top_m);
        heights_m
    }
}
