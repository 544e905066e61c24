//! `stickslip decay`.

mod special;

use crate::args::DecayArgs;
use crate::bits::{Value, at_bits, digits};
use crate::failure::{Failure, Outcome};
use crate::figure::Target;
use crate::input;
use crate::motion_plot::axis;
use crate::note::{self, both, line};
use crate::output;
use crate::outputs::{DAMPING_RATIO, STATIC_FRICTION_RATIO, key};
use crate::physical::Physical;
use crate::row::{Cell, Cells};
use crate::shaken::Surface;
use std::f64::consts::TAU;
use std::io::Write;
use std::path::Path;
use stickslip::internal::definitions::REST_POSITION;
use stickslip::motion::{FreeDecay, Trajectory};
use stickslip::{Excitation, Measure, Quantity};
use stickslip_draw::{Figure, Panel, Series, Style};
use stickslip_front::inputs::units::{Kind, System};
use stickslip_front::inputs::{Given, Input, Role};

pub(crate) fn run(args: &DecayArgs, out: &mut impl Write) -> Outcome {
    at_bits!(args.answer.bits, respond(args: &DecayArgs, out))
}

/// The scales of free vibration: length B, time 1/ω_n.
struct DecayScales<F> {
    length: F,
    time: F,
    /// The displacement about which friction is symmetric, if a mean force or backward friction was given.
    mean_displacement: Option<F>,
    system: System,
}

/// ζ and η, where given.
type Frictions<F> = [Option<F>; 2];

fn respond<F: Value>(args: &DecayArgs, out: &mut impl Write) -> Outcome {
    let reader = args.answer.units.reader();
    let given = input::read::<F>(&args.machine, &reader)?;
    let surface = Surface::read(&args.surface, &reader)?;
    if surface.is_special(&given) || given.is_without_friction() && given.is_physical() {
        return special::respond(args, given, &surface, out);
    }
    if given.has_role(Role::Friction) && given.one_of(Role::Spring)?.is_none() && !given.has(Input::Omega) {
        let missing = given.missing(&Input::of_role(Role::Spring));
        return Err(format!("{missing}. A body without a spring has --no-spring").into());
    }
    let given = input::with_any_mass(&given);
    let (scales, frictions @ [damping, static_friction]) = body(&given)?;
    let kind = |kind: Kind| if scales.is_some() { kind } else { Kind::Ratio };
    let start = |option: &str, text: &Option<String>, of: Kind| match text {
        Some(text) => reader.value(option, text, kind(of)),
        None => Ok(F::int(0)),
    };
    let (x0, v0) = (start("--x0", &args.x0, Kind::Length)?, start("--v0", &args.v0, Kind::Velocity)?);
    let (x, v) = match &scales {
        Some(s) => (x0 / s.length, v0 * s.time / s.length),
        None => (x0, v0),
    };
    let zeta = damping.unwrap_or(F::int(0));
    let eta = static_friction.unwrap_or(F::int(1));
    let decay = FreeDecay::new(x, v, zeta, eta).map_err(|e| match e.quantity() {
        Some(Quantity::DampingRatio | Quantity::StaticFrictionRatio) => given.at_fault(&e).into(),
        quantity => {
            let (option, text) = match (quantity, &args.v0, &args.x0) {
                (Some(Quantity::Velocity), Some(text), _) | (_, Some(text), None) => ("--v0", text.as_str()),
                (.., text) => ("--x0", text.as_deref().unwrap_or("0")),
            };
            Failure::Input(format!("{option} {text}: {e}"))
        }
    })?;
    if let Some(scales) = &scales {
        input::note_pendulum(&given, decay.first_turn.abs().or_larger(x.abs()) * scales.length);
    }
    let record = record(&decay, scales.as_ref(), frictions).shown().finite()?;
    args.look.needs("--out", args.out.as_deref())?;
    if let Some(file) = &args.out {
        write_file(args, &decay, scales.as_ref(), file)?;
    }
    if args.answer.format.is_json("decay")? {
        return output::json(&record, out);
    }
    let name = given.system.length();
    let length = |x| both(x, "B", scales.as_ref().map(|s| s.length), name);
    let rests = decay.rest_time.is_finite();
    if rests {
        match decay.half_cycles {
            0 => writeln!(out, "At rest from the start.\n")?,
            1 => writeln!(out, "At rest after 1 half cycle.\n")?,
            n => writeln!(out, "At rest after {n} half cycles.\n")?,
        }
    } else {
        writeln!(out, "The body creeps towards rest for ever.\n")?;
    }
    line(out, "first turning point", length(decay.first_turn))?;
    line(out, "rest position", length(decay.rest_position))?;
    line(out, "path", length(decay.path()))?;
    if rests {
        let time = both(decay.rest_time, "/ω_n", scales.as_ref().map(|s| s.time), "s");
        line(out, "time to rest", time)?;
    }
    if let Some((mean, system)) = scales.as_ref().and_then(|s| Some((s.mean_displacement?, &s.system))) {
        note::mean_displacement(mean, system, out)?;
    }
    turning_points(&decay, scales.as_ref(), out)
}

/// The turning points that the answer lists.
const LISTED: u64 = 12;
/// The most turning points in a file.
const MOST: u64 = 1_000_000;
/// The most half cycles of a picture.
const MOST_DRAWN: u64 = 2_000;

/// The first turning points, a line each.
fn turning_points<F: Value>(
    decay: &FreeDecay<F>,
    scales: Option<&DecayScales<F>>,
    out: &mut impl Write,
) -> Outcome {
    if decay.turning_point(1).is_none() {
        return Ok(());
    }
    let (length, time) = scales.map_or((F::int(1), F::int(1)), |s| (s.length, s.time));
    let [when, far] = scales.map_or(["/ω_n", "B"], |s| ["s", s.system.length()]);
    writeln!(out, "\n  {:>17}  {:>20}", "turning points at", "displacement")?;
    for (t, x) in (0..LISTED).map_while(|n| decay.turning_point(n)) {
        let (t, x) = (format!("{} {when}", digits(t * time)), format!("{} {far}", digits(x * length)));
        writeln!(out, "  {t:>17}  {x:>20}")?;
    }
    if decay.turning_point(LISTED).is_some() {
        writeln!(out, "  and so on: all of them are in --out FILE.csv")?;
    }
    Ok(())
}

/// The turning points as CSV, or the motion as a picture.
fn write_file<F: Value>(
    args: &DecayArgs,
    decay: &FreeDecay<F>,
    scales: Option<&DecayScales<F>>,
    file: &Path,
) -> Outcome {
    let target = Target::new("--out", Some(file), args.overwrite, &args.look)?;
    let of = |scale: Option<F>| scale.map_or(1.0, F::to_f64);
    let (length, time) = (of(scales.map(|s| s.length)), of(scales.map(|s| s.time)));
    let units = scales.map_or(["1/ω_n", "B"], |s| ["s", s.system.length()]);
    let refused = |most: u64| {
        let count = decay.half_cycles;
        Failure::Input(format!("--out {}: {count} half cycles, must be ≤ {most}", file.display()))
    };
    let rows = |out: &mut dyn Write| -> Outcome {
        if decay.half_cycles > MOST {
            return Err(refused(MOST));
        }
        let mut writer = csv::Writer::from_writer(out);
        writer.write_record([
            "turn",
            &format!("time[{}]", units[0]),
            &format!("displacement[{}]", units[1]),
        ])?;
        for (n, (t, x)) in (0..).map_while(|n| Some((n, decay.turning_point(n)?))) {
            let (t, x) = (t.to_f64() * time, x.to_f64() * length);
            writer.write_record([n.to_string(), t.to_string(), x.to_string()])?;
        }
        Ok(writer.flush()?)
    };
    target.fill(&mut std::io::sink(), rows, || {
        if decay.half_cycles > MOST_DRAWN {
            return Err(refused(MOST_DRAWN));
        }
        let machine = input::line(&args.machine, |_| true, &args.answer.units.reader().system());
        drawn(decay, machine, [time, length], units)
    })
}

fn drawn<F: Value>(
    decay: &FreeDecay<F>,
    machine: String,
    [time, length]: [f64; 2],
    units: [&'static str; 2],
) -> Result<Figure, Failure> {
    const PER_CYCLE: u32 = 120;
    let end = match decay.rest_time.to_f64() {
        end if end.is_finite() => end + TAU / 2.0,
        // A creep is drawn until it is near its limit.
        _ => 10.0 * TAU,
    };
    let fail = |e: stickslip::Error| Failure::Input(format!("decay: {e}"));
    let samples = Trajectory::from(*decay).samples(PER_CYCLE).map_err(fail)?;
    let mut points = Vec::new();
    for (i, sample) in samples.enumerate() {
        let t = TAU * i as f64 / f64::from(PER_CYCLE);
        if t > end {
            break;
        }
        points.push((t * time, sample.map_err(fail)?.state.x.to_f64() * length));
    }
    let turns: Vec<(f64, f64)> = (0..)
        .map_while(|n| decay.turning_point(n))
        .map(|(t, x)| (t.to_f64() * time, x.to_f64() * length))
        .collect();
    let label = |name: &str, unit: &str| format!("{name} ({unit})");
    let x = axis(&label("time", units[0]), points.iter().map(|p| p.0), 0.0);
    let y = axis(&label("displacement", units[1]), points.iter().map(|p| p.1), 0.08);
    let series = vec![
        Series::new("displacement", Style::Line, 2, points),
        Series::new("turning points", Style::Marks, 1, turns),
    ];
    let panel = Panel::new(machine, x, y, series);
    Ok(Figure::new("decay", "Free vibration to rest", "", vec![panel]))
}

stickslip::define! {
    FIRST_TURN("first_turn", Length, "");
    PATH("path", Length, "");
    REST_TIME("rest_time", Angle, "");
}

fn record<F: Value>(
    decay: &FreeDecay<F>,
    scales: Option<&DecayScales<F>>,
    frictions: Frictions<F>,
) -> Cells<F> {
    let number = |x: F| Cell::Number(Some(x));
    let given = [DAMPING_RATIO, STATIC_FRICTION_RATIO].into_iter().zip(frictions);
    let mut fields: Vec<_> = given.filter_map(|(key, x)| Some((key, number(x?)))).collect();
    fields.extend([
        (key!("half_cycles"), Cell::Count(Some(decay.half_cycles))),
        (FIRST_TURN, number(decay.first_turn)),
        (REST_POSITION, number(decay.rest_position)),
        (PATH, number(decay.path())),
        (REST_TIME, Cell::Number(Some(decay.rest_time).filter(|time| time.is_finite()))),
    ]);
    let mut record = Cells::of(fields);
    if let Some(scales) = scales {
        record.physical = Physical::of(scales.system).with(&record.fields, Excitation::Force, |measure| {
            if measure == Measure::Length { scales.length } else { scales.time }
        });
        if let Some(mean) = scales.mean_displacement {
            record.physical.values.push(("mean_displacement", Kind::Length, number(mean)));
        }
    }
    record
}

/// The scales of the machine, if there is one, and ζ and η, where given.
fn body<F: Value>(given: &Given<F>) -> Result<(Option<DecayScales<F>>, Frictions<F>), Failure> {
    let (zeta, eta) = (given.get(Input::DampingRatio), given.get(Input::StaticFrictionRatio));
    if !given.is_physical() {
        return Ok((None, [zeta, eta]));
    }
    let body = given.oscillator()?;
    let frictions = [
        given.has_role(Role::Damper).then(|| zeta.unwrap_or(body.damping_ratio())),
        given.has_role(Role::StaticFriction).then(|| eta.unwrap_or(body.static_friction_ratio())),
    ];
    let scales = DecayScales {
        length: body.friction_displacement(),
        time: F::int(1) / body.natural_frequency(),
        mean_displacement: given.is_shifted().then(|| input::mean_displacement(given, &body)).transpose()?,
        system: given.system,
    };
    Ok((Some(scales), frictions))
}
