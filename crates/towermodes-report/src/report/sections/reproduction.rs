//! The data that reproduce the report: version, command, files.

use super::super::content::{InputFile, ReportContent};
use super::super::document::Block;
use super::super::table::Table;
use super::{paragraph, table};

fn name(file: &InputFile) -> String {
    if file.is_of_text {
        format!("{} (as UTF-8)", file.name)
    } else {
        file.name.clone()
    }
}

pub(super) fn blocks(content: &ReportContent) -> Vec<Block> {
    let mut files = Table::new(
        "Files read, with the SHA-256 of their bytes",
        ["file", "#bytes", "SHA-256"],
    );
    for file in &content.circumstances.files {
        files.push([name(file), file.bytes.to_string(), file.sha256.clone()]);
    }
    vec![
        paragraph(format!(
            "Produced by towermodes {}. The same version, command and files give the same report byte by byte: it contains nothing random and no \
             date except the date of --date.",
            content.circumstances.version
        )),
        Block::Code(content.circumstances.command_line.clone()),
        table(files),
    ]
}
