//! The cycle of two reversals in balls, above the border: the formulae of `crate::cycle::damped` for every ζ.
//!
//! With a damper the peak velocity, acceleration and force of the half cycle are found by branch and bound
//! (`greatest`). Without one it is known where they are, and their balls over intervals of Ω and α have down to a
//! tenth of the width.

use super::angle::Angle;
use super::damped::moment;
use super::greatest::{greatest, greatest_size};
use super::root::{by_mean_value, only_zero};
use crate::cycle::damped::half_period::HalfPeriod;
use crate::cycle::damped::rising::{Moment, Rising};
use crate::cycle::equivalent::Equivalent;
use crate::cycle::phase_function::PhaseFunction;
use crate::cycle::{
    HalfCycle, arrival_acceleration, deviation_by, fastest, free_swing, loop_size_inertia,
    loop_size_stiffness, max_displacement, near_ends_or_crest, transmitted_force,
};
use crate::float::ball::Ball;
use crate::float::mp::Mp;
use crate::float::{Field, Real};
use crate::greatest::Jet;
use crate::machine::excitation::Excitation;
use crate::machine::support::Support;
use crate::output::Output;
use core::cmp::Ordering;

/// Outputs of a cycle by name; `None` where an output is not found.
pub(crate) type Outputs<const W: usize> = Vec<(Output, Option<Ball<W>>)>;

/// The outputs of the cycle under an excitation, for α certainly above the border, and without a damper Ω certainly not 1. Outputs that
/// take a search are computed only if requested.
pub(crate) fn outputs<const W: usize>(
    angle: &Angle<W>,
    half: HalfPeriod<Ball<W>>,
    support: &Support<Ball<W>>,
    wanted: impl Fn(Output) -> bool,
) -> Outputs<W> {
    let Support { omega, alpha, excitation, .. } = *support;
    let amplitude = max_displacement(half.k, alpha, half.stiffness);
    let rising = Rising::new(half, amplitude);
    let delta = amplitude - half.shift;
    let is_undamped = half.free.zeta.sign() == Some(Ordering::Equal);
    // cos(ω_d t₂ − δ) = qH/α, sin(ω_d t₂ − δ) = qa/α
    let lag = if !is_undamped {
        half.phase_lag()
    } else if *angle.known.high() < 1 {
        Ball::int(0)
    } else {
        Ball::pi()
    };
    let displacement_phase = lag + amplitude.atan2(half.h);
    let end = half.period;
    // Δ₀/(Bα), which changes little with α.
    let amplification = max_displacement(half.k / alpha, Ball::int(1), half.stiffness) - half.shift / alpha;
    let a1 = loop_size_stiffness(amplification, Ball::int(1)) / alpha;
    let mut found = vec![
        (Output::MaxDisplacement, Some(delta)),
        (Output::DisplacementPhase, Some(displacement_phase)),
        (Output::LoopSizeStiffness, Some(a1)),
        (Output::LoopSizeInertia, Some(loop_size_inertia(a1, omega))),
        (Output::Contraction, half.contraction(Ball::int(1) / rising.deceleration())),
        (Output::DynamicAmplification, Some(amplification)),
    ];
    if [Output::MaxVelocity, Output::VelocityPhase, Output::Deviation].into_iter().any(&wanted) {
        let [velocity, phase, deviation] = if is_undamped {
            at_only_maximum(angle, alpha, delta, displacement_phase)
        } else {
            at_greatest_velocity(&rising, displacement_phase)
        };
        found.push((Output::MaxVelocity, velocity));
        found.push((Output::VelocityPhase, phase));
        found.push((Output::Deviation, deviation));
    }
    // The ball of the end contains the remainder of the half cycle.
    let whole = [(Mp::ZERO, end.lower())];
    let of = |jet: &dyn Fn(&Moment<Ball<W>>) -> Jet<Ball<W>>| {
        greatest_size(&whole, &[Ball::int(0), end], |tau| jet(&moment(&half, tau)))
    };
    let is_force_wanted = wanted(Output::TransmittedForce) || wanted(Output::Transmissibility);
    let acceleration = (wanted(Output::MaxAcceleration) || is_force_wanted && support.is_foot()).then(|| {
        if !is_undamped {
            of(&|at| rising.acceleration(at)).map(|most| most / omega.square())
        } else if *angle.known.low() >= rug::Rational::from((1, 2)) {
            Some(arrival_acceleration(delta, omega))
        } else if *angle.known.high() < rug::Rational::from((1, 2)) {
            max_acceleration(&rising).map(|most| most / omega.square())
        } else {
            None
        }
    });
    found.extend(acceleration.map(|most| (Output::MaxAcceleration, most)));
    if is_force_wanted {
        let carried = if support.is_foot() {
            acceleration.flatten()
        } else if is_undamped {
            Some(transmitted_force(delta))
        } else {
            of(&|at| rising.force(at, rising.vibration().place(at)))
        };
        found.push((Output::TransmittedForce, carried.map(|most| support.force(most))));
        let transmissibility = if is_undamped && !support.is_foot() {
            Some(amplification + Ball::int(1) / alpha)
        } else {
            carried.map(|most| support.transmissibility(most))
        };
        found.push((Output::Transmissibility, transmissibility));
    }
    if wanted(Output::MaxAbsoluteDisplacement) && excitation.is_none_or(Excitation::moves_base) {
        let most = if support.is_foot() {
            Some(delta)
        } else if is_undamped {
            farthest(angle, &rising)
        } else {
            of(&|at| rising.absolute(at, rising.vibration().place(at)))
        };
        found.push((Output::MaxAbsoluteDisplacement, most));
    }
    let is_on_foot = excitation == Some(Excitation::DampedFootMotion);
    if wanted(Output::MaxSpringForce) {
        let most = if support.is_foot() {
            let seen = rising.seen_from_foot(is_on_foot);
            let is_slow = is_undamped && *angle.known.high() < rug::Rational::from((1, 2));
            let windows = if is_slow { crests(&rising).to_vec() } else { whole.to_vec() };
            greatest_size(&windows, &[Ball::int(0), end], |tau| seen.displacement(&moment(&half, tau)))
        } else {
            Some(delta)
        };
        found.push((Output::MaxSpringForce, most));
    }
    if EQUIVALENTS.into_iter().any(&wanted) {
        let vibration = if is_on_foot { rising.seen_from_foot(true) } else { rising.vibration() };
        let damper = if is_undamped { Ball::int(0) } else { rising.damper_work(&vibration).0 };
        let equivalent = Equivalent { omega, amplitude: delta, work: Ball::int(4) * delta + damper };
        found.extend([
            (Output::EquivalentDamping, Some(equivalent.damping())),
            (Output::EquivalentDampingRatio, Some(equivalent.damping_ratio())),
            (Output::EquivalentStiffness, Some(equivalent.stiffness())),
            (Output::EffectiveDampingRatio, Some(equivalent.effective_damping_ratio())),
        ]);
    }
    found
}

/// The outputs of the equivalent oscillator.
const EQUIVALENTS: [Output; 4] = [
    Output::EquivalentDamping,
    Output::EquivalentDampingRatio,
    Output::EquivalentStiffness,
    Output::EffectiveDampingRatio,
];

/// V₀, ω_d t₁ and Δ₁, each where it is found.
fn at_greatest_velocity<const W: usize>(
    rising: &Rising<Ball<W>>,
    displacement_phase: Ball<W>,
) -> [Option<Ball<W>>; 3] {
    let (half, omega) = (rising.half, rising.half.omega);
    let end = half.period;
    let fastest = greatest((Mp::ZERO, end.lower()), |tau| {
        let [value, slope, second] = rising.velocity(&moment(&half, tau));
        Jet { value, slope, second }
    });
    let at = fastest.as_ref().and_then(|fastest| fastest.at);
    let phase = at.map(|tau| reduced(displacement_phase - Ball::pi() + omega * tau));
    let deviation = at.map(|tau| {
        // x changes by the velocity times the time.
        by_mean_value(
            tau,
            |tau| rising.vibration().place(&moment(&half, tau)),
            |tau| rising.velocity(&moment(&half, tau))[0],
        )
    });
    [fastest.map(|fastest| fastest.value / omega), phase, deviation]
}

/// V₀, ω_d t₁ and Δ₁ without a damper.
fn at_only_maximum<const W: usize>(
    angle: &Angle<W>,
    alpha: Ball<W>,
    delta: Ball<W>,
    displacement_phase: Ball<W>,
) -> [Option<Ball<W>>; 3] {
    let (k, q, omega) = (angle.phase_function, angle.one_minus_square, angle.omega);
    let Some(psi) = fastest_psi(angle, alpha, delta) else { return [None; 3] };
    let phase = reduced(displacement_phase - Ball::pi() / Ball::int(2) - omega * psi);
    let (so, co) = (omega * psi).sin_cos();
    [velocity(angle, delta, psi).0, phase, deviation_by(k, q * delta, (so, co))].map(Some)
}

/// A phase in (−2π, 2π) reduced to [0, 2π), where the reduction is certain.
fn reduced<const W: usize>(phase: Ball<W>) -> Ball<W> {
    if phase.is_negative() { phase + Ball::pi() * Ball::int(2) } else { phase }
}

/// The greatest absolute displacement of the cycle without damping; `None` where it is not found. As in
/// `crate::cycle::peaks`, y′ has one zero.
fn farthest<const W: usize>(angle: &Angle<W>, rising: &Rising<Ball<W>>) -> Option<Ball<W>> {
    let half = &rising.half;
    let absolute = |tau: Ball<W>| {
        let at = moment(half, tau);
        rising.absolute(&at, rising.vibration().place(&at))
    };
    // K = 0: y′ is zero at the ends, and nowhere between them.
    if angle.phase_function.sign() == Some(Ordering::Equal) {
        return Some(absolute(half.period).value.abs());
    }
    let near = rising.map(|ball| ball.mid().to_f64());
    let rate = |tau: f64| {
        let at = near.half.at(tau);
        near.absolute(&at, near.displacement(&at)).slope
    };
    // Near K = 0 rounding hides the sign at one end, which a bracketing search would need.
    let (mut low, mut high) = (0.0, near.half.period);
    let is_first = rate(low) > 0.0;
    for _ in 0..40 {
        let middle = f64::midpoint(low, high);
        if (rate(middle) > 0.0) == is_first { low = middle } else { high = middle }
    }
    let start = Mp::of_f64(f64::midpoint(low, high));
    let turn = only_zero(start, |tau| absolute(tau).slope, |tau| absolute(tau).second)?;
    // At an extremum an error of the time hardly changes the value.
    (turn.is_positive() && turn.is_below(&half.period))
        .then(|| by_mean_value(turn, |tau| absolute(tau).value, |tau| absolute(tau).slope).abs())
}

/// Greatest |x″| without damping below Ω = 1/2: on arrival, or within a fast period of an end or of the maximum of
/// the slow wave, as in `crate::cycle::peaks`.
fn max_acceleration<const W: usize>(rising: &Rising<Ball<W>>) -> Option<Ball<W>> {
    let half = &rising.half;
    let ends = [Ball::int(0), half.period];
    greatest_size(&crests(rising), &ends, |tau| rising.acceleration(&moment(half, tau)))
}

/// The times within a fast period of an end or of the extreme of the slow wave.
fn crests<const W: usize>(rising: &Rising<Ball<W>>) -> [(Mp<W>, Mp<W>); 3] {
    let half = &rising.half;
    let (end, turn) = (half.period.lower(), (Ball::<W>::pi() * Ball::int(2)).upper());
    // a Ω² cos Ωτ + H Ω² sin Ωτ, whose values at the ends have opposite signs.
    let crest = (half.h.atan2(rising.amplitude) / half.omega).mid();
    let crest = if crest < Mp::ZERO { crest + half.period.mid() } else { crest };
    near_ends_or_crest([Mp::ZERO, end], crest, turn)
}

/// v/(Bω_d) and its derivative by the centred time ψ, of [`HalfCycle`] without its forms that keep digits beside Ω = 1.
fn velocity<const W: usize>(angle: &Angle<W>, delta: Ball<W>, psi: Ball<W>) -> (Ball<W>, Ball<W>) {
    let omega = angle.omega;
    let (so, co) = (omega * psi).sin_cos();
    let (h, h1) = free_swing(omega, angle.sin_cos, psi.sin_cos(), (so, co));
    (delta * co + h, h1 - omega * delta * so)
}

/// v″ = (Ω − 1/Ω) sin ψ/cos β − Ω²v.
fn bend<const W: usize>(angle: &Angle<W>, delta: Ball<W>, psi: Ball<W>) -> Ball<W> {
    let omega = angle.omega;
    let forcing = -(angle.one_minus_square / (omega * angle.sin_cos.1));
    forcing * psi.sin() - omega.square() * velocity(angle, delta, psi).0
}

/// The centred time of the peak velocity: the only zero of v′ in a ball. The ball lies where
/// `crate::cycle::velocity` proves that v′ has one zero, and that the zero is the peak velocity.
fn fastest_psi<const W: usize>(angle: &Angle<W>, alpha: Ball<W>, delta: Ball<W>) -> Option<Ball<W>> {
    let p = PhaseFunction::of_valid(angle.omega.mid());
    let start = fastest(&HalfCycle::new(&p, delta.mid()), p.value(), alpha.mid()).psi;
    let psi = only_zero(start, |psi| velocity(angle, delta, psi).1, |psi| bend(angle, delta, psi))?;
    is_in_bracket(angle, delta, psi).then_some(psi)
}

/// Whether ψ is certainly in the interval in which v′ has a single zero.
fn is_in_bracket<const W: usize>(angle: &Angle<W>, delta: Ball<W>, psi: Ball<W>) -> bool {
    let quarter = Ball::pi() / Ball::int(2);
    let half = rug::Rational::from((1, 2));
    if *angle.known.low() >= half {
        // |ψ| < π/2, and ψ within the half cycle.
        let beta = quarter / angle.omega;
        let bound = if *angle.known.low() > 1 { beta } else { quarter };
        return psi.abs().is_below(&bound);
    }
    if *angle.known.high() >= half {
        return false;
    }
    // Between ψ_c = −asin(K/α)/Ω and ψ_p = ±π/2, with the sign of cos β.
    let k = angle.phase_function;
    let centre = -(k.atan2(angle.one_minus_square * delta) / angle.omega);
    let Some(sign) = angle.sin_cos.1.sign() else { return false };
    let crest = if sign == core::cmp::Ordering::Less { -quarter } else { quarter };
    let (low, high) = if sign == core::cmp::Ordering::Less { (crest, centre) } else { (centre, crest) };
    low.is_below(&psi) && psi.is_below(&high)
}

#[cfg(test)]
mod tests {
    use super::is_in_bracket;
    use crate::enclosed::angle::Angle;
    use crate::enclosed::known::Known;
    use crate::float::ball::{Ball, Radius};
    use crate::float::mp::Mp;
    use rug::Rational;

    /// For Ω ≥ 1/2, |ψ| is below π/2 and β.
    #[test]
    fn the_bracket_of_the_maximum_velocity_ends_on_both_sides() {
        let at = |p: i32, q: i32, delta: f64, psi: f64| {
            let angle = Angle::<2>::new(&Known::rational(Rational::from((p, q))));
            let near = Ball::new(Mp::of_f64(psi), Radius::power_of_two(-60));
            is_in_bracket(&angle, Ball::exact(Mp::of_f64(delta)), near)
        };
        let quarter = std::f64::consts::FRAC_PI_2;
        for (p, q, bound) in [(1, 2, quarter), (7, 10, quarter), (1, 1, quarter), (3, 2, quarter / 1.5)] {
            let inside = 1.0 - 1e-9;
            for (psi, is) in
                [(0.0, true), (inside, true), (-inside, true), (2.0 - inside, false), (inside - 2.0, false)]
            {
                assert_eq!(at(p, q, 3.0, psi * bound), is, "{p}/{q} {psi}");
            }
        }
    }
}
