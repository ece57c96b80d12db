//! Where the energy of a mode is, by parts of the turbine.

use crate::modes::Family;

/// The motions of a platform, in the order of [`TurbineEnergy::platform`].
const PLATFORM: [Family; 6] = [
    Family::Surge,
    Family::Sway,
    Family::Heave,
    Family::Roll,
    Family::Pitch,
    Family::Yaw,
];

/// Both waves tilt or yaw the nacelle if so much of their energy does.
const CLEARLY: f64 = 2.0 / 3.0;

/// How a blade deflects.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BladeMotion {
    /// Bending normal to the chord (flapwise), mostly downwind.
    Flap,
    /// Bending along the chord (edgewise), mostly in the plane of the rotor.
    Edge,
    /// Twist about its axis.
    Torsion,
    /// Along its axis.
    Axial,
}

/// How the deflections of the blades of a rotor follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Harmonic {
    /// All alike.
    Collective,
    /// A wave that runs around the rotor with the rotation.
    Forward,
    /// A wave that runs around the rotor against the rotation.
    Backward,
    /// A wave of this many periods around the rotor, 2 or more, with the rotation; it does not move
    /// the hub. Only rotors of more than three blades have it.
    ForwardOf(usize),
    /// The same against the rotation.
    BackwardOf(usize),
    /// Neighbours against each other, in a rotor with an even number of blades, 4 or more.
    Alternating,
}

/// What a mode of the blades does to the nacelle if both waves are alike, as at standstill.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Nodding {
    /// The forces of the blades tilt the nacelle: flap as the cosine of the azimuth, edge as its
    /// sine.
    Tilt,
    /// They yaw it.
    Yaw,
}

/// A part of a turbine that stores elastic energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TurbinePart {
    /// A floating platform in one of its six motions, surge to yaw, with mooring, water and
    /// gravity.
    Platform(Family),
    /// Members of the frame below a tower that move by themselves, as braces between their joints;
    /// what the frame has as it follows the tower is with the tower.
    Substructure,
    /// Bending of the tower downwind, with the soil and the foundation.
    TowerForeAft,
    /// Bending of the tower sideways, with the soil and the foundation.
    TowerSideSide,
    /// Torsion of the tower, with the foundation.
    TowerTorsion,
    /// Stretch of the tower, with the foundation.
    TowerAxial,
    /// The yaw drive.
    YawDrive,
    /// The shaft: torsion of the drivetrain.
    Shaft,
    /// The blades.
    Blades(BladeMotion, Harmonic),
}

/// Energies of the blades in one motion.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BladeEnergy {
    /// All alike.
    pub collective: f64,
    /// With the rotation.
    pub forward: f64,
    /// Against the rotation.
    pub backward: f64,
    /// Of what tilts the nacelle; `tilt + yaw = forward + backward`.
    pub tilt: f64,
    /// Of what yaws the nacelle.
    pub yaw: f64,
}

/// Elastic energies of a mode by parts. None is negative at any speed: gyroscopic and centrifugal
/// forces are not among them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TurbineEnergy {
    /// A floating platform in surge, sway, heave, roll, pitch and yaw, with mooring, water and
    /// gravity.
    pub platform: [f64; 6],
    /// Of the frame below the tower with its transition piece held: the elastic energy less that of
    /// a frame which follows the transition piece at rest.
    pub substructure: f64,
    /// Bending of the tower downwind, with the soil and the foundation: for a frame the energy as
    /// it follows the tower.
    pub tower_fore_aft: f64,
    /// Bending of the tower sideways, with the soil and the foundation.
    pub tower_side_side: f64,
    /// Torsion of the tower.
    pub tower_torsion: f64,
    /// Stretch of the tower.
    pub tower_axial: f64,
    /// The yaw drive.
    pub yaw_drive: f64,
    /// The shaft.
    pub shaft: f64,
    /// The blades by their motion: flap, edge, torsion, axial.
    pub blades: [BladeEnergy; 4],
}

impl BladeMotion {
    /// All, in the order of [`TurbineEnergy::blades`].
    pub const ALL: [Self; 4] = [Self::Flap, Self::Edge, Self::Torsion, Self::Axial];

    /// Its name: "flapwise", "edgewise", "blade torsion", "blade axial".
    pub fn name(self) -> &'static str {
        match self {
            Self::Flap => "flapwise",
            Self::Edge => "edgewise",
            Self::Torsion => "blade torsion",
            Self::Axial => "blade axial",
        }
    }
}

impl BladeEnergy {
    /// Of all harmonics.
    pub fn total(&self) -> f64 {
        self.collective + self.forward + self.backward
    }

    /// By harmonic.
    pub fn parts(&self) -> [(Harmonic, f64); 3] {
        [
            (Harmonic::Backward, self.backward),
            (Harmonic::Forward, self.forward),
            (Harmonic::Collective, self.collective),
        ]
    }

    /// Of both waves.
    pub fn asymmetric(&self) -> f64 {
        self.forward + self.backward
    }

    /// Whether both waves together tilt or yaw the nacelle: if so at least two thirds of their
    /// energy are in one of the two.
    pub fn nodding(&self) -> Option<Nodding> {
        let (nodding, more) = match self.tilt >= self.yaw {
            true => (Nodding::Tilt, self.tilt),
            false => (Nodding::Yaw, self.yaw),
        };
        (more >= CLEARLY * (self.tilt + self.yaw)).then_some(nodding)
    }
}

impl TurbineEnergy {
    /// Fractions of the sum of all.
    pub(super) fn as_fractions(mut self) -> Self {
        let total = self.total();
        if total > 0.0 {
            self.scale(1.0 / total);
        }
        self
    }

    fn scale(&mut self, factor: f64) {
        let Self {
            platform,
            substructure,
            tower_fore_aft,
            tower_side_side,
            tower_torsion,
            tower_axial,
            yaw_drive,
            shaft,
            blades,
        } = self;
        let own = [
            substructure,
            tower_fore_aft,
            tower_side_side,
            tower_torsion,
            tower_axial,
            yaw_drive,
            shaft,
        ];
        let blades = blades.iter_mut().flat_map(|blade| {
            let BladeEnergy {
                collective,
                forward,
                backward,
                tilt,
                yaw,
            } = blade;
            [collective, forward, backward, tilt, yaw]
        });
        own.into_iter()
            .chain(platform)
            .chain(blades)
            .for_each(|energy| *energy *= factor);
    }

    /// Of all parts.
    pub fn total(&self) -> f64 {
        let blades = self.blades.iter().map(BladeEnergy::total);
        self.stationary().map(|(_, energy)| energy).sum::<f64>() + blades.sum::<f64>()
    }

    /// By part, in the order of the parts of the turbine.
    pub fn parts(&self) -> Vec<(TurbinePart, f64)> {
        let blades = BladeMotion::ALL.iter().zip(&self.blades);
        let blades = blades.flat_map(|(motion, energy)| {
            let of = |(harmonic, energy)| (TurbinePart::Blades(*motion, harmonic), energy);
            energy.parts().map(of)
        });
        self.stationary().chain(blades).collect()
    }

    /// What the two whirls of a motion together do to the nacelle; none of other parts.
    pub fn nodding_of(&self, part: TurbinePart) -> Option<Nodding> {
        let TurbinePart::Blades(motion, Harmonic::Backward | Harmonic::Forward) = part else {
            return None;
        };
        let place = BladeMotion::ALL.iter().position(|other| *other == motion)?;
        self.blades[place].nodding()
    }

    /// Of the tower and what it stands on: a floating platform, a frame.
    pub fn of_tower(&self) -> f64 {
        let bending = self.tower_fore_aft + self.tower_side_side;
        self.platform.iter().sum::<f64>()
            + self.substructure
            + bending
            + self.tower_torsion
            + self.tower_axial
    }

    /// By part, without the blades: platform, frame, tower, yaw drive, shaft.
    pub(super) fn stationary(&self) -> impl Iterator<Item = (TurbinePart, f64)> {
        let platform = PLATFORM
            .map(TurbinePart::Platform)
            .into_iter()
            .zip(self.platform);
        platform.chain([
            (TurbinePart::Substructure, self.substructure),
            (TurbinePart::TowerForeAft, self.tower_fore_aft),
            (TurbinePart::TowerSideSide, self.tower_side_side),
            (TurbinePart::TowerTorsion, self.tower_torsion),
            (TurbinePart::TowerAxial, self.tower_axial),
            (TurbinePart::YawDrive, self.yaw_drive),
            (TurbinePart::Shaft, self.shaft),
        ])
    }
}
