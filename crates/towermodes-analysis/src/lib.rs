//! Analyses based on the natural modes of wind turbine towers.
//!
//! All results are computed from towers and their solutions. This crate reads no files and prints
//! nothing, so that a program, a report and a web page can use the same analyses.
//!
//! | question | function | module |
//! |---|---|---|
//! | How far do the methods differ? | [`compare`] | [`study`] |
//! | How do frequencies converge as the number of segments increases? | [`converge`] | [`study`] |
//! | Does the rotor excite a mode of the tower? | [`campbell`] | [`resonance`] |
//! | What are the modes of a turbine that turns? | [`coupled_campbell`] | [`whirl`] |
//! | What if the soil is softer? | [`soil_band`](soil_band::soil_band) | [`mod@soil_band`] |
//! | Do two descriptions describe the same tower? | [`agree`] | [`agreement`] |
//! | Which numbers do the frequencies depend on? | [`influences`] | [`influence`] |
//! | How are the modes damped? | [`damping()`] | [`mod@damping`] |
//! | Which mode shapes does ElastoDyn need? | [`tower_shapes`] | [`elastodyn`] |
//!
//! With the feature `serde` results can be serialized, with `schema` they have JSON schemas.
//!
//! # Example
//! ```
//! use towermodes::{
//!     Material, Method, Options, Rna, Rotor, Solver, Station, Tower, TowerDescription,
//! };
//! use towermodes_analysis::agreement::AgreementLimits;
//! use towermodes_analysis::resonance::{CampbellOptions, StiffnessClass};
//! use towermodes_analysis::study::{ColumnSpec, Fineness};
//! use towermodes_analysis::{Verdict, agree, campbell, compare, converge, tower_shapes};
//!
//! let description = TowerDescription {
//!     materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
//!     stations: vec![Station::new(0.0, 6.0, 0.027), Station::new(87.6, 3.87, 0.019)],
//!     rna: Rna::point(350e3),
//!     ..TowerDescription::default()
//! };
//! let tower = Tower::new(description.clone())?;
//! let mut solver = Solver::new(Options { modes: 4, ..Options::default() });
//!
//! // compare: 60 lumped segments against the reference beam solution
//! let lumped = ColumnSpec { method: Method::Lumped, segments: Some(60) };
//! let comparison = compare(&tower, &[lumped], &mut solver, |_, _| ())?;
//! let difference = comparison.columns[0].relative_differences[0];
//! assert!(difference.is_some_and(|difference| difference.abs() < 1e-3));
//!
//! // converge: the error of the paper's element falls with the square of the number of segments
//! let levels = [20, 40, 80].map(Fineness::Segments);
//! let convergence = converge(&tower, &levels, &mut solver, |_| ())?;
//! let order = convergence.levels[2].orders[0];
//! assert!(order.is_some_and(|order| (order - 2.0).abs() < 0.1));
//!
//! // campbell: the rotor speed range 6.9 to 12.1 rpm and the first bending modes
//! let rotor = Rotor { blades: 3, lowest_rpm: 6.9, highest_rpm: 12.1 };
//! let solution = solver.solve(&tower)?;
//! let diagram = campbell(&tower, &solution, None, &rotor, &CampbellOptions::default())?;
//! assert_eq!(diagram.classes[0].1, StiffnessClass::SoftStiff);
//!
//! // agree: the tower against one with a top mass that is 10 t larger
//! let heavier = TowerDescription { rna: Rna::point(360e3), ..description.clone() };
//! let agreement = agree(&description, &heavier, &AgreementLimits::default())?;
//! assert_eq!(agreement.mass_kg.verdict, Verdict::Pass);
//! assert_eq!(agreement.verdict, Verdict::Fail);
//!
//! // tower_shapes: polynomials of x² to x⁶ for ElastoDyn, from the base up
//! let shapes = tower_shapes(&tower, &solver.options, tower.base_m())?;
//! let sum: f64 = shapes.coefficients()[0].iter().sum();
//! assert!((sum - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod agreement;
mod assignment;
pub mod damping;
pub mod elastodyn;
pub mod influence;
mod mac;
pub mod resonance;
pub mod soil_band;
pub mod study;
mod verdict;
pub mod whirl;

pub use agreement::agree;
pub use damping::damping;
pub use elastodyn::tower_shapes;
pub use influence::influences;
pub use mac::mac;
pub use resonance::campbell;
pub use study::{compare, converge};
pub use verdict::Verdict;
pub use whirl::coupled_campbell;
