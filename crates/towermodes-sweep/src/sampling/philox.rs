//! A random number generator without state: Philox 4×64 with ten rounds.
//!
//! Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as 1, 2, 3", SC11 (2011). Any
//! number of a stream can be computed independently of the others, so any process can draw rows in
//! any order.

const MULTIPLIERS: [u64; 2] = [0xD2E7_470E_E14C_6C93, 0xCA5A_8263_9512_1157];
const KEY_STEPS: [u64; 2] = [0x9E37_79B9_7F4A_7C15, 0xBB67_AE85_84CA_A73B];
const ROUNDS: usize = 10;

/// Four random numbers of 64 bits for a counter and a key.
pub(super) fn philox(mut counter: [u64; 4], mut key: [u64; 2]) -> [u64; 4] {
    for round in 0..ROUNDS {
        if round > 0 {
            key[0] = key[0].wrapping_add(KEY_STEPS[0]);
            key[1] = key[1].wrapping_add(KEY_STEPS[1]);
        }
        let product = |i: usize| u128::from(MULTIPLIERS[i]) * u128::from(counter[2 * i]);
        let (first, second) = (product(0), product(1));
        let (high, low) = (|p: u128| (p >> 64) as u64, |p: u128| p as u64);
        counter = [
            high(second) ^ counter[1] ^ key[0],
            low(second),
            high(first) ^ counter[3] ^ key[1],
            low(first),
        ];
    }
    counter
}

/// A number in the open interval (0, 1) from 52 random bits: the middle of one of 2⁵² equal
/// intervals, so that no quantile is infinite.
pub(super) fn unit(bits: u64) -> f64 {
    ((bits >> 12) as f64 + 0.5) / (1_u64 << 52) as f64
}

/// Mixes the bits of a number (the finalizer of SplitMix64): each input bit changes half of the
/// output bits on average. Steele, Lea, Flood, "Fast splittable pseudorandom number generators",
/// OOPSLA 2014.
pub(super) fn mixed(mut bits: u64) -> u64 {
    bits = (bits ^ (bits >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    bits = (bits ^ (bits >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    bits ^ (bits >> 31)
}

#[cfg(test)]
mod tests {
    use super::{philox, unit};

    /// The generator of NumPy 2.4 adds 1 to the counter before each block:
    /// `numpy.random.Philox(key=[2, 3], counter=[4, 5, 6, 7]).random_raw(4)`, and key and counter
    /// 0.
    #[test]
    fn the_numbers_are_those_of_numpy() {
        assert_eq!(philox([5, 5, 6, 7], [2, 3]), NUMPY[0]);
        assert_eq!(philox([1, 0, 0, 0], [0, 0]), NUMPY[1]);
    }

    const NUMPY: [[u64; 4]; 2] = [
        [
            0xca9368b59c83c05d,
            0x8f71e4bce4f9e032,
            0x827a1f485bb63474,
            0xbc126e9dc80a7a66,
        ],
        [
            0x2f4ba6408e4d89b,
            0x3dd62b0b9ca8c5b2,
            0x1c8667a55d902e79,
            0x907d7a052fd5b4dc,
        ],
    ];

    #[test]
    fn units_are_never_0_or_1() {
        assert_eq!(unit(0), 0.5_f64.powi(53));
        assert_eq!(unit(u64::MAX), 1.0 - 0.5_f64.powi(53));
        assert_eq!(unit(1 << 63), 0.5 + 0.5_f64.powi(53));
    }
}
