//! Eq. 21–25 in a form that is well conditioned where the problem is, with its Jacobian.
//!
//! Near Ω = 1 and Ω = 1/(2n+1) the paper's form is not balanced: the amplitude α/q of the linear oscillator is large,
//! eq. 22 tends to eq. 21 and eq. 24 to eq. 23, and the motion is determined by their small differences, eq. 28 and
//! 29. Lengths are therefore in units of that amplitude, and eq. 22 and 24 are replaced as follows.
//!
//! Let Y₁ = (X, ρ) be the free vibration at t₁ ([`super::system`]), A the matrix of free vibration and τ = (t₂ − t₁)ω_n.
//! At t₂ the free vibration is `Y₂ = e^{Aτ} Y₁`, and at the start of the rising half cycle, whose motion is the
//! negative of that at its end, −Y₂ + (2b, 0). So eq. 21–24 imply
//!
//! ```text
//! (1 + e^{AT}) Y₁ = 2b e^{A(T−τ)} (1, 0).
//! ```
//!
//! With `M = e^{AT/2}`, E = det M = e^{−ζT} and the trace tr M = 2 e^{−ζT/2} cos dT/2, the theorem of Cayley and Hamilton
//! gives
//!
//! ```text
//! 1 + e^{AT} = tr M · M + (1 − E),   det (1 + e^{AT}) = D = (tr M)² + (1 − E)²,
//! Y₁ = κ L e^{A(T−τ)} (1, 0),   L = [tr M · adj M + (1 − E)]/√D,   κ = 2b/√D.
//! ```
//!
//! Nothing cancels in L and D, whose parts are sine and cosine in a triangle. The equations are
//!
//! ```text
//! 21                          F′(t₂) + rate of Y₂ = 0,            Y₂ = e^{Aτ} Y₁
//! 23                 F(t₂) − b + position of Y₂ = Δ₀
//! (21 − 22), (23 − 24)       Y₂ = κ L e^{AT} (1, 0)   or from ζ = 1 on   Y₁ = κ L e^{A(T−τ)} (1, 0)
//! 25                   b + Δ₁ + 2ζV₀ − q sin ω_d t₁ = 0
//! 59                            q sin ω_d t₂ + b − Δ₀ = 0
//! ```
//!
//! From ζ = 1 on Y₂ has lost the faster of the two decays, and with it digits of Y₁; below, Newton's method takes half as
//! many steps with Y₂ where two cycles meet.
//!
//! All coefficients are of order 1, and κ has a limit at Ω = 1 and at the poles of K; without a damper κ = b/|cos β|, β =
//! π/2Ω. No closed form is in it: without a damper it is eq. 21–25 times a regular matrix, which a symbolic test checks.

use super::system::System;
use super::{Unknowns, pi_1};
use crate::cycle::damped::free::{Free, Waves};
#[cfg(feature = "matching")]
use crate::cycle::damped::half_period::half_angle;
#[cfg(feature = "matching")]
use crate::cycle::phase_function::one_minus_square;
#[cfg(feature = "matching")]
use crate::float::Float;
use crate::float::Real;
#[cfg(feature = "matching")]
use crate::machine::ratios::Ratios;

/// Eq. 21–25 and 59 at one frequency and damping ratio; unknowns in units of α/q.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Balanced<R> {
    /// Frequency ratio Ω.
    pub(crate) omega: R,
    pub(crate) free: Free<R>,
    /// q.
    pub(crate) stiffness: R,
    /// (cos δ, sin δ), δ the lag of the linear oscillator.
    pub(crate) lag: (R, R),
    /// √D/2.
    pub(crate) root: R,
    /// Whether ζ < 1, and then `L e^{AT} (1, 0)`, otherwise `L (1, 0)`.
    pub(crate) swings: bool,
    pub(crate) known: (R, R),
    /// κ: the friction, 0 for none.
    pub(crate) friction: R,
}

/// The equations: left less right, the derivatives by t₁, t₂, V₀, Δ₀, Δ₁, and those by κ.
type Equations<R> = ([R; 5], [[R; 5]; 5], [R; 5]);

impl<R: Real> Balanced<R> {
    /// Eq. 21–25 with these lengths.
    pub(crate) fn system(&self) -> System<R> {
        let Self { omega, free, lag, .. } = *self;
        System { omega, free, forced: lag, friction: self.friction * self.root }
    }

    /// The equations, by free vibration after a time.
    pub(crate) fn equations_by(
        &self,
        u: &Unknowns<R>,
        waves: impl Fn(&Free<R>, R) -> Waves<R>,
    ) -> Equations<R> {
        let (zero, one, system) = (R::int(0), R::int(1), self.system());
        let Self { omega, root, friction, stiffness: q, .. } = *self;
        let (b, damping) = (system.friction, system.damping());
        let (f1, g1) = system.forced_at(u.velocity_phase);
        let (f2, g2) = system.forced_at(u.displacement_phase);
        let tau = (u.displacement_phase - u.velocity_phase) / omega;
        let near = system.after(tau, &waves);
        let (offset, rho) = (u.deviation + b - f1, u.max_velocity - g1);
        // From t₁ to t₂, with the influence of t₁ on the start: F′ = dF/dφ, dθ = Ω dφ.
        let [x, w, a] = near.from((offset, rho), damping);
        let [x1, w1, _] = near.from((-(g1 / omega), omega * f1), damping);
        let ((sine, cosine), (y, v)) = (u.velocity_phase.sin_cos(), self.known);
        // The two equations for Y₁ or Y₂: residuals, derivatives, and those by κ.
        let (free, by_free, by_friction) = if self.swings {
            let rows = [
                [w1 - a / omega, a / omega, near.slope, zero, -near.s],
                [x1 - w / omega, w / omega, near.s, zero, near.c],
            ];
            ([w - friction * v, x - friction * y], rows, [-(root * near.s) - v, root * near.c - y])
        } else {
            let [y, v, c] = system.after(pi_1(omega) - tau, &waves).from((y, v), damping);
            let (speed, change) = (friction * v / omega, friction * c / omega);
            let rows = [
                [omega * f1 - change, change, one, zero, zero],
                [-(g1 / omega) - speed, speed, zero, zero, one],
            ];
            ([rho - friction * v, offset - friction * y], rows, [-v, root - y])
        };
        let residuals = [
            g2 + w,
            free[0],
            f2 - b + x - u.max_displacement,
            free[1],
            b + u.deviation + damping * u.max_velocity - q * sine,
        ];
        let jacobian = [
            [w1 - a / omega, a / omega - omega * f2, near.slope, zero, -near.s],
            by_free[0],
            [x1 - w / omega, (g2 + w) / omega, near.s, -one, near.c],
            by_free[1],
            [-(q * cosine), zero, damping, zero, one],
        ];
        let by_friction = [-(root * near.s), by_friction[0], root * (near.c - one), by_friction[1], root];
        (residuals, jacobian, by_friction)
    }

    /// Left less right side of eq. 59: the force left over at t₂ is r_y.
    pub(crate) fn turning_point(&self, u: &Unknowns<R>) -> R {
        self.stiffness * u.displacement_phase.sin() - u.max_displacement + self.friction * self.root
    }

    /// Derivatives of [`Balanced::turning_point`] by t₁, t₂, V₀, Δ₀, Δ₁ and κ, in closed form.
    pub(crate) fn turning_point_gradient(&self, u: &Unknowns<R>) -> [R; 6] {
        let zero = R::int(0);
        [zero, self.stiffness * u.displacement_phase.cos(), zero, R::int(-1), zero, self.root]
    }
}

#[cfg(feature = "matching")]
impl<F: Float> Balanced<F> {
    /// The equations at Ω and ζ, and α.
    pub(super) fn new(ratios: &Ratios<F>) -> Self {
        let (omega, zeta, two) = (ratios.omega(), ratios.damping_ratio(), F::int(2));
        let (free, half) = (Free::new(zeta), pi_1(omega) / two);
        let (spring, damper) = (one_minus_square(omega), two * zeta * omega);
        let stiffness = spring.hypot(damper);
        // Towards ζ = 1 d vanishes, and a difference would lose it.
        let Waves { cosine, sine } = if zeta * two > F::int(1) {
            free.waves(half)
        } else {
            let (decay, (s, c)) = ((-(zeta * half)).exp(), half_angle(&free, omega, half));
            Waves { cosine: decay * c, sine: decay * s / free.frequency }
        };
        // (1 − E)/2
        let rest = -(-(zeta * half * two)).exp_m1() / two;
        let root = cosine.hypot(rest);
        let (p, g) = (cosine / root, rest / root);
        let swings = free.swings();
        let known = if swings {
            // M (1, 0) and M² (1, 0)
            let (once, decay) = ((cosine + zeta * sine, -sine), F::int(1) - rest * two);
            let state = free.after(Waves { cosine, sine }, once.0, once.1);
            (p * decay * once.0 + g * state.x, p * decay * once.1 + g * state.v)
        } else {
            (p * (cosine - zeta * sine) + g, p * sine)
        };
        Self {
            omega,
            free,
            stiffness,
            lag: (spring / stiffness, damper / stiffness),
            root,
            swings,
            known,
            friction: stiffness / (ratios.alpha() * root),
        }
    }

    /// These equations with another friction.
    pub(super) fn with_friction(self, friction: F) -> Self {
        Self { friction, ..self }
    }

    /// `x = F`.
    pub(super) fn without_friction(&self) -> Unknowns<F> {
        let lag = self.lag.1.atan2(self.lag.0);
        Unknowns {
            velocity_phase: lag,
            displacement_phase: lag + F::pi() / F::int(2),
            max_velocity: self.omega,
            max_displacement: F::int(1),
            deviation: F::int(0),
        }
    }

    pub(super) fn equations(&self, u: &Unknowns<F>) -> Equations<F> {
        self.equations_by(u, Free::waves)
    }

    /// Displacement and velocity of the rising half at a phase: the falling half with the opposite sign, half a turn
    /// later.
    pub(super) fn rising(&self, u: &Unknowns<F>, phase: F) -> (F, F) {
        let (x, w) = self.system().falling(u, phase - (u.displacement_phase - F::pi()));
        (-x, -w)
    }

    /// The equations at f64: each number rounded on its own, so that an Ω closer to 1 than f64 can tell keeps its
    /// distance.
    pub(super) fn to_f64(self) -> Balanced<f64> {
        let pair = |(a, b): (F, F)| (a.to_f64(), b.to_f64());
        Balanced {
            omega: self.omega.to_f64(),
            free: self.free.map(F::to_f64),
            stiffness: self.stiffness.to_f64(),
            lag: pair(self.lag),
            root: self.root.to_f64(),
            swings: self.swings,
            known: pair(self.known),
            friction: self.friction.to_f64(),
        }
    }
}
