//! Monte-Carlo estimates, compared with known shares and with their own standard errors.

use crate::compared::{Origin::ByHand, compared};
use rand_distr::{Distribution, Normal, Uniform};
use stickslip::uncertainty::{MonteCarlo, Parameters};
use stickslip::{Border, Drive, Error, Excitation, Oscillator, Output, Ratios, Regime};

fn machine(friction_bound: f64, damping: f64) -> Parameters<f64> {
    Parameters {
        excitation: Excitation::Force,
        mass: 50.0,
        stiffness: 1000.0,
        friction_bound,
        amplitude: 12.0,
        angular_frequency: 6.0,
        damping,
    }
}

fn drawn(
    friction: impl Distribution<f64>,
    outputs: &[Output],
    draws: u32,
    seed: u64,
) -> Result<MonteCarlo, Error> {
    MonteCarlo::new(|rng| machine(friction.sample(rng), 0.0), outputs, draws, seed)
}

#[test]
fn probabilities_and_quantiles_are_those_of_the_distribution() {
    // For a uniform r_y, the body sticks above p₀/α_min.
    let greatest = 12.0 / Border::new(6.0 / 20f64.sqrt()).unwrap().min_force_ratio;
    let uniform = Uniform::new(4.0, 10.0).unwrap();
    let outputs = [Output::Margin, Output::MaxDisplacement];
    let found = drawn(uniform, &outputs, 40_000, 3).unwrap();
    let expected = (10.0 - greatest) / 6.0;
    let sticking = found.probability(Regime::Sticking);
    let of = "fn uncertainty::MonteCarlo::*";
    compared(of, sticking.value, expected, ByHand, 4.0 * sticking.standard_error);
    assert!((sticking.standard_error - (expected * (1.0 - expected) / 4e4).sqrt()).abs() < 1e-4);
    // The margin decreases with r_y: its quantile is that of r_y at the complementary share.
    for share in [0.05, 0.5, 0.9] {
        let margin = found.quantile(Output::Margin, share).unwrap();
        compared(of, greatest / margin, 10.0 - 6.0 * share, ByHand, 0.1);
    }
    assert_eq!(found.values(Output::MaxDisplacement).len(), found.count(Regime::NonSticking) as usize);
    assert_eq!(found.values(Output::Margin).len(), 40_000);
    assert!(
        found.quantile(Output::Margin, 1.1).is_none() && found.quantile(Output::Deviation, 0.5).is_none()
    );
    // Quantiles are linear between the ordered values.
    let values = &found[Output::Margin];
    assert!(values == found.values(Output::Margin) && found[Output::MaxVelocity].is_empty());
    for (i, part) in [(0usize, 0.25), (1234, 0.5), (39_998, 0.75)] {
        let share = (i as f64 + part) / (values.len() - 1) as f64;
        let due = values[i] * (1.0 - part) + values[i + 1] * part;
        assert!((found.quantile(Output::Margin, share).unwrap() - due).abs() < 1e-9 * due, "{i}");
    }
    assert!([-0.1, f64::NAN].iter().all(|&share| found.quantile(Output::Margin, share).is_none()));
    let mean = found.mean(Output::Margin).unwrap();
    let exact = greatest / 6.0 * (10f64 / 4.0).ln();
    compared(of, mean.value, exact, ByHand, 4.0 * mean.standard_error);
    let variance = greatest * greatest * (1.0 / 4.0 - 1.0 / 10.0) / 6.0 - exact * exact;
    assert!((mean.standard_error / (variance / 4e4).sqrt() - 1.0).abs() < 0.02, "{mean:?} {variance}");
}

#[test]
fn the_seed_decides_and_invalid_draws_are_counted() {
    let wide = Normal::new(2.0, 2.0).unwrap();
    let run = |seed| drawn(wide, &[Output::MaxVelocity], 5000, seed).unwrap();
    assert_eq!(run(1), run(1));
    assert_ne!(run(1), run(2));
    // P(r_y ≤ 0) = Φ(−1) = 0.1587
    let invalid = f64::from(run(1).invalid) / 5000.0;
    assert!((invalid - 0.1587).abs() < 0.02, "{invalid}");
    let all = [Regime::Stuck, Regime::Sticking, Regime::NonSticking, Regime::Unbounded];
    let valid: u32 = all.iter().map(|regime| run(1).count(*regime)).sum();
    assert_eq!(valid + run(1).invalid, run(1).draws);
    assert!(drawn(wide, &[], 0, 1).is_err());
    let never = MonteCarlo::new(|_| machine(1.0, 0.0), &[], 100, 1).unwrap().probability(Regime::Sticking);
    assert!(never.value == 0.0 && never.standard_error > 0.0);
}

/// The damper of a draw counts: above the friction at which the damped body would stick, it does.
#[test]
fn a_draw_has_its_damper() -> Result<(), Error> {
    let damping = 300.0;
    let body = Oscillator::new(50.0, 1000.0, 1.0)?.with_damping(damping)?;
    let ratios: Ratios<f64> = Drive::force(12.0, 6.0)?.ratios(&body)?;
    let greatest = 12.0 / Border::of(&ratios).min_force_ratio;
    let undamped = 12.0 / Border::new(ratios.omega())?.min_force_ratio;
    assert!((greatest / undamped - 1.0).abs() > 0.1, "{greatest} {undamped}");
    let friction = Uniform::new(0.5 * greatest, 1.5 * greatest).unwrap();
    let sticking = MonteCarlo::new(|rng| machine(friction.sample(rng), damping), &[], 10_000, 5)?
        .probability(Regime::Sticking);
    assert!((sticking.value - 0.5).abs() < 4.0 * sticking.standard_error, "{sticking:?}");
    Ok(())
}
