//! A record: samples of a load, and straight lines between them.

use super::body::Constants;
use super::number::Number;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::{finite, positive};
use crate::named::named;
use alloc::boxed::Box;
use alloc::vec::Vec;
use core::ops::Range;
use core::str::FromStr;

/// A measured load: samples of a force on the body, of an acceleration of the surface, or of a displacement of the
/// spring's support, with straight lines between them. After its last sample a force and an acceleration are zero, and a
/// support stays where it is, unless [`Record::followed_by`] says otherwise.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::RecordFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
pub struct Record<F> {
    excitation: Excitation,
    times: Times<F>,
    samples: Vec<F>,
    after: After,
}

named! {
    /// The load after the last sample of a record.
    #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
    #[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
    #[cfg_attr(feature = "serde", serde(rename_all = "kebab-case"))]
    pub enum After [name] {
        /// It is zero: a support jumps back to 0, with the impulse of a damper that stands on it.
        Zero = "zero",
        /// It stays at the last sample. A support then rests, so that its damper carries no velocity of it.
        Hold = "hold",
        /// No load is left. A support lets go of the spring, and of the damper that stands on it, so that friction alone
        /// and a damper on the ground stop the body. Of a force and an acceleration it is [`After::Zero`].
        Free = "free",
    }
}

impl After {
    /// That of a record of this kind by default: a support stays, a force and an acceleration end.
    const fn of(excitation: Excitation) -> Self {
        if excitation.moves_foot() { Self::Hold } else { Self::Zero }
    }
}

/// The times of the samples.
#[derive(Debug, Clone, PartialEq)]
enum Times<F> {
    /// The first one, and the step to the next.
    Equal(F, F),
    Each(Vec<F>),
}

impl<F: Float> Record<F> {
    /// A record with a sample every `step`, the first at the time 0.
    ///
    /// The excitation is [`Excitation::Force`], [`Excitation::FootMotion`], [`Excitation::DampedFootMotion`] or
    /// [`Excitation::SurfaceAcceleration`].
    ///
    /// # Errors
    /// Where there are fewer than two samples, one is not finite, the step is not finite and > 0, or the
    /// excitation is another.
    pub fn new(excitation: Excitation, step: F, samples: Vec<F>) -> Result<Self, Error> {
        positive(Quantity::TimeStep, step)?;
        let (times, after) = (Times::Equal(F::int(0), step), After::of(excitation));
        Self { excitation, times, samples, after }.checked()
    }

    /// A record with samples at these times, which increase. Two samples at one time are a step of the load. A damper on
    /// a support that jumps by Δu gives the body the impulse c Δu.
    ///
    /// # Errors
    /// As [`Record::new`], and where the times are not as many as the samples, or do not increase.
    pub fn at_times(excitation: Excitation, times: Vec<F>, samples: Vec<F>) -> Result<Self, Error> {
        if times.len() != samples.len() {
            return Err(Error::LengthMismatch { name: "times", found: times.len(), expected: samples.len() });
        }
        for (index, &time) in times.iter().enumerate() {
            let earlier = |by: usize| index.checked_sub(by).and_then(|before| times.get(before));
            let is_jump =
                earlier(1) == Some(&time) && earlier(2) != Some(&time) && times.first() != times.last();
            let step = match earlier(1) {
                Some(&before) if !is_jump => positive(Quantity::TimeStep, time - before),
                _ => Ok(time),
            };
            finite(Quantity::Time, time).and(step).map_err(|error| in_sample(index, error))?;
        }
        Self { excitation, times: Times::Each(times), samples, after: After::of(excitation) }.checked()
    }

    fn checked(self) -> Result<Self, Error> {
        if matches!(
            self.excitation,
            Excitation::SurfaceMotion | Excitation::SurfaceVelocity | Excitation::Unbalance
        ) {
            return Err(Error::RecordOf { excitation: self.excitation.name() });
        }
        if self.samples.len() < 2 {
            return Err(Error::TooFewSamples { count: self.samples.len() });
        }
        for (index, &sample) in self.samples.iter().enumerate() {
            finite(Quantity::Sample, sample).map_err(|error| in_sample(index, error))?;
        }
        finite(Quantity::Time, self.end())?;
        Ok(self)
    }

    /// A record from text with a time and a sample in each line, between them a comma, a semicolon, a tab or spaces.
    ///
    /// Lines before the first number are a header. Empty lines and lines that begin with `#` are left out, and so are
    /// further columns. Times and samples are in the units of the machine; they increase as those of
    /// [`Record::at_times`] do. The crate `stickslip-front` reads files with units and those of agencies.
    ///
    /// ```
    /// use stickslip::Excitation;
    /// use stickslip::motion::record::{Body, Record};
    /// let record = Record::from_text(Excitation::Force, "time,force\n0,0\n0.5,8\n1,-9\n1.5,0\n")?;
    /// let block = Body::new(2.0_f64, 0.7)?.with_stiffness(3.0)?;
    /// assert!(block.follow(&record)?.residual_displacement.is_some());
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::InSample`] with the number of the row from 0 where a row is not two numbers; else as for
    /// [`Record::at_times`].
    pub fn from_text(excitation: Excitation, text: &str) -> Result<Self, Error>
    where
        F: FromStr,
    {
        let lines = text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#'));
        let number = |field: Option<&str>| field.and_then(|field| field.parse::<F>().ok());
        let fields = |line: &'_ str| {
            let is_between = |c: char| matches!(c, ',' | ';' | '\t') || c.is_whitespace();
            let mut fields = line.split(is_between).filter(|field| !field.is_empty());
            let time = number(fields.next());
            (time, number(fields.next()))
        };
        let (mut times, mut samples) = (Vec::new(), Vec::new());
        for (row, (time, sample)) in lines.map(fields).skip_while(|(time, _)| time.is_none()).enumerate() {
            let unread = |quantity| in_sample(row, Error::NotFinite { quantity, value: written(f64::NAN) });
            times.push(time.ok_or_else(|| unread(Quantity::Time))?);
            samples.push(sample.ok_or_else(|| unread(Quantity::Sample))?);
        }
        Self::at_times(excitation, times, samples)
    }

    /// A record from a file, or whatever else can be read, with the text that [`Record::from_text`] takes.
    ///
    /// ```no_run
    /// use std::fs::File;
    /// use stickslip::Excitation;
    /// use stickslip::motion::record::Record;
    /// let record: Record<f64> = Record::from_csv(Excitation::SurfaceAcceleration, File::open("quake.csv")?)?;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unreadable`] where reading fails, or finds no text; else as for [`Record::from_text`].
    #[cfg(feature = "std")]
    pub fn from_csv(excitation: Excitation, mut reader: impl std::io::Read) -> Result<Self, Error>
    where
        F: FromStr,
    {
        let mut text = alloc::string::String::new();
        let unreadable = |e: std::io::Error| Error::Unreadable { reason: alloc::format!("{e}").into() };
        reader.read_to_string(&mut text).map_err(unreadable)?;
        Self::from_text(excitation, &text)
    }

    /// This record with its first sample at a time, all others as long after it as before.
    ///
    /// # Errors
    /// Where the time is not finite, or the time of the last sample is not.
    pub fn beginning_at(self, start: F) -> Result<Self, Error> {
        finite(Quantity::Time, start)?;
        let times = match self.times {
            Times::Equal(_, step) => Times::Equal(start, step),
            Times::Each(times) => {
                let first = times.first().copied().unwrap_or(start);
                Times::Each(times.into_iter().map(|time| start + (time - first)).collect())
            }
        };
        Self { times, ..self }.checked()
    }

    /// This record with every sample multiplied by a factor.
    ///
    /// # Errors
    /// Where the factor or a product is not finite.
    pub fn scaled(self, factor: F) -> Result<Self, Error> {
        finite(Quantity::ScaleFactor, factor)?;
        self.mapped(|sample| sample * factor)
    }

    /// The samples of this record within two times, both included; their times stay as they are.
    ///
    /// Times are compared as decimals, not as the numbers to which these were rounded: two that differ by no more than
    /// 2⁻⁴⁸ of the record's greatest time are one, and so are 0.015 and the third of the steps of 0.005. In a type of fewer
    /// than 53 bits, 16 of its roundings take the place of 2⁻⁴⁸.
    ///
    /// # Errors
    /// Where the times are not finite, are not in order, or fewer than two samples are between them.
    pub fn between(self, from: F, to: F) -> Result<Self, Error> {
        let kept = self.places_between(from, to)?;
        let samples = self.samples.get(kept.clone()).unwrap_or_default().to_vec();
        let times = match &self.times {
            Times::Equal(_, step) => Times::Equal(self.time(kept.start), *step),
            Times::Each(times) => Times::Each(times.get(kept).unwrap_or_default().to_vec()),
        };
        Self { times, samples, ..self }.checked()
    }

    /// This record with other samples at its times, if they make one.
    #[cfg(feature = "identify")]
    pub(crate) fn with_samples(&self, samples: Vec<F>) -> Option<Self> {
        (samples.len() == self.samples.len())
            .then(|| Self { samples, ..self.clone() }.checked().ok())
            .flatten()
    }

    /// This record with another load after its last sample. By default a force and an acceleration are zero, and a support
    /// stays.
    #[must_use]
    pub fn followed_by(self, after: After) -> Self {
        Self { after, ..self }
    }

    /// The time of the first sample and the step, where the steps are equal; otherwise the time of each sample.
    #[cfg(feature = "serde")]
    pub(crate) fn times(&self) -> Result<(F, F), &[F]> {
        match &self.times {
            Times::Equal(start, step) => Ok((*start, *step)),
            Times::Each(times) => Err(times),
        }
    }

    /// What the samples are.
    pub const fn excitation(&self) -> Excitation {
        self.excitation
    }

    /// The load after the last sample.
    pub const fn after(&self) -> After {
        self.after
    }

    /// The last sample.
    pub(super) fn last(&self) -> F {
        self.samples.last().copied().unwrap_or_else(|| F::int(0))
    }

    /// The steps between the samples: the time at which each begins, its length, which is 0 where the load jumps, and both
    /// samples.
    pub(super) fn steps(&self) -> impl Iterator<Item = (F, F, [F; 2])> + '_ {
        let pairs = self.samples.iter().zip(self.samples.iter().skip(1)).enumerate();
        pairs.map(|(index, (&first, &second))| (self.time(index), self.step_after(index), [first, second]))
    }

    /// The samples.
    pub fn samples(&self) -> &[F] {
        &self.samples
    }

    /// The time of a sample.
    pub fn time(&self, index: usize) -> F {
        match &self.times {
            Times::Equal(start, step) => *start + F::count(index) * *step,
            Times::Each(times) => times.get(index).copied().unwrap_or_else(|| F::int(0)),
        }
    }

    /// The time of the last sample.
    pub fn end(&self) -> F {
        self.time(self.samples.len().saturating_sub(1))
    }

    /// The step, where all steps are equal.
    pub fn step(&self) -> Option<F> {
        match &self.times {
            Times::Equal(_, step) => Some(*step),
            Times::Each(_) => None,
        }
    }

    /// The length of the step after a sample.
    pub(super) fn step_after(&self, index: usize) -> F {
        match &self.times {
            Times::Equal(_, step) => *step,
            Times::Each(_) => self.time(index.saturating_add(1)) - self.time(index),
        }
    }
}

// For the programs of this repository.
#[doc(hidden)]
impl<F: Float> Record<F> {
    /// This record with every sample replaced by this function of it.
    ///
    /// # Errors
    /// Where a value of the function is not finite.
    pub fn mapped(mut self, of: impl Fn(F) -> F) -> Result<Self, Error> {
        for sample in &mut self.samples {
            *sample = of(*sample);
        }
        self.checked()
    }

    /// The places of the samples that [`Record::between`] keeps.
    ///
    /// # Errors
    /// Where the times are not finite, or are not in order.
    pub fn places_between(&self, from: F, to: F) -> Result<Range<usize>, Error> {
        positive(Quantity::Duration, finite(Quantity::Time, to)? - finite(Quantity::Time, from)?)?;
        let of_decimals = F::exp2i(-48).or_larger(F::epsilon() * F::int(16));
        let same = self.time(0).abs().or_larger(self.end().abs()) * of_decimals;
        let places = 0..self.samples.len();
        let first = places.clone().take_while(|&i| self.time(i) < from - same).count();
        let end = places.take_while(|&i| self.time(i) <= to + same).count();
        Ok(first..end.max(first))
    }

    /// The longest step.
    pub fn longest_step(&self) -> F {
        match &self.times {
            Times::Equal(_, step) => *step,
            Times::Each(times) => {
                let ends = times.iter().skip(1);
                ends.zip(times).fold(F::int(0), |most, (&end, &start)| most.or_larger(end - start))
            }
        }
    }
}

fn in_sample(index: usize, error: Error) -> Error {
    Error::InSample { index, error: Box::new(error) }
}

/// The force per mass that a sample stands for: `sample · factor`, and the change of the sample over the step times
/// `per_change`/step.
#[derive(Debug, Clone, Copy)]
pub(super) struct Factors<F> {
    pub(super) factor: F,
    /// c/m where the damper stands on the moving support, else 0.
    pub(super) damper: F,
}

impl<F: Number> Factors<F> {
    pub(super) fn new(excitation: Excitation, mass: F, constants: &Constants<F>) -> Self {
        let factor = match excitation {
            Excitation::Force | Excitation::Unbalance => F::int(1) / mass,
            Excitation::FootMotion | Excitation::DampedFootMotion => constants.square,
            Excitation::SurfaceAcceleration | Excitation::SurfaceMotion | Excitation::SurfaceVelocity => {
                F::int(-1)
            }
        };
        let is_on_foot = excitation == Excitation::DampedFootMotion;
        Self { factor, damper: if is_on_foot { constants.rate } else { F::int(0) } }
    }

    /// The load after a record with this last sample.
    pub(super) fn after(&self, after: After, last: F) -> F {
        match after {
            After::Zero | After::Free => F::int(0),
            After::Hold => last * self.factor,
        }
    }
}

/// One step of a load per mass: its length, its values at both ends, and its slope.
#[derive(Debug, Clone, Copy)]
pub(super) struct Piece<F> {
    pub(super) length: F,
    pub(super) from: F,
    pub(super) to: F,
    pub(super) slope: F,
    /// 2βu′ of a support on which the damper stands, else 0: a part of the load.
    pub(super) foot: F,
}

impl<F: Number> Piece<F> {
    /// The step between two samples; `inverse` is 1 over its length.
    #[inline(always)]
    pub(super) fn new(factors: &Factors<F>, [first, second]: [F; 2], length: F, inverse: F) -> Self {
        let slope = (second - first) * inverse;
        let (from, to) = (first * factors.factor, second * factors.factor);
        // The damper on the support carries the velocity of the support, which is constant over the step.
        let foot = factors.damper * slope;
        Self { length, from: from + foot, to: to + foot, slope: slope * factors.factor, foot }
    }

    /// A constant load.
    pub(super) fn constant(load: F, length: F) -> Self {
        let zero = F::int(0);
        Self { length, from: load, to: load, slope: zero, foot: zero }
    }

    /// The work 2βu′² of the damper in the step, were the body at rest; β > 0.
    pub(super) fn work_at_rest(&self, constants: &Constants<F>) -> F {
        self.foot.square() / constants.rate * self.length
    }
}
