//! The options that a command uses in each mode. An option without an effect is refused.

use crate::failure::Outcome;
use clap::ArgMatches;
use clap::parser::ValueSource;
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::inputs::{Input, Role};

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

/// The options that a command uses: its inputs in ratios, those with a machine or a file, and the other options, of which
/// letters before a colon are the only modes. A command has the modes for which it has inputs, and with a `p:` that of
/// points. One that is not listed has one mode and uses all of its options.
const USED: &str = "\
response | RATIOS | SHIFTED | r:enclose format p:header bits mp:units
border | omega FRICTIONS | omega BODY STATIC frequency | no_stop r:enclose format p:header bits mp:units
steady | RATIOS | SHIFTED | x0 v0 max_periods r:enclose format p:header bits mp:units
attractors | RATIOS | DRIVEN | starts reach max_periods unstable rows resume format bits m:units
basins | RATIOS | DRIVEN | x0 v0 max_periods rows resume bits m:units out title size overwrite
simulate | RATIOS | SHIFTED | x0 v0 phase m:shape m:rise m:speed m:slope m:one_way cycles m:duration samples m:rate out overwrite format bits m:units
sweep | RATIOS | SHIFTED | question m:units outputs format out resume shard header no_header bits
map | RATIOS | DRIVEN | quantity m:units out overwrite title size range
response-curve | omega alpha damping-ratio | omega alpha BODY frequency DRIVE | what m:units out overwrite title size x_range y_range linear
motion-plot | RATIOS | DRIVEN | x0 v0 m:units out overwrite title size
identify | | MASS SPRING gravity force base-acceleration base-velocity base-displacement foot-displacement | file amplitude phase format units
identify | | MASS SPRING gravity | file motion format units
identify | decay half_cycles | decay half_cycles MASS SPRING gravity | file format units
record | | BODY yield-acceleration STATIC mean-force | file slope one_way time_step time_column column skip record_units scale from to remove_mean resample after x0 v0 repeats both_polarities floor_spectrum floor_damping out interval picture title size overwrite enclose format bits units
record | describe | | file time_step time_column column skip record_units scale from to remove_mean resample picture title size overwrite format units
spectrum | | BODY yield-acceleration STATIC mean-force | files slope one_way time_step time_column column skip record_units scale from to remove_mean resample after units format out resume shard header no_header picture title size overwrite
decay | FRICTIONS | BODY STATIC mean-force | m:slope m:one_way x0 v0 out title size overwrite format bits m:units
pull | | BODY STATIC | speed format bits units
design force | omega FRICTIONS | BODY STATIC mean-force frequency | no_stop format bits m:units
design friction | omega FRICTIONS | MASS SPRING gravity DAMPER static-friction-ratio frequency DRIVE | m:over m:of m:picture m:overwrite m:target_amplitude format bits m:units
design bands | alpha damping-ratio | BODY DRIVE | from to no_stop format bits m:units
design hold | | BODY STATIC frequency DRIVE | format bits units
design displacement | omega damping-ratio | BODY mean-force frequency | target format bits m:units
design velocity | omega damping-ratio | BODY mean-force frequency | target format bits m:units
design dissipation | omega damping-ratio | MASS SPRING gravity DAMPER frequency DRIVE | sticking format bits m:units
design stiffness | alpha | MASS FRICTION gravity friction-backward DAMPER frequency DRIVE | from to format bits m:units";

/// The modes of a command with the options that it uses in each.
fn modes(command: &str) -> impl Iterator<Item = (Mode, Vec<&'static str>)> {
    let rows = USED.lines().map(|row| row.split('|').map(str::trim));
    let rows =
        rows.filter_map(move |mut row| (row.next()? == command).then_some([(); 3].map(|()| row.next())));
    rows.flat_map(|[ratios, machine, others]| {
        let others = others.unwrap_or_default();
        let modes = [(Ratios, 'r', ratios), (Machine, 'm', machine), (Points, 'p', machine)];
        modes.into_iter().filter_map(move |(mode, letter, inputs)| {
            let inputs =
                inputs.filter(|inputs| !inputs.is_empty() && (mode != Points || others.contains("p:")))?;
            let others = others.split(' ').filter_map(|option| match option.split_once(':') {
                Some((modes, option)) => modes.contains(letter).then_some(option),
                None => Some(option),
            });
            let points = (mode == Points).then_some("points").into_iter();
            Some((mode, points.chain(options(inputs)).chain(others).collect()))
        })
    })
}

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
        "BODY" => options("MASS SPRING FRICTION gravity friction-backward DAMPER"),
        "MASS" => inputs(Role::Mass),
        "SPRING" => [inputs(Role::Spring), vec!["no_spring"]].concat(),
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
    let used = modes(command).find(|(mode, _)| *mode == Points).map(|(_, used)| used).unwrap_or_default();
    Input::ALL.into_iter().filter(|input| used.contains(&input.name())).collect()
}

/// The positional arguments.
const PLACES: [&str; 5] = ["question", "quantity", "what", "file", "files"];

/// The commands whose answers may have accelerations in g.
const IN_G: [&str; 2] = ["record", "spectrum"];

/// Fails at the first option that the command does not use.
pub(super) fn check(matches: &ArgMatches) -> Outcome {
    let (mut command, mut matches) = (String::new(), matches);
    while let Some((name, inner)) = matches.subcommand() {
        command = format!("{command} {name}").trim_start().to_owned();
        matches = inner;
    }
    let units = matches.try_get_one::<System>("units").ok().flatten();
    if let Some(system) = units.filter(|system| system.scale(Kind::Acceleration).is_some())
        && (!IN_G.contains(&command.as_str())
            || matches.try_get_one("enclose").is_ok_and(|is| is == Some(&true)))
    {
        let plain = system.to_string();
        let plain = plain.trim_end_matches(",g");
        return Err(format!(
            "--units {system}: must be {plain}, because only record and spectrum without --enclose answer in g"
        )
        .into());
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
    let unused = |used: &[&str]| -> Vec<&str> {
        given.iter().copied().filter(|id| *id != "quiet" && !used.contains(id)).collect()
    };
    let is_machine = given.iter().filter_map(|option| Input::named(option)).any(Input::is_physical);
    let fits = |mode: Mode| given.contains(&"points") == (mode == Points) && (mode != Machine || is_machine);
    // The file of a free decay, or of a motion, asks another question than a response curve, and a description than an answer.
    let is_asked = |used: &[&str]| {
        ["decay", "motion", "describe"].iter().all(|kind| used.contains(kind) == given.contains(kind))
    };
    let asked = modes(&command).filter(|(mode, used)| fits(*mode) && is_asked(used));
    let Some((mode, used)) = asked.min_by_key(|(_, used)| unused(used).len()) else { return Ok(()) };
    if let Some(id) = unused(&used).first() {
        let shown = used.into_iter().filter(|id| !PLACES.contains(id)).map(option);
        return Err(format!(
            "{}: {command} does not use it {}. It uses {}",
            written(id, matches),
            if given.contains(&"describe") { "with --describe" } else { mode.name() },
            shown.collect::<Vec<_>>().join(", ")
        )
        .into());
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
    let used: Vec<&str> = modes(&name).flat_map(|(_, used)| used).collect();
    if used.is_empty() {
        return command;
    }
    command.mut_args(|arg| {
        let hidden = arg.is_hide_set() || !(arg.is_global_set() || used.contains(&arg.get_id().as_str()));
        arg.hide(hidden)
    })
}
