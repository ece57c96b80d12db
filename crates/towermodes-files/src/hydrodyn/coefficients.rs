//! The coefficients of added mass, by one of three models: the same everywhere, by depth, by
//! member.

use std::collections::HashMap;

use super::growth::MOST_DEPTHS;
use super::profile::Profile;
use super::tables::{Row, Table};
use super::values::Values;
use crate::diagnostic::{Diagnostic, DiagnosticKind};

/// Across and along the axis, without and with growth.
type Four = [f64; 4];
/// Suffixes of the names of these columns: `SimplCa`, `DpthCaMG`.
const SUFFIXES: [&str; 4] = ["Ca", "CaMG", "AxCa", "AxCaMG"];

/// The tables of coefficients.
#[derive(Debug, Clone, Default)]
pub(super) struct Coefficients {
    simple: Option<Four>,
    by_depth: Profile<4>,
    by_member: HashMap<i64, [Four; 2]>,
}

/// The model of a member.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Model {
    /// Equal coefficients for all members and depths.
    Simple(Four),
    /// By depth.
    Depth,
    /// Linear between the ends of the member.
    Member([Four; 2]),
}

impl Coefficients {
    pub(super) fn of(values: &Values<'_>) -> Result<Self, Diagnostic> {
        let simple = match Table::with_column(values.text, "SimplCa")? {
            Some(table) => Some(four(&table, &table.rows[0], "Simpl", "")?),
            None => None,
        };
        let depths = Table::of(values, &["NCoefDpth", "NCoefDpthCyl"], MOST_DEPTHS)?;
        let rows = depths
            .rows
            .iter()
            .map(|row| Ok((depths.number(row, "Dpth")?, four(&depths, row, "Dpth", "")?)));
        let rows: Result<Vec<_>, Diagnostic> = rows.collect();
        let members = Table::of(values, &["NCoefMembers", "NCoefMembersCyl"], usize::MAX)?;
        members.ids("member")?;
        let mut by_member = HashMap::new();
        for row in &members.rows {
            let ends = ["1", "2"].map(|end| four(&members, row, "Member", end));
            let [from, to] = ends;
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

    /// The model of a member by MCoefMod.
    pub(super) fn model(&self, members: &Table<'_>, row: &Row<'_>) -> Result<Model, Diagnostic> {
        let column = members.column(&["MCoefMod"])?;
        let id = row.integer(0, "MemberID")?;
        let missing = |what: String| Err(row.wrong(column, DiagnosticKind::Missing { what }));
        match (
            row.integer(column, "MCoefMod")?,
            self.simple,
            self.by_member.get(&id),
        ) {
            (1, Some(four), _) => Ok(Model::Simple(four)),
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

    /// Across and along the axis, at a height and a fraction of the member.
    pub(super) fn at(
        &self,
        model: &Model,
        z_m: f64,
        middle_m: f64,
        fraction: f64,
        is_grown: bool,
    ) -> [f64; 2] {
        let four = match model {
            Model::Simple(four) => *four,
            Model::Depth => self.by_depth.at(z_m, middle_m).unwrap_or_default(),
            Model::Member([from, to]) => {
                std::array::from_fn(|i| from[i] + fraction * (to[i] - from[i]))
            }
        };
        let [across, across_grown, along, along_grown] = four.map(|value| value.max(0.0));
        match is_grown {
            true => [across_grown, along_grown],
            false => [across, along],
        }
    }
}

/// The four coefficients of a row; the first versions have none along the axis.
fn four(table: &Table<'_>, row: &Row<'_>, prefix: &str, end: &str) -> Result<Four, Diagnostic> {
    let mut four = [0.0; 4];
    for (k, (value, suffix)) in four.iter_mut().zip(SUFFIXES).enumerate() {
        let name = format!("{prefix}{suffix}{end}");
        let is_optional = k >= 2;
        if !is_optional || table.column_if_any(&[&name]).is_some() {
            *value = table.not_negative(row, &name)?;
        }
    }
    Ok(four)
}
