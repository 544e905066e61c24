//! The statements in plain numbers, and the answers compared with the exact motion, which uses none of them:
//! it starts from rest and is computed slide by slide.

use super::case::{Arithmetic, Case, Circular, Signs};
use super::points::{CheckPoint, Numbers};
use super::statements::{self, Statement, statements};
use super::verdict::{self, Place, Residue, Standing, StatementVerdict};
use crate::failure::Failure;
use stickslip::cycle::equations::System;
use stickslip::motion::{LongRun, Peaks, Segment, State, SteadyState, Trajectory};
use stickslip::{Border, Cycle, Float, Output, PhaseFunction, Ratios, Response};

/// The greatest residual that rounding may leave of a true identity, in units of the last place of its
/// largest term.
///
/// Measured residuals are below 64, at 53 to 4096 bits.
pub(super) const TOLERANCE: f64 = 128.0;

/// The case of the answers at these ratios; `None` where there is no cycle.
pub(super) fn case<F: Float>(ratios: Ratios<F>) -> Option<Case<F>> {
    let response = Response::new(ratios);
    case_of(ratios, Output::ALL.into_iter().filter_map(|o| Some((o, o.of(&response)?))).collect())
}

/// The case of given answers.
pub(super) fn case_of<F: Float>(ratios: Ratios<F>, answers: Vec<(Output, F)>) -> Option<Case<F>> {
    let p = PhaseFunction::new(ratios.omega()).ok()?;
    let answer = |output| answers.iter().find(|(name, _)| *name == output).map(|(_, value)| *value);
    let signs = Signs {
        is_damped: ratios.is_damped(),
        is_above_one: ratios.omega() > F::int(1),
        is_late: answer(Output::VelocityPhase)? > answer(Output::DisplacementPhase)?,
    };
    let circular = Circular { k: p.value(), tangent: p.tangent(), cos_beta: p.sin_cos().1 };
    let arithmetic = Arithmetic {
        residuals: System::residuals,
        falling: System::falling,
        is_below: |low, high| Some(low < high),
    };
    Case::new(arithmetic, (ratios.omega(), ratios.alpha(), ratios.damping_ratio()), answers, circular, signs)
}

/// A point, its answers, and the exact motion there.
struct AnsweredPoint<F> {
    case: Case<F>,
    cycle: Cycle<F>,
    motion: Option<MotionFromRest<F>>,
    /// The numbers of stops in a cycle slightly below α_min and slightly above.
    stops: Option<(u32, u32)>,
    /// A₁ at α* from the work against friction, and its relative slope there.
    optimum: Option<(F, F)>,
}

/// The limit of the motion from rest.
struct MotionFromRest<F> {
    steady: SteadyState<F>,
    peaks: Peaks<F>,
    /// A bound of the distance of (x, x′/ω_n) from the limit.
    doubt: F,
    /// Trace and determinant of the derivative of the negated half-turn map, by differences.
    half_map: Option<(F, F)>,
}

impl<F: Float> AnsweredPoint<F> {
    /// A point of the list with its answers; its flags say whether the exact motion is followed, also next to
    /// the border.
    fn at(point: &CheckPoint<Ratios<F>>) -> Option<Self> {
        let ratios = point.place;
        let beside = point.with_border.then(|| Response::new(ratios));
        let least = |response: &Response<F>| response.border.min_force_ratio;
        Some(Self {
            case: case(ratios)?,
            cycle: Cycle::new(ratios).ok()?,
            motion: if point.with_motion { MotionFromRest::at(ratios) } else { None },
            stops: beside.as_ref().and_then(|found| stops_beside(ratios, least(found))),
            optimum: beside.and_then(|found| optimum(ratios, found.best_force_ratio, least(&found))),
        })
    }

    /// The residual of `found = expected`, where `doubt` is the difference that causes other than rounding
    /// may produce. A difference of the size of `doubt` counts as one unit in the last place.
    fn within(&self, residual: F, size: F, doubt: F) -> F {
        residual / (F::epsilon() * size + doubt) * F::epsilon() * self.case.scale
    }

    /// The residual of a difference quotient, which keeps half of the digits.
    fn by_differences(&self, residual: F) -> F {
        residual * self.case.scale * F::epsilon().sqrt()
    }

    /// The largest of some values at instants within a half cycle: eight for each free oscillation.
    fn most(&self, value: impl Fn(F) -> F) -> F {
        let n = (16.0 + 8.0 / self.case.omega.to_f64()) as i32;
        (1..n).fold(F::int(0), |most, i| most.or_larger(value(F::pi() * F::ratio(i, n))))
    }
}

impl<F: Float> MotionFromRest<F> {
    /// The motion at the ratios; `None` where it has no single limit, or none was found.
    fn at(ratios: Ratios<F>) -> Option<Self> {
        let LongRun::Periodic(steady) = LongRun::from_start(ratios, State::default()).ok()? else {
            return None;
        };
        let (x, v) = steady.distance;
        let doubt = x.hypot(v * ratios.omega());
        Some(Self { steady, peaks: steady.peaks().ok()?, doubt, half_map: half_map(ratios, steady.state) })
    }
}

/// Trace and determinant of the derivative of `(x, v) → −(x, v)` half a turn later, by central differences.
fn half_map<F: Float>(ratios: Ratios<F>, state: State<F>) -> Option<(F, F)> {
    let step = (F::int(1) + state.x.abs() + state.v.abs()) * third_of_digits::<F>();
    let moved = |x: F, v: F| half_turn_on(ratios, State { x: state.x + x, v: state.v + v, ..state });
    let zero = F::int(0);
    let slope = |ahead: (F, F), back: (F, F)| {
        let twice = F::int(2) * step;
        ((back.0 - ahead.0) / twice, (back.1 - ahead.1) / twice)
    };
    let (a, c) = slope(moved(step, zero)?, moved(-step, zero)?);
    let (b, d) = slope(moved(zero, step)?, moved(zero, -step)?);
    Some((a + d, a * d - b * c))
}

/// 2⁻ᵖᐟ³, the step at which central differences are most accurate.
fn third_of_digits<F: Float>() -> F {
    (0..F::precision() / 3).fold(F::int(1), |step, _| step / F::int(2))
}

/// (x, v) half a turn of the drive after a state.
fn half_turn_on<F: Float>(ratios: Ratios<F>, start: State<F>) -> Option<(F, F)> {
    let end = start.phase.later_by_half_turns(1);
    let reaches = |slide: &Segment<F>| slide.end().is_none_or(|e| e.phase.since(end) >= F::int(0));
    let mut slides = Trajectory::new(ratios, start).ok()?;
    let last = slides.find(|slide| slide.as_ref().is_ok_and(reaches))?.ok()?;
    let state = last.at(end).state;
    Some((state.x, state.v))
}

/// `2 sin (a − b)/2`: zero for equal phases only, and not for phases half a turn apart.
fn apart<F: Float>(a: F, b: F) -> F {
    F::int(2) * ((a - b) / F::int(2)).sin()
}

/// The steady motion from rest at another force ratio.
fn steady<F: Float>(ratios: Ratios<F>, alpha: F) -> Option<SteadyState<F>> {
    let ratios = Ratios::new(ratios.omega(), alpha).ok()?.with_damping_ratio(ratios.damping_ratio()).ok()?;
    LongRun::from_start(ratios, State::default()).ok()?.steady_state().copied()
}

/// Stops of the exact motion at α (1 − 2⁻¹⁶) and at α (1 + 2⁻¹⁶). Next to a pole the body need not stop below
/// the border ([errata](stickslip::cycle::printed) 4), and the stops are not checked.
fn stops_beside<F: Float>(ratios: Ratios<F>, alpha: F) -> Option<(u32, u32)> {
    let (one, two) = (F::int(1), F::int(2));
    let turns = one / ratios.omega();
    let nearest = two * ((turns - one) / two).round() + one;
    if (turns - nearest).abs() * F::int(128) <= one {
        return None;
    }
    let little = F::exp2i((F::precision() as i32 / 3).min(16).saturating_neg());
    let stops = |alpha: F| steady(ratios, alpha).map(|s| s.sticks_per_cycle);
    Some((stops(alpha * (one - little))?, stops(alpha * (one + little))?))
}

/// A₁ of the exact motion at α and `(α/A₁) dA₁/dα` there, by central differences; `None` where the body stops
/// at α or slightly below.
fn optimum<F: Float>(ratios: Ratios<F>, alpha: F, least: F) -> Option<(F, F)> {
    let (one, h) = (F::int(1), third_of_digits::<F>());
    if alpha < least * F::ratio(101, 100) {
        return None;
    }
    let size = |alpha: F| {
        let steady = steady(ratios, alpha)?;
        let slides = steady.sticks_per_cycle == 0 && steady.velocity_zeros_per_cycle == 2;
        slides.then(|| F::int(2) * (steady.energy_out / alpha) / alpha)
    };
    let (here, ahead, back) = (size(alpha)?, size(alpha * (one + h))?, size(alpha * (one - h))?);
    Some((here, (ahead - back) / (F::int(2) * h * here)))
}

/// 0 if a count is as expected, and otherwise a large residual.
fn count<F: Float>(found: u32, expected: u32) -> F {
    F::int(i32::from(found != expected))
}

/// Sum and product of the half-cycle multipliers among the answers.
fn half_cycle<F: Float>(p: &AnsweredPoint<F>) -> (F, F) {
    let [(a, b), (c, d)] = p.cycle.multipliers().half_cycle;
    (a + c, a * c - b * d)
}

/// Statements about the exact motion, the waveform and the border.
fn of_motion<F: Float>() -> Vec<Statement<AnsweredPoint<F>, F>> {
    statements![any, AnsweredPoint<F>:
        "15, 16" "the waveform and its velocity are the matched branches": |p| {
            let (c, turn) = (&p.case, F::pi() / F::int(3));
            let falling = c.unknowns.displacement_phase + turn;
            let (x, v) = c.falling(turn);
            let off = |phase: F, sign: F| {
                (p.cycle.displacement_at(phase) - sign * x).abs()
                    + (p.cycle.velocity_at(phase) * c.omega - sign * v).abs()
            };
            Some(off(falling, F::int(1)) + off(falling - F::pi(), F::int(-1)))
        },
        "25" "no instant of the matched half cycle is faster than V₀": |p| {
            Some(p.most(|turn| -p.case.falling(turn).1 - p.case.unknowns.max_velocity))
        },
        "62" "on the border the body does not go back within the half cycle": |p| {
            let start = p.case.on_border()?;
            Some(p.most(|turn| p.case.falling_from(start, turn).1))
        },
        "44" "Δ₀ is that of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            Some(p.within(m.steady.max_displacement.value - c.unknowns.max_displacement, c.scale, m.doubt))
        },
        "43" "ω_d t₂ is that of the exact motion": |p| {
            // An error of a phase changes the velocity by the error times the acceleration before the
            // reversal.
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let phase = apart(m.steady.max_displacement.phase.reduced(), c.unknowns.displacement_phase);
            let acceleration = c.omega.square() * m.steady.max_displacement.value + F::int(1);
            let size = c.scale * (F::int(1) + F::int(1) / c.omega);
            Some(p.within(phase * acceleration / c.omega, size, m.doubt))
        },
        "49" "V₀ is the greatest velocity of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let velocity = m.steady.max_velocity.value * c.omega - c.unknowns.max_velocity;
            Some(p.within(velocity, c.scale * (c.omega + F::int(1)), m.doubt))
        },
        "46" "ω_d t₁ is that of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let phase = apart(m.steady.max_velocity.phase.reduced(), c.unknowns.velocity_phase);
            let velocity = m.steady.max_velocity.value * c.omega;
            let jerk = c.alpha * c.omega * m.steady.max_velocity.phase.reduced().cos() - velocity;
            let size = c.scale * (F::int(1) + c.omega + F::int(1) / c.omega);
            Some(p.within(phase * jerk / c.omega, size, m.doubt))
        },
        "62" "the exact motion has two reversals a cycle and no stop": |p| {
            let steady = &p.motion.as_ref()?.steady;
            let off = count::<F>(steady.sticks_per_cycle, 0) + count(steady.velocity_zeros_per_cycle, 2);
            Some(off * p.case.scale)
        },
        "64" "A₁ is the work against friction": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let work = c.get(Output::LoopSizeStiffness)? * c.alpha.square() / F::int(2);
            Some(p.within((m.steady.energy_out - work) / F::int(4), c.scale, m.doubt))
        },
        "67" "A₂ is Ω² times the work of the drive, less the work of the damper": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let work = c.get(Output::LoopSizeInertia)? * (c.alpha / c.omega).square() / F::int(2);
            let terms = c.alpha * c.scale * (F::int(1) + F::int(1) / c.omega);
            let off = m.steady.energy_in - m.steady.damper_work - work;
            Some(p.within(off, terms, c.alpha * m.doubt))
        },
        "67" "the work of the damper is that of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let terms = (c.alpha + c.scale) * c.scale * (F::int(1) + F::int(1) / c.omega);
            Some(p.within(m.steady.damper_work - p.cycle.damper_work(), terms, terms * m.doubt / c.scale))
        },
        "44" "the greatest acceleration is that of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let off = (m.peaks.acceleration - c.get(Output::MaxAcceleration)?) * c.omega.square();
            Some(p.within(off, c.scale + c.alpha, m.doubt))
        },
        "44" "the greatest transmitted force is that of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let size = c.scale * (F::int(1) + c.zeta) + c.alpha;
            Some(p.within(m.peaks.transmitted_force - c.get(Output::TransmittedForce)?, size, m.doubt))
        },
        "44" "the greatest absolute displacement is that of the exact motion": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let off = m.peaks.absolute_displacement - c.get(Output::MaxAbsoluteDisplacement)?;
            Some(p.within(off, c.scale + c.alpha / c.omega.square(), m.doubt))
        },
        "λ" "λ₁² + λ₂² and λ₁²λ₂² are those of the exact motion's linearised cycle": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let [(a, b), (d, e)] = m.steady.multipliers;
            let (trace, product) = (a + d, a * d - b * e);
            let (sum, determinant) = half_cycle(p);
            let off = (sum.square() - F::int(2) * determinant - trace).abs()
                + (determinant.square() - product).abs();
            Some(p.within(off, F::int(1) + F::int(1) / c.omega, m.doubt))
        },
        "λ" "the contraction is the larger |λ|": |p| {
            let (c, m) = (&p.case, p.motion.as_ref()?);
            let [(a, b), (d, e)] = p.cycle.multipliers().half_cycle;
            let (found, listed) = (c.get(Output::Contraction)?, a.hypot(b).or_larger(d.hypot(e)));
            // A double root keeps half of the digits.
            let off = (found - listed).abs().or_larger((found.square() - m.steady.contraction()).square());
            Some(p.within(off, F::int(1) + F::int(1) / c.omega, m.doubt))
        },
        "62" "the exact motion stops just below the border, and not above": |p| {
            let (below, above) = p.stops?;
            Some(if below > 0 && above == 0 { F::int(0) } else { p.case.scale })
        },
        "66" "A₁ of the exact motion at α* is A₁max": |p| {
            let (size, _) = p.optimum?;
            Some((size / p.case.get(Output::BestLoopSize)? - F::int(1)) * p.case.scale)
        },
        "λ" "λ₁ + λ₂ and λ₁λ₂, with their signs, are those of the exact half cycle": |p| {
            let ((trace, product), (sum, determinant)) = (p.motion.as_ref()?.half_map?, half_cycle(p));
            Some(p.by_differences((trace - sum).abs() + (product - determinant).abs()))
        },
        "65" "A₁ of the exact motion is stationary at α*": |p| {
            Some(p.by_differences(p.optimum?.1))
        },
    ]
}

/// A residual in plain numbers: as small as the rounding of the terms, or not.
fn residue<F: Float>(residual: F, scale: F) -> Residue {
    let size = residual.abs() / scale;
    let units = (size / F::epsilon()).to_f64();
    Residue { units, least: size.to_f64(), is_zero: units <= TOLERANCE, is_off: units > TOLERANCE }
}

/// The points, where the precision is at least twice as fine as their distance from a singular frequency.
fn places<F: Float>() -> Vec<CheckPoint<Ratios<F>>> {
    // A motion with a thousand digits takes a tenth of a second; at such precisions only every third motion
    // is followed.
    let in_turn = |number: usize| F::precision() <= 512 || number.is_multiple_of(3);
    // Closer than half the digits, the paper's own forms have no digits left.
    let has_digits = |distance: &F| distance.square() > F::epsilon();
    Numbers { ratio: F::ratio, has_digits, in_turn: [in_turn, in_turn] }.points(|omega, zeta, over| {
        let at = |alpha| Ratios::new(omega, alpha).ok()?.with_damping_ratio(zeta).ok();
        at(Border::of(&at(F::int(1))?).min_force_ratio * F::ratio(over, 100))
    })
}

/// Checks every statement at every point.
pub(super) fn verdicts<F: Float>() -> Result<Vec<StatementVerdict>, Failure> {
    let (of_answers, of_motion) = (statements::all::<F>(), of_motion::<F>());
    let verdicts = of_answers.iter().map(Statement::verdict).chain(of_motion.iter().map(Statement::verdict));
    let residues = |place: &CheckPoint<Ratios<F>>| {
        let Some(point) = AnsweredPoint::at(place) else { return Vec::new() };
        let of_answers = of_answers.iter().map(|statement| (statement.residual)(&point.case));
        let found = of_answers.chain(of_motion.iter().map(|statement| (statement.residual)(&point)));
        found.map(|residual| Some(residue(residual?, point.case.scale))).collect()
    };
    let written = |CheckPoint { place, .. }: &CheckPoint<Ratios<F>>| Place {
        omega: Some(place.omega().to_string()),
        alpha: Some(place.alpha().to_string()),
        damping_ratio: place.is_damped().then(|| place.damping_ratio().to_string()),
    };
    verdict::verdicts(verdicts.collect(), &places(), residues, written)
}

#[cfg(test)]
mod tests {
    use super::{Place, Standing, TOLERANCE, case, case_of, places, residue, verdicts};
    use crate::verify::statements::{self, Statement};
    use proptest::prelude::*;
    use stickslip::{Border, Float, Output, Ratios, Response};

    fn all_hold<F: Float>() {
        let verdicts = verdicts::<F>().unwrap();
        let failed: Vec<_> = verdicts.iter().filter(|v| !v.passed || v.points < 3).collect();
        assert!(failed.is_empty() && verdicts.len() > 60, "{} {failed:#?}", verdicts.len());
        let worst = verdicts.iter().filter(|v| v.standing == Standing::Holds);
        let worst = worst.map(|v| v.worst_residual).fold(0.0, f64::max);
        assert!(worst > 1.0 && worst < TOLERANCE / 2.0, "{worst}");
    }

    #[test]
    fn all_hold_and_the_misprints_fail() {
        all_hold::<f64>();
    }

    #[cfg(feature = "mp")]
    #[test]
    fn at_256_bits_too() {
        all_hold::<stickslip::float::Mp<4>>();
    }

    /// The greatest residual of any statement, in units of the last place, with one answer changed.
    fn most_off(ratios: Ratios<f64>, changed: Output, factor: f64) -> f64 {
        let response = Response::new(ratios);
        let answers = Output::ALL.into_iter().filter_map(|output| {
            let value = output.of(&response)?;
            Some((output, if output == changed { value * factor } else { value }))
        });
        let case = case_of(ratios, answers.collect()).unwrap();
        let holding = statements::all().into_iter().filter(|s| s.standing == Standing::Holds);
        let residuals = holding.filter_map(|s: Statement<_, f64>| (s.residual)(&case));
        residuals.map(|r| (r / case.scale).abs() / f64::EPSILON).fold(0.0, f64::max)
    }

    /// An answer with an error of a millionth is detected at some point, with and without a damper, by a
    /// statement in closed form or about the exact motion.
    #[test]
    fn every_wrong_answer_is_told() {
        let told_by_the_motion = [Output::MaxAcceleration, Output::MaxAbsoluteDisplacement];
        for output in Output::ALL.into_iter().filter(|o| !told_by_the_motion.contains(o)) {
            for is_damped in [false, true] {
                let places = places::<f64>().into_iter().map(|point| point.place);
                let told = places.filter(|ratios| ratios.is_damped() == is_damped).any(|ratios| {
                    most_off(ratios, output, 1.0) < TOLERANCE
                        && most_off(ratios, output, 1.000_001) > TOLERANCE
                });
                assert!(told, "{output}, with a damper: {is_damped}");
            }
        }
    }

    #[test]
    fn a_tally_needs_points_and_takes_nan_for_the_worst() {
        assert!(case(Ratios::new(0.7, 2.0).unwrap()).is_some());
        let passed = |standing, residuals: &[f64]| {
            let statement = Statement { equation: "0", words: "", standing, residual: |_: &()| None::<f64> };
            let mut verdict = statement.verdict();
            residuals.iter().for_each(|&residual| verdict.add(residue(residual, 1.0), Place::default));
            assert_eq!(verdict.points, residuals.len());
            verdict.passed
        };
        let (holds, refuted) = (Standing::Holds, Standing::Refuted);
        assert!(!passed(holds, &[]) && !passed(refuted, &[]));
        assert!(passed(holds, &[0.0, 1e-16]) && !passed(refuted, &[0.0, 1e-16]));
        assert!(!passed(holds, &[0.0, 1e-3, 1e-16]) && !passed(refuted, &[1e-3, 0.0]));
        assert!(!passed(holds, &[0.0, f64::NAN, 0.0]) && !passed(refuted, &[1.0, f64::NAN, 1.0]));
        assert!(passed(refuted, &[1e-3, 1.0]));
    }

    proptest! {
        #![proptest_config(crate::drawn::cases(500))]

        /// The statements also hold between the points, and the misprints fail there. Closer to Ω = 1 and
        /// 1/(2n+1) the paper's forms, unlike the library's, lose digits.
        #[test]
        fn the_statements_hold_anywhere(omega in 0.15_f64..4.0, over in 1.0001_f64..8.0) {
            prop_assume!([1.0, 3.0, 5.0].iter().all(|n| (omega * n - 1.0).abs() > 1e-3));
            let least = Border::new(omega).unwrap().min_force_ratio;
            let case = case(Ratios::new(omega, least * over).unwrap()).unwrap();
            for statement in statements::all::<f64>() {
                let Some(residual) = (statement.residual)(&case) else { continue };
                let is_zero = (residual / case.scale).abs() <= 1e-10;
                let holds = statement.standing == Standing::Holds;
                prop_assert_eq!(is_zero, holds, "{}: {}", statement.equation, statement.words);
            }
        }
    }
}
