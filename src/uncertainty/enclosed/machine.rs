//! Ranges over a box of machines.

use super::parts::{self, Ends, Over};
use super::verdict;
use super::{ends, guaranteed, over, response};
use crate::cycle::regime::{Regime, Verdict};
use crate::enclosed::{Enclosure, Known};
use crate::float::ball::Ball;
use crate::float::{Field, Float};
use crate::machine::error::Error;
use crate::machine::excitation::Excitation;
use crate::machine::oscillator::Scales;
use crate::output::Output;
use crate::uncertainty::{Interval, Parameters, Range};
use rug::Rational;

/// A ball precise enough that rounding the parameters does not widen it.
type B = Ball<4>;

impl<F: Float> Parameters<Interval<F>> {
    /// [`crate::uncertainty::ParameterBox::enclosed`].
    pub(in crate::uncertainty) fn enclosed(
        &self,
        output: Output,
        pieces: u32,
    ) -> Result<Option<Range<F>>, Error> {
        let whole: Option<Vec<Ends>> = self.intervals().into_iter().map(ends).collect();
        let Some(mut whole) = whole else { return Ok(None) };
        // The border does not depend on the amplitude.
        if !(output.is_of_cycle() || matches!(output, Output::Margin | Output::BestLoopSize))
            && let Some((low, high)) = whole.get_mut(AMPLITUDE)
        {
            high.clone_from(low);
        }
        let found = parts::range(whole, pieces, |part| self.over_part(output, part))?;
        Ok(found.map(guaranteed))
    }

    /// As `RatioBox::enclosed_verdict`, of the parameters themselves, which may occur in more than one ratio.
    pub(in crate::uncertainty) fn enclosed_verdict(&self, pieces: u32) -> Result<Verdict<F>, Error> {
        let whole: Option<Vec<Ends>> = self.intervals().into_iter().map(ends).collect();
        let ratios = whole.as_deref().and_then(|parts| MachineEnds::of(parts, self.excitation)?.ratios());
        let Some([omega, alpha, zeta]) = ratios else {
            return Ok(Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
        };
        verdict::by_margin([&omega, &alpha, &zeta], || {
            parts::is_above_one(whole.unwrap_or_default(), pieces, |part| {
                self.over_part(Output::Margin, part)
            })
        })
    }

    /// The values of an output in physical units over a part of the box.
    fn over_part(&self, output: Output, part: &[Ends]) -> Result<Over, Error> {
        let Some(machine) = MachineEnds::of(part, self.excitation) else { return Ok(Over::Undecided) };
        let Some([omega, alpha, zeta]) = machine.ratios() else { return Ok(Over::Undecided) };
        let found = response(output, [&omega, &alpha, &zeta], Some(self.excitation))?;
        let unit = output.unit(&machine.scales());
        Ok(over(output, &found, |value| physical(value, unit)))
    }
}

/// The index of the amplitude among the parameters.
const AMPLITUDE: usize = 3;

/// m, k, r_y, the amplitude, ω_d and c in intervals.
struct MachineEnds<'a> {
    mass: &'a Ends,
    stiffness: &'a Ends,
    friction: &'a Ends,
    /// The amplitude p₀ of the force.
    force: Ends,
    frequency: &'a Ends,
    damping: &'a Ends,
}

impl<'a> MachineEnds<'a> {
    fn of(part: &'a [Ends], excitation: Excitation) -> Option<Self> {
        let [mass, stiffness, friction, amplitude, frequency, damping] = part else { return None };
        let at = |end: fn(&Ends) -> &Rational| {
            let [amplitude, frequency, mass, stiffness, damping] =
                [amplitude, frequency, mass, stiffness, damping].map(|x| point(end(x)));
            excitation.force_amplitude(amplitude, frequency, [mass, stiffness, damping])
        };
        let force = if excitation == Excitation::Force {
            amplitude.clone()
        } else {
            (at(|(low, _)| low).lower().to_rational()?, at(|(_, high)| high).upper().to_rational()?)
        };
        Some(Self { mass, stiffness, friction, force, frequency, damping })
    }

    /// `Ω = ω_d √(m/k)`, `α = p₀/r_y` and `ζ = c/(2√(km))`.
    fn ratios(&self) -> Option<[Ends; 3]> {
        let square = over_positive(self.mass, self.stiffness);
        let root = |x: &Ends| -> Option<Ends> {
            let (low, high) = (point(&x.0), point(&x.1));
            Some((low.sqrt().lower().to_rational()?, high.sqrt().upper().to_rational()?))
        };
        let omega = times(self.frequency, &root(&square)?);
        let zeta = if self.damping.1 == 0 {
            self.damping.clone()
        } else {
            let (low, high) = over_positive(self.damping, &root(&times(self.stiffness, self.mass))?);
            (low / 2u32, high / 2u32)
        };
        Some([omega, over_positive(&self.force, self.friction), zeta])
    }

    /// The scales of the answers, as in [`Scales::new`].
    fn scales(&self) -> Scales<B> {
        let length = over_positive(self.friction, self.stiffness);
        let static_energy = |stiffness: &Ends| {
            let energy = over_positive(&times(&self.force, &self.force), stiffness);
            ball(&(energy.0 / 2u32, energy.1 / 2u32))
        };
        let inertia = times(self.mass, &times(self.frequency, self.frequency));
        Scales {
            length: ball(&length),
            velocity: ball(&times(&length, self.frequency)),
            time: B::int(1) / ball(self.frequency),
            force: ball(self.friction),
            energy_stiffness: static_energy(self.stiffness),
            energy_inertia: static_energy(&inertia),
            mean_displacement: B::int(0),
            mean_friction: B::int(0),
        }
    }
}

fn ball(x: &Ends) -> B {
    Known::of_ends(x.0.clone(), x.1.clone()).ball()
}

fn point(x: &Rational) -> B {
    ball(&(x.clone(), x.clone()))
}

/// The product of two intervals of nonnegative numbers.
fn times(a: &Ends, b: &Ends) -> Ends {
    ((&a.0 * &b.0).into(), (&a.1 * &b.1).into())
}

/// The quotient of an interval of nonnegative numbers and one of positive numbers.
fn over_positive(a: &Ends, b: &Ends) -> Ends {
    ((&a.0 / &b.1).into(), (&a.1 / &b.0).into())
}

/// The ends of an enclosed value in physical units.
fn physical(value: &Enclosure, unit: B) -> Option<Ends> {
    let (low, high) = value.ends()?;
    let found = ball(&(low, high)) * unit;
    Some((found.lower().to_rational()?, found.upper().to_rational()?))
}
