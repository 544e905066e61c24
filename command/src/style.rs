//! Colours: on a terminal, unless `NO_COLOR` is set.

use anstream::{AutoStream, ColorChoice};
use clap::builder::styling::{AnsiColor, Style, Styles};
use std::io;

/// The colours of help.
pub(crate) const STYLES: Styles = Styles::styled()
    .header(AnsiColor::Green.on_default().bold())
    .usage(AnsiColor::Green.on_default().bold())
    .literal(AnsiColor::Cyan.on_default().bold())
    .placeholder(AnsiColor::Cyan.on_default());

/// The name of the command before an error, for `anstream::stderr`.
pub(crate) fn label() -> String {
    painted("stickslip:", AnsiColor::Red.on_default().bold())
}

/// A sentence on standard output, with the words up to the first colon in the colour of the regime that they
/// name.
pub(crate) fn verdict(sentence: &str) -> String {
    match sentence.split_once(':') {
        Some((regime, rest)) if AutoStream::choice(&io::stdout()) != ColorChoice::Never => {
            let colour = match regime {
                "Non-sticking" => AnsiColor::Green,
                "Sticking" => AnsiColor::Yellow,
                _ => AnsiColor::Red,
            };
            format!("{}:{rest}", painted(regime, colour.on_default().bold()))
        }
        Some(_) | None => sentence.to_owned(),
    }
}

fn painted(text: &str, style: Style) -> String {
    format!("{style}{text}{style:#}")
}
