//! A checked mooring system: lines between points of the ground, the platform and free parts.

use super::carrier::{Arm, Owner};
use super::check::check;
use super::description::{Attachment, Carrier, MooringDescription, RodEnd};
use super::error::{MooringError, MooringItem};
use super::line::Rope;
use super::pose::{Placement, Pose};
use super::vector::{Vector, difference, length, rotation_of_angles, sum};

/// A checked mooring system, which [`at`](Self::at) evaluates at any pose of the platform. It
/// cannot be changed.
///
/// # Example
/// The spar OC3-Hywind on its three lines: the stiffness in surge is 41.18 kN/m (Jonkman 2010).
/// ```
/// use towermodes::mooring::{
///     LineType, Mooring, MooringDescription, MooringLine, MooringPoint, Pose,
/// };
///
/// let mut spar = MooringDescription {
///     depth_m: 320.0,
///     line_types: vec![LineType::new(0.09, 77.7066, 384.243e6)],
///     ..MooringDescription::default()
/// };
/// for angle_deg in [0.0_f64, 120.0, 240.0] {
///     let (sin, cos) = angle_deg.to_radians().sin_cos();
///     let at = |radius: f64, z: f64| [radius * cos, radius * sin, z];
///     let anchor = spar.points.len();
///     spar.points.push(MooringPoint::anchor(at(853.87, -320.0)));
///     spar.points.push(MooringPoint::fairlead(at(5.2, -70.0)));
///     let points = [anchor, anchor + 1];
///     spar.lines.push(MooringLine { line_type: 0, length_m: 902.2, points });
/// }
/// let state = Mooring::new(spar)?.at(&Pose::default())?;
/// assert!((state.load.stiffness[0][0] - 41180.0).abs() < 10.0);
/// assert!((state.load.force[2] + 1.607e6).abs() < 1e3);
/// # Ok::<(), towermodes::mooring::MooringError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Mooring {
    /// The description with the depth of the seabed under the lines.
    pub(super) description: MooringDescription,
    /// The depth as it was given, m.
    pub(super) given_depth_m: f64,
    pub(super) ropes: Vec<Rope>,
    pub(super) ends: Vec<[Arm; 2]>,
    pub(super) points: Vec<Arm>,
    pub(super) bodies: Vec<Seat>,
    pub(super) rods: Vec<Seat>,
    pub(super) loads: Vec<Load>,
    pub(super) free: Vec<FreePart>,
    /// Number of unknowns of the free parts.
    pub(super) unknowns: usize,
}

/// A part that is held only by lines.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct FreePart {
    pub(super) item: MooringItem,
    /// Starting position of the search for its equilibrium.
    pub(super) start: Placement,
    /// Index of its first unknown.
    pub(super) first: usize,
    /// Whether it can rotate: it then has six unknowns, otherwise three.
    pub(super) turns: bool,
}

/// Weight and buoyancy at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Load {
    pub(super) arm: Arm,
    /// Buoyancy less weight, N.
    pub(super) up_n: f64,
}

/// The position of a point, body or rod on its owner.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Seat {
    pub(super) owner: Owner,
    /// Its position at the reference pose.
    pub(super) start: Placement,
    /// The origin of the platform, m.
    reference_m: Vector,
}

impl Seat {
    /// A point of it, given in its axes, on its owner.
    pub(super) fn arm(&self, local_m: Vector) -> Arm {
        let reached_m = || sum(self.start.origin_m, self.start.turned(local_m));
        let arm_m = match self.owner {
            Owner::Ground => reached_m(),
            Owner::Platform => difference(reached_m(), self.reference_m),
            Owner::Free(_) => local_m,
        };
        Arm {
            owner: self.owner,
            arm_m,
        }
    }
}

impl Mooring {
    /// The mooring system of a description from a file, whose depth may be that of another place:
    /// if all anchors are at one depth and nothing is below them, they are on the seabed, even if
    /// the given depth is greater. [`warnings`](Self::warnings) contain the difference.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn with_anchors_on_seabed(
        mut description: MooringDescription,
    ) -> Result<Self, MooringError> {
        let given_depth_m = description.depth_m;
        description.depth_m = description.depth_under_lines_m();
        let mooring = Self::new(description)?;
        Ok(Self {
            given_depth_m,
            ..mooring
        })
    }

    /// Checks a description and makes the mooring system of it.
    ///
    /// # Errors
    /// [`MooringError`] that describes the first invalid value.
    pub fn new(description: MooringDescription) -> Result<Self, MooringError> {
        check(&description)?;
        let given_depth_m = description.depth_m;
        let mut mooring = Self {
            given_depth_m,
            ropes: Vec::new(),
            ends: Vec::new(),
            points: Vec::new(),
            bodies: Vec::new(),
            rods: Vec::new(),
            loads: Vec::new(),
            free: Vec::new(),
            unknowns: 0,
            description,
        };
        mooring.seat_bodies();
        mooring.seat_rods();
        mooring.seat_points();
        mooring.hang_lines();
        let mut owners = mooring.ends.iter().flatten().map(|end| end.owner);
        match owners.any(|owner| owner == Owner::Platform) {
            true => Ok(mooring),
            false => Err(MooringError::NotAtPlatform),
        }
    }

    /// Its description, with the depth of the seabed under the lines.
    pub fn description(&self) -> &MooringDescription {
        &self.description
    }

    /// The platform at a pose.
    pub(super) fn platform(&self, pose: &Pose) -> Placement {
        Placement {
            origin_m: sum(self.description.reference_m, pose.displacement_m),
            rotation: pose.rotation,
        }
    }

    fn seat_bodies(&mut self) {
        for index in 0..self.description.bodies.len() {
            let body = self.description.bodies[index];
            let start = Placement {
                origin_m: body.position_m,
                rotation: rotation_of_angles(body.angles_rad),
            };
            let seat = self.seat(body.carrier, start, MooringItem::Body(index));
            self.bodies.push(seat);
            self.add_load(seat.arm(body.center_m), body.mass_kg, body.volume_m3);
        }
    }

    fn seat_rods(&mut self) {
        for index in 0..self.description.rods.len() {
            let rod = self.description.rods[index];
            let [a, b] = rod.ends_m;
            let start = Placement::at(std::array::from_fn(|i| 0.5 * (a[i] + b[i])));
            let seat = self.seat(rod.carrier, start, MooringItem::Rod(index));
            self.rods.push(seat);
            let length_m = length(difference(b, a));
            let area_m2 = std::f64::consts::FRAC_PI_4 * rod.diameter_m * rod.diameter_m;
            let middle = seat.arm([0.0; 3]);
            self.add_load(middle, rod.mass_kg_per_m * length_m, area_m2 * length_m);
        }
    }

    fn seat_points(&mut self) {
        for index in 0..self.description.points.len() {
            let point = self.description.points[index];
            let start = Placement::at(point.position_m);
            let at_origin = [0.0; 3];
            let held = |owner| self.fixed_seat(owner, start).arm(at_origin);
            let arm = match point.attachment {
                Attachment::Fixed => held(Owner::Ground),
                Attachment::Platform => held(Owner::Platform),
                Attachment::Free => self
                    .free_seat(start, MooringItem::Point(index), false)
                    .arm(at_origin),
                Attachment::Body(body) => self.bodies[body].arm(point.position_m),
                Attachment::Rod(rod, end) => self.rod_end(rod, end),
            };
            self.points.push(arm);
            self.add_load(arm, point.mass_kg, point.volume_m3);
        }
    }

    fn rod_end(&self, rod: usize, end: RodEnd) -> Arm {
        let [a, b] = self.description.rods[rod].ends_m;
        let half = match end {
            RodEnd::A => -0.5,
            RodEnd::B => 0.5,
        };
        self.rods[rod].arm(difference(b, a).map(|along_m| half * along_m))
    }

    fn hang_lines(&mut self) {
        for line in &self.description.lines {
            let kind = &self.description.line_types[line.line_type];
            self.ropes.push(Rope::new(line, kind, &self.description));
            self.ends.push(line.points.map(|point| self.points[point]));
        }
    }

    fn seat(&mut self, carrier: Carrier, start: Placement, item: MooringItem) -> Seat {
        match carrier {
            Carrier::Fixed => self.fixed_seat(Owner::Ground, start),
            Carrier::Platform => self.fixed_seat(Owner::Platform, start),
            Carrier::Free => self.free_seat(start, item, true),
        }
    }

    fn fixed_seat(&self, owner: Owner, start: Placement) -> Seat {
        let reference_m = self.description.reference_m;
        Seat {
            owner,
            start,
            reference_m,
        }
    }

    fn free_seat(&mut self, start: Placement, item: MooringItem, turns: bool) -> Seat {
        let owner = Owner::Free(self.free.len());
        let first = self.unknowns;
        self.unknowns += if turns { 6 } else { 3 };
        self.free.push(FreePart {
            item,
            start,
            first,
            turns,
        });
        self.fixed_seat(owner, start)
    }

    fn add_load(&mut self, arm: Arm, mass_kg: f64, volume_m3: f64) {
        let buoyant_kg = self.description.water_density_kg_per_m3 * volume_m3 - mass_kg;
        let up_n = buoyant_kg * self.description.gravity_m_per_s2;
        if up_n != 0.0 && arm.owner != Owner::Ground {
            self.loads.push(Load { arm, up_n });
        }
    }
}
