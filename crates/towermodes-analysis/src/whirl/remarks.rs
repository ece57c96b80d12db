//! The limitations of a coupled Campbell diagram, as remarks.

use towermodes::turbine::{Turbine, TurbineModes};

use crate::Verdict;
use crate::resonance::{Remark, mode_lost};

use super::curve::CoupledCurve;
use super::diagram::CoupledCampbell;
use super::solved::SolvedSpeed;

impl CoupledCampbell {
    /// The worst verdict of all pairs; at best [`Verdict::Warn`] if the modes do not cover all
    /// excitations, or if the turbine is unstable or not certified at an operating speed.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let rotor = &self.campbell.rotor;
        let operation = rotor.lowest_rpm..=rotor.highest_rpm;
        let mut open = self.uncertified_rpm().into_iter();
        match open.any(|rpm| operation.contains(&rpm)) {
            true => self.campbell.verdict().max(Verdict::Warn),
            false => self.campbell.verdict(),
        }
    }

    /// The limitations of the diagram: values of the rotor that look like mistakes, lost modes,
    /// excitations above the list of modes, speeds without certificate, modes of negative energy.
    #[must_use]
    pub fn remarks(&self, turbine: &Turbine) -> Vec<Remark> {
        let campbell = &self.campbell;
        let warnings = turbine.tower().rotor_warnings(&campbell.rotor).into_iter();
        // The ends of a diagram are no input.
        let warnings = warnings.filter(|_| campbell.speeds_are_known());
        let lines = campbell.lines.iter();
        let uncovered = campbell.uncovered_range_hz();
        let uncovered =
            uncovered.map(|[limit_hz, reach_hz]| Remark::AboveLimit { limit_hz, reach_hz });
        warnings
            .map(Remark::Rotor)
            .chain(lines.filter_map(|line| mode_lost(line, &campbell.rotor)))
            .chain(uncovered)
            .chain(self.unstable())
            .chain(self.uncertified())
            .chain(self.unresisted())
            .chain(self.curves.iter().filter_map(negative_energy))
            .collect()
    }

    fn unstable(&self) -> Option<Remark> {
        let speeds = self.speeds.iter();
        let unstable: Vec<_> = speeds.filter(|speed| speed.modes.growing > 0).collect();
        Some(Remark::Unstable {
            lowest_rpm: unstable.first()?.rotor_speed_rpm,
            highest_rpm: unstable.last()?.rotor_speed_rpm,
            speeds: unstable.len(),
            growing: unstable.iter().map(|speed| speed.modes.growing).max()?,
        })
    }

    fn uncertified(&self) -> Option<Remark> {
        let speeds = self.speeds.iter();
        let is_open = |speed: &&SolvedSpeed<TurbineModes>| {
            !speed.modes.is_complete && speed.modes.growing == 0
        };
        let open: Vec<_> = speeds.filter(is_open).collect();
        let unproven = open.iter().flat_map(|speed| &speed.modes.unproven_hz);
        let mut unproven_hz: Vec<[f64; 2]> = unproven.copied().collect();
        unproven_hz.sort_by(|a, b| a[0].total_cmp(&b[0]));
        Some(Remark::Uncertified {
            lowest_rpm: open.first()?.rotor_speed_rpm,
            highest_rpm: open.last()?.rotor_speed_rpm,
            speeds: open.len(),
            unproven_hz,
        })
    }

    fn unresisted(&self) -> Option<Remark> {
        let speeds = self.speeds.iter();
        let motions = speeds.map(|speed| speed.modes.unresisted).max()?;
        (motions > 0).then_some(Remark::Unresisted { motions })
    }
}

fn negative_energy(curve: &CoupledCurve) -> Option<Remark> {
    let mut points = curve.points.iter();
    let first = points.find(|point| point.frequency.has_negative_energy)?;
    Some(Remark::NegativeEnergy {
        label: first.name.to_string(),
        from_rpm: first.rotor_speed_rpm,
    })
}
