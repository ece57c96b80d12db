//! The segments of a mesh with all data that do not depend on the mode: points of the quadratures,
//! slopes of the sections there, joints.

use std::ops::Range;

use crate::elements::Mesh;
use crate::tower::{
    Compliance, FlexibilitySlopes, MassSlopes, Piece, Plane, Profile, Section, SectionMasses,
    SoilStiffness, Tower, compliance, for_each_flexible_point, for_each_mass_point,
};

/// A point at which flexibilities are integrated.
pub(super) struct FlexiblePoint {
    pub(super) at: At,
    /// 1/EI in both planes, 1/EA, 1/GJ, 1/κGA in both planes.
    pub(super) flexibilities: [f64; 6],
    pub(super) slopes: FlexibilitySlopes,
}

/// A point at which masses are integrated.
pub(super) struct MassPoint {
    pub(super) at: At,
    pub(super) masses: SectionMasses,
    /// The soil springs at this point.
    pub(super) soil: [f64; SoilStiffness::SPRINGS],
    pub(super) slopes: MassSlopes,
}

/// The place and weight of a point.
#[derive(Clone, Copy)]
pub(super) struct At {
    pub(super) height_m: f64,
    pub(super) weight_m: f64,
    /// Its position as a fraction of the piece, and as a fraction of the segment.
    pub(super) of_piece: f64,
    pub(super) of_segment: f64,
}

/// A joint of a segment, or of one of its bending planes.
pub(super) struct Joint {
    pub(super) height_m: f64,
    /// The plane whose centre of flexibility is the position of the joint.
    pub(super) plane: Plane,
    pub(super) compression_n: f64,
    /// The section at the joint.
    pub(super) section: Section,
}

/// A segment: bodies between its joints, one more than there are joints.
pub(super) struct Segment {
    pub(super) piece: usize,
    pub(super) base_m: f64,
    pub(super) top_m: f64,
    /// Whether it is always the same fraction of its piece.
    pub(super) is_in_proportion: bool,
    pub(super) compliance: Compliance,
    pub(super) joints: Range<usize>,
    pub(super) flexible: Range<usize>,
    /// Index of the first mass point of its first body; those of the other bodies follow.
    pub(super) first_mass: usize,
    pub(super) top_compression_n: f64,
}

/// Number of mass points of a body.
pub(super) const MASS_POINTS: usize = 3;

/// All segments of a mesh.
#[derive(Default)]
pub(super) struct Segments {
    pub(super) segments: Vec<Segment>,
    pub(super) joints: Vec<Joint>,
    pub(super) flexible: Vec<FlexiblePoint>,
    pub(super) masses: Vec<MassPoint>,
}

impl Segments {
    pub(super) fn of(tower: &Tower, mesh: &Mesh) -> Self {
        let mut all = Self::default();
        for (span, borders) in mesh.spans_with_borders() {
            let piece = &tower.pieces()[span.piece];
            let is_in_proportion = (span.base_m, span.top_m) == (piece.base_m, piece.top_m);
            for border in borders.windows(2) {
                all.add(tower, span.piece, (border[0], border[1]), is_in_proportion);
            }
        }
        all
    }

    fn add(
        &mut self,
        tower: &Tower,
        index: usize,
        (base_m, top_m): (f64, f64),
        is_in_proportion: bool,
    ) {
        let piece = &tower.pieces()[index];
        let compliance = compliance(piece, base_m, top_m);
        let joints = self.joints.len();
        let flexible = self.flexible.len();
        let first_mass = self.masses.len();
        let planes: &[Plane] = match piece.profile {
            Profile::Tube { .. } => &[Plane::ForeAft],
            Profile::Table { .. } => &[Plane::ForeAft, Plane::SideSide],
        };
        let mut below_m = base_m;
        for plane in planes {
            let height_m = compliance.bending.of(*plane).elastic_centre_m;
            self.add_body(piece, (base_m, top_m), (below_m, height_m));
            self.joints.push(Joint {
                height_m,
                plane: *plane,
                compression_n: tower.compression_n(height_m),
                section: piece.section_at(height_m),
            });
            below_m = height_m;
        }
        self.add_body(piece, (base_m, top_m), (below_m, top_m));
        self.add_flexible(piece, base_m, top_m);
        self.segments.push(Segment {
            piece: index,
            base_m,
            top_m,
            is_in_proportion,
            compliance,
            joints: joints..self.joints.len(),
            flexible: flexible..self.flexible.len(),
            first_mass,
            top_compression_n: tower.compression_n(top_m),
        });
    }

    fn add_body(&mut self, piece: &Piece, segment: (f64, f64), (base_m, top_m): (f64, f64)) {
        for_each_mass_point(piece, base_m, top_m, |height_m, weight_m, masses| {
            let at = At::new(piece, segment, height_m, weight_m);
            let soil = piece.section_at(height_m).soil.values();
            let slopes = match &piece.profile {
                Profile::Tube {
                    base,
                    top,
                    material,
                    ..
                } => base
                    .blend(top, at.of_piece)
                    .mass_slopes(material, &piece.environment),
                Profile::Table { .. } => MassSlopes::default(),
            };
            self.masses.push(MassPoint {
                at,
                masses: *masses,
                soil,
                slopes,
            });
        });
    }

    fn add_flexible(&mut self, piece: &Piece, base_m: f64, top_m: f64) {
        let segment = (base_m, top_m);
        for_each_flexible_point(piece, base_m, top_m, |height_m, weight_m, section| {
            let at = At::new(piece, segment, height_m, weight_m);
            let (bending, shear) = (section.bending_n_m2, section.shear_flexibility_per_n);
            let slopes = match &piece.profile {
                Profile::Tube {
                    base,
                    top,
                    material,
                    shear,
                } => base
                    .blend(top, at.of_piece)
                    .flexibility_slopes(material, *shear),
                Profile::Table { .. } => FlexibilitySlopes::default(),
            };
            self.flexible.push(FlexiblePoint {
                at,
                flexibilities: [
                    1.0 / bending.fore_aft,
                    1.0 / bending.side_side,
                    1.0 / section.axial_n,
                    1.0 / section.torsion_n_m2,
                    shear.fore_aft,
                    shear.side_side,
                ],
                slopes,
            });
        });
    }
}

impl At {
    fn new(piece: &Piece, (base_m, top_m): (f64, f64), height_m: f64, weight_m: f64) -> Self {
        Self {
            height_m,
            weight_m,
            of_piece: (height_m - piece.base_m) / piece.length_m(),
            of_segment: (height_m - base_m) / (top_m - base_m),
        }
    }
}
