//! The section of a strip member: a circle or a rectangle, with a hole.

use std::f64::consts::PI;

use towermodes::frame::Rectangle;

/// The form of a section (MSecGeom).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Form {
    Circle,
    Rectangle,
}

/// A section; values are given at both ends and linear between them.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StripSection {
    /// A circle.
    Circle {
        /// Outer radius without growth, m.
        outer_radius_m: [f64; 2],
        /// Inner radius, m.
        inner_radius_m: [f64; 2],
    },
    /// A rectangle: at each end the lengths of the sides along the local axes x and y.
    Rectangle {
        /// Outer sides without growth, m.
        outer_sides_m: [[f64; 2]; 2],
        /// Sides of the hole, m.
        inner_sides_m: [[f64; 2]; 2],
    },
}

/// The outline of a section at one place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Outline {
    /// A circle of this radius (m).
    Circle(f64),
    /// A rectangle with sides along x and y (m).
    Rectangle([f64; 2]),
}

/// The value at a fraction of the distance between two ends, with linear interpolation.
pub(super) fn blend([from, to]: [f64; 2], fraction: f64) -> f64 {
    from + fraction * (to - from)
}

impl StripSection {
    pub(super) fn form(&self) -> Form {
        match self {
            Self::Circle { .. } => Form::Circle,
            Self::Rectangle { .. } => Form::Rectangle,
        }
    }

    /// Its outer outline without growth at a fraction of the length.
    pub(super) fn outer(&self, fraction: f64) -> Outline {
        match self {
            Self::Circle { outer_radius_m, .. } => {
                Outline::Circle(blend(*outer_radius_m, fraction))
            }
            Self::Rectangle { outer_sides_m, .. } => sides(outer_sides_m, fraction),
        }
    }

    /// Its inner outline.
    pub(super) fn inner(&self, fraction: f64) -> Outline {
        match self {
            Self::Circle { inner_radius_m, .. } => {
                Outline::Circle(blend(*inner_radius_m, fraction))
            }
            Self::Rectangle { inner_sides_m, .. } => sides(inner_sides_m, fraction),
        }
    }

    /// The volume per length (m²) that is multiplied by the coefficient of added mass along the
    /// axis, at a fraction of a stretch of this length (m) with growth: 2 π R² |dR/ds| for a
    /// circle, ½ (a |db/ds| + b |da/ds|) √(a b) for a rectangle.
    ///
    /// Source: `Morison.f90` (OpenFAST 5).
    pub(super) fn axial_reference_m2(
        &self,
        fraction: f64,
        growth_m: [f64; 2],
        length_m: f64,
    ) -> f64 {
        let slope = |[from, to]: [f64; 2]| (to - from).abs() / length_m;
        match self {
            Self::Circle { outer_radius_m, .. } => {
                let radius_m = [0, 1].map(|end| outer_radius_m[end] + growth_m[end]);
                let at_m = blend(radius_m, fraction);
                2.0 * PI * at_m * at_m * slope(radius_m)
            }
            Self::Rectangle { outer_sides_m, .. } => {
                let side = |i: usize| [0, 1].map(|end| outer_sides_m[end][i] + 2.0 * growth_m[end]);
                let [a, b] = [side(0), side(1)];
                let [at_a, at_b] = [a, b].map(|side| blend(side, fraction));
                0.5 * (at_a * slope(b) + at_b * slope(a)) * (at_a * at_b).sqrt()
            }
        }
    }

    /// The radii at both ends of the circles with the same area as the outer outline, m; for a
    /// circle its own radii.
    pub fn outer_radius_m(&self) -> [f64; 2] {
        [0.0, 1.0].map(|end| self.outer(end).radius_m())
    }

    /// The radii at both ends of the circles with the same area as the inner outline, m.
    pub fn inner_radius_m(&self) -> [f64; 2] {
        [0.0, 1.0].map(|end| self.inner(end).radius_m())
    }

    /// The part of it between two fractions of its length.
    pub(crate) fn part(&self, range: [f64; 2]) -> Self {
        let at = |radius_m: &[f64; 2]| range.map(|end| blend(*radius_m, end));
        let of_sides = |[[a, b], [c, d]]: &[[f64; 2]; 2]| {
            range.map(|end| [blend([*a, *c], end), blend([*b, *d], end)])
        };
        match self {
            Self::Circle {
                outer_radius_m,
                inner_radius_m,
            } => Self::Circle {
                outer_radius_m: at(outer_radius_m),
                inner_radius_m: at(inner_radius_m),
            },
            Self::Rectangle {
                outer_sides_m,
                inner_sides_m,
            } => Self::Rectangle {
                outer_sides_m: of_sides(outer_sides_m),
                inner_sides_m: of_sides(inner_sides_m),
            },
        }
    }
}

fn sides([from, to]: &[[f64; 2]; 2], fraction: f64) -> Outline {
    Outline::Rectangle([0, 1].map(|side| blend([from[side], to[side]], fraction)))
}

impl Outline {
    /// The outline with growth of a thickness (m) around it.
    pub(super) fn grown(self, thickness_m: f64) -> Self {
        match self {
            Self::Circle(radius_m) => Self::Circle(radius_m + thickness_m),
            Self::Rectangle(sides_m) => {
                Self::Rectangle(sides_m.map(|side| side + 2.0 * thickness_m))
            }
        }
    }

    pub(super) fn area_m2(self) -> f64 {
        match self {
            Self::Circle(radius_m) => PI * radius_m * radius_m,
            Self::Rectangle(sides_m) => solid(sides_m).area_m2(),
        }
    }

    /// Second moments of area about the local axes x and y, m⁴.
    pub(super) fn second_moments_m4(self) -> [f64; 2] {
        match self {
            Self::Circle(radius_m) => [0.25 * self.area_m2() * radius_m * radius_m; 2],
            Self::Rectangle(sides_m) => solid(sides_m).second_moments_m4(),
        }
    }

    /// The areas (m²) to which the coefficients of added mass along x and y refer: those of circles
    /// whose diameter is the side normal to this direction, π b²/4 and π a²/4.
    ///
    /// Source: `Morison.f90` (OpenFAST 5), distributed added mass of rectangular members.
    pub(super) fn reference_areas_m2(self) -> [f64; 2] {
        match self {
            Self::Circle(_) => [self.area_m2(); 2],
            Self::Rectangle([a, b]) => [0.25 * PI * b * b, 0.25 * PI * a * a],
        }
    }

    /// The radius of the circle of the same area, m.
    pub(super) fn radius_m(self) -> f64 {
        match self {
            Self::Circle(radius_m) => radius_m,
            Self::Rectangle([a, b]) => (a * b / PI).sqrt(),
        }
    }
}

fn solid([side_a_m, side_b_m]: [f64; 2]) -> Rectangle {
    Rectangle {
        side_a_m,
        side_b_m,
        wall_thickness_m: 0.0,
    }
}
