//! A floating tower as one rigid body under weights and buoyancy.

use super::super::description::TowerDescription;
use super::super::frame::FrameFoundation;
use super::super::parts::floating_platform::{FloatingPlatform, ReferredMatrix};
use super::super::parts::rigid_body::RigidBody;
use super::super::pieces::integrals::weight_integrals;
use super::super::pieces::piece::Piece;
use super::super::support::base::symmetrized;
use super::mistake::EquilibriumError;
use crate::mooring::{MooringError, Pose};
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};

/// A platform with the tower and masses on it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Afloat {
    pub(super) platform: FloatingPlatform,
    pub(super) gravity_m_per_s2: f64,
    pub(super) tower: Mass,
    pub(super) rna: Mass,
    /// The position at which the stiffness of its lines is evaluated; none for its reference
    /// position.
    pub(super) at: Option<Result<Pose, EquilibriumError>>,
    /// The platform with its lines replaced by their stiffness there; none for a neighbour that is
    /// beyond the last that they can reach.
    pub(crate) linear: Option<FloatingPlatform>,
}

/// A mass at a position relative to the tower's axis, in the datum of the stations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Mass {
    pub(super) mass_kg: f64,
    pub(super) center_m: [f64; 3],
}

/// Loads of constant direction: force (N) and moment (N m) about the reference point, and the
/// stiffness for its motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Loads {
    pub(super) force: [f64; 6],
    pub(super) stiffness: SpatialMatrix,
}

impl Afloat {
    /// The tower of a description with its pieces at its reference position, if it floats.
    pub(super) fn of(description: &TowerDescription, pieces: &[Piece]) -> Option<Self> {
        let mut platform = description.foundation.floating()?.clone();
        if let Some(frame) = description.foundation.frame() {
            carry_transition_piece(&mut platform, frame);
        }
        let top_m = pieces.last()?.top_m;
        let [x, y, z] = description.rna.center_m;
        Some(Self {
            platform,
            gravity_m_per_s2: description.gravity_m_per_s2,
            tower: tower(description, pieces),
            rna: Mass {
                mass_kg: description.rna.mass_kg,
                center_m: [x, y, top_m + z],
            },
            at: None,
            linear: None,
        })
    }

    /// Why the lines cannot be at the equilibrium, where they should be.
    pub(crate) fn mistake(&self) -> Option<EquilibriumError> {
        self.at.as_ref()?.as_ref().err().copied()
    }

    /// The height of the reference point of the hydrostatic stiffness on the tower's axis, m.
    pub(super) fn reference_m(&self) -> f64 {
        self.platform.hydrostatic.height_m
    }

    /// The platform with its lines replaced by their stiffness where they have it.
    pub(super) fn linearized(&self) -> Result<FloatingPlatform, MooringError> {
        match &self.at {
            Some(Ok(pose)) => self.platform.with_moorings_at(pose, self.reference_m()),
            _ => self.platform.with_linear_moorings(),
        }
    }

    /// Adds the hydrostatic stiffness and the stiffness of the lines to a floating frame.
    pub(in crate::tower) fn hold(&self, frame: &mut FrameFoundation) {
        let pose = match &self.at {
            Some(Ok(pose)) => *pose,
            _ => Pose::default(),
        };
        // The lines were checked; a neighbour beyond the last that they can reach has none.
        let lines = self.platform.mooring_lines.as_ref();
        let fairleads = lines.map(|lines| lines.fairleads(self.reference_m(), &pose));
        let fairleads = fairleads.and_then(Result::ok).unwrap_or_default();
        let linear = self.linear.as_ref().unwrap_or(&self.platform);
        frame.hold(linear, &fairleads, self.gravity_m_per_s2);
    }

    pub(super) fn platform_mass(&self) -> Mass {
        Mass {
            mass_kg: self.platform.mass_kg,
            center_m: self.platform.center_m,
        }
    }

    pub(super) fn weight_n(&self, mass: Mass) -> f64 {
        mass.mass_kg * self.gravity_m_per_s2
    }

    /// Weights, buoyancy with its stiffness, and moorings that are given as a matrix, which have no
    /// force; none if the buoyancy is not known.
    pub(super) fn loads(&self) -> Option<Loads> {
        let buoyancy = self.platform.buoyancy?;
        let mut loads = Loads::default();
        for mass in [self.platform_mass(), self.tower, self.rna] {
            let [x, y, z] = mass.center_m;
            loads.add(-self.weight_n(mass), [x, y, z - self.reference_m()]);
        }
        let [x, y] = buoyancy.center_m;
        loads.push(buoyancy.force_n, [x, y, 0.0]);
        for referred in [&self.platform.hydrostatic, &self.platform.mooring] {
            loads.stiffen(referred, self.reference_m());
        }
        Some(loads)
    }
}

/// Adds the body of the transition piece to the mass of a frame that floats.
fn carry_transition_piece(platform: &mut FloatingPlatform, frame: &FrameFoundation) {
    let [x, y, z] = frame.platform.center_m;
    let [.., reference_m] = frame.reference_m();
    let whole = RigidBody::combined(&[
        RigidBody {
            mass_kg: platform.mass_kg,
            center_m: platform.center_m,
            ..RigidBody::default()
        },
        RigidBody {
            center_m: [x, y, z + reference_m],
            ..frame.platform
        },
    ]);
    (platform.mass_kg, platform.center_m) = (whole.mass_kg, whole.center_m);
}

/// The tower with its point masses.
fn tower(description: &TowerDescription, pieces: &[Piece]) -> Mass {
    let of_pieces = pieces.iter().map(|piece| {
        let (mass_kg, moment) = weight_integrals(piece, piece.base_m, piece.top_m, piece.base_m);
        (mass_kg, moment + mass_kg * piece.base_m)
    });
    let points = description.point_masses.iter();
    let points = points.map(|mass| (mass.mass_kg, mass.mass_kg * mass.height_m));
    let (mass_kg, moment) = of_pieces
        .chain(points)
        .fold((0.0, 0.0), |sum, next| (sum.0 + next.0, sum.1 + next.1));
    let height_m = if mass_kg > 0.0 { moment / mass_kg } else { 0.0 };
    Mass {
        mass_kg,
        center_m: [0.0, 0.0, height_m],
    }
}

impl Loads {
    /// Adds an upward force (N) at an arm (m) without its stiffness.
    fn push(&mut self, up_n: f64, [x, y, _]: [f64; 3]) {
        self.force[2] += up_n;
        self.force[3] += y * up_n;
        self.force[4] -= x * up_n;
    }

    /// Adds an upward force (N) of constant direction at an arm (m) of the body, whose stiffness
    /// is (F·r) 1 − ½ (r Fᵀ + F rᵀ) against rotation.
    fn add(&mut self, up_n: f64, arm_m: [f64; 3]) {
        self.push(up_n, arm_m);
        let [x, y, z] = arm_m.map(|arm| up_n * arm);
        let stiffness = &mut self.stiffness;
        stiffness[3][3] += z;
        stiffness[4][4] += z;
        for (i, half) in [(3, 0.5 * x), (4, 0.5 * y)] {
            stiffness[i][5] -= half;
            stiffness[5][i] -= half;
        }
    }

    fn stiffen(&mut self, referred: &ReferredMatrix, height_m: f64) {
        let mut matrix = symmetrized(&referred.matrix);
        transform_matrix(&mut matrix, referred.height_m - height_m);
        add_scaled(&mut self.stiffness, 1.0, &matrix);
    }
}
