//! A tower on a frame: the frame's equations with the tower as links on the transition piece.

use std::ops::Range;

use super::assembly::{Assembled, PlacedElement, assemble};
use super::element::{ALL, Element, Part};
use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS, Link};
use super::error::FrameSolveError;
use super::finer::{FinerElement, change_of_energy, finer_elements};
use super::local::Local;
use super::mechanism::mechanism;
use super::order::Order;
use super::parts::Parts;
use super::product::Sweep;
use super::recipe::FrameRecipe;
use super::resultant::Places;
use super::rigid::{Motion, NONE, rigid_transfer};
use super::shape::{FrameShape, ShapeReader};
use super::statics::{AtRest, with_tensions};
use super::tension::Tension;
use super::turning_over::turning_over;
use crate::beam::MemberPart;
use crate::space::{SpatialMatrix, add_scaled, transform_matrix};
use crate::subsystem::{
    Branch, Coefficients, Energies, InternalForces, MatrixKind, Resultant, SegmentCurves,
    ShearFraction, Subsystem,
};
use crate::tower::frame::FrameFoundation;
use crate::tower::{Motions, Tower, spatial_inertia};

/// Work of the tower on the frame that is less than this fraction of the frame's energy is treated
/// as rounding.
const NO_WORK: f64 = 1e-6;

/// Nodes within this distance of the axis of the tower are on it, m.
const ON_AXIS_M: f64 = 1e-3;

/// The equations of a frame under a tower, with the platform and the geometric stiffness of the
/// total weight, but without the tower: the same for every mesh of the tower.
#[derive(Debug)]
pub(crate) struct BareFrame {
    /// The tower of the frame.
    tower: Tower,
    /// Degree of the elements of its members.
    degree: usize,
    equations: Equations,
    /// The node of the transition piece.
    node: usize,
    /// Positions of its nodes relative to the base of the tower.
    places: Places,
    /// The tension in its elements, by index of the edge.
    tensions: Vec<(usize, Tension)>,
    /// Its elements, and the additional coordinates of elements of a higher degree if they were
    /// needed.
    elements: Vec<PlacedElement>,
    finer: Option<Vec<FinerElement>>,
    /// The joint of each of its nodes.
    joint_of_node: Vec<usize>,
    /// The places of its joints and of points of its members in the equations.
    shapes: ShapeReader,
    /// Data of the local modes of its members; none before they are needed, and none if there are
    /// no local modes.
    local: Option<Option<Local>>,
    memory: Memory,
}

/// Working memory, kept from mesh to mesh.
#[derive(Debug, Default)]
struct Memory {
    factors: Factors,
    counted: Factors,
    sweep: Sweep,
    product: Vec<f64>,
}

/// A tower of any element type, in which all motions are coupled, on a frame.
pub(crate) struct OnFrame {
    tower: Box<dyn Subsystem>,
    /// The frame; its equations include the tower.
    frame: BareFrame,
    order: Order,
    /// The links of the tower.
    branch: Range<usize>,
    /// The elements of these links, in changed coordinates.
    elements: Vec<Part>,
    /// The motion of the tower's base for each of its coordinates.
    units: Motion,
    foot: usize,
}

impl BareFrame {
    /// The frame below a tower, with elements of this degree.
    ///
    /// # Errors
    /// [`FrameSolveError`].
    fn new(
        tower: &Tower,
        foundation: &FrameFoundation,
        branch: &Branch,
        degree: usize,
    ) -> Result<Self, FrameSolveError> {
        let [x, y, z] = foundation.reference_m();
        let gravity_m_per_s2 = tower.gravity_m_per_s2();
        let mut bare = (0, 0);
        let Assembled {
            mut equations,
            positions_m,
            joint_of_node,
            transition,
            tensions,
            joints,
            samples,
            elements,
            ..
        } = with_tensions(
            &foundation.frame,
            AtRest::under_tower(foundation, gravity_m_per_s2),
            |frame, forces, purpose| {
                let recipe = FrameRecipe::Spectral { degree };
                assemble(frame, recipe, forces, purpose)
            },
            |assembled| {
                if let Some(node) = assembled.transition {
                    let equations = &assembled.equations;
                    bare = (equations.nodes.len(), equations.links.len());
                    add_platform(assembled, node, foundation, gravity_m_per_s2);
                    add_tower(&mut assembled.equations, branch, node, tower.base_m() - z);
                }
            },
        )?;
        equations.shrink(bare);
        let places = Places::new(&equations, &positions_m, [x, y, tower.base_m()]);
        Ok(Self {
            tower: tower.clone(),
            degree,
            node: transition.ok_or(FrameSolveError::NoTransition)?,
            equations,
            places,
            joint_of_node,
            tensions,
            shapes: ShapeReader { joints, samples },
            elements,
            finer: None,
            local: None,
            memory: Memory::default(),
        })
    }

    fn is_of(&self, tower: &Tower, degree: usize) -> bool {
        self.degree == degree && self.tower == *tower
    }
}

impl OnFrame {
    /// A tower on its frame, whose members have elements of this degree; `model` are the tower's
    /// own equations. The bare frame of another mesh of the same tower is not made again.
    ///
    /// # Errors
    /// [`FrameSolveError`].
    pub(crate) fn new(
        tower: &Tower,
        model: Box<dyn Subsystem>,
        foundation: &FrameFoundation,
        degree: usize,
        before: Option<BareFrame>,
    ) -> Result<Self, FrameSolveError> {
        let branch = model.branch().unwrap_or_default();
        let mut frame = match before.filter(|frame| frame.is_of(tower, degree)) {
            Some(frame) => frame,
            None => BareFrame::new(tower, foundation, &branch, degree)?,
        };
        let first = frame.equations.links.len();
        let [.., z] = foundation.reference_m();
        let rise_m = tower.base_m() - z;
        let (foot, elements) = add_tower(&mut frame.equations, &branch, frame.node, rise_m);
        Ok(Self {
            tower: model,
            order: Order::new(&frame.equations),
            branch: first..frame.equations.links.len(),
            frame,
            elements,
            units: branch.units,
            foot,
        })
    }

    /// The shape of the frame in a motion, divided by a size.
    pub(crate) fn shape(&self, x: &[f64], size: f64) -> Option<FrameShape> {
        let mut motions = Vec::new();
        self.frame.equations.set_motions(x, &mut motions);
        let frame = &self.frame.tower.frame()?.frame;
        Some(self.frame.shapes.read(frame, &motions, x).divided_by(size))
    }

    /// The fractions of the kinetic and of the strain energy of a mode in local motions of the
    /// members; none if there are no local modes.
    pub(crate) fn local_shares(&mut self, x: &[f64]) -> Option<[f64; 2]> {
        let whole = [Coefficients::MASS, Coefficients::STIFFNESS].map(|a| self.energy(&a, x));
        let (nodes, links) = (self.foot, self.branch.start);
        let BareFrame {
            equations,
            node,
            local,
            ..
        } = &mut self.frame;
        let local =
            local.get_or_insert_with(|| Local::new(&equations.first((nodes, links)), *node));
        let local = local.as_ref()?;
        let mut motions = Vec::new();
        equations.set_motions(x, &mut motions);
        let own = local.energies(equations, *node, x, &motions);
        let share = |k: usize| {
            if whole[k] > 0.0 {
                own[k] / whole[k]
            } else {
                0.0
            }
        };
        Some([share(0), share(1)])
    }

    /// The change of the eigenvalue λ (rad²/s²) of a vector if the degree of the elements of the
    /// frame is increased by two.
    pub(crate) fn change_on_finer(&mut self, lambda: f64, x: &[f64]) -> f64 {
        let BareFrame {
            tower,
            degree,
            equations,
            tensions,
            elements,
            finer,
            ..
        } = &mut self.frame;
        let Some(foundation) = tower.frame() else {
            return 0.0;
        };
        let finer = finer.get_or_insert_with(|| {
            let degrees = [*degree, *degree + 2];
            finer_elements(&foundation.frame, degrees, tensions, elements)
        });
        let change = change_of_energy(equations, finer, lambda, x);
        change / self.energy(&Coefficients::MASS, x)
    }

    /// The rigid-body inertia of the frame about the base of the tower: kg, kg m, kg m².
    pub(crate) fn rigid_inertia_of_frame(&self) -> SpatialMatrix {
        let (factors, _) = factors_of(&Coefficients::MASS);
        self.frame.places.as_rigid(&self.frame.equations, &factors)
    }

    /// Whether it floats, so that the frame moves with the base except for its deformation.
    fn floats(&self) -> bool {
        self.frame.tower.base().floats
    }

    /// Why the frame is a mechanism under its tower, if it is one.
    pub(crate) fn mechanism(&self) -> Option<FrameSolveError> {
        let BareFrame {
            tower,
            equations,
            joint_of_node,
            ..
        } = &self.frame;
        let foundation = tower.frame()?;
        mechanism(&foundation.frame, (equations, &self.order), joint_of_node)
    }

    /// The frame without the tower.
    pub(crate) fn into_bare(mut self) -> BareFrame {
        // The tower's first node is its foot.
        self.frame.equations.shrink((self.foot, self.branch.start));
        self.frame
    }

    /// Number of unknowns of the frame, the first unknowns.
    fn of_frame(&self) -> usize {
        self.frame.equations.links[self.branch.start].first
    }

    /// Number of coordinates of the tower's base without a frame.
    fn base_coordinates(&self) -> usize {
        self.units.iter().filter(|unit| **unit != 0.0).count()
    }

    /// The links of the tower's elements: the first of the branch is rigid, from the transition
    /// piece to the base.
    fn links_of_tower(&self) -> impl Iterator<Item = &Link> {
        self.frame.equations.links[self.branch.clone()]
            .iter()
            .skip(1)
    }

    /// The vector of the tower only, from the vector of the whole model.
    fn tower_vector(&self, x: &[f64]) -> Vec<f64> {
        let mut motions = Vec::new();
        self.frame.equations.set_motions(x, &mut motions);
        let base = self.units.iter().zip(motions[self.foot]);
        let moving = base.filter(|(unit, _)| **unit != 0.0);
        let mut own: Vec<f64> = moving.map(|(unit, motion)| motion / unit).collect();
        for (link, element) in self.links_of_tower().zip(&self.elements) {
            let from = own.len();
            own.extend_from_slice(&x[link.first..][..link.coordinates]);
            element.change_back(&mut own[from..]);
        }
        own
    }

    /// The resultant of the whole from that of the tower by itself, whose inertia has a force on
    /// its base, in a mode with xᵀ M x = `mass`.
    fn with_frame(
        &mut self,
        a: &Coefficients,
        x: &[f64],
        mut resultant: Resultant,
        (inertia, mass): (&Motion, f64),
    ) -> Resultant {
        let of_all = match *a == Coefficients::MASS {
            true => mass,
            false => self.energy(a, x),
        };
        let of_tower: f64 = resultant.energy.iter().sum();
        let mut motions = std::mem::take(&mut self.frame.memory.sweep.motions);
        let equations = &self.frame.equations;
        equations.set_motions(x, &mut motions);
        let base = motions[self.foot];
        // λ = xᵀ K x/xᵀ M x.
        let work = std::array::from_fn(|i| of_all / mass * inertia[i] * base[i]);
        let (factors, _) = factors_of(a);
        let places = &self.frame.places;
        let force = places.resultant(equations, &factors, (&motions, x));
        let of_rigid: Motion = match self.floats() {
            true => std::array::from_fn(|i| base[i] * force[i]),
            false => Motion::default(),
        };
        self.frame.memory.sweep.motions = motions;
        let known = of_tower + of_rigid.iter().sum::<f64>();
        let of_frame = self.energy_of_frame(of_all - known, &work, x);
        for i in 0..6 {
            resultant.force[i] += force[i];
            resultant.energy[i] += of_rigid[i] + of_frame[i];
        }
        resultant
    }

    /// xᵀ A x of the frame alone, given to components as the inertia of the tower does work on the
    /// frame in each motion of its base. How joints lie in members does not matter then. Where the
    /// tower does no work, as members vibrate by themselves, by the motions of the nodes.
    fn energy_of_frame(&mut self, of_frame: f64, work: &[f64; 6], x: &[f64]) -> [f64; 6] {
        let work = work.map(f64::abs);
        let sum: f64 = work.iter().sum();
        let shares = match sum > NO_WORK * of_frame.abs() {
            true => work.map(|work| work / sum),
            false => self.shares_of_nodes(x),
        };
        shares.map(|share| share * of_frame)
    }

    /// The shares of components in the motions of the nodes: translations along the axes, but for a
    /// common rotation about the axis of the tower. A node on this axis, of a monopile, has no
    /// lever: its own rotation counts with a lever of 1 m.
    fn shares_of_nodes(&mut self, x: &[f64]) -> [f64; 6] {
        let mut motions = std::mem::take(&mut self.frame.memory.sweep.motions);
        self.frame.equations.set_motions(x, &mut motions);
        let (mut turned, mut squares) = (0.0, 0.0);
        for ([x_m, y_m, _], motion) in self.frame.places.levers_m.iter().zip(&motions) {
            turned += x_m * motion[1] - y_m * motion[0];
            squares += x_m * x_m + y_m * y_m;
        }
        let angle = if squares > 0.0 { turned / squares } else { 0.0 };
        let mut shares = [0.0; 6];
        shares[5] = angle * angle * squares;
        for ([x_m, y_m, _], motion) in self.frame.places.levers_m.iter().zip(&motions) {
            let rest = [motion[0] + angle * y_m, motion[1] - angle * x_m, motion[2]];
            (0..3).for_each(|i| shares[i] += rest[i] * rest[i]);
            if x_m.hypot(*y_m) < ON_AXIS_M {
                shares[5] += motion[5] * motion[5];
            }
        }
        self.frame.memory.sweep.motions = motions;
        let sum: f64 = shares.iter().sum();
        shares.map(|share| if sum > 0.0 { share / sum } else { 0.0 })
    }
}

/// Adds the body of the transition piece, with its weight, and the hydrostatic and mooring
/// stiffness of a floating frame.
pub(super) fn add_platform(
    assembled: &mut Assembled,
    node: usize,
    foundation: &FrameFoundation,
    gravity_m_per_s2: f64,
) {
    let body = &foundation.platform;
    let [_, _, reference_m] = foundation.reference_m();
    let rise_m = reference_m - foundation.pivot_m();
    let nodes = &mut assembled.equations.nodes;
    if let Some(held) = &foundation.held {
        for matrix in [held.water, held.moorings] {
            let mut moved = matrix;
            transform_matrix(&mut moved, -rise_m);
            add_scaled(&mut nodes[node][GROUND], 1.0, &moved);
        }
        for (joint, matrix) in held.on_joints() {
            if let Some(node) = assembled.joints[*joint] {
                add_scaled(&mut nodes[node][GROUND], 1.0, matrix);
            }
        }
    }
    let matrices = &mut nodes[node];
    let inertia = spatial_inertia(body.mass_kg, body.center_m, &body.inertia_kg_m2);
    add_scaled(&mut matrices[INERTIA], 1.0, &inertia);
    let weight_n = body.mass_kg * gravity_m_per_s2;
    let [x_m, y_m, z_m] = body.center_m;
    let turning = turning_over([0.0, 0.0, -weight_n], [x_m, y_m, z_m + rise_m]);
    add_scaled(&mut matrices[GEOMETRIC], 1.0, &turning);
}

/// Adds a tower to a frame, with its base `rise_m` (m) above the transition piece. Returns the node
/// of its base, and its elements in changed coordinates.
fn add_tower(
    equations: &mut Equations,
    branch: &Branch,
    node: usize,
    rise_m: f64,
) -> (usize, Vec<Part>) {
    let foot = add_rigidly(equations, (node, rise_m), branch.base);
    let (mut parent, mut elements) = (foot, Vec::with_capacity(branch.links.len()));
    for link in &branch.links {
        let child = add_node(equations, &link.body);
        let made = MemberPart {
            planes: vec![&ALL],
            strains: Vec::new(),
            tips: link.tips.to_vec(),
            matrices: link.matrices.clone(),
            shapes: Vec::new(),
        };
        let element = Element {
            transfer: link.transfer,
            parts: vec![Part::new(made)],
        };
        equations.links.push(Link {
            parent: Some(parent),
            child,
            transfer: element.transfer,
            tip: element.tip().collect(),
            first: equations.unknowns,
            coordinates: element.coordinates(),
            own: 1.0,
            parts: Parts::of_link(&element, None),
        });
        equations.unknowns += element.coordinates();
        elements.extend(element.parts);
        parent = child;
    }
    (foot, elements)
}

/// Adds a node with a body `rise_m` (m) above another node and rigidly connected to it; returns the
/// new node.
pub(super) fn add_rigidly(
    equations: &mut Equations,
    (node, rise_m): (usize, f64),
    body: [SpatialMatrix; 3],
) -> usize {
    let child = add_node(equations, &body);
    equations.links.push(Link {
        parent: Some(node),
        child,
        transfer: rigid_transfer([0.0, 0.0, rise_m]),
        tip: Vec::new(),
        first: equations.unknowns,
        coordinates: 0,
        own: 0.0,
        parts: Parts::none(0),
    });
    child
}

fn add_node(equations: &mut Equations, body: &[SpatialMatrix; 3]) -> usize {
    let [inertia, ground, geometric] = *body;
    equations.nodes.push([inertia, ground, geometric, NONE]);
    equations.nodes.len() - 1
}

/// The factors of the matrices of a frame, and the factor of the stiffness of its coordinates.
fn factors_of(a: &Coefficients) -> ([f64; KINDS], f64) {
    let mut factors = [0.0; KINDS];
    (factors[INERTIA], factors[GROUND]) = (a.mass, a.foundation);
    (factors[GEOMETRIC], factors[ELASTIC]) = (a.geometric, a.stiffness);
    (factors, a.stiffness)
}

impl Subsystem for OnFrame {
    fn motions(&self) -> Motions {
        self.tower.motions()
    }

    fn degrees_of_freedom(&self) -> usize {
        self.frame.equations.unknowns
    }

    fn is_finite(&self) -> bool {
        self.tower.is_finite()
    }

    fn clear(&mut self) {
        self.tower.clear();
    }

    fn add_base(&mut self, height_m: f64, unit: &[f64; 6]) {
        self.tower.add_base(height_m, unit);
    }

    fn add(&mut self, kind: MatrixKind, reference_m: f64, matrix: &SpatialMatrix) {
        self.tower.add(kind, reference_m, matrix);
    }

    fn add_geometric_stiffness(&mut self, moment_n_m: f64) {
        self.tower.add_geometric_stiffness(moment_n_m);
    }

    fn is_identity(&self, _: &Coefficients) -> bool {
        false
    }

    fn product(&mut self, a: &Coefficients, x: &[f64], out: &mut [f64]) {
        let (factors, own) = factors_of(a);
        let a = (&factors, own);
        let BareFrame {
            equations, memory, ..
        } = &mut self.frame;
        equations.product(a, &mut memory.sweep, x, out);
    }

    fn count_negative(&mut self, a: &Coefficients) -> usize {
        let (factors, own) = factors_of(a);
        let a = (&factors, own);
        let BareFrame {
            equations, memory, ..
        } = &mut self.frame;
        equations.factorize(&self.order, a, &mut memory.counted)
    }

    fn factorize(&mut self, a: &Coefficients) -> usize {
        let (factors, own) = factors_of(a);
        let a = (&factors, own);
        let BareFrame {
            equations, memory, ..
        } = &mut self.frame;
        equations.factorize(&self.order, a, &mut memory.factors)
    }

    fn solve(&mut self, x: &mut [f64]) {
        let BareFrame {
            equations, memory, ..
        } = &mut self.frame;
        equations.solve(&self.order, &mut memory.factors, x);
    }

    fn energy(&mut self, a: &Coefficients, x: &[f64]) -> f64 {
        let mut product = std::mem::take(&mut self.frame.memory.product);
        product.resize(x.len(), 0.0);
        self.product(a, x, &mut product);
        let energy = product.iter().zip(x).map(|(a, b)| a * b).sum();
        self.frame.memory.product = product;
        energy
    }

    fn energies(&mut self, x: &[f64]) -> Energies {
        let BareFrame {
            equations, memory, ..
        } = &mut self.frame;
        let energies = equations.energies(&mut memory.sweep, x);
        Energies {
            elastic: energies[ELASTIC],
            foundation: energies[GROUND],
            gravity: 0.0 - energies[GEOMETRIC],
            mass: energies[INERTIA],
        }
    }

    fn internal_forces(&self, x: &[f64], forces: &mut InternalForces) -> bool {
        let is_known = self.tower.internal_forces(&self.tower_vector(x), forces);
        // The frame is the same on any mesh.
        forces.base.truncate(self.base_coordinates());
        forces.base.extend_from_slice(&x[..self.of_frame()]);
        is_known
    }

    fn with_internal_forces(&self, forces: &InternalForces, jumps_m: &[f64], out: &mut [f64]) {
        // The vectors of a tower on another frame are not a good guess.
        if forces.base.len() != self.base_coordinates() + self.of_frame() {
            return out.fill(0.0);
        }
        let (base, of_frame) = forces.base.split_at(self.base_coordinates());
        out[..of_frame.len()].copy_from_slice(of_frame);
        let own = InternalForces {
            base: base.to_vec(),
            ..forces.clone()
        };
        let mut vector = vec![0.0; self.tower.degrees_of_freedom()];
        self.tower.with_internal_forces(&own, jumps_m, &mut vector);
        let mut rest = &mut vector[base.len()..];
        for (link, element) in self.links_of_tower().zip(&self.elements) {
            let (own, above) = rest.split_at_mut(link.coordinates);
            element.change(own);
            out[link.first..][..link.coordinates].copy_from_slice(own);
            rest = above;
        }
    }

    fn strain_energies(&self, x: &[f64], part: &mut dyn FnMut(f64, f64)) {
        self.tower.strain_energies(&self.tower_vector(x), part);
    }

    fn resultant(&mut self, a: &Coefficients, x: &[f64], base_m: f64) -> Resultant {
        let own = self.tower_vector(x);
        let inertia = self.tower.resultant(&Coefficients::MASS, &own, base_m);
        let mass = self.energy(&Coefficients::MASS, x);
        let of_tower = match *a == Coefficients::MASS {
            true => inertia,
            false => self.tower.resultant(a, &own, base_m),
        };
        self.with_frame(a, x, of_tower, (&inertia.force, mass))
    }

    fn modal_resultant(&mut self, x: &[f64], base_m: f64) -> (Resultant, [f64; 6]) {
        let own = self.tower_vector(x);
        let [inertia, stiffness] = [Coefficients::MASS, Coefficients::STIFFNESS]
            .map(|a| self.tower.resultant(&a, &own, base_m));
        let mass = self.energy(&Coefficients::MASS, x);
        let force = inertia.force;
        let inertia = self.with_frame(&Coefficients::MASS, x, inertia, (&force, mass));
        let strain = self.with_frame(&Coefficients::STIFFNESS, x, stiffness, (&force, mass));
        (inertia, strain.energy)
    }

    fn start(&mut self, out: &mut [f64]) {
        self.frame.equations.start(out);
    }

    fn curves<'a>(
        &self,
        borders_m: &'a [f64],
        shear: &'a ShearFraction<'a>,
        vector: &[f64],
    ) -> Box<dyn SegmentCurves + 'a> {
        self.tower
            .curves(borders_m, shear, &self.tower_vector(vector))
    }
}
