//! A point with its answers, and the terms of the equations with the answers put in: in plain numbers, or in
//! balls.

use stickslip::cycle::Unknowns;
use stickslip::cycle::equations::{
    FallingHalf, Given, System, cosine_coefficient, phase_lag, sine_coefficient,
};
use stickslip::{Output, Real};

/// The functions of Ω in the paper's equations, which have no damper.
#[derive(Debug, Clone, Copy)]
pub(super) struct Circular<R> {
    /// K(Ω).
    pub(super) k: R,
    /// T = tan β, β = π/2Ω.
    pub(super) tangent: R,
    /// cos β.
    pub(super) cos_beta: R,
}

/// Decisions about the numbers of a point, which balls may leave open.
#[derive(Debug, Clone, Copy)]
pub(super) struct Signs {
    pub(super) is_damped: bool,
    /// Ω > 1.
    pub(super) is_above_one: bool,
    /// ω_d t₁ is above ω_d t₂ in [0, 2π).
    pub(super) is_late: bool,
}

/// Left less right sides of eq. 21–25.
type Residuals<R> = fn(&System<R>, &Unknowns<R>) -> [R; 5];

/// Displacement and velocity of the falling half at a phase after t₂.
type Falling<R> = fn(&System<R>, &Unknowns<R>, R) -> (R, R);

/// The operations of plain numbers that differ from those of balls: decisions, and the free vibration of a damped body.
#[derive(Debug, Clone, Copy)]
pub(super) struct Arithmetic<R> {
    pub(super) residuals: Residuals<R>,
    pub(super) falling: Falling<R>,
    /// Whether one number is certainly below another; `None` where this is undecided.
    pub(super) is_below: fn(R, R) -> Option<bool>,
}

/// A point and its answers.
#[derive(Debug, Clone)]
pub(super) struct Case<R> {
    pub(super) arithmetic: Arithmetic<R>,
    pub(super) omega: R,
    pub(super) alpha: R,
    pub(super) zeta: R,
    answers: Vec<(Output, R)>,
    pub(super) signs: Signs,
    /// The terms of the paper's equations.
    pub(super) circular: Circular<R>,
    /// 1 − Ω².
    pub(super) one_minus_square: R,
    /// A/B, 1 and Ω: NaN and unused with a damper.
    pub(super) given: Given<R>,
    /// The unknowns of eq. 21–25, lengths in B, with t₂ − π/ω_d < t₁ < t₂.
    pub(super) unknowns: Unknowns<R>,
    /// Den Hartog's half cycle.
    pub(super) half: FallingHalf<R>,
    /// q and δ: stiffness of the linear oscillator at Ω, and its phase lag.
    pub(super) linear: (R, R),
    /// The sum of the amplitudes: of the drive, of the motion, and of the free vibration.
    pub(super) scale: R,
}

/// An answer among several, if it is present.
fn among<R: Copy>(answers: &[(Output, R)], output: Output) -> Option<R> {
    answers.iter().find(|(name, _)| *name == output).map(|(_, value)| *value)
}

impl<R: Real> Case<R> {
    /// The case at (Ω, α, ζ) with these answers; `None` where an answer is missing.
    pub(super) fn new(
        arithmetic: Arithmetic<R>,
        (omega, alpha, zeta): (R, R, R),
        answers: Vec<(Output, R)>,
        circular: Circular<R>,
        signs: Signs,
    ) -> Option<Self> {
        let one = R::int(1);
        let answer = |output| among(&answers, output);
        let (first, last) = (answer(Output::VelocityPhase)?, answer(Output::DisplacementPhase)?);
        let unknowns = Unknowns {
            velocity_phase: if signs.is_late { first - R::int(2) * R::pi() } else { first },
            displacement_phase: last,
            max_velocity: answer(Output::MaxVelocity)? * omega,
            max_displacement: answer(Output::MaxDisplacement)?,
            deviation: answer(Output::Deviation)?,
        };
        let (spring, damper) = ((one - omega) * (one + omega), R::int(2) * zeta * omega);
        let stiffness = if signs.is_damped { spring.hypot(damper) } else { spring.abs() };
        let lag = if signs.is_damped {
            damper.atan2(spring)
        } else {
            R::int(i32::from(signs.is_above_one)) * R::pi()
        };
        // The linear oscillator's answer at t₂, and its rate.
        let (sine, cosine) = (last - lag).sin_cos();
        let (forced, rate) = (alpha * sine / stiffness, alpha * omega * cosine / stiffness);
        let delta = unknowns.max_displacement;
        let given = Given { amplitude: alpha / spring, friction_displacement: one, omega };
        Some(Self {
            arithmetic,
            omega,
            alpha,
            zeta,
            signs,
            circular,
            one_minus_square: spring,
            given,
            unknowns,
            half: FallingHalf {
                amplitude: given.amplitude,
                friction_displacement: one,
                omega,
                phase_lag: phase_lag(last),
                c1: sine_coefficient(one, circular.tangent),
                c2: cosine_coefficient(one),
            },
            linear: (stiffness, lag),
            scale: alpha / stiffness + delta + (delta - one - forced).abs() + rate.abs(),
            answers,
        })
    }

    /// An answer, if it exists.
    pub(super) fn get(&self, output: Output) -> Option<R> {
        among(&self.answers, output)
    }

    /// Whether a number is certainly below another.
    pub(super) fn is_below(&self, low: R, high: R) -> Option<bool> {
        (self.arithmetic.is_below)(low, high)
    }

    /// sgn(1 − Ω).
    pub(super) fn sign(&self) -> R {
        R::int(if self.signs.is_above_one { -1 } else { 1 })
    }

    /// `1 + cos π₁ = 2 cos² β`, without cancellation.
    pub(super) fn one_plus_cos(&self) -> R {
        R::int(2) * self.circular.cos_beta.square()
    }

    /// The residual of an identity that contains 1 + cos π₁ as written in the paper. Near Ω = 1/(2n+1) this
    /// sum is accurate only to 1/T², relative, so that |T| counts among the terms.
    pub(super) fn near_pole(&self, residual: R) -> R {
        residual / self.scale
    }

    /// K and a, by `cos(ω_d t₂ − δ) = K/α` and `sin(ω_d t₂ − δ) = qa/α`, and `G = a − Δ₀/B`.
    pub(super) fn amplitudes(&self) -> (R, R, R) {
        let (stiffness, lag) = self.linear;
        let (sine, cosine) = (self.unknowns.displacement_phase - lag).sin_cos();
        let amplitude = self.alpha * sine / stiffness;
        (self.alpha * cosine, amplitude, amplitude - self.unknowns.max_displacement)
    }

    /// The equations with the damper at a force ratio; their lengths are in units of p₀/k.
    fn system(&self, alpha: R) -> System<R> {
        System::new(self.omega, self.zeta, R::int(1) / alpha)
    }

    /// Left less right sides of eq. 21–25 with the answers put in, in units of B.
    pub(super) fn matched(&self) -> [R; 5] {
        if !self.signs.is_damped {
            return self.given.residuals(&self.unknowns);
        }
        let (u, alpha) = (&self.unknowns, self.alpha);
        let scaled = Unknowns {
            max_velocity: u.max_velocity / alpha,
            max_displacement: u.max_displacement / alpha,
            deviation: u.deviation / alpha,
            ..*u
        };
        (self.arithmetic.residuals)(&self.system(alpha), &scaled).map(|residual| residual * alpha)
    }

    /// x/B and x′/(Bω_n) at a phase after the peak displacement `delta` at the phase `phase`, by the
    /// equation of motion, at α.
    pub(super) fn falling_from(&self, (alpha, phase, delta): (R, R, R), turn: R) -> (R, R) {
        let zero = R::int(0);
        let start = Unknowns {
            velocity_phase: zero,
            displacement_phase: phase,
            max_velocity: zero,
            max_displacement: delta / alpha,
            deviation: zero,
        };
        let (x, v) = (self.arithmetic.falling)(&self.system(alpha), &start, turn);
        (x * alpha, v * alpha)
    }

    /// x/B and x′/(Bω_n) at a phase `turn` after the peak displacement of the cycle itself.
    pub(super) fn falling(&self, turn: R) -> (R, R) {
        let u = &self.unknowns;
        self.falling_from((self.alpha, u.displacement_phase, u.max_displacement), turn)
    }

    /// α_min, ω_d t₂ and Δ₀/B on the border.
    pub(super) fn on_border(&self) -> Option<(R, R, R)> {
        let (k, _, shift) = self.amplitudes();
        let (alpha, delta) = (self.get(Output::MinForceRatio)?, self.get(Output::LeastDisplacement)?);
        let (stiffness, lag) = self.linear;
        Some((alpha, lag + (stiffness * (delta + shift)).atan2(k), delta))
    }

    /// Sum and product of the multipliers of half a cycle, by `λ² + (M₁₁ + sM₂₂)λ + s e^{−2ζT} = 0`,
    /// `s = (R − 1)/(R + 1)`, `R = Ω²a − G − 2ζΩH`.
    pub(super) fn multipliers(&self) -> (R, R) {
        let (one, u) = (R::int(1), &self.unknowns);
        // M = e^{AT}, from the motions of two starts.
        let to = |delta: R| self.falling_from((self.alpha, u.displacement_phase, delta), R::pi());
        let (here, there) = (to(u.max_displacement), to(u.max_displacement + one));
        let (m11, sine) = (there.0 - here.0, here.1 - there.1);
        let m22 = m11 - R::int(2) * self.zeta * sine;
        let (k, amplitude, shift) = self.amplitudes();
        let r =
            self.omega.square() * amplitude - shift - R::int(2) * self.zeta * self.omega * k / self.linear.0;
        let s = (r - one) / (r + one);
        (-(m11 + s * m22), s * (m11 * m22 + sine.square()))
    }
}
