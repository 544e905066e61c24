//! `stickslip decay`.

use crate::args::{DecayArgs, Format};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::note::both;
use crate::physical::Physical;
use crate::record::{Cell, Record};
use crate::units::{Kind, Reader, System};
use std::io::Write;
use stickslip::exact::FreeDecay;
use stickslip::{Oscillator, Quantity};

/// The command with its arguments and where its answer goes.
struct Run<'a, W>(&'a DecayArgs, &'a mut W);

pub(crate) fn run(args: &DecayArgs, out: &mut impl Write) -> Outcome {
    bits::run(args.bits, Run(args, out))
}

/// The scales of free vibration: length B, time 1/ω_n.
struct Scales<F> {
    length: F,
    time: F,
    system: System,
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(args, out) = self;
        let reader = args.units.reader();
        let scales = scales::<F>(args, &reader)?;
        let kind = |kind: Kind| if scales.is_some() { kind } else { Kind::Ratio };
        let x0: F = reader.value("--x0", &args.x0, kind(Kind::Length))?;
        let v0: F =
            if args.v0 == "0" { F::int(0) } else { reader.value("--v0", &args.v0, kind(Kind::Velocity))? };
        let (x, v) = match &scales {
            Some(s) => (x0 / s.length, v0 * s.time / s.length),
            None => (x0, v0),
        };
        let zeta = match &args.damping_ratio {
            Some(text) => reader.value("--damping-ratio", text, Kind::Ratio)?,
            None => F::int(0),
        };
        let eta = match &args.static_friction_ratio {
            Some(text) => reader.value("--static-friction-ratio", text, Kind::Ratio)?,
            None => F::int(1),
        };
        let decay = FreeDecay::with_frictions(x, v, zeta, eta).map_err(|e| {
            let argument = match e.quantity() {
                Some(Quantity::DampingRatio) => {
                    format!("--damping-ratio {}", args.damping_ratio.as_deref().unwrap_or("0"))
                }
                Some(Quantity::StaticFrictionRatio) => {
                    let text = args.static_friction_ratio.as_deref().unwrap_or("1");
                    format!("--static-friction-ratio {text}")
                }
                Some(Quantity::Velocity) => format!("--v0 {}", args.v0),
                _ => format!("--x0 {}", args.x0),
            };
            Failure::Input(format!("{argument}: {e}"))
        })?;
        let record = record(&decay, scales.as_ref()).finite()?;
        match args.format {
            Format::Json => record.write_pretty(out),
            Format::Text => {
                let length = |x| {
                    both(
                        x,
                        "B",
                        scales.as_ref().map(|s| s.length),
                        scales.as_ref().map_or("", |s| s.system.length),
                    )
                };
                let time = |t| both(t, "/ω_n", scales.as_ref().map(|s| s.time), "s");
                let rests = decay.rest_time().is_finite();
                if rests {
                    writeln!(out, "At rest after {} half cycles.\n", decay.half_cycles())?;
                } else {
                    writeln!(out, "It creeps to its place of rest for ever.\n")?;
                }
                writeln!(out, "  turns first at           {}", length(decay.first_turn()))?;
                writeln!(out, "  comes to rest at         {}", length(decay.rest_position()))?;
                if rests {
                    writeln!(out, "  after a time of          {}", time(decay.rest_time()))?;
                }
                Ok(())
            }
            Format::Jsonl | Format::Csv => {
                Err(Failure::Input("--format: the answer to decay is text or json".to_owned()))
            }
        }
    }
}

fn record<F: Value>(decay: &FreeDecay<F>, scales: Option<&Scales<F>>) -> Record<F> {
    let mut record = Record {
        fields: vec![
            ("half_cycles", Cell::Count(Some(decay.half_cycles()))),
            ("first_turn", Cell::Number(Some(decay.first_turn()))),
            ("rest_position", Cell::Number(Some(decay.rest_position()))),
            ("rest_time", Cell::Number(Some(decay.rest_time()).filter(|time| time.is_finite()))),
        ],
        physical: Physical::default(),
    };
    if let Some(scales) = scales {
        record.physical = Physical::of(scales.system).with(&record.fields, |name| match name {
            "first_turn" => Some(("first_turn", Kind::Length, scales.length)),
            "rest_position" => Some(("rest_position", Kind::Length, scales.length)),
            "rest_time" => Some(("rest_time", Kind::Time, scales.time)),
            _ => None,
        });
    }
    record
}

/// The scales of the machine, where there is one.
fn scales<F: Value>(args: &DecayArgs, reader: &Reader) -> Result<Option<Scales<F>>, Failure> {
    match (&args.mass, &args.stiffness, &args.friction) {
        (None, None, None) => Ok(None),
        (Some(m), Some(k), Some(r)) => {
            let mass = reader.value("--mass", m, Kind::Mass)?;
            let stiffness = reader.value("--stiffness", k, Kind::Stiffness)?;
            let friction = reader.value("--friction", r, Kind::Force)?;
            let body = Oscillator::new(mass, stiffness, friction)
                .map_err(|e| Failure::Input(format!("--mass {m} --stiffness {k} --friction {r}: {e}")))?;
            let time = F::int(1) / body.natural_frequency();
            Ok(Some(Scales { length: body.friction_displacement(), time, system: reader.system }))
        }
        _ => Err(Failure::Input("--mass, --stiffness and --friction: give all three or none".to_owned())),
    }
}
