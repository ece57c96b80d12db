//! The coupled Campbell diagram of a turbine.

use std::sync::Arc;

use pyo3::prelude::*;
use towermodes::{Options, SolveError};
use towermodes_analysis::resonance::{reach_hz, solve_to_reach, verdicts_without};
use towermodes_analysis::whirl::{
    AgainstRigid, CoupledCampbell, CoupledOptions, RotorSpeeds, coupled_campbell, coupled_limit_hz,
};
use towermodes_cli::table;
use towermodes_files::{
    ResultError, TowerInput, write_coupled_campbell_csv, write_coupled_campbell_json,
};
use towermodes_report::figures;

use crate::answer::{Answer, Shown};
use crate::campbell::RotorOptions;
use crate::error::of_coupled;
use crate::interrupt::{interruptible, looking};
use crate::lock::released;
use crate::model::Model;
use crate::tower::Tower;
use crate::turbine::turbine_of;

/// A coupled Campbell diagram.
struct TurbineCampbell {
    model: Arc<Model>,
    diagram: CoupledCampbell,
    against: Vec<AgainstRigid>,
    remarks: Vec<String>,
}

/// The rotor options; if neither the arguments nor the file give operating speeds, these are the
/// lowest and the highest speed of the diagram above zero.
fn rotor_of(
    mut options: RotorOptions,
    input: &TowerInput,
    blades: usize,
    rpm: &[f64],
) -> RotorOptions {
    options.blades.get_or_insert(blades);
    let turning = rpm.iter().copied().filter(|rpm| *rpm > 0.0);
    let lowest = turning.clone().fold(f64::INFINITY, f64::min);
    let highest = turning.fold(0.0, f64::max);
    if options.rpm.is_none() && input.description.rotor.is_none() && highest > 0.0 {
        options.rpm = Some((lowest, highest));
    }
    options
}

/// The diagram of the turbine on a tower; if no speeds are given, at the default speeds.
#[pyfunction]
#[pyo3(signature = (tower, rpm, limit_hz, rotor: "dict[str, object]"))]
pub fn turbine_campbell(
    py: Python<'_>,
    tower: &Tower,
    rpm: Vec<f64>,
    limit_hz: Option<f64>,
    rotor: RotorOptions,
) -> PyResult<Answer> {
    let model = Arc::clone(&tower.model);
    let turbine = turbine_of(&model)?;
    let blades = turbine.machine().blades;
    let given = rotor_of(rotor, &model.input, blades, &rpm);
    let limits = given.of_library();
    let solved = interruptible(py, Options::default(), |solver| {
        let chosen = given.rotor(&model.input, || solver.solve_certain(&model.tower))?;
        let reach_hz = reach_hz(&chosen.rotor, &limits);
        let rigid = solve_to_reach(solver, &model.tower, reach_hz)?;
        Ok::<_, SolveError>((rigid, chosen))
    })?;
    let (rigid, chosen) = solved.map_err(|error| model.unsolved(&error))?;
    let rotor = chosen.rotor;
    let usual_hz = coupled_limit_hz(&rotor, &limits, &rigid, &turbine);
    let speeds = match rpm.is_empty() {
        true => RotorSpeeds::Equal(limits.speeds),
        false => RotorSpeeds::Given(rpm),
    };
    let options = CoupledOptions {
        margin: limits.margin,
        multiples: limits.multiples,
        speeds,
        speeds_are_known: chosen.speeds_are_known,
        ..CoupledOptions::up_to(limit_hz.unwrap_or(usual_hz))
    };
    let diagram = looking(py, |mut look| {
        coupled_campbell(&turbine, &rotor, &options, |_| look())
    })?;
    let diagram = diagram.map_err(|error| of_coupled(&error))?;
    let remarks = diagram.remarks(&turbine);
    let remarks = remarks.iter().map(ToString::to_string);
    let without = released(py, || {
        verdicts_without(&model.tower, &diagram.campbell, false)
    });
    Ok(Answer::of(TurbineCampbell {
        against: diagram.against(&rigid),
        remarks: remarks.chain(without).collect(),
        model,
        diagram,
    }))
}

impl Shown for TurbineCampbell {
    fn table(&self) -> String {
        table::coupled_campbell(&self.model.tower, &self.diagram, &self.against, false)
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        let warnings = [self.notes(), self.warnings()].concat();
        let (tower, against) = (&self.model.tower, &self.against);
        write_coupled_campbell_json(tower, &self.diagram, against, &warnings, out)
    }

    fn csv(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_coupled_campbell_csv(&self.diagram, out)
    }

    fn svg(&self) -> String {
        let speeds = self.diagram.speeds.len();
        let computed = format!("coupled modes at {speeds} rotor speeds");
        let figure = figures::coupled_campbell(&self.diagram);
        self.model
            .titled(figure, Some(&computed), &self.conclusion())
    }

    fn notes(&self) -> Vec<String> {
        self.model.notes_with_turbine()
    }

    fn warnings(&self) -> Vec<String> {
        self.remarks.clone()
    }

    fn verdict(&self) -> &'static str {
        self.diagram.verdict().name()
    }

    fn not_checked(&self) -> Vec<String> {
        let reasons = self.diagram.campbell.not_checked.iter();
        reasons.map(ToString::to_string).collect()
    }

    fn conclusion(&self) -> Vec<String> {
        self.diagram.campbell.conclusion()
    }
}
