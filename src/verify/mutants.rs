//! Wrong formulae, one at a time: each must be detected.

use super::formulae::{Answers, Edge, Formulae};
use super::verify_by;
use crate::float::Float;
use crate::nonsticking::matching::{Given, Unknowns, pi_1};
use crate::nonsticking::stability::MultiplierPair;
use crate::nonsticking::{Border, Cycle, printed};
use crate::phase_function::{PhaseFunction, one_minus_square};
use core::f64::consts::{PI, TAU};
use core::ops::ControlFlow;

#[derive(Debug)]
struct Right;
impl<F: Float> Formulae<F> for Right {}

/// The library's answers at (Ω, α).
fn right(c: &Cycle<f64>) -> Answers<f64> {
    Right.answers(c)
}

fn right_edge(p: &PhaseFunction<f64>) -> Edge<f64> {
    Right.edge(p)
}

/// The equations that fail with these formulae.
fn failed(formulae: &dyn Formulae<f64>) -> Vec<&'static str> {
    match verify_by::<f64, ()>(formulae, |_, _| ControlFlow::Continue(())) {
        ControlFlow::Continue(verdicts) => {
            verdicts.iter().filter(|v| !v.passed).map(|v| v.statement).collect()
        }
        ControlFlow::Break(()) => panic!("ended by nobody"),
    }
}

/// The stationary points of the velocity in the rising half cycle, with the velocity at each.
fn stationary_points(c: &Cycle<f64>) -> Vec<(f64, f64)> {
    let beta = PI / 2.0 / c.ratios.omega();
    let phase = |psi: f64| (c.displacement_phase - PI / 2.0 - c.ratios.omega() * psi).rem_euclid(TAU);
    let n = 20_000;
    let velocity = |i: i32| {
        let phase = phase(beta * f64::from(2 * i - n) / f64::from(n));
        (c.velocity_at(phase), phase)
    };
    let crest = |i: &i32| velocity(*i).0 > velocity(i - 1).0 && velocity(*i).0 > velocity(i + 1).0;
    (1..n).filter(crest).map(velocity).collect()
}

macro_rules! mutants {
    ($($what:literal: $($method:ident($($arg:ident: $kind:ty),*) -> $answer:ty)+ = $body:expr;)+) => {
        /// Every mutant by name.
        fn all() -> Vec<(&'static str, Box<dyn Formulae<f64>>)> {
            let mut list: Vec<(&'static str, Box<dyn Formulae<f64>>)> = Vec::new();
            $({
                #[derive(Debug)]
                struct Wrong;
                impl Formulae<f64> for Wrong {
                    $(fn $method(&self, $($arg: $kind),*) -> $answer { $body })+
                }
                list.push(($what, Box::new(Wrong)));
            })+
            list
        }
    };
}

type C<'a> = &'a Cycle<f64>;
type P<'a> = &'a PhaseFunction<f64>;
type G<'a> = &'a Given<f64>;
type U<'a> = &'a Unknowns<f64>;

fn q(c: C<'_>) -> f64 {
    one_minus_square(c.ratios.omega())
}

fn k(c: C<'_>) -> f64 {
    PhaseFunction::new(c.ratios.omega()).unwrap().value()
}

mutants! {
    // Wrong signs.
    "K with the other sign": phase_function(p: P<'_>) -> f64 = -p.value();
    "(α − K)² for (α − K)(α + K)": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_displacement: (c.ratios.alpha() - k(c)).abs() / q(c).abs(), ..right(c) };
    "1 + Ω² for 1 − Ω² in eq. 44": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_displacement: c.max_displacement * q(c).abs() / (2.0 - q(c)), ..right(c) };
    "cos ω_d t₂ = −K/α": answers(c: C<'_>) -> Answers<f64> =
        Answers { displacement_phase: (PI - c.displacement_phase).rem_euclid(TAU), ..right(c) };
    "sin ω_d t₂ > 0 above Ω = 1, too": answers(c: C<'_>) -> Answers<f64> =
        Answers { displacement_phase: (k(c) / c.ratios.alpha()).acos(), ..right(c) };
    "eq. 49 as printed, both roots positive": answers(c: C<'_>) -> Answers<f64> = Answers {
        max_velocity: printed::max_velocity(
            c.ratios.omega(), c.ratios.alpha(), pi_1(c.ratios.omega()).cos(), c.deviation(),
        ),
        ..right(c)
    };
    "Δ₁ = B − α B sin ω_d t₁": answers(c: C<'_>) -> Answers<f64> =
        Answers { deviation: -c.deviation(), ..right(c) };
    "multipliers of the other sign": answers(c: C<'_>) -> Answers<f64> = Answers {
        multipliers: match c.multipliers().pair() {
            MultiplierPair::Complex { re, im } => MultiplierPair::Complex { re: -re, im },
            MultiplierPair::Real(a, b) => MultiplierPair::Real(-a, -b),
        },
        ..right(c)
    };
    "ρ with the other sign": rho(g: G<'_>, u: U<'_>) -> f64 = -g.rho(u);
    "a plus in eq. 31": coefficient_b(g: G<'_>, u: U<'_>) -> f64 = {
        let (s, c) = pi_1(g.omega).sin_cos();
        g.rho(u) * s + g.offset(u) * (1.0 + c)
    };
    "the waveform upside down": displacement_at(c: C<'_>, phase: f64) -> f64 = -c.displacement_at(phase);
    "friction forward in eq. 15": rising_displacement(g: G<'_>, u: U<'_>, phase: f64) -> f64 =
        g.rising_displacement(u, phase) + 2.0 * g.friction_displacement;
    "C₁ = BT": sine_coefficient(tangent: f64) -> f64 = tangent;
    "C₂ = B": cosine_coefficient() -> f64 = 1.0;
    "T² added in eq. 42": max_displacement_from_amplitude(a: f64, tangent: f64, omega: f64) -> f64 =
        a.hypot(tangent / omega);
    "K² taken off in eq. 61": turning_point_border(k: f64, q: f64, omega: f64) -> f64 =
        ((q / omega.powi(2)).powi(2) - k * k).abs().sqrt();
    "eq. 37 with its root positive": max_velocity(g: G<'_>, u: U<'_>, _sign: f64) -> f64 = g.max_velocity(u, 1.0);
    "sgn(Ω − 1) in eq. 49": max_velocity_from_phase(a: f64, omega: f64, cos_pi_1: f64, at: (f64, f64), deviation: f64, sign: f64) -> f64 =
        crate::nonsticking::max_velocity_from_phase(a, omega, cos_pi_1, at, deviation, -sign);

    // Wrong factors.
    "Δ₀ a millionth too large": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_displacement: c.max_displacement * (1.0 + 1e-6), ..right(c) };
    "V₀ over ω_n": answers(c: C<'_>) -> Answers<f64> =
        Answers { max_velocity: c.max_velocity * c.ratios.omega(), ..right(c) };
    "A₁ = 4(Δ₀/B)/α²": answers(c: C<'_>) -> Answers<f64> =
        Answers { loop_size_stiffness: c.loop_size_stiffness() / 2.0, ..right(c) };
    "A₁ = 8(Δ₀/B)/α": answers(c: C<'_>) -> Answers<f64> =
        Answers { loop_size_stiffness: c.loop_size_stiffness() * c.ratios.alpha(), ..right(c) };
    "A₂ = Ω A₁": answers(c: C<'_>) -> Answers<f64> =
        Answers { loop_size_inertia: c.loop_size_stiffness() * c.ratios.omega(), ..right(c) };
    "s = 2 r_y Δ₀": loop_size(max_displacement: f64) -> f64 = 2.0 * max_displacement;
    "A₁ and A₂ halved alike": answers(c: C<'_>) -> Answers<f64> = Answers {
        loop_size_stiffness: c.loop_size_stiffness() / 2.0,
        loop_size_inertia: c.loop_size_inertia() / 2.0,
        ..right(c)
    };
    "α* = √3 |K|": best_force_ratio_at(p: P<'_>) -> f64 = 3f64.sqrt() * p.value().abs();
    "α* = √3 |K| on the page alone": best_force_ratio(k: f64) -> f64 = 3f64.sqrt() * k.abs();
    "A₁max = 8/(|K| |1 − Ω²|)": best_loop_size_at(p: P<'_>) -> f64 =
        8.0 / (p.value() * one_minus_square(p.omega())).abs();
    "g = Ω Δ₀/B in the multipliers": answers(c: C<'_>) -> Answers<f64> = {
        let g = c.ratios.omega() * c.max_displacement;
        let s = (g - 1.0) / (g + 1.0);
        let mean = -(1.0 + s) * pi_1(c.ratios.omega()).cos() / 2.0;
        let square = mean * mean - s;
        let multipliers = if square < 0.0 {
            MultiplierPair::Complex { re: mean, im: (-square).sqrt() }
        } else {
            MultiplierPair::Real(mean + square.sqrt().copysign(mean), mean - square.sqrt().copysign(mean))
        };
        Answers { multipliers, contraction: multipliers.modulus(), ..right(c) }
    };
    "the contraction of a whole cycle": answers(c: C<'_>) -> Answers<f64> =
        Answers { contraction: c.contraction().powi(2), ..right(c) };
    "s = g − 1": multiplier_product(omega: f64, max_displacement: f64) -> f64 = omega * omega * max_displacement - 1.0;
    "T for ΩT in eq. 61": edge(p: P<'_>) -> Edge<f64> = {
        let wrong = (1.0 / p.omega().powi(2) - 1.0).abs() * 1f64.hypot(p.tangent());
        Edge { min_force_ratio: wrong, turning_point: wrong, ..right_edge(p) }
    };
    "the border a millionth too high": edge(p: P<'_>) -> Edge<f64> = {
        let edge = right_edge(p);
        Edge { min_force_ratio: edge.min_force_ratio * (1.0 + 1e-6), ..edge }
    };
    "the border a millionth too low": edge(p: P<'_>) -> Edge<f64> = {
        let edge = right_edge(p);
        Edge { min_force_ratio: edge.min_force_ratio * (1.0 - 1e-6), ..edge }
    };
    "S without 1 − Ω²": edge(p: P<'_>) -> Edge<f64> = {
        let edge = right_edge(p);
        Edge { min_force_ratio: p.value().hypot(edge.least_displacement), ..edge }
    };

    // Wrong roots.
    "another maximum of the velocity": answers(c: C<'_>) -> Answers<f64> = {
        let crests = stationary_points(c);
        let slowest = crests.into_iter().fold((f64::INFINITY, 0.0), |a, b| if b.0 < a.0 { b } else { a });
        let (max_velocity, velocity_phase) = slowest;
        let deviation = c.displacement_at(velocity_phase);
        Answers { max_velocity, velocity_phase, deviation, ..right(c) }
    };
    "the mirror image of τ*": edge(p: P<'_>) -> Edge<f64> = {
        let edge = right_edge(p);
        Edge { phase: if edge.phase == 0.0 { 0.0 } else { PI - edge.phase }, ..edge }
    };

    // Wrong ranges.
    "ω_d t₂ as printed, between π/2 and 3π/2": displacement_phase(k: f64, alpha: f64, omega: f64) -> f64 = {
        let sine = one_minus_square(omega).signum() * ((alpha - k) * (alpha + k)).sqrt() / alpha;
        printed::displacement_phase(sine)
    };
    "eq. 61 for the border below Ω = 1/2, too": edge(p: P<'_>) -> Edge<f64> = {
        let turning_point = Border::at(p).turning_point;
        Edge { min_force_ratio: turning_point, turning_point, phase: 0.0, least_displacement: 1.0 / p.omega().powi(2) }
    };
    "ω_d t₁ a turn late": answers(c: C<'_>) -> Answers<f64> =
        Answers { velocity_phase: c.velocity_phase + TAU, ..right(c) };
    "half a turn between ω_d t₁ and where it is": answers(c: C<'_>) -> Answers<f64> =
        Answers { velocity_phase: (c.velocity_phase + PI).rem_euclid(TAU), ..right(c) };
}

#[test]
fn every_wrong_formula_is_refused() {
    assert_eq!(failed(&Right), Vec::<&str>::new());
    let mutants = all();
    assert!(mutants.len() >= 40);
    let passing: Vec<_> =
        mutants.iter().filter(|(_, formulae)| failed(&**formulae).is_empty()).map(|(name, _)| name).collect();
    assert!(passing.is_empty(), "{passing:#?}");
    let of_rho = mutants.iter().find(|(name, _)| *name == "ρ with the other sign").unwrap();
    assert!(failed(&*of_rho.1).contains(&"ρ has the sign of 1 − Ω"));
}
