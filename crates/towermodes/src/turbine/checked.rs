//! A checked turbine.

use super::description::TurbineDescription;
use super::equations::blade_elements::borders;
use super::equations::machine::Machine;
use super::equations::mesh::TurbineMesh;
use super::error::{MOST_GENERATOR, TurbineError};
use super::validate::check;
use crate::beam::TurningBlade;
use crate::blade::Blade;
use crate::rotor::Multiblade;
use crate::tower::{Rna, Tower, TowerDescription};

/// A turbine that can exist, on its tower; constant afterwards.
///
/// # Example
/// Three uniform blades on a uniform tower, at rest and at 12 rpm:
/// ```
/// use towermodes::turbine::{
///     Generator, Hub, Turbine, TurbineDescription, TurbineMesh, TurbineModel,
/// };
/// use towermodes::{
///     BladeDescription, BladeSection, Inertia, Material, RigidBody, Station, TowerDescription,
/// };
///
/// let root = BladeSection {
///     mass_kg_per_m: 200.0,
///     flap_n_m2: 2e9,
///     edge_n_m2: 5e9,
///     torsion_n_m2: f64::INFINITY,
///     axial_n: f64::INFINITY,
///     ..BladeSection::default()
/// };
/// let machine = TurbineDescription {
///     nacelle: RigidBody {
///         mass_kg: 1e5,
///         center_m: [1.0, 0.0, 1.5],
///         inertia_kg_m2: Inertia { xx: 2e5, yy: 8e5, zz: 9e5, ..Inertia::default() },
///     },
///     overhang_m: -4.0,
///     tower_to_shaft_m: 2.0,
///     tilt_rad: -0.09,
///     hub: Hub { mass_kg: 2e4, polar_inertia_kg_m2: 5e4, ..Hub::default() },
///     shaft_n_m_per_rad: 5e8,
///     generator: Generator { inertia_kg_m2: 4e6, gear_ratio: 1.0, is_locked: true },
///     blade: BladeDescription {
///         hub_radius_m: 2.0,
///         tip_radius_m: 52.0,
///         sections: vec![root, BladeSection { span: 1.0, ..root }],
///         borders: vec![0.0, 0.5, 1.0],
///         ..BladeDescription::default()
///     },
///     ..TurbineDescription::default()
/// };
/// let tower = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     ..TowerDescription::default()
/// };
/// let turbine = Turbine::new(tower, machine)?;
/// let mut model = TurbineModel::new(&turbine, &TurbineMesh::default())?;
/// for rpm in [0.0, 12.0] {
///     let spectrum = model.frequencies(2.0, rpm)?;
///     assert!(spectrum.is_complete);
///     assert_eq!(spectrum.frequencies.len(), model.count(2.0, rpm));
/// }
/// # Ok::<(), towermodes::turbine::TurbineError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Turbine {
    pub(super) tower: Tower,
    pub(super) blade: Blade,
    pub(super) machine: TurbineDescription,
}

impl Turbine {
    /// Checks a tower and what it carries, and puts them together.
    ///
    /// # Errors
    /// [`TurbineError`] that describes the first invalid value.
    pub fn new(
        mut tower: TowerDescription,
        machine: TurbineDescription,
    ) -> Result<Self, TurbineError> {
        if !tower.rna.is_absent() {
            let mass_kg = tower.rna.mass_kg;
            return Err(TurbineError::TwoMachines { mass_kg });
        }
        let (blade, rna) = checked(&machine)?;
        // The weight of the RNA compresses the tower; its inertia is that of its parts.
        tower.rna = rna;
        Ok(Self {
            tower: Tower::new(tower)?,
            blade,
            machine,
        })
    }

    /// Like [`Self::new`], but removes the rotor-nacelle assembly of the tower, a rigid body, which
    /// the turbine replaces.
    ///
    /// # Errors
    /// [`TurbineError`] that describes the first invalid value.
    pub fn in_place_of_rna(
        mut tower: TowerDescription,
        machine: TurbineDescription,
    ) -> Result<Self, TurbineError> {
        tower.rna = Rna::default();
        Self::new(tower, machine)
    }

    /// The tower, which carries the whole machine as a rigid body.
    pub fn tower(&self) -> &Tower {
        &self.tower
    }

    /// The mesh that it is solved on usually: the default one, with a higher degree for a blade
    /// with long elements.
    pub fn mesh(&self) -> TurbineMesh {
        let borders = borders(&self.blade);
        let lengths = borders.windows(2).map(|ends| ends[1] - ends[0]);
        TurbineMesh::of_blade(lengths.fold(0.0, f64::max))
    }

    /// What the tower carries.
    pub fn machine(&self) -> &TurbineDescription {
        &self.machine
    }
}

impl TurbineDescription {
    /// The turbine as a rigid body that does not turn, for towers without a turning rotor.
    ///
    /// # Errors
    /// [`TurbineError`] that describes the first invalid value.
    pub fn rna(&self) -> Result<Rna, TurbineError> {
        checked(self).map(|(_, rna)| rna)
    }
}

/// The blade of a turbine after the checks of its values, and the RNA as a rigid body.
fn checked(machine: &TurbineDescription) -> Result<(Blade, Rna), TurbineError> {
    check(machine)?;
    let blade = Blade::new(machine.blade.clone())?;
    let rotor = rotor(&blade, machine, 2)?;
    let whole = Machine::new(machine, rotor);
    let (generator_kg_m2, rotor_kg_m2) = (whole.generator_at_shaft(), whole.rotor_inertia);
    if generator_kg_m2 > MOST_GENERATOR * rotor_kg_m2 {
        return Err(TurbineError::Generator {
            generator_kg_m2,
            rotor_kg_m2,
        });
    }
    Ok((blade, whole.at_rest(machine)))
}

/// The rotor of a turbine, with blade elements of a degree.
pub(super) fn rotor(
    blade: &Blade,
    machine: &TurbineDescription,
    degree: usize,
) -> Result<Multiblade<TurningBlade>, TurbineError> {
    let borders = borders(blade);
    let body = TurningBlade::new(blade, machine.cone_rad, &borders, degree);
    Ok(Multiblade::new(body, machine.blades)?)
}
