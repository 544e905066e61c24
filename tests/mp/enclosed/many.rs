//! The campaign over a million points.

use super::at_point;
use crate::random::Random;
use std::time::{Duration, Instant};
use stickslip::enclosed::MAX_BITS;
use stickslip::float::Mp;
use stickslip::{Border, Field as _, Float as _, Output, Ratios, Response};

/// A million points, half of them adversarial: every value must lie in its enclosure. Prints widths and times
/// for `docs/development/accuracy.md`. `STICKSLIP_SEED`, `STICKSLIP_POINTS` and `STICKSLIP_SECONDS` select the points,
/// their number and the greatest duration.
#[test]
#[ignore = "minutes; .ci/slow enclosures"]
#[allow(clippy::print_stdout, reason = "the figures are what it is run for")]
fn a_million_points() {
    let number = |name: &str, otherwise: u64| std::env::var(name).map_or(otherwise, |n| n.parse().unwrap());
    let (most, seconds) = (number("STICKSLIP_POINTS", 1_000_000), number("STICKSLIP_SECONDS", 1 << 40));
    let (mut count, start) = (0, Instant::now());
    let mut generator = Random(number("STICKSLIP_SEED", 20));
    let mut random = || generator.next();
    let (mut widths, mut undecided, mut values, mut more_bits) = (Vec::new(), 0, 0u64, 0);
    let (mut with, mut without) = (Duration::ZERO, Duration::ZERO);
    for i in (0..most).take_while(|_| start.elapsed().as_secs() < seconds) {
        count += 1;
        let n = (1.0 + 12.0 * random()).floor();
        let sign = if random() < 0.5 { 1.0 } else { -1.0 };
        let omega = match i % 4 {
            0 => (6.0 * (2.0 * random() - 1.0)).exp(),
            1 => 0.1 + 3.0 * random(),
            2 => (1.0 + sign * 2f64.powf(-3.0 - 49.0 * random())) / n,
            _ => (1.0 + sign * 2f64.powf(-1.0 - 9.0 * random())) / n,
        };
        let least = Border::new(omega).unwrap().min_force_ratio;
        let alpha = match i % 3 {
            0 => least * (1.0 + 20.0 * random()),
            1 => least * (1.0 + 2f64.powf(-52.0 * random())),
            // Below the border only where there can be no motion of six reversals, which has no enclosure.
            _ => least * (1.0 + if omega < 0.5 { 1.0 } else { sign } * 2f64.powf(-4.0 - 48.0 * random())),
        };
        let begun = Instant::now();
        let found = at_point(omega, alpha);
        with += begun.elapsed();
        let ratios = Ratios::new(Mp::<1>::from(omega), Mp::from(alpha)).unwrap();
        let begun = Instant::now();
        let plain = Response::guarded(ratios);
        std::hint::black_box(Output::ALL.map(|output| output.of(&plain)));
        without += begun.elapsed();
        let exact = Response::guarded(Ratios::new(Mp::<4>::from(omega), Mp::from(alpha)).unwrap());
        undecided += u64::from(found.regime.is_none());
        more_bits += u64::from(found.bits > 128);
        assert!(found.bits <= MAX_BITS);
        for output in Output::ALL {
            if let Some(enclosure) = found.get(output)
                && let Some(value) = output.of(&exact)
            {
                let distance = (value - Mp::<4>::from(&enclosure.mid)).abs();
                let rad = Mp::<4>::from(&enclosure.rad);
                assert!(distance <= rad, "{omega:e} {alpha:e} {output:?}: {value} {enclosure}");
                values += 1;
                if value != Mp::ZERO {
                    // The width between both ends, in units in the last place of 64 bits.
                    widths.push(
                        (rad.scale2(1) / Mp::<4>::rounded(Mp::<1>::rounded(value).ulp())).to_f64() as f32
                    );
                }
            }
        }
    }
    widths.sort_by(f32::total_cmp);
    println!(
        "{count} points, {values} values of all outputs, none outside; width median {}, worst {} ulp; \
         {undecided} undecided; more than 128 bits: {more_bits}; \
         time {:.2} times that of Response::guarded",
        widths[widths.len() / 2],
        widths[widths.len() - 1],
        with.as_secs_f64() / without.as_secs_f64()
    );
}
