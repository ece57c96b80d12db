//! The whole turbine with its rotating rotor: the coupled Campbell diagram, as `campbell` computes
//! it, and the shapes of the modes at one rotor speed.

use serde::{Deserialize, Serialize};
use towermodes::number::four_digits;
use towermodes::turbine::{
    Turbine, TurbineError, TurbineMode, TurbineModeName, TurbineModel, TurbinePart,
};
use towermodes::{Family, Options, Solution, Tower};
use towermodes_analysis::resonance::{ChosenRotor, reach_hz, solve_to_reach};
use towermodes_analysis::whirl::{
    CoupledCampbell, CoupledOptions, RotorSpeeds, SHARED, coupled_campbell_while, coupled_limit_hz,
};
use towermodes_files::TowerInput;
use towermodes_report::figures::{WhirlAnimation, whirl_animation};
use towermodes_report::wording::{STRUCTURE_ONLY, proved};

use super::explorer::{Explorer, Wanted};
use super::refusal::Refusal;
use super::resonance::Resonance;
use super::state::State;

/// The equally spaced rotor speeds of the diagram: `campbell --speeds 15`.
pub const SPEEDS: usize = 15;

/// A rotor speed at which a page shows the modes of a turbine.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct WhirlQuestion {
    /// The changed input values.
    #[serde(flatten)]
    pub state: State,
    /// The rotor speed, rpm.
    pub rpm: f64,
}

/// The coupled diagram of a turbine.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Coupled {
    /// Verdict, conclusion, lines and rows, as `campbell` gives them.
    pub resonance: Resonance,
    /// The proof that no mode is missing, and what the diagram does not contain.
    pub proof: String,
    /// The number of rotor speeds at which the turbine was solved.
    pub speeds: usize,
    /// Duration, ms.
    pub answer_ms: f64,
}

/// The modes of a turbine at a rotor speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Whirl {
    /// The modes by frequency.
    pub modes: Vec<WhirlMode>,
    /// Their shapes.
    pub scene: WhirlAnimation,
    /// Duration, ms.
    pub answer_ms: f64,
}

/// A mode of a turbine at a rotor speed.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WhirlMode {
    /// Its name, which is the name of a line of the diagram.
    pub name: String,
    /// Frequency in non-rotating axes, Hz.
    pub frequency_hz: f64,
    /// The frequency with four digits.
    pub frequency: String,
    /// The shares of the energy, if less than 60 % of it is in the part that the name states.
    pub remark: String,
    /// The mode of the tower with a rigid rotor that has the same motion and therefore
    /// elasticities; none for a mode of the rotor.
    pub tower_mode: Option<TowerMode>,
}

/// A mode of a tower with a rigid rotor, by its name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct TowerMode {
    /// Its family: `fore-aft`.
    pub family: &'static str,
    /// Its order in the family, from 1.
    pub order: usize,
}

/// A turbine, the rotor of its diagram, and the highest frequency of the diagram.
struct Prepared {
    turbine: Turbine,
    chosen: ChosenRotor,
    limit_hz: f64,
}

impl Explorer {
    /// The coupled diagram of the turbine with changed input values. The computation ends when
    /// `wanted` returns false.
    ///
    /// # Errors
    /// [`Refusal`]: there is no such turbine, or it cannot be solved.
    pub fn coupled(&self, state: &State, wanted: Wanted<'_>) -> Result<Coupled, Refusal> {
        let started = self.now_ms();
        let of = self.prepared(state)?;
        let given = &self.exploration.campbell;
        let options = CoupledOptions {
            margin: given.margin,
            multiples: given.multiples.clone(),
            speeds: RotorSpeeds::Equal(SPEEDS),
            speeds_are_known: of.chosen.speeds_are_known,
            ..CoupledOptions::up_to(of.limit_hz)
        };
        let (turbine, rotor) = (&of.turbine, &of.chosen.rotor);
        let diagram = coupled_campbell_while(turbine, rotor, &options, |_| wanted());
        let diagram = diagram.map_err(|error| Refusal::of(&error))?;
        Ok(Coupled {
            answer_ms: self.now_ms() - started,
            ..Coupled::new(&diagram, turbine)
        })
    }

    /// The modes of the turbine at a rotor speed, with their shapes.
    ///
    /// # Errors
    /// [`Refusal`]: there is no such turbine, or it cannot be solved.
    pub fn whirl(&self, question: &WhirlQuestion) -> Result<Whirl, Refusal> {
        let started = self.now_ms();
        let Prepared {
            turbine, limit_hz, ..
        } = self.prepared(&question.state)?;
        let modes = TurbineModel::new(&turbine, &turbine.mesh())
            .and_then(|mut model| model.modes(limit_hz, question.rpm));
        let modes = modes.map_err(|error| Refusal::of(&error))?;
        Ok(Whirl {
            modes: modes.modes.iter().map(WhirlMode::new).collect(),
            scene: whirl_animation(&turbine, &modes),
            answer_ms: self.now_ms() - started,
        })
    }

    /// The turbine, its rotor and the highest frequency of its diagram, as in `campbell`.
    fn prepared(&self, state: &State) -> Result<Prepared, Refusal> {
        let (input, tower) = self.changed(state)?;
        let turbine = turbine_of(&input)?;
        let (rigid, chosen) = self.rigid(&input, &tower)?;
        let campbell = &self.exploration.campbell;
        Ok(Prepared {
            limit_hz: coupled_limit_hz(&chosen.rotor, campbell, &rigid, &turbine),
            turbine,
            chosen,
        })
    }

    /// The modes of the tower with a rigid rotor-nacelle assembly, up to the highest excitation.
    fn rigid(&self, input: &TowerInput, tower: &Tower) -> Result<(Solution, ChosenRotor), Refusal> {
        let given = &self.exploration.rotor;
        let chosen = given.in_place_of(input.description.rotor, input.blades);
        let solved = self.solver().with(Options::default(), |solver| {
            let chosen = match chosen {
                Some(chosen) => chosen,
                None => {
                    let solution = solver.solve_certain(tower)?;
                    given.without_speeds(input.blades, &solution, input.tip_radius_m())
                }
            };
            let reach_hz = reach_hz(&chosen.rotor, &self.exploration.campbell);
            Ok((solve_to_reach(solver, tower, reach_hz)?, chosen))
        });
        solved.map_err(|error| Refusal::of_solve(&error))
    }
}

fn turbine_of(input: &TowerInput) -> Result<Turbine, Refusal> {
    let Some(machine) = &input.turbine else {
        return Err(Refusal::of(&"the file has no turbine with flexible blades"));
    };
    let turbine = Turbine::in_place_of_rna(input.description.clone(), machine.clone());
    turbine.map_err(|error| match &error {
        TurbineError::Tower(error) => Refusal::of_tower(error, &input.description),
        error => Refusal::of(error),
    })
}

impl Coupled {
    fn new(diagram: &CoupledCampbell, turbine: &Turbine) -> Self {
        let remarks = diagram.remarks(turbine).into_iter();
        let remarks = remarks.map(|remark| remark.to_string());
        Self {
            resonance: Resonance::new(&diagram.campbell, diagram.verdict(), remarks),
            proof: format!("{} {STRUCTURE_ONLY}", proved(diagram)),
            speeds: diagram.speeds.len(),
            answer_ms: 0.0,
        }
    }
}

impl WhirlMode {
    fn new(mode: &TurbineMode) -> Self {
        let percent = |share: f64| format!("{:.0} %", 100.0 * share);
        let second = mode.second.filter(|_| mode.share < SHARED);
        let remark = second
            .map(|(part, share)| format!("{}; {} {part}", percent(mode.share), percent(share)));
        Self {
            name: mode.name.to_string(),
            frequency_hz: mode.frequency.frequency_hz,
            frequency: four_digits(mode.frequency.frequency_hz),
            remark: remark.unwrap_or_default(),
            tower_mode: TowerMode::like(mode.name),
        }
    }
}

impl TowerMode {
    /// The mode of the tower with a rigid rotor whose motion the name of a turbine mode states;
    /// none for a mode of the rotor.
    fn like(name: TurbineModeName) -> Option<Self> {
        let family = match name.part {
            TurbinePart::Platform(family) => family,
            TurbinePart::Substructure => Family::Substructure,
            TurbinePart::TowerForeAft => Family::ForeAft,
            TurbinePart::TowerSideSide => Family::SideSide,
            TurbinePart::TowerTorsion => Family::Torsion,
            TurbinePart::TowerAxial => Family::Axial,
            TurbinePart::YawDrive | TurbinePart::Shaft | TurbinePart::Blades(..) => return None,
        };
        Some(Self {
            family: family.name(),
            order: name.order,
        })
    }
}

#[cfg(test)]
mod tests {
    use towermodes::Family;
    use towermodes::turbine::{BladeMotion, Harmonic, TurbineModeName, TurbinePart};

    use super::TowerMode;

    /// Elasticities are computed for the tower with a rigid rotor, so they need the mode with the
    /// same motion.
    #[test]
    fn modes_of_tower_and_platform_have_one_with_a_rigid_rotor() {
        let like = |part, order| {
            let mode = TowerMode::like(TurbineModeName { part, order });
            mode.map(|mode| (mode.family, mode.order))
        };
        assert_eq!(like(TurbinePart::TowerForeAft, 2), Some(("fore-aft", 2)));
        assert_eq!(like(TurbinePart::TowerSideSide, 1), Some(("side-side", 1)));
        let surge = TurbinePart::Platform(Family::Surge);
        assert_eq!(like(surge, 1), Some(("surge", 1)));
        let blades = TurbinePart::Blades(BladeMotion::Flap, Harmonic::Collective);
        for part in [blades, TurbinePart::Shaft, TurbinePart::YawDrive] {
            assert_eq!(like(part, 1), None);
        }
    }
}
