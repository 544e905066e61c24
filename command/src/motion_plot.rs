//! `stickslip motion-plot`: a steady motion over time, and its loops.

use crate::args::MotionPlotArgs;
use crate::failure::Outcome;
use crate::figure::Target;
use crate::input;
use crate::steady::of_motion;
use std::io::Write;
use stickslip::motion::{Instant, LongRun, Trajectory};
use stickslip_draw::{Axis, Figure, Panel, Series, Style};
use stickslip_front::inputs::units::Kind;

/// The number of samples in a cycle.
const PER_CYCLE: u32 = 600;
/// The number of cycles drawn.
const CYCLES: u32 = 2;
/// The most cycles of a motion from its start to its rest.
const MOST_CYCLES: u32 = 60;

pub(crate) fn run(args: &MotionPlotArgs, out: &mut impl Write) -> Outcome {
    let target = Target::new("--out", args.out.as_deref(), args.overwrite, &args.look)?;
    let reader = args.units.reader();
    let given = input::read::<f64>(&args.machine, &reader)?;
    let point = input::point(&given)?;
    let start = input::start(&args.start, &given, point.machine.as_ref(), &reader)?;
    let named = |e: stickslip::Error| of_motion(&given, e);
    let limit = LongRun::from_start(point.ratios, start).map_err(named)?;
    // A motion that ends at rest is drawn from its start, with a period beyond its end.
    let drawn = match (limit.steady_state(), &limit) {
        (Some(steady), _) => Some((steady.state, CYCLES, "Steady motion")),
        (None, LongRun::Rest(rest)) if rest.periods < f64::from(MOST_CYCLES) => {
            Some((start, rest.periods.ceil() as u32 + CYCLES - 1, "Motion to its rest"))
        }
        _ => None,
    };
    let Some((begin, cycles, what)) = drawn else {
        let scale = point.machine.as_ref().map_or(1.0, |m| m.scales.length);
        let unit = if point.machine.is_some() { given.system.length() } else { "B" };
        let length = |x: f64| format!("{} {unit}", crate::bits::digits(x * scale));
        let verdict = stickslip_front::words::limit(point.ratios, &limit, length, "");
        return Err(format!("motion-plot: there is no periodic motion to draw. {verdict}").into());
    };
    let samples: Vec<Instant<f64>> = Trajectory::new(point.ratios, begin)
        .and_then(|motion| motion.samples(PER_CYCLE))
        .map_err(named)?
        // The drive begins its cycle at t = 0.
        .skip_while(|sample| sample.as_ref().is_ok_and(|s| s.state.phase.reduced() != 0.0))
        .take((PER_CYCLE * cycles + 1) as usize)
        .collect::<Result<_, _>>()
        .map_err(named)?;
    let system = given.system;
    let scale =
        |of: fn(&stickslip::Scales<f64>) -> f64| point.machine.as_ref().map_or(1.0, |m| of(&m.scales));
    let (length, velocity, force) = (scale(|s| s.length), scale(|s| s.velocity), scale(|s| s.force));
    let displacement = input::displacement(&given);
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
    let rests = samples.iter().map(|s| s.state.v == 0.0 && s.acceleration == 0.0).collect::<Vec<_>>();
    let over = |points: &[(f64, f64)], label: &str, room: f64| axis(label, points.iter().map(|p| p.0), room);
    let (x, r) = (label(displacement, "x/B", Kind::Length), label("friction force", "r/r_y", Kind::Force));
    let friction_loop: Vec<_> = samples.iter().map(|s| (s.state.x * length, friction(s))).collect();
    let speed = label("velocity", "x′/(Bω_d)", Kind::Velocity);
    let panels = [
        ("displacement", &x, over_time(&|s| s.state.x * length)),
        ("velocity", &speed, over_time(&|s| s.state.v * velocity)),
        ("friction force", &r, over_time(&friction)),
    ];
    let mut panels: Vec<_> = panels
        .into_iter()
        .map(|(title, y, points)| panel(title, over(&points, when, 0.0), y, points, &rests))
        .collect();
    panels.push(panel("friction loop", over(&friction_loop, &x, 0.08), &r, friction_loop, &rests));
    let title = format!("{what}: {}", input::line(&args.machine, |_| true, &given.system));
    let figure = Figure::new("motion", title, "", panels).stacked();
    target.draw(out, || Ok(figure))
}

/// The places of the values that a picture needs: of so many in a row, the first, the least, the greatest and the last.
pub(crate) fn drawn(values: &[f64]) -> Vec<usize> {
    /// The most rows of values, several for each pixel.
    const ROWS: usize = 4000;
    let length = values.len().div_ceil(ROWS).max(1);
    if length <= 4 {
        return (0..values.len()).collect();
    }
    let mut places = Vec::new();
    for (row, some) in values.chunks(length).enumerate() {
        let by_value = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1);
        let least = some.iter().enumerate().min_by(by_value).map_or(0, |(place, _)| place);
        let greatest = some.iter().enumerate().max_by(by_value).map_or(0, |(place, _)| place);
        let mut kept = [0, least.min(greatest), least.max(greatest), some.len() - 1].to_vec();
        kept.dedup();
        places.extend(kept.into_iter().map(|place| row * length + place));
    }
    places
}

/// A panel of a motion, whose rests have the colour that means rest in all pictures.
pub(crate) fn panel(title: &str, x: Axis, y: &str, points: Vec<(f64, f64)>, rests: &[bool]) -> Panel {
    let places = drawn(&points.iter().map(|point| point.1).collect::<Vec<_>>());
    let of = |place: &usize| Some((*points.get(*place)?, *rests.get(*place)?));
    let (points, rests): (Vec<_>, Vec<_>) = places.iter().filter_map(of).unzip();
    let y = axis(y, points.iter().map(|(_, y)| *y), 0.08);
    let at_rest = points.iter().zip(&rests).map(|(&(x, y), rests)| (x, if *rests { y } else { f64::NAN }));
    let at_rest = Series::new("at rest", Style::Thick, 3, at_rest);
    // Without a rest there is nothing to tell apart.
    let key = if rests.contains(&true) { "sliding" } else { "" };
    let mut series = Vec::new();
    if rests.iter().any(|rest| !rest) {
        series.push(Series::new("sliding", Style::Line, 2, points).with_key(key));
    }
    series.extend(rests.contains(&true).then_some(at_rest));
    Panel::new(title, x, y, series)
}

/// An axis that contains all values, with a margin. Values that hardly differ, such as those of a body at rest, have
/// room around them.
pub(crate) fn axis(label: &str, values: impl Iterator<Item = f64>, room: f64) -> Axis {
    /// The least part of a value that an axis resolves.
    const RESOLVED: f64 = 1e-9;
    let ends = values.filter(|v| v.is_finite()).map(|v| (v, v));
    let (low, high) = ends.reduce(|a, b| (a.0.min(b.0), a.1.max(b.1))).unwrap_or((0.0, 0.0));
    let size = low.abs().max(high.abs());
    let room = match high - low {
        width if width > RESOLVED * size => room * width,
        _ if size > f64::MIN_POSITIVE => size / 2.0,
        _ => 1.0,
    };
    Axis::linear(label, low - room, high + room)
}

#[cfg(test)]
mod tests {
    use super::{axis, drawn};

    #[test]
    fn a_picture_of_many_values_has_their_extremes() {
        let values: Vec<f64> =
            (0..5_000_000u32).map(|i| f64::from(i.wrapping_mul(2_654_435_761) >> 8)).collect();
        let places = drawn(&values);
        assert!(
            places.len() <= 16_000 && places.windows(2).all(|pair| pair[0] < pair[1]),
            "{}",
            places.len()
        );
        let extremes = |values: &mut dyn Iterator<Item = f64>| {
            values.fold((f64::INFINITY, 0.0f64), |(low, high), value| (low.min(value), high.max(value)))
        };
        let kept = extremes(&mut places.iter().map(|&place| values[place]));
        assert_eq!(kept, extremes(&mut values.iter().copied()));
        assert_eq!((places[0], *places.last().unwrap()), (0, values.len() - 1));
        assert_eq!(drawn(&values[..9000]), (0..9000).collect::<Vec<_>>());
        assert_eq!(drawn(&[]), [0usize; 0]);
    }

    #[test]
    fn an_axis_has_room_around_constant_values() {
        for value in [0.0, 5e-324, -3.0, 1e300, f64::MAX] {
            let axis = axis("", [value, value].into_iter(), 0.0);
            assert!(axis.low < value && value < axis.high, "{value:e}: {axis:?}");
        }
        let axis = axis("", [f64::NAN].into_iter(), 0.0);
        assert_eq!((axis.low, axis.high), (-1.0, 1.0));
    }
}
