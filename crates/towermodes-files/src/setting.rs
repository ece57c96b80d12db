//! Input values of a tower that are set by name after its file is read, such as `rna.mass=360000`.

use std::fmt;
use std::str::FromStr;

use thiserror::Error;
use towermodes::number::{Plain, Rounded};
use towermodes::{Change, Operation, Parameter, ParameterError, Place, TowerDescription};

use crate::diagnostic::Exact;
use crate::input::TowerInput;
use crate::note::Note;
use crate::source::Source;

/// A change of a tower by name, and its value: `rna.mass=360000`, `scale(stations[*].wall)=1.1`.
///
/// # Example
/// ```
/// use towermodes_files::Setting;
///
/// let setting: Setting = "rna.mass = 3.6e5".parse()?;
/// assert_eq!((setting.name(), setting.value()), ("rna.mass", 3.6e5));
/// assert!("rna.mass=360 t".parse::<Setting>().is_err());
/// # Ok::<(), towermodes_files::SettingError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Setting {
    name: String,
    value: f64,
    text: String,
}

/// Why an input value cannot be set.
#[derive(Debug, Clone, PartialEq, Error)]
#[non_exhaustive]
pub enum SettingError {
    /// The text has no `=`, or nothing before it.
    #[error("`{text}` is not NAME=VALUE; write for example rna.mass=360000")]
    Form {
        /// The text.
        text: String,
    },
    /// The value is not a number.
    #[error("the value of {name} is `{found}`, but must be a number; {remedy}")]
    NotNumber {
        /// The name.
        name: String,
        /// The text found instead of a number.
        found: String,
        /// The suggestion.
        remedy: String,
    },
    /// The value is infinite or NaN, or larger than any number in double precision.
    #[error("the value of {name} is {value}, but must be a finite number")]
    NotFinite {
        /// The name.
        name: String,
        /// The value.
        value: f64,
    },
    /// The tower has no such input value, or two settings contradict each other.
    #[error(transparent)]
    Parameter(#[from] ParameterError),
}

impl Setting {
    /// The change with a name and its value.
    pub fn new(name: impl Into<String>, value: f64) -> Self {
        let name = name.into();
        let text = format!("{name}={}", Exact(value));
        Self { name, value, text }
    }

    /// The name of the change.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its value.
    pub fn value(&self) -> f64 {
        self.value
    }

    /// The value as written.
    fn written(&self) -> &str {
        self.text
            .rsplit_once('=')
            .map_or("", |(_, value)| value)
            .trim()
    }
}

impl fmt::Display for Setting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text)
    }
}

impl FromStr for Setting {
    type Err = SettingError;

    fn from_str(text: &str) -> Result<Self, SettingError> {
        let form = || SettingError::Form {
            text: text.to_owned(),
        };
        let (name, value) = text.rsplit_once('=').ok_or_else(form)?;
        let (name, value) = (name.trim().to_owned(), value.trim());
        if name.is_empty() {
            return Err(form());
        }
        let Ok(number) = value.parse::<f64>() else {
            return Err(SettingError::NotNumber {
                remedy: remedy(value),
                found: value.to_owned(),
                name,
            });
        };
        // Infinity may be meant, as of a rigid spring; a number that overflows is not.
        let is_word = value.trim_start_matches(['+', '-']).starts_with(['i', 'I']);
        if number.is_nan() || (number.is_infinite() && !is_word) {
            let value = number;
            return Err(SettingError::NotFinite { name, value });
        }
        Ok(Self {
            name,
            value: number,
            text: text.trim().to_owned(),
        })
    }
}

/// Suggestion for a text that is not a number.
fn remedy(value: &str) -> String {
    let decimal = value.replacen(',', ".", 1);
    let whole = value.replace(',', "");
    let is_group = |digits: &str| digits.len() == 3 && digits.bytes().all(|b| b.is_ascii_digit());
    match (decimal.parse::<f64>(), value.split_once(',')) {
        (Ok(_), Some((_, digits))) if is_group(digits) => {
            format!("write {whole}, or {decimal} if the comma is a decimal comma")
        }
        (Ok(_), Some(_)) => format!("write a decimal point: {decimal}"),
        // A name of a model, a flag, a quoted text or a list.
        _ if value.starts_with(|c: char| c.is_alphabetic() || c == '"' || c == '[') => {
            "values that are not numbers are changed in the tower file".to_owned()
        }
        _ => "write only the number, in the unit of the tower file".to_owned(),
    }
}

impl TowerInput {
    /// Sets input values by name, each with a note. `by` is the origin of the settings, such as
    /// `--set`: errors and warnings about a changed input value refer to the line of its setting
    /// under this name.
    ///
    /// The element boundaries of a BModes deck are dropped if heights change.
    ///
    /// # Errors
    /// [`SettingError`]; then nothing is changed. Whether the tower is possible is checked by
    /// [`Self::tower`].
    ///
    /// # Example
    /// ```
    /// # let folder = env!("CARGO_MANIFEST_DIR");
    /// # let path = format!("{folder}/../../examples/nrel-5mw.toml");
    /// use towermodes_files::{Setting, read_tower};
    ///
    /// let mut input = read_tower(path)?.input;
    /// input.set(&[Setting::new("rna.mass", 3.6e5)], "--set")?;
    /// assert_eq!(input.tower()?.rna().mass_kg, 3.6e5);
    /// let note = input.notes.last().expect("a note").to_string();
    /// assert_eq!(note, "rna.mass = 360000 kg by --set; the file has 350000");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn set(&mut self, settings: &[Setting], by: &str) -> Result<(), SettingError> {
        let names = settings.iter().map(Setting::name);
        let changes = Change::parse_all(names, &self.description)?;
        let pairs = || changes.iter().zip(settings);
        for (change, setting) in pairs() {
            if setting.value.is_infinite() && change.operation() != Operation::Set {
                return Err(SettingError::NotFinite {
                    name: setting.name.clone(),
                    value: setting.value,
                });
            }
        }
        let before = self.description.clone();
        for (change, setting) in pairs() {
            change.apply(&mut self.description, setting.value);
        }
        if self.description.rna != before.rna {
            let message = format!(
                "the rotor-nacelle assembly is changed by {by}, so that there is no turbine with the same nacelle and rotor"
            );
            self.remove_turbine(Some(Note::missing_part(message)));
        }
        let after = &self.description;
        let notes = pairs().map(|(change, setting)| note(change, setting, by, [&before, after]));
        self.notes.extend(notes.collect::<Vec<_>>());
        self.remember_settings(&changes, settings, by);
        self.drop_borders(&changes);
        Ok(())
    }

    /// Stores the places of the changed input values in a text with a line for each setting.
    fn remember_settings(&mut self, changes: &[Change], settings: &[Setting], by: &str) {
        if settings.is_empty() {
            return;
        }
        let file = self.sources.len() + self.settings.len();
        let mut text = String::new();
        for (change, setting) in changes.iter().zip(settings) {
            let start = text.len() + setting.text.len() - setting.written().len();
            text.push_str(&setting.text);
            let span = start..text.len();
            text.push('\n');
            for parameter in change.parameters() {
                self.places.remember(parameter.place(), file, span.clone());
            }
        }
        let name = by.to_owned();
        self.settings.push(Source { name, text });
    }

    fn drop_borders(&mut self, changes: &[Change]) {
        let is_height = |parameter: &Parameter| {
            matches!(parameter.place(), Place::Station { key: "height", .. })
        };
        let mut changed = changes.iter().flat_map(Change::parameters);
        if self.prescribed.borders_m.is_some() && changed.any(is_height) {
            self.prescribed.borders_m = None;
            self.notes.push(Note::approximation(
                "the elements of the deck are not used, because the heights of the tower are changed",
            ));
        }
    }
}

/// "rna.mass = 360000 kg by --set; the file has 350000".
fn note(change: &Change, setting: &Setting, by: &str, towers: [&TowerDescription; 2]) -> Note {
    let parameters = change.parameters();
    let unit = match parameters.first().map_or("", |first| first.unit()) {
        unit if parameters.iter().all(|one| one.unit() == unit) => unit,
        _ => return of_several_units(change, setting, by),
    };
    let space = if unit.is_empty() { "" } else { " " };
    let [before, after] = towers.map(|tower| range(parameters, tower));
    let is_set = change.operation() == Operation::Set;
    let value = match is_set {
        true => format!(" = {}{space}{unit} by {by}", Plain(setting.value)),
        false => format!(" = {} by {by}", Plain(setting.value)),
    };
    let result = match (is_set, parameters.len()) {
        (true, 1) => String::new(),
        (true, count) => format!(": {count} values"),
        (false, 1) => format!(": now {after}{space}{unit}"),
        (false, count) => format!(": {count} values, now {after}{space}{unit}"),
    };
    let name = change.name();
    Note::new(format!("{name}{value}{result}; the file has {before}"))
}

/// The note for input values of several units, which have no common range.
fn of_several_units(change: &Change, setting: &Setting, by: &str) -> Note {
    let (name, count) = (change.name(), change.parameters().len());
    let value = Plain(setting.value);
    Note::new(format!("{name} = {value} by {by}: {count} values"))
}

/// "0.019 to 0.027", or one number if all are equal.
fn range(parameters: &[Parameter], tower: &TowerDescription) -> String {
    let values = || parameters.iter().map(|parameter| parameter.value(tower));
    let lowest = values().fold(f64::INFINITY, f64::min);
    let highest = values().fold(f64::NEG_INFINITY, f64::max);
    match lowest == highest {
        true => Rounded(lowest).to_string(),
        false => format!("{} to {}", Rounded(lowest), Rounded(highest)),
    }
}
