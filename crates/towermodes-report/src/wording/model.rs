//! The computed model in words: its mesh, and when it buckles.

use towermodes::Method;
use towermodes::number::four_digits;

use super::text::counted;

/// The mesh of a solution: "100 segments", "1 element of degree 19".
pub fn mesh(method: Method, segments: usize, degree: Option<usize>) -> String {
    let degree = degree.map(|degree| format!(" of degree {degree}"));
    counted(segments, method.unit()) + &degree.unwrap_or_default()
}

/// The factor on gravity at which the tower buckles: four digits, and near 1 six decimals.
pub fn buckling_load_factor(factor: f64) -> String {
    if factor < 1.01 {
        format!("{factor:.6}")
    } else {
        four_digits(factor)
    }
}

#[cfg(test)]
mod tests {
    use towermodes::Method;

    use super::{buckling_load_factor, mesh};

    #[test]
    fn meshes_are_named_by_their_method() {
        assert_eq!(mesh(Method::RmjeExact, 1, None), "1 segment");
        assert_eq!(
            mesh(Method::Spectral, 2, Some(19)),
            "2 elements of degree 19"
        );
    }

    #[test]
    fn load_factors_near_1_have_more_digits() {
        assert_eq!(buckling_load_factor(14.584), "14.58");
        assert_eq!(buckling_load_factor(1.000_012_3), "1.000012");
    }
}
