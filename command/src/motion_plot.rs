//! `stickslip motion-plot`: a steady motion over time, and its loops.

use crate::args::MotionPlotArgs;
use crate::failure::Outcome;
use crate::figure::Target;
use crate::given;
use crate::input;
use crate::machine::Machine;
use crate::steady::of_motion;
use std::io::Write;
use stickslip::inputs::units::Kind;
use stickslip::motion::{Instant, LongRun, Trajectory};
use stickslip_figures::{Axis, Figure, Panel, Series, Style};

/// The number of samples in a cycle.
const PER_CYCLE: u32 = 600;
/// The number of cycles drawn.
const CYCLES: u32 = 2;

pub(crate) fn run(args: &MotionPlotArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &args.look)?;
    let reader = args.units.reader();
    let given = given::read::<f64>(&args.machine, &reader)?;
    let point = input::point(&given)?;
    let start = input::start(&args.start, &given, point.machine.as_ref(), &reader)?;
    let named = |e: stickslip::Error| of_motion(&given, e);
    let limit = LongRun::from_start(point.ratios, start).map_err(named)?;
    let Some(steady) = limit.steady_state() else {
        return Err(
            "motion-plot: there is no periodic motion to draw. See stickslip steady for the reason".into()
        );
    };
    let samples: Vec<Instant<f64>> = Trajectory::new(point.ratios, steady.state)
        .and_then(|motion| motion.samples(PER_CYCLE))
        .map_err(named)?
        // The drive begins its cycle at t = 0.
        .skip_while(|sample| sample.as_ref().is_ok_and(|s| s.state.phase.reduced() != 0.0))
        .take((PER_CYCLE * CYCLES + 1) as usize)
        .collect::<Result<_, _>>()
        .map_err(named)?;
    let system = given.system;
    let scale =
        |of: fn(&stickslip::Scales<f64>) -> f64| point.machine.as_ref().map_or(1.0, |m| of(&m.scales));
    let (length, velocity, force) = (scale(|s| s.length), scale(|s| s.velocity), scale(|s| s.force));
    let displacement = point.machine.as_ref().map_or("displacement", Machine::displacement);
    let mean_friction = point.machine.as_ref().map_or(0.0, |m| m.scales.mean_friction);
    let friction = |s: &Instant<f64>| s.friction * force + mean_friction;
    let label = |name: &str, symbol: &str, kind: Kind| match point.machine {
        Some(_) => format!("{name} ({})", system.name(kind)),
        None => format!("{name} {symbol}"),
    };
    let time = |i: usize| {
        let phase = std::f64::consts::TAU * i as f64 / f64::from(PER_CYCLE);
        point.machine.as_ref().map_or(phase, |m| phase * m.scales.time)
    };
    let when = match point.machine {
        Some(_) => "time (s)",
        None => "phase ω_d t (rad)",
    };
    let over_time = |value: &dyn Fn(&Instant<f64>) -> f64| -> Vec<(f64, f64)> {
        samples.iter().enumerate().map(|(i, s)| (time(i), value(s))).collect()
    };
    // Stops have the colour that means rest in all pictures.
    let stops = |points: &[(f64, f64)]| -> Vec<(f64, f64)> {
        let rests = |s: &Instant<f64>| s.state.v == 0.0 && s.acceleration == 0.0;
        samples
            .iter()
            .zip(points)
            .map(|(s, point)| if rests(s) { *point } else { (f64::NAN, f64::NAN) })
            .collect()
    };
    let panel = |title: &str, x: &str, y: String, points: Vec<(f64, f64)>| {
        let at_rest = stops(&points);
        let mut series = vec![Series::new("sliding", Style::Line, 2, points.clone())];
        if at_rest.iter().any(|(x, _)| x.is_finite()) {
            series.push(Series::new("at rest", Style::Thick, 3, at_rest));
        }
        Panel::new(
            title,
            axis(x, points.iter().map(|(x, _)| *x), 0.0),
            axis(&y, points.iter().map(|(_, y)| *y), 0.08),
            series,
        )
    };
    let (x, r) = (label(displacement, "x/B", Kind::Length), label("friction force", "r/r_y", Kind::Force));
    let loop_points: Vec<(f64, f64)> = samples.iter().map(|s| (s.state.x * length, friction(s))).collect();
    let mut friction_loop = panel("friction loop", &x, r.clone(), loop_points);
    friction_loop.x = axis(&x, samples.iter().map(|s| s.state.x * length), 0.08);
    let figure = Figure::new(
        "motion",
        format!("Steady motion: {}", given::line(&args.machine, |_| true, &given.system)),
        "",
        vec![
            panel("displacement", when, x.clone(), over_time(&|s| s.state.x * length)),
            panel(
                "velocity",
                when,
                label("velocity", "x′/(Bω_d)", Kind::Velocity),
                over_time(&|s| s.state.v * velocity),
            ),
            panel("friction force", when, r, over_time(&friction)),
            friction_loop,
        ],
    );
    target.draw(out, || Ok(figure))
}

/// An axis that contains all values, with a margin.
pub(crate) fn axis(label: &str, values: impl Iterator<Item = f64>, room: f64) -> Axis {
    let (low, high) = values
        .filter(|v| v.is_finite())
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    let room = room * (high - low).max(f64::MIN_POSITIVE);
    Axis::linear(label, low - room, high + room)
}
