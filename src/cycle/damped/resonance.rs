//! The linear oscillator near its resonance, where the driven and the free part of a motion nearly cancel.
//!
//! Let s and c be the free vibrations from (x, x′) = (0, 1) and (1, 0), and λ = −ζ + id, d = √(1 − ζ²). The
//! motion that the right side `e^{iΩτ}` brings about from rest is C + iS, the solution of
//! `E″ + 2ζE′ + E = e^{iΩτ}`:
//!
//! ```text
//! C + iS = (e^{iΩτ} − c − iΩs)/(1 − Ω² + 2iζΩ),   S′ = ΩC,   D = C′ = s − ΩS.
//! ```
//!
//! The divisor vanishes as Ω → 1 and ζ → 0 together. It is `z z′` with z = iΩ − λ, z′ = iΩ − λ̄, and because
//! `c = e^{λτ} + (ζ − id) s`, the numerator is z times a difference without cancellation:
//!
//! ```text
//! C + iS = (Q − s)/z′,   Q = (e^{iΩτ} − e^{λτ})/z = −e^{iΩτ} (e^{−zτ} − 1)/z.
//! ```

use super::free::Free;
use crate::float::Float;

/// The responses of the oscillator after the time τ.
pub(crate) struct Responses<F> {
    /// (s, c).
    pub(crate) free: (F, F),
    /// 1 − c.
    pub(crate) versine: F,
    /// (sin Ωτ, cos Ωτ).
    pub(crate) drive: (F, F),
    pub(crate) c: F,
    pub(crate) s: F,
    pub(crate) d: F,
}

impl<F: Float> Responses<F> {
    /// For Ω in [1/2, 2] and ζ < 1/8.
    ///
    /// `Ω − d = (Ω² − 1 + ζ²)/(Ω + d)`, and dτ is Ωτ less that times τ: two circular functions in all.
    pub(crate) fn new(omega: F, free: &Free<F>, tau: F) -> Self {
        let (one, two) = (F::int(1), F::int(2));
        let (zeta, d) = (free.zeta, free.frequency);
        let sum = omega + d;
        let gap = ((omega - one) * (omega + one) + zeta.square()) / sum;
        let (sin_drive, cos_drive) = (omega * tau).sin_cos();
        // b = (Ω − d) τ by its half.
        let (sin_half, cos_half) = (gap * tau / two).sin_cos();
        let (sin_b, versine_b) = (two * sin_half * cos_half, two * sin_half.square());
        let fall = (-(zeta * tau)).exp_m1();
        let decay = one + fall;
        let cos_b = one - versine_b;
        // e^{−zτ} − 1
        let (re, im) = (fall * cos_b - versine_b, -(decay * sin_b));
        // Divided by −z = −(ζ + i(Ω − d)), and turned by Ωτ.
        let size = zeta.hypot(gap);
        let (unit_re, unit_im) = (zeta / size, gap / size);
        let (re, im) = (-(re * unit_re + im * unit_im) / size, -(im * unit_re - re * unit_im) / size);
        let (q_re, q_im) = (re * cos_drive - im * sin_drive, im * cos_drive + re * sin_drive);
        // The free vibrations at dτ = Ωτ − b.
        let sine = decay * (sin_drive * cos_b - cos_drive * sin_b) / d;
        let cosine = decay * (cos_drive * cos_b + sin_drive * sin_b);
        let c = cosine + zeta * sine;
        // Divided by z′ = ζ + i(Ω + d).
        let square = zeta.square() + sum.square();
        let above = q_re - sine;
        let s_part = (q_im * zeta - above * sum) / square;
        // 1 − e^{−ζτ} cos dτ = −fall cos dτ + 2 sin²(dτ/2), and sin² dτ = (1 − cos)(1 + cos)
        let (sin_d, cos_d) = (sine * d / decay, cosine / decay);
        let versine_d = if cos_d > F::int(0) { sin_d.square() / (one + cos_d) } else { one - cos_d };
        Self {
            free: (sine, c),
            versine: versine_d - fall * cos_d - zeta * sine,
            drive: (sin_drive, cos_drive),
            c: (above * zeta + q_im * sum) / square,
            s: s_part,
            d: sine - omega * s_part,
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::{Cycle, Ratios};

    fn cycle<F: crate::Float>(omega: f64, alpha: f64, zeta: f64) -> Cycle<F> {
        let to = F::from_f64;
        Cycle::new(Ratios::new(to(omega), to(alpha)).unwrap().with_damping_ratio(to(zeta)).unwrap()).unwrap()
    }

    #[cfg(feature = "mp")]
    fn outputs<F: crate::Float>(cycle: &Cycle<F>) -> [F; 5] {
        let force = cycle.transmitted_force();
        let (acceleration, absolute) = (cycle.max_acceleration(), cycle.max_absolute_displacement());
        [cycle.max_velocity, cycle.velocity_phase, acceleration, force, absolute]
    }

    /// With however little damping, the peak velocity and the peaks keep their accuracy, and take no
    /// longer to find.
    #[cfg(feature = "mp")]
    #[test]
    fn a_little_damping_at_resonance_costs_no_digits() {
        use crate::float::mp::Mp;
        for (omega, alpha) in [(1.0, 1.3), (1.0, 2.0), (0.999, 1.5), (1.000_01, 1.35), (1.1, 1.4), (0.9, 2.0)]
        {
            for zeta in [1e-18, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-2] {
                let (found, wide) = (cycle::<f64>(omega, alpha, zeta), cycle::<Mp<4>>(omega, alpha, zeta));
                // The condition number is that of the displacement.
                let k = crate::PhaseFunction::new(omega).unwrap().value();
                let condition = alpha * alpha / (alpha * alpha - k * k);
                let wide = outputs(&wide).map(crate::Float::to_f64);
                for (i, (found, wide)) in outputs(&found).into_iter().zip(wide).enumerate() {
                    let ulps = ((found - wide) / wide / f64::EPSILON).abs() / condition;
                    assert!(ulps < 8.0, "{omega} {alpha} {zeta} {i}: {found} {wide} {ulps}");
                }
            }
        }
    }

    /// On the border Δ₀ tends to 1 as ζ → 0, and V₀ to the limit for Ω → 1 without damping; the rounding of
    /// the border moves both by as much as 1/ζ times itself.
    fn reaches_the_limit<F: crate::Float>(zetas: &[f64]) {
        for zeta in zetas {
            let to = F::from_f64;
            let at = |alpha| Ratios::new(to(1.0), alpha).unwrap().with_damping_ratio(to(*zeta)).unwrap();
            let least = crate::Border::of(&at(to(2.0))).min_force_ratio;
            let cycle: Cycle<F> = Cycle::new(at(least)).unwrap();
            let off = 4.0 * zeta + F::epsilon().to_f64() / zeta;
            let (far, fast) = (cycle.max_displacement.to_f64(), cycle.max_velocity.to_f64());
            assert!((far - 1.0).abs() < off + 4e-16, "{zeta}: {cycle:?}");
            assert!((fast - 1.158_460_65).abs() < off + 1e-8, "{zeta}: {cycle:?}");
        }
    }

    #[test]
    fn on_the_border_at_resonance_the_limit_is_reached() {
        reaches_the_limit::<f64>(&[1e-12, 1e-9, 1e-7]);
        #[cfg(feature = "mp")]
        reaches_the_limit::<crate::float::mp::Mp<4>>(&[1e-20, 1e-18, 1e-15, 1e-12, 1e-9]);
    }

    /// Next to the border no digit of the displacement is certain, but all results have its order of
    /// magnitude.
    #[test]
    fn on_the_border_beside_resonance_everything_is_found() {
        for zeta in [1e-18, 1e-16, 1e-15] {
            for alpha in [1.273_239_544_735_164_8, 1.273_239_544_735_2, 1.273_239_55] {
                let cycle = cycle::<f64>(1.0, alpha, zeta);
                let (far, fast) = (cycle.max_displacement, cycle.max_velocity);
                assert!(fast > 0.99 * far && fast < 1.2 * far, "{alpha} {zeta}: {far} {fast}");
                let peak = cycle.max_acceleration();
                assert!((peak - far - 1.0).abs() < 1e-12 * far, "{alpha} {zeta}: {far} {peak}");
            }
        }
    }
}
