//! Computed values of frames and moorings, by quantity.

use towermodes::frame::{
    Frame, FrameDescription, FrameOptions, FrameRecipe, FrameSolveError, count_frame_modes,
    solve_frame, static_stiffness,
};
use towermodes::mooring::{Mooring, MooringDescription, MooringState, Pose};

use crate::expected::{Expected, Hanging, Quantity};

type Matrix = [[f64; 6]; 6];

/// Degree of the elements for mechanisms, whose frequencies are found by eigenvalue counts.
const DEGREE: usize = 10;

/// Mass and frequencies of a frame.
pub(crate) struct FoundFrame {
    mass_kg: f64,
    /// Number of motions without stiffness.
    still: usize,
    frequencies_hz: Vec<f64>,
    /// Stiffness at the transition piece, if the case expects it.
    stiffness: Option<Matrix>,
}

impl FoundFrame {
    /// Solves a frame for as many modes as are expected.
    pub(crate) fn of(
        description: &FrameDescription,
        recipe: Option<FrameRecipe>,
        expected: &[Expected],
    ) -> Result<Self, String> {
        let modes = expected.iter().map(|expected| match expected.quantity {
            Quantity::Lowest(place) => place,
            _ => 1,
        });
        let modes = modes.max().unwrap_or(1);
        let frame = Frame::new(description.clone()).map_err(|error| error.to_string())?;
        let options = FrameOptions {
            modes,
            recipe,
            ..FrameOptions::default()
        };
        let solution = solve_frame(&frame, &options).map_err(|error| error.to_string())?;
        let (still, frequencies_hz) = match &solution.mechanism {
            Some(FrameSolveError::Mechanism { modes: still, .. }) => {
                let recipe = recipe.unwrap_or(FrameRecipe::Spectral { degree: DEGREE });
                let places = still + 1..=modes;
                let counted = places.map(|place| by_counts(&frame, recipe, place));
                let mut frequencies = vec![0.0; *still];
                frequencies.extend(counted.collect::<Result<Vec<_>, _>>()?);
                (*still, frequencies)
            }
            Some(error) => return Err(error.to_string()),
            None => {
                let modes = solution.modes.iter();
                (0, modes.map(|mode| mode.frequency_hz).collect())
            }
        };
        let is_stiffness =
            |expected: &Expected| matches!(expected.quantity, Quantity::Stiffness(..));
        let stiffness = expected
            .iter()
            .any(is_stiffness)
            .then(|| at_transition(&frame));
        Ok(Self {
            mass_kg: frame.mass_kg(),
            still,
            frequencies_hz,
            stiffness: stiffness.transpose()?,
        })
    }

    /// A computed value of the frame.
    pub(crate) fn get(&self, quantity: Quantity) -> Option<f64> {
        match quantity {
            Quantity::Lowest(place) => self.frequencies_hz.get(place - 1).copied(),
            Quantity::Mass => Some(self.mass_kg),
            Quantity::MotionsWithoutStiffness => Some(self.still as f64),
            Quantity::Stiffness(i, j) => self.stiffness.map(|matrix| matrix[i][j]),
            Quantity::Mode(..)
            | Quantity::BucklingLoadFactor
            | Quantity::Weight
            | Quantity::ForceLeft
            | Quantity::Force(_)
            | Quantity::Tension(..)
            | Quantity::Place(..) => None,
        }
    }
}

/// The stiffness of a frame at the reference point of its transition piece (Guyan 1965): the
/// stiffness K of a joint, transformed over the rigid arm r by Tᵀ K T, where T t is the motion of
/// the joint.
fn at_transition(frame: &Frame) -> Result<Matrix, String> {
    let description = frame.description();
    let transition = description.transition.as_ref();
    let transition = transition.ok_or("it has no transition piece")?;
    let joint = transition.joints.first().ok_or("it holds no joint")?;
    let at_joint = static_stiffness(frame, *joint).map_err(|error| error.to_string())?;
    let (at, reference) = (description.joints[*joint].position_m, transition.position_m);
    let [x, y, z]: [f64; 3] = std::array::from_fn(|i| at[i] - reference[i]);
    let mut carried: Matrix = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
    (carried[0][4], carried[0][5]) = (z, -y);
    (carried[1][3], carried[1][5]) = (-z, x);
    (carried[2][3], carried[2][4]) = (y, -x);
    let entry = |i: usize, j: usize| {
        let terms = (0..36).map(|k| (k / 6, k % 6));
        terms
            .map(|(k, l)| carried[k][i] * at_joint[k][l] * carried[l][j])
            .sum()
    };
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| entry(i, j))
    }))
}

/// The frequency of a mode of a mechanism, Hz: the frequency at which the number of modes below it
/// reaches the index of the mode.
fn by_counts(frame: &Frame, recipe: FrameRecipe, place: usize) -> Result<f64, String> {
    let is_below = |hz: f64| {
        let count = count_frame_modes(frame, recipe, hz).map_err(|error| error.to_string());
        count.map(|count| count >= place)
    };
    let (mut low, mut high) = (0.0, 1.0);
    while !is_below(high)? {
        (low, high) = (high, 2.0 * high);
    }
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if is_below(middle)? {
            high = middle;
        } else {
            low = middle;
        }
    }
    Ok(high)
}

/// A mooring system at its reference pose.
pub(crate) fn at_rest(description: &MooringDescription) -> Result<MooringState, String> {
    let mooring = Mooring::new(description.clone()).map_err(|error| error.to_string())?;
    let state = mooring.at(&Pose::default());
    state.map_err(|error| error.to_string())
}

/// A value of a mooring system.
pub(crate) fn of_mooring(state: &MooringState, quantity: Quantity) -> Option<f64> {
    match quantity {
        Quantity::Stiffness(i, j) => Some(state.load.stiffness[i][j]),
        Quantity::Force(i) => Some(state.load.force[i]),
        Quantity::Tension(line, is_vertical) => {
            let line = state.lines.get(line - 1)?;
            Some(if is_vertical {
                line.vertical_n
            } else {
                line.horizontal_n
            })
        }
        Quantity::Place(Hanging::Point(point), axis) => {
            state.points_m.get(point - 1)?.get(axis).copied()
        }
        Quantity::Place(part, axis) => {
            let part = match part {
                Hanging::Rod(rod) => state.rods.get(rod - 1)?,
                Hanging::Body(part) | Hanging::Point(part) => state.bodies.get(part - 1)?,
            };
            match axis {
                0..3 => Some(part.position_m[axis]),
                _ => part.rotation_rad.get(axis - 3).copied(),
            }
        }
        Quantity::Mode(..)
        | Quantity::Lowest(_)
        | Quantity::BucklingLoadFactor
        | Quantity::Mass
        | Quantity::Weight
        | Quantity::ForceLeft
        | Quantity::MotionsWithoutStiffness => None,
    }
}
