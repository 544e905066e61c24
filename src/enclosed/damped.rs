//! The closed forms with damping, or with static friction above the kinetic one, in balls.
//!
//! The half period ([`HalfPeriod`]) is computed from its definition, with as many bits as its cancellations
//! cost; all further steps are the formulae of `crate::cycle::damped`. The maximum velocity,
//! acceleration and force of the half cycle are found by branch and bound (`greatest`), for any Ω and ζ.

mod border;

use super::Known;
use super::angle::Angle;
use super::border::Border;
use super::certain::{not_negative, reduced};
use super::greatest::{greatest, greatest_size};
use super::root::only_zero;
use crate::cycle::Unknowns;
use crate::cycle::damped::best_of;
use crate::cycle::damped::free::{Free, Waves};
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::rising::{Moment, Rising};
use crate::cycle::equations::System;
use crate::cycle::{dynamic_amplification, loop_size_inertia, loop_size_stiffness, max_displacement};
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::greatest::Jet;
use crate::output::Output;
use core::cmp::Ordering;

/// e^{−ζt} cos dt and e^{−ζt} sin(dt)/d, below, at and above ζ = 1; the whole line where the sign of 1 − ζ is
/// undecided.
pub(crate) fn waves<const W: usize>(free: &Free<Ball<W>>, t: Ball<W>) -> Waves<Ball<W>> {
    let half = Ball::ratio(1, 2);
    match free.square.sign() {
        Some(Ordering::Greater) => {
            let (s, c) = (free.frequency * t).sin_cos();
            if free.zeta.sign() == Some(Ordering::Equal) {
                return Waves { cosine: c, sine: s / free.frequency };
            }
            let decay = (-(free.zeta * t)).exp();
            Waves { cosine: decay * c, sine: decay * (s / free.frequency) }
        }
        Some(Ordering::Equal) => {
            let decay = (-t).exp();
            Waves { cosine: decay, sine: decay * t }
        }
        Some(Ordering::Less) => {
            let (slow, gap) = ((-(free.slow_rate() * t)).exp(), (-(free.frequency * t * Ball::int(2))).exp());
            let one = Ball::int(1);
            Waves { cosine: slow * (one + gap) * half, sine: slow * (one - gap) * half / free.frequency }
        }
        None => Waves { cosine: Ball::entire(), sine: Ball::entire() },
    }
}

impl<const W: usize> System<Ball<W>> {
    /// Eq. 21–25 in balls: left less right.
    #[must_use]
    pub fn residuals_of_balls(&self, u: &Unknowns<Ball<W>>) -> [Ball<W>; 5] {
        self.equations_by(u, waves).0
    }

    /// [`System::falling`] in balls.
    #[must_use]
    pub fn falling_of_balls(&self, u: &Unknowns<Ball<W>>, turn: Ball<W>) -> (Ball<W>, Ball<W>) {
        self.falling_by(u, turn, waves)
    }
}

/// Free vibration with damping ratio ζ; without damping by exact numbers.
pub(super) fn free<const W: usize>(zeta: Ball<W>) -> Free<Ball<W>> {
    let one = Ball::int(1);
    let is_undamped = zeta.sign() == Some(Ordering::Equal);
    if is_undamped { Free { zeta, square: one, frequency: one } } else { Free::new(zeta) }
}

/// The state of the half cycle at a time.
pub(crate) fn moment<const W: usize>(half: &HalfPeriod<Ball<W>>, tau: Ball<W>) -> Moment<Ball<W>> {
    let waves = waves(&half.free, tau);
    let free = half.free.after(waves, Ball::int(1) + half.shift, half.omega * half.h);
    Moment { tau, drive: (half.omega * tau).sin_cos(), waves, free }
}

/// The half period by its definition.
pub(crate) fn half_period<const W: usize>(
    angle: &Angle<W>,
    zeta: &Known,
    eta: &Known,
) -> HalfPeriod<Ball<W>> {
    let (one, two, omega, zeta) = (Ball::int(1), Ball::int(2), angle.omega, zeta.ball::<W>());
    let is_undamped = zeta.sign() == Some(Ordering::Equal);
    let free = free(zeta);
    let period = Ball::pi() / omega;
    let decay = if is_undamped { one } else { (-(zeta * period)).exp() };
    let Waves { cosine, sine } = waves(&free, period);
    let lag = (two * zeta * omega, angle.one_minus_square);
    let stiffness = if is_undamped { lag.1.abs() } else { lag.0.hypot(lag.1) };
    // e^{−ζT} times N, and times sinh ζT
    let n = (one + decay.square()) / two + cosine;
    let hyperbolic = if is_undamped { Ball::int(0) } else { (one - decay.square()) / two };
    let h = sine / (omega * n);
    let half = HalfPeriod {
        omega,
        free,
        period,
        lag,
        stiffness,
        shift: (hyperbolic - zeta * sine) / n,
        h,
        k: stiffness * h,
        rest: [Ball::int(0); 3],
        beyond: None,
        decay,
        cosine,
        sine,
        static_excess: Ball::int(0),
        // The ball itself shows the cancellation in both parts.
        is_resonant: false,
    };
    half.with_static_friction(eta.ball())
}

/// The border, and α* and A₁max.
pub(crate) fn at_border<const W: usize>(half: &HalfPeriod<Ball<W>>) -> (Border<W>, (Ball<W>, Ball<W>)) {
    (border::border(half), best_of(half))
}

/// Outputs of a cycle by name; `None` where an output is not found.
pub(crate) type Outputs<const W: usize> = Vec<(Output, Option<Ball<W>>)>;

/// The outputs of the cycle for α certainly above the border. Outputs that take a search are computed only if
/// requested. `None` where the maximum velocity is not found.
pub(crate) fn outputs<const W: usize>(
    angle: &Angle<W>,
    half: HalfPeriod<Ball<W>>,
    alpha: Ball<W>,
    wanted: impl Fn(Output) -> bool,
) -> Option<Outputs<W>> {
    let omega = half.omega;
    let amplitude = max_displacement(half.k, alpha, half.stiffness);
    let rising = Rising::new(half, amplitude);
    let delta = amplitude - half.shift;
    // cos(ω_d t₂ − δ) = qH/α, sin(ω_d t₂ − δ) = qa/α
    let lag = if half.lag.0.sign() != Some(Ordering::Equal) {
        half.phase_lag()
    } else if *angle.known.high() < 1 {
        Ball::int(0)
    } else {
        Ball::pi()
    };
    let displacement_phase = lag + amplitude.atan2(half.h);
    let end = half.period;
    let a1 = loop_size_stiffness(delta, alpha);
    let mut found = vec![
        (Output::MaxDisplacement, Some(delta)),
        (Output::DisplacementPhase, Some(displacement_phase)),
        (Output::LoopSizeStiffness, Some(a1)),
        (Output::LoopSizeInertia, Some(loop_size_inertia(a1, omega))),
        (Output::Contraction, Some(contraction(&rising))),
        (Output::DynamicAmplification, Some(dynamic_amplification(delta, alpha))),
    ];
    if [Output::MaxVelocity, Output::VelocityPhase, Output::Deviation].into_iter().any(&wanted) {
        found.extend(at_greatest_velocity(&rising, displacement_phase)?);
    }
    // The ball of the end contains the remainder of the half cycle.
    let whole = [(Mp::ZERO, end.lower())];
    let of = |jet: &dyn Fn(&Moment<Ball<W>>) -> Jet<Ball<W>>| {
        greatest_size(&whole, &[Ball::int(0), end], |tau| jet(&moment(&half, tau)))
    };
    if wanted(Output::TransmittedForce) || wanted(Output::Transmissibility) {
        let force = of(&|at| rising.force(at, displacement(&rising, at)));
        found.push((Output::TransmittedForce, force));
        found.push((Output::Transmissibility, force.map(|force| force / alpha)));
    }
    if wanted(Output::MaxAcceleration) {
        let most = of(&|at| rising.acceleration(at));
        found.push((Output::MaxAcceleration, most.map(|most| most / omega.square())));
    }
    if wanted(Output::MaxAbsoluteDisplacement) {
        let most = of(&|at| rising.absolute(at, displacement(&rising, at)));
        found.push((Output::MaxAbsoluteDisplacement, most));
    }
    Some(found)
}

/// V₀, ω_d t₁ and Δ₁.
fn at_greatest_velocity<const W: usize>(
    rising: &Rising<Ball<W>>,
    displacement_phase: Ball<W>,
) -> Option<Outputs<W>> {
    let (half, omega) = (rising.half, rising.half.omega);
    let end = half.period;
    let fastest = greatest((Mp::ZERO, end.lower()), |tau| {
        let [value, slope, second] = rising.velocity(&moment(&half, tau));
        Jet { value, slope, second }
    })?;
    let phase = fastest.at.map(|tau| reduced(displacement_phase - Ball::pi() + omega * tau));
    let deviation = fastest.at.map(|tau| {
        // By the mean value theorem, x changes by the velocity times the time.
        let middle = Ball::exact(tau.mid());
        displacement(rising, &moment(&half, middle))
            + rising.velocity(&moment(&half, tau))[0] * (tau - middle)
    });
    Some(vec![
        (Output::MaxVelocity, Some(fastest.value / omega)),
        (Output::VelocityPhase, phase),
        (Output::Deviation, deviation),
    ])
}

/// x/B.
pub(crate) fn displacement<const W: usize>(rising: &Rising<Ball<W>>, at: &Moment<Ball<W>>) -> Ball<W> {
    at.free.x - Ball::int(1) - rising.amplitude * at.drive.1 - rising.half.h * at.drive.0
}

/// max |λ| of the half cycle.
fn contraction<const W: usize>(rising: &Rising<Ball<W>>) -> Ball<W> {
    let (one, half) = (Ball::int(1), &rising.half);
    let inverse = one / rising.deceleration();
    let (mean, discriminant) = half.multipliers(inverse);
    let complex = || half.decay * not_negative((one - inverse) / (one + inverse)).sqrt();
    let real = || mean.abs() + not_negative(discriminant).sqrt() / (one + inverse);
    match discriminant.sign() {
        Some(Ordering::Less) => complex(),
        Some(_) => real(),
        None => complex().hull(&real()),
    }
}

/// The maximum acceleration below Ω = 1/2 and the greatest absolute displacement of the cycle without
/// damping; `None` where they are not found.
///
/// As in `crate::cycle::peaks`: |x″| is greatest on arrival, or within a fast period of an end or of
/// the maximum of the slow wave; and y′ has one zero.
pub(super) fn undamped_peaks<const W: usize>(
    angle: &Angle<W>,
    delta: Ball<W>,
    wanted: impl Fn(Output) -> bool,
) -> Outputs<W> {
    let (zero, one) = (Known::rational(0.into()), Known::rational(1.into()));
    let half = half_period(angle, &zero, &one);
    let rising = Rising::new(half, delta);
    let absolute = |tau: Ball<W>| {
        let at = moment(&half, tau);
        rising.absolute(&at, displacement(&rising, &at))
    };
    let near = rising.map(|ball| ball.mid().to_f64());
    let rate = |tau: f64| {
        let at = near.half.at(tau);
        near.absolute(&at, near.displacement(&at)).slope
    };
    let (mut low, mut high) = (0.0, near.half.period);
    let is_first = rate(low) > 0.0;
    for _ in 0..40 {
        let middle = f64::midpoint(low, high);
        if (rate(middle) > 0.0) == is_first { low = middle } else { high = middle }
    }
    let start = Mp::of_f64(f64::midpoint(low, high));
    // K = 0: y′ is zero at the ends, and nowhere between them.
    let at_end =
        (angle.phase_function.sign() == Some(Ordering::Equal)).then(|| absolute(half.period).value.abs());
    let turn = only_zero(start, |tau| absolute(tau).slope, |tau| absolute(tau).second);
    // At an extremum an error of the time hardly changes the value.
    let farthest = turn.filter(|tau| tau.is_positive() && tau.is_below(&half.period)).map(|tau| {
        let middle = Ball::exact(tau.mid());
        (absolute(middle).value + absolute(tau).slope * (tau - middle)).abs()
    });
    let mut found = vec![(Output::MaxAbsoluteDisplacement, at_end.or(farthest))];
    if wanted(Output::MaxAcceleration) && *angle.known.high() < rug::Rational::from((1, 2)) {
        found.push((Output::MaxAcceleration, acceleration(&rising).map(|most| most / angle.omega.square())));
    }
    found
}

/// Greatest |x″| without damping below Ω = 1/2.
fn acceleration<const W: usize>(rising: &Rising<Ball<W>>) -> Option<Ball<W>> {
    let half = &rising.half;
    let (end, turn) = (half.period.lower(), (Ball::<W>::pi() * Ball::int(2)).upper());
    // a Ω² cos Ωτ + H Ω² sin Ωτ, whose values at the ends have opposite signs.
    let crest = (half.h.atan2(rising.amplitude) / half.omega).mid();
    let crest = if crest < Mp::ZERO { crest + half.period.mid() } else { crest };
    let windows = [(Mp::ZERO, turn), (crest - turn, crest + turn), (end - turn, end)];
    let windows = windows.map(|(low, high)| {
        (if low < Mp::ZERO { Mp::ZERO } else { low }, if high > end { end } else { high })
    });
    greatest_size(&windows, &[Ball::int(0), half.period], |tau| rising.acceleration(&moment(half, tau)))
}
