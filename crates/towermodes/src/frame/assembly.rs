//! The equations of a frame from its description.

use std::collections::HashMap;

use super::element::Element;
use super::equations::{Chord, ELASTIC, Equations, GROUND, INERTIA, KINDS, Link};
use super::error::FrameSolveError;
use super::graph::{Branch, Edge, EdgeKind, Graph, Node};
use super::hinge::{Hinge, UNIT, spring};
use super::parts::Parts;
use super::recipe::{FrameRecipe, Stretch};
use super::rigid::{self, Motion, NONE, Vector, identity, rigid_transfer};
use super::shape::{Sample, sampled};
use super::tension::{ForcesAtRest, Tension};
use super::turning_over::RigidLink;
use crate::beam::MemberElement;
use crate::space::{SpatialMatrix, add_scaled};
use crate::tower::frame::{Frame, FrameMember, JointKind, MemberKind};
use crate::tower::{RigidBody, spatial_inertia};

/// The weight of rigid links and hinges in the graph: less than the weight of any element.
const LOOSE: f64 = -3.0;
const RIGID: f64 = -2.0;
const HINGED: f64 = -1.0;

/// Two nodes and their positions, m.
type Ends = ([Node; 2], [Vector; 2]);

/// The equations of a frame, and the places of its parts in them.
pub(super) struct Assembled {
    pub(super) equations: Equations,
    /// The node of each joint; none for the ground.
    pub(super) joints: Vec<Node>,
    /// The node of the transition piece.
    pub(super) transition: Node,
    /// The positions of the nodes, m.
    pub(super) positions_m: Vec<Vector>,
    /// The joint at each node, or the joint where the member of the node begins.
    pub(super) joint_of_node: Vec<usize>,
    /// The elements of beams.
    pub(super) elements: Vec<PlacedElement>,
    /// The rigid links.
    pub(super) rigid_links: Vec<RigidLink>,
    /// The tension in the elements, by index of the edge.
    pub(super) tensions: Vec<(usize, Tension)>,
    /// Points of the elements.
    pub(super) samples: Vec<Sample>,
}

/// The place of an element in the equations.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct PlacedElement {
    /// Index of its edge in the graph, the same for each frame with the same members.
    pub(super) edge: usize,
    pub(super) member: usize,
    /// Its ends, as fractions of the member.
    pub(super) from: f64,
    pub(super) to: f64,
    pub(super) carrier: Carrier,
    /// Whether the link runs from the end to the beginning.
    pub(super) reversed: bool,
}

/// A link or a chord, by place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Carrier {
    Link(usize),
    Chord(usize),
}

/// The purpose of the equations.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Purpose {
    /// Modes and their shapes.
    Shapes,
    /// Frequencies alone: without samples of the shapes.
    Frequencies,
    /// The motions of the nodes at rest: without samples, and in uniform members with no more
    /// polynomials than move the nodes. The others are only coupled with these by inertia.
    Rest,
}

/// Makes the equations of a frame with its forces at rest.
///
/// # Errors
/// [`FrameSolveError`]: an impossible recipe, or rigid links in a loop that holds nothing.
pub(super) fn assemble(
    frame: &Frame,
    recipe: FrameRecipe,
    forces: &ForcesAtRest,
    purpose: Purpose,
) -> Result<Assembled, FrameSolveError> {
    made(Assembly::new(frame, recipe, purpose), forces)
}

/// As [`assemble`], with the six motions of the transition piece as the first unknowns: chords
/// connect it with the ground and with the parts above it, so that all other unknowns can be
/// eliminated before it.
///
/// # Errors
/// [`FrameSolveError`]: as before, or a transition piece that a support holds rigidly.
pub(super) fn assemble_below_transition(
    frame: &Frame,
    recipe: FrameRecipe,
    forces: &ForcesAtRest,
    purpose: Purpose,
) -> Result<Assembled, FrameSolveError> {
    let mut assembly = Assembly::new(frame, recipe, purpose);
    assembly.has_loose_transition = true;
    made(assembly, forces)
}

fn made(mut assembly: Assembly<'_>, forces: &ForcesAtRest) -> Result<Assembled, FrameSolveError> {
    assembly.recipe.check()?;
    assembly = assembly.with_tensions(&forces.tensions);
    assembly.place_joints();
    assembly.place_members();
    let joints = assembly.joints.clone();
    let transition = assembly.transition;
    let positions_m = assembly.graph.positions_m.clone();
    let joint_of_node = assembly.graph.joints.clone();
    let (mut equations, elements, rigid_links, samples) = assembly.equations()?;
    equations.turn_over(&rigid_links, &forces.turning);
    Ok(Assembled {
        positions_m,
        joint_of_node,
        equations,
        elements,
        rigid_links,
        tensions: forces.tensions.clone(),
        samples,
        joints,
        transition,
    })
}

/// Equations, the places of their elements and rigid links, and points of members.
type MadeEquations = (Equations, Vec<PlacedElement>, Vec<RigidLink>, Vec<Sample>);

pub(super) struct Assembly<'a> {
    frame: &'a Frame,
    recipe: FrameRecipe,
    purpose: Purpose,
    graph: Graph,
    joints: Vec<Node>,
    transition: Node,
    /// Whether the transition piece has six unknowns for its motion.
    has_loose_transition: bool,
    /// The node of each end of each member.
    ends: Vec<[Node; 2]>,
    memory: MemberElement,
    /// Chords that are not elements, without bubbles.
    matrices: Vec<Chord>,
    /// The tension in elements, by edge.
    tensions: HashMap<usize, Tension>,
    /// Points of the elements.
    samples: Vec<Sample>,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(frame: &'a Frame, recipe: FrameRecipe, purpose: Purpose) -> Self {
        Self {
            frame,
            recipe,
            purpose,
            graph: Graph::default(),
            joints: Vec::new(),
            transition: None,
            has_loose_transition: false,
            ends: Vec::new(),
            memory: MemberElement::default(),
            matrices: Vec::new(),
            tensions: HashMap::new(),
            samples: Vec::new(),
        }
    }

    /// As above, with the tension in elements, by index of the edge.
    pub(super) fn with_tensions(mut self, tensions: &[(usize, Tension)]) -> Self {
        self.tensions = tensions.iter().copied().collect();
        self
    }

    /// Nodes of joints, supports and the transition piece.
    fn place_joints(&mut self) {
        let description = self.frame.description();
        let held = description.transition.as_ref().filter(|t| t.is_held);
        let is_ground = |joint: usize| {
            let mut supports = description.supports.iter();
            supports.any(|s| s.joint == joint && s.is_clamped())
                || held.is_some_and(|t| t.joints.contains(&joint))
        };
        for (index, joint) in description.joints.iter().enumerate() {
            let node = match is_ground(index) {
                true => None,
                false => Some(self.graph.add_node(joint.position_m, index)),
            };
            self.joints.push(node);
        }
        for support in description.supports.iter().filter(|s| !s.is_clamped()) {
            let free = support.fixed.map(|fixed| !fixed);
            let ends = [None, self.joints[support.joint]];
            self.graph.connect(ends, EdgeKind::Free(free), HINGED);
        }
        let Some(transition) = description.transition.as_ref().filter(|t| !t.is_held) else {
            return;
        };
        let node = self
            .graph
            .add_node(transition.position_m, transition.joints[0]);
        self.transition = Some(node);
        if self.has_loose_transition {
            let ends = [None, Some(node)];
            self.graph.connect(ends, EdgeKind::Free([true; 6]), LOOSE);
        }
        for joint in &transition.joints {
            let ends = [Some(node), self.joints[*joint]];
            self.graph.connect(ends, EdgeKind::Rigid, RIGID);
        }
    }

    /// Nodes and edges of members; where members are not welded, each end has its own node.
    fn place_members(&mut self) {
        let description = self.frame.description();
        self.ends = description
            .members
            .iter()
            .map(|m| m.joints.map(|j| self.joints[j]))
            .collect();
        for joint in 0..description.joints.len() {
            self.place_hinges(joint);
        }
        for (index, member) in description.members.iter().enumerate() {
            self.place_member(index, member);
        }
    }

    /// The hinges of a joint: the first member that ends there has the joint's node, each other one
    /// its own.
    fn place_hinges(&mut self, joint: usize) {
        let description = self.frame.description();
        let (kind, position_m) = {
            let joint = &description.joints[joint];
            (joint.kind, joint.position_m)
        };
        if kind == JointKind::Cantilever {
            return;
        }
        let of_member = |(index, member): (usize, &FrameMember)| {
            let mut sides = (0..2).filter(|side| member.joints[*side] == joint);
            sides.next().map(|side| (index, side))
        };
        let members = description.members.iter().enumerate();
        let here: Vec<(usize, usize)> = members.filter_map(of_member).collect();
        let axes = |member: usize| self.frame.axes(&description.members[member]);
        let mut placed: Vec<(Node, [Vector; 3])> = Vec::new();
        for (member, side) in here {
            let own = axes(member);
            let node = match placed.first() {
                None => self.joints[joint],
                Some((first, first_axes)) => {
                    let node = Some(self.graph.add_node(position_m, joint));
                    if let Some(hinge) = Hinge::new(&kind, [first_axes, &own]) {
                        self.graph.connect(
                            [*first, node],
                            EdgeKind::Hinge(Box::new(hinge)),
                            HINGED,
                        );
                    }
                    node
                }
            };
            self.ends[member][side] = node;
            for (other, other_axes) in &placed {
                if let Some([near, across, far]) = spring(&kind, [other_axes, &own]) {
                    let ends = ([*other, node], [position_m; 2]);
                    self.add_nodal(ELASTIC, ends, [near, across, far]);
                }
            }
            placed.push((node, own));
        }
    }

    /// Adds a matrix for the motions of two nodes at these positions (m): its blocks near-near,
    /// near-far, far-far.
    fn add_nodal(&mut self, kind: usize, (ends, ends_m): Ends, blocks: [SpatialMatrix; 3]) {
        self.matrices.push(Chord {
            ends,
            ends_m,
            first: 0,
            parts: Parts::of_nodal(kind, &blocks),
        });
    }

    fn place_member(&mut self, index: usize, member: &FrameMember) {
        let joints = &self.frame.description().joints;
        let ends = (
            self.ends[index],
            member.joints.map(|j| joints[j].position_m),
        );
        let length_m = self.frame.length_m(member);
        let axes = self.frame.axes(member);
        match &member.kind {
            MemberKind::Beam { .. } => self.place_beam(index, member, length_m),
            MemberKind::Cable {
                axial_n,
                mass_kg_per_m,
                pretension_n,
            } => {
                let unstretched_m = length_m / (1.0 + pretension_n / axial_n);
                let along = axial_n / unstretched_m;
                let across = pretension_n / length_m;
                let spring = diagonal([across, across, along, 0.0, 0.0, 0.0]);
                self.add_relative(ends, &rigid::matrix_out_of_axes(&axes, &spring));
                self.add_cable_inertia(ends, &axes, mass_kg_per_m * unstretched_m);
            }
            MemberKind::Rigid { mass_kg_per_m } => {
                self.graph.connect(ends.0, EdgeKind::Rigid, RIGID);
                if *mass_kg_per_m > 0.0 && length_m > 0.0 {
                    self.add_cable_inertia(ends, &axes, mass_kg_per_m * length_m);
                }
            }
            MemberKind::Spring(spring) => {
                let axes = spring.axes.unwrap_or(axes);
                self.add_relative(ends, &rigid::matrix_out_of_axes(&axes, &spring.stiffness));
            }
        }
    }

    /// Adds a stiffness for the difference of two motions, with no lever arm between them.
    fn add_relative(&mut self, ends: Ends, stiffness: &SpatialMatrix) {
        let across = stiffness.map(|row| row.map(|entry| -entry));
        self.add_nodal(ELASTIC, ends, [*stiffness, across, *stiffness]);
    }

    /// The consistent inertia of a cable: cubic shapes across, linear along.
    fn add_cable_inertia(&mut self, ends: Ends, axes: &[Vector; 3], mass_kg: f64) {
        let of = |across: f64, along: f64| {
            let own = [across, across, along, 0.0, 0.0, 0.0].map(|share| share * mass_kg);
            rigid::matrix_out_of_axes(axes, &diagonal(own))
        };
        let (own, other) = (of(13.0 / 35.0, 1.0 / 3.0), of(9.0 / 70.0, 1.0 / 6.0));
        self.add_nodal(INERTIA, ends, [own, other, own]);
    }

    fn place_beam(&mut self, index: usize, member: &FrameMember, length_m: f64) {
        let borders = self.recipe.borders(member);
        let parts = borders.len() - 1;
        let mut near = self.ends[index][0];
        for (k, fractions) in borders.windows(2).enumerate() {
            let far = if k + 1 == parts {
                self.ends[index][1]
            } else {
                let position_m = self.position_m(index, fractions[1]);
                Some(self.graph.add_node(position_m, member.joints[0]))
            };
            // The flexibility of a cantilever in bending is as its length cubed over EI.
            let part_m = length_m * (fractions[1] - fractions[0]);
            let bending = self.bending_n_m2(member, fractions);
            let kind = EdgeKind::Element {
                member: index,
                from: fractions[0],
                to: fractions[1],
            };
            self.graph
                .connect([near, far], kind, part_m.powi(3) / bending);
            near = far;
        }
    }

    /// Position of a point of a member at a fraction of its length, m.
    fn position_m(&self, member: usize, at: f64) -> Vector {
        let description = self.frame.description();
        let joints = description.members[member].joints;
        let [from, to] = joints.map(|joint| description.joints[joint].position_m);
        std::array::from_fn(|i| from[i] + at * (to[i] - from[i]))
    }

    fn bending_n_m2(&self, member: &FrameMember, fractions: &[f64]) -> f64 {
        match &member.kind {
            MemberKind::Beam { ends, material } => {
                let middle = 0.5 * (fractions[0] + fractions[1]);
                let bending = ends.at(middle, material).bending_n_m2;
                bending.fore_aft.min(bending.side_side)
            }
            MemberKind::Cable { .. } | MemberKind::Rigid { .. } | MemberKind::Spring(_) => {
                f64::INFINITY
            }
        }
    }

    /// The equations: what carries the nodes first, then what is left of the edges.
    fn equations(mut self) -> Result<MadeEquations, FrameSolveError> {
        let (mut elements, mut rigid_links) = (Vec::new(), Vec::new());
        let mut nodes = vec![[NONE; KINDS]; self.graph.positions_m.len()];
        let description = self.frame.description();
        for support in &description.supports {
            if let Some(node) = self.joints[support.joint] {
                add_scaled(&mut nodes[node][GROUND], 1.0, &support.stiffness);
                add_scaled(&mut nodes[node][INERTIA], 1.0, &support.inertia);
            }
        }
        for (joint, body) in &description.masses {
            if let Some(node) = self.joints[*joint] {
                add_scaled(&mut nodes[node][INERTIA], 1.0, &body_inertia(body));
            }
        }
        for (joint, inertia) in &description.added_masses {
            if let Some(node) = self.joints[*joint] {
                add_scaled(&mut nodes[node][INERTIA], 1.0, inertia);
            }
        }
        let rotates = self.rotating();
        let branches = self.graph.trees(self.transition, |node| {
            [
                true,
                true,
                true,
                rotates[node],
                rotates[node],
                rotates[node],
            ]
        });
        let mut equations = Equations {
            nodes,
            ..Equations::default()
        };
        if self.has_loose_transition {
            self.check_loose(&branches)?;
        }
        let mut is_branch = vec![false; self.graph.edges.len()];
        for branch in &branches {
            is_branch[branch.edge] = true;
            let carrier = Carrier::Link(equations.links.len());
            elements.extend(self.placed(branch.edge, carrier, branch.reversed));
            let link = self.link(*branch, equations.unknowns);
            if matches!(self.graph.edges[branch.edge].kind, EdgeKind::Rigid) {
                rigid_links.push(RigidLink {
                    edge: branch.edge,
                    link: equations.links.len(),
                });
            }
            equations.unknowns += link.coordinates;
            equations.links.push(link);
        }
        let others = (0..self.graph.edges.len()).filter(|edge| !is_branch[*edge]);
        for edge in others.collect::<Vec<_>>() {
            self.check_unused(edge)?;
            if let Some(chord) = self.chord(edge, equations.unknowns) {
                let carrier = Carrier::Chord(equations.chords.len());
                elements.extend(self.placed(edge, carrier, false));
                equations.unknowns += chord.parts.bubbles();
                equations.chords.push(chord);
            }
        }
        equations.chords.append(&mut self.matrices);
        Ok((equations, elements, rigid_links, self.samples))
    }

    /// The element of an edge, if the edge is an element.
    fn placed(&self, edge: usize, carrier: Carrier, reversed: bool) -> Option<PlacedElement> {
        match self.graph.edges[edge].kind {
            EdgeKind::Element { member, from, to } => Some(PlacedElement {
                edge,
                member,
                from,
                to,
                carrier,
                reversed,
            }),
            EdgeKind::Rigid | EdgeKind::Hinge(_) | EdgeKind::Free(_) => None,
        }
    }

    /// Checks that an edge that carries no node is an element, or connects nodes that are rigidly
    /// connected already.
    fn check_unused(&self, edge: usize) -> Result<(), FrameSolveError> {
        let edge = &self.graph.edges[edge];
        let node = edge.ends[1].or(edge.ends[0]).unwrap_or_default();
        let joint = || {
            let joint = self.graph.joints[node];
            self.frame.description().joints[joint].name.clone()
        };
        match edge.kind {
            EdgeKind::Hinge(_) => Err(FrameSolveError::RigidLoop { joint: joint() }),
            EdgeKind::Free(free) if free != [true; 6] => {
                Err(FrameSolveError::RigidBetweenSupports { joint: joint() })
            }
            EdgeKind::Free(_) | EdgeKind::Rigid | EdgeKind::Element { .. } => Ok(()),
        }
    }

    /// Checks that there is a flexible member between the transition piece, if it has unknowns of
    /// its own, and the ground.
    fn check_loose(&self, branches: &[Branch]) -> Result<(), FrameSolveError> {
        let mut on_transition = vec![false; self.graph.positions_m.len()];
        let hangs = |on_transition: &[bool], node: Node| node.is_some_and(|n| on_transition[n]);
        for branch in branches {
            let [from, to] = self.graph.edges[branch.edge].ends;
            let [parent, child] = if branch.reversed {
                [to, from]
            } else {
                [from, to]
            };
            if let Some(child) = child {
                on_transition[child] =
                    Some(child) == self.transition || hangs(&on_transition, parent);
            }
        }
        for edge in &self.graph.edges {
            let [near, far] = edge.ends.map(|end| hangs(&on_transition, end));
            let deforms = match edge.kind {
                EdgeKind::Rigid | EdgeKind::Hinge(_) => false,
                EdgeKind::Free(free) => free == [true; 6],
                EdgeKind::Element { .. } => true,
            };
            if near != far && !deforms {
                let node = edge.ends[1].or(edge.ends[0]).unwrap_or_default();
                let joint = &self.frame.description().joints[self.graph.joints[node]];
                let joint = joint.name.clone();
                return Err(FrameSolveError::RigidTransition { joint });
            }
        }
        Ok(())
    }

    /// Whether the rotation of each node has a stiffness: cables have none.
    fn rotating(&self) -> Vec<bool> {
        let mut rotates = vec![false; self.graph.positions_m.len()];
        for edge in &self.graph.edges {
            edge.ends
                .iter()
                .flatten()
                .for_each(|node| rotates[*node] = true);
        }
        for (member, ends) in self.frame.description().members.iter().zip(&self.ends) {
            if matches!(member.kind, MemberKind::Spring(_)) {
                ends.iter().flatten().for_each(|node| rotates[*node] = true);
            }
        }
        rotates
    }

    /// The element of a part of a member, and its axes.
    fn element(
        &mut self,
        edge: usize,
        index: usize,
        from: f64,
        to: f64,
    ) -> Option<(Element, [Vector; 3])> {
        let mut memory = std::mem::take(&mut self.memory);
        let (stretch, axes) = self.stretch(edge, index, from, to);
        let element = self.recipe.element(&stretch, &mut memory);
        self.memory = memory;
        Some((element?, axes))
    }

    /// A part of a member between two fractions of its length, and its axes.
    pub(super) fn stretch(
        &self,
        edge: usize,
        index: usize,
        from: f64,
        to: f64,
    ) -> (Stretch<'_>, [Vector; 3]) {
        let member = &self.frame.description().members[index];
        let axes = axes_from(self.frame, member, to > from);
        // Their axes as rows of the transposed matrix: from global axes into those of the stretch.
        let into: [Vector; 3] = std::array::from_fn(|i| std::array::from_fn(|j| axes[j][i]));
        let (low, high) = (from.min(to), from.max(to));
        let is_here = |at: f64| low <= at && (at < high || high >= 1.0);
        let riders = self.frame.description().riders.iter();
        let riders = riders.filter(|rider| rider.member == index && is_here(rider.fraction));
        let stretch = Stretch {
            member,
            from,
            to,
            member_m: self.frame.length_m(member),
            tension: self.tensions.get(&edge),
            riders: riders
                .map(|r| (r.fraction, rigid::matrix_out_of_axes(&into, &r.inertia)))
                .collect(),
            sampled: match self.purpose {
                Purpose::Shapes => sampled(low, high).map(|(_, at)| at).collect(),
                Purpose::Frequencies | Purpose::Rest => Vec::new(),
            },
            is_at_rest: self.purpose == Purpose::Rest,
        };
        (stretch, axes)
    }

    /// The link of a branch, whose coordinates begin at `first`.
    fn link(&mut self, branch: Branch, first: usize) -> Link {
        let edge = self.graph.edges[branch.edge].clone();
        let [parent, child] = match branch.reversed {
            false => edge.ends,
            true => [edge.ends[1], edge.ends[0]],
        };
        let child = child.unwrap_or_default();
        let link = |transfer, tip: Vec<Motion>, own| Link {
            parent,
            child,
            transfer,
            first,
            coordinates: tip.len(),
            parts: Parts::none(tip.len()),
            tip,
            own,
        };
        match edge.kind {
            EdgeKind::Rigid => {
                let at = |node: Node| node.map(|node| self.graph.positions_m[node]);
                let lever = match (at(parent), at(Some(child))) {
                    (Some(from), Some(to)) => std::array::from_fn(|i| to[i] - from[i]),
                    _ => [0.0; 3],
                };
                link(rigid_transfer(lever), Vec::new(), 0.0)
            }
            EdgeKind::Hinge(hinge) => {
                let (transfer, rotations) = hinge.link(branch.reversed);
                link(transfer, rotations, 0.0)
            }
            EdgeKind::Free(free) => {
                let column = |k: usize| std::array::from_fn(|i| if i == k { UNIT } else { 0.0 });
                let columns = (0..6).filter(|k| free[*k]).map(column);
                link(identity(), columns.collect(), 0.0)
            }
            EdgeKind::Element { member, from, to } => {
                let (from, to) = if branch.reversed {
                    (to, from)
                } else {
                    (from, to)
                };
                let Some((element, axes)) = self.element(branch.edge, member, from, to) else {
                    return link(identity(), Vec::new(), 0.0);
                };
                let transfer = rigid::matrix_out_of_axes(&axes, &element.transfer);
                let tip = element.tip();
                let tip = tip
                    .map(|column| rigid::out_of_axes(&axes, &column))
                    .collect();
                let at = (member, from, to);
                if self.purpose == Purpose::Shapes {
                    let samples = Sample::of_link(at, (&element, &axes), parent, first);
                    self.samples.extend(samples);
                }
                Link {
                    coordinates: element.coordinates(),
                    parts: Parts::of_link(&element, Some(axes)),
                    ..link(transfer, tip, 1.0)
                }
            }
        }
    }

    /// The chord of an edge that carries no node; none for a rigid edge, which other rigid edges
    /// replace.
    fn chord(&mut self, edge: usize, first: usize) -> Option<Chord> {
        let Edge { ends, kind, .. } = self.graph.edges[edge].clone();
        let EdgeKind::Element { member, from, to } = kind else {
            return None;
        };
        let (element, axes) = self.element(edge, member, from, to)?;
        if self.purpose == Purpose::Shapes {
            let samples = Sample::of_chord((member, from, to), (&element, &axes), ends, first);
            self.samples.extend(samples);
        }
        Some(Chord {
            ends,
            ends_m: [from, to].map(|at| self.position_m(member, at)),
            first,
            parts: Parts::of_chord(&element, axes),
        })
    }
}

/// The axes of a member as rows, seen from one of its joints: if seen from the second joint, they
/// are rotated by 180° about x.
fn axes_from(frame: &Frame, member: &FrameMember, is_first: bool) -> [Vector; 3] {
    let [x, y, z] = frame.axes(member);
    let back = |axis: Vector| axis.map(|a| -a);
    match is_first {
        true => [x, y, z],
        false => [x, back(y), back(z)],
    }
}

fn body_inertia(body: &RigidBody) -> SpatialMatrix {
    spatial_inertia(body.mass_kg, body.center_m, &body.inertia_kg_m2)
}

fn diagonal(values: Motion) -> SpatialMatrix {
    std::array::from_fn(|i| std::array::from_fn(|j| if i == j { values[i] } else { 0.0 }))
}
