//! Footings by closed form in tables.

use towermodes::{CircularFooting, RectangularFooting};

use super::super::document::Block;
use super::super::table::Table;
use super::foundation::{matrix, of_springs};
use super::table;
use crate::number::{digits, given, length};

pub(super) fn of_circular(footing: &CircularFooting) -> Vec<Block> {
    let mut facts = vec![("radius (m)", length(footing.radius_m))];
    facts.extend(of_soil(
        footing.embedment_m,
        footing.shear_modulus_pa,
        footing.poissons_ratio,
        footing.is_coupled,
    ));
    if footing.stratum_thickness_m.is_finite() {
        let thickness = length(footing.stratum_thickness_m);
        facts.push(("thickness of the stratum (m)", thickness));
        let below = match footing.lower_shear_modulus_pa.is_finite() {
            true => given(footing.lower_shear_modulus_pa),
            false => "rock".to_owned(),
        };
        facts.push(("shear modulus below the stratum (Pa)", below));
    }
    let caption = format!("Rigid circular footing, by {}", CircularFooting::FORMULA);
    let springs = footing.springs();
    let springs = of_springs("Springs of the footing", &springs, |value| digits(value, 5));
    vec![table(Table::of_facts(&caption, facts)), table(springs)]
}

pub(super) fn of_rectangular(footing: &RectangularFooting) -> Vec<Block> {
    let mut facts = vec![
        ("side along x (m)", length(footing.length_x_m)),
        ("side along y (m)", length(footing.length_y_m)),
    ];
    facts.extend(of_soil(
        footing.embedment_m,
        footing.shear_modulus_pa,
        footing.poissons_ratio,
        footing.is_coupled,
    ));
    let caption = format!("Rigid rectangular footing, by {}", footing.formula.name());
    let stiffness = "Stiffness of the footing (N/m, N, N m)";
    let stiffness = matrix(stiffness, &footing.stiffness(), |value| digits(value, 5));
    vec![table(Table::of_facts(&caption, facts)), table(stiffness)]
}

fn of_soil(
    embedment_m: f64,
    shear_modulus_pa: f64,
    poissons_ratio: f64,
    is_coupled: bool,
) -> [(&'static str, String); 4] {
    let coupled = if is_coupled { "yes" } else { "no" };
    [
        ("embedment depth (m)", length(embedment_m)),
        ("shear modulus of the soil (Pa)", given(shear_modulus_pa)),
        ("Poisson's ratio of the soil (−)", given(poissons_ratio)),
        ("sliding and rocking coupled", coupled.to_owned()),
    ]
}
