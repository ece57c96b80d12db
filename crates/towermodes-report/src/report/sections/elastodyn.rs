//! Polynomial mode shapes for ElastoDyn and the quality of their fit.

use towermodes::Plane;
use towermodes_analysis::elastodyn::{PassedOver, TowerShape};

use super::super::content::{ElastoDynShapes, ReportContent};
use super::super::document::Block;
use super::super::plot_command::command;
use super::super::table::Table;
use super::{paragraph, table};
use crate::number::{digits, four_digits, length, percent, superscript};
use crate::wording::listed;

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let made = match &content.elastodyn {
        Ok(made) => made,
        Err(error) => {
            return vec![paragraph(format!("No mode shapes for ElastoDyn: {error}."))];
        }
    };
    let mut blocks = vec![
        paragraph(introduction(content)),
        table(coefficients(made)),
        paragraph("This command writes the complete tower file with these coefficients:"),
        Block::Code(command(
            content,
            "elastodyn tower",
            &["--output Tower.dat".to_owned()],
        )),
    ];
    blocks.extend(lacks(content).map(paragraph));
    if begins_in_soil_or_water(content) {
        blocks.push(paragraph(format!(
            "Warning: the coefficients cover the whole structure from z = {} m, in soil or water. For OpenFAST give the height at which the \
             ElastoDyn tower begins: --from-height of the command above.",
            length(content.shapes_from_m)
        )));
    }
    let passed_over = &made.shapes.passed_over;
    if !passed_over.is_empty() {
        blocks.push(paragraph(
            "Bending modes that were left out because of their torsion, which an ElastoDyn tower does not have:",
        ));
        let passed = passed_over.iter();
        blocks.push(Block::List(passed.map(left_out).collect()));
    }
    blocks
}

/// What the coefficients are and how they are made.
fn introduction(content: &ReportContent) -> String {
    format!(
        "ElastoDyn describes the tower from {} m to {} m by two mode shapes in each plane: polynomials of degree 2 to 6 in the normalised \
         height x, with zero deflection and slope at the base and the value 1 at the top. {}The coefficients are fitted by least squares \
         to the modes of the spectral beam, including rotor-nacelle assembly and foundation; residuals are relative to the largest \
         deflection of the shape. The ElastoDyn frequency is computed with ElastoDyn's generalised mass and stiffness for the shape, \
         without rotor-nacelle assembly and gravity; it is not comparable with the frequency of the mode.",
        length(content.shapes_from_m),
        length(content.tower.top_m()),
        base(content)
    )
}

/// States that base motion is subtracted before the fit, if the base can move.
fn base(content: &ReportContent) -> &'static str {
    let tower = &content.tower;
    if tower.base().is_clamped() && content.shapes_from_m == tower.base_m() {
        return "";
    }
    "The translation and rotation of the lower end are subtracted from each mode before the fit. "
}

/// The parts of this model that an ElastoDyn tower does not have.
fn lacks(content: &ReportContent) -> Option<String> {
    let d = &content.description;
    let things = [
        (!content.tower.base().is_clamped(), "the base motion"),
        (
            content.shapes_from_m > content.tower.base_m(),
            "the structure below",
        ),
        (!d.soil.is_empty(), "the soil"),
        (
            d.water.is_some() || !d.added_mass.is_empty(),
            "the added mass of the water",
        ),
        (!d.wires.is_empty(), "the guy wires"),
    ];
    let there = things.into_iter().filter(|(is_there, _)| *is_there);
    let there: Vec<String> = there.map(|(_, what)| what.to_owned()).collect();
    (!there.is_empty()).then(|| {
        format!(
            "The ElastoDyn tower is clamped to its platform and does not include {}. Their effect on the frequencies must come from other \
             modules of OpenFAST; otherwise it is missing in the OpenFAST model.",
            listed(&there)
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

/// The name of the coefficients of a shape in a tower file, without the power.
fn name(shape: &TowerShape) -> String {
    let plane = match shape.plane {
        Plane::ForeAft => "FA",
        Plane::SideSide => "SS",
    };
    format!("Tw{plane}M{}Sh", shape.number)
}

/// With the decimals of the command that writes the tower file.
fn hertz(value: f64) -> String {
    format!("{value:.5}")
}

fn coefficients(made: &ElastoDynShapes) -> Table {
    let shapes = &made.shapes;
    let names = shapes.shapes.each_ref().map(|s| format!("#{}", name(s)));
    let header = ["quantity"].into_iter();
    let mut table = Table::new(
        "Polynomial coefficients of the mode shapes and quality of the fit",
        header.chain(names.iter().map(String::as_str)),
    );
    let mut row = |quantity: &str, value: &dyn Fn(&TowerShape) -> String| {
        let mut cells = vec![quantity.to_owned()];
        cells.extend(shapes.shapes.iter().map(value));
        table.push(cells);
    };
    row("mode", &|shape| shape.label.clone());
    row("frequency of the mode (Hz)", &|shape| {
        hertz(shape.frequency_hz)
    });
    for power in 2..=6 {
        let quantity = format!(
            "({power}), coefficient of x{}",
            superscript(&power.to_string())
        );
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
    row("largest deflection / top deflection (−)", &|shape| {
        digits(shape.fit.largest_deflection, 4)
    });
    row("condition number of the fit", &|shape| {
        digits(shape.fit.condition, 3)
    });
    row("ElastoDyn frequency (Hz)", &|shape| {
        hertz(made.frequency_alone_hz.of(shape.plane)[shape.number - 1])
    });
    row("torsion fraction of the mode's energy (%)", &|shape| {
        percent(shape.torsion_share)
    });
    table
}
