//! Blade modes against the rotor speed: a blade solved at each speed, its modes followed by shape.

use std::f64::consts::PI;

use super::campbell::{BEYOND_OPERATION, CampbellError, Excited, FrequencyLine, LineEnd};
use super::track::{Seen, Tracks};
use towermodes::blade::{Blade, BladeDescription};
use towermodes::modes::ShapePoint;
use towermodes::tower::Rotor;
use towermodes::{BladeFamily, BladeMode, Solver};

/// Speeds closer than this fraction of the highest are merged.
const SAME_SPEED: f64 = 1e-9;

/// Number of places along the span at which shapes are compared.
const PLACES: usize = 30;

/// Additional modes to solve, because others may fall below the requested ones as the speed
/// increases.
const MORE_MODES: usize = 4;

/// Largest number of times that the number of modes is doubled at a speed at which a followed mode
/// is missing.
const DOUBLINGS: usize = 3;

/// Equally spaced speeds from standstill to beyond the highest, with both ends of the operating
/// range, rpm.
pub(crate) fn speeds_rpm(rotor: &Rotor, count: usize) -> Vec<f64> {
    let last_rpm = BEYOND_OPERATION * rotor.highest_rpm;
    let of_operation = [rotor.lowest_rpm, rotor.highest_rpm];
    let is_other = |rpm: &f64| {
        let apart = of_operation.iter().map(|other| (rpm - other).abs());
        apart.fold(f64::INFINITY, f64::min) > SAME_SPEED * last_rpm
    };
    let steps = (count - 1) as f64;
    let equal = (0..count).map(|k| last_rpm * (k as f64 / steps));
    let mut speeds: Vec<f64> = equal.filter(is_other).chain(of_operation).collect();
    speeds.sort_by(f64::total_cmp);
    speeds.dedup();
    speeds
}

/// The lines of the lowest blade modes, by frequency at standstill.
pub(super) fn blade_lines(
    description: &BladeDescription,
    modes: usize,
    speeds_rpm: &[f64],
) -> Result<Vec<FrequencyLine>, CampbellError> {
    if modes == 0 {
        return Ok(Vec::new());
    }
    let mut sweep = Sweep::new(description)?;
    let mut tracks = None;
    for (index, &rpm) in speeds_rpm.iter().enumerate() {
        // Errors change little with the speed and are estimated at the ends.
        let is_end = index == 0 || index + 1 == speeds_rpm.len();
        tracks = Some(match tracks {
            None => Tracks::begin(&sweep.solve(rpm, modes, is_end)?),
            Some(tracks) => sweep.follow(tracks, rpm, modes, is_end)?,
        });
    }
    Ok(lines(tracks.unwrap_or_default(), modes, speeds_rpm))
}

/// The lines, named by family and order at standstill.
fn lines(tracks: Tracks, modes: usize, speeds_rpm: &[f64]) -> Vec<FrequencyLine> {
    let mut families: Vec<BladeFamily> = Vec::new();
    let followed = tracks.modes.into_iter().take(modes);
    let line = followed.map(|mode| {
        // A pair at all speeds has no family: equal stiffness in both directions, no rotation.
        let family = mode.family.unwrap_or(BladeFamily::Flap);
        families.push(family);
        let order = families.iter().filter(|f| **f == family).count();
        let lost_at = speeds_rpm.get(mode.frequencies_hz.len());
        let lost = lost_at.zip(mode.lost).map(|(rpm, mac)| LineEnd {
            rotor_speed_rpm: *rpm,
            mac,
        });
        let frequencies = speeds_rpm.iter().zip(mode.frequencies_hz);
        FrequencyLine {
            of: Excited::Blade { family, order },
            label: format!("blade {}", family.label(order)),
            points: frequencies.map(|(rpm, hz)| [*rpm, hz]).collect(),
            error_hz: mode.error_hz,
            lost,
        }
    });
    line.collect()
}

/// A blade to be solved at several speeds.
struct Sweep {
    description: BladeDescription,
    /// The places where shapes are compared: distances from the rotor axis, m.
    radii_m: Vec<f64>,
    /// The square roots of mass (kg) and polar inertia (kg m²) at each place.
    weights: Vec<[f64; 2]>,
    available: usize,
    solver: Solver,
}

impl Sweep {
    fn new(description: &BladeDescription) -> Result<Self, CampbellError> {
        let blade = Blade::new(description.clone())?;
        let step_m = blade.length_m() / PLACES as f64;
        let spans = (0..PLACES).map(|k| (k as f64 + 0.5) / PLACES as f64);
        let weights = spans.clone().map(|span| {
            let section = blade.section_at(span);
            let polar = section.flap_inertia_kg_m + section.edge_inertia_kg_m;
            [section.mass_kg_per_m, polar].map(|per_m| (per_m.max(0.0) * step_m).sqrt())
        });
        let tip = &description.tip;
        let of_tip = [tip.mass_kg, tip.inertia_kg_m2.zz.max(0.0)].map(f64::sqrt);
        Ok(Self {
            radii_m: spans
                .map(|span| blade.radius_m(span))
                .chain([description.tip_radius_m])
                .collect(),
            weights: weights.chain([of_tip]).collect(),
            available: blade.degrees_of_freedom(),
            description: description.clone(),
            solver: Solver::default(),
        })
    }

    /// Continues the tracks to a speed, with more modes if a followed mode is missing. The line of
    /// a mode that is still missing ends before this speed.
    fn follow(
        &mut self,
        mut tracks: Tracks,
        rpm: f64,
        modes: usize,
        with_errors: bool,
    ) -> Result<Tracks, CampbellError> {
        let mut asked = modes;
        let mut seen = self.solve(rpm, asked, with_errors)?;
        let mut assignment = tracks.assign(&seen);
        for _ in 0..DOUBLINGS {
            if !tracks.has_lost(&assignment, modes) || seen.len() == self.available {
                break;
            }
            asked = asked.saturating_mul(2).min(self.available);
            seen = self.solve(rpm, asked, with_errors)?;
            assignment = tracks.assign(&seen);
        }
        tracks.take(&seen, &assignment);
        Ok(tracks)
    }

    /// The lowest modes at a speed, and some additional ones.
    fn solve(
        &mut self,
        rpm: f64,
        modes: usize,
        with_errors: bool,
    ) -> Result<Vec<Seen>, CampbellError> {
        let more = modes.saturating_add(MORE_MODES).min(self.available);
        // The solver refuses more modes than the blade has.
        let modes = more.max(modes.min(self.available + 1));
        self.description.rotor_speed_rad_per_s = rpm * PI / 30.0;
        let blade = Blade::new(self.description.clone())?;
        let solved = match with_errors {
            true => self.solver.blade(&blade, modes, &self.radii_m),
            false => self.solver.blade_once(&blade, modes, &self.radii_m),
        };
        let solution = solved.map_err(|error| CampbellError::Blade {
            rotor_speed_rpm: rpm,
            error,
        })?;
        let seen = |mode: &BladeMode| Seen {
            frequency_hz: mode.frequency_hz,
            family: mode.family,
            shape: self.weighted(&mode.shape),
            error_hz: with_errors.then_some(mode.discretization_error_hz + mode.algebraic_error_hz),
        };
        Ok(solution.modes.iter().map(seen).collect())
    }

    /// Translations and twist, each multiplied by the square root of its mass or inertia, so that
    /// modes at one speed are nearly orthogonal.
    fn weighted(&self, shape: &[ShapePoint]) -> Vec<f64> {
        let points = shape.iter().zip(&self.weights);
        let motions = points.flat_map(|(point, [mass, polar])| {
            let [x, y, z] = point.translation.map(|motion| mass * motion);
            [x, y, z, polar * point.rotation[2]]
        });
        motions.collect()
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::{MORE_MODES, Sweep};
    use crate::resonance::track::{Seen, Tracks};
    use towermodes::BladeFamily;
    use towermodes::blade::{BladeDescription, BladeSection};

    /// A straight blade without axial flexibility: no section moves along the span.
    pub(in crate::resonance) fn blade(inertia_kg_m: f64) -> BladeDescription {
        let root = BladeSection {
            mass_kg_per_m: 1.0,
            flap_inertia_kg_m: inertia_kg_m,
            edge_inertia_kg_m: inertia_kg_m,
            flap_n_m2: 1.0,
            edge_n_m2: 1.5,
            torsion_n_m2: f64::INFINITY,
            axial_n: f64::INFINITY,
            ..BladeSection::default()
        };
        let tip = BladeSection { span: 1.0, ..root };
        BladeDescription {
            tip_radius_m: 1.0,
            sections: vec![root, tip],
            borders: vec![0.0, 0.25, 0.5, 0.75, 1.0],
            tip_is_pulled: true,
            ..BladeDescription::default()
        }
    }

    /// An axial mode is in no list of modes of such a blade: all modes are searched, and then its
    /// line ends.
    #[test]
    fn a_mode_that_is_nowhere_ends_its_line() {
        let mut sweep = Sweep::new(&blade(0.0)).expect("a blade");
        // Not all modes are seen at first, and twice as many are more than there are.
        let many = sweep.available - MORE_MODES - 1;
        assert!(2 * many > sweep.available, "{}", sweep.available);
        let along = |k: usize| if k % 4 == 2 { 1.0 } else { 0.0 };
        let first = Seen {
            frequency_hz: 1.0,
            family: BladeFamily::Axial,
            shape: (0..4 * sweep.weights.len()).map(along).collect(),
            error_hz: None,
        };
        for asked in [1, many] {
            let tracks = Tracks::begin(std::slice::from_ref(&first));
            let tracks = sweep.follow(tracks, 10.0, asked, false).expect("modes");
            assert_eq!(tracks.modes[0].frequencies_hz, [1.0]);
            assert_eq!(tracks.modes[0].lost, Some(0.0));
        }
    }

    #[test]
    fn weights_are_numbers_without_inertias() {
        let sweep = Sweep::new(&blade(0.0)).expect("a blade");
        let mut weights = sweep.weights.iter().flatten();
        assert!(weights.all(|weight| weight.is_finite()));
    }
}
