//! The distribution of the energy of a mode over the motions.

/// A value for each motion of a bare tower.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ByMotion {
    /// Bending fore-aft.
    pub fore_aft: f64,
    /// Bending side-side.
    pub side_side: f64,
    /// Torsion.
    pub torsion: f64,
    /// Axial motion.
    pub axial: f64,
}

impl ByMotion {
    /// The sums of a vector's components (x, y, z, rotation about x, y, z) by motion.
    pub(crate) fn sums(components: [f64; 6]) -> Self {
        let [x, y, z, rx, ry, rz] = components;
        Self {
            fore_aft: x + ry,
            side_side: y + rx,
            torsion: rz,
            axial: z,
        }
    }

    /// The four values in the order of [`Motion::ALL`](crate::tower::Motion::ALL).
    pub fn values(&self) -> [f64; 4] {
        [self.fore_aft, self.side_side, self.torsion, self.axial]
    }

    /// As fractions of their sum; all zero if the sum is not positive relative to its terms.
    pub(crate) fn shares(&self) -> Self {
        let values = self.values();
        let (sum, size): (f64, f64) = (values.iter().sum(), values.iter().map(|x| x.abs()).sum());
        if sum > 1e-9 * size && sum.is_normal() {
            self.map(|value| value / sum)
        } else {
            Self::default()
        }
    }

    fn map(&self, change: impl Fn(f64) -> f64) -> Self {
        Self {
            fore_aft: change(self.fore_aft),
            side_side: change(self.side_side),
            torsion: change(self.torsion),
            axial: change(self.axial),
        }
    }
}

/// The fractions of a mode's kinetic and strain energy that belong to each motion; each of the two
/// sums to 1. The strain energy includes the foundation, soil, guy wires and geometric stiffness;
/// its fractions are all zero where there is none.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Energy {
    /// Kinetic energy.
    pub kinetic: ByMotion,
    /// Strain energy.
    pub strain: ByMotion,
}

impl Energy {
    /// The mean of the kinetic and the strain fractions; the kinetic fractions alone if there is no
    /// strain energy.
    pub fn mean(&self) -> ByMotion {
        let (k, s) = (&self.kinetic, &self.strain);
        if *s == ByMotion::default() {
            return *k;
        }
        ByMotion {
            fore_aft: 0.5 * (k.fore_aft + s.fore_aft),
            side_side: 0.5 * (k.side_side + s.side_side),
            torsion: 0.5 * (k.torsion + s.torsion),
            axial: 0.5 * (k.axial + s.axial),
        }
    }

    /// The same energy in the side-side plane, if it is in the fore-aft plane.
    pub(crate) fn turned_to_side_side(&self) -> Self {
        let turned = |parts: &ByMotion| ByMotion {
            fore_aft: parts.side_side,
            side_side: parts.fore_aft,
            ..*parts
        };
        Self {
            kinetic: turned(&self.kinetic),
            strain: turned(&self.strain),
        }
    }
}
