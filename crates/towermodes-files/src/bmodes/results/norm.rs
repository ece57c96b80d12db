//! The scale that BModes gives its mode shapes.

/// Scales a mode as BModes does: the Euclidean norm of all its unknowns becomes 1, and its sign is
/// kept. Returns the factor, or `None` for a mode without motion, which is not changed.
///
/// `nodes` contain, from the base to the top, u/R, v/R, v', w/R, w' and the twist: u along the
/// axis, v fore-aft, w side-side (for a blade lag and flap). `interiors` contain for each element
/// from the base to the top u/R at 1/3 and 2/3 of its length and the twist at 1/2. Fixed motions
/// are zero. R is the height of the top, plus the draft if there is one.
pub fn euclidean(nodes: &mut [[f64; 6]], interiors: &mut [[f64; 3]]) -> Option<f64> {
    let unknowns = || nodes.iter().flatten().chain(interiors.iter().flatten());
    let largest = unknowns().fold(0.0_f64, |largest, x| largest.max(x.abs()));
    // By the largest first, so that no square overflows or vanishes.
    let sum: f64 = unknowns().map(|x| (x / largest) * (x / largest)).sum();
    let (root, usable) = (sum.sqrt(), sum.is_finite() && largest > 0.0);
    if !usable {
        return None;
    }
    let scale = |x: &mut f64| *x = *x / largest / root;
    nodes.iter_mut().flatten().for_each(scale);
    interiors.iter_mut().flatten().for_each(scale);
    Some(1.0 / largest / root)
}

#[cfg(test)]
mod tests {
    use super::euclidean;

    #[test]
    fn the_norm_is_one_and_the_sign_stays() {
        let mut nodes = [[0.0; 6], [0.0, -3.0, 1.0, 0.0, 0.0, 1.0]];
        let mut interiors = [[2.0, 0.0, -1.0]];
        // 9 + 1 + 1 + 4 + 1 = 16.
        let factor = euclidean(&mut nodes, &mut interiors).expect("a factor");
        let all = [
            factor,
            nodes[1][1],
            nodes[1][2],
            nodes[1][5],
            interiors[0][0],
            interiors[0][2],
        ];
        for (value, expected) in all.into_iter().zip([0.25, -0.75, 0.25, 0.25, 0.5, -0.25]) {
            assert!((value - expected).abs() < 1e-15, "{all:?}");
        }
        let mut huge = [[1e300, 1e300, 1e300, 1e300, 0.0, 0.0]];
        assert!(euclidean(&mut huge, &mut []).is_some());
        assert_eq!(huge[0], [0.5, 0.5, 0.5, 0.5, 0.0, 0.0]);
        let mut none = [[0.0; 6]];
        assert_eq!(euclidean(&mut none, &mut []), None);
        let mut nan = [[f64::NAN, 1.0, 0.0, 0.0, 0.0, 0.0]];
        assert_eq!(euclidean(&mut nan, &mut []), None);
        assert_eq!(nan[0][1], 1.0);
    }
}
