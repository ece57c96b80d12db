//! The rule that names the modes at a speed.

use super::super::counts::frequencies::Part;
use super::energy::{BladeMotion, Harmonic, TurbineEnergy, TurbinePart};
use super::name::TurbineModeName;
use crate::modes::Arrears;
use crate::rotor::Reactionless;

/// Number of families without blades: platform, frame, tower, yaw drive, shaft.
const STATIONARY: usize = 13;
/// Number of all families: those without blades, and for each motion of the blades both waves and
/// the collective motion.
const FAMILIES: usize = STATIONARY + 2 * BladeMotion::ALL.len();
/// The six motions of a platform name one mode each.
const ONCE: [bool; FAMILIES] = {
    let mut once = [false; FAMILIES];
    let mut k = 0;
    while k < 6 {
        once[k] = true;
        k += 1;
    }
    once
};
/// Shares with a smaller difference are treated as equal, as those of both waves at standstill.
const TIE: f64 = 1e-4;
/// From one mode to the next the arrears decrease with this power of the ratio of their
/// frequencies: only modes of close frequencies share a motion, so the energy that a mode with a
/// much lower frequency has in a motion does not mean that a mode of this motion is missing. On 50
/// random turbines at 100 speeds, powers from 4 to 16 give better names than arrears that do not
/// decrease, with any weight (see the theory in the book).
const FADING: i32 = 8;

/// The names of the modes of one problem: all that moves the hub, or one wave that does not.
struct Names {
    families: Fading<FAMILIES>,
    /// Backward and forward waves, for each motion of the blades.
    waves: [Fading<2>; BladeMotion::ALL.len()],
}

/// Arrears that decrease with increasing frequency.
struct Fading<const K: usize> {
    arrears: Arrears<K>,
    /// The frequency of the last mode, if there is one.
    last_hz: Option<f64>,
}

impl<const K: usize> Fading<K> {
    fn new(once: [bool; K]) -> Self {
        Self {
            arrears: Arrears::new(once, TIE),
            last_hz: None,
        }
    }

    /// The family of the next mode, which has this frequency, and its order in the family.
    fn name(&mut self, hz: f64, shares: &[f64; K], may: impl Fn(usize) -> bool) -> (usize, usize) {
        let last_hz = self.last_hz.replace(hz).unwrap_or(hz);
        self.arrears.fade((last_hz / hz).powi(FADING));
        self.arrears.name(shares, may)
    }
}

impl Names {
    fn new() -> Self {
        Self {
            families: Fading::new(ONCE),
            waves: std::array::from_fn(|_| Fading::new([false; 2])),
        }
    }

    /// The name of the next mode, of a frequency. The two waves of a motion are one family first:
    /// their sum is continuous where the rotor begins to turn, each alone is not. Then the same
    /// rule chooses between the two, of equal ones the backward one, which has the lower frequency
    /// as soon as the rotor turns.
    fn next(&mut self, hz: f64, energy: &TurbineEnergy) -> TurbineModeName {
        let shares = shares(energy);
        let (family, order) = self.families.name(hz, &shares, |_| true);
        let stationary = energy.stationary().nth(family);
        if let Some((part, _)) = stationary {
            return TurbineModeName { part, order };
        }
        let place = (family - STATIONARY) / 2;
        let (motion, own) = (BladeMotion::ALL[place], energy.blades[place]);
        if (family - STATIONARY) % 2 == 1 {
            let part = TurbinePart::Blades(motion, Harmonic::Collective);
            return TurbineModeName { part, order };
        }
        let both = own.asymmetric().max(f64::MIN_POSITIVE);
        let of_both = [own.backward, own.forward].map(|wave| wave / both);
        let (wave, order) = self.waves[place].name(hz, &of_both, |_| true);
        let harmonic = [Harmonic::Backward, Harmonic::Forward][wave];
        let part = TurbinePart::Blades(motion, harmonic);
        TurbineModeName { part, order }
    }
}

/// The shares of the families.
fn shares(energy: &TurbineEnergy) -> [f64; FAMILIES] {
    let blades = energy.blades.iter();
    let blades = blades.flat_map(|own| [own.asymmetric(), own.collective]);
    let stationary = energy.stationary().map(|(_, share)| share);
    let mut all = stationary.chain(blades);
    std::array::from_fn(|_| all.next().unwrap_or_default())
}

/// Names the modes at one speed, by rising frequency. Waves that do not move the hub share no
/// motion with other modes and have names of their own.
#[derive(Default)]
pub(super) struct Naming {
    problems: Vec<(Part, Names)>,
}

/// The name of a mode, its share, and the part with the most energy besides.
pub(super) struct Named {
    pub(crate) name: TurbineModeName,
    pub(crate) share: f64,
    pub(crate) second: Option<(TurbinePart, f64)>,
}

impl Naming {
    /// Names the next mode, with this part of the equations and a frequency in Hz, by the fractions
    /// of its elastic energy.
    pub(crate) fn next(&mut self, problem: Part, hz: f64, energy: &TurbineEnergy) -> Named {
        let known = self.problems.iter().position(|(own, _)| *own == problem);
        let place = known.unwrap_or_else(|| {
            self.problems.push((problem, Names::new()));
            self.problems.len() - 1
        });
        let TurbineModeName { part, order } = self.problems[place].1.next(hz, energy);
        let part_of_problem = of_problem(part, problem);
        Named {
            name: TurbineModeName {
                part: part_of_problem,
                order,
            },
            share: share(energy, part),
            second: second(energy, part).map(|(part, share)| (of_problem(part, problem), share)),
        }
    }
}

/// The share of a part.
fn share(energy: &TurbineEnergy, part: TurbinePart) -> f64 {
    let parts = energy.parts().into_iter();
    let own = parts.filter(|(other, _)| *other == part);
    own.map(|(_, share)| share).sum()
}

/// The part with the second largest share, if there is one.
fn second(energy: &TurbineEnergy, first: TurbinePart) -> Option<(TurbinePart, f64)> {
    let parts = energy.parts().into_iter();
    let others = parts.filter(|(part, share)| *part != first && *share > 0.0);
    others.reduce(|most, part| if part.1 > most.1 { part } else { most })
}

/// The part with the harmonic of blades that do not move the hub.
fn of_problem(part: TurbinePart, problem: Part) -> TurbinePart {
    match (part, problem) {
        (TurbinePart::Blades(motion, _), Some(wave)) => {
            let harmonic = match wave {
                Reactionless::Forward(waves) => Harmonic::ForwardOf(waves),
                Reactionless::Backward(waves) => Harmonic::BackwardOf(waves),
                Reactionless::Alternating(_) => Harmonic::Alternating,
            };
            TurbinePart::Blades(motion, harmonic)
        }
        _ => part,
    }
}

#[cfg(test)]
mod tests {
    use super::super::energy::BladeEnergy;
    use super::*;

    fn blades(motion: usize, backward: f64, forward: f64, collective: f64) -> TurbineEnergy {
        let mut energy = TurbineEnergy::default();
        energy.blades[motion] = BladeEnergy {
            collective,
            forward,
            backward,
            ..BladeEnergy::default()
        };
        energy
    }

    /// Names of modes at frequencies, Hz.
    fn named_at(modes: &[(f64, TurbineEnergy)]) -> Vec<String> {
        let mut names = Names::new();
        let all = modes.iter();
        all.map(|(hz, energy)| names.next(*hz, energy).to_string())
            .collect()
    }

    /// Names of modes of one frequency.
    fn named(energies: &[TurbineEnergy]) -> Vec<String> {
        named_at(&energies.iter().map(|own| (1.0, *own)).collect::<Vec<_>>())
    }

    /// At standstill both waves of tilt and of yaw are equal: the lower mode is the backward whirl
    /// that it becomes, with a collective mode between or without.
    #[test]
    fn tilt_and_yaw_at_standstill_are_the_whirls_that_they_become() {
        let half = blades(0, 0.5, 0.5, 0.0);
        let all = blades(0, 0.0, 0.0, 1.0);
        let expected = |order: &str| {
            [
                format!("{order} flapwise backward whirl"),
                format!("{order} flapwise collective"),
                format!("{order} flapwise forward whirl"),
            ]
        };
        assert_eq!(
            named(&[half, all, half, half, all, half]),
            [expected("1st"), expected("2nd")].concat()
        );
        let turning = [blades(0, 0.9, 0.1, 0.0), all, blades(0, 0.1, 0.9, 0.0)];
        assert_eq!(named(&turning), expected("1st"));
    }

    /// Yaw of the blades at standstill, with torsion of the tower: 30 % in each wave are more than
    /// 40 % together.
    #[test]
    fn both_waves_together_are_weighed_against_other_parts() {
        let mut energy = blades(0, 0.3, 0.3, 0.0);
        energy.tower_torsion = 0.4;
        assert_eq!(named(&[energy]), ["1st flapwise backward whirl"]);
    }

    /// Torsion in many modes, a little in each, names the first in which it is a quarter of the
    /// largest part.
    #[test]
    fn a_mode_is_not_named_after_a_part_that_it_hardly_has() {
        let mut mode = blades(1, 0.0, 0.0, 0.95);
        mode.shaft = 0.05;
        let names = named(&[mode; 30]);
        assert!(names.iter().all(|name| name.ends_with("collective")));
    }

    /// Flapwise forward and edgewise backward whirl share two modes of the NREL 5 MW turbine on a
    /// monopile at 12.1 and 12.4 rpm. In the lower one they are all but equal at 12.1 rpm. What the
    /// first backward whirl, far below, lacks of flap must not make both modes edgewise.
    #[test]
    fn what_a_mode_far_below_lacks_names_no_mode_of_a_veering() {
        let shared = |flap_forward: f64, flap_backward: f64, edge_backward: f64, torsion: f64| {
            let mut energy = blades(0, flap_backward, flap_forward, 0.0);
            energy.blades[1].backward = edge_backward;
            energy.tower_torsion = torsion;
            energy
        };
        let lowest = shared(0.0, 0.857, 0.002, 0.091);
        let collective = blades(0, 0.0, 0.0, 1.0);
        let names = |lower: TurbineEnergy, upper: TurbineEnergy| {
            let frequencies = [0.4894, 0.7474, 0.8802, 0.8974];
            let modes = [lowest, collective, lower, upper];
            let modes: Vec<(f64, TurbineEnergy)> = frequencies.into_iter().zip(modes).collect();
            named_at(&modes)[2..].to_vec()
        };
        let (flap, edge) = ("1st flapwise forward whirl", "1st edgewise backward whirl");
        let before = names(
            shared(0.433, 0.023, 0.430, 0.081),
            shared(0.178, 0.011, 0.778, 0.004),
        );
        assert_eq!(before, [flap, edge]);
        let after = names(
            shared(0.170, 0.021, 0.745, 0.049),
            shared(0.431, 0.010, 0.482, 0.027),
        );
        assert_eq!(after, [edge, flap]);
    }

    /// Each motion of a platform names one mode; the next is named after the tower.
    #[test]
    fn motions_of_a_platform_name_one_mode_each() {
        let mut energy = TurbineEnergy {
            tower_fore_aft: 0.4,
            ..TurbineEnergy::default()
        };
        energy.platform[4] = 0.6;
        assert_eq!(
            named(&[energy, energy]),
            ["1st platform pitch", "1st tower fore-aft"]
        );
    }
}
