//! The coefficients of added mass, by one of three models: constant, by depth, by member; circles
//! and rectangles have separate tables.

use std::collections::HashMap;

use super::growth::MOST_DEPTHS;
use super::profile::Profile;
use super::section::Form;
use super::tables::{Row, Table};
use super::values::Values;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Six coefficients: along x, along y and along the axis, each without and with growth.
type Six = [f64; 6];

/// The names by which the tables for one form of section are found.
struct Names {
    /// The column that only the table of simple coefficients has.
    simple: &'static str,
    /// The names of the numbers of rows of the tables by depth, and by member.
    depths: &'static [&'static str],
    members: &'static [&'static str],
    /// The column name of each coefficient without prefix: `Ca` in `SimplCa` and `MemberCa1`.
    suffixes: [&'static str; 6],
}

const CIRCLES: Names = Names {
    simple: "SimplCa",
    depths: &["NCoefDpth", "NCoefDpthCyl"],
    members: &["NCoefMembers", "NCoefMembersCyl"],
    suffixes: ["Ca", "CaMG", "Ca", "CaMG", "AxCa", "AxCaMG"],
};

/// The coefficients of a rectangle are named after the side normal to the motion: B for motion
/// along x.
const RECTANGLES: Names = Names {
    simple: "SimplCaB",
    depths: &["NCoefDpthRec"],
    members: &["NCoefMembersRec"],
    suffixes: ["CaB", "CaBMG", "CaA", "CaAMG", "AxCa", "AxCaMG"],
};

/// The tables of coefficients.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    circles: OfForm,
    rectangles: OfForm,
}

/// The coefficients of members with one form of section.
#[derive(Debug, Clone, Default)]
pub(super) struct OfForm {
    simple: Option<Six>,
    by_depth: Profile<6>,
    by_member: HashMap<i64, [Six; 2]>,
}

/// The model of a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Model {
    /// Equal coefficients for all members and depths.
    Simple(Six),
    /// Coefficients by depth.
    Depth,
    /// Coefficients linear between the ends of the member.
    Member([Six; 2]),
}

impl Coefficients {
    pub(super) fn of(values: &Values<'_>) -> Result<Self, Diagnostic> {
        Ok(Self {
            circles: OfForm::of(values, &CIRCLES)?,
            rectangles: OfForm::of(values, &RECTANGLES)?,
        })
    }

    pub(super) fn of_form(&self, form: Form) -> &OfForm {
        match form {
            Form::Circle => &self.circles,
            Form::Rectangle => &self.rectangles,
        }
    }
}

impl OfForm {
    fn of(values: &Values<'_>, names: &Names) -> Result<Self, Diagnostic> {
        let six = |table: &Table<'_>, row: &Row<'_>, prefix, end| {
            six(
                table,
                row,
                names
                    .suffixes
                    .map(|suffix| format!("{prefix}{suffix}{end}")),
            )
        };
        let simple = match Table::with_column(values.text, names.simple)? {
            Some(table) => Some(six(&table, &table.rows[0], "Simpl", "")?),
            None => None,
        };
        let depths = Table::of(values, names.depths, MOST_DEPTHS)?;
        let rows = depths
            .rows
            .iter()
            .map(|row| Ok((depths.number(row, "Dpth")?, six(&depths, row, "Dpth", "")?)));
        let rows: Result<Vec<_>, Diagnostic> = rows.collect();
        let members = Table::of(values, names.members, usize::MAX)?;
        members.ids("member")?;
        let mut by_member = HashMap::new();
        for row in &members.rows {
            let [from, to] = ["1", "2"].map(|end| six(&members, row, "Member", end));
            by_member.insert(row.integer(0, "MemberID")?, [from?, to?]);
        }
        Ok(Self {
            simple,
            by_depth: Profile::new(rows?),
            by_member,
        })
    }

    pub(super) fn heights_m(&self) -> impl Iterator<Item = f64> {
        self.by_depth.heights_m()
    }

    /// The model of a member according to MCoefMod.
    pub(super) fn model(&self, members: &Table<'_>, row: &Row<'_>) -> Result<Model, Diagnostic> {
        let column = members.column(&["MCoefMod"])?;
        let id = row.integer(0, "MemberID")?;
        let missing = |what: String| Err(row.wrong(column, DiagnosticKind::Missing { what }));
        match (
            row.integer(column, "MCoefMod")?,
            self.simple,
            self.by_member.get(&id),
        ) {
            (1, Some(six), _) => Ok(Model::Simple(six)),
            (1, None, _) => missing("the table of simple coefficients (SimplCa)".to_owned()),
            (2, ..) if self.by_depth.heights_m().next().is_some() => Ok(Model::Depth),
            (2, ..) => missing("the table of coefficients by depth (NCoefDpth)".to_owned()),
            (3, _, Some(ends)) => Ok(Model::Member(*ends)),
            (3, _, None) => missing(format!("the row of member {id} in the table NCoefMembers")),
            (other, ..) => {
                let rule = "1 (simple), 2 (by depth) or 3 (by member)";
                let kind = DiagnosticKind::out_of_range("MCoefMod", other as f64, rule);
                Err(row.wrong(column, kind))
            }
        }
    }

    /// The coefficients along x, along y and along the axis, at a height and a fraction of the
    /// member's length.
    pub(super) fn at(
        &self,
        model: &Model,
        z_m: f64,
        middle_m: f64,
        fraction: f64,
        is_grown: bool,
    ) -> [f64; 3] {
        let six = match model {
            Model::Simple(six) => *six,
            Model::Depth => self.by_depth.at(z_m, middle_m).unwrap_or_default(),
            Model::Member([from, to]) => {
                std::array::from_fn(|i| from[i] + fraction * (to[i] - from[i]))
            }
        };
        let of_growth = usize::from(is_grown);
        [0, 2, 4].map(|i| six[i + of_growth].max(0.0))
    }
}

/// The six coefficients of a row; the first versions have none along the axis.
fn six(table: &Table<'_>, row: &Row<'_>, names: [String; 6]) -> Result<Six, Diagnostic> {
    let mut six = [0.0; 6];
    for (k, (value, name)) in six.iter_mut().zip(names).enumerate() {
        let is_optional = k >= 4;
        if !is_optional || table.column_if_any(&[&name]).is_some() {
            *value = table.not_negative(row, &name)?;
        }
    }
    Ok(six)
}
