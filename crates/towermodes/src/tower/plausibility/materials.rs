//! Materials: their properties, and whether they are used.

use super::Given;
use super::usual::Usual;
use crate::tower::Warning;
use crate::tower::{Ineffective, Quantity, Site};
use crate::tower::{Material, Place, Tower};

const DENSITY: Usual = Usual::new(Quantity::Density, 300.0, 25e3);
const YOUNGS_MODULUS: Usual = Usual::new(Quantity::YoungsModulus, 1e9, 1e12);
const POISSONS_RATIO: Usual = Usual::new(Quantity::PoissonsRatio, 0.0, 0.49);
/// Wave speed √(E/ρ), m/s: plastics with glass fibres have 3500, with carbon fibres up to 9700;
/// steel whose density includes bolts and paint has 4500.
const WAVE_SPEED: Usual = Usual::new(Quantity::MaterialWaveSpeed, 1500.0, 9800.0);
const OUTFITTING_FACTOR: Usual = Usual::new(Quantity::OutfittingFactor, 0.9, 2.0);

pub(super) fn check(tower: &Tower, given: &Given<'_>, warnings: &mut Vec<Warning>) {
    let site = Site::at(Place::OutfittingFactor);
    OUTFITTING_FACTOR.check(tower.outfitting_factor(), site, warnings);
    let used = used(tower, given.materials.len());
    for (index, (material, is_used)) in given.materials.iter().zip(&used).enumerate() {
        if *is_used {
            of_material(index, material, warnings);
        }
    }
    useless(tower, &used, warnings);
}

/// For each material, whether a part of the tower consists of it: the material of a row applies up
/// to the next row.
fn used(tower: &Tower, count: usize) -> Vec<bool> {
    let mut used = vec![false; count];
    for pair in tower.stations().windows(2) {
        used[pair[0].material] |= pair[0].height_m != pair[1].height_m;
    }
    used
}

fn of_material(index: usize, material: &Material, warnings: &mut Vec<Warning>) {
    let at = |key| Site::at(Place::Material { index, key });
    let (density, modulus) = (material.density_kg_per_m3, material.youngs_modulus_pa);
    let is_odd = DENSITY.check(density, at("density"), warnings)
        | YOUNGS_MODULUS.check(modulus, at("youngs_modulus"), warnings);
    if !is_odd {
        WAVE_SPEED.check((modulus / density).sqrt(), at("density"), warnings);
    }
    POISSONS_RATIO.check(material.poissons_ratio(), at("shear_modulus"), warnings);
}

/// Warns about materials that no part of the tower consists of. If only the last row has a
/// material, the warning is at this row.
fn useless(tower: &Tower, used: &[bool], warnings: &mut Vec<Warning>) {
    let stations = tower.stations();
    let last_alone = match stations {
        [.., below, last] if below.material != last.material => {
            (below.height_m != last.height_m).then_some(last.material)
        }
        _ => None,
    };
    if last_alone.is_some() {
        let (index, key) = (stations.len() - 1, "material");
        let site = Site::at(Place::Station { index, key });
        warnings.push(Warning::UselessMaterial { site });
    }
    let unused = (0..used.len()).filter(|&index| !used[index] && last_alone != Some(index));
    // A tower with a table of properties uses no materials, and no file can give them.
    for index in unused.filter(|_| !stations.is_empty()) {
        let key = "density";
        warnings.push(Warning::NoEffect {
            site: Site::at(Place::Material { index, key }),
            what: Ineffective::UnusedMaterial,
        });
    }
}
