use super::{every_start, sliding_bound};
use crate::motion::limit::observed::observed;
use crate::motion::{LongRun, State};
use crate::{NoStop, Ratios, Regime, Response, Verdict};
use core::ops::ControlFlow;

fn ratios(omega: f64, alpha: f64, zeta: f64, eta: f64) -> Ratios<f64> {
    let plain = Ratios::new(omega, alpha).unwrap().with_damping_ratio(zeta).unwrap();
    plain.with_static_friction_ratio(eta).unwrap()
}

fn limit(ratios: Ratios<f64>, start: State<f64>, periods: u32) -> LongRun<f64> {
    LongRun::within(ratios, start, periods, &mut || ControlFlow::Continue(())).unwrap()
}

/// The border guarantees a cycle; a body at rest moves for α > η; the regime is that of every start.
#[test]
fn each_statement_has_its_place() {
    use Regime::{DependsOnStart, NonSticking, Sticking, Stuck, Unbounded};
    for (omega, alpha, zeta, eta, regime, reversals, moves) in [
        // The border at Ω = 1.036 is 1.302564, below η.
        (1.036, 1.0, 0.0, 2.07, Stuck, None, false),
        (1.036, 1.3, 0.0, 2.07, DependsOnStart, None, false),
        (1.036, 1.31, 0.0, 2.07, DependsOnStart, Some(2), false),
        (1.036, 2.06, 0.0, 2.07, DependsOnStart, Some(2), false),
        (1.036, 2.08, 0.0, 2.07, DependsOnStart, Some(2), true),
        // At 0.5 it is 3η.
        (0.5, 1.2, 0.02, 1.3, DependsOnStart, None, false),
        (0.5, 2.0, 0.02, 1.3, Sticking, None, true),
        (0.5, 4.5, 0.02, 1.3, DependsOnStart, Some(2), true),
        (0.5, 300.0, 0.02, 1.3, NonSticking, Some(2), true),
        // Resonance without a damper: 4/π, 4η/π.
        (1.0, 1.25, 0.0, 1.2, Sticking, None, true),
        (1.0, 1.3, 0.0, 1.2, DependsOnStart, None, true),
        (1.0, 1.3, 0.0, 1.5, DependsOnStart, None, false),
        (1.0, 1.6, 0.0, 1.2, Unbounded, None, true),
        // Beside the pole 1/3.
        (0.331, 100.0, 5e-4, 1.01, DependsOnStart, Some(6), true),
        (0.331, 100.0, 0.0, 1.01, DependsOnStart, Some(6), true),
        (0.331, 54.0, 0.0, 1.1, Sticking, None, true),
        (0.331, 155.0, 0.0, 1.1, Sticking, None, true),
    ] {
        let ratios = ratios(omega, alpha, zeta, eta);
        let found = Response::new(ratios);
        let at = format!("{ratios:?}");
        assert_eq!((found.regime, found.reversals_per_cycle()), (regime, reversals), "{at}");
        assert_eq!((ratios.moves_from_rest(), found.cycle.is_some()), (moves, reversals == Some(2)), "{at}");
        let grows = omega == 1.0 && alpha > 1.28;
        assert_eq!(found.has_motion_without_stop(), reversals.is_some() || grows, "{at}");
        assert_eq!(Verdict::new(ratios).regime(), Some(regime), "{at}");
        let limit = limit(ratios, State::default(), 4000);
        assert_eq!(matches!(limit, LongRun::Rest(_)), !moves, "{at}");
        if regime != DependsOnStart {
            assert_eq!(observed(ratios, &limit).regime, regime, "{at}");
        }
    }
}

/// Six reversals without a stop, in the words of the exact motion: a start at one of the reversals leads to them.
#[test]
fn six_reversals_are_a_motion_with_static_friction_too() {
    for (omega, alpha, zeta, eta) in
        [(0.331, 100.0, 5e-4, 1.01), (0.331, 100.0, 0.0, 1.3), (0.1993, 250.0, 1e-5, 1.2)]
    {
        let ratios = ratios(omega, alpha, zeta, eta);
        let cycle = crate::cycle::SixReversals::new(ratios).unwrap();
        assert!(cycle.forces().into_iter().all(|force| force > eta), "{:?}", cycle.forces());
        let [first, ..] = cycle.reversal_phases();
        let phase = first - 0.1;
        let start = State::new(phase, cycle.displacement_at(phase), cycle.velocity_at(phase)).unwrap();
        let seen = observed(ratios, &limit(ratios, start, 20_000));
        assert_eq!((seen.regime, seen.reversals), (Regime::NonSticking, Some(6)), "{ratios:?}");
    }
}

/// 4 (1 + 10/π)/√2 η q/Ω² … at Ω = 1, ζ = 1/10: q = 1/5, √(1 + 1.44).
#[test]
fn the_bound_is_its_formula() {
    let due = 2.0 * 1.5 * 0.2 * (1.0 + 10.0 / std::f64::consts::PI) * 2.44f64.sqrt();
    assert!((sliding_bound(1.0, 0.1, 1.5) / due - 1.0).abs() < 1e-14);
    assert_eq!(every_start(&ratios(1.0, 1.0, 0.1, 1.5)), Some(sliding_bound(1.0, 0.1, 1.5)));
    assert_eq!(every_start(&ratios(0.9, 1.0, 0.0, 1.5)), None);
    assert!((every_start(&ratios(1.0, 1.0, 0.0, 1.5)).unwrap() * std::f64::consts::PI - 6.0).abs() < 1e-14);
    // It is a bound of the border.
    for (omega, zeta) in [(0.05, 0.3), (0.3, 0.01), (1.0, 1e-6), (1.0, 3.0), (7.0, 0.2)] {
        let found = NoStop::of(&ratios(omega, 1.0, zeta, 1.3));
        assert!(found.every_start.unwrap() > found.border, "{omega} {zeta}: {found:?}");
    }
}

/// Machines and starts over the plane: the closed statements against the exact motion.
#[test]
fn the_exact_motion_contradicts_no_statement() {
    let mut seen = Vec::new();
    for i in 0..160u32 {
        let spread = |step: f64| (f64::from(i) * step).fract();
        let eta = 1.0 + 10f64.powf(2.5 * spread(0.618_034) - 2.0);
        let omega = 10f64.powf(1.3 * spread(0.754_878) - 0.8);
        let zeta = if i % 4 == 0 { 0.0 } else { 10f64.powf(3.0 * spread(0.569_840) - 3.0) };
        let edges = NoStop::of(&ratios(omega, 1.0, zeta, eta));
        let share = spread(0.437_016);
        let alpha = match i % 5 {
            0 => 0.5 + (1.2 * eta - 0.5) * share,
            1 => edges.border * (0.5 + share),
            2 => eta * (0.9 + share),
            3 => eta + (edges.border - eta) * share,
            _ => edges.every_start.unwrap_or(edges.border) * (0.8 + share),
        };
        let ratios = ratios(omega, alpha.max(0.3), zeta, eta);
        let found = Response::new(ratios);
        let far = State::new(6.0 * spread(0.381_966), 3.0 * alpha, -2.0 * alpha).unwrap();
        for (start, is_rest) in [(State::default(), true), (far, false)] {
            let limit = limit(ratios, start, 1000);
            if matches!(limit, LongRun::NotConverged { .. }) {
                continue;
            }
            let motion = observed(ratios, &limit);
            let rests = matches!(limit, LongRun::Rest(_));
            let at = format!("{ratios:?} {:?} {motion:?}", found.regime);
            assert!(found.regime == Regime::DependsOnStart || found.regime == motion.regime, "{at}");
            assert!(!(rests && ratios.moves_from_rest()), "{at}");
            assert!(!is_rest || rests != ratios.moves_from_rest(), "{at}");
            match motion.regime {
                Regime::NonSticking if motion.reversals.is_some() => {
                    assert_eq!(motion.reversals, found.reversals_per_cycle(), "{at}");
                }
                Regime::NonSticking | Regime::Unbounded => assert!(found.has_motion_without_stop(), "{at}"),
                Regime::Stuck | Regime::Sticking | Regime::DependsOnStart => {}
            }
            seen.push(found.regime);
        }
    }
    for regime in [Regime::Stuck, Regime::Sticking, Regime::NonSticking, Regime::DependsOnStart] {
        assert!(seen.iter().filter(|r| **r == regime).count() >= 10, "{regime}");
    }
}
