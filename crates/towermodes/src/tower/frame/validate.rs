//! The checks of the description of a frame.

use super::super::error::Problem;
use super::super::parts::material::Material;
use super::super::parts::rigid_body::RigidBody;
use super::super::pieces::section::Tube;
use super::super::validate::inertia::{indefinite, negative_inertia};
use super::axes::{Axes, are_orthonormal, difference, member_axes, norm};
use super::coat::{CoatKind, FrameCoat};
use super::description::{FrameDescription, FrameRider, FrameSupport, JointKind};
use super::error::{FrameError, FramePlace, FrameProblem};
use super::member::{FrameMember, MemberKind, Rectangle, SectionEnds};
use super::soil::FrameSoil;
use crate::space::SpatialMatrix;

/// The largest magnitude of a coordinate, m: beyond it coordinates have no correct digit of a wall
/// thickness.
const FARTHEST_M: f64 = 1e5;
/// The largest modulus, Pa: 5e8 times the modulus of steel. Beyond it the stiffness of the tower
/// has no correct digit.
const STIFFEST_PA: f64 = 1e20;
/// Relative difference of the entries of a matrix that is symmetric but for rounding.
const SYMMETRIC: f64 = 1e-6;

/// A checked frame, which cannot be changed.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    description: FrameDescription,
}

impl Frame {
    /// Checks a description.
    ///
    /// # Errors
    /// [`FrameError`]: the first impossible value, with its place.
    pub fn new(description: FrameDescription) -> Result<Self, FrameError> {
        check(&description)?;
        Ok(Self { description })
    }

    /// Checks the frame again after a change of its input values.
    ///
    /// # Errors
    /// [`FrameError`]: the first impossible value, with its place.
    pub(crate) fn check(&self) -> Result<(), FrameError> {
        check(&self.description)
    }

    /// A frame with slightly changed values, without checks.
    pub(crate) fn unchecked(description: FrameDescription) -> Self {
        Self { description }
    }

    /// The description of the frame for a change; it must be checked again.
    pub(super) fn numbers_mut(&mut self) -> &mut FrameDescription {
        &mut self.description
    }

    /// The description that was checked.
    pub fn description(&self) -> &FrameDescription {
        &self.description
    }

    /// Length of a member, m.
    pub fn length_m(&self, member: &FrameMember) -> f64 {
        let [from, to] = member.joints.map(|j| self.description.joints[j].position_m);
        norm(difference(to, from))
    }

    /// The axes of a member as rows x, y, z, with z from its first joint to its second.
    pub fn axes(&self, member: &FrameMember) -> [[f64; 3]; 3] {
        let [from, to] = member.joints.map(|j| self.description.joints[j].position_m);
        member_axes(from, to, member.spin_deg)
    }

    /// Mass of members, masses on joints and soil at the supports, kg.
    pub fn mass_kg(&self) -> f64 {
        let description = &self.description;
        let members = description.members.iter().map(|m| self.member_mass_kg(m));
        let masses = description.masses.iter().map(|(_, body)| body.mass_kg);
        let soil = description.supports.iter().map(|s| s.inertia[0][0]);
        members.sum::<f64>() + masses.sum::<f64>() + soil.sum::<f64>()
    }

    /// Whether any support has a stiffness, or any member has soil springs.
    pub(crate) fn has_soil(&self) -> bool {
        let mut supports = self.description.supports.iter();
        let mut members = self.description.members.iter();
        supports.any(|support| support.stiffness != [[0.0; 6]; 6])
            || members.any(|member| !member.soil.is_empty())
    }

    /// Multiplies the stiffness of all supports and of the soil around members.
    pub(crate) fn multiply_soil(&mut self, factor: f64) {
        for support in &mut self.description.supports {
            let entries = support.stiffness.iter_mut().flatten();
            entries.for_each(|entry| *entry *= factor);
        }
        let members = self.description.members.iter_mut();
        let soil = members.flat_map(|member| &mut member.soil);
        soil.for_each(|soil| soil.multiply(factor));
    }

    /// Mass of a member with growth and water in it, kg.
    pub fn member_mass_kg(&self, member: &FrameMember) -> f64 {
        let length_m = self.length_m(member);
        match &member.kind {
            MemberKind::Beam { ends, material } => {
                // A = π t (d − t) is quadratic along the member: Simpson's rule is exact.
                let at = |s| ends.at(s, material).masses.mass_kg_per_m;
                let own_kg = length_m * (at(0.0) + 4.0 * at(0.5) + at(1.0)) / 6.0;
                let coats = member.coats.iter().map(|coat| coat.mass_kg(length_m));
                own_kg + coats.sum::<f64>()
            }
            MemberKind::Cable {
                axial_n,
                mass_kg_per_m,
                pretension_n,
            } => mass_kg_per_m * length_m / (1.0 + pretension_n / axial_n),
            MemberKind::Rigid { mass_kg_per_m } => mass_kg_per_m * length_m,
            MemberKind::Spring(_) => 0.0,
        }
    }
}

fn check(description: &FrameDescription) -> Result<(), FrameError> {
    if description.members.is_empty() || description.joints.len() < 2 {
        return Err(at(FramePlace::Frame, FrameProblem::Empty));
    }
    check_joints(description)?;
    for (index, member) in description.members.iter().enumerate() {
        let place = || FramePlace::Member(index, member.name.clone());
        check_member(description, member).map_err(|problem| at(place(), problem))?;
    }
    check_ends(description)?;
    for (index, support) in description.supports.iter().enumerate() {
        check_support(description, index, support)?;
    }
    for (index, (joint, body)) in description.masses.iter().enumerate() {
        let name = joint_name(description, *joint);
        let place = || FramePlace::Mass(index, name.clone());
        check_mass(description, *joint, body).map_err(|problem| at(place(), problem))?;
    }
    for (index, (joint, matrix)) in description.added_masses.iter().enumerate() {
        let place = || FramePlace::AddedMass(index, joint_name(description, *joint));
        let checked = existing(description, *joint).and_then(|()| check_inertia(matrix));
        checked.map_err(|problem| at(place(), problem))?;
    }
    for rider in &description.riders {
        check_rider(description, rider)?;
    }
    check_transition(description).map_err(|problem| at(FramePlace::Transition, problem))?;
    check_connected(description)
}

fn at(place: FramePlace, problem: FrameProblem) -> FrameError {
    FrameError { place, problem }
}

fn joint_name(description: &FrameDescription, joint: usize) -> String {
    let found = description.joints.get(joint);
    found.map_or_else(|| joint.to_string(), |joint| joint.name.clone())
}

fn finite(quantity: &'static str, value: f64) -> Result<(), FrameProblem> {
    match value.is_finite() {
        true => Ok(()),
        false => Err(Problem::NotFinite { quantity, value }.into()),
    }
}

fn positive(quantity: &'static str, unit: &'static str, value: f64) -> Result<(), FrameProblem> {
    finite(quantity, value)?;
    match value > 0.0 {
        true => Ok(()),
        false => Err(Problem::NotPositive {
            quantity,
            value,
            unit,
        }
        .into()),
    }
}

fn not_negative(
    quantity: &'static str,
    unit: &'static str,
    value: f64,
) -> Result<(), FrameProblem> {
    finite(quantity, value)?;
    match value >= 0.0 {
        true => Ok(()),
        false => Err(Problem::Negative {
            quantity,
            value,
            unit,
        }
        .into()),
    }
}

fn check_joints(description: &FrameDescription) -> Result<(), FrameError> {
    let mut names = std::collections::HashSet::new();
    for (index, joint) in description.joints.iter().enumerate() {
        let place = || FramePlace::Joint(index, joint.name.clone());
        if !names.insert(&joint.name) {
            return Err(at(place(), FrameProblem::NameTwice));
        }
        for value in joint.position_m {
            coordinate(value).map_err(|problem| at(place(), problem))?;
        }
        let stiffness = match joint.kind {
            JointKind::Cantilever => continue,
            JointKind::Pin {
                axis,
                stiffness_n_m_per_rad,
            } => {
                for value in axis {
                    finite("axis", value).map_err(|problem| at(place(), problem))?;
                }
                if norm(axis) == 0.0 {
                    return Err(at(place(), FrameProblem::NoAxis));
                }
                stiffness_n_m_per_rad
            }
            JointKind::Universal {
                stiffness_n_m_per_rad,
            }
            | JointKind::Ball {
                stiffness_n_m_per_rad,
            } => stiffness_n_m_per_rad,
        };
        not_negative("stiffness", " N m/rad", stiffness).map_err(|problem| at(place(), problem))?;
    }
    Ok(())
}

fn coordinate(value: f64) -> Result<(), FrameProblem> {
    finite("coordinate", value)?;
    match value.abs() <= FARTHEST_M {
        true => Ok(()),
        false => Err(Problem::OutOfScale {
            quantity: "coordinate",
            value,
            unit: " m",
            least: 0.0,
            most: FARTHEST_M,
        }
        .into()),
    }
}

fn existing(description: &FrameDescription, joint: usize) -> Result<(), FrameProblem> {
    let joints = description.joints.len();
    match joint < joints {
        true => Ok(()),
        false => Err(FrameProblem::NoJoint { joint, joints }),
    }
}

fn check_member(description: &FrameDescription, member: &FrameMember) -> Result<(), FrameProblem> {
    for joint in member.joints {
        existing(description, joint)?;
    }
    let [from, to] = member.joints.map(|j| description.joints[j].position_m);
    let length_m = norm(difference(to, from));
    finite("spin", member.spin_deg)?;
    member.coats.iter().try_for_each(check_coat)?;
    let is_beam = matches!(member.kind, MemberKind::Beam { .. });
    let mut soil = member.soil.iter();
    soil.try_for_each(|soil| check_soil(soil, is_beam))?;
    let may_be_short = match &member.kind {
        MemberKind::Beam { ends, material } => {
            check_material(material)?;
            check_section(ends)?;
            false
        }
        MemberKind::Cable {
            axial_n,
            mass_kg_per_m,
            pretension_n,
        } => {
            positive("axial stiffness", " N", *axial_n)?;
            not_negative("mass per length", " kg/m", *mass_kg_per_m)?;
            finite("pretension", *pretension_n)?;
            if *pretension_n < 0.0 {
                let pretension_n = *pretension_n;
                return Err(FrameProblem::SlackCable { pretension_n });
            }
            false
        }
        MemberKind::Rigid { mass_kg_per_m } => {
            not_negative("mass per length", " kg/m", *mass_kg_per_m)?;
            member.joints[0] != member.joints[1]
        }
        MemberKind::Spring(spring) => {
            check_stiffness(&spring.stiffness)?;
            if let Some(axes) = &spring.axes {
                check_axes(axes)?;
            }
            spring.axes.is_some() && member.joints[0] != member.joints[1]
        }
    };
    match length_m > 0.0 || may_be_short {
        true => Ok(()),
        false => Err(FrameProblem::NoLength { length_m }),
    }
}

fn check_rider(description: &FrameDescription, rider: &FrameRider) -> Result<(), FrameError> {
    let Some(member) = description.members.get(rider.member) else {
        let (member, members) = (rider.member, description.members.len());
        let problem = FrameProblem::NoMemberNumber { member, members };
        return Err(at(FramePlace::Frame, problem));
    };
    let is_beam = matches!(member.kind, MemberKind::Beam { .. });
    let fraction = rider.fraction;
    let checked = match is_beam && (0.0..=1.0).contains(&fraction) {
        true => check_inertia(&rider.inertia),
        false => Err(FrameProblem::RiderPlace { fraction }),
    };
    let place = || FramePlace::Member(rider.member, member.name.clone());
    checked.map_err(|problem| at(place(), problem))
}

fn check_coat(coat: &FrameCoat) -> Result<(), FrameProblem> {
    let [from, to] = coat.range;
    if !(from >= 0.0 && from < to && to <= 1.0) {
        return Err(FrameProblem::CoatRange { range: coat.range });
    }
    let pairs = match coat.kind {
        CoatKind::Solid {
            density_kg_per_m3,
            outer_radius_m,
            inner_radius_m,
        } => vec![density_kg_per_m3, outer_radius_m, inner_radius_m],
        CoatKind::AddedMass {
            density_kg_per_m3,
            radius_m,
            across,
            along,
        } => vec![[density_kg_per_m3; 2], radius_m, across, along],
    };
    let mut values = pairs.into_iter().flatten();
    values.try_for_each(|value| not_negative("value of water or growth", "", value))
}

fn check_soil(soil: &FrameSoil, is_beam: bool) -> Result<(), FrameProblem> {
    let fractions: Vec<f64> = soil.rows.iter().map(|row| row.fraction).collect();
    let ends = [0, fractions.len().saturating_sub(1)].map(|row| fractions.get(row).copied());
    let [Some(from), Some(to)] = ends else {
        return Err(FrameProblem::SoilRows);
    };
    let rises = fractions.windows(2).all(|pair| pair[0] <= pair[1]);
    if !(is_beam && rises && from >= 0.0 && from < to && to <= 1.0) {
        return Err(FrameProblem::SoilRows);
    }
    let mut values = soil.rows.iter().flat_map(|row| row.stiffness.values());
    values.try_for_each(|value| not_negative("spring of the soil", "", value))
}

fn check_material(material: &Material) -> Result<(), FrameProblem> {
    let (youngs_modulus_pa, shear_modulus_pa) =
        (material.youngs_modulus_pa, material.shear_modulus_pa);
    not_negative("density", " kg/m³", material.density_kg_per_m3)?;
    modulus("Young's modulus", youngs_modulus_pa)?;
    modulus("shear modulus", shear_modulus_pa)
}

fn modulus(quantity: &'static str, value: f64) -> Result<(), FrameProblem> {
    positive(quantity, " Pa", value)?;
    match value <= STIFFEST_PA {
        true => Ok(()),
        false => Err(Problem::OutOfScale {
            quantity,
            value,
            unit: " Pa",
            least: 0.0,
            most: STIFFEST_PA,
        }
        .into()),
    }
}

fn check_section(ends: &SectionEnds) -> Result<(), FrameProblem> {
    match ends {
        SectionEnds::Tube(ends) => ends.iter().try_for_each(check_tube),
        SectionEnds::Rectangle(ends) => ends.iter().try_for_each(check_rectangle),
        SectionEnds::Given(given) => {
            positive("area", " m²", given.area_m2)?;
            let [shear_x, shear_y] = given.shear_areas_m2;
            positive("shear area", " m²", shear_x)?;
            positive("shear area", " m²", shear_y)?;
            let [about_x, about_y] = given.second_moments_m4;
            positive("second moment of area", " m⁴", about_x)?;
            positive("second moment of area", " m⁴", about_y)?;
            not_negative("polar moment of area", " m⁴", given.polar_m4)?;
            positive("torsion constant", " m⁴", given.torsion_m4)
        }
    }
}

fn check_tube(tube: &Tube) -> Result<(), FrameProblem> {
    let (width_m, wall_m) = (tube.outer_diameter_m, tube.wall_thickness_m);
    positive("diameter", " m", width_m)?;
    positive("wall", " m", wall_m)?;
    match wall_m <= 0.5 * width_m {
        true => Ok(()),
        false => Err(FrameProblem::WallTooThick { wall_m, width_m }),
    }
}

fn check_rectangle(rectangle: &Rectangle) -> Result<(), FrameProblem> {
    let (a_m, b_m) = (rectangle.side_a_m, rectangle.side_b_m);
    positive("side", " m", a_m)?;
    positive("side", " m", b_m)?;
    let (wall_m, width_m) = (rectangle.wall_thickness_m, a_m.min(b_m));
    not_negative("wall", " m", wall_m)?;
    match wall_m < 0.5 * width_m {
        true => Ok(()),
        false => Err(FrameProblem::WallTooThick { wall_m, width_m }),
    }
}

fn check_matrix(name: &'static str, matrix: &SpatialMatrix) -> Result<(), FrameProblem> {
    let size = matrix.iter().flatten().fold(0.0_f64, |a, x| a.max(x.abs()));
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.iter().enumerate() {
            finite(name, *entry)?;
            let other = matrix[j][i];
            if (entry - other).abs() > SYMMETRIC * size {
                return Err(FrameProblem::NotSymmetric {
                    matrix: name,
                    row: i + 1,
                    column: j + 1,
                    entry: *entry,
                    other,
                });
            }
        }
    }
    Ok(())
}

/// Checks that a matrix is symmetric and has no negative eigenvalues.
fn check_stiffness(matrix: &SpatialMatrix) -> Result<(), FrameProblem> {
    check_matrix(STIFFNESS, matrix)?;
    match indefinite(STIFFNESS, matrix) {
        Some(problem) => Err(problem.into()),
        None => Ok(()),
    }
}

/// A symmetric matrix without negative masses and moments of inertia. Couplings may be too large
/// for a body: files of soil have them without the moments of inertia.
fn check_inertia(matrix: &SpatialMatrix) -> Result<(), FrameProblem> {
    check_matrix(INERTIA, matrix)?;
    for (i, row) in matrix.iter().enumerate() {
        let unit = if i < 3 { " kg" } else { " kg m2" };
        not_negative("inertia", unit, row[i])?;
    }
    Ok(())
}

const STIFFNESS: &str = "stiffness";
const INERTIA: &str = "inertia";

fn check_axes(axes: &Axes) -> Result<(), FrameProblem> {
    match are_orthonormal(axes) {
        true => Ok(()),
        false => Err(FrameProblem::Axes),
    }
}

/// Checks that each joint has members, and a universal joint has two.
fn check_ends(description: &FrameDescription) -> Result<(), FrameError> {
    let mut ends = vec![0; description.joints.len()];
    for member in &description.members {
        for joint in member.joints {
            ends[joint] += 1;
        }
    }
    for (index, joint) in description.joints.iter().enumerate() {
        let place = || FramePlace::Joint(index, joint.name.clone());
        match joint.kind {
            _ if ends[index] == 0 => return Err(at(place(), FrameProblem::NoMember)),
            JointKind::Universal { .. } if ends[index] != 2 => {
                let members = ends[index];
                return Err(at(place(), FrameProblem::UniversalMembers { members }));
            }
            _ => {}
        }
    }
    Ok(())
}

fn welded(
    description: &FrameDescription,
    joint: usize,
    what: &'static str,
) -> Result<(), FrameProblem> {
    existing(description, joint)?;
    match is_welded(description, joint) {
        true => Ok(()),
        false => Err(FrameProblem::MustBeWelded { what }),
    }
}

fn is_welded(description: &FrameDescription, joint: usize) -> bool {
    match description.joints[joint].kind {
        JointKind::Cantilever => true,
        JointKind::Pin { .. } | JointKind::Universal { .. } | JointKind::Ball { .. } => false,
    }
}

fn check_support(
    description: &FrameDescription,
    index: usize,
    support: &FrameSupport,
) -> Result<(), FrameError> {
    let place = || FramePlace::Support(index, joint_name(description, support.joint));
    let checked = existing(description, support.joint)
        .and_then(|()| match is_welded(description, support.joint) {
            true => Ok(()),
            false => Err(FrameProblem::SupportOnHinge),
        })
        .and_then(|()| check_stiffness(&support.stiffness))
        .and_then(|()| check_inertia(&support.inertia));
    checked.map_err(|problem| at(place(), problem))?;
    let before = &description.supports[..index];
    match before.iter().any(|other| other.joint == support.joint) {
        true => Err(at(place(), FrameProblem::SupportedTwice)),
        false => Ok(()),
    }
}

fn check_mass(
    description: &FrameDescription,
    joint: usize,
    body: &RigidBody,
) -> Result<(), FrameProblem> {
    welded(description, joint, "a mass")?;
    not_negative("mass", " kg", body.mass_kg)?;
    for value in body.center_m {
        finite("centre of mass", value)?;
    }
    for value in body.inertia_kg_m2.tensor().as_flattened() {
        finite("inertia", *value)?;
    }
    match negative_inertia(&body.inertia_kg_m2) {
        Some(problem) => Err(problem.into()),
        None => Ok(()),
    }
}

fn check_transition(description: &FrameDescription) -> Result<(), FrameProblem> {
    let Some(transition) = &description.transition else {
        return Ok(());
    };
    for value in transition.position_m {
        coordinate(value)?;
    }
    let joints = &transition.joints;
    let is_twice = |(i, joint)| joints[..i].contains(joint);
    if joints.is_empty() || joints.iter().enumerate().any(is_twice) {
        return Err(FrameProblem::TransitionJoints);
    }
    for joint in joints {
        welded(description, *joint, "the transition piece")?;
        if description.supports.iter().any(|s| s.joint == *joint) {
            let joint = joint_name(description, *joint);
            return Err(FrameProblem::SupportedAndMoved { joint });
        }
    }
    Ok(())
}

/// Checks that all joints are connected, by members or the transition piece.
fn check_connected(description: &FrameDescription) -> Result<(), FrameError> {
    let mut group: Vec<usize> = (0..description.joints.len()).collect();
    let of_members = description.members.iter().map(|member| member.joints);
    let transition = description.transition.iter();
    let of_transition = transition.flat_map(|t| t.joints.iter().map(|j| [t.joints[0], *j]));
    for [a, b] in of_members.chain(of_transition) {
        let (a, b) = (root(&mut group, a), root(&mut group, b));
        group[a] = b;
    }
    let first = root(&mut group, 0);
    for joint in 0..group.len() {
        if root(&mut group, joint) != first {
            let (joint, other) = (joint_name(description, 0), joint_name(description, joint));
            let problem = FrameProblem::NotConnected { joint, other };
            return Err(at(FramePlace::Frame, problem));
        }
    }
    Ok(())
}

/// The root of the group of a joint, with the path to it shortened.
fn root(group: &mut [usize], joint: usize) -> usize {
    let mut at = joint;
    while group[at] != at {
        group[at] = group[group[at]];
        at = group[at];
    }
    at
}
