//! The cycle of two reversals in balls, above the border.

use super::angle::Angle;
use super::certain::{not_negative, reduced};
use super::damped::undamped_peaks;
use super::root::only_zero;
use crate::cycle::phase_function::PhaseFunction;
use crate::cycle::stability::{multiplier_product, real_contraction};
use crate::cycle::{
    HalfCycle, arrival_acceleration, cos_displacement_phase, dynamic_amplification, fastest, free_swing,
    loop_size_inertia, loop_size_stiffness, max_displacement, sin_displacement_phase, transmitted_force,
};
use crate::float::ball::Ball;
use crate::float::{Field, Real};
use crate::output::Output;

/// Displacement and maximum velocity of the cycle.
pub(crate) struct Cycle<const W: usize> {
    pub(crate) max_displacement: Ball<W>,
    pub(crate) displacement_phase: Ball<W>,
    pub(crate) max_velocity: Ball<W>,
    pub(crate) velocity_phase: Ball<W>,
    pub(crate) deviation: Ball<W>,
}

impl<const W: usize> Cycle<W> {
    /// The cycle for α certainly above the border and Ω certainly not 1; `None` where the maximum velocity is
    /// not found at this precision.
    pub(crate) fn at(angle: &Angle<W>, alpha: Ball<W>) -> Option<Self> {
        let (k, q, omega) = (angle.phase_function, angle.one_minus_square, angle.omega);
        let max_displacement = max_displacement(k, alpha, q);
        let sine = sin_displacement_phase(max_displacement, alpha, q);
        let cosine = cos_displacement_phase(k, alpha);
        // The phase is in (0, π) below the natural frequency and in (π, 2π) above.
        let is_below_one = *angle.known.high() < 1;
        let displacement_phase =
            if is_below_one { sine.atan2(cosine) } else { Ball::pi() + (-sine).atan2(-cosine) };
        let psi = fastest_psi(angle, alpha, max_displacement)?;
        let (max_velocity, _) = velocity(angle, max_displacement, psi);
        let half_pi = Ball::pi() / Ball::int(2);
        let velocity_phase = reduced(displacement_phase - half_pi - omega * psi);
        // α sin ω_d t₁ = −[K cos Ωψ + (1 − Ω²)(Δ₀/B) sin Ωψ]
        let (so, co) = (omega * psi).sin_cos();
        let deviation = -(k * co + q * max_displacement * so) - Ball::int(1);
        Some(Self { max_displacement, displacement_phase, max_velocity, velocity_phase, deviation })
    }

    /// max |λ| of the half cycle.
    pub(crate) fn contraction(&self, angle: &Angle<W>) -> Ball<W> {
        contraction(angle, self.max_displacement)
    }

    /// All outputs of the cycle that have an enclosure.
    pub(crate) fn outputs(
        &self,
        angle: &Angle<W>,
        alpha: Ball<W>,
        wanted: impl Fn(Output) -> bool,
    ) -> Vec<(Output, Option<Ball<W>>)> {
        let (delta, omega) = (self.max_displacement, angle.omega);
        let a1 = loop_size_stiffness(delta, alpha);
        let is_above_half = *angle.known.low() >= rug::Rational::from((1, 2));
        [
            (Output::MaxDisplacement, delta),
            (Output::DisplacementPhase, self.displacement_phase),
            (Output::MaxVelocity, self.max_velocity),
            (Output::VelocityPhase, self.velocity_phase),
            (Output::Deviation, self.deviation),
            (Output::LoopSizeStiffness, a1),
            (Output::LoopSizeInertia, loop_size_inertia(a1, omega)),
            (Output::Contraction, self.contraction(angle)),
            (Output::DynamicAmplification, dynamic_amplification(delta, alpha)),
            (Output::TransmittedForce, transmitted_force(delta)),
            (Output::Transmissibility, transmitted_force(delta) / alpha),
        ]
        .into_iter()
        .map(|(output, value)| (output, Some(value)))
        .chain(is_above_half.then(|| (Output::MaxAcceleration, Some(arrival_acceleration(delta, omega)))))
        .chain(undamped_peaks(angle, delta, wanted))
        .collect()
    }
}

/// v/(Bω_d) and its derivative by the centred time ψ.
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

/// The centred time of the maximum velocity: the only zero of v′ in a ball. The ball lies where
/// `crate::cycle::velocity` proves that v′ has one zero, and that the zero is the maximum velocity.
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

/// max |λ| of the half cycle.
///
/// Where it is not certain whether the multipliers are real or complex, both forms are continuous at the
/// double root gσ = 1. The hull of both forms then contains the larger modulus.
fn contraction<const W: usize>(angle: &Angle<W>, delta: Ball<W>) -> Ball<W> {
    let (one, two) = (Ball::<W>::int(1), Ball::int(2));
    let (s, c) = angle.sin_cos;
    let g = angle.omega.square() * delta;
    let g_sine = g * (two * s * c).abs();
    let g_cosine = g * ((c - s) * (c + s)).abs();
    let complex = || not_negative(multiplier_product(angle.omega, delta)).sqrt();
    let square = (one - g_sine) * (one + g_sine);
    let real = || real_contraction(g, g_cosine, not_negative(square).sqrt());
    if square.is_negative() {
        complex()
    } else if square.is_positive() {
        real()
    } else {
        complex().hull(&real())
    }
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
