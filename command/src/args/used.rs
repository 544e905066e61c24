//! The options that a command uses in each mode. An option without an effect is refused.

use crate::failure::{Failure, Outcome};
use clap::ArgMatches;
use clap::parser::ValueSource;
use stickslip::inputs::{Input, Role};

/// The mode of a command.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Mode {
    /// The problem is given by Ω and α.
    Ratios,
    /// The problem is given by a machine in physical units.
    Machine,
    /// The points are rows of a file.
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

/// The options that a command uses in a mode. A command that is not listed has one mode and uses all of its
/// options.
const USED: &[(&str, Mode, &str)] = &[
    ("response", Ratios, "RATIOS enclose format bits"),
    ("response", Machine, "SHIFTED format bits units"),
    ("response", Points, "points SHIFTED format header bits units"),
    ("border", Ratios, "omega FRICTIONS no_stop enclose format bits"),
    ("border", Machine, "omega BODY STATIC frequency no_stop format bits units"),
    ("border", Points, "points omega BODY STATIC frequency no_stop format header bits units"),
    ("steady", Ratios, "RATIOS x0 v0 max_periods enclose format bits"),
    ("steady", Machine, "SHIFTED x0 v0 max_periods format bits units"),
    ("steady", Points, "points SHIFTED x0 v0 max_periods format header bits units"),
    ("attractors", Ratios, "RATIOS starts reach max_periods unstable rows resume format bits"),
    ("attractors", Machine, "DRIVEN starts reach max_periods unstable rows resume format bits units"),
    ("basins", Ratios, "RATIOS x0 v0 max_periods rows resume bits out title size overwrite"),
    ("basins", Machine, "DRIVEN x0 v0 max_periods rows resume bits units out title size overwrite"),
    ("simulate", Ratios, "RATIOS x0 v0 cycles samples out overwrite format bits"),
    ("simulate", Machine, "SHIFTED x0 v0 cycles duration samples rate out overwrite format bits units"),
    ("sweep", Ratios, "question RATIOS outputs format out resume shard header no_header bits"),
    ("sweep", Machine, "question SHIFTED units outputs format out resume shard header no_header bits"),
    ("map", Ratios, "quantity RATIOS out overwrite title size range"),
    ("map", Machine, "quantity DRIVEN units out overwrite title size range"),
    (
        "response-curve",
        Ratios,
        "what omega alpha damping-ratio out overwrite title size x_range y_range linear",
    ),
    (
        "response-curve",
        Machine,
        "what omega alpha BODY frequency DRIVE units out overwrite title size x_range y_range linear",
    ),
    ("motion-plot", Ratios, "RATIOS x0 v0 out overwrite title size"),
    ("motion-plot", Machine, "DRIVEN x0 v0 units out overwrite title size"),
    (
        "identify",
        Machine,
        "file mass SPRING gravity force base-acceleration base-velocity base-displacement foot-displacement amplitude phase format units",
    ),
    ("identify", Ratios, "file decay half_cycles format units"),
    ("identify", Machine, "file decay half_cycles mass SPRING gravity format units"),
    (
        "record",
        Machine,
        "file BODY STATIC mean-force no_spring slope one_way time_step scale from to x0 v0 out interval picture title size overwrite enclose format bits units",
    ),
    (
        "spectrum",
        Machine,
        "files BODY STATIC mean-force no_spring slope one_way time_step scale from to units format out resume shard header no_header picture title size overwrite",
    ),
    ("decay", Ratios, "FRICTIONS x0 v0 out title size overwrite format bits"),
    ("decay", Machine, "BODY STATIC mean-force x0 v0 out title size overwrite format bits units"),
    ("design force", Ratios, "omega FRICTIONS no_stop format bits"),
    ("design force", Machine, "BODY STATIC mean-force frequency no_stop format bits units"),
    ("design friction", Ratios, "omega FRICTIONS format bits"),
    (
        "design friction",
        Machine,
        "mass SPRING gravity DAMPER static-friction-ratio frequency DRIVE over of picture overwrite format bits units",
    ),
    ("design bands", Ratios, "alpha damping-ratio from to no_stop format bits"),
    ("design bands", Machine, "BODY DRIVE from to no_stop format bits units"),
    ("design displacement", Ratios, "omega damping-ratio target format bits"),
    ("design displacement", Machine, "BODY mean-force frequency target format bits units"),
    ("design velocity", Ratios, "omega damping-ratio target format bits"),
    ("design velocity", Machine, "BODY mean-force frequency target format bits units"),
    ("design dissipation", Ratios, "omega damping-ratio sticking format bits"),
    ("design dissipation", Machine, "mass SPRING gravity DAMPER frequency DRIVE sticking format bits units"),
    ("design stiffness", Ratios, "alpha from to format bits"),
    (
        "design stiffness",
        Machine,
        "mass FRICTION gravity friction-backward DAMPER frequency DRIVE from to format bits units",
    ),
];

/// The single options of an entry, with its groups of inputs expanded.
fn options(used: &'static str) -> Vec<&'static str> {
    let inputs = |role| -> Vec<_> {
        Input::of_role(role).into_iter().filter(|p| *p != Input::Alpha).map(Input::name).collect()
    };
    let expanded = |name| match name {
        "RATIOS" => options("omega alpha FRICTIONS"),
        "FRICTIONS" => options("damping-ratio static-friction-ratio"),
        // With a constant force, and without one.
        "SHIFTED" => options("omega alpha BODY STATIC mean-force frequency DRIVE"),
        "DRIVEN" => options("omega alpha BODY STATIC frequency DRIVE"),
        "BODY" => options("mass SPRING FRICTION gravity friction-backward DAMPER"),
        "SPRING" => inputs(Role::Spring),
        "FRICTION" => inputs(Role::Friction),
        "DAMPER" => inputs(Role::Damper),
        "STATIC" => inputs(Role::StaticFriction),
        "DRIVE" => [Role::Drive, Role::RotatingMass].map(inputs).concat(),
        single => vec![single],
    };
    used.split(' ').flat_map(expanded).collect()
}

/// The inputs that a command reads from the columns of a file of points.
pub(crate) fn columns(command: &str) -> Vec<Input> {
    let row = USED.iter().find(|(name, mode, _)| *name == command && *mode == Points);
    let used: Vec<&str> = row.map(|(.., used)| options(used)).unwrap_or_default();
    Input::ALL.into_iter().filter(|input| used.contains(&input.name())).collect()
}

/// The positional arguments.
const PLACES: [&str; 5] = ["question", "quantity", "what", "file", "files"];

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
    let unused = |used: &'static str| {
        let of_use = |id: &&str| *id == "quiet" || options(used).contains(id);
        given.iter().copied().filter(|id| !of_use(id)).collect::<Vec<_>>()
    };
    let is_machine = given.iter().filter_map(|option| Input::named(option)).any(Input::is_physical);
    let fits = |mode: Mode| given.contains(&"points") == (mode == Points) && (mode != Machine || is_machine);
    // The file of a free decay asks another question than a response curve.
    let is_asked = |used: &'static str| options(used).contains(&"decay") == given.contains(&"decay");
    let modes = USED.iter().filter(|(name, mode, used)| *name == command && fits(*mode) && is_asked(used));
    let Some((_, mode, used)) = modes.min_by_key(|(_, _, used)| unused(used).len()) else { return Ok(()) };
    if let Some(id) = unused(used).first() {
        return Err(Failure::Input(format!(
            "{}: {command} does not use it {}. It uses {}",
            written(id, matches),
            mode.name(),
            options(used)
                .into_iter()
                .filter(|id| !PLACES.contains(id))
                .map(option)
                .collect::<Vec<_>>()
                .join(", ")
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
    let uses = |id: &str| USED.iter().any(|(of, _, used)| *of == name && options(used).contains(&id));
    command.mut_args(|arg| {
        let hidden = arg.is_hide_set() || !(arg.is_global_set() || uses(arg.get_id().as_str()));
        arg.hide(hidden)
    })
}
