//! The component of a mode that is drawn, and the check whether side-side modes equal fore-aft
//! modes.

use towermodes::tower::Motion;
use towermodes::{Family, Mode, Plane, ShapePoint};

/// Shapes of an equal pair differ by at most this.
const EQUAL_SHAPE: f64 = 1e-6;
/// Frequencies of an equal pair differ by at most this, relatively.
const EQUAL_FREQUENCY: f64 = 1e-9;

/// A component of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Part {
    /// Translation fore-aft.
    X,
    /// Translation side-side.
    Y,
    /// Translation upwards.
    Z,
    /// Rotation about the tower's axis.
    RotationZ,
}

impl Part {
    /// The component by which the modes of a family are normalised.
    pub fn main(family: Family) -> Self {
        match family.motion() {
            // Of a mode of the substructure the tower does little.
            Some(Motion::Bending(Plane::ForeAft)) | None => Self::X,
            Some(Motion::Bending(Plane::SideSide)) => Self::Y,
            Some(Motion::Axial) => Self::Z,
            Some(Motion::Torsion) => Self::RotationZ,
        }
    }

    /// Its value at a height.
    pub fn of(self, point: &ShapePoint) -> f64 {
        match self {
            Self::X => point.translation[0],
            Self::Y => point.translation[1],
            Self::Z => point.translation[2],
            Self::RotationZ => point.rotation[2],
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
            Self::Z => "z",
            Self::RotationZ => "rotation z",
        }
    }
}

/// A motion with a smaller share of a mode's energy is not drawn, because it would be a straight
/// line at zero.
const NOTABLE: f64 = 1e-3;

/// The components that take part in a coupled mode, according to its energy; if it has no energy,
/// x, y and the rotation about z.
pub(super) fn coupled_parts(mode: &Mode) -> Vec<Part> {
    let mean = mode.energy.mean();
    let shares = [
        (Part::X, mean.fore_aft),
        (Part::Y, mean.side_side),
        (Part::Z, mean.axial),
        (Part::RotationZ, mean.torsion),
    ];
    let notable = shares.iter().filter(|(_, share)| *share >= NOTABLE);
    let parts: Vec<Part> = notable.map(|(part, _)| *part).collect();
    match parts.is_empty() {
        true => vec![Part::X, Part::Y, Part::RotationZ],
        false => parts,
    }
}

/// Whether a side-side mode equals a fore-aft mode: frequencies and curves are the same.
pub(super) fn is_turned(fore_aft: &Mode, side_side: &Mode) -> bool {
    let (a, b) = (fore_aft.frequency_hz, side_side.frequency_hz);
    let points = fore_aft.shape.iter().zip(&side_side.shape);
    let mut differences = points.map(|(a, b)| (Part::X.of(a) - Part::Y.of(b)).abs());
    (a - b).abs() <= EQUAL_FREQUENCY * a.max(b) && differences.all(|it| it <= EQUAL_SHAPE)
}

/// Its name for panels with modes of several families: "1st fore-aft".
pub(super) fn short_name(mode: &Mode) -> String {
    match mode.family.is_rigid() {
        true => order(mode),
        false => format!("{} {}", order(mode), mode.family.name()),
    }
}

/// Its order in its family, "1st"; for a rigid-body mode its name.
pub(super) fn order(mode: &Mode) -> String {
    let label = mode.label();
    if mode.family.is_rigid() {
        return label;
    }
    label.split(' ').next().unwrap_or_default().to_owned()
}
