//! `stickslip completions` and `stickslip man`, generated from the arguments.

use crate::args::{self, CompletionsArgs, ManArgs};
use crate::failure::Outcome;
use crate::output::{self, PendingFile};
use clap_mangen::Man;
use std::fs;
use std::io::Write;

pub(crate) fn completions(asked: &CompletionsArgs, out: &mut impl Write) -> Outcome {
    // The generator panics if its output fails.
    let mut script = Vec::new();
    clap_complete::generate(asked.shell, &mut args::grammar(), "stickslip", &mut script);
    Ok(out.write_all(&script)?)
}

pub(crate) fn man(asked: &ManArgs, out: &mut impl Write) -> Outcome {
    let command = args::grammar().disable_help_subcommand(true);
    let Some(folder) = &asked.out else { return Ok(Man::new(command).render(out)?) };
    fs::create_dir_all(folder).map_err(|e| format!("--out {}: {e}", folder.display()))?;
    let mut command = command;
    command.build();
    let mut pages = Vec::new();
    pages_of(command, &mut pages);
    let place = |page: &Man| {
        let place = folder.join(page.get_filename());
        let argument = format!("--out {}", place.display());
        (place, argument)
    };
    // Either all pages are written or none.
    for page in &pages {
        let (place, argument) = place(page);
        output::refuse_existing(&place, &argument, asked.overwrite)?;
    }
    pages.iter().try_for_each(|page| {
        let (place, argument) = place(page);
        PendingFile::create(&place, &argument, asked.overwrite)?.fill(|out| Ok(page.render(out)?))
    })
}

/// The page of a command, after those of its questions.
fn pages_of(command: clap::Command, pages: &mut Vec<Man>) {
    for inner in command.get_subcommands().filter(|inner| !inner.is_hide_set()) {
        pages_of(inner.clone(), pages);
    }
    pages.push(Man::new(command));
}
