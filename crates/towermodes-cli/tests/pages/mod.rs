//! The pages of the book and the blocks of code in them.

// Each test uses a part of it.
#![allow(dead_code)]

pub mod links;

use std::fs;
use std::path::{Path, PathBuf};

/// The root of the repository.
pub fn root() -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    fs::canonicalize(root).expect("the repository")
}

/// A file in Markdown.
pub struct Page {
    /// From the root of the repository, with slashes.
    pub name: String,
    pub text: String,
}

/// Everything between two lines of three backticks.
pub struct Block {
    /// The page and the line that it begins on.
    pub place: String,
    /// What stands behind the first backticks: the language, and perhaps a word for the tests.
    pub info: String,
    pub text: String,
}

/// The README and every page of the book, in the order of their names.
pub fn pages() -> Vec<Page> {
    let root = root();
    let mut files = vec![root.join("README.md")];
    markdown_below(&root.join("book/src"), &mut files);
    files.sort();
    let page = |file: PathBuf| Page {
        name: name_from(&root, &file),
        text: fs::read_to_string(&file).expect("a page"),
    };
    files.into_iter().map(page).collect()
}

fn name_from(root: &Path, file: &Path) -> String {
    let name = file.strip_prefix(root).expect("a file of the repository");
    name.to_string_lossy().replace('\\', "/")
}

fn markdown_below(folder: &Path, files: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            markdown_below(&path, files);
        } else if path.extension().is_some_and(|ending| ending == "md") {
            files.push(path);
        }
    }
}

impl Page {
    /// The blocks of code, in order.
    pub fn blocks(&self) -> Vec<Block> {
        let mut blocks = Vec::new();
        let mut open: Option<Block> = None;
        for (index, line) in self.text.lines().enumerate() {
            match (line.trim_start().strip_prefix("```"), open.as_mut()) {
                (Some(info), None) => {
                    open = Some(Block {
                        place: format!("{}:{}", self.name, index + 1),
                        info: info.trim().to_owned(),
                        text: String::new(),
                    });
                }
                (Some(_), Some(_)) => blocks.extend(open.take()),
                (None, Some(block)) => block.text.push_str(&format!("{line}\n")),
                (None, None) => {}
            }
        }
        assert!(open.is_none(), "{}: a block has no end", self.name);
        blocks
    }
}

impl Block {
    /// The language of the block.
    pub fn language(&self) -> &str {
        self.info.split([' ', ',']).next().unwrap_or_default()
    }

    /// The name of a file to which the reader is told to write the block: a comment on its first
    /// line, as `# my-tower.toml`.
    pub fn file_name(&self) -> Option<&str> {
        let first = self.text.lines().next()?.strip_prefix("# ")?;
        let is_name = !first.contains(char::is_whitespace) && first.ends_with(".toml");
        is_name.then_some(first)
    }
}
