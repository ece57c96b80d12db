//! The computed model in words: its mesh, and when it buckles.

use towermodes::Method;
use towermodes::number::four_digits;

use super::text::counted;

/// Whether a method is a beam of flexible elements, and not a chain of rigid segments.
pub fn is_beam(method: Method) -> bool {
    matches!(method, Method::Bmodes | Method::Spectral)
}

/// What a method divides a tower into: "element" for beams, "segment" for chains.
pub fn mesh_unit(method: Method) -> &'static str {
    if is_beam(method) {
        "element"
    } else {
        "segment"
    }
}

/// The mesh of a solution: "100 segments", "1 element of degree 19".
pub fn mesh(method: Method, segments: usize, degree: Option<usize>) -> String {
    let degree = degree.map(|degree| format!(" of degree {degree}"));
    counted(segments, mesh_unit(method)) + &degree.unwrap_or_default()
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
