//! The statements in ball arithmetic: the ball of each residual must contain 0 and be as small as the
//! requested number of bits implies.
//!
//! In plain arithmetic a residual is rounding or looks like it. The ball of a residual contains the exact
//! residual. A ball without 0 refutes the statement at that point; a ball with 0 bounds any possible error by
//! its size. The exact motion is represented here by a motion that is proved to exist
//! ([`stickslip::enclosed::steady`]).

use super::case::{Arithmetic, Case, Circular, Signs};
use super::statements::{self, Standing, Statement};
use super::{StatementVerdict, points};
use crate::failure::Failure;
use std::ops::ControlFlow;
use stickslip::cycle::equations::System;
use stickslip::dependencies::rug::float::Round;
use stickslip::dependencies::rug::{Float, Integer, Rational, ops::Pow};
use stickslip::enclosed::{self, Ball, Enclosure, Known, Steady};
use stickslip::float::Mp;
use stickslip::{Field, Output, Real};

/// The greatest number of bits: near the poles, the computation uses more bits than requested.
const MOST: u32 = 4096;

/// A point with exact ratios.
struct ExactPoint {
    omega: Rational,
    alpha: Rational,
    zeta: Rational,
    /// Whether the motion is proved at this point, which excludes the neighbourhood of the poles.
    with_motion: bool,
    /// Whether the motions near the border are proved.
    with_border: bool,
}

fn known(x: &Rational) -> Known {
    Known::rational(x.clone())
}

/// A rational number with forty digits.
fn written(x: &Rational) -> String {
    Mp::<2>::from_rational(x).to_string()
}

impl ExactPoint {
    /// The point at α `over` hundredths of the border, rounded to 64 bits.
    fn above_border(omega: Rational, zeta: Rational, over: i32) -> Option<Self> {
        let one = known(&Rational::from(1));
        let border = enclosed::border(&known(&omega), &known(&zeta), &one, 64).ok()?;
        let least = Float::with_val(64, &border.get(Output::MinForceRatio)?.mid);
        let alpha = (least * over / 100u32).to_rational()?;
        Some(Self { omega, alpha, zeta, with_motion: true, with_border: true })
    }

    fn is_damped(&self) -> bool {
        self.zeta > 0
    }
}

/// The points of [`points`], with exact ratios.
fn places() -> Vec<ExactPoint> {
    let mut omegas = Vec::new();
    for ((p, q), (r, s)) in points::BANDS {
        let (low, high) = (Rational::from((p, q)), Rational::from((r, s)));
        let width = Rational::from(&high - &low);
        omegas.extend((1..points::PARTS).map(|i| (Rational::from((i, points::PARTS)) * &width + &low, true)));
    }
    let (numbers, exponents) = points::BESIDE;
    for n in numbers {
        for exponent in exponents {
            let distance = Rational::from((Integer::from(1), Integer::from(10).pow(exponent)));
            let middle = Rational::from((1, n));
            omegas.push((Rational::from(&middle - &distance), exponent == 3));
            omegas.push((middle + distance, exponent == 3));
        }
    }
    let plain = omegas.into_iter().flat_map(|(omega, ordinary)| {
        points::OVER.into_iter().enumerate().filter_map(move |(i, over)| {
            let place = ExactPoint::above_border(omega.clone(), Rational::new(), over)?;
            Some(ExactPoint { with_motion: ordinary, with_border: ordinary && i == 0, ..place })
        })
    });
    let pairs =
        points::OMEGA.into_iter().flat_map(|omega| points::ZETA.into_iter().map(move |zeta| (omega, zeta)));
    let damped =
        pairs.zip(points::OVER.into_iter().cycle()).enumerate().filter_map(|(i, ((omega, zeta), over))| {
            let place =
                ExactPoint::above_border(Rational::from((omega, 100)), Rational::from((zeta, 1000)), over)?;
            Some(ExactPoint { with_border: i % 5 == 0, ..place })
        });
    plain.chain(damped).collect()
}

/// Whether every number of one ball is below every number of another (true) or above (false); `None` if the
/// balls overlap.
fn is_below<const W: usize>(low: Ball<W>, high: Ball<W>) -> Option<bool> {
    match (low.is_below(&high), high.is_below(&low)) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    }
}

/// The case of the enclosed answers at a point; `None` where this number of bits does not find them.
fn case<const W: usize>(place: &ExactPoint, answers: &enclosed::Response) -> Option<Case<Ball<W>>> {
    let found = Output::ALL.into_iter().filter_map(|output| Some((output, answers.get(output)?.ball())));
    let [omega, alpha, zeta]: [Ball<W>; 3] =
        [&place.omega, &place.alpha, &place.zeta].map(|ratio| known(ratio).ball());
    let one = Ball::int(1);
    let (sin_beta, cos_beta) = (Ball::pi() / (Ball::int(2) * omega)).sin_cos();
    let tangent = sin_beta / cos_beta;
    let answer = |output| answers.get(output).map(Enclosure::ball::<W>);
    let signs = Signs {
        is_damped: place.is_damped(),
        is_above_one: place.omega > 1,
        is_late: is_below(answer(Output::DisplacementPhase)?, answer(Output::VelocityPhase)?)?,
    };
    let circular = Circular { k: (one - omega) * (one + omega) * tangent / omega, tangent, cos_beta };
    let arithmetic =
        Arithmetic { residuals: System::residuals_of_balls, falling: System::falling_of_balls, is_below };
    Case::new(arithmetic, (omega, alpha, zeta), found.collect(), circular, signs)
}

/// The residual of a statement at a point, relative to its terms.
#[derive(Debug, Clone)]
struct Residue {
    /// An upper and a lower bound of its magnitude.
    most: Float,
    least: Float,
    has_zero: bool,
}

impl Residue {
    /// A residual of which nothing is known.
    fn unknown() -> Self {
        let infinite = Float::with_val(64, stickslip::dependencies::rug::float::Special::Infinity);
        Self { most: infinite, least: Float::new(64), has_zero: true }
    }

    fn of<const W: usize>(residual: Ball<W>, scale: Ball<W>) -> Self {
        let Some(Enclosure { mid, rad, .. }) = Enclosure::of(&(residual / scale)) else {
            return Self::unknown();
        };
        let size = Float::with_val_round(64, mid.abs_ref(), Round::Up).0;
        let below = Float::with_val_round(64, mid.abs_ref(), Round::Down).0;
        Self {
            most: Float::with_val_round(64, &size + &rad, Round::Up).0,
            least: Float::with_val_round(64, &below - &rad, Round::Down).0.max(&Float::new(64)),
            has_zero: below <= rad,
        }
    }

    /// A residual of one unit if the condition fails, and of zero if it holds.
    fn count(is_right: bool) -> Self {
        let size = Float::with_val(64, u32::from(!is_right));
        Self { most: size.clone(), least: size, has_zero: is_right }
    }

    /// The bound in units of the last of `bits` bits.
    fn in_last_places(&self, bits: u32) -> f64 {
        Float::with_val(64, &self.most << bits).to_f64()
    }

    /// Whether the bound is below one unit in the last of `bits` bits.
    fn is_small(&self, bits: u32) -> bool {
        self.in_last_places(bits) <= 1.0
    }
}

/// The residuals of all statements at a point, with enough bits to bring them to one unit in the last of
/// `bits`.
fn residues(place: &ExactPoint, bits: u32) -> Vec<Option<Residue>> {
    let count = statements::all::<Ball<2>>().len();
    let mut last = vec![Some(Residue::unknown()); count];
    let one = known(&Rational::from(1));
    macro_rules! at {
        ($($width:literal)*) => {$(
            let width = Mp::<$width>::BITS;
            if width >= bits + 64
                && let Ok(answers) = enclosed::response(
                    &known(&place.omega), &known(&place.alpha), &known(&place.zeta), &one, width - 64,
                )
                && let Some(case) = case::<$width>(place, &answers)
            {
                let found = statements::all().into_iter().map(|statement: Statement<_, _>| {
                    Some(Residue::of((statement.residual)(&case)?, case.scale))
                });
                let found: Vec<_> = found.collect();
                // A residual that excludes 0 needs no more bits.
                if found.iter().flatten().all(|residue| residue.is_small(bits) || !residue.has_zero) {
                    return found;
                }
                last = found;
            }
        )*};
    }
    at!(2 5 17 65 129);
    last
}

/// Equations and statements about motions that are proved to exist from the equation of motion alone.
const OF_MOTIONS: [(&str, &str); 7] = [
    ("44", "Δ₀ is that of a motion proved to exist"),
    ("43", "ω_d t₂ is that of its maximum"),
    ("49", "V₀ is the greatest velocity of that motion"),
    ("62", "that motion has two reversals a cycle and no stop"),
    ("λ", "the sum and the product of λ² are those of its linearised cycle"),
    ("λ", "the contraction is the larger |λ| of that cycle"),
    ("62", "just below the border a motion with stops is proved, and one without above"),
];

fn motion(place: &ExactPoint, alpha: &Rational, bits: u32) -> Option<Steady> {
    let one = known(&Rational::from(1));
    enclosed::steady(&known(&place.omega), &known(alpha), &known(&place.zeta), &one, bits).ok()?.ok()
}

/// The residuals at a point, in the order of [`OF_MOTIONS`].
fn residues_of_motions(place: &ExactPoint, bits: u32) -> Vec<Option<Residue>> {
    if !place.with_motion {
        return vec![None; OF_MOTIONS.len()];
    }
    macro_rules! at {
        ($($width:literal)*) => {$(
            if Mp::<$width>::BITS >= bits + 64 {
                return against::<$width>(place, bits)
                    .unwrap_or_else(|| vec![Some(Residue::unknown()); OF_MOTIONS.len()]);
            }
        )*};
    }
    at!(5 17 65 129);
    Vec::new()
}

fn against<const W: usize>(place: &ExactPoint, bits: u32) -> Option<Vec<Option<Residue>>> {
    let one = known(&Rational::from(1));
    let (omega, alpha, zeta) = (known(&place.omega), known(&place.alpha), known(&place.zeta));
    let answers = enclosed::response(&omega, &alpha, &zeta, &one, Mp::<W>::BITS - 64).ok()?;
    let case = case::<W>(place, &answers)?;
    let motion = motion(place, &place.alpha, bits + 8)?;
    let (u, ball) = (&case.unknowns, Enclosure::ball::<W>);
    // The motion begins with a reversal: the sine of the remaining phase to t₂, or to t₂ and half a turn.
    let late = (u.displacement_phase - ball(&motion.start.0)).sin();
    // λ₁² + λ₂² = (λ₁ + λ₂)² − 2 λ₁λ₂
    let (sum, determinant) = case.multipliers();
    let [(a, b), (p, q)] = motion.multipliers.each_ref().map(|(re, im)| (ball(re), ball(im)));
    let (trace, product) = (a + p, a * p - b * q);
    let by_trace = sum.square() - Ball::int(2) * determinant - trace;
    let by_product = determinant.square() - product;
    let (first, second) = (a.hypot(b), p.hypot(q));
    let largest = match case.is_below(first, second) {
        Some(true) => second,
        Some(false) => first,
        // The two complex multipliers have the same modulus.
        None => (first + second) / Ball::int(2),
    };
    let slides = motion.sticks_per_cycle == 0 && motion.velocity_zeros_per_cycle == 2;
    let contraction = case.get(Output::Contraction)?;
    Some(vec![
        Some(Residue::of(ball(&motion.max_displacement) - u.max_displacement, case.scale)),
        Some(Residue::of(late * u.max_displacement, case.scale)),
        Some(Residue::of(ball(&motion.max_velocity) * case.omega - u.max_velocity, case.scale)),
        Some(Residue::count(slides)),
        Some(Residue::of(by_trace.abs() + by_product.abs(), case.scale)),
        Some(Residue::of(contraction.square() - largest, Ball::int(1))),
        place.with_border.then(|| beside_the_border(place, &answers)).flatten(),
    ])
}

/// The stops of the motions at α_min (1 ∓ 2⁻¹⁶), except next to a pole, where the body need not stop below
/// the border.
fn beside_the_border(place: &ExactPoint, answers: &enclosed::Response) -> Option<Residue> {
    let turns = Rational::from(place.omega.recip_ref());
    let nearest = (Rational::from(&turns - 1u32) / 2u32).round() * 2u32 + 1u32;
    if (turns - nearest).abs() * 128u32 <= 1 {
        return None;
    }
    let least = Float::with_val(64, &answers.get(Output::MinForceRatio)?.mid);
    let little = Float::with_val(64, &least >> 16u32);
    let stops = |alpha: Float| Some(motion(place, &alpha.to_rational()?, 64)?.sticks_per_cycle);
    let (below, above) = (stops(Float::with_val(64, &least - &little)), stops(least + little));
    Some(Residue::count(below.is_some_and(|stops| stops > 0) && above == Some(0)))
}

/// The worst residual of a statement so far.
struct BallTally {
    equation: &'static str,
    words: &'static str,
    standing: Standing,
    points: usize,
    worst: Option<(Residue, usize)>,
    all_pass: bool,
}

impl BallTally {
    fn new((equation, words, standing): (&'static str, &'static str, Standing)) -> Self {
        Self { equation, words, standing, points: 0, worst: None, all_pass: true }
    }

    fn add(&mut self, residue: Residue, at: usize, bits: u32) {
        self.points += 1;
        let worst = self.worst.as_ref().map(|(worst, _)| worst);
        let (passes, is_worse) = match self.standing {
            Standing::Holds => (
                residue.has_zero && residue.is_small(bits),
                worst.is_none_or(|worst| residue.most > worst.most),
            ),
            Standing::Refuted => (!residue.has_zero, worst.is_none_or(|worst| residue.least < worst.least)),
        };
        self.all_pass &= passes;
        if is_worse {
            self.worst = Some((residue, at));
        }
    }

    fn verdict(self, places: &[ExactPoint], bits: u32) -> StatementVerdict {
        let place = self.worst.as_ref().and_then(|(_, at)| places.get(*at));
        StatementVerdict {
            equation: self.equation,
            statement: self.words,
            standing: self.standing,
            points: self.points,
            worst: self.worst.as_ref().map_or(0.0, |(residue, _)| match self.standing {
                Standing::Holds => residue.in_last_places(bits),
                Standing::Refuted => residue.least.to_f64(),
            }),
            at: place.map(|place| (written(&place.omega), written(&place.alpha))),
            damping_ratio: place.filter(|place| place.is_damped()).map(|place| written(&place.zeta)),
            passed: self.all_pass && self.points > 0,
        }
    }
}

/// Checks every statement in ball arithmetic at a set of points.
///
/// A statement passes if, at every point, its ball contains 0 and lies within one unit in the last of `bits`
/// bits of the statement's terms; [`StatementVerdict::worst`] is the greatest distance from 0 in those units. A
/// statement that is wrong as printed passes if every ball excludes 0; `worst` is then the least certain
/// relative residual.
pub(super) fn verdicts(
    bits: u32,
    mut step: impl FnMut(usize, usize) -> ControlFlow<Failure>,
) -> Result<ControlFlow<Failure, Vec<StatementVerdict>>, Failure> {
    if !(1..=MOST).contains(&bits) {
        let text = format!("--bits {bits}: number of bits {bits} must be ≥ 1 and ≤ {MOST}");
        return Err(Failure::Input(text));
    }
    let places = places();
    let of_answers = statements::all::<Ball<2>>();
    let of_answers = of_answers.iter().map(|s| (s.equation, s.words, s.standing));
    let of_motions = OF_MOTIONS.into_iter().map(|(equation, words)| (equation, words, Standing::Holds));
    let mut tallies: Vec<_> = of_answers.chain(of_motions).map(BallTally::new).collect();
    for (number, place) in places.iter().enumerate() {
        if let ControlFlow::Break(failure) = step(number, places.len()) {
            return Ok(ControlFlow::Break(failure));
        }
        let found = residues(place, bits).into_iter().chain(residues_of_motions(place, bits));
        for (tally, residue) in tallies.iter_mut().zip(found) {
            if let Some(residue) = residue {
                tally.add(residue, number, bits);
            }
        }
    }
    if let ControlFlow::Break(failure) = step(places.len(), places.len()) {
        return Ok(ControlFlow::Break(failure));
    }
    Ok(ControlFlow::Continue(tallies.into_iter().map(|tally| tally.verdict(&places, bits)).collect()))
}
