//! The options that a command uses in each mode. An option without an effect is refused.

use crate::failure::{Failure, Outcome};
use clap::ArgMatches;
use clap::parser::ValueSource;

/// The mode of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// By Ω and α.
    Ratios,
    /// By a machine in physical units.
    Machine,
    /// By a file of points.
    Points,
}

use Mode::{Machine, Points, Ratios};

impl Mode {
    const fn name(self) -> &'static str {
        match self {
            Ratios => "in ratios",
            Machine => "with a machine",
            Points => "with --points",
        }
    }
}

/// The options that only a machine and its drive have.
const MACHINE: [&str; 17] = [
    "mass",
    "stiffness",
    "period",
    "friction",
    "friction_coefficient",
    "gravity",
    "friction_backward",
    "damping",
    "static_friction",
    "mean_force",
    "frequency",
    "force",
    "base_acceleration",
    "base_velocity",
    "base_displacement",
    "foot_displacement",
    "damped_foot_displacement",
];

/// The options that a command uses in a mode. A command that is not listed has one mode and uses all of its
/// options.
const USED: &[(&str, Mode, &str)] = &[
    ("response", Ratios, "omega alpha damping_ratio static_friction_ratio enclose format bits"),
    ("response", Machine, "omega alpha BODY STATIC mean_force frequency DRIVE format bits units"),
    (
        "response",
        Points,
        "points omega alpha BODY STATIC mean_force frequency DRIVE format header bits units",
    ),
    ("border", Ratios, "omega damping_ratio static_friction_ratio no_stop enclose format bits"),
    ("border", Machine, "omega BODY STATIC frequency no_stop format bits units"),
    ("border", Points, "points omega BODY STATIC frequency no_stop format header bits units"),
    (
        "steady",
        Ratios,
        "omega alpha damping_ratio static_friction_ratio x0 v0 max_periods enclose format bits",
    ),
    (
        "steady",
        Machine,
        "omega alpha BODY STATIC mean_force frequency DRIVE x0 v0 max_periods format bits units",
    ),
    (
        "steady",
        Points,
        "points omega alpha BODY STATIC mean_force frequency DRIVE x0 v0 max_periods format header bits units",
    ),
    (
        "attractors",
        Ratios,
        "omega alpha damping_ratio static_friction_ratio starts reach max_periods unstable rows resume format bits",
    ),
    (
        "attractors",
        Machine,
        "omega alpha BODY STATIC frequency DRIVE starts reach max_periods unstable rows resume format bits units",
    ),
    (
        "basins",
        Ratios,
        "omega alpha damping_ratio static_friction_ratio x0 v0 max_periods rows resume bits out overwrite",
    ),
    (
        "basins",
        Machine,
        "omega alpha BODY STATIC frequency DRIVE x0 v0 max_periods rows resume bits units out overwrite",
    ),
    ("simulate", Ratios, "omega alpha damping_ratio static_friction_ratio x0 v0 cycles samples format bits"),
    (
        "simulate",
        Machine,
        "omega alpha BODY STATIC mean_force frequency DRIVE x0 v0 cycles samples format bits units",
    ),
    (
        "sweep",
        Ratios,
        "question omega alpha damping_ratio static_friction_ratio outputs format out resume shard header no_header bits",
    ),
    (
        "sweep",
        Machine,
        "question omega alpha BODY STATIC mean_force frequency DRIVE units outputs format out resume shard header no_header bits",
    ),
    ("map", Ratios, "quantity omega alpha damping_ratio static_friction_ratio out overwrite"),
    ("map", Machine, "quantity omega alpha BODY STATIC frequency DRIVE units out overwrite"),
    ("response-curve", Ratios, "what omega alpha damping_ratio out overwrite"),
    ("response-curve", Machine, "what omega alpha BODY frequency DRIVE units out overwrite"),
    ("motion-plot", Ratios, "omega alpha damping_ratio static_friction_ratio x0 v0 out overwrite"),
    ("motion-plot", Machine, "omega alpha BODY STATIC frequency DRIVE x0 v0 units out overwrite"),
    (
        "identify",
        Machine,
        "file mass stiffness period force base_acceleration base_velocity base_displacement \
         foot_displacement amplitude phase format units",
    ),
    ("decay", Ratios, "damping_ratio static_friction_ratio x0 v0 format bits"),
    ("decay", Machine, "BODY STATIC mean_force x0 v0 format bits units"),
    ("design force", Ratios, "omega damping_ratio static_friction_ratio no_stop format bits"),
    ("design force", Machine, "BODY STATIC frequency no_stop format bits units"),
    ("design friction", Ratios, "omega damping_ratio static_friction_ratio format bits"),
    (
        "design friction",
        Machine,
        "mass stiffness period gravity damping_ratio damping static_friction_ratio frequency DRIVE format bits units",
    ),
    ("design bands", Ratios, "alpha damping_ratio from to no_stop format bits"),
    ("design bands", Machine, "BODY DRIVE from to no_stop format bits units"),
    ("design displacement", Ratios, "omega damping_ratio target format bits"),
    ("design displacement", Machine, "BODY frequency target format bits units"),
    ("design velocity", Ratios, "omega damping_ratio target format bits"),
    ("design velocity", Machine, "BODY frequency target format bits units"),
    ("design dissipation", Ratios, "omega damping_ratio sticking format bits"),
    (
        "design dissipation",
        Machine,
        "mass stiffness period damping_ratio damping frequency DRIVE sticking format bits units",
    ),
    ("design stiffness", Ratios, "alpha from to format bits"),
    (
        "design stiffness",
        Machine,
        "mass friction friction_coefficient gravity friction_backward damping_ratio damping frequency DRIVE from to format bits units",
    ),
];

/// The single options of an entry, with its groups expanded.
fn options(used: &str) -> impl Iterator<Item = &str> {
    used.split(' ').flat_map(|name| match name {
        "BODY" => {
            "mass stiffness period friction friction_coefficient gravity friction_backward damping_ratio damping"
                .split(' ')
        }
        "STATIC" => "static_friction_ratio static_friction".split(' '),
        "DRIVE" => "force base_acceleration base_velocity base_displacement foot_displacement damped_foot_displacement".split(' '),
        single => single.split(' '),
    })
}

/// The positional arguments.
const PLACES: [&str; 4] = ["question", "quantity", "what", "file"];

/// Fails at the first option that the command does not use.
pub(super) fn check(matches: &ArgMatches) -> Outcome {
    let (mut command, mut matches) = (String::new(), matches);
    while let Some((name, inner)) = matches.subcommand() {
        command = format!("{command} {name}").trim_start().to_owned();
        matches = inner;
    }
    let typed = |id: &&str| matches.value_source(id) == Some(ValueSource::CommandLine);
    // The parser adds an entry for each group of options.
    let given: Vec<&str> = matches
        .ids()
        .map(clap::Id::as_str)
        .filter(typed)
        .filter(|id| !id.contains(char::is_uppercase))
        .collect();
    // Select the mode in which the fewest options are unused; a file of points leaves no choice.
    let unused = |used: &str| {
        let of_use = |id: &&str| *id == "quiet" || options(used).any(|option| option == *id);
        given.iter().copied().filter(|id| !of_use(id)).collect::<Vec<_>>()
    };
    let is_machine = given.iter().any(|option| MACHINE.contains(option));
    let fits = |mode: Mode| given.contains(&"points") == (mode == Points) && (mode != Machine || is_machine);
    let modes = USED.iter().filter(|(name, mode, _)| *name == command && fits(*mode));
    let Some((_, mode, used)) = modes.min_by_key(|(_, _, used)| unused(used).len()) else { return Ok(()) };
    if let Some(id) = unused(used).first() {
        return Err(Failure::Input(format!(
            "{}: {command} does not use it {}. It uses {}",
            written(id, matches),
            mode.name(),
            options(used).filter(|id| !PLACES.contains(id)).map(option).collect::<Vec<_>>().join(", ")
        )));
    }
    Ok(())
}

/// The option as typed, or the name of a positional argument.
pub(super) fn option(id: &str) -> String {
    if PLACES.contains(&id) { id.to_uppercase() } else { format!("--{}", id.replace('_', "-")) }
}

/// The option with its value.
fn written(id: &str, matches: &ArgMatches) -> String {
    let values = matches.get_raw(id).into_iter().flatten();
    let values: Vec<String> = values.map(|value| value.to_string_lossy().into_owned()).collect();
    // A flag has the value true if it is present.
    if values.is_empty() || values == ["true"] {
        option(id)
    } else {
        format!("{} {}", option(id), values.join(" "))
    }
}

/// Hides the options that a command does not use from its help; `before` is the name of its parent command.
pub(super) fn hide_unused(command: clap::Command, before: &str) -> clap::Command {
    let name = format!("{before} {}", command.get_name()).trim_start().to_owned();
    let command = command.mut_subcommands(|question| hide_unused(question, &name));
    if !USED.iter().any(|(of, ..)| *of == name) {
        return command;
    }
    let uses =
        |id: &str| USED.iter().any(|(of, _, used)| *of == name && options(used).any(|option| option == id));
    command.mut_args(|arg| {
        let hidden = arg.is_hide_set() || !(arg.is_global_set() || uses(arg.get_id().as_str()));
        arg.hide(hidden)
    })
}
