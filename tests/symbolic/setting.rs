//! The matching problem in symbols, on which the library's functions run.
//!
//! ρ and X = B + Δ₁ − A sin ω_d t₁ are used as symbols in place of V₀ and Δ₁, and P = A Ω cos ω_d t₂ and Q =
//! A sin ω_d t₂ in place of the sine and cosine. This change of variables keeps the algebra small.

use super::scalar::{Symbol, angle, angle_with, factor, free, reset};
use stickslip::cycle::equations::{cos_displacement_phase, sin_displacement_phase};
use stickslip::cycle::matching::{Given, Unknowns, pi_1};
use stickslip::cycle::phase_function::{one_minus_square, phase_function_of_tangent};
use stickslip::{Field, Real};

pub(crate) fn int(n: i32) -> Symbol {
    Symbol::int(n)
}

/// The matching problem in symbols.
pub(crate) struct Matching {
    pub(crate) given: Given<Symbol>,
    pub(crate) unknowns: Unknowns<Symbol>,
    pub(crate) rho: Symbol,
    pub(crate) offset: Symbol,
    /// P = A Ω cos ω_d t₂.
    pub(crate) rate: Symbol,
    /// Q = A sin ω_d t₂.
    pub(crate) height: Symbol,
    /// (sin, cos) of ω_n(t₂ − t₁).
    pub(crate) lag: (Symbol, Symbol),
    /// (sin, cos) of π₁.
    pub(crate) pi_1: (Symbol, Symbol),
    /// (sin, cos) of ω_d t₁.
    pub(crate) t1: (Symbol, Symbol),
}

impl Matching {
    /// The problem with a named angle ω_n(t₂ − t₁) and free P and Q.
    pub(crate) fn new() -> Self {
        let mut m = Self::without_lag(None);
        m.lag = angle("θ", m.given.lag(&m.unknowns));
        m
    }

    /// The problem with rational sines and cosines for π₁ and ω_n(t₂ − t₁), for which eq. 21–24 are linear. A
    /// claim that does not follow here does not follow in general.
    pub(crate) fn at_rational_angles() -> Self {
        let mut m = Self::without_lag(Some((3, 4, 5)));
        m.lag = (Symbol::ratio(5, 13), Symbol::ratio(12, 13));
        angle_with(m.given.lag(&m.unknowns), m.lag.0, m.lag.1);
        m
    }

    /// The problem without a named angle for ω_n(t₂ − t₁).
    pub(crate) fn without_lag(sin_cos_pi_1: Option<(i32, i32, i32)>) -> Self {
        reset();
        let [rate, height, offset, rho, delta] = ["P", "Q", "X", "ρ", "Δ₀"].map(free);
        let [amplitude, friction, omega, t1, t2] = ["A", "B", "Ω", "t₁", "t₂"].map(free);
        let given = Given { amplitude, friction_displacement: friction, omega };
        let of_pi_1 = match sin_cos_pi_1 {
            None => angle("π₁", pi_1(omega)),
            Some((sine, cosine, of)) => {
                let values = (Symbol::ratio(sine, of), Symbol::ratio(cosine, of));
                angle_with(pi_1(omega), values.0, values.1);
                values
            }
        };
        factor(int(1) + of_pi_1.1);
        factor(one_minus_square(omega));
        let of_t1 = angle("t₁", t1);
        angle_with(t2, height / amplitude, rate / (amplitude * omega));
        let unknowns = Unknowns {
            velocity_phase: t1,
            displacement_phase: t2,
            max_velocity: rho + amplitude * omega * of_t1.1,
            max_displacement: delta,
            deviation: offset - friction + amplitude * of_t1.0,
        };
        Self { given, unknowns, rho, offset, rate, height, lag: (int(0), int(1)), pi_1: of_pi_1, t1: of_t1 }
    }

    pub(crate) fn residuals(&self) -> [Symbol; 5] {
        self.given.residuals(&self.unknowns)
    }

    /// Eq. 21–24 as hypotheses.
    pub(crate) fn first_four(&self) -> Vec<Symbol> {
        self.residuals()[..4].to_vec()
    }

    /// 1 + cos π₁.
    pub(crate) fn one_plus(&self) -> Symbol {
        int(1) + self.pi_1.1
    }

    /// T = sin π₁/(1 + cos π₁).
    pub(crate) fn tangent(&self) -> Symbol {
        self.pi_1.0 / self.one_plus()
    }

    /// α = A(1 − Ω²)/B (eq. 5, 6, 8).
    pub(crate) fn alpha(&self) -> Symbol {
        self.given.amplitude * one_minus_square(self.given.omega) / self.given.friction_displacement
    }

    /// K(Ω).
    pub(crate) fn phase_function(&self) -> Symbol {
        phase_function_of_tangent(self.given.omega, self.tangent())
    }

    /// Eq. 40 in units of B: sin ω_d t₂ minus the library's form of it.
    pub(crate) fn equation_40(&self) -> Symbol {
        let delta = self.unknowns.max_displacement / self.given.friction_displacement;
        self.unknowns.displacement_phase.sin()
            - sin_displacement_phase(delta, self.alpha(), one_minus_square(self.given.omega))
    }

    /// Eq. 41: cos ω_d t₂ minus the library's form of it, K/α.
    pub(crate) fn equation_41(&self) -> Symbol {
        self.unknowns.displacement_phase.cos() - cos_displacement_phase(self.phase_function(), self.alpha())
    }
}
