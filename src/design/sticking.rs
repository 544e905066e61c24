//! The friction that dissipates most under a given force, with sticking allowed.
//!
//! Let ρ = 1/α = r_y/p₀, ζ ≥ 0 the damping ratio, and J(ρ) = ∮ |x′| dt, the path length of a cycle in units
//! of p₀/k, so that A₁ = 2ρJ.
//!
//! **More friction, shorter path.** Take two frictions ρ₁ < ρ₂ and their periodic motions. The difference of
//! the equations of motion times the difference of the velocities, integrated over a cycle, gives `∮ (ρ₁r₁ −
//! ρ₂r₂)(v₁ − v₂) dt + D = 0`. Here r is the friction in units of its bound, with r v = |v|, |r| ≤ 1, and D =
//! 2ζ ∮ (v₁ − v₂)² dt ≥ 0 (in natural time) is the contribution of the damper. Hence
//!
//! ```text
//! 0 ≥ ρ₁J₁ + ρ₂J₂ − ρ₁ ∮ r₁v₂ − ρ₂ ∮ r₂v₁ ≥ ρ₁J₁ + ρ₂J₂ − ρ₁J₂ − ρ₂J₁ = (ρ₂ − ρ₁)(J₂ − J₁)
//! ```
//!
//! and J does not increase with ρ, with or without stops. **So A₁ on an interval [ρ₁, ρ₂] is at most A₁(ρ₁)
//! ρ₂/ρ₁.** This bound becomes exact as the interval shrinks, and turns a finite number of exact motions into
//! a proof. Intervals whose bound is within the tolerance of the best value found are finished; the others
//! are halved until none is left. The bound is returned with the answer.
//!
//! **A motion is known to within d.** Friction and damper are monotone, so that the computed motion and its
//! limit, δ = d apart in (x, w = x′/ω_n) at one instant, are never further apart. The difference of their
//! path lengths in a cycle of length T = 2π/Ω is `∮ (|w₁| − |w₂|) dφ`, which is small for two reasons:
//!
//! * `∮ |δw| dφ ≤ T d`, however often either stops.
//! * Where neither goes backward, |w₁| − |w₂| is δx′, and where neither goes forward −δx′: over each such
//!   time no more than the change of δx, whose size is at most d. Where they move in opposite directions,
//!   `½(δx² + δw²)` falls by 2|δw| dφ, altogether by ½d² at most. So with n changes between common forward
//!   and common backward, `|δW| ≤ 2(n + 1) d + ¼d²`. Each change begins with one of the two starting from
//!   rest, forward where `P = α sin θ − x ≥ 1`, backward where P ≤ −1. The P of the two differ by at most d,
//!   so that P of the motion found varies by at least 2 − 2d between two changes, and by at most 4α + W in a
//!   cycle: `n ≤ 1 + (2α + ½W)/(1 − d)`.
//!
//! The second bound is sharper where a cycle is long, Ω ≪ 1, since it does not grow with T. Wherever A₁
//! bounds an interval, it is increased by the smaller of the two and by the rounding of the sum. The bound
//! relies on d, which is [`crate::motion::SteadyState::distance`]: an estimate by the linearised half turn,
//! not an enclosure.
//!
//! Where the body does not stick, ρ ≤ 1/α_min, the optimum is known in closed form (`dissipation`); at ρ = 1
//! the path length is zero.

use super::dissipation::most_dissipating_force_ratio;
use super::force::ratios_of;
use super::optimum::{BoundedOptimum, Optimum, OptimumKind};
use crate::cycle::{Border, loop_size_stiffness};
use crate::float::Float;
use crate::greatest::highest;
use crate::machine::error::{Error, Quantity, written};
use crate::machine::oscillator::{Drive, Oscillator};
use crate::machine::ratios::{Ratios, positive, within};
use crate::motion::{LongRun, State, SteadyState};
use alloc::vec::Vec;

/// A computed loop size and an upper bound of it.
#[derive(Debug, Clone, Copy, PartialEq)]
struct LoopSize<F> {
    found: F,
    most: F,
}

impl<F: Float> LoopSize<F> {
    /// The loop of a body at rest, of size zero.
    fn none() -> Self {
        Self { found: F::int(0), most: F::int(0) }
    }

    /// The loop size from a closed form, accurate to two units in the last place.
    fn closed(found: F) -> Self {
        Self { found, most: found * (F::int(1) + F::int(4) * F::epsilon()) }
    }

    /// The loop size of an exact motion: A₁ = 2W/α², where W is the work against friction in units of r_y B.
    fn of_motion(steady: &SteadyState<F>, omega: F, alpha: F) -> Self {
        let (x, v) = steady.distance;
        let work = steady.energy_out;
        let doubt = doubt_of_way(x.hypot(v * omega), omega, alpha, work);
        // Each end of a slide is rounded, and so is the sum.
        let ends = F::from_f64(f64::from(steady.velocity_zeros_per_cycle) + 4.0);
        let rounding = F::int(2) * F::epsilon() * ends * (work + steady.max_displacement.value.abs());
        let most = work + doubt + rounding;
        let size = |work: F| F::int(2) * (work / alpha) / alpha;
        Self { found: size(work), most: size(most) }
    }
}

/// A bound on the difference between the path length of a motion and that of its limit, if they are
/// `distance` apart at one instant (see the module's documentation).
fn doubt_of_way<F: Float>(distance: F, omega: F, alpha: F, way: F) -> F {
    let (one, two) = (F::int(1), F::int(2));
    let by_time = two * F::pi() / omega * distance;
    if distance * two >= one {
        return by_time;
    }
    let changes = one + (two * alpha + way / two) / (one - distance);
    let by_changes = two * (changes + one) * distance + (distance / two).square();
    if by_changes < by_time { by_changes } else { by_time }
}

/// The loop size A₁ of the exact motion at (Ω, α, ζ): the friction work of a cycle over p₀²/(2k); zero at
/// rest.
fn loop_size_of_motion<F: Float>(omega: F, alpha: F, zeta: F) -> Result<LoopSize<F>, Error> {
    if alpha <= F::int(1) {
        return Ok(LoopSize::none());
    }
    match LongRun::from_start(Ratios::new(omega, alpha)?.with_damping_ratio(zeta)?, State::default())? {
        LongRun::Periodic(steady) | LongRun::Family(steady) => Ok(LoopSize::of_motion(&steady, omega, alpha)),
        LongRun::Rest(_) => Ok(LoopSize::none()),
        LongRun::Unbounded { .. } => Err(Error::Unbounded { alpha: written(alpha) }),
        LongRun::Irregular(_) | LongRun::NotConverged { .. } => {
            Err(Error::NotSettled { omega: written(omega), alpha: written(alpha) })
        }
    }
}

/// A bound of A₁ for friction shares between `low` and `high`: A₁ = 2ρJ, and J does not increase with ρ.
fn bound_between<F: Float>(at_low: F, low: F, high: F) -> F {
    // The factor covers two roundings.
    at_low * (high / low) * (F::int(1) + F::int(2) * F::epsilon())
}

/// The largest A₁ found, its place, and a bound on all values examined.
struct LoopSearch<F> {
    omega: F,
    zeta: F,
    share: F,
    loop_size: F,
    bound: F,
    tolerance: F,
    motions: u32,
}

impl<F: Float> LoopSearch<F> {
    fn loop_size_at(&mut self, share: F) -> Result<LoopSize<F>, Error> {
        let size = loop_size_of_motion(self.omega, F::int(1) / share, self.zeta)?;
        self.motions = self.motions.saturating_add(1);
        if size.found > self.loop_size {
            (self.share, self.loop_size) = (share, size.found);
        }
        self.bound = self.bound.or_larger(size.most);
        // Halving an interval does not reduce the uncertainty of the motion itself.
        if size.most > self.loop_size * (F::int(1) + self.tolerance / F::int(2)) {
            let (omega, alpha) = (written(self.omega), written(F::int(1) / share));
            return Err(Error::NotSettled { omega, alpha });
        }
        Ok(size)
    }

    /// Searches `[low, high]`, given that A₁ is `at_low` at the lower end, until no value in it can exceed
    /// the best by more than the tolerance.
    fn exhaust(&mut self, low: F, high: F, at_low: F) -> Result<(), Error> {
        let (one, two) = (F::int(1), F::int(2));
        let mut left = Vec::new();
        let mut from = (low, at_low);
        for i in 1..=COARSE {
            let next = low + (high - low) * F::ratio(i, COARSE);
            left.push((from.0, next, from.1));
            from = (next, self.loop_size_at(next)?.most);
        }
        self.refine(low, high, (high - low) / F::int(COARSE))?;
        while let Some((low, high, at_low)) = left.pop() {
            let bound = bound_between(at_low, low, high);
            if bound <= self.loop_size * (one + self.tolerance) {
                self.bound = self.bound.or_larger(bound);
                continue;
            }
            let middle = low + (high - low) / two;
            if middle <= low || middle >= high {
                self.bound = self.bound.or_larger(bound);
                continue;
            }
            let at_middle = self.loop_size_at(middle)?.most;
            left.push((low, middle, at_low));
            left.push((middle, high, at_middle));
        }
        self.refine(low, high, self.tolerance * self.share)
    }

    /// Golden-section search around the best value so far, to about the square root of the precision, which
    /// is the limit at a maximum.
    fn refine(&mut self, low: F, high: F, width: F) -> Result<(), Error> {
        let (from, to) = (self.share - width, self.share + width);
        let (from, to) = (from.or_larger(low), if to < high { to } else { high });
        let size = |share| self.loop_size_at(share).map(|size| size.found);
        highest(from, to, F::epsilon().sqrt(), size).map(|_| ())
    }
}

/// The initial number of intervals.
const COARSE: i32 = 32;

/// α = p₀/r_y of [`most_dissipating_friction_of_all`] with m = k = p₀ = 1, and A₁; its errors name ratios.
pub fn most_dissipating_force_ratio_of_all<F: Float>(
    omega: F,
    damping_ratio: F,
    tolerance: F,
) -> Result<BoundedOptimum<F>, Error> {
    let (one, zeta) = (F::int(1), damping_ratio);
    let tolerance = within(Quantity::Tolerance, tolerance, F::epsilon().sqrt(), one)?;
    let non_sticking = most_dissipating_force_ratio(omega, zeta)?;
    let border = Border::of(&crate::Ratios::of_machine(omega, zeta)?);
    let least = border.min_force_ratio;
    let share = one / least;
    let at_border = LoopSize::closed(loop_size_stiffness(border.least_displacement, least)).most;
    let most = LoopSize::closed(non_sticking.value).most;
    // The best cycle without sticking is the first candidate; its place may be the border.
    let mut sticking =
        LoopSearch { omega, zeta, share, loop_size: non_sticking.value, bound: most, tolerance, motions: 0 };
    sticking.exhaust(share, one, at_border)?;
    let inside = sticking.share > share && sticking.loop_size > non_sticking.value;
    let (at, value, kind) = if inside {
        (one / sticking.share, sticking.loop_size, OptimumKind::Sticking)
    } else {
        (non_sticking.at, non_sticking.value, non_sticking.kind)
    };
    let bound = sticking.bound.or_larger(value);
    Ok(BoundedOptimum { at, value, kind, bound, non_sticking, motions: sticking.motions })
}

/// The friction force with which `drive` dissipates most in a cycle, with sticking allowed. It is the global maximum to
/// within a relative `tolerance` in the energy, by the bound in the module's documentation.
///
/// Mass, stiffness and damping are those of `body`; its own friction force plays no part. With a damper, only
/// the energy dissipated by friction counts.
///
/// The search takes about 3/√tolerance exact motions: 300 for 1e-4. The friction is known to the square
/// root of the precision, like the place of any maximum. For Ω → 0 p₀/r_y tends to 2, and so does
/// A₁. Where the best motion does not stick, the result is [`super::most_dissipating_friction`].
///
/// ```
/// use stickslip::design::{OptimumKind, most_dissipating_friction_of_all};
/// use stickslip::{Drive, Oscillator};
/// let (body, drive) = (Oscillator::new(1.0, 1.0, 1.0)?, Drive::force(1.0, 0.3)?);
/// let best = most_dissipating_friction_of_all(&body, &drive, 1e-4)?;
/// assert_eq!(best.kind, OptimumKind::Sticking);
/// assert!(best.value > 2.0 * best.non_sticking.value && best.bound < best.value * 1.0001_f64);
/// # Ok::<(), stickslip::Error>(())
/// ```
///
/// # Errors
/// [`Error::AtResonance`] at Ω = 1 for ζ = 0, [`Error::NotSettled`] where a motion creeps too long for its
/// work to be known (Ω near 1/n), where `tolerance` is not in [ε^½, 1] or ζ is outside the domain of
/// [`Ratios`], where r_y or the energy overflows or underflows, and as for [`crate::motion::Trajectory::new`].
pub fn most_dissipating_friction_of_all<F: Float>(
    body: &Oscillator<F>,
    drive: &Drive<F>,
    tolerance: F,
) -> Result<BoundedOptimum<F>, Error> {
    let ratios = ratios_of(body, drive.angular_frequency())?;
    let (omega, zeta) = (ratios.omega(), ratios.damping_ratio());
    let best = most_dissipating_force_ratio_of_all(omega, zeta, tolerance)?;
    let p0 = positive(Quantity::ForceAmplitude, drive.force_amplitude(body))?;
    let unit = p0 / F::int(2) * (p0 / body.stiffness());
    let (sliding, friction) = (best.non_sticking, |alpha| positive(Quantity::FrictionBound, p0 / alpha));
    Ok(BoundedOptimum {
        at: friction(best.at)?,
        value: positive(Quantity::StaticEnergy, best.value * unit)?,
        bound: best.bound * unit,
        non_sticking: Optimum { at: friction(sliding.at)?, value: sliding.value * unit, ..sliding },
        ..best
    })
}

#[cfg(test)]
mod tests;
