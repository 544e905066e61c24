//! The arguments of completions and manual pages.

use clap::Args;
use clap_complete::Shell;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip completions bash > ~/.local/share/bash-completion/completions/stickslip
  stickslip completions zsh > ~/.zfunc/_stickslip
  stickslip completions fish > ~/.config/fish/completions/stickslip.fish")]
pub(crate) struct CompletionsArgs {
    /// Which shell
    #[arg(value_enum, value_name = "SHELL")]
    pub(crate) shell: Shell,
}

#[derive(Debug, Args)]
#[command(after_help = "\
Examples:
  stickslip man | man -l -
  stickslip man --out ~/.local/share/man/man1
  stickslip man --out ~/.local/share/man/man1 --overwrite")]
pub(crate) struct ManArgs {
    /// Output folder for the pages of all commands [default: only the first page, to standard output]
    #[arg(long, value_name = "DIR")]
    pub(crate) out: Option<PathBuf>,
    /// Replace existing pages
    #[arg(long, requires = "out")]
    pub(crate) overwrite: bool,
}
