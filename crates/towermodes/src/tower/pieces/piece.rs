//! A linear piece of a tower: a tube of one material, or a table of properties, linear in height.

use super::super::description::{PropertyStation, Station};
use super::super::parts::material::Material;
use super::super::parts::properties::Properties;
use super::super::parts::surroundings::SoilStiffness;
use super::super::support::independent::Motion;
use super::environment::Environment;
use super::section::{Section, SectionMasses, Tube};
use super::shear::Shear;

/// The tower between two heights over which its profile is linear.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Height of the lower end, m.
    pub base_m: f64,
    /// Height of the upper end, m.
    pub top_m: f64,
    /// What is linear between them.
    pub profile: Profile,
    /// The soil and the water around it.
    pub environment: Environment,
}

/// What is linear over a piece.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Profile {
    /// Diameter and wall of a tube.
    Tube {
        /// The tube at the lower end.
        base: Tube,
        /// The tube at the upper end.
        top: Tube,
        /// The material; its density includes the outfitting factor.
        material: Material,
        /// The shear model.
        shear: Shear,
    },
    /// The columns of a property table.
    Table {
        /// The row at the lower end; its masses include the outfitting factor.
        base: Properties,
        /// The row at the upper end.
        top: Properties,
    },
}

impl Profile {
    /// The profile from the lower end of this piece to the upper end of another, if both have the
    /// same kind and material.
    fn up_to(&self, upper: &Self) -> Option<Self> {
        match (*self, *upper) {
            (
                Self::Tube {
                    base,
                    material,
                    shear,
                    ..
                },
                Self::Tube {
                    top,
                    material: other,
                    ..
                },
            ) => (material == other).then_some(Self::Tube {
                base,
                top,
                material,
                shear,
            }),
            (Self::Table { base, .. }, Self::Table { top, .. }) => Some(Self::Table { base, top }),
            _ => None,
        }
    }
}

impl Piece {
    /// Length, m.
    pub fn length_m(&self) -> f64 {
        self.top_m - self.base_m
    }

    /// The position of a height (m) in the piece: 0 at its base, 1 at its top.
    #[inline]
    fn share_at(&self, height_m: f64) -> f64 {
        (height_m - self.base_m) / self.length_m()
    }

    /// The section at a height (m) inside the piece.
    #[inline(always)]
    pub fn section_at(&self, height_m: f64) -> Section {
        let s = self.share_at(height_m);
        let mut section = match &self.profile {
            Profile::Tube {
                base,
                top,
                material,
                shear,
            } => {
                let tube = base.blend(top, s);
                let mut section = Section::of_tube(&tube, material, *shear);
                section.masses.water_kg_per_m = self.water_kg_per_m(&tube, s);
                section
            }
            Profile::Table { base, top } => {
                let mut section = base.blend(top, s);
                section.masses.water_kg_per_m = self.environment.added_kg_per_m_at(s);
                section
            }
        };
        section.soil = self.environment.soil_at(s);
        section
    }

    /// Mass that moves with a tube of it transversely, at the fraction `s` of its length, kg/m.
    #[inline]
    fn water_kg_per_m(&self, tube: &Tube, s: f64) -> f64 {
        self.environment.water_kg_per_m(tube) + self.environment.added_kg_per_m_at(s)
    }

    /// The soil springs at a height (m) inside the piece; none if there is no soil.
    #[inline]
    pub(super) fn soil_at(&self, height_m: f64) -> SoilStiffness {
        self.environment.soil_at(self.share_at(height_m))
    }

    /// The masses of [`section_at`](Self::section_at).
    #[inline]
    pub(super) fn masses_at(&self, height_m: f64) -> SectionMasses {
        match &self.profile {
            Profile::Tube {
                base,
                top,
                material,
                ..
            } => {
                let s = self.share_at(height_m);
                let tube = base.blend(top, s);
                SectionMasses {
                    water_kg_per_m: self.water_kg_per_m(&tube, s),
                    ..SectionMasses::of_tube(&tube, material)
                }
            }
            Profile::Table { .. } => self.section_at(height_m).masses,
        }
    }

    /// Whether both bending planes are equal.
    #[inline]
    pub fn planes_are_equal(&self) -> bool {
        self.stiff_planes_are_equal() && self.soil_is_round()
    }

    /// Whether the sections are as stiff and heavy in both planes.
    #[inline]
    pub fn stiff_planes_are_equal(&self) -> bool {
        match &self.profile {
            Profile::Tube { .. } => true,
            Profile::Table { base, top } => base.planes_are_equal() && top.planes_are_equal(),
        }
    }

    fn soil_is_round(&self) -> bool {
        let is_round =
            |soil: &SoilStiffness| soil.transverse().are_equal() && soil.rotation().are_equal();
        self.environment
            .soil
            .is_none_or(|ends| ends.iter().all(is_round))
    }

    /// Whether it is rigid in this motion.
    pub(crate) fn is_rigid_in(&self, motion: Motion) -> bool {
        let Profile::Table { base, .. } = &self.profile else {
            return false;
        };
        match motion {
            Motion::Bending(_) => false,
            Motion::Torsion => base.torsion_n_m2.is_infinite(),
            Motion::Axial => base.axial_n.is_infinite(),
        }
    }

    /// Whether it deforms in shear.
    pub fn shears(&self) -> bool {
        match &self.profile {
            Profile::Tube { shear, .. } => *shear != Shear::Rigid,
            Profile::Table { base, .. } => base.shear_n.is_some(),
        }
    }

    /// Whether the largest ratio, thick end to thin end, of the properties on which the compliances
    /// between two heights (m) depend is more than `most`.
    #[inline]
    pub(crate) fn is_steeper(&self, base_m: f64, top_m: f64, most: f64) -> bool {
        let Profile::Tube { base, top, .. } = &self.profile else {
            return ratio(self.steepest(base_m, top_m)) > most;
        };
        // Without divisions: this is asked for each segment.
        let at = |height_m| base.blend(top, self.share_at(height_m));
        let (a, b) = (at(base_m), at(top_m));
        let changes = |x: f64, y: f64| x.max(y) > most * x.min(y);
        changes(a.outer_diameter_m, b.outer_diameter_m)
            || changes(a.wall_thickness_m, b.wall_thickness_m)
    }

    /// The height (m) between two others that halves what is steepest between them: there it is the
    /// geometric mean of what it is at both. None if its ratio at the two is no more than `most`,
    /// or if there is no number between them.
    pub fn even_cut_m(&self, base_m: f64, top_m: f64, most: f64) -> Option<f64> {
        let (a, b) = self.steepest(base_m, top_m);
        // It is linear: a + s (b − a) = √(ab).
        let cut_m = base_m + (top_m - base_m) * a.sqrt() / (a.sqrt() + b.sqrt());
        (ratio((a, b)) > most && base_m < cut_m && cut_m < top_m).then_some(cut_m)
    }

    /// The property with the largest ratio at two heights (m), of those on which the compliances
    /// depend: its values at both heights.
    fn steepest(&self, base_m: f64, top_m: f64) -> (f64, f64) {
        let steeper = |x: (f64, f64), y| if ratio(y) > ratio(x) { y } else { x };
        match &self.profile {
            Profile::Tube { base, top, .. } => {
                let at = |height_m| base.blend(top, self.share_at(height_m));
                let (a, b) = (at(base_m), at(top_m));
                steeper(
                    (a.outer_diameter_m, b.outer_diameter_m),
                    (a.wall_thickness_m, b.wall_thickness_m),
                )
            }
            Profile::Table { base, top } => {
                let at = |height_m| {
                    let s = self.share_at(height_m);
                    let columns = base.stiffnesses().into_iter().zip(top.stiffnesses());
                    columns.map(move |(a, b)| a + s * (b - a))
                };
                // A missing shear stiffness is zero at both ends: the ratio is NaN, and the
                // comparison is false.
                at(base_m).zip(at(top_m)).fold((1.0, 1.0), steeper)
            }
        }
    }

    /// Whether `upper`, which begins where this piece ends, begins with the section this one ends
    /// with.
    pub fn meets(&self, upper: &Self) -> bool {
        let height_m = self.top_m;
        is_same(&self.section_at(height_m), &upper.section_at(height_m))
    }

    /// The part between two heights (m), without soil and water; for the whole range the piece is
    /// unchanged.
    pub(crate) fn part(&self, base_m: f64, top_m: f64) -> Self {
        let at = |height_m| self.share_at(height_m);
        let profile = match self.profile {
            Profile::Tube {
                base,
                top,
                material,
                shear,
            } => Profile::Tube {
                base: base.blend(&top, at(base_m)),
                top: base.blend(&top, at(top_m)),
                material,
                shear,
            },
            Profile::Table { base, top } => Profile::Table {
                base: base.row_at(&top, at(base_m)),
                top: base.row_at(&top, at(top_m)),
            },
        };
        Self {
            base_m,
            top_m,
            profile,
            environment: Environment::default(),
        }
    }

    /// The piece that covers both, if `upper` continues this piece linearly.
    fn joined(&self, upper: &Self) -> Option<Self> {
        let whole = Self {
            base_m: self.base_m,
            top_m: upper.top_m,
            profile: self.profile.up_to(&upper.profile)?,
            environment: self.environment,
        };
        let line = whole.section_at(self.top_m);
        let straight = is_same(&self.section_at(self.top_m), &line) && self.meets(upper);
        straight.then_some(whole)
    }
}

/// The ratio of the larger to the smaller.
fn ratio((x, y): (f64, f64)) -> f64 {
    if x > y { x / y } else { y / x }
}

/// Whether two sections differ only by rounding: a row can be divided by hand only if all digits
/// are written.
fn is_same(a: &Section, b: &Section) -> bool {
    let pairs = a.values().into_iter().zip(b.values());
    pairs
        .into_iter()
        .all(|(a, b)| a == b || (a - b).abs() <= 1e-11 * a)
}

/// How rows become linear pieces.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Rows {
    /// As few as possible: a row on the line between its neighbours does not divide a piece.
    Fewest,
    /// One piece between any two successive rows of different height.
    Each,
}

/// The linear pieces of a list of stations.
pub(crate) fn tube_pieces(
    stations: &[Station],
    materials: &[Material],
    outfitting_factor: f64,
    shear: Shear,
    rows: Rows,
) -> Vec<Piece> {
    let tube = |s: &Station| Tube {
        outer_diameter_m: s.outer_diameter_m,
        wall_thickness_m: s.wall_thickness_m,
    };
    let pieces = stations.windows(2).map(|pair| {
        let (below, above) = (&pair[0], &pair[1]);
        let mut material = materials[below.material];
        material.density_kg_per_m3 *= outfitting_factor;
        Piece {
            base_m: below.height_m,
            top_m: above.height_m,
            profile: Profile::Tube {
                base: tube(below),
                top: tube(above),
                material,
                shear,
            },
            environment: Environment::default(),
        }
    });
    pieces_with_length(pieces, rows)
}

/// The linear pieces of a property table.
pub(crate) fn table_pieces(
    properties: &[PropertyStation],
    outfitting_factor: f64,
    rows: Rows,
) -> Vec<Piece> {
    let pieces = properties.windows(2).map(|pair| Piece {
        base_m: pair[0].height_m,
        top_m: pair[1].height_m,
        profile: Profile::Table {
            base: pair[0].properties.heavier(outfitting_factor),
            top: pair[1].properties.heavier(outfitting_factor),
        },
        environment: Environment::default(),
    });
    pieces_with_length(pieces, rows)
}

/// Omits pieces without length and, for the fewest pieces, joins those that continue linearly.
fn pieces_with_length(pieces: impl Iterator<Item = Piece>, rows: Rows) -> Vec<Piece> {
    let pieces = pieces.filter(|piece| piece.top_m != piece.base_m);
    if rows == Rows::Each {
        return pieces.collect();
    }
    let mut fewest: Vec<Piece> = Vec::new();
    for piece in pieces {
        match fewest.last().and_then(|last| last.joined(&piece)) {
            Some(whole) => *fewest.last_mut().expect("joined to it") = whole,
            None => fewest.push(piece),
        }
    }
    fewest
}
