//! The arguments of a question.

use super::{AnswerRow, DesignAnswer, NamedRow, shown};
use crate::args::QuestionArgs;
use crate::bits::{Value, digits};
use crate::failure::{Failure, Outcome};
use crate::input;
use crate::row::Cell;
use std::io::Write;
use stickslip::{Drive, Error, Excitation, Oscillator, Quantity, Ratios};
use stickslip_front::inputs::units::{self, Kind, Reader, System};
use stickslip_front::inputs::{Given, Input, Role, in_typed_unit};
use stickslip_front::words;

/// The arguments of a question, read on demand.
pub(super) struct AskedDesign<'a, F> {
    pub(super) args: &'a QuestionArgs,
    pub(super) reader: &'a Reader,
    pub(super) given: Given<F>,
    pub(super) physical: bool,
    pub(super) one: F,
    /// 0 where the answer is a share of a friction of 0; else 1.
    pub(super) share: F,
    /// Whether friction was given as 0.
    pub(super) is_without_friction: bool,
}

impl<'a, F: Value> AskedDesign<'a, F> {
    pub(super) fn new(args: &'a QuestionArgs, reader: &'a Reader) -> Result<Self, Failure> {
        let given = input::read(&args.machine, reader)?;
        let given = input::with_any_mass(&given).into_owned();
        let physical = given.is_physical();
        if physical && (given.has(Input::Omega) || given.has(Input::Alpha)) {
            let text = "--omega and --alpha: must be left out in physical units, where --frequency and --force take their place";
            return Err(text.into());
        }
        let mut asked = Self {
            args,
            reader,
            given,
            physical,
            one: F::int(1),
            share: F::int(1),
            is_without_friction: false,
        };
        asked.make_friction()?;
        Ok(asked)
    }

    /// A friction of 0 becomes one far below the rounding of the motion; where no drive and no target give its size, as
    /// for the minimum force, it becomes 1, of which the answer is a share of 0.
    fn make_friction(&mut self) -> Outcome {
        if !self.given.is_without_friction() {
            return Ok(());
        }
        self.is_without_friction = true;
        let label = self.given.first_of(Role::Friction).map(|input| self.given.label(input));
        self.given.replace_friction(self.one);
        let body = self.body(false, false)?;
        let frequency = self.given.get(Input::Frequency);
        let of_drive = self.given.has_role(Role::Drive).then(|| {
            let drive = self.drive(&body, frequency.unwrap_or(self.one))?;
            Ok::<F, Failure>(drive.force_amplitude(&body))
        });
        let target = self.args.target.as_ref().map(|text| -> Result<F, Failure> {
            // The target is a displacement or a velocity, and its unit one of the two.
            let read = |kind| self.reader.value::<F>("--target", text, kind);
            let far = read(Kind::Length).or_else(|_| read(Kind::Velocity));
            Ok(body.stiffness() * far?.abs())
        });
        match of_drive.or(target).transpose()? {
            Some(force) => self.given.replace_friction(force * Given::<F>::nothing()),
            None => self.share = F::int(0),
        }
        if let (Some(label), true) = (label, self.args.no_stop) {
            return Err(
                format!("{label}: without friction the body never stops, and is never at rest").into()
            );
        }
        Ok(())
    }

    /// Refuses a drive of 0, under which the body rests whatever is asked for.
    pub(super) fn driven(&self) -> Outcome {
        if !self.given.is_without_drive() {
            return Ok(());
        }
        let drive = self.given.first_of(Role::Drive);
        let label = drive.map_or_else(String::new, |input| self.given.label(input));
        Err(format!("{label}: must be > 0. Without a drive the body rests with every friction").into())
    }

    /// The sentence, the kind of base motion, and a line for each number with its unit.
    pub(super) fn text(&self, answer: &DesignAnswer<F>, out: &mut impl Write) -> Outcome {
        let QuestionArgs { machine, from, to, over, .. } = self.args;
        let typed =
            [machine.text(Input::Frequency)].into_iter().chain([from, to, over].map(Option::as_deref));
        // The answer has rad/s in any case.
        let typed = input::frequency_unit::<F>(typed.flatten()).filter(|(_, factor)| *factor != self.one);
        let (other, factor) = typed.unwrap_or_else(|| ("Hz".to_owned(), F::int(2) * F::pi()));
        writeln!(out, "{}", answer.sentence)?;
        if let Some(base) = self.excitation().and_then(words::base_motion_sentence) {
            writeln!(out, "{base}")?;
        }
        for row in &answer.rows {
            writeln!(out)?;
            for (name, kind, cell) in row {
                let in_other = |value: F| digits(value / factor);
                let range = |&(low, high): &(F, Option<F>)| match high {
                    Some(high) if high > low => format!("{} to {}", in_other(low), in_other(high)),
                    _ => in_other(low),
                };
                let unit = self.system().name(*kind);
                let text = match (cell, kind) {
                    (Cell::Number(Some(value)), Kind::Frequency) => {
                        format!("{} {unit} = {} {other}", cell.shown().text(), in_other(*value))
                    }
                    (Cell::Intervals(intervals), Kind::Frequency) => {
                        let ranges: Vec<_> = intervals.iter().flatten().map(range).collect();
                        format!("{} {other}", ranges.join(" and "))
                    }
                    (Cell::Number(Some(value)), Kind::Unbalance) => {
                        let (unit, factor) = self.system().for_reading(*kind);
                        format!("{} {unit}", digits(factor.times(*value)))
                    }
                    (Cell::Number(_) | Cell::Intervals(_), kind) if *kind != Kind::Ratio => {
                        format!("{} {unit}", cell.shown().text())
                    }
                    _ => cell.shown().text(),
                };
                writeln!(out, "  {:<22} {text}", name.replace('_', " "))?;
            }
        }
        Ok(())
    }

    pub(super) fn named(&self, row: &AnswerRow<F>) -> NamedRow {
        NamedRow {
            row: shown(row),
            system: self.physical.then(|| *self.system()),
            base_motion: self.excitation().and_then(words::base_motion),
        }
    }

    /// How the drive of the question excites the body, if there is one.
    fn excitation(&self) -> Option<Excitation> {
        let (input, _) = self.given.one_of(Role::Drive).ok()??;
        input.excitation()
    }

    /// The failure: the error, preceded by the arguments of the machine, the range or the target that caused
    /// it.
    pub(super) fn fail(&self, error: Error) -> Failure {
        use Quantity as Q;
        let QuestionArgs { from, to, target, .. } = self.args;
        if let Some(text) = self.in_physical_units(&error) {
            return Failure::Input(text);
        }
        let quantity = error.quantity();
        // The range is that of the unknown, which no other argument gives.
        let of_range = [Q::FrequencyRatio, Q::AngularFrequency, Q::Stiffness];
        let targets = [Q::MaxDisplacement, Q::MaxDisplacementRatio, Q::MaxVelocity, Q::MaxVelocityRatio];
        let own: [(&str, &Option<String>, &[Q]); 3] =
            [("--from", from, &of_range), ("--to", to, &of_range), ("--target", target, &targets)];
        let named: Vec<String> = own
            .iter()
            .filter(|(_, _, quantities)| quantity.is_some_and(|q| quantities.contains(&q)))
            .filter_map(|(name, value, _)| value.as_ref().map(|v| format!("{name} {v}")))
            .collect();
        let (arguments, text) = (named.join(" "), self.given.at_fault(&error).to_string());
        Failure::Input(if arguments.is_empty() {
            text
        } else if text == error.to_string() {
            format!("{arguments}: {text}")
        } else {
            text.replacen(": ", &format!(" {arguments}: "), 1)
        })
    }

    /// The error in the units of the arguments as typed, where the library states it in ratios or in the
    /// system's own units.
    fn in_physical_units(&self, error: &Error) -> Option<String> {
        let QuestionArgs { from, to, target, .. } = self.args;
        let range = from.as_ref().zip(to.as_ref());
        if let (Error::EmptyRange { .. }, Some((from, to))) = (error, range) {
            return Some(format!("--from {from} --to {to}: the lower end must be ≤ the upper end"));
        }
        if !self.physical {
            return None;
        }
        if let (Error::OutOfRange { value, .. } | Error::NotPositive { value, .. }, Some((from, to))) =
            (error, range)
        {
            // The end that the error is about, as a frequency or as Ω.
            let scale = match error.quantity() {
                Some(Quantity::FrequencyRatio) => self.body(true, true).ok()?.natural_frequency().to_f64(),
                _ => 1.0,
            };
            let at_fault = |text: &str, end: &str| {
                let typed = self.reader.value::<f64>(end, text, Kind::Frequency).ok()?;
                let said = in_typed_unit(error, &format!("{end} {text}"));
                let is_it = (typed / scale / value.to_f64() - 1.0).abs() < 1e-9;
                is_it.then(|| format!("{end} {text}: {said}"))
            };
            return at_fault(from, "--from").or_else(|| at_fault(to, "--to"));
        }
        if let (Error::SticksThroughout { alpha, least, .. }, Some((from, to))) = (error, range) {
            let (drive, _) = self.given.one_of(Role::Drive).ok()??;
            let least = digits(self.one * F::from_f64(least.to_f64() / alpha.to_f64()));
            return Some(format!(
                "{}: must be at least {least} times as large. The body sticks throughout the range from {from} to {to}",
                self.given.label(drive)
            ));
        }
        if let (Error::TargetSticks { value, least, .. }, Some(target)) = (error, target) {
            let least = units::scaled(target, least.to_f64() / value.to_f64())?;
            let frequency = self.given.label(Input::Frequency);
            return Some(format!(
                "--target {target}: must be ≥ {least} with {frequency}. In a smaller motion the body sticks"
            ));
        }
        None
    }

    pub(super) fn system(&self) -> &System {
        &self.given.system
    }

    pub(super) fn omega(&self) -> Result<F, Failure> {
        Ok(self.given.required(Input::Omega)?)
    }

    /// The given damping ratio, or zero.
    pub(super) fn damping_ratio(&self) -> F {
        self.given.get(Input::DampingRatio).unwrap_or(F::int(0))
    }

    /// Refuses a static friction above the kinetic one where its effect is not known.
    pub(super) fn one_friction(&self) -> Result<(), Failure> {
        if let Some(eta) = self.given.get(Input::StaticFrictionRatio).filter(|eta| *eta != self.one) {
            return Err(self.fail(Error::StaticFriction { static_friction_ratio: eta.into() }));
        }
        Ok(())
    }

    /// Ω with the given damping ratio and static friction ratio, and a force ratio of 1.
    pub(super) fn ratios(&self, omega: F) -> Result<Ratios<F>, Failure> {
        let ratios = Ratios::new(omega, self.one).map_err(|e| self.fail(e))?;
        Ok(self.given.completed(ratios)?)
    }

    pub(super) fn alpha(&self) -> Result<F, Failure> {
        Ok(self.given.required(Input::Alpha)?)
    }

    pub(super) fn frequency(&self) -> Result<F, Failure> {
        Ok(self.given.required(Input::Frequency)?)
    }

    /// `--from` and `--to`, in units of this kind if the question is physical.
    pub(super) fn range(&self, kind: Kind) -> Result<(F, F), Failure> {
        Ok((self.read("--from", &self.args.from, kind)?, self.read("--to", &self.args.to, kind)?))
    }

    pub(super) fn target(&self, kind: Kind) -> Result<F, Failure> {
        self.read("--target", &self.args.target, kind)
    }

    pub(super) fn read(&self, name: &str, text: &Option<String>, kind: Kind) -> Result<F, Failure> {
        match text {
            Some(text) => {
                Ok(self.reader.value(name, text, if self.physical { kind } else { Kind::Ratio })?)
            }
            None => Err(format!("{name} is missing").into()),
        }
    }

    /// The body; a quantity that the question does not need may be missing, and is then 1.
    pub(super) fn body(&self, needs_stiffness: bool, needs_friction: bool) -> Result<Oscillator<F>, Failure> {
        let or_one = |found: Option<F>, needed: bool, role| match found {
            None if needed => Err(self.given.missing(&Input::of_role(role))),
            found => Ok(found.unwrap_or(self.one)),
        };
        let mass = self.given.mass()?;
        let stiffness = self.given.stiffness_at(Some(self.frequency_of_reference()?))?;
        let stiffness = or_one(stiffness, needs_stiffness, Role::Spring)?;
        let friction = or_one(self.given.friction()?, needs_friction, Role::Friction)?;
        let body = Oscillator::new(mass, stiffness, friction).map_err(|e| self.fail(e))?;
        Ok(self.given.with_damper(body)?)
    }

    /// The frequency for which a body without a spring stands: that of the drive, the lowest of a range, or the highest of
    /// `--over`, whose motions no spring may be softer for; 1 where there is none.
    fn frequency_of_reference(&self) -> Result<F, Failure> {
        let QuestionArgs { from, over, .. } = self.args;
        let highest = over.as_deref().and_then(|text| text.split_once(':')).map(|(_, high)| ("--over", high));
        let typed = from.as_deref().map(|text| ("--from", text)).or(highest);
        match (self.given.get(Input::Frequency), typed) {
            (Some(frequency), _) => Ok(frequency),
            (None, Some((name, text))) if self.physical && self.given.is_without_spring() => {
                Ok(self.reader.value(name, text, Kind::Frequency)?)
            }
            (None, _) => Ok(self.one),
        }
    }

    pub(super) fn drive(&self, body: &Oscillator<F>, frequency: F) -> Result<Drive<F>, Failure> {
        Ok(self.given.drive(body, frequency)?)
    }
}
