//! Wrong formulae and wrong answers, one at a time: some ball must exclude 0.

use super::super::formulae::{Formulae, Library};
use super::point::{Found, places};
use super::{Standing, residues, rows};
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use crate::nonsticking::matching::{Given, Unknowns, pi_1};

const W: usize = 5;
type B = Ball<W>;
type G<'a> = &'a Given<B>;
type U<'a> = &'a Unknowns<B>;

/// A statement that a ball without 0 refutes at some point.
fn refuted(formulae: &dyn Formulae<B>, alter: fn(Found<W>) -> Found<W>) -> Option<&'static str> {
    let rows = rows::<W>();
    // One α at each of several frequencies on both sides of 1 and of the poles.
    places().iter().step_by(7).filter(|place| place.with_motion).find_map(|place| {
        let found = residues(place, formulae, alter)?;
        let wrong = |(residue, standing): (Option<super::Residue>, Standing)| {
            residue.is_some_and(|residue| standing == Standing::Holds && !residue.has_zero)
        };
        let mut pairs = found.into_iter().zip(&rows);
        pairs.find(|(residue, row)| wrong((*residue, row.standing))).map(|(_, row)| row.statement)
    })
}

macro_rules! formulae {
    ($($what:literal: $method:ident($($arg:ident: $kind:ty),*) -> $answer:ty = $body:expr;)+) => {
        fn wrong_formulae() -> Vec<(&'static str, Box<dyn Formulae<B>>)> {
            vec![$({
                #[derive(Debug)]
                struct Wrong;
                impl Formulae<B> for Wrong {
                    fn $method(&self, $($arg: $kind),*) -> $answer { $body }
                }
                ($what, Box::new(Wrong) as Box<dyn Formulae<B>>)
            }),+]
        }
    };
}

formulae! {
    "ρ with the other sign": rho(g: G<'_>, u: U<'_>) -> B = -g.rho(u);
    "no sine in eq. 30": coefficient_a(g: G<'_>, u: U<'_>) -> B =
        g.rho(u) * (B::int(1) + pi_1(g.omega).cos()) + g.offset(u) * pi_1(g.omega).cos();
    "a plus in eq. 31": coefficient_b(g: G<'_>, u: U<'_>) -> B = {
        let (s, c) = pi_1(g.omega).sin_cos();
        g.rho(u) * s + g.offset(u) * (B::int(1) + c)
    };
    "friction forward in eq. 15": rising_displacement(g: G<'_>, u: U<'_>, phase: B) -> B =
        g.rising_displacement(u, phase) + B::int(2) * g.friction_displacement;
    "the drive upside down in eq. 16": falling_displacement(g: G<'_>, u: U<'_>, phase: B) -> B =
        g.falling_displacement(u, phase) - B::int(2) * g.amplitude * phase.sin();
    "the velocity of eq. 15 without Ω": rising_velocity(g: G<'_>, u: U<'_>, phase: B) -> B =
        g.rising_velocity(u, phase) + g.amplitude * (B::int(1) - g.omega) * phase.cos();
    "the velocity of eq. 16 a part in 10⁴⁰ too large, at rest": falling_velocity(g: G<'_>, u: U<'_>, phase: B) -> B =
        g.falling_velocity(u, phase) + tiny();
    "eq. 21 a part in 10⁴⁰ off": residuals(g: G<'_>, u: U<'_>) -> [B; 5] = {
        let [a, b, c, d, e] = g.residuals(u);
        [a + tiny(), b, c, d, e]
    };
    "B² for 2B² in eq. 36": squared_rho(g: G<'_>, u: U<'_>) -> B =
        g.squared_rho(u) - g.friction_displacement.square() / (B::int(1) + pi_1(g.omega).cos());
    "eq. 37 with its root positive": max_velocity(g: G<'_>, u: U<'_>, _sign: B) -> B = g.max_velocity(u, B::int(1));
    "T² added in eq. 42": max_displacement_from_amplitude(a: B, tangent: B, omega: B) -> B = a.hypot(tangent / omega);
    "(α − K)² for (α − K)(α + K)": max_displacement(k: B, alpha: B, q: B) -> B = (alpha - k).abs() / q.abs();
    "Δ₀ for (1 − Ω²)Δ₀ in eq. 40": sin_displacement_phase(delta: B, alpha: B, _q: B) -> B = delta / alpha;
    "cos ω_d t₂ = −K/α": cos_displacement_phase(k: B, alpha: B) -> B = -(k / alpha);
    "cosine for sine in eq. 46": velocity_phase_residual(a: B, omega: B, pi_1: (B, B), lag: B, sine: B) -> B =
        (B::int(1) + pi_1.1) * lag.sin() + pi_1.0 * lag.cos() + a * omega.square() * (B::int(1) + pi_1.1) * sine;
    "Δ₁ = α sin ω_d t₁ + 1": deviation(alpha: B, sine: B) -> B = alpha * sine + B::int(1);
    "sgn(Ω − 1) in eq. 49":
        max_velocity_from_phase(a: B, omega: B, cos_pi_1: B, at: (B, B), deviation: B, sign: B) -> B =
        crate::nonsticking::max_velocity_from_phase(a, omega, cos_pi_1, at, deviation, -sign);
    "C₁ = BT": sine_coefficient(tangent: B) -> B = tangent;
    "C₂ = B": cosine_coefficient() -> B = B::int(1);
    "twice the friction in eq. 57": slip_excess(alpha: B, sine: B, x: B) -> B =
        crate::nonsticking::border::slip_excess(alpha, sine, B::int(1), x, B::int(2));
    "1 for Ω² in eq. 60": turning_point_residual(alpha: B, omega: B, tangent: B) -> B =
        crate::nonsticking::border::turning_point_residual(B::int(1), alpha, omega, tangent) + omega.square() - B::int(1);
    "K² taken off in eq. 61": turning_point_border(k: B, q: B, omega: B) -> B =
        ((q / omega.square()).square() - k.square()).abs().sqrt();
    "s = 2 r_y Δ₀": loop_size(delta: B) -> B = B::int(2) * delta;
    "A₁ = 8(Δ₀/B)/α": loop_size_stiffness(delta: B, alpha: B) -> B = B::int(8) * delta / alpha;
    "α* = √3 |K|": best_force_ratio(k: B) -> B = B::int(3).sqrt() * k.abs();
    "A₁max = 8/(|K| |1 − Ω²|)": best_loop_size(k: B, q: B) -> B = B::int(8) / (k * q).abs();
    "A₂ = Ω A₁": loop_size_inertia(size: B, omega: B) -> B = size * omega;
    "s = g − 1": multiplier_product(omega: B, delta: B) -> B = omega.square() * delta - B::int(1);
}

/// 10⁻⁴⁰.
fn tiny() -> B {
    (0..40).fold(B::int(1), |x, _| x / B::int(10))
}

/// A number increased by one part in 10⁴⁰.
fn off(x: B) -> B {
    x + x * tiny()
}

/// A wrong answer and its name.
type Wrong = (&'static str, fn(Found<W>) -> Found<W>);
const WRONG_ANSWERS: [Wrong; 18] = [
    ("K with the other sign", |mut f| {
        f.point.k = -f.point.k;
        f
    }),
    ("K a part in 10⁴⁰ off", |mut f| {
        f.point.k = off(f.point.k);
        f
    }),
    ("Δ₀ a part in 10⁴⁰ off", |mut f| {
        f.answers.max_displacement = off(f.answers.max_displacement);
        f
    }),
    ("ω_d t₂ a part in 10⁴⁰ off", |mut f| {
        f.answers.displacement_phase = off(f.answers.displacement_phase);
        f
    }),
    ("ω_d t₂ mirrored", |mut f| {
        f.answers.displacement_phase = B::pi() - f.answers.displacement_phase;
        f
    }),
    ("V₀ over ω_n", |mut f| {
        f.answers.max_velocity = f.answers.max_velocity * f.point.given.omega;
        f
    }),
    ("V₀ a part in 10⁴⁰ off", |mut f| {
        f.answers.max_velocity = off(f.answers.max_velocity);
        f
    }),
    ("ω_d t₁ a part in 10⁴⁰ off", |mut f| {
        f.answers.velocity_phase = off(f.answers.velocity_phase);
        f
    }),
    ("ω_d t₁ half a turn off", |mut f| {
        f.answers.velocity_phase = f.answers.velocity_phase + B::pi();
        f
    }),
    ("Δ₁ with the other sign", |mut f| {
        f.answers.deviation = -f.answers.deviation;
        f
    }),
    ("A₁ a part in 10⁴⁰ off", |mut f| {
        f.answers.loop_size_stiffness = off(f.answers.loop_size_stiffness);
        f
    }),
    ("A₂ a part in 10⁴⁰ off", |mut f| {
        f.answers.loop_size_inertia = off(f.answers.loop_size_inertia);
        f
    }),
    ("the contraction of a whole cycle", |mut f| {
        f.answers.contraction = f.answers.contraction.square();
        f
    }),
    ("α* a part in 10⁴⁰ off", |mut f| {
        f.point.best.0 = off(f.point.best.0);
        f
    }),
    ("A₁max a part in 10⁴⁰ off", |mut f| {
        f.point.best.1 = off(f.point.best.1);
        f
    }),
    ("the border a part in 10⁴⁰ off", |mut f| {
        f.edge.min_force_ratio = off(f.edge.min_force_ratio);
        f
    }),
    ("S a part in 10⁴⁰ off", |mut f| {
        f.edge.least_displacement = off(f.edge.least_displacement);
        f
    }),
    ("the mirror image of τ*", |mut f| {
        f.edge.phase = B::pi() - f.edge.phase;
        f
    }),
];

#[test]
fn every_wrong_formula_is_excluded_by_a_ball() {
    assert_eq!(refuted(&Library, |found| found), None);
    let formulae = wrong_formulae();
    let passing = formulae.iter().filter(|(_, wrong)| refuted(&**wrong, |found| found).is_none());
    let passing: Vec<_> = passing.map(|(what, _)| what).collect();
    assert!(passing.is_empty(), "{passing:#?}");
    let passing = WRONG_ANSWERS.iter().filter(|(_, alter)| refuted(&Library, *alter).is_none());
    let passing: Vec<_> = passing.map(|(what, _)| what).collect();
    assert!(passing.is_empty() && formulae.len() + WRONG_ANSWERS.len() > 45, "{passing:#?}");
}
