//! A deck of BModes keeps the tower but for weights, shear deformation and what its notes say.

use towermodes::{Foundation, Inertia, PointMass, SoilRow, SoilStiffness, TowerDescription, Wires};
use towermodes_files::{BmodesWriteError, FileFormat};
use towermodes_testing::with;

use super::comparison::{
    assert_near, frequencies_hz, largest_difference, weights_n_m, without_shear_and_weights,
};
use super::formats::{Target, bmodes, there_and_back, tower};
use super::towers;

/// What is spread is spread over this share of the length.
const WIDTH: f64 = 0.005;

/// The tower without what a deck cannot hold, in the way that its notes tell.
fn as_noted(description: &TowerDescription) -> TowerDescription {
    let mut reduced = without_shear_and_weights(description);
    reduced.rna.center_m[1] = 0.0;
    if let Foundation::Floating(platform) = &mut reduced.foundation {
        let weights = weights_n_m(description, platform);
        // A moment is the same about every point.
        platform.mooring.matrix[3][3] += weights;
        platform.mooring.matrix[4][4] += weights;
    }
    let length_m = tower(description).height_m();
    if !tower(description).base().is_clamped() {
        // Wires or a block of springs: soil stands for the wires.
        let wires = std::mem::take(&mut reduced.wires);
        let soil = wires.iter().map(|wires| as_soil(wires, WIDTH * length_m));
        reduced.soil.extend(soil);
    }
    let masses = std::mem::take(&mut reduced.point_masses);
    reduced.point_masses = masses
        .iter()
        .flat_map(|mass| spread(mass, WIDTH * length_m))
        .collect();
    reduced
}

/// The horizontal stiffness of wires over a width; the vertical one goes to the base and does
/// nothing to the modes that are compared.
fn as_soil(wires: &Wires, width_m: f64) -> Vec<SoilRow> {
    let per_metre = wires.horizontal_n_per_m() / width_m;
    let row = |height_m| SoilRow {
        height_m,
        stiffness: SoilStiffness {
            x_n_per_m2: per_metre,
            y_n_per_m2: per_metre,
            ..SoilStiffness::default()
        },
    };
    let half_m = 0.5 * width_m;
    vec![row(wires.height_m - half_m), row(wires.height_m + half_m)]
}

/// A mass as many, each in the middle of its part of the width, which keep of its inertia that
/// about the tower's axis.
fn spread(mass: &PointMass, width_m: f64) -> impl Iterator<Item = PointMass> + use<> {
    const PARTS: usize = 20;
    let mass = *mass;
    let zz = mass.inertia_kg_m2.zz / PARTS as f64;
    (0..PARTS).map(move |k| PointMass {
        height_m: mass.height_m + width_m * ((k as f64 + 0.5) / PARTS as f64 - 0.5),
        mass_kg: mass.mass_kg / PARTS as f64,
        // No body can have an inertia about one axis alone.
        inertia_kg_m2: with!(Inertia, xx = 0.5 * zz, yy = 0.5 * zz, zz),
    })
}

#[test]
fn a_deck_is_the_tower_but_for_what_its_notes_say() {
    for (name, description) in towers::all() {
        let input = there_and_back(&description, Target::Bmodes);
        assert_eq!(input.format, FileFormat::Bmodes, "{name}");
        let (original, again) = (
            tower(&as_noted(&description)),
            input.tower().expect("a tower"),
        );
        assert_near(again.mass_kg(), original.mass_kg(), 1e-6, name);
        let off = largest_difference(&frequencies_hz(&again), &frequencies_hz(&original));
        eprintln!(
            "BModes, {name}: {off:.1e}, mass {:.1e}",
            again.mass_kg() / original.mass_kg() - 1.0
        );
        assert!(off <= 5e-6, "{name}: {off:e}");
    }
}

#[test]
fn a_deck_that_could_only_be_another_tower_is_none() {
    let mut description = towers::unequal_planes();
    description.properties[3].properties.bending_n_m2.side_side *= 1.1;
    assert!(matches!(
        bmodes(&description).err(),
        Some(BmodesWriteError::UnequalPlanes { .. })
    ));
    let mut description = towers::in_soil();
    description.soil[0][0].stiffness.y_n_per_m2 *= 1.1;
    assert!(matches!(
        bmodes(&description).err(),
        Some(BmodesWriteError::UnequalSoil { .. })
    ));
    let mut description = towers::axially_held();
    if let Foundation::Stiffness(foundation) = &mut description.foundation {
        foundation.stiffness[0][0] = f64::INFINITY;
    }
    assert!(matches!(
        bmodes(&description).err(),
        Some(BmodesWriteError::PartlyRigidBase { .. })
    ));
}
