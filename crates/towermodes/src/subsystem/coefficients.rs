//! Linear combinations of the matrices of a subsystem.

/// The coefficients of A = `stiffness`·1 + `mass`·M + `foundation`·S + `geometric`·G.
///
/// 1 is the stiffness of the joints or elements, which is the identity in scaled coordinates; M is
/// the inertia; S is the stiffness to the ground (foundation, soil, guy wires); G is the geometric
/// stiffness of self-weight, which is negative semidefinite (P-Delta effect).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coefficients {
    /// Coefficient of the stiffness of the joints or elements.
    pub stiffness: f64,
    /// Coefficient of the inertia, 1/s².
    pub mass: f64,
    /// Coefficient of the stiffness to the ground.
    pub foundation: f64,
    /// Coefficient of the geometric stiffness.
    pub geometric: f64,
}

impl Coefficients {
    const NONE: Self = Self {
        stiffness: 0.0,
        mass: 0.0,
        foundation: 0.0,
        geometric: 0.0,
    };
    /// M.
    pub const MASS: Self = Self {
        mass: 1.0,
        ..Self::NONE
    };
    /// S.
    pub const FOUNDATION: Self = Self {
        foundation: 1.0,
        ..Self::NONE
    };
    /// 1 + S, the stiffness without gravity.
    pub const ELASTIC: Self = Self {
        stiffness: 1.0,
        ..Self::FOUNDATION
    };
    /// 1 + S + G, the stiffness.
    pub const STIFFNESS: Self = Self {
        geometric: 1.0,
        ..Self::ELASTIC
    };
    /// −G, by how much gravity reduces the stiffness.
    pub const GRAVITY: Self = Self {
        geometric: -1.0,
        ..Self::NONE
    };

    /// The coefficients of A − `shift`·B.
    #[must_use]
    pub fn minus(self, shift: f64, other: Self) -> Self {
        Self {
            stiffness: self.stiffness - shift * other.stiffness,
            mass: self.mass - shift * other.mass,
            foundation: self.foundation - shift * other.foundation,
            geometric: self.geometric - shift * other.geometric,
        }
    }
}

/// To which matrix of a subsystem a contribution belongs.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MatrixKind {
    /// The inertia M.
    Inertia,
    /// The stiffness to the ground S.
    Foundation,
}
