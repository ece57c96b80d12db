//! Tabulated properties of sections: the beams of windIO.

use super::super::text::outline::Version;
use super::super::text::reading::Reading;
use super::super::text::yaml::Node;
use super::curve::Curve;
use crate::diagnostic::Diagnostic;
use crate::note::Note;

/// Couplings below this fraction of the bending stiffness, and offsets below this many metres, are
/// negligible.
const NOISE: f64 = 1e-6;

/// A quantity that is the product of curves.
#[derive(Debug, Clone)]
pub(crate) struct Quantity(pub(crate) Vec<Curve>);

impl Quantity {
    pub(crate) fn below(&self, s: f64) -> f64 {
        self.0.iter().map(|curve| curve.below(s)).product()
    }

    pub(crate) fn above(&self, s: f64) -> f64 {
        self.0.iter().map(|curve| curve.above(s)).product()
    }

    fn is_zero(&self) -> bool {
        self.0.iter().any(|c| c.values().iter().all(|&v| v == 0.0))
    }

    /// The quantity, unless it is zero everywhere, as the defaults of the format are.
    fn if_given(self) -> Option<Self> {
        (!self.is_zero()).then_some(self)
    }
}

/// The properties of the sections along a part. Fore-aft is bending about y (K55), side-side about
/// x (K44).
#[derive(Debug, Clone)]
pub(crate) struct Elastic {
    /// Mass per length including outfitting, kg/m.
    pub(crate) mass: Quantity,
    /// EI, N m²: fore-aft, side-side.
    pub(super) bending: [Quantity; 2],
    /// GJ, N m².
    pub(super) torsion: Option<Quantity>,
    /// EA, N.
    pub(crate) axial: Option<Quantity>,
    /// Shear stiffness, N: fore-aft, side-side.
    pub(crate) shear: Option<[Quantity; 2]>,
    /// Rotary inertia per length for bending, kg m: fore-aft, side-side.
    pub(super) rotary: Option<[Quantity; 2]>,
    /// Inertia per length about the axis, kg m.
    pub(crate) polar: Option<Quantity>,
}

impl Elastic {
    /// The beam of a part, if it has one.
    pub(crate) fn read(
        part: &Node,
        what: &str,
        version: Version,
        reading: &mut Reading<'_>,
    ) -> Result<Option<Self>, Diagnostic> {
        if version == Version::Two {
            let beam = part.find(&["structure", "elastic_properties"]);
            // A beam may be there for its point masses alone.
            let beam = beam.filter(|beam| {
                beam.get("stiffness_matrix").is_some() || beam.get("inertia_matrix").is_some()
            });
            return beam.map(|beam| matrices(beam, what, reading)).transpose();
        }
        let Some(tables) = part.get("elastic_properties_mb") else {
            return Ok(None);
        };
        if let Some(beam) = tables.get("six_x_six") {
            return six_by_six(beam, what, reading).map(Some);
        }
        if let Some(beam) = tables.get("timoschenko_hawc") {
            return timoshenko(beam, what, reading).map(Some);
        }
        let beam = tables.get("cp_lambda_beam");
        beam.map(|beam| cp_lambda(beam, what, reading)).transpose()
    }

    /// All its curves.
    pub(super) fn curves(&self) -> impl Iterator<Item = &Curve> {
        let pairs = [
            Some(&self.bending),
            self.shear.as_ref(),
            self.rotary.as_ref(),
        ];
        let single = [&self.torsion, &self.axial, &self.polar];
        let pairs = pairs.into_iter().flatten().flatten();
        let single = single.into_iter().flatten();
        let all = std::iter::once(&self.mass).chain(pairs).chain(single);
        all.flat_map(|quantity| &quantity.0)
    }

    fn new(
        mass: Quantity,
        bending: [Quantity; 2],
        stretch: [Option<Quantity>; 2],
        shear: [Option<Quantity>; 2],
        inertia: [Option<Quantity>; 3],
    ) -> Self {
        let given = |q: Option<Quantity>| q.and_then(Quantity::if_given);
        let both = |[a, b]: [Option<Quantity>; 2]| Some([given(a)?, given(b)?]);
        // Zero in one plane alone is no default.
        let either = |[a, b]: [Option<Quantity>; 2]| {
            let pair = [a?, b?];
            (!pair.iter().all(Quantity::is_zero)).then_some(pair)
        };
        let [torsion, axial] = stretch.map(given);
        let [fore_aft, side_side, polar] = inertia;
        Self {
            mass,
            bending,
            torsion,
            axial,
            shear: both(shear),
            rotary: either([fore_aft, side_side]),
            polar: given(polar),
        }
    }
}

/// Version 2: a stiffness matrix and an inertia matrix with named entries.
fn matrices(beam: &Node, what: &str, reading: &mut Reading<'_>) -> Result<Elastic, Diagnostic> {
    let what = format!("elastic properties of the {what}");
    let stiffness = beam.require("stiffness_matrix", &what)?;
    let inertia = beam.require("inertia_matrix", &what)?;
    let curve = |of: &Node, key: &str| {
        Curve::read_keys(of, key, &format!("{key} of the {what}")).map(|c| Quantity(vec![c]))
    };
    let optional = |of: &Node, key: &str| of.get(key).map(|_| curve(of, key)).transpose();
    let elastic = Elastic::new(
        curve(inertia, "mass")?,
        [curve(stiffness, "K55")?, curve(stiffness, "K44")?],
        [optional(stiffness, "K66")?, optional(stiffness, "K33")?],
        [optional(stiffness, "K11")?, optional(stiffness, "K22")?],
        [
            optional(inertia, "i_edge")?,
            optional(inertia, "i_flap")?,
            optional(inertia, "i_plr")?,
        ],
    );
    note_left_out(beam, &what, couplings(stiffness, inertia), reading);
    Ok(elastic)
}

/// The couplings and offsets that are not negligible.
fn couplings<'n>(stiffness: &'n Node, inertia: &'n Node) -> impl Iterator<Item = &'static str> {
    const COUPLINGS: [&str; 15] = [
        "K12", "K13", "K14", "K15", "K16", "K23", "K24", "K25", "K26", "K34", "K35", "K36", "K45",
        "K46", "K56",
    ];
    let largest = |of: &Node, key: &str| {
        let numbers = of.get(key).map_or(Ok(Vec::new()), |n| n.numbers(key));
        numbers.map_or(0.0, |n| n.iter().fold(0.0_f64, |a, b| a.max(b.abs())))
    };
    let limit = NOISE * largest(stiffness, "K44");
    let coupled = COUPLINGS
        .into_iter()
        .filter(move |key| largest(stiffness, key) > limit);
    let offset = ["cm_x", "cm_y"]
        .into_iter()
        .filter(move |key| largest(inertia, key) > NOISE);
    coupled.chain(offset)
}

fn note_left_out<'k>(
    beam: &Node,
    what: &str,
    keys: impl Iterator<Item = &'k str>,
    reading: &mut Reading<'_>,
) {
    let keys: Vec<&str> = keys.collect();
    if !keys.is_empty() {
        let message = format!(
            "{what}: couplings and offsets are left out ({}); the sections of the tower are centred",
            keys.join(", ")
        );
        reading.note_at(beam.span.start, Note::left_out(message));
    }
}

/// The indices of the diagonal entries in the upper triangle of a 6x6 matrix, row by row.
const DIAGONAL: [usize; 6] = [0, 6, 11, 15, 18, 20];

/// Version 1: the upper triangles of both matrices row by row, 21 values for each position.
fn six_by_six(beam: &Node, what: &str, reading: &mut Reading<'_>) -> Result<Elastic, Diagnostic> {
    let what = format!("six_x_six of the {what}");
    let stiffness = beam.require("stiff_matrix", &what)?;
    let inertia = beam.require("inertia_matrix", &what)?;
    let column = |of: &Node, column: usize, key: &str| {
        let curve = Curve::read_column(of, column, &format!("{key} of {what}"));
        curve.map(|curve| Quantity(vec![curve]))
    };
    let of_stiffness = |at: usize, key: &str| column(stiffness, at, key);
    let side_side = of_stiffness(15, "K44")?;
    let largest = |of: &Quantity| {
        of.0[0]
            .values()
            .iter()
            .fold(0.0, |a: f64, b| a.max(b.abs()))
    };
    let limit = NOISE * largest(&side_side);
    let mut coupled = false;
    for at in (0..21).filter(|at| !DIAGONAL.contains(at)) {
        coupled |= largest(&of_stiffness(at, "a coupling")?) > limit;
    }
    let elastic = Elastic::new(
        column(inertia, 0, "mass")?,
        [of_stiffness(18, "K55")?, side_side],
        [
            Some(of_stiffness(20, "K66")?),
            Some(of_stiffness(11, "K33")?),
        ],
        [Some(of_stiffness(0, "K11")?), Some(of_stiffness(6, "K22")?)],
        [
            Some(column(inertia, 18, "inertia about y")?),
            Some(column(inertia, 15, "inertia about x")?),
            Some(column(inertia, 20, "inertia about z")?),
        ],
    );
    let keys = coupled.then_some("entries beside the diagonal");
    note_left_out(beam, &what, keys.into_iter(), reading);
    Ok(elastic)
}

/// Version 1: the columns of HAWC2.
fn timoshenko(beam: &Node, what: &str, reading: &mut Reading<'_>) -> Result<Elastic, Diagnostic> {
    let what = format!("timoschenko_hawc of the {what}");
    let curve = |key: &str| {
        let node = beam.require(key, &what)?;
        Curve::read(node, &format!("{key} of {what}"))
    };
    let (mass, e, g, area) = (curve("dm")?, curve("E")?, curve("G")?, curve("A")?);
    let of = |factors: &[&Curve]| Quantity(factors.iter().map(|&c| c.clone()).collect());
    let (radius_x, radius_y) = (curve("ri_x")?, curve("ri_y")?);
    let elastic = Elastic::new(
        of(&[&mass]),
        [of(&[&e, &curve("I_y")?]), of(&[&e, &curve("I_x")?])],
        [Some(of(&[&g, &curve("K")?])), Some(of(&[&e, &area]))],
        [
            Some(of(&[&curve("k_x")?, &g, &area])),
            Some(of(&[&curve("k_y")?, &g, &area])),
        ],
        [
            Some(of(&[&mass, &radius_y, &radius_y])),
            Some(of(&[&mass, &radius_x, &radius_x])),
            None,
        ],
    );
    note_offsets(
        beam,
        &what,
        &["x_cg", "y_cg", "x_sh", "y_sh", "x_e", "y_e"],
        reading,
    );
    Ok(elastic)
}

/// Version 1: the columns of Cp-Lambda, axis 3 along the beam.
fn cp_lambda(beam: &Node, what: &str, reading: &mut Reading<'_>) -> Result<Elastic, Diagnostic> {
    let what = format!("cp_lambda_beam of the {what}");
    let curve = |key: &str| {
        let node = beam.require(key, &what)?;
        Curve::read(node, &format!("{key} of {what}")).map(|curve| Quantity(vec![curve]))
    };
    let elastic = Elastic::new(
        curve("dm")?,
        [curve("E22")?, curve("E11")?],
        [Some(curve("GJ")?), Some(curve("EA")?)],
        [Some(curve("T11")?), Some(curve("T22")?)],
        [Some(curve("J2")?), Some(curve("J1")?), Some(curve("J3")?)],
    );
    note_offsets(
        beam,
        &what,
        &["x_cg", "y_cg", "x_sh", "y_sh", "x_ce", "y_ce"],
        reading,
    );
    Ok(elastic)
}

fn note_offsets(beam: &Node, what: &str, keys: &[&'static str], reading: &mut Reading<'_>) {
    let is_offset = |key: &&&'static str| {
        let values = beam.find(&[**key, "values"]);
        let numbers = values.and_then(|values| values.numbers(key).ok());
        numbers.is_some_and(|n| n.iter().any(|v| v.abs() > NOISE))
    };
    note_left_out(beam, what, keys.iter().filter(is_offset).copied(), reading);
}
