//! The statements in ball arithmetic: the ball of each residual must contain 0 and be as small as the
//! requested number of bits implies.
//!
//! In plain arithmetic a residual is rounding or looks like it. The ball of a residual contains the exact
//! residual. A ball without 0 refutes the statement at that point; a ball with 0 bounds any possible error by
//! its size. The exact motion is represented here by a motion that is proved to exist
//! ([`stickslip::enclosed::KnownRatios::steady`]).

use super::case::{Arithmetic, Case, Circular, Signs};
use super::points::{CheckPoint, Numbers};
use super::statements::{self, Statement};
use super::verdict::{self, Place, Residue, Standing, StatementVerdict};
use crate::failure::Failure;
use stickslip::cycle::equations::System;
use stickslip::dependencies::rug::float::Round;
use stickslip::dependencies::rug::{Float, Rational};
use stickslip::enclosed::{self, Ball, Enclosure, InBalls, Known, KnownRatios, Steady};
use stickslip::float::Mp;
use stickslip::{Field, Output, Real};

/// The greatest number of bits: near the poles, the computation uses more bits than requested.
const MOST: u32 = 4096;

/// A point with exact ratios.
struct ExactRatios {
    omega: Rational,
    alpha: Rational,
    zeta: Rational,
}

fn known(x: &Rational) -> Known {
    Known::rational(x.clone())
}

impl ExactRatios {
    /// The point at α `over` hundredths of the border, rounded to 64 bits.
    fn above_border(omega: Rational, zeta: Rational, over: i32) -> Option<Self> {
        let border = KnownRatios::new(&known(&omega)).with_damping_ratio(&known(&zeta)).response(64).ok()?;
        let least = Float::with_val(64, &border.get(Output::MinForceRatio)?.mid);
        let alpha = (least * over / 100u32).to_rational()?;
        Some(Self { omega, alpha, zeta })
    }

    /// The ratios here with another force ratio.
    fn ratios(&self, alpha: &Rational) -> KnownRatios {
        let [omega, alpha, zeta] = [&self.omega, alpha, &self.zeta].map(known);
        KnownRatios::new(&omega).with_force_ratio(&alpha).with_damping_ratio(&zeta)
    }

    /// The enclosed answers here.
    fn answers(&self, bits: u32) -> Option<enclosed::Response> {
        self.ratios(&self.alpha).response(bits).ok()
    }

    /// The motion at a force ratio, if it is proved.
    fn motion(&self, alpha: &Rational, bits: u32) -> Option<Steady> {
        self.ratios(alpha).steady(bits).ok()?.ok()
    }

    fn is_damped(&self) -> bool {
        self.zeta > 0
    }

    /// The ratios with forty digits.
    fn written(&self) -> Place {
        let [omega, alpha, zeta] =
            [&self.omega, &self.alpha, &self.zeta].map(|x| Mp::<2>::from(x).to_string());
        Place { omega: Some(omega), alpha: Some(alpha), damping_ratio: self.is_damped().then_some(zeta) }
    }
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
fn case<const W: usize>(place: &ExactRatios, answers: &enclosed::Response) -> Option<Case<Ball<W>>> {
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
    let arithmetic = Arithmetic { residuals: System::residuals, falling: System::falling, is_below };
    Case::new(arithmetic, (omega, alpha, zeta), found.collect(), circular, signs)
}

/// A residual of which nothing is known.
const UNKNOWN: Residue = Residue { units: f64::INFINITY, least: 0.0, is_zero: false, is_off: false };

/// The residual of a statement, in units in the last of `bits` bits: small where its ball contains 0 and lies within one.
fn residue<const W: usize>(residual: Ball<W>, scale: Ball<W>, bits: u32) -> Residue {
    let Some(Enclosure { mid, rad, .. }) = Enclosure::of(&(residual / scale)) else { return UNKNOWN };
    let size = Float::with_val_round(64, mid.abs_ref(), Round::Up).0;
    let below = Float::with_val_round(64, mid.abs_ref(), Round::Down).0;
    let most = Float::with_val_round(64, &size + &rad, Round::Up).0;
    let units = Float::with_val(64, &most << bits).to_f64();
    let least = Float::with_val_round(64, &below - &rad, Round::Down).0.max(&Float::new(64));
    Residue { units, least: least.to_f64(), is_zero: below <= rad && units <= 1.0, is_off: below > rad }
}

/// A residual of one unit if the condition fails, and of zero if it holds.
fn count(is_right: bool, bits: u32) -> Residue {
    let size = f64::from(u8::from(!is_right));
    Residue { units: size * 2f64.powi(bits as i32), least: size, is_zero: is_right, is_off: !is_right }
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

/// The residuals of all statements at a point, in the order of [`statements::all`] and of [`OF_MOTIONS`].
struct Residues<'a> {
    point: &'a CheckPoint<ExactRatios>,
    bits: u32,
}

impl InBalls for Residues<'_> {
    /// `None` where this precision does not find the answers; and whether it brings each residual to one unit in the last
    /// of the requested bits. One that excludes 0 needs no more bits.
    type Found = Option<(Vec<Option<Residue>>, bool)>;

    fn run<const W: usize>(&self) -> Self::Found {
        let CheckPoint { place, with_motion, .. } = self.point;
        let answers = place.answers(<Mp<W> as stickslip::Float>::precision() - 64)?;
        let case = case::<W>(place, &answers)?;
        let of =
            |statement: Statement<_, _>| Some(residue((statement.residual)(&case)?, case.scale, self.bits));
        let mut found: Vec<_> = statements::all().into_iter().map(of).collect();
        let is_sharp = found.iter().flatten().all(|residue| residue.units <= 1.0 || residue.is_off);
        if is_sharp {
            let motion = with_motion.then(|| self.of_motion(&case, &answers).unwrap_or([Some(UNKNOWN); _]));
            found.extend(motion.unwrap_or([None; OF_MOTIONS.len()]));
        }
        Some((found, is_sharp))
    }
}

impl Residues<'_> {
    /// With the highest precision that is needed; all unknown where none finds the answers.
    fn found(&self) -> Vec<Option<Residue>> {
        let mut last = Vec::new();
        let found = enclosed::with_more_bits(&enclosed::PRECISIONS, self.bits, self, |_, found| {
            let (found, is_sharp) = found?;
            last.clone_from(&found);
            is_sharp.then_some(found)
        });
        found.unwrap_or_else(|| {
            last.resize(statements::all::<Ball<26>>().len() + OF_MOTIONS.len(), Some(UNKNOWN));
            last
        })
    }

    /// The residuals of [`OF_MOTIONS`]; `None` where no motion is proved.
    fn of_motion<const W: usize>(
        &self,
        case: &Case<Ball<W>>,
        answers: &enclosed::Response,
    ) -> Option<[Option<Residue>; OF_MOTIONS.len()]> {
        let &Self { point: CheckPoint { place, with_border, .. }, bits } = self;
        let motion = place.motion(&place.alpha, bits + 8)?;
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
        let of = |residual| Some(residue(residual, case.scale, bits));
        Some([
            of(ball(&motion.max_displacement) - u.max_displacement),
            of(late * u.max_displacement),
            of(ball(&motion.max_velocity) * case.omega - u.max_velocity),
            Some(count(slides, bits)),
            of(by_trace.abs() + by_product.abs()),
            Some(residue(contraction.square() - largest, Ball::int(1), bits)),
            with_border.then(|| beside_the_border(place, answers, bits)).flatten(),
        ])
    }
}

/// The stops of the motions at α_min (1 ∓ 2⁻¹⁶), except next to a pole, where the body need not stop below
/// the border.
fn beside_the_border(place: &ExactRatios, answers: &enclosed::Response, bits: u32) -> Option<Residue> {
    let turns = Rational::from(place.omega.recip_ref());
    let nearest = (Rational::from(&turns - 1u32) / 2u32).round() * 2u32 + 1u32;
    if (turns - nearest).abs() * 128u32 <= 1 {
        return None;
    }
    let least = Float::with_val(64, &answers.get(Output::MinForceRatio)?.mid);
    let little = Float::with_val(64, &least >> 16u32);
    let stops = |alpha: Float| Some(place.motion(&alpha.to_rational()?, 64)?.sticks_per_cycle);
    let (below, above) = (stops(Float::with_val(64, &least - &little)), stops(least + little));
    Some(count(below.is_some_and(|stops| stops > 0) && above == Some(0), bits))
}

/// Checks every statement in ball arithmetic at a set of points.
///
/// A statement passes if, at every point, its ball contains 0 and lies within one unit in the last of `bits`
/// bits of the statement's terms; its worst residual is the greatest distance from 0 in those units. A
/// statement that is wrong as printed passes if every ball excludes 0; its worst residual is then the least certain
/// relative one.
pub(super) fn verdicts(bits: u32) -> Result<Vec<StatementVerdict>, Failure> {
    if !(1..=MOST).contains(&bits) {
        let text = format!("--bits {bits}: number of bits {bits} must be ≥ 1 and ≤ {MOST}");
        return Err(text.into());
    }
    let of_answers = statements::all::<Ball<26>>();
    let of_motions =
        OF_MOTIONS.map(|(equation, words)| StatementVerdict::of(equation, words, Standing::Holds));
    let verdicts = of_answers.iter().map(Statement::verdict).chain(of_motions).collect();
    let numbers = Numbers {
        ratio: |p, q| Rational::from((p, q)),
        has_digits: |_| true,
        in_turn: [|_| true, |number| number % 5 == 0],
    };
    let residues = |point: &CheckPoint<ExactRatios>| Residues { point, bits }.found();
    verdict::verdicts(verdicts, &numbers.points(ExactRatios::above_border), residues, |point| {
        point.place.written()
    })
}
