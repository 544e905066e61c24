//! The exact motion from rest, and difference quotients of it.

use crate::exact::{LongRun, Segment, State, SteadyState, Trajectory};
use crate::float::Float;
use crate::ratios::Ratios;

/// The limit of the motion from rest, and the derivative of its half-turn map by differences.
#[derive(Debug, Clone, Copy)]
pub(super) struct Motion<F> {
    pub(super) steady: SteadyState<F>,
    /// A bound of the distance of (x, w) from the limit.
    pub(super) doubt: F,
    /// Trace and determinant of the derivative of the negated half-turn map.
    pub(super) half_map: Option<(F, F)>,
}

impl<F: Float> Motion<F> {
    /// The motion at the ratios; `None` where it has no single limit, or none was found.
    pub(super) fn at(ratios: Ratios<F>) -> Option<Self> {
        let LongRun::Periodic(steady) = LongRun::from_start(ratios, State::default()).ok()? else {
            return None;
        };
        let (x, v) = steady.distance;
        let half_map = half_map(ratios, steady.state);
        Some(Self { steady, doubt: x.hypot(v * ratios.omega()), half_map })
    }
}

/// Trace and determinant of the derivative of `(x, v) → −(x, v)` half a turn later, by central differences.
fn half_map<F: Float>(ratios: Ratios<F>, state: State<F>) -> Option<(F, F)> {
    let size = F::int(1) + state.x.abs() + state.v.abs();
    let step = size * third_of_digits::<F>();
    let moved = |x: F, v: F| half_turn_on(ratios, State { x: state.x + x, v: state.v + v, ..state });
    let zero = F::int(0);
    let slope = |ahead: (F, F), back: (F, F)| {
        let twice = F::int(2) * step;
        ((back.0 - ahead.0) / twice, (back.1 - ahead.1) / twice)
    };
    let (a, c) = slope(moved(step, zero)?, moved(-step, zero)?);
    let (b, d) = slope(moved(zero, step)?, moved(zero, -step)?);
    Some((a + d, a * d - b * c))
}

/// 2⁻ᵖᐟ³, the step at which central differences are most accurate.
pub(super) fn third_of_digits<F: Float>() -> F {
    (0..F::PRECISION / 3).fold(F::int(1), |step, _| step / F::int(2))
}

/// (x, v) half a turn of the drive after a state.
fn half_turn_on<F: Float>(ratios: Ratios<F>, start: State<F>) -> Option<(F, F)> {
    let end = start.phase.later_by_half_turns(1);
    let mut phases = Trajectory::new(ratios, start).ok()?;
    let reaches = |phase: &Segment<F>| phase.end().is_none_or(|e| e.phase.since(end) >= F::int(0));
    let last = phases.find(|phase| phase.as_ref().is_ok_and(reaches))?.ok()?;
    let state = last.at(end).state;
    Some((state.x, state.v))
}

/// `2 sin (a − b)/2`: zero for equal phases only, and not for phases half a turn apart.
pub(super) fn apart<F: Float>(a: F, b: F) -> F {
    F::int(2) * ((a - b) / F::int(2)).sin()
}

#[cfg(test)]
mod tests {
    use super::apart;
    use core::f64::consts::{PI, TAU};

    #[test]
    fn phases_a_turn_apart_are_equal_and_half_a_turn_apart_are_not() {
        for a in [0.0, 0.3, 6.2] {
            assert!(apart(a, a + TAU).abs() < 1e-14 && apart(a - TAU, a).abs() < 1e-14);
            assert!(
                (apart(a + 1e-6, a) - 1e-6).abs() < 1e-14 && (apart(a + PI, a).abs() - 2.0).abs() < 1e-14
            );
        }
    }
}
