//! A tower for ElastoDyn: the rows, masses, shapes and damping of its tower file, and the
//! quantities that ElastoDyn computes from them.

use thiserror::Error;

use super::damping::{DampingError, damping_to_write_percent};
use super::generalized::Generalized;
use super::model::{ModelError, PlaneModes, TowerModel};
use super::model_difference::ModelDifference;
use super::shapes::{ShapesError, TowerShapes, tower_shapes};
use super::stations::{PointMasses, Rows, RowsError, tower_rows};
use towermodes::tower::{Plane, Planes, Tower};
use towermodes::{Method, Options};

/// The default number of elements of ElastoDyn's towers, `TwrNodes`.
pub const DEFAULT_NODES: usize = 20;

/// The structural damping of a tower file.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Damping {
    /// Writes this ratio, percent of critical.
    Written(f64),
    /// Writes the ratio for which the tower with its rotor-nacelle assembly has this damping ratio,
    /// percent of critical.
    Wanted(f64),
    /// Writes these ratios of the first and second mode, percent of critical.
    Kept(Planes<[f64; 2]>),
}

/// Options for the ElastoDyn file of a tower.
#[derive(Debug, Clone, PartialEq)]
pub struct MakeOptions {
    /// Height at which the flexible tower begins, m; by default the base of the tower.
    pub from_m: Option<f64>,
    /// The number of rows.
    pub rows: Rows,
    /// Whether the tower file has the section of concentrated masses, which OpenFAST reads from
    /// version 4.2 on; without it each mass is distributed over an element.
    pub has_concentrated_masses: bool,
    /// The structural damping.
    pub damping: Damping,
    /// The number of elements of ElastoDyn's tower, `TwrNodes`.
    pub nodes: usize,
    /// The options of the solution that gives the shapes.
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

/// A tower for ElastoDyn.
#[derive(Debug, Clone, PartialEq)]
pub struct MadeTower {
    /// Height at which the flexible tower begins, m.
    pub from_m: f64,
    /// The shapes with their fits.
    pub shapes: TowerShapes,
    /// The rows and masses; all factors are 1.
    pub model: TowerModel,
    /// The rounded shapes with the damping ratios to write; all tuners are 1.
    pub modes: Planes<PlaneModes>,
    /// The quantities that ElastoDyn computes from model and modes.
    pub quantities: Planes<Generalized>,
    /// The number of point masses that are distributed over one element each.
    pub spread_masses: usize,
    /// The change of the tower due to the small number of rows; none if it is at most a thousandth.
    pub coarseness: Option<Coarseness>,
}

/// The change of a tower due to a small number of rows.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Coarseness {
    /// The number of rows that an accurate tower needs.
    pub accurate_rows: usize,
    /// The difference of the tower with the requested rows from the accurate one.
    pub difference: ModelDifference,
}

/// Why a tower cannot become a tower of ElastoDyn.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum MakeError {
    /// The tower has no shapes.
    #[error(transparent)]
    Shapes(#[from] ShapesError),
    /// The tower has no rows.
    #[error(transparent)]
    Rows(#[from] RowsError),
    /// ElastoDyn cannot compute with the tower.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The damping ratio cannot be written.
    #[error(transparent)]
    Damping(#[from] DampingError),
}

/// Makes the rows, masses, shapes and damping ratios of the tower file of a tower, and computes
/// ElastoDyn's quantities from them.
///
/// # Errors
/// [`MakeError`]: the tower has no shapes or no rows, or the damping ratio cannot be written.
///
/// # Example
/// ```
/// use towermodes::{Material, Rna, Station, Tower, TowerDescription};
/// use towermodes_analysis::elastodyn::{MakeOptions, make_tower};
///
/// let tower = Tower::new(TowerDescription {
///     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
///     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
///     rna: Rna::point(350e3),
///     ..TowerDescription::default()
/// })?;
/// let made = make_tower(&tower, &MakeOptions::default())?;
/// assert_eq!(made.model.stations[0].height_fraction, 0.0);
/// assert_eq!(made.modes.fore_aft.damping_percent, [1.0, 1.0]);
/// // Without the rotor-nacelle assembly the tower is faster.
/// let alone_hz = made.quantities.fore_aft.frequency_alone_hz[0];
/// assert!(alone_hz > made.shapes.shapes[0].frequency_hz);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn make_tower(tower: &Tower, options: &MakeOptions) -> Result<MadeTower, MakeError> {
    let from_m = options.from_m.unwrap_or(tower.base_m());
    let shapes = tower_shapes(tower, &options.solve, from_m)?;
    let model = model(tower, from_m, options, options.rows)?;
    let coarseness = coarseness(tower, from_m, options, &model)?;
    let mut modes = modes(&shapes);
    let undamped = model.both_planes(&modes)?;
    set_damping(&mut modes, options.damping, &undamped, &shapes)?;
    let masses = tower.point_masses().iter();
    let above = masses.filter(|mass| mass.height_m >= from_m).count();
    Ok(MadeTower {
        from_m,
        quantities: model.both_planes(&modes)?,
        shapes,
        model,
        modes,
        spread_masses: if options.has_concentrated_masses {
            0
        } else {
            above
        },
        coarseness,
    })
}

/// The rows and masses of a tower, all factors 1, without gravity.
fn model(
    tower: &Tower,
    from_m: f64,
    options: &MakeOptions,
    rows: Rows,
) -> Result<TowerModel, RowsError> {
    let masses = match options.has_concentrated_masses {
        true => PointMasses::Listed,
        false => PointMasses::Spread {
            parts: options.nodes,
        },
    };
    let rows = tower_rows(tower, from_m, rows, masses)?;
    Ok(TowerModel {
        flexible_length_m: tower.top_m() - from_m,
        nodes: options.nodes,
        stations: rows.stations,
        mass_factor: 1.0,
        stiffness_factors: Planes::both(1.0),
        concentrated_masses: rows.concentrated_masses,
        tower_top_mass_kg: tower.rna().mass_kg,
        gravity_m_per_s2: 0.0,
    })
}

/// The change of the tower by the requested rows, if it is more than a thousandth of its mass or
/// flexibility.
fn coarseness(
    tower: &Tower,
    from_m: f64,
    options: &MakeOptions,
    coarse: &TowerModel,
) -> Result<Option<Coarseness>, RowsError> {
    if options.rows == Rows::Accurate {
        return Ok(None);
    }
    let accurate = TowerModel {
        concentrated_masses: coarse.concentrated_masses.clone(),
        ..model(tower, from_m, options, Rows::Accurate)?
    };
    let difference = accurate.difference_from(coarse);
    Ok((difference.largest() > 1e-3).then_some(Coarseness {
        accurate_rows: accurate.stations.len(),
        difference,
    }))
}

/// The rounded shapes with tuners of 1 and a damping of 1 %.
fn modes(shapes: &TowerShapes) -> Planes<PlaneModes> {
    let of = |plane| PlaneModes {
        shapes: shapes.polynomials(plane),
        tuners: [1.0; 2],
        damping_percent: [1.0; 2],
    };
    Planes {
        fore_aft: of(Plane::ForeAft),
        side_side: of(Plane::SideSide),
    }
}

fn set_damping(
    modes: &mut Planes<PlaneModes>,
    damping: Damping,
    quantities: &Planes<Generalized>,
    shapes: &TowerShapes,
) -> Result<(), DampingError> {
    let planes = [
        (Plane::ForeAft, &mut modes.fore_aft),
        (Plane::SideSide, &mut modes.side_side),
    ];
    for (shapes, (plane, modes)) in shapes.shapes.chunks(2).zip(planes) {
        let alone_hz = quantities.of(plane).frequency_alone_hz;
        for (i, ((percent, alone_hz), shape)) in
            (modes.damping_percent.iter_mut().zip(alone_hz).zip(shapes)).enumerate()
        {
            *percent = match damping {
                Damping::Written(percent) => percent,
                Damping::Kept(percent) => percent.of(plane)[i],
                Damping::Wanted(wanted) => {
                    let exact = damping_to_write_percent(wanted, alone_hz, shape.frequency_hz)?;
                    in_decimals(exact)
                }
            };
        }
    }
    Ok(())
}

/// A ratio in six decimals, as it is written.
fn in_decimals(percent: f64) -> f64 {
    (percent * 1e6).round() / 1e6
}
