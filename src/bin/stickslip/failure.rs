//! How the command ends when it cannot answer.

use std::io;
use std::process::ExitCode;

/// The end of a command.
pub(crate) type Outcome = Result<(), Failure>;

/// Why a command stopped.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The input is at fault: exit status 2.
    #[error("{0}")]
    Input(String),
    /// What was to be shown does not hold: exit status 1.
    #[error("{0}")]
    Verdict(String),
    /// The system is: exit status 1.
    #[error("{0}")]
    System(io::Error),
    /// Ctrl-C. Exit status 130, as of a program ended by the signal.
    #[error("interrupted; the output ends at a complete record")]
    Interrupted,
    /// Nobody reads on: a quiet end.
    #[error("closed pipe")]
    ClosedPipe,
}

impl Failure {
    /// The exit status of an interrupted command.
    pub(crate) const INTERRUPTED: u8 = 130;

    /// What the user is told, on one line that a terminal can show.
    pub(crate) fn message(&self) -> String {
        on_one_line(&self.to_string())
    }

    /// The same, where the input is at fault behind the argument and the file that it is about.
    pub(crate) fn about(self, what: &str) -> Self {
        if let Self::Input(text) = self { Self::Input(format!("{what}: {text}")) } else { self }
    }

    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::Input(_) => ExitCode::from(2),
            Self::Interrupted => ExitCode::from(Self::INTERRUPTED),
            Self::Verdict(_) | Self::System(_) => ExitCode::FAILURE,
            Self::ClosedPipe => ExitCode::SUCCESS,
        }
    }
}

/// What the library says while it computes. What is wrong with an argument is said where its name is known.
impl From<stickslip::Error> for Failure {
    fn from(error: stickslip::Error) -> Self {
        if error == stickslip::Error::Interrupted {
            Self::Interrupted
        } else if matches!(error, stickslip::Error::SearchBound { .. }) {
            Self::Verdict(error.to_string())
        } else {
            Self::Input(error.to_string())
        }
    }
}

/// A value or a unit that cannot be read.
impl From<stickslip::units::UnitError> for Failure {
    fn from(error: stickslip::units::UnitError) -> Self {
        Self::Input(error.to_string())
    }
}

impl From<io::Error> for Failure {
    fn from(error: io::Error) -> Self {
        if error.kind() == io::ErrorKind::BrokenPipe { Self::ClosedPipe } else { Self::System(error) }
    }
}

impl From<serde_json::Error> for Failure {
    fn from(error: serde_json::Error) -> Self {
        io::Error::from(error).into()
    }
}

impl From<csv::Error> for Failure {
    fn from(error: csv::Error) -> Self {
        let text = error.to_string();
        if let csv::ErrorKind::Io(error) = error.into_kind() { error.into() } else { Self::Input(text) }
    }
}

/// What the parser takes for what was meant.
fn meant(error: &clap::Error) -> Option<String> {
    use clap::error::{ContextKind, ContextValue};
    let kinds = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    kinds.into_iter().find_map(|kind| {
        let found = error.get(kind)?;
        if let ContextValue::String(text) = found {
            return Some(text.clone());
        }
        // The best one comes last.
        if let ContextValue::Strings(texts) = found { texts.last().cloned() } else { None }
    })
}

/// The parser's own message on one line, with what it takes for meant, without its usage.
impl From<clap::Error> for Failure {
    fn from(error: clap::Error) -> Self {
        if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
            return Self::Input("a command is missing; --help lists them".to_owned());
        }
        let text = error.to_string();
        let message: Vec<&str> =
            text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim).collect();
        let message = message.join(" ");
        let message = message.strip_prefix("error: ").unwrap_or(&message);
        Self::Input(match meant(&error) {
            Some(meant) => format!("{message}; did you mean {meant}?"),
            None => message.to_owned(),
        })
    }
}

/// Most characters of a word that a user typed, and of a message.
const WORD: usize = 100;
const MESSAGE: usize = 1_000;

/// The text without control characters, which would act on a terminal, and of a length that can be read.
fn on_one_line(text: &str) -> String {
    let printable = |c: char| if c.is_control() { c.escape_default().to_string() } else { c.to_string() };
    let words = text.split(' ').map(|word| cut(&word.chars().map(printable).collect::<String>(), WORD));
    cut(&words.collect::<Vec<_>>().join(" "), MESSAGE)
}

/// The text, or its beginning and its end where it is longer.
fn cut(text: &str, most: usize) -> String {
    let length = text.chars().count();
    if length <= most {
        return text.to_owned();
    }
    let part = |from: usize, count: usize| text.chars().skip(from).take(count).collect::<String>();
    format!("{}…{}", part(0, most / 2), part(length - most / 2, most / 2))
}

#[cfg(test)]
mod tests {
    use super::{Failure, MESSAGE, WORD};

    #[test]
    fn a_message_is_one_line_of_bounded_length_without_control_characters() {
        let message = |text: &str| Failure::Input(text.to_owned()).message();
        assert_eq!(
            message("--omega 1\n2\u{1b}[31m: must be a number"),
            "--omega 1\\n2\\u{1b}[31m: must be a number"
        );
        let long = message(&format!("--omega {}: must be a number", "7".repeat(1_000_000)));
        assert!(long.starts_with("--omega 777") && long.ends_with("777: must be a number"), "{long}");
        assert!(long.chars().count() < WORD + 40);
        let words = message(&"a long header ".repeat(100_000));
        assert!(
            words.chars().count() == MESSAGE + 1 && words.starts_with("a long") && words.ends_with("header ")
        );
    }
}
