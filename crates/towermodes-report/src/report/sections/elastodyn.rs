//! Polynomial mode shapes for ElastoDyn and the quality of their fit.

use towermodes_analysis::elastodyn::{PassedOver, PolynomialFit, TowerShape, shape_name};

use super::super::content::{ElastoDynShapes, ReportContent};
use super::super::document::Block;
use super::super::plot_command::command;
use super::super::table::Table;
use super::{paragraph, table};
use crate::number::{digits, four_digits, length, percent, typeset};
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
            "Warning: the coefficients cover the whole structure from z = {} m, including the part in soil or water. For OpenFAST add \
             --from-height HEIGHT to the command above, with the height at which the ElastoDyn tower begins.",
            length(content.shapes_from_m)
        )));
    }
    let passed_over = &made.shapes.passed_over;
    if !passed_over.is_empty() {
        blocks.push(paragraph(
            "Bending modes that were not used, because they contain torsion, which an ElastoDyn tower does not have:",
        ));
        let passed = passed_over.iter();
        blocks.push(Block::List(passed.map(left_out).collect()));
    }
    blocks
}

/// The meaning of the coefficients, and how they are computed.
fn introduction(content: &ReportContent) -> String {
    format!(
        "The coefficients below describe the tower from {} m to {} m by two mode shapes in each plane, as ElastoDyn requires: polynomials \
         with the powers 2 to 6 of the normalised height η, with zero deflection and slope at the base and the value 1 at the top. {}The coefficients are fitted by least squares \
         to the modes of the reference solution (method spectral), including rotor-nacelle assembly and foundation; residuals are relative to the largest \
         deflection of the shape. The ElastoDyn frequency is computed from ElastoDyn's generalised mass and stiffness of the shape, \
         without rotor-nacelle assembly and gravity; do not compare it with the frequency of the mode.",
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
        (d.has_soil(), "the soil"),
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
            "The ElastoDyn tower is clamped to its platform and does not include {}. The effect of these parts on the frequencies must come from other \
             modules of OpenFAST; otherwise it is missing in the OpenFAST model.",
            listed(&there)
        )
    })
}

fn begins_in_soil_or_water(content: &ReportContent) -> bool {
    let tower = &content.tower;
    tower.begins_in_soil_or_water() && content.shapes_from_m == tower.base_m()
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

/// A frequency with as many decimals as in the output of the command that writes the tower file.
fn hertz(value: f64) -> String {
    format!("{value:.5}")
}

fn coefficients(made: &ElastoDynShapes) -> Table {
    let shapes = &made.shapes.shapes;
    let names = shapes.each_ref();
    let names = names.map(|shape| format!("#{}", shape_name(shape.plane, shape.number)));
    let header = ["quantity"].into_iter();
    let mut table = Table::new(
        "Polynomial coefficients of the mode shapes and quality of the fit",
        header.chain(names.iter().map(String::as_str)),
    );
    let mut row = |quantity: &str, value: &dyn Fn(&TowerShape) -> String| {
        let cells = std::iter::once(quantity.to_owned());
        table.push(cells.chain(shapes.iter().map(value)));
    };
    row("mode", &|s| s.label.clone());
    row("frequency of the mode (Hz)", &|s| hertz(s.frequency_hz));
    for (index, power) in ["²", "³", "⁴", "⁵", "⁶"].into_iter().enumerate() {
        let quantity = format!("({}), coefficient of η{power}", index + 2);
        row(&quantity, &|s| typeset(&s.decimals.texts()[index]));
    }
    for (quantity, value) in fit_quality() {
        row(quantity, &|shape| value(&shape.fit));
    }
    row("ElastoDyn frequency without RNA and gravity (Hz)", &|s| {
        hertz(made.frequency_alone_hz.of(s.plane)[s.number - 1])
    });
    let torsion = "torsion fraction of the mode's energy (%)";
    row(torsion, &|s| percent(s.torsion_share));
    table
}

/// A measure of the quality of a fit with its name.
type Measure = (&'static str, fn(&PolynomialFit) -> String);

fn fit_quality() -> [Measure; 4] {
    [
        ("root mean square residual (%)", |fit| {
            digits(100.0 * fit.relative_rms_residual(), 2)
        }),
        ("largest residual (%)", |fit| {
            digits(100.0 * fit.relative_largest_residual(), 2)
        }),
        ("largest deflection / top deflection (−)", |fit| {
            digits(fit.largest_deflection, 4)
        }),
        ("condition number of the fit", |fit| {
            digits(fit.condition, 3)
        }),
    ]
}
