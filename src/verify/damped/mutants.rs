//! Wrong formulae with damping, one at a time: each must be detected.

use super::formulae::{Answers, Edge, Formulae};
use super::{Library, verify_by};
use crate::nonsticking::Cycle;
use crate::nonsticking::damped::half_period;
use crate::nonsticking::damped::half_period::HalfPeriod;
use crate::nonsticking::stability::MultiplierPair;
use crate::ratios::Ratios;
use core::f64::consts::{PI, TAU};
use core::ops::ControlFlow;

type C<'a> = &'a Cycle<f64>;
type R<'a> = &'a Ratios<f64>;

fn right(c: C<'_>) -> Answers<f64> {
    Library.answers(c)
}

fn edge(r: R<'_>) -> Edge<f64> {
    Library.edge(r)
}

fn half(c: C<'_>) -> HalfPeriod<f64> {
    half_period(&c.ratios)
}

/// α_min computed from another S.
fn border(r: R<'_>, s: f64) -> Edge<f64> {
    let h = half_period(r);
    Edge { min_force_ratio: h.stiffness * s.hypot(h.h), phase: 0.0, least_displacement: s - h.shift }
}

/// a = Δ₀/B + G.
fn amplitude(c: C<'_>) -> f64 {
    c.max_displacement + half(c).shift
}

/// Roots of λ² + sum λ + product.
fn roots(sum: f64, product: f64) -> MultiplierPair<f64> {
    let disc = sum * sum / 4.0 - product;
    if disc < 0.0 {
        return MultiplierPair::Complex { re: -sum / 2.0, im: (-disc).sqrt() };
    }
    let larger = -(sum / 2.0) - disc.sqrt().copysign(sum);
    MultiplierPair::Real(larger, product / larger)
}

/// Multipliers and contraction computed from another R and another area factor.
fn multipliers(c: C<'_>, r: f64, area: f64) -> Answers<f64> {
    let h = half(c);
    let s = (r - 1.0) / (r + 1.0);
    let turned = h.free.zeta * h.sine;
    let pair = roots((h.cosine + turned) + s * (h.cosine - turned), s * area);
    Answers { multipliers: pair, contraction: pair.modulus(), ..right(c) }
}

fn deceleration(c: C<'_>) -> f64 {
    let h = half(c);
    h.omega * h.omega * amplitude(c) - h.shift - h.lag.0 * h.h
}

macro_rules! mutants {
    ($($what:literal: $method:ident($arg:ident: $kind:ty) -> $answer:ty = $body:expr;)+) => {
        fn all() -> Vec<(&'static str, Box<dyn Formulae<f64>>)> {
            let mut list: Vec<(&'static str, Box<dyn Formulae<f64>>)> = Vec::new();
            $({
                #[derive(Debug)]
                struct Wrong;
                impl Formulae<f64> for Wrong {
                    fn $method(&self, $arg: $kind) -> $answer { $body }
                }
                list.push(($what, Box::new(Wrong)));
            })+
            list
        }
    };
}

mutants! {
    "Δ₀ without G": answers(c: C<'_>) -> Answers<f64> = Answers { max_displacement: amplitude(c), ..right(c) };
    "Δ₀ with +G": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_displacement: amplitude(c) + half(c).shift, ..right(c) };
    "K without q": answers(c: C<'_>) -> Answers<f64> = {
        let (h, alpha) = (half(c), c.ratios.alpha());
        Answers { max_displacement: ((alpha / h.stiffness).powi(2) - (h.h / h.stiffness).powi(2)).sqrt() - h.shift, ..right(c) }
    };
    "|1 − Ω²| for q": answers(c: C<'_>) -> Answers<f64> = {
        let (h, alpha) = (half(c), c.ratios.alpha());
        Answers { max_displacement: ((alpha / h.lag.1.abs().max(1e-3)).powi(2) - h.h.powi(2)).abs().sqrt() - h.shift, ..right(c) }
    };
    "t₂ without the lag": answers(c: C<'_>) -> Answers<f64> = {
        let h = half(c);
        Answers { displacement_phase: amplitude(c).atan2(h.h).rem_euclid(TAU), ..right(c) }
    };
    "t₂ with the lag subtracted": answers(c: C<'_>) -> Answers<f64> = {
        let h = half(c);
        Answers { displacement_phase: (amplitude(c).atan2(h.h) - h.phase_lag()).rem_euclid(TAU), ..right(c) }
    };
    "cos(ω_d t₂ − δ) = −K/α": answers(c: C<'_>) -> Answers<f64> = {
        let h = half(c);
        Answers { displacement_phase: (h.phase_lag() + amplitude(c).atan2(-h.h)).rem_euclid(TAU), ..right(c) }
    };
    "V₀ of the drive alone": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_velocity: c.ratios.alpha() / half(c).stiffness, ..right(c) };
    "V₀ a part in 10⁹ too large": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_velocity: c.max_velocity * (1.0 + 1e-9), ..right(c) };
    "t₁ a quarter turn before t₂": answers(c: C<'_>) -> Answers<f64> =
        Answers { velocity_phase: (c.displacement_phase - PI / 2.0).rem_euclid(TAU), ..right(c) };
    "Δ₁ without the damper's force": answers(c: C<'_>) -> Answers<f64> =
        Answers { deviation: c.ratios.alpha() * c.velocity_phase.sin() - 1.0, ..right(c) };
    "A₁ by a for Δ₀": answers(c: C<'_>) -> Answers<f64> =
        Answers { loop_size_stiffness: 8.0 * amplitude(c) / c.ratios.alpha().powi(2), ..right(c) };
    "A₂ without Ω²": answers(c: C<'_>) -> Answers<f64> =
        Answers { loop_size_inertia: c.loop_size_stiffness() * 1.0001, ..right(c) };
    "work of the damper without 4G": answers(c: C<'_>) -> Answers<f64> =
        Answers { damper_work: c.damper_work() - 4.0 * half(c).shift, ..right(c) };
    "work of the damper of the drive alone": answers(c: C<'_>) -> Answers<f64> = {
        let h = half(c);
        let driven = h.omega * c.ratios.alpha() / h.stiffness;
        Answers { damper_work: 2.0 * h.free.zeta * h.period * driven * driven + 4.0 * h.shift, ..right(c) }
    };
    "work of the damper doubled": answers(c: C<'_>) -> Answers<f64> =
        Answers { damper_work: 2.0 * c.damper_work(), ..right(c) };
    "multipliers without the decay of the area": answers(c: C<'_>) -> Answers<f64> = multipliers(c, deceleration(c), 1.0);
    "the area of a whole cycle": answers(c: C<'_>) -> Answers<f64> = multipliers(c, deceleration(c), half(c).decay.powi(4));
    "R without G": answers(c: C<'_>) -> Answers<f64> =
        multipliers(c, deceleration(c) + half(c).shift, half(c).decay.powi(2));
    "R without 2ζΩH": answers(c: C<'_>) -> Answers<f64> =
        multipliers(c, deceleration(c) + half(c).lag.0 * half(c).h, half(c).decay.powi(2));
    "R by Δ₀": answers(c: C<'_>) -> Answers<f64> =
        multipliers(c, half(c).omega.powi(2) * c.max_displacement, half(c).decay.powi(2));
    "the smaller multiplier as contraction": answers(c: C<'_>) -> Answers<f64> =
        Answers { contraction: c.contraction() * 0.999, ..right(c) };
    "border: 1/Ω² for S": edge(r: R<'_>) -> Edge<f64> = border(r, 1.0 / r.omega().powi(2));
    "border without G": edge(r: R<'_>) -> Edge<f64> = {
        let h = half_period(r);
        border(r, (1.0 + h.lag.0 * h.h) / r.omega().powi(2))
    };
    "border without 2ζΩH": edge(r: R<'_>) -> Edge<f64> = border(r, (1.0 + half_period(r).shift) / r.omega().powi(2));
    "the turning point alone": edge(r: R<'_>) -> Edge<f64> = border(r, half_period(r).holding() / r.omega().powi(2));
    "a border a part in 10⁹ too low": edge(r: R<'_>) -> Edge<f64> = {
        let e = edge(r);
        Edge { min_force_ratio: e.min_force_ratio * (1.0 - 1e-9), ..e }
    };
    "a border a part in 10⁹ too high": edge(r: R<'_>) -> Edge<f64> = {
        let e = edge(r);
        Edge { min_force_ratio: e.min_force_ratio * (1.0 + 1e-9), ..e }
    };
    "τ* half a turn early": edge(r: R<'_>) -> Edge<f64> = {
        let e = edge(r);
        Edge { phase: e.phase + 1e-3, ..e }
    };
    "least Δ₀ by S": edge(r: R<'_>) -> Edge<f64> = {
        let e = edge(r);
        Edge { least_displacement: e.least_displacement + half_period(r).shift, ..e }
    };
    "α* of ζ = 0": best(r: R<'_>) -> (f64, f64) = (2f64.sqrt() * half_period(r).k.abs(), Library.best(r).1);
    "A₁max of ζ = 0": best(r: R<'_>) -> (f64, f64) = {
        let h = half_period(r);
        (Library.best(r).0, 4.0 / (h.k.abs() * h.stiffness))
    };
}

/// The identities that fail with these formulae.
fn failed(formulae: &dyn Formulae<f64>) -> Vec<&'static str> {
    match verify_by::<f64, ()>(formulae, |_| ControlFlow::Continue(())) {
        ControlFlow::Continue(verdicts) => {
            verdicts.iter().filter(|v| !v.passed).map(|v| v.statement).collect()
        }
        ControlFlow::Break(()) => panic!("ended by nobody"),
    }
}

#[test]
fn each_wrong_formula_is_refused_and_the_right_ones_are_not() {
    assert_eq!(failed(&Library), Vec::<&str>::new());
    let accepted: Vec<_> = all().into_iter().filter(|(_, wrong)| failed(wrong.as_ref()).is_empty()).collect();
    assert!(accepted.is_empty(), "{:?}", accepted.iter().map(|(what, _)| *what).collect::<Vec<_>>());
}
