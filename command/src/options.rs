//! `stickslip options`: the table of all options, generated from the grammar.

use crate::args;
use crate::failure::Outcome;
use clap::{Arg, Command};
use std::fmt::Write as _;
use std::io::Write;

/// The width of the first column.
const NAMES: usize = 30;

/// A command by its full name.
struct Asked {
    name: String,
    about: String,
    /// Its arguments and options as (name with value, meaning with default).
    options: Vec<(String, String)>,
}

/// The commands that do something, those below another one included.
fn asked(command: &Command, before: &str, found: &mut Vec<Asked>) {
    for own in command.get_subcommands().filter(|own| own.get_name() != "help") {
        let name = format!("{before}{}", own.get_name());
        let shown = own.get_arguments().filter(|arg| !arg.is_hide_set() && !is_global(arg));
        let options: Vec<_> = shown.map(|arg| (name_of(arg), meaning(arg))).collect();
        let has_inner = own.get_subcommands().any(|inner| inner.get_name() != "help");
        if !has_inner || !options.is_empty() {
            let about = own.get_about().map(ToString::to_string).unwrap_or_default();
            found.push(Asked { name: name.clone(), about, options });
        }
        asked(own, &format!("{name} "), found);
    }
}

/// Whether every command has it.
fn is_global(arg: &Arg) -> bool {
    matches!(arg.get_id().as_str(), "help" | "version" | "quiet")
}

/// `--name <VALUE>` or `<VALUE>`.
fn name_of(arg: &Arg) -> String {
    let takes_value = arg.get_action().takes_values();
    let value = arg
        .get_value_names()
        .filter(|_| takes_value)
        .map(|names| names.iter().map(|name| format!("<{name}>")).collect::<Vec<_>>().join(" "));
    let parts = [arg.get_long().map(|long| format!("--{long}")), value];
    parts.into_iter().flatten().collect::<Vec<_>>().join(" ")
}

/// The meaning, with the default and other names of the option.
fn meaning(arg: &Arg) -> String {
    let mut text = arg.get_help().map(ToString::to_string).unwrap_or_default();
    let defaults = arg.get_default_values();
    if !(defaults.is_empty() || arg.is_hide_default_value_set() || !arg.get_action().takes_values()) {
        let values: Vec<_> = defaults.iter().map(|value| value.to_string_lossy()).collect();
        let _ = write!(text, " [default: {}]", values.join(", "));
    }
    for alias in arg.get_visible_aliases().unwrap_or_default() {
        let _ = write!(text, " [alias: --{alias}]");
    }
    text
}

/// The whole table as text: options that mean the same in several commands once, then each command with its own ones
/// and the names of the others.
fn text() -> String {
    let mut commands = Vec::new();
    asked(&args::grammar(), "", &mut commands);
    let uses = |option: &(String, String)| commands.iter().filter(|own| own.options.contains(option)).count();
    let mut shared: Vec<(String, String)> = Vec::new();
    for option in commands.iter().flat_map(|own| &own.options) {
        if uses(option) > 1 && !shared.contains(option) {
            shared.push(option.clone());
        }
    }
    // An option with two meanings is shown with each command.
    let alone: Vec<_> = shared.iter().map(|(name, _)| name.clone()).collect();
    shared.retain(|(name, _)| alone.iter().filter(|other| *other == name).count() == 1);
    let line = |text: &mut String, (name, meaning): &(String, String)| {
        let _ = writeln!(text, "  {name:<NAMES$} {meaning}");
    };
    let mut text = "Of every command\n\n".to_owned();
    let grammar = args::grammar();
    for arg in grammar.get_arguments().filter(|arg| is_global(arg)) {
        line(&mut text, &(name_of(arg), meaning(arg)));
    }
    line(&mut text, &("--help".to_owned(), "Print help".to_owned()));
    text.push_str("\nOf several commands\n\n");
    shared.iter().for_each(|option| line(&mut text, option));
    for own in &commands {
        let _ = writeln!(text, "\nstickslip {}: {}\n", own.name, own.about);
        let (common, special): (Vec<_>, Vec<_>) = own.options.iter().partition(|o| shared.contains(o));
        special.iter().for_each(|option| line(&mut text, option));
        let names: Vec<_> = common.iter().map(|(name, _)| name.split(" <").next().unwrap_or(name)).collect();
        if !names.is_empty() {
            let _ = writeln!(text, "  {}", names.join(" "));
        }
    }
    text
}

/// `stickslip options`.
pub(crate) fn run(out: &mut impl Write) -> Outcome {
    Ok(out.write_all(text().as_bytes())?)
}
