//! α ≤ 1: the body ends at rest.
//!
//! It can rest for ever where `|x| ≤ 1 − α`. From a place outside it is moved on in every cycle; the distance to the nearest
//! place of rest never grows (the motion is contracting, `shooting`). A start at rest a distance δ outside moves the body by
//! less than `9δ²/(αΩ²)` towards it, because `sin θ − sin θ_e ≤ (η² − τ²)/2` about the maximum of the force, where δ = α(1 − cos η).
//! So once δ is below `α min(Ω², 1)/16` the body creeps to the edge of the interval and never gets there: a limit in closed form,
//! which no amount of simulation reaches (δ falls like 1/cycles).

use super::equation::Equation;
use super::long_run::LongRun;
use super::shooting::Budget;
use super::state::State;
use super::trajectory::{Body, End, Trajectory};
use crate::float::Float;
use crate::ratios::Ratios;

/// Where a body ends at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest<F> {
    /// Place of rest x/B, `|x| ≤ 1 − α`.
    pub position: F,
    /// Slides until it is at rest for ever; `None` where it creeps for ever towards [`Rest::position`].
    pub slides: Option<u64>,
    /// Periods of the drive that were followed.
    pub periods: F,
}

/// Where the motion from a start comes to rest, α ≤ 1.
pub(crate) fn come_to_rest<F: Float>(ratios: Ratios<F>, start: State<F>, budget: &mut Budget) -> LongRun<F> {
    let (zero, one, turn) = (F::int(0), F::int(1), F::int(2) * F::pi());
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let edge = one - alpha;
    let slow = omega.square();
    let creeping = alpha * if slow < one { slow } else { one } / F::int(16);
    let mut slides = 0;
    let mut last = start;
    let motion = Trajectory::of(Equation::new(ratios), start);
    for phase in motion {
        let periods = phase.start().phase.since(start.phase) / turn;
        match &phase.body {
            Body::Slide(..) => slides += 1,
            Body::Stick(stick) => {
                let outside = stick.x.abs() - edge;
                if phase.end == End::Never {
                    return LongRun::Rest(Rest { position: stick.x, slides: Some(slides), periods });
                }
                if outside < creeping {
                    let position = if stick.x < zero { -edge } else { edge };
                    return LongRun::Rest(Rest { position, slides: None, periods });
                }
            }
        }
        last = phase.end().unwrap_or(last);
        if slides > budget.most {
            break;
        }
    }
    let periods = last.phase.since(start.phase) / turn;
    LongRun::NotConverged { state: last, residual: last.x.abs() - edge, periods }
}
