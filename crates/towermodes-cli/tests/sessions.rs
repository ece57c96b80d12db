//! The program's output, session by session.
//!
//! `TRYCMD=overwrite cargo test -p towermodes-cli --test sessions` writes what the program says now; look at the difference before you
//! commit it.

#[test]
fn sessions_print_what_they_printed() {
    // Sessions are written as a user at the root of the repository would type them.
    std::env::set_current_dir("../..").expect("the root of the repository");
    trycmd::TestCases::new()
        .case("README.md")
        .case("book/src/*.md")
        .case("crates/towermodes-cli/tests/sessions/*.md");
}
