//! A complete tower file of a tower: its rows, its shapes, its damping.

use thiserror::Error;
use towermodes::{Method, Options, Plane, Planes, Tower};
use towermodes_analysis::elastodyn::{
    ConcentratedMass as ListedMass, DampingError, Generalized, ModelError, PlaneModes, PointMasses,
    Rows, RowsError, ShapesError, TowerModel, TowerPolynomial, TowerRows, TowerShapes,
    TowerStation, damping_to_write_percent, tower_rows, tower_shapes,
};

use super::tower_file::{ConcentratedMass, TowerFile, TowerRow};
use super::writer::header_with_heights;
use crate::note::Note;

/// Default number of elements of ElastoDyn towers, `TwrNodes`.
pub const DEFAULT_NODES: usize = 20;

/// The damping of a tower file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// This ratio without scaling, percent of critical.
    Written(f64),
    /// The values for which the tower with its RNA has this ratio, percent of critical.
    Wanted(f64),
}

/// How a tower file is made.
#[derive(Debug, Clone, PartialEq)]
pub struct MakeOptions {
    /// Height at which the flexible tower begins, m; by default the tower base.
    pub from_m: Option<f64>,
    /// How many rows.
    pub rows: Rows,
    /// Whether OpenFAST has the section of concentrated masses, as it does since 4.2; without it
    /// masses are spread over an element.
    pub has_concentrated_masses: bool,
    /// The damping.
    pub damping: Damping,
    /// Elements of ElastoDyn's tower, `TwrNodes`.
    pub nodes: usize,
    /// How the tower is solved for its shapes.
    pub solve: Options,
}

impl Default for MakeOptions {
    fn default() -> Self {
        Self {
            from_m: None,
            rows: Rows::Accurate,
            has_concentrated_masses: false,
            damping: Damping::Written(1.0),
            nodes: DEFAULT_NODES,
            solve: Options {
                method: Method::Spectral,
                ..Options::default()
            },
        }
    }
}

/// A tower file, and what it was made of.
#[derive(Debug, Clone, PartialEq)]
pub struct MadeTowerFile {
    /// The content of the file.
    pub content: TowerFile,
    /// The shapes with their fits.
    pub shapes: TowerShapes,
    /// The quantities that ElastoDyn computes from it.
    pub quantities: Planes<Generalized>,
    /// Notes for the user.
    pub notes: Vec<Note>,
}

/// Why a tower has no tower file.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MakeError {
    /// It has no shapes.
    #[error(transparent)]
    Shapes(#[from] ShapesError),
    /// It has no rows.
    #[error(transparent)]
    Rows(#[from] RowsError),
    /// ElastoDyn could not use it.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The damping cannot be.
    #[error(transparent)]
    Damping(#[from] DampingError),
}

/// Makes the tower file of a tower.
///
/// # Errors
/// [`MakeError`].
pub fn make_tower_file(tower: &Tower, options: &MakeOptions) -> Result<MadeTowerFile, MakeError> {
    let from_m = options.from_m.unwrap_or(tower.base_m());
    let shapes = tower_shapes(tower, &options.solve, from_m)?;
    let masses = match options.has_concentrated_masses {
        true => PointMasses::Listed,
        false => PointMasses::Spread {
            parts: options.nodes,
        },
    };
    let rows = tower_rows(tower, from_m, options.rows, masses)?;
    let mut content = content(tower, from_m, &rows, &shapes);
    let length_m = tower.top_m() - from_m;
    let coarseness = coarseness(tower, from_m, masses, &content, options)?;
    let model = content.model(length_m, options.nodes, tower.rna().mass_kg);
    let quantities = quantities(&content, &model)?;
    set_damping(&mut content, options.damping, &quantities, &shapes)?;
    let quantities = self::quantities(&content, &model)?;
    let mut notes = notes(tower, from_m, &shapes, options);
    notes.extend(coarseness);
    Ok(MadeTowerFile {
        content,
        shapes,
        quantities,
        notes,
    })
}

/// What so few rows make of the tower, if more than a thousandth of its mass or stiffness.
fn coarseness(
    tower: &Tower,
    from_m: f64,
    masses: PointMasses,
    content: &TowerFile,
    options: &MakeOptions,
) -> Result<Option<Note>, RowsError> {
    if options.rows == Rows::Accurate {
        return Ok(None);
    }
    let rows = tower_rows(tower, from_m, Rows::Accurate, masses)?;
    let length_m = tower.top_m() - from_m;
    let model = |content: &TowerFile| content.model(length_m, options.nodes, 0.0);
    let accurate = TowerFile {
        rows: rows.stations.iter().map(tower_row).collect(),
        ..content.clone()
    };
    let difference = model(&accurate).difference_from(&model(content));
    Ok((difference.largest() > 1e-3).then(|| {
        Note::new(format!(
            "{} rows change the mass of the tower by {:+.2} % and its flexibility by {:+.2} %; without --stations there are {}",
            content.rows.len(),
            100.0 * difference.mass,
            100.0 * difference.flexibility.fore_aft,
            accurate.rows.len()
        ))
    }))
}

fn tower_row(station: &TowerStation) -> TowerRow {
    TowerRow {
        height_fraction: station.height_fraction,
        mass_kg_per_m: station.mass_kg_per_m,
        fore_aft_n_m2: station.bending_n_m2.fore_aft,
        side_side_n_m2: station.bending_n_m2.side_side,
    }
}

fn content(tower: &Tower, from_m: f64, rows: &TowerRows, shapes: &TowerShapes) -> TowerFile {
    let what = match tower.name() {
        "" => "Tower file made by towermodes",
        name => name,
    };
    let mass = |mass: &ListedMass| ConcentratedMass {
        height_fraction: mass.height_fraction,
        mass_kg: mass.mass_kg,
    };
    TowerFile {
        header: header_with_heights(what, tower.top_m(), from_m),
        fore_aft_damping_percent: [1.0; 2],
        side_side_damping_percent: [1.0; 2],
        fore_aft_tuners: [1.0; 2],
        side_side_tuners: [1.0; 2],
        mass_factor: 1.0,
        fore_aft_factor: 1.0,
        side_side_factor: 1.0,
        rows: rows.stations.iter().map(tower_row).collect(),
        coefficients: shapes.coefficients(),
        concentrated_masses: rows.concentrated_masses.iter().map(mass).collect(),
    }
}

/// ElastoDyn's quantities of both planes.
///
/// # Errors
/// [`ModelError`].
pub fn quantities(
    content: &TowerFile,
    model: &TowerModel,
) -> Result<Planes<Generalized>, ModelError> {
    let modes = content.modes();
    Ok(Planes {
        fore_aft: model.generalized(Plane::ForeAft, &modes.fore_aft)?,
        side_side: model.generalized(Plane::SideSide, &modes.side_side)?,
    })
}

fn set_damping(
    content: &mut TowerFile,
    damping: Damping,
    quantities: &Planes<Generalized>,
    shapes: &TowerShapes,
) -> Result<(), DampingError> {
    let of = |plane: Plane, first: usize| -> Result<[f64; 2], DampingError> {
        let alone_hz = quantities.of(plane).frequency_alone_hz;
        let percent = |i: usize| match damping {
            Damping::Written(percent) => Ok(percent),
            Damping::Wanted(percent) => {
                let coupled_hz = shapes.shapes[first + i].frequency_hz;
                let percent = damping_to_write_percent(percent, alone_hz[i], coupled_hz);
                percent.map(in_decimals)
            }
        };
        Ok([percent(0)?, percent(1)?])
    };
    content.fore_aft_damping_percent = of(Plane::ForeAft, 0)?;
    content.side_side_damping_percent = of(Plane::SideSide, 2)?;
    Ok(())
}

/// A mode with more of its energy in torsion is taken with a word.
const MUCH_TORSION: f64 = 0.1;

/// Which modes were left out for their torsion, and which were taken with some: ElastoDyn's towers
/// have none.
pub fn torsion_notes(shapes: &TowerShapes) -> Vec<Note> {
    let left_out = shapes.passed_over.iter().map(|mode| {
        format!(
            "mode {} ({}, {:.4} Hz) is skipped: {:.0} % of its energy is torsion, which ElastoDyn's towers do not have",
            mode.number, mode.label, mode.frequency_hz, 100.0 * mode.torsion_share
        )
    });
    let taken = shapes.shapes.iter();
    let taken = taken.filter(|shape| shape.torsion_share > MUCH_TORSION).map(|shape| {
        format!(
            "{:.0} % of the energy of the {} ({:.4} Hz) is torsion, which ElastoDyn's towers do not have: only its bending is used",
            100.0 * shape.torsion_share, shape.label, shape.frequency_hz
        )
    });
    left_out.chain(taken).map(Note::new).collect()
}

/// A ratio in as many decimals as anybody reads.
fn in_decimals(percent: f64) -> f64 {
    (percent * 1e6).round() / 1e6
}

fn notes(tower: &Tower, from_m: f64, shapes: &TowerShapes, options: &MakeOptions) -> Vec<Note> {
    let mut notes = torsion_notes(shapes);
    let masses = tower.point_masses().iter();
    let above = masses.filter(|mass| mass.height_m >= from_m).count();
    if above > 0 && !options.has_concentrated_masses {
        notes.push(Note::new(format!(
            "{above} point mass{} distributed over 1/{} of the height each: OpenFAST has concentrated masses since 4.2 (--openfast 4.2)",
            if above == 1 { " is" } else { "es are" },
            options.nodes
        )));
    }
    let rotor = tower.rna();
    if rotor.mass_kg == 0.0 {
        notes.push(Note::new(
            "the shapes are those of a tower without RNA: with a rotor-nacelle assembly they differ",
        ));
    }
    notes
}

impl TowerFile {
    /// The modes that it describes.
    pub fn modes(&self) -> Planes<PlaneModes> {
        let [fa1, fa2, ss1, ss2] = self
            .coefficients
            .map(|coefficients| TowerPolynomial { coefficients });
        Planes {
            fore_aft: PlaneModes {
                shapes: [fa1, fa2],
                tuners: self.fore_aft_tuners,
                damping_percent: self.fore_aft_damping_percent,
            },
            side_side: PlaneModes {
                shapes: [ss1, ss2],
                tuners: self.side_side_tuners,
                damping_percent: self.side_side_damping_percent,
            },
        }
    }

    /// The tower model of ElastoDyn: flexible length (m), number of elements, mass (kg) on top,
    /// without gravity.
    pub fn model(
        &self,
        flexible_length_m: f64,
        nodes: usize,
        tower_top_mass_kg: f64,
    ) -> TowerModel {
        let station = |row: TowerRow| TowerStation {
            height_fraction: row.height_fraction,
            mass_kg_per_m: row.mass_kg_per_m,
            bending_n_m2: Planes {
                fore_aft: row.fore_aft_n_m2,
                side_side: row.side_side_n_m2,
            },
        };
        let mass = |mass: &ConcentratedMass| ListedMass {
            height_fraction: mass.height_fraction,
            mass_kg: mass.mass_kg,
        };
        TowerModel {
            flexible_length_m,
            nodes,
            stations: self.rows_to_the_top().map(station).collect(),
            mass_factor: self.mass_factor,
            stiffness_factors: Planes {
                fore_aft: self.fore_aft_factor,
                side_side: self.side_side_factor,
            },
            concentrated_masses: self.concentrated_masses.iter().map(mass).collect(),
            tower_top_mass_kg,
            gravity_m_per_s2: 0.0,
        }
    }
}
