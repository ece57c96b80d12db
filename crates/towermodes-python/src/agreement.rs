//! Two descriptions of one tower compared, and one summarised.

use std::sync::Arc;

use pyo3::prelude::*;
use towermodes_analysis::agreement::{
    Agreement as Agreed, AgreementLimits, Examination as Examined, agree, examine, omit_one_sided,
};
use towermodes_cli::table;
use towermodes_files::{FileFormat, write_result_json};

use crate::error::{of_agreement, of_result, of_tower};
use crate::lock::released;
use crate::tower::{Model, Tower};

/// The comparison of two descriptions.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Agreement {
    names: [String; 2],
    agreement: Agreed,
    notes: Vec<String>,
}

/// The name of a tower in a table: its file, or else its own.
fn name(model: &Model) -> String {
    let file = model.input.files().find(|name| !name.starts_with('<'));
    match (file, model.tower.name()) {
        (Some(file), _) => file.to_owned(),
        (None, "") => "a tower without name".to_owned(),
        (None, name) => name.to_owned(),
    }
}

#[pymethods]
impl Agreement {
    /// Compares the second tower with the first.
    #[new]
    fn new(py: Python<'_>, first: &Tower, second: &Tower) -> PyResult<Self> {
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
        Ok(Self {
            names,
            agreement,
            notes,
        })
    }

    /// The worst verdict: `pass`, `warn` or `fail`.
    #[getter]
    fn verdict(&self) -> &'static str {
        self.agreement.verdict.name()
    }

    /// The notes of both readers, and what is left out of the comparison.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }

    /// The table of the program.
    fn table(&self) -> String {
        table::agreement(&self.names, &self.agreement)
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let mut json = Vec::new();
        let done = write_result_json(&self.agreement, &mut json);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&json).into_owned())
    }
}

/// The values of one description.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Examination {
    model: Arc<Model>,
    examination: Examined,
}

#[pymethods]
impl Examination {
    /// Summarises a tower.
    #[new]
    fn new(tower: &Tower) -> PyResult<Self> {
        let model = Arc::clone(&tower.model);
        let examined = examine(&model.input.description);
        let examination = examined.map_err(|error| of_tower(&error))?;
        Ok(Self { model, examination })
    }

    /// The table of the program.
    fn table(&self) -> String {
        table::examination(&self.model.tower, &self.examination)
    }

    /// The JSON of the program.
    fn json(&self) -> PyResult<String> {
        let mut json = Vec::new();
        let done = write_result_json(&self.examination, &mut json);
        done.map_err(|error| of_result(&error))?;
        Ok(String::from_utf8_lossy(&json).into_owned())
    }
}
