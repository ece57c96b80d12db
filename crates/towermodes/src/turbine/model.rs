//! A checked turbine, and its equations of motion on a mesh.

use std::f64::consts::TAU;

use super::description::TurbineDescription;
use super::error::TurbineError;
use super::frequencies::CoupledSpectrum;
use super::machine::Machine;
use super::root::Sample;
use super::validate::check;
use crate::beam::{
    BeamRecipe, BeamWorkspace, SpaceBeam, TopWorkspace, TurningBlade, assemble_in_space,
};
use crate::blade::Blade;
use crate::elements::{Borders, Mesh};
use crate::rotor::Multiblade;
use crate::subsystem::{Coefficients, Subsystem};
use crate::tower::{Rna, Tower, TowerDescription};

/// The highest polynomial degree of an element.
const MAX_DEGREE: usize = 60;

/// A turbine that can exist, on its tower; constant afterwards.
///
/// # Example
/// Three uniform blades on a uniform tower, at rest and at 12 rpm:
/// ```
/// use std::f64::consts::PI;
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
///     yaw_bearing_mass_kg: 0.0,
///     yaw_n_m_per_rad: f64::INFINITY,
///     overhang_m: -4.0,
///     tower_to_shaft_m: 2.0,
///     tilt_rad: -0.09,
///     hub: Hub { mass_kg: 2e4, polar_inertia_kg_m2: 5e4, ..Hub::default() },
///     shaft_n_m_per_rad: 5e8,
///     generator: Generator { inertia_kg_m2: 4e6, gear_ratio: 1.0, is_locked: true },
///     blades: 3,
///     cone_rad: 0.0,
///     blade: BladeDescription {
///         hub_radius_m: 2.0,
///         tip_radius_m: 52.0,
///         sections: vec![root, BladeSection { span: 1.0, ..root }],
///         borders: vec![0.0, 0.5, 1.0],
///         ..BladeDescription::default()
///     },
/// };
/// let tower = TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     ..TowerDescription::default()
/// };
/// let turbine = Turbine::new(tower, machine)?;
/// let mut model = TurbineModel::new(&turbine, &TurbineMesh::default())?;
/// for rpm in [0.0, 12.0] {
///     let spectrum = model.frequencies(2.0, rpm * PI / 30.0)?;
///     assert!(spectrum.is_complete);
///     assert_eq!(spectrum.frequencies.len(), model.count(2.0, rpm * PI / 30.0));
/// }
/// # Ok::<(), towermodes::turbine::TurbineError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Turbine {
    tower: Tower,
    blade: Blade,
    machine: TurbineDescription,
}

/// The elements of a turbine. The defaults suit frequencies up to the second bending modes of tower
/// and blades.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct TurbineMesh {
    /// Least number of elements of the tower, which also end at its steps, kinks and attachments.
    pub tower_elements: usize,
    /// Polynomial degree of their deflections.
    pub tower_degree: usize,
    /// Polynomial degree of the deflections of a blade's elements.
    pub blade_degree: usize,
}

impl Default for TurbineMesh {
    fn default() -> Self {
        Self {
            tower_elements: 2,
            tower_degree: 6,
            blade_degree: 3,
        }
    }
}

impl Turbine {
    /// Checks a tower and what it carries, and puts them together.
    ///
    /// # Errors
    /// [`TurbineError`] with the numbers of the first thing that no turbine can have.
    pub fn new(
        mut tower: TowerDescription,
        machine: TurbineDescription,
    ) -> Result<Self, TurbineError> {
        if !tower.rna.is_absent() {
            let mass_kg = tower.rna.mass_kg;
            return Err(TurbineError::TwoMachines { mass_kg });
        }
        let (blade, rna) = checked(&machine)?;
        // The weight of the machine compresses the tower; its inertia is that of its parts.
        tower.rna = rna;
        Ok(Self {
            tower: Tower::new(tower)?,
            blade,
            machine,
        })
    }

    /// The same for a tower whose rotor-nacelle assembly, a rigid body, stands for the turbine: it
    /// is left away.
    ///
    /// # Errors
    /// [`TurbineError`] with the numbers of the first thing that no turbine can have.
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

    /// What the tower carries.
    pub fn machine(&self) -> &TurbineDescription {
        &self.machine
    }
}

impl TurbineDescription {
    /// The turbine as a rigid body that does not turn, for towers without a turning rotor.
    ///
    /// # Errors
    /// [`TurbineError`] with the numbers of the first thing that no turbine can have.
    pub fn rna(&self) -> Result<Rna, TurbineError> {
        checked(self).map(|(_, rna)| rna)
    }
}

/// The blade of a turbine whose numbers are possible, and the whole as a rigid body.
fn checked(machine: &TurbineDescription) -> Result<(Blade, Rna), TurbineError> {
    check(machine)?;
    let blade = Blade::new(machine.blade.clone())?;
    let rotor = rotor(&blade, machine, 2)?;
    Ok((blade, Machine::new(machine, rotor).at_rest(machine)))
}

/// The rotor of a turbine, with blade elements of a degree.
fn rotor(
    blade: &Blade,
    machine: &TurbineDescription,
    degree: usize,
) -> Result<Multiblade<TurningBlade>, TurbineError> {
    let borders = borders(blade);
    let body = TurningBlade::new(blade, machine.cone_rad, &borders, degree);
    Ok(Multiblade::new(body, machine.blades)?)
}

/// The borders of a blade's elements and the places of its sections, as fractions of the span.
fn borders(blade: &Blade) -> Vec<f64> {
    let description = blade.description();
    let sections = description.sections.iter().map(|section| section.span);
    let mut all: Vec<f64> = sections
        .chain(description.borders.iter().copied())
        .collect();
    all.sort_by(f64::total_cmp);
    all.dedup();
    all
}

/// The equations of motion of a turbine on a mesh, with the memory to work on them:
///
/// H(w) = K + i w G − w² M,
///
/// Hermitian at any speed Ω of the rotor, in axes that do not turn.
pub struct TurbineModel {
    tower: SpaceBeam,
    machine: Machine,
    is_locked: bool,
    workspace: TopWorkspace,
}

impl std::fmt::Debug for TurbineModel {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("TurbineModel").finish_non_exhaustive()
    }
}

impl TurbineModel {
    /// The equations of a turbine.
    ///
    /// # Errors
    /// [`TurbineError`] if the mesh is impossible or if numbers overflow.
    pub fn new(turbine: &Turbine, mesh: &TurbineMesh) -> Result<Self, TurbineError> {
        check_mesh("the tower", mesh.tower_elements, mesh.tower_degree)?;
        check_mesh("a blade", 1, mesh.blade_degree)?;
        let (tower, machine) = (&turbine.tower, &turbine.machine);
        let recipe = BeamRecipe::Spectral {
            degree: mesh.tower_degree,
            rotary_inertia: true,
            shear: true,
        };
        let elements = Mesh::new(tower, Borders::Gradual, mesh.tower_elements);
        let mut beam = SpaceBeam::default();
        let attachments = tower.attachments_but_inertia_of_rna();
        let mut memory = BeamWorkspace::default();
        assemble_in_space(
            tower,
            &attachments,
            (&elements, recipe),
            &mut memory,
            &mut beam,
        );
        let rotor = rotor(&turbine.blade, machine, mesh.blade_degree)?;
        let is_finite = beam.members()[0].is_finite() && rotor.body().is_finite();
        if !is_finite {
            return Err(TurbineError::Overflow);
        }
        Ok(Self {
            tower: beam,
            machine: Machine::new(machine, rotor),
            is_locked: machine.generator.is_locked,
            workspace: TopWorkspace::default(),
        })
    }

    /// The number of negative eigenvalues of H at a frequency in Hz, which is not 0, and a speed of
    /// the rotor in rad/s.
    ///
    /// Where K is positive definite, this is the number of natural frequencies below; a free shaft
    /// adds 1, its rotation. Proof: where an eigenvalue of H vanishes, with the vector x, its
    /// derivative by w, times w, is −xᴴ (K + w² M) x < 0, so that each crosses zero downwards.
    /// Where the stiffness K, softened by the spin, is indefinite, modes with xᴴ (K + w² M) x < 0,
    /// of negative energy, cross upwards.
    pub fn count(&mut self, frequency_hz: f64, speed_rad_per_s: f64) -> usize {
        self.sample(TAU * frequency_hz, speed_rad_per_s).negative
    }

    /// The number of negative eigenvalues of the stiffness K with the generator locked, at a speed
    /// in rad/s: 0 unless the rotor turns faster than its blades vibrate.
    pub fn negative_stiffness(&mut self, speed_rad_per_s: f64) -> usize {
        self.eliminate(0.0, speed_rad_per_s, true).negative
    }

    /// The natural frequencies up to a limit (Hz) at a speed of the rotor (rad/s).
    ///
    /// # Errors
    /// [`TurbineError`] if limit or speed is no number.
    pub fn frequencies(
        &mut self,
        limit_hz: f64,
        speed_rad_per_s: f64,
    ) -> Result<CoupledSpectrum, TurbineError> {
        if !(limit_hz.is_finite() && limit_hz > 0.0) {
            return Err(TurbineError::Limit { limit_hz });
        }
        if !speed_rad_per_s.is_finite() {
            return Err(TurbineError::Speed { speed_rad_per_s });
        }
        Ok(CoupledSpectrum::of(self, TAU * limit_hz, speed_rad_per_s))
    }

    /// Whether the shaft turns freely.
    pub(super) fn turns_freely(&self) -> bool {
        !self.is_locked
    }

    /// Count and determinant of H at a frequency, rad/s.
    pub(super) fn sample(&mut self, w: f64, speed: f64) -> Sample {
        self.eliminate(w, speed, self.is_locked)
    }

    fn eliminate(&mut self, w: f64, speed: f64, is_locked: bool) -> Sample {
        let machine = self.machine.seen_from_top(w, speed, is_locked);
        let a = Coefficients::STIFFNESS.minus(w * w, Coefficients::MASS);
        let tower = &self.tower.members()[0];
        let (negative, log_pivots) = tower.eliminate_under(&a, machine.matrix, &mut self.workspace);
        Sample {
            w,
            negative: machine.negative + negative,
            log_determinant: machine.log_pivots + log_pivots,
        }
    }
}

fn check_mesh(part: &'static str, elements: usize, degree: usize) -> Result<(), TurbineError> {
    match elements > 0 && (2..=MAX_DEGREE).contains(&degree) {
        true => Ok(()),
        false => Err(TurbineError::Mesh {
            part,
            elements,
            degree,
            most: MAX_DEGREE,
        }),
    }
}
