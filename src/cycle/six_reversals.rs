//! Motion without a stop below the border: the symmetric cycle of six reversals near the poles Ω = 1/(2n+1).
//!
//! At a pole the natural frequency is the odd harmonic 2n+1 of the drive, and friction that reverses twice a
//! cycle feeds the free vibration in every half turn: the border is infinite there. Three reversals in half a
//! turn, a sixth of a natural period apart, have no such harmonic. A motion with such reversals exists in a
//! region near each pole, n ≥ 1, far below the border, and does not stop.
//!
//! # The matching problem
//!
//! Natural time u is counted from the second of the three reversals, the first is at −a, the third at b. With
//! `A = α/(1 − Ω²)`, the reversals σ = (1, −1, 1) at `u₁, u₂, u₃ = −a, 0, b` and friction +1 before the
//! first,
//!
//! ```text
//! x = A cos Ω(φ₂ + u) + p cos u − q sin u − r(u) + Σ σ_j sgn(u_j − u) cos(u − u_j),      r = ±1 the friction
//! ```
//!
//! solves the equation of motion and keeps its velocity at the reversals. It is antisymmetric,
//! x(φ + π/Ω) = −x(φ), if the free vibration `p + iq` is what the three reversals feed: with
//! `X = cos a + cos b − 1`, `Y = sin a − sin b`, β = π/2Ω,
//!
//! ```text
//! p cos β + Y sin β = 0,     q cos β − X sin β = 0,
//! ```
//!
//! which is smooth through the poles, cos β = 0. The velocity vanishes at the reversals: with
//! `s = AΩ sin Ωφ₂`, `c = AΩ² cos Ωφ₂`, `κ(u) = (cos Ωu − cos u)/sin u` and `μ(u) = sin Ωu/(Ω sin u)`,
//!
//! ```text
//! q = sin a + sin b − s,
//! c μ(a) + p − s κ(a) = 1 + cos a − cos b,      −c μ(b) − p − s κ(b) = 1 + cos b − cos a.
//! ```
//!
//! A fifth equation closes the system for (a, b, s, c, p): the force, `c² + Ω²s² = (AΩ²)²`, or an edge. At
//! the pole itself a = b = π/3, and all of it is a closed form: `s = −1/κ(π/3)`, `p = −c μ(π/3)`.
//!
//! # The edges
//!
//! The body slides on at a reversal where the force left over is above the friction bound,
//! `σ_j (α sin θ − x) < −1`. At the edges the second or the third reversal becomes a stop. At the pole, where
//! the third does, with C = cos(Ωπ/3):
//!
//! ```text
//! c (C − μ(π/3)/2) = 3/2 + s [Ω sin(Ωπ/3) − √3/2],     α = (1 − Ω²) √(c² + Ω²s²)/Ω²
//! ```
//!
//! is the least of all forces without a stop, 68.87 r_y at Ω = 1/3; there is no greatest one.
//!
//! **With a static friction of η times the kinetic one** the motion is the same, because the body does not
//! rest, and a reversal is a stop where the force left over is at most η. So the edges are where the second or
//! the third reversal has the force η, which only the search of [`damped`] knows, with ζ = 0 as a value; the
//! first reversal has more.
//!
//! # Proved and searched statements
//!
//! A cycle that this module gives is a motion without a stop (its equations are solved to rounding, and a
//! test follows the exact motion), and so, for α > 1, the limit of every start: there is one limit only
//! (`motion`). That its edges are the only ones, that no cycle of ten reversals or more exists without a stop,
//! and none of six elsewhere, is searched: the exact motion from rest over the plane, see
//! `docs/theory/six-reversals.md`.

pub(crate) mod damped;
mod edges;
mod equations;
mod newton;
mod range;
mod search;

use crate::cycle::phase_function::PhaseFunction;
use crate::float::{Float, at_precision};
use crate::machine::ratios::Ratios;
use equations::{Closing, Frequency, Unknowns};
pub(crate) use range::{EDGE_ERROR, Within, within};

/// The least and the greatest force ratio of the six-reversal cycle at the frequency ratio of `p`; `None`
/// where it does not exist.
///
/// Between these values, both included, the body never stops and reverses six times a cycle. They are below
/// the border of the two-reversal cycle ([`crate::Border`]); between the greatest one and the border the body
/// stops.
///
/// Accuracy at f64: 40 ulp; where the two meet, at the ends of the region, the problem itself has half the
/// digits.
pub(crate) fn force_ratios_at<F: Float>(p: &PhaseFunction<F>) -> Option<(F, F)> {
    edges::edges(p).map(|found| (found.low, found.high))
}

/// Whether the body does not stop at (Ω, α), given that α is below the border of the two-reversal cycle.
///
/// Nearly everywhere that is answered by one or two comparisons.
#[inline]
pub(crate) fn is_within<F: Float>(omega: F, alpha: F) -> bool {
    edges::is_strong_enough(omega, alpha) && omega * F::int(2) < F::int(1) && is_between(omega, alpha)
}

#[cold]
#[inline(never)]
fn is_between<F: Float>(omega: F, alpha: F) -> bool {
    force_ratios_at(&PhaseFunction::of_valid(omega)).is_some_and(|(low, high)| low <= alpha && alpha <= high)
}

/// The symmetric cycle of six reversals at one (Ω, α).
///
/// ```
/// use stickslip::{Ratios, cycle::SixReversals};
/// let cycle = SixReversals::new(Ratios::new(0.331f64, 61.6)?).unwrap();
/// // Around its maximum the body turns back, forth and back again.
/// let [first, second, third] = cycle.reversal_phases();
/// assert!(first < second && second < third);
/// assert!(cycle.velocity_at(second).abs() < 1e-13);
/// # Ok::<(), stickslip::Error>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct SixReversals<F> {
    ratios: Ratios<F>,
    unknowns: Unknowns<F>,
    /// With a damper.
    damped: Option<damped::Problem<F>>,
}

impl<F: Float> SixReversals<F> {
    /// The cycle at (Ω, α, ζ, η); `None` outside its force ratios ([`crate::NoStop::of`]). With a static
    /// friction above the kinetic one it is the limit of its neighbourhood only.
    pub fn new(ratios: Ratios<F>) -> Option<Self> {
        let (omega, alpha) = (ratios.omega(), ratios.alpha());
        if ratios.is_damped() {
            return Self::damped(ratios);
        }
        let is_one = if ratios.has_higher_static_friction() {
            damped::is_within(&ratios)
        } else {
            is_within(omega, alpha)
        };
        if !is_one {
            return None;
        }
        let frequency = Frequency::of(&PhaseFunction::of_valid(omega));
        let force = ratios.forced_amplitude() * omega.square();
        let start = followed(frequency, force)?;
        let solved = newton::polished(omega, start, |y| y.residuals(&frequency, Closing::Force(force)));
        solved.map(|unknowns| Self { ratios, unknowns, damped: None })
    }

    fn damped(ratios: Ratios<F>) -> Option<Self> {
        if !damped::is_within(&ratios) {
            return None;
        }
        let problem = damped::Problem::of(&ratios);
        let unknowns = damped::at_force(&problem, ratios.forced_amplitude() * ratios.omega().square())?;
        Some(Self { ratios, unknowns, damped: Some(problem) })
    }

    /// The phases ω_d t of the three reversals around the maximum, increasing; those around the minimum are
    /// half a turn later.
    ///
    /// Between 0 and π, because the forced maximum is at π/2.
    pub fn reversal_phases(&self) -> [F; 3] {
        let (omega, y) = (self.ratios.omega(), &self.unknowns);
        let second = self.second_phase();
        [second - omega * y.before, second, second + omega * y.after]
    }

    /// The force `|α sin θ − x|` at the three reversals, in units of r_y: above η, and η on an edge.
    pub fn forces(&self) -> [F; 3] {
        let forces = match &self.damped {
            Some(problem) => problem.forces(&self.unknowns),
            None => self.unknowns.forces(self.ratios.omega()),
        };
        forces.map(F::abs)
    }

    /// Displacement `x/B` at the phase ω_d t, finite.
    pub fn displacement_at(&self, phase: F) -> F {
        self.at(phase).0
    }

    /// Velocity `x′/(Bω_d)` at the phase ω_d t, finite.
    pub fn velocity_at(&self, phase: F) -> F {
        self.at(phase).1
    }

    /// π/2 + Ωφ₂, and the lag of the linear oscillator.
    fn second_phase(&self) -> F {
        let (y, omega) = (&self.unknowns, self.ratios.omega());
        let lag = self.damped.as_ref().map_or(F::int(0), damped::Problem::phase_lag);
        lag + (F::pi() / F::int(2) + (omega * y.sine).atan2(y.cosine))
    }

    fn at(&self, phase: F) -> (F, F) {
        let (omega, y) = (self.ratios.omega(), &self.unknowns);
        // In the half turn that ends half way from the third reversal to the next first one.
        let since = phase - self.second_phase() + F::pi() / F::int(2);
        let half_turns = (since / F::pi()).floor();
        let flipped = half_turns != (half_turns / F::int(2)).floor() * F::int(2);
        let slow = since - half_turns * F::pi() - F::pi() / F::int(2);
        let u = slow / omega;
        let (x, w) = match &self.damped {
            Some(problem) => problem.motion(y, u),
            None => self.undamped_motion(slow),
        };
        if flipped { (-x, -w / omega) } else { (x, w / omega) }
    }

    /// x and its derivative by natural time, Ωu after the second reversal.
    fn undamped_motion(&self, slow: F) -> (F, F) {
        let (omega, y) = (self.ratios.omega(), &self.unknowns);
        let u = slow / omega;
        let (one, zero) = (F::int(1), F::int(0));
        let ((slow_sine, slow_cosine), (sine, cosine)) = (slow.sin_cos(), u.sin_cos());
        let (p, q) = (y.swing, y.quarter_swing());
        let mut x = (y.cosine / omega * slow_cosine - y.sine * slow_sine) / omega + p * cosine - q * sine;
        let mut w = -(y.cosine / omega * slow_sine + y.sine * slow_cosine) - p * sine - q * cosine;
        let mut friction = one;
        for (at, sign) in [(-y.before, one), (zero, -one), (y.after, one)] {
            let (s, c) = (u - at).sin_cos();
            let side = if u < at { sign } else { -sign };
            x = x + side * c;
            w = w - side * s;
            if u >= at {
                friction = -friction;
            }
        }
        (x - friction, w)
    }
}

/// The solution for a force followed from the pole, where it is a closed form, in steps of cot β.
fn followed<F: Float>(frequency: Frequency<F>, force: F) -> Option<Unknowns<F>> {
    at_precision!(narrowed, <F>(frequency: Frequency<F>, force: F) -> Option<Unknowns<F>>, |there, back: G| {
        let (omega, force) = (there(frequency.omega), there(force));
        let (sin_beta, cos_beta) = (there(frequency.sin_beta), there(frequency.cos_beta));
        let mut y = at_the_pole(omega, force)?;
        for step in 1..=STEPS {
            let frequency = Frequency { omega, sin_beta, cos_beta: cos_beta * G::ratio(step, STEPS) };
            y = newton::polished(omega, y, |y| y.residuals(&frequency, Closing::Force(force)))?;
        }
        Some(y.map(back))
    })
}

/// Steps from the pole.
const STEPS: i32 = 16;

/// The cycle at a pole with this Ω: `a = b = π/3`, `s = −1/κ(π/3)`, `p = −c μ(π/3)`.
fn at_the_pole<F: Float>(omega: F, force: F) -> Option<Unknowns<F>> {
    let third = F::pi() / F::int(3);
    let root = F::int(3).sqrt();
    let (slow_sine, slow_cosine) = (omega * third).sin_cos();
    let sine = -root / (F::int(2) * slow_cosine - F::int(1));
    let square = force.square() - (omega * sine).square();
    let cosine = square.sqrt();
    let swing = -cosine * slow_sine * F::int(2) / (omega * root);
    (square > F::int(0)).then_some(Unknowns { before: third, after: third, sine, cosine, swing })
}

#[cfg(test)]
mod tests {
    use super::SixReversals;
    use crate::Ratios;

    #[test]
    fn the_motion_solves_the_equation_of_motion() {
        for (omega, alpha) in [
            (0.331, 61.6),
            (0.3333, 100.0),
            (0.3333, 12_000.0),
            (0.334_325, 149.563),
            (0.198_7, 230.688),
            (0.0907, 1300.0),
        ] {
            let cycle = SixReversals::new(Ratios::new(omega, alpha).unwrap()).unwrap();
            let size = alpha;
            let h = 1e-4;
            for i in 0..200 {
                let phase = -10.0 + 0.1 * f64::from(i);
                let x = |p| cycle.displacement_at(p);
                let v = cycle.velocity_at(phase);
                assert!((x(phase + std::f64::consts::PI) + x(phase)).abs() < 1e-11 * size);
                assert!(
                    ((x(phase + h) - x(phase - h)) / (2.0 * h) - v).abs() < 1e-5 * size,
                    "{omega} {phase}"
                );
                let second = (x(phase + h) - 2.0 * x(phase) + x(phase - h)) / (h * h);
                let left = omega * omega * second + x(phase) + v.signum() - alpha * phase.sin();
                let near = cycle.velocity_at(phase + h).signum() != cycle.velocity_at(phase - h).signum();
                assert!(near || left.abs() < 1e-5 * size, "{omega} {alpha} {phase}: {left}");
            }
            for reversal in cycle.reversal_phases() {
                assert!(cycle.velocity_at(reversal).abs() < 1e-13 * size, "{}", cycle.velocity_at(reversal));
            }
        }
    }
}
