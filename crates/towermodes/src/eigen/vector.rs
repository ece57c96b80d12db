//! Products of long vectors, blocked so that a basis is read from memory once and a sum has few
//! rounding errors.

/// Entries handled together: two such blocks stay in the first-level cache.
const BLOCK: usize = 1024;

/// xᵀ y in a fixed order of summation: eight running sums over each block, then the blocks.
pub(super) fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.chunks(BLOCK)
        .zip(y.chunks(BLOCK))
        .map(|(x, y)| block_dot(x, y))
        .sum()
}

#[inline]
fn block_dot(x: &[f64], y: &[f64]) -> f64 {
    let (x_eights, y_eights) = (x.chunks_exact(8), y.chunks_exact(8));
    let rest: f64 = x_eights
        .remainder()
        .iter()
        .zip(y_eights.remainder())
        .map(|(x, y)| x * y)
        .sum();
    let mut sums = [0.0; 8];
    for (x, y) in x_eights.zip(y_eights) {
        for lane in 0..8 {
            sums[lane] += x[lane] * y[lane];
        }
    }
    let [a, b, c, d, e, f, g, h] = sums;
    ((a + e) + (b + f)) + ((c + g) + (d + h)) + rest
}

/// coefficients[i] = basis[i]ᵀ x.
pub(super) fn project(basis: &[Vec<f64>], x: &[f64], coefficients: &mut [f64]) {
    coefficients.fill(0.0);
    for (block, x) in x.chunks(BLOCK).enumerate() {
        let from = block * BLOCK;
        for (coefficient, v) in coefficients.iter_mut().zip(basis) {
            *coefficient += block_dot(&v[from..from + x.len()], x);
        }
    }
}

/// x ← x + Σ factors[i]·basis[i].
pub(super) fn add_combination(basis: &[Vec<f64>], factors: &[f64], x: &mut [f64]) {
    for (block, x) in x.chunks_mut(BLOCK).enumerate() {
        let from = block * BLOCK;
        let (fours, rest) = basis.split_at(basis.len() / 4 * 4);
        for (v, factors) in fours.chunks_exact(4).zip(factors.chunks_exact(4)) {
            let [a, b, c, d] = [0, 1, 2, 3].map(|k| &v[k][from..from + x.len()]);
            // The order of the additions is that of the vectors one by one.
            for ((((x, a), b), c), d) in x.iter_mut().zip(a).zip(b).zip(c).zip(d) {
                *x = (((*x + factors[0] * a) + factors[1] * b) + factors[2] * c) + factors[3] * d;
            }
        }
        for (v, factor) in rest.iter().zip(&factors[fours.len()..]) {
            for (x, v) in x.iter_mut().zip(&v[from..]) {
                *x += factor * v;
            }
        }
    }
}

/// x ← factor·x.
pub(super) fn scale(x: &mut [f64], factor: f64) {
    for x in x {
        *x *= factor;
    }
}

/// Fills x with numbers in (−1/2, 1/2) that depend on the seed alone (splitmix64: Steele, Lea &
/// Flood 2014).
pub(super) fn fill_pseudo_random(x: &mut [f64], seed: u64) {
    let mut state = seed;
    for x in x {
        state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = state;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^= z >> 31;
        *x = (z >> 11) as f64 / (1u64 << 53) as f64 - 0.5;
    }
}
