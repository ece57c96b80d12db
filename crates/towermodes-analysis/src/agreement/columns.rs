//! Integrals of mass and bending stiffness over any part of a tower.

use towermodes::tower::{Piece, Planes, PointMass, Tower, compliance};

/// Gauss-Legendre nodes and weights on [−1, 1] with three points: exact for EI of a tube, a quartic
/// in height.
const GAUSS_3: [(f64, f64); 3] = [
    (-0.774_596_669_241_483_4, 5.0 / 9.0),
    (0.0, 8.0 / 9.0),
    (0.774_596_669_241_483_4, 5.0 / 9.0),
];

/// Heights that differ by no more than this are equal, m: some files have steps 1 mm wide.
pub(super) const SAME_HEIGHT_M: f64 = 1.001e-3;

/// Whether two heights are equal apart from rounding in files.
pub(super) fn is_same_height(a_m: f64, b_m: f64) -> bool {
    (a_m - b_m).abs() <= SAME_HEIGHT_M
}

/// A range of heights of a tower.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HeightRange {
    /// The lower end in the datum of the stations, m.
    pub base_m: f64,
    /// The upper end, m.
    pub top_m: f64,
}

impl HeightRange {
    /// The heights of a tower.
    pub(super) fn of(tower: &Tower) -> Self {
        Self {
            base_m: tower.base_m(),
            top_m: tower.top_m(),
        }
    }

    /// Base to top, m.
    pub fn length_m(&self) -> f64 {
        self.top_m - self.base_m
    }

    /// The overlap with another range; its length is negative if there is none.
    pub(super) fn and(&self, other: &Self) -> Self {
        Self {
            base_m: self.base_m.max(other.base_m),
            top_m: self.top_m.min(other.top_m),
        }
    }

    /// Whether it contains a height, apart from rounding in files.
    pub(super) fn holds(&self, height_m: f64) -> bool {
        height_m >= self.base_m - SAME_HEIGHT_M && height_m <= self.top_m + SAME_HEIGHT_M
    }

    /// Equally spaced heights from the base to the top, both ends exactly.
    pub(super) fn heights_m(&self, count: usize) -> impl Iterator<Item = f64> + use<> {
        let Self { base_m, top_m } = *self;
        (0..count).map(move |k| {
            let s = k as f64 / (count - 1) as f64;
            base_m * (1.0 - s) + top_m * s
        })
    }
}

/// Integrals over a part of a tower's wall.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Integral {
    /// ∫ m dz, kg.
    pub(super) mass_kg: f64,
    /// ∫ m (z − z₀) dz, kg m.
    pub(super) moment_kg_m: f64,
    /// ∫ EI dz, N m³.
    pub(super) bending_n_m3: Planes<f64>,
}

impl Integral {
    fn and(self, other: Self) -> Self {
        Self {
            mass_kg: self.mass_kg + other.mass_kg,
            moment_kg_m: self.moment_kg_m + other.moment_kg_m,
            bending_n_m3: self.bending_n_m3.zip(other.bending_n_m3, |a, b| a + b),
        }
    }

    /// The properties of a part of one piece, about a height z₀.
    fn of_piece(piece: &Piece, part: HeightRange, reference_m: f64) -> Self {
        let (middle, half) = (0.5 * (part.base_m + part.top_m), 0.5 * part.length_m());
        let mut sum = Self::default();
        for (node, weight) in GAUSS_3 {
            let z = middle + half * node;
            let section = piece.section_at(z);
            let mass_kg = weight * half * section.masses.mass_kg_per_m;
            sum = sum.and(Self {
                mass_kg,
                moment_kg_m: mass_kg * (z - reference_m),
                bending_n_m3: section.bending_n_m2.map(|ei| weight * half * ei),
            });
        }
        sum
    }
}

/// The quantities of a tower along its height, with precomputed sums so that any part of the height
/// is a sum of few terms without subtraction.
pub(super) struct Columns<'a> {
    tower: &'a Tower,
    point_masses: &'a [PointMass],
    reference_m: f64,
    /// A binary tree of sums: entry i is the sum of entries 2i and 2i + 1, and the second half are
    /// the pieces.
    sums: Vec<Integral>,
}

impl<'a> Columns<'a> {
    /// The columns of a tower and its point masses, with moments about a height.
    pub(super) fn new(tower: &'a Tower, point_masses: &'a [PointMass], reference_m: f64) -> Self {
        let pieces = tower.pieces();
        let mut sums = vec![Integral::default(); pieces.len()];
        sums.extend(pieces.iter().map(|piece| {
            let (base_m, top_m) = (piece.base_m, piece.top_m);
            Integral::of_piece(piece, HeightRange { base_m, top_m }, reference_m)
        }));
        for i in (1..pieces.len()).rev() {
            sums[i] = sums[2 * i].and(sums[2 * i + 1]);
        }
        Self {
            tower,
            point_masses,
            reference_m,
            sums,
        }
    }

    /// The integrals of the wall over a part.
    pub(super) fn integral(&self, part: HeightRange) -> Integral {
        let pieces = self.tower.pieces();
        let first = pieces.partition_point(|piece| piece.top_m <= part.base_m);
        let end = pieces.partition_point(|piece| piece.base_m < part.top_m);
        let of = |index: usize| {
            let piece = &pieces[index];
            let (base_m, top_m) = (piece.base_m, piece.top_m);
            let shared = part.and(&HeightRange { base_m, top_m });
            Integral::of_piece(piece, shared, self.reference_m)
        };
        match end.saturating_sub(first) {
            0 => Integral::default(),
            1 => of(first),
            _ => of(first).and(self.sum(first + 1, end - 1)).and(of(end - 1)),
        }
    }

    /// The sum over the pieces from index `from` up to, but not including, index `to`.
    fn sum(&self, from: usize, to: usize) -> Integral {
        let pieces = self.tower.pieces().len();
        let (mut from, mut to) = (from + pieces, to + pieces);
        let mut sum = Integral::default();
        while from < to {
            if from % 2 == 1 {
                sum = sum.and(self.sums[from]);
                from += 1;
            }
            if to % 2 == 1 {
                to -= 1;
                sum = sum.and(self.sums[to]);
            }
            from /= 2;
            to /= 2;
        }
        sum
    }

    /// Mass, kg, and its first moment about the reference, kg m, of a part with its point masses.
    pub(super) fn mass(&self, part: HeightRange) -> (f64, f64) {
        let wall = self.integral(part);
        let masses = self.point_masses.iter();
        masses.filter(|mass| part.holds(mass.height_m)).fold(
            (wall.mass_kg, wall.moment_kg_m),
            |(kg, kg_m), mass| {
                let arm_m = mass.height_m - self.reference_m;
                (kg + mass.mass_kg, kg_m + mass.mass_kg * arm_m)
            },
        )
    }

    /// Mass per length, kg/m, and EI, N m², as means over a part.
    pub(super) fn means(&self, part: HeightRange) -> (f64, Planes<f64>) {
        let integral = self.integral(part);
        let mean = |sum: f64| sum / part.length_m();
        (mean(integral.mass_kg), integral.bending_n_m3.map(mean))
    }
}

/// ∫ (z_top − z)²/EI dz over a part: the deflection of its top by a unit force there, m/N.
pub(super) fn tip_flexibility(tower: &Tower, part: HeightRange) -> Planes<f64> {
    let of_piece = |piece: &Piece| {
        let (base_m, top_m) = (piece.base_m, piece.top_m);
        let shared = part.and(&HeightRange { base_m, top_m });
        if shared.base_m >= shared.top_m {
            return Planes::both(0.0);
        }
        let bending = compliance(piece, shared.base_m, shared.top_m).bending;
        bending.map(|plane| {
            let arm_m = part.top_m - plane.elastic_centre_m;
            plane.deflection_m_per_n + arm_m * arm_m * plane.bending_per_n_m
        })
    };
    let pieces = tower.pieces().iter().map(of_piece);
    pieces.fold(Planes::both(0.0), |sum, piece| sum.zip(piece, |a, b| a + b))
}
