//! The layers of soil around the pile, in a table.

use towermodes::inputs::given_inputs;
use towermodes::{FoundationHead, Ground, GroundLayer, SpringsAt, TipSprings, Tower};

use super::super::table::Table;
use super::inputs::{in_short, of_inputs_but};
use crate::number::{given, length};

/// Largest number of layers that are shown.
const MOST_LAYERS: usize = 50;

/// The ground as a whole, its layers, and the resulting springs.
pub(super) fn ground(ground: &Ground, names: &[String], tower: &Tower) -> Vec<Table> {
    let edition: &[&str] = match ground.depends_on_edition() {
        true => &[],
        false => &["edition"],
    };
    let mut tables = vec![
        of_inputs_but("Soil in layers", ground, edition, []),
        layers(ground, names),
    ];
    tables.push(match tower.frame() {
        Some(_) => springs_of_members(tower),
        None => springs(tower),
    });
    tables.extend(tower.springs_at_tip().map(|tip| springs_at_tip(&tip)));
    tables.extend(tower.foundation_head().map(pile_head));
    tables
}

fn springs(tower: &Tower) -> Table {
    let mut table = Table::new(
        "Spring stiffness per unit length of the pile, sum of all soil layers, from the surface down; linear between rows",
        [
            "#height z (m)",
            "#lateral k (N/m²)",
            "#z (N/m²)",
            "#rotation about x and y (N)",
            "#torsion (N)",
        ],
    );
    for springs in tower.springs_of_soil().iter().rev() {
        table.push(cells(springs));
    }
    table.without_empty_columns().shortened()
}

fn springs_at_tip(tip: &TipSprings) -> Table {
    let mut table = Table::new(
        "Springs of the soil under the pile tip, which add to the foundation at the base",
        [
            "#height z (m)",
            "#lateral, x and y (N/m)",
            "#rocking, about x and y (N m)",
            "#vertical (N/m)",
            "#torsion (N m)",
        ],
    );
    table.push([
        length(tip.height_m),
        given(tip.lateral_n_per_m),
        given(tip.rocking_n_m),
        given(tip.vertical_n_per_m),
        given(tip.torsion_n_m),
    ]);
    table.without_empty_columns()
}

/// The height of springs, and their stiffness across, along, for rotation across and torsion.
fn cells(springs: &SpringsAt) -> [String; 5] {
    [
        length(springs.height_m),
        given(springs.lateral_n_per_m2),
        given(springs.vertical_n_per_m2),
        given(springs.rotation_n),
        given(springs.torsion_n),
    ]
}

fn springs_of_members(tower: &Tower) -> Table {
    let mut table = Table::new(
        "Spring stiffness per unit length of the piles below the surface of the soil, lateral and axial to each member; linear between rows",
        [
            "member",
            "#height z (m)",
            "#across k (N/m²)",
            "#along (N/m²)",
            "#rotation across (N)",
            "#torsion (N)",
        ],
    );
    for of_member in tower.springs_of_members() {
        for springs in &of_member.springs {
            let member = std::iter::once(of_member.member.clone());
            table.push(member.chain(cells(springs)));
        }
    }
    table.without_empty_columns().shortened()
}

pub(super) fn pile_head(head: FoundationHead) -> Table {
    let stiffness = head.fore_aft;
    Table::of_facts(
        "Static stiffness of the pile at the surface of the soil: force and moment per deflection and rotation of the pile at this height",
        [
            (
                "surface of the soil after scour z (m)",
                length(head.height_m),
            ),
            ("K_L (N/m)", given(stiffness.lateral_n_per_m)),
            ("K_LR (N)", given(stiffness.coupling_n)),
            ("K_R (N m)", given(stiffness.rocking_n_m)),
        ],
    )
}

fn layers(ground: &Ground, names: &[String]) -> Table {
    let columns = [
        "layer",
        "#top z (m)",
        "#bottom z (m)",
        "soil",
        "model",
        "values",
    ];
    let mut table = Table::new("Layers of soil from the surface down", columns);
    for (index, layer) in ground.layers.iter().enumerate().take(MOST_LAYERS) {
        let name = names.get(index).filter(|name| !name.trim().is_empty());
        table.push([
            name.cloned().unwrap_or_else(|| (index + 1).to_string()),
            length(layer.top_m),
            length(layer.bottom_m),
            layer.soil.noun().to_owned(),
            layer.model.name().to_owned(),
            values(layer, &ground.unused_values(index)).join("; "),
        ]);
    }
    table
}

/// The values of a layer that its models use, each with its unit.
fn values(layer: &GroundLayer, unused: &[&str]) -> Vec<String> {
    // Without the modulus its other values have no meaning either.
    let modulus = layer.shear_modulus;
    let modulus = modulus.filter(|modulus| unused.contains(&modulus.key()));
    let of_modulus = given_inputs(&modulus).into_iter();
    let of_modulus = of_modulus.map(|(input, _)| input.key);
    let unused: Vec<&str> = unused.iter().copied().chain(of_modulus).collect();
    let rows = layer.soil.rows().len();
    let rows = (rows > 0).then(|| format!("{rows} rows"));
    rows.into_iter().chain(in_short(layer, &unused)).collect()
}
