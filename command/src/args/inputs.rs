//! The options of machines, made from the library's table of inputs.

use clap::error::ErrorKind;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use std::ffi::OsString;
use std::ops::Deref;
use stickslip_front::inputs::{Input, Role};

/// The inputs of these parts as they were typed, in the order of the table. A value may have a unit, such as 800kg. Bare
/// numbers are in one consistent system.
#[derive(Debug, Clone)]
pub(crate) struct Typed<const PARTS: u8>(Vec<(Input, String)>);

/// The body, its frequency, and the ratios but for α.
const BODY: u8 = 1;
/// The excitation.
const DRIVE: u8 = 2;
/// The start of a motion.
const START: u8 = 4;

/// The flag of a body without a spring.
const NO_SPRING: &str = "no_spring";

/// The name of that flag, and the stiffness that it stands for.
const FLAG: &str = "--no-spring";
const NONE: &str = "0";

/// A message about the arguments as they were typed: a stiffness that the flag stands for has the flag's name.
pub(crate) fn as_typed(message: String, arguments: impl Iterator<Item = OsString>) -> String {
    let option = Input::Stiffness.option();
    let arguments: Vec<String> = arguments.filter_map(|argument| argument.into_string().ok()).collect();
    let is_typed = arguments.iter().any(|argument| argument.starts_with(option));
    if is_typed || !arguments.iter().any(|argument| argument == FLAG) {
        return message;
    }
    message.replace(&format!("{option} {NONE}"), FLAG)
}

/// A body and its frequency.
pub(crate) type BodyArgs = Typed<BODY>;
/// A body under its drive.
pub(crate) type MachineArgs = Typed<{ BODY | DRIVE }>;
/// Where a motion starts, at ω_d t = 0.
pub(crate) type StartArgs = Typed<START>;

impl<const PARTS: u8> Typed<PARTS> {
    fn inputs() -> impl Iterator<Item = Input> {
        let part = |role| match role {
            Role::Drive | Role::RotatingMass => DRIVE,
            Role::Start => START,
            Role::Body
            | Role::Mass
            | Role::Spring
            | Role::Friction
            | Role::Damper
            | Role::StaticFriction
            | Role::MeanForce
            | Role::Frequency => BODY,
        };
        Input::ALL.into_iter().filter(move |input| PARTS & part(input.role()) != 0)
    }

    /// The text of an input, if it was typed.
    pub(crate) fn text(&self, input: Input) -> Option<&str> {
        self.iter().find(|(own, _)| *own == input).map(|(_, text)| text.as_str())
    }
}

impl<const PARTS: u8> Deref for Typed<PARTS> {
    type Target = [(Input, String)];

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

impl<const PARTS: u8> Args for Typed<PARTS> {
    fn augment_args(command: Command) -> Command {
        let command = command.args(Self::inputs().map(|input| {
            let arg = Arg::new(input.name()).long(input.name()).value_name(input.placeholder());
            let arg = arg.help(input.help()).allow_hyphen_values(true);
            let arg = input.alias().into_iter().fold(arg, Arg::visible_alias);
            input.former().into_iter().fold(arg, Arg::alias)
        }));
        if PARTS & BODY == 0 {
            return command;
        }
        command.arg(
            Arg::new(NO_SPRING)
                .long(FLAG.trim_start_matches('-'))
                .action(ArgAction::SetTrue)
                .help("A body without a spring, the same as a stiffness of 0"),
        )
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl<const PARTS: u8> FromArgMatches for Typed<PARTS> {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let text = |input: Input| Some((input, matches.get_one::<String>(input.name())?.clone()));
        let mut typed: Vec<_> = Self::inputs().filter_map(text).collect();
        if PARTS & BODY != 0 && matches.get_flag(NO_SPRING) {
            if let Some((spring, text)) = typed.iter().find(|(input, _)| input.role() == Role::Spring) {
                let text = format!("{} {text}: must be left out with {FLAG}\n", spring.option());
                return Err(clap::Error::raw(ErrorKind::ArgumentConflict, text));
            }
            typed.push((Input::Stiffness, NONE.to_owned()));
            typed.sort_by_key(|(input, _)| *input);
        }
        Ok(Self(typed))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}
