//! The parameters of a machine by their names, and the boxes of them.

use super::ratios::RatioBox;
use super::{Interval, Range};
use crate::cycle::regime::Verdict;
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::oscillator::{Drive, Excitation, Oscillator};
use crate::output::Output;

/// A machine and its drive by named values: intervals in a [`ParameterBox`], numbers in a draw of
/// `MonteCarlo`.
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Parameters<T> {
    /// The kind of the excitation.
    pub excitation: Excitation,
    /// Mass m > 0.
    pub mass: T,
    /// Stiffness k > 0.
    pub stiffness: T,
    /// Friction force r_y > 0.
    pub friction_bound: T,
    /// Amplitude > 0 of the excitation: p₀ of a force, the unbalance, or the amplitude of the motion.
    pub amplitude: T,
    /// Angular frequency ω_d > 0.
    pub angular_frequency: T,
    /// Damping constant c ≥ 0; 0 without a damper.
    pub damping: T,
}

impl<F: Float> Parameters<F> {
    /// The machine with these parameters.
    pub(super) fn machine(&self) -> Result<(Oscillator<F>, Drive<F>), Error> {
        let body =
            Oscillator::new(self.mass, self.stiffness, self.friction_bound)?.with_damping(self.damping)?;
        Ok((body, Drive::new(self.excitation, self.amplitude, self.angular_frequency)?))
    }
}

/// Independent intervals of the parameters: of the ratios, for dimensionless answers, or of a machine, for answers in
/// its units. Static friction is the kinetic one.
///
/// ```
/// use stickslip::uncertainty::{Interval, ParameterBox};
/// use stickslip::{Output, Regime, Verdict};
/// let ratios = |omega, damping_ratio| ParameterBox::Ratios { omega, alpha: Interval::exactly(2.0), damping_ratio };
/// let undamped = ratios(Interval { low: 0.7, high: 0.75 }, Interval::exactly(0.0));
/// assert_eq!(undamped.verdict()?, Verdict::NonSticking);
/// let peak = undamped.range(Output::MaxDisplacement, 1000)?.unwrap(); // in r_y/k
/// assert!(peak.is_guaranteed() && 3.4 < peak.low && peak.high < 4.2);
/// let wide = ratios(Interval { low: 0.4, high: 0.75 }, Interval::exactly(0.0));
/// assert_eq!(wide.verdict()?, Verdict::Undecided(Regime::Sticking, Regime::NonSticking));
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(rename_all = "kebab-case", bound(deserialize = "F: Float + serde::Deserialize<'de>"))
)]
#[must_use]
pub enum ParameterBox<F> {
    /// The ratios of the domain of [`crate::Ratios`].
    Ratios {
        /// The frequency ratio Ω.
        omega: Interval<F>,
        /// The force ratio α.
        alpha: Interval<F>,
        /// The damping ratio ζ; exactly 0 without a damper.
        damping_ratio: Interval<F>,
    },
    /// A machine and its drive.
    Machine(Parameters<Interval<F>>),
}

/// The answers about all parameters of a box.
///
/// # Errors
/// Where an interval is empty or an end of it is not valid: a ratio outside the domain of [`crate::Ratios`], a parameter of a machine
/// that is not finite or has the wrong sign, or a ratio or scale of a machine that overflows or underflows.
impl<F: Float> ParameterBox<F> {
    /// The smallest box of ratios with those of all parameters of this box: Ω = ω_d √(m/k), α = p₀/r_y,
    /// ζ = c/(2√(km)), each monotone in each parameter.
    ///
    /// Its ends are attained. A parameter of a machine may occur in more than one ratio, so that not all of the box is
    /// attained. The box is widened by the possible rounding of the formulae.
    ///
    /// # Errors
    /// Where an interval is empty or an end of it is not valid, or a ratio leaves the domain of [`crate::Ratios`].
    pub fn ratios(&self) -> Result<Self, Error> {
        let RatioBox { omega, alpha, damping_ratio } = match self.checked()? {
            Checked::Ratios(ratios) => ratios,
            Checked::Machine(machine) => machine.ratios()?,
        };
        Ok(Self::Ratios { omega, alpha, damping_ratio })
    }

    /// The verdict that holds for the whole box; [`Verdict::sticks`] says whether the body sticks.
    ///
    /// With damping it needs the feature `mp`, and takes some tenths of a second: it follows from the margin in ball
    /// arithmetic, where need be over 1000 parts of the box. Without the feature the verdict is undecided where α
    /// exceeds 1. Of an undamped machine whose α depends on the stiffness, mass or frequency, a box that is only just
    /// decided may be called undecided ([`ParameterBox::ratios`]).
    ///
    /// **Proved** with damping: where the margin is above 1 throughout, the body never stops; where it is below, there is
    /// no cycle of two reversals without a stop. **Searched:** that the body then stops, as in [`Verdict::Sticking`]. The
    /// verdict is undecided where a cycle of six reversals may exist (next to a pole, with little damping), where the box
    /// would need more parts, and where it contains Ω = 1 without damping, so that the motion is unbounded.
    ///
    /// # Errors
    /// As [`ParameterBox::ratios`].
    ///
    /// ```
    /// # #[cfg(feature = "mp")] {
    /// use stickslip::uncertainty::{Interval, ParameterBox, Parameters};
    /// use stickslip::{Excitation, Verdict};
    /// // Friction known to ±5 %, a damper to ±20 %.
    /// let (friction_bound, damping) = (Interval::relative(5.0, 0.05), Interval::relative(20.0, 0.2));
    /// let machine = |force| ParameterBox::Machine(Parameters {
    ///     excitation: Excitation::Force,
    ///     mass: Interval::exactly(50.0),
    ///     stiffness: Interval::exactly(1000.0),
    ///     friction_bound,
    ///     amplitude: Interval::exactly(force),
    ///     angular_frequency: Interval::exactly(6.0),
    ///     damping,
    /// });
    /// assert_eq!(machine(12.0).verdict()?, Verdict::NonSticking);
    /// assert_eq!(machine(5.5).verdict()?, Verdict::Sticking);
    /// # }
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    pub fn verdict(&self) -> Result<Verdict<F>, Error> {
        match self.checked()? {
            Checked::Ratios(ratios) => ratios.verdict(),
            Checked::Machine(machine) => machine.verdict(),
        }
    }

    /// The range of an output over the box, dimensionless for a box of ratios, otherwise in physical units
    /// ([`Output::unit`]); `None` where the output exists at none of the points tried.
    ///
    /// Without damping, the range of ratios is guaranteed for Δ₀, A₁, A₂, the border, the margin and α*, and for V₀ at a
    /// single Ω; that of a machine for Δ₀, the energy of a cycle (both loop sizes), the minimum force and the margin (see
    /// the module's documentation). It is sampled for all other outputs, with damping, and for outputs of the cycle where
    /// the body may stick or the box contains Ω = 1. `points` is the number of points or of pieces.
    ///
    /// # Errors
    /// As [`ParameterBox::ratios`], and where a scale overflows or underflows.
    pub fn range(&self, output: Output, points: u32) -> Result<Option<Range<F>>, Error> {
        match self.checked()? {
            Checked::Ratios(ratios) => ratios.range(output, points),
            Checked::Machine(machine) => machine.range(output, points),
        }
    }

    /// The range of any output over the box, with its damper, proved in ball arithmetic. It assumes neither a measured
    /// accuracy of the formulae nor that an output is monotone. `None` where the output does not exist in
    /// some part of the box, or where that is undecided.
    ///
    /// The box is cut into at most `pieces` parts, preferably at the ends of the range, and each part is
    /// enclosed as by [`KnownRatios::response`](crate::enclosed::KnownRatios::response). The range exceeds the sharp
    /// one, by less the more parts there are. A part takes about a millisecond, or tens of milliseconds for the peak
    /// acceleration below Ω = 1/2. A phase may lie outside [0, 2π) by the width of its range.
    ///
    /// The body sticks nowhere in the box if the range of the margin is above 1.
    ///
    /// # Errors
    /// As [`ParameterBox::ratios`].
    ///
    /// ```
    /// use stickslip::Output;
    /// use stickslip::uncertainty::{Interval, ParameterBox};
    /// let ratios = ParameterBox::Ratios {
    ///     omega: Interval { low: 0.7, high: 0.72 },
    ///     alpha: Interval::exactly(2.0),
    ///     damping_ratio: Interval::exactly(0.0),
    /// };
    /// let phase = ratios.enclosed(Output::VelocityPhase, 100)?.unwrap();
    /// assert!(phase.is_guaranteed() && 0.71 < phase.low && phase.high < 0.83);
    /// assert!(ratios.enclosed(Output::Margin, 100)?.unwrap().low > 1.0);
    /// # Ok::<(), stickslip::Error>(())
    /// ```
    #[cfg(feature = "mp")]
    pub fn enclosed(&self, output: Output, pieces: u32) -> Result<Option<Range<F>>, Error> {
        match self.checked()? {
            Checked::Ratios(ratios) => ratios.enclosed(output, pieces),
            Checked::Machine(machine) => machine.enclosed(output, pieces),
        }
    }

    /// This box, if its ends are valid.
    fn checked(self) -> Result<Checked<F>, Error> {
        Ok(match self {
            Self::Ratios { omega, alpha, damping_ratio } => {
                Checked::Ratios(RatioBox::new(omega, alpha, damping_ratio)?)
            }
            Self::Machine(machine) => Checked::Machine(machine.checked()?),
        })
    }
}

/// A box whose ends are valid.
enum Checked<F> {
    Ratios(RatioBox<F>),
    Machine(Parameters<Interval<F>>),
}
