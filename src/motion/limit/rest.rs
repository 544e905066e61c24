//! α ≤ 1: the body ends at rest.
//!
//! The body can rest permanently where `|x| ≤ 1 − α`. A body outside this interval moves in every cycle; its
//! distance from the nearest place of rest never grows (the motion is contracting, `shooting`). A start at
//! rest at a distance δ outside moves the body by less than `9δ²/(αΩ²)` towards the interval. Let τ be the
//! phase from the extreme of the force and δ = α(1 − cos η): the force in excess of friction is α(cos τ − cos
//! η), positive from −η to η. Without the pull of the spring, which only slows the body, the speed would be
//! (α/Ω²) [sin τ + sin η − (τ + η) cos η], zero again before τ = 2.02η for cos η ≥ 15/16, and the distance at
//! most 4.56 δ²/(αΩ²). With damping, which also slows the body, the distance is at most the impulse of the
//! excess force divided by 2ζ, (α/2ζΩ) ∫(cos τ − cos η) dτ ≤ 1.89 δ √(δ/α)/2ζΩ. Once δ is below `α min(Ω²,
//! 1)/16` or `α min((2ζΩ)², 1)/16` the body therefore creeps to the edge of the interval and never reaches
//! it. This limit has a closed form, which no simulation reaches (δ falls like 1/cycles).
//!
//! With a static friction above the kinetic one a body can rest permanently where `|x| ≤ η − α`. For α < 1
//! every motion ends there, because `d/dφ ½(x² + w²) ≤ −(1 − α)|w|`, so that its total path is finite. The
//! body does not creep: each slide begins with the acceleration η − 1.

use super::long_run::{LongRun, Rest};
use crate::float::Float;
use crate::machine::error::Error;
use crate::machine::ratios::Ratios;
use crate::motion::broken::Budget;
use crate::motion::slide::equation::Equation;
use crate::motion::state::State;
use crate::motion::trajectory::{Body, End, Trajectory};

/// The rest in which the motion from a start ends, α ≤ 1.
///
/// # Errors
/// [`Error::SearchBound`], [`Error::Interrupted`].
pub(crate) fn come_to_rest<F: Float>(
    ratios: Ratios<F>,
    start: State<F>,
    budget: &mut Budget<'_>,
) -> Result<LongRun<F>, Error> {
    let (zero, one, turn) = (F::int(0), F::int(1), F::int(2) * F::pi());
    let (omega, alpha) = (ratios.omega(), ratios.alpha());
    let creeps = !ratios.has_higher_static_friction();
    let edge = ratios.static_friction_ratio() - alpha;
    let slow = omega.square().or_larger((F::int(2) * ratios.damping_ratio() * omega).square());
    let creeping = alpha * if slow < one { slow } else { one } / F::int(16);
    let mut slides = 0;
    let mut last = start;
    let motion = Trajectory::of(Equation::new(ratios), start);
    for phase in motion {
        let phase = phase?;
        budget.ask()?;
        let periods = phase.start().phase.since(start.phase) / turn;
        match &phase.body {
            Body::Slide(..) => slides = u64::saturating_add(slides, 1),
            Body::Stick(stick) => {
                let outside = stick.x.abs() - edge;
                if phase.ends_by == End::Never {
                    return Ok(LongRun::Rest(Rest { position: stick.x, slides: Some(slides), periods }));
                }
                if creeps && outside < creeping {
                    let position = if stick.x < zero { -edge } else { edge };
                    return Ok(LongRun::Rest(Rest { position, slides: None, periods }));
                }
            }
        }
        last = phase.end().unwrap_or(last);
        if slides > budget.most {
            break;
        }
    }
    let periods = last.phase.since(start.phase) / turn;
    Ok(LongRun::NotConverged { state: last, residual: last.x.abs() - edge, periods })
}

#[cfg(test)]
mod tests {
    use super::{Budget, LongRun, come_to_rest};
    use crate::Ratios;
    use crate::motion::trajectory::{Body, End, Segment};
    use crate::motion::{State, Trajectory};
    use std::f64::consts::TAU;

    /// The numbers of slides and periods count the motion itself, whether it came to rest or the search
    /// stopped earlier.
    #[test]
    fn it_is_the_motion_that_is_counted() {
        let ratios = Ratios::new(0.37, 0.8).unwrap();
        let start = State::new(0.3, 60.0, -2.0).unwrap();
        let phases: Vec<_> = Trajectory::new(ratios, start).unwrap().take(200).map(Result::unwrap).collect();
        let is_slide = |phase: &&Segment<f64>| matches!(phase.body, Body::Slide(..));
        let at_rest = phases.iter().position(|phase| phase.ends_by == End::Never).unwrap();
        let slides = phases[..at_rest].iter().filter(is_slide).count();
        assert!(slides > 20 && slides < at_rest, "{slides} {at_rest}");
        let since = |state: State<f64>| state.phase.since(start.phase) / TAU;
        let within = |most| come_to_rest(ratios, start, &mut Budget::of(most)).unwrap();
        let LongRun::Rest(rest) = within(1000) else { panic!("no rest") };
        assert_eq!((rest.slides, rest.position), (Some(slides as u64), phases[at_rest].start().x));
        assert!((rest.periods - since(phases[at_rest].start())).abs() < 1e-12, "{rest:?}");
        let LongRun::NotConverged { state, residual, periods } = within(9) else { panic!("at rest") };
        let tenth = phases.iter().filter(is_slide).nth(9).unwrap().end().unwrap();
        assert_eq!((state, residual), (tenth, tenth.x.abs() - (1.0 - 0.8)));
        assert!(periods > 1.0 && (periods - since(state)).abs() < 1e-12, "{periods}");
    }
}
