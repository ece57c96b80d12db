//! Polynomial shapes for ElastoDyn, and how well they fit.

use towermodes::Plane;
use towermodes_analysis::elastodyn::{PassedOver, TowerShape};

use super::super::content::{ElastoDynShapes, ReportContent};
use super::super::document::Block;
use super::super::plot_command::command;
use super::super::table::Table;
use super::{paragraph, table};
use crate::number::{digits, four_digits, length, percent};

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let made = match &content.elastodyn {
        Ok(made) => made,
        Err(error) => {
            return vec![paragraph(format!(
                "There are no shapes for ElastoDyn: {error}."
            ))];
        }
    };
    let mut blocks = vec![
        paragraph(format!(
            "ElastoDyn describes the tower from {} m to {} m by two shapes in each plane, polynomials of the share of the height of degree 2 to \
             6 that neither move nor turn at the base and are 1 at the top. {}These are fitted by least squares to the modes of the spectral \
             beam, the tower with all that it carries and stands on; residuals are shares of a shape's largest deflection. ElastoDyn's \
             frequency of a shape alone is that of its own formulas, without what is on the top and without gravity.",
            length(content.shapes_from_m),
            length(content.tower.top_m()),
            base(content)
        )),
        table(coefficients(made)),
        paragraph("The whole tower file, with these coefficients, is written by"),
        Block::Code(command(
            content,
            "elastodyn tower",
            &["--output Tower.dat".to_owned()],
        )),
    ];
    blocks.extend(lacks(content).map(paragraph));
    if begins_in_soil_or_water(content) {
        blocks.push(paragraph(
            "Here the flexible tower begins at the lowest height, in soil or water; --from-height of that command says where ElastoDyn's \
             tower begins.",
        ));
    }
    let passed_over = &made.shapes.passed_over;
    if !passed_over.is_empty() {
        blocks.push(paragraph(
            "Modes that bend but were left out for their torsion, which ElastoDyn's towers do not have:",
        ));
        let passed = passed_over.iter();
        blocks.push(Block::List(passed.map(left_out).collect()));
    }
    blocks
}

/// That what the base does in a mode is none of a shape, where it does anything.
fn base(content: &ReportContent) -> &'static str {
    let tower = &content.tower;
    if tower.base().is_clamped() && content.shapes_from_m == tower.base_m() {
        return "";
    }
    "How far the lower end moves and turns in a mode is taken out of it first. "
}

/// What holds and surrounds the tower here and is not in ElastoDyn.
fn lacks(content: &ReportContent) -> Option<String> {
    let d = &content.description;
    let things = [
        (
            !content.tower.base().is_clamped(),
            "the motion of the base in the modes",
        ),
        (
            content.shapes_from_m > content.tower.base_m(),
            "the tower below",
        ),
        (!d.soil.is_empty(), "the soil"),
        (
            d.water.is_some() || !d.added_mass.is_empty(),
            "the mass of the water",
        ),
        (!d.wires.is_empty(), "the wires"),
    ];
    let there: Vec<&str> = things
        .into_iter()
        .filter(|(is_there, _)| *is_there)
        .map(|(_, what)| what)
        .collect();
    (!there.is_empty()).then(|| {
        format!(
            "ElastoDyn's tower stands clamped on its platform and does not have {}: what these do to the frequencies must come from other \
             modules of OpenFAST, or is not there.",
            there.join(", ")
        )
    })
}

fn begins_in_soil_or_water(content: &ReportContent) -> bool {
    let d = &content.description;
    let is_surrounded = !d.soil.is_empty() || d.water.is_some() || !d.added_mass.is_empty();
    is_surrounded && content.shapes_from_m == content.tower.base_m()
}

fn left_out(mode: &PassedOver) -> String {
    format!(
        "mode {}, {} at {} Hz: {} % of its energy is torsion",
        mode.number,
        mode.label,
        four_digits(mode.frequency_hz),
        percent(mode.torsion_share)
    )
}

/// The name that a shape's coefficients have in a tower file, without their power.
fn name(shape: &TowerShape) -> String {
    let plane = match shape.plane {
        Plane::ForeAft => "FA",
        Plane::SideSide => "SS",
    };
    format!("Tw{plane}M{}Sh", shape.number)
}

/// In the digits of the command that writes the tower file.
fn hertz(value: f64) -> String {
    format!("{value:.5}")
}

fn coefficients(made: &ElastoDynShapes) -> Table {
    let shapes = &made.shapes;
    let names = shapes.shapes.each_ref().map(|s| format!("#{}", name(s)));
    let header = ["quantity"].into_iter();
    let mut table = Table::new(
        "Coefficients of the shapes and how well they fit",
        header.chain(names.iter().map(String::as_str)),
    );
    let mut row = |quantity: &str, value: &dyn Fn(&TowerShape) -> String| {
        let mut cells = vec![quantity.to_owned()];
        cells.extend(shapes.shapes.iter().map(value));
        table.push(cells);
    };
    row("mode", &|shape| shape.label.clone());
    row("its frequency (Hz)", &|shape| hertz(shape.frequency_hz));
    for power in 2..=6 {
        let quantity = format!("({power}), of the power {power}");
        row(&quantity, &|shape| {
            shape.decimals.texts()[power - 2].replace('-', "\u{2212}")
        });
    }
    row("root mean square residual (%)", &|shape| {
        digits(
            100.0 * shape.fit.rms_residual / shape.fit.largest_deflection,
            2,
        )
    });
    row("largest residual (%)", &|shape| {
        digits(
            100.0 * shape.fit.largest_residual / shape.fit.largest_deflection,
            2,
        )
    });
    row("largest deflection over that of the top", &|shape| {
        digits(shape.fit.largest_deflection, 4)
    });
    row("condition number of the fit", &|shape| {
        digits(shape.fit.condition, 3)
    });
    row("ElastoDyn's frequency of the shape alone (Hz)", &|shape| {
        hertz(made.frequency_alone_hz.of(shape.plane)[shape.number - 1])
    });
    row("torsion in the mode's energy (%)", &|shape| {
        percent(shape.torsion_share)
    });
    table
}
