//! Proofs that steady motions exist, compared with the exact solver.

use super::text;
use stickslip::enclosed::{self, Enclosure, Event, Known, Unproved};
use stickslip::float::Mp;
use stickslip::motion::{LongRun, State};
use stickslip::{Field as _, Float as _, Ratios};

/// The motions of the exact solver at 256 bits are all proved to exist, with place, stops, extrema and
/// multipliers in their enclosures.
#[test]
fn steady_motions_are_proved() {
    for (omega, alpha, zeta, eta, sticks) in [
        ("0.4", "6", "0", "1", 2),
        ("0.1", "3", "0", "1", 4),
        ("0.15", "3", "0", "1", 4),
        ("1.5", "2.5", "0", "1", 0),
        ("0.6", "1.7", "0.05", "1", 2),
        ("0.8", "2", "0.05", "1", 0),
        ("0.6", "2.2", "0.05", "1.3", 2),
        ("0.3", "4", "0.1", "1.3", 2),
        ("0.8", "1.5", "0.05", "1.25", 0),
        // At and above critical damping.
        ("0.6", "1.7", "1", "1", 2),
        ("0.4", "1.6", "3", "1.2", 2),
        ("0.9", "9", "1.5", "1", 0),
        // Below Ω = 1/100: many slides after each other, and slides of many free waves and of creep.
        ("1e-3", "3", "1e-3", "1", 54),
        ("1e-4", "3", "0.7", "1", 2),
        ("2.5e-3", "1.07", "14.6", "1", 2),
        // One of a mirror pair.
        ("0.5", "4", "0.02", "1.3", 1),
    ] {
        let found = enclosed::KnownRatios::new(&text(omega))
            .with_force_ratio(&text(alpha))
            .with_damping_ratio(&text(zeta))
            .with_static_friction_ratio(&text(eta))
            .steady(128)
            .unwrap();
        let found = found.unwrap_or_else(|why| panic!("{omega} {alpha} {zeta}: {why}"));
        let ratios = Ratios::new(omega.parse::<Mp<4>>().unwrap(), alpha.parse().unwrap()).unwrap();
        let ratios = ratios.with_damping_ratio(zeta.parse().unwrap()).unwrap();
        let ratios = ratios.with_static_friction_ratio(eta.parse().unwrap()).unwrap();
        let run = LongRun::from_start(ratios, State::default()).unwrap();
        let exact = run.steady_state().unwrap();
        let near = |enclosure: &Enclosure, value: Mp<4>, name: &str| {
            // The enclosure has at least 30 digits, and contains the solver's value to within its own 60.
            let off = (value - Mp::from(&enclosure.mid)).abs().to_f64();
            assert!(enclosure.rad.to_f64() < 1e-30, "{omega} {alpha} {zeta} {name}: {enclosure}");
            assert!(
                off <= enclosure.rad.to_f64() + 1e-55,
                "{omega} {alpha} {zeta} {name}: {enclosure} {value}"
            );
        };
        near(&found.max_displacement, exact.max_displacement.value, "max_displacement");
        near(&found.min_displacement, exact.min_displacement.value, "min_displacement");
        near(&found.max_velocity, exact.max_velocity.value, "max_velocity");
        near(&found.min_velocity, exact.min_velocity.value, "min_velocity");
        assert_eq!(
            (found.is_symmetric, found.turns_per_cycle),
            (exact.is_symmetric, exact.turns_per_cycle),
            "{omega} {alpha} {zeta}"
        );
        near(&found.stick_fraction, exact.stick_fraction, "stick_fraction");
        assert_eq!(
            (found.sticks_per_cycle, exact.sticks_per_cycle),
            (sticks, sticks),
            "{omega} {alpha} {zeta}"
        );
        assert_eq!(found.velocity_zeros_per_cycle, exact.velocity_zeros_per_cycle, "{omega} {alpha} {zeta}");
        for ((re, im), (x, y)) in found.multipliers.iter().zip(exact.multipliers) {
            for (enclosure, value) in [(re, x), (im, y)] {
                let off = (value - Mp::from(&enclosure.mid)).abs().to_f64();
                assert!(off < 1e-25, "{omega} {alpha} {zeta}: {enclosure} {value}");
            }
        }
        assert!(found.only_within.1.mid.to_f64() > 1e-7, "{:?}", found.only_within);
    }
}

/// Grazing events are not claimed: the reason is returned, and for a decision the event.
#[test]
fn what_cannot_be_proved_is_not_claimed() {
    let with = |[omega, alpha, zeta, eta]: [&str; 4]| {
        enclosed::KnownRatios::new(&text(omega))
            .with_force_ratio(&text(alpha))
            .with_damping_ratio(&text(zeta))
            .with_static_friction_ratio(&text(eta))
            .steady(64)
    };
    let reason = |omega, alpha| with([omega, alpha, "0", "1"]).unwrap().unwrap_err();
    assert_eq!(reason("0.7", "0.9"), Unproved::NotPeriodic);
    assert_eq!(reason("1", "2"), Unproved::NotPeriodic);
    assert_eq!(reason("1e-4", "3"), Unproved::TooManySlides);
    assert_eq!(reason("0.5", "3"), Unproved::Family);
    // Force ratios on both sides of the border: some slides end earlier than others, and no number of bits
    // decides which.
    let both = Known::between(&text("1.5679"), &text("1.5681")).unwrap();
    let both = enclosed::KnownRatios::new(&text("0.7"))
        .with_force_ratio(&both)
        .with_damping_ratio(&text("0.05"))
        .steady(64)
        .unwrap();
    let Err(Unproved::Undecided { event, bits, .. }) = both else { panic!("{both:?}") };
    assert_eq!((event, bits), (Event::End, 4160));
    // Six reversals a cycle are a motion like any other.
    let six = with(["0.331", "61.6", "0", "1"]).unwrap();
    assert_eq!(six.unwrap().velocity_zeros_per_cycle, 6);
    assert!(with(["1e10", "3", "0", "1"]).is_err() && with(["0.5", "3", "0", "0.99"]).is_err());
}
