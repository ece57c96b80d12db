//! The energy of modes by parts of the tower: for springs and masses the difference that the part
//! makes with fixed vector; for materials the energy in joints or elements.

use super::super::on_mesh::cut::Cut;
use super::super::on_mesh::model::Model;
use super::super::on_mesh::spectrum::{Found, Spectrum};
use super::super::request::options::Options;
use super::super::workspace::Workspace;
use crate::modes::{EnergyParts, KineticParts, StrainParts};
use crate::subsystem::Energies;
use crate::tower::{Strippable, Tower};

/// The energy of each mode found, by parts.
pub(crate) fn energy_parts(
    tower: &Tower,
    cut: &Cut,
    options: &Options,
    found: &[Found],
    workspace: &mut Workspace,
) -> Vec<EnergyParts> {
    let Workspace {
        model, spectrum, ..
    } = workspace;
    let whole = energies(model, spectrum, found);
    let mut all: Vec<EnergyParts> = found
        .iter()
        .zip(&whole)
        .map(|(found, energies)| EnergyParts {
            strain: StrainParts {
                materials: by_material(tower, model, spectrum, found),
                gravity: 0.0 - energies.gravity,
                ..StrainParts::default()
            },
            kinetic: KineticParts {
                tower: energies.mass,
                ..KineticParts::default()
            },
        })
        .collect();
    // The model keeps the whole tower for the error estimates.
    let mut model = Model::default();
    for part in Strippable::ALL {
        let Some(stripped) = tower.without(part) else {
            continue;
        };
        model.assemble(&stripped, &cut.mesh, cut.degree, options);
        let rest = energies(&mut model, spectrum, found);
        for ((parts, whole), rest) in all.iter_mut().zip(&whole).zip(&rest) {
            let spring = whole.foundation - rest.foundation;
            set(parts, part, spring, whole.mass - rest.mass);
        }
    }
    if tower.frame().is_some() {
        for (parts, whole) in all.iter_mut().zip(&whole) {
            // Strain energy that is not in the materials of the tower is bending of members of the
            // frame.
            let of_tower: f64 = parts.strain.materials.iter().sum();
            parts.strain.substructure = whole.elastic - of_tower;
        }
    }
    let fractions = |parts: EnergyParts| EnergyParts {
        strain: parts.strain.into_fractions(),
        kinetic: parts.kinetic.into_fractions(),
    };
    all.into_iter().map(fractions).collect()
}

/// Sets the energy of the springs and of the masses of a part; the tower has the mass that is left.
fn set(parts: &mut EnergyParts, part: Strippable, spring: f64, mass: f64) {
    let EnergyParts { strain, kinetic } = parts;
    kinetic.tower -= mass;
    match part {
        Strippable::Base => (strain.foundation, kinetic.foundation) = (spring, mass),
        Strippable::Moorings => strain.moorings = spring,
        Strippable::Members => kinetic.substructure = mass,
        Strippable::Growth => kinetic.growth = mass,
        Strippable::Filling => kinetic.filling = mass,
        Strippable::Surroundings => (strain.soil, kinetic.water) = (spring, mass),
        Strippable::WiresAndMasses => (strain.wires, kinetic.point_masses) = (spring, mass),
        Strippable::Rna => kinetic.rna = mass,
    }
}

fn energies(model: &mut Model, spectrum: &Spectrum, found: &[Found]) -> Vec<Energies> {
    let of_mode = |found: &Found| model.energies(found.key.subsystem, spectrum.vector(found.key));
    found.iter().map(of_mode).collect()
}

/// The strain energy of a mode in each material, times 2.
fn by_material(tower: &Tower, model: &Model, spectrum: &Spectrum, found: &Found) -> Vec<f64> {
    let mut materials = vec![0.0; tower.material_count()];
    let vector = spectrum.vector(found.key);
    let subsystem = model.subsystem(found.key.subsystem);
    subsystem.strain_energies(vector, &mut |height_m, energy| {
        materials[tower.material_index_at(height_m)] += energy;
    });
    materials
}
