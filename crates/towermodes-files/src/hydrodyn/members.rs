//! The tables of joints, sections, members and fillings.

use std::collections::HashMap;

use super::coefficients::{Coefficients, Model};
use super::ends::Joint;
use super::growth::Growth;
use super::section::{Form, StripSection, blend};
use super::sections::{Sections, form};
use super::spatial::Vector;
use super::strip::{Stretch, StripAddedMass, StripMember};
use super::tables::{Ids, Row, Table};
use super::values::Values;
use super::water::SeaWater;
use crate::diagnostic::{Diagnostic, DiagnosticKind};
use crate::note::Note;
use crate::source::Source;

/// The members of a file, with the joints of each.
#[derive(Debug, Default)]
pub(super) struct Members {
    pub(super) joints: Vec<Joint>,
    pub(super) members: Vec<StripMember>,
    pub(super) joints_of: Vec<[usize; 2]>,
    /// The byte of the row of each member.
    pub(super) rows: Vec<usize>,
    pub(super) notes: Vec<Note>,
}

/// The data that the stretches of all members depend on.
pub(super) struct Site<'s> {
    pub(super) water: &'s SeaWater,
    pub(super) growth: &'s Growth,
    pub(super) coefficients: &'s Coefficients,
}

/// Reads the members.
pub(super) fn read(
    values: &Values<'_>,
    source: &Source,
    site: &Site<'_>,
) -> Result<Members, Diagnostic> {
    let table = Table::of(values, &["NMembers"], usize::MAX)?;
    if table.rows.is_empty() {
        return Ok(Members::default());
    }
    let joint_table = Table::of(values, &["NJoints"], usize::MAX)?;
    let joint_ids = joint_table.ids("joint")?;
    let joints = joints(values, &joint_table)?;
    let sections = Sections::of(values)?;
    let member_ids = table.ids("member")?;
    let fillings = fillings(values, &member_ids, site.water)?;
    let mut found = Members {
        joints,
        ..Members::default()
    };
    for (index, row) in table.rows.iter().enumerate() {
        let ends = [
            joint_ids.find(row, table.column(&["MJointID1"])?, "MJointID1")?,
            joint_ids.find(row, table.column(&["MJointID2"])?, "MJointID2")?,
        ];
        let ends_m = ends.map(|joint| found.joints[joint].position_m);
        let filling = fillings.get(&index);
        // The water of such a member is that of the body, and it has no other mass.
        let is_rectangle = form(&table, row)? == Form::Rectangle;
        if is_rectangle && is_potential(&table, row)? && filling.is_none() {
            continue;
        }
        let section = sections.of_member(&table, row)?;
        let member = member(&table, row, ends_m, &section, filling, site)?;
        found.members.push(member);
        found.joints_of.push(ends);
        found.rows.push(row.span().start);
    }
    found.notes = overlaps(&joint_table, source);
    Ok(found)
}

fn joints(values: &Values<'_>, table: &Table<'_>) -> Result<Vec<Joint>, Diagnostic> {
    let axial = Table::of(values, &["NAxCoef"], usize::MAX)?;
    let axial_ids = axial.ids("axial coefficient")?;
    let joints = table.rows.iter().map(|row| {
        let mut position_m = [0.0; 3];
        for (x, name) in position_m.iter_mut().zip(["Jointxi", "Jointyi", "Jointzi"]) {
            *x = table.number(row, name)?;
        }
        let set = axial_ids.find(row, table.column(&["JointAxID"])?, "JointAxID")?;
        Ok(Joint {
            name: row.integer(0, "JointID")?.to_string(),
            position_m,
            axial: axial.not_negative(&axial.rows[set], "AxCa")?,
        })
    });
    joints.collect()
}

/// The note on JointOvrlp.
fn overlaps(table: &Table<'_>, source: &Source) -> Vec<Note> {
    let Some(column) = table.column_if_any(&["JointOvrlp"]) else {
        return Vec::new();
    };
    let is_set = |row: &&Row<'_>| row.number(column, "").is_ok_and(|value| value != 0.0);
    let first = table.rows.iter().find(is_set);
    let message = "JointOvrlp is not used: members that overlap at a joint keep their whole length, as in HydroDyn";
    let note = |row: &Row<'_>| Note::left_out(message).at(source, row.span().start);
    first.map(note).into_iter().collect()
}

/// Whether the water of a member belongs to the body of the potential-flow solution.
fn is_potential(table: &Table<'_>, row: &Row<'_>) -> Result<bool, Diagnostic> {
    let column = table.column(&["PropPot", "PropWAMIT"])?;
    row.token(column, "PropPot")?.logical("PropPot")
}

/// The level and density of the filling of a member.
#[derive(Debug, Clone, Copy)]
struct Filling {
    level_m: f64,
    density_kg_per_m3: f64,
}

/// The fillings by the index of their member.
fn fillings(
    values: &Values<'_>,
    members: &Ids,
    water: &SeaWater,
) -> Result<HashMap<usize, Filling>, Diagnostic> {
    let table = Table::of(values, &["NFillGroups"], usize::MAX)?;
    let mut fillings = HashMap::new();
    for row in &table.rows {
        let count = row.integer(0, "FillNumM")?;
        let fits = usize::try_from(count)
            .ok()
            .filter(|count| *count < row.tokens.len());
        let Some(count) = fits else {
            let rule = "the number of members in the list after it";
            let kind = DiagnosticKind::out_of_range("FillNumM", count as f64, rule);
            return Err(row.wrong(0, kind));
        };
        let filling = Filling {
            level_m: row.number(count + 1, "FillFSLoc")?,
            density_kg_per_m3: fill_density(row, count + 2, water)?,
        };
        for column in 1..=count {
            let member = members.find(row, column, "FillMList")?;
            if fillings.insert(member, filling).is_some() {
                let what = format!(
                    "member {} in the lists of filled members",
                    row.tokens[column].text
                );
                let kind = DiagnosticKind::Repeated { what, times: 2 };
                return Err(row
                    .wrong(column, kind)
                    .with_hint("a member belongs to one group"));
            }
        }
    }
    Ok(fillings)
}

fn fill_density(row: &Row<'_>, column: usize, water: &SeaWater) -> Result<f64, Diagnostic> {
    let token = row.token(column, "FillDens")?;
    if token.text.eq_ignore_ascii_case("default") {
        return Ok(water.density_kg_per_m3);
    }
    let density = row.number(column, "FillDens")?;
    match density >= 0.0 {
        true => Ok(density),
        false => {
            let kind = DiagnosticKind::out_of_range("FillDens", density, "0 or positive");
            Err(row.wrong(column, kind))
        }
    }
}

fn member(
    table: &Table<'_>,
    row: &Row<'_>,
    ends_m: [Vector; 2],
    section: &StripSection,
    filling: Option<&Filling>,
    site: &Site<'_>,
) -> Result<StripMember, Diagnostic> {
    let is_potential_flow = is_potential(table, row)?;
    let has_hydrostatics = match table.column_if_any(&["MHstLMod"]) {
        Some(column) => row.integer(column, "MHstLMod")? != 0,
        None => true,
    };
    let mut member = StripMember {
        name: row.integer(0, "MemberID")?.to_string(),
        ends_m,
        spin_deg: match table.column_if_any(&["MSpinOrient"]) {
            Some(column) => row.number(column, "MSpinOrient")?,
            None => 0.0,
        },
        is_potential_flow,
        has_hydrostatics,
        stretches: Vec::new(),
    };
    if ends_m[0] == ends_m[1] {
        let message = format!("both joints of member {} are at one point", member.name);
        return Err(row.wrong(0, DiagnosticKind::Contradiction(message)));
    }
    let model = match is_potential_flow {
        true => None,
        false => Some(
            site.coefficients
                .of_form(section.form())
                .model(table, row)?,
        ),
    };
    member.stretches = stretches(&member, section, model, filling, site);
    Ok(member)
}

/// Cuts that are closer together than this share of the member are merged.
const SAME_CUT: f64 = 1e-12;

/// Divides the member into stretches, at the heights at which a property begins or ends.
fn stretches(
    member: &StripMember,
    section: &StripSection,
    model: Option<Model>,
    filling: Option<&Filling>,
    site: &Site<'_>,
) -> Vec<Stretch> {
    let [from_m, to_m] = member.ends_m.map(|end_m| end_m[2]);
    let water = site.water;
    let heights = [water.level_m, -water.depth_m].into_iter();
    let heights = heights
        .chain(site.growth.heights_m())
        .chain(site.coefficients.of_form(section.form()).heights_m());
    let heights = heights.chain(filling.map(|filling| filling.level_m));
    let mut cuts = vec![0.0, 1.0];
    cuts.extend(heights.map(|z_m| (z_m - from_m) / (to_m - from_m)));
    cuts.retain(|cut| (0.0..=1.0).contains(cut));
    cuts.sort_by(f64::total_cmp);
    cuts.dedup_by(|a, b| *a - *b < SAME_CUT && *a != 1.0);
    let ranges = cuts.windows(2).filter(|pair| pair[1] - pair[0] >= SAME_CUT);
    let ranges = ranges.map(|pair| [pair[0], pair[1]]);
    ranges
        .map(|range| stretch(range, [from_m, to_m], section, model, filling, site))
        .collect()
}

fn stretch(
    range: [f64; 2],
    ends_m: [f64; 2],
    section: &StripSection,
    model: Option<Model>,
    filling: Option<&Filling>,
    site: &Site<'_>,
) -> Stretch {
    let z_m = range.map(|fraction| blend(ends_m, fraction));
    let middle_m = 0.5 * (z_m[0] + z_m[1]);
    let is_wet = site.water.holds(middle_m);
    let is_above_seabed = middle_m >= -site.water.depth_m;
    let growth = model
        .filter(|_| is_above_seabed)
        .and_then(|_| site.growth.between(z_m));
    let added_mass = model.filter(|_| is_wet).map(|model| {
        let at = |end: usize| {
            let (z_m, fraction) = (z_m[end], range[end]);
            let coefficients = site.coefficients.of_form(section.form());
            coefficients.at(&model, z_m, middle_m, fraction, growth.is_some())
        };
        let ends = [at(0), at(1)];
        StripAddedMass {
            across: ends.map(|[x, y, _]| [x, y]),
            along: ends.map(|[_, _, along]| along),
        }
    });
    let filling = filling.filter(|filling| is_above_seabed && middle_m <= filling.level_m);
    Stretch {
        range,
        section: section.part(range),
        is_wet,
        growth,
        added_mass,
        fill_density_kg_per_m3: filling.map_or(0.0, |filling| filling.density_kg_per_m3),
    }
}
