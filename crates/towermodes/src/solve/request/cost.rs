//! Memory and time of a solve, estimated before anything is allocated.
//!
//! The Lanczos process keeps all its vectors and orthogonalizes each against all before it: for w
//! modes of a subsystem with n unknowns about p = 2.5 w + 12 vectors, 8 n p bytes and n p²
//! operations, and p³ for the projected matrix. The constants are fitted to runs on a processor of
//! 2020 (one core, 3 GHz). Estimates are 0.8 to 3 times the memory and 0.5 to 3 times the time that
//! was measured there.

use super::super::error::SolveError;
use super::super::on_mesh::cut::Cut;
use super::limits::{MAX_BYTES, MAX_SECONDS};
use super::options::Options;
use crate::Method;
use crate::elements::Element;
use crate::modes::ShapePoint;
use crate::subsystem::dimension;
use crate::tower::{Motion, Motions, Plane, Tower};

/// Bytes of a number.
const NUMBER: f64 = size_of::<f64>() as f64;
/// Seconds for a term of a sum of products.
const SECONDS_A_TERM: f64 = 1e-9;
/// Work of the diagonalizations of the projected matrix, in units of p³.
const DIAGONALIZATION: f64 = 1.5;
/// Degrees that the spectral method usually needs until the modes converge.
pub(crate) const DEGREES: f64 = 3.0;

/// Estimated memory and time of a solve.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Cost {
    /// Peak memory, bytes.
    pub(crate) bytes: f64,
    /// Time, s.
    pub(crate) seconds: f64,
    /// Degrees of freedom of the whole tower.
    pub(crate) unknowns: f64,
    /// Number of segments of all meshes together.
    pub(crate) segments: f64,
    /// Number of products with the mass matrix on each mesh.
    pub(crate) products: f64,
}

impl Cost {
    /// The cost of a tower with this mesh, the meshes of the error estimate included.
    pub(crate) fn of(tower: &Tower, cut: &Cut, options: &Options) -> Self {
        let own = cut.mesh.segments() as f64;
        let (finest, all) = match options.method {
            Method::Spectral => (own, DEGREES * own),
            method => {
                // One cut for each power of the error, and one to detect agreement by chance.
                let others = method.bending_powers(tower.shears()).len() + 1;
                ladder(cut, others)
            }
        };
        let costs = Costs::of(tower, cut, options);
        let (finest, meshes) = (costs.work(finest), all / own);
        let heights = options.points + tower.station_count() + options.heights_m.len();
        let shapes = options.modes as f64 * size_of::<ShapePoint>() as f64 * heights as f64;
        Self {
            bytes: finest.bytes + shapes,
            seconds: meshes * costs.work(own).seconds,
            unknowns: costs.unknowns_a_segment() * own,
            segments: all,
            products: costs.products(),
        }
    }

    /// The cost of one mesh of a blade; its time is not estimated.
    pub(crate) fn of_blade(unknowns: usize, segments: usize, modes: usize) -> Self {
        // The number of vectors per mode is that of a tower with elements of BModes, plus the mode.
        let vectors = (6 * modes + 20).min(2 * unknowns) as f64;
        Self {
            bytes: vectors * (unknowns * size_of::<f64>()) as f64,
            seconds: 0.0,
            unknowns: unknowns as f64,
            segments: segments as f64,
            products: vectors,
        }
    }

    /// Refuses a computation beyond the limits of memory and time.
    pub(crate) fn check(&self, modes: usize) -> Result<(), SolveError> {
        let degrees_of_freedom = self.unknowns as usize;
        if self.bytes > MAX_BYTES as f64 {
            return Err(SolveError::TooLarge {
                modes,
                degrees_of_freedom,
                bytes: self.bytes,
            });
        }
        if self.seconds > MAX_SECONDS {
            return Err(SolveError::TooSlow {
                modes,
                degrees_of_freedom,
                seconds: self.seconds,
            });
        }
        Ok(())
    }
}

/// Segments of the finest of the cuts that a solve needs, and of all together: coarser ones while
/// every span can be halved, then finer ones.
fn ladder(cut: &Cut, others: usize) -> (f64, f64) {
    let own = cut.mesh.segments();
    let spans = cut.mesh.spans_with_borders().map(|(span, _)| span.segments);
    let even = spans.map(usize::trailing_zeros).min().unwrap_or(0) as usize;
    let coarser = even.min(others);
    let finer = others - coarser;
    let others = (1..=coarser).map(|halvings| own as f64 / f64::from(1 << halvings));
    let others: f64 = others
        .chain((1..=finer).map(|d| own as f64 * f64::from(1 << d)))
        .sum();
    (own as f64 * f64::from(1 << finer), own as f64 + others)
}

/// The cost of work on a number of segments.
struct Work {
    bytes: f64,
    seconds: f64,
}

/// One subsystem.
struct SubsystemCost {
    /// Unknowns per segment.
    unknowns: f64,
    /// Bytes per segment, without vectors.
    bytes: f64,
    /// Terms of a product, for each unknown.
    terms: f64,
    /// Number of modes requested in it.
    modes: f64,
    /// Number of equal subsystems.
    multiplicity: f64,
}

struct Costs {
    subsystems: [Option<SubsystemCost>; Motion::ALL.len()],
    /// Vectors for w modes: coefficients of 1, w, w².
    vectors: [f64; 3],
}

impl Costs {
    fn of(tower: &Tower, cut: &Cut, options: &Options) -> Self {
        let sets = tower.independent_motions();
        let bends = |set: &Motions| set.iter().any(Motion::bends);
        let equal = tower.planes_are_equal();
        let side_side = Motions::only(Motion::Bending(Plane::SideSide));
        // Half of the modes are in each bending plane; the other subsystems have fewer.
        let planes = sets.iter().filter(|set| bends(set)).count().max(1);
        let mut subsystems = [const { None }; Motion::ALL.len()];
        for (index, (set, subsystem)) in sets.iter().zip(&mut subsystems).enumerate() {
            if equal && *set == side_side {
                continue;
            }
            let fraction = if bends(set) {
                1.0 / planes as f64
            } else {
                0.25
            };
            *subsystem = Some(SubsystemCost {
                modes: (fraction * options.modes as f64).ceil(),
                multiplicity: if equal && index == 0 { 2.0 } else { 1.0 },
                ..SubsystemCost::of(tower, set, cut, options)
            });
        }
        Self {
            subsystems,
            // The elements of BModes have clusters of high modes, which need more vectors.
            vectors: match options.method {
                Method::Bmodes => [12.0, 2.5, 0.05],
                Method::RmjeExact
                | Method::Rmje
                | Method::CardanicExact
                | Method::Cardanic
                | Method::Lumped
                | Method::Spectral => [12.0, 2.5, 0.0],
            },
        }
    }

    fn unknowns_a_segment(&self) -> f64 {
        let subsystems = self.subsystems.iter().flatten();
        subsystems.map(|s| s.multiplicity * s.unknowns).sum()
    }

    /// Number of Lanczos vectors for this number of modes.
    fn vectors(&self, modes: f64) -> f64 {
        let [a, b, c] = self.vectors;
        a + modes * (b + modes * c)
    }

    /// One product for each vector, and one for each mode found.
    fn products(&self) -> f64 {
        let subsystems = self.subsystems.iter().flatten();
        subsystems
            .map(|subsystem| self.vectors(subsystem.modes) + subsystem.modes)
            .sum()
    }

    fn work(&self, segments: f64) -> Work {
        let mut work = Work {
            bytes: 0.0,
            seconds: 0.0,
        };
        for subsystem in self.subsystems.iter().flatten() {
            let size = subsystem.unknowns * segments;
            let modes = subsystem.modes.min(size);
            let vectors = self.vectors(modes).min(size);
            let kept = vectors + modes + 4.0;
            work.bytes += NUMBER * (size * kept + vectors * vectors) + subsystem.bytes * segments;
            let terms =
                size * vectors * (vectors + subsystem.terms) + DIAGONALIZATION * vectors.powi(3);
            work.seconds += SECONDS_A_TERM * terms;
        }
        work
    }
}

impl SubsystemCost {
    /// A subsystem of these motions; the number of its modes is not known yet.
    fn of(tower: &Tower, set: &Motions, cut: &Cut, options: &Options) -> Self {
        let shears = usize::from(tower.shears());
        let has_gravity = tower.gravity_m_per_s2() != 0.0;
        let element = Element::of(options.method);
        let unknowns = |motion: Motion| match (options.method, motion.bends()) {
            (Method::Spectral, true) => (1 + shears) * cut.degree,
            (Method::Spectral, false) => cut.degree,
            (Method::Bmodes, false) if motion == Motion::Axial => 3,
            (Method::Bmodes, false) => 2,
            (_, true) => element.map_or(2, |e| e.bending_unknowns(tower.shears(), has_gravity)),
            (_, false) => 1,
        };
        let unknowns: usize = set.iter().map(unknowns).sum();
        let components = dimension(*set);
        // The inertia and one more matrix; with a foundation or gravity also their matrices and the
        // factors.
        let is_untied = tower.base().is_clamped() && !has_gravity;
        let matrices = if is_untied { 2 } else { 5 };
        let rows = match element {
            Some(_) => components,
            None => components + unknowns,
        };
        let numbers = 6 + 2 * components + matrices * rows * rows + components * unknowns;
        Self {
            unknowns: unknowns as f64,
            bytes: NUMBER * numbers as f64,
            terms: match element {
                Some(_) => 20.0,
                None => (components + unknowns) as f64 * 4.0,
            },
            modes: 0.0,
            multiplicity: 1.0,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::options::Options;
    use super::{Cost, ladder};
    use crate::elements::Mesh;
    use crate::solve::error::SolveError;
    use crate::solve::on_mesh::cut::Cut;
    use crate::tower::Shear;
    use crate::{Material, Method, Station, Tower, TowerDescription};

    fn description() -> TowerDescription {
        TowerDescription {
            materials: vec![Material::from_shear_modulus(8500.0, 2.1e11, 8.08e10)],
            stations: vec![
                Station::new(0.0, 6.0, 0.027),
                Station::new(87.6, 3.87, 0.019),
            ],
            ..TowerDescription::default()
        }
    }

    fn tower() -> Tower {
        Tower::new(description()).expect("a valid tower")
    }

    fn options(method: Method, modes: usize) -> Options {
        Options {
            method,
            modes,
            ..Options::default()
        }
    }

    fn cost(options: &Options, segments: usize, degree: usize) -> Cost {
        let tower = tower();
        let mesh = Mesh::new(&tower, options.borders(), segments);
        Cost::of(&tower, &Cut { mesh, degree }, options)
    }

    /// Peak memory less 8 MB of the program itself, MB, and processor time, s, of a release build;
    /// an estimate is on the safe side or a little off.
    #[test]
    fn estimates_are_near_what_was_measured() {
        for (method, segments, modes, megabytes, seconds) in [
            (Method::RmjeExact, 100_000, 4, 48.0, 0.15),
            (Method::RmjeExact, 100_000, 8, 77.0, 0.29),
            (Method::RmjeExact, 100_000, 20, 137.0, 0.88),
            (Method::RmjeExact, 1000, 300, 17.0, 0.68),
            (Method::RmjeExact, 1000, 600, 38.0, 3.76),
            (Method::Bmodes, 100_000, 8, 151.0, 0.81),
        ] {
            let Cost {
                bytes,
                seconds: estimated,
                ..
            } = cost(&options(method, modes), segments, 0);
            let ratio = bytes / 1e6 / megabytes;
            assert!(
                (0.8..3.0).contains(&ratio),
                "{modes} of {segments}: {ratio}"
            );
            let ratio = estimated / seconds;
            assert!(
                (0.5..3.0).contains(&ratio),
                "{modes} of {segments}: {ratio}"
            );
        }
        let spectral = cost(&options(Method::Spectral, 600), 32, 26).seconds / 5.88;
        assert!((0.5..3.0).contains(&spectral), "{spectral}");
    }

    /// The estimate counts the unknowns of the assembled models; of spectral elements, whose count
    /// differs between motions, up to a tenth more.
    #[test]
    fn degrees_of_freedom_are_those_of_the_solution() {
        for (shear, gravity_m_per_s2) in [
            (Shear::Rigid, 0.0),
            (Shear::Cowper, 0.0),
            (Shear::Rigid, 9.81),
            (Shear::Cowper, 9.81),
        ] {
            let tower = Tower::new(TowerDescription {
                shear,
                gravity_m_per_s2,
                ..description()
            });
            let tower = tower.expect("a valid tower");
            for method in Method::ALL {
                let options = options(method, 4);
                let mesh = Mesh::new(&tower, options.borders(), 20);
                let asked = Options {
                    segments: Some(20),
                    ..options.clone()
                };
                let solution = crate::solve(&tower, &asked).expect("modes");
                let degree = solution.degree.unwrap_or(0);
                let counted = Cost::of(&tower, &Cut { mesh, degree }, &options).unknowns;
                let (counted, known) = (counted as usize, solution.degrees_of_freedom);
                let place = format!("{method:?}, shear {shear:?}, gravity {gravity_m_per_s2}");
                match method {
                    Method::Spectral => {
                        assert!((known..=known + known / 10).contains(&counted), "{place}");
                    }
                    _ => assert_eq!(counted, known, "{place}"),
                }
            }
        }
    }

    #[test]
    fn a_million_segments_are_within_the_limits() {
        for method in [Method::RmjeExact, Method::Lumped, Method::Bmodes] {
            let asked = options(method, 8);
            assert_eq!(cost(&asked, 1_000_000, 0).check(8), Ok(()));
        }
    }

    #[test]
    fn what_takes_more_than_ten_minutes_or_the_memory_is_refused() {
        let check = |method, segments, degree, modes| {
            cost(&options(method, modes), segments, degree).check(modes)
        };
        assert!(check(Method::RmjeExact, 5000, 0, 2000).is_ok());
        for (method, segments, degree) in [
            (Method::RmjeExact, 5000, 0),
            (Method::Lumped, 5000, 0),
            (Method::Spectral, 256, 27),
        ] {
            let refused = check(method, segments, degree, 5000);
            assert!(
                matches!(refused, Err(SolveError::TooSlow { .. })),
                "{refused:?}"
            );
        }
        let refused = check(Method::Bmodes, 2_000_000, 0, 20);
        assert!(
            matches!(refused, Err(SolveError::TooLarge { .. })),
            "{refused:?}"
        );
        // Full matrices of many elements.
        let refused = check(Method::Spectral, 100_000, 60, 8);
        assert!(
            matches!(refused, Err(SolveError::TooLarge { .. })),
            "{refused:?}"
        );
    }

    /// What cannot be halved is doubled, which takes the more memory.
    #[test]
    fn cuts_that_cannot_be_halved_need_finer_ones() {
        let cut = |segments| Cut {
            mesh: Mesh::new(&tower(), Options::default().borders(), segments),
            degree: 0,
        };
        assert_eq!(ladder(&cut(100), 2), (100.0, 175.0));
        assert_eq!(ladder(&cut(101), 2), (404.0, 707.0));
        assert_eq!(ladder(&cut(102), 2), (204.0, 357.0));
    }
}
