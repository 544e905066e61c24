//! `stickslip completions` and `stickslip man`, generated from the arguments.

use crate::args::{self, CompletionsArgs, ManArgs};
use crate::failure::{Failure, Outcome};
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
    let Some(folder) = &asked.out else { return Ok(clap_mangen::Man::new(command).render(out)?) };
    let bad = |e: std::io::Error| Failure::Input(format!("--out {}: {e}", folder.display()));
    fs::create_dir_all(folder).map_err(bad)?;
    clap_mangen::generate_to(command, folder).map_err(bad)
}
