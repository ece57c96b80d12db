//! Shapes for ElastoDyn for people: how well they fit, how they change, how they are judged.

use towermodes::number::four_digits;
use towermodes::{Plane, Tower};
use towermodes_analysis::elastodyn::{TowerShape, TowerShapes, ValidatedShape};
use towermodes_files::elastodyn::{MadeTowerFile, TowerFile};
use towermodes_report::wording::verdict_word;

use super::text::{align_right, plain_table, title};

/// How well the polynomials of a made tower file fit, and what ElastoDyn makes of them.
pub(crate) fn fits(tower: &Tower, made: &MadeTowerFile) -> String {
    let mut table = plain_table();
    table.set_header([
        "shape",
        "mode Hz",
        "rms residual",
        "largest",
        "largest / top",
        "condition",
        "ElastoDyn Hz (alone)",
        "damping %",
    ]);
    let content = &made.content;
    let damping = [
        content.fore_aft_damping_percent,
        content.side_side_damping_percent,
    ];
    for (index, shape) in made.shapes.shapes.iter().enumerate() {
        let alone_hz = made.quantities.of(shape.plane).frequency_alone_hz[index % 2];
        table.add_row([
            shape.label.clone(),
            format!("{:.5}", shape.frequency_hz),
            format!(
                "{:.1e}",
                shape.fit.rms_residual / shape.fit.largest_deflection
            ),
            format!(
                "{:.1e}",
                shape.fit.largest_residual / shape.fit.largest_deflection
            ),
            four_digits(shape.fit.largest_deflection),
            format!("{:.0}", shape.fit.condition),
            format!("{alone_hz:.5}"),
            four_digits(damping[index / 2][index % 2]),
        ]);
    }
    align_right(&mut table, 1..=7);
    format!(
        "{}{}\n\n{} rows | residuals are relative to the maximum deflection of the shape; largest / top is this maximum divided by the top deflection\n",
        title(tower),
        table.trim_fmt(),
        content.rows.len()
    )
}

/// The coefficients of a tower file and those of the tower's own modes.
pub(crate) fn changes(file: &TowerFile, shapes: &TowerShapes) -> String {
    let mut table = plain_table();
    table.set_header(["coefficient", "in the file", "computed", "rms residual"]);
    for (index, shape) in shapes.shapes.iter().enumerate() {
        let texts = shape.decimals.texts();
        for (k, (old, new)) in file.coefficients[index].iter().zip(texts).enumerate() {
            let residual = match k {
                0 => format!(
                    "{:.1e}",
                    shape.fit.rms_residual / shape.fit.largest_deflection
                ),
                _ => String::new(),
            };
            table.add_row([
                format!("{}({})", name(shape), k + 2),
                format!("{old:.8}"),
                new,
                residual,
            ]);
        }
    }
    align_right(&mut table, 1..=3);
    format!("{}\n", table.trim_fmt())
}

/// The name that a shape's coefficients have in the file, without their power.
fn name(shape: &TowerShape) -> String {
    let plane = match shape.plane {
        Plane::ForeAft => "FA",
        Plane::SideSide => "SS",
    };
    format!("Tw{plane}M{}Sh", shape.number)
}

/// How far the shapes of a tower file are from the tower's own modes.
pub(crate) fn judgements(
    file: &str,
    tower: &Tower,
    from_m: f64,
    judgements: &[ValidatedShape; 4],
) -> String {
    let mut table = plain_table();
    table.set_header([
        "shape",
        "mode Hz",
        "rms off",
        "times the best",
        "rms off both",
        "MAC",
        "sum",
        "implied Hz",
        "best Hz",
        "verdict",
    ]);
    for judgement in judgements {
        let plane = match judgement.plane {
            Plane::ForeAft => "FA",
            Plane::SideSide => "SS",
        };
        table.add_row([
            format!("Tw{plane}M{}Sh", judgement.number),
            format!("{:.4}", judgement.mode_hz),
            format!("{:.2} %", 100.0 * judgement.rms),
            four_digits(judgement.rms_ratio),
            format!("{:.2} %", 100.0 * judgement.rms_of_both),
            format!("{:.5}", judgement.mac),
            format!("{:.6}", judgement.sum),
            format!("{:.4}", judgement.implied_hz),
            format!("{:.4}", judgement.best_implied_hz),
            verdict_word(judgement.verdict).to_owned(),
        ]);
    }
    align_right(&mut table, 1..=8);
    format!(
        "{file}\n\n{}\n\nmodes: {}, {}\nrms off: rms difference from the mode, relative to its maximum deflection; both: difference that remains if both shapes of the plane are combined, as in ElastoDyn\nimplied: frequency that ElastoDyn gets with the coefficients, for the tower alone\n",
        table.trim_fmt(),
        heights(tower, from_m),
        match tower.rna().mass_kg {
            0.0 => "no RNA".to_owned(),
            kg => format!("RNA {}", super::text::tonnes(kg)),
        },
    )
}

/// "of the tower from 0 m to 87.6 m", or what of a longer one.
fn heights(tower: &Tower, from_m: f64) -> String {
    let (base_m, top_m) = (tower.base_m(), tower.top_m());
    if from_m <= base_m {
        return format!("of the tower from {base_m} m to {top_m} m");
    }
    format!("of the tower from {base_m} m to {top_m} m, part above {from_m} m")
}
