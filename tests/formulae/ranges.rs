//! Statements of `docs/development/proof.md` over whole ranges: boxes are halved until ball arithmetic proves the sign in
//! each.

use crate::float::ball::Ball;
use stickslip::float::Mp;
use stickslip::{Field, Real};

type B = Ball<1>;

/// `sin x/x`. Up to 1/2 the enclosure also uses its series, `1 − x²/6 ≤ sin x/x ≤ 1 − x²/6 + x⁴/120`, because
/// the quotient of two balls near zero is wide.
fn sinc(x: B) -> B {
    let quotient = x.sin() / x;
    if !x.abs().is_below(&B::ratio(1, 2)) {
        return quotient;
    }
    let square = x.square();
    let rest = Ball::between(Mp::ZERO, (square.square() / B::int(120)).upper());
    quotient.intersection(&(B::int(1) - square / B::int(6) + rest)).unwrap()
}

/// `[1/Ω² − f(τ)] Ω sin τ`, with u = 1/Ω and f the function of Den Hartog's condition, in a form that is
/// smooth through u = 1: with v = u − 1, `T (cos τ − cos uτ) = −2 cos(πv/2) sin((1 + u)τ/2)
/// sin(vτ/2)/sin(πv/2)`.
fn clearance(u: B, tau: B) -> B {
    let (half, v) = (B::ratio(1, 2), u - B::int(1));
    let turn = B::pi() * half * v;
    let quotient = tau / B::pi() * sinc(v * tau * half) / sinc(turn);
    let matched = B::int(2) * turn.cos() * ((B::int(1) + u) * tau * half).sin() * quotient;
    u * tau.sin() - (u * tau).sin() + matched
}

/// The number of boxes after which `holds` is true in every part of a rectangle; an error otherwise.
fn throughout(
    first: (f64, f64),
    second: (f64, f64),
    holds: impl Fn(B, B) -> bool,
) -> Result<usize, (f64, f64)> {
    let ball = |(low, high): (f64, f64)| B::between(Mp::from(low), Mp::from(high));
    let mut left = vec![(first, second)];
    let mut count = 0;
    while let Some((x, y)) = left.pop() {
        count += 1;
        if holds(ball(x), ball(y)) {
            continue;
        }
        if count > 400_000 || x.1 - x.0 < 1e-9 {
            return Err((x.0, y.0));
        }
        let middle = |(low, high): (f64, f64)| f64::midpoint(low, high);
        for x in [(x.0, middle(x)), (middle(x), x.1)] {
            left.extend([(x, (y.0, middle(y))), (x, (middle(y), y.1))]);
        }
    }
    Ok(count)
}

/// Eq. 61 suffices: `f(τ) < 1/Ω²` for every Ω in [1/2, 20] and τ in [0.15, π/2].
///
/// The rest is at the ends, where `src/cycle/border.rs` derives the sign: as τ → 0, f → 1/Ω², and as Ω
/// → ∞ both sides vanish.
#[test]
fn equation_61_suffices_over_a_whole_range() {
    let quarter = std::f64::consts::FRAC_PI_2.next_up();
    let boxes = throughout((0.05, 2.0), (0.15, quarter), |u, tau| clearance(u, tau).is_positive());
    assert!(boxes.is_ok_and(|count| count > 100), "{boxes:?}");
    // The same method finds that eq. 61 does not suffice just below Ω = 1/2.
    assert!(throughout((2.0, 2.2), (0.15, quarter), |u, tau| clearance(u, tau).is_positive()).is_err());
}

/// The form above equals the condition's own function.
#[test]
fn the_smooth_form_is_den_hartogs() {
    for (u, tau) in [(0.3f64, 0.4f64), (0.7, 1.2), (1.4, 0.9), (1.9, 0.2), (2.15, 1.1)] {
        let tangent = (std::f64::consts::FRAC_PI_2 * u).tan();
        let f = u * ((u * tau).sin() + tangent * (tau.cos() - (u * tau).cos())) / tau.sin();
        let expected = (u * u - f) / u * tau.sin();
        let found = clearance(Ball::exact(Mp::from(u)), Ball::exact(Mp::from(tau)));
        assert!((found.mid().to_f64() - expected).abs() < 1e-14, "{u} {tau}: {found} {expected}");
    }
}

/// The sign of ρ for Ω > 1: `Ω sin β = (π/2) sin β/β > 1`, so that the velocity decreases in the middle of
/// the half cycle.
#[test]
fn the_velocity_falls_in_the_middle_above_resonance() {
    let half = B::ratio(1, 2);
    let falls = |u: B, _| (B::pi() * half * sinc(B::pi() * half * u) - B::int(1)).is_positive();
    assert!(throughout((0.0, 0.999), (0.0, 1.0), falls).is_ok());
    assert!(throughout((0.0, 1.001), (0.0, 1.0), falls).is_err());
}

/// The velocity has one stationary point: with ψ = tβ, y = (π/2)(1 − u) and Δ₀/B ≥ 1/Ω², v′/cos Ωψ decreases
/// where q < 1,
///
/// ```text
/// cos²Ωψ (v′/cos Ωψ)′ = q − Ω²Δ₀/B,   q = (2/π) [cos ψ sin Ωψ + ψ sin(ty)/(ty)]/(sin y/y),
/// ```
///
/// and for Ω < 1, in the second half, v′ ≤ m/Ω < 0 elsewhere, with `m = [cos ψ − Ω sin β cos Ωψ]/cos β − sin
/// Ωψ`; v′(0) < 0 there. So v′ has at most one zero. This covers every Ω in [0.52, 50] and |ψ| ≤ 0.9 β; the
/// rest is derived in `src/cycle/velocity.rs`.
#[test]
fn the_velocity_has_one_stationary_point_over_a_whole_range() {
    let quarter = || B::pi() * B::ratio(1, 2);
    let falls = |u: B, t: B| {
        let (y, psi, slow) = (quarter() * (B::int(1) - u), quarter() * u * t, quarter() * t);
        let q = (psi.cos() * slow.sin() + psi * sinc(t * y)) / sinc(y) / quarter();
        (B::int(1) - q).is_positive()
    };
    let is_negative = |u: B, t: B| {
        let (y, psi, slow) = (quarter() * (B::int(1) - u), quarter() * u * t, quarter() * t);
        let m = (psi.cos() - y.cos() * slow.cos() / u) / y.sin() - slow.sin();
        (u - B::int(1)).is_positive() && t.is_positive() && m.is_negative()
    };
    let holds = |u, t| falls(u, t) || is_negative(u, t);
    let found = throughout((0.02, 1.92), (-0.9, 0.9), holds);
    assert!(found.is_ok_and(|count| count > 100), "{found:?}");
    // Neither condition is enough alone. At the turning point itself, where v = v′ = 0 on the border, no ball
    // can prove it.
    assert!(throughout((1.2, 1.9), (0.1, 0.9), falls).is_err());
    assert!(throughout((0.5, 0.9), (0.9, 1.0), holds).is_err());
}

/// The sign of ρ for Ω < 1. With ψ = tβ, Δ = Δ₀/B and σ the sign of cos β, the velocity of the half cycle is
///
/// ```text
/// v = Δ cos Ωψ + o(ψ),   o = (sin ψ − sin β sin Ωψ)/cos β,   ρ = sin ψ/cos β at its maximum,
/// ```
///
/// and Δ is at least both 1/Ω² and |tan β| cot(πΩ/2)/Ω, the values of the border's function at τ = 0 and πΩ.
/// Where sin ψ does not have the sign of cos β, no Δ makes ψ the maximum: either v(0) = Δ is larger, or v′ is
/// not zero. The ends of the half cycle are included. The proof by hand covers the neighbourhoods of Ω = 1
/// and the poles, where cos β = 0, and of ψ = 0 on the side of the maximum, where `v′(0) = (1 − Ω sin β)/cos
/// β`.
#[test]
fn rho_is_positive_over_whole_ranges_below_resonance() {
    let half_pi = || B::pi() * B::ratio(1, 2);
    // All terms up to a factor |cos β|.
    let excluded = |u: B, t: B, sigma: i32| {
        let (beta, slow, sigma) = (half_pi() * u, half_pi() * t, B::int(sigma));
        let psi = beta * t;
        let ((sin_beta, cos_beta), (sine, cosine)) = (beta.sin_cos(), psi.sin_cos());
        if (sigma * sine).is_positive() {
            return true;
        }
        let (slow_sine, slow_cosine) = slow.sin_cos();
        let least = (sigma * cos_beta * u.square()).larger(&(sin_beta.abs() * u / (half_pi() / u).tan()));
        let odd = sigma * (sine - sin_beta * slow_sine);
        let is_below_middle = (least * (B::int(1) - slow_cosine) - odd).is_positive();
        let slope = sigma * (cosine - sin_beta * slow_cosine / u) - least * slow_sine / u;
        is_below_middle || if t.mid() > Mp::ZERO { slope.is_negative() } else { slope.is_positive() }
    };
    // Ranges of 1/Ω with the sign of cos β: Ω in [0.335, 0.98], [0.2005, 0.332], [0.1435, 0.1995], [0.112,
    // 0.1425].
    for (low, high, sigma) in [(1.02, 2.985, -1), (3.012, 4.987, 1), (5.013, 6.968, -1), (7.018, 8.928, 1)] {
        for t in if sigma > 0 { [(-1.0, 0.0), (0.001, 1.0)] } else { [(0.0, 1.0), (-1.0, -0.001)] } {
            let found = throughout((low, high), t, |u, t| excluded(u, t, sigma));
            assert!(found.is_ok_and(|count| count > 40), "{low} {t:?}: {found:?}");
        }
        // With the other sign, the statement is refuted.
        assert!(
            throughout((low, high), (0.001, 1.0), |u, t| excluded(u, t, -sigma)).is_err()
                || throughout((low, high), (-1.0, -0.001), |u, t| excluded(u, t, -sigma)).is_err()
        );
    }
}
