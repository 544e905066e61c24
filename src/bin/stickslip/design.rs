//! `stickslip design`.

mod best;
mod no_stop;

use crate::args::{Format, Question, QuestionArgs, UnitNames};
use crate::bits::{self, Task, Value};
use crate::failure::{Failure, Outcome};
use crate::input::{behind, given, is_physical, number, required};
use crate::note::digits;
use crate::record::{Cell, Record};
use std::io::Write;
use stickslip::design::{self, Edge};
use stickslip::{Border, Drive, Error, Oscillator, Quantity};

/// The question and where its answer goes.
struct Run<'a, W>(&'a Question, &'a mut W);

pub(crate) fn run(question: &Question, out: &mut impl Write) -> Outcome {
    bits::run(arguments(question).bits, Run(question, out))
}

const fn arguments(question: &Question) -> &QuestionArgs {
    match question {
        Question::Force(args)
        | Question::Friction(args)
        | Question::Bands(args)
        | Question::Displacement(args)
        | Question::Velocity(args)
        | Question::Dissipation(args)
        | Question::Stiffness(args) => args,
    }
}

/// An answer: what it says in a sentence, and its numbers.
struct Answer<F> {
    sentence: String,
    rows: Vec<Vec<(&'static str, Cell<F>)>>,
}

impl<F: Value> Answer<F> {
    fn one(sentence: String, fields: Vec<(&'static str, Cell<F>)>) -> Self {
        Self { sentence, rows: vec![fields] }
    }
}

impl<W: Write> Task for Run<'_, W> {
    fn run<F: Value>(self) -> Outcome {
        let Self(question, out) = self;
        let args = arguments(question);
        let asked = Asked::<F>::new(args)?;
        let answer = match question {
            Question::Force(_) if args.no_stop => asked.forces_without_stop(),
            Question::Bands(_) if args.no_stop => asked.bands_without_stop(),
            Question::Force(_) => asked.least_force(),
            Question::Friction(_) => asked.greatest_friction(),
            Question::Bands(_) => asked.bands(),
            Question::Displacement(_) => asked.displacement(),
            Question::Velocity(_) => asked.velocity(),
            Question::Dissipation(_) => asked.dissipation(),
            Question::Stiffness(_) => asked.stiffness(),
        }?;
        answer.rows.iter().flatten().try_for_each(|(name, cell)| cell.finite(name))?;
        match args.format {
            Format::Text => {
                writeln!(out, "{}", answer.sentence)?;
                for row in &answer.rows {
                    writeln!(out)?;
                    for (name, cell) in row {
                        writeln!(out, "  {:<22} {}", name.replace('_', " "), cell.text())?;
                    }
                }
                Ok(())
            }
            Format::Json => {
                let records = answer.rows.into_iter().map(|fields| Record { fields, physical: Vec::new() });
                let records: Vec<Record<F>> = records.collect();
                match (question, records.first()) {
                    (Question::Bands(_), _) => serde_json::to_writer_pretty(&mut *out, &records)?,
                    (_, Some(record)) => serde_json::to_writer_pretty(&mut *out, record)?,
                    (_, None) => {}
                }
                Ok(out.write_all(b"\n")?)
            }
            Format::Jsonl | Format::Csv => {
                Err(Failure::Input("--format: the answer to design is text or json".to_owned()))
            }
        }
    }
}

/// The arguments of a question, ready to be read as its answer needs them.
struct Asked<'a, F> {
    args: &'a QuestionArgs,
    physical: bool,
    one: F,
}

impl<'a, F: Value> Asked<'a, F> {
    fn new(args: &'a QuestionArgs) -> Result<Self, Failure> {
        let physical = is_physical(&args.machine);
        if physical && (args.machine.omega.is_some() || args.force.alpha.is_some()) {
            let text = "--omega and --alpha: a question is asked in ratios or in physical units, not in both";
            return Err(Failure::Input(text.to_owned()));
        }
        Ok(Self { args, physical, one: F::int(1) })
    }

    /// The error behind the arguments of the machine, the range and the target that it comes from.
    fn fail(&self, error: Error) -> Failure {
        use Quantity as Q;
        let QuestionArgs { machine, force, from, to, target, .. } = self.args;
        let mut given = given(machine, force).to_vec();
        // The range is of what is asked for, which no other argument gives.
        let of_range: &[Q] = &[Q::FrequencyRatio, Q::AngularFrequency, Q::Stiffness];
        let targets: &[Q] =
            &[Q::MaxDisplacement, Q::MaxDisplacementRatio, Q::MaxVelocity, Q::MaxVelocityRatio];
        given.extend([("--from", from, of_range), ("--to", to, of_range), ("--target", target, targets)]);
        behind(error, &given)
    }

    fn omega(&self) -> Result<F, Failure> {
        required("--omega", self.args.machine.omega.as_ref())
    }

    fn alpha(&self) -> Result<F, Failure> {
        required("--alpha", self.args.force.alpha.as_ref())
    }

    fn frequency(&self) -> Result<F, Failure> {
        required("--frequency", self.args.machine.frequency.as_ref())
    }

    fn range(&self) -> Result<(F, F), Failure> {
        Ok((required("--from", self.args.from.as_ref())?, required("--to", self.args.to.as_ref())?))
    }

    fn target(&self) -> Result<F, Failure> {
        required("--target", self.args.target.as_ref())
    }

    /// The body; what the question does not need may be missing, and is then 1.
    fn body(&self, needs_stiffness: bool, needs_friction: bool) -> Result<Oscillator<F>, Failure> {
        let machine = &self.args.machine;
        let or_one = |needed: bool, name: &str, given: &Option<String>| match given {
            None if !needed => Ok(self.one),
            given => required(name, given.as_ref()),
        };
        let mass = required("--mass", machine.mass.as_ref())?;
        let stiffness = or_one(needs_stiffness, "--stiffness", &machine.stiffness)?;
        let friction = or_one(needs_friction, "--friction", &machine.friction)?;
        Oscillator::new(mass, stiffness, friction).map_err(|e| self.fail(e))
    }

    fn drive(&self, frequency: F) -> Result<Drive<F>, Failure> {
        match (&self.args.force.force, &self.args.force.base_motion) {
            (Some(p0), None) => Drive::force(number("--force", p0)?, frequency),
            (None, Some(ug)) => Drive::base_motion(number("--base-motion", ug)?, frequency),
            (None, None) => {
                return Err(Failure::Input("--force (or --base-motion) is missing".to_owned()));
            }
            (Some(_), Some(_)) => {
                return Err(Failure::Input("--force and --base-motion: give one of the two".to_owned()));
            }
        }
        .map_err(|e| self.fail(e))
    }

    fn units(&self) -> &UnitNames {
        &self.args.units
    }

    fn least_force(&self) -> Result<Answer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let border = Border::new(omega).map_err(|e| self.fail(e))?;
            let least = border.min_force_ratio();
            let sentence = format!("It does not stick from a force of {} r_y on.", digits(least));
            return Ok(Answer::one(sentence, vec![("omega", some(omega)), ("force_ratio", some(least))]));
        }
        let (body, frequency) = (self.body(true, true)?, self.frequency()?);
        let force = design::least_force(&body, frequency).map_err(|e| self.fail(e))?;
        let base = design::least_base_amplitude(&body, frequency).map_err(|e| self.fail(e))?;
        let UnitNames { force: newton, length } = self.units();
        let sentence = format!(
            "It does not stick from a force of {} {newton}, or a base motion of {} {length}, on.",
            digits(force),
            digits(base)
        );
        Ok(Answer::one(sentence, vec![("force", some(force)), ("base_motion", some(base))]))
    }

    fn greatest_friction(&self) -> Result<Answer<F>, Failure> {
        if !self.physical {
            let omega = self.omega()?;
            let border = Border::new(omega).map_err(|e| self.fail(e))?;
            let ratio = self.one / border.min_force_ratio();
            let sentence = format!("It does not stick up to a friction bound of {} p₀.", digits(ratio));
            return Ok(Answer::one(
                sentence,
                vec![("omega", some(omega)), ("friction_to_force", some(ratio))],
            ));
        }
        let (body, drive) = (self.body(true, false)?, self.drive(self.frequency()?)?);
        let friction = design::greatest_friction(&body, &drive).map_err(|e| self.fail(e))?;
        let sentence = format!(
            "It does not stick up to a friction bound of {} {}.",
            digits(friction),
            self.units().force
        );
        Ok(Answer::one(sentence, vec![("friction", some(friction))]))
    }

    fn bands(&self) -> Result<Answer<F>, Failure> {
        let (low, high) = self.range()?;
        let (found, unit) = if self.physical {
            let body = self.body(true, true)?;
            // The frequency of the drive is what is asked for: its amplitude alone counts.
            let drive = self.drive(self.one)?;
            (design::frequency_bands(&body, &drive, low, high), "frequency")
        } else {
            (design::bands(self.alpha()?, low, high), "omega")
        };
        let names =
            if unit == "omega" { ["omega_from", "omega_to"] } else { ["frequency_from", "frequency_to"] };
        let edge = |edge: Edge| if edge == Edge::Range { "end-of-range" } else { "border" };
        let rows = found
            .map_err(|e| self.fail(e))?
            .map(|band| {
                band.map(|b| {
                    vec![
                        (names[0], some(b.low)),
                        (names[1], some(b.high)),
                        ("low_edge", Cell::Text(edge(b.low_edge))),
                        ("high_edge", Cell::Text(edge(b.high_edge))),
                    ]
                })
            })
            .collect::<Result<Vec<_>, Error>>()
            .map_err(|e| self.fail(e))?;
        let sentence = match rows.len() {
            0 => "It sticks, or rests, throughout that range.".to_owned(),
            1 => "It does not stick in one band of that range:".to_owned(),
            n => format!("It does not stick in {n} bands of that range, which are all there are:"),
        };
        Ok(Answer { sentence, rows })
    }

    fn displacement(&self) -> Result<Answer<F>, Failure> {
        let target = self.target()?;
        if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            return self.force_for(design::force_for_displacement(&body, frequency, target));
        }
        self.ratio_for(design::force_ratio_for_displacement(self.omega()?, target))
    }

    fn velocity(&self) -> Result<Answer<F>, Failure> {
        let target = self.target()?;
        if self.physical {
            let (body, frequency) = (self.body(true, true)?, self.frequency()?);
            return self.force_for(design::force_for_velocity(&body, frequency, target));
        }
        self.ratio_for(design::force_ratio_for_velocity(self.omega()?, target))
    }

    fn force_for(&self, force: Result<F, Error>) -> Result<Answer<F>, Failure> {
        let force = force.map_err(|e| self.fail(e))?;
        let sentence = format!("It takes a force of {} {}.", digits(force), self.units().force);
        Ok(Answer::one(sentence, vec![("force", some(force))]))
    }

    fn ratio_for(&self, ratio: Result<F, Error>) -> Result<Answer<F>, Failure> {
        let ratio = ratio.map_err(|e| self.fail(e))?;
        let sentence = format!("It takes a force of {} r_y.", digits(ratio));
        Ok(Answer::one(sentence, vec![("force_ratio", some(ratio))]))
    }
}

fn some<F: Value>(x: F) -> Cell<F> {
    Cell::Number(Some(x))
}
