//! Guaranteed answers: every output as a midpoint and a radius that contain it, rounding included.
//!
//! [`KnownRatios::steady`] proves that a periodic motion with its stops exists (`motion`).
//! [`KnownRatios::response`] evaluates the closed forms in ball arithmetic (`float::ball`), by the functions that [`crate::Cycle`] and
//! [`crate::Border`] call. Ratios are exact rational numbers or intervals ([`Known`]): `0.4` is four tenths,
//! not the nearest double. Quantities that are found by iteration elsewhere (the peak velocity, the
//! stationary point of the border's condition) are enclosed here as the only zero of their equation in a
//! ball, by the interval Newton method (`root`).
//!
//! **Decisions.** A ball may be too wide to tell on which side of the border a force ratio lies. All
//! quantities are then recomputed with twice the bits, up to [`MAX_BITS`]; a question that remains undecided
//! there gives `None`, never a guess. With exact ratios, each output is as sharp as the requested bits.
//! Intervals are cut into parts, until the hull of each output is at most 5/4 of its range or there are too many parts (`split`).
//!
//! **What the guarantee rests on.** The balls contain the values of the formulae by virtue of MPFR and the
//! bounds of `float::ball`. That the formulae are those of the oscillator is shown in `docs/development/proof.md`.
//!
//! | file | content |
//! |---|---|
//! | `known` | ratios as they are known |
//! | `angle` | π/2Ω reduced, K(Ω) |
//! | `border` | the exact border without damping |
//! | `cycle` | the cycle of two reversals |
//! | `damped` | half a period of the drive; the border with damping |
//! | `greatest` | the greatest value of a function, proved |
//! | `motion` | the exact motion, stops included, proved to exist |
//! | `ratios` | the ratios of one question |
//! | `record` | the motion under a record ([`follow`]) |
//! | `root` | the only zero of a function in a ball, if it is proved |
//! | `split` | intervals cut into parts |
//! | `widen` | more bits until the answers are sharp |
//!
//! ```
//! use stickslip::Output;
//! use stickslip::enclosed::KnownRatios;
//! let found = KnownRatios::new(&"0.4".parse()?).with_force_ratio(&"9".parse()?).response(128)?;
//! let velocity = found.get(Output::MaxVelocity).unwrap();
//! assert_eq!(velocity.to_string(), "13.6968608268773571362677089591797754027 ± 3.9e-38");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub(crate) mod angle;
pub(crate) mod border;
pub(crate) mod cycle;
pub(crate) mod damped;
mod enclosure;
mod greatest;
mod known;
mod motion;
mod ratios;
mod record;
mod regime;
pub(crate) mod root;
pub(crate) mod split;
mod widen;

pub use enclosure::Enclosure;
pub use known::Known;
pub use motion::{Event, Steady, Unproved};
pub use ratios::KnownRatios;
pub use record::follow;
pub use regime::Regime;
// The arithmetic in which the command checks the equations.
#[doc(hidden)]
pub use {
    crate::float::ball::Ball,
    widen::{InBalls, PRECISIONS, with_more_bits},
};

use crate::cycle::damped::best_of;
use crate::cycle::regime::sliding_bound;
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::machine::error::{Error, Quantity};
use crate::machine::excitation::Excitation;
use crate::machine::ratios::{valid_damping_ratio, valid_static_friction_ratio, within};
use crate::machine::support::Support;
use crate::output::Output;
use angle::Angle;
use border::Border;
use widen::{Answers, sharpest};

/// The greatest number of bits used in a computation.
pub const MAX_BITS: u32 = widen::GREATEST;

/// The answers at ratios that are exact or lie in intervals.
#[derive(Debug, Clone)]
#[non_exhaustive]
pub struct Response {
    /// The regime; `None` where it is undecided at these [`bits`](Response::bits).
    pub regime: Option<Regime>,
    /// Whether a body at rest is released at any position, α > η; `None`
    /// where the intervals do not decide it, or without an α.
    pub moves_from_rest: Option<bool>,
    /// The number of bits of the final computation.
    pub bits: u32,
    values: Vec<(Output, Enclosure)>,
}

impl Response {
    /// An output; `None` where it does not exist, is undecided, or has no enclosure here.
    ///
    /// Outputs of the cycle exist where the cycle certainly exists: where the regime is
    /// [`Regime::NonSticking`], or [`Regime::DependsOnStart`] away from Ω = 1 without a damper. A phase may
    /// lie outside [0, 2π) by up to the width of its ball.
    #[must_use]
    pub fn get(&self, output: Output) -> Option<&Enclosure> {
        self.values.iter().find(|(name, _)| *name == output).map(|(_, value)| value)
    }
}

/// The response under an excitation for a single output, without the expensive parts of the others.
pub(crate) fn response_for(
    only: Output,
    ratios: &KnownRatios,
    excitation: Option<Excitation>,
    bits: u32,
) -> Result<Response, Error> {
    let wanted = |output| output == only;
    let asked = AskedRatios { wanted: &wanted, excitation, ..AskedRatios::new(ratios)? };
    sharpest(&asked, valid(bits)?).map(|found| asked.response(found))
}

fn valid(bits: u32) -> Result<u32, Error> {
    let (least, greatest) = (1.0, f64::from(MAX_BITS - 64));
    within(Quantity::Precision, f64::from(bits), least, greatest).map(|_| bits)
}

/// The data of one computation: Ω, and α if there is one.
struct AskedRatios<'a> {
    omega: &'a Known,
    alpha: Option<&'a Known>,
    zeta: &'a Known,
    eta: &'a Known,
    excitation: Option<Excitation>,
    /// Whether an output is requested, if it takes a search.
    wanted: &'a dyn Fn(Output) -> bool,
}

impl<'a> AskedRatios<'a> {
    /// The data, with ratios in their domains.
    fn new(ratios: &'a KnownRatios) -> Result<Self, Error> {
        let (zeta, eta) = (&ratios.damping_ratio, &ratios.static_friction_ratio);
        let alpha =
            ratios.alpha.as_ref().map(|alpha| alpha.within(Quantity::ForceRatio, false)).transpose()?;
        let omega = ratios.omega.within(Quantity::FrequencyRatio, true)?;
        for end in [zeta.low(), zeta.high()] {
            valid_damping_ratio(Mp::<2>::from_rational(end))?;
        }
        for end in [eta.low(), eta.high()] {
            valid_static_friction_ratio(Mp::<2>::from_rational(end))?;
        }
        Ok(Self { omega, alpha, zeta, eta, excitation: None, wanted: &|_| true })
    }

    /// All answers; over intervals by parts of them.
    fn answered(&self, bits: u32) -> Result<Response, Error> {
        let bits = valid(bits)?;
        let side = |known: &Known| (known.low().clone(), known.high().clone());
        let whole = [self.omega, self.zeta, self.eta].into_iter().chain(self.alpha).map(side).collect();
        let over = |part: &[split::Ends], done: &[Output]| {
            let mut sides = part.iter().map(|(low, high)| Known::of_ends(low.clone(), high.clone()));
            let mut next = |whole: &Known| sides.next().unwrap_or_else(|| whole.clone());
            let (omega, zeta, eta) = (next(self.omega), next(self.zeta), next(self.eta));
            let alpha = self.alpha.map(next);
            let wanted = |output| !done.contains(&output);
            let part = AskedRatios {
                omega: &omega,
                alpha: alpha.as_ref(),
                zeta: &zeta,
                eta: &eta,
                wanted: &wanted,
                ..*self
            };
            sharpest(&part, bits)
        };
        split::over_parts(whole, bits, over).map(|found| self.response(found))
    }

    fn response(&self, found: Answers) -> Response {
        Response {
            regime: found.regime,
            moves_from_rest: self.moves_from_rest(),
            bits: found.bits,
            values: found.values,
        }
    }

    fn moves_from_rest(&self) -> Option<bool> {
        let alpha = self.alpha?;
        let (moves, stays) = (alpha.low() > self.eta.high(), alpha.high() <= self.eta.low());
        (moves || stays).then_some(moves)
    }

    fn is_undamped(&self) -> bool {
        *self.zeta.high() == 0
    }
}

impl InBalls for AskedRatios<'_> {
    type Found = Answers;

    fn run<const W: usize>(&self) -> Answers {
        let angle = Angle::<W>::new(self.omega);
        let half = damped::half_period(&angle, self.zeta, self.eta);
        let (border, best) = if self.is_undamped() {
            (Border::at(&angle, self.eta), (angle.best_force_ratio(), angle.best_loop_size()))
        } else {
            (damped::border::border(&half), best_of(&half))
        };
        let mut values: Vec<(Output, Option<Ball<W>>)> = vec![
            (Output::MinForceRatio, Some(border.min_force_ratio)),
            (Output::MinForceRatioTurningPoint, Some(border.turning_point)),
            (Output::LeastDisplacement, Some(border.least_displacement)),
            (Output::BorderPhase, border.phase),
            (Output::BestForceRatio, Some(best.0)),
            (Output::BestLoopSize, Some(best.1).filter(|size| !size.is_entire())),
        ];
        let Some(alpha) = self.alpha else {
            return Answers::new(None, values, self.is_exact(), true);
        };
        let ball = alpha.ball::<W>();
        values.push((Output::Margin, Some(ball / border.min_force_ratio)));
        let regime = self.regime(alpha, &ball, &border, self.is_undamped() && angle.is_pole());
        let mut is_decided = regime.is_some();
        let exists = match regime {
            Some(Regime::NonSticking) => true,
            Some(Regime::DependsOnStart) => self.is_bounded(),
            _ => false,
        };
        if exists {
            let support = Support {
                excitation: self.excitation,
                omega: half.omega,
                alpha: ball,
                damping_ratio: half.free.zeta,
            };
            let found = cycle::outputs(&angle, half, &support, self.wanted);
            // For exact ratios, more bits find every output; over intervals some may never be found.
            is_decided = !self.is_exact() || found.iter().all(|(_, value)| value.is_some());
            values.extend(found);
        }
        Answers::new(regime, values, self.is_exact(), is_decided)
    }
}

impl AskedRatios<'_> {
    fn is_exact(&self) -> bool {
        let others = [self.omega, self.zeta, self.eta];
        others.into_iter().all(Known::is_exact) && self.alpha.is_none_or(Known::is_exact)
    }

    /// The regime, where the balls do not overlap.
    fn regime<const W: usize>(
        &self,
        alpha: &Known,
        ball: &Ball<W>,
        border: &Border<W>,
        is_pole: bool,
    ) -> Option<Regime> {
        if *alpha.high() <= 1 {
            return Some(Regime::Stuck);
        }
        if *alpha.low() <= 1 {
            return None;
        }
        if is_pole || ball.is_below(&border.min_force_ratio) {
            return Some(Regime::BelowBorder);
        }
        if !border.min_force_ratio.is_below(ball) {
            return None;
        }
        let is_bounded = self.is_bounded();
        if !(is_bounded || self.omega.is_exact() && self.is_undamped()) {
            return None;
        }
        let without_stop = if is_bounded { Regime::NonSticking } else { Regime::Unbounded };
        let eta = self.eta.ball::<W>();
        let from_every_start = *self.eta.high() == 1
            || if is_bounded {
                let bound = || sliding_bound(self.omega.ball(), self.zeta.ball(), eta);
                *self.zeta.low() > 0 && bound().is_below(ball)
            } else {
                (Ball::int(4) * eta / Ball::pi()).is_below(ball)
            };
        Some(if from_every_start { without_stop } else { Regime::DependsOnStart })
    }

    /// Whether no motion grows without bound.
    fn is_bounded(&self) -> bool {
        *self.zeta.low() > 0 || *self.omega.low() > 1 || *self.omega.high() < 1
    }
}
