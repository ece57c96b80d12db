//! No input makes the reader or the solver panic, and what is refused is refused with a place
//! inside the file.

use proptest::prelude::*;
use proptest::sample::Index;
use towermodes::{Method, Options, solve};
use towermodes_files::tower_from_toml;

const FILES: [&str; 11] = [
    include_str!("../../../examples/reference-tower.toml"),
    include_str!("../../../examples/reference-tower-350t.toml"),
    include_str!("../../../examples/nrel-5mw.toml"),
    include_str!("../../../examples/monopile.toml"),
    include_str!("../../../examples/floating.toml"),
    include_str!("../../../examples/floating-lines.toml"),
    include_str!("../../../examples/jacket.toml"),
    include_str!("../../../examples/guyed.toml"),
    include_str!("../../../examples/nrel-5mw-turbine.toml"),
    r#"
name = "elliptic"
[tower]
outfitting_factor = 1.02
[tower.properties]
z_m = [0.0, 40.0, 40.0, 90.0]
mass_kg_per_m = [5000, 4800.0, 4200.0, 3000.0]
ei_fore_aft_n_m2 = [6.0e11, 5.0e11, 4.5e11, 1.2e11]
ei_side_side_n_m2 = [7.0e11, 5.5e11, 4.5e11, 1.1e11]
gj_n_m2 = [5.0e11, 4.0e11, 3.6e11, 0.9e11]
ea_n = [1.4e11, 1.3e11, 1.1e11, 0.6e11]
polar_inertia_kg_m = [5.0e4, 4.0e4, 3.6e4, 0.9e4]
shear_stiffness_fore_aft_n = [2.6e10, 2.4e10, 2.1e10, 1.2e10]
[rna]
mass = 300e3
"#,
    r#"
name = "hybrid"
[materials.concrete]
density = 2500.0
youngs_modulus = 3.6e10
poissons_ratio = 0.2
[materials.steel]
density = 7850.0
youngs_modulus = 2.1e11
shear_modulus = 8.08e10
poissons_ratio = 0.3
[tower]
outfitting_factor = 1.05
shear = true
stations = [
  [10.0, 9.0, 0.5, "concrete"],
  [60.0, 7.0, 0.4, "concrete"],
  [60.0, 6.0, 0.04, "steel"],
  [120.0, 4.0, 0.022, "steel"],
]
[rna]
mass = 400e3
center = [0.0, 0.0, 2.1]
inertia = { xx = 4.4e7, yy = 2.4e7, zz = 2.5e7 }
[[point_mass]]
height = 60.0
mass = 20e3
[foundation]
type = "clamped"
"#,
];

/// Pieces that are likely to hurt.
const SPLICES: [&str; 30] = [
    "0",
    "-1",
    "nan",
    "inf",
    "-inf",
    "1e308",
    "1e-308",
    "1e999",
    "0x10",
    "true",
    "\"x\"",
    "[",
    "]",
    "{",
    "}",
    "=",
    ",",
    "\n",
    "[[point_mass]]\n",
    "[rna]\n",
    "[[soil]]\n",
    "[gravity]\n",
    "[foundation]\n",
    "type = \"springs\"\n",
    "type = \"floating\"\n",
    "[[wires]]\n",
    "stations",
    "\u{0}",
    "ü",
    "1979-05-27",
];

#[derive(Debug, Clone)]
pub enum Mutation {
    Cut(Index, usize),
    Insert(Index, usize),
    ReplaceNumber(Index, f64),
    Duplicate(Index, usize),
    Truncate(Index),
}

/// A change of a text that is likely to hurt.
pub fn any_mutation() -> impl Strategy<Value = Mutation> {
    let number = prop_oneof![
        prop::num::f64::ANY,
        -1e3..1e3,
        prop::sample::select(vec![0.0, 1e-300, 1e300, 1e-12, 1e12, 87.6]),
    ];
    prop_oneof![
        (any::<Index>(), 1..20usize).prop_map(|(i, n)| Mutation::Cut(i, n)),
        (any::<Index>(), 0..SPLICES.len()).prop_map(|(i, n)| Mutation::Insert(i, n)),
        (any::<Index>(), number).prop_map(|(i, x)| Mutation::ReplaceNumber(i, x)),
        (any::<Index>(), 1..60usize).prop_map(|(i, n)| Mutation::Duplicate(i, n)),
        any::<Index>().prop_map(Mutation::Truncate),
    ]
}

/// The characters of a text changed as a mutation says.
pub fn mutated(text: &str, mutation: &Mutation) -> String {
    let characters: Vec<char> = text.chars().collect();
    let at = |index: &Index| index.index(characters.len() + 1);
    let join = |parts: &[&[char]]| parts.concat().into_iter().collect::<String>();
    match mutation {
        Mutation::Cut(index, length) => {
            let end = (at(index) + length).min(characters.len());
            join(&[&characters[..at(index)], &characters[end..]])
        }
        Mutation::Insert(index, which) => {
            let splice: Vec<char> = SPLICES[*which].chars().collect();
            join(&[&characters[..at(index)], &splice, &characters[at(index)..]])
        }
        Mutation::Duplicate(index, length) => {
            let end = (at(index) + length).min(characters.len());
            join(&[&characters[..end], &characters[at(index)..]])
        }
        Mutation::Truncate(index) => join(&[&characters[..at(index)]]),
        Mutation::ReplaceNumber(index, number) => replace_number(text, index, *number),
    }
}

/// One of the numbers of a text replaced.
fn replace_number(text: &str, index: &Index, number: f64) -> String {
    let is_number = |word: &str| word.parse::<f64>().is_ok();
    let separators = |c: char| c.is_whitespace() || "[],={}".contains(c);
    let numbers: Vec<&str> = text
        .split(separators)
        .filter(|word| is_number(word))
        .collect();
    let Some(chosen) = numbers.get(index.index(numbers.len().max(1))) else {
        return text.to_owned();
    };
    let start = chosen.as_ptr() as usize - text.as_ptr() as usize;
    format!(
        "{}{number:?}{}",
        &text[..start],
        &text[start + chosen.len()..]
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, ..ProptestConfig::default() })]

    #[test]
    fn mutated_files_are_solved_or_refused(
        file in 0..FILES.len(),
        mutations in prop::collection::vec(any_mutation(), 1..4),
        method in prop::sample::select(Method::ALL.to_vec()),
        segments in 1..40usize,
    ) {
        let mut text = FILES[file].to_owned();
        for mutation in &mutations {
            text = mutated(&text, mutation);
        }
        match tower_from_toml(&text) {
            Ok(tower) => {
                let options = Options { method, segments: Some(segments), modes: 6, ..Options::default() };
                if let Ok(solution) = solve(&tower, &options) {
                    prop_assert!(solution.certificate.complete);
                    for mode in &solution.modes {
                        // Only what floats may have motions that nothing resists.
                        let is_held = mode.frequency_hz > 0.0 || mode.family.is_rigid();
                        prop_assert!(mode.frequency_hz.is_finite() && mode.frequency_hz >= 0.0 && is_held);
                        prop_assert!(mode.discretization_error_hz.is_finite());
                        prop_assert!(mode.shape.iter().all(|p| p.translation.iter().chain(&p.rotation).all(|v| v.is_finite())));
                    }
                }
            }
            Err(mistakes) => {
                prop_assert!(!mistakes.is_empty());
                for mistake in mistakes {
                    prop_assert!(mistake.span.start <= mistake.span.end && mistake.span.end <= text.len());
                    prop_assert!(!mistake.message().is_empty());
                }
            }
        }
    }
}
