//! The comparison of two descriptions of a tower, and the summary of one.

use std::sync::Arc;

use pyo3::prelude::*;
use towermodes_analysis::agreement::{
    Agreement as Agreed, AgreementLimits, Examination as Examined, agree, examine as examined,
    omit_one_sided,
};
use towermodes_cli::table;
use towermodes_files::{FileFormat, ResultError, write_result_json};

use crate::answer::{Answer, Shown};
use crate::error::{of_agreement, of_tower};
use crate::lock::released;
use crate::model::Model;
use crate::tower::Tower;

/// The comparison of two descriptions.
struct Agreement {
    names: [String; 2],
    agreement: Agreed,
    notes: Vec<String>,
}

/// The name of a tower in a table: its file, or without a file its own name.
fn name(model: &Model) -> String {
    let file = model.input.files().find(|name| !name.starts_with('<'));
    match (file, model.tower.name()) {
        (Some(file), _) => file.to_owned(),
        (None, "") => "a tower without name".to_owned(),
        (None, name) => name.to_owned(),
    }
}

/// Compares the second tower with the first.
#[pyfunction]
pub fn check(py: Python<'_>, first: &Tower, second: &Tower) -> PyResult<Answer> {
    let models = [&*first.model, &*second.model];
    let names = models.map(name);
    let implied = models.map(|model| model.input.format == FileFormat::ElastoDyn);
    let [mut first, mut second] = models.map(|model| model.input.description.clone());
    let omitted = omit_one_sided([&mut first, &mut second], implied);
    let agreed = released(py, || agree(&first, &second, &AgreementLimits::default()));
    let agreement = agreed.map_err(|error| of_agreement(&error))?;
    let mut notes = models[0].notes();
    for note in models[1].notes() {
        if !notes.contains(&note) {
            notes.push(note);
        }
    }
    notes.extend(omitted.iter().map(ToString::to_string));
    Ok(Answer::of(Agreement {
        names,
        agreement,
        notes,
    }))
}

impl Shown for Agreement {
    fn table(&self) -> String {
        table::agreement(&self.names, &self.agreement)
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_result_json(&self.agreement, out)
    }

    /// Notes of both readers, and on data that are not compared.
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    fn verdict(&self) -> &'static str {
        self.agreement.verdict.name()
    }
}

/// The values of one description.
struct Examination {
    model: Arc<Model>,
    examination: Examined,
}

/// Summarises a tower.
#[pyfunction]
pub fn examine(tower: &Tower) -> PyResult<Answer> {
    let model = Arc::clone(&tower.model);
    let examined = examined(&model.input.description);
    let examination = examined.map_err(|error| of_tower(&error))?;
    Ok(Answer::of(Examination { model, examination }))
}

impl Shown for Examination {
    fn table(&self) -> String {
        table::examination(&self.model.tower, &self.examination)
    }

    fn json(&self, out: &mut Vec<u8>) -> Result<(), ResultError> {
        write_result_json(&self.examination, out)
    }
}
