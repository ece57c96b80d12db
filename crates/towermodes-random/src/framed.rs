//! The modes of a random frame, without and with a tower: their estimated errors and their true
//! errors.

use towermodes::frame::{
    Frame, FrameDescription, FrameFoundation, FrameMode, FrameOptions, FrameRecipe, MemberKind,
    Transition, solve_frame,
};
use towermodes::{Method, Mode, Options, RigidBody, Solver};

use super::frames::{random_frame, tower_on};
use super::sample::Sample;
use super::seed::Seed;

/// The polynomial degree of the reference solution of a frame without tower.
const REFERENCE: usize = 24;
/// The increase of the polynomial degree in the reference solution of a tower on a frame.
const RAISED: usize = 4;
/// Number of modes.
const MODES: usize = 8;
/// Frames with lower frequencies are nearly mechanisms, whose frequencies depend mainly on the
/// springs of a hinge.
const SLOWEST_HZ: f64 = 0.02;
/// The relative rounding errors of the element integrals, which the estimated errors do not
/// include.
const ROUNDING: f64 = 1e-13;

/// The lowest modes of a random frame by [`solve_frame`], compared with elements of degree 24; none
/// if the frame is not valid, is a mechanism or has fewer modes.
pub fn frame_samples(number: u64) -> Option<Vec<Sample>> {
    let description = random_frame(&mut Seed::new(number));
    let frame = Frame::new(description).ok()?;
    let options = FrameOptions {
        modes: MODES,
        ..FrameOptions::default()
    };
    let found = solve_frame(&frame, &options).ok()?;
    if found.mechanism.is_some() {
        return None;
    }
    let truth = FrameOptions {
        recipe: Some(FrameRecipe::Spectral { degree: REFERENCE }),
        ..options
    };
    let truth = solve_frame(&frame, &truth).ok()?;
    let of = |mode: &FrameMode| {
        let claimed_hz = mode.error_hz + mode.discretization_error_hz;
        (mode.frequency_hz, claimed_hz)
    };
    let [found, truth] = [found, truth].map(|s| s.modes.iter().map(of).collect::<Vec<_>>());
    compared(number, 0, &found, &truth)
}

/// The lowest modes of a tower on a random frame by a method, compared with spectral elements of a
/// higher degree; none if the frame cannot carry the tower.
pub fn samples_on_frame(number: u64, method: Method, solver: &mut Solver) -> Option<Vec<Sample>> {
    let description = under_a_tower(random_frame(&mut Seed::new(number)))?;
    let frame = Frame::new(description.clone()).ok()?;
    FrameFoundation::new(frame, RigidBody::default()).ok()?;
    let tower = tower_on(description, RigidBody::default());
    let options = Options {
        method,
        modes: MODES,
        points: 2,
        ..Options::default()
    };
    let converged = Options {
        method: Method::Spectral,
        ..options.clone()
    };
    let found = solver.with(options, |solver| solver.solve(&tower)).ok()?;
    let first = solver
        .with(converged.clone(), |solver| solver.solve(&tower))
        .ok()?;
    let raised = Options {
        segments: Some(first.segments),
        degree: first.degree.map(|degree| degree + RAISED),
        ..converged
    };
    let truth = solver.with(raised, |solver| solver.solve(&tower)).ok()?;
    let of = |mode: &Mode| (mode.frequency_hz, mode.error_hz());
    let segments = found.segments;
    let [found, truth] = [found, truth].map(|s| s.modes.iter().map(of).collect::<Vec<_>>());
    compared(number, segments, &found, &truth)
}

/// The frame with its highest joint as the transition piece, if a deformable member is below it.
fn under_a_tower(mut frame: FrameDescription) -> Option<FrameDescription> {
    let height = |joint: &usize| frame.joints[*joint].position_m[2];
    let top = (2..frame.joints.len()).max_by(|a, b| height(a).total_cmp(&height(b)))?;
    let deforms = |kind: &MemberKind| matches!(kind, MemberKind::Beam { .. });
    let mut here = frame.members.iter().filter(|m| m.joints.contains(&top));
    here.any(|member| deforms(&member.kind)).then_some(())?;
    frame.transition = Some(Transition {
        position_m: frame.joints[top].position_m,
        joints: vec![top],
        is_held: false,
    });
    Some(frame)
}

/// Compares the modes in their order, because both lists are proved complete.
fn compared(
    tower: u64,
    segments: usize,
    found: &[(f64, f64)],
    truth: &[(f64, f64)],
) -> Option<Vec<Sample>> {
    let (slowest_hz, _) = truth.first()?;
    if *slowest_hz < SLOWEST_HZ {
        return None;
    }
    let mut samples = Vec::with_capacity(found.len());
    for ((frequency_hz, claimed_hz), (truth_hz, _)) in found.iter().zip(truth) {
        let difference_hz = (frequency_hz - truth_hz).abs();
        samples.push(Sample {
            tower,
            mode: samples.len() + 1,
            segments,
            frequency_hz: *frequency_hz,
            claimed_hz: *claimed_hz,
            true_hz: (difference_hz - ROUNDING * frequency_hz).max(0.0),
            is_warned: false,
        });
    }
    Some(samples)
}
