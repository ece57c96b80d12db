//! Completion scripts and the manual page, made from the command line's own description.

use clap::CommandFactory;
use clap_complete::Shell;

use crate::args::Arguments;
use crate::failure::Failure;
use crate::output::deliver;

/// `towermodes completions SHELL`.
pub(crate) fn completions(shell: Shell) -> Result<(), Failure> {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Arguments::command(), "towermodes", &mut script);
    deliver(&script, None)
}

/// `towermodes man`: the program and its commands on one page.
pub(crate) fn man() -> Result<(), Failure> {
    let command = Arguments::command();
    let mut page = Vec::new();
    let unwritable = |error| Failure::Unwritable("the manual page".into(), error);
    clap_mangen::Man::new(command.clone())
        .render(&mut page)
        .map_err(unwritable)?;
    for part in command.get_subcommands() {
        let named = part.clone().name(format!("towermodes {}", part.get_name()));
        let man = clap_mangen::Man::new(named);
        man.render_synopsis_section(&mut page).map_err(unwritable)?;
        man.render_description_section(&mut page)
            .map_err(unwritable)?;
        man.render_options_section(&mut page).map_err(unwritable)?;
        man.render_extra_section(&mut page).map_err(unwritable)?;
    }
    deliver(&page, None)
}
