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
    /// Ctrl-C: what was written is whole. Exit status 130, as of a program ended by the signal.
    #[error("interrupted; what was written is whole")]
    Interrupted,
    /// Nobody reads on: a quiet end.
    #[error("closed pipe")]
    ClosedPipe,
}

impl Failure {
    pub(crate) fn exit_code(&self) -> ExitCode {
        match self {
            Self::Input(_) => ExitCode::from(2),
            Self::Interrupted => ExitCode::from(130),
            Self::Verdict(_) | Self::System(_) => ExitCode::FAILURE,
            Self::ClosedPipe => ExitCode::SUCCESS,
        }
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

/// The parser's own message on one line, without its usage and hints.
impl From<clap::Error> for Failure {
    fn from(error: clap::Error) -> Self {
        if error.kind() == clap::error::ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
            return Self::Input("a command is missing; --help lists them".to_owned());
        }
        let text = error.to_string();
        let message: Vec<&str> =
            text.lines().take_while(|line| !line.trim().is_empty()).map(str::trim).collect();
        let message = message.join(" ");
        Self::Input(message.strip_prefix("error: ").unwrap_or(&message).to_owned())
    }
}
