//! The limits of starts, compared with an independent simulation.

use super::attractors;
use crate::Ratios;
use crate::motion::machines::{ratios, starts};
use crate::motion::{LongRun, State};

/// Maximum and minimum displacement, stops, turns, symmetry, and whether the mirror image counts, for each
/// limit, ordered by the peak displacement.
type ListedLimit = (f64, f64, u32, u32, bool, bool);

fn found(ratios: Ratios<f64>, count: u32) -> Vec<ListedLimit> {
    let all = attractors(ratios, &starts(count, 10.0), 1000).unwrap();
    assert_eq!(all.unsettled(), 0);
    assert_eq!(all.limits.iter().map(|limit| limit.starts).sum::<u64>(), u64::from(count));
    let mut found: Vec<_> = all
        .limits
        .iter()
        .map(|limit| {
            let LongRun::Periodic(s) = limit.limit else { panic!("{limit:?}") };
            if let Some(mirror) = limit.mirror {
                let other = all.limits[mirror].limit.steady_state().unwrap();
                assert!((other.max_displacement.value + s.min_displacement.value).abs() < 1e-9);
            }
            (
                s.max_displacement.value,
                s.min_displacement.value,
                s.sticks_per_cycle,
                s.turns_per_cycle,
                s.is_symmetric,
                limit.mirror.is_some(),
            )
        })
        .collect();
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    found
}

fn same(found: &[ListedLimit], expected: &[ListedLimit]) {
    let is = |a: &ListedLimit, b: &ListedLimit| {
        let close = (a.0 - b.0).abs() < 1e-6 && (a.1 - b.1).abs() < 1e-6;
        close && (a.2, a.3, a.4, a.5) == (b.2, b.3, b.4, b.5)
    };
    let all = found.len() == expected.len() && found.iter().zip(expected).all(|(a, b)| is(a, b));
    assert!(all, "{found:#?} for {expected:#?}");
}

/// The five regular cases of an independent simulation: all of its motions, and no others.
#[test]
fn limits_of_an_independent_simulation() {
    let pair = |most: f64, least: f64, stops, turns| {
        let one = (most, -least, stops, turns, false, true);
        [one, (least, -most, stops, turns, false, true)]
    };
    same(&found(ratios(0.5, 0.02, 1.3, 4.0), 60), &pair(5.362_738, 5.185_938, 1, 1));
    same(&found(ratios(0.54, 0.03, 2.4, 4.2), 60), &pair(6.913_339, 5.098_781, 1, 1));
    let [high, low] = pair(6.221_430, 5.496_536, 1, 1);
    let between = (5.770_820, -5.770_820, 0, 1, true, false);
    same(&found(ratios(0.573, 0.005, 1.87, 3.92), 60), &[high, between, low]);
    let two = [(4.921_033, 4), (2.734_118, 2)].map(|(x, stops)| (x, -x, stops, 1, true, false));
    same(&found(ratios(0.1356, 0.0388, 2.7673, 4.4107), 60), &two);
    let three = found(ratios(0.428, 0.013, 2.9, 5.6), 60);
    let [high, low] = pair(8.623_030, 6.190_593, three[0].2, 3);
    same(&three, &[high, low]);
}

/// A start at another phase is recognised as leading to the same motion.
#[test]
fn one_limit_whatever_the_phase_of_the_start() {
    let ratios = ratios(0.5, 0.02, 1.3, 4.0);
    let starts: Vec<_> = (0..24)
        .map(|i| State::new(f64::from(i) * 0.7, 6.0 * (f64::from(i) * 0.618).sin(), 0.3).unwrap())
        .collect();
    let all = attractors(ratios, &starts, 1000).unwrap();
    assert_eq!(all.limits.len(), 2, "{:?}", all.limits);
    let of_start = |i: usize| all.of_start[i].map(|place| all.limits[place].first_start);
    assert!((0..24).all(|i| of_start(i).is_some_and(|first| first <= i)));
}

/// All positions of rest are one limit, with their range.
#[test]
fn places_of_rest_are_one_limit() {
    let all = attractors(ratios(0.8, 0.02, 1.6, 1.5), &starts(40, 5.0), 1000).unwrap();
    let rest = all.limits.iter().find(|limit| matches!(limit.limit, LongRun::Rest(_))).unwrap();
    let (low, high) = rest.range.unwrap();
    assert!(-0.1 <= low && low <= high && high <= 0.1 + 1e-12, "{low} {high}");
    assert!(all.limits.iter().any(|limit| limit.limit.steady_state().is_some()));
}
