//! The computed model as text: method, mesh, buckling load factor.

use towermodes::frame::FrameFoundation;
use towermodes::number::four_digits;
use towermodes::{Method, Solution};
use towermodes_analysis::study::{Comparison, Convergence, Fineness, Level};

use super::text::counted;

/// The mesh of a solution: "100 segments", "1 element of degree 19".
pub fn mesh(method: Method, segments: usize, degree: Option<usize>) -> String {
    let degree = degree.map(|degree| format!(" of degree {degree}"));
    counted(segments, method.unit()) + &degree.unwrap_or_default()
}

/// The text that names the structure of
/// [`Tower::structure_mass_kg`](towermodes::Tower::structure_mass_kg), for a tower with or without
/// a substructure.
pub fn structure_mass(substructure: Option<&FrameFoundation>) -> &'static str {
    match substructure {
        Some(_) => "mass of tower and substructure",
        None => "tower mass",
    }
}

/// The method and the mesh of a solution: "rmje-exact, 100 segments", "spectral, degree 17".
pub fn computed_by(solution: &Solution) -> String {
    let method = solution.method.name();
    match solution.degree {
        Some(degree) => format!("{method}, degree {degree}"),
        None => format!("{method}, {}", counted(solution.segments, "segment")),
    }
}

/// The levels of a convergence study: "10 to 320 segments, relative to the reference solution".
pub fn levels(convergence: &Convergence) -> String {
    let numbers = convergence.levels.iter().map(|level| level.asked.number());
    let is_degree = |level: &Level| matches!(level.asked, Fineness::Degree(_));
    let levels = match convergence.levels.first().is_some_and(is_degree) {
        true => format!("degrees {}", range(numbers)),
        false => format!("{} segments", range(numbers)),
    };
    let rotary = match convergence.rotary_inertia {
        true => "",
        false => " without rotary inertia",
    };
    format!("{levels}, relative to the reference solution{rotary}")
}

/// The segments of all methods of a comparison except `spectral`: "60 segments".
pub fn compared_segments(comparison: &Comparison) -> String {
    let columns = comparison.columns.iter();
    let others = columns.filter(|column| column.method != Method::Spectral);
    format!("{} segments", range(others.map(|column| column.segments)))
}

/// "60", "10 to 320".
fn range(numbers: impl Iterator<Item = usize> + Clone) -> String {
    match (numbers.clone().min(), numbers.max()) {
        (Some(least), Some(most)) if least < most => format!("{least} to {most}"),
        (least, _) => least.unwrap_or(0).to_string(),
    }
}

/// The buckling load factor: four digits, and six decimals near 1.
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
