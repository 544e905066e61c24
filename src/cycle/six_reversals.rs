//! Motion without a stop below the border: the symmetric cycle of six reversals near the poles Ω = 1/(2n+1).
//!
//! At a pole the natural frequency is the odd harmonic 2n+1 of the drive, and friction that reverses twice a
//! cycle feeds the free vibration in every half turn: without a damper the border is infinite there. Three
//! reversals in half a turn, a sixth of a natural period apart, have no such harmonic. A motion with such
//! reversals exists in a region near each pole, n ≥ 1, far below the border, and does not stop.
//!
//! # The matching problem
//!
//! Natural time u is counted from the second of the three reversals, the first is at −a, the third at b. Free
//! vibration is `e^{Au}`, `A = [[0, 1], [−1, −2ζ]]`, with the waves C, S, D of [`equations::Wave`]. With the
//! reversals σ = (1, −1, 1) at `u₁, u₂, u₃ = −a, 0, b` and the free vibration g at the second of them,
//! displacement with friction's part and velocity are
//!
//! ```text
//! z(u) = forced wave + e^{Au} g + Σ σ_j sgn(u_j − u) e^{A(u − u_j)} (1, 0)ᵀ.
//! ```
//!
//! It is antisymmetric, z(u + T) = −z(u), where g is the contribution of the reversals:
//!
//! ```text
//! cosh(AT/2) g = sinh(AT/2) w,     w = Σ σ_j e^{−Au_j} (1, 0)ᵀ = (C(a) + C(−b) − 1, −S(a) − S(−b)).
//! ```
//!
//! `J = (A + ζ)/d` has J² = −1, so that with β = dT/2 and t = tanh(ζT/2) this is
//!
//! ```text
//! (cos β − t sin β J) g + (t cos β − sin β J) w = 0,
//! ```
//!
//! smooth where cos β and t vanish. The velocity is zero at the reversals: with `s = AΩ sin Ωφ₂` and
//! `c = AΩ² cos Ωφ₂`, A = α/q the forced amplitude and φ₂ the natural time from the forced maximum to the second
//! reversal, `κ(u) = (cos Ωu − D(u))/S(u)` and `μ(u) = sin Ωu/(ΩS(u))`,
//!
//! ```text
//! g₂ = s − S(a) + S(−b),
//! cμ(−a) + g₁ + sκ(−a) = 1 + C(a) − C(−b),      −cμ(b) − g₁ − sκ(b) = 1 + C(−b) − C(a).
//! ```
//!
//! A fifth equation closes the system for (a, b, s, c, g₁): the force, `c² + Ω²s² = (AΩ²)²`, or an edge.
//!
//! Without a damper C = D = cos, S = sin and t = 0. With p = g₁ and q = −g₂ antisymmetry is
//!
//! ```text
//! p cos β + (sin a − sin b) sin β = 0,     q cos β − (cos a + cos b − 1) sin β = 0,
//! ```
//!
//! and at the pole itself a = b = π/3, and all of it is a closed form: `s = −1/κ(π/3)`, `p = −c μ(π/3)`.
//!
//! # The edges
//!
//! The body slides on at a reversal where the force left over is above the friction force,
//! `σ_j (α sin θ − x) < −1`. At the edges the second or the third reversal becomes a stop. At the pole, where
//! the third does, with C = cos(Ωπ/3):
//!
//! ```text
//! c (C − μ(π/3)/2) = 3/2 + s [Ω sin(Ωπ/3) − √3/2],     α = (1 − Ω²) √(c² + Ω²s²)/Ω²
//! ```
//!
//! is the least of all forces without a stop, 68.87 r_y at Ω = 1/3; there is no greatest one. Damping takes the
//! pole away, and with it the endless force ratios there: the cycle exists where both cot β and t are small.
//!
//! **With a static friction of η times the kinetic one** the motion is the same, because the body does not
//! rest, and a reversal is a stop where the force left over is at most η. So the edges are where the second or
//! the third reversal has the force η; the first reversal has more.
//!
//! # Proved and searched statements
//!
//! A cycle that this module gives is a motion without a stop (its equations are solved to rounding, and a
//! test follows the exact motion), and so, for α > 1, the limit of every start: there is one limit only
//! (`motion`), with a damper without an exception. That its edges are the only ones, that no cycle of ten
//! reversals or more exists without a stop, and none of six elsewhere, is searched: the exact motion from rest
//! over the plane, see `docs/development/theory/six-reversals.md`.

mod edges;
mod equations;
mod newton;
mod solved;
mod within;

use crate::float::Float;
use crate::machine::ratios::Ratios;
use edges::edges;
use equations::{Problem, Unknowns};
use solved::{at_force, solved};
pub(crate) use within::{Within, within, within_box, within_edges};

/// The least and the greatest force ratio of the six-reversal cycle at the Ω, ζ and η of these ratios; `None`
/// where it does not exist.
///
/// Between these values, both included, the body never stops and reverses six times a cycle. They are below
/// the border of the two-reversal cycle ([`crate::Border`]); between the greatest one and the border the body
/// stops.
///
/// Accuracy at f64: 64 ulp; where the two meet, at the ends of the region, the problem itself has half the digits.
pub(crate) fn force_ratios<F: Float>(ratios: &Ratios<F>) -> Option<(F, F)> {
    force_ratios_at(ratios.omega(), ratios.damping_ratio(), ratios.static_friction_ratio())
}

/// The least and the greatest force ratio of [`force_ratios`] at a valid Ω, ζ and η.
pub(crate) fn force_ratios_at<F: Float>(omega: F, zeta: F, eta: F) -> Option<(F, F)> {
    edges(omega, zeta, eta).map(|found| (found.low, found.high))
}

/// Whether the body does not stop at these ratios, given that α is below the border of the two-reversal cycle. Nearly
/// everywhere one or two comparisons decide.
#[inline]
pub(crate) fn is_within<F: Float>(ratios: &Ratios<F>) -> bool {
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    is_strong_enough(omega, alpha) && omega * F::int(2) < F::int(1) && is_between(ratios)
}

/// A cheap necessary condition on (Ω, α) below the border: on the edges `AΩ² = αΩ²/q` is nowhere below 5, and
/// q ≥ 1 − Ω².
#[inline]
fn is_strong_enough<F: Float>(omega: F, alpha: F) -> bool {
    let one = F::int(1);
    alpha * omega.square() > F::int(5) * (one - omega) * (one + omega)
}

/// The rounded edges themselves belong to the cycle.
#[cold]
#[inline(never)]
fn is_between<F: Float>(ratios: &Ratios<F>) -> bool {
    let alpha = ratios.alpha();
    force_ratios(ratios).is_some_and(|(low, high)| low <= alpha && alpha <= high)
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
    problem: Problem<F>,
    unknowns: Unknowns<F>,
}

impl<F: Float> SixReversals<F> {
    /// The cycle at (Ω, α, ζ, η); `None` outside its force ratios ([`crate::NoStop::of`]). With a static
    /// friction above the kinetic one it is the limit of its neighbourhood only.
    pub fn new(ratios: Ratios<F>) -> Option<Self> {
        if !is_within(&ratios) {
            return None;
        }
        let problem = Problem::of(&ratios);
        let unknowns = at_force(&problem, ratios.forced_amplitude() * ratios.omega().square())?;
        Some(Self { ratios, problem, unknowns })
    }

    /// The phases ω_d t of the three reversals around the maximum, increasing; those around the minimum are
    /// half a turn later.
    ///
    /// Without a damper between 0 and π, because the forced maximum is at π/2; with one they are later by its lag.
    pub fn reversal_phases(&self) -> [F; 3] {
        let (omega, y) = (self.ratios.omega(), &self.unknowns);
        let second = self.second_phase();
        [second - omega * y.before, second, second + omega * y.after]
    }

    /// The force `|α sin θ − x|` at the three reversals, in units of r_y: above η, and η on an edge.
    pub fn forces(&self) -> [F; 3] {
        self.problem.forces(&self.unknowns).map(F::abs)
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
        self.problem.phase_lag() + (F::pi() / F::int(2) + (omega * y.sine).atan2(y.cosine))
    }

    fn at(&self, phase: F) -> (F, F) {
        let omega = self.ratios.omega();
        // In the half turn that ends half way from the third reversal to the next first one.
        let since = phase - self.second_phase() + F::pi() / F::int(2);
        let half_turns = (since / F::pi()).floor();
        let flipped = half_turns != (half_turns / F::int(2)).floor() * F::int(2);
        let slow = since - half_turns * F::pi() - F::pi() / F::int(2);
        let (x, w) = self.problem.motion(&self.unknowns, slow / omega);
        if flipped { (-x, -w / omega) } else { (x, w / omega) }
    }
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
