//! Shapes for ElastoDyn as text: quality of the fit, changes of coefficients, validation.

use towermodes::Tower;
use towermodes::number::four_digits;
use towermodes_analysis::elastodyn::{
    MadeTower, TowerShape, TowerShapes, ValidatedShape, shape_name,
};
use towermodes_files::elastodyn::TowerFile;
use towermodes_report::wording::verdict_word;

use super::text::{rna, text_table, title};

/// The quality of the polynomials of a tower file, and their frequencies and damping in ElastoDyn.
pub(crate) fn fits(tower: &Tower, made: &MadeTower) -> String {
    let header = [
        "shape",
        "mode Hz",
        "rms residual",
        "largest",
        "largest / top",
        "condition",
        "ElastoDyn Hz",
        "damping %",
    ];
    let row = |(index, shape): (usize, &TowerShape)| {
        let alone_hz = made.quantities.of(shape.plane).frequency_alone_hz[index % 2];
        let damping_percent = made.modes.of(shape.plane).damping_percent[index % 2];
        [
            shape.label.clone(),
            format!("{:.5}", shape.frequency_hz),
            format!("{:.1e}", shape.fit.relative_rms_residual()),
            format!("{:.1e}", shape.fit.relative_largest_residual()),
            four_digits(shape.fit.largest_deflection),
            format!("{:.0}", shape.fit.condition),
            format!("{alone_hz:.5}"),
            four_digits(damping_percent),
        ]
    };
    format!(
        "{}{}\n\n{} rows | residuals are relative to the maximum deflection of the shape; largest / top is this maximum divided by the top deflection; ElastoDyn Hz is without RNA and gravity\n",
        title(tower),
        text_table(
            header,
            made.shapes.shapes.iter().enumerate().map(row),
            1..=7
        ),
        made.model.stations.len()
    )
}

/// The coefficients of a tower file and those of the computed modes.
pub(crate) fn changes(file: &TowerFile, shapes: &TowerShapes) -> String {
    let mut rows = Vec::new();
    for (shape, old) in shapes.shapes.iter().zip(&file.coefficients) {
        let name = shape_name(shape.plane, shape.number);
        for (k, (old, new)) in old.iter().zip(shape.decimals.texts()).enumerate() {
            let residual = match k {
                0 => format!("{:.1e}", shape.fit.relative_rms_residual()),
                _ => String::new(),
            };
            rows.push([
                format!("{name}({})", k + 2),
                format!("{old:.8}"),
                new,
                residual,
            ]);
        }
    }
    let header = ["coefficient", "in the file", "computed", "rms residual"];
    format!("{}\n", text_table(header, rows, 1..=3))
}

/// The differences of the shapes of a tower file from the modes of the tower.
pub(crate) fn judgements(
    file: &str,
    tower: &Tower,
    from_m: f64,
    judgements: &[ValidatedShape; 4],
) -> String {
    let header = [
        "shape",
        "mode Hz",
        "rms error",
        "error/best",
        "rms error both",
        "MAC",
        "sum",
        "implied Hz",
        "best Hz",
        "verdict",
    ];
    format!(
        "{file}\n\n{}\n\nmodes {}, {}\nrms error: rms difference from the mode, relative to its maximum deflection; error/best: this error divided by the rms error of the polynomial that this program fits to the mode; rms error both: rms error if both shapes of the plane are combined, as in ElastoDyn\nimplied Hz: frequency of the tower without RNA that ElastoDyn computes with these coefficients; best Hz: this frequency with the polynomial that this program fits to the mode\n",
        text_table(header, judgements.iter().map(judgement), 1..=8),
        heights(tower, from_m),
        rna(tower),
    )
}

fn judgement(shape: &ValidatedShape) -> [String; 10] {
    [
        shape_name(shape.plane, shape.number),
        format!("{:.4}", shape.mode_hz),
        format!("{:.2} %", 100.0 * shape.rms),
        four_digits(shape.rms_ratio),
        format!("{:.2} %", 100.0 * shape.rms_of_both),
        format!("{:.5}", shape.mac),
        format!("{:.6}", shape.sum),
        format!("{:.4}", shape.implied_hz),
        format!("{:.4}", shape.best_implied_hz),
        verdict_word(shape.verdict).to_owned(),
    ]
}

/// "of the tower from 0 m to 87.6 m", and the part of a longer tower.
fn heights(tower: &Tower, from_m: f64) -> String {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    if from_m <= base_m {
        return format!("of the tower from {base_m} m to {top_m} m");
    }
    format!("of the tower from {base_m} m to {top_m} m, part above {from_m} m")
}
