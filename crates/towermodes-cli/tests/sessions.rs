//! The program's output, session by session.
//!
//! `TRYCMD=overwrite cargo test -p towermodes-cli --test sessions` writes what the program says
//! now; look at the difference before you commit it. Sessions are typed in a folder of their own
//! that has the examples and the files that the pages tell their readers to write.

mod pages;
mod sandbox;

use pages::{pages, root};
use sandbox::Sandbox;

#[test]
fn sessions_print_what_they_printed() {
    let sandbox = Sandbox::new("sessions");
    for page in pages() {
        sandbox.write_files_of(&page);
    }
    std::env::set_current_dir(sandbox.path()).expect("the folder");
    let root = root();
    trycmd::TestCases::new()
        .case(root.join("README.md"))
        .case(root.join("book/src/*.md"))
        .case(root.join("book/src/*/*.md"))
        .case(root.join("crates/towermodes-cli/tests/sessions/*.md"))
        .run();
}
