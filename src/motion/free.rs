//! Free vibration: no drive. In every half cycle friction reduces the amplitude by 2B, and a damper by a
//! fixed ratio.
//!
//! Displacements in units of B = r_y/k, velocities in B ω_n, time in 1/ω_n. From (x₀, v₀) the body slides
//! about ∓1, its equilibrium with friction. With d = √(1 − ζ²) the first turn is at
//!
//! ```text
//! x₁ = s (e^{−ζt₁} R − 1),   R² = y² + 2ζy|v₀| + v₀²,   y = s x₀ + 1,   s = sgn v₀,
//! tan dt₁ = d|v₀|/(y + ζ|v₀|)
//! ```
//!
//! (x₁ = x₀ where v₀ = 0), and every half cycle after it takes x to `−sgn x (κ(|x| − 1) − 1)`, κ = e^{−ζπ/d},
//! until `|x| ≤ 1`, where the body stays (with a static friction of η times the kinetic one, until |x| ≤ η).
//! Without a damper, κ = 1, that is 2B less in each. After n of them
//!
//! ```text
//! (−1)ⁿ sgn x₁ x_n = κⁿ|x₁| − (1 − κⁿ) coth(ζπ/2d),
//! ```
//!
//! and there are `n = ⌈(|x₁| − η)/2⌉` of them, or `⌈ln(1 + (|x₁| − η)(1 − κ)/(2 + (η − 1)(1 − κ))) d/ζπ⌉`.
//! From ζ = 1 on no half cycle ends: the body turns at most once; if it slides after that or does not turn,
//! it creeps to ±1 for ever.

use super::slide::equation::Equation;
use super::state::State;
use super::trajectory::Trajectory;
use crate::float::Float;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::ratios::{valid_damping_ratio, valid_static_friction_ratio};
#[cfg(not(feature = "std"))]
use num_traits::Float as _;

/// Free vibration from a start, to rest.
///
/// ```
/// use stickslip::motion::FreeDecay;
/// let decay = FreeDecay::new(12.0f64, 6.0, 0.0, 1.0)?;
/// assert_eq!(decay.half_cycles, 8);
/// assert!((decay.rest_position - (15.0 - 205f64.sqrt())).abs() < 1e-14);
/// let damped = FreeDecay::new(12.0f64, 6.0, 0.05, 1.0)?;
/// assert_eq!(damped.half_cycles, 6);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(
        try_from = "crate::serialized::FreeDecayFields<F>",
        bound(deserialize = "F: Float + serde::Deserialize<'de>")
    )
)]
#[non_exhaustive]
#[must_use]
pub struct FreeDecay<F> {
    /// Displacement of the first turn, x₁/B; if the body creeps without a turn, the limit of the creep.
    pub first_turn: F,
    /// The number of half cycles of sliding: velocity zeros until rest, counted from the start. The first one
    /// is only a part of a half cycle if v₀ ≠ 0. A creep that never ends counts as one.
    pub half_cycles: u64,
    /// Displacement x/B at rest, or the limit of a creep. Accuracy at f64: that of x₁, half a unit in its
    /// last place without damping, a few units of max(|x₁|, 1) with it.
    pub rest_position: F,
    /// The time until rest, in 1/ω_n: the time of the first half cycle, and π/√(1 − ζ²) for each other. It is
    /// infinite for a creep, with ζ ≥ 1.
    pub rest_time: F,
    start: State<F>,
    zeta: F,
    eta: F,
    /// The time of the first turn; infinite where there is none.
    first_time: F,
    /// The half cycles after the first turn.
    turns: F,
}

impl<F: Float> FreeDecay<F> {
    /// The state from which the vibration begins.
    #[cfg(feature = "serde")]
    pub(crate) const fn start(&self) -> State<F> {
        self.start
    }

    /// Damping ratio ζ.
    #[cfg(feature = "serde")]
    pub(crate) const fn damping_ratio(&self) -> F {
        self.zeta
    }

    /// Static friction ratio η.
    #[cfg(feature = "serde")]
    pub(crate) const fn static_friction_ratio(&self) -> F {
        self.eta
    }

    /// Free vibration from the displacement x₀/B and the velocity v₀/(Bω_n), with the damping ratio ζ (0
    /// without a damper) and a static friction of η ≥ 1 times the kinetic one (1 for one friction).
    ///
    /// # Errors
    /// Where x₀ or v₀ is not finite or so large that the half cycles cannot be counted (more than 2ᵖ⁻¹ of
    /// them, p = [`Float::PRECISION`], and more than 2⁶¹ at any precision), ζ is neither 0 nor within `[2⁻ᵉ, 2²⁰]`,
    /// e = [`Float::RATIO_EXPONENT`], or η is not within `[1, 2²⁰]`.
    pub fn new(x: F, v: F, damping_ratio: F, static_friction_ratio: F) -> Result<Self, Error> {
        let start = State::new(F::int(0), x, v)?;
        let eta = valid_static_friction_ratio(static_friction_ratio)?;
        crate::machine::ratios::within(Quantity::StaticFrictionRatio, eta, F::int(1), F::exp2i(20))?;
        let (zero, one, two) = (F::int(0), F::int(1), F::int(2));
        let zeta = valid_damping_ratio(damping_ratio)?;
        if zeta > zero {
            crate::machine::ratios::within(Quantity::DampingRatio, zeta, F::least_ratio(), F::exp2i(20))?;
        }
        let mut found = Self {
            first_turn: x,
            half_cycles: 0,
            rest_position: x,
            rest_time: zero,
            start,
            zeta,
            eta,
            first_time: zero,
            turns: zero,
        };
        if v != zero {
            (found.first_turn, found.first_time) = found.turning();
        }
        let excess = found.first_turn.abs() - eta;
        if excess > zero && found.first_time.is_finite() {
            found.turns = if zeta == zero {
                // ⌈y⌉ = −⌊−y⌋
                -((-excess / two).floor())
            } else if zeta < one {
                found.damped_turns(excess)
            } else {
                one
            };
        }
        // Above this limit the half cycles cannot be counted, and the place of rest is rounding.
        let most = F::exp2i(i32::try_from(F::precision().min(62)).unwrap_or(62));
        if found.turns * two > most {
            let (quantity, far) =
                if v.abs() > x.abs() { (Quantity::Velocity, v) } else { (Quantity::Displacement, x) };
            let most = most / two;
            return Err(Error::OutOfRange {
                quantity,
                value: written(far),
                least: written(-most),
                greatest: written(most),
            });
        }
        found.half_cycles = found.counted();
        found.rest_position = found.resting();
        found.rest_time = found.time();
        Ok(found)
    }

    /// The time in 1/ω_n and the displacement x/B of the nth turning point, from 0 on; the start is one where it has no
    /// velocity, and the last is where the body rests. `None` after it, and in a creep.
    pub fn turning_point(&self, n: u64) -> Option<(F, F)> {
        let (one, turns) = (F::int(1), F::from_f64(n as f64));
        if turns > self.turns || !self.first_time.is_finite() {
            return None;
        }
        if n == 0 {
            return Some((self.first_time, self.first_turn));
        }
        let half = F::pi() / ((one - self.zeta) * (one + self.zeta)).sqrt();
        let (left, is_opposite) = (self.left_after(turns), (n % 2 == 1) != (self.first_turn < F::int(0)));
        let x = F::int(0) + if is_opposite { -left } else { left };
        (self.zeta < one).then(|| (self.first_time + turns * half, x))
    }

    /// The path of the body to its rest, or to the limit of a creep, in B.
    ///
    /// Half a cycle from x to `−κ(x − 1) + 1` is `(1 + κ)(x − 1)` long, x > 1, so that n of them after the first turn are
    /// `2n(|x₁| − n)` without a damper. With one, up to 4,096 half cycles are summed. More of them are
    /// `(1 + κ)(Σ − n)`, `Σ = (|x₁| − |x_n| − n(1 + κ))/(1 − κ)`, or the first two terms of its power series.
    /// Accuracy: some units in the last place, and for more than 4,096 damped half cycles two thirds of the digits.
    pub fn path(&self) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let first = (self.first_turn - self.start.x).abs();
        if !self.first_time.is_finite() {
            return (self.rest_position - self.start.x).abs();
        }
        if self.turns == F::int(0) {
            return first;
        }
        if self.zeta >= one {
            return first + (self.rest_position - self.first_turn).abs();
        }
        let (n, reach) = (self.turns, self.first_turn.abs());
        if self.zeta == F::int(0) {
            return first + two * n * (reach - n);
        }
        if n <= F::int(SUMMED) {
            let (mut sum, mut turn, mut left) = (first, F::int(0), reach);
            while turn < n {
                turn = turn + one;
                let next = self.left_after(turn);
                (sum, left) = (sum + (left + next), next);
            }
            return sum;
        }
        let decrement = self.decrement();
        let share = -(-decrement).exp_m1();
        let both = two - share;
        let total = if (decrement * n) * (decrement * n) * (decrement * n) > F::epsilon() {
            (reach - self.left_after(n) - n * both) / share
        } else {
            let linear = n * reach - n * (n - one);
            let bent = n * (n - one) * (reach - (two * n - one) / F::int(3)) / two;
            linear - decrement * bent
        };
        first + both * (total - n)
    }

    /// Where and when a body with a velocity turns first.
    fn turning(&self) -> (F, F) {
        let (one, two) = (F::int(1), F::int(2));
        let (x, v, zeta) = (self.start.x, self.start.v, self.zeta);
        let sign = one.with_sign_of(v);
        let (speed, y) = (sign * v, sign * x + one);
        let square = (one - zeta) * (one + zeta);
        let d = square.abs().sqrt();
        let slowed = y + zeta * speed;
        let time = if square > F::int(0) {
            (d * speed).atan2(slowed) / d
        } else if slowed <= d * speed {
            // The limit of a creep.
            return (-sign, one / F::int(0));
        } else if d == F::int(0) {
            speed / slowed
        } else {
            // artanh(d|v₀|/(y + ζ|v₀|))/d
            ln_1p(two * d * speed / (slowed - d * speed)) / (two * d)
        };
        // R² = (d v₀)² + (y + ζ|v₀|)². Above ζ = 1, d² < 0 and R² = (y + |v₀|/μ)(y + μ|v₀|), μ = ζ + |d|.
        let reach = if square > F::int(0) {
            (d * speed).hypot(slowed)
        } else {
            let fast = zeta + d;
            ((y + speed / fast) * (y + fast * speed)).sqrt()
        };
        (sign * ((-(zeta * time)).exp() * reach - one), time)
    }

    /// The logarithmic decrement of half a cycle, ζπ/d, for ζ < 1.
    fn decrement(&self) -> F {
        let one = F::int(1);
        self.zeta * F::pi() / ((one - self.zeta) * (one + self.zeta)).sqrt()
    }

    /// The displacement after `turns` half cycles, `(−1)ⁿ sgn x₁ x_n`.
    fn left_after(&self, turns: F) -> F {
        let (first, two) = (self.first_turn.abs(), F::int(2));
        if self.zeta == F::int(0) {
            return first - two * turns;
        }
        if self.zeta >= F::int(1) {
            // After the turn the body creeps to ±1 on the same side.
            return if turns > F::int(0) { -F::int(1) } else { first };
        }
        let decrement = self.decrement();
        let lost = (-(turns * decrement)).exp_m1();
        let share = (-decrement).exp_m1();
        // coth(ζπ/2d) = (1 + κ)/(1 − κ)
        first + lost * (first - (two + share) / share)
    }

    /// Number of half cycles after the first turn, ζ < 1: from the logarithm, corrected by one for its
    /// rounding.
    fn damped_turns(&self, excess: F) -> F {
        let (one, two) = (F::int(1), F::int(2));
        let decrement = self.decrement();
        // −(1 − κ)
        let share = (-decrement).exp_m1();
        let guess = ln_1p(-(excess * share / (two - (self.eta - one) * share))) / decrement;
        let mut turns = -((-guess).floor());
        if turns > one && self.left_after(turns - one) <= self.eta {
            turns = turns - one;
        }
        if self.left_after(turns) > self.eta { turns + one } else { turns.or_larger(one) }
    }

    fn counted(&self) -> u64 {
        let first = u64::from(self.start.v != F::int(0));
        (self.turns.to_f64() as u64).saturating_add(first)
    }

    fn resting(&self) -> F {
        let left = self.left_after(self.turns);
        let half = self.turns / F::int(2);
        let is_opposite = (half != half.floor()) != (self.first_turn < F::int(0));
        // A rest at 0 has no sign.
        F::int(0) + if is_opposite { -left } else { left }
    }

    fn time(&self) -> F {
        let (zero, one) = (F::int(0), F::int(1));
        if self.turns == zero {
            return self.first_time;
        }
        if self.zeta >= one {
            return one / zero;
        }
        self.first_time + self.turns * F::pi() / ((one - self.zeta) * (one + self.zeta)).sqrt()
    }
}

/// A free vibration as a trajectory, segment by segment; its phases are ω_n t. A creep ends when its velocity
/// is rounding.
impl<F: Float> From<FreeDecay<F>> for Trajectory<F> {
    fn from(decay: FreeDecay<F>) -> Self {
        Self::of(Equation::free(decay.zeta, decay.eta), decay.start)
    }
}

/// The greatest number of half cycles whose lengths are summed.
const SUMMED: i32 = 1 << 12;

/// `ln(1 + y)` of a y ≥ 0, by Newton's method on the exponential from the logarithm at f64: each step doubles
/// the digits.
fn ln_1p<F: Float>(y: F) -> F {
    let (one, two) = (F::int(1), F::int(2));
    let mut x = F::from_f64(y.to_f64().ln_1p());
    for _ in 0..F::precision().ilog2() {
        // Halley's step: 2 (y − (eˣ − 1))/(y + 1 + eˣ).
        let e = x.exp_m1();
        let step = two * (y - e) / (y + two + e);
        x = x + step;
        let is_felt = one + step.abs() > one;
        if step.abs() <= F::epsilon() * x.abs() || !is_felt {
            break;
        }
    }
    x
}

#[cfg(test)]
mod tests;
