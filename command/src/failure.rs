//! Failures of the command and its exit status.

use std::io;
use std::process::ExitCode;
use stickslip_front::text::printable;

/// The end of a command.
pub(crate) type Outcome = Result<(), Failure>;

/// The reason why a command stopped.
#[derive(Debug, thiserror::Error)]
pub(crate) enum Failure {
    /// The input is wrong: exit status 2.
    #[error("{0}")]
    Input(String),
    /// A statement to be verified does not hold: exit status 1.
    #[error("{0}")]
    Verdict(String),
    /// The system failed: exit status 1.
    #[error("{0}")]
    System(io::Error),
    /// Ctrl-C: exit status 130, as for a program that the signal ended.
    #[error("interrupted, and the output ends at a complete record")]
    Interrupted,
    /// The reader closed the pipe: a quiet end.
    #[error("closed pipe")]
    ClosedPipe,
}

impl Failure {
    /// The exit status of an interrupted command.
    pub(crate) const INTERRUPTED: u8 = 130;

    /// The message to the user, on one line that a terminal can show.
    pub(crate) fn message(&self) -> String {
        on_one_line(&self.to_string())
    }

    /// Whether it concerns the answer alone, not the system or the whole command.
    pub(crate) const fn is_of_an_answer(&self) -> bool {
        matches!(self, Self::Input(_) | Self::Verdict(_))
    }

    /// This failure, preceded by the argument or the file concerned if the input is wrong.
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

/// The library's errors during a computation. Errors of an argument are reported where its name is known.
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

/// A text alone is what is wrong with the input.
impl From<String> for Failure {
    fn from(text: String) -> Self {
        Self::Input(text)
    }
}

impl From<&str> for Failure {
    fn from(text: &str) -> Self {
        Self::Input(text.to_owned())
    }
}

/// A value or a unit that cannot be read.
impl From<stickslip_front::inputs::units::InputError> for Failure {
    fn from(error: stickslip_front::inputs::units::InputError) -> Self {
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

/// The parser's suggestion.
fn meant(error: &clap::Error) -> Option<String> {
    use clap::error::{ContextKind, ContextValue};
    let kinds = [ContextKind::SuggestedSubcommand, ContextKind::SuggestedArg, ContextKind::SuggestedValue];
    kinds.into_iter().find_map(|kind| {
        let found = error.get(kind)?;
        if let ContextValue::String(text) = found {
            return Some(text.clone());
        }
        // The best suggestion comes last.
        if let ContextValue::Strings(texts) = found { texts.last().cloned() } else { None }
    })
}

/// The message on a value that is no whole number, or none of this size.
fn no_whole_number(error: &clap::Error) -> Option<String> {
    use clap::error::{ContextKind, ContextValue};
    use std::num::IntErrorKind;
    let number = std::error::Error::source(error)?.downcast_ref::<std::num::ParseIntError>()?;
    let typed =
        |kind| if let ContextValue::String(text) = error.get(kind)? { Some(text.as_str()) } else { None };
    let option = typed(ContextKind::InvalidArg)?.split(' ').next()?;
    let value = typed(ContextKind::InvalidValue)?;
    let is_large = *number.kind() == IntErrorKind::PosOverflow;
    let due = if is_large { "must be a smaller whole number" } else { "must be a whole number ≥ 0" };
    Some(format!("{option} {value}: {due}"))
}

/// The parser's own message on one line, with its suggestion and without the usage.
impl From<clap::Error> for Failure {
    fn from(error: clap::Error) -> Self {
        if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
            return Self::Input("a command is missing. List the commands with --help".to_owned());
        }
        if let Some(text) = no_whole_number(&error) {
            return Self::Input(text);
        }
        let text = error.to_string();
        let message: Vec<&str> =
            text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim).collect();
        let message = message.join(" ");
        let message = message.strip_prefix("error: ").unwrap_or(&message);
        Self::Input(match meant(&error) {
            Some(meant) => format!("{message}. Did you mean {meant}?"),
            None => message.to_owned(),
        })
    }
}

/// The greatest number of characters of a typed word, and of a message.
const WORD: usize = 100;
const MESSAGE: usize = 1_000;

/// The text without control characters, which would act on a terminal, and of a readable length.
pub(crate) fn on_one_line(text: &str) -> String {
    let words = text.split(' ').map(|word| cut(&printable(word), WORD));
    cut(&words.collect::<Vec<_>>().join(" "), MESSAGE)
}

/// The text, or its beginning and its end if it is too long.
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
