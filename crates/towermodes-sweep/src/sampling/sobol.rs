//! The Sobol sequence with Owen's scrambling; each point is computed independently of the others.

use super::philox::{mixed, philox, unit};
use super::sobol_numbers::DIRECTION_NUMBERS;

/// Number of bits of a coordinate before scrambling, which limits the sequence to 2³² points.
const BITS: usize = 32;

/// One dimension of the sequence.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct SobolDimension {
    /// The direction numbers v₁ to v₃₂ as fractions of 2³².
    directions: [u32; BITS],
    /// The key of the scrambling.
    key: u64,
}

impl SobolDimension {
    /// A dimension, from 0, scrambled with a seed.
    pub(super) fn new(dimension: usize, seed: u64) -> Self {
        let [key, ..] = philox([dimension as u64, 0, 0, 2], [seed, 0]);
        Self {
            directions: directions(dimension),
            key,
        }
    }

    /// The coordinate of a point before scrambling, as a fraction of 2³². The points are in the
    /// order of the Gray code, as in scipy.
    fn plain(&self, point: u32) -> u32 {
        let gray = point ^ (point >> 1);
        let bits = (0..BITS).filter(|bit| gray >> bit & 1 == 1);
        bits.fold(0, |sum, bit| sum ^ self.directions[bit])
    }

    /// The coordinate of a point in (0, 1) after nested uniform scrambling (Owen 1995): the binary
    /// digits before a digit determine whether it is flipped, so that every interval of length 2⁻ᵏ
    /// keeps its number of points; random digits follow the first 32.
    pub(super) fn scrambled(&self, point: u32) -> f64 {
        let plain = u64::from(self.plain(point));
        let mut scrambled = 0;
        for digit in (0..BITS).rev() {
            // The digits before this one with a leading 1: no two prefixes have the same number.
            let prefix = (1 << (BITS - 1 - digit)) | (plain >> digit >> 1);
            let flip = self.of_prefix(prefix) >> 63;
            scrambled |= ((plain >> digit & 1) ^ flip) << digit;
        }
        let rest = self.of_prefix(1 << BITS | plain);
        unit(scrambled << 32 | rest >> 32)
    }

    fn of_prefix(&self, prefix: u64) -> u64 {
        mixed(self.key ^ prefix.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }
}

/// The direction numbers of a dimension: m₁, m₂, … of the table, then by the recurrence of its
/// primitive polynomial (Bratley and Fox 1988), each as a fraction of 2³².
fn directions(dimension: usize) -> [u32; BITS] {
    let Some((polynomial, initial)) = dimension.checked_sub(1).map(|d| DIRECTION_NUMBERS[d]) else {
        return std::array::from_fn(|bit| 1 << (BITS - 1 - bit));
    };
    let degree = initial.len();
    let mut directions = [0; BITS];
    for bit in 0..BITS {
        directions[bit] = match initial.get(bit) {
            Some(m) => m << (BITS - 1 - bit),
            None => (1..degree)
                .filter(|back| polynomial >> (degree - back) & 1 == 1)
                .fold(
                    directions[bit - degree] ^ (directions[bit - degree] >> degree),
                    |sum, back| sum ^ directions[bit - back],
                ),
        };
    }
    directions
}

#[cfg(test)]
mod tests {
    use super::{DIRECTION_NUMBERS, SobolDimension};

    /// `2**32 * scipy.stats.qmc.Sobol(64, scramble=False, bits=32).random(2**17)[[i]][0, d]` of
    /// scipy 1.17.
    #[test]
    fn the_points_before_scrambling_are_those_of_scipy() {
        for (dimension, points) in SCIPY {
            let sobol = SobolDimension::new(dimension, 0);
            for (point, expected) in [1, 2, 3, 77, 1000, 65_535, 131_071].into_iter().zip(points) {
                assert_eq!(sobol.plain(point), expected, "{dimension} {point}");
            }
        }
    }

    #[rustfmt::skip]
    const SCIPY: [(usize, [u32; 7]); 8] = [
        (0, [2147483648, 3221225472, 1073741824, 3590324224, 943718400, 65536, 32768]),
        (1, [2147483648, 1073741824, 3221225472, 3590324224, 415236096, 4294901760, 2147516416]),
        (2, [2147483648, 1073741824, 3221225472, 33554432, 2227175424, 2421489664, 3900735488]),
        (3, [2147483648, 1073741824, 3221225472, 3321888768, 2906652672, 3271884800, 546275328]),
        (7, [2147483648, 3221225472, 1073741824, 2785017856, 3862953984, 3125346304, 438599680]),
        (20, [2147483648, 1073741824, 3221225472, 637534208, 2243952640, 2432892928, 1233354752]),
        (40, [2147483648, 1073741824, 3221225472, 3523215360, 3921674240, 1781858304, 1131970560]),
        (63, [2147483648, 3221225472, 1073741824, 3791650816, 1916796928, 1272905728, 1960280064]),
    ];

    #[test]
    fn the_numbers_of_the_table_are_odd_and_small() {
        for (polynomial, initial) in DIRECTION_NUMBERS {
            assert_eq!(polynomial.ilog2() as usize, initial.len());
            for (index, m) in initial.iter().enumerate() {
                assert!(m % 2 == 1 && *m < 2 << index, "{polynomial}");
            }
        }
    }

    /// Any 2ᵏ successive points that begin at a multiple of 2ᵏ have one point in each interval of
    /// length 2⁻ᵏ, in every dimension and with any seed.
    #[test]
    fn each_interval_has_one_point() {
        for (seed, dimension) in [(0, 0), (0, 1), (1, 1), (7, 5), (7, 63)] {
            let sobol = SobolDimension::new(dimension, seed);
            for (first, count) in [(0, 1024), (4096, 4096), (1 << 31, 512)] {
                let mut is_taken = vec![false; count];
                for point in first..first + count as u32 {
                    let interval = (sobol.scrambled(point) * count as f64) as usize;
                    assert!(!std::mem::replace(&mut is_taken[interval], true));
                }
            }
        }
    }

    /// The first two dimensions are a (0, 2)-sequence: 2⁸ points have one in each rectangle of area
    /// 2⁻⁸, whatever its shape. Owen's scrambling keeps this.
    #[test]
    fn each_rectangle_of_two_dimensions_has_one_point() {
        let [x, y] = [0, 1].map(|dimension| SobolDimension::new(dimension, 3));
        for columns in [1, 2, 4, 16, 64, 256] {
            let rows = 256 / columns;
            let mut is_taken = [false; 256];
            for point in 256..512 {
                let column = (x.scrambled(point) * columns as f64) as usize;
                let row = (y.scrambled(point) * rows as f64) as usize;
                let place = column * rows + row;
                assert!(!std::mem::replace(&mut is_taken[place], true), "{columns}");
            }
        }
    }

    /// Over the seeds a point is uniformly distributed: chi-square of 16 intervals, 15 degrees of
    /// freedom, is below 45 with a probability of 0.9999.
    #[test]
    fn a_point_is_uniform_over_the_seeds() {
        for point in [0, 1, 1000] {
            let mut counts = [0.0; 16];
            for seed in 0..16_000 {
                let at = SobolDimension::new(3, seed).scrambled(point);
                counts[(at * 16.0) as usize] += 1.0;
            }
            let chi: f64 = counts
                .iter()
                .map(|n| (n - 1000.0_f64).powi(2) / 1000.0)
                .sum();
            assert!(chi < 45.0, "{point}: {chi} {counts:?}");
        }
    }
}
