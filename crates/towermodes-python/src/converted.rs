//! A tower in another format.

use pyo3::prelude::*;
use towermodes_files::{ConvertOptions, Converted as Files, Note, OutputFormat, convert};

use crate::error::{of_convert, usage};
use crate::lock::released;
use crate::tower::Tower;

/// The files of a tower in another format.
#[pyclass(frozen, module = "towermodes._towermodes")]
pub struct Converted {
    files: Files,
    notes: Vec<String>,
}

fn format_named(name: &str) -> PyResult<OutputFormat> {
    match name {
        "toml" => Ok(OutputFormat::Toml),
        "bmodes" => Ok(OutputFormat::Bmodes),
        "elastodyn" => Ok(OutputFormat::ElastoDyn),
        "windio" => Ok(OutputFormat::WindIo),
        _ => Err(usage(format!(
            "'{name}' is not a format; the formats are toml, bmodes, elastodyn, windio"
        ))),
    }
}

#[pymethods]
impl Converted {
    /// Writes a tower in a format.
    #[new]
    fn new(
        py: Python<'_>,
        tower: &Tower,
        format: &str,
        sections_file: Option<String>,
        from_height_m: Option<f64>,
    ) -> PyResult<Self> {
        let format = format_named(format)?;
        if from_height_m.is_some() && format != OutputFormat::ElastoDyn {
            return Err(usage(
                "from_height_m applies only to the format elastodyn; the other formats contain the whole tower",
            ));
        }
        let options = ConvertOptions {
            sections_file,
            from_height_m,
        };
        let input = &tower.model.input;
        let files = released(py, || convert(input, format, &options));
        let files = files.map_err(of_convert)?;
        let own = files.of_reader.iter().chain(&files.notes);
        let own = own.map(Note::to_string);
        let notes = tower.model.notes().into_iter().chain(own).collect();
        Ok(Self { files, notes })
    }

    /// The text of the file.
    #[getter]
    fn text(&self) -> &str {
        &self.files.text
    }

    /// Name and text of the second file of a BModes deck.
    #[getter]
    fn companion(&self) -> Option<(String, String)> {
        self.files.companion.clone()
    }

    /// The notes of the reader, and notes on data that the format cannot store.
    #[getter]
    fn notes(&self) -> Vec<String> {
        self.notes.clone()
    }
}
