//! A description of a tower as a TOML file.

mod bodies;
mod foundation;
mod materials;
mod properties;
mod surroundings;
mod text;

use towermodes::{Shear, Station, TowerDescription};

use crate::input::Note;
use materials::MaterialNames;
use text::{number, quoted, rows};

/// What is written: the text so far, and what the user should know of it.
#[derive(Debug, Default)]
struct Writing {
    text: String,
    notes: Vec<Note>,
}

impl Writing {
    /// A line.
    fn line(&mut self, line: impl AsRef<str>) {
        self.text.push_str(line.as_ref());
        self.text.push('\n');
    }

    /// An empty line and the head of a section.
    fn section(&mut self, head: &str) {
        self.line("");
        self.line(head);
    }

    /// `key = value`, and if there is something to say of it, that in a column of comments.
    fn value(&mut self, key: &str, value: &str, comment: &str) {
        let line = format!("{key} = {value}");
        if comment.is_empty() {
            self.line(line);
        } else {
            self.line(format!("{line:<30} # {comment}"));
        }
    }

    /// The name of a part that has one.
    fn name(&mut self, name: Option<&String>) {
        if let Some(name) = name.filter(|name| !name.is_empty()) {
            self.value("name", &quoted(name), "");
        }
    }

    fn number(&mut self, key: &str, value: f64, comment: &str) {
        self.value(key, &number(value), comment);
    }

    fn note(&mut self, message: impl Into<String>) {
        self.notes.push(Note::new(message));
    }
}

/// Writes a description as a TOML file that is read back as the same description, number by number.
///
/// The notes say what such a file cannot hold, or what its reader will refuse.
pub fn write_toml(description: &TowerDescription) -> (String, Vec<Note>) {
    let mut writing = Writing::default();
    writing.line("# A tower for towermodes. Lengths in m, masses in kg, forces in N; z is up, x fore-aft (downwind), y side-side.");
    if !description.name.is_empty() {
        writing.line("");
        writing.value("name", &quoted(&description.name), "");
    }
    tower(description, &mut writing);
    bodies::rna(&description.rna, description.rna_is_point, &mut writing);
    bodies::rotor(description.rotor.as_ref(), &mut writing);
    let names = &description.part_names.point_masses;
    bodies::point_masses(&description.point_masses, names, &mut writing);
    foundation::foundation(&description.foundation, &mut writing);
    surroundings::surroundings(description, &mut writing);
    (writing.text, writing.notes)
}

/// `[material]`, `[materials]` and `[tower]`.
fn tower(description: &TowerDescription, writing: &mut Writing) {
    let has_stations = !description.stations.is_empty() || description.properties.is_empty();
    let names = MaterialNames::of(description);
    if has_stations {
        materials::materials(&description.materials, &names, writing);
    } else {
        unused_beside_properties(description, writing);
    }
    writing.section("[tower]");
    if has_stations {
        stations(&description.stations, &names, writing);
        shear(description.shear, writing);
    }
    if description.outfitting_factor != 1.0 {
        let comment = "multiplies the tower's masses per length";
        writing.number("outfitting_factor", description.outfitting_factor, comment);
    }
    if !description.properties.is_empty() {
        if has_stations {
            writing.note("the description has stations and a table of properties: no tower has both, and the file is refused for it");
        }
        properties::properties(&description.properties, writing);
    }
}

/// A file refuses beside a table of properties what would change nothing there.
fn unused_beside_properties(description: &TowerDescription, writing: &mut Writing) {
    let count = description.materials.len();
    if count > 0 {
        writing.note(format!(
            "materials left out ({count}): nothing is made of them, the table of properties has masses and stiffnesses"
        ));
    }
    if description.shear != Shear::Rigid {
        let message = "the shear model is left out: it is one of stations, the table of properties has its own shear stiffness or none";
        writing.note(message);
    }
}

fn stations(stations: &[Station], names: &MaterialNames, writing: &mut Writing) {
    let row = |station: &Station| {
        let numbers = [
            station.height_m,
            station.outer_diameter_m,
            station.wall_thickness_m,
        ];
        let numbers = numbers.into_iter().map(number);
        numbers
            .chain(names.in_row(station.material))
            .collect::<Vec<_>>()
    };
    let cells: Vec<_> = stations.iter().map(row).collect();
    let comment = "height, outer diameter, wall thickness, all in m";
    if names.are_needed() {
        writing.line(format!("stations = [  # {comment}; material"));
    } else {
        writing.line(format!("stations = [  # {comment}"));
    }
    rows(&cells, writing);
    writing.line("]");
}

fn shear(shear: Shear, writing: &mut Writing) {
    match shear {
        Shear::Rigid => {}
        Shear::Cowper => writing.value("shear", "true", "Timoshenko, Cowper's coefficient"),
        Shear::Coefficient(kappa) => writing.number("shear", kappa, "Timoshenko, this coefficient"),
    }
}
