//! A tower on a frame: the frame's equations with the tower as links on the transition piece.

use std::ops::Range;

use super::assembly::{Assembled, assemble};
use super::element::Element;
use super::elimination::Factors;
use super::equations::{ELASTIC, Equations, GEOMETRIC, GROUND, INERTIA, KINDS, Link};
use super::error::FrameSolveError;
use super::order::Order;
use super::product::Sweep;
use super::recipe::FrameRecipe;
use super::rigid::{Motion, NONE, rigid_transfer};
use super::statics::with_tensions;
use crate::space::{SpatialMatrix, add_scaled};
use crate::subsystem::{
    Branch, Coefficients, MatrixKind, Resultant, SegmentCurves, ShearFraction, Subsystem,
};
use crate::tower::frame::FrameFoundation;
use crate::tower::{Motions, RigidBody, spatial_inertia};

/// A tower of any kind of elements, in which all motions are coupled, on a frame.
pub(crate) struct OnFrame {
    tower: Box<dyn Subsystem>,
    equations: Equations,
    order: Order,
    /// Which links are those of the tower.
    branch: Range<usize>,
    /// The changed elements of these links.
    elements: Vec<Element>,
    /// The motion of the tower's base for each of its coordinates.
    units: Motion,
    foot: usize,
    /// Positions of the nodes of the frame about the axis of the tower, m.
    levers_m: Vec<[f64; 2]>,
    factors: Factors,
    counted: Factors,
    sweep: Sweep,
    product: Vec<f64>,
}

impl OnFrame {
    /// A tower, which has its base at a height (m) and carries gravity (m/s²), on a frame whose
    /// members have elements of this degree.
    ///
    /// # Errors
    /// [`FrameSolveError`].
    pub(crate) fn new(
        tower: Box<dyn Subsystem>,
        foundation: &FrameFoundation,
        (base_m, gravity_m_per_s2): (f64, f64),
        degree: usize,
    ) -> Result<Self, FrameSolveError> {
        let [x, y, z] = foundation.reference_m();
        let branch = tower.branch().unwrap_or_default();
        let recipe = FrameRecipe::Spectral { degree };
        let mut carried = None;
        let members_n = if foundation.weight_on_members {
            gravity_m_per_s2
        } else {
            0.0
        };
        let Assembled {
            equations,
            positions_m,
            ..
        } = with_tensions(
            &foundation.frame,
            members_n,
            |frame, tensions| assemble(frame, recipe, tensions),
            |assembled| {
                let on = assembled.transition.map(|node| {
                    let equations = &mut assembled.equations;
                    add_platform(equations, node, &foundation.platform, gravity_m_per_s2);
                    let first = equations.links.len();
                    let (foot, elements) = add_tower(equations, &branch, node, base_m - z);
                    (foot, elements, first..equations.links.len())
                });
                carried = on;
            },
        )?;
        let (foot, elements, branch_links) = carried.ok_or(FrameSolveError::NoTransition)?;
        let units = branch.units;
        let levers_m = positions_m.iter().map(|p| [p[0] - x, p[1] - y]).collect();
        Ok(Self {
            tower,
            order: Order::new(&equations),
            branch: branch_links,
            equations,
            elements,
            units,
            foot,
            levers_m,
            factors: Factors::default(),
            counted: Factors::default(),
            sweep: Sweep::default(),
            product: Vec::new(),
        })
    }

    /// The vector of the tower by itself, for a vector of the whole.
    fn tower_vector(&self, x: &[f64]) -> Vec<f64> {
        let mut motions = Vec::new();
        self.equations.set_motions(x, &mut motions);
        let base = self.units.iter().zip(motions[self.foot]);
        let moving = base.filter(|(unit, _)| **unit != 0.0);
        let mut own: Vec<f64> = moving.map(|(unit, motion)| motion / unit).collect();
        // The first link of the branch is rigid: from the transition piece to the base.
        let links = &self.equations.links[self.branch.clone()][1..];
        for (link, element) in links.iter().zip(&self.elements) {
            let from = own.len();
            own.extend_from_slice(&x[link.first..][..link.coordinates]);
            element.change_back(&mut own[from..]);
        }
        own
    }

    /// xᵀ A x of the frame alone, given to components by the motions of its nodes: translations
    /// along the axes, but for a common rotation about the axis of the tower.
    fn energy_of_frame(&mut self, of_all: f64, of_tower: f64, x: &[f64]) -> [f64; 6] {
        let mut motions = std::mem::take(&mut self.sweep.motions);
        self.equations.set_motions(x, &mut motions);
        let (mut turned, mut squares) = (0.0, 0.0);
        for ([x_m, y_m], motion) in self.levers_m.iter().zip(&motions) {
            turned += x_m * motion[1] - y_m * motion[0];
            squares += x_m * x_m + y_m * y_m;
        }
        let angle = if squares > 0.0 { turned / squares } else { 0.0 };
        let mut shares = [0.0; 6];
        shares[5] = angle * angle * squares;
        for ([x_m, y_m], motion) in self.levers_m.iter().zip(&motions) {
            let rest = [motion[0] + angle * y_m, motion[1] - angle * x_m, motion[2]];
            (0..3).for_each(|i| shares[i] += rest[i] * rest[i]);
        }
        self.sweep.motions = motions;
        let sum: f64 = shares.iter().sum();
        let scale = if sum > 0.0 {
            (of_all - of_tower) / sum
        } else {
            0.0
        };
        shares.map(|share| share * scale)
    }
}

/// Adds a rigid body to the transition piece, with its weight.
pub(super) fn add_platform(
    equations: &mut Equations,
    node: usize,
    body: &RigidBody,
    gravity_m_per_s2: f64,
) {
    let matrices = &mut equations.nodes[node];
    let inertia = spatial_inertia(body.mass_kg, body.center_m, &body.inertia_kg_m2);
    add_scaled(&mut matrices[INERTIA], 1.0, &inertia);
    let weight_n = body.mass_kg * gravity_m_per_s2;
    add_scaled(
        &mut matrices[GEOMETRIC],
        weight_n,
        &turning_over(body.center_m),
    );
}

/// Adds a tower to a frame, with its base `rise_m` (m) above the transition piece. Returns the node
/// of its base, and its elements in changed coordinates.
fn add_tower(
    equations: &mut Equations,
    branch: &Branch,
    node: usize,
    rise_m: f64,
) -> (usize, Vec<Element>) {
    let foot = add_rigidly(equations, (node, rise_m), branch.base);
    let (mut parent, mut elements) = (foot, Vec::with_capacity(branch.links.len()));
    for link in &branch.links {
        let child = add_node(equations, &link.body);
        let element = Element::new(link.transfer, link.tips.clone(), link.matrices.clone());
        let [inertia, ground, geometric] = element.matrices.clone();
        equations.links.push(Link {
            parent: Some(parent),
            child,
            transfer: element.transfer,
            tip: element.tip.clone(),
            first: equations.unknowns,
            coordinates: element.coordinates,
            own: 1.0,
            matrices: [inertia, ground, geometric, Vec::new()],
        });
        equations.unknowns += element.coordinates;
        elements.push(element);
        parent = child;
    }
    (foot, elements)
}

/// Adds a node with a body `rise_m` (m) above another one, on which it is fixed; returns it.
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
        matrices: [const { Vec::new() }; KINDS],
    });
    child
}

fn add_node(equations: &mut Equations, body: &[SpatialMatrix; 3]) -> usize {
    let [inertia, ground, geometric] = *body;
    equations.nodes.push([inertia, ground, geometric, NONE]);
    equations.nodes.len() - 1
}

/// The geometric stiffness of a unit weight at r on a rigid body: a force F of constant direction
/// has (F·r) 1 − ½ (r Fᵀ + F rᵀ) for rotations.
fn turning_over([x, y, z]: [f64; 3]) -> SpatialMatrix {
    let mut matrix = NONE;
    (matrix[3][3], matrix[4][4]) = (-z, -z);
    (matrix[3][5], matrix[5][3]) = (0.5 * x, 0.5 * x);
    (matrix[4][5], matrix[5][4]) = (0.5 * y, 0.5 * y);
    matrix
}

/// The factors of the matrices of a frame, and that of the coordinates' own stiffness.
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
        self.equations.unknowns
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
        self.equations.product(a, &mut self.sweep, x, out);
    }

    fn count_negative(&mut self, a: &Coefficients) -> usize {
        let (factors, own) = factors_of(a);
        let a = (&factors, own);
        self.equations.factorize(&self.order, a, &mut self.counted)
    }

    fn factorize(&mut self, a: &Coefficients) -> usize {
        let (factors, own) = factors_of(a);
        let a = (&factors, own);
        self.equations.factorize(&self.order, a, &mut self.factors)
    }

    fn solve(&mut self, x: &mut [f64]) {
        self.equations.solve(&self.order, &mut self.factors, x);
    }

    fn energy(&mut self, a: &Coefficients, x: &[f64]) -> f64 {
        let mut product = std::mem::take(&mut self.product);
        product.resize(x.len(), 0.0);
        self.product(a, x, &mut product);
        let energy = product.iter().zip(x).map(|(a, b)| a * b).sum();
        self.product = product;
        energy
    }

    fn strain_energies(&self, x: &[f64], part: &mut dyn FnMut(f64, f64)) {
        self.tower.strain_energies(&self.tower_vector(x), part);
    }

    fn resultant(&mut self, a: &Coefficients, x: &[f64], base_m: f64) -> Resultant {
        let of_all = self.energy(a, x);
        let own = self.tower_vector(x);
        let mut resultant = self.tower.resultant(a, &own, base_m);
        let of_tower = resultant.energy.iter().sum();
        let of_frame = self.energy_of_frame(of_all, of_tower, x);
        (0..6).for_each(|i| resultant.energy[i] += of_frame[i]);
        resultant
    }

    fn start(&mut self, out: &mut [f64]) {
        self.equations.start(out);
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
