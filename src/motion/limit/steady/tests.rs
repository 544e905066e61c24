use super::SteadyState;
use crate::Ratios;
use crate::motion::{LongRun, State, Trajectory};
use std::f64::consts::TAU;

/// The motion returns to the stated state after a cycle and has the stated extrema.
#[test]
fn the_state_is_on_the_motion() {
    for (omega, alpha) in [(0.3f64, 2.0f64), (0.4, 9.0), (0.7, 1.2), (1.6, 1.5), (3.0, 4.0)] {
        let ratios = Ratios::new(omega, alpha).unwrap();
        let found = LongRun::from_start(ratios, State::default()).unwrap();
        let steady: &SteadyState<f64> = found.steady_state().unwrap();
        let start = steady.state;
        let (mut most, mut fastest) = (0.0f64, 0.0f64);
        for sample in
            Trajectory::new(ratios, start).unwrap().samples(4000).unwrap().take(4001).map(Result::unwrap)
        {
            (most, fastest) = (most.max(sample.state.x), fastest.max(sample.state.v));
        }
        let close = |found: f64, sampled: f64| (found - sampled).abs() < 1e-5 * found;
        assert!(close(steady.max_displacement.value, most), "{omega} {alpha}: {most} {steady:?}");
        assert!(close(steady.max_velocity.value, fastest), "{omega} {alpha}: {fastest} {steady:?}");
        let phases = Trajectory::new(ratios, start).unwrap();
        let cycle_on = start.phase.later_by_half_turns(2);
        let last = phases
            .map(Result::unwrap)
            .take_while(|phase| phase.start().phase.since(start.phase) < TAU)
            .last()
            .unwrap();
        let back = last.at(cycle_on).state;
        assert!((back.x - start.x).abs() < 1e-12 && (back.v - start.v).abs() < 1e-12, "{back:?} {start:?}");
    }
}
