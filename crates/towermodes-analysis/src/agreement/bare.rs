//! The wall and the point masses of a tower over a part of its height.

use super::columns::HeightRange;
use towermodes::tower::{
    Piece, PointMass, Profile, Properties, PropertyStation, Shear, Station, Tower,
    TowerDescription, Tube,
};

/// The part of a tower between two heights, clamped at its base, without RNA, foundation, soil,
/// water, guy wires, gravity and shear deformation.
pub(super) fn bare(
    tower: &Tower,
    point_masses: &[PointMass],
    part: HeightRange,
) -> TowerDescription {
    let mut bare = TowerDescription {
        name: tower.name().to_owned(),
        shear: Shear::Rigid,
        ..TowerDescription::default()
    };
    for piece in tower.pieces() {
        let (base_m, top_m) = (piece.base_m, piece.top_m);
        let shared = part.and(&HeightRange { base_m, top_m });
        if shared.base_m < shared.top_m {
            add(piece, shared, &mut bare);
        }
    }
    let masses = point_masses.iter().filter(|m| part.holds(m.height_m));
    bare.point_masses = masses
        .map(|mass| PointMass {
            height_m: mass.height_m.clamp(part.base_m, part.top_m),
            ..*mass
        })
        .collect();
    bare
}

/// Adds two rows for a part of a piece; the tower merges equal rows of neighbouring pieces.
fn add(piece: &Piece, part: HeightRange, bare: &mut TowerDescription) {
    let ends_m = [part.base_m, part.top_m];
    match piece.profile {
        Profile::Tube {
            base,
            top,
            material,
            ..
        } => {
            // The density includes the outfitting.
            if bare.materials.last() != Some(&material) {
                bare.materials.push(material);
            }
            let material = bare.materials.len() - 1;
            bare.stations.extend(ends_m.map(|height_m| {
                let tube = tube_at(piece, &base, &top, height_m);
                Station {
                    height_m,
                    outer_diameter_m: tube.outer_diameter_m,
                    wall_thickness_m: tube.wall_thickness_m,
                    material,
                }
            }));
        }
        Profile::Table { base, top } => {
            bare.properties
                .extend(ends_m.map(|height_m| PropertyStation {
                    height_m,
                    properties: row_at(piece, &base, &top, height_m),
                }));
        }
    }
}

/// The value at a height of a quantity that is linear over a piece: exact at both ends, infinite if
/// both end values are infinite.
fn linear(piece: &Piece, base: f64, top: f64, height_m: f64) -> f64 {
    if height_m == piece.base_m || base == top {
        base
    } else if height_m == piece.top_m {
        top
    } else {
        base + (height_m - piece.base_m) / piece.length_m() * (top - base)
    }
}

fn tube_at(piece: &Piece, base: &Tube, top: &Tube, height_m: f64) -> Tube {
    let at = |base, top| linear(piece, base, top, height_m);
    Tube {
        outer_diameter_m: at(base.outer_diameter_m, top.outer_diameter_m),
        wall_thickness_m: at(base.wall_thickness_m, top.wall_thickness_m),
    }
}

fn row_at(piece: &Piece, base: &Properties, top: &Properties, height_m: f64) -> Properties {
    let masses = piece.section_at(height_m).masses;
    let at = |base, top| linear(piece, base, top, height_m);
    Properties {
        mass_kg_per_m: masses.mass_kg_per_m,
        rotary_inertia_kg_m: masses.rotary_inertia_kg_m,
        polar_inertia_kg_m: masses.polar_inertia_kg_m,
        bending_n_m2: base.bending_n_m2.zip(top.bending_n_m2, at),
        torsion_n_m2: at(base.torsion_n_m2, top.torsion_n_m2),
        axial_n: at(base.axial_n, top.axial_n),
        shear_n: None,
    }
}
