//! The elastic energy of a mode by parts of the turbine.

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

/// Both waves together tilt or yaw the nacelle if this fraction of their energy does.
const CLEARLY: f64 = 2.0 / 3.0;

/// How a blade deflects.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum BladeMotion {
    /// Bending normal to the chord (flapwise), mostly downwind.
    Flap,
    /// Bending along the chord (edgewise), mostly in the plane of the rotor.
    Edge,
    /// Twist about the axis of the blade.
    Torsion,
    /// Extension along the axis of the blade.
    Axial,
}

/// The phase of the deflections from blade to blade: a harmonic of multiblade coordinates.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Harmonic {
    /// All blades deflect equally.
    Collective,
    /// A wave that runs around the rotor with the rotation.
    Forward,
    /// A wave that runs around the rotor against the rotation.
    Backward,
    /// A wave of this many periods around the rotor, 2 or more, with the rotation; it does not move
    /// the hub. Only rotors of more than three blades have it.
    ForwardOf(usize),
    /// A wave of this many periods around the rotor, 2 or more, against the rotation; it does not
    /// move the hub. Only rotors of more than three blades have it.
    BackwardOf(usize),
    /// Neighbouring blades deflect in opposite directions; only rotors with an even number of
    /// blades, 4 or more, have it.
    Alternating,
}

/// How a mode of the blades moves the nacelle, if its forward and backward waves together mostly
/// tilt or mostly yaw it, as at standstill.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Nodding {
    /// The blades tilt the nacelle: flapwise deflections vary as the cosine of the azimuth (0 is
    /// up), edgewise deflections as its sine.
    Tilt,
    /// The blades yaw the nacelle: flapwise deflections vary as the sine of the azimuth, edgewise
    /// deflections as its cosine.
    Yaw,
}

/// A part of a turbine that stores elastic energy.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum TurbinePart {
    /// A floating platform in one of its six motions, surge to yaw, with mooring, water and
    /// gravity.
    Platform(Family),
    /// Local motion of members of the frame below a tower, for example of braces between their
    /// joints. The energy of the frame that follows the motion of the tower is counted with the
    /// tower.
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

/// Energies of the blades in one motion, by harmonic; see [`TurbineEnergy::blades`].
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct BladeEnergy {
    /// All blades deflect equally.
    pub collective: f64,
    /// Energy of the wave that runs with the rotation.
    pub forward: f64,
    /// Energy of the wave that runs against the rotation.
    pub backward: f64,
    /// Energy of the combination of both waves that tilts the nacelle; `tilt + yaw = forward +
    /// backward`.
    pub tilt: f64,
    /// Energy of the combination of both waves that yaws the nacelle.
    pub yaw: f64,
}

/// Elastic energies of a mode by parts. None is negative at any speed: gyroscopic and centrifugal
/// forces are not among them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct TurbineEnergy {
    /// A floating platform in surge, sway, heave, roll, pitch and yaw, with mooring, water and
    /// gravity.
    pub platform: [f64; 6],
    /// The frame below the tower in its motion relative to the transition piece: its elastic energy
    /// less the energy of its static deformation by the motion of the transition piece.
    pub substructure: f64,
    /// Bending of the tower downwind, with the soil and the foundation: for a frame also the energy
    /// of its static deformation by the motion of the transition piece.
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
    /// All motions, in the order of [`TurbineEnergy::blades`].
    pub const ALL: [Self; 4] = [Self::Flap, Self::Edge, Self::Torsion, Self::Axial];

    /// Name of the motion: "flapwise", "edgewise", "blade torsion", "blade axial".
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
    /// The sum over all harmonics.
    pub fn total(&self) -> f64 {
        self.collective + self.forward + self.backward
    }

    /// The energies of backward wave, forward wave and collective harmonic, in this order.
    pub fn parts(&self) -> [(Harmonic, f64); 3] {
        [
            (Harmonic::Backward, self.backward),
            (Harmonic::Forward, self.forward),
            (Harmonic::Collective, self.collective),
        ]
    }

    /// The energy of both waves, forward and backward.
    pub fn asymmetric(&self) -> f64 {
        self.forward + self.backward
    }

    /// How both waves together move the nacelle: tilt or yaw, if at least two thirds of their
    /// energy are in one of these; otherwise none.
    pub fn nodding(&self) -> Option<Nodding> {
        let (nodding, more) = match self.tilt >= self.yaw {
            true => (Nodding::Tilt, self.tilt),
            false => (Nodding::Yaw, self.yaw),
        };
        (more >= CLEARLY * (self.tilt + self.yaw)).then_some(nodding)
    }
}

impl TurbineEnergy {
    /// The energies as fractions of their sum.
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

    /// The sum over all parts.
    pub fn total(&self) -> f64 {
        let blades = self.blades.iter().map(BladeEnergy::total);
        self.stationary().map(|(_, energy)| energy).sum::<f64>() + blades.sum::<f64>()
    }

    /// The energy of each part, in the order of the variants of [`TurbinePart`]; the blades by
    /// harmonic.
    pub fn parts(&self) -> Vec<(TurbinePart, f64)> {
        let blades = BladeMotion::ALL.iter().zip(&self.blades);
        let blades = blades.flat_map(|(motion, energy)| {
            let of = |(harmonic, energy)| (TurbinePart::Blades(*motion, harmonic), energy);
            energy.parts().map(of)
        });
        self.stationary().chain(blades).collect()
    }

    /// The energy of a part.
    pub fn of(&self, part: TurbinePart) -> f64 {
        let own = self.parts().into_iter().filter(|(other, _)| *other == part);
        own.map(|(_, energy)| energy).sum()
    }

    /// How the two whirls of a motion of the blades together move the nacelle; none for other
    /// parts.
    pub fn nodding_of(&self, part: TurbinePart) -> Option<Nodding> {
        let TurbinePart::Blades(motion, Harmonic::Backward | Harmonic::Forward) = part else {
            return None;
        };
        let place = BladeMotion::ALL.iter().position(|other| *other == motion)?;
        self.blades[place].nodding()
    }

    /// The energy of the tower and of the floating platform or the frame below it.
    pub fn of_tower(&self) -> f64 {
        let bending = self.tower_fore_aft + self.tower_side_side;
        self.platform.iter().sum::<f64>()
            + self.substructure
            + bending
            + self.tower_torsion
            + self.tower_axial
    }

    /// The energies by part, without the blades: platform, frame, tower, yaw drive, shaft.
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
