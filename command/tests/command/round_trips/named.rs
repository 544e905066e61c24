//! Answers as names and values, from the library and from the command's output.

use serde_json::Value;
use std::fmt::{Debug, LowerExp};
use std::str::FromStr;
use stickslip::NoStop;
use stickslip::motion::{End, Kind, LongRun, Segment, SteadyOutput, SteadyState};
use stickslip::{Drive, Float, Oscillator, Output, Ratios, Regime, Response, Scales};

/// A value. A number is stored as the digits of `{:e}`, which identify it within its type, including the sign
/// of zero.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Cell {
    Text(String),
    Number(String),
    /// A value that does not exist.
    Absent,
}

impl Cell {
    pub(crate) fn of<F: LowerExp>(number: F) -> Self {
        Self::Number(format!("{number:e}"))
    }

    fn or_absent<F: LowerExp>(number: Option<F>) -> Self {
        number.map_or(Self::Absent, Self::of)
    }

    fn text(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}

pub(crate) type Named = Vec<(String, Cell)>;

/// The value of a text: a number, or a name in the columns of names.
fn read<F: FromStr + LowerExp>(name: &str, text: &str) -> (String, Cell)
where
    F::Err: Debug,
{
    let cell = match name {
        "regime" | "limit" | "kind" | "ends_by" | "best_force_ratio_slides" => Cell::text(text),
        _ if text.is_empty() => Cell::Absent,
        _ => Cell::of(text.parse::<F>().unwrap()),
    };
    (name.to_owned(), cell)
}

/// The rows of CSV.
pub(crate) fn of_csv<F: FromStr<Err: Debug> + LowerExp>(text: &str) -> Vec<Named> {
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    let header = reader.headers().unwrap().clone();
    let row = |row: csv::StringRecord| header.iter().zip(&row).map(|(n, t)| read::<F>(n, t)).collect();
    reader.records().map(|found| row(found.unwrap())).collect()
}

/// The values of a JSON object.
pub(crate) fn of_json<F: FromStr<Err: Debug> + LowerExp>(object: &Value) -> Named {
    let value = |name: &str, value: &Value| match value {
        Value::Null => (name.to_owned(), Cell::Absent),
        // A JSON reader takes numbers as f64.
        Value::Number(number) => (name.to_owned(), Cell::of(number.as_f64().unwrap())),
        Value::String(text) => read::<F>(name, text),
        Value::Bool(flag) => (name.to_owned(), Cell::text(&flag.to_string())),
        other => panic!("{name}: {other}"),
    };
    let parts = ["1_re", "1_im", "2_re", "2_im"].map(|part| format!("multipliers_{part}"));
    let fields = |(name, found): (&String, &Value)| match (name.as_str(), found) {
        ("multipliers", Value::Null) => parts.clone().map(|part| (part, Cell::Absent)).to_vec(),
        ("multipliers", pairs) => {
            let numbers = pairs.as_array().unwrap().iter().flat_map(|pair| pair.as_array().unwrap());
            parts.iter().zip(numbers).map(|(part, number)| value(part, number)).collect()
        }
        (name, found) => vec![value(name, found)],
    };
    sorted(object.as_object().unwrap().iter().flat_map(fields).collect())
}

/// The values in the order of their names, since an object of JSON has no order.
pub(crate) fn sorted(mut named: Named) -> Named {
    named.sort_by(|(a, _), (b, _)| a.cmp(b));
    named
}

fn named<const N: usize>(fields: [(&str, Cell); N]) -> Named {
    fields.map(|(name, cell)| (name.to_owned(), cell)).to_vec()
}

pub(crate) fn of_response<F: Float + LowerExp>(response: &Response<F>) -> Named {
    let (ratios, border, cycle) = (response.ratios, response.border, response.cycle.as_ref());
    named([
        ("omega", Cell::of(ratios.omega())),
        ("alpha", Cell::of(ratios.alpha())),
        ("regime", Cell::text(response.regime.name())),
        ("max_displacement", Cell::or_absent(cycle.map(|c| c.max_displacement))),
        ("displacement_phase", Cell::or_absent(cycle.map(|c| c.displacement_phase))),
        ("max_velocity", Cell::or_absent(cycle.map(|c| c.max_velocity))),
        ("velocity_phase", Cell::or_absent(cycle.map(|c| c.velocity_phase))),
        ("deviation", Cell::or_absent(cycle.map(|c| c.deviation()))),
        ("min_force_ratio", Cell::of(border.min_force_ratio)),
        ("min_force_ratio_turning_point", Cell::of(border.min_force_ratio_turning_point)),
        ("loop_size_stiffness", Cell::or_absent(response.loop_size_stiffness)),
        ("loop_size_inertia", Cell::or_absent(response.loop_size_inertia)),
        ("best_force_ratio", Cell::of(response.best_force_ratio)),
        ("best_loop_size", Cell::or_absent(response.best_loop_size)),
        ("contraction", Cell::or_absent(cycle.map(|c| c.contraction()))),
        ("reversals_per_cycle", Cell::or_absent(response.reversals_per_cycle())),
        ("best_force_ratio_slides", Cell::text(&response.best_is_reached().to_string())),
        ("dynamic_amplification", Cell::or_absent(cycle.map(|c| c.max_displacement / c.ratios.alpha()))),
        ("max_acceleration", Cell::or_absent(Output::MaxAcceleration.of(response))),
        ("transmitted_force", Cell::or_absent(Output::TransmittedForce.of(response))),
        ("transmissibility", Cell::or_absent(Output::Transmissibility.of(response))),
        ("max_absolute_displacement", Cell::or_absent(Output::MaxAbsoluteDisplacement.of(response))),
        ("max_spring_force", Cell::or_absent(Output::MaxSpringForce.of(response))),
        ("equivalent_damping", Cell::or_absent(Output::EquivalentDamping.of(response))),
        ("equivalent_damping_ratio", Cell::or_absent(Output::EquivalentDampingRatio.of(response))),
        ("equivalent_stiffness", Cell::or_absent(Output::EquivalentStiffness.of(response))),
        ("effective_damping_ratio", Cell::or_absent(Output::EffectiveDampingRatio.of(response))),
    ])
}

pub(crate) fn of_border<F: Float + LowerExp>(response: &Response<F>) -> Named {
    let border = response.border;
    named([
        ("omega", Cell::of(response.ratios.omega())),
        ("min_force_ratio", Cell::of(border.min_force_ratio)),
        ("min_force_ratio_turning_point", Cell::of(border.min_force_ratio_turning_point)),
        ("border_phase", Cell::of(border.border_phase)),
        ("least_displacement", Cell::of(border.least_displacement)),
        ("best_force_ratio", Cell::of(response.best_force_ratio)),
    ])
}

/// Regime, stops and reversals in a cycle as counted from the exact motion. The borders decide where it has
/// not settled, and beside a border, where a stop or its absence may be rounding.
///
/// In half a turn of the drive, α sin θ and x are rounded by some four units in the last place each, and the
/// velocity by those of its phase, 1/Ω times as much: by 8εα/Ω. A sliding motion keeps what it has gathered for
/// Ω²α/2 half turns (its multipliers are 1 − 2/Ω²α), and the excess of the force over friction at a reversal is
/// Ω² times that of α over the border. So the motion does not know a relative distance from the border of 64 εα/Ω,
/// with a margin of sixteen, and never knows one of the 64 units of the borders themselves. From a distance of 1
/// on it knows nothing, and from 64 ε (α + |x|) = 1 on friction itself is lost in the rounding of each force, so
/// that stops cannot be counted either.
fn counted(ratios: Ratios<f64>, limit: &LongRun<f64>) -> (Regime, Option<u32>, Option<u32>) {
    let (alpha, without_stop) = (ratios.alpha(), NoStop::of(&ratios));
    let six = without_stop.six_reversals;
    let due = if alpha >= without_stop.border && ratios.omega() == 1.0 {
        (Regime::Unbounded, None)
    } else if alpha >= without_stop.border {
        (Regime::NonSticking, Some(2))
    } else if six.is_some_and(|(low, high)| low <= alpha && alpha <= high) {
        (Regime::NonSticking, Some(6))
    } else {
        (Regime::Sticking, None)
    };
    let steady = match limit {
        LongRun::Rest(_) => return (Regime::Stuck, None, None),
        LongRun::Unbounded { .. } => return (Regime::Unbounded, None, None),
        LongRun::Irregular(_) | LongRun::NotConverged { .. } => return (due.0, None, due.1),
        LongRun::Periodic(steady) | LongRun::Family(steady) => steady,
    };
    let (sticks, zeros) = (steady.sticks_per_cycle, steady.velocity_zeros_per_cycle);
    let found = if sticks > 0 { (Regime::Sticking, None) } else { (Regime::NonSticking, Some(zeros)) };
    let (most, least) = (steady.max_displacement.value, steady.min_displacement.value);
    let is_lost = 64.0 * f64::EPSILON * (alpha + f64::max(most, -least)) >= 1.0;
    if found == due && !(is_lost && sticks > 0) {
        return (found.0, Some(sticks), found.1);
    }
    if is_lost {
        return (due.0, (due.0 == Regime::NonSticking).then_some(0), due.1);
    }
    let edges = [Some(without_stop.border), six.map(|(low, _)| low), six.map(|(_, high)| high)];
    let known = 64.0 * f64::EPSILON * f64::max(1.0, alpha / ratios.omega());
    let beside = known >= 1.0 || edges.into_iter().flatten().any(|edge| (alpha / edge - 1.0).abs() < known);
    assert!(beside, "{found:?} by the motion, {due:?} by the borders at {ratios:?}");
    (due.0, Some(if due.0 == Regime::NonSticking { 0 } else { sticks }), due.1)
}

pub(crate) fn of_steady(ratios: Ratios<f64>, limit: &LongRun<f64>) -> Named {
    let steady = limit.steady_state();
    let number = |value: fn(&SteadyState<f64>) -> f64| Cell::or_absent(steady.map(value));
    // At rest the body stays where it is, and friction carries the whole force.
    let or_at_rest = |value: fn(&SteadyState<f64>) -> f64, known: f64| {
        let at_rest = || matches!(limit, LongRun::Rest(_)).then_some(known);
        Cell::or_absent(steady.map(value).or_else(at_rest))
    };
    let place = if let LongRun::Rest(rest) = limit { rest.position } else { f64::NAN };
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let (regime, sticks, reversals) = counted(ratios, limit);
    let multiplier = |i: usize| steady.map(|s| s.multipliers[i]);
    let (kind, periods, rest) = match limit {
        LongRun::Periodic(s) => ("periodic", Some(s.periods), None),
        LongRun::Family(s) => ("family", Some(s.periods), None),
        LongRun::Rest(rest) => ("rest", Some(rest.periods), Some(rest.position)),
        LongRun::Unbounded { .. } => ("none", None, None),
        LongRun::Irregular(motion) => ("irregular", Some(motion.periods), None),
        LongRun::NotConverged { periods, .. } => ("not-converged", Some(*periods), None),
    };
    named([
        ("omega", Cell::of(ratios.omega())),
        ("alpha", Cell::of(ratios.alpha())),
        ("regime", Cell::text(regime.name())),
        ("limit", Cell::text(kind)),
        ("max_displacement", or_at_rest(|s| s.max_displacement.value, place)),
        ("max_displacement_phase", number(|s| s.max_displacement.phase.reduced())),
        ("min_displacement", or_at_rest(|s| s.min_displacement.value, place)),
        ("min_displacement_phase", number(|s| s.min_displacement.phase.reduced())),
        ("max_velocity", or_at_rest(|s| s.max_velocity.value, 0.0)),
        ("max_velocity_phase", number(|s| s.max_velocity.phase.reduced())),
        ("min_velocity", or_at_rest(|s| s.min_velocity.value, 0.0)),
        ("min_velocity_phase", number(|s| s.min_velocity.phase.reduced())),
        ("sticks_per_cycle", Cell::or_absent(sticks)),
        ("velocity_zeros_per_cycle", Cell::or_absent(steady.map(|s| s.velocity_zeros_per_cycle))),
        ("stick_fraction", or_at_rest(|s| s.stick_fraction, 1.0)),
        ("error_1", number(|s| s.errors().unwrap().error_1)),
        ("error_2", number(|s| s.errors().unwrap().error_2)),
        ("error_3", number(|s| s.errors().unwrap().error_3)),
        ("error_4", number(|s| s.errors().unwrap().error_4)),
        ("energy_in", or_at_rest(|s| s.energy_in, 0.0)),
        ("energy_out", or_at_rest(|s| s.energy_out, 0.0)),
        ("multipliers_1_re", Cell::or_absent(multiplier(0).map(|(re, _)| re))),
        ("multipliers_1_im", Cell::or_absent(multiplier(0).map(|(_, im)| im))),
        ("multipliers_2_re", Cell::or_absent(multiplier(1).map(|(re, _)| re))),
        ("multipliers_2_im", Cell::or_absent(multiplier(1).map(|(_, im)| im))),
        ("distance", number(|s| s.distance.0)),
        ("rest_position", Cell::or_absent(rest)),
        ("periods", Cell::or_absent(periods)),
        ("reversals_per_cycle", Cell::or_absent(reversals)),
        (
            "dynamic_amplification",
            Cell::or_absent(steady.map(|s| s.max_displacement.value).or(rest).map(|x| x / alpha)),
        ),
        ("max_acceleration", or_at_rest(|s| s.peaks().unwrap().acceleration, 0.0)),
        ("transmitted_force", or_at_rest(|s| s.peaks().unwrap().transmitted_force, alpha)),
        ("transmissibility", or_at_rest(|s| s.peaks().unwrap().transmissibility, 1.0)),
        (
            "max_absolute_displacement",
            or_at_rest(|s| s.peaks().unwrap().absolute_displacement, place.abs() + alpha / (omega * omega)),
        ),
        ("max_spring_force", or_at_rest(|s| s.peaks().unwrap().spring_force, place.abs())),
        ("equivalent_damping", number(|s| SteadyOutput::EquivalentDamping.of(s))),
        ("equivalent_damping_ratio", number(|s| SteadyOutput::EquivalentDampingRatio.of(s))),
        ("equivalent_stiffness", number(|s| SteadyOutput::EquivalentStiffness.of(s))),
        ("effective_damping_ratio", number(|s| SteadyOutput::EffectiveDampingRatio.of(s))),
    ])
}

pub(crate) fn of_phase(phase: &Segment<f64>) -> Named {
    let (start, end) = (phase.start(), phase.end());
    let kind = match phase.kind {
        Kind::SlideForward => "slide-forward",
        Kind::SlideBackward => "slide-backward",
        Kind::Stick => "stick",
    };
    let ends_by = match phase.ends_by {
        End::Reversal => "reversal",
        End::Stop => "stop",
        End::Grazing => "grazing",
        End::Release => "release",
        End::Never => "never",
    };
    named([
        ("kind", Cell::text(kind)),
        ("ends_by", Cell::text(ends_by)),
        ("start_cycle", Cell::of(start.phase.cycles())),
        ("start_phase", Cell::of(start.phase.reduced())),
        ("end_cycle", Cell::or_absent(end.map(|e| e.phase.cycles()))),
        ("end_phase", Cell::or_absent(end.map(|e| e.phase.reduced()))),
        ("duration", Cell::or_absent(phase.duration())),
        ("start_x", Cell::of(start.x)),
        ("start_v", Cell::of(start.v)),
        ("end_x", Cell::or_absent(end.map(|e| e.x))),
    ])
}

/// A response in the units of a machine; a value that overflows is infinite here.
pub(crate) fn of_machine(
    response: &Response<f64>,
    body: &Oscillator<f64>,
    drive: &Drive<f64>,
    scales: &Scales<f64>,
) -> Vec<(&'static str, Option<f64>)> {
    let (border, cycle) = (response.border, response.cycle.as_ref());
    let scaled = |value: Option<f64>, unit: f64| value.map(|v| v * unit);
    let best_force = response.best_force_ratio * scales.force;
    vec![
        ("frequency", Some(drive.angular_frequency() / std::f64::consts::TAU)),
        ("angular_frequency", Some(drive.angular_frequency())),
        ("natural_frequency", Some(body.natural_frequency())),
        ("period", Some(std::f64::consts::TAU / body.natural_frequency())),
        ("mass", Some(body.mass())),
        ("stiffness", Some(body.stiffness())),
        ("friction", Some(body.friction_bound())),
        ("force_amplitude", Some(drive.force_amplitude(body))),
        ("friction_displacement", Some(scales.length)),
        ("max_displacement", scaled(cycle.map(|c| c.max_displacement), scales.length)),
        ("displacement_time", scaled(cycle.map(|c| c.displacement_phase), scales.time)),
        ("max_velocity", scaled(cycle.map(|c| c.max_velocity), scales.velocity)),
        ("velocity_time", scaled(cycle.map(|c| c.velocity_phase), scales.time)),
        ("deviation", scaled(cycle.map(|c| c.deviation()), scales.length)),
        ("max_acceleration", scaled(Output::MaxAcceleration.of(response), scales.velocity / scales.time)),
        ("transmitted_force", scaled(Output::TransmittedForce.of(response), scales.force)),
        ("max_spring_force", scaled(Output::MaxSpringForce.of(response), scales.force)),
        (
            "equivalent_damping",
            scaled(Output::EquivalentDamping.of(response), scales.force / scales.velocity),
        ),
        (
            "equivalent_stiffness",
            scaled(Output::EquivalentStiffness.of(response), scales.force / scales.length),
        ),
        ("min_force", scaled(Some(border.min_force_ratio), scales.force)),
        ("min_force_turning_point", scaled(Some(border.min_force_ratio_turning_point), scales.force)),
        ("energy_per_cycle", scaled(response.loop_size_stiffness, scales.energy_stiffness)),
        ("best_force", Some(best_force)),
        // A₁ is stated in units of p₀²/(2k) for the best force.
        (
            "best_force_energy",
            scaled(response.best_loop_size, 0.5 * best_force * (best_force / body.stiffness())),
        ),
    ]
}

/// The amplitude of a motion of the spring's support, which a machine's answer repeats.
pub(crate) fn foot(drive: &Drive<f64>) -> Option<(&'static str, Option<f64>)> {
    drive.excitation().moves_foot().then(|| ("foot_displacement", Some(drive.amplitude())))
}

/// The values as cells.
pub(crate) fn cells(values: &[(&'static str, Option<f64>)]) -> Named {
    values.iter().map(|&(name, value)| (name.to_owned(), Cell::or_absent(value))).collect()
}
