//! A mooring system at a pose of the platform.

use std::array::from_fn;

use super::carrier::Owner;
use super::equilibrium::Search;
use super::error::{MooringError, MooringItem};
use super::line::Hung;
use super::pose::{Placement, Pose};
use super::system::{Mooring, Seat};
use super::vector::{difference, length, product, rotation_vector, sum, transposed};
use crate::space::SpatialMatrix;

/// Largest strain of a rope: nylon breaks at about 0.4.
const MOST_STRETCH: f64 = 0.5;

/// What a mooring system does to the platform at a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MooringLoad {
    /// Force (N) and moment about the displaced reference point (N m): lines, and weight and
    /// buoyancy of what is fixed to the platform.
    pub force: [f64; 6],
    /// Stiffness −∂F/∂u for a displacement (m) and a rotation vector (rad) of the displaced
    /// reference point, in fixed axes (N/m, N, N m); free points, bodies and rods follow in
    /// equilibrium. It is that of the energy, hence symmetric: the derivative of the moment in
    /// fixed axes differs from it by half the skew matrix of the moment, which other loads balance
    /// at the equilibrium of the platform.
    pub stiffness: SpatialMatrix,
}

/// A mooring system at a pose of the platform.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct MooringState {
    /// What it does to the platform.
    pub load: MooringLoad,
    /// The lines, in the order of the description.
    pub lines: Vec<LineState>,
    /// Positions of the points, m.
    pub points_m: Vec<[f64; 3]>,
    /// The bodies.
    pub bodies: Vec<BodyState>,
    /// The rods, by their middle.
    pub rods: Vec<BodyState>,
}

/// A line at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LineState {
    /// The force of the line on the point at each end, N.
    pub forces_n: [[f64; 3]; 2],
    /// Tension at each end, N.
    pub tensions_n: [f64; 2],
    /// Horizontal tension H at the upper end, N; for a line lighter than water at the lower end.
    pub horizontal_n: f64,
    /// Vertical tension V at the same end, N: downwards on the end; upwards for a line lighter than
    /// water.
    pub vertical_n: f64,
    /// Length on the seabed, m.
    pub on_seabed_m: f64,
    /// Lowest height of the line, m; for a line lighter than water, the greatest height.
    pub extreme_z_m: f64,
    /// Whether it has no horizontal tension: it lies loosely on the seabed, or has no weight and is
    /// longer than the distance of its ends.
    pub is_slack: bool,
}

/// Where a body or a rod is.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BodyState {
    /// Position of the origin of a body, or of the middle of a rod, m.
    pub position_m: [f64; 3],
    /// Rotation vector from where the description has it, in fixed axes, rad.
    pub rotation_rad: [f64; 3],
}

/// Memory for [`Mooring::load`]; evaluations after the first one allocate nothing.
#[derive(Debug, Clone, Default)]
pub struct MooringWorkspace {
    search: Search,
}

impl Mooring {
    /// Force and stiffness at a pose, computed in reused memory.
    ///
    /// # Errors
    /// As [`Self::at`].
    pub fn load(
        &self,
        pose: &Pose,
        workspace: &mut MooringWorkspace,
    ) -> Result<MooringLoad, MooringError> {
        let platform = self.platform(pose);
        let search = &mut workspace.search;
        search.run(self, &platform)?;
        self.check_lengths(&platform, &search.free)?;
        self.check_depths(&platform, &search.free)?;
        let (n, stiffness) = (self.unknowns, &search.assembly.stiffness);
        let size = stiffness.size;
        Ok(MooringLoad {
            force: from_fn(|i| search.assembly.force[n + i]),
            stiffness: from_fn(|i| {
                from_fn(|j| stiffness.matrix[(n + i.max(j)) * size + n + i.min(j)])
            }),
        })
    }

    /// Positions along each line in a state of this system, m: at least `count` (1 or more) for
    /// each line, from its first end to its second end.
    pub fn places_m(&self, state: &MooringState, count: usize) -> Vec<Vec<[f64; 3]>> {
        let lines = self.ropes.iter().zip(&self.description.lines);
        let places = lines.map(|(rope, line)| {
            let ends_m = line.points.map(|point| state.points_m[point]);
            rope.places(ends_m, count.max(1))
        });
        places.collect()
    }

    /// The mooring system at a pose.
    ///
    /// # Errors
    /// [`MooringError`] if a line cannot reach or a free part has no stable equilibrium above the
    /// seabed.
    pub fn at(&self, pose: &Pose) -> Result<MooringState, MooringError> {
        let mut workspace = MooringWorkspace::default();
        let load = self.load(pose, &mut workspace)?;
        let (platform, free) = (self.platform(pose), &workspace.search.free);
        let body = |seat: &Seat| seat.state(self.description.reference_m, &platform, free);
        let (ropes, hung) = (&self.ropes, &workspace.search.assembly.hung);
        let lines = ropes
            .iter()
            .zip(&self.ends)
            .zip(hung)
            .map(|((rope, ends), hung)| {
                let ends_m = ends.map(|end| end.reached(&platform, free).position_m);
                LineState::new(hung, rope.extreme_z_m(ends_m, hung.profile.sag_m))
            });
        let points_m = self
            .points
            .iter()
            .map(|arm| arm.reached(&platform, free).position_m);
        Ok(MooringState {
            load,
            lines: lines.collect(),
            points_m: points_m.collect(),
            bodies: self.bodies.iter().map(body).collect(),
            rods: self.rods.iter().map(body).collect(),
        })
    }

    fn check_lengths(&self, platform: &Placement, free: &[Placement]) -> Result<(), MooringError> {
        for (line, ends) in self.ends.iter().enumerate() {
            let [a, b] = ends.map(|end| end.reached(platform, free).position_m);
            let (distance_m, length_m) = (
                length(difference(b, a)),
                self.description.lines[line].length_m,
            );
            if distance_m > (1.0 + MOST_STRETCH) * length_m {
                let most = MOST_STRETCH;
                return Err(MooringError::TooShort {
                    line,
                    length_m,
                    distance_m,
                    most,
                });
            }
        }
        Ok(())
    }

    /// Checks that points that move are above the seabed.
    fn check_depths(&self, platform: &Placement, free: &[Placement]) -> Result<(), MooringError> {
        let depth_m = self.description.depth_m;
        for (index, arm) in self.points.iter().enumerate() {
            let z_m = arm.reached(platform, free).position_m[2];
            let item = MooringItem::Point(index);
            match arm.owner {
                Owner::Free(_) if z_m < -depth_m => {
                    return Err(MooringError::Sinks { item, z_m, depth_m });
                }
                Owner::Platform if z_m < -depth_m => {
                    return Err(MooringError::UnderSeabed { item, z_m, depth_m });
                }
                Owner::Ground | Owner::Platform | Owner::Free(_) => {}
            }
        }
        Ok(())
    }
}

impl LineState {
    fn new(hung: &Hung, extreme_z_m: f64) -> Self {
        let profile = &hung.profile;
        Self {
            forces_n: hung.forces_n,
            tensions_n: hung.forces_n.map(length),
            horizontal_n: profile.horizontal_n,
            vertical_n: profile.upper_n,
            on_seabed_m: profile.on_seabed_m,
            extreme_z_m,
            is_slack: profile.is_slack,
        }
    }
}

impl Seat {
    fn state(&self, reference_m: [f64; 3], platform: &Placement, free: &[Placement]) -> BodyState {
        let (position_m, turned) = match self.owner {
            Owner::Ground => {
                return BodyState {
                    position_m: self.start.origin_m,
                    rotation_rad: [0.0; 3],
                };
            }
            Owner::Platform => {
                let arm_m = difference(self.start.origin_m, reference_m);
                (
                    sum(platform.origin_m, platform.turned(arm_m)),
                    platform.rotation,
                )
            }
            Owner::Free(index) => {
                let now = &free[index];
                (
                    now.origin_m,
                    product(&now.rotation, &transposed(&self.start.rotation)),
                )
            }
        };
        BodyState {
            position_m,
            rotation_rad: rotation_vector(&turned),
        }
    }
}
