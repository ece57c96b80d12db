//! The tables of properties that members refer to.

use std::cell::Cell;

use towermodes::Material;
use towermodes::frame::{GivenSection, Rectangle};
use towermodes::tower::Tube;

use super::rows::{Ids, Row};
use super::sections::{Kind, Sections};
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::source::Source;

/// The properties of a table and their numbers.
#[derive(Debug, Clone)]
pub(super) struct Sets<T> {
    pub(super) ids: Ids,
    values: Vec<(T, Cell<bool>)>,
}

impl<T> Sets<T> {
    fn of(
        rows: &[Row<'_>],
        what: &'static str,
        read: impl Fn(&Row<'_>) -> Result<T, Diagnostic>,
    ) -> Result<Self, Diagnostic> {
        let ids = Ids::of(rows, what)?;
        let values = rows.iter().map(|row| Ok((read(row)?, Cell::new(false))));
        let values = values.collect::<Result<_, _>>()?;
        Ok(Self { ids, values })
    }

    /// The property set at an index; it is marked as used.
    pub(super) fn used(&self, index: usize) -> &T {
        let (value, is_used) = &self.values[index];
        is_used.set(true);
        value
    }

    /// The rows that no member refers to.
    fn unused<'r, 'a>(&self, rows: &'r [Row<'a>]) -> impl Iterator<Item = &'r Row<'a>> {
        let pairs = rows.iter().zip(&self.values);
        let unused: Vec<_> = pairs.filter(|(_, (_, used))| !used.get()).collect();
        unused.into_iter().map(|(row, _)| row)
    }
}

/// A cable.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cable {
    pub(super) axial_n: f64,
    pub(super) mass_kg_per_m: f64,
    pub(super) pretension_n: f64,
}

/// All properties of a file.
#[derive(Debug, Clone)]
pub(super) struct Properties {
    pub(super) circular: Sets<(Material, Tube)>,
    pub(super) rectangular: Sets<(Material, Rectangle)>,
    pub(super) arbitrary: Sets<(Material, GivenSection)>,
    pub(super) cables: Sets<Cable>,
    pub(super) rigid_links: Sets<f64>,
    pub(super) springs: Sets<[[f64; 6]; 6]>,
    pub(super) cosines: Sets<[[f64; 3]; 3]>,
}

impl Properties {
    pub(super) fn of(sections: &Sections<'_>) -> Result<Self, Diagnostic> {
        let rows = |kind| sections.rows(kind);
        let read_rigid = |row: &Row<'_>| row.number(1, "MatDens");
        Ok(Self {
            circular: Sets::of(rows(Kind::Circular), "circular section", circular)?,
            rectangular: Sets::of(rows(Kind::Rectangular), "rectangular section", rectangular)?,
            arbitrary: Sets::of(rows(Kind::Arbitrary), "arbitrary section", arbitrary)?,
            cables: Sets::of(rows(Kind::Cables), "cable property set", cable)?,
            rigid_links: Sets::of(
                rows(Kind::RigidLinks),
                "rigid link property set",
                read_rigid,
            )?,
            springs: Sets::of(rows(Kind::Springs), "spring property set", spring)?,
            cosines: Sets::of(rows(Kind::Cosines), "cosine matrix", cosines)?,
        })
    }

    /// The notes on properties that no member refers to.
    pub(super) fn unused(&self, sections: &Sections<'_>, source: &Source) -> Vec<Note> {
        let rows = |kind| sections.rows(kind);
        let mut notes = Vec::new();
        let mut add = |what: &str, unused: Vec<&Row<'_>>| {
            let Some(first) = unused.first() else {
                return;
            };
            let ids = unused.iter().filter_map(|row| row.get(0)).map(|id| id.text);
            let ids = ids.collect::<Vec<_>>().join(", ");
            let message = format!("no member refers to these {what}: {ids}");
            notes.push(Note::left_out(message).at(source, first.span().start));
        };
        let Self {
            circular,
            rectangular,
            arbitrary,
            cables,
            rigid_links,
            springs,
            cosines,
        } = self;
        add(
            "circular sections",
            circular.unused(rows(Kind::Circular)).collect(),
        );
        add(
            "rectangular sections",
            rectangular.unused(rows(Kind::Rectangular)).collect(),
        );
        add(
            "arbitrary sections",
            arbitrary.unused(rows(Kind::Arbitrary)).collect(),
        );
        add(
            "cable properties",
            cables.unused(rows(Kind::Cables)).collect(),
        );
        add(
            "rigid link properties",
            rigid_links.unused(rows(Kind::RigidLinks)).collect(),
        );
        add(
            "spring properties",
            springs.unused(rows(Kind::Springs)).collect(),
        );
        add(
            "cosine matrices",
            cosines.unused(rows(Kind::Cosines)).collect(),
        );
        notes
    }
}

/// The columns of the material, after the number of the set.
fn material(row: &Row<'_>) -> Result<Material, Diagnostic> {
    let [young, shear, density] = row.numbers_from(1, ["YoungE", "ShearG", "MatDens"])?;
    Ok(Material::from_shear_modulus(density, young, shear))
}

/// The material and the tube; a wall thickness of 0 means a solid section.
fn circular(row: &Row<'_>) -> Result<(Material, Tube), Diagnostic> {
    let material = material(row)?;
    let [outer_diameter_m, wall_m] = row.numbers_from(4, ["XsecD", "XsecT"])?;
    let wall_thickness_m = if wall_m == 0.0 {
        0.5 * outer_diameter_m
    } else {
        wall_m
    };
    let tube = Tube {
        outer_diameter_m,
        wall_thickness_m,
    };
    Ok((material, tube))
}

fn rectangular(row: &Row<'_>) -> Result<(Material, Rectangle), Diagnostic> {
    let material = material(row)?;
    let [side_a_m, side_b_m, wall_thickness_m] =
        row.numbers_from(4, ["XsecSa", "XsecSb", "XsecT"])?;
    let rectangle = Rectangle {
        side_a_m,
        side_b_m,
        wall_thickness_m,
    };
    Ok((material, rectangle))
}

/// The material and the section; without a torsion constant, as before OpenFAST 4.1, the polar
/// moment is used for torsion.
fn arbitrary(row: &Row<'_>) -> Result<(Material, GivenSection), Diagnostic> {
    let material = material(row)?;
    let names = [
        "XsecA", "XsecAsx", "XsecAsy", "XsecJxx", "XsecJyy", "XsecJ0",
    ];
    let [area_m2, shear_x, shear_y, about_x, about_y, polar_m4] = row.numbers_from(4, names)?;
    let torsion_m4 = match row.numbers() {
        11.. => row.number(10, "XsecJt")?,
        _ => polar_m4,
    };
    let section = GivenSection {
        area_m2,
        shear_areas_m2: [shear_x, shear_y],
        second_moments_m4: [about_x, about_y],
        polar_m4,
        torsion_m4,
    };
    Ok((material, section))
}

fn cable(row: &Row<'_>) -> Result<Cable, Diagnostic> {
    let [axial_n, mass_kg_per_m, pretension_n] = row.numbers_from(1, ["EA", "MatDens", "T0"])?;
    Ok(Cable {
        axial_n,
        mass_kg_per_m,
        pretension_n,
    })
}

/// The upper triangle by rows: k11, k12 … k16, k22 … k66.
fn spring(row: &Row<'_>) -> Result<[[f64; 6]; 6], Diagnostic> {
    let mut upper = [[0.0; 6]; 6];
    let mut column = 1;
    for (i, entries) in upper.iter_mut().enumerate() {
        for (j, entry) in entries.iter_mut().enumerate().skip(i) {
            *entry = row.number(column, &format!("k{}{}", i + 1, j + 1))?;
            column += 1;
        }
    }
    let entry = |i: usize, j: usize| upper[i.min(j)][i.max(j)];
    Ok(std::array::from_fn(|i| {
        std::array::from_fn(|j| entry(i, j))
    }))
}

/// The axes of a member as rows.
fn cosines(row: &Row<'_>) -> Result<[[f64; 3]; 3], Diagnostic> {
    let names = [
        "COSM11", "COSM12", "COSM13", "COSM21", "COSM22", "COSM23", "COSM31", "COSM32", "COSM33",
    ];
    let [a, b, c, d, e, f, g, h, i] = row.numbers_from(1, names)?;
    Ok([[a, b, c], [d, e, f], [g, h, i]])
}

/// The mistake of a member with different properties at its ends.
pub(super) fn unlike(row: &Row<'_>, column: usize, message: String, hint: &str) -> Diagnostic {
    let kind = DiagnosticKind::Contradiction(message);
    row.wrong(column, kind).with_hint(hint.to_owned())
}
