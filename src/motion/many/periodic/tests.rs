//! Unstable motions at ratios where they are known, and stable ones that starts lead to.

use super::periodic_motions;
use crate::motion::attractors;
use crate::motion::machines::{ratios, starts};
use crate::motion::{LongRun, Signature, State};

/// Half turns, stops in a cycle, and extrema of an unstable motion.
type Unstable = (u32, u32, f64, f64);

/// Each mirror pair of the six machines is accompanied by the symmetric motion that lost its stability to the
/// pair, or by an unstable pair on the basin boundary. The two symmetric limits have no such neighbour: there
/// the boundary is a jump of the period map.
#[test]
fn unstable_motions_beside_the_limits() {
    let symmetric = |x: f64| (1, 2, x, -x);
    let cases: [(_, _, &[Unstable]); 6] = [
        (ratios(0.5, 0.02, 1.3, 4.0), 2, &[symmetric(5.271_292_025)]),
        (ratios(0.54, 0.03, 2.4, 4.2), 2, &[symmetric(6.110_469_521)]),
        (
            ratios(0.573, 0.005, 1.87, 3.92),
            2,
            &[(2, 1, 5.813_694_182, -5.741_734_934), (2, 1, 5.741_734_934, -5.813_694_182)],
        ),
        (ratios(0.1356, 0.0388, 2.7673, 4.4107), 1, &[]),
        (ratios(0.428, 0.013, 2.9, 5.6), 3, &[symmetric(7.098_911_165)]),
        (ratios(0.47, 0.023, 2.48, 7.44), 2, &[symmetric(9.509_955_005)]),
    ];
    for (ratios, turns, expected) in cases {
        let starts = starts(60, 10.0);
        let all = periodic_motions(ratios, &starts, turns).unwrap();
        let unstable: Vec<_> = all.iter().filter(|m| !m.steady_state.is_stable()).collect();
        assert_eq!(unstable.len(), expected.len(), "{ratios:?}: {unstable:#?}");
        for motion in unstable {
            let s = motion.steady_state;
            let (most, least) = (s.max_displacement.value, s.min_displacement.value);
            let is = |(half_turns, stops, a, b): &Unstable| {
                let close = (most - a).abs() < 1e-8 && (least - b).abs() < 1e-8;
                close && (s.half_turns(), s.sticks_per_cycle) == (*half_turns, *stops)
            };
            assert!(expected.iter().any(is), "{s:?}");
            assert_eq!(motion.mirror.is_some(), !s.is_symmetric);
            // No motion that starts close to the unstable one stays there.
            let start = State { x: s.state.x + 1e-6, ..s.state };
            match LongRun::from_start(ratios, start).unwrap() {
                LongRun::Periodic(limit) => {
                    assert!((limit.max_displacement.value - most).abs() > 1e-3, "{limit:?}")
                }
                LongRun::Irregular(limit) => {
                    assert!((limit.max_displacement - most).abs() > 0.1, "{limit:?}")
                }
                other => panic!("{other:?}"),
            }
        }
    }
}

/// The search finds every periodic limit that starts lead to, and every stable motion that it finds is a
/// limit.
#[test]
fn the_limits_are_among_them() {
    for (ratios, turns) in [
        (ratios(0.5, 0.02, 1.3, 4.0), 1),
        (ratios(0.573, 0.005, 1.87, 3.92), 1),
        (ratios(0.1356, 0.0388, 2.7673, 4.4107), 1),
        (ratios(0.428, 0.013, 2.9, 5.6), 3),
        (ratios(0.8, 0.02, 1.0, 2.5), 1),
    ] {
        let starts = starts(60, 10.0);
        let limits = attractors(ratios, &starts, 1000).unwrap();
        let all = periodic_motions(ratios, &starts, turns).unwrap();
        let signature = |s| Signature::of(&LongRun::Periodic(s)).unwrap();
        let stable = all.iter().map(|m| m.steady_state).filter(|s| s.is_stable());
        let mut seen: Vec<_> = stable.map(|s| limits.place_of(&signature(s))).collect();
        seen.sort_unstable();
        assert_eq!(seen, (0..limits.limits.len()).map(Some).collect::<Vec<_>>(), "{ratios:?}");
    }
}

/// Ten starts suffice to find the unstable pair on the basin boundary, whatever their range.
#[test]
fn few_starts_find_them() {
    for reach in [10.0, 18.4] {
        let all = periodic_motions(ratios(0.573, 0.005, 1.87, 3.92), &starts(10, reach), 1).unwrap();
        assert_eq!(all.len(), 5, "{reach}: {all:?}");
    }
}

#[test]
fn where_nothing_moves_there_is_none() {
    let all = periodic_motions(ratios(0.8, 0.02, 1.6, 1.0), &starts(20, 5.0), 2).unwrap();
    assert!(all.is_empty(), "{all:?}");
    // These starts are at rest, and the search needs one in motion.
    let resting = [State::default(), State::new(0.0, 0.05, 0.0).unwrap()];
    let all = periodic_motions(ratios(0.8, 0.02, 1.6, 1.5), &resting, 2).unwrap();
    assert!(all.is_empty(), "{all:?}");
}
