//! The supremum of Den Hartog's condition for Ω < 1/2, statement by statement, at 256 bits.

use crate::random::Random;
use stickslip::float::Mp;
use stickslip::{Border, Field, Float, Real};

/// Den Hartog's f at τ = Ωζ as it is written in the documentation of `src/cycle/border.rs`.
fn den_hartog<F: Real>(omega: F, tangent: F, zeta: F) -> F {
    let ((sine, cosine), (slow_sine, slow_cosine)) = (zeta.sin_cos(), (omega * zeta).sin_cos());
    (sine + tangent * (slow_cosine - cosine)) / (omega * slow_sine)
}

/// The place of the supremum of |f| for Ω < 1/2, statement by statement, at 256 bits. Since f(π − τ) = −f(τ),
/// (0, π/2] suffices. Up to γ, f is monotonic from 1/Ω². Beyond γ + π, |f| does not exceed its values in [γ,
/// γ + π], where |f| has one stationary point; the border takes that point.
#[test]
fn the_largest_of_den_hartogs_function_is_where_it_is_proved_to_be() {
    type Wide = Mp<4>;
    let pi = Wide::pi();
    let mut random = Random(13);
    for i in 0..60 {
        // Ω between poles and close to them on both sides.
        let inverse = match i % 3 {
            0 => random.between(2.0, 20.0),
            1 => f64::from(3 + 2 * (i / 9)) + random.scale(1e-9, 0.2),
            _ => f64::from(3 + 2 * (i / 9)) - random.scale(1e-9, 0.2),
        };
        let omega = Wide::int(1) / Wide::from(inverse);
        let beta = pi * Wide::from(inverse) / Wide::int(2);
        let gamma = beta - (beta / pi).floor() * pi;
        let tangent = beta.tan();
        let f = |zeta: Wide| den_hartog(omega, tangent, zeta);
        let part = |low: Wide, high: Wide, k: i32, n: i32| low + (high - low) * Wide::ratio(k, n);
        let limit = Wide::int(1) / omega.square();
        let rounding = Wide::exp2i(-200);

        // f(π − τ) = −f(τ)
        for k in 1..20 {
            let zeta = part(Wide::int(0), Wide::int(2) * beta, k, 40);
            let sum = f(zeta) + f(Wide::int(2) * beta - zeta);
            assert!(sum.abs() < rounding * (limit + f(zeta).abs()), "{inverse}: {sum}");
        }
        // Up to γ, f is monotonic from 1/Ω²: increasing for T > 0 and decreasing for T < 0.
        let end = if gamma < beta { gamma } else { beta };
        let mut last = limit;
        for k in 1..=200 {
            let here = f(part(Wide::int(0), end, k, 200));
            assert!((here > last) == (tangent > Wide::int(0)), "{inverse}: {here} after {last}");
            last = here;
        }
        // In [γ, γ + π], |f| increases to one stationary point and then decreases.
        let lobe_end = if gamma + pi < beta { gamma + pi } else { beta };
        let (mut falls, mut most, mut before) = (0, Wide::int(0), f(gamma).abs());
        let mut was_rising = true;
        for k in 1..=800 {
            let here = f(part(gamma, lobe_end, k, 800)).abs();
            let rises = here > before;
            falls += i32::from(was_rising && !rises);
            assert!(was_rising || !rises, "{inverse}: a second rise at {k}");
            (was_rising, before) = (rises, here);
            most = most.or_larger(here);
        }
        assert_eq!(falls, 1, "{inverse}");
        // Beyond, no value is larger.
        if lobe_end < beta {
            for k in 1..=400 {
                assert!(f(part(lobe_end, beta, k, 400)).abs() <= most, "{inverse}: {k}");
            }
        }
        // That is the border, up to the amount by which the grid misses a maximum.
        let border = Border::new(omega).unwrap();
        let supremum = border.least_displacement;
        let due = limit.or_larger(most);
        assert!(due <= supremum * (Wide::int(1) + rounding), "{inverse}: {due} above {supremum}");
        assert!(supremum <= due * Wide::from(1.0 + 1e-4), "{inverse}: {supremum} above {due}");
        let phase = border.border_phase;
        if phase > Wide::int(0) {
            let exact = f(phase / omega).abs();
            assert!(
                (exact / supremum - Wide::int(1)).abs() < Wide::exp2i(-150),
                "{inverse}: {exact} {supremum}"
            );
        }
    }
}
